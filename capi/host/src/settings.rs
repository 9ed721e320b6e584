//! Settings of a library, from the environment.

use std::path::PathBuf;

use fillrate_engine::DeviceConfig;
use fillrate_engine::target::TileSize;
use fillrate_simd::Level;

/// What every library can be told.
#[derive(Debug, Default)]
pub struct Settings {
    /// Threads, SIMD level and tile size.
    pub device: DeviceConfig,
    /// Record every call here.
    pub trace: Option<PathBuf>,
    /// Write frames and their log here.
    pub capture: Option<PathBuf>,
    /// Write every Nth frame; 0 writes the log alone.
    pub every: u64,
    /// End the program after so many frames.
    pub exit_after: Option<u64>,
}

/// A variable's value, parsed; a bad one is told of and not used.
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

/// A number that is not negative.
///
/// # Errors
/// In words.
pub fn number(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| "it is not a number".to_string())
}

fn level(name: &str) -> Result<Level, String> {
    let level: Level = name.parse().map_err(|e| format!("{e}"))?;
    if level.is_available() { Ok(level) } else { Err("this machine lacks it".into()) }
}

fn threads(text: &str) -> Result<usize, String> {
    match number(text)? {
        n @ 1..=256 => Ok(n as usize),
        _ => Err("it is outside 1 to 256".into()),
    }
}

fn tile(text: &str) -> Result<TileSize, String> {
    match number(text)? {
        32 => Ok(TileSize::Small),
        64 => Ok(TileSize::Medium),
        128 => Ok(TileSize::Large),
        _ => Err("tiles are 32, 64 or 128 pixels".into()),
    }
}

impl Settings {
    /// Reads the environment.
    pub fn from_environment() -> Settings {
        let usual = DeviceConfig::default();
        Settings {
            device: DeviceConfig {
                threads: variable("FILLRATE_THREADS", threads).unwrap_or(usual.threads),
                level: variable("FILLRATE_SIMD", level).unwrap_or(usual.level),
                tile: variable("FILLRATE_TILE", tile).unwrap_or(usual.tile),
            },
            trace: std::env::var_os("FILLRATE_TRACE").map(PathBuf::from),
            capture: std::env::var_os("FILLRATE_CAPTURE").map(PathBuf::from),
            every: variable("FILLRATE_EVERY", number).unwrap_or(1),
            exit_after: variable("FILLRATE_EXIT_AFTER", number).filter(|&n| n > 0),
        }
    }
}
