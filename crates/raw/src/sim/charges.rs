//! From work done to bursts of cycles. Both builds are charged through these functions.

use super::cost::{Burst, Costs};
use crate::opcode::Opcode;
use crate::stage::combine::Textured;
use crate::stage::composite::Outcome;
use crate::stage::geometry::GeometryWork;
use crate::stage::raster::{Interpolants, RasterWork};
use crate::state::{PrimInfo, texmode};

/// A command on a screen of so many pixels, without the words it is made of; returns the pixels that
/// the frame-buffer controller is sent. Words of a block count as commands of their own.
pub fn command(c: &Costs, op: Opcode, screen: u64, mut charge: impl FnMut(Burst)) -> u64 {
    let (pixels, depths) = match op {
        Opcode::ClearFb => (screen, 0),
        Opcode::ClearZ | Opcode::Reset => (0, screen),
        Opcode::WriteFb => (1, 0),
        Opcode::WriteZ => (0, 1),
        _ => (0, 0),
    };
    charge(c.s1.command_pixel.times((pixels + depths) as u32));
    pixels
}

/// Stage 1 after the end of the primitive has been read.
pub fn geometry(c: &Costs, work: &GeometryWork, mut charge: impl FnMut(Burst)) {
    charge(c.s1.records);
    // The table is for a triangle; strips and meshes share vertices.
    charge(c.s1.transform.share(work.vertices, 3));
    charge(c.s1.visibility.times(work.parts));
    if work.visible {
        charge(c.s1.light_vertex.times(work.lit_vertices));
        charge(c.s1.clip_vertex.times(work.new_vertices));
        charge(c.s1.premultiply.times(work.sent));
        charge(c.s1.premultiply_extra.times(work.extra_attributes * work.sent));
    }
}

/// Stage 2 before the first pixel.
pub fn setup(c: &Costs, needs: Interpolants, mut charge: impl FnMut(Burst)) {
    charge(c.s2.setup);
    charge(c.s2.plane.times(needs.planes()));
    charge(c.s2.average.times(u32::from(needs.flat_color)));
}

/// Stage 2 walking the box; `parts` of fifteen parts of the cost of a visited pixel arise.
pub fn walk(c: &Costs, work: RasterWork, parts: u32, mut charge: impl FnMut(Burst)) {
    charge(c.s2.row.times(work.rows));
    charge(c.s2.visit.times(work.visited).share(parts, 15));
}

/// Stage 2 making a fragment, without what its values are divided by.
pub fn cover(c: &Costs, needs: Interpolants, mut charge: impl FnMut(Burst)) {
    charge(c.s2.cover);
    if needs.z {
        charge(c.s2.z);
    }
}

/// Recovering w, and dividing the values of a fragment.
pub fn divide(c: &Costs, needs: Interpolants, mut charge: impl FnMut(Burst)) {
    let parts = [
        (needs.color, c.s2.color),
        (needs.alpha, c.s2.alpha),
        (needs.uv, c.s2.uv),
        (needs.intensity, c.s2.intensity),
        (needs.perspective(), c.s2.reciprocal),
    ];
    parts.into_iter().filter(|(used, _)| *used).for_each(|(_, burst)| charge(burst));
}

/// Stage 3 texturing and combining a fragment, without the transfers.
pub fn combine(c: &Costs, info: &PrimInfo, textured: &Textured, mut charge: impl FnMut(Burst)) {
    let mode = info.mode;
    let nearest = textured.looked_up && mode.tex_interp() == 0;
    let bilinear = textured.looked_up && mode.tex_interp() == 1;
    let two_levels = textured.addresses[textured.addresses.len() / 2..].iter().any(Option::is_some);
    let levels = 1 + u32::from(two_levels);
    let blend = matches!(mode.texmode(), texmode::BLEND | texmode::TEXDECAL | texmode::COLDECAL);
    charge(c.s3.core);
    let parts = [
        (nearest, c.s3.nearest.times(levels)),
        (bilinear, c.s3.bilinear.times(levels)),
        (blend, c.s3.blend),
        (mode.texmode() == texmode::MODULATE, c.s3.modulate),
        (mode.lit() == 1 && mode.use_amb() == 1, c.s3.ambient),
        (mode.uses_intensity(), c.s3.directional),
    ];
    parts.into_iter().filter(|(used, _)| *used).for_each(|(_, burst)| charge(burst));
}

/// Stage 4 drawing a fragment, beyond the base cost of a pixel and without waiting for memory.
pub fn composite(c: &Costs, outcome: &Outcome, mut charge: impl FnMut(Burst)) {
    if outcome.tested {
        charge(c.s4.z_test);
    }
    if outcome.depth_written {
        charge(c.s4.z_write);
    }
    charge(c.s4.blend.times(outcome.page_reads));
}
