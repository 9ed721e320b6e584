//! The published numbers and shapes, with the one cost table, and the ablations.

use fillrate_raw::bench::bands::{bands, shapes};
use fillrate_raw::bench::run::{self, Outcome, Setting, Test};
use fillrate_raw::bench::{HERTZ, figures, gains, vectors};
use fillrate_raw::sim::Options;

fn measure(line: usize, scale: f32, options: Options) -> Outcome {
    let (outer, inner) = vectors::CHARTED[line].vectors();
    let setting = Setting { options, ..Setting::default() };
    run::run(Test { outer, inner, scale }, &setting).expect("no deadlock")
}

#[test]
fn published_bands_and_shapes_hold() {
    let outcomes = run::run_all(&run::charted(), &Setting::default(), 2, |_| {}).expect("runs");
    for band in bands(&outcomes) {
        assert!(band.holds(), "{band}");
    }
    for (name, shows) in shapes(&outcomes) {
        assert!(shows, "{name}");
    }
    assert!(outcomes.iter().all(|o| o.same_picture));
    let page = figures::page(&outcomes);
    assert_eq!(page.matches("<svg").count(), 4);
    assert!(!page.contains("NaN"));
}

#[test]
fn textured_modes_count_a_texel_per_fragment() {
    let outcome = measure(3, 0.3, Options::default());
    for counters in [outcome.single, outcome.grid] {
        assert_eq!(counters.texels, 5596);
        assert_eq!((counters.frames, counters.prims, counters.drawn_prims), (4, 24, 24));
        assert_eq!(counters.pixels, 5596);
    }
}

#[test]
fn matrix_has_2520_tests() {
    assert_eq!(run::matrix().len(), 2520);
}

#[test]
fn late_token_serialises_stage_1() {
    let late = measure(0, 0.01, Options { early_release: false, ..Options::default() });
    let early = measure(0, 0.01, Options::default());
    assert!(late.grid.triangle_rate(HERTZ) < 0.75 * early.grid.triangle_rate(HERTZ));
    let stage1 = 100.0 * late.grid.utilisation(4)[0];
    // One tile at a time, so at most a quarter; the thesis saw about that much.
    assert!((15.0..=25.0).contains(&stage1), "{stage1}");
    // Passing the token round while nothing comes counted as work, about as much.
    let stage4 = |o: &Outcome| 100.0 * o.grid.utilisation(4)[3];
    assert!((15.0..=27.0).contains(&stage4(&late)), "{}", stage4(&late));
    assert!(stage4(&early) < 1.0);
}

#[test]
fn plain_round_robin_waits_for_busy_tiles() {
    let plain = Options { skip_busy: false, ..Options::default() };
    let ratio = |line: usize, scale: f32| {
        let (waits, skips) =
            (measure(line, scale, plain), measure(line, scale, Options::default()));
        assert!(waits.same_picture);
        waits.grid.stream_cycles as f64 / skips.grid.stream_cycles as f64
    };
    // "Everything on" at moderate sizes, where four pipelines can be kept busy.
    assert!(ratio(8, 0.1) > 1.05);
    // The smallest triangles keep nobody busy.
    assert!((ratio(0, 0.01) - 1.0).abs() < 0.001);
}

#[test]
fn depth_bursts_raise_the_pixel_rate() {
    let burst = measure(0, 1.0, Options { z_once_per_burst: true, ..Options::default() });
    let plain = measure(0, 1.0, Options::default());
    assert!(burst.grid.pixel_rate(HERTZ) > 1.1 * plain.grid.pixel_rate(HERTZ));
}

#[test]
fn runs_repeat_exactly() {
    assert_eq!(measure(6, 0.2, Options::default()), measure(6, 0.2, Options::default()));
}

#[test]
fn improvements_gain_and_the_array_scales() {
    let gains = gains::measure().expect("no machine gets stuck");
    println!("{}", gains::table(&gains));
    assert!(gains.switches.iter().chain(&gains.scaling).all(|row| row.same_pictures));
    let row = |name: &str| {
        let row = gains.switches.iter().find(|row| row.name == name).expect("a row");
        row.values.clone()
    };
    let thesis = row("as in the thesis");
    for (name, mode, factor) in [
        ("z_once_per_burst", "flat colour", 1.15),
        ("overlap_test", "transparent", 1.02),
        ("pixel_pipeline", "flat colour", 1.5),
        ("banked", "flat colour", 1.8),
        ("banked + overlap_test", "transparent", 2.0),
        ("all but pixel_pipeline", "everything on", 1.03),
    ] {
        let at = gains::MODES.iter().position(|m| *m == mode).expect("a mode");
        assert!(row(name)[at] > factor * thesis[at], "{name}: {:?}", row(name));
    }
    // The target: ten times one tile on sixteen, and on to sixty-four.
    for row in &gains.scaling {
        let at = |columns| gains::SIZES.iter().position(|c| *c == columns).expect("a size");
        let (sixteen, sixty_four) = (row.values[at(4)], row.values[at(16)]);
        assert!(sixteen >= 10.0, "{}: {sixteen}", row.name);
        assert!(sixty_four > 3.0 * sixteen, "{}: {sixteen} to {sixty_four}", row.name);
    }
}
