//! The chip: video memory, registers, and what commands do to them.

mod memory;
mod state;
mod transfer;

pub(crate) use state::State;

use self::memory::VideoMemory;
use crate::config::RedlineConfig;
use crate::opcode::Opcode;
use crate::stream::{Command, Commands};

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
    state: State,
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
            state: State::default(),
            scanout: Scanout::default(),
        })
    }

    /// Carries out a stream that has been checked; stops at an error.
    pub fn execute(&mut self, words: &[u32]) {
        for command in Commands::new(words, self.config.chip).map_while(Result::ok) {
            self.command(command);
        }
    }

    fn command(&mut self, command: Command<'_>) {
        match command {
            Command::State { register, mask, value } => self.state.set(register, mask, value),
            Command::CurrentTexture(words) => self.state.set_texture(words),
            Command::TexturePalette(words) => self.state.set_palette(words),
            Command::Draw { .. } => {}
            Command::Other { opcode, words, .. } => self.other(opcode, words),
        }
    }

    fn other(&mut self, opcode: Opcode, words: &[u32]) {
        match opcode {
            Opcode::ContextInit => self.state = State::default(),
            Opcode::Display => (self.scanout.base, self.scanout.odd) = (words[0], None),
            Opcode::StereoDisplay => {
                (self.scanout.base, self.scanout.odd) = (words[1], Some(words[0]));
            }
            Opcode::MemWrite => self.mem_write(words),
            Opcode::MemWriteRect => self.mem_write_rect(words),
            Opcode::MemClearRect => self.mem_clear_rect(words),
            Opcode::MemWriteSprite => self.mem_write_sprite(words),
            _ => {}
        }
    }

    /// Rows of bytes, as they are now; bytes beyond the memory are 0.
    pub fn read_rows(&mut self, base: u32, pitch: u32, row: u32, rows: u32) -> Vec<u8> {
        self.memory.read_rows(base, pitch, row, rows)
    }

    /// Bytes to an address; those beyond the memory are dropped.
    pub fn write_bytes(&mut self, address: u32, bytes: &[u8]) {
        self.memory.write(address, bytes);
    }
}
