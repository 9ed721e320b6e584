//! Stage 1: light at the vertices.
//!
//! Source: RAW, geometry listing; further lights and highlights are beyond it (chapter 6): each
//! vertex then also carries a colour of light, and of highlights by the halfway vector.

use super::{InputVertex, Vertex};
use crate::color::{self, mul};
use crate::errata::Errata;
use crate::matrix;
use crate::state::{PrimInfo, RenderState};

/// Lights the vertices; the ambient term goes into `info`. Returns how many vertices went through
/// directional lighting.
pub fn light(
    state: &mut RenderState,
    info: &mut PrimInfo,
    input: &[InputVertex],
    out: &mut [Vertex],
    errata: &Errata,
) -> u32 {
    if !state.dir_defined {
        info.mode.set_use_dir(0);
    }
    if info.mode.lit() == 0 {
        return 0;
    }
    if info.mode.use_amb() == 1 {
        let ambient = mul(state.amb_reflect & 0xff, color::low(info.amb_color));
        if errata.ambient_decays {
            state.prim.amb_color = color::with_low(state.prim.amb_color, ambient);
        } else {
            info.amb_color = color::with_low(info.amb_color, ambient);
        }
    }
    let more = state.beyond.shines();
    info.mode.set_more_light(u32::from(more));
    if info.mode.use_dir() == 1 {
        let power = color::low(info.dir_color) as f32;
        for (vertex, v) in out.iter_mut().zip(input) {
            vertex.intensity = directional(state, v.normal, power, errata);
        }
    }
    if more {
        for (vertex, v) in out.iter_mut().zip(input) {
            vertex.more = further(state, info, v, errata);
        }
    }
    if info.mode.use_dir() == 1 || more { out.len() as u32 } else { 0 }
}

fn reflectance(state: &RenderState) -> f32 {
    (state.dir_reflect & 0xff) as f32 / 255.0
}

/// The normal in the world and one over its length; `None` for a zero normal, which gets no light.
fn world_normal(state: &RenderState, normal: [f32; 3], errata: &Errata) -> Option<([f32; 3], f32)> {
    let [x, y, z] = normal;
    let [x, y, z, _] = matrix::transform(&state.normal_matrix, [x, y, z, 1.0]);
    let square = x * x + y * y + z * z;
    if square == 0.0 && !errata.normals_flip {
        return None;
    }
    Some(([x, y, z], 1.0 / square.sqrt()))
}

/// The intensity of the first light, of the power 0..=255, in the listing's order of operations.
fn directional(state: &RenderState, normal: [f32; 3], power: f32, errata: &Errata) -> f32 {
    let Some(([x, y, z], scale)) = world_normal(state, normal, errata) else { return 0.0 };
    let [lx, ly, lz] = state.light;
    let product = -(x * scale * lx + y * scale * ly + z * scale * lz);
    let reflected = product * (state.dir_reflect & 0xff) as f32 / 255.0;
    if product <= 0.0 { 0.0 } else { reflected * power / 255.0 }
}

/// Light of further lights, then of the highlights of all lights; red, green, blue, each.
fn further(state: &RenderState, info: &PrimInfo, v: &InputVertex, errata: &Errata) -> [f32; 6] {
    let mut out = [0.0; 6];
    let Some((n, scale)) = world_normal(state, v.normal, errata) else { return out };
    let normal = n.map(|c| c * scale);
    let [x, y, z] = v.position;
    let [x, y, z, _] = matrix::transform(&state.model, [x, y, z, 1.0]);
    let [ex, ey, ez] = state.beyond.eye;
    let to_eye = unit([ex - x, ey - y, ez - z]);
    let first = crate::state::Light { rgbi: info.dir_color, direction: state.light };
    let first = (info.mode.use_dir() == 1).then_some((first, false));
    let others = state.beyond.lights.iter().map(|light| (*light, true));
    for (light, is_further) in first.into_iter().chain(others) {
        let power = color::low(light.rgbi) as f32 / 255.0;
        let against = light.direction.map(|c| -c);
        let facing = dot(normal, against);
        if power == 0.0 || facing <= 0.0 {
            continue;
        }
        let [r, g, b, _] = color::unpack(light.rgbi).map(|c| c as f32);
        let diffuse = if is_further { facing * power * reflectance(state) } else { 0.0 };
        let shine = highlight(state, normal, against, to_eye) * power;
        let surface = color::unpack(state.beyond.specular).map(|c| c as f32 / 255.0);
        for (i, channel) in [r, g, b].into_iter().enumerate() {
            out[i] += channel * diffuse;
            out[i + 3] += channel * shine * surface[i] * surface[3];
        }
    }
    out
}

/// The cosine between normal and halfway vector, to the power of the exponent.
fn highlight(state: &RenderState, normal: [f32; 3], light: [f32; 3], eye: [f32; 3]) -> f32 {
    if state.beyond.exponent == 0 {
        return 0.0;
    }
    let light = unit(light);
    let halfway = unit([light[0] + eye[0], light[1] + eye[1], light[2] + eye[2]]);
    let cosine = dot(normal, halfway);
    if cosine > 0.0 { power(cosine, state.beyond.exponent) } else { 0.0 }
}

/// `base` to a whole power by repeated squaring: the same on every machine.
fn power(base: f32, exponent: u32) -> f32 {
    let (mut result, mut square, mut left) = (1.0, base, exponent);
    while left > 0 {
        if left & 1 == 1 {
            result *= square;
        }
        square *= square;
        left >>= 1;
    }
    result
}

fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The vector of length 1 in the same direction; zero stays zero.
fn unit(v: [f32; 3]) -> [f32; 3] {
    let square = dot(v, v);
    if square == 0.0 {
        return v;
    }
    let scale = 1.0 / square.sqrt();
    v.map(|c| c * scale)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::opcode::Opcode;

    fn lit() -> RenderState {
        let mut state = RenderState::default();
        state.prim.mode.set_lit(1);
        state
    }

    #[test]
    fn powers_are_those_of_repeated_products() {
        assert_eq!(power(0.5, 0), 1.0);
        assert_eq!(power(0.5, 5), 0.03125);
        assert_eq!(power(0.0, 255), 0.0);
    }

    #[test]
    fn further_lights_add_their_colours_and_highlights_peak_at_the_mirror() {
        let mut state = lit();
        let f = f32::to_bits;
        for (number, rgbi) in [(1, 0xff00_00ff), (2, 0x0000_ffff)] {
            let p = [number, rgbi, f(0.0), f(0.0), f(1.0)];
            state.execute(Opcode::Light, &p, &Errata::CORRECT);
        }
        state.execute(Opcode::Specular, &[0xffff_ffff, 8], &Errata::CORRECT);
        state.execute(Opcode::Eye, &[f(0.0), f(0.0), f(-5.0)], &Errata::CORRECT);
        let facing = InputVertex { normal: [0.0, 0.0, -1.0], ..InputVertex::default() };
        let tilted = InputVertex { normal: [0.0, 1.0, -1.0], ..InputVertex::default() };
        let away = InputVertex { normal: [0.0, 0.0, 1.0], ..InputVertex::default() };
        let mut out = [Vertex::default(); 3];
        let mut info = state.prim;
        let input = [facing, tilted, away];
        assert_eq!(light(&mut state, &mut info, &input, &mut out, &Errata::CORRECT), 3);
        assert_eq!(info.mode.more_light(), 1);
        assert_eq!(out[0].more, [255.0, 0.0, 255.0, 255.0, 0.0, 255.0]);
        assert!(out[1].more[0] < 255.0 && out[1].more[3] < 100.0, "{:?}", out[1].more);
        assert_eq!(out[2].more, [0.0; 6]);
    }
}
