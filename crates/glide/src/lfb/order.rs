//! Calls while a lock is held: what was stored before one is carried out before
//! it, what it draws is shown before it returns.

use fillrate_engine::fixed;
use fillrate_engine::state::Rect;

use crate::board::Board;
use crate::call::Call;
use crate::registers::fbz;
use crate::vertex::GrVertex;

/// How a call meets locks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Meeting {
    /// Not at all, or it takes care itself.
    Nothing,
    /// It may change what becomes of stored pixels, or lets the program look.
    State,
    /// It draws inside a rectangle of the screen.
    Draws(Rect),
}

/// Pixels that smooth points and edges reach beyond their corners, and one
/// more.
const REACH: i32 = 3;
/// Corners so far out may wrap.
const FAR: i32 = 2000;

impl Board {
    /// Whether somebody looks at this board's buffers, or stores into them.
    pub(crate) fn is_locked(&self) -> bool {
        self.lfb.is_held() && self.is_open()
    }

    /// How a call meets the locks of this board.
    pub(crate) fn meeting(&mut self, call: &Call) -> Meeting {
        use Call::*;
        if !self.is_locked() {
            return Meeting::Nothing;
        }
        match call {
            GrDrawPoint { point } | GrAaDrawPoint { point } => self.draws([point]),
            GrDrawLine { a, b } | GrAaDrawLine { a, b } => self.draws([a, b]),
            GrDrawTriangle { a, b, c }
            | GrAaDrawTriangle { a, b, c, .. }
            | GuMpDrawTriangle { a, b, c } => self.draws([a, b, c]),
            GrDrawPolygon { vertices }
            | GrDrawPlanarPolygon { vertices }
            | GrAaDrawPolygon { vertices } => self.draws(vertices),
            // Corners outside the clip window are somewhere else afterwards.
            GuDrawTriangleWithClip { .. }
            | GuAaDrawTriangleWithClip { .. }
            | GuDrawPolygonVertexListWithClip { .. }
            | GrBufferClear { .. } => Meeting::Draws(self.clip_on_screen(self.screen().y1)),
            GrSplash { .. } | GrLfbWriteRegion { .. } => Meeting::Draws(self.screen()),
            // Commands that launch, fill and swap.
            GrSstConfigPipeline { register: 32 | 64 | 73 | 74, .. } => {
                Meeting::Draws(self.screen())
            }
            GrSstConfigPipeline { .. }
            | GrGlideSetState { .. }
            | GrSstIdle {}
            | GrSstResetPerfStats {}
            | GrLfbWriteColorFormat { .. }
            | GrLfbWriteColorSwizzle { .. }
            | GrLfbWriteMode { .. }
            | GrLfbOrigin { .. }
            | GrLfbBypassMode { .. }
            | GrLfbLock { .. }
            | GrDitherMode { .. }
            | GrColorMask { .. }
            | GrDepthMask { .. }
            | GrDepthBufferMode { .. }
            | GrDisableAllEffects {} => Meeting::State,
            GrSstOrigin { .. }
            | GrRenderBuffer { .. }
            | GrClipWindow { .. }
            | GrAlphaBlendFunction { .. }
            | GrAlphaTestFunction { .. }
            | GrAlphaTestReferenceValue { .. }
            | GrChromakeyMode { .. }
            | GrChromakeyValue { .. }
            | GrConstantColorValue { .. }
            | GrDepthBiasLevel { .. }
            | GrDepthBufferFunction { .. }
            | GrFogColorValue { .. }
            | GrFogMode { .. }
            | GrFogTable { .. }
            | GrLfbConstantAlpha { .. }
            | GrLfbConstantDepth { .. }
                if self.stores_through_pipeline() =>
            {
                Meeting::State
            }
            _ => Meeting::Nothing,
        }
    }

    /// Before a call.
    pub(crate) fn meet(&mut self, meeting: Meeting) {
        match meeting {
            Meeting::Nothing => {}
            // A pixel that is stored twice through the pipeline is drawn twice.
            Meeting::Draws(_) if self.stores_through_pipeline() => self.commit_stores(),
            Meeting::Draws(rect) => {
                // What is drawn is shown afterwards.
                self.commit(rect);
            }
            Meeting::State => self.commit_stores(),
        }
    }

    /// After it.
    pub(crate) fn part(&mut self, meeting: Meeting) {
        match meeting {
            Meeting::Nothing => {}
            Meeting::Draws(rect) => {
                self.update_showing();
                self.show_all(rect);
            }
            Meeting::State => self.update_showing(),
        }
    }

    fn stores_through_pipeline(&self) -> bool {
        self.lfb.write.is_some_and(|lock| lock.pipeline)
    }

    /// A primitive with these corners.
    fn draws<'v>(&self, corners: impl IntoIterator<Item = &'v GrVertex>) -> Meeting {
        let screen = self.screen();
        let (width, height) = (screen.x1 as i32, screen.y1 as i32);
        let (mut low, mut high) = ([i32::MAX; 2], [i32::MIN; 2]);
        for corner in corners {
            let at = [corner.x, corner.y].map(|v| fixed::coord(v) >> fixed::COORD_FRACTION);
            for axis in 0..2 {
                low[axis] = low[axis].min(at[axis]);
                high[axis] = high[axis].max(at[axis]);
            }
        }
        if low.into_iter().any(|v| v < -FAR) || high.into_iter().any(|v| v > FAR) {
            return Meeting::Draws(screen);
        }
        let [x0, y0] = low.map(|v| v.saturating_sub(REACH));
        let [x1, y1] = high.map(|v| v.saturating_add(1 + REACH));
        let (y0, y1) = match self.fbi.fbz_mode & fbz::LOWER_LEFT {
            0 => (y0, y1),
            _ => (height.saturating_sub(y1), height.saturating_sub(y0)),
        };
        let inside = |v: i32, limit: i32| v.clamp(0, limit) as u32;
        let (x0, x1) = (inside(x0, width), inside(x1, width));
        Meeting::Draws(Rect::new(x0, inside(y0, height), x1, inside(y1, height)))
    }
}
