//! The last step: which bits of an element change, and how.

/// A logic operation on the bits of the packed source and destination
/// elements: bit `2 * source + destination` of the table is the result. Dithering
/// comes before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct LogicOp(u8);

impl LogicOp {
    /// The source as it is.
    pub const SOURCE: LogicOp = LogicOp(0b1100);

    /// An operation by its truth table; the low four bits count.
    pub const fn new(table: u8) -> LogicOp {
        LogicOp(table & 15)
    }

    /// The truth table.
    pub const fn table(self) -> u8 {
        self.0
    }
}

/// Which channels of a colour element are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Channels {
    /// Red.
    pub red: bool,
    /// Green.
    pub green: bool,
    /// Blue.
    pub blue: bool,
    /// Alpha.
    pub alpha: bool,
}

impl Channels {
    /// All of them.
    pub const ALL: Channels = Channels { red: true, green: true, blue: true, alpha: true };
}

impl Default for Channels {
    fn default() -> Channels {
        Channels::ALL
    }
}
