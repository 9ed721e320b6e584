//! The state as the board's registers hold it.
//!
//! Every state function of the API only changes bits here; one place decodes
//! them. Raw register writes, and saving and restoring the state, then need
//! nothing of their own.
//!
//! Source: SST1, register descriptions.
#![allow(missing_docs)]

/// The pixel pipeline's registers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FbiRegisters {
    pub fbz_color_path: u32,
    pub fog_mode: u32,
    pub alpha_mode: u32,
    pub fbz_mode: u32,
    pub lfb_mode: u32,
    pub clip_left_right: u32,
    pub clip_bottom_top: u32,
    pub fog_color: u32,
    pub za_color: u32,
    pub chroma_key: u32,
    pub stipple: u32,
    pub color0: u32,
    pub color1: u32,
}

/// A texture unit's registers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TmuRegisters {
    pub texture_mode: u32,
    pub t_lod: u32,
    pub t_detail: u32,
    /// In units of eight bytes: level 256 or the whole chain, then 128, 64,
    /// and 32 to 1.
    pub base: [u32; 4],
}

/// Bits of fbzColorPath.
pub mod color_path {
    pub const LOCAL_BY_TEXTURE_ALPHA: u32 = 1 << 7;
    pub const COLOR_UNIT: u32 = 8;
    pub const ALPHA_UNIT: u32 = 17;
    pub const PARAMETER_ADJUST: u32 = 1 << 26;
    pub const TEXTURE_ENABLE: u32 = 1 << 27;
}

/// Bits of a combine unit, from its first bit.
pub mod unit {
    pub const ZERO_OTHER: u32 = 1;
    pub const SUB_LOCAL: u32 = 1 << 1;
    pub const SELECT_SHIFT: u32 = 2;
    pub const REVERSE_BLEND: u32 = 1 << 5;
    pub const ADD_LOCAL: u32 = 1 << 6;
    pub const ADD_ALPHA: u32 = 1 << 7;
    pub const INVERT: u32 = 1 << 8;
    pub const ALL: u32 = 0x1ff;
}

/// Bits of fbzMode.
pub mod fbz {
    pub const CLIP: u32 = 1;
    pub const CHROMA_KEY: u32 = 1 << 1;
    pub const STIPPLE: u32 = 1 << 2;
    pub const W_BUFFER: u32 = 1 << 3;
    pub const DEPTH_ENABLE: u32 = 1 << 4;
    pub const DEPTH_FUNCTION: u32 = 5;
    pub const DITHER: u32 = 1 << 8;
    pub const RGB_WRITE: u32 = 1 << 9;
    pub const AUX_WRITE: u32 = 1 << 10;
    pub const DITHER_2X2: u32 = 1 << 11;
    pub const STIPPLE_PATTERN: u32 = 1 << 12;
    pub const DRAW_BACK: u32 = 1 << 14;
    pub const DRAW_BUFFER: u32 = 3 << 14;
    pub const DEPTH_BIAS: u32 = 1 << 16;
    pub const LOWER_LEFT: u32 = 1 << 17;
    pub const ALPHA_PLANES: u32 = 1 << 18;
    pub const SUBTRACT_DITHER: u32 = 1 << 19;
    pub const COMPARE_CONSTANT: u32 = 1 << 20;
}

/// Bits of fogMode.
pub mod fog {
    pub const ENABLE: u32 = 1;
    pub const ADD: u32 = 1 << 1;
    pub const MULT: u32 = 1 << 2;
    pub const ITERATED_ALPHA: u32 = 1 << 3;
    pub const ITERATED_Z: u32 = 1 << 4;
    pub const CONSTANT: u32 = 1 << 5;
}

/// Bits of alphaMode.
pub mod alpha {
    pub const TEST: u32 = 1;
    pub const BLEND: u32 = 1 << 4;
}

/// Bits of textureMode.
pub mod texture_mode {
    pub const PERSPECTIVE: u32 = 1;
    pub const MINIFY_BILINEAR: u32 = 1 << 1;
    pub const MAGNIFY_BILINEAR: u32 = 1 << 2;
    pub const CLAMP_W: u32 = 1 << 3;
    pub const LOD_DITHER: u32 = 1 << 4;
    pub const NCC_TABLE: u32 = 1 << 5;
    pub const CLAMP_S: u32 = 1 << 6;
    pub const CLAMP_T: u32 = 1 << 7;
    pub const FORMAT: u32 = 8;
    pub const COLOR_UNIT: u32 = 12;
    pub const ALPHA_UNIT: u32 = 21;
    pub const TRILINEAR: u32 = 1 << 30;
    pub const COLOR_UNIT_MASK: u32 = super::unit::ALL << COLOR_UNIT;
    pub const ALPHA_UNIT_MASK: u32 = super::unit::ALL << ALPHA_UNIT;
}

/// Bits of lfbMode.
pub mod lfb_mode {
    /// Two bits, as the program's colour formats are numbered.
    pub const LANES: u32 = 9;
    pub const LANES_MASK: u32 = 3 << LANES;
    pub const SWAP_WORDS: u32 = 1 << 11;
    pub const SWIZZLE_BYTES: u32 = 1 << 12;
}

/// Bits of tLOD.
pub mod t_lod {
    pub const ODD: u32 = 1 << 18;
    pub const SPLIT: u32 = 1 << 19;
    pub const S_IS_WIDER: u32 = 1 << 20;
    pub const ASPECT: u32 = 21;
    pub const ZERO_FRACTION: u32 = 1 << 23;
    pub const MULTIBASE: u32 = 1 << 24;
}

/// `value` with the bits of `mask` replaced by those of `bits`.
pub fn replace(value: u32, mask: u32, bits: u32) -> u32 {
    (value & !mask) | (bits & mask)
}

/// `value` with `bit` set or cleared.
pub fn switch(value: u32, bit: u32, on: bool) -> u32 {
    if on { value | bit } else { value & !bit }
}
