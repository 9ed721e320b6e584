//! Vertices of the program to those of the engine.

use fillrate_engine::{TmuVertex, Vertex, VertexExtra};

use super::prepare::{Bound, Prepared};
use crate::constants::texture_op;
use crate::painter::{DEEP_MAX, Z16_MAX};
use crate::vertex::{VGouraud, VMultiTexture, VTexture};

/// The greatest factor of a modulation: the engine's 2047 of 255.
const MAX_DIFFUSE: f32 = 8.0;

/// 0..=1 as 0..=255.
#[inline(always)]
fn byte(value: f32) -> f32 {
    value.clamp(0.0, 1.0) * 255.0
}

impl Prepared {
    /// A coloured corner. Vertex alpha that is fog leaves the corner opaque.
    #[inline(always)]
    pub(super) fn gouraud(&self, v: &VGouraud) -> Vertex {
        Vertex {
            x: v.x,
            y: v.y,
            r: byte(v.r),
            g: byte(v.g),
            b: byte(v.b),
            a: if self.alpha_fog { 255.0 } else { byte(v.a) },
            z: v.z.clamp(0.0, 1.0) * Z16_MAX,
            w: v.inv_w * self.w_scale,
            ..Vertex::default()
        }
    }

    /// What stays of a corner's colour under fog, and its depth in a deep plane.
    pub(super) fn extra(&self, z: f32, inv_w: f32, a: f32) -> VertexExtra {
        let fog = match &self.curve {
            _ if self.alpha_fog => byte(a),
            Some(curve) => {
                let distance = if inv_w > 0.0 { 1.0 / f64::from(inv_w) } else { self.depth_of(z) };
                curve.stays(distance) as f32 * 255.0
            }
            None => 255.0,
        };
        let deep_z = f64::from(z.clamp(0.0, 1.0)) * f64::from(DEEP_MAX);
        VertexExtra { fog, deep_z, ..VertexExtra::default() }
    }

    /// The distance of a vertex that has no w.
    fn depth_of(&self, z: f32) -> f64 {
        f64::from(z.clamp(0.0, 1.0)) * f64::from(self.fog_max_depth)
    }

    /// The same as [`Prepared::textured`] of a corner with nothing to limit, where
    /// the state is plain.
    #[inline(always)]
    pub(super) fn usual(&self, v: &VTexture, bound: &Bound) -> Vertex {
        Vertex {
            x: v.x,
            y: v.y,
            r: v.kd_r * 255.0,
            g: v.kd_g * 255.0,
            b: v.kd_b * 255.0,
            a: v.a * 255.0,
            z: v.z * Z16_MAX,
            w: v.inv_w * self.w_scale,
            tmu: [
                coordinate(v.inv_w, v.u_over_w, v.v_over_w, bound, 1.0),
                TmuVertex::default(),
                TmuVertex::default(),
            ],
        }
    }

    /// A textured corner, without the coordinates of further layers. `scale`
    /// multiplies all that is divided by w.
    pub(super) fn textured(&self, v: &VTexture, bound: &Bound, scale: f32) -> Vertex {
        let diffuse = |kd: f32| kd.clamp(0.0, MAX_DIFFUSE) * 255.0;
        let modulates = self.has(texture_op::MODULATE);
        let [r, g, b] = if !modulates {
            [byte(v.r), byte(v.g), byte(v.b)]
        } else if self.has(texture_op::BLEND) && !self.has(texture_op::DECAL) {
            [byte(v.kd_r), byte(v.kd_g), byte(v.kd_b)]
        } else {
            [diffuse(v.kd_r), diffuse(v.kd_g), diffuse(v.kd_b)]
        };
        let mut vertex = Vertex {
            x: v.x,
            y: v.y,
            r,
            g,
            b,
            a: if self.alpha_fog { 255.0 } else { byte(v.a) },
            z: v.z.clamp(0.0, 1.0) * Z16_MAX,
            w: v.inv_w * self.w_scale,
            ..Vertex::default()
        };
        vertex.tmu[self.layers] = coordinate(v.inv_w, v.u_over_w, v.v_over_w, bound, scale);
        vertex
    }

    /// The values of a textured corner beyond the engine's own.
    pub(super) fn texture_extra(&self, v: &VTexture) -> VertexExtra {
        let mut extra = self.extra(v.z, v.inv_w, v.a);
        extra.specular = [byte(v.ks_r), byte(v.ks_g), byte(v.ks_b)];
        extra.base = [byte(v.r), byte(v.g), byte(v.b)];
        extra
    }

    /// The coordinates of a layer.
    pub(super) fn layer_coordinate(&self, layer: usize, v: &VMultiTexture) -> TmuVertex {
        match &self.bound[layer + 1] {
            Some(bound) => coordinate(v.inv_w, v.u_over_w, v.v_over_w, bound, 1.0),
            None => TmuVertex::default(),
        }
    }
}

/// Texels to the right and down; v runs up from the last row.
#[inline(always)]
fn coordinate(inv_w: f32, u: f32, v: f32, bound: &Bound, scale: f32) -> TmuVertex {
    let down = if bound.flipped { v } else { inv_w - v };
    TmuVertex { s: u * bound.size[0] * scale, t: down * bound.size[1] * scale, w: inv_w * scale }
}

/// 1/w that the engine's registers hold well.
pub(super) const USUAL_W: core::ops::RangeInclusive<f32> = 1.0 / 64.0..=1024.0;

/// A power of two that brings 1/w of a triangle into the range where the
/// engine's 32 fraction bits and 16 integer bits are plenty; 1 for usual ones.
#[inline]
pub(super) fn w_scale(inv_w: [f32; 3]) -> f32 {
    let greatest = inv_w[0].max(inv_w[1]).max(inv_w[2]);
    if USUAL_W.contains(&greatest) {
        return 1.0;
    }
    if !(f32::MIN_POSITIVE..f32::MAX).contains(&greatest) {
        return 1.0;
    }
    let exponent = (greatest.to_bits() >> 23) as i32 - 127;
    f32::from_bits(((127 - exponent).clamp(1, 254) as u32) << 23)
}
