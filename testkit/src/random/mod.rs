//! Random cases: states, textures, triangles, registers, runs and clears, with
//! more unpleasant ones among them than programs ever produce. All follow from
//! one seed.

mod command;
mod primitive;
mod rng;
mod state;
mod texture;

pub use command::{Case, Command, case};
pub use primitive::{extras, registers, verite_corners, vertices};
pub use rng::Rng;
pub use state::draw_state;
pub use texture::textures;
