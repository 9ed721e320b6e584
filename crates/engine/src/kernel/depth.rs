//! Depth: z and w of the fragments, the test, and the write.
//!
//! Source: SST1, fbzMode; the test runs before texturing, which changes no
//! result because depth is written only where everything else passes.
//!
//! Where nothing but depth decides about a fragment, iterated z is tested while
//! stamps are covered, before they are gathered into blocks: see [`early`].

use fillrate_simd::{FloatLanes, IntLanes, MaskLanes, Simd};

use super::block::{Block, Lanes, STAMP, Slot, Strip, VECTORS};
use super::lanes::{Stamp, iterate, places, ramp_wide, wrap};
use super::{Pass, Pipeline, Tile};
use crate::setup::{Narrow, Plane64, PlaneF, Z, offset};
use crate::state::{AuxWrite, Compare, DepthSource, ZOverflow};

/// The pseudo-float of a 48-bit w with 32 fraction bits: 4 exponent bits and
/// 12 inverted mantissa bits, plus one; 0 for w of one and above or negative,
/// 0xffff for the smallest.
pub(crate) fn float_w(w: i64) -> u16 {
    if (w >> 32) & 0xffff != 0 {
        return 0;
    }
    let low = w as u32;
    if low & 0xffff_0000 == 0 {
        return 0xffff;
    }
    let exponent = low.leading_zeros();
    let mantissa = !low >> (19 - exponent) & 0xfff;
    (((exponent << 12) | mantissa) + 1).min(0xffff) as u16
}

/// [`float_w`] of integers below 2^47 held as floats. Their bit patterns
/// already hold exponent and mantissa.
#[inline(always)]
fn float_w_lanes<S: Simd>(s: S, w: S::F) -> S::I {
    let high = w.high_word();
    let leading_zeros = s.splat(31 + 1023) - high.shr(20);
    let mantissa = high.shr(8) & s.splat(0xfff);
    let packed = leading_zeros.shl(12) | (mantissa ^ s.splat(0xfff));
    let value = (packed + s.splat(1)).min(s.splat(0xffff));
    // Below 2^16: nothing left in the upper half.
    let tiny = s.splat((16 + 1023) << 20).gt(high);
    let value = s.splat(0xffff).select(value, tiny);
    // At least 2^32, or negative.
    let near = high.gt(s.splat(((32 + 1023) << 20) - 1));
    let negative = s.splat(0).gt(high);
    s.splat(0).select(value, near | negative)
}

/// Depth values of one stamp after another, without bias.
pub(super) trait DepthLanes<S: Simd> {
    /// Goes to a stamp, which is the block's slot `slot`.
    fn enter(&mut self, s: S, pass: &Pass<'_>, at: &Slot, slot: usize);
    /// The values of fragments `j..` of that stamp.
    fn lanes(&self, s: S, pass: &Pass<'_>, at: &Slot, j: usize) -> S::I;
}

/// Iterated z, 16 bits.
pub(super) struct IteratedZ {
    overflow: ZOverflow,
}

impl IteratedZ {
    pub fn new(pass: &Pass<'_>) -> IteratedZ {
        IteratedZ { overflow: pass.pipeline.state.depth.z_overflow }
    }
}

/// Iterated z as integers of 16 bits. Those that a state rejects are limited, for
/// what reads z before they are dropped.
#[inline(always)]
fn whole_z<S: Simd>(s: S, z: S::I, overflow: ZOverflow) -> S::I {
    match overflow {
        ZOverflow::Wrap => wrap::<S, 20, 16>(s, z.shr(12)),
        ZOverflow::Clamp | ZOverflow::Reject => z.sar(12).max(s.splat(0)).min(s.splat(0xffff)),
    }
}

impl<S: Simd> DepthLanes<S> for IteratedZ {
    #[inline(always)]
    fn enter(&mut self, _s: S, _pass: &Pass<'_>, _at: &Slot, _slot: usize) {}

    #[inline(always)]
    fn lanes(&self, s: S, pass: &Pass<'_>, at: &Slot, j: usize) -> S::I {
        let z = iterate(s, &pass.triangle(at).narrow, Z, places(s, at.x, at.y, j));
        whole_z(s, z, self.overflow)
    }
}

/// The pseudo-float of iterated w.
#[derive(Clone, Debug)]
pub(crate) struct IteratedW {
    pub(super) triangle: u32,
    /// Whether floats hold it; see [`crate::setup::Triangle::exact`].
    exact: bool,
    origin: (i32, i32),
    plane: PlaneF,
    ramp: Stamp<f64>,
    /// w of the stamp's first fragment.
    corner: f64,
    /// The values of a stamp whose w floats do not hold.
    values: Stamp<i32>,
}

impl IteratedW {
    pub const NONE: IteratedW = IteratedW {
        triangle: u32::MAX,
        exact: false,
        origin: (0, 0),
        plane: PlaneF { start: 0.0, dx: 0.0, dy: 0.0 },
        ramp: Stamp([0.0; STAMP]),
        corner: 0.0,
        values: Stamp([0; STAMP]),
    };

    /// Goes to the triangle of a stamp.
    #[inline(always)]
    fn change<S: Simd>(&mut self, s: S, pass: &Pass<'_>, at: &Slot) {
        let triangle = pass.triangle(at);
        self.triangle = at.triangle;
        self.exact = triangle.exact;
        if triangle.exact {
            self.origin = triangle.origin();
            self.plane = pass.triangles.exact_w(triangle);
            ramp_wide(s, &self.plane, &mut self.ramp.0);
        }
    }
}

impl<S: Simd> DepthLanes<S> for IteratedW {
    #[inline(always)]
    fn enter(&mut self, s: S, pass: &Pass<'_>, at: &Slot, _slot: usize) {
        if at.triangle != self.triangle {
            self.change(s, pass, at);
        }
        if self.exact {
            self.corner = self.plane.at(offset(self.origin, at.x, at.y));
        } else {
            let plane = pass.triangles.w(pass.triangle(at));
            exact_w_of_stamp(&plane, at.x, at.y, &mut self.values.0);
        }
    }

    #[inline(always)]
    fn lanes(&self, s: S, _pass: &Pass<'_>, _at: &Slot, j: usize) -> S::I {
        if self.exact {
            float_w_lanes(s, s.splat_f(self.corner) + s.load_f(&self.ramp.0[j..]))
        } else {
            s.load(&self.values.0[j..])
        }
    }
}

/// The pseudo-float w of a stamp whose iterators are too large for floats.
fn exact_w_of_stamp(w: &Plane64, x: i32, y: i32, out: &mut [i32; STAMP]) {
    for (i, out) in out.iter_mut().enumerate() {
        *out = i32::from(float_w(w.at(x + (i & 3) as i32, y + (i >> 2) as i32)));
    }
}

/// Depth values that lie in the block already.
pub(super) struct Kept<'a> {
    pub values: &'a Lanes,
    pub first: usize,
}

impl<S: Simd> DepthLanes<S> for Kept<'_> {
    #[inline(always)]
    fn enter(&mut self, _s: S, _pass: &Pass<'_>, _at: &Slot, slot: usize) {
        self.first = slot * STAMP;
    }

    #[inline(always)]
    fn lanes(&self, s: S, _pass: &Pass<'_>, _at: &Slot, j: usize) -> S::I {
        s.load(&self.values.0[self.first + j..])
    }
}

/// Keeps the depth values of the whole block.
#[inline(always)]
pub(super) fn keep<S: Simd, D: DepthLanes<S>>(
    s: S,
    source: &mut D,
    slots: &[Slot],
    pass: &Pass<'_>,
    out: &mut Lanes,
) {
    for (slot, at) in slots.iter().enumerate() {
        source.enter(s, pass, at, slot);
        for j in (0..STAMP).step_by(S::LANES) {
            s.store(source.lanes(s, pass, at, j), &mut out.0[slot * STAMP + j..]);
        }
    }
}

/// Computes z and w where they are needed after the test.
#[inline(always)]
pub(crate) fn keep_depth<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let needs = &pass.pipeline.needs;
    let Block { slots, count, steps, z, w, .. } = block;
    if needs.keeps_z {
        keep(s, &mut IteratedZ::new(pass), &slots[..*count], pass, z);
    }
    if needs.keeps_w {
        keep(s, &mut steps.w, &slots[..*count], pass, w);
    }
}

/// Computes z and w where they are needed, tests and writes depth.
#[inline(always)]
pub(crate) fn depth<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>, tile: &mut Tile<'_>) {
    reject_overflow(s, block, pass, tile);
    keep_depth(s, block, pass);
    let needs = &pass.pipeline.needs;
    match pass.pipeline.state.depth.source {
        DepthSource::Z if needs.keeps_z => ready_depth(s, block, pass, tile),
        DepthSource::FloatW if needs.keeps_w => ready_depth(s, block, pass, tile),
        source => {
            let Block { live, count, slots, depth, steps, .. } = block;
            let fragments = Fragments { live, slots: &slots[..*count], depth };
            match source {
                DepthSource::Z => {
                    test_depth(s, fragments, &mut IteratedZ::new(pass), pass, tile);
                }
                DepthSource::FloatW => test_depth(s, fragments, &mut steps.w, pass, tile),
                // Those are another stage's.
                DepthSource::DeepZ | DepthSource::DeepW => {}
            }
        }
    }
}

/// Drops the fragments whose iterated z is no 16-bit number, where the state says
/// so.
#[inline(always)]
pub(super) fn reject_overflow<S: Simd>(
    s: S,
    block: &mut Block,
    pass: &Pass<'_>,
    tile: &mut Tile<'_>,
) {
    if !pass.pipeline.state.depth.rejects() {
        return;
    }
    let mut inside = 0u64;
    for slot in 0..block.count {
        let at = &block.slots[slot];
        for j in (0..STAMP).step_by(S::LANES) {
            let z = iterate(s, &pass.triangle(at).narrow, Z, places(s, at.x, at.y, j));
            inside |= u64::from(z.shr(28).eq(s.splat(0)).bits()) << (slot * STAMP + j);
        }
    }
    tile.counters.depth_fail += block.keep(inside);
}

/// Tests and writes depth values that lie in the block.
#[inline(always)]
pub(crate) fn ready_depth<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>, tile: &mut Tile<'_>) {
    let Block { live, count, slots, z, w, depth, .. } = block;
    let fragments = Fragments { live, slots: &slots[..*count], depth };
    let values = match pass.pipeline.state.depth.source {
        DepthSource::Z => z,
        DepthSource::FloatW | DepthSource::DeepZ | DepthSource::DeepW => w,
    };
    test_depth(s, fragments, &mut Kept { values, first: 0 }, pass, tile);
}

/// Lanes where `source OP reference`.
#[inline(always)]
pub(crate) fn compare<S: Simd>(s: S, op: Compare, source: S::I, reference: S::I) -> S::M {
    let one = s.splat(1);
    match op {
        Compare::Never => s.mask(0),
        Compare::Less => reference.gt(source),
        Compare::Equal => source.eq(reference),
        Compare::LessEqual => (reference + one).gt(source),
        Compare::Greater => source.gt(reference),
        Compare::NotEqual => source.gt(reference) | reference.gt(source),
        Compare::GreaterEqual => (source + one).gt(reference),
        Compare::Always => s.mask(u32::MAX),
    }
}

/// Depth tests before fragments are gathered, as constants of the loops over
/// stamps. The common ones have neither bias nor constant.
pub(crate) mod early {
    /// None: the test is a stage, or there is none.
    pub const NONE: u8 = 0;
    /// [`super::Compare::Less`]
    pub const LESS: u8 = 1;
    /// [`super::Compare::LessEqual`]
    pub const LESS_EQUAL: u8 = 2;
    /// Whatever the state says.
    pub const ANY: u8 = 3;
}

/// Which of [`early`] a pipeline can have, if its first stage is the depth test.
pub(super) fn early_test(pipeline: &Pipeline) -> u8 {
    let depth = &pipeline.state.depth;
    let needs = &pipeline.needs;
    // Alpha in the aux plane is written by the last stage.
    let late = needs.late_depth_write || pipeline.state.aux_write == AuxWrite::Alpha;
    if !needs.depth || late || depth.source != DepthSource::Z {
        return early::NONE;
    }
    match (depth.test, depth.bias, depth.compare_constant) {
        (Some(Compare::Less), None, None) => early::LESS,
        (Some(Compare::LessEqual), None, None) => early::LESS_EQUAL,
        _ => early::ANY,
    }
}

/// What happens to a depth value, the same for a whole block.
#[derive(Clone, Copy)]
pub(crate) struct DepthTest {
    pub test: Option<Compare>,
    bias: Option<i32>,
    overflow: ZOverflow,
    pub constant: Option<i32>,
    /// Written as soon as it passes.
    pub writes: bool,
}

impl DepthTest {
    /// Everything passes, nothing is written.
    pub const NONE: DepthTest = DepthTest {
        test: None,
        bias: None,
        overflow: ZOverflow::Wrap,
        constant: None,
        writes: false,
    };

    #[inline(always)]
    pub fn new(pipeline: &Pipeline) -> DepthTest {
        let depth = &pipeline.state.depth;
        DepthTest {
            test: depth.test,
            bias: depth.bias.map(i32::from),
            overflow: depth.z_overflow,
            constant: depth.compare_constant.map(i32::from),
            writes: pipeline.writes_depth() && !pipeline.needs.late_depth_write,
        }
    }

    /// The value that is compared and written.
    #[inline(always)]
    pub fn biased<S: Simd>(&self, s: S, value: S::I) -> S::I {
        match self.bias {
            Some(bias) => (value + s.splat(bias)).max(s.splat(0)).min(s.splat(0xffff)),
            None => value,
        }
    }

    /// Tests and writes biased values at the start of `aux`; which of the
    /// `live` lanes pass. `EARLY` is one of [`early`].
    #[inline(always)]
    pub fn run<S: Simd, const EARLY: u8>(
        &self,
        s: S,
        value: S::I,
        live: S::M,
        aux: &mut [u16],
    ) -> S::M {
        let mut passed = live;
        if EARLY == early::LESS {
            passed = live & compare(s, Compare::Less, value, s.load16(aux));
        } else if EARLY == early::LESS_EQUAL {
            passed = live & compare(s, Compare::LessEqual, value, s.load16(aux));
        } else if let Some(op) = self.test {
            let source = match self.constant {
                Some(constant) => s.splat(constant),
                None => value,
            };
            passed = live & compare(s, op, source, s.load16(aux));
        }
        if self.writes {
            s.store16(value, aux, passed);
        }
        passed
    }

    /// The same for iterated z, before the rule for overflows and the bias.
    #[inline(always)]
    pub fn run_iterated<S: Simd, const EARLY: u8>(
        &self,
        s: S,
        z: S::I,
        mut live: S::M,
        aux: &mut [u16],
    ) -> S::M {
        let mut value = z.shr(12);
        // Most triangles are in range.
        let outside = value.gt(s.splat(0xffff)) & live;
        if outside.bits() != 0 {
            value = whole_z(s, z, self.overflow);
            if self.overflow == ZOverflow::Reject {
                live = s.splat(0x1_0000).gt(z.shr(12)) & live;
            }
        }
        if EARLY == early::ANY {
            value = self.biased(s, value);
        }
        self.run::<S, EARLY>(s, value, live, aux)
    }
}

/// Drops a strip's fragments that fail the depth test, and writes the depth of
/// the others.
#[inline(always)]
pub(crate) fn test_strip<S: Simd, const EARLY: u8>(
    s: S,
    test: &DepthTest,
    narrow: &Narrow,
    strip: &mut Strip,
    aux: &mut [u16],
) {
    let aux = strip.elements(aux);
    let common = EARLY == early::LESS || EARLY == early::LESS_EQUAL;
    if common && test.writes && strip.is_whole() && is_in_range(narrow, strip) {
        return test_whole::<S, EARLY>(s, narrow, strip, aux);
    }
    let step = s.splat(narrow.dx[Z].wrapping_mul(4));
    let mut z = first_depths(s, narrow, strip);
    for (live, stamp) in strip.live.iter_mut().zip(aux) {
        let (before, mut left) = (u32::from(*live), 0);
        for (v, z) in z[..STAMP / S::LANES].iter_mut().enumerate() {
            let (j, lanes) = (v * S::LANES, s.mask(before >> (v * S::LANES)));
            let passed = test.run_iterated::<S, EARLY>(s, *z, lanes, &mut stamp[j..]);
            left |= passed.bits() << j;
            *z = *z + step;
        }
        *live = left as u16;
    }
}

/// The same of stamps that are covered whole, with z in its range: what passes
/// is the lesser of two numbers.
#[inline(always)]
fn test_whole<S: Simd, const EARLY: u8>(
    s: S,
    narrow: &Narrow,
    strip: &mut Strip,
    aux: &mut [[u16; STAMP]],
) {
    let op = if EARLY == early::LESS { Compare::Less } else { Compare::LessEqual };
    let step = s.splat(narrow.dx[Z].wrapping_mul(4));
    let mut z = first_depths(s, narrow, strip);
    for (live, stamp) in strip.live.iter_mut().zip(aux) {
        let mut left = 0;
        for (v, z) in z[..STAMP / S::LANES].iter_mut().enumerate() {
            let (j, value) = (v * S::LANES, z.shr(12));
            let old = s.load16(&stamp[j..]);
            left |= compare(s, op, value, old).bits() << j;
            s.store16_all(value.min(old), &mut stamp[j..]);
            *z = *z + step;
        }
        *live = left as u16;
    }
}

/// Iterated z of a strip's first stamp.
#[inline(always)]
fn first_depths<S: Simd>(s: S, narrow: &Narrow, strip: &Strip) -> [S::I; VECTORS] {
    let mut z = [s.splat(0); VECTORS];
    for (v, z) in z[..STAMP / S::LANES].iter_mut().enumerate() {
        *z = iterate(s, narrow, Z, places(s, strip.first.x, strip.first.y, v * S::LANES));
    }
    z
}

/// Whether iterated z is a 16-bit number all over a strip.
#[inline(always)]
fn is_in_range(narrow: &Narrow, strip: &Strip) -> bool {
    let right = 4 * strip.count as i64 - 1;
    let (low, high) = narrow.range(Z, [strip.first.x, strip.first.y], [right, 3]);
    low >= 0 && high < 1 << 28
}

/// The parts of a block that the depth test works on.
struct Fragments<'a> {
    live: &'a mut u64,
    slots: &'a [Slot],
    depth: &'a mut Lanes,
}

/// Drops the fragments that fail the depth test, and writes the depth of the
/// others, at once or into `block.depth` where something later can drop them.
#[inline(always)]
fn test_depth<S: Simd, D: DepthLanes<S>>(
    s: S,
    fragments: Fragments<'_>,
    source: &mut D,
    pass: &Pass<'_>,
    tile: &mut Tile<'_>,
) {
    let needs = &pass.pipeline.needs;
    if !needs.depth {
        return;
    }
    let test = DepthTest::new(pass.pipeline);
    let before = *fragments.live;
    let mut left = 0;
    for (slot, at) in fragments.slots.iter().enumerate() {
        source.enter(s, pass, at, slot);
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let value = test.biased(s, source.lanes(s, pass, at, j));
            if needs.late_depth_write {
                s.store(value, &mut fragments.depth.0[k..]);
            }
            let live = s.mask((before >> k) as u32);
            let place = at.at as usize + j;
            let passed = test.run::<S, { early::ANY }>(s, value, live, &mut tile.aux[place..]);
            left |= u64::from(passed.bits()) << k;
        }
    }
    *fragments.live = left;
    tile.counters.depth_fail += u64::from((before & !left).count_ones());
}

/// Writes the depth of the fragments left.
#[inline(always)]
pub(crate) fn depth_write<S: Simd>(s: S, block: &mut Block, tile: &mut Tile<'_>) {
    for slot in 0..block.count {
        let at = block.slots[slot].at as usize;
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let live = s.mask((block.live >> k) as u32);
            tile.store_aux(s, s.load(&block.depth.0[k..]), at + j, live);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fillrate_simd::{Kernel, Level};

    struct FloatW(Vec<i64>);

    impl Kernel for FloatW {
        type Output = Vec<i32>;
        #[inline(always)]
        fn run<S: Simd>(self, s: S) -> Vec<i32> {
            let mut out = vec![0; self.0.len()];
            for (w, out) in self.0.chunks_exact(16).zip(out.chunks_exact_mut(16)) {
                for j in (0..16).step_by(S::LANES) {
                    let w: Vec<f64> = w[j..].iter().map(|&w| w as f64).collect();
                    let mut padded = [0.0; 16];
                    padded[..w.len()].copy_from_slice(&w);
                    s.store(float_w_lanes(s, s.load_f(&padded)), &mut out[j..]);
                }
            }
            out
        }
    }

    #[test]
    fn float_w_of_known_values() {
        assert_eq!(float_w(1 << 32), 0);
        assert_eq!(float_w(-1), 0);
        assert_eq!(float_w(0xffff_ffff), 1);
        assert_eq!(float_w(0x8000_0000), 0x1000);
        assert_eq!(float_w(0), 0xffff);
        assert_eq!(float_w(0xffff), 0xffff);
        assert_eq!(float_w(0x1_0000), 0xffff);
        assert_eq!(float_w(0x1_8000), 0xf800);
    }

    #[test]
    fn float_w_lanes_equal_the_scalar() {
        let mut values = vec![0, 1, 0xffff, 0x1_0000, 0x1_0001, 0xffff_ffff, 1 << 32, -1, -70000];
        let mut seed = 1u64;
        while values.len() < 160_000 {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            values.push((seed >> 17) as i64 >> (seed % 47));
            values.push(-((seed >> 20) as i64 >> (seed % 31)));
        }
        values.truncate(160_000);
        let expected: Vec<i32> = values.iter().map(|&w| i32::from(float_w(w))).collect();
        for level in Level::available() {
            assert_eq!(level.dispatch(FloatW(values.clone())), expected, "{level}");
        }
    }
}
