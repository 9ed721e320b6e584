//! One fragment from the clip window to the surface.
//!
//! Source: SST1, pixel pipeline; LFB writes through the pipeline enter here as
//! well.

use fillrate_engine::PixelFormat;
use fillrate_engine::state::{AuxWrite, DrawState};

use super::{Reference, depth, dither, fog, output, shade};

/// Where a fragment is. It lies on the surface.
#[derive(Clone, Copy, Debug)]
pub struct Position {
    /// Column.
    pub x: u32,
    /// Row in drawing coordinates.
    pub y: u32,
    /// Row from the top of the screen.
    pub row: u32,
}

/// What the later stages need of a fragment's iterators.
#[derive(Clone, Copy, Debug)]
pub struct Iterated {
    /// 16 bits, without bias.
    pub z: i32,
    /// Pseudo-float w, 16 bits, without bias.
    pub w: i32,
    /// Depth of a deep source.
    pub deep: u32,
    /// Whether z, before its rule, was no 16-bit number.
    pub is_outside: bool,
    /// 8 bits.
    pub alpha: i32,
    /// The part of the colour that iterated fog leaves; ready-made fragments
    /// have none and stay as they are.
    pub fog_part: Option<i32>,
    /// Added to depth and to the fog table's index.
    pub bias: Option<i16>,
}

/// What the combine units make of a fragment; channels are 0..=255.
#[derive(Clone, Copy, Debug)]
pub struct Shaded {
    /// "Other" red, green and blue of the colour unit.
    pub other: [i32; 3],
    /// Red, green, blue, alpha of the units' outputs.
    pub out: [i32; 4],
}

impl Reference {
    /// Takes one fragment through all stages; `shade` textures and combines, and
    /// gives nothing where keyed texels drop the fragment.
    pub(super) fn fragment(
        &mut self,
        state: &DrawState,
        at: Position,
        values: Iterated,
        shade: impl FnOnce() -> Option<Shaded>,
    ) {
        self.counters.pixels_in += 1;
        if outside_clip(state, at)
            || stippled_out(state, at)
            || shade::patterned_out(state, at.x, at.row)
        {
            return;
        }
        let index = (at.row * self.width + at.x) as usize;
        let aux = self.aux.as_ref().map(|aux| aux[index]);
        let depth = depth::of_fragment(&state.depth, values);
        let tested = aux.filter(|_| depth::fits(state.depth.source, self.aux_format));
        if depth::is_rejected(&state.depth, values)
            || tested.is_some_and(|aux| !depth::passes(&state.depth, depth, aux))
        {
            self.counters.depth_fail += 1;
            return;
        }
        let Some(mut shaded) = shade() else {
            self.counters.chroma_fail += 1;
            return;
        };
        if state.chroma_key.is_some_and(|key| is_key(shaded.other, key)) {
            self.counters.chroma_fail += 1;
            return;
        }
        if let Some(color) = shade::gap_color(state, at.x, at.row) {
            shaded.out = color;
        }
        let alpha = shaded.out[3];
        if state.alpha_test.is_some_and(|t| !t.compare.holds(alpha, t.reference.into())) {
            self.counters.alpha_fail += 1;
            return;
        }
        self.counters.pixels_out += 1;
        let fogged = fog::apply(state, shaded.out, values);
        let aux = aux.filter(|_| self.aux_format == Some(PixelFormat::Aux16));
        let destination =
            output::Destination { format: self.format, color: self.color[index], aux };
        let blended = output::blend(state, fogged, shaded.out, &destination, at);
        self.write(state, index, at, blended, depth);
    }

    fn write(&mut self, state: &DrawState, index: usize, at: Position, out: [i32; 4], depth: u32) {
        if state.color_write {
            let argb = dither::join(out);
            let [right, down] = state.dither_offset.map(u32::from);
            let (x, row) = (at.x + right, at.row + down);
            let new = dither::pack(self.format, argb, state.dither, x, row);
            self.color[index] = output::merge(state, self.format, new, self.color[index]);
        }
        let Some(aux) = &mut self.aux else { return };
        match state.aux_write {
            AuxWrite::Nothing => {}
            AuxWrite::Depth if depth::fits(state.depth.source, self.aux_format) => {
                aux[index] = depth;
            }
            AuxWrite::Alpha if self.aux_format == Some(PixelFormat::Aux16) => {
                aux[index] = out[3] as u32;
            }
            AuxWrite::Depth | AuxWrite::Alpha => {}
        }
    }
}

/// Maxima are exclusive; rows count before the flip.
fn outside_clip(state: &DrawState, at: Position) -> bool {
    state
        .clip
        .is_some_and(|clip| at.x < clip.x0 || at.x >= clip.x1 || at.y < clip.y0 || at.y >= clip.y1)
}

fn stippled_out(state: &DrawState, at: Position) -> bool {
    state.stipple.is_some_and(|stipple| {
        let bit = (at.row & 3) * 8 + (!at.x & 7);
        stipple.pattern >> bit & 1 == 0
    })
}

fn is_key([r, g, b]: [i32; 3], key: u32) -> bool {
    (r << 16 | g << 8 | b) as u32 == key & 0xff_ffff
}
