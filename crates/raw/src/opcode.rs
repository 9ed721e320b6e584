//! The 47 commands of the device, with their sizes and the modes they are legal in, and those that
//! go beyond the thesis, from [`FIRST_BEYOND`] on.
//!
//! Source: RAW, chapter 4 (command tables) and the command listings; chapter 6 for what lies
//! beyond, with numbers of our own.

/// Which of the two device modes a command may be used in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Modes {
    /// Only in command mode.
    Command,
    /// Only in scene-streaming mode.
    Scene,
    /// In both modes.
    Both,
}

macro_rules! opcodes {
    ($($(#[$doc:meta])* $name:ident = $value:literal, $historic:literal, $modes:ident,
        $input:literal, $output:literal;)+) => {
        /// A command of the device; the discriminant is the opcode word.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[repr(u32)]
        pub enum Opcode { $($(#[$doc])* $name = $value,)+ }

        impl Opcode {
            /// Every opcode in ascending order: those of the thesis, then those beyond it.
            pub const ALL: &'static [Opcode] = &[$(Opcode::$name,)+];

            /// Decodes an opcode word, if there is such a command.
            pub const fn from_word(word: u32) -> Option<Self> {
                match word { $($value => Some(Opcode::$name),)+ _ => None }
            }

            /// The name in the thesis.
            pub const fn name(self) -> &'static str {
                match self { $(Opcode::$name => $historic,)+ }
            }

            /// The modes in which the command is legal.
            pub const fn modes(self) -> Modes {
                match self { $(Opcode::$name => Modes::$modes,)+ }
            }

            /// Number of fixed parameter words, without the data of a block.
            pub const fn inputs(self) -> usize {
                match self { $(Opcode::$name => $input,)+ }
            }

            /// Number of words the command returns, without the data of a block.
            pub const fn outputs(self) -> usize {
                match self { $(Opcode::$name => $output,)+ }
            }
        }
    };
}

opcodes! {
    /// Enters scene-streaming mode.
    BeginScene = 1, "RENDER_BEGINSCENE", Command, 0, 1;
    /// Leaves scene-streaming mode; an end-of-primitive marker must follow.
    EndScene = 2, "RENDER_ENDSCENE", Scene, 0, 1;
    /// A vertex: x, y, z, u, v.
    Vertex = 3, "RENDER_VERTEX", Scene, 5, 0;
    /// The colour of the vertices that follow.
    Color = 4, "RENDER_COLOR", Both, 1, 0;
    /// The model-to-world matrix, row by row.
    ModelMatrix = 5, "RENDER_MODELMATRIX", Both, 16, 0;
    /// The world-to-view matrix, row by row.
    ViewMatrix = 6, "RENDER_VIEWMATRIX", Both, 16, 0;
    /// The normal of the vertices that follow.
    Normal = 7, "RENDER_NORMAL", Both, 3, 0;
    /// Turns lighting on.
    SetLit = 8, "RENDER_SET_LIT", Both, 1, 0;
    /// Uses the ambient term.
    SetUseAmb = 9, "RENDER_SET_USEAMB", Both, 1, 0;
    /// Uses the directional term.
    SetUseDir = 10, "RENDER_SET_USEDIR", Both, 1, 0;
    /// How colour and texture are combined, 0..=6.
    SetTexMode = 11, "RENDER_SET_TEXMODE", Both, 1, 0;
    /// How texture alpha is conditioned, 0..=2.
    SetTexAlpha = 12, "RENDER_SET_TEXALPHA", Both, 1, 0;
    /// How colour alpha is conditioned, 0..=2.
    SetColAlpha = 13, "RENDER_SET_COLALPHA", Both, 1, 0;
    /// Interpolates colours.
    SetColInterp = 14, "RENDER_SET_COLINTERP", Both, 1, 0;
    /// Interpolates the directional intensity.
    SetLitInterp = 15, "RENDER_SET_LITINTERP", Both, 1, 0;
    /// Bilinear instead of nearest texels.
    SetTexInterp = 16, "RENDER_SET_TEXINTERP", Both, 1, 0;
    /// Lets primitives be drawn out of order.
    SetOutOfOrder = 17, "RENDER_SET_OUTOFORDER", Both, 1, 0;
    /// How texture coordinates outside 0..1 are treated, 0..=3.
    SetTexTile = 18, "RENDER_SET_TEXTILE", Both, 1, 0;
    /// Skips the depth test.
    SetNoUseZ = 19, "RENDER_SET_NOUSEZ", Both, 1, 0;
    /// Skips the depth write.
    SetNoWriteZ = 20, "RENDER_SET_NOWRITEZ", Both, 1, 0;
    /// Chooses the texture.
    SetTextureId = 21, "RENDER_SET_TEXTUREID", Both, 1, 0;
    /// The weight of the colour in blend mode, a float.
    ColTexBalance = 22, "RENDER_COLTEXBALANCE", Both, 1, 0;
    /// The threshold of hard alpha, 0..=255.
    AlphaThresh = 23, "RENDER_ALPHATHRESH", Both, 1, 0;
    /// Colour and intensity of the ambient light.
    AmbColor = 24, "RENDER_AMBCOLOR", Both, 1, 0;
    /// Colour and intensity of the directional light.
    DirColor = 25, "RENDER_DIRCOLOR", Both, 1, 0;
    /// The direction in which the light travels, in world space.
    DirLight = 26, "RENDER_DIRLIGHT", Both, 3, 0;
    /// How much ambient light surfaces reflect, 0..=255.
    AmbReflect = 27, "RENDER_AMBREFLECT", Both, 1, 0;
    /// How much directional light surfaces reflect, 0..=255.
    DirReflect = 28, "RENDER_DIRREFLECT", Both, 1, 0;
    /// Fills pages of the frame buffer: page mask, colour.
    ClearFb = 29, "RENDER_CLEARFB", Command, 2, 0;
    /// Sets every depth to the farthest value.
    ClearZ = 30, "RENDER_CLEARZ", Command, 0, 0;
    /// Chooses the pages fragments are drawn to: page mask.
    SetPage = 31, "RENDER_SETPAGE", Command, 1, 0;
    /// Swaps front and back page; non-zero waits for vertical sync.
    FlipPage = 32, "RENDER_FLIPPAGE", Command, 1, 0;
    /// Allocates a texture of width x height texels; returns its id or -1.
    AllocateTexture = 33, "RENDER_ALLOCATE_TEXTURE", Command, 2, 1;
    /// Frees a texture.
    DeallocTexture = 34, "RENDER_DEALLOC_TEXTURE", Command, 1, 0;
    /// Writes n texels of a texture: id, n, data.
    UploadTexture = 35, "RENDER_UPLOAD_TEXTURE", Command, 2, 0;
    /// Returns the free texture memory in bytes.
    TexMemAvail = 36, "RENDER_TEXMEM_AVAIL", Command, 0, 1;
    /// Moves all textures together.
    CompactTexMem = 37, "RENDER_COMPACT_TEXMEM", Command, 0, 0;
    /// Writes one pixel: x, y, page mask, colour.
    WriteFb = 38, "RENDER_WRITE_FB", Command, 4, 0;
    /// Writes a run of pixels: x, y, page mask, n, data.
    WriteFbBlock = 39, "RENDER_WRITE_FB_BLOCK", Command, 4, 0;
    /// Reads one pixel: x, y, page.
    ReadFb = 40, "RENDER_READ_FB", Command, 3, 1;
    /// Reads a run of pixels: x, y, page, n.
    ReadFbBlock = 41, "RENDER_READ_FB_BLOCK", Command, 4, 0;
    /// Writes one depth: x, y, value.
    WriteZ = 42, "RENDER_WRITE_Z", Command, 3, 0;
    /// Writes a run of depths: x, y, n, data.
    WriteZBlock = 43, "RENDER_WRITE_Z_BLOCK", Command, 3, 0;
    /// Reads one depth: x, y.
    ReadZ = 44, "RENDER_READ_Z", Command, 2, 1;
    /// Reads a run of depths: x, y, n.
    ReadZBlock = 45, "RENDER_READ_Z_BLOCK", Command, 3, 0;
    /// Puts the device back to its defaults.
    Reset = 46, "RENDER_RESET", Command, 0, 0;
    /// Stops the device for good.
    Halt = 47, "RENDER_HALT", Command, 0, 0;
    /// What the vertices of a primitive make up, see [`crate::state::topology`].
    SetPrimitive = 64, "RENDERX_SET_PRIMITIVE", Both, 1, 0;
    /// What is done where a primitive leaves the view, see [`crate::state::clip`].
    SetClip = 65, "RENDERX_SET_CLIP", Both, 1, 0;
    /// How levels of a texture are used, see [`crate::state::mipmap`].
    SetMipMap = 66, "RENDERX_SET_MIPMAP", Both, 1, 0;
    /// The side of a point in pixels, 1..=64.
    SetPointSize = 67, "RENDERX_SET_POINTSIZE", Both, 1, 0;
    /// Keeps a vertex with the current colour and normal: index, x, y, z, u, v.
    StoreVertex = 68, "RENDERX_STORE_VERTEX", Both, 6, 0;
    /// Adds a kept vertex to the primitive: index.
    Index = 69, "RENDERX_INDEX", Scene, 1, 0;
    /// A further light: number 1..=7, rgb and intensity, direction.
    Light = 70, "RENDERX_LIGHT", Both, 5, 0;
    /// Highlights: rgb and intensity of the surface, exponent 0..=255; exponent 0 for none.
    Specular = 71, "RENDERX_SPECULAR", Both, 2, 0;
    /// Where the viewer stands, in world space; for highlights.
    Eye = 72, "RENDERX_EYE", Both, 3, 0;
    /// Allocates a texture with all its levels; returns its id or -1.
    AllocateMipMapped = 73, "RENDERX_ALLOCATE_MIPMAPPED", Command, 2, 1;
    /// Makes the levels of a texture from its finest one.
    MakeMipMaps = 74, "RENDERX_MAKE_MIPMAPS", Command, 1, 0;
    /// Changes the resolution: width, height; both pages become black, depths far.
    Resize = 75, "RENDERX_RESIZE", Command, 2, 0;
}

/// The first opcode beyond the thesis.
pub const FIRST_BEYOND: u32 = 64;

impl Opcode {
    /// Whether the command goes beyond the thesis.
    pub const fn is_beyond(self) -> bool {
        self as u32 >= FIRST_BEYOND
    }

    /// Decodes a word as a command that is legal in command mode.
    pub fn in_command_mode(word: u32) -> Option<Self> {
        Self::from_word(word).filter(|op| op.modes() != Modes::Scene)
    }

    /// Decodes a word as a command that is legal in scene-streaming mode.
    pub fn in_scene_mode(word: u32) -> Option<Self> {
        Self::from_word(word).filter(|op| op.modes() != Modes::Command)
    }

    /// The command that does for one pixel or depth what a word of this command's block does.
    pub const fn of_one_word(self) -> Self {
        match self {
            Opcode::WriteFbBlock => Opcode::WriteFb,
            Opcode::WriteZBlock => Opcode::WriteZ,
            other => other,
        }
    }

    /// Where the length of the data that follows stands among the parameters, if the command is
    /// followed by a block of data words.
    pub const fn data_length_at(self) -> Option<usize> {
        match self {
            Opcode::UploadTexture => Some(1),
            Opcode::WriteFbBlock => Some(3),
            Opcode::WriteZBlock => Some(2),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn opcodes_are_dense_and_round_trip() {
        for (index, op) in Opcode::ALL.iter().enumerate() {
            let first = if op.is_beyond() { FIRST_BEYOND as usize - 47 } else { 1 };
            assert_eq!(*op as usize, index + first);
            assert_eq!(Opcode::from_word(*op as u32), Some(*op));
        }
        assert_eq!(Opcode::from_word(0), None);
        assert_eq!(Opcode::from_word(48), None);
    }

    #[test]
    fn modes_filter_commands() {
        assert_eq!(Opcode::in_command_mode(3), None);
        assert_eq!(Opcode::in_scene_mode(30), None);
        assert_eq!(Opcode::in_scene_mode(21), Some(Opcode::SetTextureId));
    }
}
