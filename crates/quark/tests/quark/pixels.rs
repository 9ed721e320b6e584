//! The engine against the reference, bit for bit.

use std::sync::Arc;

use fillrate_engine::DeviceConfig;
use fillrate_engine::target::TileSize;
use fillrate_quark::{DrawMode, Gpu, GpuConfig, RasterState, TriangleMode};
use fillrate_simd::Level;

use crate::random::Random;
use crate::reference::Reference;

const WIDTH: i32 = 83;
const HEIGHT: i32 = 70;

/// Primitives drawn over one another before the pictures are compared.
const BATCH: usize = 40;

/// Primitives of a test: 10,000, or `FILLRATE_CASES`.
fn cases() -> usize {
    let asked = std::env::var("FILLRATE_CASES").ok().and_then(|text| text.parse().ok());
    asked.unwrap_or(10_000)
}

/// A way of working, another one each time.
fn device(turn: usize) -> DeviceConfig {
    let levels: Vec<Level> = Level::available().collect();
    let tiles = [TileSize::Small, TileSize::Medium, TileSize::Large];
    DeviceConfig {
        threads: 1 + turn % 2,
        level: levels[turn % levels.len()],
        tile: tiles[turn / levels.len() % 3],
    }
}

fn gpu(turn: usize) -> Gpu {
    let (width, height) = (WIDTH as u32, HEIGHT as u32);
    let config = GpuConfig { width, height, device: device(turn), ..GpuConfig::default() };
    Gpu::new(config).expect("a valid size")
}

/// Fills both with the same noise, so that blending and depth have something
/// to meet.
fn noise(random: &mut Random, gpu: &mut Gpu, reference: &mut Reference) {
    for word in &mut reference.words {
        let near = if random.one_in(3) { 0 } else { random.bits() % 30_000 };
        *word = near << 16 | random.bits() & 0x1fff;
    }
    gpu.write_frame_buffer(reference.words.iter().copied().enumerate());
}

fn assert_same(gpu: &mut Gpu, reference: &Reference, what: &dyn std::fmt::Debug) {
    let words = gpu.frame_buffer();
    if let Some(at) = (0..words.len()).find(|&i| words[i] != reference.words[i]) {
        panic!(
            "pixel ({}, {}): engine {:#010x}, reference {:#010x}; {what:?}",
            at as i32 % WIDTH,
            at as i32 / WIDTH,
            words[at],
            reference.words[at]
        );
    }
}

/// Draws batches with both; a batch that differs is drawn again one by one, to
/// name the primitive.
fn compare<T: std::fmt::Debug>(
    seed: u64,
    mut make: impl FnMut(&mut Random) -> T,
    draw: impl Fn(&mut Gpu, &T),
    expect: impl Fn(&mut Reference, &T),
) {
    let mut random = Random::new(seed);
    let mut reference = Reference::new(WIDTH as u32, HEIGHT as u32);
    for turn in 0..cases().div_ceil(BATCH) {
        let mut gpu = gpu(turn);
        let batch: Vec<T> = (0..BATCH).map(|_| make(&mut random)).collect();
        noise(&mut random, &mut gpu, &mut reference);
        let before = reference.words.clone();
        for item in &batch {
            draw(&mut gpu, item);
            expect(&mut reference, item);
        }
        if gpu.frame_buffer() == reference.words {
            continue;
        }
        gpu.write_frame_buffer(before.iter().copied().enumerate());
        reference.words = before;
        for item in &batch {
            draw(&mut gpu, item);
            expect(&mut reference, item);
            assert_same(&mut gpu, &reference, &(item, device(turn)));
        }
        panic!("a batch differs, its parts do not");
    }
}

fn triangles(draw_mode: DrawMode, mode: TriangleMode) {
    let seed = 1 + draw_mode as u64 * 4 + mode as u64;
    let error_max = |random: &mut Random| if random.one_in(3) { random.range(0, 2000) } else { 0 };
    compare(
        seed,
        |random| {
            let state = RasterState {
                draw_mode,
                draw_color: random.bits() as u8,
                draw_intensity: random.bits() as u8,
                test_culling: random.one_in(4),
                z_sort: false,
                texture: (!random.one_in(20)).then(|| random.texture()),
            };
            (state, random.triangle(WIDTH, HEIGHT), error_max(random))
        },
        |gpu, (state, [a, b, c], error)| {
            gpu.triangle_mode = Some(mode);
            gpu.triangle_state = Some(state.clone());
            gpu.zc_error_max = *error;
            gpu.draw_triangle(a, b, c);
        },
        |reference, (state, corners, error)| {
            reference.zc_error_max = i128::from(*error);
            reference.triangle(state, mode, *corners);
        },
    );
}

macro_rules! triangle_tests {
    ($($name:ident: $draw:ident $mode:ident;)*) => {$(
        #[test]
        fn $name() {
            triangles(DrawMode::$draw, TriangleMode::$mode);
        }
    )*};
}

triangle_tests! {
    opaque_affine: Opaque Affine;
    opaque_perspective: Opaque Perspective;
    opaque_untextured: Opaque Untextured;
    opaque_wireframe: Opaque Wireframe;
    keyed_affine: Keyed Affine;
    keyed_perspective: Keyed Perspective;
    keyed_untextured: Keyed Untextured;
    keyed_wireframe: Keyed Wireframe;
    alpha_affine: Alpha Affine;
    alpha_perspective: Alpha Perspective;
    alpha_untextured: Alpha Untextured;
    alpha_wireframe: Alpha Wireframe;
    alpha_keyed_affine: AlphaKeyed Affine;
    alpha_keyed_perspective: AlphaKeyed Perspective;
    alpha_keyed_untextured: AlphaKeyed Untextured;
    alpha_keyed_wireframe: AlphaKeyed Wireframe;
}

fn any_mode(random: &mut Random) -> DrawMode {
    DrawMode::ALL[random.bits() as usize % 4]
}

#[test]
fn lines() {
    compare(
        101,
        |random| {
            let (a, b) = (random.point(WIDTH, HEIGHT), random.point(WIDTH, HEIGHT));
            (any_mode(random), random.bits() as u8, random.bits() as u8, a, b)
        },
        |gpu, (mode, color, intensity, a, b)| {
            gpu.line_state.draw_mode = *mode;
            gpu.line_state.draw_color = *color;
            gpu.line_state.draw_intensity = *intensity;
            gpu.draw_line(a, b);
        },
        |reference, (mode, color, intensity, a, b)| {
            let color = u32::from(*color) + u32::from(*intensity) / 8 * 256;
            reference.line(*mode, color, *a, *b);
        },
    );
}

#[test]
fn pixels() {
    compare(
        102,
        |random| (random.range(-3, WIDTH + 3), random.range(-3, HEIGHT + 3), random.bits() as u16),
        |gpu, (x, y, color)| gpu.put_pixel(*x, *y, *color),
        |reference, (x, y, color)| reference.put_pixel(*x, *y, *color),
    );
}

/// A sprite: its state, place, scale, second corner and distance.
fn sprite(random: &mut Random) -> (RasterState, [i32; 2], i32, [i32; 2], i32) {
    let (width, height) = (random.range(1, 70), random.range(1, 70));
    let state = RasterState {
        draw_mode: any_mode(random),
        draw_intensity: random.bits() as u8,
        texture: Some(random.sized_texture(width, height)),
        ..RasterState::default()
    };
    let place = |random: &mut Random| [random.range(-90, WIDTH), random.range(-90, HEIGHT)];
    let scale = if random.one_in(9) { random.range(-100, 10_000) } else { random.range(1, 600) };
    let (from, to) = (place(random), place(random));
    (state, from, scale, to, random.point(1, 1)[2])
}

#[test]
fn sprites() {
    compare(
        103,
        sprite,
        |gpu, (state, at, ..)| {
            gpu.sprite_state = state.clone();
            gpu.draw_sprite(at[0], at[1]);
        },
        |reference, (state, at, ..)| {
            let Some(texture) = &state.texture else { return };
            let size = [texture.width().into(), texture.height().into()];
            reference.sprite(state, *at, size, None);
        },
    );
}

#[test]
fn scaled_sprites() {
    compare(
        104,
        sprite,
        |gpu, (state, at, scale, ..)| {
            gpu.sprite_state = state.clone();
            gpu.draw_sprite_scale(at[0], at[1], *scale);
        },
        |reference, (state, at, scale, ..)| {
            let Some(texture) = state.texture.as_ref().filter(|_| *scale > 0) else { return };
            let size = [texture.width(), texture.height()]
                .map(|side| (i128::from(side) * i128::from(*scale) / 256).max(1));
            reference.sprite(state, *at, size, None);
        },
    );
}

#[test]
fn sprites_with_depth() {
    compare(
        105,
        sprite,
        |gpu, (state, from, _, to, z)| {
            gpu.sprite_state = state.clone();
            gpu.draw_sprite_scale_zb(*from, *to, *z);
        },
        |reference, (state, from, _, to, z)| {
            let size = [0, 1].map(|i| i128::from(to[i]) - i128::from(from[i]));
            if *z >= 64 && size[0] > 0 && size[1] > 0 {
                reference.sprite(state, *from, size, Some(*z));
            }
        },
    );
}

/// Sorted faces are drawn by mean distance, equal ones in order.
#[test]
fn sorted_triangles() {
    for turn in 0..40 {
        let mut random = Random::new(turn);
        let mut reference = Reference::new(WIDTH as u32, HEIGHT as u32);
        let mut gpu = gpu(turn as usize);
        noise(&mut random, &mut gpu, &mut reference);
        let mode = TriangleMode::ALL[turn as usize % 4];
        gpu.triangle_mode = Some(mode);
        gpu.set_work_memory(0, 60).expect("a small table");
        let texture = random.texture();
        let mut waiting = Vec::new();
        for _ in 0..400 {
            let state = RasterState {
                draw_mode: any_mode(&mut random),
                draw_color: random.bits() as u8,
                test_culling: random.one_in(3),
                z_sort: true,
                texture: Some(Arc::clone(&texture)),
                ..RasterState::default()
            };
            let corners = random.triangle(WIDTH, HEIGHT);
            gpu.triangle_state = Some(state.clone());
            let before = gpu.sorted_faces();
            gpu.draw_triangle(&corners[0], &corners[1], &corners[2]);
            if gpu.sorted_faces() > before {
                let sum: i64 = corners.iter().map(|c| i64::from(c.z)).sum();
                waiting.push(((sum / 3).clamp(0, 4095), state, corners));
            }
        }
        assert_eq!(gpu.sorted_faces(), 60, "later faces are ignored");
        assert_same(&mut gpu, &reference, &"nothing is drawn yet");
        for distance in (0..4096).rev() {
            for (_, state, corners) in waiting.iter().filter(|(d, ..)| *d == distance) {
                reference.triangle(state, mode, *corners);
            }
        }
        gpu.sort_draw();
        assert_same(&mut gpu, &reference, &"sorted");
        gpu.sort_draw();
        assert_same(&mut gpu, &reference, &"the table is empty");
    }
}
