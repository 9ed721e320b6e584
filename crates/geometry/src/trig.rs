//! Sines and tangents. The platform's differ in their last bits, and pixels
//! must not, so these are power series in `f64`, rounded to `f32` once.

use std::f64::consts::{FRAC_PI_2, PI};

/// Sine and cosine of an angle in radians, within one unit of the last place of
/// a value near 1. Angles that are not numbers or beyond 2^20 count as 0.
pub fn sin_cos(angle: f32) -> (f32, f32) {
    let (sine, cosine) = sin_cos_f64(f64::from(angle));
    (sine as f32, cosine as f32)
}

/// Tangent of an angle in radians; the same ranges as [`sin_cos`]. It is huge,
/// not infinite, next to a right angle.
pub fn tan(angle: f32) -> f32 {
    let (sine, cosine) = sin_cos_f64(f64::from(angle));
    (sine / cosine) as f32
}

fn sin_cos_f64(angle: f64) -> (f64, f64) {
    const LARGEST: f64 = 1_048_576.0;
    if angle.is_nan() || angle.abs() > LARGEST {
        return (0.0, 1.0);
    }
    let half_turns = (angle / PI + 0.5).floor();
    let near = angle - half_turns * PI;
    debug_assert!(near.abs() < FRAC_PI_2 + 1e-6);
    let sign = if half_turns % 2.0 == 0.0 { 1.0 } else { -1.0 };
    (sign * series(near, near, 1.0), sign * series(1.0, near, 0.0))
}

/// The alternating power series that starts with `first` of power `power`; 12
/// terms reach the last bits of an `f64` for a quarter turn.
fn series(first: f64, x: f64, power: f64) -> f64 {
    let (mut term, mut sum, mut power) = (first, first, power);
    for _ in 0..12 {
        term = -term * x * x / ((power + 1.0) * (power + 2.0));
        sum += term;
        power += 2.0;
    }
    sum
}
