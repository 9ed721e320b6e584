//! Switches of the model: the size of the grid, and what chapter 6 of the thesis would improve.

use super::pipe::STEPS;
use crate::stage::composite::Outcome;
use crate::stage::raster::Interpolants;
use crate::state::ModeBits;

macro_rules! options {
    ($($(#[$doc:meta])* $name:ident = $default:literal,)+) => {
        /// How the modelled machine differs from the one of the thesis.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub struct Options {
            /// Pipelines side by side; the thesis has four.
            pub columns: usize,
            $($(#[$doc])* pub $name: bool,)+
        }

        impl Options {
            /// The names of all switches.
            pub const NAMES: &'static [&'static str] = &[$(stringify!($name),)+];

            /// The switches that are on in the machine of the thesis.
            pub fn of_the_thesis() -> impl Iterator<Item = &'static str> {
                [$((stringify!($name), $default)),+].into_iter().filter(|s| s.1).map(|s| s.0)
            }

            /// Sets the switch of that name. Returns false when there is none.
            pub fn set(&mut self, name: &str, on: bool) -> bool {
                match name {
                    $(stringify!($name) => self.$name = on,)+
                    _ => return false,
                }
                true
            }
        }

        impl Default for Options {
            /// The machine of the thesis.
            fn default() -> Self {
                Self { columns: 4, $($name: $default,)+ }
            }
        }
    };
}

options! {
    /// Stage 1 lets the next tile start before it transforms its primitive: the late fix of the
    /// thesis. Off, it is the "unfixed" stage 1.
    early_release = true,
    /// A primitive goes to the next stage-1 tile that is ready. Off, it waits for the next one in
    /// the row: the plain round robin that the thesis improves on.
    skip_busy = true,
    /// State changes go from tile to tile instead of through memory.
    direct_state = false,
    /// Only the fields a mode needs are sent.
    minimal_messages = false,
    /// A fragment right of the one before it does not carry its coordinates.
    implicit_coordinates = false,
    /// Depths are invalidated and flushed once per burst instead of once per pixel.
    z_once_per_burst = false,
    /// Ordered primitives are buffered while they wait for their turn.
    buffer_ordered = false,
    /// Stage 2 steps only the planes a mode uses.
    lean_raster = false,
    /// Stage 1 computes edges and planes for stage 2.
    setup_in_stage1 = false,
    /// An ordered primitive waits only for those before it that it overlaps.
    overlap_test = false,
    /// Stage 4 is a pipeline of four tiles; needs four columns.
    pixel_pipeline = false,
    /// The frame buffer and the depths have a bank and a port for each column; with the pixel
    /// pipeline, for every four columns.
    banked = false,
    /// Stages 2 and 4 texture some of the fragments, or stage 3 divides some for stage 2, so that
    /// the three are equally busy.
    shared_texturing = false,
    /// Stage 1 walks the edges and sends rows of covered pixels, where that relieves the busiest
    /// stage.
    walk_in_stage1 = false,
    /// The frame-buffer controller blends: it is sent colour and alpha, and reads what is there.
    blend_in_controller = false,
}

/// Parts of testing a pixel that go with its edges: stepping three and testing them.
pub(super) const EDGE_PARTS: u32 = 7;

impl Options {
    /// The machine of the thesis with all improvements, `columns` wide.
    pub fn improved(columns: usize) -> Self {
        let mut options = Self { columns, ..Self::default() };
        // The pixel pipeline stands in for a bank for each column, which is the faster of the two.
        for name in Self::NAMES.iter().filter(|name| **name != "pixel_pipeline") {
            options.set(name, true);
        }
        options
    }

    /// Whether stage 4 is made of pixel pipelines.
    pub(super) fn uses_pipes(&self) -> bool {
        self.pixel_pipeline && self.columns >= STEPS
    }

    /// Whether stage 4 keeps order by what is finished, not by counting.
    pub(super) fn uses_tickets(&self) -> bool {
        self.uses_pipes() || self.banked || self.overlap_test
    }

    /// Banks of the frame buffer and the depths.
    pub(super) fn banks(&self) -> usize {
        match (self.banked, self.uses_pipes()) {
            (false, _) => 1,
            (true, false) => self.columns,
            (true, true) => self.columns / STEPS,
        }
    }

    /// Of fifteen parts of testing a pixel, those that are needed: four for the test and one for
    /// each plane stepped. `walked` says that stage 1 has walked the edges.
    pub(super) fn visit_parts(&self, needs: Interpolants, walked: bool) -> u32 {
        let lanes = needs.planes() - u32::from(needs.z);
        let all = if self.lean_raster { (EDGE_PARTS + lanes).min(15) } else { 15 };
        // Without edges the count of the row's pixels is left to be tested.
        if walked { all - EDGE_PARTS + 1 } else { all }
    }

    /// Words of the state at the beginning of a primitive from stage 3 to 4: tag, mode and number,
    /// and all of it where stage 4 textures.
    pub(super) fn pixel_info_words(&self, mode: ModeBits) -> u32 {
        if self.shared_texturing && !self.uses_pipes() { self.info_words(mode, 8) } else { 3 }
    }

    /// Of thirteen words of a fragment into and out of stage 3, those that are sent.
    pub(super) fn transfer_parts(&self, words_in: u32, words_out: u32) -> u32 {
        if self.minimal_messages { (words_in + words_out).min(13) } else { 13 }
    }

    /// Words of a primitive from stage 1 to 2; `full` without savings.
    pub(super) fn prim_words(&self, mode: ModeBits, full: u32) -> u32 {
        if !self.minimal_messages {
            return full;
        }
        // Header, tag, mode and number, then position and 1/w, and what the mode interpolates.
        let needs = Interpolants::of(mode);
        let color = if mode.uses_color() { 4 } else { 0 };
        let uv = if needs.uv { 2 } else { 0 };
        4 + 3 * (4 + color + uv + u32::from(mode.uses_intensity())) + self.info_words(mode, 8)
    }

    /// Words of the primitive's state; `full` without savings.
    pub(super) fn info_words(&self, mode: ModeBits, full: u32) -> u32 {
        if !self.minimal_messages {
            return full;
        }
        3 + u32::from(mode.uses_texture()) + 2 * mode.lit()
    }

    /// Words of a fragment from stage 2 to 3: tag, place, depth, texture, colour, intensity.
    pub(super) fn fragment_words(&self, needs: Interpolants, follows: bool) -> u32 {
        let place = if self.implicit_coordinates && follows { 0 } else { 2 };
        // What the thesis does not have is sent only where it is used.
        let beyond = 2 * (u32::from(needs.footprint) + u32::from(needs.more));
        if !self.minimal_messages {
            return 6 + place + beyond;
        }
        1 + place
            + beyond
            + u32::from(needs.z)
            + 2 * u32::from(needs.uv)
            + u32::from(needs.color)
            + u32::from(needs.intensity)
    }

    /// Words of a fragment from stage 2 to 3 whose values are not divided: 1/w comes along, and
    /// channels take a word each.
    pub(super) fn undivided_words(&self, needs: Interpolants, follows: bool) -> u32 {
        let channels = 2 * u32::from(needs.color) + u32::from(needs.alpha);
        self.fragment_words(needs, follows) + channels + 1
    }

    /// Words of a fragment from stage 3 to 4: tag, place, depth, colour.
    pub(super) fn pixel_words(&self, mode: ModeBits, follows: bool) -> u32 {
        let place = if self.implicit_coordinates && follows { 0 } else { 2 };
        let depth = if self.minimal_messages && !mode.touches_z() { 0 } else { 1 };
        2 + place + depth
    }

    /// Pixels that a stage-4 tile reads and blends for a fragment.
    pub(super) fn read_by_tile(&self, outcome: &Outcome) -> u32 {
        if self.blend_in_controller { 0 } else { outcome.page_reads }
    }

    /// Words stage 3 spends on telling its switch how much to route.
    pub(super) fn switch_counts(&self) -> u32 {
        if self.minimal_messages { 1 } else { 2 }
    }
}
