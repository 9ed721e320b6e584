//! Chores of the repository: `cargo run -p fillrate-xtask -- bless`.

use std::process::{Command, ExitCode};

const HELP: &str = "usage: cargo run -p fillrate-xtask -- bless|long

  bless  rewrites golden pictures and hashes from what is drawn now
  long   runs the long tests: all combinations, 100,000 random cases";

fn test(package: &str, variables: &[(&str, &str)]) -> bool {
    let mut command = Command::new(env!("CARGO"));
    command.args(["test", "-p", package]).envs(variables.iter().copied());
    command.status().is_ok_and(|status| status.success())
}

fn main() -> ExitCode {
    let done = match std::env::args().nth(1).as_deref() {
        Some("bless") => {
            let bless = [("BLESS", "1")];
            test("fillrate-testkit", &bless) && test("fillrate-cli", &bless)
        }
        Some("long") => {
            test("fillrate-testkit", &[("FILLRATE_CASES", "100000")])
                && test("fillrate-cli", &[("FILLRATE_FULL", "1")])
        }
        _ => {
            eprintln!("{HELP}");
            return ExitCode::from(2);
        }
    };
    if done { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
