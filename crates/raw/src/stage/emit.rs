//! Stage 2, second half: from interpolated values to a fragment.

use super::{UntexFragment, Vertex, trunc_i32};
use crate::color;
use crate::errata::Errata;
use crate::state::ModeBits;

/// Interpolated attributes in the order of the walker's lanes.
pub const LANES: usize = 14;
/// The lanes that the thesis has; the rest is light beyond it.
pub const THESIS_LANES: usize = 8;
/// Lanes of red, green and blue.
pub const RGB: usize = 0;
/// Lane of alpha.
pub const ALPHA: usize = 3;
/// Lanes of the texture coordinates.
pub const UV: usize = 4;
/// Lane of the intensity.
pub const INTENSITY: usize = 6;
/// Lane of 1/w.
pub const W1: usize = 7;
/// Lanes of further light.
pub const MORE: usize = 8;

/// The value of a lane at a vertex.
pub fn lane(v: &Vertex, lane: usize) -> f32 {
    match lane {
        RGB..=ALPHA => v.rgba[lane],
        4 => v.u,
        5 => v.v,
        INTENSITY => v.intensity,
        W1 => v.w1,
        _ => v.more[lane - MORE],
    }
}

/// Which attributes the mode interpolates, derived once per primitive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Interpolants {
    /// Depth.
    pub z: bool,
    /// Red, green and blue.
    pub color: bool,
    /// Alpha of the colour.
    pub alpha: bool,
    /// Texture coordinates.
    pub uv: bool,
    /// Directional intensity.
    pub intensity: bool,
    /// The flat average of the colour is needed.
    pub flat_color: bool,
    /// The flat average of the intensity is needed.
    pub flat_intensity: bool,
    /// Beyond the thesis: light of further lights and highlights.
    pub more: bool,
    /// Beyond the thesis: how far texture coordinates move.
    pub footprint: bool,
}

impl Interpolants {
    /// Reads the needs off the mode.
    pub fn of(mode: ModeBits) -> Self {
        let smooth = mode.uses_color() && mode.col_interp() == 1;
        let lit = mode.uses_intensity();
        Self {
            z: mode.touches_z(),
            color: smooth,
            alpha: smooth && mode.col_alpha() != 0,
            uv: mode.uses_texture(),
            intensity: lit && mode.lit_interp() == 1,
            flat_color: mode.uses_color() && !smooth,
            flat_intensity: lit && mode.lit_interp() == 0,
            more: mode.more_light() == 1,
            footprint: mode.uses_texture() && mode.mipmap() != 0,
        }
    }

    /// Whether 1/w has to be interpolated, and w recovered per fragment.
    pub fn perspective(&self) -> bool {
        self.color || self.uv || self.intensity || self.more
    }

    /// Number of planes that have to be set up.
    pub fn planes(&self) -> u32 {
        u32::from(self.z)
            + 3 * u32::from(self.color)
            + u32::from(self.alpha)
            + 2 * u32::from(self.uv)
            + u32::from(self.intensity)
            + 6 * u32::from(self.more)
            + u32::from(self.perspective())
    }

    /// Whether a lane is interpolated.
    pub fn has(&self, lane: usize) -> bool {
        match lane {
            RGB..ALPHA => self.color,
            ALPHA => self.alpha,
            UV..INTENSITY => self.uv,
            INTENSITY => self.intensity,
            W1 => self.perspective(),
            _ => self.more,
        }
    }
}

/// Values without interpolation: the average of the vertices.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Flat {
    rgba: u32,
    intensity: f32,
}

/// Makes fragments of one primitive.
#[derive(Clone, Copy, Debug)]
pub struct Emitter {
    /// What is interpolated.
    pub needs: Interpolants,
    flat: Flat,
    mask_channels: bool,
    overflow_depth: bool,
}

impl Emitter {
    /// An emitter for a primitive with these corners: three of a triangle, two of a line, one of a
    /// point.
    pub fn new(corners: &[Vertex], mode: ModeBits, errata: &Errata) -> Self {
        let needs = Interpolants::of(mode);
        Self {
            needs,
            flat: flat_values(corners, mode, needs, errata),
            mask_channels: errata.channels_wrap,
            overflow_depth: errata.depth_overflows,
        }
    }

    /// The fragment at a pixel from depth and lanes; `steps` are the slopes of the lanes along both
    /// axes, where there are any.
    #[inline(always)]
    pub fn fragment(
        &self,
        x: u32,
        y: u32,
        z: f32,
        lanes: &[f32; LANES],
        steps: Option<[&[f32; LANES]; 2]>,
    ) -> UntexFragment {
        let needs = &self.needs;
        let w = if needs.perspective() { 1.0 / lanes[W1] } else { 0.0 };
        let (u, v) = if needs.uv { (lanes[UV] * w, lanes[UV + 1] * w) } else { (0.0, 0.0) };
        let mut out = UntexFragment {
            x,
            y,
            z: if needs.z { self.depth(z) } else { 0 },
            u,
            v,
            rgba: if needs.color { self.color(lanes, w) } else { self.flat.rgba },
            intensity: if needs.intensity { lanes[INTENSITY] * w } else { self.flat.intensity },
            ..UntexFragment::default()
        };
        if needs.footprint
            && let Some(steps) = steps
        {
            out.footprint = footprint(u, v, w, steps);
        }
        if needs.more {
            let byte = |i: usize| channel(lanes[MORE + i] * w, false);
            out.diffuse = color::pack(byte(0), byte(1), byte(2), 0);
            out.specular = color::pack(byte(3), byte(4), byte(5), 0);
        }
        out
    }

    /// A depth as a word.
    #[inline(always)]
    pub fn depth(&self, z: f32) -> i32 {
        // As f32 the scale is 2^31, one more than the largest depth.
        let scaled = z * 2_147_483_648.0;
        if self.overflow_depth && scaled >= 2_147_483_648.0 { i32::MIN } else { trunc_i32(scaled) }
    }

    #[inline(always)]
    fn color(&self, lanes: &[f32; LANES], w: f32) -> u32 {
        let byte = |lane: usize| channel(lanes[lane] * w, self.mask_channels);
        let alpha = if self.needs.alpha { byte(ALPHA) } else { 0 };
        color::pack(byte(RGB), byte(RGB + 1), byte(RGB + 2), alpha)
    }
}

/// How far u and v move from this pixel to the next, the larger of both axes: the slopes of the
/// quotients `u = U / q`, `v = V / q`, where `w = 1 / q`.
fn footprint(u: f32, v: f32, w: f32, steps: [&[f32; LANES]; 2]) -> [f32; 2] {
    let along = |lane: usize, value: f32| {
        let slope = |step: &[f32; LANES]| ((step[lane] - value * step[W1]) * w).abs();
        slope(steps[0]).max(slope(steps[1]))
    };
    [along(UV, u), along(UV + 1, v)]
}

/// Rounds a channel to a byte; `mask` keeps the low byte instead of clamping.
fn channel(value: f32, mask: bool) -> u32 {
    let rounded = trunc_i32(value + 0.5);
    if mask { rounded as u32 & 0xff } else { rounded.clamp(0, 255) as u32 }
}

fn flat_values(v: &[Vertex], mode: ModeBits, needs: Interpolants, errata: &Errata) -> Flat {
    let average = |f: &dyn Fn(&Vertex) -> f32| {
        let sum = v.iter().map(|v| f(v) * (1.0 / v.w1)).reduce(|a, b| a + b).unwrap_or(0.0);
        sum / v.len() as f32
    };
    let mut flat = Flat::default();
    if needs.flat_color {
        let byte = |i: usize| channel(average(&|v| v.rgba[i]), errata.channels_wrap);
        let alpha = if mode.col_alpha() != 0 { byte(3) } else { 0 };
        flat.rgba = color::pack(byte(0), byte(1), byte(2), alpha);
    }
    if needs.flat_intensity {
        flat.intensity = average(&|v| v.intensity);
    }
    flat
}
