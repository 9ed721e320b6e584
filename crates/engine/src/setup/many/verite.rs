//! [`crate::setup::verite`] in lanes.

use fillrate_simd::{FloatLanes, IntLanes, MaskLanes, Simd};

use super::{Order, Places, Source};
use crate::setup::corners::BLOCK;
use crate::setup::launch::{Params, Z};
use crate::setup::verite::{ORDER_CODES, SIXTEENTHS, VeriteCorners};

/// Values of one kind, by corner, a lane for each triangle.
type Field<T> = [[T; BLOCK]; 3];

/// Corners of triangles as they came, field by field.
struct Corners {
    x: Field<i32>,
    y: Field<i32>,
    /// Red, green, blue, alpha, z.
    narrow: [Field<i32>; 5],
    /// s, t, w of the first texture unit.
    texel: [Field<f64>; 3],
}

impl Corners {
    const EMPTY: Corners = Corners {
        x: [[0; BLOCK]; 3],
        y: [[0; BLOCK]; 3],
        narrow: [[[0; BLOCK]; 3]; 5],
        texel: [[[0.0; BLOCK]; 3]; 3],
    };

    #[inline(always)]
    fn put(&mut self, lane: usize, (vertices, extras): VeriteCorners<'_>) {
        for (corner, v) in vertices.into_iter().enumerate() {
            self.x[corner][lane] = i32::from(v.x);
            self.y[corner][lane] = i32::from(v.y);
            let [r, g, b, a] = v.color;
            for (field, value) in self.narrow.iter_mut().zip([r, g, b, a, v.z]) {
                field[corner][lane] = value;
            }
        }
        for (corner, extra) in extras.into_iter().flatten().enumerate() {
            for (field, value) in self.texel.iter_mut().zip(extra.texel) {
                field[corner][lane] = value;
            }
        }
    }
}

/// Triangles, and what their steps are made of.
pub(super) struct Sorted<S: Simd> {
    corners: Corners,
    /// Bit per lane: those with an area.
    pub drawn: u32,
    order: Order<S>,
    negative: S::I,
    /// Sides of the corners as they came, by the area.
    dx_ab: S::F,
    dy_ab: S::F,
    dx_bc: S::F,
    dy_bc: S::F,
}

#[inline(always)]
fn load<S: Simd>(s: S, field: &Field<i32>) -> [S::I; 3] {
    [s.load(&field[0]), s.load(&field[1]), s.load(&field[2])]
}

impl<S: Simd> Sorted<S> {
    /// Takes the triangle of every lane that has one.
    #[inline(always)]
    pub fn new<'a>(s: S, triangle: impl Fn(usize) -> Option<VeriteCorners<'a>>) -> Self {
        let mut corners = Corners::EMPTY;
        for lane in 0..S::LANES {
            if let Some(triangle) = triangle(lane) {
                corners.put(lane, triangle);
            }
        }
        let ([ax, bx, cx], [ay, by, cy]) = (load(s, &corners.x), load(s, &corners.y));
        let (dx_ab, dy_ab) = (S::F::from_i32(ax - bx), S::F::from_i32(ay - by));
        let (dx_bc, dy_bc) = (S::F::from_i32(bx - cx), S::F::from_i32(by - cy));
        let area = dx_ab * dy_bc - dx_bc * dy_ab;
        let (zero, none) = (s.splat(0), s.splat_f(0.0));
        let (below, above) = (area.lt(none), none.lt(area));
        let scale = s.splat_f(SIXTEENTHS) / area;
        let (one, two, four) = (s.splat(1), s.splat(2), s.splat(4));
        let index = four.select(zero, ay.gt(by)) | two.select(zero, by.gt(cy));
        let code = s.lookup16(&ORDER_CODES, index | one.select(zero, ay.gt(cy)));
        // The sign turns with an odd order.
        let sign = one.select(zero, below) ^ code.shr(6);
        Sorted {
            corners,
            drawn: below.bits() | above.bits(),
            order: Order::new(s, code),
            negative: zero - sign,
            dx_ab: dx_ab * scale,
            dy_ab: dy_ab * scale,
            dx_bc: dx_bc * scale,
            dy_bc: dy_bc * scale,
        }
    }

    /// Steps per column and per row of values by corner.
    #[inline(always)]
    fn steps(&self, [a, b, c]: [S::F; 3]) -> [S::F; 2] {
        let (d_ab, d_bc) = (a - b, b - c);
        [d_ab * self.dy_bc - d_bc * self.dy_ab, d_bc * self.dx_ab - d_ab * self.dx_bc]
    }
}

impl<S: Simd> Source<S> for Sorted<S> {
    #[inline(always)]
    fn places(&self, s: S) -> (Places<S>, S::M) {
        let (x, y) = (load(s, &self.corners.x), load(s, &self.corners.y));
        let (x, y) = (self.order.integers(x), self.order.integers(y));
        (Places { x, y, negative: self.negative }, s.mask(u32::MAX))
    }

    #[inline(always)]
    fn narrow(&self, s: S, lane: usize) -> (Params<S::I>, S::M) {
        let [a, b, c] = load(s, &self.corners.narrow[lane]);
        let [dx, dy] = self.steps([S::F::from_i32(a), S::F::from_i32(b), S::F::from_i32(c)]);
        let [start, ..] = self.order.integers([a, b, c]);
        // Kept within their registers.
        let params = Params { start, dx: dx.trunc().floor_i32(), dy: dy.trunc().floor_i32() };
        if lane != Z {
            return (params, s.mask(u32::MAX));
        }
        // 21.11 in iterators of 20.12; steps wrap there.
        let limit = s.splat_f(f64::from(i32::MAX));
        let Params { start, dx: z_dx, dy: z_dy } = params;
        let fits = dx.abs().lt(limit) & dy.abs().lt(limit);
        (Params { start: start.shl(1), dx: z_dx.shl(1), dy: z_dy.shl(1) }, fits)
    }

    #[inline(always)]
    fn wide(&self, s: S, group: usize, lane: usize) -> Params<S::F> {
        if (group, lane) == (0, 0) || group > 0 {
            let zero = s.splat_f(0.0);
            return Params { start: zero, dx: zero, dy: zero };
        }
        let texel = &self.corners.texel[lane - 1];
        let corners = [s.load_f(&texel[0]), s.load_f(&texel[1]), s.load_f(&texel[2])];
        let [dx, dy] = self.steps(corners);
        Params { start: self.order.first(corners).trunc(), dx: dx.trunc(), dy: dy.trunc() }
    }
}
