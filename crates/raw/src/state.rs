//! The render state: everything a primitive takes along when it starts down the pipe.
//!
//! Source: RAW, render-state structures and defaults.

use std::sync::Arc;

use crate::color;
use crate::errata::Errata;
use crate::matrix::{self, IDENTITY, Matrix};
use crate::opcode::Opcode;
use crate::stage::InputVertex;

/// How colour and texture are combined; the words 0..=6, and 7 which acts as 0.
pub mod texmode {
    /// Opaque black.
    pub const NONE: u32 = 0;
    /// The colour alone.
    pub const COLOR: u32 = 1;
    /// The texture alone.
    pub const TEXTURE: u32 = 2;
    /// A weighted sum.
    pub const BLEND: u32 = 3;
    /// The texture as a decal over the colour.
    pub const TEXDECAL: u32 = 4;
    /// The colour as a decal over the texture.
    pub const COLDECAL: u32 = 5;
    /// The product.
    pub const MODULATE: u32 = 6;
}

/// How an alpha channel is conditioned.
pub mod alpha {
    /// Forced opaque.
    pub const NONE: u32 = 0;
    /// Used as it is.
    pub const SOFT: u32 = 1;
    /// Either 0 or 255, by threshold.
    pub const HARD: u32 = 2;
}

/// How texture coordinates outside 0..1 are treated.
pub mod textile {
    /// Transparent black outside.
    pub const NONE: u32 = 0;
    /// The texture repeats.
    pub const REPEAT: u32 = 1;
    /// The texture repeats, mirrored every other time.
    pub const MIRROR: u32 = 2;
    /// The edge texels continue.
    pub const CLAMP: u32 = 3;
}

/// What the vertices of a primitive make up; beyond the thesis but for the first.
pub mod topology {
    /// One triangle; further vertices are ignored.
    pub const TRIANGLE: u32 = 0;
    /// A triangle of every three vertices.
    pub const TRIANGLES: u32 = 1;
    /// A strip of triangles that share edges.
    pub const STRIP: u32 = 2;
    /// A fan of triangles that share the first vertex.
    pub const FAN: u32 = 3;
    /// A line of every two vertices.
    pub const LINES: u32 = 4;
    /// Lines from vertex to vertex.
    pub const LINE_STRIP: u32 = 5;
    /// Points; 7 acts as 6.
    pub const POINTS: u32 = 6;
}

/// What is done where a primitive leaves the view; beyond the thesis but for the first.
pub mod clip {
    /// It is dropped whole.
    pub const DROP: u32 = 0;
    /// It is cut at the near plane.
    pub const NEAR: u32 = 1;
    /// It is cut at all six planes; 3 acts as 2.
    pub const FRUSTUM: u32 = 2;
}

/// How the levels of a texture are used; beyond the thesis but for the first.
pub mod mipmap {
    /// The finest level alone.
    pub const OFF: u32 = 0;
    /// The nearest level.
    pub const NEAREST: u32 = 1;
    /// A blend of two levels; 3 acts as 2.
    pub const BLEND: u32 = 2;
}

macro_rules! mode_bits {
    ($($(#[$doc:meta])* $get:ident $set:ident $shift:literal $bits:literal;)+) => {
        /// The mode word of a primitive. The bit order is ours; the compiler's is not recorded.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub struct ModeBits(u32);

        impl ModeBits {
            $(
                $(#[$doc])*
                pub const fn $get(self) -> u32 {
                    self.0 >> $shift & ((1 << $bits) - 1)
                }

                #[doc = concat!("Sets `", stringify!($get), "` to the low bits of `value`.")]
                pub fn $set(&mut self, value: u32) {
                    let mask = ((1u32 << $bits) - 1) << $shift;
                    self.0 = self.0 & !mask | value << $shift & mask;
                }
            )+
        }
    };
}

mode_bits! {
    /// 1 when the primitive is visible (not culled).
    draw set_draw 0 1;
    /// 1 when lighting modulates the fragment.
    lit set_lit 1 1;
    /// 1 when the ambient term is used.
    use_amb set_use_amb 2 1;
    /// 1 when the directional term is used.
    use_dir set_use_dir 3 1;
    /// The combine mode, see [`texmode`].
    texmode set_texmode 4 3;
    /// How texture alpha is conditioned, see [`alpha`].
    tex_alpha set_tex_alpha 7 2;
    /// How colour alpha is conditioned, see [`alpha`].
    col_alpha set_col_alpha 9 2;
    /// 1 when colours are interpolated, 0 for the average of the vertices.
    col_interp set_col_interp 11 1;
    /// 1 when the directional intensity is interpolated.
    lit_interp set_lit_interp 12 1;
    /// 1 for bilinear texels, 0 for the nearest.
    tex_interp set_tex_interp 13 1;
    /// 1 when the primitive may be drawn out of order.
    out_of_order set_out_of_order 14 1;
    /// The treatment of texture coordinates, see [`textile`].
    textile set_textile 15 2;
    /// 1 to skip the depth test.
    no_use_z set_no_use_z 17 1;
    /// 1 to skip the depth write.
    no_write_z set_no_write_z 18 1;
    /// What the vertices make up, see [`topology`].
    topology set_topology 19 3;
    /// What happens at the borders of the view, see [`clip`].
    clip set_clip 22 2;
    /// How texture levels are used, see [`mipmap`].
    mipmap set_mipmap 24 2;
    /// 1 when further lights or highlights reach the primitive.
    more_light set_more_light 26 1;
}

impl ModeBits {
    /// The word itself.
    pub const fn word(self) -> u32 {
        self.0
    }

    /// Reads a mode word; bits above the fields are dropped.
    pub const fn from_word(word: u32) -> Self {
        Self(word & 0x7ff_ffff)
    }

    /// Whether anything of the primitive needs a depth.
    pub const fn touches_z(self) -> bool {
        self.no_use_z() == 0 || self.no_write_z() == 0
    }

    /// Whether the combine mode uses the vertex colour.
    pub const fn uses_color(self) -> bool {
        !matches!(self.texmode(), texmode::NONE | texmode::TEXTURE)
    }

    /// Whether the combine mode asks for texture coordinates (mode 7 does, as in the listing).
    pub const fn uses_texture(self) -> bool {
        self.texmode() > texmode::COLOR
    }

    /// Whether the directional light reaches the primitive.
    pub const fn uses_intensity(self) -> bool {
        self.lit() == 1 && self.use_dir() == 1
    }
}

impl Default for ModeBits {
    fn default() -> Self {
        let mut mode = Self(0);
        mode.set_texmode(texmode::COLOR);
        mode.set_tex_alpha(alpha::SOFT);
        mode.set_col_alpha(alpha::SOFT);
        mode.set_col_interp(1);
        mode.set_textile(textile::REPEAT);
        mode
    }
}

/// What travels down the pipe with each primitive: seven words in the thesis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrimInfo {
    /// The mode word.
    pub mode: ModeBits,
    /// The sequence number.
    pub seq_num: u32,
    /// The texture, an index into the manager's table.
    pub texture_id: u32,
    /// The weight of the colour in blend mode, 0.0 to 1.0.
    pub col_tex_balance: f32,
    /// The threshold of hard alpha.
    pub alpha_thresh: u32,
    /// Colour and intensity of the ambient light.
    pub amb_color: u32,
    /// Colour and intensity of the directional light.
    pub dir_color: u32,
    /// The side of a point in pixels.
    pub point_size: u32,
}

impl PrimInfo {
    /// Whether fragments of both are drawn alike; the order is another matter.
    pub fn draws_like(&self, other: &Self) -> bool {
        *self == Self { seq_num: self.seq_num, ..*other }
    }
}

impl Default for PrimInfo {
    fn default() -> Self {
        Self {
            mode: ModeBits::default(),
            seq_num: 1,
            texture_id: 0,
            col_tex_balance: 0.5,
            alpha_thresh: 128,
            amb_color: 0,
            dir_color: 0,
            point_size: 1,
        }
    }
}

/// The largest side of a point in pixels.
pub const MAX_POINT_SIZE: u32 = 64;
/// Directional lights beside the first.
pub const MORE_LIGHTS: usize = 7;
/// Vertices that can be kept.
pub const MAX_STORED: usize = 4096;

/// A directional light beside the first.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Light {
    /// Colour and intensity; intensity 0 is off.
    pub rgbi: u32,
    /// The direction in which it travels, in world space.
    pub direction: [f32; 3],
}

/// State beyond the thesis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Beyond {
    /// Lights 1 to 7.
    pub lights: [Light; MORE_LIGHTS],
    /// Colour and intensity of highlights.
    pub specular: u32,
    /// How narrow highlights are, 0..=255; 0 for none.
    pub exponent: u32,
    /// Where the viewer stands.
    pub eye: [f32; 3],
    /// Kept vertices, shared by all copies of the state until one changes them.
    pub stored: Arc<Vec<InputVertex>>,
}

impl Beyond {
    /// Whether anything beyond the first light and the ambient term shines.
    pub fn shines(&self) -> bool {
        self.exponent > 0 || self.lights.iter().any(|light| color::low(light.rgbi) > 0)
    }
}

/// The state all later vertices and primitives inherit.
#[derive(Clone, Debug, PartialEq)]
pub struct RenderState {
    /// One bit per stage-1 tile: the state has changed since that tile last looked.
    pub updated: u64,
    /// Model to world.
    pub model: Matrix,
    /// World to view: projection times camera.
    pub view: Matrix,
    /// View times model.
    pub model_view: Matrix,
    /// Turns model normals into world normals.
    pub normal_matrix: Matrix,
    /// The current normal.
    pub normal: [f32; 3],
    /// The current colour.
    pub rgba: u32,
    /// What the next primitive will take along; `seq_num` is the next sequence number.
    pub prim: PrimInfo,
    /// The direction in which the light travels, in world space, used as given.
    pub light: [f32; 3],
    /// Ambient reflectance, 0..=255.
    pub amb_reflect: u32,
    /// Directional reflectance, 0..=255.
    pub dir_reflect: u32,
    /// Whether a light direction was ever given.
    pub dir_defined: bool,
    /// The sequence number unordered primitives wait for.
    pub lagged_seq_num: u32,
    /// State beyond the thesis.
    pub beyond: Beyond,
    /// Commands beyond the thesis are unknown opcodes.
    pub thesis_only: bool,
}

/// Size of the state in words, as it crosses the memory network.
pub const STATE_WORDS: u64 = 83;

impl Default for RenderState {
    fn default() -> Self {
        Self {
            updated: 0xe,
            model: IDENTITY,
            view: IDENTITY,
            model_view: IDENTITY,
            normal_matrix: IDENTITY,
            normal: [1.0, 0.0, 0.0],
            rgba: color::OPAQUE,
            prim: PrimInfo::default(),
            light: [1.0, 0.0, 0.0],
            amb_reflect: 255,
            dir_reflect: 255,
            dir_defined: false,
            lagged_seq_num: 1,
            beyond: Beyond::default(),
            thesis_only: false,
        }
    }
}

impl RenderState {
    /// Carries out a command that only changes state. Returns false for every other command.
    ///
    /// `p` holds the command's parameter words; missing ones count as zero.
    pub fn execute(&mut self, op: Opcode, p: &[u32], errata: &Errata) -> bool {
        let word = p.first().copied().unwrap_or(0);
        match op {
            Opcode::Color => self.rgba = word,
            Opcode::ModelMatrix => self.set_model(matrix::from_words(p), errata),
            Opcode::ViewMatrix => self.set_view(matrix::from_words(p)),
            Opcode::Normal => self.normal = floats3(p),
            Opcode::SetTextureId => self.prim.texture_id = word,
            Opcode::ColTexBalance => self.prim.col_tex_balance = f32::from_bits(word),
            Opcode::AlphaThresh => self.prim.alpha_thresh = word,
            Opcode::AmbColor => self.prim.amb_color = word,
            Opcode::DirColor => self.prim.dir_color = word,
            Opcode::AmbReflect => self.amb_reflect = word,
            Opcode::DirReflect => self.dir_reflect = word,
            Opcode::DirLight => {
                self.light = floats3(p);
                self.dir_defined = true;
            }
            _ => return self.set_mode(op, word) || self.set_beyond(op, p),
        }
        true
    }

    fn set_mode(&mut self, op: Opcode, word: u32) -> bool {
        let mode = &mut self.prim.mode;
        match op {
            Opcode::SetLit => mode.set_lit(word),
            Opcode::SetUseAmb => mode.set_use_amb(word),
            Opcode::SetUseDir => mode.set_use_dir(word),
            Opcode::SetTexMode => mode.set_texmode(word),
            Opcode::SetTexAlpha => mode.set_tex_alpha(word),
            Opcode::SetColAlpha => mode.set_col_alpha(word),
            Opcode::SetColInterp => mode.set_col_interp(word),
            Opcode::SetLitInterp => mode.set_lit_interp(word),
            Opcode::SetTexInterp => mode.set_tex_interp(word),
            Opcode::SetOutOfOrder => mode.set_out_of_order(word),
            Opcode::SetTexTile => mode.set_textile(word),
            Opcode::SetNoUseZ => mode.set_no_use_z(word),
            Opcode::SetNoWriteZ => mode.set_no_write_z(word),
            Opcode::SetPrimitive => mode.set_topology(word),
            Opcode::SetClip => mode.set_clip(word),
            Opcode::SetMipMap => mode.set_mipmap(word),
            _ => return false,
        }
        true
    }

    fn set_beyond(&mut self, op: Opcode, p: &[u32]) -> bool {
        let word = |i: usize| p.get(i).copied().unwrap_or(0);
        match op {
            Opcode::SetPointSize => self.prim.point_size = word(0).clamp(1, MAX_POINT_SIZE),
            Opcode::Eye => self.beyond.eye = floats3(p),
            Opcode::Specular => {
                self.beyond.specular = word(0);
                self.beyond.exponent = word(1).min(255);
            }
            Opcode::Light => {
                let direction = floats3(p.get(2..).unwrap_or(&[]));
                let light = Light { rgbi: word(1), direction };
                // Number 0 is the light of the thesis, which has commands of its own.
                let place = (word(0) as usize).wrapping_sub(1);
                if let Some(slot) = self.beyond.lights.get_mut(place) {
                    *slot = light;
                }
            }
            Opcode::StoreVertex => self.store(word(0) as usize, p.get(1..).unwrap_or(&[])),
            _ => return false,
        }
        true
    }

    fn store(&mut self, index: usize, p: &[u32]) {
        if index >= MAX_STORED {
            return;
        }
        let vertex = self.latch(p);
        let stored = Arc::make_mut(&mut self.beyond.stored);
        if stored.len() <= index {
            stored.resize(index + 1, InputVertex::default());
        }
        stored[index] = vertex;
    }

    /// Whether a command may be used: those beyond the thesis can be switched off.
    pub fn allows(&self, op: Opcode) -> bool {
        !(self.thesis_only && op.is_beyond())
    }

    /// A vertex with the current colour and normal from its five words.
    pub fn latch(&self, p: &[u32]) -> InputVertex {
        let f = |i: usize| f32::from_bits(p.get(i).copied().unwrap_or(0));
        InputVertex {
            position: [f(0), f(1), f(2)],
            uv: [f(3), f(4)],
            normal: self.normal,
            rgba: self.rgba,
        }
    }

    fn set_model(&mut self, model: Matrix, errata: &Errata) {
        self.model = model;
        self.model_view = matrix::multiply(&self.view, &self.model);
        self.normal_matrix = matrix::cofactors(&self.model);
        // The cofactor matrix carries the determinant; its sign would turn normals inside out.
        if !errata.normals_flip && matrix::determinant3(&self.model) < 0.0 {
            for row in &mut self.normal_matrix[..3] {
                *row = row.map(|c| -c);
            }
        }
    }

    fn set_view(&mut self, view: Matrix) {
        self.view = view;
        self.model_view = matrix::multiply(&self.view, &self.model);
    }
}

fn floats3(p: &[u32]) -> [f32; 3] {
    let at = |i: usize| f32::from_bits(p.get(i).copied().unwrap_or(0));
    [at(0), at(1), at(2)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mode_fields_keep_low_bits_only() {
        let mut mode = ModeBits::default();
        mode.set_lit(2);
        assert_eq!(mode.lit(), 0);
        mode.set_texmode(15);
        assert_eq!(mode.texmode(), 7);
        assert_eq!(ModeBits::from_word(mode.word()), mode);
    }

    #[test]
    fn defaults_are_the_documented_ones() {
        let state = RenderState::default();
        let mode = state.prim.mode;
        assert_eq!((mode.texmode(), mode.tex_alpha(), mode.col_alpha()), (1, 1, 1));
        assert_eq!((mode.lit(), mode.col_interp(), mode.textile()), (0, 1, 1));
        assert_eq!((state.prim.alpha_thresh, state.rgba), (128, 0xff));
    }

    #[test]
    fn mirrored_model_keeps_normals_outside() {
        let mut words = IDENTITY.as_flattened().iter().map(|f| f.to_bits()).collect::<Vec<_>>();
        words[0] = (-1.0f32).to_bits();
        let mut state = RenderState::default();
        state.execute(Opcode::ModelMatrix, &words, &Errata::CORRECT);
        assert_eq!(state.normal_matrix[1][1], 1.0);
        state.execute(Opcode::ModelMatrix, &words, &Errata::FAITHFUL);
        assert_eq!(state.normal_matrix[1][1], -1.0);
    }
}
