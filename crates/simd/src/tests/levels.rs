//! Names, detection and dispatch.

use crate::{Kernel, Level, MAX_LANES, Simd};

/// The level and the lane count that a kernel is run with.
struct Which;

impl Kernel for Which {
    type Output = (Level, usize);
    #[inline(always)]
    fn run<S: Simd>(self, _: S) -> (Level, usize) {
        (S::LEVEL, S::LANES)
    }
}

/// A kernel entered a second time, from within.
struct Nested;

impl Kernel for Nested {
    type Output = (Level, usize);
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> (Level, usize) {
        simd.vectorize(Which)
    }
}

#[test]
fn dispatch_runs_the_level_asked_for() {
    for level in Level::available() {
        let (ran, lanes) = level.dispatch(Which);
        assert_eq!(ran, level);
        assert_eq!(level.dispatch(Nested), (ran, lanes));
        assert!(lanes >= 4 && MAX_LANES.is_multiple_of(lanes));
    }
}

#[test]
fn dispatch_of_a_missing_level_is_scalar() {
    let missing = Level::ALL.into_iter().filter(|level| !level.is_available());
    assert!(missing.map(|level| level.dispatch(Which).0).all(|ran| ran == Level::Scalar));
}

#[test]
fn names_are_read_back() {
    for level in Level::ALL {
        assert_eq!(level.name().parse(), Ok(level));
        assert_eq!(format!(" {level} ").to_uppercase().parse(), Ok(level));
    }
}

#[test]
fn unknown_name_lists_the_known_ones() {
    let error = "sse9".parse::<Level>().map_err(|error| error.to_string());
    let known = "scalar sse4.1 avx2 avx512 neon simd128";
    assert_eq!(error, Err(format!("unknown simd level 'sse9'; known: {known}")));
}

#[test]
fn best_is_available() {
    assert!(Level::available().any(|level| level == Level::Scalar));
    assert!(Level::best().is_available());
}

/// Where the target itself promises a level, it must be found.
#[test]
fn level_of_the_target_is_available() {
    let neon = cfg!(all(target_arch = "aarch64", target_endian = "little"));
    assert_eq!(Level::Neon.is_available(), neon);
    let simd128 = cfg!(all(target_arch = "wasm32", target_feature = "simd128"));
    assert_eq!(Level::Simd128.is_available(), simd128);
}
