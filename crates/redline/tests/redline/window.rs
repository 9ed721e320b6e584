//! Destinations larger than 2048 columns or rows, which are drawn in windows: a
//! picture across their borders is the one that a small destination gets.

use fillrate_redline::surface::Z_BUFFER;
use fillrate_redline::vertex::Attribute;
use fillrate_redline::{
    Call, Chip, CommandBuffer, CommandSink, Context, NoMemory, Opcode, PixFmt, RedlineConfig,
    Register, Surface, VertexType, record,
};

use crate::board::config;
use crate::random::{Random, cases};

/// Columns and rows of a picture.
const SIDE: u32 = 128;

/// A destination without a display.
struct Sheet {
    context: Context,
    device: u32,
    group: u32,
    commands: CommandBuffer,
}

impl Sheet {
    fn new(format: PixFmt, [width, height]: [u32; 2], depth: bool) -> Sheet {
        let mut context = Context::new(RedlineConfig { memory: 8, ..config(Chip::V2000) });
        let device = context.execute(&Call::OpenVerite {}).unwrap().number();
        let (mask, buffers) = if depth { (Z_BUFFER, 2) } else { (0, 1) };
        let format = format.code();
        let create = Call::CreateSurface { device, mask, buffers, format, width, height };
        let group = context.execute(&create).unwrap().number();
        let mut commands = CommandBuffer::new(1, 16, 1 << 18).unwrap();
        let known = context.group(device, group).unwrap();
        let surface = Surface::new(width, height, format);
        record::install_dst_buffer(&mut commands, &surface, known).unwrap();
        if depth {
            record::install_z_buffer(&mut commands, known).unwrap();
            record::fill_buffer(&mut commands, known, 1, [0, 0], [width, height], 0x8000).unwrap();
        }
        let mut sheet = Sheet { context, device, group, commands };
        sheet.texture();
        sheet
    }

    /// A texture of 32 x 32 texels, all different.
    fn texture(&mut self) {
        let device = self.device;
        let (width, height, format) = (32, 32, PixFmt::Argb4444.code());
        let create = Call::CreateSurface { device, mask: 0, buffers: 1, format, width, height };
        let group = self.context.execute(&create).unwrap().number();
        let place = self.context.group(device, group).unwrap();
        let texels: Vec<u32> = (0..512u32).map(|i| i.wrapping_mul(0x9e37_79b9)).collect();
        let to = [place.addresses[0], place.linebytes];
        record::mem_write_rect_inline(&mut self.commands, to, [64, 32], &texels).unwrap();
        let surface = Surface::new(width, height, format);
        record::install_texture_map(&mut self.commands, &surface, place).unwrap();
    }

    /// Draws words and returns the bytes of a picture at a place, all buffers.
    fn draw(&mut self, words: &[u32], [x, y]: [u32; 2]) -> Vec<Vec<u8>> {
        self.commands.reserve(words.len(), 0).unwrap().copy_from_slice(words);
        let device = self.device;
        let create = Call::CreateCmdBuffer { device, entries: 16, words: 1 << 18 };
        let buffer = self.context.execute(&create).unwrap().number();
        let segments = self.commands.snapshot(&NoMemory).unwrap();
        let issue = Call::IssueCmdBuffer { device, buffer, segments, wait: true };
        self.context.execute(&issue).unwrap();
        let group = self.group;
        let count = self.context.group(device, group).unwrap().count();
        let (width, height) = (SIDE, SIDE);
        let read = |buffer| Call::ReadBuffer { device, group, buffer, x, y, width, height };
        (0..count).map(|buffer| self.context.execute(&read(buffer)).unwrap().into_bytes()).collect()
    }
}

/// Words of any primitive or state; coordinates count from `at`.
fn words(random: &mut Random, at: [u32; 2], out: &mut Vec<u32>) {
    match random.below(4) {
        0 | 1 => state(random, at, out),
        2 => primitive(random, at, out),
        _ => without_vertices(random, at, out),
    }
}

fn state(random: &mut Random, [x, y]: [u32; 2], out: &mut Vec<u32>) {
    let (flag, any) = (random.below(2), random.word());
    let (low, high) = (random.below(40), 88 + random.below(40));
    let (register, value) = match random.below(18) {
        0 => (Register::SrcFunc, any & 3),
        1 => (Register::SrcFilter, flag),
        2 => (Register::ZBufMode, any % 7),
        3 => (Register::ZBufWrMode, flag),
        4 => (Register::BlendEnable, flag),
        5 => (Register::BlendSrcFunc, any % 10),
        6 => (Register::BlendDstFunc, any % 8),
        7 => (Register::FogEnable, flag),
        8 => (Register::DitherEnable, flag),
        9 => (Register::DitherOffset, any & 0x33),
        10 => (Register::PatEnable, flag),
        11 => (Register::Pat, any),
        // Lengths that the distance of the pictures is a multiple of.
        12 => (Register::PatLengthM1, [31, 15, 7, 3][any as usize % 4]),
        13 => (Register::PatOpaque, flag),
        14 => (Register::PatOffset, any % 40),
        15 => (Register::ScissorX, (x + low) << 16 | (x + high)),
        16 => (Register::ScissorY, (y + low) << 16 | (y + high)),
        _ => (Register::FgColorArgb, any),
    };
    out.extend([register.word(), value]);
}

/// 16.16, on the picture or up to 60 pixels outside.
fn near(random: &mut Random, at: u32) -> u32 {
    (random.below((SIDE + 120) << 16).wrapping_sub(60 << 16)).wrapping_add(at << 16)
}

fn vertex(random: &mut Random, at: [u32; 2], of: &[Attribute], out: &mut Vec<u32>) {
    for attribute in of {
        out.push(match attribute {
            Attribute::X => near(random, at[0]),
            Attribute::Y => near(random, at[1]),
            Attribute::Z => random.word(),
            Attribute::U | Attribute::V => random.below(4 << 16).wrapping_sub(2 << 16),
            Attribute::Q => 0x40_0000 | random.word() & 0x7f_ffff,
            Attribute::K | Attribute::Ka | Attribute::S | Attribute::Sf => random.word(),
            _ => random.below(256 << 16),
        });
    }
}

fn primitive(random: &mut Random, at: [u32; 2], out: &mut Vec<u32>) {
    let kind = VertexType::ALL[random.below(VertexType::ALL.len() as u32) as usize];
    let (size, count) = (random.below(90 << 16), 1 + random.below(4));
    let (opcode, head, vertices): (_, &[u32], u32) = match random.below(13) {
        0..=3 => (Opcode::Triangle, &[], 3),
        4 => (Opcode::Tristrip, &[count], count + 2),
        5 => (Opcode::Trifan, &[count + 2], count + 2),
        6 => (Opcode::Line, &[], 2),
        7 => (Opcode::Polyline, &[count], count + 1),
        8 => (Opcode::AALine, &[], 2),
        9 => (Opcode::AAEdge, &[], 2),
        10 => (Opcode::Square, &[size], 1),
        11 => (Opcode::Rectangle, &[size, size / 2], 1),
        _ => (Opcode::Dot, &[], 1),
    };
    out.push(kind.code() << 16 | opcode as u32);
    out.extend(head);
    for _ in 0..vertices {
        vertex(random, at, kind.attributes(), out);
    }
}

/// Places of pixels are 16 bits each.
fn pair(random: &mut Random, [x, y]: [u32; 2]) -> u32 {
    (x + random.below(SIDE)) << 16 | (y + random.below(SIDE))
}

fn without_vertices(random: &mut Random, at: [u32; 2], out: &mut Vec<u32>) {
    let place = pair(random, at);
    let (width, height) = (1 + random.below(90), 1 + random.below(20));
    let size = width << 16 | height;
    match random.below(10) {
        0 => out.extend([Opcode::IntLine as u32 | 0x1_0000, place, pair(random, at)]),
        1 => {
            out.extend([Opcode::IntPolyline as u32, 3]);
            out.extend((0..4).map(|_| pair(random, at)));
        }
        2 => {
            out.push(Opcode::TriFill as u32);
            (0..6).for_each(|i| out.push(near(random, at[i % 2])));
        }
        3 => {
            out.extend([Opcode::Particles as u32, 2]);
            (0..2).for_each(|_| out.extend([pair(random, at), size, random.word(), random.word()]));
        }
        4 => {
            let at = at.map(|at| near(random, at));
            out.extend([Opcode::Affine as u32, at[0], at[1], 0, 0, width << 16, height << 16]);
            out.extend([4 << 16, 1 << 16, 2 << 16, 5 << 16]);
        }
        5 => {
            out.extend([Opcode::Warp as u32, place, size, 0, 0]);
            out.extend((0..width * height * 2).map(|i| i << 11));
        }
        6 => {
            out.extend([Opcode::Lookup as u32, place, size]);
            out.extend((0..width.div_ceil(4) * height).map(|_| random.word()));
        }
        7 => {
            let row = width.div_ceil(2);
            out.extend([Opcode::BitbltMem as u32, place, row << 16 | height, width << 16 | 2]);
            out.extend((0..row * height).map(|_| random.word()));
        }
        8 => {
            out.extend([Opcode::CompositeRect as u32, 4, place, size, 0, 0, 1 << 16, 1 << 16]);
            out.extend((0..width.div_ceil(2) * height).map(|_| random.word()));
        }
        _ => out.extend([Opcode::Bitfill as u32, place, size]),
    }
}

#[test]
fn large_destinations_are_drawn_across_windows() {
    let sheets: [(PixFmt, [u32; 2], bool, [u32; 2]); 4] = [
        (PixFmt::Rgb565, [2500, SIDE], true, [960, 0]),
        (PixFmt::Argb1555, [2300, SIDE], true, [1984, 0]),
        (PixFmt::Rgb565, [SIDE, 4200], true, [0, 1984]),
        (PixFmt::Rgb332, [2200, 2100], false, [1984, 960]),
    ];
    let mut drawn = 0;
    for case in 0..cases(120) {
        let (format, size, depth, at) = sheets[case as usize % sheets.len()];
        let pictures = [(size, at), ([SIDE, SIDE], [0, 0])].map(|(size, at)| {
            let mut random = Random::new(case);
            let scissor = [at[0] << 16 | (at[0] + SIDE), at[1] << 16 | (at[1] + SIDE)];
            let mut all = vec![Register::ScissorX.word(), scissor[0]];
            all.extend([Register::ScissorY.word(), scissor[1]]);
            (0..40).for_each(|_| words(&mut random, at, &mut all));
            Sheet::new(format, size, depth).draw(&all, at)
        });
        let [large, small] = &pictures;
        assert!(large == small, "case {case}");
        drawn += usize::from(large[0].iter().any(|&byte| byte != 0));
    }
    assert!(drawn > 0);
}

/// What is larger than the engine's coordinates is drawn in all windows, to the
/// last pixel.
#[test]
fn large_triangles_reach_everywhere() {
    let (width, height) = (2600, 2100);
    let mut sheet = Sheet::new(PixFmt::Gray8, [width, height], false);
    let right = width << 16;
    let down = height << 16;
    let word = Opcode::TriFill as u32;
    let upper = [word, 0, 0, right, 0, right, down];
    let lower = [word, 0, 0, right, down, 0, down];
    let words = [[Register::FgColorArgb.word(), u32::MAX].as_slice(), &upper, &lower].concat();
    for at in [[0, 0], [width - SIDE, height - SIDE], [1980, 1000], [2000, 0], [0, 1972]] {
        let pictures = sheet.draw(&words, at);
        assert!(pictures[0].iter().all(|&byte| byte == 255), "{at:?}");
        sheet.commands.reset();
    }
}
