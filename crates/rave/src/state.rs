//! The state variables of a draw context: values, defaults, ranges.
//!
//! Values are kept as the program set them, once they are within their ranges;
//! [`crate::translate`] says what they mean.
//!
//! Source: RAVE, state variables.

use crate::constants::{compare, context, fog, texture_op};
use crate::handle::TextureId;
use crate::tags::{MAX_WIDTH, ati, float, int, pointer};

/// Tags of the standard state are below.
const TAGS: usize = 160;

/// The most textures besides the first, `kQAGestalt_MultiTextureMax`.
pub const MAX_LAYERS: usize = 2;

/// What tag `MultiTextureCurrent` chooses among.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Layer {
    pub texture: Option<TextureId>,
    pub op: u32,
    pub filter: u32,
    pub wrap: [u32; 2],
    /// Magnifying and minifying.
    pub gl_filters: [u32; 2],
    pub gl: GlFilters,
    pub mipmap_bias: f32,
    /// Alpha, red, green, blue.
    border: [f32; 4],
    /// The program set one of them.
    has_border: bool,
    pub factor: f32,
    /// Alpha, red, green, blue.
    pub env_color: [f32; 4],
}

impl Layer {
    const DEFAULT: Layer = Layer {
        texture: None,
        op: 0,
        filter: 0,
        wrap: [0; 2],
        gl_filters: [0; 2],
        gl: GlFilters { magnify: false, minify: false },
        mipmap_bias: 0.5,
        border: [0.0; 4],
        has_border: false,
        factor: 0.5,
        env_color: [0.0; 4],
    };

    /// The colour around its texture, 0xAARRGGBB, once the program set it.
    pub fn border(&self) -> Option<u32> {
        let clamps = self.wrap.iter().any(|&wrap| wrap != 0);
        (clamps && self.has_border).then(|| argb(self.border))
    }

    fn int(&mut self, tag: u32) -> Option<&mut u32> {
        Some(match tag {
            int::MULTI_TEXTURE_OP => &mut self.op,
            int::MULTI_TEXTURE_FILTER => &mut self.filter,
            int::MULTI_TEXTURE_WRAP_U => &mut self.wrap[0],
            int::MULTI_TEXTURE_WRAP_V => &mut self.wrap[1],
            int::MULTI_TEXTURE_MAG_FILTER => &mut self.gl_filters[0],
            int::MULTI_TEXTURE_MIN_FILTER => &mut self.gl_filters[1],
            _ => return None,
        })
    }

    fn float(&mut self, tag: u32) -> Option<&mut f32> {
        let at = |first: u32| (tag - first) as usize;
        Some(match tag {
            float::MULTI_TEXTURE_MIPMAP_BIAS => &mut self.mipmap_bias,
            float::MULTI_TEXTURE_BORDER_A..=float::MULTI_TEXTURE_BORDER_B => {
                self.has_border = true;
                &mut self.border[at(float::MULTI_TEXTURE_BORDER_A)]
            }
            float::MULTI_TEXTURE_FACTOR => &mut self.factor,
            float::MULTI_TEXTURE_ENV_COLOR_A..=float::MULTI_TEXTURE_ENV_COLOR_B => {
                &mut self.env_color[at(float::MULTI_TEXTURE_ENV_COLOR_A)]
            }
            _ => return None,
        })
    }
}

/// Which filters count: those of `TextureFilter`, or of OpenGL's tags that were
/// set since.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct GlFilters {
    pub magnify: bool,
    pub minify: bool,
}

/// All state variables of a draw context.
#[derive(Clone, Debug)]
pub(crate) struct State {
    ints: [u32; TAGS],
    floats: [f32; TAGS],
    pub texture: Option<TextureId>,
    pub layers: [Layer; MAX_LAYERS],
    pub gl_filters: GlFilters,
    /// The program set a part of the texture border's colour.
    has_border: bool,
    has_z: bool,
}

impl State {
    /// The state of a new context of `width` x `height` pixels.
    pub fn new(flags: u32, width: u32, height: u32) -> State {
        let has_z = flags & context::NO_Z_BUFFER == 0;
        let mut state = State {
            ints: [0; TAGS],
            floats: [0.0; TAGS],
            texture: None,
            layers: [Layer::DEFAULT; MAX_LAYERS],
            gl_filters: GlFilters::default(),
            has_border: false,
            has_z,
        };
        let double = flags & context::DOUBLE_BUFFER != 0;
        for (tag, value) in [
            (int::Z_FUNCTION, if has_z { compare::LT } else { compare::NONE }),
            (int::ANTIALIAS, crate::constants::antialias::FAST),
            (int::CSG_TAG, u32::MAX),
            (int::CHANNEL_MASK, 0xf),
            (int::Z_BUFFER_MASK, 1),
            (int::GL_DRAW_BUFFER, if double { GL_BACK } else { GL_FRONT }),
            (int::GL_SCISSOR_X_MAX, width),
            (int::GL_SCISSOR_Y_MAX, height),
            (int::GL_BLEND_SRC, 1),
            (int::GL_LINE_PATTERN, 0xffff),
            (int::GL_LINE_PATTERN_FACTOR, 1),
        ] {
            state.ints[tag as usize] = value;
        }
        let patterns = int::GL_AREA_PATTERN_0 as usize..=int::GL_AREA_PATTERN_31 as usize;
        state.ints[patterns].fill(u32::MAX);
        let deep = flags & context::DEEP_Z != 0;
        for (tag, value) in [
            (float::WIDTH, 1.0),
            (float::Z_MIN_OFFSET, if deep { -1.0 / 16_777_216.0 } else { -1.0 / 65_536.0 }),
            (float::Z_MIN_SCALE, 1.0),
            (float::FOG_END, 1.0),
            (float::FOG_DENSITY, 1.0),
            (float::FOG_MAX_DEPTH, 1.0),
            (float::MIPMAP_BIAS, 0.5),
            (float::BITMAP_SCALE_X, 1.0),
            (float::BITMAP_SCALE_Y, 1.0),
            (float::GL_DEPTH_BG, 1.0),
        ] {
            state.floats[tag as usize] = value;
        }
        state
    }

    /// A standard integer variable.
    pub fn int(&self, tag: u32) -> u32 {
        self.ints.get(tag as usize).copied().unwrap_or(0)
    }

    /// A standard float variable.
    pub fn float(&self, tag: u32) -> f32 {
        self.floats.get(tag as usize).copied().unwrap_or(0.0)
    }

    /// A colour whose alpha has this tag, as 0xAARRGGBB.
    pub fn color(&self, alpha_tag: u32) -> u32 {
        argb(core::array::from_fn(|i| self.float(alpha_tag + i as u32)))
    }

    /// The colour around the texture, 0xAARRGGBB, once the program set it, where
    /// the texture is clamped as OpenGL does.
    pub fn border(&self) -> Option<u32> {
        let shrinks = self.int(int::TEXTURE_OP) & texture_op::SHRINK != 0;
        let clamps = self.int(int::GL_TEXTURE_WRAP_U) | self.int(int::GL_TEXTURE_WRAP_V) != 0;
        (self.has_border && clamps && !shrinks).then(|| self.color(float::GL_TEXTURE_BORDER_A))
    }

    /// The rows of the area pattern.
    pub fn area_pattern(&self) -> [u32; 32] {
        core::array::from_fn(|row| self.ints[int::GL_AREA_PATTERN_0 as usize + row])
    }

    /// `QAGetInt`: 0 for what is no integer variable.
    pub fn get_int(&self, tag: u32) -> u32 {
        if let Some(alias) = ati_int(tag) {
            return self.get_ati(tag, alias);
        }
        if !is_int(tag) {
            return 0;
        }
        match self.layer() {
            Some(layer) if is_layer_int(tag) => {
                let mut layer = self.layers[layer];
                layer.int(tag).map_or(0, |value| *value)
            }
            _ => self.int(tag),
        }
    }

    /// `QAGetFloat`: 0 for what is no float variable.
    pub fn get_float(&self, tag: u32) -> f32 {
        let tag = ati_float(tag).unwrap_or(tag);
        if !is_float(tag) {
            return 0.0;
        }
        let layer = self.layer().map(|layer| self.layers[layer]);
        match layer.and_then(|mut layer| layer.float(tag).copied()) {
            Some(value) => value,
            None => self.float(tag),
        }
    }

    /// `QAGetPtr` of a texture.
    pub fn get_texture(&self, tag: u32) -> Option<TextureId> {
        match tag {
            pointer::TEXTURE => self.texture,
            pointer::MULTI_TEXTURE => self.layers[self.layer()?].texture,
            _ => None,
        }
    }

    /// `QASetInt`. What is no integer variable, or out of its range, does
    /// nothing.
    pub fn set_int(&mut self, tag: u32, value: u32) {
        if let Some(alias) = ati_int(tag) {
            return self.set_ati(tag, alias, value);
        }
        if !is_int(tag) {
            return;
        }
        let Some(value) = self.accepted(tag, value) else { return };
        match tag {
            int::TEXTURE_FILTER => self.gl_filters = GlFilters::default(),
            int::GL_TEXTURE_MAG_FILTER => self.gl_filters.magnify = true,
            int::GL_TEXTURE_MIN_FILTER => self.gl_filters.minify = true,
            _ => {}
        }
        if is_layer_int(tag) {
            let Some(layer) = self.layer().map(|layer| &mut self.layers[layer]) else { return };
            match tag {
                int::MULTI_TEXTURE_FILTER => layer.gl = GlFilters::default(),
                int::MULTI_TEXTURE_MAG_FILTER => layer.gl.magnify = true,
                int::MULTI_TEXTURE_MIN_FILTER => layer.gl.minify = true,
                _ => {}
            }
            if let Some(place) = layer.int(tag) {
                *place = value;
            }
            return;
        }
        self.ints[tag as usize] = value;
    }

    /// `QASetFloat`. What is no float variable, is read only or not a number
    /// does nothing.
    pub fn set_float(&mut self, tag: u32, value: f32) {
        let tag = ati_float(tag).unwrap_or(tag);
        let read_only = matches!(tag, float::Z_MIN_OFFSET | float::Z_MIN_SCALE);
        if !is_float(tag) || read_only || value.is_nan() {
            return;
        }
        let value = match tag {
            float::WIDTH => value.clamp(0.0, MAX_WIDTH),
            _ if is_unit(tag) => value.clamp(0.0, 1.0),
            _ => value.clamp(f32::MIN, f32::MAX),
        };
        let layer = self.layer().map(|layer| &mut self.layers[layer]);
        self.has_border |= (float::GL_TEXTURE_BORDER_A..=float::GL_TEXTURE_BORDER_B).contains(&tag);
        match layer.and_then(|layer| layer.float(tag)) {
            Some(place) => *place = value,
            None => self.floats[tag as usize] = value,
        }
    }

    /// `QASetPtr` of a texture.
    pub fn set_texture(&mut self, tag: u32, texture: Option<TextureId>) {
        match (tag, self.layer()) {
            (pointer::TEXTURE, _) => self.texture = texture,
            (pointer::MULTI_TEXTURE, Some(layer)) => self.layers[layer].texture = texture,
            _ => {}
        }
    }

    /// The layer that the multi-texture tags address.
    pub fn layer(&self) -> Option<usize> {
        let layer = self.int(int::MULTI_TEXTURE_CURRENT) as usize;
        (layer < MAX_LAYERS).then_some(layer)
    }

    /// The value that a variable takes; `None`: it stays.
    fn accepted(&self, tag: u32, value: u32) -> Option<u32> {
        let up_to = |last: u32| (value <= last).then_some(value);
        match tag {
            int::Z_FUNCTION if !self.has_z => None,
            int::Z_FUNCTION => up_to(compare::FALSE),
            int::ALPHA_TEST_FUNC => Some(value & 7),
            int::ANTIALIAS => up_to(3),
            int::BLEND
            | int::TEXTURE_FILTER
            | int::BUFFER_COMPOSITE
            | int::MULTI_TEXTURE_FILTER
            | int::BITMAP_FILTER
            | int::DRAW_CONTEXT_FILTER => up_to(2),
            int::PERSPECTIVE_Z
            | int::Z_BUFFER_MASK
            | int::Z_SORTED_HINT
            | int::CHROMAKEY_ENABLE
            | int::DONT_SWAP
            | int::MULTI_TEXTURE_WRAP_U
            | int::MULTI_TEXTURE_WRAP_V
            | int::MULTI_TEXTURE_MAG_FILTER
            | int::MULTI_TEXTURE_MIN_FILTER
            | int::GL_TEXTURE_WRAP_U
            | int::GL_TEXTURE_WRAP_V
            | int::GL_TEXTURE_MAG_FILTER
            | int::GL_TEXTURE_MIN_FILTER => up_to(1),
            int::TEXTURE_OP => up_to(31),
            int::FOG_MODE => up_to(fog::EXPONENTIAL_SQUARED),
            int::CHANNEL_MASK => up_to(15),
            int::MULTI_TEXTURE_ENABLE => up_to(MAX_LAYERS as u32),
            int::MULTI_TEXTURE_CURRENT => up_to(MAX_LAYERS as u32 - 1),
            int::MULTI_TEXTURE_OP => up_to(3),
            int::GL_BLEND_SRC => is_source_factor(value).then_some(value),
            int::GL_BLEND_DST => is_destination_factor(value).then_some(value),
            int::GL_LINE_PATTERN => Some(value & 0xffff),
            int::GL_LINE_PATTERN_FACTOR => Some(value.clamp(1, 256)),
            _ => Some(value),
        }
    }

    fn get_ati(&self, tag: u32, alias: u32) -> u32 {
        let value = self.int(alias);
        match tag {
            ati::FOG_MODE => ATI_FOG_MODES.iter().position(|&m| m == value).unwrap_or(0) as u32,
            ati::ALPHA_TEST_ENABLE => u32::from(value != compare::NONE),
            _ => ati_channel(tag).map_or(value, |bit| u32::from(value & bit != 0)),
        }
    }

    fn set_ati(&mut self, tag: u32, alias: u32, value: u32) {
        let value = match tag {
            ati::FOG_MODE => match ATI_FOG_MODES.get(value as usize) {
                Some(&mode) => mode,
                None => return,
            },
            ati::ENABLE_Z_WRITE => u32::from(value != 0),
            ati::ALPHA_TEST_ENABLE if value == 0 => compare::NONE,
            // Switching on leaves a function that is there.
            ati::ALPHA_TEST_ENABLE => match self.int(alias) {
                compare::NONE => compare::GT,
                function => function,
            },
            _ => match ati_channel(tag) {
                Some(bit) if value != 0 => self.int(alias) | bit,
                Some(bit) => self.int(alias) & !bit,
                None => value,
            },
        };
        self.set_int(alias, value);
    }
}

/// OpenGL's draw buffers.
const GL_FRONT: u32 = 3;
const GL_BACK: u32 = 12;

/// The fog modes that ATI's numbers mean.
const ATI_FOG_MODES: [u32; 5] =
    [fog::NONE, fog::EXPONENTIAL, fog::EXPONENTIAL_SQUARED, fog::ALPHA, fog::LINEAR];

/// 0..=1 as 0..=255, to the nearest; what is outside counts as the nearest.
pub(crate) fn unit_byte(value: f32) -> u32 {
    (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u32
}

/// Alpha, red, green and blue, 0..=1, as 0xAARRGGBB.
fn argb(color: [f32; 4]) -> u32 {
    color.into_iter().fold(0, |argb, channel| argb << 8 | unit_byte(channel))
}

fn is_int(tag: u32) -> bool {
    use int::*;
    matches!(tag,
        Z_FUNCTION
        | ANTIALIAS..=TEXTURE_OP
        | CSG_TAG..=FOG_MODE
        | CHANNEL_MASK..=MULTI_TEXTURE_MIN_FILTER
        | BITMAP_FILTER
        | DRAW_CONTEXT_FILTER
        | GL_DRAW_BUFFER..=GL_LINE_PATTERN
        | GL_AREA_PATTERN_0..=GL_LINE_PATTERN_FACTOR)
}

fn is_layer_int(tag: u32) -> bool {
    (int::MULTI_TEXTURE_OP..=int::MULTI_TEXTURE_MIN_FILTER).contains(&tag)
}

fn is_float(tag: u32) -> bool {
    use float::*;
    matches!(tag,
        COLOR_BG_A..=Z_MIN_SCALE
        | FOG_COLOR_A..=FOG_MAX_DEPTH
        | MIPMAP_BIAS..=BITMAP_SCALE_Y
        | MULTI_TEXTURE_ENV_COLOR_A..=MULTI_TEXTURE_ENV_COLOR_B
        | GL_DEPTH_BG..=GL_TEXTURE_BORDER_B
        | GL_TEXTURE_ENV_COLOR_A..=GL_TEXTURE_ENV_COLOR_B)
}

/// Whether a float variable is a colour, or another with the range 0..=1.
fn is_unit(tag: u32) -> bool {
    use float::*;
    matches!(tag,
        COLOR_BG_A..=COLOR_BG_B
        | FOG_COLOR_A..=FOG_COLOR_B
        | CHROMAKEY_R..=MULTI_TEXTURE_FACTOR
        | MULTI_TEXTURE_ENV_COLOR_A..=MULTI_TEXTURE_ENV_COLOR_B
        | GL_DEPTH_BG..=GL_TEXTURE_BORDER_B
        | GL_TEXTURE_ENV_COLOR_A..=GL_TEXTURE_ENV_COLOR_B)
}

/// The standard variable that an integer tag of ATI stands for.
fn ati_int(tag: u32) -> Option<u32> {
    Some(match tag {
        ati::FOG_MODE => int::FOG_MODE,
        ati::ENABLE_Z_WRITE => int::Z_BUFFER_MASK,
        ati::ALPHA_TEST_ENABLE | ati::ALPHA_TEST_FUNC => int::ALPHA_TEST_FUNC,
        ati::ALPHA_ENABLE..=ati::BLUE_ENABLE => int::CHANNEL_MASK,
        _ => return None,
    })
}

/// The standard variable that a float tag of ATI stands for.
fn ati_float(tag: u32) -> Option<u32> {
    Some(match tag {
        ati::FOG_COLOR_R => float::FOG_COLOR_R,
        ati::FOG_COLOR_G => float::FOG_COLOR_G,
        ati::FOG_COLOR_B => float::FOG_COLOR_B,
        ati::FOG_COLOR_A => float::FOG_COLOR_A,
        ati::FOG_DENSITY => float::FOG_DENSITY,
        ati::FOG_START => float::FOG_START,
        ati::FOG_END => float::FOG_END,
        ati::ALPHA_TEST_REF => float::ALPHA_TEST_REF,
        _ => return None,
    })
}

/// The channel that a tag of ATI switches.
fn ati_channel(tag: u32) -> Option<u32> {
    use crate::constants::channel;
    Some(match tag {
        ati::ALPHA_ENABLE => channel::ALPHA,
        ati::RED_ENABLE => channel::RED,
        ati::GREEN_ENABLE => channel::GREEN,
        ati::BLUE_ENABLE => channel::BLUE,
        _ => return None,
    })
}

/// OpenGL 1.1's source factors.
fn is_source_factor(value: u32) -> bool {
    matches!(value, 0 | 1 | 0x302..=0x308)
}

/// OpenGL 1.1's destination factors.
fn is_destination_factor(value: u32) -> bool {
    matches!(value, 0 | 1 | 0x300..=0x305)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_out_of_range_changes_nothing() {
        let mut state = State::new(0, 320, 220);
        state.set_int(int::BLEND, 1);
        state.set_int(int::BLEND, 9);
        assert_eq!(state.get_int(int::BLEND), 1);
        state.set_int(int::ALPHA_TEST_FUNC, 518);
        assert_eq!(state.get_int(int::ALPHA_TEST_FUNC), 6);
        state.set_float(float::WIDTH, 400.0);
        assert_eq!(state.get_float(float::WIDTH), 128.0);
        state.set_float(float::WIDTH, f32::NAN);
        assert_eq!(state.get_float(float::WIDTH), 128.0);
        state.set_float(float::COLOR_BG_A, -1.0);
        assert_eq!(state.get_float(float::COLOR_BG_A), 0.0);
        state.set_float(float::Z_MIN_SCALE, 3.0);
        assert_eq!(state.get_float(float::Z_MIN_SCALE), 1.0);
    }

    #[test]
    fn types_do_not_mix() {
        let mut state = State::new(0, 320, 220);
        state.set_int(float::WIDTH, 7);
        state.set_float(int::BLEND, 1.0);
        state.set_int(9999, 1);
        assert_eq!((state.get_int(float::WIDTH), state.get_float(int::BLEND)), (0, 0.0));
        assert_eq!((state.get_int(9999), state.get_float(9999)), (0, 0.0));
        assert_eq!((state.get_float(float::WIDTH), state.get_int(int::BLEND)), (1.0, 0));
    }

    #[test]
    fn without_z_there_is_no_function() {
        let mut state = State::new(context::NO_Z_BUFFER, 8, 8);
        state.set_int(int::Z_FUNCTION, compare::TRUE);
        assert_eq!(state.get_int(int::Z_FUNCTION), compare::NONE);
    }

    #[test]
    fn layers_are_addressed_by_the_current_one() {
        let mut state = State::new(0, 8, 8);
        state.set_int(int::MULTI_TEXTURE_OP, 1);
        state.set_int(int::MULTI_TEXTURE_CURRENT, 1);
        state.set_int(int::MULTI_TEXTURE_OP, 3);
        state.set_float(float::MULTI_TEXTURE_FACTOR, 0.25);
        state.set_texture(pointer::MULTI_TEXTURE, Some(TextureId(4)));
        assert_eq!((state.layers[0].op, state.layers[1].op), (1, 3));
        assert_eq!((state.layers[0].factor, state.layers[1].factor), (0.5, 0.25));
        state.set_int(int::MULTI_TEXTURE_CURRENT, 0);
        assert_eq!(state.get_int(int::MULTI_TEXTURE_OP), 1);
        assert_eq!(state.get_texture(pointer::MULTI_TEXTURE), None);
        assert_eq!(state.layers[1].texture, Some(TextureId(4)));
    }

    #[test]
    fn ati_tags_stand_for_standard_ones() {
        let mut state = State::new(0, 8, 8);
        for (number, mode) in ATI_FOG_MODES.into_iter().enumerate() {
            state.set_int(ati::FOG_MODE, number as u32);
            assert_eq!(state.get_int(int::FOG_MODE), mode);
            assert_eq!(state.get_int(ati::FOG_MODE), number as u32);
        }
        state.set_float(ati::FOG_DENSITY, 3.0);
        assert_eq!(state.get_float(float::FOG_DENSITY), 3.0);
        state.set_int(ati::RED_ENABLE, 0);
        assert_eq!(state.get_int(int::CHANNEL_MASK), 0xe);
        assert_eq!((state.get_int(ati::RED_ENABLE), state.get_int(ati::BLUE_ENABLE)), (0, 1));
        state.set_int(ati::ALPHA_TEST_ENABLE, 1);
        assert_eq!(state.get_int(int::ALPHA_TEST_FUNC), compare::GT);
        state.set_int(ati::ENABLE_Z_WRITE, 0);
        assert_eq!(state.get_int(int::Z_BUFFER_MASK), 0);
    }
}
