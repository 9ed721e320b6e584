//! `fillrate`: runs programs of the 1990s on the software renderer, replays
//! what they drew, measures and explains it.

#![forbid(unsafe_code)]

mod bench;
mod demo;
mod doctor;
mod gallery;
mod library;
mod model;
mod raw;
mod replay;
mod run;
mod settings;
mod target;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// The 3D accelerators of the 1990s as one fast, exact, deterministic software
/// renderer.
#[derive(Parser)]
#[command(name = "fillrate", version, about)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Run a program with our library found first, and collect its frames.
    Run(run::RunArgs),
    /// Draw the gallery of every example into a folder with a page.
    Demo(demo::DemoArgs),
    /// Draw a recorded trace again and compare it with what was recorded.
    Replay(replay::ReplayArgs),
    /// Estimate how long a recorded RRedline program took on the real chip.
    Model(model::ModelArgs),
    /// The Raw pipeline: serve clients, play records, run the experiment.
    Raw(raw::RawArgs),
    /// Measure the workloads W1 to W9.
    Bench(bench::BenchArgs),
    /// Print what this machine offers and how Fillrate is set up.
    Doctor(doctor::DoctorArgs),
}

/// What an exit code says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Everything as expected.
    Same = 0,
    /// A picture differs from what was expected.
    Differs = 1,
    /// The input cannot be used.
    BadInput = 3,
    /// A limit was reached.
    Limit = 4,
}

fn main() -> ExitCode {
    // Wrong usage ends in the parser, with code 2.
    let result = match Cli::parse().command {
        Command::Run(args) => run::run(&args),
        Command::Demo(args) => demo::demo(&args),
        Command::Replay(args) => replay::replay(&args),
        Command::Model(args) => model::model(&args),
        Command::Raw(args) => raw::raw(&args),
        Command::Bench(args) => bench::bench(&args),
        Command::Doctor(args) => doctor::doctor(&args),
    };
    match result {
        Ok(outcome) => ExitCode::from(outcome as u8),
        Err(error) => {
            eprintln!("fillrate: {error:#}");
            ExitCode::from(Outcome::BadInput as u8)
        }
    }
}
