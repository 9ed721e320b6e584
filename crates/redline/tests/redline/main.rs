//! Tests of RRedline through its Rust interface and its call border.

mod bad_input;
mod board;
mod calls;
mod htri;
mod lines;
mod model;
mod objects;
mod pixels;
mod plane;
mod random;
mod raw;
mod streams;
mod window;
