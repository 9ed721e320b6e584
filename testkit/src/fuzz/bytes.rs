//! Arguments from bytes.

use fillrate_call::Data;
use fillrate_glide::{GrTmuVertex, GrVertex};

/// Bytes that decide everything; zeros when they have run out.
#[derive(Clone, Debug)]
pub struct Bytes<'a> {
    rest: &'a [u8],
}

/// Texels, pixels and other data that calls carry at most.
const MAX_DATA: usize = 16 * 1024;

impl<'a> Bytes<'a> {
    /// All decisions follow from these.
    pub fn new(bytes: &'a [u8]) -> Bytes<'a> {
        Bytes { rest: bytes }
    }

    /// Whether nothing is left to decide with.
    pub fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    /// The next byte.
    pub fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.rest.split_first() else { return 0 };
        self.rest = rest;
        first
    }

    fn raw<const N: usize>(&mut self) -> [u8; N] {
        core::array::from_fn(|_| self.byte())
    }

    /// An argument: an enumerant or a small number mostly.
    pub fn int(&mut self) -> i32 {
        const SPECIAL: [i32; 8] = [0xff, -1, i32::MAX, i32::MIN, 1024, 256, 640, 0x300];
        match self.byte() {
            k @ 0..=207 => i32::from(k & 15),
            k @ 208..=223 => i32::from(k) - 224,
            k @ 224..=231 => SPECIAL[usize::from(k & 7)],
            232..=247 => i32::from(self.byte()),
            _ => i32::from_le_bytes(self.raw()),
        }
    }

    /// As [`Bytes::int`], or a colour.
    pub fn word(&mut self) -> u32 {
        if self.byte() & 1 == 0 { self.int() as u32 } else { u32::from_le_bytes(self.raw()) }
    }

    /// A signed half word.
    pub fn half(&mut self) -> i16 {
        i16::from_le_bytes(self.raw())
    }

    /// A half word.
    pub fn unsigned_half(&mut self) -> u16 {
        u16::from_le_bytes(self.raw())
    }

    /// A texture unit.
    pub fn unit(&mut self) -> i32 {
        match self.byte() {
            k @ 0..=239 => i32::from(k & 1),
            k @ 240..=247 => i32::from(k & 3),
            _ => self.int(),
        }
    }

    /// A level number; half of them large levels are rare, as they take long.
    pub fn level(&mut self) -> i32 {
        match self.byte() {
            k @ 0..=223 => 8 - i32::from(k % 7),
            k @ 224..=247 => i32::from(k % 9),
            _ => self.int(),
        }
    }

    /// Even, odd or all levels.
    pub fn levels(&mut self) -> u32 {
        match self.byte() {
            0..=127 => 3,
            k @ 128..=247 => u32::from(k & 3),
            _ => self.word(),
        }
    }

    /// A handle of the texture manager.
    pub fn handle(&mut self) -> u32 {
        match self.byte() {
            k @ 0..=223 => u32::from(k & 3),
            k @ 224..=239 => u32::from(k),
            240..=247 => u32::MAX,
            _ => self.word(),
        }
    }

    /// An address of texture memory.
    pub fn address(&mut self) -> u32 {
        match self.byte() {
            k @ 0..=191 => u32::from(k) << 8,
            192..=223 => u32::from(self.unsigned_half()) << 6,
            k @ 224..=239 => (2 << 20) - (u32::from(k & 15) << 7),
            _ => self.word(),
        }
    }

    /// A number, of the size of colours and coordinates mostly.
    pub fn float(&mut self) -> f32 {
        const SPECIAL: [f32; 8] = [
            f32::NAN,
            f32::INFINITY,
            f32::NEG_INFINITY,
            f32::MAX,
            f32::MIN,
            1e-40,
            -0.0,
            786_432.0,
        ];
        match self.byte() {
            k @ 0..=127 => f32::from(k) * 2.0,
            128..=207 => f32::from(self.unsigned_half()) / 128.0,
            k @ 208..=231 => f32::from(k - 207) / 24.0,
            k @ 232..=239 => SPECIAL[usize::from(k & 7)],
            240..=247 => f32::from(self.half()),
            _ => f32::from_le_bytes(self.raw()),
        }
    }

    /// A coordinate near the screen.
    fn coordinate(&mut self) -> f32 {
        match self.byte() {
            k @ 0..=239 => f32::from(k) * 0.5 + f32::from(self.byte() & 15) / 16.0 - 16.0,
            _ => self.float(),
        }
    }

    /// A vertex.
    pub fn vertex(&mut self) -> GrVertex {
        let (x, y) = (self.coordinate(), self.coordinate());
        let oow = match self.byte() {
            k @ 0..=223 => 1.0 / (1.0 + f32::from(k) / 16.0),
            _ => self.float(),
        };
        let mut unit =
            || GrTmuVertex { sow: self.float() * oow, tow: self.float() * oow, oow: self.float() };
        let tmuvtx = [unit(), unit()];
        let (r, g, b, a) = (self.float(), self.float(), self.float(), self.float());
        GrVertex { x, y, z: 0.0, r, g, b, ooz: self.float() * 256.0, a, oow, tmuvtx }
    }

    /// The corners of a polygon.
    pub fn vertices(&mut self) -> Vec<GrVertex> {
        let count = match self.byte() {
            k @ 0..=251 => k & 7,
            k => k & 127,
        };
        (0..count).map(|_| self.vertex()).collect()
    }

    /// A fog table: rising, or noise.
    pub fn fog_table(&mut self) -> [u8; 64] {
        let (step, noise) = (self.byte() & 7, self.byte() > 200);
        core::array::from_fn(|i| if noise { self.byte() } else { (i as u8).wrapping_mul(step) })
    }

    /// Data: some bytes, repeated up to a length.
    pub fn data(&mut self) -> Data {
        let length = match self.byte() {
            k @ 0..=127 => usize::from(k) * 4,
            k @ 128..=239 => usize::from(k) << 5,
            _ => usize::from(self.unsigned_half()) % MAX_DATA,
        };
        let pattern: [u8; 5] = self.raw();
        let byte = |i: usize| pattern[i % 5].wrapping_add((i / 7) as u8);
        (0..length).map(byte).collect::<Vec<u8>>().into()
    }

    /// Data, or none.
    pub fn maybe_data(&mut self) -> Option<Data> {
        (self.byte() & 1 == 0).then(|| self.data())
    }

    /// A list of words.
    pub fn words(&mut self) -> Vec<u32> {
        let count = self.byte();
        (0..count)
            .map(|i| u32::from(i).wrapping_mul(0x0107_0305) ^ u32::from(self.byte()))
            .collect()
    }

    /// A list of half words: mostly as many as a palette has.
    pub fn halves(&mut self) -> Vec<u16> {
        let (count, by) = (self.byte(), u16::from(self.byte()) << 3 | 1);
        let count = if count < 240 { 256 } else { u16::from(count) };
        (0..count).map(|i| i.wrapping_mul(by)).collect()
    }
}
