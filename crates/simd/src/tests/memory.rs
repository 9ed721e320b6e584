//! Loads, stores, masks and tables.

use super::{EDGES, RANDOM_LANES, Random, compare, padded, push, push_mask};
use crate::{FloatLanes, IntLanes, Kernel, Level, MAX_LANES, MaskLanes, Simd};

/// Loads from `offset` on, inverts, and stores at the same place.
#[derive(Clone, Copy)]
struct Inverted<'a>(&'a [i32], usize);

impl Kernel for Inverted<'_> {
    type Output = Vec<i32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<i32> {
        let Inverted(values, offset) = self;
        let mut out = values.to_vec();
        for at in (offset..values.len()).step_by(S::LANES) {
            simd.store(simd.load(&values[at..]) ^ simd.splat(-1), &mut out[at..]);
        }
        out
    }
}

#[test]
fn load_and_store_at_any_alignment() {
    for offset in 0..MAX_LANES {
        let values = Random(11).ints(offset + RANDOM_LANES / MAX_LANES);
        let found = compare("load and store", Inverted(&values, offset));
        assert_eq!(found[..offset], values[..offset]);
        assert!((offset..values.len()).all(|at| found[at] == !values[at]));
    }
}

#[derive(Clone, Copy)]
struct Wide<'a>(&'a [u16], usize);

impl Kernel for Wide<'_> {
    type Output = Vec<i32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<i32> {
        let mut out = Vec::new();
        let from = &self.0[self.1..];
        for at in (0..from.len()).step_by(S::LANES) {
            push(simd, simd.load16(&from[at..]), &mut out);
        }
        out
    }
}

#[test]
fn load16_of_every_value() {
    for offset in 0..MAX_LANES {
        let mut values = vec![0; offset];
        values.extend(0..=0xffff);
        let found = compare("load16", Wide(&values, offset));
        assert!(found.into_iter().eq(0..=0xffff));
    }
}

/// Stores sixteen lanes under each of `masks`, sixteen places apart, from the
/// last to the first, so that a store beyond its lanes meets finished ones.
macro_rules! masked_store {
    ($kernel:ident, $method:ident, $element:ty) => {
        #[derive(Clone, Copy)]
        struct $kernel<'a> {
            masks: &'a [u16],
            values: &'a [i32],
            old: &'a [$element],
        }
        impl Kernel for $kernel<'_> {
            type Output = Vec<$element>;
            #[inline(always)]
            fn run<S: Simd>(self, simd: S) -> Vec<$element> {
                let mut out = self.old.to_vec();
                for (group, &mask) in self.masks.iter().enumerate().rev() {
                    for part in (0..MAX_LANES).step_by(S::LANES).rev() {
                        let at = group * MAX_LANES + part;
                        let mask = simd.mask(u32::from(mask) >> part);
                        simd.$method(simd.load(&self.values[at..]), &mut out[at..], mask);
                    }
                }
                out
            }
        }
    };
}
masked_store!(Store16, store16, u16);
masked_store!(StoreMasked, store_masked, i32);

/// Every mask of sixteen lanes.
fn all_masks() -> Vec<u16> {
    (0..=u16::MAX).collect()
}

/// What masked stores leave, by the definition.
fn stored<T: Copy>(old: &[T], new: impl Fn(usize) -> T) -> Vec<T> {
    (0..old.len())
        .map(|at| if (at / 16) >> (at % 16) & 1 == 1 { new(at) } else { old[at] })
        .collect()
}

#[test]
fn store16_with_every_mask() {
    let mut random = Random(12);
    let masks = all_masks();
    let values = random.ints(masks.len() * MAX_LANES);
    let old: Vec<u16> = random.ints(values.len()).into_iter().map(|v| v as u16).collect();
    let found = compare("store16", Store16 { masks: &masks, values: &values, old: &old });
    assert!(found == stored(&old, |at| values[at] as u16));
}

/// Stores of all lanes from the last to the first, as above.
struct Store16All<'a>(&'a [i32]);

impl Kernel for Store16All<'_> {
    type Output = Vec<u16>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<u16> {
        let mut out = vec![0; self.0.len()];
        for at in (0..self.0.len()).step_by(S::LANES).rev() {
            simd.store16_all(simd.load(&self.0[at..]), &mut out[at..]);
        }
        out
    }
}

#[test]
fn store16_all_keeps_low_halves() {
    let values = Random(14).ints(64 * MAX_LANES);
    let expected: Vec<u16> = values.iter().map(|&v| v as u16).collect();
    for level in Level::available() {
        assert_eq!(level.dispatch(Store16All(&values)), expected, "{level}");
    }
}

#[test]
fn store_masked_with_every_mask() {
    let mut random = Random(13);
    let masks = all_masks();
    let values = random.ints(masks.len() * MAX_LANES);
    let old = random.ints(values.len());
    let found = compare("store_masked", StoreMasked { masks: &masks, values: &values, old: &old });
    assert!(found == stored(&old, |at| values[at]));
}

/// Masks from bits: as bits again, and in `select`.
#[derive(Clone, Copy)]
struct Masks;

impl Kernel for Masks {
    type Output = Vec<i32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<i32> {
        let mut out = Vec::new();
        for bits in 0..=0xffff_u32 {
            for part in (0..MAX_LANES).step_by(S::LANES) {
                // The higher bits must not matter.
                let mask = simd.mask(bits >> part | u32::MAX << S::LANES);
                push_mask(simd, mask, &mut out);
                assert_eq!(mask.bits(), simd.mask(bits >> part).bits());
            }
            for part in (0..MAX_LANES).step_by(S::LANES) {
                let mask = simd.mask(bits >> part);
                push(simd, simd.splat(-1).select(simd.splat(7), mask), &mut out);
            }
        }
        out
    }
}

#[test]
fn masks_of_every_pattern() {
    let found = compare("mask", Masks);
    let by_hand = (0..=0xffff_u32).flat_map(|bits| {
        let bit = move |lane: u32| bits >> lane & 1 == 1;
        let as_bits = (0..16).map(move |lane| i32::from(bit(lane)));
        as_bits.chain((0..16).map(move |lane| if bit(lane) { -1 } else { 7 }))
    });
    assert!(found.into_iter().eq(by_hand));
}

/// Conjunction and disjunction of masks.
#[derive(Clone, Copy)]
struct MaskPairs<'a>(&'a [(u16, u16)]);

impl Kernel for MaskPairs<'_> {
    type Output = Vec<i32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<i32> {
        let (mut and, mut or) = (Vec::new(), Vec::new());
        for &(a, b) in self.0 {
            for part in (0..MAX_LANES).step_by(S::LANES) {
                let (a, b) = (simd.mask(u32::from(a) >> part), simd.mask(u32::from(b) >> part));
                push_mask(simd, a & b, &mut and);
                push_mask(simd, a | b, &mut or);
            }
        }
        [and, or].concat()
    }
}

#[test]
fn masks_combined() {
    // All pairs of eight bits, both bytes alike, then random ones.
    let mut random = Random(14);
    let bytes = (0..=0xffff_u16).map(|ab| ((ab & 0xff) * 0x101, (ab >> 8) * 0x101));
    let mut pairs: Vec<(u16, u16)> = bytes.collect();
    pairs.extend((0..0x1_0000).map(|_| (random.int() as u16, random.int() as u16)));
    compare("masks", MaskPairs(&pairs));
}

#[derive(Clone, Copy)]
struct Lookup<'a>(&'a [[i32; 16]], &'a [i32]);

impl Kernel for Lookup<'_> {
    type Output = Vec<i32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<i32> {
        let mut out = Vec::new();
        for table in self.0 {
            for at in (0..self.1.len()).step_by(S::LANES) {
                push(simd, simd.lookup16(table, simd.load(&self.1[at..])), &mut out);
            }
        }
        out
    }
}

#[test]
fn lookup16_of_every_entry_and_any_upper_bits() {
    let mut random = Random(15);
    let tables: Vec<[i32; 16]> = (0..64).map(|_| std::array::from_fn(|_| random.int())).collect();
    let mut at: Vec<i32> = (0..256).map(|i| i % 16 * 0x11).collect();
    at.extend(EDGES);
    at.extend(random.ints(RANDOM_LANES / tables.len()));
    let at = padded(at);
    let found = compare("lookup16", Lookup(&tables, &at));
    let by_hand = tables.iter().flat_map(|t| at.iter().map(|&i| t[(i & 15) as usize]));
    assert!(found.into_iter().eq(by_hand));
}

/// [`Lookup`] in a longer table.
#[derive(Clone, Copy)]
struct LongLookup<'a>(&'a [[i32; 64]], &'a [i32]);

impl Kernel for LongLookup<'_> {
    type Output = Vec<i32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<i32> {
        let mut out = Vec::new();
        for table in self.0 {
            for at in (0..self.1.len()).step_by(S::LANES) {
                push(simd, simd.lookup64(table, simd.load(&self.1[at..])), &mut out);
            }
        }
        out
    }
}

#[test]
fn lookup64_of_every_entry_and_any_upper_bits() {
    let mut random = Random(16);
    let tables: Vec<[i32; 64]> = (0..16).map(|_| std::array::from_fn(|_| random.int())).collect();
    let mut at: Vec<i32> = (0..256).map(|i| i % 64 * 0x41).collect();
    at.extend(EDGES);
    at.extend(random.ints(RANDOM_LANES / tables.len()));
    let at = padded(at);
    let found = compare("lookup64", LongLookup(&tables, &at));
    let by_hand = tables.iter().flat_map(|t| at.iter().map(|&i| t[(i & 63) as usize]));
    assert!(found.into_iter().eq(by_hand));
}

#[derive(Clone, Copy)]
struct Pairs<'a>(&'a [u64], &'a [i32]);

impl Kernel for Pairs<'_> {
    type Output = Vec<i32>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<i32> {
        let (mut low, mut high) = (Vec::new(), Vec::new());
        for at in (0..self.1.len()).step_by(S::LANES) {
            let (l, h) = simd.load_pairs(self.0, simd.load(&self.1[at..]));
            push(simd, l, &mut low);
            push(simd, h, &mut high);
            // Once more by indices in memory.
            let (l, h) = simd.load_pairs_at(self.0, &self.1[at..]);
            let (mut again_low, mut again_high) = (Vec::new(), Vec::new());
            push(simd, l, &mut again_low);
            push(simd, h, &mut again_high);
            assert!(low.ends_with(&again_low) && high.ends_with(&again_high));
        }
        [low, high].concat()
    }
}

#[test]
fn load_pairs_in_and_out_of_range() {
    let mut random = Random(16);
    for len in [1, 2, 3, 5, 16, 255, 4096, 65536] {
        // A boxed slice ends where the table ends: reads beyond it are the
        // allocator's to notice.
        let table: Box<[u64]> = (0..len).map(|_| random.word()).collect();
        let mut at = vec![0, 1, len - 1, len, len + 1, 2 * len, -1, -len, i32::MAX, i32::MIN];
        at.extend(EDGES);
        at.extend((0..RANDOM_LANES / 16).map(|_| random.int().rem_euclid(len)));
        at.extend(random.ints(RANDOM_LANES / 16));
        let at = padded(at);
        let found = compare("load_pairs", Pairs(&table, &at));
        let entry = |&i: &i32| table[(i as u32 as usize).min(table.len() - 1)];
        let low = at.iter().map(|i| entry(i) as i32);
        let high = at.iter().map(|i| (entry(i) >> 32) as i32);
        assert!(found.into_iter().eq(low.chain(high)));
    }
}

/// Defines a test for each level: an empty table is refused before any read.
/// A level that the machine lacks runs as the scalar one.
macro_rules! empty_table {
    ($($test:ident $level:ident)*) => {$(
        #[test]
        #[should_panic = "at least one entry"]
        fn $test() {
            Level::$level.dispatch(Pairs(&[], &[0; MAX_LANES]));
        }
    )*};
}
empty_table! {
    load_pairs_empty_scalar Scalar
    load_pairs_empty_sse41 Sse41
    load_pairs_empty_avx2 Avx2
    load_pairs_empty_avx512 Avx512
    load_pairs_empty_neon Neon
    load_pairs_empty_simd128 Simd128
}

macro_rules! short_slice {
    ($($test:ident |$simd:ident, $short:ident| $body:expr;)*) => {$(
        #[test]
        fn $test() {
            struct Run;
            impl Kernel for Run {
                type Output = ();
                #[inline(always)]
                fn run<S: Simd>(self, $simd: S) {
                    let $short = S::LANES - 1;
                    $body;
                }
            }
            // A target that cannot unwind cannot look at a panic either.
            if cfg!(panic = "unwind") {
                for level in Level::available() {
                    let result = std::panic::catch_unwind(|| level.dispatch(Run));
                    assert!(result.is_err(), "{level} accepted a slice that is too short");
                }
            }
        }
    )*};
}
short_slice! {
    short_load |simd, n| simd.load(&vec![0; n]);
    short_load16 |simd, n| simd.load16(&vec![0; n]);
    short_load_f |simd, n| simd.load_f(&vec![0.0; n]);
    short_store |simd, n| simd.store(simd.splat(0), &mut vec![0; n]);
    short_store16 |simd, n| simd.store16(simd.splat(0), &mut vec![0; n], simd.mask(0));
    short_store16_all |simd, n| simd.store16_all(simd.splat(0), &mut vec![0; n]);
    short_store_masked |simd, n| simd.store_masked(simd.splat(0), &mut vec![0; n], simd.mask(0));
    short_store_f |simd, n| simd.store_f(simd.splat_f(0.0), &mut vec![0.0; n]);
}

/// Columns of integers, and the same as floats, side by side.
#[derive(Clone, Copy)]
struct Transposed<'a>([&'a [i32]; 4]);

impl Kernel for Transposed<'_> {
    type Output = Vec<([i32; 4], [f64; 4])>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Vec<([i32; 4], [f64; 4])> {
        let [a, b, c, d] = self.0;
        let (mut out, mut floats) = (vec![[0; 4]; a.len()], vec![[0.0; 4]; a.len()]);
        for at in (0..a.len()).step_by(S::LANES) {
            let (a, b) = (simd.load(&a[at..]), simd.load(&b[at..]));
            let (c, d) = (simd.load(&c[at..]), simd.load(&d[at..]));
            simd.transpose([a, b, c, d], &mut out[at..]);
            let (a, b) = (S::F::from_i32(a), S::F::from_i32(b));
            let (c, d) = (S::F::from_i32(c), S::F::from_i32(d));
            simd.transpose_f([a, b, c, d], &mut floats[at..]);
        }
        out.into_iter().zip(floats).collect()
    }
}

#[test]
fn transposed_columns() {
    let columns: [Vec<i32>; 4] = std::array::from_fn(|i| Random(16 + i as u64).ints(1 << 12));
    let found = compare("transpose", Transposed(columns.each_ref().map(Vec::as_slice)));
    for (at, (ints, floats)) in found.into_iter().enumerate() {
        let row = columns.each_ref().map(|column| column[at]);
        assert_eq!((ints, floats), (row, row.map(f64::from)));
    }
}
