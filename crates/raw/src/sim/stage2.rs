//! The program of a stage-2 tile: primitives in, fragments out.

use std::rc::Rc;

use super::charges;
use super::machine::{FragMessage, Machine, PrimMessage, Wait};
use super::ticket::Ticket;
use crate::stage::TransPrim;
use crate::stage::raster::Rasterizer;

/// Runs a stage-2 tile for good.
pub async fn run(m: Rc<Machine>, column: usize) {
    let above = m.tile_number(0, column);
    loop {
        let tile = m.tile(1, column);
        match m.receive(tile, &m.prims[column], Wait::Words(above)).await {
            PrimMessage::Flush(from) => send(&m, column, FragMessage::Flush(from), 2).await,
            PrimMessage::Prim(parts, ticket) => draw(&m, column, &parts, ticket).await,
        }
    }
}

async fn send(m: &Machine, column: usize, message: FragMessage, words: u32) {
    let tile = m.tile(1, column);
    m.work(tile, m.costs.s2.send_word.times(words));
    m.send(tile, &m.frags[column], m.tile_number(2, column), message, words).await;
}

/// Draws all parts of a primitive as one primitive of the stages below.
async fn draw(m: &Machine, column: usize, parts: &[TransPrim], ticket: Ticket) {
    let Some(first) = parts.first() else { return };
    let (tile, costs) = (m.tile(1, column), &m.costs);
    let mode = first.info.mode;
    let received = m.options.prim_words(mode, 43).saturating_sub(3);
    m.work(tile, costs.s2.receive_word.times(received));
    send(m, column, FragMessage::Prim(first.info, ticket), m.options.info_words(mode, 8)).await;
    for part in parts.iter().filter(|part| part.info.mode.draw() == 1) {
        walk(m, column, part).await;
    }
    send(m, column, FragMessage::End, 1).await;
}

async fn walk(m: &Machine, column: usize, part: &TransPrim) {
    let (tile, costs) = (m.tile(1, column), &m.costs);
    let config = m.core.borrow().config;
    let mut walker = Rasterizer::new(part, config.width, config.height, &config.errata);
    let needs = walker.needs();
    let visit = m.options.visit_parts(needs);
    if !m.options.setup_in_stage1 {
        charges::setup(costs, needs, |burst| m.work(tile, burst));
    }
    let mut last = None;
    while let Some(fragment) = walker.next() {
        charges::walk(costs, walker.take_work(), visit, |burst| m.work(tile, burst));
        charges::cover(costs, needs, |burst| m.work(tile, burst));
        m.count(|c| c.frags += 1);
        let follows = last.replace((fragment.x, fragment.y))
            == Some((fragment.x.wrapping_sub(1), fragment.y));
        let words = m.options.fragment_words(needs, follows);
        send(m, column, FragMessage::Frag(fragment), words).await;
    }
    charges::walk(costs, walker.take_work(), visit, |burst| m.work(tile, burst));
}
