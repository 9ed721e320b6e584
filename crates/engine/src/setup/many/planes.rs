//! [`crate::setup::planes`] in lanes.

use fillrate_simd::{FloatLanes, IntLanes, Simd};

use super::Places;
use crate::fixed::COORD_FRACTION;
use crate::setup::launch::Params;
use crate::setup::planes::{COMPACT, EXACT_LIMIT, Screen};
use crate::state::Origin;
use crate::target::STAMP;

/// The parts of the screen that can be covered.
pub(super) struct Bounds<S: Simd> {
    pub x0: S::I,
    pub y0: S::I,
    pub x1: S::I,
    pub y1: S::I,
}

/// A line of each triangle: see [`crate::setup::Edge`].
#[derive(Clone, Copy)]
pub(super) struct Edges<S: Simd> {
    pub a: S::I,
    pub b: S::I,
    pub c: S::I,
}

#[inline(always)]
fn clamp<S: Simd>(s: S, value: S::I, size: u32) -> S::I {
    value.max(s.splat(0)).min(s.splat(size as i32))
}

/// The first pixel whose centre is not before a coordinate.
#[inline(always)]
fn pixel<S: Simd>(s: S, coordinate: S::I) -> S::I {
    (coordinate + s.splat(7)).sar(COORD_FRACTION)
}

/// Down to a stamp's first pixel.
#[inline(always)]
fn stamp<S: Simd>(s: S, value: S::I) -> S::I {
    value & s.splat(!(STAMP as i32 - 1))
}

impl<S: Simd> Places<S> {
    #[inline(always)]
    pub fn bounds(&self, s: S, screen: &Screen) -> Bounds<S> {
        let ([ax, bx, cx], [ay, _, cy]) = (self.x, self.y);
        let (left, right) = (ax.min(bx).min(cx), ax.max(bx).max(cx));
        let (mut first, mut end) = (pixel(s, ay), pixel(s, cy));
        if screen.origin == Origin::LowerLeft {
            let height = s.splat(screen.height as i32);
            (first, end) = (height - end, height - first);
        }
        Bounds {
            x0: clamp(s, pixel(s, left), screen.width),
            y0: clamp(s, first, screen.height),
            x1: clamp(s, pixel(s, right), screen.width),
            y1: clamp(s, end, screen.height),
        }
    }

    /// The lanes of compact triangles whose bounds are so too: see
    /// [`crate::setup::Triangle::compact`].
    #[inline(always)]
    pub fn are_compact(&self, s: S) -> S::M {
        let ([ax, bx, cx], [ay, by, cy]) = (self.x, self.y);
        let width = ax.max(bx).max(cx) - ax.min(bx).min(cx);
        let small = s.splat(COMPACT).gt(width.max(cy - ay));
        let area = (bx - ax).mul(cy - ay) - (cx - ax).mul(by - ay);
        let minus_one = s.splat(-1);
        small & (by - ay).gt(minus_one) & (cy - by).gt(minus_one) & area.sar(31).eq(self.negative)
    }

    /// The long side, then the others; a level one is the first or the last row of
    /// the bounds.
    #[inline(always)]
    pub fn edges(&self, s: S, bounds: &Bounds<S>, screen: &Screen) -> [Edges<S>; 3] {
        let ([ax, bx, cx], [ay, by, cy]) = (self.x, self.y);
        // B left of A-C: A-C is the right edge, A-B and B-C are left ones.
        let (major, minor) = (self.negative, self.negative ^ s.splat(-1));
        let ac = edge(s, [ax, ay], [cx, cy], major, screen);
        let ab = edge(s, [ax, ay], [bx, by], minor, screen);
        let bc = edge(s, [bx, by], [cx, cy], minor, screen);
        let (zero, one) = (s.splat(0), s.splat(1));
        let first = Edges { a: zero, b: one, c: zero - bounds.y0 };
        let last = Edges { a: zero, b: zero - one, c: bounds.y1 - one };
        let (above, below) = match screen.origin {
            Origin::UpperLeft => (first, last),
            Origin::LowerLeft => (last, first),
        };
        [ac, above.select(ab, ay.eq(by)), below.select(bc, by.eq(cy))]
    }
}

/// The edge from one corner to another; `turn` is -1 where pixels to its right are
/// inside, else 0.
#[inline(always)]
fn edge<S: Simd>(
    s: S,
    [from_x, from_y]: [S::I; 2],
    [to_x, to_y]: [S::I; 2],
    turn: S::I,
    screen: &Screen,
) -> Edges<S> {
    let (dx, dy) = (to_x - from_x, to_y - from_y);
    let half = s.splat(8);
    let c = (half - from_x).mul(dy) - (half - from_y).mul(dx);
    let a = (dy.shl(4) ^ turn) - turn;
    let b = ((s.splat(0) - dx.shl(4)) ^ turn) - turn;
    let c = c ^ turn;
    match screen.origin {
        Origin::UpperLeft => Edges { a, b, c },
        Origin::LowerLeft => {
            Edges { a, b: s.splat(0) - b, c: c + b.mul(s.splat(screen.height as i32 - 1)) }
        }
    }
}

impl<S: Simd> Edges<S> {
    #[inline(always)]
    fn select(&self, other: Edges<S>, mask: S::M) -> Edges<S> {
        Edges {
            a: self.a.select(other.a, mask),
            b: self.b.select(other.b, mask),
            c: self.c.select(other.c, mask),
        }
    }
}

impl<S: Simd> Bounds<S> {
    /// The lanes where they are not empty.
    #[inline(always)]
    pub fn visible(&self, _: S) -> S::M {
        self.x1.gt(self.x0) & self.y1.gt(self.y0)
    }

    /// The lanes where no stamp that they touch reaches beyond the screen.
    #[inline(always)]
    pub fn end_at_stamps(&self, s: S, screen: &Screen) -> S::M {
        let round = s.splat(STAMP as i32 - 1);
        let (width, height) = (screen.width as i32 + 1, screen.height as i32 + 1);
        let (x1, y1) = (stamp(s, self.x1 + round), stamp(s, self.y1 + round));
        s.splat(width).gt(x1) & s.splat(height).gt(y1)
    }
}

/// The sub-pixel correction, the reference pixel of a launch, and the area where
/// values are needed.
pub(super) struct Corrected<S: Simd> {
    /// Sixteenths from the first vertex to its pixel's centre.
    dx: S::I,
    dy: S::I,
    /// The first vertex's pixel, on the screen.
    x: S::I,
    y: S::I,
    /// Rows are counted from the other end.
    flipped: bool,
    /// As floats: the sixteenths; from the pixel to the first one of the area's first
    /// stamp; and from there to the last pixel of its last stamp.
    from: [S::F; 2],
    origin: [S::F; 2],
    reach: [S::F; 2],
}

impl<S: Simd> Corrected<S> {
    #[inline(always)]
    pub fn new(s: S, places: &Places<S>, bounds: &Bounds<S>, screen: &Screen) -> Self {
        let ([vx, ..], [vy, ..]) = (places.x, places.y);
        let (x, mut y) = (vx.sar(COORD_FRACTION), vy.sar(COORD_FRACTION));
        let flipped = screen.origin == Origin::LowerLeft;
        if flipped {
            y = s.splat(screen.height as i32 - 1) - y;
        }
        let (dx, dy) = (s.splat(8) - (vx & s.splat(15)), s.splat(8) - (vy & s.splat(15)));
        let (x0, y0) = (stamp(s, bounds.x0), stamp(s, bounds.y0));
        let round = s.splat(STAMP as i32 - 1);
        let (x1, y1) = (stamp(s, bounds.x1 + round), stamp(s, bounds.y1 + round));
        let one = s.splat(1);
        Corrected {
            dx,
            dy,
            x,
            y,
            flipped,
            from: [S::F::from_i32(dx), S::F::from_i32(dy)],
            origin: [S::F::from_i32(x0 - x), S::F::from_i32(y0 - y)],
            reach: [S::F::from_i32(x1 - x0 - one), S::F::from_i32(y1 - y0 - one)],
        }
    }

    /// Planes of a 32-bit parameter, shifted left.
    #[inline(always)]
    pub fn narrow(&self, s: S, params: Params<S::I>, shift: u32) -> Params<S::I> {
        let Params { start, dx, mut dy } = params;
        let moved = (dx.mul(self.dx) + dy.mul(self.dy)).sar(COORD_FRACTION);
        if self.flipped {
            dy = s.splat(0) - dy;
        }
        let start = start + moved - dx.mul(self.x) - dy.mul(self.y);
        Params { start: start.shl(shift), dx: dx.shl(shift), dy: dy.shl(shift) }
    }

    /// Planes of a 64-bit parameter as floats, and the lanes where these are exact
    /// and stay below a limit over the area.
    #[inline(always)]
    pub fn exact(&self, s: S, params: Params<S::F>, limit: f64) -> (Params<S::F>, S::M) {
        let Params { start, dx, mut dy } = params;
        let ([from_x, from_y], [ox, oy], [rx, ry]) = (self.from, self.origin, self.reach);
        let sixteenths = dx * from_x + dy * from_y;
        if self.flipped {
            dy = dy * s.splat_f(-1.0);
        }
        let (across, down) = (dx * ox, dy * oy);
        let corner = start + (sixteenths * s.splat_f(1.0 / 16.0)).floor() + across + down;
        // Nothing on the way may have been rounded, nor may the parameters be so large
        // that floats do not hold them. Not-a-number does not pass.
        let steps = s.splat_f(16.0) * (dx.abs() + dy.abs());
        let largest = start.abs() + steps + across.abs() + down.abs();
        let value = corner.abs() + (dx * rx).abs() + (dy * ry).abs();
        let fits = largest.lt(s.splat_f(EXACT_LIMIT)) & value.lt(s.splat_f(limit));
        (Params { start: corner, dx, dy }, fits)
    }
}
