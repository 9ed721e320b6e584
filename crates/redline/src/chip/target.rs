//! Parts of video memory that the engine draws into.
//!
//! The engine has surfaces, the chip has addresses. What is drawn into, or used
//! as a depth buffer, becomes a resident: an engine surface that stands for an
//! area of memory. Its pixels are newer than memory within its dirty rectangle;
//! they are written back when the bytes are needed. No byte belongs to two
//! residents, and whoever writes bytes brings residents up to date, so a
//! resident is never older than memory.

use std::panic::{AssertUnwindSafe, catch_unwind};

use fillrate_engine::state::{Dither, Rect};
use fillrate_engine::target::unpack as unpack_element;
use fillrate_engine::{
    ClearValues, Counters, Device, DeviceConfig, EngineError, PixelFormat, SurfaceId,
};

use super::area::Area;
use super::memory::VideoMemory;
use crate::format::{PixFmt, swap_red_blue};

/// Residents at a time, where the destination has no more windows.
const MAX_RESIDENTS: usize = 8;
/// Surfaces made before the engine is started again, to get its handles back.
const MAX_SURFACES: u32 = 4096;

/// What a resident's pixels are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Colours of a format; red and blue may be exchanged in memory.
    Color { format: PixFmt, bgr: bool },
    /// Depths of 16 bits.
    Depth,
}

impl Kind {
    fn bytes(self) -> u32 {
        match self {
            Kind::Color { format, .. } => format.bytes(),
            Kind::Depth => 2,
        }
    }

    fn engine_format(self) -> PixelFormat {
        match self {
            Kind::Depth => PixelFormat::Aux16,
            Kind::Color { format, .. } => match format {
                PixFmt::Rgb332 => PixelFormat::Rgb332,
                PixFmt::Gray8 => PixelFormat::Gray8,
                PixFmt::Alpha8 => PixelFormat::Alpha8,
                PixFmt::Argb4444 => PixelFormat::Argb4444,
                PixFmt::Argb1555 => PixelFormat::Argb1555,
                PixFmt::Argb8888 => PixelFormat::Argb8888,
                _ => PixelFormat::Rgb565,
            },
        }
    }

    /// A pixel of memory as the engine's element, or the other way round.
    fn exchange(self, pixel: u32) -> u32 {
        match self {
            Kind::Color { format, bgr: true } => swap_red_blue(format, pixel),
            _ => pixel,
        }
    }
}

/// Where pixels lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Place {
    pub base: u32,
    pub pitch: u32,
    pub kind: Kind,
}

impl Place {
    /// Columns that a row has.
    pub fn columns(&self) -> u32 {
        self.pitch / self.kind.bytes()
    }

    /// The place that begins with one of this one's pixels.
    pub fn at(&self, [x, y]: [u32; 2]) -> Place {
        let offset = u64::from(y) * u64::from(self.pitch) + u64::from(x * self.kind.bytes());
        let base = u32::try_from(u64::from(self.base) + offset).unwrap_or(u32::MAX);
        Place { base, ..*self }
    }

    /// Rows that begin inside `memory` bytes and end there.
    pub fn rows(&self, columns: u32, memory: u32) -> u32 {
        let row = columns * self.kind.bytes();
        match memory.checked_sub(self.base).and_then(|room| room.checked_sub(row)) {
            Some(room) if self.pitch > 0 => room / self.pitch + 1,
            _ => 0,
        }
    }
}

/// What the target's depth buffer is to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DepthBuffer {
    /// It does not matter.
    Unused,
    /// There is none, though depths are tested or written.
    Missing,
    /// It lies here.
    At(Place),
}

/// An area of memory in the engine's hands.
#[derive(Clone, Debug)]
pub(crate) struct Resident {
    place: Place,
    /// Size of the engine's surface.
    width: u32,
    height: u32,
    /// The part of it that lies in memory.
    area: Area,
    surface: SurfaceId,
    /// Where the surface is newer than memory.
    dirty: Rect,
    used: u64,
}

impl Resident {
    fn columns(&self) -> u32 {
        self.area.row / self.place.kind.bytes()
    }

    fn add_dirty(&mut self, rect: &Rect) {
        let backed = Rect::new(0, 0, self.columns(), self.area.rows);
        let rect = rect.intersect(&backed);
        if rect.is_empty() {
            return;
        }
        self.dirty = if self.dirty.is_empty() { rect } else { around(&self.dirty, &rect) };
    }

    /// The pixels that bytes of one line lie in, as rectangles of one row.
    fn rows_of(&self, line: &Area) -> impl Iterator<Item = Rect> + use<> {
        let (pitch, bytes) =
            (u64::from(self.area.pitch.max(1)), u64::from(self.place.kind.bytes()));
        let base = u64::from(self.area.base);
        let (from, to) = (u64::from(line.base).max(base) - base, line.end().max(base) - base);
        let (row, rows) = (u64::from(self.area.row), u64::from(self.area.rows));
        let first = from / pitch;
        let last = if to > from { ((to - 1) / pitch + 1).min(rows) } else { first };
        (first..last).filter_map(move |y| {
            let start = (from.max(y * pitch) - y * pitch).min(row);
            let end = (to - y * pitch).min(row);
            let (x0, x1) = ((start / bytes) as u32, end.div_ceil(bytes) as u32);
            (x0 < x1).then(|| Rect::new(x0, y as u32, x1, y as u32 + 1))
        })
    }
}

/// The smallest rectangle around two that are not empty.
#[inline]
fn around(a: &Rect, b: &Rect) -> Rect {
    Rect::new(a.x0.min(b.x0), a.y0.min(b.y0), a.x1.max(b.x1), a.y1.max(b.y1))
}

/// Where the target was drawn since residents last heard of it.
#[derive(Clone, Copy, Debug)]
struct Drawn {
    rect: Rect,
    /// The depth buffer was, too.
    depth: bool,
}

impl Drawn {
    /// Nowhere: what [`around`] it and a rectangle is that rectangle.
    const NOWHERE: Drawn = Drawn { rect: Rect::new(u32::MAX, u32::MAX, 0, 0), depth: false };
}

/// The engine and what it holds of video memory.
#[derive(Debug)]
pub(crate) struct Targets {
    pub engine: Device,
    config: DeviceConfig,
    residents: Vec<Resident>,
    /// The most of them.
    room: usize,
    /// The engine's target.
    color: Option<SurfaceId>,
    depth: Option<SurfaceId>,
    drawn: Drawn,
    made: u32,
    clock: u64,
    /// Counters of engines before this one.
    counters: Counters,
}

impl Targets {
    /// An engine that holds nothing.
    ///
    /// # Errors
    /// Those of [`Device::new`].
    pub fn new(config: &DeviceConfig) -> Result<Targets, EngineError> {
        Ok(Targets {
            engine: Device::new(config.clone())?,
            config: config.clone(),
            residents: Vec::new(),
            room: MAX_RESIDENTS,
            color: None,
            depth: None,
            drawn: Drawn::NOWHERE,
            made: 0,
            clock: 0,
            counters: Counters::default(),
        })
    }

    /// What was drawn so far.
    pub fn counters(&mut self) -> Counters {
        let mut all = self.counters;
        all += self.engine.counters();
        all
    }

    /// Makes `color`, with `depth`, the engine's target of
    /// `width` x `height` pixels at least, one of `room` that are used by turns.
    /// False where nothing can be drawn.
    pub fn choose(
        &mut self,
        memory: &mut VideoMemory,
        color: Place,
        depth: DepthBuffer,
        (width, height): (u32, u32),
        room: usize,
    ) -> bool {
        self.settle();
        self.clock += 1;
        self.room = room.max(MAX_RESIDENTS);
        if self.made >= MAX_SURFACES {
            self.restart(memory);
        }
        let Some(surface) = self.resident(memory, color, (width, height), false) else {
            return false;
        };
        let at = self.residents.iter().position(|r| r.surface == surface).unwrap_or(0);
        let size = (self.residents[at].width, self.residents[at].height);
        let depth = match depth {
            DepthBuffer::At(place) => self.resident(memory, place, size, true),
            DepthBuffer::Missing => None,
            // Changing the target would draw all that waits.
            DepthBuffer::Unused => self.depth.filter(|&kept| {
                self.color == Some(surface) && self.residents.iter().any(|r| r.surface == kept)
            }),
        };
        let set = self.engine.set_target(surface, depth).is_ok();
        (self.color, self.depth) = (set.then_some(surface), depth);
        set
    }

    /// The resident of a place, made where there is none of at least that size
    /// (of that very size, for `exact`).
    fn resident(
        &mut self,
        memory: &mut VideoMemory,
        place: Place,
        (width, height): (u32, u32),
        exact: bool,
    ) -> Option<SurfaceId> {
        let fits = |r: &Resident| match exact {
            true => (r.width, r.height) == (width, height),
            false => r.width >= width && r.height >= height,
        };
        let clock = self.clock;
        if let Some(found) = self.residents.iter_mut().find(|r| r.place == place && fits(r)) {
            found.used = clock;
            return Some(found.surface);
        }
        let area = Resident::area_of(&place, (width, height), memory.len());
        self.drop_residents(memory, |r| r.place == place || r.area.overlaps(&area));
        while self.residents.len() >= self.room {
            let oldest = self.residents.iter().map(|r| r.used).min();
            self.drop_residents(memory, |r| Some(r.used) == oldest);
        }
        let surface = self.engine.create_surface(width, height, place.kind.engine_format()).ok()?;
        self.made += 1;
        let dirty = Rect::default();
        let resident = Resident { place, width, height, area, surface, dirty, used: clock };
        let all = Rect::new(0, 0, resident.columns(), area.rows);
        self.residents.push(resident);
        self.load(memory, self.residents.len() - 1, &all);
        Some(surface)
    }

    /// Writes residents back and forgets them.
    fn drop_residents(&mut self, memory: &mut VideoMemory, which: impl Fn(&Resident) -> bool) {
        for at in (0..self.residents.len()).rev() {
            if which(&self.residents[at]) {
                self.write_back(memory, at);
                let gone = self.residents.swap_remove(at);
                if self.color == Some(gone.surface) || self.depth == Some(gone.surface) {
                    (self.color, self.depth) = (None, None);
                }
                // It is there: it was made here and is destroyed only here.
                let _ = self.engine.destroy_surface(gone.surface);
            }
        }
    }

    /// A new engine, without surfaces.
    fn restart(&mut self, memory: &mut VideoMemory) {
        self.drop_residents(memory, |_| true);
        if let Ok(engine) = Device::new(self.config.clone()) {
            self.counters = self.counters();
            self.engine = engine;
            self.made = 0;
        }
    }

    /// Starts over after the engine broke off. Pixels that it still gives are
    /// written back.
    pub fn recover(&mut self, memory: &mut VideoMemory) {
        self.settle();
        for at in 0..self.residents.len() {
            let save = AssertUnwindSafe(|| self.write_back(memory, at));
            if catch_unwind(save).is_err() {
                let Area { base, rows, .. } = self.residents[at].area;
                eprintln!("fillrate: RRedline: pixels drawn at {base:#x}, {rows} rows, are lost");
            }
        }
        let counters = catch_unwind(AssertUnwindSafe(|| self.counters()));
        if let Ok(engine) = Device::new(self.config.clone()) {
            self.counters = counters.unwrap_or(self.counters);
            self.engine = engine;
            self.made = 0;
        }
        self.residents.clear();
        (self.color, self.depth) = (None, None);
    }

    /// Copies pixels from memory into a resident's surface.
    fn load(&mut self, memory: &VideoMemory, at: usize, rect: &Rect) {
        let Resident { place, area, surface, .. } = self.residents[at];
        let Ok(surface) = self.engine.surface(surface) else { return };
        let bytes = place.kind.bytes();
        let mut pixels = Vec::new();
        for y in rect.y0..rect.y1 {
            let from = area.base + y * area.pitch + rect.x0 * bytes;
            let row = memory.get(from, (rect.x1 - rect.x0) * bytes);
            let row = row.chunks_exact(bytes as usize).map(pixel_of);
            pixels.clear();
            pixels.extend(row.map(|pixel| place.kind.exchange(pixel)));
            surface.write_run(rect.x0, y, &pixels);
        }
    }

    /// Copies what is newer in a resident to memory.
    fn write_back(&mut self, memory: &mut VideoMemory, at: usize) {
        let Resident { place, area, surface, dirty, .. } = self.residents[at];
        if dirty.is_empty() {
            return;
        }
        self.residents[at].dirty = Rect::default();
        let Ok(surface) = self.engine.surface(surface) else { return };
        let bytes = place.kind.bytes();
        let mut pixels = vec![0; (dirty.x1 - dirty.x0) as usize];
        for y in dirty.y0..dirty.y1 {
            let to = area.base + y * area.pitch + dirty.x0 * bytes;
            let row = memory.get_mut(to, (dirty.x1 - dirty.x0) * bytes);
            surface.read_run(dirty.x0, y, &mut pixels);
            for (&pixel, out) in pixels.iter().zip(row.chunks_exact_mut(bytes as usize)) {
                let pixel = place.kind.exchange(pixel);
                out.copy_from_slice(&pixel.to_le_bytes()[..out.len()]);
            }
        }
    }

    /// Brings memory up to date in an area, for reading.
    pub fn sync(&mut self, memory: &mut VideoMemory, area: &Area) {
        self.settle();
        for at in 0..self.residents.len() {
            if !self.residents[at].dirty.is_empty() && self.residents[at].area.overlaps(area) {
                self.write_back(memory, at);
            }
        }
    }

    /// Writes bytes that follow one another, into memory and into residents.
    pub fn write(&mut self, memory: &mut VideoMemory, address: u32, bytes: &[u8]) {
        self.settle();
        let line = Area::line(address, bytes.len() as u32);
        for at in 0..self.residents.len() {
            let resident = &self.residents[at];
            // Of pixels that are written in part the rest must be in memory.
            let cut = |at: u64| !at.is_multiple_of(u64::from(resident.place.kind.bytes()));
            let base = u64::from(resident.area.base);
            let ragged =
                cut(line.end().wrapping_sub(base)) || cut(u64::from(address).wrapping_sub(base));
            if ragged && !resident.dirty.is_empty() && resident.area.overlaps(&line) {
                self.write_back(memory, at);
            }
        }
        memory.write(address, bytes);
        for at in 0..self.residents.len() {
            if self.residents[at].area.overlaps(&line) {
                let rows = self.residents[at].rows_of(&line);
                rows.for_each(|row| self.load(memory, at, &row));
            }
        }
    }

    /// Fills an area with a pixel value through the engine, where it is a
    /// rectangle of a resident; false where it is not.
    pub fn clear(&mut self, area: &Area, value: u32) -> bool {
        self.settle();
        let Some(at) = self.residents.iter().position(|r| r.area.overlaps(area)) else {
            return false;
        };
        let resident = &self.residents[at];
        let (kind, surface) = (resident.place.kind, resident.surface);
        let Some(rect) = resident.rect_of(area) else { return false };
        let repeats = match kind.bytes() {
            1 => value == (value & 0xff) * 0x0101_0101,
            2 => value >> 16 == value & 0xffff,
            _ => true,
        };
        // Only the target's surfaces can be cleared.
        let values = match kind {
            Kind::Depth if self.depth == Some(surface) => {
                ClearValues { color: None, aux: Some(value & 0xffff) }
            }
            Kind::Color { format, .. }
                if self.color == Some(surface) && format != PixFmt::Gray8 =>
            {
                let mask = kind.engine_format().element_mask();
                let argb = unpack_element(kind.engine_format(), kind.exchange(value & mask));
                ClearValues { color: Some((argb, Dither::Off)), aux: None }
            }
            _ => return false,
        };
        if !repeats {
            return false;
        }
        self.engine.clear(rect, values);
        self.residents[at].add_dirty(&rect);
        true
    }

    /// Notes that the target changes within a rectangle that is not empty.
    #[inline(always)]
    pub fn drawn(&mut self, rect: &Rect, depth: bool) {
        if depth != self.drawn.depth {
            self.settle();
            self.drawn.depth = depth;
        }
        self.drawn.rect = around(&self.drawn.rect, rect);
    }

    /// Tells the target's residents where it was drawn. Due before anything asks
    /// residents, and before the target changes.
    #[inline(never)]
    fn settle(&mut self) {
        let Drawn { rect, depth } = std::mem::replace(&mut self.drawn, Drawn::NOWHERE);
        let (color, aux) = (self.color, self.depth.filter(|_| depth));
        for resident in &mut self.residents {
            if Some(resident.surface) == color || Some(resident.surface) == aux {
                resident.add_dirty(&rect);
            }
        }
    }
}

impl Resident {
    /// The memory behind a surface of this size.
    pub fn area_of(place: &Place, (width, height): (u32, u32), memory: u32) -> Area {
        let columns = width.min(place.columns());
        let rows = height.min(place.rows(columns, memory));
        let row = columns * place.kind.bytes();
        Area { base: place.base, pitch: place.pitch, row, rows }
    }

    /// The pixels that an area consists of, where they are a rectangle.
    fn rect_of(&self, area: &Area) -> Option<Rect> {
        let bytes = self.place.kind.bytes();
        let offset = area.base.checked_sub(self.area.base)?;
        if (area.pitch != self.area.pitch && area.rows > 1) || self.area.pitch == 0 {
            return None;
        }
        let (x, y) = (offset % self.area.pitch, offset / self.area.pitch);
        let fits = x + area.row <= self.area.row && y + area.rows <= self.area.rows;
        if !fits || x % bytes != 0 || !area.row.is_multiple_of(bytes) {
            return None;
        }
        Some(Rect::new(x / bytes, y, (x + area.row) / bytes, y + area.rows))
    }
}

/// A pixel of one, two or four bytes.
fn pixel_of(bytes: &[u8]) -> u32 {
    match *bytes {
        [a] => u32::from(a),
        [a, b] => u32::from(u16::from_le_bytes([a, b])),
        [a, b, c, d] => u32::from_le_bytes([a, b, c, d]),
        _ => 0,
    }
}
