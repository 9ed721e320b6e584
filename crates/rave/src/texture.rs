//! Textures and bitmaps: the program's pictures, and what the engine samples.
//!
//! Source: RAVE, textures and bitmaps.

use std::sync::Arc;

use fillrate_engine::{Texture as Texels, TextureDesc};

use crate::RaveError;
use crate::color_table::ColorTable;
use crate::constants::texture;
use crate::handle::DrawContextId;
use crate::image::Image;
use crate::memory::ResourceId;
use crate::pixel::PixelType;
use crate::vertex::ImageValue;

/// Where the pixels of a picture come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Source {
    /// The program.
    Program,
    /// A draw context.
    Context(DrawContextId),
}

/// How a picture is decoded for the sampler.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Decoding {
    /// The last column's right neighbour is itself.
    pub clamp: bool,
    /// Texels of this colour, 0x00RRGGBB, are dropped.
    pub key: Option<u32>,
    /// What lies around the texture, 0xAARRGGBB; without one its last texels go on.
    pub border: Option<u32>,
}

/// Texels as the engine samples them.
#[derive(Clone, Debug)]
pub(crate) struct Decoded {
    pub decoding: Decoding,
    pub texels: Arc<Texels>,
    /// Every texel's alpha is 255, and the border's.
    pub opaque: bool,
}

/// A texture, or a bitmap: one level of any size.
#[derive(Debug)]
pub(crate) struct Picture {
    pub flags: u32,
    pub pixel_type: PixelType,
    /// The largest first.
    pub levels: Vec<Image>,
    pub table: Option<ColorTable>,
    pub source: Source,
    /// Its place in the books of the texture memory.
    pub resource: Option<ResourceId>,
    /// The level that the program has access to.
    pub accessed: Option<usize>,
    /// The context that it is made from has drawn since.
    pub is_stale: bool,
    is_bitmap: bool,
    /// The two decodings used last.
    decoded: Vec<Decoded>,
}

/// Decodings that are kept.
const KEPT: usize = 2;

impl Picture {
    /// Takes a texture's images.
    ///
    /// # Errors
    /// [`RaveError::Parameter`] for images that are no chain of powers of two,
    /// and the errors of [`Image::new`].
    pub fn texture(
        flags: u32,
        pixel_type: PixelType,
        images: &[ImageValue],
    ) -> Result<Picture, RaveError> {
        let levels = texture_levels(flags, pixel_type, images)?;
        Ok(Picture::new(flags, pixel_type, levels, false))
    }

    /// Takes a bitmap's image.
    ///
    /// # Errors
    /// Those of [`Image::new`].
    pub fn bitmap(
        flags: u32,
        pixel_type: PixelType,
        image: &ImageValue,
    ) -> Result<Picture, RaveError> {
        Ok(Picture::new(flags, pixel_type, vec![Image::new(image, pixel_type)?], true))
    }

    fn new(flags: u32, pixel_type: PixelType, levels: Vec<Image>, is_bitmap: bool) -> Picture {
        Picture {
            flags,
            pixel_type,
            levels,
            table: None,
            source: Source::Program,
            resource: None,
            accessed: None,
            is_stale: false,
            is_bitmap,
            decoded: Vec::new(),
        }
    }

    /// Replaces the images of a texture.
    ///
    /// # Errors
    /// Those of [`Picture::texture`]; the old ones stay.
    pub fn replace(
        &mut self,
        flags: u32,
        pixel_type: PixelType,
        images: &[ImageValue],
    ) -> Result<(), RaveError> {
        self.levels = if self.is_bitmap {
            let image = images.first().ok_or(RaveError::Parameter)?;
            vec![Image::new(image, pixel_type)?]
        } else {
            texture_levels(flags, pixel_type, images)?
        };
        (self.flags, self.pixel_type) = (flags, pixel_type);
        self.changed();
        Ok(())
    }

    /// Bytes of all levels, as the program gave them.
    pub fn bytes(&self) -> u64 {
        self.levels.iter().map(|level| level.bytes(self.pixel_type) as u64).sum()
    }

    /// Columns and rows of the largest level.
    pub fn size(&self) -> (u32, u32) {
        (self.levels[0].width, self.levels[0].height)
    }

    /// Whether the rows are stored bottom first.
    pub fn is_flipped(&self) -> bool {
        self.flags & texture::FLIP_ORIGIN != 0
    }

    /// Binds a colour table.
    ///
    /// # Errors
    /// [`RaveError::Parameter`] where the pixels do not index such a table.
    pub fn bind(&mut self, table: &ColorTable) -> Result<(), RaveError> {
        if !table.fits(self.pixel_type) {
            return Err(RaveError::Parameter);
        }
        self.table = Some(table.clone());
        self.changed();
        Ok(())
    }

    /// Forgets what was decoded.
    pub fn changed(&mut self) {
        self.decoded.clear();
    }

    /// The picture for the sampler.
    pub fn decoded(&mut self, decoding: Decoding) -> &Decoded {
        match self.decoded.iter().position(|decoded| decoded.decoding == decoding) {
            Some(0) => {}
            Some(at) => self.decoded.swap(0, at),
            None => {
                let decoded = self.decode(decoding);
                self.decoded.truncate(KEPT - 1);
                self.decoded.insert(0, decoded);
            }
        }
        &self.decoded[0]
    }

    fn decode(&self, decoding: Decoding) -> Decoded {
        let table = self.table.as_ref().map(|table| &*table.colors);
        let (width, height) = self.size();
        let bits = |side: u32| side.next_power_of_two().trailing_zeros() as u8;
        let desc = TextureDesc {
            s_bits: bits(width),
            t_bits: bits(height),
            first: 0,
            last: (self.levels.len() - 1) as u8,
            clamp_s: decoding.clamp,
        };
        let mut opaque = decoding.border.is_none_or(|argb| argb >> 24 == 255);
        let mut keyed: Vec<Vec<bool>> = Vec::new();
        let fill = |level: u8, out: &mut Vec<u32>| {
            let image = &self.levels[usize::from(level)];
            if self.is_bitmap {
                self.decode_padded(image, table, out);
            } else {
                image.decode(self.pixel_type, table, out);
            }
            opaque &= out.iter().all(|argb| argb >> 24 == 255);
            if let Some(key) = decoding.key {
                keyed.push(out.iter().map(|&argb| self.is_key(argb, key)).collect());
            }
        };
        let texels = match decoding.border {
            Some(border) => Texels::build_bordered(desc, border, fill),
            None => Texels::build(desc, fill),
        };
        let mut texels = texels.expect("sides and levels were checked when the images were taken");
        if decoding.key.is_some() {
            texels = texels.with_key(|level, column, row| {
                let width = (1u32 << desc.s_bits >> level).max(1);
                keyed[usize::from(level)][(row * width + column) as usize]
            });
        }
        Decoded { decoding, texels: Arc::new(texels), opaque }
    }

    /// The picture in a power of two, its last column and row repeated.
    fn decode_padded(&self, image: &Image, table: Option<&[u32]>, out: &mut Vec<u32>) {
        let mut pixels = Vec::new();
        image.decode(self.pixel_type, table, &mut pixels);
        let padded = image.width.next_power_of_two() as usize;
        for row in pixels.chunks_exact(image.width as usize) {
            out.extend_from_slice(row);
            out.extend(std::iter::repeat_n(row[row.len() - 1], padded - row.len()));
        }
        let last = out.len() - padded;
        for _ in image.height..image.height.next_power_of_two() {
            out.extend_from_within(last..last + padded);
        }
    }

    /// Whether a colour is the key at the depth of this picture's channels.
    fn is_key(&self, argb: u32, key: u32) -> bool {
        let [r, g, b] = channel_bits(self.pixel_type).map(|bits| 0xff00u32 >> bits & 0xff);
        (argb ^ key) & (r << 16 | g << 8 | b) == 0
    }

    /// The level that `QAAccessTexture` opens.
    ///
    /// # Errors
    /// [`RaveError::Parameter`] where there is none, or another is open.
    pub fn access(&mut self, level: i32) -> Result<(), RaveError> {
        let level = usize::try_from(level).map_err(|_| RaveError::Parameter)?;
        if level >= self.levels.len() || self.accessed.is_some() {
            return Err(RaveError::Parameter);
        }
        self.accessed = Some(level);
        Ok(())
    }

    /// Ends an access. `pixels` are the rows of a rectangle; none where nothing
    /// was written.
    ///
    /// # Errors
    /// [`RaveError::Parameter`] without an access, and those of [`Image::write`].
    pub fn access_end(&mut self, rect: [u32; 4], pixels: &[u8]) -> Result<(), RaveError> {
        let level = self.accessed.take().ok_or(RaveError::Parameter)?;
        if pixels.is_empty() {
            return Ok(());
        }
        self.levels[level].write(self.pixel_type, rect, pixels)?;
        self.changed();
        Ok(())
    }
}

/// A texture's levels, each half the one before and down to one texel where
/// the flags say mip-map.
fn texture_levels(
    flags: u32,
    pixel_type: PixelType,
    images: &[ImageValue],
) -> Result<Vec<Image>, RaveError> {
    let first = Image::new(images.first().ok_or(RaveError::Parameter)?, pixel_type)?;
    if !first.width.is_power_of_two() || !first.height.is_power_of_two() {
        return Err(RaveError::Parameter);
    }
    let (width, height) = (first.width, first.height);
    let mut levels = vec![first];
    if flags & texture::MIPMAP == 0 {
        return Ok(levels);
    }
    for level in 1..=width.max(height).ilog2() {
        let image = images.get(level as usize).ok_or(RaveError::Parameter)?;
        let image = Image::new(image, pixel_type)?;
        if (image.width, image.height) != ((width >> level).max(1), (height >> level).max(1)) {
            return Err(RaveError::Parameter);
        }
        levels.push(image);
    }
    Ok(levels)
}

/// Bits of red, green and blue that a pixel type holds.
fn channel_bits(pixel_type: PixelType) -> [u32; 3] {
    match pixel_type {
        PixelType::Rgb16 | PixelType::Argb16 => [5, 5, 5],
        PixelType::Rgb16_565 => [5, 6, 5],
        PixelType::Rgb8_332 => [3, 3, 2],
        PixelType::Argb16_4444 => [4, 4, 4],
        _ => [8, 8, 8],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image(width: i32, height: i32, argb: &[u32]) -> ImageValue {
        let pixels: Vec<u8> = argb.iter().flat_map(|p| p.to_le_bytes()).collect();
        ImageValue { width, height, pixels: pixels.into() }
    }

    #[test]
    fn a_chain_goes_down_to_one_texel() {
        let chain = [image(4, 2, &[1; 8]), image(2, 1, &[2; 2]), image(1, 1, &[3])];
        let texture = |images| Picture::texture(texture::MIPMAP, PixelType::Argb32, images);
        assert_eq!(texture(&chain).unwrap().levels.len(), 3);
        assert_eq!(texture(&chain[..2]).unwrap_err(), RaveError::Parameter);
        let wrong = [chain[0].clone(), chain[0].clone(), chain[2].clone()];
        assert_eq!(texture(&wrong).unwrap_err(), RaveError::Parameter);
        let odd = [image(3, 2, &[1; 6])];
        let plain = Picture::texture(0, PixelType::Argb32, &odd);
        assert_eq!(plain.unwrap_err(), RaveError::Parameter);
    }

    #[test]
    fn bitmaps_are_padded_by_their_edges() {
        let mut bitmap =
            Picture::bitmap(0, PixelType::Argb32, &image(3, 1, &[1, 2, 0xff00_0003])).unwrap();
        let decoded = bitmap.decoded(Decoding { clamp: true, key: None, border: None });
        assert!(!decoded.opaque);
        assert_eq!(
            [0, 1, 2, 3].map(|x| decoded.texels.texel(0, x, 0)),
            [1, 2, 0xff00_0003, 0xff00_0003]
        );
    }

    #[test]
    fn the_key_counts_at_the_depth_of_the_texture() {
        let words: Vec<u8> = [0x7c00u16, 0x7800].iter().flat_map(|w| w.to_le_bytes()).collect();
        let image = ImageValue { width: 2, height: 1, pixels: words.into() };
        let mut texture = Picture::texture(0, PixelType::Rgb16, &[image]).unwrap();
        let decoded =
            texture.decoded(Decoding { clamp: false, key: Some(0x00f9_0300), border: None });
        assert!(decoded.texels.is_keyed(0, 0, 0) && !decoded.texels.is_keyed(0, 1, 0));
    }
}
