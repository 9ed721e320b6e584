//! Textures: base colours, one byte a texel.

use std::fmt;
use std::sync::Arc;

use fillrate_engine::{Texture as Texels, TextureDesc};

use crate::color::color_rgb;
use crate::error::QuarkError;

/// The longest side of a texture. The document limits those for triangles to
/// 128 and sprites not at all.
pub const MAX_TEXTURE_SIDE: i32 = 2048;

/// The texel that keyed modes leave out.
pub const KEY_TEXEL: u8 = 0;

/// A texture, or a sprite. Immutable; cheap to share.
///
/// Source: QK, `CTexture`.
pub struct Texture {
    width: i32,
    height: i32,
    keyed: bool,
    texels: Vec<u8>,
    engine: Arc<Texels>,
}

impl fmt::Debug for Texture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = if self.keyed { "keyed" } else { "without key" };
        write!(f, "Texture({}x{}, {kind})", self.width, self.height)
    }
}

/// Whether a texture of that size can be used on triangles: powers of two from
/// 16 to 128, not necessarily equal.
pub fn fits_triangles(width: i32, height: i32) -> bool {
    let fits = |side: i32| (16..=128).contains(&side) && side & (side - 1) == 0;
    fits(width) && fits(height)
}

/// Replaces the texels that equal `key` by [`KEY_TEXEL`]; a key outside
/// 0..=255 is none. Returns whether there is a key.
pub fn apply_key(texels: &mut [u8], key: i32) -> bool {
    let Ok(key) = u8::try_from(key) else { return false };
    texels.iter_mut().filter(|texel| **texel == key).for_each(|texel| *texel = KEY_TEXEL);
    true
}

impl Texture {
    /// A texture of `width` x `height` base colours, row by row from the top.
    /// Texels equal to `key` are left out by keyed modes, and so is base
    /// colour 0; with a key outside 0..=255 nothing is left out.
    ///
    /// # Errors
    /// [`QuarkError::Texture`] for sides outside 1..=2048 or too few texels.
    pub fn new(texels: &[u8], width: i32, height: i32, key: i32) -> Result<Texture, QuarkError> {
        let bad = QuarkError::Texture { width, height, given: texels.len() };
        let allowed = 1..=MAX_TEXTURE_SIDE;
        if !allowed.contains(&width) || !allowed.contains(&height) {
            return Err(bad);
        }
        let Some(texels) = texels.get(..(width * height) as usize) else { return Err(bad) };
        let mut texels = texels.to_vec();
        let keyed = apply_key(&mut texels, key);
        Texture::prepared(texels, width, height, keyed)
    }

    /// A texture whose key is already [`KEY_TEXEL`]; the caller has checked
    /// the size.
    pub(crate) fn prepared(
        texels: Vec<u8>,
        width: i32,
        height: i32,
        keyed: bool,
    ) -> Result<Texture, QuarkError> {
        let engine = Arc::new(engine_texture(&texels, width as usize, height as usize)?);
        Ok(Texture { width, height, keyed, texels, engine })
    }

    /// A texture of 24-bit colours, three bytes a texel.
    ///
    /// # Errors
    /// As [`Texture::new`].
    pub fn from_rgb888(
        rgb: &[[u8; 3]],
        width: i32,
        height: i32,
        key: i32,
    ) -> Result<Texture, QuarkError> {
        let texels: Vec<u8> = rgb.iter().map(|&[r, g, b]| color_rgb(r, g, b)).collect();
        Texture::new(&texels, width, height, key)
    }

    /// Texels in a row.
    pub fn width(&self) -> i32 {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> i32 {
        self.height
    }

    /// The base colours, after the key was applied.
    pub fn texels(&self) -> &[u8] {
        &self.texels
    }

    /// Whether keyed modes leave texels out.
    pub fn is_keyed(&self) -> bool {
        self.keyed
    }

    /// Whether triangles can use it.
    pub fn fits_triangles(&self) -> bool {
        fits_triangles(self.width, self.height)
    }

    pub(crate) fn engine(&self) -> &Arc<Texels> {
        &self.engine
    }
}

/// Texels as the engine samples them: in red, and filled up to powers of two
/// with zeros.
fn engine_texture(texels: &[u8], width: usize, height: usize) -> Result<Texels, QuarkError> {
    let bits = |side: usize| side.next_power_of_two().ilog2() as u8;
    let (s_bits, t_bits) = (bits(width), bits(height));
    let desc = TextureDesc { s_bits, t_bits, first: 0, last: 0, clamp_s: false };
    let texture = Texels::build(desc, |_, out| {
        for row in texels.chunks_exact(width) {
            out.extend(row.iter().map(|&texel| u32::from(texel) << 16));
            out.resize(out.len() + (1 << s_bits) - width, 0);
        }
        out.resize(1 << (s_bits + t_bits), 0);
    })?;
    Ok(texture)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_of_triangles() {
        for (size, fits) in [
            ((16, 16), true),
            ((128, 16), true),
            ((8, 16), false),
            ((256, 128), false),
            ((48, 64), false),
            ((0, 16), false),
            ((-16, 16), false),
        ] {
            assert_eq!(fits_triangles(size.0, size.1), fits, "{size:?}");
        }
    }

    #[test]
    fn key_becomes_zero() {
        let texture = Texture::new(&[7, 9, 7, 0], 2, 2, 7).unwrap();
        assert_eq!((texture.texels(), texture.is_keyed()), (&[0, 9, 0, 0][..], true));
        let texture = Texture::new(&[7, 9, 7, 0], 2, 2, -1).unwrap();
        assert_eq!((texture.texels(), texture.is_keyed()), (&[7, 9, 7, 0][..], false));
    }

    #[test]
    fn bad_sizes_are_errors() {
        for (width, height) in [(0, 4), (4, -1), (2049, 1), (3, 3), (i32::MAX, i32::MAX)] {
            assert!(Texture::new(&[1; 8], width, height, 0).is_err());
        }
    }

    #[test]
    fn odd_sizes_keep_their_rows() {
        let texels: Vec<u8> = (1..=15).collect();
        let texture = Texture::new(&texels, 5, 3, -1).unwrap();
        assert_eq!(texture.engine().texel(0, 4, 2), 15 << 16);
        assert_eq!(texture.engine().texel(0, 5, 2), 0);
        assert_eq!(texture.engine().texel(0, 4, 3), 0);
    }
}
