//! What an engine says of itself.
//!
//! Source: RAVE, `QAEngineGestalt`.

/// `TQAGestaltSelector`.
#[allow(missing_docs)]
pub mod selector {
    pub const OPTIONAL_FEATURES: u32 = 0;
    pub const FAST_FEATURES: u32 = 1;
    pub const VENDOR_ID: u32 = 2;
    pub const ENGINE_ID: u32 = 3;
    pub const REVISION: u32 = 4;
    pub const ASCII_NAME_LENGTH: u32 = 5;
    pub const ASCII_NAME: u32 = 6;
    pub const TEXTURE_MEMORY: u32 = 7;
    pub const FAST_TEXTURE_MEMORY: u32 = 8;
    pub const DRAW_CONTEXT_PIXEL_TYPES_ALLOWED: u32 = 9;
    pub const DRAW_CONTEXT_PIXEL_TYPES_PREFERRED: u32 = 10;
    pub const TEXTURE_PIXEL_TYPES_ALLOWED: u32 = 11;
    pub const TEXTURE_PIXEL_TYPES_PREFERRED: u32 = 12;
    pub const BITMAP_PIXEL_TYPES_ALLOWED: u32 = 13;
    pub const BITMAP_PIXEL_TYPES_PREFERRED: u32 = 14;
    pub const OPTIONAL_FEATURES_2: u32 = 15;
    pub const MULTI_TEXTURE_MAX: u32 = 16;
    pub const NUM_SELECTORS: u32 = 17;
    pub const ENGINE_SPECIFIC_MINIMUM: u32 = 1000;
    /// Copies of textures to the board so far; our extension.
    pub const TEXTURE_LOADS: u32 = 2000;
    /// Copies that left it for others; our extension.
    pub const TEXTURE_EVICTIONS: u32 = 2001;
}

/// What a selector answers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// A number of 32 bits.
    Number(u32),
    /// A text, without its terminator.
    Text(String),
}

/// Bits of the answer to [`selector::OPTIONAL_FEATURES`].
#[allow(missing_docs)]
pub mod optional {
    pub const DEEP_Z: u32 = 1 << 0;
    pub const TEXTURE: u32 = 1 << 1;
    pub const TEXTURE_HQ: u32 = 1 << 2;
    pub const TEXTURE_COLOR: u32 = 1 << 3;
    pub const BLEND: u32 = 1 << 4;
    pub const BLEND_ALPHA: u32 = 1 << 5;
    pub const ANTIALIAS: u32 = 1 << 6;
    pub const Z_SORTED: u32 = 1 << 7;
    pub const PERSPECTIVE_Z: u32 = 1 << 8;
    pub const OPEN_GL: u32 = 1 << 9;
    pub const NO_CLEAR: u32 = 1 << 10;
    pub const CSG: u32 = 1 << 11;
    pub const BOUND_TO_DEVICE: u32 = 1 << 12;
    pub const CL4: u32 = 1 << 13;
    pub const CL8: u32 = 1 << 14;
    pub const BUFFER_COMPOSITE: u32 = 1 << 15;
    pub const NO_DITHER: u32 = 1 << 16;
    pub const FOG_ALPHA: u32 = 1 << 17;
    pub const FOG_DEPTH: u32 = 1 << 18;
    pub const MULTI_TEXTURES: u32 = 1 << 19;
    pub const MIPMAP_BIAS: u32 = 1 << 20;
    pub const CHANNEL_MASK: u32 = 1 << 21;
    pub const Z_BUFFER_MASK: u32 = 1 << 22;
    pub const ALPHA_TEST: u32 = 1 << 23;
    pub const ACCESS_TEXTURE: u32 = 1 << 24;
    pub const ACCESS_BITMAP: u32 = 1 << 25;
    pub const ACCESS_DRAW_BUFFER: u32 = 1 << 26;
    pub const ACCESS_Z_BUFFER: u32 = 1 << 27;
    pub const CLEAR_DRAW_BUFFER: u32 = 1 << 28;
    pub const CLEAR_Z_BUFFER: u32 = 1 << 29;
    pub const OFFSCREEN_DRAW_CONTEXTS: u32 = 1 << 30;
}

/// Bits of the answer to [`selector::OPTIONAL_FEATURES_2`].
#[allow(missing_docs)]
pub mod optional2 {
    pub const TEXTURE_DRAW_CONTEXTS: u32 = 1 << 1;
    pub const BITMAP_DRAW_CONTEXTS: u32 = 1 << 2;
    pub const BUSY: u32 = 1 << 3;
    pub const SWAP_BUFFERS: u32 = 1 << 4;
    pub const CHROMAKEY: u32 = 1 << 5;
    pub const NON_RELOCATABLE: u32 = 1 << 6;
    pub const NO_COPY: u32 = 1 << 7;
    pub const PRIORITY_BITS: u32 = 1 << 8;
    pub const FLIP_ORIGIN: u32 = 1 << 9;
    pub const BITMAP_SCALE: u32 = 1 << 10;
    pub const DRAW_CONTEXT_SCALE: u32 = 1 << 11;
    pub const DRAW_CONTEXT_NON_RELOCATABLE: u32 = 1 << 12;
}

/// Bits of the answer to [`selector::FAST_FEATURES`]; their numbers are not
/// those of the optional features.
#[allow(missing_docs)]
pub mod fast {
    pub const LINE: u32 = 1 << 0;
    pub const GOURAUD: u32 = 1 << 1;
    pub const TEXTURE: u32 = 1 << 2;
    pub const TEXTURE_HQ: u32 = 1 << 3;
    pub const BLEND: u32 = 1 << 4;
    pub const ANTIALIASING: u32 = 1 << 5;
    pub const Z_SORTED: u32 = 1 << 6;
    pub const CL4: u32 = 1 << 7;
    pub const CL8: u32 = 1 << 8;
    pub const FOG_ALPHA: u32 = 1 << 9;
    pub const FOG_DEPTH: u32 = 1 << 10;
    pub const MULTI_TEXTURES: u32 = 1 << 11;
    pub const BITMAP_SCALE: u32 = 1 << 12;
    pub const DRAW_CONTEXT_SCALE: u32 = 1 << 13;
}
