//! The two chips as data: extensions, stride tables, limits.
//!
//! Source: RR, extensions, V1000 and V2000; stride tables as the X driver for
//! these boards has them.

/// Which chip a board carries.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Chip {
    /// Verite V1000.
    V1000,
    /// Verite V2000 (V2100, V2200).
    #[default]
    V2000,
}

/// Vendor number of the boards on their bus.
pub const VENDOR: u32 = 0x1163;
/// Video memory that the microcode takes, in bytes.
pub const MICROCODE_BYTES: u32 = 128 << 10;

/// First terms of pitches, by the low digit of a stride code.
const LOW: [u32; 8] = [0, 256, 512, 1024, 4, 768, 576, 1152];
/// Second terms of pitches, by the high digit.
const HIGH: [u32; 8] = [0, 16, 32, 64, 128, 1024, 2048, 4096];
/// Codes preferred where two give one pitch, as (low, high).
const PREFERRED: [(u32, u32); 6] = [(2, 3), (2, 4), (3, 0), (3, 4), (1, 5), (0, 6)];

impl Chip {
    /// The chip of this name, `v1000` or `v2000`.
    pub fn by_name(name: &str) -> Option<Chip> {
        [Chip::V1000, Chip::V2000].into_iter().find(|chip| chip.name().eq_ignore_ascii_case(name))
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Chip::V1000 => "v1000",
            Chip::V2000 => "v2000",
        }
    }

    /// Device number on the bus.
    pub fn device_number(self) -> u32 {
        match self {
            Chip::V1000 => 0x0001,
            Chip::V2000 => 0x2000,
        }
    }

    /// The names of extensions, each with a space on both sides.
    pub fn extensions(self) -> &'static str {
        match self {
            Chip::V1000 => " V1K_Verite PixFmt_332 PixFmt_4I ",
            Chip::V2000 => " V2K_Verite Specular PixFmt_332 PixFmt_4I ",
        }
    }

    /// Whether vertices may carry specular colours.
    pub fn has_specular(self) -> bool {
        self == Chip::V2000
    }

    /// The largest pitch in bytes.
    pub fn max_pitch(self) -> u32 {
        match self {
            Chip::V1000 => 5120,
            Chip::V2000 => 5248,
        }
    }

    /// Low digits that the chip knows.
    fn low_digits(self) -> u32 {
        match self {
            Chip::V1000 => 5,
            Chip::V2000 => 8,
        }
    }

    /// The pitch of a stride code in bytes; 0 for digits that the chip lacks
    /// (`V_Linebytes`).
    pub fn linebytes(self, code: u32) -> u32 {
        let (low, high) = (code & 0xf, code >> 4 & 0xf);
        if low >= self.low_digits() || high >= 8 {
            return 0;
        }
        LOW[low as usize] + HIGH[high as usize]
    }

    /// The code of the smallest pitch of at least `linebytes` bytes, if there is
    /// one (`V_Stride`).
    pub fn stride(self, linebytes: u32) -> Option<u32> {
        let codes = (0..8).flat_map(|high| (0..self.low_digits()).map(move |low| (low, high)));
        let fits = codes.map(|(low, high)| (self.linebytes(low | high << 4), low, high));
        let fits = fits.filter(|&(pitch, ..)| pitch >= linebytes.max(1));
        let best = fits.min_by_key(|&(pitch, low, high)| {
            (pitch, !PREFERRED.contains(&(low, high)), low, high)
        });
        best.map(|(_, low, high)| low | high << 4)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pitches(chip: Chip) -> Vec<u32> {
        let mut all: Vec<u32> = (0..=0x77).map(|code| chip.linebytes(code)).collect();
        all.sort_unstable();
        all.dedup();
        all.retain(|&pitch| pitch != 0);
        all
    }

    #[test]
    fn pitches_are_the_published_ones() {
        let common = [
            4, 16, 20, 32, 36, 64, 68, 128, 132, 256, 272, 288, 320, 384, 512, 528, 544, 576, 640,
            1024, 1028, 1040, 1056, 1088, 1152, 1280, 1536, 2048, 2052, 2304, 2560, 3072, 4096,
            4100, 4352, 4608, 5120,
        ];
        assert_eq!(pitches(Chip::V1000), common);
        let more = [
            592, 608, 704, 768, 784, 800, 832, 896, 1168, 1184, 1216, 1600, 1792, 2176, 2624, 2816,
            3200, 4672, 4864, 5248,
        ];
        let mut all = [&common[..], &more[..]].concat();
        all.sort_unstable();
        assert_eq!(pitches(Chip::V2000), all);
    }

    #[test]
    fn strides_are_the_smallest_that_fit() {
        assert_eq!(Chip::V1000.stride(1280), Some(0x51));
        assert_eq!(Chip::V1000.stride(400), Some(0x02));
        assert_eq!(Chip::V1000.linebytes(0x41), 384);
        assert_eq!(Chip::V1000.stride(1), Some(0x04));
        assert_eq!(Chip::V1000.stride(5121), None);
        for chip in [Chip::V1000, Chip::V2000] {
            for bytes in 1..=chip.max_pitch() {
                let pitch = chip.linebytes(chip.stride(bytes).unwrap());
                assert!(pitch >= bytes && !pitches(chip).iter().any(|&p| p >= bytes && p < pitch));
            }
        }
    }

    #[test]
    fn extensions_stand_between_spaces() {
        assert!(Chip::V2000.extensions().contains(" Specular "));
        assert!(!Chip::V1000.extensions().contains(" Specular "));
    }
}
