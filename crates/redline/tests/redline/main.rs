//! Tests of RRedline through its Rust interface and its call border.

mod board;
mod htri;
