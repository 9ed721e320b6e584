//! Random cases through the reference and the engine.
//!
//! `FILLRATE_CASES` sets how many cases are drawn (10,000 without it) and
//! `FILLRATE_SEED` the first seed.

use std::thread;

use fillrate_engine::Counters;
use fillrate_testkit::compare::Comparison;
use fillrate_testkit::random::case;

/// A number from the environment.
fn setting(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
}

/// Checks every `step`th seed; the counters show that the cases draw.
fn check_seeds(seeds: std::ops::Range<u64>, step: usize) -> Result<Counters, String> {
    let mut comparison = Comparison::new().map_err(|error| error.to_string())?;
    let mut total = Counters::default();
    for seed in seeds.step_by(step) {
        let checked = comparison.check(&case(seed));
        total += checked.map_err(|report| format!("FILLRATE_SEED={seed}: {report}"))?;
    }
    Ok(total)
}

#[test]
fn random_cases_equal_the_reference() {
    let cases = setting("FILLRATE_CASES", 10_000);
    let first = setting("FILLRATE_SEED", 1);
    let parts = 2;
    let total = thread::scope(|scope| {
        let part = |part: u64| {
            let seeds = first + part..first + cases;
            scope.spawn(move || check_seeds(seeds, parts as usize))
        };
        let running: Vec<_> = (0..parts).map(part).collect();
        running.into_iter().fold(Counters::default(), |mut total, thread| {
            match thread.join().expect("a comparison does not panic") {
                Ok(counters) => total += counters,
                Err(report) => panic!("{report}"),
            }
            total
        })
    });
    println!("{cases} cases, {total:?}");
    if cases >= 1000 {
        let per_case = |count: u64| count / cases;
        assert!(per_case(total.pixels_in) > 500 && per_case(total.pixels_out) > 200, "{total:?}");
        assert!(per_case(total.depth_fail) > 20 && total.chroma_fail > 0, "{total:?}");
        assert!(per_case(total.alpha_fail) > 10, "{total:?}");
    }
}
