//! Bits of a clip mask: why a point cannot be seen.
//!
//! Source: QK, standard drawing process, step 4.

/// Below the bottom of the screen.
pub const BOTTOM: i32 = 1;
/// Above its top.
pub const TOP: i32 = 2;
/// Left of it.
pub const LEFT: i32 = 4;
/// Right of it.
pub const RIGHT: i32 = 8;
/// Beyond the far plane.
pub const FAR: i32 = 16;
/// Nearer than the near plane, or behind; such a point was not projected.
pub const NEAR: i32 = 32;
