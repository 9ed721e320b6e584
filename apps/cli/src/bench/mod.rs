//! `fillrate bench`: the workloads W1 to W9 through the Glide API, Q1 to Q14
//! through Quark 3D, R1 to R6 through RRedline, A1 to A8 through RAVE.

mod board;
mod chart;
mod curves;
mod digest;
mod drawing;
mod measure;
mod peers;
mod quark;
mod rave;
mod redline;
mod scene;
mod size;
mod surfaces;
mod workload;

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, bail};
use clap::Args;

use crate::Outcome;
use crate::settings::Settings;
use curves::Curves;
use digest::Digests;
use measure::{Job, Measured, WrongPicture};
use peers::Peers;
use size::Size;
use workload::WORKLOADS;

/// Options of `fillrate bench`.
#[derive(Args, Debug)]
pub struct BenchArgs {
    #[command(flatten)]
    settings: Settings,
    /// Size of the picture, up to 4096x4096. Sizes that no board shows are
    /// drawn through the engine's API with the same states and vertices
    #[arg(long, value_name = "WxH", default_value = "640x480")]
    size: Size,
    /// Timed runs of each workload
    #[arg(long, value_name = "N", default_value_t = 7, value_parser = clap::value_parser!(u16).range(1..=1000))]
    runs: u16,
    /// Only workloads whose name starts with this
    #[arg(long, value_name = "PREFIX", default_value = "")]
    only: String,
    /// Print one JSON object a workload
    #[arg(long)]
    json: bool,
    /// Draw each workload once, compare its picture, and time nothing
    #[arg(long)]
    check: bool,
    /// With --check: write the pictures into this folder
    #[arg(long, value_name = "DIR", requires = "check")]
    out: Option<PathBuf>,
    /// Take the pictures' digests from this file instead of the built-in ones
    #[arg(long, value_name = "FILE")]
    digests: Option<PathBuf>,
    /// Print a table with the figures of other renderers, lines of
    /// peer,workload,res,format,ms_frame,Mpix_med,Mpix_min,Mpix_max,Mtri_med,Mtri_min,Mtri_max,frames_s,checksum
    #[arg(long, value_name = "CSV", num_args = 1..)]
    vs: Vec<PathBuf>,
    /// Take our figures for --vs from this output of --json instead of
    /// measuring
    #[arg(long, value_name = "FILE", requires = "vs")]
    measured: Option<PathBuf>,
    /// Measure curves over threads, resolution, triangle and texture size, and
    /// write them into this folder
    #[arg(long, value_name = "DIR", conflicts_with_all = ["vs", "check"])]
    curves: Option<PathBuf>,
}

/// The command. Exit code 1 where a picture is not the expected one.
pub fn bench(args: &BenchArgs) -> Result<Outcome> {
    match run(args) {
        Err(error) if error.is::<WrongPicture>() => {
            eprintln!("fillrate: {error}");
            Ok(Outcome::Differs)
        }
        result => result.map(|()| Outcome::Same),
    }
}

fn run(args: &BenchArgs) -> Result<()> {
    let digests = Digests::load(args.digests.as_deref())?;
    let peers = Peers::load(&args.vs)?;
    if let Some(folder) = &args.curves {
        let (device, runs) = (args.settings.device(), args.runs);
        return curves::draw(folder, &Curves { device, runs, digests: &digests });
    }
    let measured = match &args.measured {
        Some(file) => read(file)?,
        None => measure(args, &digests)?,
    };
    if !args.vs.is_empty() {
        print!("{}", peers.table(&measured));
    }
    Ok(())
}

/// Measures what was chosen, and tells so unless a table follows.
fn measure(args: &BenchArgs, digests: &Digests) -> Result<Vec<Measured>> {
    let device = args.settings.device();
    let quiet = !args.vs.is_empty();
    if !args.json && !args.check && !quiet {
        println!("{:22} {:>9} {:>9} {:>9} unit    digest", "workload", "median", "min", "max");
    }
    let mut all = Vec::new();
    for job in jobs(args)? {
        let mut checked = job.check(&device, digests)?;
        if args.check {
            println!("{:22} {}", job.name, checked.digest);
            if let Some(folder) = &args.out {
                std::fs::create_dir_all(folder)?;
                let file = folder.join(job.name).with_extension("png");
                checked.drawing.picture()?.save_png(&file)?;
            }
            continue;
        }
        let measured = job.time(&mut checked, &device, args.runs)?;
        if args.json {
            println!("{}", serde_json::to_string(&measured)?);
        } else if !quiet {
            report(&measured);
        }
        all.push(measured);
    }
    Ok(all)
}

/// The chosen workloads. Those of Quark 3D, RRedline and RAVE exist where a board
/// shows the size.
fn jobs(args: &BenchArgs) -> Result<Vec<Job>> {
    let is_chosen = |name: &str| name.starts_with(&args.only);
    let glide = WORKLOADS.into_iter().filter(|workload| is_chosen(workload.name));
    let mut jobs: Vec<Job> =
        glide.map(|workload| drawing::job(workload, args.size, None)).collect();
    let of_redline = redline::WORKLOADS.into_iter().filter(|(name, _)| is_chosen(name));
    let of_rave = rave::WORKLOADS.into_iter().filter(|(name, _)| is_chosen(name));
    let of_quark = quark::WORKLOADS.into_iter().filter(|(name, _)| is_chosen(name));
    if jobs.is_empty() || args.size.resolution().is_some() {
        for (name, kind) in of_quark {
            jobs.push(drawing::quark_job(name, kind, args.size)?);
        }
    }
    if args.size.resolution().is_some() {
        jobs.extend(of_redline.map(|(name, kind)| drawing::redline_job(name, kind, args.size)));
        jobs.extend(of_rave.map(|(name, kind)| drawing::rave_job(name, kind, args.size)));
    }
    if jobs.is_empty() {
        bail!("no workload starts with '{}'", args.only);
    }
    Ok(jobs)
}

fn report(m: &Measured) {
    println!(
        "{:22} {:>9.2} {:>9.2} {:>9.2} {:7} {}",
        m.workload, m.median, m.min, m.max, m.unit, m.digest
    );
}

/// The output of an earlier `--json`.
fn read(file: &Path) -> Result<Vec<Measured>> {
    let name = file.display();
    let text = std::fs::read_to_string(file).with_context(|| format!("cannot read {name}"))?;
    let lines = text.lines().filter(|line| !line.trim().is_empty());
    lines
        .map(|line| serde_json::from_str(line).with_context(|| format!("{name}: not a figure")))
        .collect()
}
