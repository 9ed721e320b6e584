//! The fragment pipeline: one file per hardware unit, in the chip's order.
//!
//! stipple, pattern -> depth -> texture units (level of detail, address, fetch,
//! key, combine) -> iterated colours -> chroma key -> combine -> shade (decal,
//! overbright, specular) -> alpha test -> fog -> blend -> depth write -> dither,
//! write. A [`Pipeline`] is a draw state
//! compiled into the list of stages it needs; each stage is one small
//! function over a [`block::Block`] of 64 fragments, compiled for every SIMD
//! level from the same text.

pub(crate) mod block;
pub(crate) mod depth;
pub(crate) mod lanes;
pub(crate) mod palette;
pub(crate) mod pipeline;
pub(crate) mod raw;
pub(crate) mod texture;

mod alpha_test;
mod chroma_key;
mod combine;
mod fog;
mod iterate;
mod joined;
mod output;
mod shade;
mod stages;
mod stipple;
mod wide_depth;

pub(crate) use joined::one_stamp;
pub(crate) use pipeline::Pipeline;
pub(crate) use stages::{StageList, StripFn, run, stage_list, strip_function};

use fillrate_simd::Simd;

use crate::setup::{Triangle, Triangles};
use crate::stats::Counters;
use crate::target::PixelFormat;

/// What a block's stages read besides the block: the state and the triangles
/// that its slots refer to.
#[derive(Clone, Copy)]
pub(crate) struct Pass<'a> {
    pub pipeline: &'a Pipeline,
    pub triangles: &'a Triangles,
}

impl Pass<'_> {
    /// The triangle that a slot belongs to.
    #[inline(always)]
    pub fn triangle(&self, slot: &block::Slot) -> &Triangle {
        &self.triangles.list[slot.triangle]
    }
}

/// A tile's colour elements.
pub(crate) enum ColorTile<'a> {
    Bits16(&'a mut [u16], PixelFormat),
    Bits32(&'a mut [i32], PixelFormat),
}

impl ColorTile<'_> {
    /// The elements from an index on, and their format.
    #[inline(always)]
    fn elements<S: Simd>(&self, s: S, at: usize) -> (S::I, PixelFormat) {
        match self {
            ColorTile::Bits16(pixels, format) => (s.load16(&pixels[at..]), *format),
            ColorTile::Bits32(pixels, format) => (s.load(&pixels[at..]), *format),
        }
    }
}

/// A tile while a worker owns it.
pub(crate) struct Tile<'a> {
    pub color: ColorTile<'a>,
    /// Empty where there is no 16-bit aux surface.
    pub aux: &'a mut [u16],
    /// Empty where there is no 32-bit one.
    pub aux32: &'a mut [i32],
    pub counters: &'a mut Counters,
}

impl Tile<'_> {
    /// Aux elements from an index on, of either size.
    #[inline(always)]
    fn load_aux<S: Simd>(&self, s: S, at: usize) -> S::I {
        match self.aux32.is_empty() {
            true => s.load16(&self.aux[at..]),
            false => s.load(&self.aux32[at..]),
        }
    }

    /// Writes the aux elements that are on in `mask`.
    #[inline(always)]
    fn store_aux<S: Simd>(&mut self, s: S, value: S::I, at: usize, mask: S::M) {
        match self.aux32.is_empty() {
            true => s.store16(value, &mut self.aux[at..], mask),
            false => s.store_masked(value, &mut self.aux32[at..], mask),
        }
    }
}
