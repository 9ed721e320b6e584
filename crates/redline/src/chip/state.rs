//! The registers of the pixel engine.
//!
//! Source: RR, state setters and defaults.

use crate::format::PixFmt;
use crate::opcode::{REGISTERS, Register};

/// All registers, and the palette of 4-bit textures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct State {
    registers: [u32; REGISTERS],
    /// Entries in the layout of the format's palette.
    palette: [u16; 16],
    /// Counts loads of the palette.
    palette_loads: u32,
}

/// 1.0 in 16.16.
const ONE: u32 = 0x1_0000;
/// 255.0 in 16.16.
const FULL: u32 = 255 << 16;

/// Registers that are not 0 by default.
const DEFAULTS: [(Register, u32); 18] = [
    (Register::SrcFmt, PixFmt::Rgb565 as u32),
    (Register::DstFmt, PixFmt::Rgb565 as u32),
    (Register::UMask, 0xffff),
    (Register::VMask, 0xffff),
    (Register::UMultiplier, ONE),
    (Register::VMultiplier, ONE),
    (Register::ChromaMask, u32::MAX),
    (Register::AluMode, 0xc),
    (Register::BlendSrcFunc, 7),
    (Register::BlendDstFunc, 6),
    (Register::PMask, u32::MAX),
    (Register::PatLengthM1, 31),
    (Register::ScissorX, 0xffff),
    (Register::ScissorY, 0xffff),
    (Register::FgColorArgb, u32::MAX),
    (Register::F, FULL),
    (Register::A, FULL),
    (Register::R, FULL),
];

impl Default for State {
    /// The state after `V_FIFO_CONTEXT_INIT`.
    fn default() -> State {
        let mut registers = [0; REGISTERS];
        for (register, value) in DEFAULTS {
            registers[register.index()] = value;
        }
        registers[Register::G.index()] = FULL;
        registers[Register::B.index()] = FULL;
        State { registers, palette: [0; 16], palette_loads: 0 }
    }
}

impl State {
    /// A register's value.
    #[inline]
    pub fn get(&self, register: Register) -> u32 {
        self.registers[register.index()]
    }

    /// Whether a register is not 0.
    #[inline]
    pub fn is_set(&self, register: Register) -> bool {
        self.get(register) != 0
    }

    /// Loads a register, or the bits of `mask` where that is not 0; says whether
    /// that changed it. The foreground colour also loads the default colour and
    /// alpha.
    pub fn set(&mut self, register: Register, mask: u32, value: u32) -> bool {
        let old = &mut self.registers[register.index()];
        let new = if mask == 0 { value } else { *old & !mask | value & mask };
        let changed = *old != new;
        *old = new;
        if register == Register::FgColorArgb {
            let color = new;
            let channels =
                [(Register::A, 24), (Register::R, 16), (Register::G, 8), (Register::B, 0)];
            for (channel, shift) in channels {
                self.registers[channel.index()] = (color >> shift & 0xff) << 16;
            }
            return true;
        }
        changed
    }

    /// Loads base, stride code, masks and multipliers of the source.
    pub fn set_texture(&mut self, [base, stride, masks, u, v]: &[u32; 5]) {
        let values = [
            (Register::SrcBase, *base),
            (Register::SrcStride, *stride),
            (Register::UMask, masks & 0xffff),
            (Register::VMask, masks >> 16),
            (Register::UMultiplier, *u),
            (Register::VMultiplier, *v),
        ];
        for (register, value) in values {
            self.registers[register.index()] = value;
        }
    }

    /// Loads the palette, two entries in a word, the first in its high half.
    pub fn set_palette(&mut self, words: &[u32; 8]) {
        for (two, word) in self.palette.as_chunks_mut::<2>().0.iter_mut().zip(words) {
            *two = [(word >> 16) as u16, *word as u16];
        }
        self.palette_loads += 1;
    }

    /// The palette of 4-bit textures.
    pub fn palette(&self) -> &[u16; 16] {
        &self.palette
    }

    /// The source's format; code 0 is the destination's.
    pub fn source_format(&self) -> Option<PixFmt> {
        match self.get(Register::SrcFmt) {
            crate::format::DESTINATION_FORMAT => self.destination_format(),
            code => PixFmt::from_code(code),
        }
    }

    /// The destination's format, if it can be drawn into.
    pub fn destination_format(&self) -> Option<PixFmt> {
        PixFmt::from_code(self.get(Register::DstFmt)).filter(|format| format.is_destination())
    }

    /// Left, right, top, bottom of the scissor; right and bottom are outside.
    pub fn scissor(&self) -> [u32; 4] {
        let (x, y) = (self.get(Register::ScissorX), self.get(Register::ScissorY));
        [x >> 16, x & 0xffff, y >> 16, y & 0xffff]
    }
}
