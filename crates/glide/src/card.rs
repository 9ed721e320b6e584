//! Boards as data.

use std::borrow::Cow;

/// The memory and units of a board.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Card {
    /// The name that configuration uses.
    pub name: Cow<'static, str>,
    /// Frame buffer memory in MB: 1, 2 or 4; of each half where two are
    /// interleaved.
    pub frame_buffer: u32,
    /// Texture units, 1 to 3.
    pub units: usize,
    /// Memory of each texture unit in MB: 1, 2 or 4.
    pub texture: u32,
    /// Two boards that draw every other line each and act as one. They have
    /// twice the frame buffer, hold the same textures, and cannot be read
    /// through the linear frame buffer.
    pub interleaved: bool,
}

/// Every built-in board. The first is the default: the largest that programs
/// with the standard vertex layout can use.
///
/// Source: SST1, configurations; sizes as boards were sold.
pub static CARDS: [Card; 9] = [
    Card::new("voodoo-8mb-2tmu", 4, 2, 2),
    Card::new("voodoo-4mb", 2, 1, 2),
    Card::new("voodoo-6mb", 2, 1, 4),
    Card::new("voodoo-6mb-2tmu", 2, 2, 2),
    Card::new("arcade-12mb-2tmu", 4, 2, 4),
    Card::new("arcade-16mb-3tmu", 4, 3, 4),
    Card::new("voodoo-sli-8mb", 2, 1, 2).twice(),
    Card::new("voodoo-sli-12mb-2tmu", 2, 2, 2).twice(),
    Card::new("arcade-sli-24mb-2tmu", 4, 2, 4).twice(),
];

impl Card {
    const fn new(name: &'static str, frame_buffer: u32, units: usize, texture: u32) -> Card {
        Card { name: Cow::Borrowed(name), frame_buffer, units, texture, interleaved: false }
    }

    const fn twice(mut self) -> Card {
        self.interleaved = true;
        self
    }

    /// The built-in board of that name.
    pub fn by_name(name: &str) -> Option<Card> {
        CARDS.iter().find(|card| card.name == name).cloned()
    }

    /// Whether its sizes are ones that the chips know.
    pub fn is_valid(&self) -> bool {
        let megabytes = |mb: u32| matches!(mb, 1 | 2 | 4);
        (1..=3).contains(&self.units) && megabytes(self.frame_buffer) && megabytes(self.texture)
    }

    /// Bytes of each texture unit.
    pub fn texture_bytes(&self) -> usize {
        (self.texture as usize) << 20
    }
}

impl Default for Card {
    fn default() -> Card {
        Card::new("voodoo-8mb-2tmu", 4, 2, 2)
    }
}

/// Columns and rows of the resolutions a Voodoo Graphics board can show, by
/// enumerant.
pub const RESOLUTIONS: [(u32, u32); 12] = [
    (320, 200),
    (320, 240),
    (400, 256),
    (512, 384),
    (640, 200),
    (640, 350),
    (640, 400),
    (640, 480),
    (800, 600),
    (960, 720),
    (856, 480),
    (512, 256),
];

impl Card {
    /// Whether the frame buffer holds that many colour and aux buffers.
    ///
    /// Source: G246, `grSstWinOpen`: with 2 MB, 800x600 and 856x480 leave room
    /// for two buffers in all, and 960x720 does not fit.
    pub fn holds(&self, resolution: usize, buffers: u32) -> bool {
        let Some((width, height)) = RESOLUTIONS.get(resolution) else { return false };
        // Of interleaved boards, each holds every other line. Buffers are
        // allocated in tiles of 64x16 pixels of two bytes.
        let height = if self.interleaved { height / 2 } else { *height };
        let one = width.div_ceil(64) * 64 * height.div_ceil(16) * 16 * 2;
        one * buffers <= self.frame_buffer << 20
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_megabytes_hold_what_the_reference_allows() {
        let card = Card::by_name("voodoo-4mb").unwrap();
        for resolution in [0, 1, 2, 3, 4, 5, 6, 7, 11] {
            assert!(card.holds(resolution, 3), "{resolution}");
        }
        for resolution in [8, 10] {
            assert!(card.holds(resolution, 2) && !card.holds(resolution, 3));
        }
        assert!(!card.holds(9, 2));
        assert!(!card.holds(12, 1));
    }

    #[test]
    fn four_megabytes_and_two_halves_hold_three_buffers_of_nearly_everything() {
        let whole = Card::by_name("voodoo-8mb-2tmu").unwrap();
        let halves = Card::by_name("voodoo-sli-8mb").unwrap();
        for resolution in 0..12 {
            assert!(whole.holds(resolution, 3) && halves.holds(resolution, 2), "{resolution}");
            assert_eq!(halves.holds(resolution, 3), resolution != 9, "{resolution}");
        }
    }

    #[test]
    fn built_in_boards_are_valid_and_their_names_differ() {
        assert_eq!(CARDS[0], Card::default());
        for (i, card) in CARDS.iter().enumerate() {
            assert!(card.is_valid());
            assert_eq!(Card::by_name(&card.name).as_ref(), Some(&CARDS[i]));
        }
    }
}
