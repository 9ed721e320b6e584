//! A level of a first-person game of 1999, drawn through Glide 2.x.
//!
//! What a program of the time had to do itself is here: materials reduced to
//! one or two passes, pictures to textures of 256 texels at most, texture
//! memory managed, triangles clipped. `fillrate-level` is the program.

#![forbid(unsafe_code)]

pub mod assets;
pub mod bsp;
pub mod camera;
pub mod draw;
pub mod entities;
pub mod flight;
pub mod level;
pub mod math;
pub mod memory;
pub mod output;
pub mod patch;
pub mod picture;
pub mod script;
pub mod sky;
pub mod synthetic;
pub mod view;
pub mod wave;
pub mod way;
