//! `fillrate raw serve`: the renderer at the other end of a client's pipes.

use std::ffi::OsString;
use std::io::BufReader;
use std::process::{Child, Command, Stdio};

use anyhow::{Context as _, Result};
use clap::Args;
use fillrate_raw::serve::{self, RecordReader, Served};

use super::machine::MachineArgs;
use crate::{Outcome, library};

/// Options of `fillrate raw serve`.
#[derive(Args, Debug)]
pub struct ServeArgs {
    #[command(flatten)]
    machine: MachineArgs,
    /// The client and its arguments; without one, records come from standard input and words go to
    /// standard output
    #[arg(last = true, value_name = "PROGRAM [ARGS]")]
    program: Vec<OsString>,
}

/// The command.
pub fn serve(args: &ServeArgs) -> Result<Outcome> {
    let Some((name, arguments)) = args.program.split_first() else {
        return serve_standard(args);
    };
    let mut child = start(args, name, arguments)?;
    let (input, output) = (child.stdout.take(), child.stdin.take());
    let (input, output) = (input.context("no pipe")?, output.context("no pipe")?);
    let records = RecordReader::new(BufReader::new(input), args.machine.repair());
    let (config, build) = (args.machine.config(), args.machine.build());
    let served = serve::serve(build, config, records, output, |line| eprintln!("{line}"));
    let outcome = args.machine.finish(&served)?;
    end(&mut child, &served, outcome)
}

fn serve_standard(args: &ServeArgs) -> Result<Outcome> {
    let records = RecordReader::new(BufReader::new(std::io::stdin()), args.machine.repair());
    let (config, build) = (args.machine.config(), args.machine.build());
    let log = |line: &str| eprintln!("{line}");
    let served = serve::serve(build, config, records, std::io::stdout(), log);
    args.machine.finish(&served)
}

/// Starts the client with its standard input and output as the pipes, as the thesis's host device
/// did.
fn start(args: &ServeArgs, name: &OsString, arguments: &[OsString]) -> Result<Child> {
    let mut command = Command::new(name);
    command
        .args(arguments)
        .env("FILLRATE_RAW_TRANSPORT", "pipe")
        .envs(args.machine.variables())
        .stdin(Stdio::piped())
        .stdout(Stdio::piped());
    // A client that carries its own interface needs no library of ours.
    if let Some(folder) = library::folder() {
        command.env(library::SEARCH_PATH, library::search_path(&folder)?);
    }
    command.spawn().with_context(|| format!("cannot start {}", name.to_string_lossy()))
}

/// Waits for the client; one whose renderer stopped early is ended, since it may wait for words.
fn end(child: &mut Child, served: &Served, outcome: Outcome) -> Result<Outcome> {
    if !served.errors.is_empty() {
        let _ = child.kill();
    }
    let status = child.wait()?;
    if served.errors.is_empty() && !status.success() {
        eprintln!("fillrate: the client ended with {status}");
        return Ok(Outcome::BadInput);
    }
    Ok(outcome)
}
