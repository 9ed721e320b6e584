//! Integer lanes.

use super::{EDGES, RANDOM_LANES, Random, compare, padded, pairs, push, push_mask};
use crate::{IntLanes, Kernel, MAX_LANES, Simd};

/// Defines one test for each operation on two vectors.
macro_rules! binary_tests {
    ($($test:ident: |$a:ident, $b:ident| $result:expr;)*) => {$(
        #[test]
        fn $test() {
            #[derive(Clone, Copy)]
            struct Run<'a>(&'a [i32], &'a [i32]);
            impl Kernel for Run<'_> {
                type Output = Vec<i32>;
                #[inline(always)]
                fn run<S: Simd>(self, simd: S) -> Vec<i32> {
                    let mut out = Vec::with_capacity(self.0.len());
                    for at in (0..self.0.len()).step_by(S::LANES) {
                        let ($a, $b) = (simd.load(&self.0[at..]), simd.load(&self.1[at..]));
                        push(simd, $result, &mut out);
                    }
                    out
                }
            }
            let mut random = Random(1);
            let (a, b) = pairs(&EDGES, || random.int());
            compare(stringify!($test), Run(&a, &b));
        }
    )*};
}

binary_tests! {
    add: |a, b| a + b;
    sub: |a, b| a - b;
    and: |a, b| a & b;
    or: |a, b| a | b;
    xor: |a, b| a ^ b;
    mul: |a, b| a.mul(b);
    min: |a, b| a.min(b);
    max: |a, b| a.max(b);
    add16: |a, b| a.add16(b);
    sub16: |a, b| a.sub16(b);
    add_sat_u16: |a, b| a.add_sat_u16(b);
    mul16: |a, b| a.mul16(b);
    mul_high_i16: |a, b| a.mul_high_i16(b);
    min16: |a, b| a.min16(b);
    max16: |a, b| a.max16(b);
    eq16: |a, b| a.eq16(b);
    select_by_gt: |a, b| a.select(b, b.gt(a));
    select_by_eq: |a, b| a.add16(b).select(b, b.eq(a));
}

/// Comparisons of two vectors as masks: eq, gt, and both combined.
#[derive(Clone, Copy)]
struct Compare<'a>(&'a [i32], &'a [i32]);

impl Kernel for Compare<'_> {
    type Output = Vec<i32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<i32> {
        // All results of a kind together, so that the order does not depend
        // on the lane count.
        let (mut eq, mut gt, mut both) = (Vec::new(), Vec::new(), Vec::new());
        for at in (0..self.0.len()).step_by(S::LANES) {
            let (a, b) = (simd.load(&self.0[at..]), simd.load(&self.1[at..]));
            push_mask(simd, a.eq(b), &mut eq);
            push_mask(simd, a.gt(b), &mut gt);
            push_mask(simd, (a.eq(b) | a.gt(b)) & simd.splat(0).gt(b), &mut both);
        }
        [eq, gt, both].concat()
    }
}

#[test]
fn comparisons() {
    let mut random = Random(2);
    let (mut a, mut b) = pairs(&EDGES, || random.int());
    // Random words are hardly ever equal.
    let near = RANDOM_LANES / 16;
    a.extend((0..near).map(|_| random.int() & 3));
    b.extend((0..near).map(|_| random.int() & 3));
    let found = compare("comparisons", Compare(&a, &b));
    let by_hand = a.iter().zip(&b);
    let eq = by_hand.clone().map(|(a, b)| i32::from(a == b));
    let gt = by_hand.clone().map(|(a, b)| i32::from(a > b));
    let both = by_hand.map(|(a, b)| i32::from(a >= b && *b < 0));
    assert!(found.into_iter().eq(eq.chain(gt).chain(both)));
}

/// A shift by one count, as a method of the lanes.
#[derive(Clone, Copy, Debug)]
enum Shift {
    Left,
    Right,
    Arithmetic,
    Left16,
    Right16,
}

#[derive(Clone, Copy)]
struct Shifted<'a>(Shift, u32, &'a [i32]);

impl Kernel for Shifted<'_> {
    type Output = Vec<i32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<i32> {
        let Shifted(shift, count, values) = self;
        let mut out = Vec::with_capacity(values.len());
        for at in (0..values.len()).step_by(S::LANES) {
            let value = simd.load(&values[at..]);
            let result = match shift {
                Shift::Left => value.shl(count),
                Shift::Right => value.shr(count),
                Shift::Arithmetic => value.sar(count),
                Shift::Left16 => value.shl16(count),
                Shift::Right16 => value.shr16(count),
            };
            push(simd, result, &mut out);
        }
        out
    }
}

#[test]
fn shifts_by_every_count() {
    let mut random = Random(3);
    let mut values = EDGES.to_vec();
    values.extend((0..32).map(|bit| 1 << bit));
    values.extend(random.ints(RANDOM_LANES / 32));
    let values = padded(values);
    for shift in [Shift::Left, Shift::Right, Shift::Arithmetic] {
        for count in 0..32 {
            compare(&format!("{shift:?} by {count}"), Shifted(shift, count, &values));
        }
    }
}

#[test]
fn shifts16_of_every_value_by_every_count() {
    // Each half takes every value, the two of a lane different ones.
    let values: Vec<i32> =
        (0..=0xffff_u32).map(|low| (low | (low ^ 0xa5c3) << 16) as i32).collect();
    for shift in [Shift::Left16, Shift::Right16] {
        for count in 0..16 {
            compare(&format!("{shift:?} by {count}"), Shifted(shift, count, &values));
        }
    }
}

/// Shifts with a count of its own in every lane.
#[derive(Clone, Copy)]
struct ShiftedEach<'a>(&'a [i32], &'a [i32]);

impl Kernel for ShiftedEach<'_> {
    type Output = Vec<i32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<i32> {
        let mut out = Vec::with_capacity(self.0.len());
        for at in (0..self.0.len()).step_by(S::LANES) {
            let value = simd.load(&self.0[at..]);
            push(simd, value.sar_each(simd.load(&self.1[at..])), &mut out);
        }
        out
    }
}

#[test]
fn sar_each_by_every_count() {
    let mut random = Random(5);
    let edges = EDGES.into_iter().chain((0..32).map(|bit| 1 << bit));
    let (mut values, mut counts): (Vec<i32>, Vec<i32>) =
        edges.flat_map(|value| (0..32).map(move |count| (value, count))).unzip();
    values.extend(random.ints(RANDOM_LANES));
    counts.extend((0..RANDOM_LANES).map(|_| random.int() & 31));
    let (values, counts) = (padded(values), padded(counts));
    let found = compare("sar_each", ShiftedEach(&values, &counts));
    let by_hand = values.iter().zip(&counts).map(|(value, count)| value >> count);
    assert!(found.into_iter().eq(by_hand));
}

/// Defines a kernel on pairs of halves, for values that the random ones of
/// `binary_tests` rarely meet.
macro_rules! halves {
    ($kernel:ident, $method:ident) => {
        #[derive(Clone, Copy)]
        struct $kernel<'a>(&'a [i32], &'a [i32]);
        impl Kernel for $kernel<'_> {
            type Output = Vec<i32>;
            #[inline(always)]
            fn run<S: Simd>(self, simd: S) -> Vec<i32> {
                let mut out = Vec::with_capacity(self.0.len());
                for at in (0..self.0.len()).step_by(S::LANES) {
                    let (a, b) = (simd.load(&self.0[at..]), simd.load(&self.1[at..]));
                    push(simd, a.$method(b), &mut out);
                }
                out
            }
        }
    };
}
halves!(Equal16, eq16);
halves!(DotBytes, dot_bytes);

#[test]
fn eq16_of_every_value_with_its_neighbours() {
    // Against itself, against itself with one bit changed, and half of each.
    let values: Vec<i32> = (0..=0xffff_u32).map(|v| (v | v << 16) as i32).collect();
    compare("eq16 equal", Equal16(&values, &values));
    for bit in 0..32 {
        let other: Vec<i32> = values.iter().map(|v| v ^ 1 << bit).collect();
        let found = compare("eq16 near", Equal16(&values, &other));
        let expected = if bit < 16 { -0x1_0000 } else { 0xffff };
        assert!(found.into_iter().all(|lane| lane == expected));
    }
}

/// The sum that `dot_bytes` documents, of one half.
fn dot(bytes: u32, weights: u32) -> u32 {
    (bytes & 0xff) * (weights & 0xff) + (bytes >> 8 & 0xff) * (weights >> 8 & 0xff)
}

#[test]
fn dot_bytes_of_all_bytes_by_filter_weights() {
    // All pairs of bytes in the low half; the high half has them swapped.
    let bytes: Vec<i32> =
        (0..=0xffff_u16).map(|b| (u32::from(b) | u32::from(b.swap_bytes()) << 16) as i32).collect();
    for first in 0..=16 {
        for second in 0..=16_i32 {
            let weights = first | second << 8 | second << 16 | first << 24;
            let found = compare("dot_bytes", DotBytes(&bytes, &vec![weights; bytes.len()]));
            let by_hand = (0..=0xffff).map(|b| dot(b, weights as u32 & 0xffff) * 0x1_0001);
            assert!(found.into_iter().eq(by_hand.map(|lane| lane as i32)), "weights {weights:x}");
        }
    }
}

#[test]
fn dot_bytes_within_its_limits() {
    let mut random = Random(4);
    let bytes = random.ints(RANDOM_LANES);
    // Two weights that sum to 128 at most keep the sum below 32768.
    let mut half = || {
        let first = random.word() as u32 % 128;
        let second = random.word() as u32 % (129 - first).min(128);
        first | second << 8
    };
    let weights: Vec<i32> = (0..RANDOM_LANES).map(|_| (half() | half() << 16) as i32).collect();
    let found = compare("dot_bytes", DotBytes(&bytes, &weights));
    let by_hand = bytes.iter().zip(&weights).map(|(&b, &w)| {
        let (b, w) = (b as u32, w as u32);
        (dot(b, w) | dot(b >> 16, w >> 16) << 16) as i32
    });
    assert!(found.into_iter().eq(by_hand));
}

#[derive(Clone, Copy)]
struct Any<'a>(&'a [i32]);

impl Kernel for Any<'_> {
    type Output = Vec<i32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<i32> {
        let mut found = Vec::new();
        for at in (0..self.0.len()).step_by(MAX_LANES) {
            let mut any = false;
            for j in (0..MAX_LANES).step_by(S::LANES) {
                any |= simd.load(&self.0[at + j..]).any();
            }
            found.push(i32::from(any));
        }
        found
    }
}

#[test]
fn any_bit_of_any_lane() {
    let mut lanes = vec![0; MAX_LANES];
    for lane in 0..MAX_LANES {
        for bit in 0..32 {
            let mut one = vec![0; MAX_LANES];
            one[lane] = 1 << bit;
            lanes.extend(one);
        }
    }
    let found = compare("any", Any(&lanes));
    assert!(found[0] == 0 && found[1..].iter().all(|&any| any == 1));
}
