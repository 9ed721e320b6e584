//! Flags, selectors and enumerated values, as the interface numbers them.
//!
//! Source: RAVE, `RAVE.h` of version 1.6.
#![allow(missing_docs)]

/// `TQAVersion`: what a draw context reports, `kQAVersion_1_6`.
pub const VERSION: u32 = 4;

/// Flags of draw contexts.
pub mod context {
    pub const NO_Z_BUFFER: u32 = 0x1;
    pub const DEEP_Z: u32 = 0x2;
    pub const DOUBLE_BUFFER: u32 = 0x4;
    pub const CACHE: u32 = 0x8;
    pub const NO_DITHER: u32 = 0x10;
    pub const SCALE: u32 = 0x20;
    pub const NON_RELOCATABLE: u32 = 0x40;
}

/// Flags of textures.
pub mod texture {
    pub const LOCK: u32 = 0x1;
    pub const MIPMAP: u32 = 0x2;
    pub const NO_COMPRESSION: u32 = 0x4;
    pub const HIGH_COMPRESSION: u32 = 0x8;
    pub const NON_RELOCATABLE: u32 = 0x10;
    pub const NO_COPY: u32 = 0x20;
    pub const FLIP_ORIGIN: u32 = 0x40;
    pub const PRIORITY_BITS: u32 = 0xf000_0000;
}

/// Flags of bitmaps. Their Lock is not the textures'.
pub mod bitmap {
    pub const LOCK: u32 = 0x2;
    pub const NO_COMPRESSION: u32 = 0x4;
    pub const HIGH_COMPRESSION: u32 = 0x8;
    pub const NON_RELOCATABLE: u32 = 0x10;
    pub const NO_COPY: u32 = 0x20;
    pub const FLIP_ORIGIN: u32 = 0x40;
    pub const PRIORITY_BITS: u32 = 0xf000_0000;
}

/// `TQADeviceType`.
pub mod device {
    pub const MEMORY: u32 = 0;
    pub const GDEVICE: u32 = 1;
    pub const WIN32_DC: u32 = 2;
    pub const DD_SURFACE: u32 = 3;
    /// An off-screen context without memory of the program; our extension.
    pub const OFFSCREEN: u32 = 4;
}

/// `TQAColorTableType`.
pub mod color_table {
    pub const CL8_RGB32: u32 = 0;
    pub const CL4_RGB32: u32 = 1;
}

/// `kQAZFunction` and `kQAAlphaTest`.
pub mod compare {
    pub const NONE: u32 = 0;
    pub const LT: u32 = 1;
    pub const EQ: u32 = 2;
    pub const LE: u32 = 3;
    pub const GT: u32 = 4;
    pub const NE: u32 = 5;
    pub const GE: u32 = 6;
    pub const TRUE: u32 = 7;
    /// Of `kQAZFunction` only.
    pub const FALSE: u32 = 8;
}

/// `kQABlend`.
pub mod blend {
    pub const PRE_MULTIPLY: u32 = 0;
    pub const INTERPOLATE: u32 = 1;
    pub const OPEN_GL: u32 = 2;
}

/// Texture, bitmap and context filters, and antialiasing.
pub mod quality {
    pub const FAST: u32 = 0;
    pub const MID: u32 = 1;
    pub const BEST: u32 = 2;
}

/// `kQAAntiAlias`.
pub mod antialias {
    pub const OFF: u32 = 0;
    pub const FAST: u32 = 1;
    pub const MID: u32 = 2;
    pub const BEST: u32 = 3;
}

/// `kQATextureOp`, a mask.
pub mod texture_op {
    pub const NONE: u32 = 0;
    pub const MODULATE: u32 = 1;
    pub const HIGHLIGHT: u32 = 2;
    pub const DECAL: u32 = 4;
    pub const SHRINK: u32 = 8;
    pub const BLEND: u32 = 16;
}

/// `kQAMultiTexture` operations.
pub mod multi_texture {
    pub const ADD: u32 = 0;
    pub const MODULATE: u32 = 1;
    pub const BLEND_ALPHA: u32 = 2;
    pub const FIXED: u32 = 3;
}

/// `kQAFogMode`.
pub mod fog {
    pub const NONE: u32 = 0;
    pub const ALPHA: u32 = 1;
    pub const LINEAR: u32 = 2;
    pub const EXPONENTIAL: u32 = 3;
    pub const EXPONENTIAL_SQUARED: u32 = 4;
}

/// `kQAChannelMask`.
pub mod channel {
    pub const RED: u32 = 1;
    pub const GREEN: u32 = 2;
    pub const BLUE: u32 = 4;
    pub const ALPHA: u32 = 8;
}

/// `TQAVertexMode`.
pub mod vertex_mode {
    pub const POINT: u32 = 0;
    pub const LINE: u32 = 1;
    pub const POLYLINE: u32 = 2;
    pub const TRI: u32 = 3;
    pub const STRIP: u32 = 4;
    pub const FAN: u32 = 5;
}

/// `TQAMethodSelector`: the notices.
pub mod notice {
    pub const RENDER_COMPLETION: u32 = 0;
    pub const DISPLAY_MODE_CHANGED: u32 = 1;
    pub const RELOAD_TEXTURES: u32 = 2;
    pub const IMAGE_BUFFER_INITIALIZE: u32 = 3;
    pub const IMAGE_BUFFER_2D_COMPOSITE: u32 = 4;
    pub const NUM_SELECTORS: u32 = 5;
}

/// Flag of the access calls: the program overwrites everything.
pub const NO_COPY_NEEDED: u32 = 1;
