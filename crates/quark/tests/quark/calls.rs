//! Calls as values: they encode, and a replay of them draws the same frames.

use fillrate_call::{Decoder, Encoder, Tagged, Value};
use fillrate_engine::DeviceConfig;
use fillrate_quark::{Call, Context, ListValue, Matrix, StateValue, Vertex};

use crate::random::Random;

/// A frame that uses every kind of call.
fn frame(random: &mut Random) -> Vec<Call> {
    let gpu = 7;
    let state = StateValue {
        draw_mode: random.bits() as u8 % 5,
        draw_color: random.bits() as u8,
        draw_intensity: random.bits() as u8,
        test_culling: 0,
        z_sort: random.bits() as u8 % 2,
        texture: random.bits() % 3,
    };
    let vertices: Vec<u8> = (0..3 * 8)
        .flat_map(|k| {
            {
                let z = if k % 3 == 2 { -500 } else { 0 };
                (random.range(-150, 150) + z) as i16
            }
            .to_le_bytes()
        })
        .collect();
    let indices: Vec<u8> = (0..6 * 9)
        .flat_map(|k| (if k % 9 < 3 { random.bits() as u16 % 8 } else { 100 }).to_le_bytes())
        .collect();
    let list = ListValue {
        vertex_format: 0,
        index_format: 4,
        vertices: vertices.into(),
        indices: indices.into(),
        commands: vec![6, 0],
        states: vec![state],
    };
    let corner = |random: &mut Random| {
        let [x, y, z] = random.point(240, 320);
        Vertex { x, y, z, m: 0, i: 200, u: random.range(0, 300), v: random.range(0, 300) }
    };
    let point = |random: &mut Random| random.point(240, 320);
    vec![
        Call::TextureInit {
            texture: 1,
            texels: (0..32 * 64).map(|_| random.bits() as u8).collect::<Vec<u8>>().into(),
            x: 32,
            y: 64,
            key: 5,
        },
        Call::Texture { texture: 2, texels: vec![9; 16 * 16].into(), x: 16, y: 16, keyed: true },
        Call::TextState { gpu, state },
        Call::LineState { gpu, state },
        Call::SpriteState { gpu, state },
        Call::TriangleState { gpu, state: Some(state) },
        Call::TriangleMode { gpu, mode: random.range(0, 4) },
        Call::ViewMatrix { gpu, matrix: Some(Matrix::identity().m) },
        Call::ZcErrorMax { gpu, error: random.range(0, 900) },
        Call::FrameBuffer { gpu, words: vec![9, 1, 0, 0, 0xff, 0x1f, 0, 0x40].into() },
        Call::PrintXy { gpu, text: b"Quark\n3D".to_vec(), x: 20, y: 20 },
        Call::PrintFps { gpu, ticks: random.bits() },
        Call::PutPixel { gpu, x: 5, y: 6, color: random.range(0, 8191) },
        Call::DrawLine { gpu, a: point(random), b: point(random) },
        Call::DrawSprite { gpu, x: 30, y: 40 },
        Call::DrawSpriteScale { gpu, x: 100, y: 100, scale: 700 },
        Call::DrawSpriteScaleZb { gpu, top_left: [5, 5], bottom_right: [99, 99], z: 400 },
        Call::DrawTriangle { gpu, a: corner(random), b: corner(random), c: corner(random) },
        Call::DrawTriangleList { gpu, list: list.clone() },
        Call::WeldVertex { list: list.clone(), position: 5, intensity: 0, uv: 0 },
        Call::BuildCmdList { list: list.clone(), states: vec![0; 6] },
        Call::BuildFNormalList { list: list.clone() },
        Call::BuildVNormalList { list },
        Call::ListInit { vertex_format: 0, vertices: 5, index_format: 0, triangles: 5 },
        Call::SortDraw { gpu },
        Call::SetFov { gpu, fov: random.range(8, 120) },
        Call::SetNfClip { gpu, near: -80, far: -3000 },
        Call::ScrProjection { gpu, position: [1, 2, -300] },
        Call::ClipMsk { gpu, position: [1, 2, -300] },
        Call::CrossFrustrum { gpu, corners: [[1, 2, -300]; 8] },
        Call::Camera { gpu, zoom: 200, near: -70, far: -4000, frustum: [[0, 0, -16384]; 4] },
        Call::FrameCounter { gpu, count: 3 },
        Call::FlushFb { gpu, address: 0, clear_color: random.range(0, 8191) },
    ]
}

fn script() -> Vec<Call> {
    let mut random = Random::new(41);
    let mut calls = vec![
        Call::Init { gpu: 7, near: -64, far: -4095, fov: 60 },
        Call::SetWorkMemory { gpu: 7, max_vertex: 100, max_sort: 100 },
        Call::SortReset { gpu: 7 },
    ];
    for _ in 0..12 {
        calls.extend(frame(&mut random));
    }
    calls.push(Call::Delete { gpu: 7 });
    calls
}

fn play(calls: &[Call], threads: usize) -> Vec<Vec<u16>> {
    let mut context = Context::new(DeviceConfig { threads, ..DeviceConfig::default() });
    let mut frames = Vec::new();
    for call in calls {
        context.execute(call);
        if matches!(call, Call::FlushFb { .. }) {
            frames.push(context.shown().expect("a frame is shown").colors);
        }
    }
    frames
}

#[test]
fn every_variant_survives_encoding_and_draws_the_same() {
    let calls = script();
    for (tag, name) in Call::VARIANTS {
        assert!(calls.iter().any(|call| call.tag() == *tag), "{name} is not tried");
    }
    let decoded: Vec<Call> = calls
        .iter()
        .map(|call| {
            let mut encoder = Encoder::new();
            call.encode(&mut encoder);
            let bytes = encoder.into_bytes();
            let mut decoder = Decoder::new(&bytes);
            let decoded = Call::decode(&mut decoder).expect("it was encoded");
            decoder.finish().expect("all was read");
            decoded
        })
        .collect();
    assert_eq!(calls, decoded);
    let frames = play(&calls, 1);
    assert_eq!(frames.len(), 12);
    assert!(frames.windows(2).all(|pair| pair[0] != pair[1]));
    assert_eq!(frames, play(&decoded, 3));
}
