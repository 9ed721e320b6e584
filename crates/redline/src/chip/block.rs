//! Host pixels through the pixel pipeline: blocks of texels that are drawn as
//! rectangles of a texture of their own.
//!
//! Source: RR, `VL_BitbltMem`, `VL_Lookup`, `VL_CompositeRect`.

use std::sync::Arc;

use fillrate_engine::Texture;
use fillrate_engine::state::{
    CombineUnit, Filter, MAX_TMUS, Rect, TextureCombine, TextureFactor, TextureUnit,
};

use super::VeriteChip;
use super::area::Area;
use super::draw::HALVES;
use super::setup::{self, Corner};
use super::texture::{Binding, Reading, build};
use super::transfer::bytes_of;
use super::translate::{self, SourceFunction};
use super::window;
use crate::format::PixFmt;
use crate::opcode::Register;

/// The longest side of a part of a block.
const PART: u32 = 512;
/// 1.0 with 32 fraction bits.
const ONE: f64 = 4_294_967_296.0;

/// Where a block is, in pixels.
#[derive(Clone, Copy, Debug)]
struct Extent {
    x: u32,
    y: u32,
    width: u32,
    height: u32,
}

impl Extent {
    /// A packed place, and a packed size.
    fn new(at: u32, size: u32) -> Extent {
        Extent { x: at >> 16, y: at & 0xffff, width: size >> 16, height: size & 0xffff }
    }

    fn rect(&self) -> Rect {
        Rect::new(self.x, self.y, self.x + self.width, self.y + self.height)
    }
}

/// Rectangles of at most [`PART`] pixels a side that make up a rectangle.
fn parts(rect: Rect) -> impl Iterator<Item = Rect> {
    let part = PART as usize;
    (rect.y0..rect.y1).step_by(part).flat_map(move |y| {
        (rect.x0..rect.x1)
            .step_by(part)
            .map(move |x| Rect::new(x, y, rect.x1.min(x + PART), rect.y1.min(y + PART)))
    })
}

/// Corners of a rectangle: upper left, upper right, lower left, lower right.
fn corners(rect: &Rect, corner: impl Fn(u32, u32) -> Corner) -> [Corner; 4] {
    [(rect.x0, rect.y0), (rect.x1, rect.y0), (rect.x0, rect.y1), (rect.x1, rect.y1)]
        .map(|(x, y)| corner(x, y))
}

/// What a block's texels are combined with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Under {
    /// The default colour, by a source function.
    Color(SourceFunction),
    /// The current texture; U and V at the upper left and lower right corner.
    Texture([[u32; 2]; 2]),
}

impl VeriteChip {
    /// `V_FIFO_BITBLT_MEM`: pixels of the source format, replacing.
    pub(super) fn bitblt_mem(&mut self, words: &[u32]) {
        let [at, size, pixel] = [words[0], words[1], words[2]];
        let (row_words, height, bytes) = (size >> 16, size & 0xffff, pixel & 0xffff);
        let Some(format) = self.host_format(bytes) else { return };
        let width = match pixel >> 16 {
            0 => row_words * 4 / bytes,
            width => width.min(row_words * 4 / bytes),
        };
        let extent = Extent { width, height, ..Extent::new(at, 0) };
        let reading = Reading::of(&self.state, format);
        let data = bytes_of(&words[3..]);
        let row = |y: u32| row_of(&data, row_words, y);
        let under = Under::Color(SourceFunction::Replace);
        self.block(extent, under, |x, y| reading.texel(row(y), x as usize));
    }

    /// The format of host pixels of so many bytes: the source's where it has as
    /// many.
    fn host_format(&self, bytes: u32) -> Option<PixFmt> {
        let same = |format: &PixFmt| bytes > 0 && format.bytes() == bytes;
        let source = self.state.source_format().filter(same);
        source.or(match bytes {
            1 => Some(PixFmt::Gray8),
            2 => Some(PixFmt::Rgb565),
            4 => Some(PixFmt::Argb8888),
            _ => None,
        })
    }

    /// `V_FIFO_LOOKUP`: bytes select texels of the texture's first row.
    pub(super) fn lookup(&mut self, words: &[u32]) {
        let extent = Extent::new(words[0], words[1]);
        let Some(reading) = Reading::new(&self.state) else { return };
        let bytes = reading.format.row_bytes(256) as u32;
        let base = self.state.get(Register::SrcBase);
        self.targets.sync(&mut self.memory, &Area::line(base, bytes));
        let row = self.memory.get(base, bytes).to_vec();
        let mask = (self.state.get(Register::UMask) & 0xff) as usize;
        let texels: Vec<(u32, bool)> = (0..256).map(|i| reading.texel(&row, i & mask)).collect();
        let data = bytes_of(&words[2..]);
        let row_words = extent.width.div_ceil(4);
        let index = |x: u32, y: u32| row_of(&data, row_words, y)[x as usize];
        let function = match SourceFunction::of(&self.state) {
            SourceFunction::NoTexture => SourceFunction::Replace,
            function => function,
        };
        self.block(extent, Under::Color(function), |x, y| texels[usize::from(index(x, y))]);
    }

    /// `V_FIFO_COMPOSITE_RECT`: host pixels times the texture's.
    pub(super) fn composite_rect(&mut self, words: &[u32]) {
        let Some(format) = PixFmt::from_code(words[0]) else { return };
        let extent = Extent::new(words[1], words[2]);
        let reading = Reading::of(&self.state, format);
        let row_words = crate::stream::padded_row(words[0], extent.width.into()) as u32;
        let data = bytes_of(&words[7..]);
        let row = |y: u32| row_of(&data, row_words, y);
        let under = Under::Texture([[words[3], words[4]], [words[5], words[6]]]);
        self.block(extent, under, |x, y| reading.texel(row(y), x as usize));
    }

    /// Draws a block; `texel` gives colour and key of a column and row of it.
    fn block(&mut self, extent: Extent, under: Under, texel: impl Fn(u32, u32) -> (u32, bool)) {
        let Some(prepared) = self.prepare() else { return };
        let scissor = prepared.scissor;
        // Parts begin with the block, so that what is drawn of it does not
        // depend on what can be seen.
        for part in parts(extent.rect()) {
            let visible = part.intersect(&scissor);
            if visible.is_empty() {
                continue;
            }
            let texels = |x: u32, y: u32| texel(part.x0 + x - extent.x, part.y0 + y - extent.y);
            let Some(texture) = block_texture(&part, texels) else { return };
            self.block_part(&extent, [&part, &visible], under, Arc::new(texture));
        }
    }

    fn block_part(
        &mut self,
        extent: &Extent,
        [part, visible]: [&Rect; 2],
        under: Under,
        texture: Arc<Texture>,
    ) {
        let upstream = match under {
            Under::Color(_) => None,
            Under::Texture(_) => self.upstream(),
        };
        if !self.enter() {
            return;
        }
        let Some(prepared) = &self.prepared else { return };
        let (depth, attributes, at) = (prepared.depth, prepared.attributes, prepared.origin());
        let mut draw = prepared.base;
        let mut textures: [Option<Arc<Texture>>; MAX_TMUS] = [const { None }; MAX_TMUS];
        let mut unit = translate::texture_unit(Filter::Point, false, [true, true]);
        textures[0] = Some(texture);
        let function = match under {
            Under::Color(function) => function,
            Under::Texture(_) => SourceFunction::Replace,
        };
        let uv = match (under, upstream) {
            (Under::Texture(uv), Some((above, source))) => {
                let product = CombineUnit::<TextureFactor> {
                    factor: TextureFactor::Local,
                    ..CombineUnit::default()
                };
                unit.combine = TextureCombine { color: product, alpha: product };
                (draw.units[1], textures[1]) = (Some(above), Some(source));
                Some(uv)
            }
            _ => None,
        };
        draw.units[0] = Some(unit);
        draw.pattern = None;
        translate::source(&mut draw, function, false);
        self.set_special(&draw, textures);
        self.targets.drawn(&window::moved(visible, at), depth);
        let place = |x: u32, at: u32| (x as i32 - at as i32) * 16;
        let own = corners(part, |x, y| {
            let texel = [f64::from(x - part.x0) * ONE, f64::from(y - part.y0) * ONE, ONE];
            attributes.corner([place(x, at[0]), place(y, at[1])], [0, 0]).with_texel(texel)
        });
        let under = corners(part, |x, y| {
            let uv = uv.map_or([0, 0], |uv| across(extent, uv, x, y));
            attributes.corner([place(x, at[0]), place(y, at[1])], uv)
        });
        for [a, b, c] in HALVES {
            // Both have the same places, so they come in the same pieces.
            let upper = setup::parts([&under[a], &under[b], &under[c]]);
            let own = setup::parts([&own[a], &own[b], &own[c]]);
            for (mut registers, upper) in own.into_iter().zip(upper) {
                registers.tmu[1] = upper.tmu[0];
                self.targets.engine.launch(&registers);
            }
        }
    }

    /// The unit and texture that are the current source, whole.
    fn upstream(&mut self) -> Option<(TextureUnit, Arc<Texture>)> {
        let pitch = self.config.chip.linebytes(self.state.get(Register::SrcStride));
        let binding = Binding::new(&self.state, pitch)?;
        self.targets.sync(&mut self.memory, &binding.area());
        let texture = self.textures.get(&self.memory, &binding)?;
        Some((translate::bound_unit(&self.state, &binding, false), texture))
    }
}

/// U and V at a pixel corner of a block, linear between those of its corners.
fn across(extent: &Extent, [[u0, v0], [u1, v1]]: [[u32; 2]; 2], x: u32, y: u32) -> [u32; 2] {
    let at = |from: u32, to: u32, step: u32, whole: u32| {
        let change = i64::from(to as i32) - i64::from(from as i32);
        let change = change * i64::from(step) / i64::from(whole.max(1));
        (i64::from(from as i32) + change) as u32
    };
    [at(u0, u1, x - extent.x, extent.width), at(v0, v1, y - extent.y, extent.height)]
}

/// A row of so many words.
fn row_of(data: &[u8], words: u32, row: u32) -> &[u8] {
    let size = words as usize * 4;
    data.get(row as usize * size..(row as usize + 1) * size).unwrap_or_default()
}

/// Texels of a part as a texture, up to the next powers of two.
fn block_texture(part: &Rect, texel: impl Fn(u32, u32) -> (u32, bool)) -> Option<Texture> {
    let (width, height) = (part.x1 - part.x0, part.y1 - part.y0);
    let bits = [width, height].map(|side| side.next_power_of_two().trailing_zeros());
    let count = 1usize << (bits[0] + bits[1]);
    let (mut texels, mut keys) = (Vec::with_capacity(count), Vec::new());
    for y in 0..1 << bits[1] {
        for x in 0..1 << bits[0] {
            let (argb, keyed) = if x < width && y < height { texel(x, y) } else { (0, false) };
            if keyed {
                keys.resize(count, false);
                keys[texels.len()] = true;
            }
            texels.push(argb);
        }
    }
    build(bits, true, &texels, &keys)
}
