//! The program of a stage-3 tile: fragments get their texture, colour and light.

use std::rc::Rc;

use super::boot;
use super::charges;
use super::cost::Burst;
use super::machine::{FragMessage, Machine, PixelMessage, Wait};
use super::pipe::STEPS;
use super::texturing::Texturing;
use crate::stage::raster::Interpolants;
use crate::stage::{Fragment, UntexFragment};

/// What a stage-3 tile remembers.
struct Stage3 {
    m: Rc<Machine>,
    column: usize,
    texturing: Texturing,
    last: Option<(u32, u32)>,
}

/// Runs a stage-3 tile for good.
pub async fn run(m: Rc<Machine>, column: usize) {
    boot::tile(&m, 2, column).await;
    let above = m.tile_number(1, column);
    let texturing = Texturing::new(&m, 2, column);
    let mut tile = Stage3 { m: Rc::clone(&m), column, texturing, last: None };
    loop {
        let message = m.receive(m.tile(2, column), &m.frags[column], Wait::Words(above)).await;
        match message {
            FragMessage::Flush(from) => {
                tile.texturing.forget_table();
                tile.send_all(|| PixelMessage::Flush(from), 2).await;
            }
            FragMessage::Prim(info, ticket) => {
                tile.last = None;
                tile.texturing.begin(info);
                let words = m.options.pixel_info_words(info.mode);
                tile.send_all(|| PixelMessage::Prim(info, ticket), words).await;
            }
            FragMessage::Frag(fragment) => tile.texture(&fragment, false).await,
            FragMessage::Undivided(fragment) => tile.texture(&fragment, true).await,
            FragMessage::Done(fragment) => tile.pass_done(fragment).await,
            FragMessage::Later(fragment) => tile.pass_later(fragment).await,
            FragMessage::End => tile.send_all(|| PixelMessage::End, 1).await,
        }
    }
}

impl Stage3 {
    /// Sends a message that every pixel pipeline must see, or the one tile below.
    async fn send_all(&self, message: impl Fn() -> PixelMessage, words: u32) {
        let pipes = self.m.lanes.len() / self.m.columns;
        for pipe in 0..pipes {
            self.send(Some(pipe), message(), words).await;
        }
        if pipes == 0 {
            self.send(None, message(), words).await;
        }
    }

    /// Sends a message, after the counts the switch of this row takes; the switch lets words in
    /// again when it has passed these on.
    async fn send(&self, pipe: Option<usize>, message: PixelMessage, words: u32) {
        let (m, column) = (&self.m, self.column);
        let tile = m.tile(2, column);
        m.work(tile, Burst::new(m.options.switch_counts(), 100));
        let (link, to) = match pipe {
            Some(pipe) => (&m.lanes[pipe * m.columns + column], STEPS * pipe),
            None => (&m.pixels[column], column),
        };
        m.send(tile, link, m.tile_number(3, to), message, words).await;
        m.frags[column].hold_until(tile.clock.get() + u64::from(m.costs.switch_turn));
    }

    /// Whether a fragment is right of the one before it.
    fn follows(&mut self, x: u32, y: u32) -> bool {
        self.last.replace((x, y)) == Some((x.wrapping_sub(1), y))
    }

    async fn texture(&mut self, fragment: &UntexFragment, undivided: bool) {
        let m = Rc::clone(&self.m);
        let follows = self.follows(fragment.x, fragment.y);
        let mode = self.texturing.info().mode;
        let (tile, needs) = (m.tile(2, self.column), Interpolants::of(mode));
        let words_in = match undivided {
            true => m.options.undivided_words(needs, follows),
            false => m.options.fragment_words(needs, follows),
        };
        let words = m.options.pixel_words(mode, follows);
        let parts = m.options.transfer_parts(words_in, words);
        m.work(tile, m.costs.s3.transfer.share(parts, 13));
        if undivided {
            charges::divide(&m.costs, needs, |burst| m.work(tile, burst));
        }
        let fragment = self.texturing.finish(fragment);
        self.send_pixel(fragment, words).await;
    }

    async fn send_pixel(&self, fragment: Fragment, words: u32) {
        let pipe = (!self.m.lanes.is_empty()).then(|| self.m.bank_of(&fragment));
        self.send(pipe, PixelMessage::Frag(fragment), words).await;
    }

    /// Passes on what stage 2 has textured.
    async fn pass_done(&mut self, fragment: Fragment) {
        let follows = self.follows(fragment.x, fragment.y);
        let words = self.m.options.pixel_words(self.texturing.info().mode, follows);
        self.m.work(self.m.tile(2, self.column), self.m.options.pass(&self.m.costs, words));
        self.send_pixel(fragment, words).await;
    }

    /// Passes on what stage 4 will texture.
    async fn pass_later(&mut self, fragment: UntexFragment) {
        let follows = self.follows(fragment.x, fragment.y);
        let needs = Interpolants::of(self.texturing.info().mode);
        let words = self.m.options.fragment_words(needs, follows);
        self.m.work(self.m.tile(2, self.column), self.m.options.pass(&self.m.costs, words));
        self.send(None, PixelMessage::Later(fragment), words).await;
    }
}
