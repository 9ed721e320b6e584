//! Small steps that several stages share, and the constants of a stamp.

use fillrate_simd::{IntLanes, Simd};

use super::block::STAMP;
use crate::setup::{Narrow, PlaneF};
use crate::state::{DITHER_2X2, DITHER_4X4, Dither};

/// A value for each fragment of a stamp, where no vector of them crosses a cache
/// line.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Stamp<T>(pub [T; STAMP]);

/// Column of each fragment in its stamp.
pub(crate) static COLUMN: Stamp<i32> = Stamp([0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3]);
/// Row of each fragment in its stamp.
pub(crate) static ROW: Stamp<i32> = Stamp([0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3]);
/// [`COLUMN`] as floats.
pub(crate) static COLUMN_F: Stamp<f64> =
    Stamp([0., 1., 2., 3., 0., 1., 2., 3., 0., 1., 2., 3., 0., 1., 2., 3.]);
/// [`ROW`] as floats.
pub(crate) static ROW_F: Stamp<f64> =
    Stamp([0., 0., 0., 0., 1., 1., 1., 1., 2., 2., 2., 2., 3., 3., 3., 3.]);

/// Screen columns and rows of fragments `j..` of the stamp at (x, y).
#[inline(always)]
pub(crate) fn places<S: Simd>(s: S, x: i32, y: i32, j: usize) -> [S::I; 2] {
    [s.splat(x) + s.load(&COLUMN.0[j..]), s.splat(y) + s.load(&ROW.0[j..])]
}

/// A 32-bit attribute at screen columns and rows.
#[inline(always)]
pub(crate) fn iterate<S: Simd>(s: S, narrow: &Narrow, lane: usize, [x, y]: [S::I; 2]) -> S::I {
    s.splat(narrow.c[lane]) + (x.mul(s.splat(narrow.dx[lane])) + y.mul(s.splat(narrow.dy[lane])))
}

/// How an edge's value differs from that at a stamp's first fragment at each
/// of its fragments.
#[inline(always)]
pub(crate) fn ramp<S: Simd>(s: S, dx: i32, dy: i32, out: &mut [i32; STAMP]) {
    for j in (0..STAMP).step_by(S::LANES) {
        let ramp = s.load(&COLUMN.0[j..]).mul(s.splat(dx)) + s.load(&ROW.0[j..]).mul(s.splat(dy));
        s.store(ramp, &mut out[j..]);
    }
}

/// The same for a 64-bit attribute, in floats.
#[inline(always)]
pub(crate) fn ramp_wide<S: Simd>(s: S, plane: &PlaneF, out: &mut [f64; STAMP]) {
    let (dx, dy) = (s.splat_f(plane.dx), s.splat_f(plane.dy));
    for j in (0..STAMP).step_by(S::LANES) {
        let ramp = s.load_f(&COLUMN_F.0[j..]) * dx + s.load_f(&ROW_F.0[j..]) * dy;
        s.store_f(ramp, &mut out[j..]);
    }
}

/// The chip's wrap rule for an iterated integer part `t`: of its `WIDE` bits,
/// all ones count as 0, 2^`BITS` as 2^`BITS` - 1, else the low bits count.
///
/// Source: SST1, iterated parameters without clamping.
#[inline(always)]
pub(crate) fn wrap<S: Simd, const WIDE: u32, const BITS: u32>(s: S, t: S::I) -> S::I {
    let one = s.splat(1);
    let t = ((t + one) & s.splat((1 << WIDE) - 1)).max(one) - one;
    let over = t.eq(s.splat(1 << BITS));
    (t - one).select(t, over) & s.splat((1 << BITS) - 1)
}

/// The wrap rule of 12-bit colours on pairs of 16-bit channels.
#[inline(always)]
pub(crate) fn wrap_colors<S: Simd>(s: S, t: S::I) -> S::I {
    let one = s.splat(0x0001_0001);
    let t = t.add16(one) & s.splat(0x0fff_0fff);
    let t = t.max16(one).sub16(one);
    t.add16(t.eq16(s.splat(0x0100_0100))) & s.splat(0x00ff_00ff)
}

/// The high channel of each pair in both halves: alpha for every channel.
#[inline(always)]
pub(crate) fn spread_alpha<S: Simd>(s: S, ga: S::I) -> S::I {
    ga.shr(16) | (ga & s.splat(0xffff_0000u32 as i32))
}

/// Low halves of one, high halves of the other.
#[inline(always)]
pub(crate) fn join<S: Simd>(s: S, low: S::I, high: S::I) -> S::I {
    (low & s.splat(0xffff)) | (high & s.splat(0xffff_0000u32 as i32))
}

/// `(x * (f + 1)) >> 8` for signed x of at most 9 bits and f of 0..=255.
#[inline(always)]
pub(crate) fn scale<S: Simd>(s: S, x: S::I, f: S::I) -> S::I {
    x.shl16(7).mul_high_i16(f.add16(s.splat(0x0001_0001)).shl16(1))
}

/// Limits signed channels to 0..=255.
#[inline(always)]
pub(crate) fn clamp<S: Simd>(s: S, x: S::I) -> S::I {
    x.max16(s.splat(0)).min16(s.splat(0x00ff_00ff))
}

/// Channels' products of two values of 0..=255, or sums of such products that
/// stay within 255 * 255, divided by 255 to the nearest.
#[inline(always)]
pub(crate) fn div_255<S: Simd>(s: S, product: S::I) -> S::I {
    let v = product.add16(s.splat(0x0080_0080));
    v.add16(v.shr16(8)).shr16(8)
}

/// `(a * part + b * (255 - part)) / 255`, to the nearest.
#[inline(always)]
pub(crate) fn lerp_255<S: Simd>(s: S, a: S::I, b: S::I, part: S::I) -> S::I {
    let rest = s.splat(0x00ff_00ff).sub16(part);
    div_255(s, a.mul16(part).add16(b.mul16(rest)))
}

/// `(a * (256 - part) + b * part) / 256`, to the nearest, for parts of 0..=255.
#[inline(always)]
pub(crate) fn mix_256<S: Simd>(s: S, a: S::I, b: S::I, part: S::I) -> S::I {
    let rest = s.splat(0x0100_0100).sub16(part);
    a.mul16(rest).add16(b.mul16(part)).add16(s.splat(0x0080_0080)).shr16(8)
}

/// The dither value of each fragment of a stamp, in both halves. Stamps start
/// at multiples of four, so one pattern serves the whole screen.
pub(crate) fn dither_pattern(dither: Dither, [right, down]: [u8; 2]) -> [i32; STAMP] {
    core::array::from_fn(|i| {
        let (x, y) = ((i + usize::from(right)) % 4, (i / 4 + usize::from(down)) % 4);
        let value = match dither {
            Dither::Off => 0,
            Dither::Ordered2x2 => DITHER_2X2[y % 2][x % 2],
            Dither::Ordered4x4 => DITHER_4X4[y][x],
        };
        i32::from(value) * 0x0001_0001
    })
}
