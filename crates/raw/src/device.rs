//! The reference renderer: the single-tile build, all four stages in one thread.
//!
//! A host pushes command words and takes reply words; see [`crate::opcode`] for the commands.
//! Source: RAW, chapter 4 and the single-tile listing.

use std::collections::VecDeque;

use fillrate_engine::target::TileSize;
use fillrate_simd::Level;

use crate::errata::Errata;
use crate::error::StreamError;
use crate::framebuffer::Pages;
use crate::observer::Observer;
use crate::opcode::Opcode;
use crate::painter::{self, Painter};
use crate::stage::composite::{self, Target};
use crate::stage::raster::Rasterizer;
use crate::stage::{InputVertex, TransPrim, combine, geometry, ordering};
use crate::state::{PrimInfo, RenderState};
use crate::stream::{SceneEvent, SceneReader};
use crate::texture::{self, TextureManager};

/// Faults kept for [`Device::take_faults`]; later ones are only counted.
pub(crate) const MAX_FAULTS: usize = 256;

/// The painter uses no surfaces but those it made.
const OWN: &str = "surfaces of the painter's own";

/// The word that says "ready": at boot, on entering a scene and on leaving it.
pub const READY: u32 = 1;

/// The compile-time constants of the original, and its errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Config {
    /// Screen width in pixels, 1..=2048.
    pub width: u32,
    /// Screen height in pixels, 1..=2048.
    pub height: u32,
    /// Texture memory in bytes.
    pub texture_bytes: u32,
    /// Entries of the texture table.
    pub texture_entries: usize,
    /// Which errors of the thesis to keep.
    pub errata: Errata,
    /// Whether commands beyond the thesis are known.
    pub beyond: bool,
    /// Threads that draw, the caller's included; 0 for the scalar reference. The picture is the same.
    pub threads: usize,
    /// SIMD level of the threads. The picture is the same.
    pub level: Level,
    /// Side of the tiles that threads draw. The picture is the same.
    pub tile: TileSize,
}

/// The largest width and height a device accepts.
pub const MAX_SIZE: u32 = 2048;

impl Default for Config {
    fn default() -> Self {
        Self {
            width: 320,
            height: 240,
            texture_bytes: texture::DEFAULT_MEMORY,
            texture_entries: texture::DEFAULT_ENTRIES,
            errata: Errata::CORRECT,
            beyond: true,
            threads: 0,
            level: Level::best(),
            tile: TileSize::default(),
        }
    }
}

impl Config {
    /// This configuration at another resolution, limited to 1..=[`MAX_SIZE`].
    pub fn sized(self, width: u32, height: u32) -> Self {
        Self { width: width.clamp(1, MAX_SIZE), height: height.clamp(1, MAX_SIZE), ..self }
    }
}

/// Words waiting for the host, run-length encoded so that a huge block read stays small.
#[derive(Clone, Debug, Default)]
pub struct Replies {
    runs: VecDeque<(u32, u32)>,
}

impl Replies {
    /// Appends a word `times` times.
    pub fn push(&mut self, word: u32, times: u32) {
        match self.runs.back_mut().filter(|last| last.0 == word) {
            Some(last) if last.1.checked_add(times).is_some() => last.1 += times,
            _ if times > 0 => self.runs.push_back((word, times)),
            _ => {}
        }
    }

    /// Takes the oldest word.
    pub fn pop(&mut self) -> Option<u32> {
        let run = self.runs.front_mut()?;
        run.1 -= 1;
        let word = run.0;
        if run.1 == 0 {
            self.runs.pop_front();
        }
        Some(word)
    }
}

fn initial_state(config: &Config) -> RenderState {
    RenderState { thesis_only: !config.beyond, ..RenderState::default() }
}

/// Everything commands act on: state, textures, buffers. Shared with the simulator.
#[derive(Clone, Debug)]
pub struct Core {
    /// The configuration.
    pub config: Config,
    /// The render state.
    pub state: RenderState,
    /// Texture memory.
    pub textures: TextureManager,
    /// Frame buffer, depth buffer and draw pages.
    pub target: Target,
}

impl Core {
    /// The state after power-on.
    pub fn new(config: Config) -> Self {
        let config = config.sized(config.width, config.height);
        Self {
            config,
            state: initial_state(&config),
            textures: TextureManager::new(
                config.texture_bytes,
                config.texture_entries,
                config.errata,
            ),
            target: Target::new(config.width, config.height),
        }
    }

    /// Pixels of the screen.
    pub fn screen(&self) -> u64 {
        self.target.depth.depths().len() as u64
    }

    /// Carries out a command-mode command whose fixed parameters are `p`.
    ///
    /// Data words of a block follow through [`Core::block_word`]. Scene, halt and unknown commands
    /// do nothing here.
    pub fn execute(&mut self, op: Opcode, p: &[u32], replies: &mut Replies) {
        if self.state.execute(op, p, &self.config.errata) {
            return;
        }
        match op {
            Opcode::ClearFb => self.target.frame.clear(Pages::from_word(p[0]), p[1]),
            Opcode::ClearZ => self.target.depth.clear(),
            Opcode::SetPage => self.target.pages = Pages::from_word(p[0]),
            Opcode::FlipPage => self.target.frame.flip(),
            Opcode::AllocateTexture => replies.push(self.textures.allocate(p[0], p[1]), 1),
            Opcode::DeallocTexture => self.textures.deallocate(p[0]),
            Opcode::TexMemAvail => replies.push(self.textures.available(), 1),
            Opcode::CompactTexMem => self.textures.compact(),
            Opcode::Reset => self.reset(),
            Opcode::AllocateMipMapped => {
                replies.push(self.textures.allocate_mipmapped(p[0], p[1]), 1);
            }
            Opcode::MakeMipMaps => self.textures.make_levels(p[0]),
            Opcode::Resize => self.resize(p[0], p[1]),
            _ => self.access_buffers(op, p, replies),
        }
    }

    fn access_buffers(&mut self, op: Opcode, p: &[u32], replies: &mut Replies) {
        let at = |i: usize| p.get(i).copied().unwrap_or(0);
        let address = self.target.frame.address(at(0), at(1));
        match op {
            Opcode::WriteFb => self.target.frame.write(address, Pages::from_word(p[2]), p[3]),
            Opcode::ReadFb => replies.push(self.target.frame.read(address, p[2] != 0), 1),
            Opcode::WriteZ => self.target.depth.write(address, p[2] as i32),
            Opcode::ReadZ => replies.push(self.target.depth.read(address) as u32, 1),
            Opcode::ReadFbBlock => {
                self.read_block(address, p[3], replies, |target, a| target.frame.read(a, p[2] != 0))
            }
            Opcode::ReadZBlock => {
                self.read_block(address, p[2], replies, |target, a| target.depth.read(a) as u32);
            }
            _ => {}
        }
    }

    fn read_block(
        &self,
        address: u64,
        count: u32,
        replies: &mut Replies,
        read: impl Fn(&Target, u64) -> u32,
    ) {
        let inside = self.screen().saturating_sub(address).min(u64::from(count)) as u32;
        let inside = if self.config.errata.blocks_do_nothing { 0 } else { inside };
        for offset in 0..u64::from(inside) {
            replies.push(read(&self.target, address + offset), 1);
        }
        replies.push(0, count - inside);
    }

    /// Changes the resolution; sizes no device has are ignored.
    fn resize(&mut self, width: u32, height: u32) {
        if (1..=MAX_SIZE).contains(&width) && (1..=MAX_SIZE).contains(&height) {
            self.config = self.config.sized(width, height);
            let pages = self.target.pages;
            self.target = Target { pages, ..Target::new(width, height) };
        }
    }

    /// The fault of a command whose parameters `p` name a texture that does not exist.
    pub(crate) fn texture_fault(&self, op: Opcode, p: &[u32], offset: u64) -> Option<StreamError> {
        let names =
            matches!(op, Opcode::UploadTexture | Opcode::DeallocTexture | Opcode::MakeMipMaps);
        let id = *p.first().filter(|_| names)?;
        self.textures.get(id).is_none().then_some(StreamError::Texture { id, offset })
    }

    /// Takes data word number `index` of the block command `op` with the parameters `p`.
    pub fn block_word(&mut self, op: Opcode, p: &[u32], index: u32, word: u32) {
        let offset = u64::from(index);
        match op {
            Opcode::UploadTexture => self.textures.upload_word(p[0], index as usize, word),
            _ if self.config.errata.blocks_do_nothing => {}
            Opcode::WriteFbBlock => {
                let address = self.target.frame.address(p[0], p[1]) + offset;
                self.target.frame.write(address, Pages::from_word(p[2]), word);
            }
            Opcode::WriteZBlock => {
                let address = self.target.frame.address(p[0], p[1]) + offset;
                self.target.depth.write(address, word as i32);
            }
            _ => {}
        }
    }

    /// The reset command: everything but the frame-buffer contents goes back to its default.
    pub fn reset(&mut self) {
        self.state = initial_state(&self.config);
        self.textures.reset();
        self.target.pages = Pages::BACK;
        self.target.depth.clear();
        self.target.frame.reset();
    }
}

#[derive(Clone, Debug)]
enum Mode {
    Command,
    Params(Opcode),
    Block { op: Opcode, index: u32, count: u32 },
    Scene(Box<SceneReader>),
    Halted,
}

/// The single-tile device. `O` watches the work for the cost model; `()` watches nothing.
#[derive(Debug)]
pub struct Device<O = ()> {
    core: Core,
    mode: Mode,
    params: Vec<u32>,
    replies: Replies,
    faults: Vec<StreamError>,
    offset: u64,
    fragments: u64,
    /// Primitives that wait for the fast path.
    queue: Vec<TransPrim>,
    /// The fast path, once something was drawn with it.
    painter: Option<Box<Painter>>,
    observer: O,
}

impl Device {
    /// A booted device: the ready word waits for the host.
    pub fn new(config: Config) -> Self {
        Self::observed(config, ())
    }
}

impl<O: Observer> Device<O> {
    /// As [`Device::new`], with an observer of the work.
    pub fn observed(config: Config, observer: O) -> Self {
        let mut replies = Replies::default();
        replies.push(READY, 1);
        Self {
            core: Core::new(config),
            mode: Mode::Command,
            params: Vec::new(),
            replies,
            faults: Vec::new(),
            offset: 0,
            fragments: 0,
            queue: Vec::new(),
            painter: None,
            observer,
        }
    }

    /// State, textures and buffers; with threads, the buffers may lack what [`Device::flush`] brings.
    pub fn core(&self) -> &Core {
        &self.core
    }

    /// State, textures and buffers, without the device.
    pub fn into_core(mut self) -> Core {
        self.flush();
        self.core
    }

    /// State, textures and buffers, for set-up from outside the command stream.
    pub fn core_mut(&mut self) -> &mut Core {
        self.flush();
        if let Some(painter) = &mut self.painter {
            painter.buffers_changed();
        }
        &mut self.core
    }

    /// The observer.
    pub fn observer(&self) -> &O {
        &self.observer
    }

    /// The observer, to change it.
    pub fn observer_mut(&mut self) -> &mut O {
        &mut self.observer
    }

    /// Whether the device is in scene-streaming mode.
    pub fn in_scene(&self) -> bool {
        matches!(self.mode, Mode::Scene(_))
    }

    /// Whether the device was halted, or hung as the listing would.
    pub fn is_halted(&self) -> bool {
        matches!(self.mode, Mode::Halted)
    }

    /// Words pushed so far: the place of the next one in the stream.
    pub fn words(&self) -> u64 {
        self.offset
    }

    /// Fragments made so far.
    pub fn fragments(&self) -> u64 {
        self.fragments
    }

    /// Takes the next reply word, if one is waiting.
    pub fn pop_reply(&mut self) -> Option<u32> {
        self.replies.pop()
    }

    /// Drops the reply words that are waiting.
    pub fn drop_replies(&mut self) {
        self.replies = Replies::default();
    }

    /// The faults found since the last call, oldest first; at most 256 are kept.
    pub fn take_faults(&mut self) -> Vec<StreamError> {
        std::mem::take(&mut self.faults)
    }

    /// Pushes a run of words.
    pub fn push_all(&mut self, words: &[u32]) {
        words.iter().for_each(|word| self.push(*word));
    }

    /// Pushes one command word.
    pub fn push(&mut self, word: u32) {
        self.observer.word();
        match std::mem::replace(&mut self.mode, Mode::Halted) {
            Mode::Command => self.opcode(word),
            Mode::Params(op) => self.param(op, word),
            Mode::Block { op, index, count } => {
                self.core.block_word(op, &self.params, index, word);
                if !self.core.config.errata.blocks_do_nothing {
                    self.observer.buffers(op.of_one_word(), self.core.screen());
                }
                self.block(op, index + 1, count);
            }
            Mode::Scene(reader) => self.scene_word(reader, word),
            Mode::Halted => self.fault(StreamError::Halted { offset: self.offset }),
        }
        self.offset += 1;
    }

    fn fault(&mut self, fault: StreamError) {
        if self.faults.len() < MAX_FAULTS {
            self.faults.push(fault);
        }
    }

    fn opcode(&mut self, word: u32) {
        self.mode = Mode::Command;
        self.params.clear();
        match Opcode::in_command_mode(word).filter(|op| self.core.state.allows(*op)) {
            None => self.fault(StreamError::Opcode { word, offset: self.offset, mode: "command" }),
            Some(op) if op.inputs() == 0 => self.run(op),
            Some(op) => self.mode = Mode::Params(op),
        }
    }

    fn param(&mut self, op: Opcode, word: u32) {
        self.params.push(word);
        if self.params.len() == op.inputs() { self.run(op) } else { self.mode = Mode::Params(op) }
    }

    fn run(&mut self, op: Opcode) {
        self.observer.command(op);
        self.mode = Mode::Command;
        match op {
            Opcode::BeginScene => {
                self.replies.push(READY, 1);
                self.mode = Mode::Scene(Box::default());
            }
            Opcode::Halt => self.mode = Mode::Halted,
            _ => {
                if let Some(fault) = self.core.texture_fault(op, &self.params, self.offset) {
                    self.fault(fault);
                }
                self.observer.buffers(op, self.core.screen());
                if !self.clear(op) {
                    self.lend_buffers(op);
                    self.core.execute(op, &self.params, &mut self.replies);
                }
                if let Some(at) = op.data_length_at() {
                    self.block(op, 0, self.params[at]);
                }
            }
        }
    }

    fn block(&mut self, op: Opcode, index: u32, count: u32) {
        self.mode = if index < count { Mode::Block { op, index, count } } else { Mode::Command };
    }

    fn scene_word(&mut self, mut reader: Box<SceneReader>, word: u32) {
        let errata = self.core.config.errata;
        match reader.push(word, self.offset, &mut self.core.state, &errata) {
            SceneEvent::More | SceneEvent::Empty => {}
            SceneEvent::Vertex => self.observer.command(Opcode::Vertex),
            SceneEvent::State(op) => self.observer.command(op),
            SceneEvent::Primitive(vertices) => self.primitive(&vertices),
            SceneEvent::EndScene => {
                self.observer.command(Opcode::EndScene);
                self.draw_queue();
                self.replies.push(READY, 1);
                self.mode = Mode::Command;
                return;
            }
            SceneEvent::Fault(fault) => {
                let hung = matches!(fault, StreamError::Hung { .. });
                self.fault(fault);
                if hung {
                    return;
                }
            }
        }
        self.mode = Mode::Scene(reader);
    }

    fn primitive(&mut self, vertices: &[InputVertex]) {
        let errata = self.core.config.errata;
        let mut info = self.core.state.prim;
        let unordered = ordering::is_unordered(info.mode, vertices, &errata);
        info.seq_num = ordering::number(&mut self.core.state, unordered, &errata).seq_num;
        info.mode.set_out_of_order(u32::from(unordered));
        let (parts, work) = geometry::process(&mut self.core.state, info, vertices, &errata);
        self.observer.primitive(&work);
        if !work.visible {
            return;
        }
        if O::WATCHES || self.core.config.threads == 0 {
            parts.iter().for_each(|part| self.draw(part));
            return;
        }
        self.queue.extend(parts.iter());
        if self.queue.len() >= painter::MAX_QUEUED {
            self.draw_queue();
        }
    }

    /// Draws what waits for the fast path, as the end of a scene does by itself, and brings the
    /// buffers up to date.
    pub fn flush(&mut self) {
        self.draw_queue();
        if let Some(painter) = &mut self.painter {
            painter.update_buffers(&mut self.core.target).expect(OWN);
        }
    }

    /// Draws what waits for the fast path.
    fn draw_queue(&mut self) {
        if self.queue.is_empty() {
            return;
        }
        let queue = std::mem::take(&mut self.queue);
        if self.painter.is_none() {
            self.painter = Painter::new(&self.core.config).map(Box::new).ok();
        }
        match &mut self.painter {
            Some(painter) => {
                self.fragments += painter.draw(&mut self.core, &queue).expect(OWN);
            }
            // Without threads to start, the reference draws the same.
            None => queue.iter().for_each(|prim| self.draw(prim)),
        }
        self.queue = queue;
        self.queue.clear();
    }

    /// Carries a command out on the fast path's own buffers, if it is a clear.
    fn clear(&mut self, op: Opcode) -> bool {
        let Some(painter) = &mut self.painter else { return false };
        painter.clear(&self.core.target, op, &self.params).expect(OWN)
    }

    /// Brings the buffers up to date before a command reads or writes them.
    fn lend_buffers(&mut self, op: Opcode) {
        if self.painter.is_none() || painter::leaves_buffers(op) {
            return;
        }
        self.core_mut();
        if op == Opcode::Resize {
            self.painter = None;
        }
    }

    /// Back to the state after power-on, whatever the device is doing; the frame buffer keeps its
    /// contents. The ready word waits for the host. Beyond the thesis.
    pub fn reset_now(&mut self) {
        self.core_mut().reset();
        self.mode = Mode::Command;
        self.params.clear();
        self.replies = Replies::default();
        self.replies.push(READY, 1);
    }

    /// Draws a transformed primitive: stages 2 to 4 for each of its fragments.
    pub fn draw(&mut self, prim: &TransPrim) {
        let Config { width, height, errata, .. } = self.core.config;
        let mut walker = Rasterizer::new(&stage2_view(prim, &errata), width, height, &errata);
        self.observer.setup(walker.needs());
        while let Some(fragment) = walker.next() {
            self.fragments += 1;
            let textured = combine::process(&self.core.textures, &prim.info, &fragment, &errata);
            self.observer.fragment(&prim.info, walker.take_work(), &textured);
            let drawn = &textured.fragment;
            let outcome =
                composite::process_at_pixel(&mut self.core.target, prim.info.mode, drawn, &errata);
            let address = self.core.target.frame.address(drawn.x, drawn.y);
            self.observer.composite(prim.info.mode, address, &outcome);
        }
        self.observer.rows(walker.take_work());
    }
}

/// The primitive as the single tile's stage 2 unpacks it: its listing mixes two mode fields up.
fn stage2_view(prim: &TransPrim, errata: &Errata) -> TransPrim {
    let PrimInfo { mut mode, .. } = prim.info;
    if errata.single_tile_mode_mixup {
        let (lit, use_dir) = (mode.lit(), mode.use_dir());
        mode.set_use_dir(lit);
        mode.set_lit_interp(use_dir);
    }
    TransPrim { info: PrimInfo { mode, ..prim.info }, ..*prim }
}
