//! State variables: their tags, types, defaults and ranges.
//!
//! Tag numbers are unique over integers, floats and pointers. Values that the
//! sources leave open are marked in `docs/sources.md`.
//!
//! Source: RAVE, state variables.

/// Integer tags, `TQATagInt`.
#[allow(missing_docs)]
pub mod int {
    pub const Z_FUNCTION: u32 = 0;
    pub const ANTIALIAS: u32 = 8;
    pub const BLEND: u32 = 9;
    pub const PERSPECTIVE_Z: u32 = 10;
    pub const TEXTURE_FILTER: u32 = 11;
    pub const TEXTURE_OP: u32 = 12;
    pub const CSG_TAG: u32 = 14;
    pub const CSG_EQUATION: u32 = 15;
    pub const BUFFER_COMPOSITE: u32 = 16;
    pub const FOG_MODE: u32 = 17;
    pub const CHANNEL_MASK: u32 = 27;
    pub const Z_BUFFER_MASK: u32 = 28;
    pub const Z_SORTED_HINT: u32 = 29;
    pub const CHROMAKEY_ENABLE: u32 = 30;
    pub const ALPHA_TEST_FUNC: u32 = 31;
    pub const DONT_SWAP: u32 = 32;
    pub const MULTI_TEXTURE_ENABLE: u32 = 33;
    pub const MULTI_TEXTURE_CURRENT: u32 = 34;
    pub const MULTI_TEXTURE_OP: u32 = 35;
    pub const MULTI_TEXTURE_FILTER: u32 = 36;
    pub const MULTI_TEXTURE_WRAP_U: u32 = 37;
    pub const MULTI_TEXTURE_WRAP_V: u32 = 38;
    pub const MULTI_TEXTURE_MAG_FILTER: u32 = 39;
    pub const MULTI_TEXTURE_MIN_FILTER: u32 = 40;
    pub const BITMAP_FILTER: u32 = 54;
    pub const DRAW_CONTEXT_FILTER: u32 = 55;
    pub const GL_DRAW_BUFFER: u32 = 100;
    pub const GL_TEXTURE_WRAP_U: u32 = 101;
    pub const GL_TEXTURE_WRAP_V: u32 = 102;
    pub const GL_TEXTURE_MAG_FILTER: u32 = 103;
    pub const GL_TEXTURE_MIN_FILTER: u32 = 104;
    pub const GL_SCISSOR_X_MIN: u32 = 105;
    pub const GL_SCISSOR_Y_MIN: u32 = 106;
    pub const GL_SCISSOR_X_MAX: u32 = 107;
    pub const GL_SCISSOR_Y_MAX: u32 = 108;
    pub const GL_BLEND_SRC: u32 = 109;
    pub const GL_BLEND_DST: u32 = 110;
    pub const GL_LINE_PATTERN: u32 = 111;
    pub const GL_AREA_PATTERN_0: u32 = 117;
    pub const GL_AREA_PATTERN_31: u32 = 148;
    pub const GL_LINE_PATTERN_FACTOR: u32 = 149;
}

/// Pointer tags, `TQATagPtr`.
#[allow(missing_docs)]
pub mod pointer {
    pub const TEXTURE: u32 = 13;
    pub const MULTI_TEXTURE: u32 = 26;
}

/// Float tags, `TQATagFloat`. Of every colour alpha has the lowest number.
#[allow(missing_docs)]
pub mod float {
    pub const COLOR_BG_A: u32 = 1;
    pub const COLOR_BG_R: u32 = 2;
    pub const COLOR_BG_G: u32 = 3;
    pub const COLOR_BG_B: u32 = 4;
    pub const WIDTH: u32 = 5;
    pub const Z_MIN_OFFSET: u32 = 6;
    pub const Z_MIN_SCALE: u32 = 7;
    pub const FOG_COLOR_A: u32 = 18;
    pub const FOG_COLOR_R: u32 = 19;
    pub const FOG_COLOR_G: u32 = 20;
    pub const FOG_COLOR_B: u32 = 21;
    pub const FOG_START: u32 = 22;
    pub const FOG_END: u32 = 23;
    pub const FOG_DENSITY: u32 = 24;
    pub const FOG_MAX_DEPTH: u32 = 25;
    pub const MIPMAP_BIAS: u32 = 41;
    pub const MULTI_TEXTURE_MIPMAP_BIAS: u32 = 42;
    pub const CHROMAKEY_R: u32 = 43;
    pub const CHROMAKEY_G: u32 = 44;
    pub const CHROMAKEY_B: u32 = 45;
    pub const ALPHA_TEST_REF: u32 = 46;
    pub const MULTI_TEXTURE_BORDER_A: u32 = 47;
    pub const MULTI_TEXTURE_BORDER_R: u32 = 48;
    pub const MULTI_TEXTURE_BORDER_G: u32 = 49;
    pub const MULTI_TEXTURE_BORDER_B: u32 = 50;
    pub const MULTI_TEXTURE_FACTOR: u32 = 51;
    pub const BITMAP_SCALE_X: u32 = 52;
    pub const BITMAP_SCALE_Y: u32 = 53;
    pub const MULTI_TEXTURE_ENV_COLOR_A: u32 = 56;
    pub const MULTI_TEXTURE_ENV_COLOR_R: u32 = 57;
    pub const MULTI_TEXTURE_ENV_COLOR_G: u32 = 58;
    pub const MULTI_TEXTURE_ENV_COLOR_B: u32 = 59;
    pub const GL_DEPTH_BG: u32 = 112;
    pub const GL_TEXTURE_BORDER_A: u32 = 113;
    pub const GL_TEXTURE_BORDER_R: u32 = 114;
    pub const GL_TEXTURE_BORDER_G: u32 = 115;
    pub const GL_TEXTURE_BORDER_B: u32 = 116;
    pub const GL_TEXTURE_ENV_COLOR_A: u32 = 150;
    pub const GL_TEXTURE_ENV_COLOR_R: u32 = 151;
    pub const GL_TEXTURE_ENV_COLOR_G: u32 = 152;
    pub const GL_TEXTURE_ENV_COLOR_B: u32 = 153;
}

/// Tags of the ATI extension that are aliases of the standard state.
#[allow(missing_docs)]
pub mod ati {
    pub const FOG_MODE: u32 = 1002;
    pub const FOG_COLOR_R: u32 = 1003;
    pub const FOG_COLOR_G: u32 = 1004;
    pub const FOG_COLOR_B: u32 = 1005;
    pub const FOG_COLOR_A: u32 = 1006;
    pub const FOG_DENSITY: u32 = 1007;
    pub const FOG_START: u32 = 1008;
    pub const FOG_END: u32 = 1009;
    pub const EXTENSION_FUNCTIONS: u32 = 1021;
    pub const ENABLE_Z_WRITE: u32 = 1022;
    pub const ALPHA_TEST_ENABLE: u32 = 1024;
    pub const ALPHA_TEST_REF: u32 = 1025;
    pub const ALPHA_TEST_FUNC: u32 = 1026;
    pub const ALPHA_ENABLE: u32 = 1034;
    pub const RED_ENABLE: u32 = 1035;
    pub const GREEN_ENABLE: u32 = 1036;
    pub const BLUE_ENABLE: u32 = 1037;
}

/// The greatest width of lines and points, `kQAMaxWidth`.
pub const MAX_WIDTH: f32 = 128.0;
