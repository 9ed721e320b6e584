//! Patterns: fragments dropped, or drawn in a second colour, by their place.

/// The direction in which a [`PatternBits::Line`] counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Axis {
    /// Surface columns.
    #[default]
    X,
    /// Surface rows from the top.
    Y,
}

/// Which bit decides at a pixel of the surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PatternBits {
    /// A row of bits along one axis: bit `n` of `bits`, bit 0 the lowest, with
    /// `n = floor((p - origin) / factor) mod length`, where p is the column or
    /// the row, or `origin - p` where it counts backwards.
    Line {
        /// The bits; those from `length` on are not used.
        bits: u32,
        /// How many there are, 1 to 32; others count as the nearest of these.
        length: u8,
        /// How many pixels each serves; 0 counts as 1.
        factor: u16,
        /// What p counts.
        axis: Axis,
        /// Where p has bit 0's first pixel.
        origin: i32,
        /// Counts against the axis.
        backwards: bool,
    },
    /// 32x32 bits: bit `31 - (x & 31)` of row `y & 31`, rows from the top of
    /// the surface.
    Area([u32; 32]),
}

/// A pattern: 1 draws, 0 drops the fragment, which then counts in no counter
/// but `pixels_in`, or gives it another colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Pattern {
    /// The bits.
    pub bits: PatternBits,
    /// The colour and alpha of fragments whose bit is 0, 0xAARRGGBB; they pass
    /// everything from the alpha test on. `None` drops them.
    pub background: Option<u32>,
}

impl Pattern {
    /// Whether it is a row of bits along the columns.
    pub(crate) fn along_x(&self) -> bool {
        matches!(self.bits, PatternBits::Line { axis: Axis::X, .. })
    }

    /// Whether it drops fragments.
    pub(crate) fn drops(&self) -> bool {
        self.background.is_none()
    }

    /// Whether the bit at a surface position is 1.
    pub fn draws(&self, x: u32, y: u32) -> bool {
        match &self.bits {
            PatternBits::Area(rows) => rows[(y & 31) as usize] >> (31 - (x & 31)) & 1 != 0,
            PatternBits::Line { bits, length, factor, axis, origin, backwards } => {
                let p = i64::from(if *axis == Axis::X { x } else { y });
                let along = p - i64::from(*origin);
                let along = if *backwards { -along } else { along };
                let step = along.div_euclid(i64::from(*factor).max(1));
                let n = step.rem_euclid(i64::from(*length).clamp(1, 32));
                bits >> n & 1 != 0
            }
        }
    }
}
