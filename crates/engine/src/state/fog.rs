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
    /// The fourth value of [`crate::Registers::specular`], iterated: the part
    /// of the fragment's colour that stays, 255 all of it. Mixed exactly, see
    /// [`Fog`].
    Iterated,
    /// The same part by the pseudo-float w, from [`FogTable::by_w`]: fog that
    /// is a function of the fragment's distance 1/w. Mixed exactly.
    ByW,
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

/// Samples of a table for [`FogAmount::ByW`].
pub const FOG_SAMPLES: usize = 128;

impl FogTable {
    /// A table for [`FogAmount::ByW`]: `sample[i]` is the part of the
    /// fragment's colour that stays, 0 to 255, where the pseudo-float w (before
    /// any depth bias) is `512 * i`; in between it is linear, rounded to the
    /// nearest; past the last sample it is that one.
    ///
    /// The pseudo-float is 0 for w of 1 and above and then rises by 4096, which
    /// are eight samples, each time w halves: sample `i` is at the w of
    /// [`FogTable::w_of_sample`]. A front end whose distances are others scales
    /// [`crate::Vertex::w`] by a constant, which nothing but depth tests by w
    /// sees as well.
    pub fn by_w(samples: &[u8; FOG_SAMPLES]) -> FogTable {
        let mut table = FogTable::default();
        table.value.copy_from_slice(&samples[..64]);
        table.delta.copy_from_slice(&samples[64..]);
        table
    }

    /// A sample of [`FogTable::by_w`]; past the last one that.
    pub fn sample(&self, index: usize) -> u8 {
        let index = index.min(FOG_SAMPLES - 1);
        if index < 64 { self.value[index] } else { self.delta[index - 64] }
    }

    /// The w that a sample of [`FogTable::by_w`] is for, 1 down to 2^-16.
    pub fn w_of_sample(index: usize) -> f64 {
        // 0.1xxx of its octave, the x inverted: 1 - n/16 for n of 0 to 7.
        let octave = 0.5f64.powi((index / 8) as i32);
        octave * (1.0 - (index % 8) as f64 / 16.0)
    }
}

/// Fog: `c + ((fog_color - c) * (amount + 1) >> 8)`, with either term dropped
/// on demand. With [`FogAmount::Iterated`] and [`FogAmount::ByW`], whose value
/// f is what stays: `(c * f + fog_color * (255 - f)) / 255`, to the nearest.
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
