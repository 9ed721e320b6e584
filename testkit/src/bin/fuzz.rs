//! Runs a fuzz target over seeded inputs, without a fuzzer's instrumentation:
//! `fuzz TARGET [EXECUTIONS] [FIRST SEED]`. An input that fails is named by its
//! seed; one that takes longer than a second fails too.

use std::time::{Duration, Instant};

use fillrate_testkit::fuzz::{Fuzzer, Target};

/// The longest an execution may take.
const LIMIT: Duration = Duration::from_secs(1);

fn number(text: Option<String>, otherwise: u64) -> u64 {
    text.map_or(otherwise, |text| text.parse().expect("numbers are whole and positive"))
}

/// The most memory the process had, in KiB, where the system tells.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM"))?;
    line.split_whitespace().nth(1)?.parse().ok()
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let name = arguments.next().unwrap_or_default();
    let Some(target) = Target::ALL.into_iter().find(|target| target.name() == name) else {
        let names = Target::ALL.map(Target::name).join("|");
        eprintln!("usage: fuzz {names} [EXECUTIONS] [FIRST SEED]");
        std::process::exit(2);
    };
    let (executions, first) = (number(arguments.next(), 100_000), number(arguments.next(), 1));
    let mut fuzzer = Fuzzer::new(target);
    let (started, mut longest) = (Instant::now(), (Duration::ZERO, first));
    for seed in first..first + executions {
        let bytes = target.input(seed);
        let before = Instant::now();
        let outcome = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| fuzzer.run(&bytes)));
        let took = before.elapsed();
        if outcome.is_err() || took > LIMIT {
            println!("seed {seed} failed after {took:?}");
            std::process::exit(1);
        }
        longest = longest.max((took, seed));
    }
    let seconds = started.elapsed().as_secs_f64();
    println!(
        "{name}: {executions} executions in {seconds:.1} s, {:.0} a second; the longest took {:?} \
         (seed {}); {} KiB of memory at most",
        executions as f64 / seconds,
        longest.0,
        longest.1,
        peak_memory().unwrap_or(0)
    );
}
