use std::collections::{BTreeMap, BTreeSet};

use crate::{Draw, TextureId};

/// An engine whose texture memory is found out by trying.
pub trait FrameHost {
    /// Waits until everything submitted is drawn (`QASync`). Engines that wait
    /// themselves when a texture is deleted need nothing here.
    fn sync(&mut self);
    /// Begins the frame (`QARenderStart`).
    fn start(&mut self);
    /// Ends it (`QARenderEnd`).
    fn end(&mut self);
    /// Creates a texture in the engine (`QATextureNew`); false if it has no room.
    fn create(&mut self, texture: TextureId) -> bool;
    /// Deletes one (`QATextureDelete`); false if it cannot now.
    fn delete(&mut self, texture: TextureId) -> bool;
    /// Draws a draw of the list, with its texture or, where that could not be
    /// created or there is none, in one colour.
    fn draw(&mut self, index: usize, textured: bool);
}

/// A frame in progress.
struct Frame<'a, H> {
    host: &'a mut H,
    /// Textures in the engine, the least recently used first.
    loaded: &'a mut Vec<TextureId>,
    /// Textures not loaded or drawn yet, in order, with their opaque draws.
    pending: Vec<(TextureId, Vec<usize>)>,
    /// Textures of blended draws, kept to the end of the frame.
    kept: BTreeSet<TextureId>,
    failures: u32,
}

/// Draws a frame as the technote's rendering loop does: load what fits, draw
/// all that has its texture, synchronize, delete what is done, load more.
///
/// `loaded` lists the textures in the engine, the least recently used first, and
/// is kept up to date for the next frame. Ends, also with engines that can
/// delete nothing, when everything is loaded or when no texture could be created
/// twice in a row; what has no texture then is drawn in one colour. Textures of
/// blended draws are created last and never deleted in the frame, since engines
/// draw these at its end. Returns the number of textures created.
///
/// Source: TN, preflighting texture allocation.
pub fn render_frame<H: FrameHost>(
    host: &mut H,
    draws: &[Draw],
    loaded: &mut Vec<TextureId>,
) -> usize {
    let mut frame = Frame::new(host, draws, loaded);
    frame.host.sync();
    let (mut done, mut created) = frame.load_textures();
    frame.host.start();
    draw_untextured(frame.host, draws);
    frame.render_textures();
    while !done {
        frame.host.sync();
        let (now_done, more) = frame.load_textures();
        (done, created) = (now_done, created + more);
        frame.render_textures();
    }
    frame.finish(draws);
    created
}

fn draw_untextured<H: FrameHost>(host: &mut H, draws: &[Draw]) {
    for (index, draw) in draws.iter().enumerate() {
        if !draw.blended && draw.texture.is_none() {
            host.draw(index, false);
        }
    }
}

impl<'a, H: FrameHost> Frame<'a, H> {
    fn new(host: &'a mut H, draws: &[Draw], loaded: &'a mut Vec<TextureId>) -> Self {
        let kept: BTreeSet<TextureId> =
            draws.iter().filter(|draw| draw.blended).filter_map(|draw| draw.texture).collect();
        let mut groups: BTreeMap<(bool, TextureId), Vec<usize>> = BTreeMap::new();
        for (index, draw) in draws.iter().enumerate() {
            let Some(texture) = draw.texture else { continue };
            let group = groups.entry((kept.contains(&texture), texture)).or_default();
            if !draw.blended {
                group.push(index);
            }
        }
        let pending = groups.into_iter().map(|((_, texture), draws)| (texture, draws)).collect();
        Self { host, loaded, pending, kept, failures: 0 }
    }

    /// Returns whether nothing is left to load or nothing more can be, and the
    /// number of textures created.
    fn load_textures(&mut self) -> (bool, usize) {
        let present: BTreeSet<TextureId> = self.loaded.iter().copied().collect();
        let pending: Vec<TextureId> = self.pending.iter().map(|&(texture, _)| texture).collect();
        let mut spare = self.spare_textures();
        let mut created = 0;
        for texture in pending.into_iter().filter(|texture| !present.contains(texture)) {
            while !self.host.create(texture) {
                if !self.delete_one(&mut spare) {
                    self.failures = if created == 0 { self.failures + 1 } else { 0 };
                    return (self.failures >= 2, created);
                }
            }
            self.loaded.push(texture);
            created += 1;
        }
        (true, created)
    }

    /// Loaded textures that the rest of the frame does not need, the least
    /// recently used last.
    fn spare_textures(&self) -> Vec<TextureId> {
        let pending: BTreeSet<TextureId> = self.pending.iter().map(|&(id, _)| id).collect();
        let is_spare = |id: &TextureId| !pending.contains(id) && !self.kept.contains(id);
        self.loaded.iter().rev().copied().filter(is_spare).collect()
    }

    fn delete_one(&mut self, spare: &mut Vec<TextureId>) -> bool {
        while let Some(texture) = spare.pop() {
            if self.host.delete(texture) {
                self.loaded.retain(|&id| id != texture);
                return true;
            }
        }
        false
    }

    /// Draws everything opaque whose texture is loaded, and makes that texture
    /// the most recently used.
    fn render_textures(&mut self) {
        let present: BTreeSet<TextureId> = self.loaded.iter().copied().collect();
        let all = std::mem::take(&mut self.pending);
        let (ready, waiting): (Vec<_>, Vec<_>) =
            all.into_iter().partition(|(texture, _)| present.contains(texture));
        self.pending = waiting;
        let used: BTreeSet<TextureId> = ready.iter().map(|&(texture, _)| texture).collect();
        self.loaded.retain(|texture| !used.contains(texture));
        self.loaded.extend(ready.iter().map(|&(texture, _)| texture));
        for index in ready.iter().flat_map(|(_, draws)| draws) {
            self.host.draw(*index, true);
        }
    }

    /// What has no texture, then what is blended.
    fn finish(self, draws: &[Draw]) {
        for index in self.pending.iter().flat_map(|(_, draws)| draws) {
            self.host.draw(*index, false);
        }
        let present: BTreeSet<TextureId> = self.loaded.iter().copied().collect();
        for (index, draw) in draws.iter().enumerate().filter(|(_, draw)| draw.blended) {
            let textured = draw.texture.is_some_and(|texture| present.contains(&texture));
            self.host.draw(index, textured);
        }
        self.host.end();
    }
}
