//! The program of a stage-2 tile: primitives in, fragments out.

use std::rc::Rc;

use super::charges;
use super::machine::{FragMessage, Machine, PrimMessage, Wait};
use super::texturing::{Division, Share, Texturing};
use super::ticket::Ticket;
use crate::stage::raster::{Interpolants, RasterWork, Rasterizer};
use crate::stage::{TransPrim, UntexFragment};
use crate::state::PrimInfo;

struct Stage2 {
    m: Rc<Machine>,
    column: usize,
    /// For the fragments that this tile textures itself.
    texturing: Texturing,
    /// Who textures which fragment of the primitive.
    division: Division,
    /// The primitive that it was decided for.
    divided: Option<PrimInfo>,
}

/// Runs a stage-2 tile for good.
pub async fn run(m: Rc<Machine>, column: usize) {
    let above = m.tile_number(0, column);
    let texturing = Texturing::new(&m, 1, column);
    let division = Division::default();
    let mut tile = Stage2 { m: Rc::clone(&m), column, texturing, division, divided: None };
    loop {
        match m.receive(m.tile(1, column), &m.prims[column], Wait::Words(above)).await {
            PrimMessage::Flush(from) => {
                tile.texturing.forget_table();
                tile.send(FragMessage::Flush(from), 2).await;
            }
            PrimMessage::Prim(parts, ticket) => tile.draw(&parts, ticket).await,
        }
    }
}

impl Stage2 {
    async fn send(&self, message: FragMessage, words: u32) {
        let (m, tile) = (&self.m, self.m.tile(1, self.column));
        m.work(tile, m.costs.s2.send_word.times(words));
        let below = m.tile_number(2, self.column);
        m.send(tile, &m.frags[self.column], below, message, words).await;
    }

    /// Draws all parts of a primitive as one primitive of the stages below.
    async fn draw(&mut self, parts: &[TransPrim], ticket: Ticket) {
        let Some(first) = parts.first() else { return };
        let m = Rc::clone(&self.m);
        let (tile, costs) = (m.tile(1, self.column), &m.costs);
        let info = first.info;
        let received = m.options.prim_words(info.mode, 43).saturating_sub(3);
        m.work(tile, costs.s2.receive_word.times(received));
        self.divide(info);
        if m.options.shared_texturing {
            self.texturing.begin(info);
        }
        let words = m.options.info_words(info.mode, 8);
        self.send(FragMessage::Prim(info, ticket), words).await;
        for part in parts.iter().filter(|part| part.info.mode.draw() == 1) {
            self.walk(part).await;
        }
        self.send(FragMessage::End, 1).await;
    }

    /// Decides who does what for the fragments of a primitive; for one like the last it is decided.
    fn divide(&mut self, info: PrimInfo) {
        if self.divided.replace(info).is_none_or(|last| !last.draws_like(&info)) {
            self.division = Division::of(&self.m.costs, &self.m.options, &info);
        }
    }

    async fn walk(&mut self, part: &TransPrim) {
        let m = Rc::clone(&self.m);
        let (tile, costs) = (m.tile(1, self.column), &m.costs);
        let config = m.core.borrow().config;
        let mut walker = Rasterizer::new(part, config.width, config.height, &config.errata);
        let needs = walker.needs();
        let walked = self.division.walked;
        let visit = m.options.visit_parts(needs, walked);
        if !m.options.setup_in_stage1 {
            charges::setup(costs, needs, |burst| m.work(tile, burst));
        }
        let mut last = None;
        while let Some(fragment) = walker.next() {
            let work = walked_here(walker.take_work(), walked);
            charges::walk(costs, work, visit, |burst| m.work(tile, burst));
            charges::cover(costs, needs, |burst| m.work(tile, burst));
            m.count(|c| c.frags += 1);
            let follows = last.replace((fragment.x, fragment.y))
                == Some((fragment.x.wrapping_sub(1), fragment.y));
            self.hand_on(fragment, needs, follows).await;
        }
        let work = walked_here(walker.take_work(), walked);
        charges::walk(costs, work, visit, |burst| m.work(tile, burst));
    }

    /// Sends a fragment to be textured, or textures it first.
    async fn hand_on(&mut self, fragment: UntexFragment, needs: Interpolants, follows: bool) {
        let words = self.m.options.fragment_words(needs, follows);
        let share = self.division.next();
        if share != Share::Undivided {
            let tile = self.m.tile(1, self.column);
            charges::divide(&self.m.costs, needs, |burst| self.m.work(tile, burst));
        }
        match share {
            Share::Undivided => {
                let words = self.m.options.undivided_words(needs, follows);
                self.send(FragMessage::Undivided(fragment), words).await;
            }
            Share::Own => self.send(FragMessage::Frag(fragment), words).await,
            Share::Below => self.send(FragMessage::Later(fragment), words).await,
            Share::Above => {
                let done = self.texturing.finish(&fragment);
                let words = self.m.options.pixel_words(self.texturing.info().mode, follows);
                self.send(FragMessage::Done(done), words).await;
            }
        }
    }
}

/// What stage 2 walks: covered pixels only, where stage 1 has walked the edges.
fn walked_here(work: RasterWork, walked: bool) -> RasterWork {
    if walked { RasterWork { visited: work.covered, ..work } } else { work }
}
