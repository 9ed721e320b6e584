//! Counters of the pixel pipeline.

use core::ops::AddAssign;

/// What happened to fragments and triangles since the last reset.
///
/// Source: SST1, performance counters (theirs have 24 bits; mask at the front
/// end).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Fragments covered, before the clip window.
    pub pixels_in: u64,
    /// Dropped by the chroma key.
    pub chroma_fail: u64,
    /// Dropped by the depth test.
    pub depth_fail: u64,
    /// Dropped by the alpha test.
    pub alpha_fail: u64,
    /// Fragments that reached the write stage, whatever the masks, and pixels
    /// cleared.
    pub pixels_out: u64,
    /// Triangles submitted.
    pub triangles_in: u64,
    /// Triangles left after culling and dropping those without area.
    pub triangles_drawn: u64,
}

impl AddAssign for Counters {
    fn add_assign(&mut self, other: Counters) {
        self.pixels_in += other.pixels_in;
        self.chroma_fail += other.chroma_fail;
        self.depth_fail += other.depth_fail;
        self.alpha_fail += other.alpha_fail;
        self.pixels_out += other.pixels_out;
        self.triangles_in += other.triangles_in;
        self.triangles_drawn += other.triangles_drawn;
    }
}

/// How often each kind of flush happened, and how much they drew.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FlushStats {
    /// Flushes by [`crate::FlushReason`], in its order.
    pub by_reason: [u64; 6],
    /// Commands executed.
    pub commands: u64,
}
