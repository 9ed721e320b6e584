//! Settings from the environment.

/// A variable's value, parsed; a bad one is told of on standard error and not used.
pub fn variable<T>(name: &str, parse: impl FnOnce(&str) -> Result<T, String>) -> Option<T> {
    let text = std::env::var(name).ok()?;
    match parse(&text) {
        Ok(value) => Some(value),
        Err(problem) => {
            eprintln!("fillrate: {name}={text} is not used: {problem}");
            None
        }
    }
}

/// Parses a whole number.
///
/// # Errors
/// What is wrong, in words.
pub fn number(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| "it is not a number".to_string())
}
