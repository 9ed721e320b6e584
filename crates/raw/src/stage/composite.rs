//! Stage 4: depth test, blend, write.
//!
//! Source: RAW, compositing listing.

use super::Fragment;
use crate::color::{self, low};
use crate::errata::Errata;
use crate::framebuffer::{DepthBuffer, FrameBuffer, Pages};
use crate::state::ModeBits;

/// The buffers stage 4 draws to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Target {
    /// Colour pages.
    pub frame: FrameBuffer,
    /// Depths.
    pub depth: DepthBuffer,
    /// The pages fragments go to.
    pub pages: Pages,
}

impl Target {
    /// Cleared buffers, drawing to the back page.
    pub fn new(width: u32, height: u32) -> Self {
        Self {
            frame: FrameBuffer::new(width, height),
            depth: DepthBuffer::new(width, height),
            pages: Pages::BACK,
        }
    }
}

/// Where fragments are drawn: the buffers, or a part of them with addresses of its own.
pub trait Canvas {
    /// The pages fragments go to.
    fn pages(&self) -> Pages;
    /// The depth at an address.
    fn depth(&self, address: u64) -> i32;
    /// Sets the depth at an address.
    fn set_depth(&mut self, address: u64, z: i32);
    /// The pixel at an address of the front or the back page.
    fn read(&self, address: u64, front: bool) -> u32;
    /// Writes a pixel to pages.
    fn write(&mut self, address: u64, pages: Pages, word: u32);
}

impl Canvas for Target {
    fn pages(&self) -> Pages {
        self.pages
    }

    fn depth(&self, address: u64) -> i32 {
        self.depth.read(address)
    }

    fn set_depth(&mut self, address: u64, z: i32) {
        self.depth.write(address, z);
    }

    fn read(&self, address: u64, front: bool) -> u32 {
        self.frame.read(address, front)
    }

    fn write(&mut self, address: u64, pages: Pages, word: u32) {
        self.frame.write(address, pages, word);
    }
}

/// What happened to a fragment, for the cost model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Outcome {
    /// The depth was read and compared.
    pub tested: bool,
    /// The fragment passed (or skipped) the test.
    pub drawn: bool,
    /// Pages read for blending.
    pub page_reads: u32,
    /// Data words written to the frame-buffer controller.
    pub page_writes: u32,
    /// The depth was written.
    pub depth_written: bool,
}

/// Draws one fragment of a whole screen; alpha 0 is skipped, equal depth passes.
pub fn process_at_pixel(
    target: &mut Target,
    mode: ModeBits,
    f: &Fragment,
    errata: &Errata,
) -> Outcome {
    let address = target.frame.address(f.x, f.y);
    process(target, mode, f, address, errata)
}

/// Draws one fragment at an address; alpha 0 is skipped, equal depth passes.
#[inline]
pub fn process<C: Canvas>(
    target: &mut C,
    mode: ModeBits,
    f: &Fragment,
    address: u64,
    errata: &Errata,
) -> Outcome {
    let alpha = low(f.rgba);
    let mut outcome = Outcome::default();
    if alpha == 0 {
        return outcome;
    }
    outcome.tested = mode.no_use_z() == 0;
    if outcome.tested && !passes(target.depth(address), f.z, errata) {
        return outcome;
    }
    outcome.drawn = true;
    if alpha == 255 {
        target.write(address, target.pages(), color::with_low(f.rgba, 0));
        // One message serves both pages, and is sent even when no page is selected.
        outcome.page_writes = 1;
    } else {
        blend(target, address, f.rgba, &mut outcome);
    }
    if mode.no_write_z() == 0 {
        target.set_depth(address, f.z);
        outcome.depth_written = true;
    }
    outcome
}

/// Whether a depth passes the test against the stored one.
#[inline(always)]
pub fn passes(stored: i32, z: i32, errata: &Errata) -> bool {
    if errata.unsigned_depth { z as u32 <= stored as u32 } else { z <= stored }
}

/// Blends into each selected page on its own, back page first.
fn blend<C: Canvas>(target: &mut C, address: u64, source: u32, outcome: &mut Outcome) {
    let alpha = low(source);
    let pages = target.pages();
    let each = [(pages.back(), Pages::BACK), (pages.front(), Pages::FRONT)];
    for (_, page) in each.into_iter().filter(|(selected, _)| *selected) {
        let below = target.read(address, page.front());
        let mixed = color::mix(source, below, alpha);
        target.write(address, page, color::with_low(mixed, 0));
        outcome.page_reads += 1;
        outcome.page_writes += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fragment(z: i32, rgba: u32) -> Fragment {
        Fragment { x: 1, y: 1, z, rgba }
    }

    #[test]
    fn equal_depth_passes_and_farther_fails() {
        let mut target = Target::new(4, 4);
        let mode = ModeBits::default();
        let draw = |target: &mut Target, z, rgba| {
            process_at_pixel(target, mode, &fragment(z, rgba), &Errata::CORRECT).drawn
        };
        assert!(draw(&mut target, 5, 0x1100_00ff));
        assert!(draw(&mut target, 5, 0x2200_00ff));
        assert!(!draw(&mut target, 6, 0x3300_00ff));
        assert!(draw(&mut target, -6, 0x4400_00ff));
        assert_eq!(target.frame.read(5, false), 0x4400_0000);
    }

    #[test]
    fn unsigned_compare_loses_the_near_half() {
        let mut target = Target::new(4, 4);
        let faithful = Errata { unsigned_depth: true, ..Errata::CORRECT };
        let mode = ModeBits::default();
        assert!(!process_at_pixel(&mut target, mode, &fragment(-6, 0xff), &faithful).drawn);
    }

    #[test]
    fn blending_touches_each_page_alone() {
        let mut target = Target::new(4, 4);
        target.pages = Pages::BOTH;
        target.frame.write(5, Pages::FRONT, 0xff00_0000);
        let outcome = process_at_pixel(
            &mut target,
            ModeBits::default(),
            &fragment(0, 0x0000_ff80),
            &Errata::CORRECT,
        );
        assert_eq!((outcome.page_reads, outcome.page_writes), (2, 2));
        assert_eq!(target.frame.read(5, false), 0x0000_8000);
        assert_eq!(target.frame.read(5, true), 0x7f00_8000);
    }
}
