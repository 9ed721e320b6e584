//! Exact binary logarithms with 8 fraction bits.
//!
//! floor(256 * log2(v)) is decided by comparing the mantissa's 256th power
//! with powers of two, in exact integers; no floating-point function has a
//! say. Values to check other tables with (2^52 times the 256ths powers of
//! two, rounded up):
//!
//! | k | ceil(2^52 * 2^(k/256)) |
//! |---|---|
//! | 1 | 4515810124676287 |
//! | 32 | 4911210218475899 |
//! | 64 | 5355712719992598 |
//! | 100 | 5904044423720103 |
//! | 128 | 6369051672525773 |
//! | 192 | 7574121564787630 |
//! | 213 | 8017263140063539 |
//! | 255 | 8982844293129178 |

use std::sync::OnceLock;

/// floor(256 * log2(value)); `value` must not be 0.
pub fn log2_8_u64(value: u64) -> i32 {
    let zeros = value.leading_zeros();
    256 * (63 - zeros as i32) + fraction(value << zeros)
}

/// floor(256 * log2(value)) of a positive, normal value.
pub fn log2_8_f64(value: f64) -> i32 {
    let bits = value.to_bits();
    let exponent = (bits >> 52) as i32 - 1023;
    256 * exponent + fraction((bits << 11) | 1 << 63)
}

/// How many 256ths of an octave a mantissa with its highest bit set reaches.
fn fraction(mantissa: u64) -> i32 {
    static THRESHOLDS: OnceLock<Vec<u64>> = OnceLock::new();
    let thresholds = THRESHOLDS.get_or_init(|| (1..=255).map(threshold).collect());
    thresholds.partition_point(|&threshold| threshold <= mantissa) as i32
}

/// ceil(2^63 * 2^(k/256)), k in 1..=255.
fn threshold(k: u32) -> u64 {
    // An estimate, and a bracket far wider than its error, save most of the
    // 64 halvings; the bracket is checked, so the estimate decides nothing.
    let estimate = (f64::from(k) / 256.0).exp2() * 2f64.powi(63);
    let (mut below, mut reached) = (estimate as u64 - (1 << 14), estimate as u64 + (1 << 14));
    assert!(!reaches(below, k) && reaches(reached, k), "the estimate is close");
    while reached - below > 1 {
        let middle = below + (reached - below) / 2;
        match reaches(middle, k) {
            true => reached = middle,
            false => below = middle,
        }
    }
    reached
}

/// Whether mantissa / 2^63 >= 2^(k/256): whether mantissa^256 >= 2^(k + 63 *
/// 256), that is, has more bits than the exponent.
fn reaches(mantissa: u64, k: u32) -> bool {
    let mut power = vec![mantissa];
    for _ in 0..8 {
        power = square(&power);
    }
    bits(&power) > k + 63 * 256
}

/// The square of a number of 64-bit digits, lowest first.
fn square(number: &[u64]) -> Vec<u64> {
    let mut out = vec![0u64; 2 * number.len()];
    for (i, &a) in number.iter().enumerate() {
        let mut carry = 0u128;
        for (j, &b) in number.iter().enumerate() {
            let sum = u128::from(a) * u128::from(b) + u128::from(out[i + j]) + carry;
            out[i + j] = sum as u64;
            carry = sum >> 64;
        }
        out[i + number.len()] = carry as u64;
    }
    out
}

/// Bits up to the highest set one.
fn bits(number: &[u64]) -> u32 {
    let top = number.iter().rposition(|&digit| digit != 0).unwrap_or(0);
    64 * top as u32 + 64 - number[top].leading_zeros()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_two_and_their_neighbours() {
        for exponent in 1..64 {
            let value = 1u64 << exponent;
            assert_eq!(log2_8_u64(value), 256 * exponent);
            assert!(log2_8_u64(value - 1) < 256 * exponent);
        }
        assert_eq!(log2_8_u64(3), 405);
        assert_eq!(log2_8_f64(3.0), 405);
        assert_eq!(log2_8_f64(0.75), 405 - 512);
        assert_eq!(log2_8_f64(1.0), 0);
    }

    #[test]
    fn both_forms_agree() {
        for i in 1..5000u64 {
            let value = i * i * i * 7919;
            assert_eq!(log2_8_u64(value), log2_8_f64(value as f64));
        }
    }

    /// The values of the module's table.
    #[test]
    fn spot_values() {
        let spots = [
            (1, 4_515_810_124_676_287),
            (32, 4_911_210_218_475_899),
            (64, 5_355_712_719_992_598),
            (100, 5_904_044_423_720_103),
            (128, 6_369_051_672_525_773),
            (192, 7_574_121_564_787_630),
            (213, 8_017_263_140_063_539),
            (255, 8_982_844_293_129_178),
        ];
        for (k, expected) in spots {
            assert_eq!(threshold(k).div_ceil(1 << 11), expected, "k = {k}");
        }
    }
}
