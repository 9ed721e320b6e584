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

use crate::RaveError;
use crate::draw_context::DrawContext;
use crate::objects::Objects;
use crate::painter::{Corner, Painter};
use crate::translate::{Variant, draw_state};

/// Draws into one context.
pub(crate) struct Pen<'a> {
    pub context: &'a mut DrawContext,
    pub painter: &'a mut Painter,
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
            let serial = self.painter.serial();
            let prepared = prepare::prepare(self.context, self.objects, serial);
            self.context.prepared = Some(Box::new(prepared));
        }
        true
    }

    /// Draws what follows in a variant of the current state.
    #[inline]
    fn choose(&mut self, variant: &Variant) {
        let Some(prepared) = self.context.prepared.as_deref() else { return };
        if !self.painter.draws_by(prepared.serial, variant) {
            self.change_to(variant);
        }
    }

    #[cold]
    fn change_to(&mut self, variant: &Variant) {
        let Some(prepared) = self.context.prepared.as_deref_mut() else { return };
        let place = (self.context.id.0, prepared.around.plane);
        let by = (prepared.serial, *variant);
        let textures = prepared.textures_of(variant.paint);
        let variants = &mut prepared.variants;
        let index = variants.iter().position(|(known, _)| known == variant).unwrap_or_else(|| {
            // Lines with a pattern are all different.
            if variants.len() >= MAX_VARIANTS {
                variants.clear();
            }
            let fog = &self.context.fog_table.1;
            let state = draw_state(&self.context.state, &prepared.around, variant, fog);
            variants.push((*variant, state));
            variants.len() - 1
        });
        self.painter.choose(place, by, &variants[index].1, textures);
    }

    /// Adds a triangle by the chosen variant; it may reach beyond what the
    /// renderer's coordinates hold.
    fn add(&mut self, corners: [Corner; 3], is_extended: bool) {
        if corners.iter().all(|Corner { vertex, .. }| clip::fits(vertex.x, vertex.y)) {
            return self.add_inside(&corners, is_extended);
        }
        let polygon = clip::to_guard(&corners, self.context.size);
        for i in 1..polygon.len().saturating_sub(1) {
            self.add_inside(&[polygon[0], polygon[i], polygon[i + 1]], is_extended);
        }
    }

    fn add_inside(&mut self, corners: &[Corner; 3], is_extended: bool) {
        if is_extended {
            self.painter.extended(corners);
        } else {
            self.painter.triangle(|i| corners[i].vertex);
        }
    }
}

/// Draw states that are kept of a context's state.
const MAX_VARIANTS: usize = 16;
