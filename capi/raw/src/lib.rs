//! `librender_client`: the client interface of the Raw pipeline for C.
//!
//! No logic: each export checks its pointers, makes the call's value and hands it to the one client
//! of the process. Prototypes: `include/render_client.h`.

#![allow(non_snake_case, non_upper_case_globals)]

mod block;
mod command;
mod globals;
mod matrix;
mod session;
mod settings;
mod words;

pub use block::*;
pub use command::*;
pub use globals::*;
pub use matrix::*;
pub use words::*;
