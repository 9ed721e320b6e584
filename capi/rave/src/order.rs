//! The order of bytes in the program's memory.
//!
//! Pixels, entries of colour tables and depths of 16 and 32 bits are integers of
//! the host. Data of a Macintosh has the high byte first; a variable says where
//! that is so. Calls carry the low byte first, whatever it says, so a recording
//! does not depend on it.

use std::sync::OnceLock;

use fillrate_capture::variable;
use fillrate_rave::PixelType;

/// What of the program's memory has the high byte first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum BigEndian {
    /// Nothing.
    #[default]
    Nothing,
    /// Textures, bitmaps and colour tables.
    Pictures,
    /// These, and devices, buffers and depths.
    Everything,
}

fn parse(text: &str) -> Result<BigEndian, String> {
    match text {
        "0" => Ok(BigEndian::Nothing),
        "pictures" => Ok(BigEndian::Pictures),
        "1" => Ok(BigEndian::Everything),
        _ => Err("it may be 0, 'pictures' or 1".into()),
    }
}

fn big_endian() -> BigEndian {
    static ORDER: OnceLock<BigEndian> = OnceLock::new();
    *ORDER.get_or_init(|| variable("FILLRATE_RAVE_BIG_ENDIAN", parse).unwrap_or_default())
}

/// Bytes of the integers that pixels of a type are.
fn integer(pixel_type: PixelType) -> usize {
    use PixelType::*;
    match pixel_type {
        Rgb32 | Argb32 => 4,
        Rgb16 | Argb16 | Rgb16_565 | Argb16_4444 | Acl16_88 | Ai16_88 => 2,
        // Bits, nibbles, bytes, and groups of bytes in an order of their own.
        Alpha1 | Cl4 | Cl8 | Rgb24 | Rgb8_332 | I8 | Yuvs | Yuvu | Yvyu422 | Uyvy422 => 1,
    }
}

/// How integers lie in some part of the program's memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Order {
    /// Bytes of the integers that are turned round; 1 turns nothing.
    turned: usize,
}

impl Order {
    /// Of pixels of textures and bitmaps.
    pub fn of_pictures(pixel_type: PixelType) -> Order {
        Order::when(big_endian() != BigEndian::Nothing, integer(pixel_type))
    }

    /// Of the entries of colour tables.
    pub fn of_tables() -> Order {
        Order::when(big_endian() != BigEndian::Nothing, 4)
    }

    /// Of the pixels of devices and of the buffers that are drawn to.
    pub fn of_buffers(pixel_type: PixelType) -> Order {
        Order::when(big_endian() == BigEndian::Everything, integer(pixel_type))
    }

    /// Of depths of so many bits.
    pub fn of_depths(bits: u32) -> Order {
        Order::when(big_endian() == BigEndian::Everything, bits as usize / 8)
    }

    /// The high byte first where the program says so, or the host has it first.
    fn when(is_big: bool, bytes: usize) -> Order {
        Order { turned: if is_big || cfg!(target_endian = "big") { bytes } else { 1 } }
    }

    /// Whether the high byte comes first.
    pub fn is_big_endian(self) -> bool {
        self.turned > 1
    }

    /// Whole integers from this order to the calls', or back.
    pub fn turn(self, bytes: &mut [u8]) {
        if self.turned > 1 {
            bytes.chunks_exact_mut(self.turned).for_each(<[u8]>::reverse);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integers_are_turned_and_bytes_are_not() {
        let turned = |pixel_type: PixelType| {
            let mut bytes = [1, 2, 3, 4];
            Order::when(true, integer(pixel_type)).turn(&mut bytes);
            bytes
        };
        assert_eq!(turned(PixelType::Argb32), [4, 3, 2, 1]);
        assert_eq!(turned(PixelType::Rgb16), [2, 1, 4, 3]);
        for same in [PixelType::Cl8, PixelType::Rgb24, PixelType::Yuvs, PixelType::Alpha1] {
            assert_eq!(turned(same), [1, 2, 3, 4]);
        }
        assert_eq!(parse("pictures"), Ok(BigEndian::Pictures));
        assert!(parse("yes").is_err());
    }
}
