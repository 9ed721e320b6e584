//! Streams of nonsense through every way in: no panic, no hang. `FILLRATE_CASES` runs more,
//! `FILLRATE_SEED` others.

use fillrate_raw::hostile::{feed, stream};

fn variable(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
}

#[test]
fn nonsense_does_no_harm() {
    let seed = variable("FILLRATE_SEED", 1);
    for case in 0..variable("FILLRATE_CASES", 2000) {
        feed(&stream(seed << 32 | (case + 1)));
    }
}
