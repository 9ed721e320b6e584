//! Which pixels a triangle covers.
//!
//! A pixel is covered where its centre is: centres on a left edge or on the
//! edge of lower y count, centres on a right edge or on the one of higher y do
//! not. Edges are exact lines between the 12.4 vertices.
//!
//! Source: SST1, triangle rasterization.

use fillrate_engine::Registers;

/// Whether the centre of the pixel at drawing coordinates (x, y) is covered.
pub fn covers(registers: &Registers, x: u32, y: u32) -> bool {
    let (x, y) = (i64::from(x), i64::from(y));
    let [a, b, c] =
        [0, 1, 2].map(|i| Point { x: i64::from(registers.x[i]), y: i64::from(registers.y[i]) });
    if y < first_row(a.y) || y >= first_row(c.y) {
        return false;
    }
    let long = Edge { from: a, to: c };
    let minor = if y < first_row(b.y) { Edge { from: a, to: b } } else { Edge { from: b, to: c } };
    let (left, right) = if registers.negative { (minor, long) } else { (long, minor) };
    left.is_at_or_left_of(x, y) && !right.is_at_or_left_of(x, y)
}

/// The first row whose centre is not above a 12.4 coordinate.
fn first_row(y: i64) -> i64 {
    (y + 7) >> 4
}

#[derive(Clone, Copy)]
struct Point {
    x: i64,
    y: i64,
}

/// An edge with rising y.
#[derive(Clone, Copy)]
struct Edge {
    from: Point,
    to: Point,
}

impl Edge {
    /// Whether the edge crosses row y's centre line at or left of the centre
    /// of column x.
    ///
    /// The crossing is `from.x + (centre y - from.y) * dx / dy`; both sides
    /// are multiplied by dy, which is positive.
    fn is_at_or_left_of(&self, x: i64, y: i64) -> bool {
        let (dx, dy) = (self.to.x - self.from.x, self.to.y - self.from.y);
        assert!(dy > 0, "an edge used on a row rises across its centre");
        let (centre_x, centre_y) = (16 * x + 8, 16 * y + 8);
        let crossing = i128::from(self.from.x) * i128::from(dy)
            + i128::from(centre_y - self.from.y) * i128::from(dx);
        crossing <= i128::from(centre_x) * i128::from(dy)
    }
}
