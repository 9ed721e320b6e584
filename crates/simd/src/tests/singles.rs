//! 32-bit float lanes.

use super::{EDGES as INTS, RANDOM_LANES, Random, compare, padded, pairs, push, push_mask};
use crate::{Kernel, MAX_LANES, MaskLanes, Simd, SingleLanes};

/// Floats where signs, exponents and the range of `i32` end.
const EDGES: [f32; 26] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -0.5,
    0.999_999_94,
    -0.999_999_94,
    f32::MIN_POSITIVE,
    1e-45,
    -1e-45,
    1e-40,
    8_388_607.5,
    8_388_608.0,
    16_777_216.0,
    -16_777_217.0,
    2_147_483_500.0,
    2_147_483_648.0,
    -2_147_483_648.0,
    -2_147_484_000.0,
    4_294_967_296.0,
    f32::MAX,
    f32::MIN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
];

/// Any bit pattern, half of the time; else of the size that attributes have.
fn float(random: &mut Random) -> f32 {
    let word = random.word();
    if word & 1 == 0 {
        f32::from_bits(random.int() as u32)
    } else {
        (random.int() >> (word >> 1 & 31)) as f32 / (1u32 << (word >> 7 & 31)) as f32
    }
}

/// The bits of `x`, one pattern for every not-a-number.
fn bits(x: f32) -> u32 {
    if x.is_nan() { u32::MAX } else { x.to_bits() }
}

/// Defines one test for each operator.
macro_rules! operator_tests {
    ($($test:ident $op:tt)*) => {$(
        #[test]
        fn $test() {
            #[derive(Clone, Copy)]
            struct Run<'a>(&'a [f32], &'a [f32]);
            impl Kernel for Run<'_> {
                type Output = Vec<u32>;
                #[inline(always)]
                fn run<S: Simd>(self, simd: S) -> Vec<u32> {
                    let (mut out, mut lanes) = (Vec::new(), [0.0; MAX_LANES]);
                    for at in (0..self.0.len()).step_by(S::LANES) {
                        let (a, b) = (simd.load_g(&self.0[at..]), simd.load_g(&self.1[at..]));
                        simd.store_g(a $op b, &mut lanes);
                        out.extend(lanes[..S::LANES].iter().copied().map(bits));
                    }
                    out
                }
            }
            let mut random = Random(31);
            let (a, b) = pairs(&EDGES, || float(&mut random));
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

#[derive(Clone, Copy)]
struct Less<'a>(&'a [f32], &'a [f32]);

impl Kernel for Less<'_> {
    type Output = Vec<i32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<i32> {
        let mut out = Vec::new();
        for at in (0..self.0.len()).step_by(S::LANES) {
            let (a, b) = (simd.load_g(&self.0[at..]), simd.load_g(&self.1[at..]));
            push_mask(simd, a.lt(b), &mut out);
            // Selecting by the same mask gives the lesser one, bit for bit.
            push(simd, a.select(b, a.lt(b)).to_bits(), &mut out);
        }
        out
    }
}

#[test]
fn lt_and_select() {
    let mut random = Random(32);
    let (mut a, mut b) = pairs(&EDGES, || float(&mut random));
    // Neighbours, which random floats hardly ever are.
    for _ in 0..RANDOM_LANES / 16 {
        let x = float(&mut random);
        a.push(x);
        b.push(f32::from_bits(x.to_bits().wrapping_add(random.int() as u32 % 3).wrapping_sub(1)));
    }
    let found = compare("lt, select", FlatLess(&a, &b));
    let by_hand = a.iter().zip(&b).flat_map(|(a, b)| {
        let lesser = if a < b { a } else { b };
        [i32::from(a < b), lesser.to_bits() as i32]
    });
    assert!(found.into_iter().eq(by_hand));
}

/// [`Less`] with mask and choice of each lane side by side, whatever the lane count.
#[derive(Clone, Copy)]
struct FlatLess<'a>(&'a [f32], &'a [f32]);

impl Kernel for FlatLess<'_> {
    type Output = Vec<i32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<i32> {
        let grouped = Less(self.0, self.1).run(simd);
        let vectors = grouped.chunks(2 * S::LANES);
        vectors.flat_map(|v| (0..S::LANES).flat_map(|i| [v[i], v[S::LANES + i]])).collect()
    }
}

#[derive(Clone, Copy)]
struct Whole<'a>(&'a [f32]);

impl Kernel for Whole<'_> {
    type Output = Vec<i32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<i32> {
        let mut out = Vec::new();
        for at in (0..self.0.len()).step_by(S::LANES) {
            push(simd, simd.load_g(&self.0[at..]).to_i32(), &mut out);
        }
        out
    }
}

#[test]
fn to_i32_truncates_and_limits() {
    let mut random = Random(33);
    let mut values = EDGES.to_vec();
    for exponent in 0..34 {
        for near in [0.0, 1.0, -1.0, 0.5, -0.5] {
            let x = (1_u64 << exponent) as f32 + near;
            values.extend([x, x.next_up(), x.next_down(), -x, (-x).next_up(), (-x).next_down()]);
        }
    }
    values.extend((0..RANDOM_LANES).map(|_| float(&mut random)));
    let values = padded(values);
    let found = compare("to_i32", Whole(&values));
    assert!(found.into_iter().eq(values.iter().map(|&x| x as i32)));
}

#[derive(Clone, Copy)]
struct Floats<'a>(&'a [i32]);

impl Kernel for Floats<'_> {
    type Output = Vec<i32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<i32> {
        let mut out = Vec::new();
        for at in (0..self.0.len()).step_by(S::LANES) {
            let lanes = S::G::from_i32(simd.load(&self.0[at..]));
            push(simd, lanes.to_bits(), &mut out);
            let zero = S::G::from_bits(simd.splat(0));
            assert_eq!(zero.lt(zero).bits(), 0);
        }
        out
    }
}

#[test]
fn from_i32_rounds_to_nearest() {
    let mut random = Random(34);
    let mut values = INTS.to_vec();
    values.extend((-300..300).map(|i| (1 << 24) + i));
    values.extend((-300..300).map(|i| (1 << 26) + i));
    values.extend(random.ints(RANDOM_LANES));
    let values = padded(values);
    let found = compare("from_i32", Floats(&values));
    assert!(found.into_iter().eq(values.iter().map(|&i| (i as f32).to_bits() as i32)));
}

#[test]
fn widen_keeps_the_value() {
    #[derive(Clone, Copy)]
    struct Run<'a>(&'a [f32]);
    impl Kernel for Run<'_> {
        type Output = Vec<u64>;
        #[inline(always)]
        fn run<S: Simd>(self, simd: S) -> Vec<u64> {
            let mut out = vec![0.0; self.0.len()];
            for at in (0..self.0.len()).step_by(S::LANES) {
                simd.store_f(simd.load_g(&self.0[at..]).widen(), &mut out[at..]);
            }
            out.into_iter().map(wide_bits).collect()
        }
    }
    let mut random = Random(35);
    let mut values = EDGES.to_vec();
    values.extend((0..RANDOM_LANES).map(|_| float(&mut random)));
    let values = padded(values);
    let found = compare("widen", Run(&values));
    assert!(found.into_iter().eq(values.into_iter().map(|x| wide_bits(f64::from(x)))));
}

fn wide_bits(x: f64) -> u64 {
    if x.is_nan() { u64::MAX } else { x.to_bits() }
}

#[test]
fn truncate_i32_within_its_range() {
    #[derive(Clone, Copy)]
    struct Run<'a>(&'a [f32]);
    impl Kernel for Run<'_> {
        type Output = Vec<i32>;
        #[inline(always)]
        fn run<S: Simd>(self, simd: S) -> Vec<i32> {
            let mut out = Vec::new();
            for at in (0..self.0.len()).step_by(S::LANES) {
                push(simd, simd.load_g(&self.0[at..]).truncate_i32(), &mut out);
            }
            out
        }
    }
    let mut random = Random(36);
    let mut values = EDGES.to_vec();
    values.extend((0..RANDOM_LANES).map(|_| float(&mut random)));
    values.retain(|x| x.abs() < 2_147_483_648.0);
    let values = padded(values);
    let found = compare("truncate_i32", Run(&values));
    assert!(found.into_iter().eq(values.into_iter().map(|x| x as i32)));
}
