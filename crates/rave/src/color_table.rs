//! Colour tables.
//!
//! Source: RAVE, colour tables.

use std::sync::Arc;

use crate::RaveError;
use crate::constants::color_table;
use crate::pixel::PixelType;

/// The entries of a colour table, shared by all that it is bound to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct ColorTable {
    /// 16 or 256 colours, 0xAARRGGBB.
    pub colors: Arc<[u32]>,
}

impl ColorTable {
    /// Copies a table; entries 0x00RRGGBB, the low byte first. Where
    /// `transparent_index` is not 0, index 0 is transparent.
    ///
    /// # Errors
    /// [`RaveError::Parameter`] for an unknown type or too few entries.
    pub fn new(
        table_type: u32,
        entries: &[u8],
        transparent_index: i32,
    ) -> Result<ColorTable, RaveError> {
        let count = match table_type {
            color_table::CL8_RGB32 => 256,
            color_table::CL4_RGB32 => 16,
            _ => return Err(RaveError::Parameter),
        };
        let entries = entries.as_chunks::<4>().0.get(..count).ok_or(RaveError::Parameter)?;
        let opaque = |entry: &[u8; 4]| u32::from_le_bytes(*entry) | 0xff00_0000;
        let mut colors: Vec<u32> = entries.iter().map(opaque).collect();
        if transparent_index != 0 {
            colors[0] &= 0x00ff_ffff;
        }
        Ok(ColorTable { colors: colors.into() })
    }

    /// Whether pixels of this type index it.
    pub fn fits(&self, pixel_type: PixelType) -> bool {
        match pixel_type {
            PixelType::Cl4 => self.colors.len() == 16,
            PixelType::Cl8 | PixelType::Acl16_88 => self.colors.len() == 256,
            _ => false,
        }
    }
}
