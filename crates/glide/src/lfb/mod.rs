//! Linear frame buffer access.
//!
//! A lock hands out memory of 1024 pixels a row, and keeps it equal to the
//! buffer: whatever changes the buffer while a lock is held is carried out at
//! once and shown in the memory before the call returns. What a program stored
//! through a write lock is found by comparing, and carried out before the next
//! call that could meet it: those that draw into the same rows, change what
//! becomes of stored pixels, or look at a buffer (`order.rs`). So stores and
//! drawing keep their order, and nobody sees either too late.
//!
//! Comparing cannot see a store of what the memory holds already. It therefore
//! holds pixels whose store would change nothing: the buffer's own, or, where
//! there are no such pixels, noise ([`Showing`]).
//!
//! Source: G246, `grLfbLock`; SST1, linear frame buffer formats.

mod memory;
mod order;
mod pixel;
mod region;
mod write;

pub use self::memory::ROW_PIXELS;
pub(crate) use self::order::Meeting;

use fillrate_engine::SurfaceId;
use fillrate_engine::state::Rect;

use self::memory::Memory;
use self::pixel::{in_mode, key_pixel, noise, pixel_bytes};
use crate::board::Board;
use crate::enums::*;
use crate::registers::{FbiRegisters, fbz, lfb_mode, replace};

/// One lock.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lock {
    pub buffer: i32,
    mode: i32,
    origin: i32,
    pipeline: bool,
    /// Which of the board's memories the program has.
    memory: usize,
    showing: Showing,
    /// zaColor and fbzMode to restore.
    saved: (u32, u32),
}

/// What the memory of a lock holds where nothing was stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Showing {
    /// The buffer, in the lock's mode and the program's colour format. Where
    /// the aux buffer holds alpha, that is what alpha is.
    Buffer { format: i32, alpha_planes: bool },
    /// Chroma-keyed pixels, which the pipeline drops.
    Key(u16),
    /// Noise. Pixels that go through the pipeline can depend on what was drawn
    /// before, so that no pixel is without effect.
    Noise,
}

impl Showing {
    /// The buffer as it is.
    const READ: Showing = Showing::Buffer { format: 0, alpha_planes: false };
}

/// The locks of a board: at most one for reading and one for writing.
#[derive(Debug, Default)]
pub(crate) struct Lfb {
    pub read: Option<Lock>,
    pub write: Option<Lock>,
    /// The memories, by the kind of lock that has them unless it shares the
    /// other's.
    memories: [Memory; 2],
    /// Times that noise was made.
    rounds: u32,
    /// What the calls before 2.4 set: write mode, origin, bypass.
    pub old: OldState,
}

/// Settings of the calls before 2.4.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OldState {
    pub mode: i32,
    pub origin: i32,
    pub pipeline: bool,
}

impl Default for OldState {
    fn default() -> OldState {
        OldState { mode: LFBWRITEMODE_565, origin: 0, pipeline: false }
    }
}

/// What a lock tells the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LfbInfo {
    /// Bytes from one row to the next.
    pub stride: u32,
    /// The resolved write mode.
    pub write_mode: i32,
    /// As asked for.
    pub origin: i32,
}

impl Lfb {
    /// Whether a lock is held.
    pub fn is_held(&self) -> bool {
        self.read.is_some() || self.write.is_some()
    }

    /// The lock of a kind.
    pub fn lock(&self, kind: i32) -> Option<&Lock> {
        if kind & 0xf == LFB_WRITE_ONLY { self.write.as_ref() } else { self.read.as_ref() }
    }
}

impl Lock {
    /// Takes over registers that are to be in force after the lock.
    pub fn keep(&mut self, fbi: &FbiRegisters) {
        self.saved = (fbi.za_color, fbi.fbz_mode);
    }

    fn is_wide(&self) -> bool {
        pixel_bytes(self.mode) == Some(4)
    }

    /// Columns and rows of the memory that a rectangle of the screen is.
    fn place(&self, rect: Rect, height: u32) -> (core::ops::Range<usize>, core::ops::Range<usize>) {
        let (y0, y1) = match self.origin {
            0 => (rect.y0, rect.y1),
            _ => (height - rect.y1, height - rect.y0),
        };
        (rect.x0 as usize..rect.x1 as usize, y0 as usize..y1 as usize)
    }

    /// Whether a lock with this memory would show the same as another.
    fn shows_like(&self, other: &Lock) -> bool {
        let same =
            (self.buffer, self.mode, self.origin) == (other.buffer, other.mode, other.origin);
        // Red and blue are exchanged in what is stored, not in what is read.
        let plain = |lock: &Lock| match lock.showing {
            Showing::Buffer { format, .. } => lock.mode == LFBWRITEMODE_ZA16 || format & 1 == 0,
            _ => false,
        };
        same && !self.pipeline && !other.pipeline && plain(self) && plain(other)
    }
}

/// The write mode that is a buffer's own format.
fn native_mode(buffer: i32) -> i32 {
    if buffer >= BUFFER_AUX { LFBWRITEMODE_ZA16 } else { LFBWRITEMODE_565 }
}

/// The mode that a write lock resolves to; `None` where it does not fit.
fn resolved_mode(buffer: i32, mode: i32) -> Option<i32> {
    let mode = if mode == LFBWRITEMODE_ANY { native_mode(buffer) } else { mode };
    pixel_bytes(mode)?;
    ((mode == LFBWRITEMODE_ZA16) == (buffer >= BUFFER_AUX)).then_some(mode)
}

/// The screen row of a lock's row. Any origin but the upper left counts as
/// lower left.
fn screen_row(origin: i32, y: usize, height: usize) -> usize {
    match origin {
        0 => y,
        _ => height - 1 - y,
    }
}

impl Board {
    fn surface_of(&self, buffer: i32) -> Option<SurfaceId> {
        match buffer {
            BUFFER_FRONT | BUFFER_BACK => self.color_surface(buffer as u32),
            // 3 and 4 name the aux buffer by its use.
            2..=4 => self.buffers.as_ref()?.aux,
            _ => None,
        }
    }

    /// All pixels of the screen.
    pub(crate) fn screen(&self) -> Rect {
        let (width, height) = self.buffers.as_ref().map_or((0, 0), |b| (b.width, b.height));
        Rect::new(0, 0, width, height)
    }

    /// Starts a lock; `None` where it is refused.
    pub(crate) fn lock(
        &mut self,
        kind: i32,
        buffer: i32,
        mode: i32,
        origin: i32,
        pipeline: bool,
    ) -> Option<LfbInfo> {
        let writes = match kind & 0xf {
            LFB_READ_ONLY => false,
            LFB_WRITE_ONLY => true,
            _ => return None,
        };
        // Interleaved boards cannot be read.
        if !writes && self.card.interleaved {
            return None;
        }
        self.commit_stores();
        self.surface_of(buffer)?;
        if self.lfb.lock(kind).is_some() {
            return None;
        }
        let mode = if writes { resolved_mode(buffer, mode)? } else { native_mode(buffer) };
        let (memory, saved) = (usize::from(writes), (self.fbi.za_color, self.fbi.fbz_mode));
        let showing = Showing::Noise;
        let pipeline = pipeline && writes;
        let mut lock = Lock { buffer, mode, origin, pipeline, memory, showing, saved };
        if writes {
            self.fbi.za_color =
                u32::from(self.settings.lfb_depth) | u32::from(self.settings.lfb_alpha) << 24;
            self.fbi.fbz_mode &= !fbz::DEPTH_BIAS;
            self.dirty = true;
        }
        lock.showing = if writes { self.showing(&lock) } else { Showing::READ };
        let other = if writes { self.lfb.read } else { self.lfb.write };
        if let Some(other) = other.filter(|other| lock.shows_like(other)) {
            lock.memory = other.memory;
        }
        let rows = self.screen().y1 as usize;
        let stores = writes.then_some((lock.is_wide(), rows));
        self.lfb.memories[lock.memory].prepare(stores);
        self.show(&lock, self.screen());
        *(if writes { &mut self.lfb.write } else { &mut self.lfb.read }) = Some(lock);
        let stride = (ROW_PIXELS * if lock.is_wide() { 4 } else { 2 }) as u32;
        Some(LfbInfo { stride, write_mode: mode, origin })
    }

    /// Ends a lock and carries out what was stored. False where there is none
    /// of that kind on that buffer.
    pub(crate) fn unlock(&mut self, kind: i32, buffer: i32) -> bool {
        let held = self.lfb.lock(kind).is_some_and(|lock| lock.buffer == buffer);
        match kind & 0xf {
            LFB_READ_ONLY if held => self.lfb.read = None,
            LFB_WRITE_ONLY if held => {
                let stored = self.commit(self.screen());
                self.fbi = self.lasting_registers();
                self.lfb.write = None;
                self.dirty = true;
                self.show_all(stored);
            }
            _ => return false,
        }
        true
    }

    /// Gives the locks that are held the settings of the calls before 2.4,
    /// which set them at any time.
    pub(crate) fn set_up_old_locks(&mut self) {
        let OldState { mode, origin, pipeline } = self.lfb.old;
        let rows = self.screen().y1 as usize;
        if let Some(lock) = &mut self.lfb.read {
            lock.origin = origin;
        }
        if let Some(lock) = &mut self.lfb.write {
            let memory = &mut self.lfb.memories[lock.memory];
            // A memory that a read lock had first has no room for more.
            let fits = |mode: &i32| pixel_bytes(*mode) != Some(4) || memory.holds_wide();
            lock.mode = resolved_mode(lock.buffer, mode).filter(fits).unwrap_or(lock.mode);
            (lock.origin, lock.pipeline) = (origin, pipeline);
            memory.prepare(Some((lock.is_wide(), rows)));
        }
        self.update_showing();
        self.show_all(self.screen());
    }

    /// The memory of a lock.
    pub(crate) fn lock_words(&mut self, kind: i32) -> Option<&mut Vec<u32>> {
        let memory = self.lfb.lock(kind)?.memory;
        Some(&mut self.lfb.memories[memory].words)
    }

    /// The registers without what a write lock changes for its time: constants in
    /// zaColor, and no depth bias.
    pub(crate) fn lasting_registers(&self) -> FbiRegisters {
        let (za_color, mode) =
            self.lfb.write.map_or((self.fbi.za_color, self.fbi.fbz_mode), |lock| lock.saved);
        let fbz_mode = replace(self.fbi.fbz_mode, fbz::DEPTH_BIAS, mode);
        FbiRegisters { za_color, fbz_mode, ..self.fbi }
    }

    /// The colour format of stores: a register of its own, ARGB until it is set.
    ///
    /// Source: G246, `grSstWinOpen`, whatever format that is given.
    pub(super) fn lfb_format(&self) -> i32 {
        (self.fbi.lfb_mode >> lfb_mode::LANES & 3) as i32
    }

    /// Sets it.
    pub(crate) fn set_lfb_format(&mut self, format: i32) {
        let lanes = (format as u32) << lfb_mode::LANES;
        self.fbi.lfb_mode = replace(self.fbi.lfb_mode, lfb_mode::LANES_MASK, lanes);
    }

    /// What the memory of a lock holds, as things are.
    fn showing(&self, lock: &Lock) -> Showing {
        let fbi = &self.fbi;
        let alpha_planes = fbi.fbz_mode & fbz::ALPHA_PLANES != 0;
        let format = self.lfb_format();
        // One bit of alpha is eight in the aux buffer.
        let coarse_alpha = alpha_planes && matches!(lock.mode, 2 | 0xe);
        if self.swizzle_bits() != 0 || coarse_alpha {
            return Showing::Noise;
        }
        if !lock.pipeline || lock.mode != LFBWRITEMODE_ZA16 && self.only_writes_colors() {
            return Showing::Buffer { format, alpha_planes };
        }
        let keyed = fbi.fbz_mode & fbz::CHROMA_KEY != 0;
        let key = key_pixel(lock.mode, format, fbi.chroma_key).filter(|_| keyed);
        key.map_or(Showing::Noise, Showing::Key)
    }

    /// Whether the pipeline writes the colours of ready-made fragments as they
    /// are, once and for ever, and nothing else.
    fn only_writes_colors(&self) -> bool {
        const TESTS: u32 = fbz::CHROMA_KEY | fbz::STIPPLE | fbz::DEPTH_ENABLE | fbz::AUX_WRITE;
        // Alpha test, blending; fog.
        self.fbi.fbz_mode & TESTS == 0
            && self.fbi.alpha_mode & 0x11 == 0
            && self.fbi.fog_mode & 1 == 0
    }

    fn swizzle_bits(&self) -> u32 {
        self.fbi.lfb_mode & (lfb_mode::SWIZZLE_BYTES | lfb_mode::SWAP_WORDS)
    }

    /// Finds out what the memories must hold, after the state changed; what
    /// was stored must have been carried out. Shows it where that is new.
    fn update_showing(&mut self) {
        let Some(mut lock) = self.lfb.write else { return };
        let showing = self.showing(&lock);
        if showing != lock.showing {
            lock.showing = showing;
            self.lfb.write = Some(lock);
            self.show(&lock, self.screen());
            // The memory may be the read lock's, too.
            if let Some(read) = self.lfb.read.filter(|read| read.memory == lock.memory) {
                self.show(&read, self.screen());
            }
        }
    }

    /// Shows the program's locks a rectangle of the screen as it is now.
    pub(crate) fn show_all(&mut self, rect: Rect) {
        for lock in [self.lfb.write, self.lfb.read].into_iter().flatten() {
            self.show(&lock, rect);
        }
    }

    /// Makes the memory of a lock hold a rectangle of the screen.
    fn show(&mut self, lock: &Lock, rect: Rect) {
        let rect = rect.intersect(&self.screen());
        if rect.is_empty() {
            return;
        }
        let mut memory = core::mem::take(&mut self.lfb.memories[lock.memory]);
        let (columns, rows) = lock.place(rect, self.screen().y1);
        match lock.showing {
            Showing::Buffer { .. } => self.show_buffer(lock, rect, &mut memory),
            Showing::Key(key) => {
                for y in rows {
                    for x in columns.clone() {
                        memory.show(false, y * ROW_PIXELS + x, u32::from(key));
                    }
                }
            }
            Showing::Noise => {
                self.lfb.rounds = self.lfb.rounds.wrapping_add(1);
                let wide = lock.is_wide();
                for y in rows {
                    for x in columns.clone() {
                        let at = y * ROW_PIXELS + x;
                        let mask = if wide { u32::MAX } else { 0xffff };
                        let made = noise(at, self.lfb.rounds) & mask;
                        // What was stored here may be stored again.
                        let same = memory.get(wide, x, y) == made;
                        memory.show(wide, at, if same { made ^ 0x0101 } else { made });
                    }
                }
            }
        }
        self.lfb.memories[lock.memory] = memory;
    }

    fn show_buffer(&mut self, lock: &Lock, rect: Rect, memory: &mut Memory) {
        let Showing::Buffer { format, alpha_planes } = lock.showing else { return };
        let (columns, rows) = lock.place(rect, self.screen().y1);
        let (native, wide) = (lock.mode == native_mode(lock.buffer), lock.is_wide());
        // Only stores of these modes reach the aux buffer.
        let deep = if alpha_planes { lock.mode == 5 } else { matches!(lock.mode, 0xc..=0xe) };
        let height = self.screen().y1 as usize;
        let mut colors = vec![0u16; columns.len()];
        let mut aux = vec![0u16; if deep { columns.len() } else { 0 }];
        let as_is = native && (format & 1 == 0 || lock.mode == LFBWRITEMODE_ZA16);
        for y in rows {
            let screen = screen_row(lock.origin, y, height) as u32;
            let row = Rect::new(rect.x0, screen, rect.x1, screen + 1);
            // The surfaces are ours, and have the screen's size.
            if let Some(surface) = self.surface_of(lock.buffer) {
                let _ = self.read_pixels(surface, row, &mut colors, columns.len());
            }
            if let Some(surface) = self.surface_of(BUFFER_AUX).filter(|_| deep) {
                let _ = self.read_pixels(surface, row, &mut aux, columns.len());
            }
            for (i, (x, &color)) in columns.clone().zip(&colors).enumerate() {
                let at = y * ROW_PIXELS + x;
                let value = if as_is {
                    u32::from(color)
                } else {
                    let high = aux.get(i).map_or_else(|| noise(at, 0), |&aux| u32::from(aux));
                    in_mode(lock.mode, format, color, high)
                };
                memory.show(wide, at, value);
            }
        }
    }
}
