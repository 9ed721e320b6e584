//! `fillrate raw`: the Raw pipeline, its protocol, its simulator and its experiment.

mod experiment;
mod machine;
mod play;
mod serve;

use anyhow::Result;
use clap::{Args, Subcommand};

use crate::Outcome;

/// Options of `fillrate raw`.
#[derive(Args, Debug)]
pub struct RawArgs {
    #[command(subcommand)]
    command: RawCommand,
}

#[derive(Debug, Subcommand)]
enum RawCommand {
    /// Be the renderer of a client: a program's, or standard input and output
    Serve(serve::ServeArgs),
    /// Play a file of protocol records
    Play(play::PlayArgs),
    /// Run the published experiment: tables, figures, a page
    Bench(experiment::ExperimentArgs),
}

/// The command.
pub fn raw(args: &RawArgs) -> Result<Outcome> {
    match &args.command {
        RawCommand::Serve(args) => serve::serve(args),
        RawCommand::Play(args) => play::play(args),
        RawCommand::Bench(args) => experiment::experiment(args),
    }
}
