//! Chores of the repository: `cargo run -p fillrate-xtask -- bless`.

mod budget;
mod calls;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

const HELP: &str = "usage: cargo run -p fillrate-xtask -- bless|long|budget|check-kernels

  bless          rewrites golden pictures and hashes from what is drawn now
  long           runs the long tests: all combinations, 100,000 random cases
  budget         counts instructions of each draw state under valgrind and fails
                 more than 2 % above benches/records/budget.json
  budget --record REASON
                 keeps what is counted now
  check-kernels  fails where a kernel's machine code calls what it should not";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn test(package: &str, variables: &[(&str, &str)]) -> bool {
    let mut command = Command::new(env!("CARGO"));
    command.args(["test", "-p", package]).envs(variables.iter().copied());
    command.status().is_ok_and(|status| status.success())
}

/// Tells of a failure.
fn told(result: anyhow::Result<()>) -> bool {
    result.inspect_err(|error| eprintln!("{error:#}")).is_ok()
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match arguments[..] {
        ["bless"] => {
            let bless = [("BLESS", "1")];
            test("fillrate-testkit", &bless) && test("fillrate-cli", &bless)
        }
        ["long"] => {
            test("fillrate-testkit", &[("FILLRATE_CASES", "100000")])
                && test("fillrate-cli", &[("FILLRATE_FULL", "1")])
        }
        ["budget"] => told(budget::budget(&root(), None)),
        ["budget", "--record", reason] if !reason.trim().is_empty() => {
            told(budget::budget(&root(), Some(reason)))
        }
        ["check-kernels"] => told(calls::check(&root())),
        _ => {
            eprintln!("{HELP}");
            return ExitCode::from(2);
        }
    };
    if done { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
