//! Boards as data.

/// The memory and units of a board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Card {
    /// The name that configuration uses.
    pub name: &'static str,
    /// Frame buffer memory in MB: 1, 2 or 4.
    pub frame_buffer: u32,
    /// Texture units, 1 to 3.
    pub units: usize,
    /// Memory of each texture unit in MB: 1, 2 or 4.
    pub texture: u32,
    /// Two boards interleaving scan lines, which act as one.
    pub interleaved: bool,
}

/// Every board that can be chosen. The first is the default: the largest that
/// programs with the standard vertex layout can use.
///
/// Source: SST1, configurations; sizes as boards were sold.
pub const CARDS: [Card; 6] = [
    Card::new("voodoo-8mb-2tmu", 4, 2, 2),
    Card::new("voodoo-4mb", 2, 1, 2),
    Card::new("voodoo-6mb", 2, 1, 4),
    Card::new("voodoo-6mb-2tmu", 2, 2, 2),
    Card::new("arcade-12mb-2tmu", 4, 2, 4),
    Card::new("arcade-16mb-3tmu", 4, 3, 4),
];

impl Card {
    const fn new(name: &'static str, frame_buffer: u32, units: usize, texture: u32) -> Card {
        Card { name, frame_buffer, units, texture, interleaved: false }
    }

    /// The board of that name.
    pub fn by_name(name: &str) -> Option<Card> {
        CARDS.into_iter().find(|card| card.name == name)
    }

    /// Bytes of each texture unit.
    pub fn texture_bytes(&self) -> usize {
        (self.texture as usize) << 20
    }
}

impl Default for Card {
    fn default() -> Card {
        CARDS[0]
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
        // Buffers are allocated in tiles of 64x16 pixels of two bytes.
        let one = width.div_ceil(64) * 64 * height.div_ceil(16) * 16 * 2;
        let scale = if self.interleaved { 2 } else { 1 };
        one * buffers <= (self.frame_buffer << 20) * scale
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
}
