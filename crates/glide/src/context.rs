//! A Glide library without global state.

use std::collections::BTreeMap;
use std::sync::Arc;

use fillrate_engine::state::MAX_TMUS;
use fillrate_engine::{Counters, Device, DeviceConfig, DrawState, Texture, Vertex};

use crate::board::Board;
use crate::buffers::Shown;
use crate::card::Card;
use crate::clock::Clock;
use crate::enums::LFB_WRITE_ONLY;
use crate::error::{GlideError, Report, historic_name};
use crate::gu::MultiPass;
use crate::improve::{Improvements, MAX_SCALE};
use crate::lfb::{LfbInfo, Meeting};
use crate::rules::{INFO_SIZE, NOT_OPEN, NULL_POINTER};
use crate::state::STATE_BYTES;
use crate::variables::Variables;
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
    /// Shows the start-up picture when a board is opened, unless
    /// `FX_GLIDE_NO_SPLASH` is among the variables.
    pub splash: bool,
    /// More pixels and colours than the board has.
    pub improve: Improvements,
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
            splash: false,
            improve: Improvements::default(),
            variables: BTreeMap::new(),
        }
    }
}

impl GlideConfig {
    /// The settings that pictures depend on, as keys and values.
    pub fn describe(&self) -> Vec<(String, String)> {
        let card = &self.card;
        let numbers = [
            ("card", card.name.to_string()),
            ("card.frame_buffer", card.frame_buffer.to_string()),
            ("card.units", card.units.to_string()),
            ("card.texture", card.texture.to_string()),
            ("card.interleaved", u8::from(card.interleaved).to_string()),
            ("boards", self.boards.to_string()),
            ("splash", u8::from(self.splash).to_string()),
            ("scale", self.improve.scale.to_string()),
            ("color32", u8::from(self.improve.color32).to_string()),
        ];
        let variables = self.variables.iter();
        let variables = variables.map(|(k, v)| (format!("{VARIABLE_PREFIX}{k}"), v.clone()));
        numbers.into_iter().map(|(k, v)| (k.to_string(), v)).chain(variables).collect()
    }

    /// The configuration that [`GlideConfig::describe`] gave; what is missing
    /// or unknown has its built-in value.
    pub fn from_description(pairs: impl IntoIterator<Item = (String, String)>) -> GlideConfig {
        let mut config = GlideConfig::default();
        for (key, value) in pairs {
            let number = value.parse::<u32>().ok();
            let set = |to: &mut u32| *to = number.unwrap_or(*to);
            match key.as_str() {
                "card" => config.card.name = value.into(),
                "card.frame_buffer" => set(&mut config.card.frame_buffer),
                "card.units" => config.card.units = number.unwrap_or(1) as usize,
                "card.texture" => set(&mut config.card.texture),
                "card.interleaved" => config.card.interleaved = number == Some(1),
                "boards" => config.boards = number.unwrap_or(1) as usize,
                "splash" => config.splash = number == Some(1),
                "scale" => config.improve.scale = number.unwrap_or(1).clamp(1, MAX_SCALE),
                "color32" => config.improve.color32 = number == Some(1),
                other => {
                    if let Some(name) = other.strip_prefix(VARIABLE_PREFIX) {
                        config.variables.insert(name.to_string(), value);
                    }
                }
            }
        }
        config
    }
}

/// Starts the keys of variables in a description.
const VARIABLE_PREFIX: &str = "variable.";

/// The library: boards, the current one, and what went wrong.
#[derive(Debug)]
pub struct Context {
    pub(crate) config: GlideConfig,
    pub(crate) boards: Vec<Board>,
    pub(crate) current: usize,
    pub(crate) initialized: bool,
    pub(crate) reports: Vec<Report>,
    /// A rule told what is wrong with the call that is carried out.
    pub(crate) told: bool,
    pub(crate) variables: Variables,
    /// The mark in the corner is drawn at every swap.
    pub(crate) plug: bool,
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
        if !config.card.is_valid() {
            return Err(GlideError::Card);
        }
        let mut config = config;
        config.improve.scale = config.improve.scale.clamp(1, MAX_SCALE);
        let boards = Vec::new();
        let variables = Variables::new(&config.variables);
        Ok(Context {
            plug: variables.shameless_plug,
            config,
            boards,
            current: 0,
            initialized: false,
            reports: Vec::new(),
            told: false,
            variables,
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
        for _ in 0..self.config.boards.clamp(1, MAX_BOARDS) {
            match Device::new(self.config.device.clone()) {
                Ok(device) => {
                    self.boards.push(Board::new(
                        self.config.card.clone(),
                        device,
                        &self.variables,
                        self.config.improve,
                    ));
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
        self.add_report(function, "", text.into(), true);
    }

    /// Tells of something that would not have ended the program.
    pub(crate) fn warn(&mut self, function: &str, text: impl Into<String>) {
        self.add_report(function, "", text.into(), false);
    }

    /// Adds a report, unless a rule already told what is wrong with the call.
    pub(crate) fn add_report(
        &mut self,
        function: &str,
        argument: &'static str,
        text: String,
        fatal: bool,
    ) {
        if self.reports.len() < MAX_REPORTS && !self.told {
            let function = historic_name(function);
            self.reports.push(Report { function, argument, text, fatal });
        }
    }

    /// In checking mode, tells of a misuse that no rule of the table names.
    pub(crate) fn check(&mut self, holds: bool, function: &str, rule: &str) {
        if !holds && self.config.check {
            self.report(function, rule);
        }
    }

    /// In checking mode, tells of a null pointer, which only the caller sees.
    pub fn null_pointer(&mut self, function: &str) {
        self.tell_of_border(function, NULL_POINTER, true);
    }

    /// In checking mode, tells of a lock's description without its size, which
    /// only the caller sees.
    pub fn wrong_info_size(&mut self, function: &str) {
        self.tell_of_border(function, INFO_SIZE, false);
    }

    fn tell_of_border(&mut self, function: &str, rule: (&'static str, &'static str), fatal: bool) {
        if self.config.check {
            self.told = false;
            let (argument, text) = rule;
            self.add_report(function, argument, text.to_string(), fatal);
        }
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
        self.boards.get(self.current)?.lfb.lock(kind).map(|lock| lock.buffer)
    }

    /// The current board where it is open; tells so otherwise.
    pub(crate) fn board(&mut self, function: &str) -> Option<&mut Board> {
        let open = self.boards.get(self.current).is_some_and(Board::is_open);
        self.check(open, function, NOT_OPEN.1);
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
        if self.config.check {
            self.execute(&crate::Call::GrDrawTriangle { a: *a, b: *b, c: *c });
            return;
        }
        let Some(board) = self.board("grDrawTriangle") else { return };
        if board.is_locked() {
            self.execute(&crate::Call::GrDrawTriangle { a: *a, b: *b, c: *c });
        } else {
            board.draw_triangle([a, b, c]);
        }
    }

    /// The displayed buffer of the current board; `None` while it is closed.
    pub fn shown(&mut self) -> Option<Shown> {
        let board = self.boards.get_mut(self.current)?;
        board.commit_stores();
        board.shown()
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

    /// What the registers of the current board say, in the engine's terms; a
    /// unit whose texel does not count has no texture. `None` while the board
    /// is closed.
    pub fn draw_state(&mut self) -> Option<(DrawState, [Option<Arc<Texture>>; MAX_TMUS])> {
        let board = self.boards.get_mut(self.current).filter(|board| board.is_open())?;
        Some(board.engine_state())
    }

    /// A vertex as the current board hands it to the engine; `None` while the
    /// board is closed.
    pub fn engine_vertex(&mut self, vertex: &GrVertex) -> Option<Vertex> {
        let board = self.boards.get_mut(self.current).filter(|board| board.is_open())?;
        board.update();
        Some(board.rules.convert(vertex))
    }

    /// Pixel and triangle counters of the current board since their resets.
    /// The board's registers have 24 bits.
    pub fn counters(&mut self) -> Counters {
        if let Some(board) = self.boards.get_mut(self.current) {
            board.commit_stores();
        }
        self.boards.get_mut(self.current).map_or_else(Counters::default, Board::counters)
    }

    /// The same since the board was opened, whatever was reset.
    pub fn total_counters(&mut self) -> Counters {
        self.boards.get_mut(self.current).map_or_else(Counters::default, Board::totals)
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

    /// What a program stored through the write lock since it was last carried
    /// out, as data of [`crate::Call::GrLfbStored`]: `None` where nothing
    /// changed. Calls that [`Context::shows_stores`] names, and everything that
    /// this type is asked, carry it out; a recording needs it before them.
    pub fn lfb_stores(&self) -> Option<Vec<u8>> {
        self.boards.get(self.current)?.stores()
    }

    /// Whether a call may carry out what was stored through a lock.
    pub fn shows_stores(&mut self, call: &crate::Call) -> bool {
        use crate::Call;
        let held = self.lfb_locked(LFB_WRITE_ONLY).is_some();
        let own = matches!(
            call,
            Call::GrLfbUnlock { .. } | Call::GrBufferSwap { .. } | Call::GuFbWriteRegion { .. }
        );
        let board = self.boards.get_mut(self.current).filter(|_| held);
        board.is_some_and(|board| own || board.meeting(call) != Meeting::Nothing)
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

    /// The line being shown, 0 in retrace. Looking moves the clock by a line.
    pub fn video_line(&mut self) -> u32 {
        self.look("grSstVideoLine").map_or(0, |clock| clock.video_line())
    }

    /// Whether the beam is in vertical retrace; see [`Context::video_line`].
    pub fn in_retrace(&mut self) -> bool {
        self.look("grSstVRetraceOn").is_some_and(|clock| clock.in_retrace())
    }

    /// Retraces since the board was opened; see [`Context::video_line`].
    pub fn retraces(&mut self) -> u32 {
        self.look("grSstVRetraceTicks").map_or(0, |clock| clock.retraces())
    }

    /// Swaps that wait for their retrace, 0 to 7; see [`Context::video_line`].
    pub fn pending_swaps(&mut self) -> u32 {
        self.look("grBufferNumPending").map_or(0, |clock| clock.pending())
    }

    /// Whether the board has something to do; see [`Context::video_line`].
    pub fn is_busy(&mut self) -> bool {
        self.look("grSstIsBusy").is_some_and(|clock| clock.pending() > 0)
    }

    fn look(&mut self, function: &str) -> Option<&Clock> {
        let board = self.board(function)?;
        board.commit_stores();
        board.clock.look();
        Some(&board.clock)
    }

    /// The status register; see [`Context::video_line`].
    pub fn status(&mut self) -> u32 {
        let Some(board) = self.board("grSstStatus") else { return 0 };
        board.commit_stores();
        board.status()
    }

    /// Bytes of a unit's texture memory; 0 where there is no such unit.
    pub fn texture_memory(&self, tmu: i32) -> u32 {
        let index = usize::try_from(tmu).ok().filter(|&index| index < self.config.card.units);
        index.map_or(0, |_| self.config.card.texture_bytes() as u32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::card::CARDS;

    #[test]
    fn descriptions_hold_what_pictures_depend_on() {
        let mut config = GlideConfig { boards: 3, splash: true, ..GlideConfig::default() };
        config.card = CARDS[8].clone();
        config.variables.insert("SST_GAMMA".into(), "1.3".into());
        let back = GlideConfig::from_description(config.describe());
        assert_eq!(back.card, config.card);
        assert_eq!((back.boards, back.splash), (3, true));
        assert_eq!(back.variables, config.variables);
        let nonsense = [("card.units", "x"), ("boards", "-1"), ("other", "")];
        let nonsense = nonsense.map(|(k, v)| (k.to_string(), v.to_string()));
        assert!(Context::new(GlideConfig::from_description(nonsense)).is_ok());
    }
}
