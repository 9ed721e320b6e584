//! `libglide2x`: the C ABI of Glide 2.x.
//!
//! No logic: each export checks its pointers, makes the call's value and hands
//! it to the one library of the process. Prototypes and layouts: `include/`.

#![allow(non_snake_case)]

mod capture;
mod draw;
mod library;
mod linear;
mod manager;
mod multipass;
mod session;
mod state;
mod texture;
mod texture_file;
mod utility;

pub use draw::*;
pub use library::*;
pub use linear::*;
pub use manager::*;
pub use multipass::*;
pub use state::*;
pub use texture::*;
pub use texture_file::*;
pub use utility::*;
