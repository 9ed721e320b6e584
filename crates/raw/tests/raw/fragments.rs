//! Fragment counts of the triangle pattern, and the counters that follow from them.

use fillrate_raw::host::Host;
use fillrate_raw::observer::Observer;
use fillrate_raw::protocol::Record;
use fillrate_raw::sim::cost::COSTS;
use fillrate_raw::sim::single;
use fillrate_raw::stage::combine::Textured;
use fillrate_raw::stage::raster::{Interpolants, RasterWork};
use fillrate_raw::state::PrimInfo;
use fillrate_raw::{Config, Device, Errata};

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

/// Scale, fragments of each triangle, pixels visited in one pattern, rows.
const TRIANGLES: [(f32, [u64; 6], u64, u64); 7] = [
    (1.0, [2400, 360, 384, 96, 2564, 9600], 16469, 353),
    (0.5, [600, 90, 96, 24, 642, 2400], 4196, 176),
    (0.3, [216, 31, 35, 9, 244, 864], 1550, 106),
    (0.2, [96, 16, 15, 3, 94, 384], 711, 71),
    (0.1, [24, 3, 4, 1, 25, 96], 195, 35),
    (0.05, [6, 1, 1, 0, 9, 24], 57, 18),
    (0.01, [0, 0, 0, 0, 0, 1], 3, 3),
];

/// Counts the work of stage 2, triangle by triangle.
#[derive(Default)]
struct Walks {
    triangles: Vec<u64>,
    visited: u64,
    rows: u64,
}

impl Walks {
    fn add(&mut self, work: RasterWork) {
        self.visited += u64::from(work.visited);
        self.rows += u64::from(work.rows);
    }
}

impl Observer for Walks {
    fn setup(&mut self, _: Interpolants) {
        self.triangles.push(0);
    }

    fn fragment(&mut self, _: &PrimInfo, work: RasterWork, _: &Textured) {
        *self.triangles.last_mut().expect("set up before") += 1;
        self.add(work);
    }

    fn rows(&mut self, work: RasterWork) {
        self.add(work);
    }
}

#[test]
fn work_per_triangle_and_scale() {
    for (scale, triangles, visited, rows) in TRIANGLES {
        let mut host = Host::new(Device::observed(Config::default(), Walks::default()));
        let records = pattern(scale, 0xff, &[]);
        records.iter().for_each(|record| host.push(*record).expect("a good stream"));
        let walks = host.device().observer();
        assert_eq!(walks.triangles, triangles.repeat(4), "scale {scale}");
        assert_eq!((walks.visited, walks.rows), (4 * visited, 4 * rows), "scale {scale}");
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
