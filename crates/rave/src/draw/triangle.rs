//! Triangles.

use super::Pen;
use super::clip::{LIMIT, fits};
use super::convert::{USUAL_W, w_scale};
use crate::RaveError;
use crate::constants::texture_op;
use crate::painter::Corner;
use crate::translate::{Paint, PatternUse, Variant};
use crate::vertex::{VGouraud, VTexture};

impl Pen<'_> {
    /// `QADrawTriGouraud`.
    pub fn tri_gouraud(&mut self, v: [&VGouraud; 3]) {
        if !self.may_draw() {
            return;
        }
        if !v.iter().all(|v| is_finite_gouraud(v)) {
            return self.context.fail(RaveError::Parameter);
        }
        let Some(prepared) = self.context.prepared.as_deref() else { return };
        let alpha_is_one = prepared.alpha_fog || v.iter().all(|v| v.a >= 1.0);
        let fog = prepared.fog_source(v.iter().all(|v| v.inv_w > 0.0));
        let is_extended = prepared.extends(fog);
        let variant = Variant {
            paint: Paint::Gouraud,
            opaque: prepared.is_opaque(alpha_is_one),
            bright: false,
            fog,
            pattern: PatternUse::Area,
        };
        self.choose(&variant);
        let Some(prepared) = self.context.prepared.as_deref() else { return };
        if is_extended || !v.iter().all(|v| fits(v.x, v.y)) {
            let extra = |v: &VGouraud| prepared.extra(v.z, v.inv_w, v.a);
            let corners = v.map(|v| Corner { vertex: prepared.gouraud(v), extra: extra(v) });
            return self.add(corners, is_extended);
        }
        self.painter.triangle(|i| prepared.gouraud(v[i]));
    }

    /// `QADrawTriTexture`; `at` says which of the multi-texture parameters are
    /// the corners'.
    #[inline]
    pub fn tri_texture(&mut self, v: [&VTexture; 3], at: [usize; 3]) {
        if !self.may_draw() {
            return;
        }
        let Some(prepared) = self.context.prepared.as_deref() else { return };
        if !prepared.is_plain || !are_usual(v) {
            return self.tri_any(v, at);
        }
        let alpha_is_one = v.iter().all(|v| v.a >= 1.0);
        let variant = prepared.variant(true, alpha_is_one, false);
        self.objects.usage.add(prepared.serial, &prepared.resources);
        self.choose(&variant);
        let Some(prepared) = self.context.prepared.as_deref() else { return };
        let Some(bound) = &prepared.bound[0] else { return };
        self.painter.triangle(
            // Otherwise they are made elsewhere, and copied.
            #[inline(always)]
            |i| prepared.usual(v[i], bound),
        );
    }

    /// A textured triangle with whatever texture operations, layers and values.
    fn tri_any(&mut self, v: [&VTexture; 3], at: [usize; 3]) {
        let Some(prepared) = self.context.prepared.as_deref() else { return };
        if !v.iter().all(|v| is_finite_texture(v, prepared.op)) {
            return self.context.fail(RaveError::Parameter);
        }
        if prepared.bound[0].is_none() {
            return self.tri_without_texture(v);
        }
        let params = &self.context.params[..prepared.layers];
        if params.iter().any(|layer| at.iter().any(|&i| i >= layer.len())) {
            return self.context.fail(RaveError::Parameter);
        }
        let has_w = v.iter().all(|v| v.inv_w > 0.0);
        let alpha_is_one = prepared.alpha_fog || v.iter().all(|v| v.a >= 1.0);
        let bright = prepared.has(texture_op::MODULATE)
            && v.iter().any(|v| v.kd_r.max(v.kd_g).max(v.kd_b) > 1.0);
        let variant = prepared.variant(has_w, alpha_is_one, bright);
        let is_extended = prepared.extends_texture(variant.fog);
        self.objects.usage.add(prepared.serial, &prepared.resources);
        self.choose(&variant);
        let Some(prepared) = self.context.prepared.as_deref() else { return };
        let Some(bound) = &prepared.bound[0] else { return };
        let params = &self.context.params[..prepared.layers];
        let scale = w_scale(v.map(|v| v.inv_w));
        let corner = |i: usize| {
            let mut vertex = prepared.textured(v[i], bound, scale);
            for (layer, params) in params.iter().enumerate() {
                let unit = prepared.layers - 1 - layer;
                vertex.tmu[unit] = prepared.layer_coordinate(layer, &params[at[i]]);
            }
            Corner { vertex, extra: prepared.texture_extra(v[i]) }
        };
        self.add([0, 1, 2].map(corner), is_extended);
    }

    /// A textured triangle while no texture is set: its diffuse colour.
    fn tri_without_texture(&mut self, v: [&VTexture; 3]) {
        let [a, b, c] = v.map(plain);
        self.tri_gouraud([&a, &b, &c]);
    }
}

/// A textured vertex with its diffuse colour alone.
pub(super) fn plain(v: &VTexture) -> VGouraud {
    VGouraud { x: v.x, y: v.y, z: v.z, inv_w: v.inv_w, r: v.kd_r, g: v.kd_g, b: v.kd_b, a: v.a }
}

/// Whether nothing of the corners has to be limited, scaled or refused: places
/// within the renderer's coordinates, usual 1/w, and z, alpha and diffuse colours
/// of 0..=1.
#[inline(always)]
fn are_usual([a, b, c]: [&VTexture; 3]) -> bool {
    (excess(a) | excess(b) | excess(c)) as i32 >= 0
}

/// A number whose highest bit is on where a vertex is not usual.
#[inline(always)]
fn excess(v: &VTexture) -> u32 {
    const ONE: u32 = 1.0f32.to_bits();
    const PLACE: u32 = LIMIT.to_bits() - 1;
    let [low_w, high_w] = [USUAL_W.start().to_bits(), USUAL_W.end().to_bits()];
    // Floats of one sign are in the order of their bits, numbers before all else.
    let outside = |bits: u32, low: u32, high: u32| {
        let above = bits.wrapping_sub(low);
        (high - low).wrapping_sub(above) | above
    };
    let unit = |value: f32| outside(value.to_bits(), 0, ONE);
    let size = |value: f32, limit: u32| outside(value.abs().to_bits(), 0, limit);
    let place = size(v.x, PLACE) | size(v.y, PLACE) | unit(v.z);
    let color = unit(v.a) | unit(v.kd_r) | unit(v.kd_g) | unit(v.kd_b);
    let texture = size(v.u_over_w, f32::MAX.to_bits()) | size(v.v_over_w, f32::MAX.to_bits());
    place | color | texture | outside(v.inv_w.to_bits(), low_w, high_w)
}

/// Whether all of a vertex are numbers that can be drawn with.
#[inline]
pub(super) fn is_finite_gouraud(v: &VGouraud) -> bool {
    // Sums of numbers stay numbers, but for those of no screen.
    let place = v.x * 0.0 + v.y * 0.0 + v.z * 0.0 + v.inv_w * 0.0;
    let color = v.r * 0.0 + v.g * 0.0 + v.b * 0.0 + v.a * 0.0;
    place + color == 0.0
}

/// As [`is_finite_gouraud`], for the values that the operations `op` read.
#[inline]
fn is_finite_texture(v: &VTexture, op: u32) -> bool {
    let place = v.x * 0.0 + v.y * 0.0 + v.z * 0.0 + v.inv_w * 0.0;
    let texture = v.u_over_w * 0.0 + v.v_over_w * 0.0 + v.a * 0.0;
    let mut sum = place + texture;
    if op & texture_op::MODULATE != 0 {
        sum += v.kd_r * 0.0 + v.kd_g * 0.0 + v.kd_b * 0.0;
    }
    if op & texture_op::HIGHLIGHT != 0 {
        sum += v.ks_r * 0.0 + v.ks_g * 0.0 + v.ks_b * 0.0;
    }
    if op & (texture_op::DECAL | texture_op::BLEND) != 0 {
        sum += v.r * 0.0 + v.g * 0.0 + v.b * 0.0;
    }
    sum == 0.0
}
