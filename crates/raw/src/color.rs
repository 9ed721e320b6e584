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

/// Every other byte of a word: two channels with room for a product each.
const PAIR: u32 = 0x00ff_00ff;

/// Multiplies every channel with the same fraction 0..=255, as [`mul`].
#[inline(always)]
pub const fn scale(word: u32, k: u32) -> u32 {
    // A product and its 255 take at most 16 bits, so two fit into a word.
    let low = ((word & PAIR) * k + PAIR) >> 8 & PAIR;
    let high = ((word >> 8 & PAIR) * k + PAIR) & !PAIR;
    high | low
}

/// Multiplies two colours channel by channel, as [`mul`].
#[inline(always)]
pub fn modulate(x: u32, y: u32) -> u32 {
    per_channel(x, y, mul)
}

/// Adds two colours channel by channel; sums stop at 255.
#[inline(always)]
pub const fn add(x: u32, y: u32) -> u32 {
    let low = (x & PAIR) + (y & PAIR);
    let high = (x >> 8 & PAIR) + (y >> 8 & PAIR);
    saturate(high) << 8 | saturate(low)
}

/// Limits two 9-bit sums to 255.
#[inline(always)]
const fn saturate(sums: u32) -> u32 {
    let over = sums >> 8 & 0x0001_0001;
    (sums | (over * 0xff)) & PAIR
}

/// Blends every channel: `x` weighted by `k`, `y` by `255 - k`. The sums never exceed 255.
#[inline(always)]
pub fn mix(x: u32, y: u32, k: u32) -> u32 {
    scale(x, k) + scale(y, 255 - k)
}

/// Applies `f` to each of the four channels of two colours.
#[inline(always)]
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
    fn words_are_four_channels() {
        for a in 0..=255u32 {
            for k in 0..=255 {
                let (x, y) = (pack(a, 255 - a, a ^ 0x55, 255), pack(k, a, 255, a));
                assert_eq!(scale(x, k), per_channel(x, 0, |c, _| mul(c, k)));
                assert_eq!(add(x, y), per_channel(x, y, |c, d| (c + d).min(255)));
                assert_eq!(mix(x, y, k), per_channel(x, y, |c, d| mul(c, k) + mul(d, 255 - k)));
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
