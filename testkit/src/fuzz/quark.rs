//! Streams of Quark 3D's calls from bytes.

use fillrate_call::{Decoder, Tagged, Value};
use fillrate_engine::DeviceConfig;
use fillrate_quark::{Call, Context, ListValue, StateValue, Vertex};

use super::Bytes;

/// The processor that most calls name.
const GPU: u32 = 1;

/// Runs a stream of calls and returns the hash of each frame it shows.
pub fn run_quark(bytes: &[u8], threads: usize) -> Vec<u64> {
    let mut context = Context::new(DeviceConfig { threads, ..DeviceConfig::default() });
    context.execute(&Call::Init { gpu: GPU, near: -64, far: -4095, fov: 60 });
    context.execute(&Call::SetWorkMemory { gpu: GPU, max_vertex: 500, max_sort: 50 });
    let state = StateValue { draw_color: 0xff, draw_intensity: 0xff, ..StateValue::default() };
    context.execute(&Call::TriangleState { gpu: GPU, state: Some(state) });
    context.execute(&Call::TriangleMode { gpu: GPU, mode: 2 });
    let mut from = Bytes::new(bytes);
    let mut frames = Vec::new();
    let calls = std::iter::from_fn(|| (!from.is_empty()).then(|| any_quark_call(&mut from)));
    let end = Call::FlushFb { gpu: GPU, address: 0, clear_color: 0 };
    for call in calls.chain([end]) {
        let shows = matches!(call, Call::FlushFb { .. });
        context.execute(&call);
        if shows && let Some(shown) = context.shown() {
            let hash = |hash: u64, &color: &u16| {
                (hash ^ u64::from(color)).wrapping_mul(0x0000_0100_0000_01b3)
            };
            frames.push(shown.colors.iter().fold(0xcbf2_9ce4_8422_2325, hash));
        }
    }
    frames
}

/// A call whose arguments follow from bytes: plausible ones mostly, anything
/// else now and then.
pub fn any_quark_call(from: &mut Bytes<'_>) -> Call {
    match from.byte() & 31 {
        0..=5 => Call::DrawTriangle { gpu: GPU, a: vertex(from), b: vertex(from), c: vertex(from) },
        6..=9 => Call::DrawTriangleList { gpu: GPU, list: list(from) },
        10 => Call::DrawLine { gpu: GPU, a: point(from), b: point(from) },
        11 => Call::DrawSpriteScale {
            gpu: GPU,
            x: from.half().into(),
            y: from.half().into(),
            scale: from.half().into(),
        },
        12 => Call::DrawSpriteScaleZb {
            gpu: GPU,
            top_left: [near(from), near(from)],
            bottom_right: [near(from), near(from)],
            z: from.half().into(),
        },
        13 => Call::TriangleState { gpu: GPU, state: Some(state(from)) },
        14 => Call::SpriteState { gpu: GPU, state: state(from) },
        15 => Call::TextState { gpu: GPU, state: state(from) },
        16 => Call::LineState { gpu: GPU, state: state(from) },
        17 => Call::TriangleMode { gpu: GPU, mode: i32::from(from.byte() % 5) },
        18 => {
            Call::ViewMatrix { gpu: GPU, matrix: Some(std::array::from_fn(|_| from.half().into())) }
        }
        19 => texture(from),
        20 => Call::BuildCmdList { list: list(from), states: from.halves() },
        21 => Call::WeldVertex {
            list: list(from),
            position: from.int(),
            intensity: from.int(),
            uv: from.int(),
        },
        22 => Call::BuildFNormalList { list: list(from) },
        23 => Call::BuildVNormalList { list: list(from) },
        24 => Call::PrintXy { gpu: GPU, text: from.data().to_vec(), x: near(from), y: near(from) },
        25 => Call::FrameBuffer { gpu: GPU, words: from.data() },
        26 => Call::FlushFb { gpu: GPU, address: from.word(), clear_color: from.int() },
        27 => Call::SortDraw { gpu: GPU },
        28 => Call::SetWorkMemory {
            gpu: GPU,
            max_vertex: from.half().into(),
            max_sort: from.byte().into(),
        },
        _ => decoded(from).unwrap_or(Call::SortReset { gpu: GPU }),
    }
}

/// A call of any tag, decoded from words in a row.
fn decoded(from: &mut Bytes<'_>) -> Option<Call> {
    let variants = Call::VARIANTS;
    let pick = usize::from(from.byte()) | usize::from(from.byte()) << 8;
    let mut bytes = variants[pick % variants.len()].0.to_le_bytes().to_vec();
    bytes.extend(GPU.to_le_bytes());
    bytes.extend((0..40).flat_map(|_| from.int().to_le_bytes()));
    // The lengths of calls differ: the rest of the words is not read.
    Call::decode(&mut Decoder::new(&bytes)).ok()
}

/// A coordinate on the screen or not far from it.
fn near(from: &mut Bytes<'_>) -> i32 {
    i32::from(from.half()) >> 6
}

fn coordinate(from: &mut Bytes<'_>) -> i32 {
    if from.byte() < 8 { from.int() } else { near(from) }
}

fn distance(from: &mut Bytes<'_>) -> i32 {
    if from.byte() < 8 { from.int() } else { i32::from(from.unsigned_half() >> 4) }
}

fn point(from: &mut Bytes<'_>) -> [i32; 3] {
    [coordinate(from), coordinate(from), distance(from)]
}

fn vertex(from: &mut Bytes<'_>) -> Vertex {
    let [x, y, z] = point(from);
    let m = if from.byte() < 16 { from.byte().into() } else { 0 };
    Vertex { x, y, z, m, i: from.byte().into(), u: near(from), v: coordinate(from) }
}

fn state(from: &mut Bytes<'_>) -> StateValue {
    StateValue {
        draw_mode: from.byte() % 5,
        draw_color: from.byte(),
        draw_intensity: from.byte(),
        test_culling: from.byte() & 1,
        z_sort: u8::from(from.byte() < 64),
        texture: u32::from(from.byte() % 4),
    }
}

/// A texture of one of four numbers, of a size that fits its texels mostly.
fn texture(from: &mut Bytes<'_>) -> Call {
    let number = u32::from(from.byte() % 4);
    let (x, y) = (16 << (from.byte() % 3), 16 << (from.byte() % 3));
    let pattern = from.data();
    let texels: Vec<u8> = (0..(x * y) as usize)
        .map(|i| pattern.get(i % pattern.len().max(1)).copied().unwrap_or(0))
        .collect();
    let odd = from.byte() < 32;
    let x = if odd { from.int() } else { x };
    Call::TextureInit { texture: number, texels: texels.into(), x, y, key: near(from) }
}

/// A list of any format, with numbers that are small mostly.
fn list(from: &mut Bytes<'_>) -> ListValue {
    let numbers = |from: &mut Bytes<'_>| {
        let count = 6 + usize::from(from.byte() % 64);
        let bytes: Vec<u8> = (0..count)
            .flat_map(|_| {
                if from.byte() < 200 { from.half() >> 6 } else { from.half() & 15 }.to_le_bytes()
            })
            .collect();
        bytes.into()
    };
    ListValue {
        vertex_format: i32::from(from.byte() & 3),
        index_format: i32::from(from.byte() & 7),
        vertices: numbers(from),
        indices: {
            let count = 6 + usize::from(from.byte() % 64);
            let bytes: Vec<u8> =
                (0..count).flat_map(|_| u16::from(from.byte() & 15).to_le_bytes()).collect();
            bytes.into()
        },
        commands: (0..from.byte() % 4)
            .flat_map(|_| [u16::from(from.byte() & 31), u16::from(from.byte() & 3)])
            .collect(),
        states: (0..from.byte() % 4).map(|_| state(from)).collect(),
    }
}
