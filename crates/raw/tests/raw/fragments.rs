//! Fragment counts of the triangle pattern, and the counters that follow from them.

use fillrate_raw::protocol::Record;
use fillrate_raw::sim::cost::COSTS;
use fillrate_raw::sim::single;
use fillrate_raw::{Config, Errata};

use crate::common::{on_single, pattern};

/// Scale and fragments of one pattern.
const COUNTS: [(f32, u64); 7] =
    [(1.0, 15404), (0.5, 3852), (0.3, 1399), (0.2, 608), (0.1, 153), (0.05, 41), (0.01, 1)];

#[test]
fn fragments_per_scale() {
    for (scale, count) in COUNTS {
        let device = on_single(&pattern(scale, 0xff, &[]));
        let counters = device.observer().counters();
        assert_eq!(counters.frags, 4 * count, "scale {scale}");
        assert_eq!(counters.tex_frags, counters.frags);
        assert_eq!((counters.drawn_prims, counters.texels), (24, 0));
    }
}

#[test]
fn pattern_is_171_words() {
    let words = pattern(1.0, 0xff, &[]).iter().filter(|r| matches!(r, Record::Data(_))).count();
    // Model matrix 17, begin 1, four patterns, end 3.
    assert_eq!(words, 17 + 1 + 4 * 171 + 3);
}

#[test]
fn faithful_rules_count_the_same() {
    let config = Config { errata: Errata::FAITHFUL, ..Config::default() };
    for (scale, count) in COUNTS {
        let (device, _) = single::play(config, COSTS, &pattern(scale, 0xff, &[]));
        assert_eq!(device.observer().counters().frags, 4 * count, "scale {scale}");
    }
}
