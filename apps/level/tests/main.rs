//! The level made here, through the whole program's path: file, materials,
//! visibility, both ways of drawing.

use std::collections::BTreeSet;

use fillrate_engine::DeviceConfig;
use fillrate_glide::card::Card;
use fillrate_glide::{Improvements, Shown};
use fillrate_level::bsp::Bsp;
use fillrate_level::camera::Path;
use fillrate_level::draw::{Difference, DrawOptions, Renderer};
use fillrate_level::level::Level;
use fillrate_level::synthetic;
use fillrate_level::view::{Camera, View};

fn level() -> Level {
    Level::load(&mut synthetic::assets(), synthetic::NAME, 256).expect("the level is valid")
}

fn renderer(level: &Level, passes: u32, fog: Option<f32>, threads: usize) -> Renderer {
    let options = DrawOptions {
        card: Card::by_name("voodoo-8mb-2tmu").expect("a board"),
        resolution: 1,
        passes,
        fog,
        device: DeviceConfig { threads, ..DeviceConfig::default() },
        check: true,
        improve: Improvements::default(),
    };
    Renderer::new(options, level.surfaces.len()).expect("the board opens")
}

fn looking(eye: [f32; 3], x: f32) -> Camera {
    Camera { eye, forward: [x, 0.0, 0.0], right: [0.0, -x, 0.0], up: [0.0, 0.0, 1.0] }
}

fn picture(renderer: &mut Renderer, level: &Level, camera: Camera) -> Shown {
    renderer.draw(level, &View::new(camera, 320, 240), 1.25);
    assert_eq!(renderer.problems(), Vec::<String>::new());
    renderer.shown().expect("a frame")
}

#[test]
fn everything_of_the_file_is_read() {
    let level = level();
    assert_eq!(level.spawns.len(), 6);
    assert_eq!(level.bsp.faces.len(), 33);
    assert_eq!(level.bsp.lightmaps.len(), 2);
    assert_eq!(level.textures.len(), 8 + 2);
    assert_eq!((level.skies.len(), level.skies[0].clouds.len()), (1, 2));
    // The hidden wall; the sky is no surface.
    assert_eq!(level.skipped.hidden, 1);
    assert_eq!(level.surfaces.len(), 31);
    assert_eq!((level.skipped.invalid, level.skipped.missing_pictures), (0, 0));
}

#[test]
fn rooms_that_are_not_visible_are_not_collected() {
    let bsp = Bsp::parse(&synthetic::level()).expect("the level is valid");
    let cluster = |x: f32| bsp.leaf_at([x, 0.0, 50.0]).and_then(|leaf| leaf.cluster);
    assert_eq!((cluster(-300.0), cluster(300.0), cluster(600.0)), (Some(0), Some(1), Some(2)));
    assert!(bsp.sees(Some(0), 1) && !bsp.sees(Some(0), 2) && bsp.sees(None, 2));

    // From the first room through both doorways: the grating of the third
    // room is ahead, and left out.
    let level = level();
    let mut renderer = renderer(&level, 1, None, 1);
    let view = View::new(looking([-300.0, 0.0, 50.0], 1.0), 320, 240);
    let near = renderer.draw(&level, &view, 1.25).surfaces;
    let view = View::new(looking([100.0, 0.0, 50.0], 1.0), 320, 240);
    let far = renderer.draw(&level, &view, 1.25).surfaces;
    assert!(near > 8 && far > 8, "{near} {far}");
    let third: BTreeSet<usize> =
        level.bsp.leaf_faces(&level.bsp.leafs[2]).iter().copied().collect();
    let all = level.surface_of.iter().enumerate().filter(|(_, s)| s.is_some());
    assert!(near <= all.filter(|(face, _)| !third.contains(face)).count());
}

#[test]
fn the_picture_is_closed_and_lit() {
    let level = level();
    let mut renderer = renderer(&level, 1, None, 2);
    let picture = picture(&mut renderer, &level, looking([-450.0, 0.0, 100.0], 1.0));
    // Indoors nothing of the clear colour is left (0x586878, undithered).
    let sky = 0x58 >> 3 << 11 | 0x68 >> 2 << 5 | 0x78 >> 3;
    assert!(picture.pixels.iter().filter(|&&p| p == sky).count() < 20);
    let colors: BTreeSet<u16> = picture.pixels.iter().copied().collect();
    assert!(colors.len() > 100, "{}", colors.len());
}

/// One pass on two units and two passes on one show the same, but for
/// rounding and the pixels where surfaces meet.
#[test]
fn both_ways_of_drawing_agree() {
    let level = level();
    for fog in [None, Some(0.002)] {
        let (mut one, mut two) = (renderer(&level, 1, fog, 1), renderer(&level, 2, fog, 1));
        let path = Path::new(&level.bsp, &level.spawns, [0.0; 3]);
        let mut difference = Difference::default();
        for i in 0..8 {
            let camera = path.camera(i as f32 / 8.0);
            let (a, b) = (picture(&mut one, &level, camera), picture(&mut two, &level, camera));
            difference.add(&a, &b);
        }
        assert!(difference.largest > 0, "the ways are different");
        assert!(difference.beyond * 10_000 < difference.pixels, "{difference:?}");
    }
}

/// A unit too small for all textures shows the same as one that holds them.
#[test]
fn texture_memory_is_managed() {
    let level = level();
    let small = DrawOptions {
        card: Card { texture: 1, units: 1, frame_buffer: 2, ..Card::default() },
        resolution: 1,
        passes: 2,
        fog: None,
        device: DeviceConfig { threads: 1, ..DeviceConfig::default() },
        check: true,
        improve: Improvements::default(),
    };
    let mut tight = Renderer::new(small, level.surfaces.len()).expect("the board opens");
    let mut wide = renderer(&level, 2, None, 1);
    for x in [-400.0, 100.0, 600.0, -400.0] {
        let camera = looking([x, 10.0, 100.0], 1.0);
        assert_eq!(picture(&mut tight, &level, camera), picture(&mut wide, &level, camera));
    }
}

/// Damaged files are refused or drawn, and never more than that.
#[test]
fn damaged_levels_end_well() {
    let whole = synthetic::level();
    let mut random = 1u32;
    let mut next = || {
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (random >> 8) as usize
    };
    let mut valid = 0;
    for _ in 0..300 {
        let mut bytes = whole.clone();
        // Mostly in the tables in front of the lightmaps, which are large.
        for _ in 0..4 {
            let at = next() % if next() % 2 == 0 { 2000 } else { bytes.len() };
            bytes[at] = next() as u8;
        }
        bytes.truncate(if next() % 4 == 0 { next() % bytes.len() } else { bytes.len() });
        let mut assets = synthetic::assets();
        assets.insert("maps/builtin.bsp", bytes);
        valid += usize::from(Level::load(&mut assets, synthetic::NAME, 8).is_ok());
    }
    assert!(valid > 20, "{valid}");
}
