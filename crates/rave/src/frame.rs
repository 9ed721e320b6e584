//! Frames: start, end, and when they are seen.
//!
//! Source: RAVE, rendering control.

use fillrate_engine::state::Rect;

use crate::RaveError;
use crate::constants::{context, notice};
use crate::context::Context;
use crate::draw_context::DrawContext;
use crate::painter::{ClearPlanes, Painter};
use crate::present::Present;
use crate::tags::{float, int};
use crate::translate::scissor;
use crate::vertex::RaveRect;

type Outcome = Result<(), RaveError>;

impl Context {
    /// `QARenderStart`.
    pub(crate) fn render_start(&mut self, id: u32, dirty: Option<&RaveRect>, initial: u32) {
        let source = self.cache(id, initial);
        let Some((context, painter)) = self.context_and_painter(id) else { return };
        if context.in_frame {
            // The frame before was not ended.
            context.fail(RaveError::Failure);
        }
        let scale = context.wanted_scale();
        // Where there is no room, it stays as it was.
        if scale != context.scale && painter.rescale(id, scale).is_ok() {
            context.scale = scale;
        }
        context.in_frame = true;
        context.frames += 1;
        context.prepared = None;
        let rect = context.inside(dirty);
        match source {
            Ok(Some(from)) => painter.copy(id, from, rect, [true, true]),
            other => {
                if let Err(error) = other {
                    context.fail(error);
                }
                // The notice is for frames that start from nothing.
                let keeps =
                    initial == 0 && context.notices[notice::IMAGE_BUFFER_INITIALIZE as usize];
                let color = (!keeps).then(|| (context.background(), context.dither()));
                let depth = Some(depth_background(context));
                painter.clear(id, &ClearPlanes { rect, color, depth });
            }
        }
        self.objects.memory.start_frame();
    }

    /// The cache context that a context can start from; `None` where none is
    /// given.
    fn cache(&self, id: u32, initial: u32) -> Result<Option<u32>, RaveError> {
        if initial == 0 {
            return Ok(None);
        }
        let (to, from) = (self.contexts.get(&id), self.contexts.get(&initial));
        let (to, from) = to.zip(from).ok_or(RaveError::Parameter)?;
        let alike = to.size == from.size
            && from.has(context::CACHE)
            && !from.in_frame
            && (to.spec.flags ^ from.spec.flags) & !context::CACHE == 0;
        if alike { Ok(Some(initial)) } else { Err(RaveError::Parameter) }
    }

    /// `QARenderEnd`.
    pub(crate) fn render_end(&mut self, id: u32, modified: Option<&RaveRect>) -> Outcome {
        self.objects.settle();
        let Some((context, painter)) = self.context_and_painter(id) else {
            return Err(RaveError::Parameter);
        };
        if !context.in_frame {
            context.fail(RaveError::Failure);
            return context.report();
        }
        context.in_frame = false;
        let accessed = context.draw_buffer_accessed || context.z_buffer_accessed;
        if accessed {
            context.fail(RaveError::Failure);
            (context.draw_buffer_accessed, context.z_buffer_accessed) = (false, false);
        }
        // Where there is nothing to swap, the end is a flush.
        let swaps = context.state.int(int::DONT_SWAP) == 0 || context.draws_to_front();
        let shows = !context.has(context::CACHE) && swaps;
        if shows {
            let rect = context.inside(modified);
            present(context, painter, rect);
        } else {
            painter.submit();
        }
        context.pending.push(painter.started());
        let result = context.report();
        if shows {
            self.shown = Some(id);
        }
        self.objects.memory.end_frame();
        self.pictures_of(id);
        result
    }

    /// `QARenderAbort`.
    pub(crate) fn render_abort(&mut self, id: u32) -> Outcome {
        self.objects.settle();
        let Some((context, painter)) = self.context_and_painter(id) else {
            return Err(RaveError::Parameter);
        };
        if !context.in_frame {
            context.fail(RaveError::Failure);
        }
        context.in_frame = false;
        (context.draw_buffer_accessed, context.z_buffer_accessed) = (false, false);
        painter.sync();
        let result = context.report();
        self.objects.memory.end_frame();
        self.objects.memory.sync();
        self.pictures_of(id);
        result
    }

    /// `QAFlush`.
    pub(crate) fn flush(&mut self, id: u32) -> Outcome {
        self.objects.settle();
        let Some((context, painter)) = self.context_and_painter(id) else {
            return Err(RaveError::Parameter);
        };
        let shows = context.in_frame && context.draws_to_front();
        if shows {
            let rect = context.bounds();
            present(context, painter, rect);
        } else {
            painter.submit();
        }
        let result = context.report();
        if shows {
            self.shown = Some(id);
        }
        result
    }

    /// `QASync`.
    pub(crate) fn sync(&mut self, id: u32) -> Outcome {
        let result = self.flush(id);
        self.objects.memory.sync();
        if let Some((_, painter)) = self.context_and_painter(id) {
            painter.sync();
        }
        result
    }

    /// `QASwapBuffers`.
    pub(crate) fn swap_buffers(&mut self, id: u32, dirty: Option<&RaveRect>) -> Outcome {
        let Some((context, painter)) = self.context_and_painter(id) else {
            return Err(RaveError::Parameter);
        };
        if context.has(context::CACHE) {
            return Err(RaveError::NotSupported);
        }
        let rect = context.inside(dirty);
        present(context, painter, rect);
        context.pending.push(painter.started());
        self.shown = Some(id);
        Ok(())
    }

    /// `QAClearDrawBuffer` and `QAClearZBuffer`: fills with the background, or
    /// copies from a cache. Inside the scissor rectangle.
    pub(crate) fn clear_buffer(
        &mut self,
        id: u32,
        rect: Option<&RaveRect>,
        initial: u32,
        [color, depth]: [bool; 2],
    ) -> Outcome {
        let source = self.cache(id, initial);
        let Some((context, painter)) = self.context_and_painter(id) else {
            return Err(RaveError::Parameter);
        };
        if !context.in_frame || depth && context.has(context::NO_Z_BUFFER) {
            return Err(RaveError::Failure);
        }
        let mut rect = context.inside(rect);
        if let Some(scissor) = scissor(&context.state, context.size) {
            rect = rect.intersect(&scissor);
        }
        match source? {
            Some(from) => painter.copy(id, from, rect, [color, depth]),
            None => {
                let color = color.then(|| (context.background(), context.dither()));
                let depth = depth.then(|| depth_background(context));
                painter.clear(id, &ClearPlanes { rect, color, depth });
            }
        }
        Ok(())
    }
}

fn depth_background(context: &DrawContext) -> f32 {
    context.state.float(float::GL_DEPTH_BG)
}

fn present(context: &DrawContext, painter: &mut Painter, rect: Rect) {
    let composite = context.state.int(int::BUFFER_COMPOSITE);
    let filter = context.state.int(int::DRAW_CONTEXT_FILTER);
    painter.present(context.id.0, Present { rect, composite, filter });
}
