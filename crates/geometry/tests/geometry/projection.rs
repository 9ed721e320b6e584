//! View space to the screen.

use fillrate_geometry::{
    Clipper, DepthMap, DepthScale, Error, Frustum, NormalizedFrustum, PlaneMask, Projection,
    TECHNOTE_FIELD_OF_VIEW, Transform, Vec3, Vertex, View, sin_cos, tan,
};

use crate::support::{Random, cases, close};

fn projection(map: DepthMap, scale: DepthScale) -> Projection {
    let view = View::new(640.0, 480.0, 200.0, 2.0, 800.0).expect("a view");
    Projection { view, map, scale }
}

#[test]
fn sines_and_tangents() {
    let mut random = Random::new(20);
    for _ in 0..cases(20_000) {
        let angle = random.range(-20.0, 20.0);
        let (sine, cosine) = sin_cos(angle);
        let wide = f64::from(angle);
        assert!((f64::from(sine) - wide.sin()).abs() < 6e-8, "{angle}");
        assert!((f64::from(cosine) - wide.cos()).abs() < 6e-8, "{angle}");
    }
    assert_eq!(sin_cos(0.0), (0.0, 1.0));
    assert_eq!(sin_cos(f32::NAN), (0.0, 1.0));
    assert_eq!(sin_cos(f32::INFINITY), (0.0, 1.0));
    assert_eq!(tan(std::f32::consts::FRAC_PI_4), 1.0);
}

#[test]
fn viewing_distance_of_the_technote() {
    let view =
        View::with_field_of_view(640.0, 480.0, TECHNOTE_FIELD_OF_VIEW, 1.0, 100.0).expect("a view");
    // 320 / tan(55 degrees)
    assert!(close(view.distance(), 224.066_4, 1e-3), "{}", view.distance());
    let right = std::f32::consts::FRAC_PI_2;
    let view = View::with_field_of_view(640.0, 480.0, right, 1.0, 100.0).expect("a view");
    assert!(close(view.distance(), 320.0, 1e-4));
}

#[test]
fn views_out_of_range() {
    for (index, what) in ["width", "height", "distance", "hither", "yon"].into_iter().enumerate() {
        for bad in [0.0, -1.0, f32::NAN, f32::INFINITY] {
            let mut v = [640.0, 480.0, 200.0, 2.0, 800.0];
            v[index] = bad;
            assert_eq!(View::new(v[0], v[1], v[2], v[3], v[4]), Err(Error::View { what }), "{bad}");
        }
    }
    assert_eq!(View::new(9.0, 9.0, 9.0, 5.0, 5.0), Err(Error::View { what: "yon" }));
    for bad in [0.0, std::f32::consts::PI, f32::NAN, -1.0] {
        assert!(View::with_field_of_view(9.0, 9.0, bad, 1.0, 5.0).is_err());
    }
}

#[test]
fn projected_point_known_values() {
    let projection = projection(DepthMap::Linear, DepthScale::NONE);
    let vertex = Vertex::new(Vec3::new(30.0, -10.0, 50.0), [0.5, 1.0]);
    let screen = projection.project(&vertex).expect("in front");
    assert_eq!((screen.x, screen.y), (320.0 + 30.0 * 200.0 / 50.0, 240.0 + 10.0 * 200.0 / 50.0));
    assert_eq!(screen.inv_w, 1.0 / 50.0);
    assert_eq!(screen.over_w(0), 0.5 * (1.0 / 50.0));
    assert_eq!(screen.over_w(7), 0.0);
    assert!(close(screen.z, 48.0 / 798.0, 1e-7));
}

#[test]
fn depth_from_hither_to_yon() {
    for map in [DepthMap::Linear, DepthMap::Projective] {
        let plain = projection(map, DepthScale::NONE);
        assert_eq!((plain.depth(2.0), plain.depth(800.0)), (0.0, 1.0));
        for (scale, bits) in [(DepthScale::BITS_16, 16), (DepthScale::BITS_24, 24)] {
            let scaled = projection(map, scale);
            assert_eq!(scaled.depth(2.0), 0.0);
            assert_eq!(scaled.depth(800.0), 1.0 - 1.0 / (1_u32 << bits) as f32);
            assert!(scaled.depth(800.0) < 1.0);
        }
        let mut last = -1.0;
        for z in 2..=800 {
            let depth = plain.depth(z as f32);
            assert!(depth > last, "{z}");
            last = depth;
        }
    }
    // Linear on the screen: the depth of the middle between two projected ends.
    let projective = projection(DepthMap::Projective, DepthScale::NONE);
    let (near, far) = (4.0_f32, 40.0_f32);
    let middle = 2.0 / (1.0 / near + 1.0 / far);
    let mean = (projective.depth(near) + projective.depth(far)) / 2.0;
    assert!(close(projective.depth(middle), mean, 1e-6));
}

#[test]
fn depth_scale_limits() {
    let half = DepthScale::new(0.5, 0.25).expect("to 0.75");
    assert_eq!((half.apply(0.0), half.apply(1.0)), (0.25, 0.75));
    assert_eq!(half.apply(f32::NAN), 0.0);
    assert!(DepthScale::new(1.0 / 65535.0, 0.0).is_ok());
    for (scale, offset) in
        [(1.0, 0.1), (0.0, 0.0), (-1.0, 0.5), (f32::NAN, 0.0), (f32::INFINITY, 0.0)]
    {
        assert_eq!(DepthScale::new(scale, offset), Err(Error::DepthScale));
    }
}

#[test]
fn points_that_cannot_be_projected() {
    let projection = projection(DepthMap::Linear, DepthScale::NONE);
    for z in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        assert_eq!(projection.project(&Vertex::new(Vec3::new(0.0, 0.0, z), [])), None);
    }
    assert_eq!(projection.project(&Vertex::new(Vec3::new(0.0, 0.0, 9.0), [f32::NAN])), None);
    let far = Vertex::new(Vec3::new(1e18, 1e18, f32::MIN_POSITIVE), []);
    let screen = projection.project(&far).expect("positive z");
    assert_eq!((screen.x, screen.y), (640.0_f32.next_down(), 0.0));
    assert_eq!((screen.z, screen.inv_w), (0.0, 0.5));
}

/// Everything clipped lands on the screen, from both frustums at the same place.
#[test]
fn clipped_vertices_land_on_the_screen() {
    let projection = projection(DepthMap::Projective, DepthScale::BITS_16);
    let frustum = Frustum::new(&projection.view);
    let normal = NormalizedFrustum::new(&projection.view, DepthScale::BITS_16);
    let camera = normal.camera(&Transform::IDENTITY);
    let (mut clipper, mut random, mut drawn) = (Clipper::new(), Random::new(21), 0);
    for case in 0..cases(10_000) {
        let huge = if case % 10 == 0 { 1e7 } else { 1.0 };
        let polygon: Vec<Vertex<2>> = random
            .polygon()
            .into_iter()
            .map(|corner| Vertex { position: corner.position * (10.0 * huge), ..corner })
            .collect();
        for corner in frustum.clip(&mut clipper, &polygon, PlaneMask::ALL) {
            let screen = projection.project(corner).expect("a clipped vertex");
            assert!((0.0..640.0).contains(&screen.x) && (0.0..480.0).contains(&screen.y));
            assert!((0.0..1.0).contains(&screen.z) && screen.inv_w > 0.0 && screen.inv_w <= 0.5);
            let small = Vertex { position: camera.point(corner.position), ..*corner };
            let other = normal.project(&small).expect("the same vertex");
            assert!(close(screen.x, other.x, 0.01) && close(screen.y, other.y, 0.01), "{case}");
            drawn += 1;
        }
    }
    assert!(drawn > cases(10_000) / 4, "{drawn}");
}
