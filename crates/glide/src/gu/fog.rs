//! Fog tables.
//!
//! Source: G246, `guFogGenerate*`.

/// The w of a fog table entry, 0..=63; 1 at entry 0.
pub fn fog_table_w(index: i32) -> f32 {
    let index = index.clamp(0, 63);
    (1u32 << (3 + (index >> 2))) as f32 / (8 - (index & 3)) as f32
}

/// e to the power of `x`, for x of 0 and below; within an ulp or two, and the
/// same on every machine: only sums, products and exact scaling.
fn exp(x: f64) -> f64 {
    if x.is_nan() || x > 0.0 {
        return 1.0;
    }
    if x < -700.0 {
        return 0.0;
    }
    const LN2_HIGH: f64 = f64::from_bits(0x3fe6_2e42_fee0_0000);
    const LN2_LOW: f64 = f64::from_bits(0x3dea_39ef_3579_3c76);
    let n = (x * core::f64::consts::LOG2_E).floor();
    let r = (x - n * LN2_HIGH) - n * LN2_LOW;
    // Taylor's series on 0..ln 2, smallest terms first.
    let mut sum = 1.0;
    for k in (1..=20).rev() {
        sum = 1.0 + sum * r / f64::from(k);
    }
    sum * f64::from_bits(((n as i64 + 1023) as u64) << 52)
}

/// A fraction as a fog amount: limited to 0..=1, times 255, truncated.
fn amount(fraction: f32) -> u8 {
    let limited = if fraction > 0.0 { fraction.min(1.0) } else { 0.0 };
    (limited * 255.0) as u8
}

/// A table of `f(w)` scaled so that the last entry is full fog.
fn scaled(f: impl Fn(f32) -> f32) -> [u8; 64] {
    let last = f(fog_table_w(63));
    core::array::from_fn(|i| amount(f(fog_table_w(i as i32)) / last))
}

/// Exponential fog: 1 - e^(-density * w).
pub fn fog_table_exp(density: f32) -> [u8; 64] {
    scaled(|w| 1.0 - exp(f64::from(-density * w)) as f32)
}

/// Squared exponential fog: 1 - e^(-(density * w)^2).
pub fn fog_table_exp2(density: f32) -> [u8; 64] {
    scaled(|w| 1.0 - exp(f64::from(-(density * w) * (density * w))) as f32)
}

/// Linear fog from `near` (none) to `far` (full).
pub fn fog_table_linear(near: f32, far: f32) -> [u8; 64] {
    core::array::from_fn(|i| amount((fog_table_w(i as i32).min(65535.0) - near) / (far - near)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn w_of_entries() {
        assert_eq!(fog_table_w(0), 1.0);
        assert_eq!(fog_table_w(4), 2.0);
        assert!((fog_table_w(63) - 52428.8).abs() < 0.1);
    }

    #[test]
    fn exp_is_close_to_the_library() {
        for i in 0..20_000 {
            let x = -f64::from(i) * 0.0037;
            let difference = (exp(x) - x.exp()).abs() / x.exp();
            assert!(difference < 1e-14, "{x}: {difference}");
        }
    }

    #[test]
    fn tables_rise_to_full_fog() {
        for table in [fog_table_exp(0.01), fog_table_exp2(0.005), fog_table_linear(2.0, 400.0)] {
            assert!(table.is_sorted());
            assert_eq!((table[0], table[63]), (table[0].min(3), 255));
        }
        assert_eq!(fog_table_exp(f32::NAN), [0; 64]);
    }
}
