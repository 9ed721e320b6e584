//! Colour after the combine units: decal, modulation beyond one, a second
//! iterated colour. Boards with the SST-1's pipeline leave all of it off.
//!
//! In this order, where asked for, on red, green and blue:
//!
//! ```text
//! decal       c = (Ta * T + (255 - Ta) * base) / 255, rounded
//! overbright  c = min(255, c * k / 255, rounded), k of 0..=2047
//! specular    c = min(255, c + s)
//! ```
//!
//! T is the texture chain's output, k the iterated colour before its wrap rule,
//! s [`crate::Registers::specular`]. Alpha is the alpha combine unit's.

/// What shows through a decal where its texture is transparent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DecalBase {
    /// The iterated colour.
    Iterated,
    /// The third iterated colour: [`crate::Registers::base`].
    Base,
}

/// Colour after the combine units; see the module's text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Shade {
    /// Replaces the colour unit's output by the texture over a base colour.
    pub decal: Option<DecalBase>,
    /// Multiplies by the iterated colour, of which values up to 2047 (below 0:
    /// 0) count, where the combine units read it with its wrap rule.
    pub overbright: bool,
    /// Adds the second iterated colour.
    pub specular: bool,
}
