//! Settings of the library, from the environment.

use std::collections::BTreeMap;
use std::path::PathBuf;

use fillrate_capture::{number, variable};
use fillrate_engine::DeviceConfig;
use fillrate_engine::target::TileSize;
use fillrate_glide::GlideConfig;
use fillrate_glide::card::{CARDS, Card};

/// Everything that is set.
#[derive(Debug, Default)]
pub struct Settings {
    /// How the library works.
    pub glide: GlideConfig,
    /// Record every call here.
    pub trace: Option<PathBuf>,
    /// Write frames and their log here.
    pub capture: Option<PathBuf>,
    /// Write every Nth frame; 0 writes the log alone.
    pub every: u64,
    /// End the program after so many swaps.
    pub exit_after: Option<u64>,
}

fn card(name: &str) -> Result<Card, String> {
    Card::by_name(name).ok_or_else(|| {
        let names: Vec<&str> = CARDS.iter().map(|card| card.name).collect();
        format!("boards are {}", names.join(", "))
    })
}

fn level(name: &str) -> Result<fillrate_simd::Level, String> {
    let level: fillrate_simd::Level = name.parse().map_err(|e| format!("{e}"))?;
    if level.is_available() { Ok(level) } else { Err("this machine lacks it".into()) }
}

impl Settings {
    /// Reads the environment.
    pub fn from_environment() -> Settings {
        let mut device = DeviceConfig::default();
        let threads = |text: &str| match number(text)? {
            n @ 1..=256 => Ok(n as usize),
            _ => Err("it is outside 1 to 256".into()),
        };
        device.threads = variable("FILLRATE_THREADS", threads).unwrap_or(device.threads);
        device.level = variable("FILLRATE_SIMD", level).unwrap_or(device.level);
        let tile = |text: &str| match number(text)? {
            32 => Ok(TileSize::Small),
            64 => Ok(TileSize::Medium),
            128 => Ok(TileSize::Large),
            _ => Err("tiles are 32, 64 or 128 pixels".into()),
        };
        device.tile = variable("FILLRATE_TILE", tile).unwrap_or(device.tile);
        let boards = |text: &str| match number(text)? {
            n @ 1..=4 => Ok(n as usize),
            _ => Err("it is outside 1 to 4".into()),
        };
        let original = |name: &str| name.starts_with("FX_GLIDE_") || name.starts_with("SST_");
        let variables: BTreeMap<String, String> =
            std::env::vars().filter(|(name, _)| original(name)).collect();
        Settings {
            glide: GlideConfig {
                device,
                card: variable("FILLRATE_CARD", card).unwrap_or_default(),
                boards: variable("FILLRATE_BOARDS", boards).unwrap_or(1),
                check: variable("FILLRATE_CHECK", number).is_some_and(|n| n != 0),
                variables,
            },
            trace: std::env::var_os("FILLRATE_TRACE").map(PathBuf::from),
            capture: std::env::var_os("FILLRATE_CAPTURE").map(PathBuf::from),
            every: variable("FILLRATE_EVERY", number).unwrap_or(1),
            exit_after: variable("FILLRATE_EXIT_AFTER", number).filter(|&n| n > 0),
        }
    }
}
