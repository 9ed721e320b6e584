//! Frustum planes, spheres, and the normalized frustum.

use fillrate_geometry::{
    Clipper, Containment, DepthScale, Frustum, HalfSpace, NormalizedFrustum, Plane, PlaneMask,
    Sphere, Transform, Vec3, Vertex, View,
};

use crate::support::{Random, area, cases, close, near};

/// 640 by 480 with the view plane at 240, so that the normals come out even.
fn view() -> View {
    View::new(640.0, 480.0, 240.0, 1.0, 1000.0).expect("a view")
}

#[test]
fn planes_of_the_technote() {
    let frustum = Frustum::new(&view());
    let planes: Vec<Plane> = frustum.planes(PlaneMask::ALL).copied().collect();
    let unit = |x, y, z| Vec3::new(x, y, z).normalized().expect("a normal");
    let expected = [
        (Vec3::new(0.0, 0.0, 1.0), 1.0),
        (Vec3::new(0.0, 0.0, -1.0), -1000.0),
        (unit(-240.0, 0.0, 320.0), 0.0),
        (unit(240.0, 0.0, 320.0), 0.0),
        (unit(0.0, -240.0, 240.0), 0.0),
        (unit(0.0, 240.0, 240.0), 0.0),
    ];
    for (plane, (normal, distance)) in planes.iter().zip(expected) {
        assert_eq!((plane.normal, plane.distance), (normal, distance));
    }
    assert!(near(planes[2].normal, Vec3::new(-0.6, 0.0, 0.8), 1e-7));
    let five = Frustum::without_hither(&view());
    assert_eq!(five.used().len(), 5);
    assert!(
        five.planes(PlaneMask::ALL).skip(1).all(|side| side.contains(Vec3::new(0.0, 0.0, 1.0)))
    );
}

/// A point is in the frustum when its projection is on the screen.
#[test]
fn inside_means_on_the_screen() {
    let (view, mut random) = (view(), Random::new(10));
    let (frustum, five) = (Frustum::new(&view), Frustum::without_hither(&view));
    let mut inside = 0;
    for _ in 0..cases(50_000) {
        let p = Vec3::new(
            random.range(-1500.0, 1500.0),
            random.range(-1500.0, 1500.0),
            random.range(-10.0, 1100.0),
        );
        let (x, y) = (p.x * 240.0 / p.z, p.y * 240.0 / p.z);
        let seen = (1.0..=1000.0).contains(&p.z) && x.abs() <= 320.0 && y.abs() <= 240.0;
        let edge = close(x.abs(), 320.0, 0.01) || close(y.abs(), 240.0, 0.01);
        assert!(edge || frustum.contains(p) == seen, "{p:?}");
        assert!(!five.contains(p) || seen || edge, "{p:?}");
        inside += usize::from(seen);
    }
    assert!(inside > cases(50_000) / 20);
}

#[test]
fn sphere_known_cases() {
    let frustum = Frustum::new(&view());
    let test = |x, y, z, radius| {
        frustum.test_sphere(&Sphere { centre: Vec3::new(x, y, z), radius }, PlaneMask::ALL)
    };
    assert_eq!(test(0.0, 0.0, 500.0, 10.0), Containment::Within(PlaneMask::NONE));
    assert_eq!(test(0.0, 0.0, 995.0, 10.0), Containment::Within(PlaneMask::YON));
    assert_eq!(test(0.0, 0.0, 1011.0, 10.0), Containment::Outside);
    assert_eq!(test(0.0, 0.0, -8.0, 8.5), Containment::Outside);
    assert_eq!(test(400.0, 0.0, 300.0, 1.0), Containment::Within(PlaneMask::RIGHT));
    assert_eq!(test(-400.0, 0.0, 300.0, 1.0), Containment::Within(PlaneMask::LEFT));
    assert_eq!(test(410.0, 0.0, 300.0, 1.0), Containment::Outside);
    let all = test(0.0, 0.0, 500.0, 1e9);
    assert_eq!(all, Containment::Within(PlaneMask::ALL));
    for bad in [f32::NAN, f32::INFINITY, -1.0] {
        assert_eq!(test(0.0, 0.0, 500.0, bad), Containment::Outside);
    }
    assert_eq!(test(f32::NAN, 0.0, 500.0, 1.0), Containment::Outside);
}

/// Whatever the sphere test says holds for every point of the sphere.
#[test]
fn sphere_test_is_never_wrong() {
    let (mut random, frustum) = (Random::new(11), Frustum::new(&view()));
    let mut counts = [0; 3];
    for case in 0..cases(5_000) {
        let sphere = Sphere {
            centre: Vec3::new(
                random.range(-900.0, 900.0),
                random.range(-700.0, 700.0),
                random.range(-50.0, 1100.0),
            ),
            radius: random.range(0.0, 120.0),
        };
        let result = frustum.test_sphere(&sphere, PlaneMask::ALL);
        for _ in 0..8 {
            let ray = random.vector(1.0).normalized().unwrap_or(Vec3::ZERO);
            let point = sphere.centre + ray * (sphere.radius * 0.999);
            match result {
                Containment::Outside => assert!(!frustum.contains(point), "{case}"),
                Containment::Within(mask) => {
                    let crossed: Vec<Plane> = frustum.planes(mask).copied().collect();
                    let others = frustum.planes(PlaneMask::ALL).filter(|p| !crossed.contains(p));
                    assert!(others.into_iter().all(|plane| plane.contains(point)), "{case}");
                }
            }
        }
        counts[match result {
            Containment::Outside => 0,
            Containment::Within(PlaneMask::NONE) => 1,
            Containment::Within(_) => 2,
        }] += 1;
    }
    assert!(counts.iter().all(|&count| count > cases(5_000) / 20), "{counts:?}");
}

#[test]
fn bounding_sphere_of_a_model() {
    let points = [Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, -3.0, 4.0)];
    assert_eq!(Sphere::of_points(points).map(|sphere| sphere.radius), Some(5.0));
    assert_eq!(Sphere::of_points([]), None);
    assert_eq!(Sphere::of_points([points[0], Vec3::new(0.0, f32::NAN, 0.0)]), None);
}

#[test]
fn frustum_in_the_world() {
    let mut random = Random::new(12);
    let frustum = Frustum::new(&view());
    for case in 0..cases(2_000) {
        let (eye, forward) = (random.vector(50.0), random.vector(1.0));
        let Some(camera) = Transform::camera(eye, forward, Vec3::new(0.1, 1.0, 0.2)) else {
            continue;
        };
        assert!(near(camera.point(eye), Vec3::ZERO, 1e-3));
        let ahead = forward.normalized().expect("a direction");
        assert!(near(camera.direction(ahead), Vec3::new(0.0, 0.0, 1.0), 1e-4));
        let world = frustum.in_world(&camera);
        let point = random.vector(300.0);
        for (seen, placed) in frustum.planes(PlaneMask::ALL).zip(world.planes(PlaneMask::ALL)) {
            assert!(close(placed.normal.length(), 1.0, 1e-5));
            let (a, b) = (seen.signed_distance(camera.point(point)), placed.signed_distance(point));
            assert!(close(a, b, 2e-3), "{case}: {a} {b}");
        }
    }
    assert_eq!(Transform::camera(Vec3::ZERO, Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0)), None);
    let y = Vec3::new(0.0, 1.0, 0.0);
    assert_eq!(Transform::camera(Vec3::ZERO, y, y), None);
    assert_eq!(Transform::camera(Vec3::new(f32::NAN, 0.0, 0.0), y, Vec3::new(1.0, 0.0, 0.0)), None);
}

#[test]
fn transforms_compose() {
    let turn = Transform::turn_y(std::f32::consts::FRAC_PI_2);
    assert!(near(turn.point(Vec3::new(0.0, 0.0, 1.0)), Vec3::new(1.0, 0.0, 0.0), 1e-6));
    let turn = Transform::turn_x(std::f32::consts::FRAC_PI_2);
    assert!(near(turn.point(Vec3::new(0.0, 1.0, 0.0)), Vec3::new(0.0, 0.0, 1.0), 1e-6));
    let mut random = Random::new(13);
    for _ in 0..100 {
        let first = Transform::turn_y(random.range(-9.0, 9.0));
        let next = Transform::turn_x(random.range(-9.0, 9.0));
        let next = next.then(&Transform::translation(random.vector(5.0)));
        let point = random.vector(5.0);
        let (once, twice) = (first.then(&next).point(point), next.point(first.point(point)));
        assert!(near(once, twice, 1e-4));
    }
}

#[test]
fn normalized_frustum_known_values() {
    let frustum = NormalizedFrustum::new(&view(), DepthScale::NONE);
    let factors = frustum.factors();
    assert!(close(factors.x, 240.0 / (1000.0 * 320.0), 1e-9));
    assert!(close(factors.y, 240.0 / (1000.0 * 240.0), 1e-9));
    assert!(close(factors.z, 0.001, 1e-9));
    let tight = NormalizedFrustum::new(&view(), DepthScale::BITS_16);
    assert!(tight.factors().z * 1000.0 < 1.0);
    for (point, inside) in [
        (Vec3::new(0.5, 0.5, 0.5), true),
        (Vec3::new(-0.5, -0.5, 0.5), true),
        (Vec3::new(0.5001, 0.0, 0.5), false),
        (Vec3::new(0.0, -0.5001, 0.5), false),
        (Vec3::new(0.0, 0.0, 1.0), true),
        (Vec3::new(0.0, 0.0, 1.0001), false),
        (Vec3::new(0.0, 0.0, 0.0009), false),
        (Vec3::new(f32::NAN, 0.0, 0.5), false),
    ] {
        assert_eq!(frustum.contains(point), inside, "{point:?}");
    }
}

/// Clipping against comparisons gives what clipping against planes gives.
#[test]
fn normalized_frustum_against_planes() {
    let (view, mut random) = (view(), Random::new(14));
    let (frustum, normal) =
        (Frustum::new(&view), NormalizedFrustum::new(&view, DepthScale::BITS_16));
    let camera = normal.camera(&Transform::IDENTITY);
    let (mut seen, mut scaled) = (Clipper::new(), Clipper::new());
    let mut drawn = 0;
    for case in 0..cases(5_000) {
        let polygon: Vec<Vertex<2>> = random
            .polygon()
            .into_iter()
            .map(|corner| Vertex {
                position: corner.position * 8.0 + Vec3::new(0.0, 0.0, 30.0),
                ..corner
            })
            .collect();
        let small: Vec<Vertex<2>> = polygon
            .iter()
            .map(|corner| Vertex { position: camera.point(corner.position), ..*corner })
            .collect();
        let a = frustum.clip(&mut seen, &polygon, PlaneMask::ALL);
        let b = normal.clip(&mut scaled, &small);
        let back: Vec<Vertex<2>> = b
            .iter()
            .map(|corner| {
                let (p, f) = (corner.position, normal.factors());
                Vertex { position: Vec3::new(p.x / f.x, p.y / f.y, p.z / f.z), ..*corner }
            })
            .collect();
        let tolerance = 1e-3 * area(&polygon) + 0.1;
        assert!((area(a) - area(&back)).abs() < tolerance, "{case}: {} {}", area(a), area(&back));
        drawn += usize::from(!b.is_empty());
        for corner in b {
            let on_screen = normal.project(corner).expect("a clipped vertex");
            assert!((0.0..640.0).contains(&on_screen.x) && (0.0..480.0).contains(&on_screen.y));
            assert!((0.0..1.0).contains(&on_screen.z) && on_screen.inv_w > 0.0, "{case}");
        }
    }
    assert!(drawn > cases(5_000) / 4);
}
