//! `fillrate raw bench`: the published experiment.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result};
use clap::Args;
use fillrate_raw::bench::{bands, figures, gains, run};
use indicatif::ProgressBar;

use crate::Outcome;

/// Options of `fillrate raw bench`.
#[derive(Args, Debug)]
pub struct ExperimentArgs {
    /// Run all 2520 tests instead of the 84 of the charts
    #[arg(long)]
    all: bool,
    /// Measure the improvements beyond the thesis instead, and how far the array scales
    #[arg(long, conflicts_with_all = ["all", "json"])]
    gains: bool,
    /// Worker threads
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    threads: Option<u16>,
    /// Write the page and its figures into this folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print one JSON object a test
    #[arg(long)]
    json: bool,
}

/// The command. Exit code 1 where a published range does not hold or a picture differs.
pub fn experiment(args: &ExperimentArgs) -> Result<Outcome> {
    if args.gains {
        return measure_gains(args);
    }
    let tests = if args.all { run::matrix() } else { run::charted() };
    let outcomes = run_tests(args, &tests)?;
    let charted = run::charted();
    let shown: Vec<_> = outcomes.iter().copied().filter(|o| charted.contains(&o.test)).collect();
    if args.json {
        outcomes.iter().for_each(|outcome| println!("{}", figures::json(outcome)));
    } else {
        print!("{}\n{}", figures::table(&shown), figures::verdicts(&shown));
    }
    if let Some(folder) = &args.out {
        write(folder, &shown)?;
        println!("\n{}", folder.join("index.html").display());
    }
    let holds = bands::bands(&shown).iter().all(bands::Band::holds)
        && bands::shapes(&shown).iter().all(|(_, shows)| *shows)
        && outcomes.iter().all(|outcome| outcome.same_picture);
    Ok(if holds { Outcome::Same } else { Outcome::Differs })
}

/// Exit code 1 where a picture differs.
fn measure_gains(args: &ExperimentArgs) -> Result<Outcome> {
    let gains = gains::measure()?;
    print!("{}", gains::table(&gains));
    if let Some(folder) = &args.out {
        std::fs::create_dir_all(folder)?;
        std::fs::write(folder.join("gains.html"), gains::page(&gains))?;
        println!("{}", folder.join("gains.html").display());
    }
    let same = gains.switches.iter().chain(&gains.scaling).all(|row| row.same_pictures);
    Ok(if same { Outcome::Same } else { Outcome::Differs })
}

fn run_tests(args: &ExperimentArgs, tests: &[run::Test]) -> Result<Vec<run::Outcome>> {
    let threads = args.threads.map_or_else(super::machine::cores, usize::from);
    let progress = ProgressBar::new(tests.len() as u64);
    let done = |finished: usize| progress.set_position(finished as u64);
    let outcomes = run::run_all(tests, &run::Setting::default(), threads, done)?;
    progress.finish_and_clear();
    Ok(outcomes)
}

fn write(folder: &Path, outcomes: &[run::Outcome]) -> Result<()> {
    std::fs::create_dir_all(folder)
        .with_context(|| format!("cannot create {}", folder.display()))?;
    let put = |name: &str, text: String| {
        let file = folder.join(name);
        std::fs::write(&file, text).with_context(|| format!("cannot write {}", file.display()))
    };
    put("index.html", figures::page(outcomes))?;
    for (number, (_, svg)) in figures::figures(outcomes).into_iter().enumerate() {
        put(&format!("figure{}.svg", number + 1), svg)?;
    }
    Ok(())
}
