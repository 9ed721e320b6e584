use std::ops::{Add, Mul, Neg, Sub};

/// The largest magnitude of a coordinate or attribute that takes part in
/// anything. Products of three such values' sums stay finite, so that no
/// intermediate result overflows.
pub const MAX_MAGNITUDE: f32 = (1_u64 << 60) as f32;

/// A point or direction in three dimensions.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec3 {
    /// To the right.
    pub x: f32,
    /// Up.
    pub y: f32,
    /// Into the screen.
    pub z: f32,
}

/// Whether a value is a number of at most [`MAX_MAGNITUDE`].
pub(crate) fn is_usable(value: f32) -> bool {
    value.abs() <= MAX_MAGNITUDE
}

impl Vec3 {
    /// The origin.
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0);

    /// The vector of three coordinates.
    pub const fn new(x: f32, y: f32, z: f32) -> Self {
        Self { x, y, z }
    }

    /// The inner product, `(x x' + y y') + z z'`.
    pub fn dot(self, other: Self) -> f32 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The outer product: at right angles to both, by the rule of the left hand
    /// in left-handed space.
    pub fn cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }

    /// The length. Squares are taken in `f64`, where none over- or underflows.
    pub fn length(self) -> f32 {
        self.wide_length() as f32
    }

    /// The vector of length 1 in this direction; `None` where there is none.
    pub fn normalized(self) -> Option<Self> {
        let length = self.wide_length();
        if !(self.is_usable() && length > 0.0) {
            return None;
        }
        let unit = |value: f32| (f64::from(value) / length) as f32;
        Some(Self::new(unit(self.x), unit(self.y), unit(self.z)))
    }

    fn wide_length(self) -> f64 {
        let [x, y, z] = [self.x, self.y, self.z].map(f64::from);
        (x * x + y * y + z * z).sqrt()
    }

    /// Whether all coordinates are numbers of at most [`MAX_MAGNITUDE`].
    pub fn is_usable(self) -> bool {
        is_usable(self.x) && is_usable(self.y) && is_usable(self.z)
    }
}

impl Add for Vec3 {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl Sub for Vec3 {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl Mul<f32> for Vec3 {
    type Output = Self;
    fn mul(self, factor: f32) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }
}

impl Neg for Vec3 {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}
