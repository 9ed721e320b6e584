//! Quark 3D, the integer 3D library of the Pocket PC, on the pixel engine.
//!
//! A [`Gpu`] is a frame buffer of palette colours and 1/z with everything that
//! draws into it; a [`TriangleList`] holds an object, a [`Matrix`] its place, a
//! [`Texture`] its skin. [`math`] has the integer functions. All arithmetic is
//! in integers, and no pixel is touched here: the engine's Quark profile draws.
//!
//! Programs of the original come in as [`Call`] values, which a [`Context`]
//! carries out.
//!
//! ```
//! use fillrate_quark::{Gpu, GpuConfig, RasterState, Vertex, color_rgb};
//!
//! let mut gpu = Gpu::new(GpuConfig { width: 64, height: 64, ..GpuConfig::default() })?;
//! gpu.triangle_mode = Some(fillrate_quark::TriangleMode::Untextured);
//! gpu.triangle_state = Some(RasterState { draw_color: color_rgb(255, 0, 0), ..RasterState::default() });
//! let corner = |x, y, i| Vertex { x, y, z: 100, i, ..Vertex::default() };
//! gpu.draw_triangle(&corner(8, 8, 255), &corner(8, 56, 255), &corner(56, 56, 0));
//! gpu.flush_frame(0);
//! assert_eq!(gpu.shown().colors[20 * 64 + 9] & 0xff, 0xc0);
//! # Ok::<(), fillrate_quark::QuarkError>(())
//! ```
//!
//! Source tag: QK; see `docs/sources.md`.

#![forbid(unsafe_code)]

pub mod clip;
pub mod color;
pub mod math;

mod call;
mod context;
mod error;
mod font;
mod gpu;
mod list;
mod matrix;
mod state;
mod texture;

pub use call::{Call, ListValue, Reply, StateValue};
pub use color::{color_i, color_rgb};
pub use context::Context;
pub use error::{ErrorCode, QuarkError};
pub use gpu::{
    CLIPZ_FAR, CLIPZ_NEAR, Camera, Gpu, GpuConfig, INVTBL_SHIFT, MAX_SORTED, SCR_X, SCR_Y, Shown,
    inverse_z,
};
pub use list::{
    Command, Corner, IndexFormat, Layout, ListView, MAX_COUNT, TriangleList, VertexFormat,
};
pub use matrix::Matrix;
pub use state::{DrawMode, RasterState, TriangleMode, Vertex};
pub use texture::{KEY_TEXEL, MAX_TEXTURE_SIDE, Texture, apply_key, fits_triangles};
