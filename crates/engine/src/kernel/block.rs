//! The register file of the fragment pipeline: 64 fragments in L1.

use fillrate_simd::Simd;

use super::depth::IteratedW;
use super::texture::{Reciprocals, TextureSteps};
use crate::state::MAX_TMUS;

/// Fragments of a block.
pub(crate) const BLOCK: usize = 64;
/// Fragments of a stamp.
pub(crate) const STAMP: usize = crate::target::STAMP_PIXELS;
/// Stamps of a block.
pub(crate) const SLOTS: usize = BLOCK / STAMP;

/// One 32-bit value for each fragment.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Lanes(pub [i32; BLOCK]);

impl Lanes {
    pub const fn splat(value: i32) -> Lanes {
        Lanes([value; BLOCK])
    }
}

/// A colour for each fragment: pairs of 16-bit channels, red and green low.
#[derive(Clone, Debug)]
pub(crate) struct Colors {
    /// red | blue << 16
    pub rb: Lanes,
    /// green | alpha << 16
    pub ga: Lanes,
}

impl Colors {
    /// The same 0xAARRGGBB everywhere.
    pub const fn splat(argb: u32) -> Colors {
        Colors {
            rb: Lanes::splat(((argb >> 16 & 0xff) | (argb & 0xff) << 16) as i32),
            ga: Lanes::splat(((argb >> 8 & 0xff) | (argb >> 24) << 16) as i32),
        }
    }
}

/// Which stamp of which triangle a quarter of the block holds.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Slot {
    /// Index of the triangle in the pass.
    pub triangle: u32,
    /// Index of the stamp's first pixel in the tile.
    pub at: u32,
    /// Screen column of the stamp.
    pub x: i32,
    /// Screen row of the stamp.
    pub y: i32,
}

/// Stamps of a strip.
pub(crate) const STRIP: usize = 16;

/// Stamps of one triangle side by side, and which of their fragments are left.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Strip {
    /// The leftmost stamp.
    pub first: Slot,
    /// Stamps.
    pub count: usize,
    /// Bit per fragment; none beyond `count`.
    pub live: [u16; STRIP],
}

impl Strip {
    pub const NONE: Strip =
        Strip { first: Slot { triangle: 0, at: 0, x: 0, y: 0 }, count: 0, live: [0; STRIP] };

    /// The fragments left.
    #[inline(always)]
    pub fn len(&self) -> u64 {
        let mut sum = 0;
        for &[a, b, c, d] in self.live.as_chunks().0 {
            let [a, b, c, d] = [u64::from(a), u64::from(b), u64::from(c), u64::from(d)];
            sum += u64::from((a | b << 16 | c << 32 | d << 48).count_ones());
        }
        sum
    }

    /// Whether every fragment of its stamps is left.
    #[inline(always)]
    pub fn is_whole(&self) -> bool {
        self.len() == (self.count * STAMP) as u64
    }

    /// The stamps' elements of a plane of the tile.
    #[inline(always)]
    pub fn elements<'a>(&self, plane: &'a mut [u16]) -> &'a mut [[u16; STAMP]] {
        let elements = &mut plane[self.first.at as usize..][..self.count * STAMP];
        elements.as_chunks_mut().0
    }
}

/// Vectors of a stamp at the narrowest level.
pub(crate) const VECTORS: usize = 4;

/// Whether any of a stamp's fragments `j..` of a vector is live.
#[inline(always)]
pub(crate) fn any_live<S: Simd>(live: u32, j: usize) -> bool {
    live >> j & ((1u32 << S::LANES) - 1) != 0
}

/// Up to four stamps of fragments and everything the stages keep about them.
/// Where stages read what others write into the tile, no two slots hold the same
/// stamp, so stages may finish one after another; see [`super::Pipeline::in_order`].
#[derive(Clone, Debug)]
pub(crate) struct Block {
    /// Bit per fragment: still to be drawn.
    pub live: u64,
    /// Slots in use.
    pub count: usize,
    pub slots: [Slot; SLOTS],
    /// Iterated z, 0..=65535, without bias.
    pub z: Lanes,
    /// Pseudo-float w, without bias.
    pub w: Lanes,
    /// What is compared and written.
    pub depth: Lanes,
    pub iterated: Colors,
    /// Output of the texture chain so far.
    pub texture: Colors,
    /// The fragment's colour from the combine units on.
    pub color: Colors,
    /// The colour before fog.
    pub prefog: Colors,
    /// Fog amounts by the table, in both halves.
    pub fog: Lanes,
    /// Texel addresses of the two rows, and the weights of a bilinear sample.
    pub row0: Lanes,
    pub row1: Lanes,
    pub weight_s: Lanes,
    pub weight_t: Lanes,
    /// 1 / w of the unit upstream.
    pub reciprocals: Reciprocals,
    /// Level of detail of the current unit, 8 fraction bits.
    pub lod: Lanes,
    /// Scratch colours.
    pub scratch: Colors,
    /// What the stamps of the last triangle shared.
    pub steps: Steps,
}

/// What the stamps of one triangle share, kept from block to block.
#[derive(Clone, Debug)]
pub(crate) struct Steps {
    pub w: IteratedW,
    pub units: [TextureSteps; MAX_TMUS],
}

impl Steps {
    const NONE: Steps =
        Steps { w: IteratedW::NONE, units: [const { TextureSteps::NONE }; MAX_TMUS] };
}

impl Block {
    pub fn new() -> Block {
        let lanes = Lanes::splat(0);
        let colors = Colors::splat(0);
        Block {
            live: 0,
            count: 0,
            slots: [Slot::default(); SLOTS],
            z: lanes.clone(),
            w: lanes.clone(),
            depth: lanes.clone(),
            iterated: colors.clone(),
            texture: colors.clone(),
            color: colors.clone(),
            prefog: colors.clone(),
            fog: lanes.clone(),
            row0: lanes.clone(),
            row1: lanes.clone(),
            weight_s: lanes.clone(),
            weight_t: lanes.clone(),
            reciprocals: Reciprocals([0.0; BLOCK]),
            lod: lanes,
            scratch: colors,
            steps: Steps::NONE,
        }
    }

    /// Forgets the last triangle: indices or the state mean something else now.
    pub fn forget_steps(&mut self) {
        self.steps.w.triangle = u32::MAX;
        for unit in &mut self.steps.units {
            unit.triangle = u32::MAX;
        }
    }

    /// Fragments in the slots in use.
    pub fn len(&self) -> usize {
        self.count * STAMP
    }

    /// Keeps only the fragments of `pass`; returns how many were dropped.
    pub fn keep(&mut self, pass: u64) -> u64 {
        let dropped = (self.live & !pass).count_ones();
        self.live &= pass;
        u64::from(dropped)
    }
}
