//! The draw state of the Quark profile: colours of a fixed palette, a base
//! colour and an intensity, with a depth that grows towards the viewer.
//!
//! An element of the colour plane is a base colour in bits 0..7 and an
//! intensity in bits 8..12. The depth plane holds 65535ths of the greatest
//! 1/z, 16 bits.

use std::sync::Arc;

use super::Compare;
use crate::texture::Texture;

/// Bits of a palette colour: base and intensity.
pub const PALETTE_BITS: u32 = 13;

/// How fragments of the Quark profile become pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct PaletteState {
    /// Takes the base colour from the texel, not from the primitive.
    pub texel_color: bool,
    /// Drops fragments whose texel is this.
    pub key: Option<u8>,
    /// Mixes half and half with the pixel that is there.
    pub blend: bool,
    /// Compares the fragment's depth with the stored one.
    pub test: Option<Compare>,
    /// Stores the fragment's depth.
    pub depth_write: bool,
}

impl PaletteState {
    /// Whether the texture is read.
    pub fn reads_texture(&self) -> bool {
        self.texel_color || self.key.is_some()
    }
}

/// The tables of a 50/50 blend: each palette colour in 8-bit channels, and the
/// palette colour for each average.
#[derive(Debug)]
pub struct PaletteBlend {
    /// Red and blue in the halves of the low word, green in the high one.
    pub(crate) channels: Vec<u64>,
    /// Four palette colours each; the index is a 15-bit colour over 4.
    pub(crate) nearest: Vec<u64>,
}

impl PaletteBlend {
    /// Tables from the channels of each 13-bit colour, and the colour to take
    /// for each average, red in bits 14..10, green 9..5, blue 4..0.
    ///
    /// # Panics
    /// Unless `nearest` has 32,768 entries.
    pub fn new(channels: impl Fn(u16) -> [u8; 3], nearest: &[u16]) -> PaletteBlend {
        assert_eq!(nearest.len(), 1 << 15, "one colour for each 15-bit average");
        let widen = |color: u16| {
            let [r, g, b] = channels(color).map(u64::from);
            r | b << 16 | g << 32
        };
        let pack = |four: &[u16; 4]| four.iter().rev().fold(0, |all, &c| all << 16 | u64::from(c));
        PaletteBlend {
            channels: (0..1 << PALETTE_BITS).map(widen).collect(),
            nearest: nearest.as_chunks().0.iter().map(pack).collect(),
        }
    }
}

/// A state with what it refers to. The texel's base colour is the texture's
/// red channel; of its levels the finest is used, repeated in both directions.
#[derive(Clone, Debug, Default)]
pub struct PaletteDraw {
    /// The state.
    pub state: PaletteState,
    /// Read where the state says so; a missing one is all zeros.
    pub texture: Option<Arc<Texture>>,
    /// Read by blending; without it nothing is blended.
    pub blend: Option<Arc<PaletteBlend>>,
}

impl PaletteDraw {
    /// Whether both draw the same, tables and textures being immutable.
    pub(crate) fn same(&self, other: &PaletteDraw) -> bool {
        fn same<T>(a: &Option<Arc<T>>, b: &Option<Arc<T>>) -> bool {
            a.as_ref().map(Arc::as_ptr) == b.as_ref().map(Arc::as_ptr)
        }
        self.state == other.state
            && same(&self.texture, &other.texture)
            && same(&self.blend, &other.blend)
    }
}
