//! Golden pictures of the engine's stages, each as small as shows its point.

use std::f32::consts::TAU;
use std::sync::Arc;

use fillrate_engine::state::{
    Addend, AuxWrite, Blend, BlendFactor, ColorCombine, CombineUnit, Compare, DepthSource,
    DepthState, Dither, DrawState, Factor, Filter, Fog, FogAmount, FogTable, LodRange, Other, Rect,
    TextureCombine, TextureUnit,
};
use fillrate_engine::{ClearValues, Cull, Texture, TextureDesc, TmuVertex, Vertex};
use fillrate_testkit::reference::Textures;
use fillrate_testkit::{Canvas, golden};

pub(crate) const SIDE: u32 = 96;
pub(crate) const NO_TEXTURES: Textures = [None, None, None];

/// A vertex of a colour 0xRRGGBB.
pub(crate) fn vertex(x: f32, y: f32, rgb: u32) -> Vertex {
    let channel = |shift: u32| (rgb >> shift & 0xff) as f32;
    let tmu = [TmuVertex { s: 0.0, t: 0.0, w: 1.0 }; 3];
    Vertex { x, y, r: channel(16), g: channel(8), b: channel(0), a: 255.0, z: 0.0, w: 1.0, tmu }
}

/// A quadrangle as two triangles.
fn quad(canvas: &mut dyn Canvas, [a, b, c, d]: [Vertex; 4]) {
    canvas.triangle(&[a, b, c], Cull::Disabled);
    canvas.triangle(&[a, c, d], Cull::Disabled);
}

pub(crate) fn clear(canvas: &mut dyn Canvas, color: u32, aux: u16) {
    let values = ClearValues { color: Some((color, Dither::Off)), aux: Some(u32::from(aux)) };
    canvas.clear(Rect::new(0, 0, SIDE, SIDE), values);
}

/// Triangles around a point; neighbours share edges exactly once.
fn fan(canvas: &mut dyn Canvas, count: u32, radius: f32) {
    let corner = |i: u32| {
        let angle = TAU * i as f32 / count as f32;
        // Sixteenths, so that no machine's sine decides a pixel.
        let at = |v: f32| ((48.3 + radius * v) * 16.0).round() / 16.0;
        (at(angle.cos()), at(angle.sin()))
    };
    let colors = [0xff4040, 0x40ff40, 0x4040ff, 0xffff40];
    for i in 0..count {
        let rgb = colors[i as usize % colors.len()];
        let ((x0, y0), (x1, y1)) = (corner(i), corner(i + 1));
        let corners = [vertex(48.3125, 48.3125, rgb), vertex(x0, y0, rgb), vertex(x1, y1, rgb)];
        canvas.triangle(&corners, Cull::Disabled);
    }
}

/// Additive, so that a pixel drawn twice or never shows.
#[test]
fn coverage_fan() {
    golden("engine/coverage_fan", SIDE, SIDE, |canvas| {
        clear(canvas, 0x101010, 0);
        let blend = Blend {
            source: BlendFactor::One,
            destination: BlendFactor::One,
            source_alpha: true,
            destination_alpha: false,
            alpha_plane: false,
            subtract_dither: false,
            ..Blend::default()
        };
        canvas.set_state(&DrawState { blend: Some(blend), ..DrawState::default() }, &NO_TEXTURES);
        fan(canvas, 23, 45.0);
    });
}

#[test]
fn gouraud_dithered() {
    golden("engine/gouraud_dithered", SIDE, SIDE, |canvas| {
        let state = DrawState { dither: Dither::Ordered4x4, ..DrawState::default() };
        canvas.set_state(&state, &NO_TEXTURES);
        let corners = [
            vertex(4.0, 4.0, 0xff0000),
            vertex(92.0, 12.0, 0x00ff00),
            vertex(86.0, 90.0, 0x0000ff),
            vertex(10.0, 80.0, 0xffffff),
        ];
        quad(canvas, corners);
    });
}

/// Two quadrangles through each other.
fn crossing(canvas: &mut dyn Canvas, near: fn(&mut Vertex, bool)) {
    for (rgb, left_near) in [(0xe08020, true), (0x2060c0, false)] {
        let mut corners = [
            vertex(8.0, 8.0, rgb),
            vertex(88.0, 14.0, rgb),
            vertex(84.0, 88.0, rgb),
            vertex(12.0, 80.0, rgb),
        ];
        for (index, corner) in corners.iter_mut().enumerate() {
            near(corner, (index == 0 || index == 3) == left_near);
        }
        quad(canvas, corners);
    }
}

fn depth_state(source: DepthSource, compare: Compare) -> DrawState {
    DrawState {
        depth: DepthState { source, test: Some(compare), ..DepthState::default() },
        aux_write: AuxWrite::Depth,
        ..DrawState::default()
    }
}

#[test]
fn depth_z_greater() {
    golden("engine/depth_z_greater", SIDE, SIDE, |canvas| {
        clear(canvas, 0, 0);
        canvas.set_state(&depth_state(DepthSource::Z, Compare::Greater), &NO_TEXTURES);
        crossing(canvas, |vertex, near| vertex.z = if near { 60000.0 } else { 5000.0 });
    });
}

#[test]
fn depth_w_less() {
    golden("engine/depth_w_less", SIDE, SIDE, |canvas| {
        clear(canvas, 0, 0xffff);
        canvas.set_state(&depth_state(DepthSource::FloatW, Compare::Less), &NO_TEXTURES);
        crossing(canvas, |vertex, near| vertex.w = if near { 0.5 } else { 1.0 / 64.0 });
    });
}

/// A texture whose levels can be told apart by colour, with a chequer in each.
pub(crate) fn chequers() -> Arc<Texture> {
    let desc = TextureDesc { s_bits: 8, t_bits: 8, first: 3, last: 8, clamp_s: false };
    let colors = [0xff4040, 0x40ff40, 0x4040ff, 0xffff40, 0xff40ff, 0x40ffff];
    let texture = Texture::build(desc, |level, out| {
        let side = 1u32 << (8 - level);
        let light = colors[usize::from(level - 3)];
        let dark = light >> 2 & 0x3f3f3f;
        let texels = (0..side * side).map(|i| if (i / side + i) & 1 == 0 { light } else { dark });
        out.extend(texels.map(|rgb| 0xff00_0000 | rgb));
    });
    Arc::new(texture.expect("the shape is valid"))
}

pub(crate) fn textured(filter: Filter) -> DrawState {
    let replace = CombineUnit { zero_other: true, add: Addend::Local, ..CombineUnit::default() };
    let unit = TextureUnit {
        perspective: true,
        minify: filter,
        magnify: filter,
        lod: LodRange { min: 0x300, max: 0x800, bias: 0 },
        combine: TextureCombine { color: replace, alpha: replace },
        ..TextureUnit::default()
    };
    let pass = CombineUnit { factor: Factor::Zero, one_minus: true, ..CombineUnit::default() };
    DrawState {
        units: [Some(unit), None, None],
        color_combine: ColorCombine {
            other: Other::Texture,
            unit: pass,
            ..ColorCombine::default()
        },
        ..DrawState::default()
    }
}

/// A floor from near (w = 1) at the bottom to far at the top.
pub(crate) fn floor(canvas: &mut dyn Canvas) {
    let corner = |x: f32, y: f32, s: f32, t: f32, inv_w: f32| {
        let tmu = [TmuVertex { s: s * inv_w, t: t * inv_w, w: inv_w }; 3];
        Vertex { w: inv_w, tmu, ..vertex(x, y, 0xffffff) }
    };
    quad(
        canvas,
        [
            corner(20.0, 6.0, -512.0, 4096.0, 1.0 / 32.0),
            corner(76.0, 6.0, 512.0, 4096.0, 1.0 / 32.0),
            corner(94.5, 94.0, 128.0, 0.0, 1.0),
            corner(1.5, 94.0, -128.0, 0.0, 1.0),
        ],
    );
}

#[test]
fn texture_levels_point() {
    let textures = [Some(chequers()), None, None];
    golden("engine/texture_levels_point", SIDE, SIDE, |canvas| {
        canvas.set_state(&textured(Filter::Point), &textures);
        floor(canvas);
    });
}

#[test]
fn texture_levels_bilinear() {
    let textures = [Some(chequers()), None, None];
    golden("engine/texture_levels_bilinear", SIDE, SIDE, |canvas| {
        canvas.set_state(&textured(Filter::Bilinear), &textures);
        floor(canvas);
    });
}

#[test]
fn fog_table_w() {
    let mut table = FogTable::default();
    for (entry, value) in table.value.iter_mut().enumerate() {
        *value = (entry * 10).min(255) as u8;
    }
    table.delta = [40; 64];
    golden("engine/fog_table_w", SIDE, SIDE, |canvas| {
        let fog = Fog {
            amount: FogAmount::Table,
            color: 0xa0b0c0,
            drop_fog_color: false,
            drop_fragment_color: false,
        };
        let state = DrawState { fog: Some(fog), fog_table: table, ..textured(Filter::Bilinear) };
        canvas.set_state(&state, &[Some(chequers()), None, None]);
        floor(canvas);
    });
}

#[test]
fn blend_over_dithered() {
    golden("engine/blend_over_dithered", SIDE, SIDE, |canvas| {
        clear(canvas, 0x204060, 0);
        let blend = Blend {
            source: BlendFactor::SourceAlpha,
            destination: BlendFactor::OneMinusSourceAlpha,
            source_alpha: true,
            destination_alpha: false,
            alpha_plane: false,
            subtract_dither: true,
            ..Blend::default()
        };
        let dither = Dither::Ordered4x4;
        let state = DrawState { blend: Some(blend), dither, ..DrawState::default() };
        canvas.set_state(&state, &NO_TEXTURES);
        for (rgb, shift) in [(0xff6000, 0.0), (0x00ff80, 12.0), (0x8080ff, 24.0)] {
            let at = |x: f32, y: f32, a: f32| Vertex { a, ..vertex(x + shift, y + shift, rgb) };
            let corners = [at(6.0, 4.0, 255.0), at(60.0, 10.0, 128.0), at(20.0, 66.0, 0.0)];
            canvas.triangle(&corners, Cull::Disabled);
        }
    });
}
