//! Which primitives must be drawn in order, and the sequence numbers that see to it.
//!
//! Source: RAW, section 3.3.2 and the stage-1 listing.

use super::InputVertex;
use crate::color;
use crate::errata::Errata;
use crate::state::{ModeBits, RenderState, alpha, texmode};

/// Whether the primitive may be drawn in any order relative to its neighbours.
///
/// Opaque primitives with an ordinary depth test give the same picture in any order (but for equal
/// depths). A user who sets `out_of_order` forces the answer.
pub fn is_unordered(mode: ModeBits, vertices: &[InputVertex], errata: &Errata) -> bool {
    mode.out_of_order() == 1 || !must_be_ordered(mode, vertices, errata)
}

fn must_be_ordered(mode: ModeBits, vertices: &[InputVertex], errata: &Errata) -> bool {
    let all = |value| vertices.iter().all(|v| color::low(v.rgba) == value);
    let translucent = !all(0) && !all(255);
    // What is neither forced opaque nor cut by the threshold is soft, the fourth value as well.
    let keeps = errata.ordering_ignores_decals;
    let soft = |alpha| alpha == alpha::SOFT || (!keeps && alpha > alpha::HARD);
    let (texture, color) = (soft(mode.tex_alpha()), soft(mode.col_alpha()));
    let tm = mode.texmode();
    let soft_texture = texture && (tm & 2 != 0 || (tm & 4 != 0 && translucent));
    let soft_color =
        color && translucent && matches!(tm, texmode::COLOR | texmode::BLEND | texmode::MODULATE);
    // Where two layers are mixed, a transparent one lets the other through in part.
    let mixed = matches!(tm, texmode::BLEND | texmode::TEXDECAL | texmode::COLDECAL)
        && (texture || (color && !all(255)));
    mode.no_use_z() == 1
        || mode.no_write_z() == 1
        || soft_texture
        || soft_color
        || (mixed && !keeps)
}

/// What numbering a primitive led to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Numbered {
    /// The number the primitive carries.
    pub seq_num: u32,
    /// Whether the sequence number rolled over, so that the pipeline has to be flushed: before
    /// this primitive in the faithful mode, after it otherwise.
    pub rolled_over: bool,
}

/// Gives the next primitive its number and advances the counters.
///
/// An ordered primitive waits for exactly its number. An unordered one carries the number after the
/// last ordered primitive, and may be drawn at that token value or any later one.
pub fn number(state: &mut RenderState, unordered: bool, errata: &Errata) -> Numbered {
    let current = state.prim.seq_num;
    let next = current.wrapping_add(1);
    if !unordered {
        state.lagged_seq_num = next;
    }
    let seq_num = if unordered { state.lagged_seq_num } else { current };
    state.prim.seq_num = next;
    let rolled_over = next == 0;
    if rolled_over && !errata.rollover_keeps_lagged {
        state.lagged_seq_num = 0;
    }
    Numbered { seq_num, rolled_over }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(state: &mut RenderState, kinds: &str) -> Vec<u32> {
        kinds.chars().map(|k| number(state, k == 'O', &Errata::CORRECT).seq_num).collect()
    }

    #[test]
    fn twenty_primitives_of_the_thesis() {
        let mut state = RenderState::default();
        let got = numbers(&mut state, "OOOIIIOOOOIIOIOIOOOI");
        let want = [1, 1, 1, 4, 5, 6, 7, 7, 7, 7, 11, 12, 13, 14, 15, 16, 17, 17, 17, 20];
        assert_eq!(got, want);
        assert!(completes(&got, "OOOIIIOOOOIIOIOIOOOI"));
    }

    /// Whether some completion order exists in which the token takes the values 1, 2, 3...
    fn completes(numbers: &[u32], kinds: &str) -> bool {
        let mut left: Vec<_> = numbers.iter().copied().zip(kinds.chars()).collect();
        for token in 1..=numbers.len() as u32 {
            let ready =
                |&(n, kind): &(u32, char)| if kind == 'I' { n == token } else { n <= token };
            let ordered = left.iter().position(|p| p.1 == 'I' && ready(p));
            let Some(at) = ordered.or_else(|| left.iter().position(ready)) else { return false };
            left.remove(at);
        }
        left.is_empty()
    }

    #[test]
    fn roll_over_resets_the_lagged_number() {
        let mut state = RenderState::default();
        state.prim.seq_num = u32::MAX;
        state.lagged_seq_num = 7;
        let first = number(&mut state, true, &Errata::CORRECT);
        assert_eq!(first, Numbered { seq_num: 7, rolled_over: true });
        assert_eq!(number(&mut state, true, &Errata::CORRECT).seq_num, 0);
        assert_eq!(number(&mut state, false, &Errata::CORRECT).seq_num, 1);
    }

    #[test]
    fn soft_textures_are_ordered_and_opaque_colour_is_not() {
        let opaque = [InputVertex { rgba: 0xff, ..InputVertex::default() }; 3];
        let mut mode = ModeBits::default();
        assert!(is_unordered(mode, &opaque, &Errata::CORRECT));
        mode.set_texmode(texmode::TEXTURE);
        assert!(!is_unordered(mode, &opaque, &Errata::CORRECT));
        mode.set_out_of_order(1);
        assert!(is_unordered(mode, &opaque, &Errata::CORRECT));
    }

    #[test]
    fn blended_texture_shows_through_transparent_colour() {
        let clear = [InputVertex { rgba: 0, ..InputVertex::default() }; 3];
        let mut mode = ModeBits::default();
        mode.set_texmode(texmode::BLEND);
        mode.set_tex_alpha(alpha::NONE);
        assert!(!is_unordered(mode, &clear, &Errata::CORRECT));
        assert!(is_unordered(mode, &clear, &Errata::FAITHFUL));
    }

    #[test]
    fn the_fourth_alpha_mode_is_soft() {
        let half = [InputVertex { rgba: 0x80, ..InputVertex::default() }; 3];
        let mut mode = ModeBits::default();
        mode.set_col_alpha(3);
        assert!(!is_unordered(mode, &half, &Errata::CORRECT));
        assert!(is_unordered(mode, &half, &Errata::FAITHFUL));
    }

    #[test]
    fn decals_with_soft_colour_alpha_are_ordered_when_correct() {
        let half = [InputVertex { rgba: 0x80, ..InputVertex::default() }; 3];
        let mut mode = ModeBits::default();
        mode.set_texmode(texmode::COLDECAL);
        mode.set_tex_alpha(alpha::NONE);
        assert!(!is_unordered(mode, &half, &Errata::CORRECT));
        let keep = Errata { ordering_ignores_decals: true, ..Errata::CORRECT };
        assert!(is_unordered(mode, &half, &keep));
    }
}
