//! The options that say which machine plays records, and what is told of a run.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result};
use clap::{Args, ValueEnum};
use fillrate_player::{Frame, Pixels};
use fillrate_raw::serve::{Build, Repair, Served};
use fillrate_raw::sim::{MAX_COLUMNS, Options};
use fillrate_raw::{Config, Errata, shown};

use crate::Outcome;

/// What plays records.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum BuildName {
    /// The reference renderer on one tile
    #[default]
    Single,
    /// The fast path: the same picture, nothing counted
    Fast,
    /// The grid of tiles
    Grid,
}

/// Which machine plays records.
#[derive(Args, Clone, Debug)]
pub struct MachineArgs {
    /// One tile, the fast path or the grid
    #[arg(long, value_enum, default_value_t)]
    build: BuildName,
    /// Threads of the fast path
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    threads: Option<u16>,
    /// Columns of the grid, four tiles each
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = columns)]
    columns: usize,
    /// Improvements of the grid beyond the thesis, by name
    #[arg(long, value_name = "NAME[,NAME]", value_delimiter = ',', value_parser = switch)]
    with: Vec<String>,
    /// What the thesis's grid has and this one lacks, by name: early_release, skip_busy
    #[arg(long, value_name = "NAME[,NAME]", value_delimiter = ',', value_parser = switch)]
    without: Vec<String>,
    /// Screen size
    #[arg(long, value_name = "WxH", default_value = "320x240", value_parser = size)]
    size: (u32, u32),
    /// The thesis's own errors: correct (none) or faithful (all)
    #[arg(long, value_name = "PRESET", default_value = "correct", value_parser = errata)]
    errata: Errata,
    /// Go on behind the next newline after a malformed record, instead of stopping
    #[arg(long)]
    resync: bool,
    /// Write the displayed and the hidden page as PNG files into this folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// Cores of this machine.
pub fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

fn columns(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(n) if (1..=MAX_COLUMNS).contains(&n) => Ok(n),
        _ => Err(format!("columns are 1 to {MAX_COLUMNS}")),
    }
}

/// Checks the name of a switch.
pub fn switch(text: &str) -> Result<String, String> {
    if Options::default().set(text, true) {
        return Ok(text.to_string());
    }
    Err(format!("switches are {}", Options::NAMES.join(", ")))
}

fn size(text: &str) -> Result<(u32, u32), String> {
    let sides = text.split_once('x').and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    match sides {
        Some((w @ 1..=2048, h @ 1..=2048)) => Ok((w, h)),
        _ => Err("sizes are WIDTHxHEIGHT, each 1 to 2048".into()),
    }
}

fn errata(text: &str) -> Result<Errata, String> {
    Errata::by_name(text).ok_or_else(|| "presets are 'correct' and 'faithful'".into())
}

impl MachineArgs {
    /// The device.
    pub fn config(&self) -> Config {
        let config = Config { errata: self.errata, ..Config::default() };
        config.sized(self.size.0, self.size.1)
    }

    /// The machine.
    pub fn build(&self) -> Build {
        match self.build {
            BuildName::Single => Build::Single,
            BuildName::Fast => Build::Fast(self.threads.map_or_else(cores, usize::from)),
            BuildName::Grid => {
                let mut options = Options { columns: self.columns, ..Options::default() };
                self.with.iter().for_each(|name| _ = options.set(name, true));
                self.without.iter().for_each(|name| _ = options.set(name, false));
                Build::Grid(options)
            }
        }
    }

    /// What is done about malformed records.
    pub fn repair(&self) -> Repair {
        if self.resync { Repair::NextLine } else { Repair::Stop }
    }

    /// The variables with which a client library records for the same device.
    pub fn variables(&self) -> [(&'static str, String); 2] {
        let size = format!("{}x{}", self.size.0, self.size.1);
        [("FILLRATE_RAW_SIZE", size), ("FILLRATE_RAW_ERRATA", self.errata.name().to_string())]
    }

    /// Tells of faults, writes the pages; what an exit code says of the run.
    pub fn finish(&self, served: &Served) -> Result<Outcome> {
        served.faults.iter().for_each(|fault| eprintln!("fillrate: {fault}"));
        for error in &served.errors {
            eprintln!("fillrate: {:#}", anyhow::Error::msg(chain(error)));
        }
        if let Some(folder) = &self.out {
            write_page(served, folder, true)?;
            write_page(served, folder, false)?;
        }
        let good = served.faults.is_empty() && served.errors.is_empty();
        Ok(if good { Outcome::Same } else { Outcome::BadInput })
    }
}

/// An error with its causes in one line.
fn chain(error: &dyn std::error::Error) -> String {
    let mut text = error.to_string();
    let mut source = error.source();
    while let Some(cause) = source {
        text += &format!(": {cause}");
        source = cause.source();
    }
    text
}

/// A page of the frame buffer.
pub fn page(served: &Served, front: bool) -> Result<Frame> {
    let shown = shown(&served.core.target.frame, front);
    Ok(Frame::new(shown.width, shown.height, Pixels::Rgba8(shown.rgba))?)
}

fn write_page(served: &Served, folder: &Path, front: bool) -> Result<()> {
    std::fs::create_dir_all(folder)
        .with_context(|| format!("cannot create {}", folder.display()))?;
    let file = folder.join(if front { "front.png" } else { "back.png" });
    let mut bytes = Vec::new();
    page(served, front)?.write_png(&mut bytes)?;
    std::fs::write(&file, bytes).with_context(|| format!("cannot write {}", file.display()))
}
