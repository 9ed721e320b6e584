//! Mathematics, lists and primitives: `cargo bench -p fillrate-quark`. Rates are
//! elements a second on one thread; whole pictures are `fillrate bench --only Q`.

use std::hint::black_box;
use std::sync::Arc;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use fillrate_engine::DeviceConfig;
use fillrate_quark::{
    DrawMode, Gpu, GpuConfig, IndexFormat, Matrix, RasterState, Texture, TriangleList,
    TriangleMode, Vertex, VertexFormat, math,
};

const NUMBERS: i32 = 1024;

fn mathematics(c: &mut Criterion) {
    let mut group = c.benchmark_group("math");
    group.throughput(Throughput::Elements(NUMBERS as u64));
    let mut case = |name: &str, f: fn(i32) -> i32| {
        group.bench_function(name, |b| {
            b.iter(|| (0..NUMBERS).map(|n| f(black_box(n))).sum::<i32>())
        });
    };
    case("sinus", |n| math::sinus(n).into());
    case("sqrti", |n| math::sqrti(n * 99_991));
    case("atan2i", |n| math::atan2i(n - 500, 77 * n + 3));
    case("normalize", |n| {
        let mut v = [n, 3 * n - 40, 1000 - n];
        math::normalize(&mut v);
        v[0]
    });
    group.finish();
}

/// A grid of triangles, lit and textured.
fn grid(side: usize) -> TriangleList {
    let texels: Vec<u8> = (0..64 * 64).map(|i| (i * 7 % 255) as u8).collect();
    let texture = Texture::new(&texels, 64, 64, -1).expect("a valid size");
    let state = RasterState { texture: Some(Arc::new(texture)), ..RasterState::default() };
    let vertex = VertexFormat { intensity: true, uv: true };
    let count = side * side;
    let list = TriangleList::new(vertex, count, IndexFormat::default(), 2 * count, vec![state]);
    let mut list = list.expect("a valid format");
    for i in 0..count {
        let (x, y) = ((i % side) as i16, (i / side) as i16);
        list.set_xyz(i, [x * 8 - 200, y * 8 - 200, -500]);
        list.set_uv(i, &[[x * 20, y * 20]]);
        list.set_i(i, (i % 256) as i32);
        if i % side + 1 < side && i / side + 1 < side {
            let a = i as u16;
            let below = a + side as u16;
            list.set_abc(2 * i, [a, a + 1, below]);
            list.set_abc(2 * i + 1, [a + 1, below + 1, below]);
        }
    }
    list.build_commands(&[]);
    list
}

fn gpu() -> Gpu {
    let device = DeviceConfig { threads: 1, ..DeviceConfig::default() };
    let mut gpu = Gpu::new(GpuConfig { device, ..GpuConfig::default() }).expect("a valid size");
    gpu.set_work_memory(4096, 4096).expect("little memory");
    gpu
}

fn lists(c: &mut Criterion) {
    let list = grid(50);
    let mut group = c.benchmark_group("list");
    group.throughput(Throughput::Elements(list.triangle_count() as u64));
    group.bench_function("vertex_normals", |b| b.iter(|| black_box(list.vertex_normals())));
    group.bench_function("weld", |b| {
        b.iter(|| {
            let mut list = list.clone();
            list.weld(0, 0, 0);
            list
        });
    });
    for mode in TriangleMode::ALL {
        let mut gpu = gpu();
        gpu.triangle_mode = Some(mode);
        gpu.view_matrix = Some(Matrix::identity());
        group.bench_function(format!("draw/{mode:?}"), |b| {
            b.iter(|| {
                gpu.draw_list(&list.view()).expect("the list fits");
                gpu.flush_frame(0);
            });
        });
    }
    group.finish();
}

/// The whole screen, nearer each time so that all of it is drawn.
fn fill(c: &mut Criterion) {
    let list = grid(2);
    let mut group = c.benchmark_group("fill");
    group.throughput(Throughput::Elements(240 * 320));
    for draw_mode in DrawMode::ALL {
        let mut gpu = gpu();
        gpu.triangle_mode = Some(TriangleMode::Affine);
        gpu.triangle_state = Some(RasterState { draw_mode, ..list.states[0].clone() });
        let corner = |x, y| Vertex { x, y, z: 100, m: 0, i: 200, u: 2 * x, v: 2 * y };
        let [a, b, c, d] = [corner(0, 0), corner(0, 320), corner(240, 320), corner(240, 0)];
        group.bench_function(format!("{draw_mode:?}"), |bencher| {
            bencher.iter(|| {
                gpu.draw_triangle(&a, &b, &c);
                gpu.draw_triangle(&a, &c, &d);
                gpu.flush_frame(0x1f00);
            });
        });
    }
    group.finish();
}

criterion_group!(benches, mathematics, lists, fill);
criterion_main!(benches);
