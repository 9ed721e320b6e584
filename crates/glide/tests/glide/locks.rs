//! What locks of the frame buffer mean for the rest of the state, and regions.

use fillrate_engine::state::AuxWrite;
use fillrate_glide::{Call, Context};

use super::{draw, opened, pixel};

const WRITE: i32 = 1;
const BACK: i32 = 1;

fn lock(glide: &mut Context) {
    glide.lfb_lock(WRITE, BACK, 0, 0, false).expect("a lock");
}

fn unlock(glide: &mut Context) {
    let unlock = Call::GrLfbUnlock { kind: WRITE, buffer: BACK, written: None };
    assert_eq!(glide.execute(&unlock), 1);
}

/// Depth bias and constant of the state in force.
fn depth_bias(glide: &mut Context) -> Option<i16> {
    glide.draw_state().expect("the board is open").0.depth.bias
}

/// The colour format of writes is one thing, that of colours in calls another.
#[test]
fn the_format_of_writes_leaves_other_colors_alone() {
    let mut glide = opened("voodoo-4mb", 0);
    glide.execute(&Call::GrLfbWriteColorFormat { format: 1 });
    glide.execute(&Call::GrBufferClear { color: 0x00ff_0000, alpha: 0, depth: 0 });
    assert_eq!(pixel(&mut glide, BACK, 3, 3), 0xf800, "the clear has the open board's format");
    let write = |glide: &mut Context| {
        let (data, x, y, format) = (vec![0, 0xf8].into(), 3, 3, 0);
        let (width, height, stride) = (1, 1, 2);
        let write =
            Call::GrLfbWriteRegion { buffer: BACK, x, y, format, width, height, stride, data };
        assert_eq!(glide.execute(&write), 1);
        pixel(glide, BACK, 3, 3)
    };
    assert_eq!(write(&mut glide), 0x001f, "the write has its own");
    // It is part of a saved state.
    let state = glide.state().expect("the board is open").to_vec();
    glide.execute(&Call::GrLfbWriteColorFormat { format: 0 });
    assert_eq!(write(&mut glide), 0xf800);
    glide.execute(&Call::GrGlideSetState { state: state.into() });
    assert_eq!(write(&mut glide), 0x001f);
    // The format that a board is opened with is that of colours in calls.
    let mut glide = opened("voodoo-4mb", 1);
    assert_eq!(write(&mut glide), 0xf800);
    glide.execute(&Call::GrBufferClear { color: 0x00ff_0000, alpha: 0, depth: 0 });
    assert_eq!(pixel(&mut glide, BACK, 3, 3), 0x001f);
}

/// A lock's constants and missing bias end with it; what calls set during the
/// lock stays.
#[test]
fn state_set_during_a_lock_outlives_it() {
    let mut glide = opened("voodoo-4mb", 0);
    glide.execute(&Call::GrDepthBufferMode { mode: 1 });
    glide.execute(&Call::GrDepthBiasLevel { level: -5 });
    lock(&mut glide);
    assert_eq!(depth_bias(&mut glide), None);
    unlock(&mut glide);
    assert_eq!(depth_bias(&mut glide), Some(-5));
    lock(&mut glide);
    glide.execute(&Call::GrDepthBiasLevel { level: 9 });
    unlock(&mut glide);
    assert_eq!(depth_bias(&mut glide), Some(9));
    glide.execute(&Call::GrDepthBufferMode { mode: 0 });
    lock(&mut glide);
    glide.execute(&Call::GrDepthBufferMode { mode: 2 });
    unlock(&mut glide);
    assert_eq!(depth_bias(&mut glide), Some(9));
}

/// A state saved during a lock is the one without it, and one that is restored
/// during a lock is there afterwards.
#[test]
fn states_saved_and_restored_during_a_lock() {
    let mut glide = opened("voodoo-4mb", 0);
    glide.execute(&Call::GrDepthBufferMode { mode: 1 });
    glide.execute(&Call::GrDepthBiasLevel { level: 31 });
    lock(&mut glide);
    let saved = glide.state().expect("the board is open").to_vec();
    glide.execute(&Call::GrDisableAllEffects {});
    unlock(&mut glide);
    assert_eq!(depth_bias(&mut glide), None);
    lock(&mut glide);
    glide.execute(&Call::GrGlideSetState { state: saved.into() });
    unlock(&mut glide);
    assert_eq!(depth_bias(&mut glide), Some(31));
    // The mark in the corner saves and restores by itself.
    glide.execute(&Call::GrGlideShamelessPlug { on: 1 });
    lock(&mut glide);
    glide.execute(&Call::GrBufferSwap { interval: 0 });
    assert_eq!(depth_bias(&mut glide), None);
    unlock(&mut glide);
    assert_eq!(depth_bias(&mut glide), Some(31));
}

/// Interleaved boards refuse read locks; regions read both halves.
#[test]
fn regions_of_interleaved_boards_can_be_read() {
    let mut glide = opened("voodoo-sli-8mb", 0);
    draw(&mut glide, |v| v.g = 255.0);
    assert!(glide.lfb_lock(0, BACK, 0, 0, false).is_none());
    let rows = glide.lfb_read_region(BACK, (10, 10), (2, 2)).expect("a region");
    assert_eq!(rows, [0x07e0; 4]);
}

/// Alpha planes stay on when depth is buffered as well, as on the board.
#[test]
fn alpha_planes_and_depth_can_be_on_together() {
    let mut glide = opened("voodoo-4mb", 0);
    glide.execute(&Call::GrColorMask { rgb: 1, alpha: 1 });
    glide.execute(&Call::GrDepthBufferMode { mode: 1 });
    let (state, _) = glide.draw_state().expect("the board is open");
    assert_eq!(state.aux_write, AuxWrite::Alpha);
}
