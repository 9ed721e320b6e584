//! Raw register writes.
//!
//! Source: SST1, register map; indices count words.

use fillrate_engine::ClearValues;

use crate::board::Board;
use crate::enums::GR_FBI;
use crate::registers::fbz;

impl Board {
    /// Writes a register. `chip` 0 to 2 means a texture unit alone. The pixel
    /// chip's number reaches, of the texture units, the registers that both
    /// have: the iterated parameters. Registers that only tune hardware are
    /// taken and do nothing. False for a unit that there is not.
    pub(crate) fn write_register(&mut self, chip: i32, register: u32, value: u32) -> bool {
        let count = self.tmus.len();
        let pixel = chip == GR_FBI;
        let units = match usize::try_from(chip) {
            _ if pixel => 0..count,
            Ok(unit) if unit < count => unit..unit + 1,
            _ => return false,
        };
        self.dirty = true;
        match register {
            2..=31 | 34..=63 => self.write_set_up(register, value, units, pixel),
            192..=224 if !pixel => self.write_unit(units.start, register, value),
            _ if pixel => self.write_pixel_chip(register, value),
            _ => {}
        }
        true
    }

    fn write_unit(&mut self, unit: usize, register: u32, value: u32) {
        let tmu = &mut self.tmus[unit];
        match register {
            192 => tmu.texture_mode = value,
            193 => tmu.t_lod = value,
            194 => tmu.t_detail = value,
            195..=198 => tmu.base[register as usize - 195] = value,
            201..=224 => self.write_table(unit, register as usize - 201, value),
            _ => {}
        }
    }

    /// A word of the compression tables. Bit 31 of an I or Q word of the first
    /// table reaches the palette instead: the entry's number, whose lowest bit
    /// is the register's, and its colour.
    fn write_table(&mut self, unit: usize, word: usize, value: u32) {
        let memory = &mut self.memories[unit];
        if (4..12).contains(&word) && value >> 31 != 0 {
            let entry = (value >> 23 & 0xfe) as usize | word & 1;
            memory.set_palette(entry, &[value]);
        } else {
            memory.set_ncc(word / 12, word % 12, &[value]);
        }
    }

    fn write_pixel_chip(&mut self, register: u32, value: u32) {
        let fbi = &mut self.fbi;
        match register {
            32 | 64 => self.launch_set_up(value),
            65 => fbi.fbz_color_path = value,
            66 => fbi.fog_mode = value,
            67 => fbi.alpha_mode = value,
            // Two buffers can be drawn to: one bit says which.
            68 => fbi.fbz_mode = value & !(2 << 14),
            69 => fbi.lfb_mode = value,
            70 => fbi.clip_left_right = value,
            71 => fbi.clip_bottom_top = value,
            // Bit 0 of a no-operation resets the pixel counters.
            72 if value & 1 != 0 => self.reset_pixel_counters(),
            73 => self.fast_fill(),
            74 => {
                let interval = if value & 1 == 0 { 0 } else { (value >> 1 & 0xff) + 1 };
                self.swap(interval);
            }
            75 => fbi.fog_color = value,
            76 => fbi.za_color = value,
            77 => fbi.chroma_key = value,
            80 => fbi.stipple = value,
            81 => fbi.color0 = value,
            82 => fbi.color1 = value,
            88..=119 => {
                // Two entries a word, each with its slope above it.
                let at = (register as usize - 88) * 2;
                let table = &mut self.fog_table;
                [table.delta[at], table.value[at], table.delta[at + 1], table.value[at + 1]] =
                    value.to_le_bytes();
            }
            _ => {}
        }
    }

    /// Fills the clip window with color1 and zaColor. Unlike Glide's clear it
    /// writes the aux buffer whether or not depth is tested.
    ///
    /// Source: SST1, fastfillCMD.
    fn fast_fill(&mut self) {
        self.update();
        let on = |bit: u32| self.fbi.fbz_mode & bit != 0;
        let za = self.fbi.za_color;
        let aux = if on(fbz::ALPHA_PLANES) { za >> 24 } else { za & 0xffff };
        let values = ClearValues {
            color: on(fbz::RGB_WRITE).then(|| (self.fbi.color1, self.dither())),
            aux: on(fbz::AUX_WRITE).then_some(aux),
        };
        self.fill(values);
    }
}

#[cfg(test)]
mod tests {
    use crate::{Call, Context, GlideConfig};

    #[test]
    fn fill_and_swap_by_register() {
        let mut glide = Context::new(GlideConfig::default()).expect("a board");
        glide.execute(&Call::GrGlideInit {});
        let open = Call::GrSstWinOpen {
            window: 0,
            resolution: 1,
            refresh: 0,
            color_format: 0,
            origin: 0,
            colors: 2,
            aux: 1,
        };
        assert_eq!(glide.execute(&open), 1);
        glide.execute(&Call::GrDepthMask { mask: 1 });
        let mut write = |register, value| {
            glide.execute(&Call::GrSstConfigPipeline { chip: 3, register, value });
        };
        write(82, 0x00ff_0000);
        write(76, 0x1234);
        write(73, 0);
        write(74, 0);
        assert_eq!(glide.shown().expect("a frame").pixels[0], 0xf800);
        let depth = glide.lfb_read_region(2, (5, 5), (1, 1)).expect("a buffer");
        assert_eq!((depth[0], glide.swaps()), (0x1234, 1));
        assert_eq!(glide.counters().pixels_out, 320 * 240);
        glide.execute(&Call::GrSstConfigPipeline { chip: 3, register: 72, value: 1 });
        assert_eq!(glide.counters().pixels_out, 0);
    }
}
