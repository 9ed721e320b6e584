//! Stage 3's work on fragments, on whichever tile does it.
//!
//! In the thesis that is the tile of row 2. Where it is shared (RAW, chapter 6: "stage 2 taking
//! part of stage 3's work or the reverse"), the tiles above and below texture some fragments, each
//! with a cache of its own, from the memory of row 2.

use std::rc::Rc;

use super::cache::Cache;
use super::charges;
use super::cost::{Burst, Costs};
use super::machine::Machine;
use super::options::Options;
use crate::stage::combine::Textured;
use crate::stage::raster::Interpolants;
use crate::stage::sample::MAX_TEXELS;
use crate::stage::{Fragment, UntexFragment, combine};
use crate::state::PrimInfo;
use crate::texture::TextureManager;

/// The row whose memory holds textures.
const TEXTURE_ROW: usize = 2;

/// What a tile remembers that textures fragments.
pub struct Texturing {
    m: Rc<Machine>,
    row: usize,
    column: usize,
    info: PrimInfo,
    cache: Cache,
    /// The texture table is read again after a flush.
    table_stale: bool,
    /// The version of each texture that the cache holds texels of.
    versions: Vec<u64>,
    /// Texels as the cache holds them, where re-uploads do not reach it.
    cached: Option<Box<TextureManager>>,
}

impl Texturing {
    /// For the tile of a row and a column.
    pub fn new(m: &Rc<Machine>, row: usize, column: usize) -> Self {
        let (entries, cached) = {
            let core = m.core.borrow();
            let stale = core.config.errata.uploads_stay_cached;
            (core.config.texture_entries, stale.then(|| Box::new(core.textures.clone())))
        };
        Self {
            m: Rc::clone(m),
            row,
            column,
            info: PrimInfo::default(),
            cache: Cache::default(),
            table_stale: true,
            versions: vec![0; entries],
            cached,
        }
    }

    /// Textures may change: the table is read again before it is used.
    pub fn forget_table(&mut self) {
        self.table_stale = true;
    }

    /// The state of the primitive that fragments belong to.
    pub fn info(&self) -> &PrimInfo {
        &self.info
    }

    /// A primitive begins: its entry of the texture table is looked at.
    pub fn begin(&mut self, info: PrimInfo) {
        self.info = info;
        if !info.mode.uses_texture() {
            return;
        }
        if std::mem::take(&mut self.table_stale) {
            self.fetch();
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

    /// Fetches a line of texture memory; from another row it is a hop farther each way.
    fn fetch(&self) {
        let hops = 2 * self.row.abs_diff(TEXTURE_ROW) as u32;
        let tile = self.m.tile(self.row, self.column);
        self.m.fetch_line(tile, TEXTURE_ROW, self.m.costs.miss + hops);
    }

    /// Gives a fragment its texture, colour and light.
    pub fn finish(&mut self, fragment: &UntexFragment) -> Fragment {
        let m = Rc::clone(&self.m);
        let tile = m.tile(self.row, self.column);
        let textured = {
            let core = m.core.borrow();
            combine::process(&core.textures, &self.info, fragment, &core.config.errata)
        };
        charges::combine(&m.costs, &self.info, &textured, |burst| m.work(tile, burst));
        for address in textured.addresses.iter().flatten() {
            if self.cache.touch(*address as u64) {
                self.fetch();
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
        textured.fragment
    }
}

/// Who textures a fragment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Share {
    /// The stage-2 tile that made it.
    Above,
    /// The stage-3 tile.
    Own,
    /// The stage-4 tile that draws it.
    Below,
}

/// Parts that the fragments of a primitive are divided into.
const PARTS: u32 = 32;

/// What asking for a bank and waiting for it costs a fragment, as measured.
const LOAN: u32 = 30;

/// How the fragments of a primitive are shared out, decided from its state and the cost table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Division {
    above: u32,
    below: u32,
    /// What has gathered for each, in parts of a fragment.
    due: [u32; 2],
}

impl Division {
    /// The division that keeps stages 2, 3 and 4 equally busy, as far as the table knows.
    pub fn of(costs: &Costs, options: &Options, info: &PrimInfo) -> Self {
        if !options.shared_texturing {
            return Self::default();
        }
        let load = Load::of(costs, options, info);
        // Stage 4 as a pipeline draws fragments of all columns, and textures none.
        let most_below = if options.uses_pipes() { 0 } else { PARTS };
        let all = (0..=PARTS).flat_map(|above| {
            let below = 0..=most_below.min(PARTS - above);
            below.map(move |below| Self { above, below, due: [0; 2] })
        });
        all.min_by_key(|d| (load.greatest(d), d.above + d.below)).unwrap_or_default()
    }

    /// Who textures the next fragment.
    pub fn next(&mut self) -> Share {
        self.due[0] += self.above;
        self.due[1] += self.below;
        let [above, below] = &mut self.due;
        if *above >= PARTS {
            *above -= PARTS;
            Share::Above
        } else if *below >= PARTS {
            *below -= PARTS;
            Share::Below
        } else {
            Share::Own
        }
    }
}

/// Cycles of a fragment in each stage without sharing, of texturing it, and of passing it on.
struct Load {
    stages: [u32; 3],
    texturing: u32,
    passing: u32,
}

impl Load {
    fn of(costs: &Costs, options: &Options, info: &PrimInfo) -> Self {
        let (mode, needs) = (info.mode, Interpolants::of(info.mode));
        let mut texturing = 0;
        let looked_up = Textured {
            fragment: Fragment::default(),
            looked_up: mode.uses_texture(),
            addresses: [None; MAX_TEXELS],
        };
        charges::combine(costs, info, &looked_up, |burst| texturing += burst.cycles);
        let (words_in, words_out) =
            (options.fragment_words(needs, true), options.pixel_words(mode, true));
        let words = words_in + words_out;
        let mut above = costs.s2.visit.share(options.visit_parts(needs), 15).cycles;
        charges::cover(costs, needs, |burst| above += burst.cycles);
        above += (1 + costs.s2.send_word.cycles) * words_in;
        let transfer = costs.s3.transfer.share(options.transfer_parts(words_in, words_out), 13);
        let own = transfer.cycles + words + options.switch_counts();
        let s4 = &costs.s4;
        let mut below = s4.buffer.cycles + s4.pixel.cycles + words_out;
        if mode.no_use_z() == 0 {
            // Eight depths are a line.
            let fetched = if options.z_once_per_burst { s4.z_miss / 4 } else { s4.z_miss };
            below += s4.z_test.cycles + fetched;
        }
        below += if mode.no_write_z() == 0 { s4.z_write.cycles } else { 0 };
        below += if options.banked { LOAN } else { 0 };
        if mode.out_of_order() == 0 && !options.blend_in_controller {
            // Ordered fragments are those that blend.
            below += s4.blend.cycles + s4.round_trip;
        }
        let passing = options.pass(costs, words_in.max(words_out)).cycles + words;
        Self { stages: [above, own, below], texturing, passing }
    }

    /// The load of the busiest stage, in parts of a fragment.
    fn greatest(&self, division: &Division) -> u32 {
        let Division { above, below, .. } = *division;
        let [s2, s3, s4] = self.stages;
        let own = PARTS - above - below;
        let loads = [
            PARTS * s2 + above * self.texturing,
            own * (s3 + self.texturing) + (above + below) * self.passing,
            PARTS * s4 + below * self.texturing,
        ];
        loads.into_iter().max().unwrap_or(0)
    }
}

impl Options {
    /// A fragment of so many words that stage 3 hands on as it is.
    pub(super) fn pass(&self, costs: &Costs, words: u32) -> Burst {
        costs.s2.send_word.times(words)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sim::cost::COSTS;
    use crate::state::texmode;

    fn textured() -> PrimInfo {
        let mut info = PrimInfo::default();
        info.mode.set_texmode(texmode::BLEND);
        info.mode.set_tex_interp(1);
        info.mode.set_lit(1);
        info.mode.set_use_dir(1);
        info.mode.set_out_of_order(1);
        info
    }

    #[test]
    fn nothing_is_shared_in_the_thesis() {
        let mut division = Division::of(&COSTS, &Options::default(), &textured());
        assert!((0..100).all(|_| division.next() == Share::Own));
    }

    #[test]
    fn sharing_evens_the_stages_out() {
        let options = Options { shared_texturing: true, ..Options::default() };
        let info = textured();
        let mut division = Division::of(&COSTS, &options, &info);
        let load = Load::of(&COSTS, &options, &info);
        assert!(load.greatest(&division) < load.greatest(&Division::default()) * 4 / 5);
        let shares: Vec<Share> = (0..320).map(|_| division.next()).collect();
        let count = |share| shares.iter().filter(|s| **s == share).count() as u32;
        assert_eq!(count(Share::Above), 10 * division.above);
        assert!(count(Share::Below).abs_diff(10 * division.below) <= 1);
        assert!(count(Share::Own) > 0 && count(Share::Below) > 0);
    }

    #[test]
    fn pixel_pipelines_texture_nothing() {
        let options =
            Options { shared_texturing: true, pixel_pipeline: true, ..Options::default() };
        assert_eq!(Division::of(&COSTS, &options, &textured()).below, 0);
    }
}
