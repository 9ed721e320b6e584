//! Cases as text that a person can read and build again.

use std::fmt::Write as _;

use fillrate_engine::state::DrawState;

use crate::random::{Case, Command};

/// A case; states by what differs from the default, textures by their shape.
pub fn case(case: &Case) -> String {
    let Case { width, height, format, aux, contents, commands } = case;
    let mut out =
        format!("{width}x{height} {format:?}, aux {aux:?}, contents {contents:?}, commands:\n");
    for command in commands {
        match command {
            Command::State { state, textures } => {
                out += &draw_state(state);
                let shapes = textures.each_ref().map(|t| t.as_ref().map(|t| t.desc()));
                let _ = writeln!(out, "textures {shapes:?}");
            }
            other => {
                let _ = writeln!(out, "{other:?}");
            }
        }
    }
    out
}

/// The fields of a state that are not the default ones, a line each.
fn draw_state(state: &DrawState) -> String {
    let default = DrawState::default();
    let mut out = String::from("state of\n");
    macro_rules! fields {
        ($($field:ident)*) => {
            $(if state.$field != default.$field {
                let _ = writeln!(out, "  {}: {:?}", stringify!($field), state.$field);
            })*
        };
    }
    fields!(origin clip stipple depth aux_write units chroma_key color_combine alpha_combine);
    fields!(color0 color1 shade alpha_test fog fog_table blend dither dither_offset);
    fields!(pattern logic_op channels plane_mask color_write);
    out
}
