//! Tests of the engine against the reference, and of the reference itself.

mod batches;
mod formats;
mod fuzz_targets;
mod glide_states;
mod golden_beyond;
mod golden_scenes;
mod random_cases;
mod set_up;
mod state_coverage;
