//! The engine's triangle set-up against the reference's.

use fillrate_engine::Cull;
use fillrate_engine::setup::{Outcome, triangle, verite_triangle};
use fillrate_testkit::random::{Rng, verite_corners, vertices};
use fillrate_testkit::reference::{SetUp, set_up, set_up_verite};

#[test]
fn set_up_gives_the_same_registers() {
    let mut rng = Rng::new(17);
    let mut drawn = 0;
    for round in 0..200_000 {
        let corners = vertices(&mut rng, 640, 480);
        let cull = rng.pick(&[Cull::Disabled, Cull::Negative, Cull::Positive]);
        let expected = set_up(&corners, cull);
        let actual = match triangle(corners.each_ref(), cull, 3) {
            Outcome::Empty => SetUp::Empty,
            Outcome::Culled => SetUp::Culled,
            Outcome::Drawn(registers) => SetUp::Drawn(Box::new(registers)),
        };
        drawn += u32::from(matches!(expected, SetUp::Drawn(_)));
        assert_eq!(actual, expected, "round {round}: {corners:?}, {cull:?}");
    }
    assert!(drawn > 100_000, "{drawn} drawn");
}

#[test]
fn verite_set_up_gives_the_same_registers() {
    let mut rng = Rng::new(19);
    let mut drawn = 0;
    for round in 0..200_000 {
        let mut corners = verite_corners(&mut rng, 640, 480);
        if rng.one_in(4) {
            corners.iter_mut().for_each(|corner| corner.0.y = rng.pick(&[0, 5, 56, -3]));
        }
        let expected = set_up_verite(&corners);
        let [a, b, c] = &corners;
        let actual = verite_triangle([&a.0, &b.0, &c.0], [&a.1, &b.1, &c.1])
            .map_or(SetUp::Empty, |registers| SetUp::Drawn(Box::new(registers)));
        drawn += u32::from(matches!(expected, SetUp::Drawn(_)));
        assert_eq!(actual, expected, "round {round}: {corners:?}");
    }
    assert!(drawn > 100_000, "{drawn} drawn");
}

#[test]
fn equal_rows_are_sorted_alike() {
    let mut rng = Rng::new(18);
    for _ in 0..20_000 {
        let mut corners = vertices(&mut rng, 64, 64);
        for vertex in &mut corners {
            vertex.y = rng.pick(&[0.0, -0.0, 3.5, 20.0, -7.25]);
        }
        let actual = match triangle(corners.each_ref(), Cull::Disabled, 3) {
            Outcome::Empty => SetUp::Empty,
            Outcome::Culled => SetUp::Culled,
            Outcome::Drawn(registers) => SetUp::Drawn(Box::new(registers)),
        };
        assert_eq!(actual, set_up(&corners, Cull::Disabled), "{corners:?}");
    }
}
