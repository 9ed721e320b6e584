//! Input out of range: no panic, no hang, and the documented answer.

use std::sync::Arc;

use fillrate_quark::{
    Call, Command, Context, ErrorCode, Gpu, GpuConfig, ListView, RasterState, Reply, Texture,
    TriangleMode, Vertex, VertexFormat,
};

use crate::random::Random;

fn gpu() -> Gpu {
    let mut gpu = Gpu::new(GpuConfig { width: 40, height: 30, ..GpuConfig::default() }).unwrap();
    gpu.set_work_memory(100, 100).unwrap();
    gpu
}

#[test]
fn sizes_planes_and_angles_out_of_range() {
    let make = |width, height, near, far, field_of_view| {
        let config = GpuConfig { width, height, near, far, field_of_view, ..GpuConfig::default() };
        Gpu::new(config).is_ok()
    };
    assert!(make(240, 320, -64, -4095, 60));
    for (width, height) in [(0, 0), (15, 320), (240, 2049), (u32::MAX, u32::MAX)] {
        assert!(!make(width, height, -64, -4095, 60));
    }
    for (near, far) in [(0, -4095), (-64, -5000), (-100, -100), (i32::MAX, i32::MIN)] {
        assert!(!make(240, 320, near, far, 60));
    }
    for angle in [7, 121, -1, i32::MIN] {
        assert!(!make(240, 320, -64, -4095, angle));
    }
    assert_eq!(gpu().set_work_memory(usize::MAX, usize::MAX), Err(ErrorCode::Memory));
}

#[test]
fn extreme_triangles_lines_and_sprites() {
    let extremes = [i32::MIN, -1, 0, 1, 63, 64, 4095, 1 << 20, i32::MAX];
    let mut random = Random::new(9);
    let mut gpu = gpu();
    let texture = random.texture();
    for turn in 0..20_000 {
        let mut pick = || extremes[random.bits() as usize % extremes.len()];
        let mut vertex =
            || Vertex { x: pick(), y: pick(), z: pick(), m: 0, i: pick(), u: pick(), v: pick() };
        let corners = [vertex(), vertex(), vertex()];
        let (a, b, z) = ([pick(), pick(), pick()], [pick(), pick(), pick()], pick());
        gpu.triangle_mode = Some(TriangleMode::ALL[turn % 4]);
        gpu.zc_error_max = pick();
        let state = RasterState {
            draw_mode: fillrate_quark::DrawMode::ALL[turn / 4 % 4],
            test_culling: false,
            z_sort: turn % 7 == 0,
            texture: Some(Arc::clone(&texture)),
            ..RasterState::default()
        };
        gpu.sprite_state = state.clone();
        gpu.triangle_state = Some(state);
        gpu.draw_triangle(&corners[0], &corners[1], &corners[2]);
        gpu.draw_line(&a, &b);
        gpu.draw_sprite(a[0], a[1]);
        gpu.draw_sprite_scale(a[0], a[1], z);
        gpu.draw_sprite_scale_zb([a[0], a[1]], [b[0], b[1]], z);
        gpu.put_pixel(a[0], b[1], z as u16);
        gpu.print_xy(b"a\n\xff", a[0], a[1]);
        if turn % 100 == 0 {
            gpu.sort_draw();
            gpu.flush_frame(turn as u16);
            assert!(gpu.frame_buffer().iter().all(|word| word & 0xe000 == 0));
        }
    }
}

#[test]
fn missing_things_draw_nothing() {
    let mut gpu = gpu();
    let corner = |x, y| Vertex { x, y, z: 100, i: 255, ..Vertex::default() };
    let (a, b, c) = (corner(0, 0), corner(0, 30), corner(40, 30));
    gpu.draw_triangle(&a, &b, &c);
    gpu.triangle_state = Some(RasterState::default());
    gpu.triangle_mode = None;
    gpu.draw_triangle(&a, &b, &c);
    gpu.draw_sprite(0, 0);
    gpu.draw_sprite_scale_zb([0, 0], [9, 9], 100);
    assert!(gpu.frame_buffer().iter().all(|&word| word == 0));
    // A textured triangle without a texture is drawn in one colour.
    gpu.triangle_mode = Some(TriangleMode::Perspective);
    gpu.draw_triangle(&a, &b, &c);
    assert!(gpu.frame_buffer().contains(&(41943 << 16 | 0x1fff)));
}

#[test]
fn sprite_textures_are_no_skins() {
    let mut gpu = gpu();
    let texture = Texture::new(&[3; 20 * 30], 20, 30, -1).unwrap();
    gpu.triangle_state =
        Some(RasterState { texture: Some(Arc::new(texture)), ..RasterState::default() });
    let corner = |x, y| Vertex { x, y, z: 100, i: 255, u: 1, v: 1, ..Vertex::default() };
    gpu.draw_triangle(&corner(0, 0), &corner(0, 30), &corner(40, 30));
    assert!(gpu.frame_buffer().iter().all(|&word| word == 0 || word & 0x1fff == 0x1fff));
}

#[test]
fn commands_beyond_the_list() {
    let mut gpu = gpu();
    gpu.triangle_mode = Some(TriangleMode::Untextured);
    let states = [RasterState::default()];
    let command = |count, state| Command { count, state };
    let commands = [command(1, 9), command(65_535, 0), command(3, 0)];
    let vertices = [0, 0, -100, 50, 0, -100, 0, 50, -100, 7];
    let indices = [0, 1, 2, 0, 1, 2, 0, 1, 65_535, 4];
    let view = ListView {
        vertex_format: VertexFormat::default(),
        index_format: Default::default(),
        vertices: &vertices,
        indices: &indices,
        commands: &commands,
        states: &states,
    };
    assert_eq!(gpu.draw_list(&view), Ok(()));
    // The first triangle has no state, the third no corner.
    assert_eq!(gpu.counters().triangles_in, 1);
    assert_eq!(gpu.draw_list(&ListView { indices: &[], vertices: &[], ..view }), Ok(()));
}

#[test]
fn calls_without_their_objects() {
    let mut context = Context::default();
    let draw = Call::DrawSprite { gpu: 3, x: 0, y: 0 };
    assert!(matches!(context.execute(&draw), Reply::Nothing));
    let flush = Call::FlushFb { gpu: 3, address: 0, clear_color: 0 };
    context.execute(&flush);
    assert!(context.shown().is_none());
    let number = |reply: Reply| reply.number();
    for (near, far, fov) in [(-64, -64, 60), (0, 0, 60), (-64, -4095, 200)] {
        assert_eq!(number(context.execute(&Call::Init { gpu: 1, near, far, fov })), 0);
    }
    for (vertex_format, vertices, index_format, triangles, code) in [
        (4, 1, 0, 1, ErrorCode::VertexFormat),
        (0, 1, -8, 1, ErrorCode::IndexFormat),
        (1, 1, 1, 1, ErrorCode::DuplicateIntensity),
        (2, 1, 4, 1, ErrorCode::DuplicateUv),
        (0, -1, 0, 1, ErrorCode::Memory),
        (0, 1, 0, i32::MAX, ErrorCode::Memory),
    ] {
        let init = Call::ListInit { vertex_format, vertices, index_format, triangles };
        match context.execute(&init) {
            Reply::List(list) => assert_eq!(list.err(), Some(code)),
            other => panic!("{other:?}"),
        }
    }
}
