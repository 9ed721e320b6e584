//! `fillrate replay`: a recorded trace, drawn again.

use std::fs::File;
use std::io::BufReader;
use std::path::PathBuf;

use anyhow::{Context as _, Result};
use clap::Args;
use fillrate_player::{Limits, Played, Player, Stop, Verdict};
use fillrate_trace::TraceReader;

use crate::Outcome;
use crate::settings::Settings;
use crate::target::AnyTarget;

/// Options of `fillrate replay`.
#[derive(Args, Debug)]
pub struct ReplayArgs {
    #[command(flatten)]
    settings: Settings,
    /// Stop after N frames
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    frames: Option<u64>,
    /// Write frames as PNG files into this folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print the hash of every frame
    #[arg(long)]
    hash: bool,
    /// Print one JSON object a frame
    #[arg(long)]
    json: bool,
    /// The trace
    file: PathBuf,
}

/// The command.
pub fn replay(args: &ReplayArgs) -> Result<Outcome> {
    let file =
        File::open(&args.file).with_context(|| format!("cannot open {}", args.file.display()))?;
    if let Some(folder) = &args.out {
        std::fs::create_dir_all(folder)?;
    }
    let device = args.settings.device();
    let reader = TraceReader::new(BufReader::new(file))?;
    let limits = Limits { frames: args.frames, ..Limits::default() };
    let mut player = Player::new(reader, AnyTarget::new(device), limits);
    let (mut frames, mut different) = (0u64, 0u64);
    loop {
        match player.step()? {
            Played::Frame { result, frame } => {
                let hash = frame.as_ref().map_or(0, |frame| frame.hash());
                let differs = result.verdict == Verdict::Differs;
                different += u64::from(differs);
                if args.json {
                    println!(
                        "{{\"frame\":{frames},\"hash\":\"{hash:016x}\",\"same\":{}}}",
                        !differs
                    );
                } else if args.hash || differs {
                    let mark = if differs { "  differs from the recording" } else { "" };
                    println!("{frames:6} {hash:016x}{mark}");
                }
                if let (Some(folder), Some(frame)) = (&args.out, &frame) {
                    let mut bytes = Vec::new();
                    frame.write_png(&mut bytes)?;
                    std::fs::write(folder.join(format!("frame_{frames:05}.png")), bytes)?;
                }
                frames += 1;
            }
            Played::Stop(stop) => return Ok(ending(&stop, frames, different)),
        }
    }
}

fn ending(stop: &Stop, frames: u64, different: u64) -> Outcome {
    if let Stop::End(end) = stop
        && end.is_truncated()
    {
        eprintln!("fillrate: the trace was cut short; everything up to the cut was drawn");
    }
    eprintln!("{frames} frames, {different} different");
    match (stop, different) {
        (_, 1..) => Outcome::Differs,
        (Stop::FrameLimit, _) => Outcome::Limit,
        _ => Outcome::Same,
    }
}
