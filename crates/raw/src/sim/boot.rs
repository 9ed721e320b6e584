//! Start-up: the first tile of each row tells the others where its memory is.
//!
//! Source: RAW, boot sequence: tile 0 hands out the render state, then asks the first tiles of rows
//! 2 and 3 in turn to do the same with textures and depths. Row 1 needs no message.

use super::cost::Burst;
use super::machine::{Machine, Wait};
use crate::state::STATE_WORDS;

/// An acknowledgement, or a request to begin.
const GO: u32 = 0;
/// A pointer; what it points to is shared memory of the model.
const POINTER: u32 = 0x1000;
/// Words of an entry of the texture table.
const ENTRY_WORDS: u32 = 6;

/// Boots the tile of a stage, 0..=3, in a column; returns when it may work.
pub async fn tile(m: &Machine, stage: usize, column: usize) {
    if stage == 1 {
        return;
    }
    if column > 0 {
        follow(m, stage, column).await;
        return;
    }
    m.work(m.tile(stage, 0), preparation(m, stage));
    if stage > 0 {
        m.letter(stage, 0, Wait::Message((0, 0))).await;
    }
    hand_out(m, stage).await;
    if stage == 0 {
        for row in [2, 3] {
            m.post(m.tile(0, 0).clock.get(), (0, 0), (row, 0), GO);
            m.letter(0, 0, Wait::Message((row, 0))).await;
        }
    } else {
        m.post(m.tile(stage, 0).clock.get(), (stage, 0), (0, 0), POINTER);
    }
}

/// What the first tile of a row prepares before anybody asks: state, texture table or depths,
/// written and flushed.
fn preparation(m: &Machine, stage: usize) -> Burst {
    let core = m.core.borrow();
    let words = match stage {
        0 => STATE_WORDS as u32,
        2 => core.config.texture_entries as u32 * ENTRY_WORDS,
        _ => core.target.depth.depths().len() as u32,
    };
    m.costs.s1.invalidate_word.times(words)
}

/// Sends the pointer along the row and waits for everybody.
async fn hand_out(m: &Machine, stage: usize) {
    for column in 1..m.columns {
        m.post(m.tile(stage, 0).clock.get(), (stage, 0), (stage, column), POINTER);
    }
    for _ in 1..m.columns {
        m.letter(stage, 0, Wait::Message((stage, 1))).await;
    }
}

/// The other tiles of a row: take the pointer, drop what the cache holds there, acknowledge.
async fn follow(m: &Machine, stage: usize, column: usize) {
    m.letter(stage, column, Wait::Message((stage, 0))).await;
    let tile = m.tile(stage, column);
    m.work(tile, m.costs.s1.invalidate_word);
    m.post(tile.clock.get(), (stage, column), (stage, 0), GO);
}
