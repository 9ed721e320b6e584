//! Settings of the library, from the environment.

use std::path::PathBuf;

use fillrate_capture::{number, variable};
use fillrate_raw::{Config, Errata, Level, TileSize};

/// Everything that is set.
#[derive(Debug, Default)]
pub struct Settings {
    /// The device.
    pub config: Config,
    /// Whether to talk to a renderer through standard input and output.
    pub pipe: bool,
    /// Record every call here.
    pub trace: Option<PathBuf>,
    /// Write frames and their log here.
    pub capture: Option<PathBuf>,
    /// Write every Nth frame; 0 writes the log alone.
    pub every: u64,
    /// End the program after so many page flips.
    pub exit_after: Option<u64>,
}

/// Parses WIDTHxHEIGHT.
fn size(text: &str) -> Result<(u32, u32), String> {
    let sides = text.split_once('x').and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    match sides {
        Some((w @ 1..=2048, h @ 1..=2048)) => Ok((w, h)),
        _ => Err("sizes are WIDTHxHEIGHT, each 1 to 2048".into()),
    }
}

/// Threads of the fast path; 0 for the scalar reference.
fn threads(text: &str) -> Result<usize, String> {
    match number(text)? {
        n @ 0..=256 => Ok(n as usize),
        _ => Err("it is outside 0 to 256".into()),
    }
}

/// A SIMD level of this machine.
fn level(text: &str) -> Result<Level, String> {
    let level: Level = text.parse().map_err(|error| format!("{error}"))?;
    if level.is_available() { Ok(level) } else { Err("this machine lacks it".into()) }
}

/// The side of a tile in pixels.
fn tile(text: &str) -> Result<TileSize, String> {
    match number(text)? {
        32 => Ok(TileSize::Small),
        64 => Ok(TileSize::Medium),
        128 => Ok(TileSize::Large),
        _ => Err("tiles are 32, 64 or 128 pixels".into()),
    }
}

fn errata(text: &str) -> Result<Errata, String> {
    Errata::by_name(text).ok_or_else(|| "they are 'correct' or 'faithful'".to_string())
}

fn transport(text: &str) -> Result<bool, String> {
    match text {
        "here" => Ok(false),
        "pipe" => Ok(true),
        _ => Err("transports are 'here' and 'pipe'".into()),
    }
}

impl Settings {
    /// Reads the environment.
    pub fn from_environment() -> Settings {
        let mut config = Config::default();
        if let Some((width, height)) = variable("FILLRATE_RAW_SIZE", size) {
            config = config.sized(width, height);
        }
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        config.threads = variable("FILLRATE_THREADS", threads).unwrap_or(cores);
        config.level = variable("FILLRATE_SIMD", level).unwrap_or(config.level);
        config.tile = variable("FILLRATE_TILE", tile).unwrap_or(config.tile);
        config.errata = variable("FILLRATE_RAW_ERRATA", errata).unwrap_or(config.errata);
        Settings {
            config,
            pipe: variable("FILLRATE_RAW_TRANSPORT", transport).unwrap_or(false),
            trace: std::env::var_os("FILLRATE_TRACE").map(PathBuf::from),
            capture: std::env::var_os("FILLRATE_CAPTURE").map(PathBuf::from),
            every: variable("FILLRATE_EVERY", number).unwrap_or(1),
            exit_after: variable("FILLRATE_EXIT_AFTER", number).filter(|&n| n > 0),
        }
    }
}
