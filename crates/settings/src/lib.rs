//! How Fillrate is set up: built-in values, then the file `fillrate.toml`,
//! then environment variables; later ones win. Options of the program
//! `fillrate` are handed to the library as variables, so that they win over
//! all. `docs/settings.md` lists everything.
//!
//! A value that cannot be used is told of and not used; nothing here fails.

#![forbid(unsafe_code)]

mod layer;
mod resolve;

pub use resolve::Settings;
