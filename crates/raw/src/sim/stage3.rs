//! The program of a stage-3 tile: fragments get their texture, colour and light.

use std::rc::Rc;

use super::cache::Cache;
use super::charges;
use super::cost::Burst;
use super::machine::{FragMessage, Machine, PixelMessage, Wait};
use crate::stage::{UntexFragment, combine};
use crate::state::PrimInfo;

/// Runs a stage-3 tile for good.
pub async fn run(m: Rc<Machine>, column: usize) {
    let above = m.tile_number(1, column);
    let mut info = PrimInfo::default();
    let mut cache = Cache::default();
    let mut last = None;
    loop {
        let tile = m.tile(2, column);
        let message = m.receive(tile, &m.frags[column], Wait::Words(above)).await;
        match message {
            FragMessage::Flush(from) => {
                cache.invalidate();
                send(&m, column, PixelMessage::Flush(from), 2).await;
            }
            FragMessage::Prim(prim) => {
                info = prim;
                last = None;
                let message = PixelMessage::Prim(info.mode, info.seq_num);
                send(&m, column, message, 3).await;
            }
            FragMessage::Frag(fragment) => {
                let follows = last.replace((fragment.x, fragment.y))
                    == Some((fragment.x.wrapping_sub(1), fragment.y));
                texture(&m, column, &info, &fragment, follows, &mut cache).await;
            }
            FragMessage::End => send(&m, column, PixelMessage::End, 1).await,
        }
    }
}

/// Sends a message, after the two counts the switch of this row takes.
async fn send(m: &Machine, column: usize, message: PixelMessage, words: u32) {
    let tile = m.tile(2, column);
    m.work(tile, Burst::new(m.options.switch_counts(), 100));
    m.send(tile, &m.pixels[column], m.tile_number(3, column), message, words).await;
}

async fn texture(
    m: &Machine,
    column: usize,
    info: &PrimInfo,
    fragment: &UntexFragment,
    follows: bool,
    cache: &mut Cache,
) {
    let tile = m.tile(2, column);
    let textured = {
        let core = m.core.borrow();
        combine::process(&core.textures, info, fragment, &core.config.errata)
    };
    m.work(tile, m.costs.s3.transfer);
    charges::combine(&m.costs, info, &textured, |burst| m.work(tile, burst));
    for address in textured.addresses.iter().flatten() {
        if cache.touch(*address as u64) {
            m.fetch_line(tile, 2, m.costs.miss);
        }
    }
    m.count(|c| {
        c.tex_frags += 1;
        c.texels += u64::from(textured.looked_up);
    });
    let words = m.options.pixel_words(info.mode, follows);
    send(m, column, PixelMessage::Frag(textured.fragment), words).await;
}
