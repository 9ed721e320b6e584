//! Packed 32-bit colours and the pipeline's 8-bit arithmetic.
//!
//! A colour word holds red in bits 31-24, green in 23-16, blue in 15-8. The low byte is alpha,
//! light intensity or unused, by context. Source: RAW, section 3.2 and the colour listings.

/// The low byte of a fully opaque colour.
pub const OPAQUE: u32 = 0xff;

/// Packs four channels, each already in 0..=255, with red in the high byte.
pub const fn pack(r: u32, g: u32, b: u32, low: u32) -> u32 {
    (r & 0xff) << 24 | (g & 0xff) << 16 | (b & 0xff) << 8 | (low & 0xff)
}

/// Splits a colour word into red, green, blue and the low byte, each 0..=255.
pub const fn unpack(word: u32) -> [u32; 4] {
    [word >> 24, word >> 16 & 0xff, word >> 8 & 0xff, word & 0xff]
}

/// The low byte of a colour: alpha, intensity or unused.
pub const fn low(word: u32) -> u32 {
    word & 0xff
}

/// Replaces the low byte of a colour.
pub const fn with_low(word: u32, value: u32) -> u32 {
    word & !0xff | value & 0xff
}

/// Multiplies two fractions 0..=255 (0.0 to 1.0), rounding up: `mul(255, a) == a`.
///
/// The result is never above the smaller operand. Source: RAW, fixed-point product.
pub const fn mul(a: u32, b: u32) -> u32 {
    (a * b + 255) >> 8
}

/// Blends every channel: `x` weighted by `k`, `y` by `255 - k`. The sums never exceed 255.
pub fn mix(x: u32, y: u32, k: u32) -> u32 {
    per_channel(x, y, |a, b| mul(a, k) + mul(b, 255 - k))
}

/// Applies `f` to each of the four channels of two colours.
pub fn per_channel(x: u32, y: u32, f: impl Fn(u32, u32) -> u32) -> u32 {
    let (a, b) = (unpack(x), unpack(y));
    pack(f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2]), f(a[3], b[3]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mul_keeps_identity_and_zero() {
        for a in 0..=255 {
            assert_eq!(mul(255, a), a);
            assert_eq!(mul(0, a), 0);
            for b in 0..=255 {
                assert!(mul(a, b) <= a.min(b));
            }
        }
    }

    #[test]
    fn mix_never_overflows_a_channel() {
        for k in 0..=255 {
            for x in 0..=255 {
                for y in [0, 1, 127, 254, 255] {
                    assert!(mul(x, k) + mul(y, 255 - k) <= 255, "{x} {y} {k}");
                }
            }
        }
    }
}
