//! Levels of detail and of mip maps.

use fillrate_geometry::{
    Sphere, Vec3, View, WantedTexture, choose_level, fit_levels, keep_or_choose_level, mip_level,
    projected_radius,
};

use crate::support::{Random, cases};

fn view() -> View {
    View::new(640.0, 480.0, 200.0, 1.0, 1000.0).expect("a view")
}

#[test]
fn projected_radius_known_values() {
    let radius =
        |z, radius| projected_radius(&view(), &Sphere { centre: Vec3::new(5.0, 5.0, z), radius });
    assert_eq!(radius(100.0, 4.0), 8.0);
    assert_eq!(radius(0.5, 4.0), 800.0);
    assert_eq!(radius(-3.0, 4.0), 800.0);
    assert_eq!(radius(-5.0, 4.0), 0.0);
    assert_eq!(radius(f32::NAN, 4.0), 0.0);
    assert_eq!(radius(10.0, f32::INFINITY), 0.0);
    assert!(radius(1e18, 1e18).is_finite());
}

#[test]
fn level_of_detail_by_size() {
    let thresholds = [100.0, 25.0, 4.0];
    for (size, level) in
        [(500.0, 0), (100.0, 0), (99.0, 1), (25.0, 1), (5.0, 2), (3.9, 3), (0.0, 3), (f32::NAN, 3)]
    {
        assert_eq!(choose_level(&thresholds, size), level, "{size}");
    }
    assert_eq!(choose_level(&[], 5.0), 0);
    let keep = |size, previous| keep_or_choose_level(&thresholds, size, previous, 0.1);
    assert_eq!((keep(95.0, 0), keep(95.0, 1)), (0, 1));
    assert_eq!((keep(105.0, 0), keep(105.0, 1)), (0, 1));
    assert_eq!((keep(80.0, 0), keep(120.0, 1)), (1, 0));
    assert_eq!((keep(f32::NAN, 0), keep(500.0, usize::MAX)), (3, 0));
    assert_eq!(keep_or_choose_level(&[1.0, 9.0], 5.0, 1, f32::INFINITY), 1);
}

#[test]
fn mip_level_by_the_closest_z() {
    // 20 texels for a unit, 200 pixels at z = 1: 0.1 texels a pixel.
    for (z, level) in [(1.0, 0), (10.0, 0), (19.9, 0), (20.0, 1), (40.0, 2), (79.0, 2), (900.0, 6)]
    {
        assert_eq!(mip_level(&view(), 20.0, z, 8), level, "{z}");
    }
    assert_eq!(mip_level(&view(), 20.0, 900.0, 3), 2);
    assert_eq!(mip_level(&view(), 1e18, 1e18, u32::MAX), 31);
    for bad in [f32::NAN, f32::INFINITY, 0.0, -5.0] {
        assert_eq!(mip_level(&view(), bad, 50.0, 8), 0);
        assert_eq!(mip_level(&view(), 20.0, bad, 8), 0);
    }
    assert_eq!(mip_level(&view(), 20.0, 900.0, 0), 0);
}

fn texture(side: u32, levels: u32) -> WantedTexture {
    WantedTexture { width: side, height: side, texel_bytes: 2, levels, finest: 0 }
}

#[test]
fn mip_levels_save_what_the_technote_says() {
    let large = texture(128, 8);
    assert_eq!(large.bytes_from(7), 2);
    assert_eq!(large.bytes_from(8), 0);
    let whole = large.bytes_from(0) as f64;
    // A third more than the level alone; 95 per cent less with the third level.
    assert!((whole / (128.0 * 128.0 * 2.0) - 4.0 / 3.0).abs() < 0.001);
    assert!((0.93..0.96).contains(&(1.0 - large.bytes_from(2) as f64 / whole)));
    let odd = WantedTexture { width: 8, height: 1, ..texture(0, 4) };
    assert_eq!(odd.bytes_from(0), 2 * (8 + 4 + 2 + 1));
    let huge =
        WantedTexture { width: u32::MAX, height: u32::MAX, texel_bytes: 99, ..texture(0, 9) };
    assert_eq!(huge.bytes_from(0), u64::MAX);
    assert_eq!(fit_levels(&[huge; 3], 0), [None; 3]);
}

#[test]
fn levels_fit_the_memory() {
    let textures = [texture(64, 7), texture(128, 8), texture(64, 1)];
    let all: u64 = textures.iter().map(|texture| texture.bytes_from(0)).sum();
    assert_eq!(fit_levels(&textures, all), [Some(0); 3]);
    assert_eq!(fit_levels(&textures, all - 1), [Some(0), Some(1), Some(0)]);
    assert_eq!(fit_levels(&textures, 0), [None; 3]);
    assert_eq!(fit_levels(&[], 0), []);
    let mut random = Random::new(40);
    for case in 0..cases(500) {
        let textures: Vec<WantedTexture> = (0..1 + random.below(20))
            .map(|_| {
                let levels = 1 + random.below(9) as u32;
                WantedTexture {
                    finest: random.below(9) as u32,
                    ..texture(1 << (levels - 1), levels)
                }
            })
            .collect();
        let budget = random.below(60_000) as u64;
        let chosen = fit_levels(&textures, budget);
        let bytes = |chosen: &[Option<u32>]| -> u64 {
            let levels = textures.iter().zip(chosen);
            levels.map(|(texture, level)| level.map_or(0, |level| texture.bytes_from(level))).sum()
        };
        assert!(bytes(&chosen) <= budget, "{case}");
        let wanted: Vec<Option<u32>> =
            textures.iter().map(|texture| Some(texture.finest.min(texture.levels - 1))).collect();
        assert!(chosen == wanted || bytes(&wanted) > budget, "{case}: too coarse");
        for (chosen, wanted) in chosen.iter().zip(&wanted) {
            assert!(chosen.is_none() || chosen >= wanted, "{case}: finer than wanted");
        }
        // A texture goes only when all the others are at their last levels.
        if chosen.contains(&None) {
            let last = textures.iter().zip(&chosen);
            assert!(last.into_iter().all(|(t, c)| c.is_none_or(|c| c == t.levels - 1)), "{case}");
        }
    }
}
