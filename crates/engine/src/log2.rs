//! Base-2 logarithms with eight fraction bits, exactly.
//!
//! `log2_8(v)` is floor(256 * log2(v)). It is decided by comparing mantissas
//! with the 256 thresholds 2^(k/256), so that no approximation of any machine
//! enters, and a threshold can be handed to vector code to compare with.

/// Bits of a threshold after its leading one.
const MANTISSA: u32 = 52;

/// ceil(2^52 * 2^(k/256)) for k of 0..=255.
static THRESHOLDS: [u64; 256] = thresholds();

/// Integer square root of a 126-bit number.
const fn isqrt(value: u128) -> u128 {
    let mut root = 0u128;
    let mut bit = 1u128 << 62;
    while bit != 0 {
        let next = root | bit;
        if next * next <= value {
            root = next;
        }
        bit >>= 1;
    }
    root
}

/// Products of the roots 2^(1/2), 2^(1/4), ... 2^(1/256), 62 fraction bits.
const fn thresholds() -> [u64; 256] {
    let mut roots = [0u128; 8];
    let mut previous = 2u128 << 61;
    let mut i = 0;
    while i < 8 {
        // sqrt(p * 2^61 * 2^61) keeps 61 fraction bits.
        previous = isqrt(previous << 61);
        roots[i] = previous;
        i += 1;
    }
    let mut table = [0u64; 256];
    let mut k = 0;
    while k < 256 {
        let mut product = 1u128 << 61;
        let mut bit = 0;
        while bit < 8 {
            if k >> (7 - bit) & 1 != 0 {
                product = (product * roots[bit]) >> 61;
            }
            bit += 1;
        }
        let drop = 61 - MANTISSA;
        table[k] = ((product + (1 << drop) - 1) >> drop) as u64;
        k += 1;
    }
    table
}

/// floor(256 * log2(value)) for a positive normal float.
#[inline(always)]
pub(crate) fn log2_8(value: f64) -> i32 {
    let bits = value.to_bits();
    let exponent = (bits >> MANTISSA & 0x7ff) as i32 - 1023;
    let mantissa = bits & ((1 << MANTISSA) - 1) | 1 << MANTISSA;
    exponent * 256 + fraction(mantissa)
}

/// floor(256 * log2(value)) for a positive integer of any size.
pub(crate) fn log2_8_int(value: u64) -> i32 {
    let exponent = 63 - value.leading_zeros();
    let mantissa = if exponent > MANTISSA {
        // Below a threshold or not is decided by the first 53 bits: no
        // threshold but the first is an integer.
        value >> (exponent - MANTISSA)
    } else {
        value << (MANTISSA - exponent)
    };
    exponent as i32 * 256 + fraction(mantissa)
}

/// The greatest k whose threshold is not above the mantissa that has `i` in
/// the eight bits after its leading one and zeros behind them.
static REACHED: [u8; 256] = {
    let mut table = [0; 256];
    let mut i = 0;
    let mut k = 0;
    while i < 256 {
        let mantissa = (256 + i as u64) << (MANTISSA - 8);
        while k < 255 && THRESHOLDS[k + 1] <= mantissa {
            k += 1;
        }
        table[i] = k as u8;
        i += 1;
    }
    table
};

/// How many thresholds after the first a mantissa reaches.
#[inline(always)]
fn fraction(mantissa: u64) -> i32 {
    let mut k = usize::from(REACHED[(mantissa >> (MANTISSA - 8)) as usize & 255]);
    // The curve rises by at most 1.45 thresholds in an eighth bit.
    for _ in 0..2 {
        let next = THRESHOLDS.get(k + 1).copied().unwrap_or(u64::MAX);
        k += usize::from(next <= mantissa);
    }
    k as i32
}

/// The smallest real that has `log2_8` of at least `log`; exact as a float.
/// Exponents outside a float's range are limited to it.
pub(crate) fn smallest_with_log2_8(log: i32) -> f64 {
    let exponent = ((log >> 8) + 1023).clamp(1, 2046) as u64;
    let mantissa = THRESHOLDS[(log & 255) as usize] & ((1 << MANTISSA) - 1);
    f64::from_bits(exponent << MANTISSA | mantissa)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thresholds_are_powers_of_two() {
        assert_eq!(THRESHOLDS[0], 1 << 52);
        for (k, &threshold) in THRESHOLDS.iter().enumerate() {
            let expected = (k as f64 / 256.0).exp2() * (1u64 << 52) as f64;
            assert!((threshold as f64 - expected).abs() <= 2.0, "{k}");
        }
        // 2^(1/2) = 1.41421356237309504880...
        assert_eq!(THRESHOLDS[128], 6_369_051_672_525_773);
    }

    #[test]
    fn a_fraction_counts_the_thresholds_reached() {
        let counted = |m: u64| THRESHOLDS.iter().filter(|&&t| t <= m).count() as i32 - 1;
        for &threshold in &THRESHOLDS {
            for mantissa in [threshold, threshold + 1, threshold.max((1 << 52) + 1) - 1] {
                assert_eq!(fraction(mantissa), counted(mantissa), "{mantissa:#x}");
            }
        }
        for i in 0..4096u64 {
            for mantissa in [1 << 52 | i << 40, 1 << 52 | i << 40 | ((1 << 40) - 1)] {
                assert_eq!(fraction(mantissa), counted(mantissa), "{mantissa:#x}");
            }
        }
    }

    #[test]
    fn logarithms_of_known_values() {
        assert_eq!(log2_8(1.0), 0);
        assert_eq!(log2_8(2.0f64.powi(40)), 40 * 256);
        assert_eq!(log2_8(0.5), -256);
        assert_eq!(log2_8(3.0), 405);
        assert_eq!(log2_8_int(3), 405);
        assert_eq!(log2_8_int(u64::MAX), 64 * 256 - 1);
        assert_eq!(log2_8_int(1 << 63), 63 * 256);
    }

    #[test]
    fn the_smallest_value_of_a_logarithm() {
        for log in -600..9000 {
            let value = smallest_with_log2_8(log);
            assert_eq!(log2_8(value), log);
            assert_eq!(log2_8(f64::from_bits(value.to_bits() - 1)), log - 1);
        }
    }
}
