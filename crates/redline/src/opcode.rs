//! Words of the command stream: opcodes and state registers.
//!
//! Source: RR, FIFO commands; numbers from the interface headers.

/// Declares opcodes with their names in C.
macro_rules! opcodes {
    ($($(#[$meta:meta])* $name:ident = $code:literal $c:literal,)*) => {
        /// What a command does: the low half of its first word.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(u32)]
        pub enum Opcode { $($(#[$meta])* $name = $code,)* }

        impl Opcode {
            /// All opcodes.
            pub const ALL: &'static [Opcode] = &[$(Opcode::$name),*];

            /// The opcode with this number.
            pub fn from_code(code: u32) -> Option<Opcode> {
                match code {
                    $($code => Some(Opcode::$name),)*
                    _ => None,
                }
            }

            /// The name in C.
            pub fn name(self) -> &'static str {
                match self { $(Opcode::$name => $c,)* }
            }
        }
    };
}

opcodes! {
    /// All state to its defaults.
    ContextInit = 2 "V_FIFO_CONTEXT_INIT",
    /// Shows another address.
    Display = 4 "V_FIFO_DISPLAY",
    /// Shows two addresses, line by line.
    StereoDisplay = 5 "V_FIFO_STEREO_DISPLAY",
    /// Waits until the address is shown.
    WaitDisplaySwitch = 6 "V_FIFO_WAIT_DISPLAY_SWITCH",
    /// Ends a command buffer.
    SyncAndRespond = 8 "V_FIFO_SYNC_AND_RESPOND",
    /// Bytes into memory.
    MemWrite = 9 "V_FIFO_MEM_WRITE",
    /// Rows of bytes into memory.
    MemWriteRect = 10 "V_FIFO_MEM_WRITE_RECT",
    /// Fills rows.
    MemClearRect = 13 "V_FIFO_MEM_CLEAR_RECT",
    /// Bytes with gaps into memory.
    MemWriteSprite = 14 "V_FIFO_MEM_WRITE_SPRITE",
    /// A pixel.
    Dot = 15 "V_FIFO_DOT",
    /// A line.
    Line = 16 "V_FIFO_LINE",
    /// Lines one after another.
    Polyline = 17 "V_FIFO_POLYLINE",
    /// A line between whole coordinates.
    IntLine = 18 "V_FIFO_INTLINE",
    /// Such lines one after another.
    IntPolyline = 19 "V_FIFO_INTPOLYLINE",
    /// An antialiased line.
    AALine = 20 "V_FIFO_AALINE",
    /// A horizontal span.
    Span = 21 "V_FIFO_SPAN",
    /// A square.
    Square = 22 "V_FIFO_SQUARE",
    /// A rectangle.
    Rectangle = 23 "V_FIFO_RECTANGLE",
    /// A triangle.
    Triangle = 24 "V_FIFO_TRIANGLE",
    /// Antialiases an edge.
    AAEdge = 25 "V_FIFO_AAEDGE",
    /// A strip of triangles.
    Tristrip = 26 "V_FIFO_TRISTRIP",
    /// A fan of triangles.
    Trifan = 27 "V_FIFO_TRIFAN",
    /// An affinely textured rectangle.
    Affine = 28 "V_FIFO_AFFINE",
    /// A rectangle with coordinates for each pixel.
    Warp = 29 "V_FIFO_WARP",
    /// Copies from the source.
    Bitblt = 30 "V_FIFO_BITBLT",
    /// Fills in the foreground colour or pattern.
    Bitfill = 31 "V_FIFO_BITFILL",
    /// Nothing.
    RleHack = 32 "V_FIFO_RLEHACK",
    /// Palette of the display.
    Palette = 33 "V_FIFO_PALETTE",
    /// Timers.
    TimerFuncs = 34 "V_FIFO_TIMER_FUNCS",
    /// Marks a frame.
    FrameMarker = 35 "V_FIFO_FRAME_MARKER",
    /// Host pixels times the texture.
    CompositeRect = 36 "V_FIFO_COMPOSITE_RECT",
    /// Rectangles of one colour each.
    Particles = 37 "V_FIFO_PARTICLES",
    /// A triangle in the default colour.
    TriFill = 38 "V_FIFO_TRI_FILL",
    /// Host pixels to the destination.
    BitbltMem = 41 "V_FIFO_BITBLT_MEM",
    /// Texels by index.
    Lookup = 42 "V_FIFO_LOOKUP",
    /// Triangle of k, x, y, z.
    FtriKxyz = 48 "V_FIFO_FTRI_KXYZ",
    /// Triangle of k, x, y, z, u, v, q.
    FtriKxyzuvq = 49 "V_FIFO_FTRI_KXYZUVQ",
    /// Triangle of k, f, x, y, z, u, v, q.
    FtriKfxyzuvq = 50 "V_FIFO_FTRI_KFXYZUVQ",
    /// Triangle of k, s, x, y, z.
    FtriKsxyz = 51 "V_FIFO_FTRI_KSXYZ",
    /// Triangle of k, s, x, y, z, u, v, q.
    FtriKsxyzuvq = 52 "V_FIFO_FTRI_KSXYZUVQ",
}

/// `SET_CURRENT_TEXTURE`: base, stride, masks and multipliers follow.
pub const SET_CURRENT_TEXTURE: u32 = 0x4000;
/// `TEX4PAL`: eight words of two palette entries follow.
pub const TEXTURE_PALETTE: u32 = 0x7020;
/// The second word of a frame marker.
pub const FRAME_MARKER_PATTERN: u32 = 0xa5c3_1697;
/// The first word of a frame marker.
pub const FRAME_MARKER: u32 = 0x5a3c_0023;

/// Declares registers with the low half of the word that sets each.
macro_rules! registers {
    ($($name:ident = $word:literal $c:literal,)*) => {
        /// A register of the pixel engine. The number is the low half of the
        /// word that sets it.
        #[allow(missing_docs)]
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(u32)]
        pub enum Register { $($name = $word,)* }

        impl Register {
            /// All registers.
            pub const ALL: &'static [Register] = &[$(Register::$name),*];

            /// The name in C.
            pub fn name(self) -> &'static str {
                match self { $(Register::$name => $c,)* }
            }
        }

        /// Registers by index.
        static BY_INDEX: [Option<Register>; REGISTERS] = {
            let mut all = [None; REGISTERS];
            $(all[$word & 0x7f] = Some(Register::$name);)*
            all
        };
    };
}

/// How many register indices there are.
pub const REGISTERS: usize = 128;

registers! {
    SrcBase = 0x1000 "V_FIFO_SETSTATE_SRCBASE",
    DstBase = 0x1004 "V_FIFO_SETSTATE_DSTBASE",
    DstFmt = 0x1006 "V_FIFO_SETSTATE_DSTFMT",
    PMask = 0x1007 "V_FIFO_SETSTATE_PMASK",
    Pat = 0x1008 "V_FIFO_SETSTATE_PAT",
    PatOffset = 0x100d "V_FIFO_SETSTATE_PATOFFSET",
    ScissorX = 0x100e "V_FIFO_SETSTATE_SCISSORX",
    ScissorY = 0x100f "V_FIFO_SETSTATE_SCISSORY",
    ZBase = 0x1010 "V_FIFO_SETSTATE_ZBASE",
    DitherOffset = 0x1011 "V_FIFO_SETSTATE_DITHEROFFSET",
    FgColorArgb = 0x3013 "V_FIFO_SETSTATE_FGCOLORARGB",
    BgColorArgb = 0x1014 "V_FIFO_SETSTATE_BGCOLORARGB",
    FogColorRgb = 0x1015 "V_FIFO_SETSTATE_FOGCOLORRGB",
    DstColorArgb = 0x1016 "V_FIFO_SETSTATE_DSTCOLORARGB",
    ChromaColor = 0x1017 "V_FIFO_SETSTATE_CHROMACOLOR",
    YuvContrast = 0x1018 "V_FIFO_SETSTATE_YUVCONTRAST",
    ChromaMask = 0x101a "V_FIFO_SETSTATE_CHROMAMASK",
    AlphaThreshold = 0x101d "V_FIFO_SETSTATE_ALPHATHRESHOLD",
    UMultiplier = 0x5028 "V_FIFO_SETSTATE_UMULTIPLIER",
    VMultiplier = 0x5029 "V_FIFO_SETSTATE_VMULTIPLIER",
    SOffset = 0x602a "V_FIFO_SETSTATE_SOFFSET",
    TOffset = 0x602b "V_FIFO_SETSTATE_TOFFSET",
    SrcFmt = 0x1030 "V_FIFO_SETSTATE_SRCFMT",
    SrcFunc = 0x1231 "V_FIFO_SETSTATE_SRCFUNC",
    SrcFilter = 0x13b2 "V_FIFO_SETSTATE_SRCFILTER",
    SrcColorNoPad = 0x14b3 "V_FIFO_SETSTATE_SRCCOLORNOPAD",
    SwapUv = 0x1534 "V_FIFO_SETSTATE_SWAPUV",
    ChromaKey = 0x15b5 "V_FIFO_SETSTATE_CHROMAKEY",
    ZScissor = 0x1636 "V_FIFO_SETSTATE_ZSCISSOR",
    SrcBgr = 0x16b7 "V_FIFO_SETSTATE_SRCBGR",
    UMask = 0x1038 "V_FIFO_SETSTATE_UMASK",
    VMask = 0x1839 "V_FIFO_SETSTATE_VMASK",
    SrcStride = 0x103a "V_FIFO_SETSTATE_SRCSTRIDE",
    DstStride = 0x143b "V_FIFO_SETSTATE_DSTSTRIDE",
    ZStride = 0x183c "V_FIFO_SETSTATE_ZSTRIDE",
    UClamp = 0x17be "V_FIFO_SETSTATE_UCLAMP",
    VClamp = 0x183f "V_FIFO_SETSTATE_VCLAMP",
    AluMode = 0x1040 "V_FIFO_SETSTATE_ALUMODE",
    BlendSrcFunc = 0x1241 "V_FIFO_SETSTATE_BLENDSRCFUNC",
    BlendDstFunc = 0x1442 "V_FIFO_SETSTATE_BLENDDSTFUNC",
    ZBufMode = 0x1643 "V_FIFO_SETSTATE_ZBUFMODE",
    ZBufWrMode = 0x1844 "V_FIFO_SETSTATE_ZBUFWRMODE",
    Yuv2Rgb = 0x9945 "V_FIFO_SETSTATE_YUV2RGB",
    BlendEnable = 0x89c6 "V_FIFO_SETSTATE_BLENDENABLE",
    DitherEnable = 0xaa47 "V_FIFO_SETSTATE_DITHERENABLE",
    FogEnable = 0x1ac8 "V_FIFO_SETSTATE_FOGENABLE",
    DstRdDisable = 0x1bca "V_FIFO_SETSTATE_DSTRDDISABLE",
    DstBgr = 0x1c4b "V_FIFO_SETSTATE_DSTBGR",
    TranspReject = 0x1ccc "V_FIFO_SETSTATE_TRANSPREJECT",
    PatLengthM1 = 0x1050 "V_FIFO_SETSTATE_PATLENGTHM1",
    PatEnable = 0x1851 "V_FIFO_SETSTATE_PATENABLE",
    PatOpaque = 0x18d2 "V_FIFO_SETSTATE_PATOPAQUE",
    SpecularEnable = 0x18d3 "V_FIFO_SETSTATE_SPECULARENABLE",
    Z = 0x2054 "V_FIFO_SETSTATE_Z",
    A = 0x2055 "V_FIFO_SETSTATE_A",
    R = 0x2056 "V_FIFO_SETSTATE_R",
    V = 0x2057 "V_FIFO_SETSTATE_V",
    G = 0x2058 "V_FIFO_SETSTATE_G",
    B = 0x2059 "V_FIFO_SETSTATE_B",
    U = 0x205a "V_FIFO_SETSTATE_U",
    F = 0x205b "V_FIFO_SETSTATE_F",
    SpecularColorRgb = 0x205c "V_FIFO_SETSTATE_SPECCOLORRGB",
}

impl Register {
    /// Its index, 0..[`REGISTERS`].
    #[inline]
    pub const fn index(self) -> usize {
        (self as u32 & 0x7f) as usize
    }

    /// The first word of the command that loads it.
    #[inline]
    pub const fn word(self) -> u32 {
        self as u32
    }

    /// The register that a command's first word sets, if it sets one.
    #[inline]
    pub fn from_word(word: u32) -> Option<Register> {
        let register = BY_INDEX[(word & 0x7f) as usize]?;
        (register.word() == word & 0xffff).then_some(register)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn registers_have_their_own_index() {
        for register in Register::ALL {
            assert_eq!(Register::from_word(register.word() | 0x00ff_0000), Some(*register));
        }
        assert_eq!(Register::from_word(0x1001), None);
        assert_eq!(Register::from_word(0x18), None);
    }
}
