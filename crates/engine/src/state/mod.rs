//! The draw state: everything that decides how a fragment becomes a pixel,
//! as plain values. A front end translates its own state into one
//! [`DrawState`]; equal values share one compiled pipeline.

mod blend;
mod combine;
mod depth;
mod draw;
mod fog;
mod palette;
mod pattern;
mod raw;
mod shade;
mod texture;
mod write;

pub use blend::{AlphaEquation, Blend, BlendFactor, DITHER_2X2, DITHER_4X4, Dither};
pub use combine::{
    Addend, AlphaCombine, AlphaLocal, ColorCombine, ColorLocal, CombineUnit, Factor, Other,
};
pub use depth::{AuxWrite, Compare, DepthSource, DepthState, ZOverflow};
pub use draw::{AlphaTest, DrawState, Origin, Rect, Stipple};
pub use fog::{FOG_SAMPLES, Fog, FogAmount, FogTable};
pub use palette::{PALETTE_BITS, PaletteBlend, PaletteDraw, PaletteState};
pub use pattern::{Axis, Pattern, PatternBits};
pub(crate) use raw::RawLevel;
pub use raw::{
    RawAlpha, RawCombine, RawDraw, RawLight, RawMipmap, RawQuirks, RawState, RawTexture, RawTiling,
};
pub use shade::{DecalBase, Shade};
pub use texture::{Filter, LodRange, MAX_TMUS, TextureCombine, TextureFactor, TextureUnit};
pub use write::{Channels, LogicOp};
