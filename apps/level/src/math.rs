//! Vectors of three numbers.

/// A point or direction in the level: x east, y north, z up.
pub type Vec3 = [f32; 3];

/// a + b.
pub fn add(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// a - b.
pub fn sub(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// a times a number.
pub fn scale(a: Vec3, by: f32) -> Vec3 {
    a.map(|v| v * by)
}

/// Inner product.
pub fn dot(a: Vec3, b: Vec3) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Outer product.
pub fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Length.
pub fn length(a: Vec3) -> f32 {
    dot(a, a).sqrt()
}

/// Of length one; `otherwise` where there is no direction.
pub fn normalize(a: Vec3, otherwise: Vec3) -> Vec3 {
    let length = length(a);
    if length > 1e-6 { scale(a, 1.0 / length) } else { otherwise }
}

/// From a at 0 to b at 1.
pub fn mix(a: Vec3, b: Vec3, t: f32) -> Vec3 {
    add(a, scale(sub(b, a), t))
}
