//! Which levels are sampled, and passes over textures.

use fillrate_glide::{Call, Context};

use super::{opened, pixel, vertex};

const WHITE: u16 = 0xffff;

/// A square 565 texture of 256 to 64 at address 0, one grey for each level.
fn download(glide: &mut Context, levels: [u16; 3], even_odd: u32, start: u32) {
    let (tmu, small_lod, large_lod, aspect, format) = (0, 2, 0, 3, 0xa);
    let texels = |lod: usize| {
        let side = 256usize >> lod;
        std::iter::repeat_n(levels[lod].to_le_bytes(), side * side).flatten()
    };
    let data: Vec<u8> = (0..3).flat_map(texels).collect();
    let data = data.into();
    glide.execute(&Call::GrTexDownloadMipMap {
        tmu,
        start,
        even_odd,
        small_lod,
        large_lod,
        aspect,
        format,
        data,
    });
}

fn source(glide: &mut Context, even_odd: u32, start: u32) {
    let (tmu, small_lod, large_lod, aspect, format) = (0, 2, 0, 3, 0xa);
    glide.execute(&Call::GrTexSource {
        tmu,
        start,
        even_odd,
        small_lod,
        large_lod,
        aspect,
        format,
    });
}

/// The texture alone, with neighbouring levels to be blended.
fn textured(blend: i32) -> Context {
    let mut glide = opened("voodoo-4mb", 0);
    glide.execute(&Call::GuColorCombineFunction { function: 4 });
    glide.execute(&Call::GrTexMipMapMode { tmu: 0, mode: 1, blend });
    glide
}

/// Scales the texel by one minus the fraction of the level, or by the fraction.
fn scale_by_fraction(glide: &mut Context, by_fraction: bool) {
    let factor = if by_fraction { 0xd } else { 5 };
    glide.execute(&Call::GrTexCombine {
        tmu: 0,
        rgb_function: 9,
        rgb_factor: factor,
        alpha_function: 9,
        alpha_factor: factor,
        rgb_invert: 0,
        alpha_invert: 0,
    });
}

/// Draws at a level of detail: 2^level texels a pixel.
fn draw_at(glide: &mut Context, level: f32) {
    let scale = level.exp2();
    let corner = |x: f32, y: f32| vertex(x, y, x * scale, y * scale);
    let (a, b, c) = (corner(0.0, 0.0), corner(320.0, 0.0), corner(0.0, 240.0));
    glide.execute(&Call::GrDrawTriangle { a, b, c });
}

fn green(glide: &mut Context) -> u16 {
    pixel(glide, 1, 9, 9) >> 5 & 63
}

/// Two passes of one unit over a whole texture blend its levels: each takes the
/// even or the odd ones.
#[test]
fn two_passes_blend_the_levels_of_a_whole_texture() {
    let mut glide = textured(1);
    for (levels, level, expected) in [
        ([WHITE, 0, WHITE], 0.25, 47),
        ([WHITE, 0, WHITE], 0.75, 16),
        ([WHITE, 0, WHITE], 1.25, 16),
        ([0, WHITE, 0], 1.5, 31),
        ([WHITE, WHITE, WHITE], 0.5, 63),
    ] {
        download(&mut glide, levels, 3, 0);
        source(&mut glide, 3, 0);
        let blend = |rgb_source, rgb_destination| Call::GrAlphaBlendFunction {
            rgb_source,
            rgb_destination,
            alpha_source: 4,
            alpha_destination: 0,
        };
        glide.execute(&blend(4, 0));
        scale_by_fraction(&mut glide, false);
        draw_at(&mut glide, level);
        glide.execute(&blend(4, 4));
        scale_by_fraction(&mut glide, true);
        draw_at(&mut glide, level);
        let drawn = green(&mut glide);
        assert!(drawn.abs_diff(expected) <= 2, "{levels:x?} at {level}: {drawn}, not {expected}");
    }
}

/// The second pass's choice of the odd levels ends with its factor.
#[test]
fn the_odd_levels_of_a_second_pass_are_not_kept() {
    let mut glide = textured(1);
    download(&mut glide, [0, WHITE, 0], 3, 0);
    source(&mut glide, 3, 0);
    let odd = |glide: &mut Context| {
        glide.draw_state().expect("the board is open").0.units[0].expect("a unit").odd_levels
    };
    scale_by_fraction(&mut glide, true);
    assert_eq!(odd(&mut glide), Some(true));
    glide.execute(&Call::GrTexCombineFunction { tmu: 0, function: 1 });
    assert_eq!(odd(&mut glide), Some(false));
    scale_by_fraction(&mut glide, true);
    glide.execute(&Call::GrTexMipMapMode { tmu: 0, mode: 1, blend: 0 });
    assert_eq!(odd(&mut glide), None);
    // What the texture was sourced with is kept through all of this.
    source(&mut glide, 1, 0);
    scale_by_fraction(&mut glide, false);
    assert_eq!(odd(&mut glide), Some(false));
    source(&mut glide, 2, 0);
    glide.execute(&Call::GrTexCombineFunction { tmu: 0, function: 1 });
    assert_eq!(odd(&mut glide), Some(true));
    // Also by saved states, of which those of earlier releases have it in tLOD.
    let mut state = glide.state().expect("the board is open");
    for mark in [*b"FLS2", *b"FLS1"] {
        state[..4].copy_from_slice(&mark);
        source(&mut glide, 3, 0);
        glide.execute(&Call::GrGlideSetState { state: state.to_vec().into() });
        glide.execute(&Call::GrTexCombineFunction { tmu: 0, function: 1 });
        assert_eq!(odd(&mut glide), Some(true));
    }
}

/// Without blending, and where there is one level, all levels are sampled.
#[test]
fn textures_that_are_not_blended_have_all_levels() {
    let mut glide = textured(0);
    glide.execute(&Call::GrTexCombineFunction { tmu: 0, function: 1 });
    download(&mut glide, [0, WHITE, 0], 3, 0);
    source(&mut glide, 3, 0);
    draw_at(&mut glide, 1.0);
    assert_eq!(green(&mut glide), 63);
    draw_at(&mut glide, 2.0);
    assert_eq!(green(&mut glide), 0);
    glide.execute(&Call::GrTexMipMapMode { tmu: 0, mode: 0, blend: 1 });
    draw_at(&mut glide, 1.0);
    assert_eq!(green(&mut glide), 0, "the largest level alone");
}

/// Multiplied textures get fog once: its colour is added by a third pass.
#[test]
fn multiplied_textures_fade_into_the_fog() {
    let mut glide = opened("voodoo-4mb", 0);
    glide.execute(&Call::GuColorCombineFunction { function: 4 });
    glide.execute(&Call::GuMpInit {});
    glide.execute(&Call::GuMpTexCombineFunction { function: 1 });
    for unit in 0..2 {
        let id = glide.execute(&Call::GuTexAllocateMemory {
            tmu: 0,
            even_odd: 3,
            width: 1,
            height: 1,
            format: 0xa,
            mip_map_mode: 0,
            small_lod: 8,
            large_lod: 8,
            aspect: 3,
            s_clamp: 0,
            t_clamp: 0,
            minify: 0,
            magnify: 0,
            lod_bias: 0.0,
            trilinear: 0,
        });
        glide.execute(&Call::GuTexDownloadMipMap { id, data: vec![255; 2].into(), table: None });
        glide.execute(&Call::GuMpTexSource { tmu: unit, id });
    }
    glide.execute(&Call::GrFogColorValue { color: 0x0000_00ff });
    glide.execute(&Call::GrFogTable { table: [128; 64] });
    let mut drawn = |mode| {
        glide.execute(&Call::GrFogMode { mode });
        let corner = |x: f32, y: f32| vertex(x, y, 0.0, 0.0);
        let (a, b, c) = (corner(0.0, 0.0), corner(320.0, 0.0), corner(0.0, 240.0));
        glide.execute(&Call::GuMpDrawTriangle { a, b, c });
        pixel(&mut glide, 1, 9, 9)
    };
    assert_eq!(drawn(0), WHITE);
    let [r, g, b] = [drawn(2) >> 11, drawn(2) >> 5 & 63, drawn(2) & 31];
    assert!(r.abs_diff(15) <= 1 && g.abs_diff(31) <= 1, "half of white: {r} {g}");
    assert!(b >= 30, "half of white and half of the fog: {b}");
}
