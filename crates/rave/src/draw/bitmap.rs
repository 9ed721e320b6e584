//! Bitmaps: rectangles of pixels, cut to the context.

use fillrate_engine::{TmuVertex, Vertex};

use super::Pen;
use super::prepare::bind_bitmap;
use super::triangle::is_finite_gouraud;
use crate::RaveError;
use crate::painter::Corner;
use crate::tags::float;
use crate::translate::{Paint, PatternUse, Sampled, Variant};
use crate::vertex::VGouraud;

impl Pen<'_> {
    /// `QADrawBitmap`.
    pub fn bitmap(&mut self, v: &VGouraud, bitmap: u32) {
        if !self.may_draw() {
            return;
        }
        if !is_finite_gouraud(v) {
            return self.context.fail(RaveError::Parameter);
        }
        let Some(bound) = bind_bitmap(self.context, self.objects, bitmap) else { return };
        self.objects.usage.add(self.painter.serial(), bound.resource.as_slice());
        let scale_x = self.context.state.float(float::BITMAP_SCALE_X);
        let scale_y = self.context.state.float(float::BITMAP_SCALE_Y);
        if !(scale_x > 0.0 && scale_y > 0.0) {
            return;
        }
        let keyed = self.context.state.int(crate::tags::int::CHROMAKEY_ENABLE) != 0;
        let Some(prepared) = self.context.prepared.as_deref_mut() else { return };
        let has_w = v.inv_w > 0.0;
        let fog = prepared.fog_source(has_w);
        let is_extended = prepared.extends(fog);
        let alpha_is_one = prepared.alpha_fog || v.a >= 1.0;
        let variant = Variant {
            paint: Paint::Bitmap,
            opaque: prepared.is_opaque(alpha_is_one && bound.opaque),
            bright: false,
            fog,
            pattern: PatternUse::None,
        };
        let extra = prepared.extra(v.z, v.inv_w, v.a);
        let base = Vertex { r: 255.0, g: 255.0, b: 255.0, ..prepared.gouraud(v) };
        let [columns, rows] = bound.size;
        let (top, bottom) = if bound.flipped { (rows, 0.0) } else { (0.0, rows) };
        let place = |at: f32, scale: f32| if scale == 1.0 { (at + 0.5).floor() } else { at };
        let (left, upper) = (place(v.x, scale_x), place(v.y, scale_y));
        let (right, lower) = (left + columns * scale_x, upper + rows * scale_y);
        if ![left, upper, right, lower].iter().all(|side| side.is_finite()) {
            return self.context.fail(RaveError::Parameter);
        }
        let corner = |x: f32, y: f32, s: f32, t: f32| at(&base, [x, y], [s, t]);
        let [a, b] = [corner(left, upper, 0.0, top), corner(right, upper, columns, top)];
        let [c, d] = [corner(left, lower, 0.0, bottom), corner(right, lower, columns, bottom)];
        // The state samples the bitmap in place of the texture.
        let sampled = Some(Sampled { levels: 1, keyed });
        let texture = prepared.exchange_bitmap(self.painter.serial(), Some(bound), sampled);
        self.choose(&variant);
        let corners = |corners: [Vertex; 3]| corners.map(|vertex| Corner { vertex, extra });
        self.add(corners([a, b, c]), is_extended);
        self.add(corners([b, d, c]), is_extended);
        if let Some(prepared) = self.context.prepared.as_deref_mut() {
            prepared.exchange_bitmap(self.painter.serial(), None, texture);
        }
    }
}

/// A corner of the rectangle with its texel.
fn at(base: &Vertex, [x, y]: [f32; 2], [s, t]: [f32; 2]) -> Vertex {
    let mut vertex = *base;
    (vertex.x, vertex.y) = (x, y);
    vertex.tmu[0] = TmuVertex { s, t, w: 1.0 };
    vertex
}
