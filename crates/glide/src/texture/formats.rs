//! Texel formats to 0xAARRGGBB.
//!
//! Source: SST1, texture formats; NCC tables: nccTable registers.

/// A narrow-channel compression table: Y plus I plus Q, channel by channel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NccTable {
    /// Brightness.
    pub y: [u8; 16],
    /// Red, green, blue of each I, signed 9 bits.
    pub i: [[i16; 3]; 4],
    /// Red, green, blue of each Q, signed 9 bits.
    pub q: [[i16; 3]; 4],
}

impl NccTable {
    /// Replaces what a register word holds; words 0..=3 are four Y each, 4..=7
    /// the I, 8..=11 the Q.
    pub fn set_word(&mut self, index: usize, word: u32) {
        let signed = |shift: u32| (((word >> shift & 0x1ff) << 7) as u16 as i16) >> 7;
        let channels = || [signed(18), signed(9), signed(0)];
        match index {
            0..=3 => self.y[index * 4..index * 4 + 4].copy_from_slice(&word.to_le_bytes()),
            4..=7 => self.i[index - 4] = channels(),
            8..=11 => self.q[index - 8] = channels(),
            _ => {}
        }
    }

    /// The colour of a compressed byte, 0x00RRGGBB.
    pub fn color(&self, value: u8) -> u32 {
        let y = i16::from(self.y[usize::from(value >> 4)]);
        let (i, q) = (self.i[usize::from(value >> 2 & 3)], self.q[usize::from(value & 3)]);
        let channel = |c: usize| (y + i[c] + q[c]).clamp(0, 255) as u32;
        channel(0) << 16 | channel(1) << 8 | channel(2)
    }
}

fn argb(a: u32, r: u32, g: u32, b: u32) -> u32 {
    a << 24 | r << 16 | g << 8 | b
}

fn rgb332(v: u32) -> u32 {
    let (r, g, b) = (v >> 5 & 7, v >> 2 & 7, v & 3);
    let three = |c: u32| c << 5 | c << 2 | c >> 1;
    argb(255, three(r), three(g), b << 6 | b << 4 | b << 2 | b)
}

fn widen5(c: u32) -> u32 {
    c << 3 | c >> 2
}

/// A texel of format 0..=15 as 0xAARRGGBB. `palette` holds 0x00RRGGBB. Reserved
/// formats give transparent black.
pub fn decode(format: i32, texel: u16, palette: &[u32; 256], ncc: &NccTable) -> u32 {
    let v = u32::from(texel);
    let (low, high) = (v & 0xff, v >> 8);
    let gray = |a: u32, c: u32| argb(a, c, c, c);
    let color = |a: u32, rgb: u32| a << 24 | rgb & 0x00ff_ffff;
    match format {
        0x0 => rgb332(low),
        0x1 => color(255, ncc.color(low as u8)),
        0x2 => gray(low, low),
        0x3 => gray(255, low),
        0x4 => gray((low >> 4) * 17, (low & 15) * 17),
        0x5 => color(255, palette[low as usize]),
        0x8 => color(high, rgb332(low)),
        0x9 => color(high, ncc.color(low as u8)),
        0xa => {
            let g = v >> 5 & 63;
            argb(255, widen5(v >> 11), g << 2 | g >> 4, widen5(v & 31))
        }
        0xb => {
            let a = if v & 0x8000 != 0 { 255 } else { 0 };
            argb(a, widen5(v >> 10 & 31), widen5(v >> 5 & 31), widen5(v & 31))
        }
        0xc => argb((v >> 12) * 17, (v >> 8 & 15) * 17, (v >> 4 & 15) * 17, (v & 15) * 17),
        0xd => gray(high, low),
        0xe => color(high, palette[low as usize]),
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_and_black_of_every_format() {
        let mut palette = [0; 256];
        palette[255] = 0xffff_ffff;
        let mut ncc = NccTable::default();
        ncc.y[15] = 255;
        for format in [0, 1, 2, 3, 4, 5, 8, 9, 10, 11, 12, 13, 14] {
            assert_eq!(decode(format, 0xffff, &palette, &ncc), 0xffff_ffff, "{format}");
            assert_eq!(decode(format, 0, &palette, &ncc) & 0xff_ffff, 0, "{format}");
        }
        assert_eq!(decode(6, 0xffff, &palette, &ncc), 0);
    }

    #[test]
    fn channels_lie_where_the_formats_say() {
        let (palette, ncc) = ([0; 256], NccTable::default());
        assert_eq!(decode(0, 0b0100_0101, &palette, &ncc), 0xff49_2455);
        assert_eq!(decode(10, 0x8410, &palette, &ncc), 0xff84_8284);
        assert_eq!(decode(12, 0x1234, &palette, &ncc), 0x1122_3344);
        assert_eq!(decode(4, 0x5a, &palette, &ncc), 0x55aa_aaaa);
        assert_eq!(decode(8, 0x80e0, &palette, &ncc), 0x80ff_0000);
    }

    #[test]
    fn ncc_words_are_signed() {
        let mut table = NccTable::default();
        table.set_word(0, 0x4030_2010);
        table.set_word(4, 0x1ff << 18 | 5 << 9 | 0x100);
        assert_eq!(&table.y[..4], &[0x10, 0x20, 0x30, 0x40]);
        assert_eq!(table.i[0], [-1, 5, -256]);
        assert_eq!(table.color(0x00), 0x0f_1500);
    }
}
