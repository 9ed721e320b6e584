//! Which of the thesis's own errors to keep.
//!
//! The thesis prints its complete program, and the program contains mistakes, some of which the
//! text admits. Each one that can change a result has a switch here: `true` keeps what the listing
//! does, `false` does what was meant. Two presets: [`Errata::CORRECT`] (the default) and
//! [`Errata::FAITHFUL`].

macro_rules! errata {
    ($($(#[$doc:meta])* $name:ident,)+) => {
        /// One switch per documented error; `true` keeps the error.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub struct Errata {
            $($(#[$doc])* pub $name: bool,)+
            /// Option, not an error: decal modes 4 and 5 combine alpha with the "over" rule
            /// instead of blending it linearly, so that an opaque base stays opaque.
            pub decal_over_alpha: bool,
            /// Option, not an error: a top-left rule on the edges, so that a pixel centre on a
            /// shared edge is drawn once. Without it both triangles draw it.
            pub top_left_rule: bool,
        }

        impl Errata {
            /// Every error repaired; the default.
            pub const CORRECT: Self =
                Self { $($name: false,)+ decal_over_alpha: false, top_left_rule: false };
            /// Every error of the listing kept.
            pub const FAITHFUL: Self =
                Self { $($name: true,)+ decal_over_alpha: false, top_left_rule: false };
            /// The names of all switches that stand for an error, in the order of the listing.
            pub const NAMES: &'static [&'static str] = &[$(stringify!($name),)+];

            /// The preset of that name: `correct` or `faithful`.
            pub fn by_name(name: &str) -> Option<Self> {
                match name {
                    "correct" => Some(Self::CORRECT),
                    "faithful" => Some(Self::FAITHFUL),
                    _ => None,
                }
            }

            /// The name of this preset; `other` where single switches differ.
            pub fn name(&self) -> &'static str {
                if *self == Self::CORRECT {
                    "correct"
                } else if *self == Self::FAITHFUL {
                    "faithful"
                } else {
                    "other"
                }
            }

            /// Sets the switch of that name. Returns false when there is none.
            pub fn set(&mut self, name: &str, keep: bool) -> bool {
                match name {
                    $(stringify!($name) => self.$name = keep,)+
                    _ => return false,
                }
                true
            }
        }
    };
}

errata! {
    /// The upload call of the client sends one word too many, which the device then takes for a
    /// command opcode.
    upload_one_extra,
    /// The back-face test looks at the coordinates before the perspective divide.
    backface_before_divide,
    /// The ambient reflectance product is stored in the render state after the pipe's copy was
    /// taken: the primitive uses the raw intensity and the state decays.
    ambient_decays,
    /// Depths are compared as unsigned words, so the nearer half of the range fails.
    unsigned_depth,
    /// The near test lets vertices with negative w pass.
    behind_eye_passes,
    /// The singular-w test truncates w to an integer, so every |w| below 1 counts as singular.
    integer_w_test,
    /// Mirror wrap is wrong for coordinates at or below -1, and 1.0 indexes past the edge.
    mirror_wrap,
    /// Clamping v uses the width of the texture.
    clamp_v_by_width,
    /// When the sequence number rolls over, the flush comes one primitive early and the number
    /// for unordered primitives is not reset.
    rollover_keeps_lagged,
    /// The ordering rule overlooks soft colour alpha in the decal modes, colour that is transparent
    /// at every corner in the blend mode, where the texture shows through, and alpha mode 3, which
    /// acts as 1.
    ordering_ignores_decals,
    /// Mirroring model matrices flip normals, and a zero normal divides by zero.
    normals_flip,
    /// Repeat wrap of a tiny negative coordinate gives 1.0, which indexes past the edge.
    repeat_to_one,
    /// A bounding box left of or above the screen is moved instead of skipped.
    box_clamp_moves,
    /// A pixel centre exactly on the lower bound of the box is left out.
    box_skips_exact_centre,
    /// Texel indices truncate towards zero instead of rounding down.
    texel_truncates,
    /// Bilinear mirroring blends an edge texel with its inner neighbour instead of itself.
    bilinear_mirror_inner,
    /// Colour bytes are masked instead of clamped, and a negative intensity saturates to full.
    channels_wrap,
    /// Depth 1.0 overflows to the nearest value, and nothing beyond the far plane is dropped.
    depth_overflows,
    /// A zero count in the middle of a command hangs the device.
    zero_count_hangs,
    /// Texture memory of N words is accounted as N bytes: three quarters cannot be used.
    texture_bytes_as_words,
    /// Block transfers discard what they write and read zeros; compaction does nothing.
    blocks_do_nothing,
    /// A texture that is uploaded again, or replaced after a reset, stays as it was in the caches of
    /// the stage-3 tiles.
    uploads_stay_cached,
    /// At the start of a scene the other stage-1 tiles are not told of state changes.
    scene_start_hides_state,
    /// The colour calls for lights mask their channels with 0x0f.
    light_colors_masked,
    /// The camera axes are not unit length, because they are scaled while being measured.
    camera_axes_scaled,
    /// The single tile reads "use directional" from "lit" and "interpolate light" from
    /// "use directional".
    single_tile_mode_mixup,
}

impl Default for Errata {
    fn default() -> Self {
        Self::CORRECT
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_sets_its_switch() {
        let mut errata = Errata::CORRECT;
        for name in Errata::NAMES {
            assert!(errata.set(name, true), "{name}");
        }
        assert_eq!(errata, Errata::FAITHFUL);
        assert!(!errata.set("no_such_error", true));
    }
}
