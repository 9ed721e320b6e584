//! The program of a stage-3 tile: fragments get their texture, colour and light.

use std::rc::Rc;

use super::boot;
use super::cache::Cache;
use super::charges;
use super::cost::Burst;
use super::machine::{FragMessage, Machine, PixelMessage, Wait};
use super::pipe::STEPS;
use crate::stage::raster::Interpolants;
use crate::stage::{UntexFragment, combine};
use crate::state::PrimInfo;
use crate::texture::TextureManager;

/// What a stage-3 tile remembers.
struct Stage3 {
    m: Rc<Machine>,
    column: usize,
    info: PrimInfo,
    cache: Cache,
    /// The texture table is read again after a flush.
    table_stale: bool,
    /// The version of each texture that the cache holds texels of.
    versions: Vec<u64>,
    /// Texels as the cache holds them, where re-uploads do not reach it.
    cached: Option<Box<TextureManager>>,
    last: Option<(u32, u32)>,
}

/// Runs a stage-3 tile for good.
pub async fn run(m: Rc<Machine>, column: usize) {
    boot::tile(&m, 2, column).await;
    let above = m.tile_number(1, column);
    let (entries, cached) = {
        let core = m.core.borrow();
        let stale = core.config.errata.uploads_stay_cached;
        (core.config.texture_entries, stale.then(|| Box::new(core.textures.clone())))
    };
    let mut tile = Stage3 {
        m: Rc::clone(&m),
        column,
        info: PrimInfo::default(),
        cache: Cache::default(),
        table_stale: true,
        versions: vec![0; entries],
        cached,
        last: None,
    };
    loop {
        let message = m.receive(m.tile(2, column), &m.frags[column], Wait::Words(above)).await;
        match message {
            FragMessage::Flush(from) => {
                tile.table_stale = true;
                tile.send_all(|| PixelMessage::Flush(from), 2).await;
            }
            FragMessage::Prim(info, ticket) => {
                tile.begin(info);
                tile.send_all(|| PixelMessage::Prim(info.mode, ticket), 3).await;
            }
            FragMessage::Frag(fragment) => tile.texture(&fragment).await,
            FragMessage::End => tile.send_all(|| PixelMessage::End, 1).await,
        }
    }
}

impl Stage3 {
    /// A primitive begins: its entry of the texture table is looked at.
    fn begin(&mut self, info: PrimInfo) {
        self.info = info;
        self.last = None;
        if !info.mode.uses_texture() {
            return;
        }
        if std::mem::take(&mut self.table_stale) {
            self.m.fetch_line(self.m.tile(2, self.column), 2, self.m.costs.miss);
        }
        let core = self.m.core.borrow();
        let id = info.texture_id as usize;
        let (version, words) = core.textures.version(info.texture_id);
        if let Some(seen) = self.versions.get_mut(id).filter(|seen| **seen != version) {
            *seen = version;
            self.cache.drop_words(words);
        }
        if let Some(cached) = &mut self.cached {
            cached.adopt_table(&core.textures);
        }
    }

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

    async fn texture(&mut self, fragment: &UntexFragment) {
        let m = Rc::clone(&self.m);
        let tile = m.tile(2, self.column);
        let follows = self.last.replace((fragment.x, fragment.y))
            == Some((fragment.x.wrapping_sub(1), fragment.y));
        let textured = {
            let core = m.core.borrow();
            combine::process(&core.textures, &self.info, fragment, &core.config.errata)
        };
        let mode = self.info.mode;
        let words_in = m.options.fragment_words(Interpolants::of(mode), follows);
        let words = m.options.pixel_words(mode, follows);
        m.work(tile, m.costs.s3.transfer.share(m.options.transfer_parts(words_in, words), 13));
        charges::combine(&m.costs, &self.info, &textured, |burst| m.work(tile, burst));
        for address in textured.addresses.iter().flatten() {
            if self.cache.touch(*address as u64) {
                m.fetch_line(tile, 2, m.costs.miss);
                if let Some(cached) = &mut self.cached {
                    cached.copy_line(&m.core.borrow().textures, *address);
                }
            }
        }
        let textured = match &self.cached {
            Some(cached) => {
                combine::process(cached, &self.info, fragment, &m.core.borrow().config.errata)
            }
            None => textured,
        };
        m.count(|c| {
            c.tex_frags += 1;
            c.texels += u64::from(textured.looked_up);
        });
        let pipe = (!m.lanes.is_empty()).then(|| m.bank_of(&textured.fragment));
        self.send(pipe, PixelMessage::Frag(textured.fragment), words).await;
    }
}
