//! `libquark3d`: what the classes of `include/quark.h` call.
//!
//! No logic: each export checks its pointers, makes the call's value and hands
//! it to the one library of the process. Members that programs set by
//! themselves are read where a call needs them and become calls where they
//! changed.

mod gpu;
mod layout;
mod list;
mod math;
mod matrix;
mod memory;
mod session;
mod sync;
mod texture;

pub use gpu::*;
pub use list::*;
pub use math::*;
pub use matrix::*;
pub use texture::*;
