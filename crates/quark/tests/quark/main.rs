//! Tests of Quark 3D through its Rust interface and its call border.

mod bad_input;
mod calls;
mod lists;
mod names;
mod pixels;
mod random;
mod reference;
