//! Points, lines and polygons against planes.

use fillrate_geometry::{
    Clipper, HalfSpace, MAX_MAGNITUDE, MAX_VERTICES, Plane, Vec3, Vertex, clip_line, clip_point,
};

use crate::support::{Random, area, cases, close, linear};

const FLOOR: Plane = Plane { normal: Vec3::new(0.0, 1.0, 0.0), distance: 1.0 };

fn vertex(x: f32, y: f32, value: f32) -> Vertex<1> {
    Vertex::new(Vec3::new(x, y, 2.0), [value])
}

#[test]
fn vectors_known_values() {
    let (x, y) = (Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0));
    assert_eq!(x.cross(y), Vec3::new(0.0, 0.0, 1.0));
    assert_eq!(Vec3::new(1.0, 2.0, 3.0).dot(Vec3::new(4.0, -5.0, 6.0)), 12.0);
    assert_eq!(Vec3::new(2.0, 3.0, 6.0).length(), 7.0);
    let huge = (1_u128 << 80) as f32;
    assert_eq!(Vec3::new(3.0 * huge, 0.0, 4.0 * huge).length(), 5.0 * huge);
    assert_eq!(Vec3::new(0.0, -4e-30, 0.0).normalized(), Some(Vec3::new(0.0, -1.0, 0.0)));
    assert_eq!(Vec3::ZERO.normalized(), None);
    assert_eq!(Vec3::new(f32::NAN, 1.0, 0.0).normalized(), None);
    assert!(Vec3::new(0.0, f32::NAN, 1.0).length().is_nan());
}

#[test]
fn plane_of_points_and_of_nothing() {
    let [a, b, c] = [Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 1.0, 5.0), Vec3::new(2.0, 1.0, 0.0)];
    assert_eq!(Plane::of_points(a, b, c), Some(FLOOR));
    assert_eq!(Plane::of_points(a, c, b), Some(FLOOR.flipped()));
    assert_eq!(Plane::of_points(a, b, a + (b - a) * 3.0), None);
    assert_eq!(Plane::of_points(a, a, c), None);
    let long = Plane { normal: Vec3::new(0.0, 4.0, 0.0), distance: 4.0 };
    assert_eq!(long.normalized(), Some(FLOOR));
    assert_eq!(Plane { normal: Vec3::ZERO, distance: 4.0 }.normalized(), None);
}

#[test]
fn point_on_the_plane_is_inside() {
    for (y, inside) in [(1.0, true), (1.0_f32.next_down(), false), (f32::NAN, false), (1e30, false)]
    {
        assert_eq!(clip_point(Vec3::new(0.0, y, 0.0), [FLOOR]), inside, "{y}");
    }
    assert!(clip_point(Vec3::ZERO, [FLOOR; 0]));
}

#[test]
fn line_known_crossing() {
    let line = [vertex(0.0, -1.0, 0.0), vertex(4.0, 3.0, 1.0)];
    let half = [vertex(2.0, 1.0, 0.5), vertex(4.0, 3.0, 1.0)];
    assert_eq!(clip_line(line, [FLOOR]), Some(half));
    assert_eq!(clip_line([line[1], line[0]], [FLOOR]), Some([half[1], half[0]]));
    assert_eq!(clip_line(half, [FLOOR]), Some(half));
    assert_eq!(clip_line(line, [FLOOR, FLOOR.flipped()]), Some([half[0], half[0]]));
    assert_eq!(clip_line([vertex(0.0, 0.0, 0.0), vertex(9.0, 0.5, 1.0)], [FLOOR]), None);
}

#[test]
fn square_cut_in_half() {
    let square = [
        vertex(0.0, 0.0, 0.0),
        vertex(0.0, 2.0, 1.0),
        vertex(2.0, 2.0, 1.0),
        vertex(2.0, 0.0, 0.0),
    ];
    let mut clipper = Clipper::new();
    let expected = [
        vertex(0.0, 1.0, 0.5),
        vertex(0.0, 2.0, 1.0),
        vertex(2.0, 2.0, 1.0),
        vertex(2.0, 1.0, 0.5),
    ];
    assert_eq!(clipper.clip(&square, [FLOOR]), expected);
    // Cutting a corner off adds one.
    let corner = Plane::through(Vec3::new(1.0, 1.0, 0.0), Vec3::new(0.5, 0.0, 0.0));
    assert_eq!(clipper.clip(&square, [corner]).len(), 5);
    assert_eq!(clipper.clip(&square, [corner.flipped()]).len(), 3);
}

#[test]
fn polygons_that_touch() {
    let mut clipper = Clipper::new();
    let above = [vertex(0.0, 1.0, 0.0), vertex(1.0, 2.0, 0.0), vertex(2.0, 1.0, 0.0)];
    assert_eq!(clipper.clip(&above, [FLOOR]), above);
    assert!(clipper.clip(&above, [FLOOR.flipped()]).is_empty());
    // A corner on the plane does not become two.
    let through = [vertex(0.0, 1.0, 0.0), vertex(2.0, 3.0, 0.0), vertex(2.0, -1.0, 0.0)];
    assert_eq!(clipper.clip(&through, [FLOOR]).len(), 3);
    let flat = through.map(|corner| vertex(corner.position.x, 1.0, 0.0));
    assert_eq!(clipper.clip(&flat, [FLOOR]), flat);
}

#[test]
fn clipped_area_and_attributes() {
    let mut random = Random::new(1);
    let (mut inner, mut outer) = (Clipper::new(), Clipper::new());
    let mut cut = 0;
    for case in 0..cases(20_000) {
        let (polygon, plane) = (random.polygon(), random.plane());
        let kept = inner.clip(&polygon, [plane]);
        let lost = outer.clip(&polygon, [plane.flipped()]);
        let sum = area(kept) + area(lost);
        assert!((sum - area(&polygon)).abs() < 2e-3, "{case}: {sum} of {}", area(&polygon));
        assert!(kept.len() <= polygon.len() + 1, "{case}");
        cut += usize::from(!kept.is_empty() && !lost.is_empty());
        for corner in kept {
            assert!(plane.signed_distance(corner.position) > -1e-4, "{case}");
            let expected = linear(corner.position);
            assert!((0..2).all(|i| close(corner.attributes[i], expected[i], 1e-4)), "{case}");
        }
    }
    assert!(cut > cases(20_000) / 4, "too few polygons were cut: {cut}");
}

/// The result is the part of the polygon inside all planes: its corners are in
/// the polygon and inside the planes, and it holds every point that is both.
#[test]
fn clipped_polygon_holds_the_right_points() {
    let mut random = Random::new(2);
    let mut clipper = Clipper::new();
    let (mut held, mut gone) = (0, 0);
    for case in 0..cases(4_000) {
        let polygon = random.polygon();
        let planes: Vec<Plane> = (0..1 + random.below(4)).map(|_| random.plane()).collect();
        let least = |point| planes.iter().map(|p| p.signed_distance(point)).fold(9.0, f32::min);
        let clipped = clipper.clip(&polygon, &planes);
        for corner in clipped {
            assert!(least(corner.position) > -1e-4, "{case}");
            let around = area_around(&polygon, corner.position);
            assert!(around < area(&polygon) + 2e-3, "{case}: a corner left the polygon");
        }
        for _ in 0..8 {
            let point = point_of(&polygon, &mut random);
            if least(point) > 1e-2 && area(&polygon) > 0.1 {
                assert!(!clipped.is_empty(), "{case}: a point was lost");
                let around = area_around(clipped, point);
                assert!(around < area(clipped) + 2e-3, "{case}: a point was lost");
                held += 1;
            }
        }
        gone += usize::from(clipped.is_empty());
    }
    assert!(held > 500 && gone > 100, "{held} {gone}");
}

fn point_of(polygon: &[Vertex<2>], random: &mut Random) -> Vec3 {
    let weights: Vec<f32> = polygon.iter().map(|_| random.range(0.001, 1.0)).collect();
    let sum: f32 = weights.iter().sum();
    polygon
        .iter()
        .zip(&weights)
        .fold(Vec3::ZERO, |point, (corner, weight)| point + corner.position * (weight / sum))
}

/// The area of the triangles of a point and each edge: the polygon's own for a
/// point in it, more for one outside.
fn area_around(polygon: &[Vertex<2>], point: Vec3) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    let triangle = |(a, b): (&Vertex<2>, &Vertex<2>)| {
        f64::from((a.position - point).cross(b.position - point).length()) / 2.0
    };
    polygon.iter().zip(next).map(triangle).sum()
}

#[test]
fn neighbours_share_their_new_vertex() {
    let mut random = Random::new(3);
    let (mut left, mut right) = (Clipper::new(), Clipper::new());
    let mut shared = 0;
    for case in 0..cases(5_000) {
        let [a, b, c, d] = [(); 4].map(|()| {
            let position = random.vector(5.0);
            Vertex::new(position, linear(position))
        });
        let plane = random.plane();
        if plane.contains(a.position) == plane.contains(b.position) {
            continue;
        }
        let first = left.clip(&[a, b, c], [plane]);
        let second = right.clip(&[b, a, d], [plane]);
        let both = first.iter().filter(|corner| second.contains(corner)).count();
        assert_eq!(both, 2, "{case}: the end inside and the crossing");
        shared += 1;
    }
    assert!(shared > cases(5_000) / 10);
}

#[test]
fn attributes_stay_in_range() {
    let mut random = Random::new(4);
    for case in 0..cases(20_000) {
        // An end just outside: the crossing is next to it, where rounding overshoots.
        let values = [random.range(-0.7, 0.3), random.range(-0.1, 0.7)];
        let [inside, outside] = [random.range(1.0, 9.0), random.range(1e-7, 1e-6)];
        let line = [(1.0 + inside, values[0]), (1.0 - outside, values[1])]
            .map(|(y, value)| Vertex::new(Vec3::new(0.0, y, 0.0), [value, 0.3]));
        let [_, end] = clip_line(line, [FLOOR]).expect("one end is inside");
        let (low, high) = (values[0].min(values[1]), values[0].max(values[1]));
        assert!((low..=high).contains(&end.attributes[0]), "{case}: {values:?} {end:?}");
        assert_eq!(end.attributes[1], 0.3);
    }
}

#[test]
fn bad_input_leaves_nothing() {
    let mut clipper = Clipper::new();
    let good = [vertex(0.0, 2.0, 0.0), vertex(1.0, 2.0, 0.0), vertex(0.0, 3.0, 0.0)];
    for bad in [f32::NAN, f32::INFINITY, MAX_MAGNITUDE.next_up()] {
        let mut polygon = good;
        polygon[1].position.z = bad;
        assert!(clipper.clip(&polygon, [FLOOR]).is_empty());
        polygon = good;
        polygon[2].attributes[0] = bad;
        assert!(clipper.clip(&polygon, [FLOOR; 0]).is_empty());
        let plane = Plane { normal: Vec3::new(0.0, 1.0, bad), distance: 0.0 };
        assert!(clipper.clip(&good, [plane]).is_empty());
        assert!(!clip_point(good[0].position, [plane]));
        assert_eq!(clip_line([good[0], good[1]], [plane]), None);
    }
    let none = Plane { normal: Vec3::ZERO, distance: -1.0 };
    assert!(clipper.clip(&good, [none]).is_empty());
    assert!(clipper.clip(&good[..2], [FLOOR]).is_empty());
    assert!(clipper.clip(&[], [FLOOR]).is_empty());
    let many = vec![good[0]; MAX_VERTICES + 1];
    assert!(clipper.clip(&many, [FLOOR]).is_empty());
}

/// Not convex, not flat, not sane: bounded, and of numbers only.
#[test]
fn anything_goes_in() {
    let mut random = Random::new(5);
    let mut clipper = Clipper::new();
    for _ in 0..cases(20_000) {
        let large = random.below(20) == 0;
        let corners = random.below(if large { 300 } else { 12 });
        let mut coordinate = |nasty: bool| {
            if nasty { random.nasty_vector() } else { random.vector(MAX_MAGNITUDE) }
        };
        let nasty = corners.is_multiple_of(3);
        let polygon: Vec<Vertex<2>> =
            (0..corners).map(|i| Vertex::new(coordinate(nasty), [i as f32, 1.0])).collect();
        let normal = coordinate(nasty);
        let planes = [
            Plane { normal, distance: random.nasty() },
            Plane { normal: -normal, distance: -1e20 },
            random.plane(),
        ];
        let result = clipper.clip(&polygon, planes);
        assert!(result.is_empty() || (3..=MAX_VERTICES).contains(&result.len()));
        assert!(result.iter().all(Vertex::is_usable));
    }
}
