//! Every operation at every level of the machine, compared with the scalar
//! level: edge values, and a million random lanes for each.
//!
//! A test is a kernel from arrays to an array. It runs at each level, and all
//! results must equal the scalar level's; what the scalar level computes is
//! compared with plain Rust where that says more than its own source.

mod divide;
mod floats;
mod ints;
mod levels;
mod memory;
mod singles;

use crate::{Kernel, Level, MAX_LANES, MaskLanes, Simd};

/// Random lanes for each operation; a multiple of every lane count.
const RANDOM_LANES: usize = 1 << 20;

/// Integers where carries, signs and halves meet.
const EDGES: [i32; 24] = [
    0,
    1,
    -1,
    2,
    -2,
    0x7f,
    0x80,
    0xff,
    0x100,
    0x7fff,
    0x8000,
    0xffff,
    0x1_0000,
    0x7fff_8000,
    i32::MAX,
    i32::MAX - 1,
    i32::MIN,
    i32::MIN + 1,
    -0x8000,
    -0x8001,
    0x0001_8000,
    0x7f80_ff01,
    0x5555_aaaa,
    -0x5555_aaab,
];

/// A small generator with a fixed seed (SplitMix64).
struct Random(u64);

impl Random {
    fn word(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ mixed >> 31
    }

    fn int(&mut self) -> i32 {
        self.word() as i32
    }

    fn ints(&mut self, count: usize) -> Vec<i32> {
        (0..count).map(|_| self.int()).collect()
    }
}

/// Pads `values` to whole vectors of every level.
fn padded<T: Copy + Default>(mut values: Vec<T>) -> Vec<T> {
    values.resize(values.len().next_multiple_of(MAX_LANES), T::default());
    values
}

/// All pairs of `edges`, then random pairs.
fn pairs<T: Copy + Default>(edges: &[T], mut random: impl FnMut() -> T) -> (Vec<T>, Vec<T>) {
    let edge_pairs = edges.iter().flat_map(|&a| edges.iter().map(move |&b| (a, b)));
    let mut both: Vec<(T, T)> = edge_pairs.collect();
    both.extend((0..RANDOM_LANES).map(|_| (random(), random())));
    let (a, b) = both.into_iter().unzip();
    (padded(a), padded(b))
}

/// Runs `kernel` at every level above scalar and compares with the scalar run.
/// Returns the scalar result.
#[track_caller]
fn compare<K: Kernel<Output = Vec<T>> + Clone, T: PartialEq + std::fmt::Debug>(
    what: &str,
    kernel: K,
) -> Vec<T> {
    let expected = Level::Scalar.dispatch(kernel.clone());
    for level in Level::available() {
        let actual = level.dispatch(kernel.clone());
        assert_eq!(actual.len(), expected.len(), "{what} at {level}");
        let wrong = actual.iter().zip(&expected).position(|(a, e)| a != e);
        if let Some(at) = wrong {
            let (actual, expected) = (&actual[at], &expected[at]);
            panic!("{what} at {level}: lane {at} is {actual:?}, expected {expected:?}");
        }
    }
    expected
}

/// Appends one 0 or 1 for each lane of `mask`.
fn push_mask<S: Simd>(_: S, mask: S::M, to: &mut Vec<i32>) {
    let bits = mask.bits();
    assert_eq!(u64::from(bits) >> S::LANES, 0, "bits beyond the lanes");
    to.extend((0..S::LANES).map(|lane| (bits >> lane & 1) as i32));
}

/// Appends the integers of `lanes`.
fn push<S: Simd>(simd: S, lanes: S::I, to: &mut Vec<i32>) {
    let start = to.len();
    to.resize(start + S::LANES, 0);
    simd.store(lanes, &mut to[start..]);
}
