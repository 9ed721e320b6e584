//! 4x4 matrices as the thesis uses them: `m[row][column]`, column vectors, f32.

/// A 4x4 matrix, `m[row][column]`, applied to column vectors.
pub type Matrix = [[f32; 4]; 4];

/// The identity matrix.
pub const IDENTITY: Matrix =
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

/// The product `a * b`; each element is summed from left to right.
pub fn multiply(a: &Matrix, b: &Matrix) -> Matrix {
    let mut out = [[0.0; 4]; 4];
    for (row, line) in out.iter_mut().enumerate() {
        for (col, cell) in line.iter_mut().enumerate() {
            *cell = a[row][0] * b[0][col]
                + a[row][1] * b[1][col]
                + a[row][2] * b[2][col]
                + a[row][3] * b[3][col];
        }
    }
    out
}

/// The product of `m` and a column vector; each row is summed from left to right.
pub fn transform(m: &Matrix, v: [f32; 4]) -> [f32; 4] {
    m.map(|r| r[0] * v[0] + r[1] * v[1] + r[2] * v[2] + r[3] * v[3])
}

/// Reads a matrix sent row by row as 16 float words.
pub fn from_words(words: &[u32]) -> Matrix {
    let mut out = [[0.0; 4]; 4];
    for (cell, word) in out.iter_mut().flatten().zip(words) {
        *cell = f32::from_bits(*word);
    }
    out
}

/// The cofactor matrix of the upper 3x3 part: determinant times inverse transpose.
///
/// The last row and column are those of the identity. Source: RAW, geometry listing.
pub fn cofactors(m: &Matrix) -> Matrix {
    let c = |a: usize, b: usize, p: usize, q: usize| m[a][p] * m[b][q] - m[a][q] * m[b][p];
    [
        [c(1, 2, 1, 2), c(1, 2, 2, 0), c(1, 2, 0, 1), 0.0],
        [c(2, 0, 1, 2), c(2, 0, 2, 0), c(2, 0, 0, 1), 0.0],
        [c(0, 1, 1, 2), c(0, 1, 2, 0), c(0, 1, 0, 1), 0.0],
        [0.0, 0.0, 0.0, 1.0],
    ]
}

/// The determinant of the upper 3x3 part.
pub fn determinant3(m: &Matrix) -> f32 {
    let c = cofactors(m);
    m[0][0] * c[0][0] + m[0][1] * c[0][1] + m[0][2] * c[0][2]
}

/// A perspective projection from the edges of the near rectangle.
///
/// Eye space is x right, y up, z forward. `top` maps to -1 (the top of the screen), `bottom` to +1,
/// `near` to -1 and `far` to +1; w becomes z. Source: RAW, client listing.
pub fn perspective(l: f32, r: f32, t: f32, b: f32, n: f32, f: f32) -> Matrix {
    let (depth, offset) = depth_rows(n, f);
    [
        [2.0 * n / (r - l), 0.0, -(r + l) / (r - l), 0.0],
        [0.0, 2.0 * n / (b - t), -(b + t) / (b - t), 0.0],
        [0.0, 0.0, depth, offset],
        [0.0, 0.0, 1.0, 0.0],
    ]
}

/// A symmetric perspective projection from two angles in radians: centre to right edge and centre
/// to top edge.
pub fn perspective_angles(u: f32, v: f32, n: f32, f: f32) -> Matrix {
    let (depth, offset) = depth_rows(n, f);
    [
        [1.0 / tangent(u), 0.0, 0.0, 0.0],
        [0.0, -1.0 / tangent(v), 0.0, 0.0],
        [0.0, 0.0, depth, offset],
        [0.0, 0.0, 1.0, 0.0],
    ]
}

fn depth_rows(n: f32, f: f32) -> (f32, f32) {
    ((f + n) / (f - n), -2.0 * n * f / (f - n))
}

/// An orthographic projection of a box.
pub fn orthographic(l: f32, r: f32, t: f32, b: f32, n: f32, f: f32) -> Matrix {
    [
        [2.0 / (r - l), 0.0, 0.0, -(r + l) / (r - l)],
        [0.0, 2.0 / (b - t), 0.0, -(b + t) / (b - t)],
        [0.0, 0.0, 2.0 / (f - n), -(f + n) / (f - n)],
        [0.0, 0.0, 0.0, 1.0],
    ]
}

/// A camera at `eye` looking at `focus`, with `up` a point in the upward direction.
///
/// `scale_while_measuring` keeps the listing's normalisation, which divides the later components
/// by a length computed from the already scaled earlier ones.
pub fn camera(eye: [f32; 3], focus: [f32; 3], up: [f32; 3], scale_while_measuring: bool) -> Matrix {
    let unit = |v| if scale_while_measuring { normalise_in_place(v) } else { normalise(v) };
    let n = unit(sub(focus, eye));
    let d = sub(up, eye);
    let along = dot(n, d);
    let v = unit([d[0] - along * n[0], d[1] - along * n[1], d[2] - along * n[2]]);
    let u = [n[2] * v[1] - n[1] * v[2], n[0] * v[2] - n[2] * v[0], n[1] * v[0] - n[0] * v[1]];
    let row = |a: [f32; 3]| [a[0], a[1], a[2], -dot(a, eye)];
    [row(u), row(v), row(n), [0.0, 0.0, 0.0, 1.0]]
}

fn sub(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn normalise(v: [f32; 3]) -> [f32; 3] {
    let length = dot(v, v).sqrt();
    v.map(|c| c / length)
}

fn normalise_in_place(mut v: [f32; 3]) -> [f32; 3] {
    for axis in 0..3 {
        v[axis] /= dot(v, v).sqrt();
    }
    v
}

/// The tangent of an angle in radians, the same on every machine.
///
/// The platform's own function may differ in the last bit from one library to the next and would
/// then move pixels. Sine and cosine are summed as series in f64 after reduction to a quarter turn.
pub fn tangent(angle: f32) -> f32 {
    let (sin, cos) = sin_cos(f64::from(angle));
    (sin / cos) as f32
}

/// Sine and cosine of an angle in radians, the same on every machine; zero and one for angles that
/// are not finite or too large (beyond a million turns) to mean anything.
pub fn sin_cos(angle: f64) -> (f64, f64) {
    use std::f64::consts::FRAC_PI_2;
    if angle.is_nan() || angle.abs() >= 6.0e6 {
        return (0.0, 1.0);
    }
    let turns = (angle / FRAC_PI_2).round();
    let r = angle - turns * FRAC_PI_2;
    let square = r * r;
    let series = |first: f64, start: f64| {
        let (mut term, mut sum, mut k) = (first, first, start);
        for _ in 0..12 {
            term *= -square / ((k + 1.0) * (k + 2.0));
            sum += term;
            k += 2.0;
        }
        sum
    };
    let (s, c) = (series(r, 1.0), series(1.0, 0.0));
    match (turns as i64).rem_euclid(4) {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cofactors_of_a_rotation_are_the_rotation() {
        let m = [[0.0, -1.0, 0.0, 5.0], [1.0, 0.0, 0.0, 6.0], [0.0, 0.0, 1.0, 7.0], IDENTITY[3]];
        let mut rotation = m;
        for (row, line) in rotation.iter_mut().enumerate().take(3) {
            line[3] = IDENTITY[row][3];
        }
        assert_eq!(cofactors(&m), rotation);
        assert_eq!(determinant3(&m), 1.0);
    }

    #[test]
    fn perspective_maps_the_planes() {
        let m = perspective(-1.0, 1.0, 1.0, -1.0, 2.0, 10.0);
        let near = transform(&m, [0.0, 1.0, 2.0, 1.0]);
        assert_eq!([near[1] / near[3], near[2] / near[3]], [-1.0, -1.0]);
        let far = transform(&m, [0.0, 0.0, 10.0, 1.0]);
        assert!((far[2] / far[3] - 1.0).abs() < 1e-6);
    }

    #[test]
    fn camera_axes_match_the_convention() {
        let m = camera([0.0; 3], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0], false);
        assert_eq!(m, IDENTITY);
    }

    #[test]
    fn sine_and_cosine_agree_with_the_platform() {
        for step in -2000..2000 {
            let angle = f64::from(step) * 0.01;
            let (s, c) = sin_cos(angle);
            assert!((s - angle.sin()).abs() < 1e-12 && (c - angle.cos()).abs() < 1e-12);
        }
        assert_eq!(sin_cos(f64::NAN), (0.0, 1.0));
    }
}
