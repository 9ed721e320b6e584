//! The enumerants that the translation needs, as the headers number them.
//!
//! Source: G246, `glide.h` and `sst1vid.h`.
#![allow(missing_docs)]

pub const GR_FBI: i32 = 3;

pub const BUFFER_FRONT: i32 = 0;
pub const BUFFER_BACK: i32 = 1;
pub const BUFFER_AUX: i32 = 2;

pub const COMBINE_ZERO: i32 = 0;
pub const COMBINE_LOCAL: i32 = 1;
pub const COMBINE_LOCAL_ALPHA: i32 = 2;
pub const COMBINE_SCALE_OTHER: i32 = 3;
pub const COMBINE_SCALE_OTHER_ADD_LOCAL: i32 = 4;
pub const COMBINE_SCALE_OTHER_ADD_LOCAL_ALPHA: i32 = 5;
pub const COMBINE_SCALE_OTHER_MINUS_LOCAL: i32 = 6;
pub const COMBINE_BLEND: i32 = 7;
pub const COMBINE_BLEND_ADD_LOCAL_ALPHA: i32 = 8;
pub const COMBINE_BLEND_LOCAL: i32 = 9;
pub const COMBINE_BLEND_LOCAL_ADD_LOCAL_ALPHA: i32 = 0x10;

pub const FACTOR_NONE: i32 = 0;
pub const FACTOR_LOCAL: i32 = 1;
pub const FACTOR_OTHER_ALPHA: i32 = 2;
pub const FACTOR_LOCAL_ALPHA: i32 = 3;
pub const FACTOR_TEXTURE_ALPHA: i32 = 4;
pub const FACTOR_DETAIL: i32 = 4;
pub const FACTOR_TEXTURE_RGB: i32 = 5;
pub const FACTOR_LOD_FRACTION: i32 = 5;
pub const FACTOR_ONE: i32 = 8;
pub const FACTOR_ONE_MINUS_DETAIL: i32 = 0xc;
pub const FACTOR_ONE_MINUS_LOD_FRACTION: i32 = 0xd;

pub const LOCAL_ITERATED: i32 = 0;
pub const LOCAL_CONSTANT: i32 = 1;
pub const OTHER_ITERATED: i32 = 0;
pub const OTHER_TEXTURE: i32 = 1;
pub const OTHER_CONSTANT: i32 = 2;

pub const BLEND_ZERO: i32 = 0;
pub const BLEND_COLOR: i32 = 2;
pub const BLEND_ONE: i32 = 4;
pub const BLEND_ALPHA_SATURATE: i32 = 0xf;

pub const CMP_ALWAYS: i32 = 7;
pub const CMP_LESS: i32 = 1;
pub const CMP_EQUAL: i32 = 2;

pub const DEPTHBUFFER_WBUFFER: i32 = 2;
pub const DEPTHBUFFER_ZBUFFER_COMPARE_TO_BIAS: i32 = 3;
pub const DEPTHBUFFER_WBUFFER_COMPARE_TO_BIAS: i32 = 4;

pub const FOG_WITH_TABLE: i32 = 2;
pub const FOG_MULT2: i32 = 0x100;
pub const FOG_ADD2: i32 = 0x200;

pub const HINT_STW: i32 = 0;
pub const HINT_ALLOW_MIPMAP_DITHER: i32 = 3;
pub const STW_W_DIFF_TMU0: u32 = 2;
pub const STW_W_DIFF_TMU1: u32 = 8;
pub const STW_ST_DIFF_TMU1: u32 = 0x10;
pub const STW_W_DIFF_TMU2: u32 = 0x20;
pub const STW_ST_DIFF_TMU2: u32 = 0x40;

pub const MIPMAP_DISABLE: i32 = 0;
pub const MIPMAP_NEAREST_DITHER: i32 = 2;
pub const LEVELS_EVEN: u32 = 1;
pub const LEVELS_ODD: u32 = 2;
pub const LEVELS_BOTH: u32 = 3;

pub const TEXFMT_YIQ_422: i32 = 1;
pub const TEXFMT_P_8: i32 = 5;
pub const TEXFMT_AYIQ_8422: i32 = 9;
pub const TEXFMT_AP_88: i32 = 0xe;

pub const TEXTABLE_PALETTE: i32 = 2;

pub const LFB_READ_ONLY: i32 = 0;
pub const LFB_WRITE_ONLY: i32 = 1;
pub const LFB_NOIDLE: i32 = 0x10;
pub const LFBWRITEMODE_565: i32 = 0;
pub const LFBWRITEMODE_ZA16: i32 = 0xf;
pub const LFBWRITEMODE_ANY: i32 = 0xff;
pub const LFB_SRC_FMT_RLE16: i32 = 0x80;

pub const RESOLUTION_NONE: i32 = 0xff;
