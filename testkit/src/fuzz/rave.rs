//! Streams of RAVE's calls from bytes.

use fillrate_call::{Data, Decoder, Tagged, Value};
use fillrate_engine::DeviceConfig;
use fillrate_rave::memory::{EngineKind, MemoryConfig};
use fillrate_rave::{
    Call, Context, DeviceValue, ImageValue, IndexedTriangle, PixelType, RaveConfig, RaveRect,
    VGouraud, VMultiTexture, VTexture, constants,
};

use super::Bytes;

/// The engine that most calls name.
const ENGINE: u32 = 1;
/// The context that most calls name: the first object of a stream.
const CONTEXT: u32 = 1;
const WIDTH: i32 = 64;
const HEIGHT: i32 = 48;

/// Runs a stream of calls and returns the hash of each frame it shows.
pub fn run_rave(bytes: &[u8], threads: usize) -> Vec<u64> {
    let first = bytes.first().copied().unwrap_or(0);
    let mut context = library(first, threads);
    for call in start() {
        context.execute(&call);
    }
    let mut from = Bytes::new(bytes);
    let mut frames = Vec::new();
    let calls = std::iter::from_fn(|| (!from.is_empty()).then(|| any_rave_call(&mut from)));
    for call in calls.chain([Call::RenderEnd { context: CONTEXT, modified: None }]) {
        let shows = matches!(call, Call::RenderEnd { .. } | Call::SwapBuffers { .. });
        context.execute(&call);
        if shows && let Some(shown) = context.shown() {
            let hash = |hash: u64, &byte: &u8| {
                (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
            };
            frames.push(shown.pixels.iter().fold(0xcbf2_9ce4_8422_2325, hash));
        }
    }
    frames
}

/// A library with little texture memory, of any kind.
fn library(first: u8, threads: usize) -> Context {
    let kinds = [
        EngineKind::Separate,
        EngineKind::VideoOnly,
        EngineKind::VideoOnlyUntilFrameEnd,
        EngineKind::Separate,
    ];
    Context::new(RaveConfig {
        device: DeviceConfig { threads, ..DeviceConfig::default() },
        // A thread for each stream would be most of the time.
        asynchronous: false,
        memory: MemoryConfig {
            kind: kinds[usize::from(first >> 1 & 3)],
            video_bytes: 1 << (10 + (first >> 3 & 7)),
            host_bytes: 1 << 20,
            ..MemoryConfig::default()
        },
        as_apple_software: false,
    })
}

/// What a stream starts with: objects 1 to 6, and a frame.
fn start() -> [Call; 8] {
    let new = |pixel_type: PixelType, flags| Call::DrawContextNew {
        engine: ENGINE,
        device: DeviceValue {
            device_type: constants::device::MEMORY,
            pixel_type: pixel_type.number(),
            width: WIDTH,
            height: HEIGHT,
            row_bytes: WIDTH * 4,
        },
        rect: RaveRect::new(0, 0, WIDTH, HEIGHT),
        scaled: None,
        clip: None,
        flags,
    };
    let image = || ImageValue { width: 8, height: 8, pixels: vec![0x9c; 256].into() };
    let argb = PixelType::Argb32.number();
    let table = Call::ColorTableNew {
        engine: ENGINE,
        table_type: constants::color_table::CL8_RGB32,
        entries: (0..1024).map(|i| i as u8).collect::<Vec<u8>>().into(),
        transparent_index: 1,
    };
    [
        new(PixelType::Argb32, constants::context::DOUBLE_BUFFER),
        new(PixelType::Argb32, constants::context::DOUBLE_BUFFER | constants::context::CACHE),
        new(PixelType::Rgb16, 0),
        Call::TextureNew { engine: ENGINE, flags: 0, pixel_type: argb, images: vec![image()] },
        Call::BitmapNew { engine: ENGINE, flags: 0, pixel_type: argb, image: image() },
        table,
        Call::RenderStart { context: CONTEXT, dirty: None, initial: 0 },
        Call::SetTexture { context: CONTEXT, tag: 13, texture: 4 },
    ]
}

/// A call whose arguments follow from bytes: plausible ones mostly, anything
/// else now and then.
pub fn any_rave_call(from: &mut Bytes<'_>) -> Call {
    let context = context_number(from);
    match from.byte() & 63 {
        0..=5 => Call::DrawTriGouraud {
            context,
            a: gouraud(from),
            b: gouraud(from),
            c: gouraud(from),
            flags: 0,
        },
        6..=11 => Call::DrawTriTexture {
            context,
            a: texture(from),
            b: texture(from),
            c: texture(from),
            flags: 1,
        },
        12..=13 => Call::DrawVGouraud {
            context,
            mode: u32::from(from.byte() % 7),
            vertices: (0..from.byte() & 7).map(|_| gouraud(from)).collect(),
            flags: None,
        },
        14..=15 => Call::DrawVTexture {
            context,
            mode: u32::from(from.byte() % 7),
            vertices: (0..from.byte() & 7).map(|_| texture(from)).collect(),
            flags: None,
        },
        16 => Call::DrawPoint { context, v: gouraud(from) },
        17 => Call::DrawLine { context, a: gouraud(from), b: gouraud(from) },
        18..=20 => Call::DrawBitmap { context, v: gouraud(from), bitmap: object(from) },
        21 => Call::SubmitVerticesGouraud {
            context,
            vertices: (0..from.byte() & 15).map(|_| gouraud(from)).collect(),
        },
        22 => Call::SubmitVerticesTexture {
            context,
            vertices: (0..from.byte() & 15).map(|_| texture(from)).collect(),
        },
        23 => Call::DrawTriMeshGouraud { context, triangles: triangles(from) },
        24 => Call::DrawTriMeshTexture { context, triangles: triangles(from) },
        25 => Call::SubmitMultiTextureParams {
            context,
            layer: u32::from(from.byte() & 3),
            params: (0..from.byte() & 7)
                .map(|_| VMultiTexture {
                    inv_w: from.float(),
                    u_over_w: from.float(),
                    v_over_w: from.float(),
                })
                .collect(),
        },
        26..=35 => Call::SetInt { context, tag: int_tag(from), value: from.int() as u32 },
        36..=38 => Call::SetFloat { context, tag: float_tag(from), value: unit(from) },
        39..=40 => Call::SetTexture { context, tag: pointer_tag(from), texture: object(from) },
        41 => Call::RenderStart { context, dirty: rect(from), initial: initial(from) },
        42 => Call::RenderEnd { context, modified: rect(from) },
        43 => Call::Sync { context },
        44..=46 => new_texture(from),
        47 => new_bitmap(from),
        48..=49 => Call::TextureDelete { engine: ENGINE, texture: object(from) },
        50 => Call::BitmapDelete { engine: ENGINE, bitmap: object(from) },
        51 => Call::ClearDrawBuffer { context, rect: rect(from), initial: initial(from) },
        52 => Call::ClearZBuffer { context, rect: rect(from), initial: initial(from) },
        53 => access(from, context),
        54 => new_context(from),
        55 => Call::TextureBindColorTable { engine: ENGINE, texture: object(from), table: 6 },
        56 => Call::TextureFromContext { context, flags: u32::from(from.byte()) },
        57 => Call::BitmapFromContext { context, flags: u32::from(from.byte()) },
        58 => Call::SetNoticeMethod {
            context,
            selector: u32::from(from.byte() & 7),
            installed: from.byte() & 1 == 1,
        },
        _ => decoded(from).unwrap_or(Call::Flush { context }),
    }
}

/// A call of any tag, decoded from words in a row.
fn decoded(from: &mut Bytes<'_>) -> Option<Call> {
    let variants = Call::VARIANTS;
    let pick = usize::from(from.byte()) | usize::from(from.byte()) << 8;
    let mut bytes = variants[pick % variants.len()].0.to_le_bytes().to_vec();
    bytes.extend(u32::from(1 + from.byte() % 4).to_le_bytes());
    bytes.extend((0..40).flat_map(|_| from.int().to_le_bytes()));
    // The lengths of calls differ: the rest of the words is not read.
    Call::decode(&mut Decoder::new(&bytes)).ok()
}

fn context_number(from: &mut Bytes<'_>) -> u32 {
    match from.byte() {
        0..=207 => CONTEXT,
        k @ 208..=247 => u32::from(k % 4),
        _ => from.word(),
    }
}

fn object(from: &mut Bytes<'_>) -> u32 {
    match from.byte() {
        k @ 0..=247 => u32::from(k % 24),
        _ => from.word(),
    }
}

fn initial(from: &mut Bytes<'_>) -> u32 {
    if from.byte() < 64 { 2 } else { 0 }
}

/// A coordinate on the screen or not far from it.
fn near(from: &mut Bytes<'_>) -> f32 {
    match from.byte() {
        k @ 0..=239 => f32::from(k) * 0.375 - 8.0 + f32::from(from.byte() & 15) / 16.0,
        _ => from.float(),
    }
}

/// A number of 0..=1 mostly.
fn unit(from: &mut Bytes<'_>) -> f32 {
    match from.byte() {
        k @ 0..=239 => f32::from(k) / 239.0,
        _ => from.float(),
    }
}

fn gouraud(from: &mut Bytes<'_>) -> VGouraud {
    let [x, y] = [near(from), near(from)];
    let [z, inv_w, r, g, b, a] = std::array::from_fn(|_| unit(from));
    VGouraud { x, y, z, inv_w, r, g, b, a }
}

fn texture(from: &mut Bytes<'_>) -> VTexture {
    let [x, y] = [near(from), near(from)];
    let [z, inv_w, r, g, b, a] = std::array::from_fn(|_| unit(from));
    let [u_over_w, v_over_w] = [near(from) / 16.0, near(from) / 16.0];
    let light = unit(from) * 2.0;
    let shine = unit(from);
    VTexture {
        x,
        y,
        z,
        inv_w,
        r,
        g,
        b,
        a,
        u_over_w,
        v_over_w,
        kd_r: light,
        kd_g: unit(from),
        kd_b: light,
        ks_r: shine,
        ks_g: 0.0,
        ks_b: shine,
    }
}

fn triangles(from: &mut Bytes<'_>) -> Vec<IndexedTriangle> {
    let corner = |from: &mut Bytes<'_>| u32::from(from.byte() & 15);
    (0..from.byte() & 7)
        .map(|_| IndexedTriangle { flags: 0, vertices: std::array::from_fn(|_| corner(from)) })
        .collect()
}

/// A tag that a state has, of integers mostly.
fn int_tag(from: &mut Bytes<'_>) -> u32 {
    const USUAL: [u32; 30] = [
        0, 8, 9, 10, 11, 11, 12, 16, 17, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 101, 101,
        102, 103, 104, 109, 110, 111, 149,
    ];
    match from.byte() {
        k @ 0..=239 => USUAL[usize::from(k) % USUAL.len()],
        _ => u32::from(from.unsigned_half()) % 1100,
    }
}

/// A tag that a state has, of floats mostly.
fn float_tag(from: &mut Bytes<'_>) -> u32 {
    const USUAL: [u32; 24] = [
        1, 2, 5, 18, 19, 22, 23, 24, 25, 41, 42, 43, 46, 47, 49, 51, 52, 53, 112, 113, 114, 115,
        116, 150,
    ];
    match from.byte() {
        k @ 0..=191 => USUAL[usize::from(k) % USUAL.len()],
        k => u32::from(k) ^ u32::from(from.byte()),
    }
}

fn pointer_tag(from: &mut Bytes<'_>) -> u32 {
    [13, 13, 13, 26][usize::from(from.byte() & 3)]
}

fn rect(from: &mut Bytes<'_>) -> Option<RaveRect> {
    match from.byte() {
        0..=127 => None,
        128..=239 => {
            let mut side = || i32::from(from.byte() & 63);
            Some(RaveRect::new(side(), side(), side(), side()))
        }
        _ => Some(RaveRect::new(from.int(), from.int(), from.int(), from.int())),
    }
}

/// A picture whose pixels fit its size mostly.
fn image(from: &mut Bytes<'_>, pixel_type: PixelType, [width, height]: [i32; 2]) -> ImageValue {
    let pattern = from.data();
    let row = pixel_type.row_bytes(width.clamp(0, 256) as u32);
    let bytes = row * height.clamp(0, 256) as usize;
    let byte = |i: usize| pattern.get(i % pattern.len().max(1)).copied().unwrap_or(0);
    let odd = usize::from(from.byte() >= 248);
    let pixels: Data = (0..bytes - odd.min(bytes)).map(byte).collect::<Vec<u8>>().into();
    ImageValue { width, height, pixels }
}

fn pixel_type(from: &mut Bytes<'_>) -> PixelType {
    let all = PixelType::ALL;
    all[usize::from(from.byte()) % all.len()]
}

fn side(from: &mut Bytes<'_>) -> i32 {
    match from.byte() {
        k @ 0..=223 => 1 << (k % 6),
        k @ 224..=247 => i32::from(k) - 226,
        _ => from.int(),
    }
}

fn new_texture(from: &mut Bytes<'_>) -> Call {
    let (pixel_type, mut size) = (pixel_type(from), [side(from), side(from)]);
    let is_mipmapped = from.byte() & 3 == 0;
    let mut images = Vec::new();
    for _ in 0..12 {
        images.push(image(from, pixel_type, size));
        if !is_mipmapped || size.iter().all(|&side| side <= 1) {
            break;
        }
        size = size.map(|side| (side / 2).max(1));
    }
    let flags = u32::from(from.byte() & 0x41) | u32::from(is_mipmapped) << 1;
    Call::TextureNew { engine: ENGINE, flags, pixel_type: pixel_type.number(), images }
}

fn new_bitmap(from: &mut Bytes<'_>) -> Call {
    let pixel_type = pixel_type(from);
    let size = [i32::from(from.byte() & 31), i32::from(from.byte() & 31)];
    let image = image(from, pixel_type, size);
    let flags = u32::from(from.byte() & 0x42);
    Call::BitmapNew { engine: ENGINE, flags, pixel_type: pixel_type.number(), image }
}

fn new_context(from: &mut Bytes<'_>) -> Call {
    let mut side = || i32::from(from.byte() & 127);
    let rect = RaveRect::new(side() & 7, side() & 7, side(), side());
    let scaled = RaveRect::new(0, 0, side(), side());
    let flags = u32::from(from.byte() & 0x7f);
    let is_scaled = flags & constants::context::SCALE != 0;
    Call::DrawContextNew {
        engine: ENGINE,
        device: DeviceValue {
            device_type: u32::from(from.byte() % 5),
            pixel_type: pixel_type(from).number(),
            width: 128,
            height: 128,
            row_bytes: 512,
        },
        rect,
        scaled: is_scaled.then_some(scaled),
        clip: (from.byte() < 64).then(|| vec![RaveRect::new(3, 3, 40, 20)]),
        flags,
    }
}

/// Access to something, and what the program wrote.
fn access(from: &mut Bytes<'_>, context: u32) -> Call {
    let all = RaveRect::new(0, 0, i32::from(from.byte() & 63), i32::from(from.byte() & 31));
    let rect = rect(from).unwrap_or(all);
    match from.byte() & 7 {
        0 => Call::AccessDrawBuffer { context },
        1 => Call::AccessDrawBufferEnd { context, rect, pixels: from.data() },
        2 => Call::AccessZBuffer { context },
        3 => Call::AccessZBufferEnd { context, rect, depths: from.data() },
        4 => Call::AccessTexture { engine: ENGINE, texture: object(from), level: 0, flags: 0 },
        5 => Call::AccessTextureEnd {
            engine: ENGINE,
            texture: object(from),
            rect,
            pixels: from.data(),
        },
        6 => Call::AccessBitmap { engine: ENGINE, bitmap: object(from), flags: 0 },
        _ => Call::AccessBitmapEnd {
            engine: ENGINE,
            bitmap: object(from),
            rect,
            pixels: from.data(),
        },
    }
}
