//! `libverite`: RRedline for C programs, both layers.
//!
//! The lower layer's functions have their own names here. Those of the upper
//! layer are called `redline_...`; `libredline` (`capi/redline`) has them under
//! the names that programs know and goes on to these, so that both libraries
//! speak of one device.
//!
//! No logic: each export checks its pointers, makes the call's value or records
//! words, and hands it to the one library of the process. Handles are numbers
//! in pointers' clothes and are never followed.
// C programs know the functions by these names.
#![allow(non_snake_case)]

mod buffers;
mod commands;
mod copy;
mod device;
mod draw;
mod errors;
mod extensions;
mod handle;
mod host_memory;
mod install;
mod lock;
mod memory;
mod session;
mod sink;
mod slots;
mod state;
mod surface;

pub use buffers::*;
pub use commands::*;
pub use copy::*;
pub use device::*;
pub use draw::*;
pub use errors::exports::*;
pub use extensions::*;
pub use handle::Opaque;
pub use install::*;
pub use memory::*;
pub use state::*;
pub use surface::*;
