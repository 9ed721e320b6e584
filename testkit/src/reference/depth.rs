//! Pseudo-float w, depth bias and depth test.
//!
//! Source: SST1, fbzMode register.

use fillrate_engine::state::{DepthSource, DepthState, ZOverflow};
use fillrate_engine::{PixelFormat, Registers};

use super::iterate::wide;
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

/// The depth of a deep source: the integer part of its iterator, or the upper
/// half of the bits of 1/w as a float.
pub fn deep(source: DepthSource, centred: &Registers, x: u32, y: u32) -> u32 {
    let value = match source {
        DepthSource::DeepZ => wide(centred, &centred.deep_z, x, y),
        _ => wide(centred, &centred.w, x, y),
    };
    match (source, value) {
        (_, ..=0) => 0,
        (DepthSource::DeepZ, value) => (value >> 32) as u32,
        (_, value) => ((value as f64).to_bits() >> 32) as u32,
    }
}

/// Whether a plane can hold depths of a source.
pub fn fits(source: DepthSource, aux: Option<PixelFormat>) -> bool {
    !source.is_deep() || aux == Some(PixelFormat::Aux32)
}

/// The depth of a fragment, with bias where there is one.
pub fn of_fragment(state: &DepthState, values: Iterated) -> u32 {
    match state.source {
        DepthSource::Z => biased(values.z, values.bias) as u32,
        DepthSource::FloatW => biased(values.w, values.bias) as u32,
        DepthSource::DeepZ | DepthSource::DeepW => values.deep,
    }
}

/// Whether a fragment is dropped for its z.
pub fn is_rejected(state: &DepthState, values: Iterated) -> bool {
    let looks = state.z_overflow == ZOverflow::Reject && state.source == DepthSource::Z;
    looks && values.is_outside
}

/// Whether a fragment of this depth passes the test against the aux plane.
pub fn passes(state: &DepthState, depth: u32, aux: u32) -> bool {
    let constant = state.compare_constant.filter(|_| !state.source.is_deep());
    let source = constant.map_or(depth, u32::from);
    state.test.is_none_or(|compare| compare.holds(source, aux))
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
