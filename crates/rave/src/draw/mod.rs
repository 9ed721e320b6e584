//! Primitives: from the program's vertices to the renderer's.
//!
//! Source: RAVE, drawing methods and pixel pipeline.

mod array;
mod bitmap;
mod clip;
mod convert;
mod line;
mod prepare;
mod triangle;

pub(crate) use prepare::Prepared;

use fillrate_engine::{Vertex, VertexExtra};

use crate::RaveError;
use crate::batch::{Batch, Corner, FullState};
use crate::draw_context::DrawContext;
use crate::objects::Objects;
use crate::queue::Queue;
use crate::translate::{Variant, draw_state};

/// Draws into one context.
pub(crate) struct Pen<'a> {
    pub context: &'a mut DrawContext,
    pub queue: &'a mut Queue,
    pub objects: &'a mut Objects,
}

impl Pen<'_> {
    /// Whether drawing is allowed. Outside a frame, and while the program has
    /// access to the buffers, it is an error.
    #[inline]
    fn may_draw(&mut self) -> bool {
        let accessed = self.context.draw_buffer_accessed || self.context.z_buffer_accessed;
        if !self.context.in_frame || accessed {
            self.context.fail(RaveError::Failure);
            return false;
        }
        if self.context.prepared.is_none() {
            let prepared = prepare::prepare(self.context, self.objects);
            self.context.prepared = Some(Box::new(prepared));
        }
        true
    }

    /// Draws what follows in a variant of the current state.
    fn choose(&mut self, variant: &Variant) {
        if self.queue.batch.is_full() {
            self.queue.flush();
        }
        let Some(prepared) = self.context.prepared.as_deref_mut() else { return };
        self.queue.target(self.context.id.0, prepared.around.plane);
        if prepared.serial != Some(self.queue.serial) {
            prepared.serial = Some(self.queue.serial);
            prepared.variants.clear();
        }
        let known = prepared.variants.iter().find(|(known, _)| known == variant);
        let index = match known {
            Some((_, index)) => *index,
            None => {
                let fog = &self.context.fog_table.1;
                let draw = draw_state(&self.context.state, &prepared.around, variant, fog);
                let textures = prepared.textures_of(variant.paint);
                let index = self.queue.batch.states.len() as u32;
                self.queue.batch.states.push(FullState { draw, textures });
                prepared.variants.push((*variant, index));
                index
            }
        };
        self.queue.state(index);
    }

    /// Adds a triangle by the chosen variant; it may reach beyond what the
    /// renderer's coordinates hold.
    #[inline(always)]
    fn add(&mut self, corners: [Vertex; 3]) {
        if corners.iter().all(clip::fits) {
            return self.queue.batch.triangle(corners);
        }
        self.add_near(corners);
    }

    /// Adds what of a triangle is near the context.
    #[cold]
    fn add_near(&mut self, corners: [Vertex; 3]) {
        let corners = corners.map(|vertex| Corner { vertex, ..Corner::default() });
        self.add_part(&corners, |batch, corners| batch.triangle(corners.map(|c| c.vertex)));
    }

    /// The same with the values beyond the engine's own.
    fn add_extended(&mut self, corners: [Corner; 3]) {
        if corners.iter().all(|corner| clip::fits(&corner.vertex)) {
            return self.queue.batch.extended(corners);
        }
        self.add_part(&corners, Batch::extended);
    }

    /// Adds the part of a triangle near the context.
    fn add_part(&mut self, corners: &[Corner; 3], add: fn(&mut Batch, [Corner; 3])) {
        let polygon = clip::to_guard(corners, self.context.size);
        for i in 1..polygon.len().saturating_sub(1) {
            add(&mut self.queue.batch, [polygon[0], polygon[i], polygon[i + 1]]);
        }
    }

    /// Adds corners that share their values beyond the engine's own.
    fn add_flat(&mut self, corners: [Vertex; 3], extra: &VertexExtra, is_extended: bool) {
        if is_extended {
            self.add_extended(corners.map(|vertex| Corner { vertex, extra: *extra }));
        } else {
            self.add(corners);
        }
    }
}
