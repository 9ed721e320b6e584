//! Float lanes.

use super::{RANDOM_LANES, Random, compare, padded, pairs, push, push_mask};
use crate::{FloatLanes, Kernel, MAX_LANES, Simd};

/// Floats where signs, exponents and the range of `i32` end.
const EDGES: [f64; 34] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -0.5,
    f64::EPSILON,
    -f64::EPSILON,
    f64::MIN_POSITIVE,
    -f64::MIN_POSITIVE,
    5e-324,
    -5e-324,
    1.1e-310,
    1.0 - f64::EPSILON / 2.0,
    -1.0 + f64::EPSILON / 2.0,
    2_147_483_646.0,
    2_147_483_646.999_999_8,
    2_147_483_647.0,
    2_147_483_647.5,
    2_147_483_648.0,
    -2_147_483_647.5,
    -2_147_483_648.0,
    -2_147_483_648.5,
    -2_147_483_649.0,
    4_294_967_296.0,
    -4_294_967_296.0,
    9_007_199_254_740_991.0,
    -9_007_199_254_740_991.0,
    9_007_199_254_740_992.0,
    9_223_372_036_854_775_808.0,
    -9_223_372_036_854_775_808.0,
    1e300,
    f64::INFINITY,
    f64::NEG_INFINITY,
];

/// Any bit pattern, half of the time; else of the size that coordinates have.
fn float(random: &mut Random) -> f64 {
    let word = random.word();
    if word & 1 == 0 {
        f64::from_bits(random.word())
    } else {
        (random.word() as i64 >> (word >> 1 & 63)) as f64 / f64::from(1 << (word >> 7 & 31))
    }
}

fn number(random: &mut Random) -> f64 {
    std::iter::repeat_with(|| float(random)).find(|x| !x.is_nan()).unwrap_or(0.0)
}

/// The bits of `x`, one pattern for every not-a-number: which one an operation
/// gives differs between processors.
fn bits(x: f64) -> u64 {
    if x.is_nan() { u64::MAX } else { x.to_bits() }
}

/// Defines one test for each operator.
macro_rules! operator_tests {
    ($($test:ident $op:tt)*) => {$(
        #[test]
        fn $test() {
            #[derive(Clone, Copy)]
            struct Run<'a>(&'a [f64], &'a [f64]);
            impl Kernel for Run<'_> {
                type Output = Vec<u64>;
                #[inline(always)]
                fn run<S: Simd>(self, simd: S) -> Vec<u64> {
                    let (mut out, mut lanes) = (Vec::new(), [0.0; MAX_LANES]);
                    for at in (0..self.0.len()).step_by(S::LANES) {
                        let (a, b) = (simd.load_f(&self.0[at..]), simd.load_f(&self.1[at..]));
                        simd.store_f(a $op b, &mut lanes);
                        out.extend(lanes[..S::LANES].iter().copied().map(bits));
                    }
                    out
                }
            }
            let mut random = Random(21);
            let (a, b) = pairs(&with_nan(), || float(&mut random));
            let found = compare(stringify!($test), Run(&a, &b));
            let by_hand = a.iter().zip(&b).map(|(a, b)| bits(a $op b));
            assert!(found.into_iter().eq(by_hand));
        }
    )*};
}
operator_tests! {
    add +
    sub -
    mul *
    div /
}

fn with_nan() -> Vec<f64> {
    let mut edges = EDGES.to_vec();
    edges.extend([f64::NAN, -f64::NAN, f64::from_bits(0x7ff0_0000_0000_0001)]);
    edges
}

#[derive(Clone, Copy)]
struct Less<'a>(&'a [f64], &'a [f64]);

impl Kernel for Less<'_> {
    type Output = Vec<i32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<i32> {
        let mut out = Vec::new();
        for at in (0..self.0.len()).step_by(S::LANES) {
            let (a, b) = (simd.load_f(&self.0[at..]), simd.load_f(&self.1[at..]));
            push_mask(simd, a.lt(b), &mut out);
        }
        out
    }
}

#[test]
fn lt_with_nan_and_zeros() {
    let mut random = Random(22);
    let (mut a, mut b) = pairs(&with_nan(), || float(&mut random));
    // Neighbours, which random floats hardly ever are.
    for _ in 0..RANDOM_LANES / 16 {
        let x = number(&mut random);
        a.push(x);
        b.push(f64::from_bits((x.to_bits()).wrapping_add(random.word() % 3).wrapping_sub(1)));
    }
    let found = compare("lt", Less(&a, &b));
    assert!(found.into_iter().eq(a.iter().zip(&b).map(|(a, b)| i32::from(a < b))));
}

#[derive(Clone, Copy)]
struct Floor<'a>(&'a [f64]);

impl Kernel for Floor<'_> {
    type Output = Vec<i32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<i32> {
        let mut out = Vec::new();
        for at in (0..self.0.len()).step_by(S::LANES) {
            push(simd, simd.load_f(&self.0[at..]).floor_i32(), &mut out);
        }
        out
    }
}

#[test]
fn floor_i32_limits_to_its_range() {
    let mut random = Random(23);
    let mut values = EDGES.to_vec();
    // Around powers of two and around the ends of the range: the integer, the
    // floats next to it, and the halves.
    for exponent in 0..64 {
        for near in [0.0, 1.0, -1.0, 0.5, -0.5] {
            let x = (1_u64 << exponent) as f64 + near;
            values.extend([x, x.next_up(), x.next_down(), -x, (-x).next_up(), (-x).next_down()]);
        }
    }
    values.extend((-40_000..40_000).map(|i| f64::from(i) / 4.0));
    values.extend((0..RANDOM_LANES).map(|_| number(&mut random)));
    values.extend((0..RANDOM_LANES).map(|_| f64::from(random.int()) + float_fraction(&mut random)));
    let values = padded(values);
    let found = compare("floor_i32", Floor(&values));
    let by_hand =
        values.iter().map(|x| x.floor().clamp(f64::from(i32::MIN), f64::from(i32::MAX)) as i32);
    assert!(found.into_iter().eq(by_hand));
}

/// A fraction of few bits, so that sums with an `i32` are exact.
fn float_fraction(random: &mut Random) -> f64 {
    (random.word() >> 44) as f64 / f64::from(1 << 20)
}

/// Anything may come out for not-a-number, but something must.
#[test]
fn floor_i32_of_nan_ends() {
    struct Run;
    impl Kernel for Run {
        type Output = usize;
        #[inline(always)]
        fn run<S: Simd>(self, simd: S) -> usize {
            let mut out = Vec::new();
            push(simd, simd.splat_f(f64::NAN).floor_i32(), &mut out);
            out.len()
        }
    }
    for level in crate::Level::available() {
        assert!(level.dispatch(Run) <= MAX_LANES);
    }
}

/// High words, and the floats themselves stored at an odd place.
#[derive(Clone, Copy)]
struct HighWord<'a>(&'a [f64]);

impl Kernel for HighWord<'_> {
    type Output = Vec<u64>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<u64> {
        let (mut words, mut copies) = (Vec::new(), vec![0.0; self.0.len() + 1]);
        for at in (0..self.0.len()).step_by(S::LANES) {
            let lanes = simd.load_f(&self.0[at..]);
            push(simd, lanes.high_word(), &mut words);
            simd.store_f(lanes, &mut copies[at + 1..]);
        }
        let words = words.into_iter().map(|word| u64::from(word as u32));
        words.chain(copies[1..].iter().map(|x| x.to_bits())).collect()
    }
}

#[test]
fn high_word_of_every_kind_of_float() {
    let mut random = Random(24);
    let mut values = with_nan();
    // Every sign and exponent, with the mantissas that carry into the word.
    for top in 0..4096_u64 {
        for mantissa in [0, 1, 0xffff_ffff, 1 << 32, (1 << 52) - 1] {
            values.push(f64::from_bits(top << 52 | mantissa));
        }
    }
    values.extend((0..RANDOM_LANES).map(|_| f64::from_bits(random.word())));
    let values = padded(values);
    let found = compare("high_word", HighWord(&values));
    let words = values.iter().map(|x| x.to_bits() >> 32);
    assert!(found.into_iter().eq(words.chain(values.iter().map(|x| x.to_bits()))));
}

/// Defines one test for each way to round, and for leaving out the sign.
macro_rules! rounding_tests {
    ($($test:ident $method:ident)*) => {$(
        #[test]
        fn $test() {
            #[derive(Clone, Copy)]
            struct Run<'a>(&'a [f64]);
            impl Kernel for Run<'_> {
                type Output = Vec<u64>;
                #[inline(always)]
                fn run<S: Simd>(self, simd: S) -> Vec<u64> {
                    let (mut out, mut lanes) = (Vec::new(), [0.0; MAX_LANES]);
                    for at in (0..self.0.len()).step_by(S::LANES) {
                        simd.store_f(simd.load_f(&self.0[at..]).$method(), &mut lanes);
                        out.extend(lanes[..S::LANES].iter().copied().map(bits));
                    }
                    out
                }
            }
            let mut random = Random(25);
            let mut values = with_nan();
            // Around powers of two, also where floats have no fractions any more.
            for exponent in 0..64 {
                let power = (1_u64 << exponent) as f64;
                for x in [power, power + 0.5, power - 0.5] {
                    let near = [x, x.next_up(), x.next_down()];
                    values.extend(near.iter().chain(&near.map(|x| -x)));
                }
            }
            values.extend((0..RANDOM_LANES).map(|_| float(&mut random)));
            let values = padded(values);
            let found = compare(stringify!($method), Run(&values));
            assert!(found.into_iter().eq(values.iter().map(|x| bits(x.$method()))));
        }
    )*};
}
rounding_tests! {
    trunc_keeps_the_sign trunc
    floor_of_every_kind_of_float floor
    abs_of_every_kind_of_float abs
}

#[test]
fn from_i32_is_exact() {
    #[derive(Clone, Copy)]
    struct Run<'a>(&'a [i32]);
    impl Kernel for Run<'_> {
        type Output = Vec<f64>;
        #[inline(always)]
        fn run<S: Simd>(self, simd: S) -> Vec<f64> {
            let mut out = vec![0.0; self.0.len()];
            for at in (0..self.0.len()).step_by(S::LANES) {
                simd.store_f(S::F::from_i32(simd.load(&self.0[at..])), &mut out[at..]);
            }
            out
        }
    }
    let mut values = super::EDGES.to_vec();
    values.extend(Random(26).ints(RANDOM_LANES));
    let values = padded(values);
    let found = compare("from_i32", Run(&values));
    assert!(found.into_iter().eq(values.into_iter().map(f64::from)));
}

#[test]
fn select_under_every_mask() {
    #[derive(Clone, Copy)]
    struct Run<'a>(&'a [f64]);
    impl Kernel for Run<'_> {
        type Output = Vec<f64>;
        #[inline(always)]
        fn run<S: Simd>(self, simd: S) -> Vec<f64> {
            let mut out = vec![0.0; self.0.len()];
            for at in (0..self.0.len()).step_by(S::LANES) {
                let lanes = simd.load_f(&self.0[at..]);
                let bits = (at / MAX_LANES) as u32 >> (at % MAX_LANES);
                let other = simd.splat_f(0.0) - lanes;
                simd.store_f(lanes.select(other, simd.mask(bits)), &mut out[at..]);
            }
            out
        }
    }
    let values: Vec<f64> = (0..MAX_LANES << MAX_LANES).map(|i| i as f64 + 1.0).collect();
    let found = compare("select", Run(&values));
    for (at, (found, value)) in found.into_iter().zip(values).enumerate() {
        let on = (at / MAX_LANES) >> (at % MAX_LANES) & 1 != 0;
        assert_eq!(found, if on { value } else { -value });
    }
}
