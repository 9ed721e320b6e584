//! Scratch timing.
use fillrate_engine::setup::*;
use fillrate_engine::state::*;
use fillrate_engine::target::*;
use fillrate_engine::texture::*;
use fillrate_engine::*;
use std::sync::Arc;
use std::time::Instant;

fn v(x: f32, y: f32, w: f32, z: f32, c: [f32; 3], s: f32, t: f32) -> Vertex {
    let q = 1.0 / w;
    let tm = TmuVertex { s: s * q, t: t * q, w: q };
    Vertex { x, y, r: c[0], g: c[1], b: c[2], a: 255.0, z, w: q, tmu: [tm; 3] }
}

fn main() {
    let threads: usize = std::env::args().nth(1).map_or(1, |s| s.parse().unwrap());
    let level =
        std::env::args().nth(2).map_or(fillrate_simd::Level::best(), |s| s.parse().unwrap());
    let mut dev = Device::new(DeviceConfig { threads, level, tile: TileSize::Medium }).unwrap();
    let c = dev.create_surface(640, 480, PixelFormat::Rgb565).unwrap();
    let a = dev.create_surface(640, 480, PixelFormat::Aux16).unwrap();
    dev.set_target(c, Some(a)).unwrap();
    let mut seed = 1u32;
    let desc = TextureDesc { s_bits: 8, t_bits: 8, first: 0, last: 8, clamp_s: false };
    let tex = Arc::new(
        Texture::build(desc, |l, out| {
            let n = 256usize >> l;
            out.extend((0..n * n).map(|_| {
                seed = seed.wrapping_mul(1664525).wrapping_add(1013904223);
                seed
            }));
        })
        .unwrap(),
    );
    let texel = CombineUnit { zero_other: true, add: Addend::Local, ..Default::default() };
    let unit = TextureUnit {
        perspective: true,
        clamp_negative_w: true,
        minify: Filter::Bilinear,
        magnify: Filter::Bilinear,
        lod: LodRange { min: 0, max: 0x800, bias: 0 },
        combine: TextureCombine { color: texel, alpha: texel },
        ..Default::default()
    };
    let modulate = CombineUnit { factor: Factor::Local, ..Default::default() };
    let base = DrawState {
        dither: Dither::Ordered4x4,
        clip: Some(Rect::new(0, 0, 640, 480)),
        ..Default::default()
    };
    let depth = DepthState {
        source: DepthSource::Z,
        test: Some(Compare::LessEqual),
        bias: None,
        compare_constant: None,
    };
    let w2 = DrawState { depth, aux_write: AuxWrite::Depth, ..base };
    let w3 = DrawState {
        units: [Some(unit), None, None],
        color_combine: ColorCombine {
            other: Other::Texture,
            local: ColorLocal::Iterated,
            unit: modulate,
        },
        ..w2
    };
    let k = CombineUnit { zero_other: true, add: Addend::Local, ..Default::default() };
    let w1 = DrawState {
        color_combine: ColorCombine {
            other: Other::Constant,
            local: ColorLocal::Constant,
            unit: k,
        },
        alpha_combine: AlphaCombine {
            other: Other::Constant,
            local: AlphaLocal::Constant,
            unit: k,
        },
        ..base
    };
    let blend = Blend {
        source: BlendFactor::SourceAlpha,
        destination: BlendFactor::OneMinusSourceAlpha,
        source_alpha: true,
        destination_alpha: false,
        alpha_plane: false,
        subtract_dither: true,
    };
    let w4 = DrawState { blend: Some(blend), aux_write: AuxWrite::Nothing, ..w3 };
    for (name, st, order) in [
        ("w1", w1, 0),
        ("w2b2f", w2, 0),
        ("w2f2b", w2, 1),
        ("w3b2f", w3, 0),
        ("w3f2b", w3, 1),
        ("w4", w4, 0),
    ] {
        let mut best = f64::MAX;
        let mut all = vec![];
        for _ in 0..25 {
            let t = Instant::now();
            dev.clear(
                Rect::new(0, 0, 640, 480),
                ClearValues { color: Some((0, Dither::Ordered4x4)), aux: Some(0xffff) },
            );
            for layer in 0..20 {
                let z = if order == 0 {
                    60000.0 - layer as f32 * 2000.0
                } else {
                    20000.0 + layer as f32 * 2000.0
                };
                dev.set_state(
                    &DrawState { color0: layer * 77777, ..st },
                    [Some(tex.clone()), None, None],
                );
                let p = [(0., 480., 1.), (640., 480., 1.), (640., 0., 3.), (0., 0., 3.)];
                let q: Vec<Vertex> = p
                    .iter()
                    .enumerate()
                    .map(|(i, &(x, y, w)): (usize, &(f32, f32, f32))| {
                        let (fx, fy) = ((x - 320.0) * w * 0.5, w * 256.0);
                        v(
                            x,
                            y,
                            w,
                            z,
                            [(i * 60) as f32 + 60., 200. - i as f32 * 30., 100.],
                            fx * 0.866 - fy * 0.5,
                            fx * 0.5 + fy * 0.866,
                        )
                    })
                    .collect();
                dev.draw_triangle([&q[0], &q[1], &q[2]], Cull::Disabled);
                dev.draw_triangle([&q[0], &q[2], &q[3]], Cull::Disabled);
            }
            dev.flush(FlushReason::Swap);
            let dt = t.elapsed().as_secs_f64();
            best = best.min(dt);
            all.push(dt);
        }
        all.sort_by(f64::total_cmp);
        let px = 640.0 * 480.0 * 20.0 * 1e-6;
        println!("{name:6} median {:8.0} best {:8.0} Mpix/s", px / all[12], px / best);
    }
    for (name, area) in [("w6a", 10.0f32), ("w6b", 2.0), ("w7", 100.0)] {
        dev.set_state(&w3, [Some(tex.clone()), None, None]);
        let mut r = || {
            seed ^= seed << 13;
            seed ^= seed >> 17;
            seed ^= seed << 5;
            (seed >> 8) as f32 / 16777216.0
        };
        let mut tris = vec![];
        let (mut cx, mut cy, mut cz, mut cw) = (0., 0., 0., 0.);
        for i in 0..200_000 {
            if i % 64 == 0 {
                cx = 60. + r() * 520.;
                cy = 60. + r() * 360.;
                cz = 6000. + r() * 50000.;
                cw = 1. + r() * 3.;
            }
            let (ang, asp, skew) = (r() * 6.28, 0.6 + r(), r() * 0.8 - 0.4);
            let (a, b) = ((2.0 * area).sqrt() * asp, (2.0 * area).sqrt() / asp);
            let (px, py) = ([0., a, a * (0.3 + skew)], [0., 0., b]);
            let (ox, oy) = (cx + r() * 80. - 40., cy + r() * 80. - 40.);
            let (sa, ca) = ang.sin_cos();
            tris.push([0, 1, 2].map(|k: usize| {
                let (x, y) = (ox + px[k] * ca - py[k] * sa, oy + px[k] * sa + py[k] * ca);
                let w = cw * (0.97 + r() * 0.06);
                v(x, y, w, cz + r() * 2000., [r() * 255., r() * 255., 128.], x - cx, y - cy)
            }));
        }
        let mut all = vec![];
        for _ in 0..7 {
            let t = Instant::now();
            dev.clear(
                Rect::new(0, 0, 640, 480),
                ClearValues { color: Some((0, Dither::Ordered4x4)), aux: Some(0xffff) },
            );
            for [a, b, c] in &tris {
                dev.draw_triangle([a, b, c], Cull::Disabled);
            }
            dev.flush(FlushReason::Swap);
            all.push(t.elapsed().as_secs_f64());
        }
        all.sort_by(f64::total_cmp);
        println!("{name} {:.2} Mtri/s", 0.2 / all[3]);
    }
}
