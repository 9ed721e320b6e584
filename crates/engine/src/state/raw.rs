//! The draw state of the Raw profile: 32-bit colours and depths, one texture,
//! two lights, everything in single precision.
//!
//! A colour is a word with red in bits 31..24, green in 23..16, blue in 15..8;
//! the low byte is alpha, or nothing in the colour plane. A product of two
//! bytes is `(a * b + 255) >> 8`. A depth is a signed word, less is nearer.
//!
//! Source: RAW, stages 3 and 4; `docs/sources.md`, Raw.

use std::sync::Arc;

/// How colour and texel become one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum RawCombine {
    /// Opaque black.
    Black,
    /// The colour.
    #[default]
    Color,
    /// The texel.
    Texture,
    /// Both, the colour weighted by [`RawState::balance`].
    Blend,
    /// The texel over the colour, by the texel's alpha.
    TextureDecal,
    /// The colour over the texel, by the colour's alpha.
    ColorDecal,
    /// Their product.
    Modulate,
}

impl RawCombine {
    /// Whether the result depends on the colour.
    pub fn uses_color(self) -> bool {
        !matches!(self, RawCombine::Black | RawCombine::Texture)
    }

    /// Whether the result depends on the texel.
    pub fn uses_texture(self) -> bool {
        !matches!(self, RawCombine::Black | RawCombine::Color)
    }
}

/// What an alpha counts as before anything is combined.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum RawAlpha {
    /// 255.
    Opaque,
    /// What it is.
    #[default]
    Soft,
    /// 255 from [`RawState::threshold`] on, 0 below.
    Hard,
}

/// What texture coordinates outside 0..1 mean.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum RawTiling {
    /// Nothing: transparent black.
    None,
    /// The texture again.
    #[default]
    Repeat,
    /// The texture again, every other time mirrored.
    Mirror,
    /// The texel at the edge.
    Clamp,
}

/// Which level of a texture is read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum RawMipmap {
    /// The finest.
    #[default]
    Off,
    /// The one that fits best.
    Nearest,
    /// The two that fit best, mixed.
    Linear,
}

/// Light on a fragment; without any term it is black.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct RawLight {
    /// The light from everywhere, its colour times its intensity.
    pub ambient: Option<u32>,
    /// The colour of the light whose intensity vertices carry.
    pub direct: Option<u32>,
    /// Interpolates the intensity; else it is the vertices' average.
    pub smooth: bool,
    /// Adds the further light that vertices carry.
    pub more: bool,
}

/// Errors of the original that change pixels; all off is what was meant.
///
/// Source: `docs/sources.md`, Raw; the names are those of the front end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct RawQuirks {
    /// Depths are compared as unsigned words.
    pub unsigned_depth: bool,
    /// Depth 1.0 becomes the least value.
    pub depth_overflows: bool,
    /// Bytes of colours are cut, not limited; a negative intensity is full.
    pub channels_wrap: bool,
    /// Mirroring takes the whole part of the signed coordinate.
    pub mirror_wrap: bool,
    /// The row of a clamped texel is limited by the width.
    pub clamp_v_by_width: bool,
    /// A repeated coordinate of 1.0 stays 1.0.
    pub repeat_to_one: bool,
    /// Texel indices are truncated, not rounded down.
    pub texel_truncates: bool,
    /// Filtering at a mirrored edge takes the inner neighbour.
    pub bilinear_mirror_inner: bool,
    /// Boxes left of or above the screen are moved onto it.
    pub box_clamp_moves: bool,
    /// A pixel whose centre is the box's lower bound is left out.
    pub box_skips_exact_centre: bool,
    /// Not an error: decals combine alphas by the "over" rule.
    pub decal_over_alpha: bool,
    /// Not an error: a pixel centre on an edge is covered on top and left
    /// edges only.
    pub top_left_rule: bool,
}

/// How fragments of the Raw profile become pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct RawState {
    /// How colour and texel become one.
    pub combine: RawCombine,
    /// Weight of the colour in [`RawCombine::Blend`].
    pub balance: u8,
    /// The texel's alpha.
    pub texel_alpha: RawAlpha,
    /// The colour's alpha.
    pub color_alpha: RawAlpha,
    /// Least alpha that [`RawAlpha::Hard`] lets pass; above 255 none does.
    pub threshold: u32,
    /// Interpolates the colour; else it is the vertices' average.
    pub smooth_color: bool,
    /// Reads four texels, not one.
    pub bilinear: bool,
    /// Coordinates outside the texture.
    pub tiling: RawTiling,
    /// Levels of the texture.
    pub mipmap: RawMipmap,
    /// Light, where there is any.
    pub light: Option<RawLight>,
    /// Drops fragments farther than what is there.
    pub test: bool,
    /// Stores the depth.
    pub depth_write: bool,
    /// Stores the colour.
    pub color_write: bool,
    /// Errors to keep.
    pub quirks: RawQuirks,
}

impl RawState {
    /// Whether a fragment needs its depth.
    pub fn uses_depth(&self) -> bool {
        self.test || self.depth_write
    }
}

/// A level of a texture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RawLevel {
    pub width: u32,
    pub height: u32,
    /// Its first texel.
    pub base: u32,
}

/// Texels as the kernels read them, finest level first.
#[derive(Debug)]
pub struct RawTexture {
    /// Green and alpha in the low half, red and blue in the high one, two
    /// channels of 16 bits each.
    pub(crate) entries: Vec<u64>,
    pub(crate) levels: Vec<RawLevel>,
}

impl RawTexture {
    /// A texture of levels with these widths and heights, whose texels lie in
    /// `texels` level after level, row after row.
    ///
    /// # Panics
    /// Where there is no level, a size is 0, or there are fewer texels than the
    /// sizes say or more than 2^31.
    pub fn new(sizes: &[[u32; 2]], texels: &[u32]) -> RawTexture {
        let mut base = 0u64;
        let mut levels = Vec::with_capacity(sizes.len());
        for &[width, height] in sizes {
            assert!(width > 0 && height > 0, "a level has texels");
            levels.push(RawLevel { width, height, base: base as u32 });
            base = base.saturating_add(u64::from(width) * u64::from(height));
        }
        let enough = base <= texels.len() as u64 && base <= 1 << 31;
        assert!(enough && !levels.is_empty(), "texels for every level");
        let pairs = |word: &u32| {
            let (ga, rb) = (word & 0x00ff_00ff, word >> 8 & 0x00ff_00ff);
            u64::from(ga) | u64::from(rb) << 32
        };
        RawTexture { entries: texels[..base as usize].iter().map(pairs).collect(), levels }
    }
}

/// A state with what it refers to.
#[derive(Clone, Debug, Default)]
pub struct RawDraw {
    /// The state.
    pub state: RawState,
    /// Read where the state says so; a missing one is all zeros.
    pub texture: Option<Arc<RawTexture>>,
}

impl RawDraw {
    /// Whether both draw the same, textures being immutable.
    pub(crate) fn same(&self, other: &RawDraw) -> bool {
        let address = |draw: &RawDraw| draw.texture.as_ref().map(Arc::as_ptr);
        self.state == other.state && address(self) == address(other)
    }

    /// The texture, where the state reads it.
    pub(crate) fn read_texture(&self) -> Option<&RawTexture> {
        self.texture.as_deref().filter(|_| self.state.combine.uses_texture())
    }
}
