//! Stage 1: transform, visibility, lighting at the vertices, perspective premultiply.
//!
//! Source: RAW, geometry listing, in its order of operations; all arithmetic in f32.

use super::{InputVertex, TransPrim, Vertex};
use crate::color::{self, mul};
use crate::errata::Errata;
use crate::matrix::{self, Matrix};
use crate::state::{ModeBits, PrimInfo, RenderState, texmode};

/// The smallest w that counts as in front of the eye.
pub const MIN_W: f32 = 1e-6;

/// What stage 1 did with a primitive, for the cost model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GeometryWork {
    /// Vertices that went through directional lighting: 0 or 3.
    pub lit_vertices: u32,
    /// Attributes multiplied by 1/w beyond position and colour: alpha, texture, intensity.
    pub extra_attributes: u32,
    /// Whether the primitive survived the visibility tests.
    pub visible: bool,
}

/// Takes one primitive through stage 1.
///
/// `info` is the pipe's copy of the primitive's state (with its sequence number and its
/// ordered or unordered decision); its `draw` bit and ambient intensity are filled in here. `state`
/// supplies the matrices and the light; it is only written in the faithful mode that lets the
/// ambient light decay.
pub fn process(
    state: &mut RenderState,
    mut info: PrimInfo,
    input: &[InputVertex; 3],
    errata: &Errata,
) -> (TransPrim, GeometryWork) {
    let mut vertices = input.map(|v| transform_vertex(&state.model_view, &v));
    let visible = is_visible(&vertices, errata);
    info.mode.set_draw(u32::from(visible));
    let mut work = GeometryWork { visible, ..GeometryWork::default() };
    if visible {
        light(state, &mut info, input, &mut vertices, errata);
        work.lit_vertices = if info.mode.uses_intensity() { 3 } else { 0 };
        work.extra_attributes = premultiply(info.mode, &mut vertices);
    }
    (TransPrim { info, vertices }, work)
}

fn transform_vertex(model_view: &Matrix, v: &InputVertex) -> Vertex {
    let [x, y, z] = v.position;
    let [x, y, z, w1] = matrix::transform(model_view, [x, y, z, 1.0]);
    let rgba = color::unpack(v.rgba).map(|c| c as f32);
    Vertex { x, y, z, w1, u: v.uv[0], v: v.uv[1], rgba, intensity: 0.0 }
}

/// Whether the primitive passes the near-plane and back-face tests. A primitive that crosses the
/// near plane is dropped whole.
pub fn is_visible(v: &[Vertex; 3], errata: &Errata) -> bool {
    v.iter().all(|v| in_front(v, errata)) && faces_front(v, errata)
}

fn in_front(v: &Vertex, errata: &Errata) -> bool {
    let (z, w) = (v.z, v.w1);
    if errata.integer_w_test && (w as i32) == 0 {
        return false;
    }
    if errata.behind_eye_passes {
        return !((w > 0.0 && z <= -w) || (w < 0.0 && z >= -w) || w == 0.0);
    }
    let beyond_far = !errata.depth_overflows && z > w;
    w > MIN_W && z > -w && !beyond_far
}

/// Whether the vertices run clockwise on the screen (y down). Zero area is dropped.
fn faces_front(v: &[Vertex; 3], errata: &Errata) -> bool {
    let [a, b, c] = v;
    if errata.backface_before_divide {
        return (b.y - a.y) * c.x + (a.x - b.x) * c.y + a.y * b.x - b.y * a.x < 0.0;
    }
    // The homogeneous determinant has the sign of the area after the divide when every w > 0.
    let d = a.x * (b.y * c.w1 - c.y * b.w1) - a.y * (b.x * c.w1 - c.x * b.w1)
        + a.w1 * (b.x * c.y - c.x * b.y);
    d > 0.0
}

fn light(
    state: &mut RenderState,
    info: &mut PrimInfo,
    input: &[InputVertex; 3],
    out: &mut [Vertex; 3],
    errata: &Errata,
) {
    if !state.dir_defined {
        info.mode.set_use_dir(0);
    }
    if info.mode.lit() == 0 {
        return;
    }
    if info.mode.use_amb() == 1 {
        let ambient = mul(state.amb_reflect & 0xff, color::low(info.amb_color));
        if errata.ambient_decays {
            state.prim.amb_color = color::with_low(state.prim.amb_color, ambient);
        } else {
            info.amb_color = color::with_low(info.amb_color, ambient);
        }
    }
    if info.mode.use_dir() == 1 {
        let strength = (state.dir_reflect & 0xff) as f32 / 255.0;
        let strength = strength * (color::low(info.dir_color) as f32 / 255.0);
        for (vertex, v) in out.iter_mut().zip(input) {
            vertex.intensity = directional(state, v.normal, strength, errata);
        }
    }
}

fn directional(state: &RenderState, normal: [f32; 3], strength: f32, errata: &Errata) -> f32 {
    let [x, y, z] = normal;
    let [x, y, z, _] = matrix::transform(&state.normal_matrix, [x, y, z, 1.0]);
    let square = x * x + y * y + z * z;
    if square == 0.0 && !errata.normals_flip {
        return 0.0;
    }
    let scale = 1.0 / square.sqrt();
    let [lx, ly, lz] = state.light;
    let product = -(x * scale * lx + y * scale * ly + z * scale * lz);
    if product <= 0.0 { 0.0 } else { product * strength }
}

/// Divides positions by w and multiplies the attributes the mode interpolates by 1/w. Returns how
/// many kinds of attribute beyond position and colour were touched.
fn premultiply(mode: ModeBits, vertices: &mut [Vertex; 3]) -> u32 {
    let alpha = mode.col_alpha() != 0;
    let texture = mode.texmode() > texmode::COLOR;
    for v in vertices {
        v.w1 = 1.0 / v.w1;
        v.x *= v.w1;
        v.y *= v.w1;
        if mode.touches_z() {
            v.z *= v.w1;
        }
        if mode.uses_color() {
            for channel in &mut v.rgba[..3] {
                *channel *= v.w1;
            }
        }
        if alpha {
            v.rgba[3] *= v.w1;
        }
        if texture {
            v.u *= v.w1;
            v.v *= v.w1;
        }
        if mode.uses_intensity() {
            v.intensity *= v.w1;
        }
    }
    u32::from(alpha) + u32::from(texture) + u32::from(mode.uses_intensity())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f32, y: f32, w: f32) -> Vertex {
        Vertex { x, y, z: 0.0, w1: w, ..Vertex::default() }
    }

    #[test]
    fn clockwise_on_screen_is_front() {
        let front = [at(0.0, 0.0, 1.0), at(0.5, 0.0, 1.0), at(0.0, 0.5, 1.0)];
        let back = [front[0], front[2], front[1]];
        for errata in [Errata::CORRECT, Errata { integer_w_test: false, ..Errata::FAITHFUL }] {
            assert!(is_visible(&front, &errata));
            assert!(!is_visible(&back, &errata));
        }
    }

    #[test]
    fn culling_after_the_divide_differs_from_before() {
        // Clip coordinates whose winding turns over when divided by different w.
        let v = [at(0.0, 0.0, 1.0), at(1.0, 0.1, 10.0), at(1.0, 0.0, 1.0)];
        let before = Errata { backface_before_divide: true, ..Errata::CORRECT };
        let wide = [at(0.9, 0.0, 1.0), at(1.0, 0.0, 10.0), at(0.5, 0.1, 1.0)];
        assert_eq!(is_visible(&v, &Errata::CORRECT), is_visible(&v, &before));
        assert_ne!(is_visible(&wide, &Errata::CORRECT), is_visible(&wide, &before));
    }

    #[test]
    fn behind_the_eye_is_dropped() {
        let v = [at(0.0, 0.0, -1.0), at(0.5, 0.0, -1.0), at(0.0, 0.5, -1.0)];
        assert!(!is_visible(&v, &Errata::CORRECT));
        let zero_w = [at(0.0, 0.0, f32::NAN); 3];
        assert!(!is_visible(&zero_w, &Errata::CORRECT));
    }

    #[test]
    fn ambient_reflectance_reaches_the_primitive_only_when_correct() {
        let input = [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]]
            .map(|[x, y]| InputVertex { position: [x, y, 0.0], ..InputVertex::default() });
        let mut state = RenderState { amb_reflect: 128, ..RenderState::default() };
        state.prim.amb_color = 0xffff_ff80;
        state.prim.mode.set_lit(1);
        state.prim.mode.set_use_amb(1);
        let prim = state.prim;
        let (out, _) = process(&mut state, prim, &input, &Errata::CORRECT);
        assert_eq!(color::low(out.info.amb_color), mul(128, 128));
        assert_eq!(color::low(state.prim.amb_color), 0x80);
        let decays = Errata { ambient_decays: true, ..Errata::CORRECT };
        let (out, _) = process(&mut state, prim, &input, &decays);
        assert_eq!(color::low(out.info.amb_color), 0x80);
        assert_eq!(color::low(state.prim.amb_color), mul(128, 128));
    }
}
