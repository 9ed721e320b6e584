//! The fragment pipeline: one file per hardware unit, in the chip's order.
//!
//! stipple -> depth -> texture units (level of detail, address, fetch,
//! combine) -> iterated colours -> chroma key -> combine -> alpha test -> fog
//! -> blend -> depth write -> dither, write. A [`Pipeline`] is a draw state
//! compiled into the list of stages it needs; each stage is one small
//! function over a [`block::Block`] of 64 fragments, compiled for every SIMD
//! level from the same text.

pub(crate) mod block;
pub(crate) mod depth;
pub(crate) mod lanes;
pub(crate) mod palette;
pub(crate) mod pipeline;
pub(crate) mod texture;

mod alpha_test;
mod chroma_key;
mod combine;
mod fog;
mod iterate;
mod joined;
mod output;
mod stages;
mod stipple;

pub(crate) use pipeline::Pipeline;
pub(crate) use stages::{StageList, StripFn, run, stage_list, strip_function};

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
        &self.triangles.list[slot.triangle as usize]
    }
}

/// A tile's colour elements.
pub(crate) enum ColorTile<'a> {
    Bits16(&'a mut [u16], PixelFormat),
    Bits32(&'a mut [i32], PixelFormat),
}

/// A tile while a worker owns it.
pub(crate) struct Tile<'a> {
    pub color: ColorTile<'a>,
    /// Empty where there is no aux surface.
    pub aux: &'a mut [u16],
    pub counters: &'a mut Counters,
}
