//! The conformance scene: nine steps with known results.
//!
//! Source: RAVE, conformance scene.

use fillrate_rave::constants::context::DOUBLE_BUFFER;
use fillrate_rave::constants::{blend, compare, fog, vertex_mode};
use fillrate_rave::tags::{float, int};
use fillrate_rave::{Call, PixelType, RaveRect, VGouraud, VTexture};

use crate::scene::{Scene, area, channels, colored, config, image, memory, textured};

const BLUE: [f32; 3] = [0.0, 0.15, 1.0];
const RED: [f32; 3] = [1.0, 0.08, 0.03];
const GREEN: [f32; 3] = [0.0, 1.0, 0.0];

fn is_mostly(argb: u32, channel: usize) -> bool {
    let [_, rgb @ ..] = channels(argb);
    (0..3).all(|i| if i == channel { rgb[i] > 170 } else { rgb[i] < 85 })
}

fn shape(corners: [(f32, f32); 3], v: VGouraud) -> [VGouraud; 3] {
    corners.map(|(x, y)| VGouraud { x, y, ..v })
}

fn textured_shape(corners: [(f32, f32); 3], v: VTexture) -> [VTexture; 3] {
    corners.map(|(x, y)| VTexture { x, y, ..v })
}

/// The texture of steps 5 and 6: 2x2 indices.
fn indexed_texture(scene: &mut Scene) -> u32 {
    let mut entries = vec![0u8; 1024];
    let colors = [0x00ff_0000u32, 0x0000_ff00, 0x0000_00ff, 0x00ff_ffff];
    for (entry, color) in entries.as_chunks_mut::<4>().0.iter_mut().zip(colors) {
        *entry = color.to_le_bytes();
    }
    let table = scene.call(Call::ColorTableNew {
        engine: 1,
        table_type: 0,
        entries: entries.into(),
        transparent_index: 0,
    });
    let image = fillrate_rave::ImageValue { width: 2, height: 2, pixels: vec![0, 1, 2, 3].into() };
    let pixel_type = PixelType::Cl8.number();
    let images = vec![image];
    let texture =
        scene.call(Call::TextureNew { engine: 1, flags: 0, pixel_type, images }).created();
    let bound =
        scene.call(Call::TextureBindColorTable { engine: 1, texture, table: table.created() });
    assert_eq!(bound.number(), 0);
    texture
}

fn draw(scene: &mut Scene) {
    // 1: the nearer wins.
    scene.tri(shape([(10.0, 205.0), (82.0, 18.0), (154.0, 205.0)], colored(BLUE, 0.8)));
    scene.tri(shape([(35.0, 170.0), (82.0, 65.0), (129.0, 170.0)], colored(RED, 0.2)));
    // 2: interpolation.
    scene.int(int::BLEND, blend::INTERPOLATE);
    let corners = [(130.0, 208.0), (160.0, 150.0), (190.0, 208.0)];
    scene.tri(shape(corners, colored(BLUE, 0.4)));
    scene.tri(shape(corners, VGouraud { a: 0.5, ..colored(RED, 0.1) }));
    // 3: the alpha test.
    let corners = [(280.0, 215.0), (295.0, 195.0), (310.0, 215.0)];
    scene.tri(shape(corners, colored(GREEN, 0.4)));
    scene.float(float::ALPHA_TEST_REF, 0.5);
    scene.int(int::ALPHA_TEST_FUNC, compare::GT);
    scene.tri(shape(corners, VGouraud { a: 0.25, ..colored(RED, 0.1) }));
    scene.int(int::ALPHA_TEST_FUNC, compare::NONE);
    // 4: back faces are drawn.
    let corners = [(5.0, 55.0), (30.0, 5.0), (55.0, 55.0)];
    scene.tri(shape(corners, colored(BLUE, 0.4)));
    let [a, b, c] = shape(corners, colored(RED, 0.1));
    scene.call(Call::DrawTriGouraud { context: scene.context, a, b, c, flags: 1 });
    // 5: v of 1 is the first row.
    let texture = indexed_texture(scene);
    scene.texture(texture);
    let corners = [(115.0, 55.0), (140.0, 5.0), (165.0, 55.0)];
    scene.tri(shape(corners, colored(BLUE, 0.4)));
    let vertices = textured_shape(corners, VTexture { v_over_w: 1.0, ..textured(0.1) }).to_vec();
    let (mode, flags) = (vertex_mode::TRI, Some(vec![1]));
    scene.call(Call::DrawVTexture { context: scene.context, mode, vertices, flags });
    // 6: v of 0 at the top shows the last row there.
    scene.int(int::GL_TEXTURE_WRAP_U, 1);
    scene.int(int::GL_TEXTURE_WRAP_V, 1);
    let corner = |x, y, u_over_w, v_over_w| VTexture { x, y, u_over_w, v_over_w, ..textured(0.3) };
    let vertices = vec![
        corner(178.0, 38.0, 0.0, 0.0),
        corner(302.0, 38.0, 1.0, 0.0),
        corner(178.0, 190.0, 0.0, 1.0),
        corner(302.0, 190.0, 1.0, 1.0),
    ];
    let (mode, flags) = (vertex_mode::STRIP, None);
    scene.call(Call::DrawVTexture { context: scene.context, mode, vertices, flags });
    // 7: a bitmap needs no texture.
    scene.texture(0);
    let argb: Vec<u32> = (0..16).map(|i| if i < 8 { 0xffff_0000 } else { 0xff00_ff00 }).collect();
    let (pixel_type, image) = (PixelType::Argb32.number(), image(4, &argb));
    let bitmap = scene.call(Call::BitmapNew { engine: 1, flags: 0, pixel_type, image }).created();
    let v = VGouraud { x: 318.0, y: 212.0, ..colored([0.0; 3], 0.05) };
    scene.call(Call::DrawBitmap { context: scene.context, v, bitmap });
    // 8: fog by 1/invW, PerspectiveZ from here on, corners below the edge.
    scene.color(float::FOG_COLOR_A, [1.0, 0.0, 0.0, 1.0]);
    scene.float(float::FOG_START, 0.0);
    scene.float(float::FOG_END, 1.0);
    scene.int(int::PERSPECTIVE_Z, 1);
    scene.int(int::FOG_MODE, fog::LINEAR);
    let far = VGouraud { inv_w: 1.0 / 0.75, ..colored([1.0, 0.0, 0.0], 0.1) };
    scene.tri(shape([(210.0, 232.0), (240.0, 200.0), (270.0, 232.0)], far));
    scene.int(int::FOG_MODE, fog::NONE);
    scene.int(int::PERSPECTIVE_Z, 0);
}

fn check(scene: &mut Scene) {
    assert!(is_mostly(scene.pixel(82, 120), 0), "1");
    let [_, r, g, b] = channels(scene.pixel(160, 190));
    assert!(r > 85 && b > 85 && g < 85, "2: {r} {g} {b}");
    assert!(is_mostly(scene.pixel(295, 207), 1), "3");
    assert!(is_mostly(scene.pixel(30, 35), 0), "4");
    assert!(is_mostly(scene.pixel(140, 35), 0), "5");
    assert!(is_mostly(scene.pixel(200, 60), 2), "6");
    assert!(is_mostly(scene.pixel(319, 213), 0), "7, upper half");
    assert!(is_mostly(scene.pixel(319, 215), 1), "7, lower half");
}

/// Step 8: a quarter of the colour is left at a distance of 0.75.
fn check_fog(scene: &mut Scene, tolerance: u32) {
    let [_, r, g, b] = channels(scene.pixel(240, 218));
    assert!(r.abs_diff(64) <= tolerance && b.abs_diff(191) <= tolerance && g == 0, "{r} {g} {b}");
}

fn prepare(scene: &mut Scene) {
    scene.color(float::COLOR_BG_A, [1.0, 0.03, 0.03, 0.08]);
    scene.int(int::Z_FUNCTION, compare::LT);
    scene.int(int::Z_BUFFER_MASK, 1);
}

/// Pixel types, and how far dithering may move a channel.
const TYPES: [(PixelType, u32); 7] = [
    (PixelType::Rgb32, 2),
    (PixelType::Argb32, 2),
    (PixelType::Rgb16, 12),
    (PixelType::Rgb16_565, 12),
    (PixelType::Argb16, 12),
    (PixelType::Argb16_4444, 20),
    (PixelType::Rgb24, 2),
];

fn in_all_contexts(check: impl Fn(&mut Scene, u32)) {
    for (pixel_type, tolerance) in TYPES {
        for flags in [DOUBLE_BUFFER, 0, DOUBLE_BUFFER | 2] {
            let mut scene = Scene::with(config(), 320, 220, pixel_type, flags);
            prepare(&mut scene);
            scene.start();
            draw(&mut scene);
            assert_eq!(scene.end(), Ok(()), "{pixel_type:?} {flags}");
            check(&mut scene, tolerance);
        }
    }
}

#[test]
fn the_scene_has_its_known_results() {
    in_all_contexts(|scene, _| check(scene));
}

#[test]
fn the_scene_has_its_fog() {
    in_all_contexts(check_fog);
}

/// Step 9: what the clip leaves out keeps what it had.
#[test]
fn outside_the_clip_nothing_changes() {
    let mut scene = Scene::new(8, 8, PixelType::Rgb32);
    let clip = vec![RaveRect::new(0, 0, 320, 2), RaveRect::new(0, 6, 320, 220)];
    let call = Call::DrawContextNew {
        engine: 1,
        device: memory(320, 220, PixelType::Rgb32),
        rect: area(320, 220),
        scaled: None,
        clip: Some(clip),
        flags: DOUBLE_BUFFER,
    };
    scene.context = scene.call(call).created();
    let green: Vec<u8> = std::iter::repeat_n([0, 255, 0, 0], 320 * 220).flatten().collect();
    scene.call(Call::WindowContents { context: scene.context, pixels: green.into() });
    prepare(&mut scene);
    scene.start();
    scene.end().unwrap();
    assert_eq!(scene.pixel(160, 4), 0xff00_ff00);
    assert_eq!([1, 6].map(|y| scene.pixel(160, y)), [0xff08_0814; 2]);
}
