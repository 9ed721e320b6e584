//! Destinations larger than the engine's coordinates, which end at 2047 pixels.
//!
//! Such a destination is drawn in windows: parts that begin at a pixel of it and
//! are targets of their own, at their own address. A command is drawn in each
//! window that the scissor touches, with its places less the window's.

use fillrate_engine::state::{DrawState, PatternBits, Rect};

use super::target::{DepthBuffer, Place};

/// The longest side that is drawn as one. Of triangles with a corner beyond
/// column or row 2047 only what lies before it is drawn.
const WHOLE: u32 = 2032;
/// The sides of the windows of others. The dither matrix repeats in them, and
/// what reaches no farther than as many pixels beyond is not cut.
const SIDE: u32 = 1024;

/// A destination, and the window of it that is drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Windows {
    color: Place,
    depth: DepthBuffer,
    size: (u32, u32),
    /// What the scissor leaves of the destination.
    clip: Rect,
    /// Columns and rows of a window.
    sides: [u32; 2],
    window: Rect,
}

impl Windows {
    /// Of a destination and its depth buffer; `clip` lies inside it. The first
    /// window is drawn.
    pub fn new(color: Place, depth: DepthBuffer, size: (u32, u32), clip: Rect) -> Windows {
        let side = |whole: u32| if whole <= WHOLE { whole } else { SIDE };
        let clip = if clip.is_empty() { Rect::default() } else { clip };
        let sides = [size.0, size.1].map(side);
        let window = Rect::default();
        let mut windows = Windows { color, depth, size, clip, sides, window };
        windows.window = windows.at(clip.x0 / sides[0], clip.y0 / sides[1]);
        windows
    }

    /// A window by its number along both axes.
    fn at(&self, column: u32, row: u32) -> Rect {
        let [x0, y0] = [column * self.sides[0], row * self.sides[1]];
        let (x1, y1) =
            ((x0 + self.sides[0]).min(self.size.0), (y0 + self.sides[1]).min(self.size.1));
        Rect::new(x0, y0, x1, y1)
    }

    /// Numbers of the first window and of the one after the last.
    fn range(&self) -> [std::ops::Range<u32>; 2] {
        let [width, height] = self.sides;
        let Rect { x0, y0, x1, y1 } = self.clip;
        [x0 / width..x1.div_ceil(width), y0 / height..y1.div_ceil(height)]
    }

    /// How many windows the scissor touches.
    pub fn count(&self) -> usize {
        self.range().map(|range| range.len()).iter().product()
    }

    /// Whether there is no other one to be drawn.
    #[inline]
    pub fn is_one(&self) -> bool {
        let Rect { x0, y0, x1, y1 } = self.window;
        self.clip.x0 >= x0 && self.clip.x1 <= x1 && self.clip.y0 >= y0 && self.clip.y1 <= y1
    }

    /// All windows that the scissor touches.
    pub fn all(self) -> impl Iterator<Item = Rect> {
        let [columns, rows] = self.range();
        rows.flat_map(move |row| columns.clone().map(move |column| self.at(column, row)))
    }

    /// The window that is drawn.
    pub fn window(&self) -> Rect {
        self.window
    }

    /// Its first pixel.
    #[inline]
    pub fn origin(&self) -> [u32; 2] {
        [self.window.x0, self.window.y0]
    }

    /// What of the destination can be drawn in it.
    pub fn scissor(&self) -> Rect {
        self.clip.intersect(&self.window)
    }

    /// Goes on to another window, whose state takes the place of this one's.
    pub fn select(&mut self, window: Rect, state: &mut DrawState) {
        let from = i64::from(self.window.x0);
        self.window = window;
        *state = self.placed(state, from);
    }

    /// The state of the destination in the window.
    pub fn state(&self, whole: &DrawState) -> DrawState {
        self.placed(whole, 0)
    }

    /// A state whose places begin with column `from`, in the window.
    fn placed(&self, state: &DrawState, from: i64) -> DrawState {
        let mut state = *state;
        state.clip = Some(moved(&self.scissor(), self.origin()));
        if let Some(pattern) = &mut state.pattern
            && let PatternBits::Line { origin, .. } = &mut pattern.bits
        {
            *origin += (from - i64::from(self.window.x0)) as i32;
        }
        state
    }

    /// Where the window's pixels and depths lie.
    pub fn places(&self) -> (Place, DepthBuffer) {
        let at = self.origin();
        let depth = match self.depth {
            DepthBuffer::At(depth) => DepthBuffer::At(depth.at(at)),
            other => other,
        };
        (self.color.at(at), depth)
    }
}

/// A rectangle where pixel `at` is the first one; it lies below and to the right
/// of it.
pub(super) fn moved(rect: &Rect, [x, y]: [u32; 2]) -> Rect {
    Rect::new(rect.x0 - x, rect.y0 - y, rect.x1 - x, rect.y1 - y)
}
