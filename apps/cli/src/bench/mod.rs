//! `fillrate bench`: the workloads W1 to W9 through the Glide API, Q1 to Q14
//! through Quark 3D.

mod quark;
mod scene;
mod workload;

use std::time::Instant;

use anyhow::{Result, bail};
use clap::Args;
use fillrate_engine::DeviceConfig;
use serde::Serialize;

use crate::Outcome;
use crate::settings::Settings;
use workload::{Prepared, WORKLOADS, Workload};

/// Options of `fillrate bench`.
#[derive(Args, Debug)]
pub struct BenchArgs {
    #[command(flatten)]
    settings: Settings,
    /// Size of the screen: 320x240, 512x384, 640x480 or 800x600
    #[arg(long, value_name = "WxH", default_value = "640x480")]
    size: String,
    /// Timed runs of each workload
    #[arg(long, value_name = "N", default_value_t = 7, value_parser = clap::value_parser!(u16).range(1..=1000))]
    runs: u16,
    /// Only workloads whose name starts with this
    #[arg(long, value_name = "PREFIX", default_value = "")]
    only: String,
    /// Print one JSON object a workload
    #[arg(long)]
    json: bool,
}

/// What was measured of one workload.
#[derive(Debug, Serialize)]
struct Measured<'a> {
    workload: &'a str,
    size: &'a str,
    format: &'static str,
    threads: usize,
    simd: &'static str,
    unit: &'static str,
    median: f64,
    min: f64,
    max: f64,
    runs: u16,
    digest: String,
}

/// The command.
pub fn bench(args: &BenchArgs) -> Result<Outcome> {
    let device = args.settings.device();
    let is_chosen = |name: &str| name.starts_with(&args.only);
    let chosen: Vec<&Workload> = WORKLOADS.iter().filter(|w| is_chosen(w.name)).collect();
    let of_quark: Vec<_> = quark::WORKLOADS.iter().filter(|(name, _)| is_chosen(name)).collect();
    if chosen.is_empty() && of_quark.is_empty() {
        bail!("no workload starts with '{}'", args.only);
    }
    if !args.json {
        println!("{:22} {:>9} {:>9} {:>9} unit    digest", "workload", "median", "min", "max");
    }
    for workload in chosen {
        let mut prepared = Prepared::new(workload, &args.size, device.clone())?;
        let named = Named { name: workload.name, unit: workload.unit(), format: "565" };
        report(args, &measure(args, &named, &mut prepared, &device)?)?;
    }
    let (_, size) = workload::resolution(&args.size)?;
    for &&(name, kind) in &of_quark {
        let mut prepared = quark::Prepared::new(kind, size, device.clone())?;
        let named = Named { name, unit: quark::unit(kind), format: "palette" };
        report(args, &measure(args, &named, &mut prepared, &device)?)?;
    }
    Ok(Outcome::Same)
}

/// Something that is drawn frame by frame, always the same.
trait Drawing {
    /// Draws and shows a frame.
    fn frame(&mut self);
    /// Pixels or triangles of a frame.
    fn count(&self) -> f64;
    /// The hash of the picture shown.
    fn digest(&mut self) -> Result<u64>;
}

/// What a workload is called, and what its rate counts.
struct Named {
    name: &'static str,
    unit: &'static str,
    format: &'static str,
}

/// Draws a workload until it is warm, then times the runs. All frames must
/// show the same picture.
fn measure<'a>(
    args: &'a BenchArgs,
    named: &Named,
    prepared: &mut dyn Drawing,
    device: &DeviceConfig,
) -> Result<Measured<'a>> {
    prepared.frame();
    let digest = prepared.digest()?;
    let mut rates = Vec::new();
    for _ in 0..args.runs {
        // A run is as many frames as take a twentieth of a second.
        let start = Instant::now();
        let mut frames = 0;
        while frames == 0 || start.elapsed().as_secs_f64() < 0.05 {
            prepared.frame();
            frames += 1;
        }
        rates.push(prepared.count() * f64::from(frames) / start.elapsed().as_secs_f64() * 1e-6);
    }
    if prepared.digest()? != digest {
        bail!("{}: the picture changes from frame to frame", named.name);
    }
    rates.sort_by(f64::total_cmp);
    Ok(Measured {
        workload: named.name,
        size: &args.size,
        format: named.format,
        threads: device.threads,
        simd: device.level.name(),
        unit: named.unit,
        median: rates[rates.len() / 2],
        min: rates[0],
        max: rates[rates.len() - 1],
        runs: args.runs,
        digest: format!("{digest:016x}"),
    })
}

fn report(args: &BenchArgs, m: &Measured<'_>) -> Result<()> {
    if args.json {
        println!("{}", serde_json::to_string(m)?);
    } else {
        println!(
            "{:22} {:>9.2} {:>9.2} {:>9.2} {:7} {}",
            m.workload, m.median, m.min, m.max, m.unit, m.digest
        );
    }
    Ok(())
}
