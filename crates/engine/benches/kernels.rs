//! Full-screen layers by state and level: `cargo bench -p fillrate-engine`.
//! Rates are fragments a second on one thread.

use std::sync::Arc;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use fillrate_engine::setup::{TmuVertex, Vertex};
use fillrate_engine::state::{
    Addend, AlphaEquation, Blend, BlendFactor, ColorCombine, ColorLocal, CombineUnit, Compare,
    DepthState, Dither, Factor, Filter, Fog, FogAmount, LodRange, Other, Rect, Shade,
    TextureCombine, TextureUnit, ZOverflow,
};
use fillrate_engine::target::TileSize;
use fillrate_engine::{
    ClearValues, Cull, Device, DeviceConfig, DrawState, FlushReason, PixelFormat, Texture,
    TextureDesc,
};
use fillrate_simd::Level;

const SIDE: u32 = 256;

/// The states measured, by name.
fn states() -> Vec<(&'static str, DrawState)> {
    let base = DrawState { dither: Dither::Ordered4x4, ..DrawState::default() };
    let depth = DepthState { test: Some(Compare::LessEqual), ..DepthState::default() };
    let tested = DrawState { depth, ..base };
    let texel = CombineUnit { zero_other: true, add: Addend::Local, ..CombineUnit::default() };
    let unit = TextureUnit {
        perspective: true,
        clamp_negative_w: true,
        minify: Filter::Bilinear,
        magnify: Filter::Bilinear,
        lod: LodRange { min: 0, max: 0x800, bias: 0 },
        combine: TextureCombine { color: texel, alpha: texel },
        ..TextureUnit::default()
    };
    let modulate = CombineUnit { factor: Factor::Local, ..CombineUnit::default() };
    let color_combine =
        ColorCombine { other: Other::Texture, local: ColorLocal::Iterated, unit: modulate };
    let textured = DrawState { units: [Some(unit), None, None], color_combine, ..tested };
    let blend = Blend {
        source: BlendFactor::SourceAlpha,
        destination: BlendFactor::OneMinusSourceAlpha,
        source_alpha: true,
        destination_alpha: false,
        alpha_plane: false,
        subtract_dither: true,
        ..Blend::default()
    };
    let fog = Fog {
        amount: FogAmount::Table,
        color: 0x0080_8080,
        drop_fog_color: false,
        drop_fragment_color: false,
    };
    let union = Blend { alpha: AlphaEquation::Union, ..blend };
    let foggy = DrawState { fog: Some(fog), blend: Some(blend), ..textured };
    let by_w = Fog { amount: FogAmount::ByW, ..fog };
    let by_w = DrawState { fog: Some(by_w), blend: Some(union), ..textured };
    let by_factor = Fog { amount: FogAmount::Iterated, ..fog };
    let by_factor = DrawState { fog: Some(by_factor), blend: Some(union), ..textured };
    let specular = Shade { specular: true, ..Shade::default() };
    let mixed = TextureUnit { mix_levels: true, ..unit };
    let clamped = DepthState { z_overflow: ZOverflow::Clamp, ..depth };
    vec![
        ("gouraud", base),
        ("gouraud-depth", tested),
        ("textured", textured),
        ("textured-blend", DrawState { blend: Some(blend), ..textured }),
        ("textured-fog", DrawState { fog: Some(fog), ..textured }),
        ("textured-fog-blend", foggy),
        ("textured-distance-fog-blend", by_w),
        ("textured-fog-factor-blend", by_factor),
        ("textured-specular", DrawState { shade: specular, ..textured }),
        ("textured-trilinear", DrawState { units: [Some(mixed), None, None], ..textured }),
        ("textured-clamped-z", DrawState { depth: clamped, ..textured }),
    ]
}

fn texture() -> Arc<Texture> {
    let desc = TextureDesc { s_bits: 8, t_bits: 8, first: 0, last: 8, clamp_s: false };
    let texture = Texture::build(desc, |level, out| {
        let texels = (256u32 >> level) * (256 >> level);
        out.extend((0..texels).map(|i| i.wrapping_mul(2_654_435_761)));
    });
    Arc::new(texture.expect("a square chain is valid"))
}

fn corner(x: f32, y: f32, w: f32) -> Vertex {
    let oow = 1.0 / w;
    let tmu = TmuVertex { s: x * w * oow, t: y * w * oow, w: oow };
    Vertex { x, y, r: x, g: y, b: 128.0, a: 128.0, z: 100.0 * w, w: oow, tmu: [tmu; 3] }
}

fn kernels(c: &mut Criterion) {
    let side = SIDE as f32;
    let corners = [corner(0.0, 0.0, 3.0), corner(side, 0.0, 3.0), corner(side, side, 1.0)];
    let last = corner(0.0, side, 1.0);
    let texture = texture();
    for (name, state) in states() {
        let mut group = c.benchmark_group(name);
        group.throughput(Throughput::Elements(u64::from(SIDE * SIDE)));
        for level in Level::available() {
            let config = DeviceConfig { threads: 1, level, tile: TileSize::Medium };
            let mut device = Device::new(config).expect("one thread needs no helpers");
            let size = "a small surface is allowed";
            let color = device.create_surface(SIDE, SIDE, PixelFormat::Rgb565).expect(size);
            let aux = device.create_surface(SIDE, SIDE, PixelFormat::Aux16).expect(size);
            device.set_target(color, Some(aux)).expect("the surfaces fit");
            device.clear(
                Rect::new(0, 0, SIDE, SIDE),
                ClearValues { color: Some((0, Dither::Off)), aux: Some(0xffff) },
            );
            device.set_state(&state, [Some(texture.clone()), None, None]);
            group.bench_function(level.name(), |b| {
                b.iter(|| {
                    let [p, q, r] = &corners;
                    device.draw_triangle([p, q, r], Cull::Disabled);
                    device.draw_triangle([p, r, &last], Cull::Disabled);
                    device.flush(FlushReason::Explicit);
                });
            });
        }
    }
}

criterion_group!(benches, kernels);
criterion_main!(benches);
