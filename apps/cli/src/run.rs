//! `fillrate run`: a program with our library found first.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use anyhow::{Context, Result};
use clap::Args;
use serde::{Deserialize, Serialize};

use crate::Outcome;
use crate::library;
use crate::settings::Settings;

/// Options of `fillrate run`.
#[derive(Args, Debug)]
pub struct RunArgs {
    #[command(flatten)]
    pub settings: Settings,
    /// End the program after N swapped frames
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub frames: Option<u64>,
    /// Write every Kth frame only
    #[arg(long, value_name = "K", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..))]
    pub every: u64,
    /// Write frames as PNG files into this folder
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Print the hash of every frame
    #[arg(long)]
    pub hash: bool,
    /// Print triangles, pixels and time at the end
    #[arg(long)]
    pub stats: bool,
    /// Print one JSON object a frame instead of text
    #[arg(long)]
    pub json: bool,
    /// Record every call into this file
    #[arg(long, value_name = "FILE")]
    pub trace: Option<PathBuf>,
    /// Board to model, by name
    #[arg(long, value_name = "NAME")]
    pub card: Option<String>,
    /// Report every misuse of the API
    #[arg(long)]
    pub check: bool,
    /// Boards in the machine
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=4))]
    pub boards: Option<u8>,
    /// Pictures as on the monitor: with the board's gamma
    #[arg(long)]
    pub gamma: bool,
    /// Pictures with the screen filter, which takes dithering back
    #[arg(long)]
    pub filter: bool,
    /// Show the start-up picture when a board is opened
    #[arg(long)]
    pub splash: bool,
    /// Draw every pixel as N by N, 1 to 4
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=4))]
    pub scale: Option<u8>,
    /// Scale pictures back: each pixel is the mean of those drawn for it
    #[arg(long)]
    pub supersample: bool,
    /// Eight bits a colour channel, without dithering
    #[arg(long)]
    pub color32: bool,
    /// RRedline: the chip, v1000 or v2000
    #[arg(long, value_name = "CHIP")]
    pub chip: Option<String>,
    /// RRedline: drop command buffers instead of issuing them, to see how fast the program alone is
    #[arg(long)]
    pub speed_of_light: bool,
    /// Settings file, instead of the fillrate.toml found
    #[arg(long, value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// The program and its arguments
    #[arg(last = true, required = true, value_name = "PROGRAM [ARGS]")]
    pub program: Vec<std::ffi::OsString>,
}

/// What the library notes of one frame.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct FrameNote {
    /// Counted from 0 over all boards.
    pub frame: u64,
    /// The board that showed it.
    #[serde(default)]
    pub board: usize,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Hash of the pixels, sixteen hexadecimal digits.
    pub hash: String,
    /// Triangles drawn for it.
    pub triangles: u64,
    /// Fragments covered for it.
    pub pixels: u64,
    /// Time the renderer took for it.
    pub nanoseconds: u64,
}

/// A finished run.
#[derive(Debug)]
pub struct Finished {
    /// Every frame the program showed.
    pub frames: Vec<FrameNote>,
    /// How long it ran.
    pub time: Duration,
    /// Whether it ended well.
    pub success: bool,
    /// How it ended, in words.
    pub ending: String,
}

/// What a run asks of the library.
#[derive(Debug)]
pub struct Request<'a> {
    /// How to draw.
    pub settings: Settings,
    /// End after so many frames.
    pub frames: Option<u64>,
    /// Write every Kth frame into the folder; 0 writes none.
    pub every: u64,
    /// Receives the frames and their log.
    pub folder: &'a Path,
    /// Record here.
    pub trace: Option<&'a Path>,
    /// Further variables.
    pub variables: Vec<(&'static str, String)>,
    /// Drop what the program prints, so that it does not mix with ours.
    pub quiet: bool,
}

/// Runs a program and reads back what the library noted of its frames.
pub fn execute(program: &[std::ffi::OsString], request: &Request<'_>) -> Result<Finished> {
    let (name, arguments) = program.split_first().context("no program was given")?;
    let folder = library::need_any()?;
    let mut command = Command::new(name);
    command
        .args(arguments)
        .env(library::SEARCH_PATH, library::search_path(&folder)?)
        .env("FILLRATE_CAPTURE", request.folder)
        .env("FILLRATE_EVERY", request.every.to_string())
        .envs(request.settings.variables())
        .envs(request.variables.iter().map(|(name, value)| (*name, value.as_str())));
    if let Some(frames) = request.frames {
        command.env("FILLRATE_EXIT_AFTER", frames.to_string());
    }
    if let Some(trace) = request.trace {
        command.env("FILLRATE_TRACE", trace);
    }
    if request.quiet {
        command.stdout(Stdio::null());
    }
    let start = Instant::now();
    let status =
        command.status().with_context(|| format!("cannot start {}", name.to_string_lossy()))?;
    Ok(Finished {
        time: start.elapsed(),
        frames: read_log(&request.folder.join("frames.jsonl"))?,
        success: status.success(),
        ending: status.to_string(),
    })
}

/// The notes of all frames; none where the program showed none.
fn read_log(file: &Path) -> Result<Vec<FrameNote>> {
    let text = match std::fs::read_to_string(file) {
        Ok(text) => text,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(error) => return Err(error).with_context(|| format!("cannot read {}", file.display())),
    };
    // A program that is killed can leave half a line at the end.
    Ok(text.lines().map_while(|line| serde_json::from_str(line).ok()).collect())
}

impl RunArgs {
    /// The options that the library reads as variables.
    fn variables(&self) -> Vec<(&'static str, String)> {
        let on = |on: bool| on.then(|| "1".to_string());
        let config = self.config.as_ref().map(|path| path.display().to_string());
        [
            ("FILLRATE_CARD", self.card.clone()),
            ("FILLRATE_BOARDS", self.boards.map(|n| n.to_string())),
            ("FILLRATE_CONFIG", config),
            ("FILLRATE_CHECK", on(self.check)),
            ("FILLRATE_GAMMA", on(self.gamma)),
            ("FILLRATE_FILTER", on(self.filter)),
            ("FILLRATE_SPLASH", on(self.splash)),
            ("FILLRATE_SCALE", self.scale.map(|n| n.to_string())),
            ("FILLRATE_SUPERSAMPLE", on(self.supersample)),
            ("FILLRATE_COLOR32", on(self.color32)),
            ("FILLRATE_VERITE_CHIP", self.chip.clone()),
            ("FILLRATE_SPEED_OF_LIGHT", on(self.speed_of_light)),
        ]
        .into_iter()
        .filter_map(|(name, value)| Some((name, value?)))
        .collect()
    }
}

/// The command.
pub fn run(args: &RunArgs) -> Result<Outcome> {
    let scratch = tempfile::tempdir()?;
    let folder = args.out.as_deref().unwrap_or(scratch.path());
    std::fs::create_dir_all(folder)
        .with_context(|| format!("cannot create {}", folder.display()))?;
    let finished = execute(
        &args.program,
        &Request {
            settings: args.settings.clone(),
            frames: args.frames,
            every: if args.out.is_some() { args.every } else { 0 },
            folder,
            trace: args.trace.as_deref(),
            variables: args.variables(),
            quiet: false,
        },
    )?;
    report(args, &finished)?;
    if !finished.success {
        eprintln!("fillrate: the program ended with {}", finished.ending);
        return Ok(Outcome::BadInput);
    }
    Ok(Outcome::Same)
}

fn report(args: &RunArgs, finished: &Finished) -> Result<()> {
    for note in &finished.frames {
        if args.json {
            println!("{}", serde_json::to_string(note)?);
        } else if args.hash {
            println!("{:6} {}x{} {}", note.frame, note.width, note.height, note.hash);
        }
    }
    if args.stats {
        let triangles: u64 = finished.frames.iter().map(|note| note.triangles).sum();
        let pixels: u64 = finished.frames.iter().map(|note| note.pixels).sum();
        eprintln!(
            "{} frames, {triangles} triangles, {pixels} pixels in {:.3} s",
            finished.frames.len(),
            finished.time.as_secs_f64()
        );
    }
    Ok(())
}
