//! The whole draw state.

use super::{
    AlphaCombine, AuxWrite, Blend, Channels, ColorCombine, Compare, DepthState, Dither, Fog,
    FogTable, LogicOp, MAX_TMUS, Pattern, Shade, TextureUnit,
};

/// A rectangle of pixels: minima inclusive, maxima exclusive.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Rect {
    /// Left column.
    pub x0: u32,
    /// First row.
    pub y0: u32,
    /// One past the right column.
    pub x1: u32,
    /// One past the last row.
    pub y1: u32,
}

impl Rect {
    /// A rectangle from its corners.
    #[inline]
    pub const fn new(x0: u32, y0: u32, x1: u32, y1: u32) -> Rect {
        Rect { x0, y0, x1, y1 }
    }

    /// Whether no pixel lies inside.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.x0 >= self.x1 || self.y0 >= self.y1
    }

    /// The part that both share; possibly empty.
    #[inline]
    pub fn intersect(&self, other: &Rect) -> Rect {
        Rect {
            x0: self.x0.max(other.x0),
            y0: self.y0.max(other.y0),
            x1: self.x1.min(other.x1),
            y1: self.y1.min(other.y1),
        }
    }

    /// Whether all of `other` lies inside.
    #[inline]
    pub fn contains(&self, other: &Rect) -> bool {
        self.x0 <= other.x0 && self.y0 <= other.y0 && self.x1 >= other.x1 && self.y1 >= other.y1
    }

    /// Pixels inside.
    pub fn area(&self) -> u64 {
        if self.is_empty() {
            return 0;
        }
        u64::from(self.x1 - self.x0) * u64::from(self.y1 - self.y0)
    }
}

/// Where row 0 of the drawing coordinates is on the screen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Origin {
    /// At the top.
    #[default]
    UpperLeft,
    /// At the bottom: screen row = height - 1 - y.
    LowerLeft,
}

/// Drops fragments by a bit pattern.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Stipple {
    /// Bit `(y & 3) * 8 + (~x & 7)` decides; 0 drops. y is the screen row.
    pub pattern: u32,
}

/// Drops fragments by their combined alpha.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct AlphaTest {
    /// `alpha OP reference` must hold.
    pub compare: Compare,
    /// 0..=255.
    pub reference: u8,
}

/// Everything that decides how fragments become pixels, apart from textures'
/// contents and targets. Colours are 0xAARRGGBB.
///
/// The default draws the iterated colour into the colour plane, no more.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DrawState {
    /// Row order of the drawing coordinates.
    pub origin: Origin,
    /// Fragments outside are dropped; rows count in drawing coordinates,
    /// before any flip. `None`: the whole target.
    pub clip: Option<Rect>,
    /// Stipple pattern.
    pub stipple: Option<Stipple>,
    /// A pattern of lines or areas, apart from the stipple.
    pub pattern: Option<Pattern>,
    /// Depth test.
    pub depth: DepthState,
    /// What the aux plane receives.
    pub aux_write: AuxWrite,
    /// The texture units in use, `units[0]` nearest to the combine units. A
    /// chain has no gaps.
    pub units: [Option<TextureUnit>; MAX_TMUS],
    /// Drops fragments whose colour "other" equals this 0x00RRGGBB.
    pub chroma_key: Option<u32>,
    /// Colour combine.
    pub color_combine: ColorCombine,
    /// Alpha combine.
    pub alpha_combine: AlphaCombine,
    /// The local constant.
    pub color0: u32,
    /// The "other" constant.
    pub color1: u32,
    /// What follows the combine units.
    pub shade: Shade,
    /// Alpha test.
    pub alpha_test: Option<AlphaTest>,
    /// Fog.
    pub fog: Option<Fog>,
    /// The fog table (read only where fog takes its amount from it).
    pub fog_table: FogTable,
    /// Blending.
    pub blend: Option<Blend>,
    /// Reduction to the surface's bits.
    pub dither: Dither,
    /// Added to the screen column and row that choose the dither value.
    pub dither_offset: [u8; 2],
    /// A logic operation on the elements; not where `blend` is set.
    pub logic_op: Option<LogicOp>,
    /// The channels of the colour plane that are written; others keep what they
    /// hold.
    pub channels: Channels,
    /// The bits of the colour plane's elements that are written, besides.
    pub plane_mask: u32,
    /// Whether the colour plane is written.
    pub color_write: bool,
}

impl Default for DrawState {
    fn default() -> DrawState {
        use super::{Addend, CombineUnit, Factor};
        let local = CombineUnit {
            zero_other: true,
            add: Addend::Local,
            ..CombineUnit::<Factor>::default()
        };
        DrawState {
            origin: Origin::UpperLeft,
            clip: None,
            stipple: None,
            pattern: None,
            depth: DepthState::default(),
            aux_write: AuxWrite::Nothing,
            units: [None; MAX_TMUS],
            chroma_key: None,
            color_combine: ColorCombine { unit: local, ..ColorCombine::default() },
            alpha_combine: AlphaCombine { unit: local, ..AlphaCombine::default() },
            color0: 0xffff_ffff,
            color1: 0xffff_ffff,
            shade: Shade::default(),
            alpha_test: None,
            fog: None,
            fog_table: FogTable::default(),
            blend: None,
            dither: Dither::Off,
            dither_offset: [0; 2],
            logic_op: None,
            channels: Channels::ALL,
            plane_mask: u32::MAX,
            color_write: true,
        }
    }
}
