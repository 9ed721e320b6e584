//! Triangles.

use fillrate_engine::{Vertex, VertexExtra};

use super::Pen;
use super::convert::w_scale;
use crate::RaveError;
use crate::batch::Corner;
use crate::constants::texture_op;
use crate::painter::Z16_MAX;
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
        let corners = v.map(|v| prepared.gouraud(v));
        let extras = is_extended.then(|| v.map(|v| prepared.extra(v.z, v.inv_w, v.a)));
        let variant = Variant {
            paint: Paint::Gouraud,
            opaque: prepared.is_opaque(alpha_is_one),
            bright: false,
            fog,
            z_overflows: z_overflows(&corners),
            pattern: PatternUse::Area,
        };
        self.choose(&variant);
        self.add_with(corners, extras);
    }

    /// `QADrawTriTexture`; `at` says which of the multi-texture parameters are
    /// the corners'.
    pub fn tri_texture(&mut self, v: [&VTexture; 3], at: [usize; 3]) {
        if !self.may_draw() {
            return;
        }
        let Some(prepared) = self.context.prepared.as_deref() else { return };
        if !v.iter().all(|v| is_finite_texture(v, prepared.op)) {
            return self.context.fail(RaveError::Parameter);
        }
        let Some(bound) = &prepared.bound[0] else {
            return self.tri_without_texture(v);
        };
        let params = &self.context.params;
        if params[..prepared.layers].iter().any(|layer| at.iter().any(|&i| i >= layer.len())) {
            return self.context.fail(RaveError::Parameter);
        }
        let fog = prepared.fog_source(v.iter().all(|v| v.inv_w > 0.0));
        let is_extended = prepared.extends_texture(fog);
        let scale = w_scale([v[0].inv_w, v[1].inv_w, v[2].inv_w]);
        let corner = |i: usize| {
            let mut vertex = prepared.textured(v[i], bound, scale);
            for (layer, params) in params.iter().enumerate().take(prepared.layers) {
                let unit = prepared.layers - 1 - layer;
                vertex.tmu[unit] = prepared.layer_coordinate(layer, &params[at[i]]);
            }
            vertex
        };
        let corners = [corner(0), corner(1), corner(2)];
        let extras = is_extended.then(|| v.map(|v| prepared.texture_extra(v)));
        let texel_is_opaque = bound.opaque || prepared.has(texture_op::DECAL);
        let alpha_is_one = prepared.alpha_fog || v.iter().all(|v| v.a >= 1.0);
        let bright = prepared.has(texture_op::MODULATE)
            && v.iter().any(|v| v.kd_r.max(v.kd_g).max(v.kd_b) > 1.0);
        let variant = Variant {
            paint: Paint::Texture,
            opaque: prepared.is_opaque(alpha_is_one && texel_is_opaque),
            bright,
            fog,
            z_overflows: z_overflows(&corners),
            pattern: PatternUse::Area,
        };
        self.use_textures();
        self.choose(&variant);
        self.add_with(corners, extras);
    }

    /// Adds corners, with values beyond the engine's own where there are any.
    #[inline(always)]
    fn add_with(&mut self, corners: [Vertex; 3], extras: Option<[VertexExtra; 3]>) {
        match extras {
            None => self.add(corners),
            Some(extras) => self.add_extended(core::array::from_fn(|i| Corner {
                vertex: corners[i],
                extra: extras[i],
            })),
        }
    }

    /// A textured triangle while no texture is set: its diffuse colour.
    fn tri_without_texture(&mut self, v: [&VTexture; 3]) {
        let [a, b, c] = v.map(plain);
        self.tri_gouraud([&a, &b, &c]);
    }

    /// Counts a polygon for all textures that are set.
    fn use_textures(&mut self) {
        let Some(prepared) = self.context.prepared.as_deref() else { return };
        self.objects.usage.add(&prepared.resources);
    }
}

/// A textured vertex with its diffuse colour alone.
pub(super) fn plain(v: &VTexture) -> VGouraud {
    VGouraud { x: v.x, y: v.y, z: v.z, inv_w: v.inv_w, r: v.kd_r, g: v.kd_g, b: v.kd_b, a: v.a }
}

/// Whether fragments of a triangle may get a z outside 0..=65535: its corners
/// are moved by a sixteenth of a pixel, its plane is not. Conservative.
#[inline]
fn z_overflows([a, b, c]: &[Vertex; 3]) -> bool {
    let low = a.z.min(b.z).min(c.z);
    let high = a.z.max(b.z).max(c.z);
    let span = high - low;
    if span == 0.0 {
        return false;
    }
    // Where the triangle is an eighth of a pixel high at least, its plane rises
    // by less than the span in a sixteenth, to either side.
    let (ab, ac) = ([b.x - a.x, b.y - a.y], [c.x - a.x, c.y - a.y]);
    let area = (ab[0] * ac[1] - ab[1] * ac[0]).abs();
    let length = ab[0].abs() + ab[1].abs() + ac[0].abs() + ac[1].abs();
    !(low >= span && high + span <= Z16_MAX && area * 8.0 >= length)
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
