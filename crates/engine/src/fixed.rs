//! The chips' number formats, and the conversions into them.
//!
//! All roundings from floating point live here. Not-a-number becomes 0 and
//! values out of range wrap like the low bits of an infinitely wide integer,
//! so that every input gives one fixed result on every machine.

/// Fraction bits of vertex coordinates (12.4).
pub const COORD_FRACTION: u32 = 4;
/// Fraction bits of iterated colours (12.12).
pub const COLOR_FRACTION: u32 = 12;
/// Fraction bits of iterated depth (20.12).
pub const DEPTH_FRACTION: u32 = 12;
/// Fraction bits of the s, t and w iterators.
pub const WIDE_FRACTION: u32 = 32;

/// `value * 2^fraction`, truncated toward zero, as the low 64 bits of the
/// exact integer. Not-a-number and infinities give 0.
pub fn truncate(value: f32, fraction: u32) -> i64 {
    // Exact: an f32 has 24 significant bits and the product is only scaled.
    let scaled = f64::from(value) * (1u64 << fraction) as f64;
    if !scaled.is_finite() {
        return 0;
    }
    if scaled.abs() < 9.0e18 {
        return scaled as i64;
    }
    // At least 2^62, hence a multiple of 2^38: the low 64 bits of the integer
    // are its mantissa shifted left.
    let bits = scaled.to_bits();
    let mantissa = (bits & ((1 << 52) - 1)) | 1 << 52;
    let shift = ((bits >> 52) & 0x7ff) as u32 - 1075;
    let magnitude = mantissa.checked_shl(shift).unwrap_or(0) as i64;
    if scaled < 0.0 { magnitude.wrapping_neg() } else { magnitude }
}

/// A screen coordinate in pixels as signed 12.4: truncated toward zero, then
/// the low 16 bits, sign-extended. Adding 3 * 2^18 to a coordinate therefore
/// rounds it to a sixteenth and vanishes.
///
/// Source: G246, triangle set-up.
pub fn coord(value: f32) -> i32 {
    i32::from(truncate(value, COORD_FRACTION) as i16)
}

/// A colour or alpha value (0..255) or its gradient, 12.12.
pub fn color(value: f32) -> i32 {
    truncate(value, COLOR_FRACTION) as i32
}

/// A depth value (0..65535) or its gradient, 20.12.
pub fn depth(value: f32) -> i32 {
    truncate(value, DEPTH_FRACTION) as i32
}

/// s/w, t/w or 1/w, or a gradient of one, with 32 fraction bits.
pub fn wide(value: f32) -> i64 {
    truncate(value, WIDE_FRACTION)
}

/// [`coord`] of several values at once.
#[inline(always)]
pub(crate) fn coordinates<const N: usize>(values: [f32; N]) -> [i32; N] {
    let mut out = scaled(values, COORD_FRACTION, coord);
    for out in &mut out {
        *out = (*out << 16) >> 16;
    }
    out
}

/// [`color`] and [`depth`], which are the same, of several values at once.
#[inline(always)]
pub(crate) fn twelve_bits<const N: usize>(values: [f32; N]) -> [i32; N] {
    scaled(values, COLOR_FRACTION, color)
}

/// `value * 2^fraction`, truncated toward zero, of several values at once; by
/// `one` where 32 bits do not hold all of them.
#[inline(always)]
fn scaled<const N: usize>(values: [f32; N], fraction: u32, one: fn(f32) -> i32) -> [i32; N] {
    let (mut products, mut out) = ([0.0; N], [0; N]);
    let mut fits = true;
    for (product, value) in products.iter_mut().zip(values) {
        // A product with a power of two is exact.
        *product = value * (1u32 << fraction) as f32;
        fits &= product.abs() < FITS_I32;
    }
    if !fits {
        return values.map(one);
    }
    let (fours, rest) = products.as_chunks();
    let (fours_out, rest_out) = out.as_chunks_mut();
    for (out, four) in fours_out.iter_mut().zip(fours) {
        *out = fillrate_simd::truncate(*four);
    }
    for (out, value) in rest_out.iter_mut().zip(rest) {
        *out = *value as i32;
    }
    out
}

/// Floats below it in magnitude hold every integer, with room for sums.
const WIDE_LIMIT: f64 = (1u64 << 51) as f64;

/// [`wide`] of several values at once, as floats; not-a-number where it is 2^51 or
/// more in magnitude.
#[inline(always)]
pub(crate) fn wide_floats<const N: usize>(values: [f32; N]) -> [f64; N] {
    truncated(values.map(|value| f64::from(value) * (1u64 << WIDE_FRACTION) as f64))
}

/// Values truncated toward zero; not-a-number where they are 2^51 or more in
/// magnitude.
#[inline(always)]
pub(crate) fn truncated<const N: usize>(values: [f64; N]) -> [f64; N] {
    // Added to a float below 2^52 this leaves no fraction.
    const TO_INTEGER: f64 = (1u64 << 52) as f64;
    let mut out = [0.0; N];
    for (out, value) in out.iter_mut().zip(values) {
        let magnitude = value.abs();
        // To the nearest integer, then down where that was up.
        let nearest = (magnitude + TO_INTEGER) - TO_INTEGER;
        let below = if nearest > magnitude { nearest - 1.0 } else { nearest };
        *out = if magnitude < WIDE_LIMIT { below.copysign(value) } else { f64::NAN };
    }
    out
}

/// An integer as a float; not-a-number where it is 2^51 or more in magnitude.
#[inline(always)]
pub(crate) fn to_float(value: i64) -> f64 {
    let float = value as f64;
    if float.abs() < WIDE_LIMIT { float } else { f64::NAN }
}

/// Floats below it in magnitude truncate to an `i32`.
pub(crate) const FITS_I32: f32 = 2_147_483_648.0;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lanes_convert_like_single_values() {
        let mut values = vec![0.0, -0.0, 1.0, -1.0, 0.5, -0.5, 1.99, f32::NAN, f32::INFINITY];
        values.extend([f32::MAX, f32::MIN_POSITIVE, 2e9, -3e9, 1048575.9, 1048576.0, 786442.5]);
        let mut seed = 1u32;
        for _ in 0..50_000 {
            seed = seed.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            values.push(f32::from_bits(seed));
            values.push((seed >> 8) as f32 / 65536.0 - 100.0);
        }
        for four in values.as_chunks::<4>().0 {
            assert_eq!(coordinates(*four), four.map(coord), "{four:?}");
            assert_eq!(twelve_bits(*four), four.map(color), "{four:?}");
            assert_eq!(twelve_bits(*four), four.map(depth), "{four:?}");
        }
        for one in values {
            let ([float], integer) = (wide_floats([one]), wide(one));
            let fits = f64::from(one).abs() < WIDE_LIMIT / (1u64 << 32) as f64;
            assert!(if fits { (float as i64) == integer } else { float.is_nan() }, "{one}");
            assert!(to_float(integer).is_nan() || (to_float(integer) as i64) == integer);
            assert_eq!(twelve_bits([one]), [color(one)], "{one}");
        }
    }

    #[test]
    fn coord_truncates_toward_zero_and_wraps() {
        assert_eq!(coord(1.99), 31);
        assert_eq!(coord(-1.99), -31);
        assert_eq!(coord(786_432.0 + 10.5), 168);
        assert_eq!(coord(786_432.0 - 10.5), -168);
        assert_eq!(coord(2048.0), -32768);
        assert_eq!(coord(f32::NAN), 0);
        assert_eq!(coord(f32::INFINITY), 0);
    }

    #[test]
    fn huge_values_keep_their_low_bits() {
        assert_eq!(truncate(18_446_744_073_709_551_616.0, 0), 0);
        assert_eq!(truncate(9_223_372_036_854_775_808.0, 0), i64::MIN);
        assert_eq!(truncate(-9_223_372_036_854_775_808.0 * 1.5, 0), 1 << 62);
        assert_eq!(truncate(f32::MAX, 32), 0);
    }
}
