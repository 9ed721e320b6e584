//! Pseudo-float w, depth bias and depth test.
//!
//! Source: SST1, fbzMode register.

use fillrate_engine::state::{DepthSource, DepthState};

use super::pixel::Iterated;

/// The 16-bit pseudo-float of an iterated 1/w: four bits of exponent, twelve
/// of inverted mantissa, plus one. It rises with w.
///
/// Of the iterator, 48 bits count: 0 where 1/w is negative or at least 1.
pub fn float_w(iterator: i64) -> i32 {
    if iterator >> 32 & 0xffff != 0 {
        return 0;
    }
    let low = iterator as u32;
    if low & 0xffff_0000 == 0 {
        return 0xffff;
    }
    let exponent = low.leading_zeros();
    let mantissa = !low >> (19 - exponent) & 0xfff;
    (((exponent << 12) | mantissa) + 1).min(0xffff) as i32
}

/// A 16-bit value plus a bias, limited to 16 bits.
pub fn biased(value: i32, bias: Option<i16>) -> i32 {
    (value + bias.map_or(0, i32::from)).clamp(0, 0xffff)
}

/// The depth of a fragment, with bias.
pub fn of_fragment(state: &DepthState, values: Iterated) -> i32 {
    let value = match state.source {
        DepthSource::Z => values.z,
        DepthSource::FloatW | DepthSource::DeepZ | DepthSource::DeepW => values.w,
    };
    biased(value, values.bias)
}

/// Whether a fragment of this depth passes the test against the aux plane.
pub fn passes(state: &DepthState, depth: i32, aux: u16) -> bool {
    let source = state.compare_constant.map_or(depth, i32::from);
    state.test.is_none_or(|compare| compare.holds(source, i32::from(aux)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn float_w_at_its_corners() {
        assert_eq!(float_w(1 << 32), 0);
        assert_eq!(float_w(-1), 0);
        assert_eq!(float_w(0xffff), 0xffff);
        assert_eq!(float_w(0), 0xffff);
        assert_eq!(float_w(0xffff_ffff), 1);
        assert_eq!(float_w(0x8000_0000), 0x1000);
        assert_eq!(float_w(0x0001_0000), 0xffff);
        // Bits 63..48 are not looked at.
        assert_eq!(float_w(1 << 48 | 0x8000_0000), 0x1000);
    }
}
