//! Stage 1: transform, visibility, lighting at the vertices, perspective premultiply.
//!
//! Source: RAW, geometry listing, in its order of operations; all arithmetic in f32.

use super::{InputVertex, Shape, TransPrim, Vertex, assembly, clip as clipping, lighting};
use crate::color;
use crate::errata::Errata;
use crate::matrix::{self, Matrix};
use crate::state::{ModeBits, PrimInfo, RenderState, clip, texmode};

/// The smallest w that counts as in front of the eye.
pub const MIN_W: f32 = 1e-6;

/// What stage 1 did with a primitive, for the cost model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GeometryWork {
    /// Vertices transformed.
    pub vertices: u32,
    /// Triangles, lines and points looked at.
    pub parts: u32,
    /// Parts sent on, after clipping.
    pub sent: u32,
    /// Vertices made by clipping.
    pub new_vertices: u32,
    /// Vertices that went through directional lighting.
    pub lit_vertices: u32,
    /// Attributes multiplied by 1/w beyond position and colour: alpha, texture, intensity.
    pub extra_attributes: u32,
    /// Whether anything of the primitive survived the visibility tests.
    pub visible: bool,
}

/// Takes one primitive through stage 1; returns its visible parts, or one invisible part.
///
/// `info` is the pipe's copy of the primitive's state (with its sequence number and its
/// ordered or unordered decision); its `draw` bit and ambient intensity are filled in here. `state`
/// supplies the matrices and the light; it is only written in the faithful mode that lets the
/// ambient light decay.
pub fn process(
    state: &mut RenderState,
    mut info: PrimInfo,
    input: &[InputVertex],
    errata: &Errata,
) -> (Vec<TransPrim>, GeometryWork) {
    let kind = info.mode.topology();
    let mut vertices: Vec<Vertex> =
        input.iter().map(|v| transform_vertex(&state.model_view, v)).collect();
    let mut work = GeometryWork { vertices: input.len() as u32, ..GeometryWork::default() };
    let shape = assembly::shape(kind);
    let last = vertices.len().saturating_sub(1);
    let pick = |vertices: &[Vertex], part: [usize; 3]| part.map(|i| vertices[i.min(last)]);
    let visible: Vec<_> = assembly::parts(kind, input.len())
        .inspect(|_| work.parts += 1)
        .filter(|part| passes(&pick(&vertices, *part), shape, info.mode, errata))
        .collect();
    if !visible.is_empty() {
        work.lit_vertices = lighting::light(state, &mut info, input, &mut vertices, errata);
    }
    let mut parts = Vec::with_capacity(visible.len().max(1));
    info.mode.set_draw(1);
    for part in visible {
        cut(pick(&vertices, part), shape, &info, &mut parts, &mut work);
    }
    work.sent = parts.len() as u32;
    work.visible = !parts.is_empty();
    if parts.is_empty() {
        info.mode.set_draw(0);
        let vertices = pick(&vertices, [0, 1, 2]);
        parts.push(TransPrim { info, shape, vertices });
    }
    (parts, work)
}

/// Whether a part passes the visibility tests that need no new vertices.
fn passes(v: &[Vertex; 3], shape: Shape, mode: ModeBits, errata: &Errata) -> bool {
    let cuts = mode.clip() != clip::DROP;
    let in_front = |v: &Vertex| cuts || in_front(v, errata);
    // Only cutting at the near plane leaves what is beyond the far one.
    let near_enough =
        |v: &Vertex| mode.clip() != clip::NEAR || errata.depth_overflows || v.z <= v.w1;
    match shape {
        Shape::Triangle => {
            v.iter().all(|v| in_front(v) && near_enough(v)) && faces_front(v, errata)
        }
        Shape::Line => v[..2].iter().all(|v| in_front(v) && near_enough(v)),
        Shape::Point => in_front(&v[0]) && clipping::point(&v[0], mode.clip()),
    }
}

/// Cuts a part at the borders of the view and divides what is left by w.
fn cut(
    v: [Vertex; 3],
    shape: Shape,
    info: &PrimInfo,
    parts: &mut Vec<TransPrim>,
    work: &mut GeometryWork,
) {
    let mode = info.mode;
    let mut send = |mut vertices: [Vertex; 3]| {
        work.extra_attributes = premultiply(mode, &mut vertices);
        parts.push(TransPrim { info: *info, shape, vertices });
    };
    match shape {
        _ if mode.clip() == clip::DROP => send(v),
        Shape::Point => send(v),
        Shape::Line => {
            let left = clipping::line([v[0], v[1]], mode.clip(), &mut work.new_vertices);
            left.into_iter().for_each(|[a, b]| send([a, b, b]));
        }
        Shape::Triangle => {
            let left = clipping::triangle(flattened(v, mode), mode.clip(), &mut work.new_vertices);
            for i in 1..left.len().saturating_sub(1) {
                send([left[0], left[i], left[i + 1]]);
            }
        }
    }
}

/// Where colour or light is the average of the corners, every part of a cut triangle must have the
/// average of the whole one.
fn flattened(mut v: [Vertex; 3], mode: ModeBits) -> [Vertex; 3] {
    let average = |f: &dyn Fn(&Vertex) -> f32| (f(&v[0]) + f(&v[1]) + f(&v[2])) / 3.0;
    let rgba = std::array::from_fn(|i| average(&|v| v.rgba[i]));
    let intensity = average(&|v| v.intensity);
    for v in &mut v {
        if mode.col_interp() == 0 {
            v.rgba = rgba;
        }
        if mode.lit_interp() == 0 {
            v.intensity = intensity;
        }
    }
    v
}

fn transform_vertex(model_view: &Matrix, v: &InputVertex) -> Vertex {
    let [x, y, z] = v.position;
    let [x, y, z, w1] = matrix::transform(model_view, [x, y, z, 1.0]);
    let rgba = color::unpack(v.rgba).map(|c| c as f32);
    Vertex { x, y, z, w1, u: v.uv[0], v: v.uv[1], rgba, ..Vertex::default() }
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
        if mode.more_light() == 1 {
            v.more = v.more.map(|c| c * v.w1);
        }
    }
    u32::from(alpha) + u32::from(texture) + u32::from(mode.uses_intensity()) + 2 * mode.more_light()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::mul;

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
        assert_eq!(color::low(out[0].info.amb_color), mul(128, 128));
        assert_eq!(color::low(state.prim.amb_color), 0x80);
        let decays = Errata { ambient_decays: true, ..Errata::CORRECT };
        let (out, _) = process(&mut state, prim, &input, &decays);
        assert_eq!(color::low(out[0].info.amb_color), 0x80);
        assert_eq!(color::low(state.prim.amb_color), mul(128, 128));
    }
}
