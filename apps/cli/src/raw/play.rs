//! `fillrate raw play`: a file of protocol records.

use std::fs::File;
use std::io::BufReader;
use std::path::PathBuf;

use anyhow::{Context as _, Result};
use clap::Args;
use fillrate_raw::serve::{self, Build, RecordReader};
use serde_json::json;

use super::machine::{MachineArgs, page};
use crate::Outcome;

/// Options of `fillrate raw play`.
#[derive(Args, Debug)]
pub struct PlayArgs {
    #[command(flatten)]
    machine: MachineArgs,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
    /// The records
    file: PathBuf,
}

/// The command.
pub fn play(args: &PlayArgs) -> Result<Outcome> {
    let file =
        File::open(&args.file).with_context(|| format!("cannot open {}", args.file.display()))?;
    let records = RecordReader::new(BufReader::new(file), args.machine.repair());
    let (config, build) = (args.machine.config(), args.machine.build());
    // What the client would read has no reader here.
    let log = |line: &str| eprintln!("{line}");
    let served = serve::serve(build, config, records, std::io::sink(), log);
    let hash = page(&served, true)?.hash();
    if args.json {
        let c = &served.counters;
        println!(
            "{}",
            json!({
                "hash": format!("{hash:016x}"),
                "cycles": served.cycles,
                "render_cycles": c.render_cycles,
                "stream_cycles": c.stream_cycles,
                "active": c.active.map(|hundredths| hundredths / 100),
                "frames": c.frames,
                "primitives": c.prims,
                "drawn": c.drawn_prims,
                "fragments": c.frags,
                "texels": c.texels,
                "pixels": c.pixels,
                "faults": served.faults.len() + served.errors.len(),
            })
        );
    } else {
        // The fast path counts nothing.
        let report = match build {
            Build::Fast(_) => String::new(),
            _ => served.counters.report(),
        };
        println!("{report}displayed page {hash:016x}");
    }
    args.machine.finish(&served)
}
