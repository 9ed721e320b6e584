//! Runs the charted modes (or with `all` the whole published matrix) on one tile and on sixteen,
//! prints tables and verdicts, and writes the page with the figures when a path is given.
//!
//! `cargo run --release -p fillrate-raw --example experiment -- [all] [PAGE.html]`

use fillrate_raw::bench::{figures, gains, run};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1).peekable();
    if arguments.next_if(|a| a == "gains").is_some() {
        print!("{}", gains::table(&gains::measure()?));
        return Ok(());
    }
    let all = arguments.next_if(|a| a == "all").is_some();
    let tests = if all { run::matrix() } else { run::charted() };
    let threads = std::thread::available_parallelism()?.get();
    let outcomes = run::run_all(&tests, &run::Setting::default(), threads, |_| {})?;
    let differ = outcomes.iter().filter(|o| !o.same_picture).count();
    println!("{} tests, {differ} pictures differ", outcomes.len());
    let charted = run::charted();
    let shown: Vec<_> = outcomes.into_iter().filter(|o| charted.contains(&o.test)).collect();
    print!("{}{}", figures::table(&shown), figures::verdicts(&shown));
    if let Some(path) = arguments.next() {
        std::fs::write(path, figures::page(&shown))?;
    }
    Ok(())
}
