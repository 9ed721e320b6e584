//! Triangles.

use super::Pen;
use super::clip::fits;
use super::convert::w_scale;
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
        let [a, b, c] = v;
        self.painter.triangle(|| [prepared.gouraud(a), prepared.gouraud(b), prepared.gouraud(c)]);
    }

    /// `QADrawTriTexture`; `at` says which of the multi-texture parameters are
    /// the corners'.
    pub fn tri_texture(&mut self, v: [&VTexture; 3], at: [usize; 3]) {
        if !self.may_draw() {
            return;
        }
        let Some(prepared) = self.context.prepared.as_deref() else { return };
        if !are_finite(v) && !v.iter().all(|v| is_finite_texture(v, prepared.op)) {
            return self.context.fail(RaveError::Parameter);
        }
        let Some(bound) = &prepared.bound[0] else {
            return self.tri_without_texture(v);
        };
        let params = &self.context.params[..prepared.layers];
        if params.iter().any(|layer| at.iter().any(|&i| i >= layer.len())) {
            return self.context.fail(RaveError::Parameter);
        }
        let fog = prepared.fog_source(v.iter().all(|v| v.inv_w > 0.0));
        let is_extended = prepared.extends_texture(fog);
        let texel_is_opaque = bound.opaque || prepared.has(texture_op::DECAL);
        let alpha_is_one = prepared.alpha_fog || v.iter().all(|v| v.a >= 1.0);
        let is_bright = |v: &VTexture| (v.kd_r > 1.0) | (v.kd_g > 1.0) | (v.kd_b > 1.0);
        let bright = prepared.has(texture_op::MODULATE) && v.iter().any(|v| is_bright(v));
        let variant = Variant {
            paint: Paint::Texture,
            opaque: prepared.is_opaque(alpha_is_one && texel_is_opaque),
            bright,
            fog,
            pattern: PatternUse::Area,
        };
        self.objects.usage.add(prepared.serial, &prepared.resources);
        self.choose(&variant);
        let Some(prepared) = self.context.prepared.as_deref() else { return };
        let Some(bound) = &prepared.bound[0] else { return };
        let scale = w_scale(v.map(|v| v.inv_w));
        let is_inside = v.iter().all(|v| fits(v.x, v.y));
        if prepared.layers == 0 && is_inside && !is_extended {
            let [a, b, c] = v;
            return self.painter.triangle(|| {
                [
                    prepared.textured::<0>(a, bound, scale),
                    prepared.textured::<0>(b, bound, scale),
                    prepared.textured::<0>(c, bound, scale),
                ]
            });
        }
        self.tri_layered(v, at, scale, is_extended);
    }

    /// A textured triangle that may have further layers, values beyond the engine's
    /// own, and parts outside the renderer's coordinates.
    fn tri_layered(&mut self, v: [&VTexture; 3], at: [usize; 3], scale: f32, is_extended: bool) {
        let Some(prepared) = self.context.prepared.as_deref() else { return };
        let Some(bound) = &prepared.bound[0] else { return };
        let params = &self.context.params[..prepared.layers];
        let corner = |i: usize| {
            let mut vertex = match prepared.layers {
                0 => prepared.textured::<0>(v[i], bound, scale),
                1 => prepared.textured::<1>(v[i], bound, scale),
                _ => prepared.textured::<2>(v[i], bound, scale),
            };
            for (layer, params) in params.iter().enumerate() {
                let unit = prepared.layers - 1 - layer;
                vertex.tmu[unit] = prepared.layer_coordinate(layer, &params[at[i]]);
            }
            Corner { vertex, extra: prepared.texture_extra(v[i]) }
        };
        let corners = [corner(0), corner(1), corner(2)];
        self.add(corners, is_extended);
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

/// Whether all of a vertex are numbers that can be drawn with.
#[inline]
pub(super) fn is_finite_gouraud(v: &VGouraud) -> bool {
    // Sums of numbers stay numbers, but for those of no screen.
    let place = v.x * 0.0 + v.y * 0.0 + v.z * 0.0 + v.inv_w * 0.0;
    let color = v.r * 0.0 + v.g * 0.0 + v.b * 0.0 + v.a * 0.0;
    place + color == 0.0
}

/// Four sums of a vertex's values times zero: zeros where all are numbers. They lie
/// in memory like this, so that four are read at a time.
#[inline(always)]
fn zeros(v: &VTexture) -> [f32; 4] {
    let [a, b] = [[v.x, v.y, v.z, v.inv_w], [v.r, v.g, v.b, v.a]];
    let [c, d] = [[v.u_over_w, v.v_over_w, v.kd_r, v.kd_g], [v.kd_b, v.ks_r, v.ks_g, v.ks_b]];
    core::array::from_fn(|i| (a[i] * 0.0 + b[i] * 0.0) + (c[i] * 0.0 + d[i] * 0.0))
}

/// Whether all values of all corners are numbers.
#[inline(always)]
fn are_finite([a, b, c]: [&VTexture; 3]) -> bool {
    let [a, b, c] = [zeros(a), zeros(b), zeros(c)];
    let [s, t, u, v] = core::array::from_fn(|i| a[i] + b[i] + c[i]);
    s + t + u + v == 0.0
}

/// As [`is_finite_gouraud`], for the values that the operations `op` read.
#[cold]
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
