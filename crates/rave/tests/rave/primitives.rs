//! Points, lines, arrays, patterns and the scissor rectangle.

use fillrate_rave::constants::{fog, vertex_mode};
use fillrate_rave::tags::{float, int};
use fillrate_rave::{Call, PixelType, RaveError, Shown, VGouraud, VTexture};

use crate::scene::{Scene, channels, colored, textured};

const RED: u32 = 0xffff_0000;

fn scene() -> Scene {
    let mut scene = Scene::new(32, 32, PixelType::Rgb32);
    scene.color(float::COLOR_BG_A, [1.0, 0.0, 0.0, 0.0]);
    scene
}

fn frame(scene: &mut Scene, draw: impl FnOnce(&mut Scene)) -> Shown {
    scene.start();
    draw(scene);
    assert_eq!(scene.end(), Ok(()));
    scene.library.shown().expect("a frame is shown")
}

fn red(x: f32, y: f32) -> VGouraud {
    VGouraud { x, y, ..colored([1.0, 0.0, 0.0], 0.5) }
}

/// The pixels that are not black.
fn drawn(shown: &Shown) -> Vec<(u32, u32)> {
    let all = (0..shown.height).flat_map(|y| (0..shown.width).map(move |x| (x, y)));
    all.filter(|&(x, y)| shown.argb(x, y) != 0xff00_0000).collect()
}

fn line(scene: &mut Scene, a: VGouraud, b: VGouraud) {
    scene.call(Call::DrawLine { context: scene.context, a, b });
}

#[test]
fn a_point_is_a_square() {
    let mut scene = scene();
    let point = |scene: &mut Scene, v| {
        scene.call(Call::DrawPoint { context: scene.context, v });
    };
    assert_eq!(drawn(&frame(&mut scene, |scene| point(scene, red(5.5, 7.5)))), [(5, 7)]);
    assert_eq!(drawn(&frame(&mut scene, |scene| point(scene, red(5.0, 7.9)))), [(5, 7)]);
    scene.float(float::WIDTH, 3.0);
    let square = drawn(&frame(&mut scene, |scene| point(scene, red(5.5, 7.5))));
    assert_eq!((square.len(), square[0], square[8]), (9, (4, 6), (6, 8)));
    let cut = drawn(&frame(&mut scene, |scene| point(scene, red(0.0, 31.9))));
    assert!(!cut.is_empty() && cut.iter().all(|&(x, y)| x < 3 && y > 28));
}

/// One pixel in every column or row between the ends, nearest to the line.
#[test]
fn a_line_has_a_pixel_for_each_step() {
    let ends = [
        ((2.5, 3.5), (20.5, 9.5)),
        ((20.5, 9.5), (2.5, 3.5)),
        ((3.25, 28.0), (11.75, 4.0)),
        ((4.5, 4.5), (4.5, 25.5)),
        ((29.5, 6.5), (1.5, 6.5)),
        ((0.5, 0.5), (31.5, 31.5)),
    ];
    for ((x0, y0), (x1, y1)) in ends {
        let mut scene = scene();
        let pixels = drawn(&frame(&mut scene, |scene| line(scene, red(x0, y0), red(x1, y1))));
        let steep = (y1 - y0).abs() > (x1 - x0).abs();
        let (from, to) = if steep { (y0, y1) } else { (x0, x1) };
        let (low, high): (f32, f32) = (from.min(to), from.max(to));
        let steps: Vec<u32> =
            (0..32).filter(|&i| (low..high).contains(&(i as f32 + 0.5))).collect();
        let mut major: Vec<u32> = pixels.iter().map(|&(x, y)| if steep { y } else { x }).collect();
        major.sort_unstable();
        assert_eq!(major, steps, "{x0} {y0} {x1} {y1}");
        for (x, y) in pixels {
            let (x, y) = (x as f32 + 0.5, y as f32 + 0.5);
            let off = match steep {
                true => x0 + (x1 - x0) * (y - y0) / (y1 - y0) - x,
                false => y0 + (y1 - y0) * (x - x0) / (x1 - x0) - y,
            };
            assert!(off.abs() <= 0.57, "{x} {y} is {off} off");
        }
    }
}

#[test]
fn wide_lines_grow_across() {
    let mut scene = scene();
    scene.float(float::WIDTH, 5.0);
    let pixels = drawn(&frame(&mut scene, |scene| line(scene, red(4.0, 10.5), red(12.0, 10.5))));
    let expected: Vec<(u32, u32)> = (8..13).flat_map(|y| (4..12).map(move |x| (x, y))).collect();
    assert_eq!(pixels, expected);
}

#[test]
fn colors_run_along_a_line() {
    let mut scene = scene();
    let end = VGouraud { x: 32.0, ..colored([0.0, 0.0, 1.0], 0.5) };
    let shown = frame(&mut scene, |scene| {
        line(scene, red(0.0, 4.5), VGouraud { y: 4.5, ..end });
    });
    for x in 0..32 {
        let [_, r, _, b] = channels(shown.argb(x, 4));
        let expected = (x as f32 + 0.5) / 32.0 * 255.0;
        assert!((b as f32 - expected).abs() <= 1.0 && (r as f32 - (255.0 - expected)).abs() <= 1.0);
    }
}

#[test]
fn the_line_pattern_starts_at_the_first_end_and_goes_on() {
    let mut scene = scene();
    scene.int(int::GL_LINE_PATTERN, 0b0011);
    let columns = |shown: &Shown| drawn(shown).iter().map(|&(x, _)| x).collect::<Vec<u32>>();
    let right = frame(&mut scene, |scene| line(scene, red(3.0, 4.5), red(23.0, 4.5)));
    assert_eq!(columns(&right), [3, 4, 19, 20]);
    let left = frame(&mut scene, |scene| line(scene, red(23.0, 4.5), red(3.0, 4.5)));
    assert_eq!(columns(&left), [5, 6, 21, 22]);
    scene.int(int::GL_LINE_PATTERN_FACTOR, 2);
    let twice = frame(&mut scene, |scene| line(scene, red(0.0, 4.5), red(32.0, 4.5)));
    assert_eq!(columns(&twice), [0, 1, 2, 3]);
    scene.int(int::GL_LINE_PATTERN_FACTOR, 1);
    scene.int(int::GL_LINE_PATTERN, 0x00ff);
    let polyline = frame(&mut scene, |scene| {
        let vertices = vec![red(0.0, 4.5), red(5.0, 4.5), red(32.0, 4.5)];
        let (context, mode) = (scene.context, vertex_mode::POLYLINE);
        scene.call(Call::DrawVGouraud { context, mode, vertices, flags: None });
    });
    let expected: Vec<u32> = (0..8).chain(16..24).collect();
    assert_eq!(columns(&polyline), expected, "on through the polyline");
}

#[test]
fn areas_have_a_pattern() {
    let mut scene = scene();
    for row in 0..32 {
        let checkered = if row % 2 == 0 { 0xaaaa_aaaa } else { 0x5555_5555 };
        scene.int(int::GL_AREA_PATTERN_0 + row, checkered);
    }
    let shown = frame(&mut scene, |scene| scene.rect([0.0, 0.0, 32.0, 32.0], red(0.0, 0.0)));
    for (x, y) in (0..32).flat_map(|y| (0..32).map(move |x| (x, y))) {
        let expected = if (x + y) % 2 == 0 { RED } else { 0xff00_0000 };
        assert_eq!(shown.argb(x, y), expected, "{x} {y}");
    }
}

#[test]
fn the_scissor_rectangle_ends_before_its_maximum() {
    let mut scene = scene();
    for (tag, value) in [
        (int::GL_SCISSOR_X_MIN, 3),
        (int::GL_SCISSOR_Y_MIN, 5),
        (int::GL_SCISSOR_X_MAX, 10),
        (int::GL_SCISSOR_Y_MAX, 9),
    ] {
        scene.int(tag, value);
    }
    let pixels =
        drawn(&frame(&mut scene, |scene| scene.rect([0.0, 0.0, 32.0, 32.0], red(0.0, 0.0))));
    assert_eq!((pixels.len(), pixels[0], pixels[27]), (28, (3, 5), (9, 8)));
    scene.int(int::GL_SCISSOR_X_MAX, u32::MAX);
    assert!(
        drawn(&frame(&mut scene, |scene| scene.rect([0.0, 0.0, 32.0, 32.0], red(0.0, 0.0))))
            .is_empty()
    );
}

/// Arrays draw what their parts draw one by one.
#[test]
fn arrays_are_their_parts() {
    let at = |i: usize| {
        let i = i as f32;
        let place = VGouraud { x: (i * 7.3) % 31.0, y: (i * 11.9) % 29.0, ..VGouraud::default() };
        VGouraud {
            z: 0.9 - i / 20.0,
            r: i / 10.0,
            g: 1.0 - i / 10.0,
            b: 0.5,
            a: 0.7,
            inv_w: 1.0,
            ..place
        }
    };
    let v: Vec<VGouraud> = (0..9).map(at).collect();
    type Parts = fn(usize) -> Vec<[usize; 3]>;
    let modes: [(u32, Parts); 3] = [
        (vertex_mode::TRI, |n| (0..n / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect()),
        (vertex_mode::STRIP, |n| (0..n - 2).map(|i| [i, i + 1, i + 2]).collect()),
        (vertex_mode::FAN, |n| (0..n - 2).map(|i| [0, i + 1, i + 2]).collect()),
    ];
    let mut scene = scene();
    scene.int(int::BLEND, 1);
    for (mode, parts) in modes {
        let whole = frame(&mut scene, |scene| {
            let (context, vertices) = (scene.context, v.clone());
            scene.call(Call::DrawVGouraud { context, mode, vertices, flags: None });
        });
        let single = frame(&mut scene, |scene| {
            parts(9).into_iter().for_each(|p| scene.tri(p.map(|i| v[i])))
        });
        assert_eq!(whole, single, "mode {mode}");
        assert!(drawn(&whole).len() > 20);
    }
    let lines = frame(&mut scene, |scene| {
        let (context, vertices) = (scene.context, v.clone());
        scene.call(Call::DrawVGouraud { context, mode: vertex_mode::LINE, vertices, flags: None });
    });
    let single =
        frame(&mut scene, |scene| (0..4).for_each(|i| line(scene, v[2 * i], v[2 * i + 1])));
    assert_eq!(lines, single);
    scene.start();
    let (context, vertices) = (scene.context, v.clone());
    scene.call(Call::DrawVGouraud { context, mode: 6, vertices, flags: None });
    assert_eq!(scene.end(), Err(RaveError::Parameter), "there is no mode 6");
}

/// Fog by distance, for colours, textures and corners without w, is its curve
/// within a step.
#[test]
fn fog_follows_its_curve() {
    let stays = |mode: u32, d: f64| match mode {
        fog::LINEAR => ((20.0 - d) / 18.0).clamp(0.0, 1.0),
        fog::EXPONENTIAL => (-0.2 * d).exp(),
        _ => (-(0.2 * d) * (0.2 * d)).exp(),
    };
    let mut scene = scene();
    scene.float(float::FOG_START, 2.0);
    scene.float(float::FOG_END, 20.0);
    scene.float(float::FOG_DENSITY, 0.2);
    scene.float(float::FOG_MAX_DEPTH, 10.0);
    scene.color(float::FOG_COLOR_A, [1.0, 0.0, 0.0, 1.0]);
    let texture = scene.texture_new(1, &[RED]);
    scene.texture(texture);
    for mode in [fog::LINEAR, fog::EXPONENTIAL, fog::EXPONENTIAL_SQUARED] {
        scene.int(int::FOG_MODE, mode);
        for step in 1..30 {
            let d = f64::from(step) * 0.8;
            let inv_w = (1.0 / d) as f32;
            let shown = frame(&mut scene, |scene| {
                scene.rect([0.0, 0.0, 16.0, 16.0], VGouraud { inv_w, ..red(0.0, 0.0) });
                let v = VTexture { inv_w, ..textured(0.5) };
                scene.rect_texture([16.0, 0.0, 32.0, 16.0], v);
                let without = VGouraud { inv_w: 0.0, z: d as f32 / 24.0, ..red(0.0, 0.0) };
                scene.rect([0.0, 16.0, 16.0, 32.0], without);
            });
            let by_z = stays(mode, d / 24.0 * 10.0);
            let expected = [((8, 8), stays(mode, d)), ((24, 8), stays(mode, d)), ((8, 24), by_z)];
            for ((x, y), stays) in expected {
                let [_, r, g, b] = channels(shown.argb(x, y));
                let off = (f64::from(r) - 255.0 * stays).abs();
                assert!(off <= 3.0 && g == 0 && r + b >= 254, "mode {mode} d {d}: {r} {b}, {off}");
            }
        }
    }
}
