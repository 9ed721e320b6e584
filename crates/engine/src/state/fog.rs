//! Fog.

/// Where the fog amount comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FogAmount {
    /// The table, indexed by the pseudo-float w.
    Table,
    /// Iterated alpha.
    IteratedAlpha,
    /// Bits 15..8 of iterated z, after its wrap rule.
    IteratedZ,
    /// The fog colour is added whole.
    Constant,
}

/// Entries and slopes of a fog table.
///
/// The amount at pseudo-float w is `value[w >> 10] + (delta[w >> 10] *
/// ((w >> 2) & 0xff) >> 10)`: slopes are unsigned, in quarters.
///
/// Source: SST1, fogTable registers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct FogTable {
    /// Fog amount at each entry, 0 (none) to 255.
    pub value: [u8; 64],
    /// Difference to the next entry, times four.
    pub delta: [u8; 64],
}

impl Default for FogTable {
    fn default() -> Self {
        FogTable { value: [0; 64], delta: [0; 64] }
    }
}

/// Fog: `c + ((fog_color - c) * (amount + 1) >> 8)`, with either term dropped
/// on demand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Fog {
    /// Where the amount comes from.
    pub amount: FogAmount,
    /// 0x00RRGGBB.
    pub color: u32,
    /// Leaves the fog colour out (for the passes of multi-pass drawing).
    pub drop_fog_color: bool,
    /// Leaves the fragment's colour out: the result is the fog term alone.
    pub drop_fragment_color: bool,
}
