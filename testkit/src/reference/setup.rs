//! Triangle set-up in single precision, and the conversions into registers.
//!
//! Source: G246, triangle set-up; SST1, register formats.

use fillrate_engine::{
    Cull, Param, Registers, TmuVertex, VeriteExtra, VeriteVertex, Vertex, VertexExtra, WideParam,
};

/// What becomes of a triangle.
#[derive(Clone, Debug, PartialEq)]
pub enum SetUp {
    /// Its area is 0, infinite or not a number.
    Empty,
    /// Its sign says it is not wanted.
    Culled,
    /// It is launched with these registers.
    Drawn(Box<Registers>),
}

/// Sorts, culls and computes the registers of a triangle; all texture units
/// receive coordinates.
pub fn set_up(vertices: &[Vertex; 3], cull: Cull) -> SetUp {
    let plain = VertexExtra { fog: 255.0, ..VertexExtra::default() };
    set_up_extended(vertices, &[plain; 3], cull)
}

/// [`set_up`], with what the vertices have besides.
pub fn set_up_extended(vertices: &[Vertex; 3], extras: &[VertexExtra; 3], cull: Cull) -> SetUp {
    let (order, odd) = sort(vertices);
    let (sorted, extras) = (order.map(|i| vertices[i]), order.map(|i| extras[i]));
    let [a, b, c] = &sorted;
    let (dx_ab, dy_ab) = (a.x - b.x, a.y - b.y);
    let (dx_bc, dy_bc) = (b.x - c.x, b.y - c.y);
    let area = dx_ab * dy_bc - dx_bc * dy_ab;
    if area == 0.0 || area.is_nan() || area.is_infinite() {
        return SetUp::Empty;
    }
    let negative = area < 0.0;
    let negative_as_given = if odd { !negative } else { negative };
    match cull {
        Cull::Negative if negative_as_given => return SetUp::Culled,
        Cull::Positive if !negative_as_given => return SetUp::Culled,
        _ => {}
    }
    let inverse = 1.0 / area;
    let step = Steps {
        dx_ab: dx_ab * inverse,
        dy_ab: dy_ab * inverse,
        dx_bc: dx_bc * inverse,
        dy_bc: dy_bc * inverse,
    };
    let mut registers = registers(&sorted, negative, &step);
    add_extras(&mut registers, &sorted, &extras, &step);
    SetUp::Drawn(Box::new(registers))
}

/// Coordinate differences divided by the area.
struct Steps {
    dx_ab: f32,
    dy_ab: f32,
    dx_bc: f32,
    dy_bc: f32,
}

impl Steps {
    /// Value at A, step per column, step per row.
    fn of(&self, [a, b, c]: [f32; 3]) -> [f32; 3] {
        let (ab, bc) = (a - b, b - c);
        [a, ab * self.dy_bc - bc * self.dy_ab, bc * self.dx_ab - ab * self.dx_bc]
    }

    fn narrow(&self, values: [f32; 3]) -> Param {
        let [start, dx, dy] = self.of(values).map(|v| fixed(v, 12) as i32);
        Param { start, dx, dy }
    }

    fn wide(&self, values: [f32; 3]) -> WideParam {
        let [start, dx, dy] = self.of(values).map(|v| fixed(v, 32));
        WideParam { start, dx, dy }
    }
}

fn registers(sorted: &[Vertex; 3], negative: bool, step: &Steps) -> Registers {
    let of = |field: fn(&Vertex) -> f32| [field(&sorted[0]), field(&sorted[1]), field(&sorted[2])];
    let mut out = Registers {
        x: of(|v| v.x).map(coordinate),
        y: of(|v| v.y).map(coordinate),
        negative,
        color: [
            step.narrow(of(|v| v.r)),
            step.narrow(of(|v| v.g)),
            step.narrow(of(|v| v.b)),
            step.narrow(of(|v| v.a)),
        ],
        z: step.narrow(of(|v| v.z)),
        w: step.wide(of(|v| v.w)),
        ..Registers::default()
    };
    for (unit, wide) in out.tmu.iter_mut().enumerate() {
        let of = |field: fn(&TmuVertex) -> f32| sorted.map(|v| field(&v.tmu[unit]));
        *wide = [step.wide(of(|t| t.s)), step.wide(of(|t| t.t)), step.wide(of(|t| t.w))];
    }
    out
}

/// The parameters of extras that are sorted like the vertices.
fn add_extras(
    out: &mut Registers,
    vertices: &[Vertex; 3],
    extras: &[VertexExtra; 3],
    step: &Steps,
) {
    let of = |field: &dyn Fn(&VertexExtra) -> f32| step.narrow(extras.each_ref().map(field));
    out.specular =
        [of(&|e| e.specular[0]), of(&|e| e.specular[1]), of(&|e| e.specular[2]), of(&|e| e.fog)];
    out.base = [of(&|e| e.base[0]), of(&|e| e.base[1]), of(&|e| e.base[2])];
    // The plane through three points, by Cramer's rule.
    let [a, b, c] = [0, 1, 2].map(|i| {
        let Vertex { x, y, .. } = vertices[i];
        [f64::from(x), f64::from(y), extras[i].deep_z]
    });
    let minus = |p: [f64; 3], q: [f64; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let ([x1, y1, z1], [x2, y2, z2]) = (minus(a, b), minus(b, c));
    let area = x1 * y2 - x2 * y1;
    let wide = |value: f64| (value * 4_294_967_296.0) as i64;
    out.deep_z = WideParam {
        start: wide(a[2]),
        dx: wide((z1 * y2 - z2 * y1) / area),
        dy: wide((z2 * x1 - z1 * x2) / area),
    };
}

/// Sorts and computes the registers of a triangle as the Vérité has it: planes
/// through the corners as they come, in double precision, from coordinates in
/// sixteenths.
pub fn set_up_verite(corners: &[(VeriteVertex, VeriteExtra); 3]) -> SetUp {
    let vertices = corners.map(|corner| corner.0);
    let extras = corners.map(|corner| corner.1);
    let x = vertices.map(|v| i64::from(v.x));
    let y = vertices.map(|v| i64::from(v.y));
    let area =
        |[a, b, c]: [usize; 3]| (x[a] - x[b]) * (y[b] - y[c]) - (x[b] - x[c]) * (y[a] - y[b]);
    if area([0, 1, 2]) == 0 {
        return SetUp::Empty;
    }
    let scale = 16.0 / area([0, 1, 2]) as f64;
    let side = |v: [i64; 3], i: usize| (v[i] - v[i + 1]) as f64 * scale;
    let (x_ab, y_ab, x_bc, y_bc) = (side(x, 0), side(y, 0), side(x, 1), side(y, 1));
    let steps = |values: [f64; 3]| {
        let (ab, bc) = (values[0] - values[1], values[1] - values[2]);
        [ab * y_bc - bc * y_ab, bc * x_ab - ab * x_bc]
    };
    let mut order = [0, 1, 2];
    order.sort_by_key(|&i| y[i]);
    let first = &vertices[order[0]];
    // Casts of floats end at the last integer and drop fractions.
    let narrow = |values: [i32; 3]| {
        let [dx, dy] = steps(values.map(f64::from)).map(|v| v as i32);
        Param { start: values[order[0]], dx, dy }
    };
    let wide = |i: usize| {
        let values = extras.map(|extra| extra.texel[i]);
        let [dx, dy] = steps(values).map(|v| v as i64);
        WideParam { start: values[order[0]] as i64, dx, dy }
    };
    let [z_dx, z_dy] =
        steps(vertices.map(|v| f64::from(v.z))).map(|v| (v as i64).wrapping_mul(2) as i32);
    let z = Param { start: first.z.wrapping_mul(2), dx: z_dx, dy: z_dy };
    SetUp::Drawn(Box::new(Registers {
        x: order.map(|i| x[i] as i32),
        y: order.map(|i| y[i] as i32),
        negative: area(order) < 0,
        color: [0, 1, 2, 3].map(|i| narrow(vertices.map(|v| v.color[i]))),
        z,
        tmu: [[0, 1, 2].map(wide), Default::default(), Default::default()],
        specular: [0, 1, 2, 3].map(|i| narrow(extras.map(|extra| extra.specular[i]))),
        ..Registers::default()
    }))
}

/// The vertices' numbers by rising y, and whether that took an odd permutation. Which
/// of equal ones comes first is as the original's comparisons decide.
fn sort(vertices: &[Vertex; 3]) -> ([usize; 3], bool) {
    let [ay, by, cy] = vertices.map(|vertex| rank(vertex.y));
    let [a, b, c] = [0, 1, 2];
    if ay < by {
        if by > cy {
            if ay < cy { ([a, c, b], true) } else { ([c, a, b], false) }
        } else {
            ([a, b, c], false)
        }
    } else if by < cy {
        if ay < cy { ([b, a, c], true) } else { ([b, c, a], false) }
    } else {
        ([c, b, a], true)
    }
}

/// A float's bits as an integer of the same order; -0 ranks below +0.
fn rank(value: f32) -> i64 {
    let magnitude = i64::from(value.to_bits() & 0x7fff_ffff);
    if value.is_sign_negative() { -1 - magnitude } else { magnitude }
}

/// Signed 12.4; only 16 bits are kept.
fn coordinate(value: f32) -> i32 {
    i32::from(fixed(value, 4) as i16)
}

/// `value * 2^fraction` truncated toward zero, the low 64 bits of that
/// integer; 0 for infinities and not-a-number.
fn fixed(value: f32, fraction: i32) -> i64 {
    if !value.is_finite() {
        return 0;
    }
    let bits = value.to_bits();
    let exponent = (bits >> 23 & 0xff) as i32;
    let mantissa = match exponent {
        0 => i64::from(bits & 0x7f_ffff),
        _ => i64::from(bits & 0x7f_ffff | 0x80_0000),
    };
    // The value is mantissa * 2^(exponent - 150); denormals share exponent 1.
    let shift = exponent.max(1) - 150 + fraction;
    let magnitude = match shift {
        64.. => 0,
        0..64 => mantissa << shift,
        -63..0 => mantissa >> -shift,
        _ => 0,
    };
    if value < 0.0 { magnitude.wrapping_neg() } else { magnitude }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fixed_point_truncates_and_wraps() {
        assert_eq!(fixed(1.75, 1), 3);
        assert_eq!(fixed(-1.75, 1), -3);
        assert_eq!(fixed(f32::MIN_POSITIVE / 2.0, 32), 0);
        assert_eq!(fixed(f32::NAN, 12), 0);
        assert_eq!(fixed(9_223_372_036_854_775_808.0, 0), i64::MIN);
        assert_eq!(fixed(f32::MAX, 4), 0);
        assert_eq!(coordinate(786_432.0 - 10.5), -168);
        assert_eq!(coordinate(2048.0), -32768);
    }

    #[test]
    fn ranks_are_ordered() {
        let rising = [f32::NEG_INFINITY, -1.0, -0.0, 0.0, 1e-40, 2.0, f32::INFINITY, f32::NAN];
        assert!(rising.windows(2).all(|w| rank(w[0]) < rank(w[1])));
    }
}
