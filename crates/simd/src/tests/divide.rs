//! The exact perspective divide.
//!
//! For integers `0 < w < 2^53` and `|a| < 2^53`, the floor of the correctly
//! rounded `f64` quotient is the floor of the true quotient. Rounding up to an
//! integer `n` needs `n - a / w <= n * 2^-53`; with `r = n * w - a`, an integer
//! of at least 1, that means `r <= n * w * 2^-53 = (a + r) * 2^-53 < 1`. For
//! negative `a` the same holds with the magnitudes; otherwise rounding is
//! monotone and crosses no integer.

use super::{RANDOM_LANES, Random, compare, push};
use crate::{FloatLanes, Kernel, MAX_LANES, Simd};

/// The first integer that the property leaves out.
const LIMIT: i64 = 1 << 53;

#[derive(Clone, Copy)]
struct Quotients<'a>(&'a [f64], &'a [f64]);

impl Kernel for Quotients<'_> {
    type Output = Vec<i32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<i32> {
        let mut out = Vec::with_capacity(self.0.len());
        for at in (0..self.0.len()).step_by(S::LANES) {
            let quotient = simd.load_f(&self.0[at..]) / simd.load_f(&self.1[at..]);
            push(simd, quotient.floor_i32(), &mut out);
        }
        out
    }
}

/// The true floor of `a / w`.
fn floor(a: i64, w: i64) -> i128 {
    i128::from(a).div_euclid(i128::from(w))
}

/// Compares the lanes, and the unlimited `f64` floor, with integers.
#[track_caller]
fn check(mut cases: Vec<(i64, i64)>) {
    cases.resize(cases.len().next_multiple_of(MAX_LANES), (0, 1));
    assert!(cases.iter().all(|&(a, w)| a.abs() < LIMIT && 0 < w && w < LIMIT));
    let (a, w): (Vec<f64>, Vec<f64>) = cases.iter().map(|&(a, w)| (a as f64, w as f64)).unzip();
    let found = compare("divide", Quotients(&a, &w));
    for (&(a, w), found) in cases.iter().zip(found) {
        let exact = floor(a, w);
        assert_eq!((a as f64 / w as f64).floor() as i128, exact, "{a} / {w} in full");
        let limited = exact.clamp(i32::MIN.into(), i32::MAX.into());
        assert_eq!(i128::from(found), limited, "{a} / {w}");
    }
}

/// A positive integer below `limit`, of any size.
fn magnitude(random: &mut Random, limit: i64) -> i64 {
    let bits = random.word() % 54;
    ((random.word() >> (63 - bits)) as i64).rem_euclid(limit).max(1)
}

fn signed(random: &mut Random, value: i64) -> i64 {
    if random.word() & 1 == 0 { value } else { -value }
}

#[test]
fn divide_random_quotients() {
    let mut random = Random(31);
    let case = |random: &mut Random| {
        let a = magnitude(random, LIMIT);
        (signed(random, a), magnitude(random, LIMIT))
    };
    check((0..RANDOM_LANES).map(|_| case(&mut random)).collect());
}

#[test]
fn divide_at_and_beside_exact_quotients() {
    let mut random = Random(32);
    let mut cases = Vec::new();
    while cases.len() < RANDOM_LANES {
        let w = magnitude(&mut random, LIMIT);
        // As large as the product allows, or small.
        let q = (LIMIT - 2) / w;
        let q = if random.word() & 3 == 0 { q } else { magnitude(&mut random, q.max(2)) };
        let a = signed(&mut random, q.min((LIMIT - 2) / w) * w);
        cases.extend([(a, w), (a - 1, w), (a + 1, w)]);
    }
    check(cases);
}

/// The shape of the perspective divide: 256 times a texture coordinate.
#[test]
fn divide_texture_coordinates() {
    let mut random = Random(33);
    let case = |random: &mut Random| {
        let w = magnitude(random, 1 << 45) | 1;
        let texel = random.word() as i64 % (1 << 18);
        // Half of the coordinates are whole texels.
        let s = (i128::from(texel) * i128::from(w) / 256) as i64 % (1 << 45);
        let s = if random.word() & 1 == 0 { s } else { signed(random, s) ^ 1 };
        (256 * s, w)
    };
    check((0..RANDOM_LANES).map(|_| case(&mut random)).collect());
}

#[test]
fn divide_at_the_limits() {
    let near = |x: i64| [x - 2, x - 1, x, x + 1, x + 2];
    let ends = [3, 1 << 26, 1 << 31, 1 << 52, LIMIT - 3].into_iter().flat_map(near);
    let sizes: Vec<i64> = ends.filter(|&x| 0 < x && x < LIMIT).collect();
    let numerators = sizes.iter().flat_map(|&a| [a, -a]).chain([0]);
    let cases = numerators.flat_map(|a| sizes.iter().map(move |&w| (a, w)));
    check(cases.collect());
}

/// The test would notice: two roundings do fail beside exact quotients.
#[test]
fn divide_by_reciprocal_is_not_exact() {
    let mut random = Random(34);
    let wrong = (0..RANDOM_LANES).filter(|_| {
        let w = magnitude(&mut random, 1 << 30) | 1;
        let a = w * magnitude(&mut random, 1 << 22);
        (a as f64 * (1.0 / w as f64)).floor() as i128 != floor(a, w)
    });
    assert!(wrong.count() > RANDOM_LANES / 1000);
}
