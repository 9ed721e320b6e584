//! A Glide library without global state.

use std::collections::BTreeMap;

use fillrate_engine::{Counters, Device, DeviceConfig};

use crate::board::Board;
use crate::buffers::Shown;
use crate::card::Card;
use crate::error::{GlideError, Report, historic_name};
use crate::gu::MultiPass;
use crate::lfb::LfbInfo;
use crate::state::STATE_BYTES;
use crate::vertex::GrVertex;

/// The most boards.
pub const MAX_BOARDS: usize = 4;

/// How a library works.
#[derive(Clone, Debug)]
pub struct GlideConfig {
    /// Threads, SIMD level and tile size of every board.
    pub device: DeviceConfig,
    /// The board to model.
    pub card: Card,
    /// How many of them, 1 to [`MAX_BOARDS`].
    pub boards: usize,
    /// Reports every misuse that the documents name.
    pub check: bool,
    /// The original library's environment variables, by name.
    pub variables: BTreeMap<String, String>,
}

impl Default for GlideConfig {
    fn default() -> GlideConfig {
        GlideConfig {
            device: DeviceConfig::default(),
            card: Card::default(),
            boards: 1,
            check: false,
            variables: BTreeMap::new(),
        }
    }
}

/// The library: boards, the current one, and what went wrong.
#[derive(Debug)]
pub struct Context {
    pub(crate) config: GlideConfig,
    pub(crate) boards: Vec<Board>,
    pub(crate) current: usize,
    pub(crate) initialized: bool,
    pub(crate) reports: Vec<Report>,
    pub(crate) multipass: MultiPass,
}

/// Reports kept until somebody takes them.
const MAX_REPORTS: usize = 1024;

impl Context {
    /// A library that has not been started.
    ///
    /// # Errors
    /// [`GlideError::Card`] for memory sizes no board had.
    pub fn new(config: GlideConfig) -> Result<Context, GlideError> {
        let card = &config.card;
        let megabytes = |mb: u32| matches!(mb, 1 | 2 | 4);
        if !(1..=3).contains(&card.units)
            || !megabytes(card.frame_buffer)
            || !megabytes(card.texture)
        {
            return Err(GlideError::Card);
        }
        let boards = Vec::new();
        Ok(Context {
            config,
            boards,
            current: 0,
            initialized: false,
            reports: Vec::new(),
            multipass: MultiPass::default(),
        })
    }

    /// The configuration.
    pub fn config(&self) -> &GlideConfig {
        &self.config
    }

    /// Starts the library; again does nothing.
    pub(crate) fn init(&mut self) {
        if self.initialized {
            return;
        }
        self.initialized = true;
        let no_subtraction = self.config.variables.contains_key("FX_GLIDE_NO_DITHER_SUB");
        for _ in 0..self.config.boards.clamp(1, MAX_BOARDS) {
            match Device::new(self.config.device.clone()) {
                Ok(device) => {
                    let mut board = Board::new(self.config.card, device);
                    board.dither_subtract = !no_subtraction;
                    self.boards.push(board);
                }
                Err(error) => self.report("grGlideInit", error.to_string()),
            }
        }
    }

    /// Closes all boards and stops the library; again does nothing.
    pub(crate) fn shutdown(&mut self) {
        self.boards.clear();
        self.initialized = false;
        self.current = 0;
    }

    /// Tells of a misuse, whatever the mode.
    pub(crate) fn report(&mut self, function: &str, text: impl Into<String>) {
        self.add_report(function, text.into(), true);
    }

    /// Tells of something that would not have ended the program.
    pub(crate) fn warn(&mut self, function: &str, text: impl Into<String>) {
        self.add_report(function, text.into(), false);
    }

    fn add_report(&mut self, function: &str, text: String, fatal: bool) {
        if self.reports.len() < MAX_REPORTS {
            let function = historic_name(function);
            self.reports.push(Report { function, text, fatal });
        }
    }

    /// In checking mode, tells of a broken rule.
    pub(crate) fn check(&mut self, holds: bool, function: &str, rule: &str) {
        if !holds && self.config.check {
            self.report(function, rule);
        }
    }

    /// In checking mode, tells of a misuse that only the caller can see.
    pub fn misuse(&mut self, function: &str, rule: &str) {
        self.check(false, function, rule);
    }

    /// What went wrong since the last call of this.
    pub fn take_reports(&mut self) -> Vec<Report> {
        core::mem::take(&mut self.reports)
    }

    /// Whether [`Context::take_reports`] has something.
    pub fn has_reports(&self) -> bool {
        !self.reports.is_empty()
    }

    /// The buffer under a lock of that kind.
    pub fn lfb_locked(&self, kind: i32) -> Option<i32> {
        let lfb = &self.boards.get(self.current)?.lfb;
        let lock = if kind & 0xf == 1 { &lfb.write } else { &lfb.read };
        lock.as_ref().map(|lock| lock.buffer)
    }

    /// The current board where it is open; tells so otherwise.
    pub(crate) fn board(&mut self, function: &str) -> Option<&mut Board> {
        let open = self.boards.get(self.current).is_some_and(Board::is_open);
        self.check(open, function, "no board is open");
        self.boards.get_mut(self.current).filter(|_| open)
    }

    /// The current board and the number of an existing texture unit of it.
    pub(crate) fn unit(&mut self, function: &str, tmu: i32) -> Option<(&mut Board, usize)> {
        self.board(function)?;
        let units = self.boards[self.current].tmus.len();
        let index = usize::try_from(tmu).ok().filter(|&index| index < units);
        self.check(index.is_some(), function, "there is no such texture unit");
        Some((&mut self.boards[self.current], index?))
    }

    /// Draws a triangle: the hot path, which needs no call value.
    #[inline]
    pub fn draw_triangle(&mut self, a: &GrVertex, b: &GrVertex, c: &GrVertex) {
        if let Some(board) = self.board("grDrawTriangle") {
            board.draw_triangle([a, b, c]);
        }
    }

    /// The displayed buffer of the current board; `None` while it is closed.
    pub fn shown(&mut self) -> Option<Shown> {
        self.boards.get_mut(self.current)?.shown()
    }

    /// Swaps of the current board since it was opened.
    pub fn swaps(&self) -> u64 {
        self.boards.get(self.current).map_or(0, |board| board.swaps)
    }

    /// Columns and rows of the current board; zeros while it is closed.
    pub fn screen_size(&self) -> (u32, u32) {
        let buffers = self.boards.get(self.current).and_then(|board| board.buffers.as_ref());
        buffers.map_or((0, 0), |buffers| (buffers.width, buffers.height))
    }

    /// Pixel and triangle counters of the current board.
    pub fn counters(&mut self) -> Counters {
        self.boards.get_mut(self.current).map_or_else(Counters::default, |b| b.device.counters())
    }

    /// The number of the current board.
    pub fn current_board(&self) -> usize {
        self.current
    }

    /// Boards there are; before the start, those that a start would find.
    pub fn board_count(&self) -> usize {
        self.config.boards.clamp(1, MAX_BOARDS)
    }

    /// The saved state of the current board.
    pub fn state(&mut self) -> Option<[u8; STATE_BYTES]> {
        self.board("grGlideGetState").map(|board| board.save())
    }

    /// Starts frame buffer access; see [`crate::Call::GrLfbLock`].
    pub fn lfb_lock(
        &mut self,
        kind: i32,
        buffer: i32,
        mode: i32,
        origin: i32,
        pipeline: bool,
    ) -> Option<LfbInfo> {
        let info = self.board("grLfbLock")?.lock(kind, buffer, mode, origin, pipeline);
        self.check(info.is_some(), "grLfbLock", "the lock is taken, or buffer and mode do not fit");
        info
    }

    /// The memory of a lock as 32-bit words, for the program to read or write.
    /// It stays in place until the unlock.
    pub fn lfb_memory(&mut self, kind: i32) -> Option<&mut [u32]> {
        let board = self.boards.get_mut(self.current)?;
        board.lock_words(kind).map(Vec::as_mut_slice)
    }

    /// What a program wrote under the write lock, as data of the unlock:
    /// `None` where nothing changed.
    pub fn lfb_written(&self, kind: i32) -> Option<Vec<u8>> {
        let board = self.boards.get(self.current)?;
        let lock = board.lfb.write.as_ref().filter(|_| kind & 0xf == 1)?;
        lock.is_changed().then(|| lock.memory.iter().flat_map(|word| word.to_le_bytes()).collect())
    }

    /// Reads a rectangle; see the front end's `grLfbReadRegion`.
    pub fn lfb_read_region(
        &mut self,
        buffer: i32,
        at: (u32, u32),
        size: (u32, u32),
    ) -> Option<Vec<u16>> {
        self.board("grLfbReadRegion")?.read_region(buffer, at, size)
    }

    /// Reads a rectangle as `guFbReadRegion` did: at most 1024 columns and
    /// rows, rows without gaps.
    pub fn lfb_read_old_region(
        &mut self,
        buffer: i32,
        at: (i32, i32),
        size: (i32, i32),
    ) -> Option<Vec<u16>> {
        self.board("guFbReadRegion")?.read_old_region(buffer, at, size)
    }

    /// The line being shown, 0 in retrace. A clock that moves by looking.
    pub fn video_line(&mut self) -> u32 {
        self.board("grSstVideoLine").map_or(0, Board::video_line)
    }

    /// Whether the beam is in vertical retrace.
    pub fn in_retrace(&mut self) -> bool {
        self.board("grSstVRetraceOn").is_some_and(Board::in_retrace)
    }

    /// The status register of an idle board.
    pub fn status(&mut self) -> u32 {
        self.board("grSstStatus").map_or(0, Board::status)
    }

    /// Bytes of a unit's texture memory; 0 where there is no such unit.
    pub fn texture_memory(&self, tmu: i32) -> u32 {
        let index = usize::try_from(tmu).ok().filter(|&index| index < self.config.card.units);
        index.map_or(0, |_| self.config.card.texture_bytes() as u32)
    }
}
