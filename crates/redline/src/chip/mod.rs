//! The chip: video memory, registers, and what commands do to them.

mod area;
mod blit;
mod block;
mod draw;
mod line;
mod memory;
mod setup;
mod state;
mod target;
mod texture;
mod transfer;
mod translate;
mod window;

pub(crate) use state::State;

use fillrate_engine::{Counters, FlushReason};

use self::area::Area;
use self::draw::Prepared;
use self::memory::VideoMemory;
use self::target::Targets;
use self::texture::TextureCache;
use crate::config::RedlineConfig;
use crate::opcode::Opcode;
use crate::stream::{Command, Commands};

/// The number of a frame marker that breaks off, for tests of what follows.
#[cfg(test)]
pub(crate) const BROKEN_FRAME: u32 = 0x0bad_f4a3;

/// What is on the screen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Scanout {
    /// Address of the first row.
    pub base: u32,
    /// Address of the first odd row in stereo, its own first row.
    pub odd: Option<u32>,
    /// Bytes from one row to the next.
    pub linebytes: u32,
}

/// A Verite chip with its video memory.
#[derive(Debug)]
pub(crate) struct VeriteChip {
    config: RedlineConfig,
    memory: VideoMemory,
    targets: Targets,
    textures: TextureCache,
    state: State,
    /// The state in the engine's terms.
    prepared: Option<Prepared>,
    /// What is shown.
    pub scanout: Scanout,
}

impl VeriteChip {
    /// A chip after power-on.
    ///
    /// # Errors
    /// Those of the engine's device.
    pub fn new(config: &RedlineConfig) -> Result<VeriteChip, fillrate_engine::EngineError> {
        Ok(VeriteChip {
            config: config.clone(),
            memory: VideoMemory::new(config.memory_bytes()),
            targets: Targets::new(&config.device)?,
            textures: TextureCache::default(),
            state: State::default(),
            prepared: None,
            scanout: Scanout::default(),
        })
    }

    /// Carries out a stream that has been checked, from word `at` on; stops at
    /// an error. `at` is always the word of the command being carried out.
    pub fn execute(&mut self, words: &[u32], at: &mut usize) {
        let mut commands = Commands::starting(words, *at, self.config.chip);
        while let Some(Ok(command)) = commands.next() {
            self.command(command);
            *at = commands.position();
            if self.is_in_one_window() {
                self.triangles_alike(&mut commands, at);
            }
        }
    }

    /// Triangles that follow one of their kind. Nothing between them changes what
    /// they mean.
    fn triangles_alike(&mut self, commands: &mut Commands<'_>, at: &mut usize) {
        while let Some((vertex, words)) = commands.next_alike() {
            let (a, rest) = words.split_at(vertex.words());
            let (b, c) = rest.split_at(vertex.words());
            self.triangle(vertex.layout(), a, b, c);
            *at = Commands::position(commands);
        }
    }

    /// Passes a command.
    pub fn skip(&self, words: &[u32], at: &mut usize) {
        let mut commands = Commands::starting(words, *at, self.config.chip);
        commands.next();
        *at = commands.position();
    }

    /// Makes the chip usable after a command broke off: what the engine had
    /// drawn is saved if that can be done, and the engine is started anew.
    pub fn recover(&mut self) {
        self.invalidate();
        self.textures = TextureCache::default();
        self.targets.recover(&mut self.memory);
    }

    fn command(&mut self, command: Command<'_>) {
        match command {
            Command::State { register, mask, value } => {
                if self.state.set(register, mask, value) {
                    self.invalidate();
                }
            }
            Command::CurrentTexture(words) => {
                self.state.set_texture(words);
                self.invalidate();
            }
            Command::TexturePalette(words) => {
                self.state.set_palette(words);
                self.invalidate();
            }
            Command::Draw { opcode, vertex, head, vertices } => {
                self.in_windows(|chip| chip.draw(opcode, vertex, head, vertices));
            }
            Command::Other { opcode, flags, words } => self.other(opcode, flags, words),
        }
    }

    fn other(&mut self, opcode: Opcode, flags: u32, words: &[u32]) {
        match opcode {
            Opcode::ContextInit => {
                self.state = State::default();
                self.invalidate();
            }
            Opcode::Display => self.show(words[0], None),
            Opcode::StereoDisplay => self.show(words[1], Some(words[0])),
            Opcode::MemWrite => self.mem_write(words),
            Opcode::MemWriteRect => self.mem_write_rect(words),
            Opcode::MemClearRect => self.mem_clear_rect(words),
            Opcode::MemWriteSprite => self.mem_write_sprite(words),
            Opcode::Bitblt => self.bitblt(words),
            Opcode::Bitfill => self.bitfill(words),
            #[cfg(test)]
            Opcode::FrameMarker if words[1] == BROKEN_FRAME => panic!("asked for by a test"),
            // The display switches at once, and nobody reads timers, markers or
            // a palette that a 16-bit display does not use.
            Opcode::WaitDisplaySwitch
            | Opcode::SyncAndRespond
            | Opcode::RleHack
            | Opcode::Palette
            | Opcode::TimerFuncs
            | Opcode::FrameMarker => {}
            _ => self.in_windows(|chip| chip.draw_other(opcode, flags, words)),
        }
    }

    /// Shows other rows. The frame is drawn while the next one comes.
    fn show(&mut self, base: u32, odd: Option<u32>) {
        (self.scanout.base, self.scanout.odd) = (base, odd);
        self.targets.engine.submit(FlushReason::Swap);
    }

    /// Commands that draw without vertices.
    fn draw_other(&mut self, opcode: Opcode, flags: u32, words: &[u32]) {
        match opcode {
            Opcode::IntLine => self.int_line(flags & 1 != 0, words[0], words[1]),
            Opcode::IntPolyline => self.int_polyline(flags & 1 != 0, &words[1..]),
            Opcode::TriFill => self.triangle_fill(words),
            Opcode::Affine => self.affine(words),
            Opcode::Warp => self.warp(words),
            Opcode::Particles => self.particles(words),
            Opcode::BitbltMem => self.bitblt_mem(words),
            Opcode::Lookup => self.lookup(words),
            Opcode::CompositeRect => self.composite_rect(words),
            Opcode::FtriKxyz
            | Opcode::FtriKxyzuvq
            | Opcode::FtriKfxyzuvq
            | Opcode::FtriKsxyz
            | Opcode::FtriKsxyzuvq => self.fast_triangle(opcode, words),
            _ => {}
        }
    }

    /// Rows of bytes, as they are now; bytes beyond the memory are 0.
    pub fn read_rows(&mut self, base: u32, pitch: u32, row: u32, rows: u32) -> Vec<u8> {
        self.targets.sync(&mut self.memory, &Area { base, pitch, row, rows });
        self.memory.read_rows(base, pitch, row, rows)
    }

    /// Bytes to an address; those beyond the memory are dropped.
    pub fn write_bytes(&mut self, address: u32, bytes: &[u8]) {
        self.targets.write(&mut self.memory, address, bytes);
        self.invalidate();
    }

    /// What was drawn so far.
    pub fn counters(&mut self) -> Counters {
        self.targets.counters()
    }
}
