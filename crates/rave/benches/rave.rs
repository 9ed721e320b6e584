//! Submission, filling, and the books of texture memory:
//! `cargo bench -p fillrate-rave`. One thread, which also draws; rates are
//! elements (triangles, pixels, submissions) a second.

use std::hint::black_box;
use std::sync::Arc;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use fillrate_engine::DeviceConfig;
use fillrate_rave::constants::{context, quality, texture_op, vertex_mode};
use fillrate_rave::memory::{EngineKind, MemoryConfig, TextureMemory};
use fillrate_rave::tags::{int, pointer};
use fillrate_rave::{
    Call, Context, DeviceValue, DrawContextId, EngineId, ImageValue, IndexedTriangle, PixelType,
    RaveConfig, RaveRect, VGouraud, VTexture,
};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 240;
const ENGINE: u32 = EngineId::BUILT_IN.0;

/// A library with a context of 16-bit pixels, and a texture.
fn library() -> (Context, u32, u32) {
    let device = DeviceConfig { threads: 1, ..DeviceConfig::default() };
    let config = RaveConfig { device, asynchronous: false, ..RaveConfig::default() };
    let mut library = Context::new(config);
    let device = DeviceValue {
        device_type: 0,
        pixel_type: PixelType::Rgb16_565.number(),
        width: WIDTH as i32,
        height: HEIGHT as i32,
        row_bytes: 2 * WIDTH as i32,
    };
    let rect = RaveRect::new(0, 0, WIDTH as i32, HEIGHT as i32);
    let flags = context::DOUBLE_BUFFER;
    let new =
        Call::DrawContextNew { engine: ENGINE, device, rect, scaled: None, clip: None, flags };
    let context = library.execute(&new).created();
    let pixels: Vec<u8> = (0..128 * 128 * 4).map(|i| (i * 7 + i / 512) as u8).collect();
    let images = vec![ImageValue { width: 128, height: 128, pixels: pixels.into() }];
    let pixel_type = PixelType::Argb32.number();
    let new = Call::TextureNew { engine: ENGINE, flags: 0, pixel_type, images };
    let texture = library.execute(&new).created();
    (library, context, texture)
}

fn frame(library: &mut Context, context: u32, draw: impl FnOnce(&mut Context)) {
    library.execute(&Call::RenderStart { context, dirty: None, initial: 0 });
    draw(library);
    library.execute(&Call::RenderEnd { context, modified: None });
}

/// Corner n of a grid of triangles of about 32 pixels.
fn corner(n: u32) -> VTexture {
    let (x, y) = ((n % 39) as f32 * 8.0 + 2.0, (n / 39 % 29) as f32 * 8.0 + 2.0);
    VTexture {
        x,
        y,
        z: 0.5,
        inv_w: 1.0,
        a: 1.0,
        u_over_w: x / 32.0,
        v_over_w: y / 32.0,
        kd_r: 1.0,
        kd_g: 0.8,
        kd_b: 0.6,
        ..VTexture::default()
    }
}

fn gouraud(v: &VTexture) -> VGouraud {
    VGouraud { x: v.x, y: v.y, z: v.z, inv_w: 1.0, r: v.kd_r, g: v.kd_g, b: v.kd_b, a: 1.0 }
}

fn submission(c: &mut Criterion) {
    let mut group = c.benchmark_group("triangles");
    let count = 38 * 28;
    group.throughput(Throughput::Elements(count));
    let corners: Vec<VTexture> = (0..39 * 29).map(corner).collect();
    let cells = |n: usize| n / 38 * 39 + n % 38;
    let single: Vec<[VTexture; 3]> = (0..count as usize)
        .map(|n| [corners[cells(n)], corners[cells(n) + 1], corners[cells(n) + 39]])
        .collect();
    let (mut library, context, texture) = library();
    library.execute(&Call::SetTexture { context, tag: pointer::TEXTURE, texture });
    group.bench_function("gouraud/one by one", |b| {
        b.iter(|| {
            frame(&mut library, context, |library| {
                for [a, b, c] in &single {
                    let [a, b, c] = [a, b, c].map(gouraud);
                    library.execute(&Call::DrawTriGouraud { context, a, b, c, flags: 0 });
                }
            });
        });
    });
    group.bench_function("texture/one by one", |b| {
        b.iter(|| {
            frame(&mut library, context, |library| {
                for &[a, b, c] in &single {
                    library.execute(&Call::DrawTriTexture { context, a, b, c, flags: 0 });
                }
            });
        });
    });
    let array = single.concat();
    group.bench_function("texture/array", |b| {
        b.iter(|| {
            frame(&mut library, context, |library| {
                library.draw_v_texture(DrawContextId(context), vertex_mode::TRI, &array);
            });
        });
    });
    let triangles: Vec<IndexedTriangle> = (0..count as usize)
        .map(|n| cells(n) as u32)
        .map(|n| IndexedTriangle { flags: 0, vertices: [n, n + 1, n + 39] })
        .collect();
    library.execute(&Call::SubmitVerticesTexture { context, vertices: corners });
    let mesh = Call::DrawTriMeshTexture { context, triangles };
    group.bench_function("texture/mesh", |b| {
        b.iter(|| {
            frame(&mut library, context, |library| {
                library.execute(&mesh);
            });
        });
    });
    group.finish();
}

/// The whole screen, in two triangles.
fn fill(c: &mut Criterion) {
    let mut group = c.benchmark_group("fill");
    group.throughput(Throughput::Elements(u64::from(WIDTH * HEIGHT)));
    let corner = |x: f32, y: f32| VTexture {
        x,
        y,
        u_over_w: x / 64.0,
        v_over_w: y / 64.0,
        ks_g: 0.1,
        ..self::corner(0)
    };
    let (w, h) = (WIDTH as f32, HEIGHT as f32);
    let corners = [corner(0.0, 0.0), corner(w, 0.0), corner(0.0, h), corner(w, h)];
    let both = texture_op::MODULATE | texture_op::HIGHLIGHT;
    for (name, op, filter, alpha) in [
        ("nearest", texture_op::NONE, quality::FAST, 1.0),
        ("bilinear", texture_op::NONE, quality::MID, 1.0),
        ("bilinear, modulated", texture_op::MODULATE, quality::MID, 1.0),
        ("bilinear, modulated, highlight", both, quality::MID, 1.0),
        ("bilinear, blended", texture_op::NONE, quality::MID, 0.5),
    ] {
        let (mut library, context, texture) = library();
        library.execute(&Call::SetTexture { context, tag: pointer::TEXTURE, texture });
        library.execute(&Call::SetInt { context, tag: int::TEXTURE_OP, value: op });
        library.execute(&Call::SetInt { context, tag: int::TEXTURE_FILTER, value: filter });
        library.execute(&Call::SetInt { context, tag: int::BLEND, value: u32::from(alpha < 1.0) });
        let corners = corners.map(|v| VTexture { a: alpha, ..v });
        group.bench_function(name, |b| {
            b.iter(|| {
                frame(&mut library, context, |library| {
                    library.draw_v_texture(DrawContextId(context), vertex_mode::STRIP, &corners);
                });
            });
        });
    }
    group.finish();
}

/// Polygons of textures in turn: with room for all, and for half of them.
fn texture_memory(c: &mut Criterion) {
    const TURNS: u64 = 1024;
    let mut group = c.benchmark_group("memory");
    group.throughput(Throughput::Elements(TURNS));
    for (name, room) in [("all fit", 64), ("half of them fit", 32)] {
        let config = MemoryConfig {
            kind: EngineKind::Separate,
            video_bytes: room * 1024,
            ..MemoryConfig::default()
        };
        let memory = TextureMemory::new(config);
        let textures: Vec<_> = (0..64)
            .map(|n| memory.create(Arc::new(n), 1024, false).expect("small textures"))
            .collect();
        group.bench_function(name, |b| {
            b.iter(|| {
                for turn in 0..TURNS {
                    let texture = textures[(turn * 7 % 64) as usize];
                    memory.submit(black_box(&[texture]), 2).expect("owned");
                }
                memory.draw_queued();
            });
        });
    }
    group.finish();
}

criterion_group!(benches, submission, fill, texture_memory);
criterion_main!(benches);
