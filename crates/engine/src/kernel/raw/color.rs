//! Arithmetic of the Raw profile's colours: four bytes as two pairs of 16-bit
//! channels.
//!
//! Source: RAW, fixed-point product and combine listing.

use fillrate_simd::{IntLanes, Simd};

/// Two channels of a byte each in the halves of a lane.
const BYTES: i32 = 0x00ff_00ff;

/// Colours: green and alpha (low half), red and blue (low half).
#[derive(Clone, Copy)]
pub(super) struct Pairs<I> {
    pub ga: I,
    pub rb: I,
}

impl<I: IntLanes> Pairs<I> {
    #[inline(always)]
    pub fn splat<S: Simd<I = I>>(s: S, word: u32) -> Self {
        Pairs::unpack(s, s.splat(word as i32))
    }

    #[inline(always)]
    pub fn unpack<S: Simd<I = I>>(s: S, words: I) -> Self {
        let bytes = s.splat(BYTES);
        Pairs { ga: words & bytes, rb: words.shr(8) & bytes }
    }

    /// From channels of a byte each.
    #[inline(always)]
    pub fn from_channels(r: I, g: I, b: I, a: I) -> Self {
        Pairs { ga: g.shl(16) | a, rb: r.shl(16) | b }
    }

    /// As words without their low byte.
    #[inline(always)]
    pub fn opaque_words<S: Simd<I = I>>(self, s: S) -> I {
        self.rb.shl(8) | (self.ga & s.splat(0x00ff_0000))
    }

    #[inline(always)]
    pub fn alpha<S: Simd<I = I>>(self, s: S) -> I {
        self.ga & s.splat(0xff)
    }

    #[inline(always)]
    pub fn with_alpha<S: Simd<I = I>>(self, s: S, alpha: I) -> Self {
        Pairs { ga: (self.ga & s.splat(0x00ff_0000)) | alpha, rb: self.rb }
    }

    /// With alpha 0 where the other's alpha is 0.
    #[inline(always)]
    pub fn with_hole<S: Simd<I = I>>(self, s: S, other: Self) -> Self {
        let empty = other.alpha(s).eq(s.splat(0));
        let hole = self.with_alpha(s, s.splat(0));
        Pairs { ga: hole.ga.select(self.ga, empty), rb: self.rb }
    }

    /// Channel by channel product.
    #[inline(always)]
    pub fn modulate<S: Simd<I = I>>(self, s: S, other: Self) -> Self {
        Pairs { ga: product(s, self.ga, other.ga), rb: product(s, self.rb, other.rb) }
    }

    /// All channels times a byte.
    #[inline(always)]
    pub fn scale<S: Simd<I = I>>(self, s: S, k: I) -> Self {
        let k = k | k.shl(16);
        Pairs { ga: product(s, self.ga, k), rb: product(s, self.rb, k) }
    }

    /// Channel by channel sum, 255 at most.
    #[inline(always)]
    pub fn add<S: Simd<I = I>>(self, s: S, other: Self) -> Self {
        let most = s.splat(BYTES);
        Pairs { ga: self.ga.add16(other.ga).min16(most), rb: self.rb.add16(other.rb).min16(most) }
    }

    /// This weighted by `k`, the other by 255 - `k`; sums never pass 255.
    #[inline(always)]
    pub fn mix<S: Simd<I = I>>(self, s: S, other: Self, k: I) -> Self {
        let (over, under) = (self.scale(s, k), other.scale(s, s.splat(255) - k));
        Pairs { ga: over.ga.add16(under.ga), rb: over.rb.add16(under.rb) }
    }
}

/// `(a * b + 255) >> 8` in both halves; operands are bytes.
#[inline(always)]
pub(super) fn product<S: Simd>(s: S, a: S::I, b: S::I) -> S::I {
    a.mul16(b).add16(s.splat(BYTES)).shr16(8)
}
