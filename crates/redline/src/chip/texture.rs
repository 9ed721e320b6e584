//! Textures: texels decoded from video memory, kept until the bytes change.
//!
//! Masks and clamp limits are baked into the decoded array: its sides are the
//! powers of two that hold the masks, and entry `i` of a side is the texel that
//! the chip would address for `i`. A clamped side of 200 texels becomes 256
//! whose last 56 repeat the limit.
//!
//! Source: RR, texture addressing and texel expansion.

use std::sync::Arc;

use fillrate_engine::{Texture, TextureDesc};

use super::area::Area;
use super::memory::VideoMemory;
use super::state::State;
use crate::format::{PixFmt, unpack, yuv};
use crate::opcode::Register;

/// log2 of the longest side: coordinates times size must not exceed 2^11.
const MAX_BITS: u32 = 11;
/// Texels that are kept decoded.
const MAX_TEXELS: usize = 1 << 23;

/// How texels are read; everything but the addresses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Reading {
    pub format: PixFmt,
    /// Entries of the palette, for 4-bit formats; else zeros.
    palette: [u16; 16],
    pad: bool,
    bgr: bool,
    yuv: bool,
    /// Key and the bits of it that count.
    key: Option<(u32, u32)>,
}

impl Reading {
    /// How a state reads pixels of its source format.
    pub fn new(state: &State) -> Option<Reading> {
        let format = state.source_format()?;
        Some(Reading::of(state, format))
    }

    /// How a state reads pixels of a format.
    pub fn of(state: &State, format: PixFmt) -> Reading {
        let mask = state.get(Register::ChromaMask) & format.full_mask();
        let key = (state.get(Register::ChromaColor) & mask, mask);
        let palette = if format.bits() == 4 { *state.palette() } else { [0; 16] };
        Reading {
            format,
            palette,
            pad: !state.is_set(Register::SrcColorNoPad),
            bgr: state.is_set(Register::SrcBgr),
            yuv: state.is_set(Register::Yuv2Rgb),
            key: state.is_set(Register::ChromaKey).then_some(key),
        }
    }

    /// The raw pixel in a column of a row, 0 where the row is too short.
    #[inline]
    pub fn raw(&self, row: &[u8], column: usize) -> u32 {
        let byte = |at: usize| row.get(at).copied().unwrap_or(0);
        match self.format.bits() {
            4 => u32::from(byte(column / 2) >> (column % 2 * 4) & 0xf),
            8 => u32::from(byte(column)),
            16 => u32::from(u16::from_le_bytes([byte(column * 2), byte(column * 2 + 1)])),
            _ => u32::from_le_bytes([0, 1, 2, 3].map(|i| byte(column * 4 + i))),
        }
    }

    /// Whether a raw pixel is the key.
    #[inline]
    pub fn is_key(&self, raw: u32) -> bool {
        self.key.is_some_and(|(key, mask)| raw & mask == key)
    }

    /// The texel in a column of a row as 0xAARRGGBB, and whether it is keyed;
    /// keyed ones have alpha 0.
    #[inline]
    pub fn texel(&self, row: &[u8], column: usize) -> (u32, bool) {
        let raw = self.raw(row, column);
        let argb = match (self.format, self.format.palette_entry()) {
            (_, Some(entry)) => unpack(entry, self.palette[raw as usize].into(), self.pad),
            (PixFmt::Yuv422, _) => self.yuv_texel(row, column),
            (format, _) => unpack(format, raw, self.pad),
        };
        let argb = if self.bgr { swapped(argb) } else { argb };
        if self.is_key(raw) { (argb & 0x00ff_ffff, true) } else { (argb, false) }
    }

    /// Without conversion Y, Cr and Cb count as red, green and blue.
    fn yuv_texel(&self, row: &[u8], column: usize) -> u32 {
        let byte = |at: usize| row.get(column / 2 * 4 + at).copied().unwrap_or(0);
        let (y, cr, cb) = (byte(column % 2 * 2), byte(1), byte(3));
        match self.yuv {
            true => yuv(y, cr, cb),
            false => u32::from_be_bytes([255, y, cr, cb]),
        }
    }
}

/// Exchanges red and blue of 0xAARRGGBB.
fn swapped(argb: u32) -> u32 {
    argb & 0xff00_ff00 | argb >> 16 & 0xff | (argb & 0xff) << 16
}

/// One axis of a texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Axis {
    mask: u32,
    clamp: bool,
    /// log2 of the decoded side.
    bits: u32,
    /// The coordinate of the first entry.
    pub origin: u32,
    /// Only a part of the side is decoded.
    window: bool,
}

impl Axis {
    fn new(mask: u32, clamp: bool) -> Axis {
        let mask = mask & 0xffff;
        let bits = (32 - mask.leading_zeros()).min(MAX_BITS);
        Axis { mask, clamp, bits, origin: 0, window: false }
    }

    /// Entries of the decoded side.
    fn side(&self) -> u32 {
        1 << self.bits
    }

    /// Whether what lies outside the decoded side is its nearest entry; else it
    /// repeats.
    pub fn clamps(&self) -> bool {
        self.clamp || self.window
    }

    /// The texel that an entry stands for.
    fn texel(&self, entry: u32) -> u32 {
        let at = self.origin + entry;
        if self.clamp { at.min(self.mask) } else { at & self.mask }
    }

    /// No texel is beyond this one.
    fn last(&self) -> u32 {
        self.mask.min(self.origin + self.side() - 1)
    }

    /// Only what coordinates from `low` to `high` (whole texels) touch, where
    /// that is much less.
    fn narrowed(self, [low, high]: [i64; 2]) -> Axis {
        let side = i64::from(self.side());
        // A neighbour on each side belongs to the filter.
        let (low, high) = (low - 1, high + 2);
        if self.bits < 9 || low < 0 || high >= side {
            return self;
        }
        for bits in 6..self.bits {
            // Windows start every half of their size, so that one holds
            // whatever is no longer than that.
            let origin = low >> (bits - 1) << (bits - 1);
            let end = origin + (1 << bits);
            if high < end && end <= side {
                return Axis { bits, origin: origin as u32, window: true, ..self };
            }
        }
        self
    }
}

/// A texture as the state describes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Binding {
    base: u32,
    pitch: u32,
    /// Columns: U's axis, or V's where the two are exchanged.
    pub columns: Axis,
    /// Rows.
    pub rows: Axis,
    reading: Reading,
}

impl Binding {
    /// The source texture of a state whose source has `pitch` bytes a row.
    pub fn new(state: &State, pitch: u32) -> Option<Binding> {
        let reading = Reading::new(state)?;
        let u = Axis::new(state.get(Register::UMask), state.is_set(Register::UClamp));
        let v = Axis::new(state.get(Register::VMask), state.is_set(Register::VClamp));
        let [columns, rows] = if state.is_set(Register::SwapUv) { [v, u] } else { [u, v] };
        Some(Binding { base: state.get(Register::SrcBase), pitch, columns, rows, reading })
    }

    /// Whether it is so large that decoding it whole is worth avoiding.
    pub fn is_large(&self) -> bool {
        self.columns.bits + self.rows.bits > 18
    }

    /// The same with only the texels from the first to the second number of
    /// each axis.
    pub fn narrowed(&self, [u, v]: [[i64; 2]; 2]) -> Binding {
        Binding { columns: self.columns.narrowed(u), rows: self.rows.narrowed(v), ..*self }
    }

    /// Bytes of a row as far as texels are read.
    fn row_bytes(&self) -> u32 {
        // Two YUV texels share four bytes.
        self.reading.format.row_bytes((self.columns.last() + 1).next_multiple_of(2)) as u32
    }

    /// The bytes it is read from.
    pub fn area(&self) -> Area {
        let rows = self.rows.last() + 1;
        Area { base: self.base, pitch: self.pitch, row: self.row_bytes(), rows }
    }

    fn texels(&self) -> usize {
        1 << (self.columns.bits + self.rows.bits)
    }

    fn decode(&self, memory: &VideoMemory) -> Option<Texture> {
        let columns: Vec<usize> =
            (0..self.columns.side()).map(|i| self.columns.texel(i) as usize).collect();
        let row_bytes = self.row_bytes();
        let mut texels = Vec::with_capacity(self.texels());
        let mut keys = Vec::new();
        for entry in 0..self.rows.side() {
            let offset = u64::from(self.rows.texel(entry)) * u64::from(self.pitch);
            let at = u32::try_from(u64::from(self.base) + offset).unwrap_or(u32::MAX);
            let row = memory.get(at, row_bytes);
            for &column in &columns {
                let (argb, keyed) = self.reading.texel(row, column);
                if keyed {
                    keys.resize(self.texels(), false);
                    keys[texels.len()] = true;
                }
                texels.push(argb);
            }
        }
        let bits = [self.columns.bits, self.rows.bits];
        if !keys.is_empty() {
            spread(&mut texels, &keys, bits[0]);
        }
        build(bits, self.columns.clamps(), &texels, &keys)
    }
}

/// Gives keyed texels the colour of a neighbour that is not keyed, so that
/// filtered samples near them show only colours of the others.
fn spread(texels: &mut [u32], keys: &[bool], column_bits: u32) {
    let width = 1usize << column_bits;
    let count = texels.len();
    // Offsets modulo the number of texels; a texture may be a single row.
    let offsets = [1, count - 1, width, 2 * count - width, width + 1, 2 * count - width - 1];
    for at in (0..count).filter(|&at| keys[at]) {
        let neighbours = offsets.map(|offset| (at + offset) % count);
        if let Some(neighbour) = neighbours.into_iter().find(|&neighbour| !keys[neighbour]) {
            texels[at] = texels[neighbour];
        }
    }
}

/// A texture of one level.
pub(crate) fn build(bits: [u32; 2], clamp: bool, texels: &[u32], keys: &[bool]) -> Option<Texture> {
    let [s_bits, t_bits] = bits.map(|bits| bits as u8);
    let desc = TextureDesc { s_bits, t_bits, first: 0, last: 0, clamp_s: clamp };
    let texture = Texture::build(desc, |_, out| out.extend_from_slice(texels)).ok()?;
    if keys.is_empty() {
        return Some(texture);
    }
    let keyed = |_, column, row: u32| keys[((row << s_bits) + column) as usize];
    Some(texture.with_key(keyed))
}

/// Decoded textures, the one used last at the end.
#[derive(Debug, Default)]
pub(crate) struct TextureCache {
    entries: Vec<Entry>,
    texels: usize,
}

#[derive(Debug)]
struct Entry {
    binding: Binding,
    texture: Arc<Texture>,
    /// Writes to memory when it was decoded.
    decoded: u64,
}

impl TextureCache {
    /// The texture of a binding; memory must be up to date in its area.
    pub fn get(&mut self, memory: &VideoMemory, binding: &Binding) -> Option<Arc<Texture>> {
        if let Some(at) = self.entries.iter().rposition(|entry| entry.binding == *binding) {
            let area = binding.area();
            let entry = self.entries.remove(at);
            if memory.changed(area.base, area.span()) <= entry.decoded {
                let texture = Arc::clone(&entry.texture);
                self.entries.push(entry);
                return Some(texture);
            }
            self.texels -= binding.texels();
        }
        let texture = Arc::new(binding.decode(memory)?);
        self.texels += binding.texels();
        self.entries.push(Entry {
            binding: *binding,
            texture: Arc::clone(&texture),
            decoded: memory.writes(),
        });
        while self.texels > MAX_TEXELS && self.entries.len() > 1 {
            self.texels -= self.entries.remove(0).binding.texels();
        }
        Some(texture)
    }
}
