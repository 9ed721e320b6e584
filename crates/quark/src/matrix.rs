//! Transforms: three axes and a position, in integers.

use crate::math::{TRIGO_MUL, TRIGO_SHIFT, cosinus, normalize, sinus};

/// A rotation scaled by 16384 and a translation: three rows, four columns,
/// stored column after column: right (x axis), up (y axis), direction (z
/// axis), position.
///
/// Operations multiply from the right, as OpenGL's do. Sums are taken in 64
/// bits, shifted right without rounding, and kept modulo 2^32.
///
/// Source: QK, matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct Matrix {
    /// Element (i, j) is `m[i + 3 * j]`.
    pub m: [i32; 12],
}

impl Default for Matrix {
    fn default() -> Matrix {
        Matrix::identity()
    }
}

/// Which two axes a rotation turns: the first towards the second.
#[derive(Clone, Copy)]
enum Plane {
    YToZ,
    ZToX,
    XToY,
}

impl Matrix {
    /// No rotation, no translation. Source: QK, `LoadIdentity`.
    pub const fn identity() -> Matrix {
        let one = TRIGO_MUL;
        Matrix { m: [one, 0, 0, 0, one, 0, 0, 0, one, 0, 0, 0] }
    }

    /// The x axis.
    pub fn right(&self) -> [i32; 3] {
        self.column(0)
    }

    /// The y axis.
    pub fn up(&self) -> [i32; 3] {
        self.column(1)
    }

    /// The z axis.
    pub fn dir(&self) -> [i32; 3] {
        self.column(2)
    }

    /// The position.
    pub fn pos(&self) -> [i32; 3] {
        self.column(3)
    }

    fn column(&self, j: usize) -> [i32; 3] {
        [self.m[3 * j], self.m[3 * j + 1], self.m[3 * j + 2]]
    }

    fn set_column(&mut self, j: usize, column: [i32; 3]) {
        self.m[3 * j..3 * j + 3].copy_from_slice(&column);
    }

    /// A vector by rotation alone. Source: QK, `RotateVector`.
    pub fn rotate_vector(&self, v: &[i32; 3]) -> [i32; 3] {
        core::array::from_fn(|i| {
            let sum: i64 = (0..3).map(|j| i64::from(v[j]) * i64::from(self.m[i + 3 * j])).sum();
            (sum >> TRIGO_SHIFT) as i32
        })
    }

    /// A vector by the inverse of the rotation, if it is one.
    /// Source: QK, `InvRotateVector`.
    pub fn inv_rotate_vector(&self, v: &[i32; 3]) -> [i32; 3] {
        core::array::from_fn(|j| {
            let sum: i64 = (0..3).map(|i| i64::from(v[i]) * i64::from(self.m[i + 3 * j])).sum();
            (sum >> TRIGO_SHIFT) as i32
        })
    }

    /// A point by rotation and translation. Source: QK, `TransformVector`.
    pub fn transform_vector(&self, v: &[i32; 3]) -> [i32; 3] {
        let turned = self.rotate_vector(v);
        core::array::from_fn(|i| turned[i].wrapping_add(self.m[9 + i]))
    }

    /// This matrix times `other`. Source: QK, `Mult`.
    pub fn mult(&mut self, other: &Matrix) {
        let left = *self;
        for j in 0..3 {
            self.set_column(j, left.rotate_vector(&other.column(j)));
        }
        self.set_column(3, left.transform_vector(&other.pos()));
    }

    /// Moves along its own axes. Source: QK, `Translate`.
    pub fn translate(&mut self, x: i32, y: i32, z: i32) {
        self.set_column(3, self.transform_vector(&[x, y, z]));
    }

    /// Turns y towards z about its own x axis. Source: QK, `RotateX`.
    pub fn rotate_x(&mut self, angle: i32) {
        self.rotate(Plane::YToZ, angle);
    }

    /// Turns z towards x about its own y axis. Source: QK, `RotateY`.
    pub fn rotate_y(&mut self, angle: i32) {
        self.rotate(Plane::ZToX, angle);
    }

    /// Turns x towards y about its own z axis. Source: QK, `RotateZ`.
    pub fn rotate_z(&mut self, angle: i32) {
        self.rotate(Plane::XToY, angle);
    }

    fn rotate(&mut self, plane: Plane, angle: i32) {
        let (from, to) = match plane {
            Plane::YToZ => (1, 2),
            Plane::ZToX => (2, 0),
            Plane::XToY => (0, 1),
        };
        let (sine, cosine) = (i64::from(sinus(angle)), i64::from(cosinus(angle)));
        let (a, b) = (self.column(from), self.column(to));
        let mix = |i: usize, x: i64, y: i64| {
            ((i64::from(a[i]) * x + i64::from(b[i]) * y) >> TRIGO_SHIFT) as i32
        };
        self.set_column(from, core::array::from_fn(|i| mix(i, cosine, sine)));
        self.set_column(to, core::array::from_fn(|i| mix(i, -sine, cosine)));
    }

    /// Scales its axes; 256 is 1. Source: QK, `Scale`.
    pub fn scale(&mut self, s: i32) {
        for n in &mut self.m[..9] {
            *n = ((i64::from(*n) * i64::from(s)) >> 8) as i32;
        }
    }

    /// Makes the axes perpendicular unit vectors again, the direction kept.
    /// Many rotations in a row lose that; the document has no remedy.
    pub fn orthonormalize(&mut self) {
        let mut dir = self.dir();
        normalize(&mut dir);
        let mut right = cross(&self.up(), &dir);
        normalize(&mut right);
        self.set_column(0, right);
        self.set_column(1, cross(&dir, &right));
        self.set_column(2, dir);
    }
}

/// The cross product of unit vectors.
fn cross(a: &[i32; 3], b: &[i32; 3]) -> [i32; 3] {
    let part = |i: usize, j: usize| {
        let product = |x: i32, y: i32| i64::from(x) * i64::from(y);
        ((product(a[i], b[j]) - product(a[j], b[i])) >> TRIGO_SHIFT) as i32
    };
    [part(1, 2), part(2, 0), part(0, 1)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::ANGLE2PI;

    const TURN: i32 = ANGLE2PI / 4;

    #[test]
    fn columns_are_the_axes() {
        let mut m = Matrix::identity();
        m.translate(1, 2, 3);
        assert_eq!((m.right(), m.up(), m.dir()), ([16384, 0, 0], [0, 16384, 0], [0, 0, 16384]));
        assert_eq!((m.pos(), m.m[9..].to_vec()), ([1, 2, 3], vec![1, 2, 3]));
        assert_eq!(size_of::<Matrix>(), 48);
    }

    #[test]
    fn quarter_turns() {
        let turned = |turn: fn(&mut Matrix, i32)| {
            let mut m = Matrix::identity();
            turn(&mut m, TURN);
            [[100, 0, 0], [0, 100, 0], [0, 0, 100]].map(|v| m.rotate_vector(&v))
        };
        let (x, y, z) = ([100, 0, 0], [0, 100, 0], [0, 0, 100]);
        let minus = |v: [i32; 3]| v.map(|n: i32| -n);
        assert_eq!(turned(Matrix::rotate_x), [x, z, minus(y)]);
        assert_eq!(turned(Matrix::rotate_y), [minus(z), y, x]);
        assert_eq!(turned(Matrix::rotate_z), [y, minus(x), z]);
    }

    #[test]
    fn operations_are_local() {
        let mut m = Matrix::identity();
        m.translate(10, 0, 0);
        m.rotate_z(TURN);
        m.translate(5, 0, 0);
        assert_eq!(m.pos(), [10, 5, 0]);
        m.scale(512);
        assert_eq!(m.transform_vector(&[1, 0, 0]), [10, 7, 0]);
    }

    #[test]
    fn products_chain() {
        let (mut a, mut b) = (Matrix::identity(), Matrix::identity());
        a.translate(7, -3, 20);
        a.rotate_x(700);
        b.rotate_y(-300);
        b.translate(100, 50, 0);
        let mut c = a;
        c.mult(&b);
        for v in [[1000, 0, 0], [-300, 200, 999], [0, 0, 0]] {
            let (one, two) = (c.transform_vector(&v), a.transform_vector(&b.transform_vector(&v)));
            assert!((0..3).all(|i| (one[i] - two[i]).abs() <= 2), "{one:?} {two:?}");
        }
    }

    #[test]
    fn inverse_rotation_undoes_rotation() {
        let mut m = Matrix::identity();
        m.rotate_x(1234);
        m.rotate_z(-777);
        m.translate(5, 5, 5);
        let v = [1000, -2000, 3000];
        let back = m.inv_rotate_vector(&m.rotate_vector(&v));
        assert!((0..3).all(|i| (back[i] - v[i]).abs() <= 3), "{back:?}");
    }

    #[test]
    fn drift_is_repaired() {
        let mut m = Matrix::identity();
        for i in 0..20_000 {
            m.rotate_x(17 + i % 5);
            m.rotate_y(31);
        }
        m.orthonormalize();
        let dot = |a: [i32; 3], b: [i32; 3]| -> i64 {
            (0..3).map(|i| i64::from(a[i]) * i64::from(b[i])).sum::<i64>() >> TRIGO_SHIFT
        };
        for axis in [m.right(), m.up(), m.dir()] {
            assert!((dot(axis, axis) - 16384).abs() <= 4);
        }
        assert!(dot(m.right(), m.up()).abs() <= 3 && dot(m.up(), m.dir()).abs() <= 3);
        Matrix { m: [i32::MIN; 12] }.orthonormalize();
        Matrix { m: [0; 12] }.orthonormalize();
    }
}
