//! Triangle lists: welding, commands, normals, and drawing against a plain
//! transcription of the documented steps.

use fillrate_quark::{
    Camera, Command, ErrorCode, Gpu, GpuConfig, IndexFormat, Matrix, RasterState, TriangleList,
    TriangleMode, Vertex, VertexFormat,
};

use crate::random::Random;
use crate::reference::Reference;

const NO_INDEX: IndexFormat = IndexFormat { intensity: false, color: false, uv: false };

fn list(vertex: i32, vertices: usize, index: i32, triangles: usize) -> TriangleList {
    let vertex = VertexFormat::from_bits(vertex).expect("known bits");
    let index = IndexFormat::from_bits(index).expect("known bits");
    TriangleList::new(vertex, vertices, index, triangles, Vec::new()).expect("a valid format")
}

#[test]
fn accessors_reach_every_item_of_every_format() {
    for vertex in 0..4 {
        for index in 0..8 {
            let Ok(mut list) = TriangleList::new(
                VertexFormat::from_bits(vertex).unwrap(),
                5,
                IndexFormat::from_bits(index).unwrap(),
                4,
                Vec::new(),
            ) else {
                assert!(vertex & 1 & index != 0 || (vertex >> 1) & (index >> 2) & 1 != 0);
                continue;
            };
            for i in 0..5i16 {
                list.set_xyz(i as usize, [i, -i, 100 + i]);
                list.set_i(i as usize, 50 + i32::from(i));
                list.set_uv(i as usize, &[[i, i + 1], [i + 2, i + 3], [i + 4, -i]]);
                list.set_abc(i as usize, [i as u16, 2, 3]);
                list.set_c(i as usize, 200 + i32::from(i));
            }
            for i in 0..4i16 {
                let at = i as usize;
                assert_eq!(list.xyz(at), [i, -i, 100 + i]);
                assert_eq!(list.abc(at), [i as u16, 2, 3]);
                let has_i = (vertex | index) & 1 != 0;
                assert_eq!(list.i(at), if has_i { 50 + i32::from(i) } else { 0 });
                assert_eq!(list.c(at), if index & 2 != 0 { 200 + i32::from(i) } else { 0 });
                let mut uv = [[0; 2]; 3];
                if vertex & 2 != 0 {
                    uv[0] = [i, i + 1];
                } else if index & 4 != 0 {
                    uv = [[i, i + 1], [i + 2, i + 3], [i + 4, -i]];
                }
                assert_eq!(list.uv(at), uv);
            }
            // The triangle list has four, the vertex list five.
            assert_eq!((list.abc(4), list.c(4)), ([0; 3], 0));
            assert_eq!(list.xyz(4), [4, -4, 104]);
            assert_eq!(list.xyz(5), [0; 3]);
        }
    }
}

#[test]
fn welding_merges_equal_vertices() {
    let mut list = list(0, 6, 0, 2);
    let points = [[0, 0, 0], [10, 0, 0], [0, 10, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]];
    for (i, point) in points.into_iter().enumerate() {
        list.set_xyz(i, point);
    }
    list.set_abc(0, [0, 1, 2]);
    list.set_abc(1, [3, 4, 5]);
    list.weld(0, 0, 0);
    assert_eq!(list.vertex_count(), 4);
    assert_eq!((list.abc(0), list.abc(1)), ([0, 1, 2], [1, 3, 2]));
    assert_eq!([0, 1, 2, 3].map(|i| list.xyz(i)), [points[0], points[1], points[2], points[4]]);
}

#[test]
fn welding_keeps_means_and_compares_with_the_first() {
    let mut list = list(3, 4, 0, 1);
    for (i, (x, light, u)) in
        [(0, 100, 7), (2, 103, 7), (3, 101, 8), (4, 100, 7)].into_iter().enumerate()
    {
        list.set_xyz(i, [x, -x, 0]);
        list.set_i(i, light);
        list.set_uv(i, &[[u, 0]]);
    }
    list.set_abc(0, [0, 1, 3]);
    // 1 is near 0; 2 has other coordinates; 3 is near 1, not 0.
    list.weld(2, 3, 0);
    assert_eq!(list.vertex_count(), 3);
    assert_eq!((list.xyz(0), list.i(0)), ([1, -1, 0], 102));
    assert_eq!((list.xyz(1), list.xyz(2)), ([3, -3, 0], [4, -4, 0]));
    assert_eq!(list.abc(0), [0, 0, 2]);
    list.weld(-1, -1, -1);
    assert_eq!(list.vertex_count(), 3);
    list.weld(i32::MAX, i32::MAX, i32::MAX);
    assert_eq!(list.vertex_count(), 1);
}

#[test]
fn commands_gather_states_and_drop_flat_faces() {
    let mut list = list(0, 4, 4, 6);
    for (i, point) in [[0, 0, 0], [9, 0, 0], [0, 9, 0], [18, 0, 0]].into_iter().enumerate() {
        list.set_xyz(i, point);
    }
    let faces = [[0, 1, 2], [0, 1, 3], [2, 1, 0], [1, 1, 2], [0, 2, 1], [0, 1, 9]];
    for (i, face) in faces.into_iter().enumerate() {
        list.set_abc(i, face);
        list.set_uv(i, &[[515, -1], [800, 300], [600, 40]]);
    }
    list.build_commands(&[5, 0, 2, 0, 5, 0]);
    // Aligned, twice the same, and outside are gone.
    assert_eq!(list.triangle_count(), 3);
    assert_eq!([0, 1, 2].map(|i| list.abc(i)), [[2, 1, 0], [0, 1, 2], [0, 2, 1]]);
    let command = |count, state| Command { count, state };
    assert_eq!(list.commands(), [command(1, 2), command(2, 5)]);
    assert_eq!(list.uv(0), [[3, 255], [288, 556], [88, 296]]);
    list.build_commands(&[7, 7, 7]);
    assert_eq!(list.commands(), [command(3, 7)]);
    let mut empty = self::list(0, 0, 0, 0);
    empty.build_commands(&[]);
    assert_eq!(empty.commands(), [command(0, 0)]);
}

#[test]
fn normals_of_a_cube_point_outwards() {
    let mut list = list(0, 9, 0, 12);
    for i in 0..8 {
        let side = |bit: usize| if i >> bit & 1 == 1 { 100 } else { -100 };
        list.set_xyz(i, [side(0), side(1), side(2)]);
    }
    let quads =
        [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    for (i, [a, b, c, d]) in quads.into_iter().enumerate() {
        list.set_abc(2 * i, [a, b, c]);
        list.set_abc(2 * i + 1, [a, c, d]);
    }
    let normals = list.face_normals();
    for (i, axis) in [0, 0, 1, 1, 2, 2].into_iter().enumerate() {
        let mut expected = [0; 3];
        expected[axis] = if i % 2 == 0 { -16384 } else { 16384 };
        assert_eq!((normals[2 * i], normals[2 * i + 1]), (expected, expected));
    }
    let normals = list.vertex_normals();
    for (i, normal) in normals[..8].iter().enumerate() {
        for (axis, &part) in normal.iter().enumerate() {
            assert_eq!(part > 0, i >> axis & 1 == 1);
        }
    }
    assert_eq!(normals[8], [0; 3], "no triangle uses it");
}

#[test]
fn failures_have_their_codes() {
    let mut gpu = Gpu::new(GpuConfig::default()).unwrap();
    let plain = list(0, 3, 0, 1);
    gpu.triangle_mode = Some(TriangleMode::Untextured);
    assert_eq!(gpu.draw_list(&plain.view()), Err(ErrorCode::WorkMemory));
    gpu.set_work_memory(2, 0).unwrap();
    assert_eq!(gpu.draw_list(&plain.view()), Err(ErrorCode::WorkMemory));
    gpu.set_work_memory(3, 0).unwrap();
    assert_eq!(gpu.draw_list(&plain.view()), Ok(()));
    for mode in [TriangleMode::Affine, TriangleMode::Perspective] {
        gpu.triangle_mode = Some(mode);
        assert_eq!(gpu.draw_list(&plain.view()), Err(ErrorCode::Uv));
        assert_eq!(gpu.draw_list(&list(2, 3, 0, 1).view()), Ok(()));
        assert_eq!(gpu.draw_list(&list(0, 3, 4, 1).view()), Ok(()));
    }
    let format = VertexFormat::default();
    let big = TriangleList::new(format, 65_536, NO_INDEX, 0, Vec::new());
    assert_eq!(big.err(), Some(ErrorCode::Memory));
    let big = TriangleList::new(format, 0, NO_INDEX, 65_536, Vec::new());
    assert_eq!(big.err(), Some(ErrorCode::Memory));
}

/// A list drawn step by step as documented, with the reference.
fn expect(
    reference: &mut Reference,
    list: &TriangleList,
    matrix: &Matrix,
    camera: &Camera,
    mode: TriangleMode,
) {
    let near_bit = 32;
    let project = |world: [i32; 3]| {
        if world[2] > camera.near {
            return (world, [0; 3], near_bit);
        }
        let (mask, at) = camera.project(&world);
        (world, at.unwrap(), mask)
    };
    let mut next = 0;
    for command in list.commands() {
        for _ in 0..command.count {
            let face = next;
            next += 1;
            if face >= list.triangle_count() {
                return;
            }
            let Some(state) = list.states.get(usize::from(command.state)) else { continue };
            let abc = list.abc(face).map(usize::from);
            if abc.iter().any(|&i| i >= list.vertex_count()) {
                continue;
            }
            let mut state = state.clone();
            if list.index_format().color {
                state.draw_color = list.c(face) as u8;
            }
            let corners: Vec<_> = (0..3)
                .map(|k| {
                    let at = project(matrix.transform_vector(&list.xyz(abc[k]).map(i32::from)));
                    let i = match (list.vertex_format().intensity, list.index_format().intensity) {
                        (true, _) => list.i(abc[k]),
                        (_, true) => list.i(face),
                        _ => state.draw_intensity.into(),
                    };
                    let uv = match (list.vertex_format().uv, list.index_format().uv) {
                        (true, _) => list.uv(abc[k])[0],
                        (_, true) => list.uv(face)[k],
                        _ => [0; 2],
                    };
                    (at, [i, uv[0].into(), uv[1].into()])
                })
                .collect();
            let masks: Vec<i32> = corners.iter().map(|c| c.0.2).collect();
            if masks.iter().any(|m| m & 16 != 0) || masks.iter().fold(!0, |a, m| a & m) != 0 {
                continue;
            }
            // Every second corner of the cut polygon by hand.
            let is_near = |k: usize| masks[k] & near_bit != 0;
            let vertex = |((_, s, m), [i, u, v]): (([i32; 3], [i32; 3], i32), [i32; 3])| Vertex {
                x: s[0],
                y: s[1],
                z: s[2],
                m,
                i,
                u,
                v,
            };
            let cut = |front: usize, behind: usize| {
                let (a, b) = (&corners[front], &corners[behind]);
                let (z1, z2) = (i64::from(a.0.0[2]), i64::from(b.0.0[2]));
                let t = ((i64::from(camera.near) - z1) << 16) / (z2 - z1);
                let mix = |a: i32, b: i32| {
                    (i64::from(a) + (((i64::from(b) - i64::from(a)) * t) >> 16)) as i32
                };
                let world = [mix(a.0.0[0], b.0.0[0]), mix(a.0.0[1], b.0.0[1]), camera.near];
                vertex((project(world), std::array::from_fn(|k| mix(a.1[k], b.1[k]))))
            };
            let whole = |k: usize| vertex(corners[k]);
            let front: Vec<usize> = (0..3).filter(|&k| !is_near(k)).collect();
            let triangles = match front.len() {
                3 => vec![[whole(0), whole(1), whole(2)]],
                1 => {
                    let a = front[0];
                    vec![[whole(a), cut(a, (a + 1) % 3), cut(a, (a + 2) % 3)]]
                }
                2 => {
                    let behind = (0..3).find(|&k| is_near(k)).unwrap();
                    let (a, b) = ((behind + 1) % 3, (behind + 2) % 3);
                    let (p, q) = (cut(b, behind), cut(a, behind));
                    vec![[whole(a), whole(b), p], [whole(a), p, q]]
                }
                _ => vec![],
            };
            for triangle in triangles {
                reference.triangle(&state, mode, triangle);
            }
        }
    }
}

fn random_list(random: &mut Random) -> TriangleList {
    let (vertices, triangles) = (random.range(3, 40) as usize, random.range(1, 30) as usize);
    let mut list = loop {
        let vertex = VertexFormat::from_bits(random.range(2, 3)).unwrap();
        let vertex = if random.one_in(2) { vertex } else { VertexFormat::default() };
        let index = IndexFormat::from_bits(random.range(0, 7)).unwrap();
        let states = (0..3)
            .map(|_| RasterState {
                draw_mode: fillrate_quark::DrawMode::ALL[random.bits() as usize % 4],
                draw_color: random.bits() as u8,
                draw_intensity: random.bits() as u8,
                test_culling: random.one_in(3),
                z_sort: false,
                texture: Some(random.texture()),
            })
            .collect();
        let list = TriangleList::new(vertex, vertices, index, triangles, states);
        match list {
            Ok(list) if vertex.uv || index.uv => break list,
            _ => continue,
        }
    };
    for i in 0..vertices {
        list.set_xyz(i, [0; 3].map(|_| random.range(-700, 700) as i16));
        if list.vertex_format().uv {
            list.set_uv(i, &[[random.range(-900, 900) as i16, random.range(0, 256) as i16]]);
        }
        list.set_i(i, random.range(0, 255));
    }
    for i in 0..triangles {
        let last = vertices as i32 - i32::from(!random.one_in(20));
        list.set_abc(i, [0; 3].map(|_| random.range(0, last) as u16));
        if list.index_format().uv {
            let uv = [[0; 2]; 3].map(|pair: [i16; 2]| pair.map(|_| random.range(-300, 900) as i16));
            list.set_uv(i, &uv);
        }
        if list.index_format().intensity {
            list.set_i(i, random.range(0, 255));
        }
        list.set_c(i, random.range(0, 255));
    }
    if random.one_in(2) {
        let states: Vec<u16> = (0..triangles).map(|_| random.range(0, 3) as u16).collect();
        list.build_commands(&states);
    }
    list
}

#[test]
fn drawing_follows_the_documented_steps() {
    let (width, height) = (90, 120);
    for case in 0..400u64 {
        let mut random = Random::new(case);
        let list = random_list(&mut random);
        let config = GpuConfig {
            width,
            height,
            near: random.range(-400, -64),
            field_of_view: random.range(8, 120),
            ..GpuConfig::default()
        };
        let mut gpu = Gpu::new(config).unwrap();
        gpu.set_work_memory(100, 0).unwrap();
        let mut matrix = Matrix::identity();
        matrix.translate(
            random.range(-300, 300),
            random.range(-300, 300),
            random.range(-1500, 200),
        );
        matrix.rotate_x(random.range(0, 8191));
        matrix.rotate_y(random.range(0, 8191));
        gpu.view_matrix = Some(matrix);
        let mode = TriangleMode::ALL[random.bits() as usize % 4];
        gpu.triangle_mode = Some(mode);
        gpu.draw_list(&list.view()).unwrap();
        let mut reference = Reference::new(width, height);
        expect(&mut reference, &list, &matrix, &gpu.camera, mode);
        assert!(gpu.frame_buffer() == reference.words, "case {case}, {mode:?}");
    }
}
