//! Streams of RRedline's words and calls from bytes.

use fillrate_call::{Decoder, Tagged, Value};
use fillrate_engine::DeviceConfig;
use fillrate_redline::stream::validate;
use fillrate_redline::surface::{PRIMARY, Z_BUFFER};
use fillrate_redline::vertex::Attribute;
use fillrate_redline::{
    Call, Chip, CommandBuffer, Context, NoMemory, Opcode, RedlineConfig, Register, Segment,
    Surface, VertexType, record,
};

use super::Bytes;

/// Columns and rows of the display.
const SIDE: u32 = 64;
/// Pixel formats by code.
const FORMATS: [u32; 12] = [0, 1, 2, 3, 4, 5, 6, 8, 9, 10, 12, 13];

/// A library with a device on the full screen, a display with depths and a
/// texture; their numbers.
struct Board {
    context: Context,
    device: u32,
    display: u32,
    buffer: u32,
    /// Address of the texture.
    texture: u32,
    /// The chip.
    chip: Chip,
    /// What installs destination, depths and texture.
    setup: Vec<u32>,
}

impl Board {
    fn new(chip: Chip, threads: usize) -> Board {
        let device = DeviceConfig { threads, ..DeviceConfig::default() };
        let config = RedlineConfig { chip, background: false, device, ..RedlineConfig::default() };
        let mut context = Context::new(config);
        let mut make = |call: &Call| context.execute(call).expect("it was free").number();
        let device = make(&Call::OpenVerite {});
        make(&Call::SetDisplayType { device, display_type: 2 });
        let (width, height) = (SIDE, SIDE);
        make(&Call::SetDisplayMode { device, width, height, bits: 16, refresh: 60 });
        let (mask, format) = (PRIMARY | Z_BUFFER, 4);
        let display =
            make(&Call::CreateSurface { device, mask, buffers: 3, format, width, height });
        let (mask, buffers) = (0, 2);
        let group = make(&Call::CreateSurface { device, mask, buffers, format, width, height });
        let buffer = make(&Call::CreateCmdBuffer { device, entries: 8, words: 4096 });
        let texture = context.group(device, group).and_then(|group| group.address(0));
        let texture = texture.expect("it was made");
        let setup = Vec::new();
        let mut board = Board { context, device, display, buffer, texture, chip, setup };
        board.install(group);
        board
    }

    /// Destination, depths and texture, whose texels are all different.
    fn install(&mut self, group: u32) {
        let surface = Surface::new(SIDE, SIDE, 4);
        let mut words = CommandBuffer::new(1, 8, 4096).expect("a valid size");
        let known = |group| self.context.group(self.device, group).expect("it was made").clone();
        let (display, texture) = (known(self.display), known(group));
        record::install_dst_buffer(&mut words, &surface, &display).expect("there is room");
        record::install_z_buffer(&mut words, &display).expect("there is room");
        record::install_texture_map(&mut words, &surface, &texture).expect("there is room");
        self.setup = vec![Opcode::ContextInit as u32];
        self.setup.extend_from_slice(words.words());
        let texels: Vec<u32> = (0..SIDE * SIDE / 2).map(|i| i.wrapping_mul(0x9e37_79b9)).collect();
        let place = [self.texture, texture.linebytes];
        record::mem_write_rect_inline(&mut words, place, [SIDE * 2, SIDE], &texels)
            .expect("there is room");
        let segments = words.snapshot(&NoMemory).expect("no memory is referred to");
        self.issue(segments);
    }

    fn issue(&mut self, segments: Vec<Segment>) {
        let (device, buffer) = (self.device, self.buffer);
        // Streams may be damaged.
        let _ =
            self.context.execute(&Call::IssueCmdBuffer { device, buffer, segments, wait: true });
    }

    /// A hash of the display's buffers.
    fn hash(&mut self) -> u64 {
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        let mut add = |byte: u64| hash = (hash ^ byte).wrapping_mul(0x0000_0100_0000_01b3);
        for buffer in 0..3 {
            let (device, group) = (self.device, self.display);
            let locked = self.context.execute(&Call::LockBuffer { device, group, buffer });
            let bytes = locked.map_or_else(|_| Vec::new(), |reply| reply.into_bytes());
            bytes.iter().for_each(|&byte| add(byte.into()));
        }
        assert_eq!(self.context.lost_commands(), 0, "no command breaks off");
        if let Some(shown) = self.context.shown() {
            shown.pixels.iter().for_each(|&pixel| add(pixel.into()));
        }
        hash
    }
}

fn chip(from: &mut Bytes<'_>) -> Chip {
    if from.byte() & 3 == 0 { Chip::V1000 } else { Chip::V2000 }
}

/// Issues streams of words and returns a hash of the display after each.
pub fn run_redline_words(bytes: &[u8], threads: usize) -> Vec<u64> {
    let mut from = Bytes::new(bytes);
    let mut board = Board::new(chip(&mut from), threads);
    let mut hashes = Vec::new();
    while !from.is_empty() {
        let mut words = Vec::new();
        if from.byte() & 1 == 0 {
            words.extend_from_slice(&board.setup);
        }
        let count = 1 + from.byte() % 32;
        redline_stream(&mut from, board.texture, board.chip, count, &mut words);
        board.issue(vec![Segment::of(&words)]);
        hashes.push(board.hash());
    }
    hashes
}

/// Runs a stream of calls and returns a hash of the display at the end.
pub fn run_redline_calls(bytes: &[u8], threads: usize) -> Vec<u64> {
    let mut from = Bytes::new(bytes);
    let mut board = Board::new(chip(&mut from), threads);
    while !from.is_empty() {
        let call = any_redline_call(&mut from, board.texture, board.chip);
        // Calls may be senseless.
        let _ = board.context.execute(&call);
    }
    vec![board.hash()]
}

/// Streams of commands: three of four hold only such that the board takes, their
/// words changed here and there, so that they draw; others hold anything, which
/// refuses them whole where one is wrong.
pub fn redline_stream(
    from: &mut Bytes<'_>,
    texture: u32,
    chip: Chip,
    count: u8,
    out: &mut Vec<u32>,
) {
    let anything = from.byte() & 3 == 0;
    for _ in 0..count {
        let first = out.len();
        any_redline_words(from, texture, out);
        if !anything && validate(&out[first..], chip).is_err() {
            out.truncate(first);
        }
    }
    if !anything {
        let first = out.len().min(1);
        (0..from.byte() % 8).for_each(|_| mutate(from, chip, first, out));
    }
}

/// Changes a word, mostly so that the stream stays valid.
fn mutate(from: &mut Bytes<'_>, chip: Chip, first: usize, words: &mut Vec<u32>) {
    if words.len() <= first {
        return;
    }
    let before = words.clone();
    let at = first + from.half() as u16 as usize % (words.len() - first);
    match from.byte() {
        0..192 => words[at] ^= 1 << (from.byte() & 31),
        192..224 => words[at] = from.word(),
        224..240 => words.truncate(at),
        _ => drop(words.remove(at)),
    }
    let kept = from.byte() < 8;
    if !kept && validate(words, chip).is_err() {
        *words = before;
    }
}

/// A command, or some of its words: plausible ones mostly.
pub fn any_redline_words(from: &mut Bytes<'_>, texture: u32, out: &mut Vec<u32>) {
    match from.byte() & 31 {
        0..=7 => primitive(from, out),
        8..=15 => state(from, texture, out),
        16..=17 => fast_triangle(from, out),
        18 => {
            let masks = (from.byte() as u32) << 16 | u32::from(from.byte());
            let sizes =
                [1 << (from.byte() % 8), 1 << (from.byte() % 8)].map(|side: u32| side << 16);
            let stride = u32::from(from.byte()) & 0x77;
            out.extend([0x4000, address(from, texture), stride, masks, sizes[0], sizes[1]]);
        }
        19 => {
            out.push(0x7020);
            out.extend((0..8).map(|_| from.word()));
        }
        20..=28 => two_dimensional(from, texture, out),
        29 => out.push(u32::from(from.byte())),
        30 => out.push(from.word()),
        _ => {
            // A known command with any words after it.
            let opcode = Opcode::ALL[usize::from(from.byte()) % Opcode::ALL.len()];
            out.push(u32::from(from.byte()) << 16 | opcode as u32);
            out.extend((0..from.byte() % 8).map(|_| from.word()));
        }
    }
}

/// A place on the display or not far from it, 16.16.
fn near(from: &mut Bytes<'_>) -> u32 {
    match from.byte() {
        0..4 => from.word(),
        _ => ((i32::from(from.half()) << 8) / 2).wrapping_add((SIDE << 15) as i32) as u32,
    }
}

fn address(from: &mut Bytes<'_>, texture: u32) -> u32 {
    match from.byte() {
        0..8 => from.word(),
        8..128 => texture,
        _ => texture.wrapping_add(from.half() as u32),
    }
}

fn attribute(from: &mut Bytes<'_>, attribute: Attribute) -> u32 {
    match attribute {
        Attribute::X | Attribute::Y => near(from),
        Attribute::Z => from.word() >> (from.byte() % 16),
        Attribute::U | Attribute::V => (i32::from(from.half()) << 3) as u32,
        Attribute::Q if from.byte() < 240 => 0x40_0000 | from.word() & 0x7f_ffff,
        Attribute::K | Attribute::Ka | Attribute::S | Attribute::Sf | Attribute::Q => from.word(),
        _ if from.byte() < 8 => from.word(),
        _ => u32::from(from.byte()) << 16,
    }
}

fn vertices(from: &mut Bytes<'_>, vertex: VertexType, count: u32, out: &mut Vec<u32>) {
    for _ in 0..count {
        for &word in vertex.attributes() {
            out.push(attribute(from, word));
        }
    }
}

fn primitive(from: &mut Bytes<'_>, out: &mut Vec<u32>) {
    const KINDS: [Opcode; 16] = [
        Opcode::Triangle,
        Opcode::Triangle,
        Opcode::Triangle,
        Opcode::Triangle,
        Opcode::Tristrip,
        Opcode::Trifan,
        Opcode::Line,
        Opcode::Polyline,
        Opcode::Dot,
        Opcode::Square,
        Opcode::Rectangle,
        Opcode::Span,
        Opcode::AALine,
        Opcode::AAEdge,
        Opcode::Triangle,
        Opcode::Triangle,
    ];
    let opcode = match from.byte() {
        240.. => Opcode::Palette,
        kind => KINDS[usize::from(kind & 15)],
    };
    let vertex = VertexType::ALL[usize::from(from.byte()) % VertexType::ALL.len()];
    out.push(vertex.code() << 16 | opcode as u32);
    let count = u32::from(from.byte() % 4);
    let (head, vertices_there): (&[u32], u32) = match opcode {
        Opcode::Tristrip => (&[count + 1], count + 3),
        Opcode::Trifan => (&[count + 3], count + 3),
        Opcode::Polyline => (&[count + 1], count + 2),
        Opcode::Square => (&[near(from)], 1),
        Opcode::Rectangle => (&[near(from), near(from)], 1),
        Opcode::Dot => (&[], 1),
        Opcode::Triangle => (&[], 3),
        _ => (&[], 2),
    };
    out.extend(head);
    vertices(from, vertex, vertices_there, out);
}

fn fast_triangle(from: &mut Bytes<'_>, out: &mut Vec<u32>) {
    use Attribute::{K, Q, S, U, V, X, Y, Z};
    let (opcode, words): (_, &[Attribute]) = match from.byte() & 7 {
        0 | 4 => (Opcode::FtriKxyz, &[K, X, Y, Z]),
        1 | 5 => (Opcode::FtriKsxyzuvq, &[K, S, X, Y, Z, U, V, Q]),
        // Fog in place of the second colour: any word will do.
        2 | 6 => (Opcode::FtriKfxyzuvq, &[K, S, X, Y, Z, U, V, Q]),
        3 => (Opcode::FtriKxyzuvq, &[K, X, Y, Z, U, V, Q]),
        _ => (Opcode::FtriKsxyz, &[K, S, X, Y, Z]),
    };
    out.push(opcode as u32);
    for _ in 0..3 {
        for &word in words {
            out.push(attribute(from, word));
        }
    }
}

/// A register with one of its values mostly, anything now and then.
fn state(from: &mut Bytes<'_>, texture: u32, out: &mut Vec<u32>) {
    let register = Register::ALL[usize::from(from.byte()) % Register::ALL.len()];
    let byte = u32::from(from.byte());
    let value = match register {
        _ if byte < 6 => from.word(),
        // The destination stays mostly.
        Register::DstBase | Register::DstStride | Register::ZBase | Register::ZStride
            if byte < 200 =>
        {
            return;
        }
        Register::SrcBase | Register::DstBase | Register::ZBase => address(from, texture),
        Register::SrcStride | Register::DstStride | Register::ZStride => byte & 0x77,
        Register::SrcFmt | Register::DstFmt => FORMATS[byte as usize % FORMATS.len()],
        Register::SrcFunc => byte & 3,
        Register::AluMode => byte & 15,
        Register::BlendSrcFunc | Register::BlendDstFunc => byte % 10,
        Register::ZBufMode => byte % 7,
        // As far as the destination's pitch and memory go, in windows.
        Register::ScissorX | Register::ScissorY if byte >= 248 => 0xffff,
        Register::ScissorX | Register::ScissorY => (byte & 31) << 16 | (byte >> 2),
        Register::UMask | Register::VMask => byte,
        Register::UMultiplier | Register::VMultiplier => 1 << (12 + byte % 12),
        Register::SOffset | Register::TOffset => (byte << 24) as i32 as u32 >> 16,
        Register::PatLengthM1 => byte & 31,
        Register::DitherOffset => byte & 0x33,
        Register::Z | Register::A | Register::R | Register::G | Register::B | Register::F => {
            byte << 16
        }
        _ if byte & 1 == 0 => from.word(),
        _ => byte >> 1 & 1,
    };
    let mask = if from.byte() < 8 { from.word() << 16 } else { 0 };
    out.extend([register.word() | mask, value]);
}

fn pair(from: &mut Bytes<'_>) -> u32 {
    match from.byte() {
        0..4 => from.word(),
        _ => u32::from(from.byte() % 80) << 16 | u32::from(from.byte() % 80),
    }
}

fn small(from: &mut Bytes<'_>) -> u32 {
    if from.byte() < 4 { from.word() } else { u32::from(from.byte() % 32) }
}

fn two_dimensional(from: &mut Bytes<'_>, texture: u32, out: &mut Vec<u32>) {
    const KINDS: [Opcode; 16] = [
        Opcode::Bitblt,
        Opcode::Bitfill,
        Opcode::MemClearRect,
        Opcode::MemWrite,
        Opcode::MemWriteRect,
        Opcode::MemWriteSprite,
        Opcode::Particles,
        Opcode::TriFill,
        Opcode::Affine,
        Opcode::Warp,
        Opcode::Lookup,
        Opcode::BitbltMem,
        Opcode::CompositeRect,
        Opcode::IntLine,
        Opcode::Display,
        Opcode::IntPolyline,
    ];
    let opcode = match from.byte() {
        240.. => Opcode::Palette,
        kind => KINDS[usize::from(kind & 15)],
    };
    let first = out.len();
    out.push(u32::from(from.byte() & 1) << 16 | opcode as u32);
    match opcode {
        Opcode::Bitblt => out.extend([pair(from), pair(from), pair(from)]),
        Opcode::MemClearRect => {
            let pitch = u32::from(from.byte());
            out.extend([address(from, texture), pitch, small(from), small(from), from.word()]);
        }
        Opcode::MemWrite => out.extend([address(from, texture), small(from)]),
        Opcode::MemWriteRect => {
            out.extend([address(from, texture), 128, small(from), small(from)]);
        }
        Opcode::MemWriteSprite => {
            let format = FORMATS[usize::from(from.byte()) % FORMATS.len()];
            out.extend([address(from, texture), format]);
            for _ in 0..from.byte() % 4 {
                let bytes = u32::from(from.byte() % 16);
                out.push(u32::from(from.byte()) << 16 | bytes | 1);
                out.extend((0..(bytes | 1).div_ceil(4)).map(|_| from.word()));
            }
            out.push(0);
            return;
        }
        Opcode::Particles => {
            let count = u32::from(from.byte() % 6);
            out.push(count);
            for _ in 0..count {
                out.extend([pair(from), pair(from), from.word(), from.word()]);
            }
            return;
        }
        Opcode::TriFill => out.extend((0..6).map(|_| near(from))),
        Opcode::Affine => {
            out.extend((0..6).map(|_| near(from)));
            out.extend((0..4).map(|_| (i32::from(from.half()) << 4) as u32));
        }
        Opcode::Warp => out.extend([pair(from), small_size(from), from.word(), from.word()]),
        Opcode::Lookup => out.extend([pair(from), small_size(from)]),
        Opcode::BitbltMem => {
            let bytes = [1, 2, 4, 3][usize::from(from.byte() & 3)];
            let width = u32::from(from.byte() % 32);
            let (row, rows) = ((width * bytes).div_ceil(4), u32::from(from.byte() % 16));
            out.extend([pair(from), row << 16 | rows, width << 16 | bytes]);
        }
        Opcode::CompositeRect => {
            let format = FORMATS[usize::from(from.byte()) % FORMATS.len()];
            out.extend([format, pair(from), small_size(from)]);
            out.extend((0..4).map(|_| near(from)));
        }
        Opcode::IntPolyline => {
            let segments = 1 + u32::from(from.byte() % 4);
            out.push(segments);
            out.extend((0..=segments).map(|_| pair(from)));
            return;
        }
        Opcode::Palette => out.extend([0, small(from)]),
        Opcode::Display => out.push(address(from, texture)),
        _ => out.extend([pair(from), pair(from)]),
    }
    data(from, first, out);
}

fn small_size(from: &mut Bytes<'_>) -> u32 {
    u32::from(from.byte() % 24) << 16 | u32::from(from.byte() % 24)
}

/// The words that a command still lacks, up to a bound: a pattern.
fn data(from: &mut Bytes<'_>, first: usize, out: &mut Vec<u32>) {
    use fillrate_redline::stream::StreamErrorKind;
    let pattern = [from.word(), from.word(), from.word()];
    for _ in 0..4 {
        let lacking = fillrate_redline::stream::validate(&out[first..], Chip::V2000);
        let Err(error) = lacking else { return };
        let StreamErrorKind::Incomplete { needed, left } = error.kind else { return };
        let more = needed.saturating_sub(left as u64).min(4096) as usize;
        out.extend(pattern.iter().copied().cycle().take(more));
    }
}

/// A call with plausible numbers mostly, any now and then.
pub fn any_redline_call(from: &mut Bytes<'_>, texture: u32, chip: Chip) -> Call {
    let device = 1;
    let group = u32::from(from.byte() % 6);
    let buffer = u32::from(from.byte() % 4);
    let rect = |from: &mut Bytes<'_>| {
        let mut side = || i32::from(from.byte()) - 32;
        fillrate_redline::Rect { left: side(), top: side(), right: side(), bottom: side() }
    };
    match from.byte() & 31 {
        0..=9 => {
            let mut words = Vec::new();
            let count = 1 + from.byte() % 8;
            redline_stream(from, texture, chip, count, &mut words);
            let port = if from.byte() < 32 { from.byte() % 5 } else { 0 };
            let segments = vec![Segment { port, ..Segment::of(&words) }];
            let buffer = if from.byte() < 240 { 3 } else { buffer };
            Call::IssueCmdBuffer { device, buffer, segments, wait: from.byte() & 1 == 0 }
        }
        10..=13 => Call::CreateSurface {
            device,
            mask: u32::from(from.byte() & 7),
            buffers: u32::from(from.byte() % 4),
            format: FORMATS[usize::from(from.byte()) % FORMATS.len()],
            width: small(from).wrapping_mul(2),
            height: small(from).wrapping_mul(4),
        },
        14 => Call::DestroySurface { device, group },
        15 => Call::LockBuffer { device, group, buffer },
        16 => Call::UnlockBuffer { device, group, buffer, changes: from.data() },
        17 => Call::SwapBuffers { device, group, a: buffer, b: u32::from(from.byte() % 4) },
        18 | 19 => {
            let (dst, src) = (Some(rect(from)), (from.byte() & 1 == 0).then(|| rect(from)));
            let (dst_buffer, src_buffer) = (buffer, u32::from(from.byte() % 3));
            let src_group = u32::from(from.byte() % 6);
            Call::BltDisplayBuffer {
                device,
                dst_group: group,
                dst_buffer,
                dst,
                src_group,
                src_buffer,
                src,
            }
        }
        20 => Call::ReadBuffer {
            device,
            group,
            buffer,
            x: small(from),
            y: small(from),
            width: small(from),
            height: small(from),
        },
        21 => Call::SetDisplayType { device, display_type: 1 + u32::from(from.byte() % 3) },
        22 => Call::RestoreSurface { device, group },
        23 => Call::LoseBuffers { device },
        25 => Call::StoreBuffer { device, group, buffer, changes: from.data() },
        24 => Call::SetWindow { device, window: Some(rect(from)) },
        _ => decoded(from).unwrap_or(Call::SetUserPrivate { device, value: 1 }),
    }
}

/// A call of any tag, decoded from words in a row.
fn decoded(from: &mut Bytes<'_>) -> Option<Call> {
    let variants = Call::VARIANTS;
    let mut bytes = variants[usize::from(from.byte()) % variants.len()].0.to_le_bytes().to_vec();
    bytes.extend(1u32.to_le_bytes());
    bytes.extend((0..12).flat_map(|_| small(from).to_le_bytes()));
    // The lengths of calls differ: the rest of the words is not read.
    Call::decode(&mut Decoder::new(&bytes)).ok()
}
