//! [`crate::setup::sst1`] in lanes.

use fillrate_simd::{FloatLanes, IntLanes, MaskLanes, Simd, SingleLanes};

use super::{Order, Places, Source};
use crate::fixed::{COLOR_FRACTION, COORD_FRACTION, FITS_I32, WIDE_FRACTION};
use crate::setup::corners::{CornerBlock, Field, RED, W, X, Y, tmu_field};
use crate::setup::launch::Params;
use crate::setup::sst1::ORDER_CODES;

/// Triangles with their corners sorted, and what their gradients are made of.
pub(super) struct Sorted<'a, S: Simd> {
    block: &'a CornerBlock,
    first: usize,
    /// Bit per lane: those with an area, and those that face the wrong way.
    pub drawn: u32,
    pub culled: u32,
    order: Order<S>,
    negative: S::I,
    /// Deltas of the sorted corners by the area.
    dx_ab: S::G,
    dy_ab: S::G,
    dx_bc: S::G,
    dy_bc: S::G,
}

/// A float's bits as an integer that orders like the float.
#[inline(always)]
fn order_key<S: Simd>(value: S::G) -> S::I {
    let bits = value.to_bits();
    bits ^ bits.sar(31).shr(1)
}

/// `bit` in the lanes that are on.
#[inline(always)]
fn bit<S: Simd>(s: S, mask: S::M, bit: i32) -> S::I {
    s.splat(bit).select(s.splat(0), mask)
}

/// A field's values, by corner as they came.
#[inline(always)]
fn load<S: Simd>(s: S, field: &Field, first: usize) -> [S::G; 3] {
    [s.load_g(&field[0][first..]), s.load_g(&field[1][first..]), s.load_g(&field[2][first..])]
}

impl<'a, S: Simd> Sorted<'a, S> {
    #[inline(always)]
    pub fn new(s: S, block: &'a CornerBlock, first: usize) -> Self {
        let (x, y) = (load(s, &block.fields[X], first), load(s, &block.fields[Y], first));
        let code = order_code(s, y);
        let order = Order::new(s, code);
        let ([ax, bx, cx], [ay, by, cy]) = (order.singles(x), order.singles(y));
        let (dx_ab, dy_ab, dx_bc, dy_bc) = (ax - bx, ay - by, bx - cx, by - cy);
        let area = dx_ab * dy_bc - dx_bc * dy_ab;
        let inverse = s.splat_g(1.0) / area;
        let size = area.to_bits() & s.splat(i32::MAX);
        let drawn = size.gt(s.splat(0)) & s.splat(f32::INFINITY.to_bits() as i32).gt(size);
        let negative = area.to_bits().sar(31);
        // The caller's order: -1 where its area is negative.
        let facing = negative ^ (s.splat(0) - code.shr(6));
        let culled = s.load(&block.marks.cull[first..]).eq(facing + s.splat(2));
        Sorted {
            block,
            first,
            drawn: drawn.bits(),
            culled: culled.bits(),
            order,
            negative,
            dx_ab: dx_ab * inverse,
            dy_ab: dy_ab * inverse,
            dx_bc: dx_bc * inverse,
            dy_bc: dy_bc * inverse,
        }
    }

    /// Start values and steps of a field.
    #[inline(always)]
    fn gradients(&self, s: S, field: usize) -> Params<S::G> {
        let values = load(s, &self.block.fields[field], self.first);
        let [a, b, c] = self.order.singles(values);
        let (d_ab, d_bc) = (a - b, b - c);
        Params {
            start: a,
            dx: d_ab * self.dy_bc - d_bc * self.dy_ab,
            dy: d_bc * self.dx_ab - d_ab * self.dx_bc,
        }
    }
}

/// Codes of the corners' order: see [`ORDER_CODES`].
#[inline(always)]
fn order_code<S: Simd>(s: S, [a, b, c]: [S::G; 3]) -> S::I {
    let (a, b, c) = (order_key::<S>(a), order_key::<S>(b), order_key::<S>(c));
    let index = bit(s, b.gt(a), 8) | bit(s, c.gt(b), 4) | bit(s, b.gt(c), 2) | bit(s, c.gt(a), 1);
    s.lookup16(&ORDER_CODES, index)
}

/// `value * 2^fraction`, truncated toward zero, where that fits.
#[inline(always)]
fn scaled<S: Simd>(s: S, value: S::G, fraction: u32) -> (S::I, S::M) {
    let product = value * s.splat_g((1u32 << fraction) as f32);
    let size = S::G::from_bits(product.to_bits() & s.splat(i32::MAX));
    (product.truncate_i32(), size.lt(s.splat_g(FITS_I32)))
}

/// A coordinate as 12.4.
#[inline(always)]
fn coordinate<S: Simd>(s: S, value: S::G) -> (S::I, S::M) {
    let (value, fits) = scaled(s, value, COORD_FRACTION);
    (value.shl(16).sar(16), fits)
}

/// With 32 fraction bits, truncated toward zero.
#[inline(always)]
fn widened<S: Simd>(s: S, value: S::G) -> S::F {
    (value.widen() * s.splat_f((1u64 << WIDE_FRACTION) as f64)).trunc()
}

impl<S: Simd> Source<S> for Sorted<'_, S> {
    #[inline(always)]
    fn places(&self, s: S) -> (Places<S>, S::M) {
        let (x, y) = (&self.block.fields[X], &self.block.fields[Y]);
        let [ax, bx, cx] = self.order.singles(load(s, x, self.first));
        let [ay, by, cy] = self.order.singles(load(s, y, self.first));
        let ((ax, fits_ax), (ay, fits_ay)) = (coordinate(s, ax), coordinate(s, ay));
        let ((bx, fits_bx), (by, fits_by)) = (coordinate(s, bx), coordinate(s, by));
        let ((cx, fits_cx), (cy, fits_cy)) = (coordinate(s, cx), coordinate(s, cy));
        let fits = fits_ax & fits_ay & fits_bx & fits_by & fits_cx & fits_cy;
        (Places { x: [ax, bx, cx], y: [ay, by, cy], negative: self.negative }, fits)
    }

    #[inline(always)]
    fn narrow(&self, s: S, lane: usize) -> (Params<S::I>, S::M) {
        let Params { start, dx, dy } = self.gradients(s, RED + lane);
        let (start, fits) = scaled(s, start, COLOR_FRACTION);
        let (dx, fits_dx) = scaled(s, dx, COLOR_FRACTION);
        let (dy, fits_dy) = scaled(s, dy, COLOR_FRACTION);
        (Params { start, dx, dy }, fits & fits_dx & fits_dy)
    }

    #[inline(always)]
    fn wide(&self, s: S, group: usize, lane: usize) -> Params<S::F> {
        let field = match (group, lane) {
            (0, 0) => W,
            (0, _) => tmu_field(0, lane - 1),
            _ => tmu_field(group, lane),
        };
        let Params { start, dx, dy } = self.gradients(s, field);
        Params { start: widened(s, start), dx: widened(s, dx), dy: widened(s, dy) }
    }
}
