//! A texture unit: level of detail, addresses, texels, texture combine.
//!
//! Source: SST1, TREX: textureMode, tLOD, tDetail.

mod address;
mod combine;
mod fetch;
mod key;
mod lod;
mod plan;

pub(crate) use address::{Reciprocals, TextureSteps, address};
pub(crate) use combine::{multiplied_texels, texture_combine};
pub(crate) use fetch::{fetch, mix_next, texels};
pub(crate) use key::texel_key;
pub(crate) use lod::lod_base;
pub(crate) use plan::UnitPlan;
