//! The options that say how to draw; the same for every command.

use clap::Args;
use fillrate_engine::DeviceConfig;
use fillrate_simd::Level;

/// How to draw. None of it changes a pixel.
#[derive(Args, Clone, Debug, Default)]
pub struct Settings {
    /// Threads that draw, the program's own included
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    pub threads: Option<u16>,
    /// SIMD level: scalar, sse4.1, avx2, avx512, neon, simd128
    #[arg(long, value_name = "LEVEL", value_parser = available_level)]
    pub simd: Option<Level>,
}

impl Settings {
    /// How to draw: as asked for, or else by `fillrate.toml` and the
    /// environment.
    pub fn device(&self) -> DeviceConfig {
        let device = fillrate_settings::Settings::load().glide.device;
        DeviceConfig {
            threads: self.threads.map_or(device.threads, usize::from),
            level: self.simd.unwrap_or(device.level),
            ..device
        }
    }

    /// The settings as environment variables of a program.
    pub fn variables(&self) -> Vec<(&'static str, String)> {
        let threads = self.threads.map(|n| ("FILLRATE_THREADS", n.to_string()));
        let simd = self.simd.map(|level| ("FILLRATE_SIMD", level.to_string()));
        threads.into_iter().chain(simd).collect()
    }
}

fn available_level(text: &str) -> Result<Level, String> {
    let level: Level = text.parse().map_err(|error| format!("{error}"))?;
    if level.is_available() { Ok(level) } else { Err(format!("this machine has no {level}")) }
}
