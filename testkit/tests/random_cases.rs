//! Random cases through the reference and the engine.
//!
//! `FILLRATE_CASES` sets how many cases are drawn (10,000 without it) and
//! `FILLRATE_SEED` the first seed.

use std::thread;

use fillrate_engine::Counters;
use fillrate_testkit::compare::Comparison;
use fillrate_testkit::random::case;

/// Mismatches after which a thread stops.
const MAX_REPORTS: usize = 4;

/// A number from the environment.
fn setting(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
}

/// What a thread found.
#[derive(Default)]
struct Findings {
    /// Sums over all cases; they show that the cases draw.
    total: Counters,
    reports: Vec<String>,
}

/// Checks every `step`th seed.
fn check_seeds(seeds: std::ops::Range<u64>, step: usize) -> Findings {
    let mut comparison = Comparison::new().expect("devices can be made");
    let mut findings = Findings::default();
    for seed in seeds.step_by(step) {
        match comparison.check(&case(seed)) {
            Ok(counters) => findings.total += counters,
            Err(report) => findings.reports.push(format!("FILLRATE_SEED={seed}: {report}")),
        }
        if findings.reports.len() == MAX_REPORTS {
            break;
        }
    }
    findings
}

#[test]
fn random_cases_equal_the_reference() {
    let cases = setting("FILLRATE_CASES", 10_000);
    let first = setting("FILLRATE_SEED", 1);
    let parts = 2;
    let mut all = Findings::default();
    thread::scope(|scope| {
        let part = |part: u64| {
            let seeds = first + part..first + cases;
            scope.spawn(move || check_seeds(seeds, parts as usize))
        };
        let running: Vec<_> = (0..parts).map(part).collect();
        for thread in running {
            let findings = thread.join().expect("a comparison does not panic");
            all.total += findings.total;
            all.reports.extend(findings.reports);
        }
    });
    assert!(all.reports.is_empty(), "{}", all.reports.join("\n"));
    println!("{cases} cases, {:?}", all.total);
    if cases >= 1000 {
        assert_cases_draw(cases, &all.total);
    }
}

/// The cases must reach all stages, or they test nothing.
fn assert_cases_draw(cases: u64, total: &Counters) {
    assert!(total.pixels_in / cases > 500 && total.pixels_out / cases > 200, "{total:?}");
    assert!(total.depth_fail / cases > 20 && total.alpha_fail / cases > 10, "{total:?}");
    assert!(total.chroma_fail / cases > 5, "{total:?}");
}
