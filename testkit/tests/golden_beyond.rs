//! Golden pictures of what the engine draws beyond the SST-1's pipeline.

use std::sync::Arc;

use fillrate_engine::state::{
    Axis, DecalBase, Dither, DrawState, FOG_SAMPLES, Filter, Fog, FogAmount, FogTable, LogicOp,
    Pattern, PatternBits, Shade,
};
use fillrate_engine::{Cull, Texture, TextureDesc, TmuVertex, Vertex, VertexExtra};
use fillrate_testkit::{Canvas, golden};

use crate::golden_scenes::{NO_TEXTURES, SIDE, chequers, clear, floor, textured, vertex};

/// A rectangle of vertices with their extras, corners from the upper left on
/// clockwise.
fn rectangle(
    canvas: &mut dyn Canvas,
    [x0, y0, x1, y1]: [f32; 4],
    colors: [u32; 4],
    extras: [VertexExtra; 4],
) {
    let places = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)];
    let corner = |i: usize| {
        let (x, y) = places[i];
        // Level 0 is 256 texels wide: the texture once over the rectangle.
        let (s, t) = ((x - x0) / (x1 - x0) * 256.0, (y - y0) / (y1 - y0) * 256.0);
        Vertex { tmu: [TmuVertex { s, t, w: 1.0 }; 3], ..vertex(x, y, colors[i]) }
    };
    for [a, b, c] in [[0, 1, 2], [0, 2, 3]] {
        let vertices = [corner(a), corner(b), corner(c)];
        canvas.extended(&vertices, &[extras[a], extras[b], extras[c]], Cull::Disabled);
    }
}

/// Rings whose alpha falls from the middle on.
fn rings() -> Arc<Texture> {
    let desc = TextureDesc { s_bits: 8, t_bits: 8, first: 3, last: 3, clamp_s: true };
    let texture = Texture::build(desc, |_, out| {
        for (row, column) in (0..32i32).flat_map(|row| (0..32i32).map(move |x| (row, x))) {
            let (x, y) = (2 * column - 31, 2 * row - 31);
            let far = (x * x + y * y) as u32;
            let alpha = 255u32.saturating_sub(far / 4);
            let rgb = if (far / 128).is_multiple_of(2) { 0xffffff } else { 0x2060e0 };
            out.push(alpha << 24 | rgb);
        }
    });
    Arc::new(texture.expect("the shape is valid"))
}

fn extra(specular: [f32; 3], fog: f32, base: [f32; 3]) -> VertexExtra {
    VertexExtra { specular, fog, base, deep_z: 0.0 }
}

const WHITE: [u32; 4] = [0xffffff; 4];

/// A decal over a gradient; the same half as bright, and up to twice as bright;
/// with a highlight at one corner.
#[test]
fn decals() {
    let textures = [Some(rings()), None, None];
    let base = [[0.0, 160.0, 0.0], [160.0, 0.0, 0.0], [160.0, 160.0, 0.0], [0.0, 0.0, 0.0]];
    let plain = base.map(|base| extra([0.0; 3], 255.0, base));
    let mut lit = plain;
    lit[0].specular = [255.0, 200.0, 0.0];
    golden("engine/decals", SIDE, SIDE, |canvas| {
        let draw = |canvas: &mut dyn Canvas, shade: Shade, at, colors, extras| {
            let state =
                DrawState { shade, dither: Dither::Ordered4x4, ..textured(Filter::Bilinear) };
            canvas.set_state(&state, &textures);
            rectangle(canvas, at, colors, extras);
        };
        let decal = Shade { decal: Some(DecalBase::Base), ..Shade::default() };
        let bright = Shade { overbright: true, ..decal };
        let highlight = Shade { specular: true, ..decal };
        draw(canvas, decal, [2.0, 2.0, 46.0, 46.0], WHITE, plain);
        draw(canvas, highlight, [50.0, 2.0, 94.0, 46.0], WHITE, lit);
        draw(canvas, bright, [2.0, 50.0, 46.0, 94.0], [0x808080; 4], plain);
        // Twice as bright at the right: beyond what a colour of 8 bits says.
        canvas.set_state(&DrawState { shade: bright, ..textured(Filter::Bilinear) }, &textures);
        let corner = |x: f32, y: f32, light: f32| {
            let (s, t) = ((x - 50.0) / 44.0 * 256.0, (y - 50.0) / 44.0 * 256.0);
            let tmu = [TmuVertex { s, t, w: 1.0 }; 3];
            Vertex { r: light, g: light, b: light, tmu, ..vertex(x, y, 0) }
        };
        let [a, b] = [corner(50.0, 50.0, 0.0), corner(94.0, 50.0, 510.0)];
        let [c, d] = [corner(94.0, 94.0, 510.0), corner(50.0, 94.0, 0.0)];
        canvas.extended(&[a, b, c], &[plain[0], plain[1], plain[2]], Cull::Disabled);
        canvas.extended(&[a, c, d], &[plain[0], plain[2], plain[3]], Cull::Disabled);
    });
}

/// Linear fog by distance over a floor, and a bar whose fog is iterated.
#[test]
fn fog_by_distance() {
    let mut samples = [0; FOG_SAMPLES];
    for (i, sample) in samples.iter_mut().enumerate() {
        let distance = 1.0 / FogTable::w_of_sample(i);
        *sample = (255.0 * (1.0 - distance / 24.0).clamp(0.0, 1.0)).round() as u8;
    }
    golden("engine/fog_by_distance", SIDE, SIDE, |canvas| {
        let fog = Fog {
            amount: FogAmount::ByW,
            color: 0xa0b0c0,
            drop_fog_color: false,
            drop_fragment_color: false,
        };
        let distant = DrawState {
            fog: Some(fog),
            fog_table: FogTable::by_w(&samples),
            ..textured(Filter::Bilinear)
        };
        canvas.set_state(&distant, &[Some(chequers()), None, None]);
        floor(canvas);
        let fog = Fog { amount: FogAmount::Iterated, ..fog };
        canvas.set_state(&DrawState { fog: Some(fog), ..DrawState::default() }, &NO_TEXTURES);
        let [clear, foggy] = [255.0, 0.0].map(|part| extra([0.0; 3], part, [0.0; 3]));
        rectangle(canvas, [2.0, 40.0, 94.0, 52.0], [0xff2000; 4], [clear, foggy, foggy, clear]);
    });
}

/// An area pattern with a background, a line pattern without, and a logic
/// operation that turns part of both over.
#[test]
fn patterns() {
    let mut rows = [0u32; 32];
    for (y, row) in rows.iter_mut().enumerate() {
        for x in 0..32 {
            let (dx, dy) = (x - 16, y as i32 - 16);
            *row |= u32::from(dx * dx + dy * dy < 150) << (31 - x);
        }
    }
    let plain = [extra([0.0; 3], 255.0, [0.0; 3]); 4];
    golden("engine/patterns", SIDE, SIDE, |canvas| {
        clear(canvas, 0x203040, 0);
        let draw = |canvas: &mut dyn Canvas, state: DrawState, at, color| {
            canvas.set_state(&state, &NO_TEXTURES);
            rectangle(canvas, at, [color; 4], plain);
        };
        let area = Pattern { bits: PatternBits::Area(rows), background: Some(0xff40_0060) };
        let state = DrawState { pattern: Some(area), ..DrawState::default() };
        draw(canvas, state, [0.0, 0.0, 96.0, 64.0], 0xffc020);
        let bits = PatternBits::Line {
            bits: 0b1_0001_0111,
            length: 9,
            factor: 2,
            axis: Axis::X,
            origin: 3,
            backwards: false,
        };
        let line = Pattern { bits, background: None };
        let state = DrawState { pattern: Some(line), ..DrawState::default() };
        for y in (68..92).step_by(8) {
            draw(canvas, state, [2.0, y as f32, 94.0, y as f32 + 3.0], 0x40ff80);
        }
        let state = DrawState { logic_op: Some(LogicOp::new(0b0110)), ..DrawState::default() };
        draw(canvas, state, [60.0, 8.0, 90.0, 88.0], 0xffffff);
    });
}

#[test]
fn texture_levels_mixed() {
    golden("engine/texture_levels_mixed", SIDE, SIDE, |canvas| {
        let mut state = textured(Filter::Bilinear);
        state.units[0].as_mut().expect("it has a unit").mix_levels = true;
        canvas.set_state(&state, &[Some(chequers()), None, None]);
        floor(canvas);
    });
}
