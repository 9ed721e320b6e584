//! The size of a picture.

use std::fmt;
use std::str::FromStr;

use fillrate_glide::card::{Card, RESOLUTIONS};

/// Columns and rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

/// The longest side that can be drawn.
pub const MAX_SIDE: u32 = 4096;
/// The shortest one: small triangles are placed this far from the edges.
pub const MIN_SIDE: u32 = 128;

impl Size {
    /// A square.
    pub fn square(side: u32) -> Size {
        Size { width: side, height: side }
    }

    /// The number by which a board of the default kind shows it with two
    /// colour buffers and depth; `None` where it cannot.
    pub fn resolution(self) -> Option<i32> {
        let at = RESOLUTIONS.iter().position(|size| *size == (self.width, self.height))?;
        Card::default().holds(at, 3).then_some(at as i32)
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Size, String> {
        let side = |text: &str| {
            let side = text.parse().ok();
            side.filter(|side| (MIN_SIDE..=MAX_SIDE).contains(side))
        };
        text.split_once('x')
            .and_then(|(width, height)| Some(Size { width: side(width)?, height: side(height)? }))
            .ok_or_else(|| {
                format!(
                    "'{text}' is not a size such as 640x480 with sides of {MIN_SIDE} to {MAX_SIDE}"
                )
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes() {
        assert_eq!("640x480".parse(), Ok(Size { width: 640, height: 480 }));
        assert_eq!("640x480".parse::<Size>().unwrap().resolution(), Some(7));
        assert_eq!("4096x4096".parse::<Size>().unwrap().resolution(), None);
        for wrong in ["", "640", "640x", "0x480", "4097x480", "640x480x2"] {
            assert!(wrong.parse::<Size>().is_err(), "{wrong}");
        }
    }
}
