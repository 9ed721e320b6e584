//! What a stream of commands would have taken on the chip.
//!
//! The guide gives three rates for each chip: cycles of set-up for an attribute
//! of the vertex type, cycles for a scan line, cycles for a pixel. [`Estimator`]
//! applies them to primitives, clipped to the scissor, one by one. What the
//! guide gives no rate for has one of ours; see `docs/sources.md`.
//!
//! The rates are peak rates. Bytes of video memory that are read and written
//! are counted beside them: depths, blending and textures need them on both
//! chips, and a frame cannot take less than they do.
//!
//! Source: RR, choosing a vertex type, VL_Lookup, speed of light.

use crate::board::Chip;
use crate::format::PixFmt;
use crate::opcode::{Opcode, Register};
use crate::stream::{Command, Commands};
use crate::vertex::{Attribute, VertexType};

/// Cycles of one chip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rates {
    /// Set-up, for each attribute.
    pub setup: u64,
    /// A scan line, for each attribute.
    pub line_attribute: u64,
    /// A scan line, besides.
    pub line: u64,
    /// Attributes of a pixel that take a cycle together; 0 where a pixel takes
    /// one cycle whatever it has.
    pub attributes_a_cycle: u64,
    /// Megahertz.
    pub clock: f64,
}

impl Rates {
    /// The guide's rates. Clocks are those of a V1000 and of a V2200.
    pub fn of(chip: Chip) -> Rates {
        match chip {
            Chip::V1000 => {
                Rates { setup: 20, line_attribute: 2, line: 0, attributes_a_cycle: 2, clock: 50.0 }
            }
            Chip::V2000 => {
                Rates { setup: 10, line_attribute: 0, line: 1, attributes_a_cycle: 0, clock: 60.0 }
            }
        }
    }

    /// Cycles of a pixel.
    pub fn pixel(&self, attributes: u64) -> u64 {
        match self.attributes_a_cycle {
            0 => 1,
            together => attributes.div_ceil(together).max(1),
        }
    }
}

/// Cycles of a pixel of `VL_Lookup`.
const LOOKUP: u64 = 3;
/// Bytes of video memory that a cycle moves: the bus has 64 bits.
pub const BYTES_A_CYCLE: u64 = 8;

/// Cycles, and what they are for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Triangles, lines, rectangles and so on.
    pub primitives: u64,
    /// Scan lines that they cover.
    pub lines: u64,
    /// Pixels that they cover.
    pub pixels: u64,
    /// Cycles of set-up.
    pub setup_cycles: u64,
    /// Cycles of scan lines.
    pub line_cycles: u64,
    /// Cycles of pixels.
    pub pixel_cycles: u64,
    /// Bytes of video memory read or written.
    pub bytes: u64,
}

impl Work {
    /// All cycles, memory left out.
    pub fn cycles(&self) -> u64 {
        self.setup_cycles.saturating_add(self.line_cycles).saturating_add(self.pixel_cycles)
    }

    /// Cycles that memory needs at least.
    pub fn memory_cycles(&self) -> u64 {
        self.bytes.div_ceil(BYTES_A_CYCLE)
    }
}

impl std::ops::AddAssign for Work {
    /// Saturates: a command may speak of more memory than there is.
    fn add_assign(&mut self, other: Work) {
        let add = |sum: &mut u64, more: u64| *sum = sum.saturating_add(more);
        add(&mut self.primitives, other.primitives);
        add(&mut self.lines, other.lines);
        add(&mut self.pixels, other.pixels);
        add(&mut self.setup_cycles, other.setup_cycles);
        add(&mut self.line_cycles, other.line_cycles);
        add(&mut self.pixel_cycles, other.pixel_cycles);
        add(&mut self.bytes, other.bytes);
    }
}

/// What one command takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Estimate {
    /// The command's name.
    pub command: &'static str,
    /// The vertex type's name, for those with one.
    pub vertex: Option<&'static str>,
    /// Attributes that are set up.
    pub attributes: u64,
    /// What it takes.
    pub work: Work,
}

/// Attributes of a vertex type: a packed colour counts as its channels.
pub fn attributes(vertex: VertexType) -> u64 {
    let count = |attribute: &Attribute| match attribute {
        Attribute::K | Attribute::S => 3,
        Attribute::Ka | Attribute::Sf => 4,
        _ => 1,
    };
    vertex.attributes().iter().map(count).sum()
}

/// Estimates commands, whose state it follows.
#[derive(Clone, Debug)]
pub struct Estimator {
    chip: Chip,
    rates: Rates,
    /// Left, right, top, bottom.
    scissor: [f64; 4],
    textured: bool,
    bilinear: bool,
    blends: bool,
    reads_depth: bool,
    writes_depth: bool,
    source_bytes: u64,
    destination_bytes: u64,
}

/// Bytes of a pixel, a half byte counted as one.
fn pixel_bytes(code: u32) -> u64 {
    PixFmt::from_code(code).map_or(2, |format| u64::from(format.bytes().max(1)))
}

/// 16.16 as a number.
fn fixed(value: u32) -> f64 {
    f64::from(value as i32) / 65536.0
}

impl Estimator {
    /// The chip as it is after power-on.
    pub fn new(chip: Chip, rates: Rates) -> Estimator {
        Estimator {
            chip,
            rates,
            scissor: [0.0, 2048.0, 0.0, 2048.0],
            textured: false,
            bilinear: false,
            blends: false,
            reads_depth: false,
            writes_depth: false,
            source_bytes: 2,
            destination_bytes: 2,
        }
    }

    /// The rates in use.
    pub fn rates(&self) -> &Rates {
        &self.rates
    }

    /// Estimates the commands of a stream; ends where it is damaged.
    pub fn stream(&mut self, words: &[u32], mut each: impl FnMut(Estimate)) {
        for command in Commands::new(words, self.chip).map_while(Result::ok) {
            if let Some(estimate) = self.command(&command) {
                each(estimate);
            }
        }
    }

    /// Estimates a command; `None` for state and what takes no time worth
    /// counting.
    pub fn command(&mut self, command: &Command<'_>) -> Option<Estimate> {
        match command {
            Command::State { register, value, .. } => {
                self.set(*register, *value);
                None
            }
            Command::CurrentTexture(_) | Command::TexturePalette(_) => None,
            Command::Draw { opcode, vertex, head, vertices } => {
                let attributes = attributes(*vertex);
                let work = self.draw(*opcode, *vertex, head, vertices);
                let (command, vertex) = (opcode.name(), Some(vertex.name()));
                Some(Estimate { command, vertex, attributes, work })
            }
            Command::Other { opcode: Opcode::ContextInit, .. } => {
                *self = Estimator::new(self.chip, self.rates);
                None
            }
            Command::Other { opcode, words, .. } => {
                let (attributes, work) = self.other(*opcode, words)?;
                Some(Estimate { command: opcode.name(), vertex: None, attributes, work })
            }
        }
    }

    fn set(&mut self, register: Register, value: u32) {
        let sides = [value >> 16, value & 0xffff].map(f64::from);
        match register {
            Register::ScissorX => self.scissor[..2].copy_from_slice(&sides),
            Register::ScissorY => self.scissor[2..].copy_from_slice(&sides),
            Register::SrcFunc => self.textured = value != 0,
            Register::SrcFilter => self.bilinear = value != 0,
            Register::BlendEnable => self.blends = value != 0,
            Register::ZBufMode => self.reads_depth = value != 0,
            Register::ZBufWrMode => self.writes_depth = value != 0,
            Register::SrcFmt => self.source_bytes = pixel_bytes(value),
            Register::DstFmt => self.destination_bytes = pixel_bytes(value),
            _ => {}
        }
    }

    /// Bytes that a pixel of a primitive moves.
    fn bytes_a_pixel(&self, textured: bool) -> u64 {
        let texels = if !textured {
            0
        } else if self.bilinear {
            4
        } else {
            1
        };
        let depths = 2 * (u64::from(self.reads_depth) + u64::from(self.writes_depth));
        let pixels = self.destination_bytes * (1 + u64::from(self.blends));
        texels * self.source_bytes + depths + pixels
    }

    /// A primitive with these attributes on so many lines and pixels.
    fn primitive(&self, attributes: u64, (lines, pixels): (u64, u64), textured: bool) -> Work {
        Work {
            primitives: 1,
            lines,
            pixels,
            setup_cycles: self.rates.setup * attributes,
            line_cycles: lines * (self.rates.line + self.rates.line_attribute * attributes),
            pixel_cycles: pixels * self.rates.pixel(attributes),
            bytes: pixels * self.bytes_a_pixel(textured),
        }
    }

    fn draw(&self, opcode: Opcode, vertex: VertexType, head: &[u32], words: &[u32]) -> Work {
        let size = vertex.words();
        let place = |index: usize| place(vertex, words.get(index * size..).unwrap_or_default());
        let count = words.len() / size;
        let attributes = attributes(vertex);
        let mut work = Work::default();
        let mut add = |covered| work += self.primitive(attributes, covered, self.textured);
        match opcode {
            Opcode::Triangle => add(self.triangle([place(0), place(1), place(2)])),
            Opcode::Tristrip => {
                for i in 2..count {
                    add(self.triangle([place(i - 2), place(i - 1), place(i)]));
                }
            }
            Opcode::Trifan => {
                for i in 2..count {
                    add(self.triangle([place(0), place(i - 1), place(i)]));
                }
            }
            Opcode::Dot => add(self.rectangle(place(0), [1.0, 1.0])),
            Opcode::Square | Opcode::Rectangle => {
                let [width, height] = [head[0], head[head.len() - 1]].map(fixed);
                let [x, y] = place(0);
                let corner = [x - width / 2.0, y - height / 2.0];
                // Of the vertex only the place counts; the texture brings two.
                let covered = self.rectangle(corner, [width, height]);
                return self.primitive(4, covered, self.textured);
            }
            Opcode::Span => {
                let length = place(1)[0].abs().max(1.0);
                add(self.rectangle(place(0), [length, 1.0]));
            }
            _ => {
                for i in 1..count {
                    add(self.line(place(i - 1), place(i)));
                }
            }
        }
        work
    }

    fn other(&self, opcode: Opcode, words: &[u32]) -> Option<(u64, Work)> {
        let pair = |word: u32| [f64::from(word >> 16), f64::from(word & 0xffff)];
        let sized = |at: u32, size: u32| self.rectangle(pair(at), pair(size));
        let memory = |bytes: u64| {
            let pixel_cycles = bytes.div_ceil(BYTES_A_CYCLE);
            Work { primitives: 1, pixel_cycles, bytes, ..Work::default() }
        };
        let two_dimensional = |(lines, pixels): (u64, u64), cycles: u64, textured: bool| Work {
            primitives: 1,
            lines,
            pixels,
            line_cycles: lines * self.rates.line,
            pixel_cycles: pixels * cycles,
            bytes: pixels * self.bytes_a_pixel(textured),
            ..Work::default()
        };
        let fast = |attributes: u64, size: usize, at: usize, textured: bool| {
            let place = |i: usize| [words[i * size + at], words[i * size + at + 1]].map(fixed);
            let covered = self.triangle([place(0), place(1), place(2)]);
            (attributes, self.primitive(attributes, covered, textured))
        };
        Some(match opcode {
            Opcode::TriFill => {
                let place = |i: usize| [words[2 * i], words[2 * i + 1]].map(fixed);
                let covered = self.triangle([place(0), place(1), place(2)]);
                (2, self.primitive(2, covered, false))
            }
            Opcode::FtriKxyz => fast(6, 4, 1, false),
            Opcode::FtriKxyzuvq => fast(9, 7, 1, true),
            Opcode::FtriKfxyzuvq => fast(10, 8, 2, true),
            Opcode::FtriKsxyz => fast(9, 5, 2, false),
            Opcode::FtriKsxyzuvq => fast(12, 8, 2, true),
            Opcode::Affine => {
                let at = [words[0], words[1]].map(fixed);
                let covered = self.rectangle(at, [words[4], words[5]].map(fixed));
                (4, self.primitive(4, covered, true))
            }
            Opcode::Warp => (4, self.primitive(4, sized(words[0], words[1]), true)),
            Opcode::IntLine => {
                (2, self.primitive(2, self.line(pair(words[0]), pair(words[1])), false))
            }
            Opcode::IntPolyline => {
                let mut work = Work::default();
                for two in words[1..].windows(2) {
                    let covered = self.line(pair(two[0]), pair(two[1]));
                    work += self.primitive(2, covered, false);
                }
                (2, work)
            }
            Opcode::Particles => {
                let mut work = Work::default();
                for particle in words[1..].as_chunks::<4>().0 {
                    work += self.primitive(3, sized(particle[0], particle[1]), false);
                }
                (3, work)
            }
            Opcode::Bitblt => (0, two_dimensional(sized(words[0], words[1]), 1, true)),
            Opcode::Bitfill => (0, two_dimensional(sized(words[0], words[1]), 1, false)),
            Opcode::Lookup => (0, two_dimensional(sized(words[0], words[1]), LOOKUP, true)),
            Opcode::BitbltMem | Opcode::CompositeRect => (0, memory(words.len() as u64 * 4)),
            Opcode::MemClearRect => (0, memory(u64::from(words[2]) * u64::from(words[3]))),
            Opcode::MemWrite => (0, memory(words[1].into())),
            Opcode::MemWriteRect => (0, memory(u64::from(words[2]) * u64::from(words[3]))),
            Opcode::MemWriteSprite => (0, memory(words.len() as u64 * 4)),
            _ => return None,
        })
    }

    /// Scan lines and pixels of a rectangle.
    fn rectangle(&self, [x, y]: [f64; 2], [width, height]: [f64; 2]) -> (u64, u64) {
        let [left, right, top, bottom] = self.scissor;
        let within = |from: f64, size: f64, low: f64, high: f64| {
            ((from + size).min(high) - from.max(low)).max(0.0).round() as u64
        };
        let columns = within(x, width, left, right);
        let rows = if columns == 0 { 0 } else { within(y, height, top, bottom) };
        (rows, rows * columns)
    }

    /// Scan lines and pixels of a line: each pixel starts anew.
    fn line(&self, a: [f64; 2], b: [f64; 2]) -> (u64, u64) {
        let [left, right, top, bottom] = self.scissor;
        let clamp =
            |[x, y]: [f64; 2]| [x.clamp(left, right.max(left)), y.clamp(top, bottom.max(top))];
        let (a, b) = (clamp(a), clamp(b));
        let [width, height] = [0, 1].map(|i: usize| (a[i] - b[i]).abs().round());
        (height as u64, width.max(height) as u64)
    }

    /// Scan lines and pixels of a triangle within the scissor.
    fn triangle(&self, corners: [[f64; 2]; 3]) -> (u64, u64) {
        let [left, right, top, bottom] = self.scissor;
        let mut polygon = corners.to_vec();
        for (axis, side, keep) in
            [(0, left, 1.0), (0, right, -1.0), (1, top, 1.0), (1, bottom, -1.0)]
        {
            polygon = clip(&polygon, axis, side, keep);
        }
        let next = |i: usize| polygon[(i + 1) % polygon.len()];
        let doubled: f64 =
            polygon.iter().enumerate().map(|(i, [x, y])| x * next(i)[1] - next(i)[0] * y).sum();
        let pixels = (doubled.abs() / 2.0).round() as u64;
        if pixels == 0 {
            return (0, 0);
        }
        let low = polygon.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min);
        let high = polygon.iter().map(|p| p[1]).fold(f64::NEG_INFINITY, f64::max);
        // Rows whose centres lie within.
        let rows = (high - 0.5).ceil() - (low - 0.5).ceil();
        (rows.max(0.0) as u64, pixels)
    }
}

/// Column and row of a vertex.
fn place(vertex: VertexType, words: &[u32]) -> [f64; 2] {
    let layout = vertex.layout();
    [Attribute::X, Attribute::Y].map(|axis| fixed(layout.get(words, axis).unwrap_or(0)))
}

/// The part of a polygon on one side: where `keep * (coordinate - side)` is not
/// negative.
fn clip(polygon: &[[f64; 2]], axis: usize, side: f64, keep: f64) -> Vec<[f64; 2]> {
    let inside = |p: &[f64; 2]| keep * (p[axis] - side) >= 0.0;
    let mut out = Vec::with_capacity(polygon.len() + 1);
    for (i, a) in polygon.iter().enumerate() {
        let b = &polygon[(i + 1) % polygon.len()];
        if inside(a) {
            out.push(*a);
        }
        if inside(a) != inside(b) {
            let t = (side - a[axis]) / (b[axis] - a[axis]);
            let mut crossing = [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
            crossing[axis] = side;
            out.push(crossing);
        }
    }
    out
}

/// Cycles of a Pentium of the time for a command's call, and for each of its
/// words; see `docs/sources.md`.
const HOST_CALL: u64 = 60;
const HOST_WORD: u64 = 8;
/// Megahertz of that Pentium.
pub const HOST_CLOCK: f64 = 200.0;

/// Seconds that a program of the time would have taken to record commands of
/// so many words, its own mathematics left out.
pub fn host_seconds(commands: u64, words: u64) -> f64 {
    (commands * HOST_CALL + words * HOST_WORD) as f64 / (HOST_CLOCK * 1e6)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::CommandBuffer;
    use crate::record;

    fn estimates(chip: Chip, fill: impl FnOnce(&mut CommandBuffer)) -> Vec<Estimate> {
        let mut buffer = CommandBuffer::new(1, 4, 4096).unwrap();
        record::set_scissor_x(&mut buffer, 640).unwrap();
        record::set_scissor_y(&mut buffer, 480).unwrap();
        fill(&mut buffer);
        let mut all = Vec::new();
        Estimator::new(chip, Rates::of(chip)).stream(buffer.words(), |estimate| all.push(estimate));
        all
    }

    fn xy(x: i32, y: i32) -> [u32; 2] {
        [(x << 16) as u32, (y << 16) as u32]
    }

    fn kxy(x: i32, y: i32) -> [u32; 3] {
        [0, (x << 16) as u32, (y << 16) as u32]
    }

    /// The guide's examples: fog saves set-up and at times a cycle, intensity
    /// instead of colour saves a cycle.
    #[test]
    fn attributes_cost_what_the_guide_says() {
        let v1000 = Rates::of(Chip::V1000);
        let count = |vertex| attributes(vertex);
        assert_eq!(count(VertexType::XYUVQ), 5);
        assert_eq!(count(VertexType::FXYUVQ), 6);
        assert_eq!(v1000.pixel(5), v1000.pixel(6));
        assert_eq!(count(VertexType::KAFXYZUVQ), 11);
        assert_eq!(v1000.pixel(count(VertexType::KAFXYZUVQ)), 6);
        assert_eq!(count(VertexType::KXYUVQ) - count(VertexType::IXYUVQ), 2);
        assert_eq!(
            v1000.pixel(count(VertexType::KXYUVQ)) - v1000.pixel(count(VertexType::IXYUVQ)),
            1
        );
        assert_eq!(Rates::of(Chip::V2000).pixel(12), 1);
    }

    /// The first triangle of the guide: 300 wide, 200 high.
    #[test]
    fn a_triangle_by_the_table() {
        for (chip, setup, lines, pixels) in
            [(Chip::V1000, 40, 200 * 4, 30000), (Chip::V2000, 20, 200, 30000)]
        {
            let all = estimates(chip, |buffer| {
                let (a, b, c) = (xy(100, 100), xy(400, 100), xy(250, 300));
                record::triangle(buffer, 1, &a, &b, &c).unwrap();
            });
            assert_eq!(all.len(), 1);
            let work = all[0].work;
            assert_eq!((work.primitives, work.lines, work.pixels), (1, 200, 30000));
            assert_eq!(
                (work.setup_cycles, work.line_cycles, work.pixel_cycles),
                (setup, lines, pixels)
            );
            assert_eq!(work.bytes, 60000);
        }
    }

    #[test]
    fn only_what_the_scissor_leaves_counts() {
        let all = estimates(Chip::V2000, |buffer| {
            record::triangle(buffer, 28, &kxy(-640, 0), &kxy(640, 0), &kxy(-640, 480)).unwrap();
            record::triangle(buffer, 28, &kxy(-640, -10), &kxy(640, -10), &kxy(0, -480)).unwrap();
            record::triangle(buffer, 28, &kxy(5, 5), &kxy(5, 5), &kxy(5, 5)).unwrap();
        });
        // The right half of the first is a quarter of it.
        assert_eq!((all[0].work.lines, all[0].work.pixels), (240, 640 * 240 / 2));
        assert_eq!((all[1].work.pixels, all[1].work.setup_cycles), (0, 50));
        assert_eq!(all[2].work.pixels, 0);
    }

    #[test]
    fn strips_and_state() {
        let all = estimates(Chip::V2000, |buffer| {
            let v = [xy(0, 0), xy(10, 0), xy(0, 10), xy(10, 10)].concat();
            record::set_z_buf_mode(buffer, 1).unwrap();
            record::set_z_buf_wr_mode(buffer, 1).unwrap();
            record::set_blend_enable(buffer, 1).unwrap();
            record::tristrip(buffer, 1, 2, &v).unwrap();
            record::context_init(buffer).unwrap();
            record::bitfill(buffer, [0, 0], [10, 20]).unwrap();
        });
        assert_eq!(all[0].work.primitives, 2);
        assert_eq!((all[0].work.pixels, all[0].work.bytes), (100, 100 * (4 + 4)));
        assert_eq!((all[1].work.pixels, all[1].work.bytes), (200, 400));
    }
}
