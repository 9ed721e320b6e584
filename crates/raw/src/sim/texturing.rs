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

/// Who does what for a fragment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Share {
    /// Stage 2 divides it, stage 3 textures it.
    Own,
    /// Stage 3 divides and textures it.
    Undivided,
    /// The stage-2 tile that made it textures it.
    Above,
    /// The stage-4 tile that draws it textures it.
    Below,
}

/// Parts that the fragments of a primitive are divided into.
const PARTS: u32 = 32;

/// What asking for a bank and waiting for it costs a fragment, as measured.
const LOAN: u32 = 36;

/// How the fragments of a primitive are shared out, decided from its state and the cost table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Division {
    /// Parts for [`Share::Undivided`], [`Share::Above`] and [`Share::Below`].
    parts: [u32; 3],
    /// What has gathered for each, in parts of a fragment.
    due: [u32; 3],
    /// Stage 1 walks the edges.
    pub walked: bool,
}

impl Division {
    /// The division that keeps stages 2, 3 and 4 equally busy, as far as the table knows. Of equal
    /// ones, that with the least sharing.
    pub fn of(costs: &Costs, options: &Options, info: &PrimInfo) -> Self {
        let walks = [false, true].into_iter().filter(|walked| !walked || options.walk_in_stage1);
        let each = walks.map(|walked| {
            let load = Load::of(costs, options, info, walked);
            let best = Self::shares(options, info)
                .min_by_key(|p| (load.greatest(p), p.iter().sum::<u32>()));
            let parts = best.unwrap_or_default();
            (load.greatest(&parts), Self { parts, due: [0; 3], walked })
        });
        each.min_by_key(|(load, _)| *load).map_or_else(Self::default, |(_, division)| division)
    }

    /// All that can be chosen from.
    fn shares(options: &Options, info: &PrimInfo) -> impl Iterator<Item = [u32; 3]> + use<> {
        let most = if options.shared_texturing { PARTS } else { 0 };
        // Stage 4 as a pipeline draws fragments of all columns, and textures none.
        let most_below = if options.uses_pipes() { 0 } else { most };
        let perspective = Interpolants::of(info.mode).perspective();
        let most_undivided = if perspective { most } else { 0 };
        (0..=most_undivided).flat_map(move |undivided| {
            // Stage 2 has no time for the one while it is spared the other.
            let most_above = if undivided > 0 { 0 } else { most };
            (0..=most_above).flat_map(move |above| {
                let rest = most - undivided - above;
                (0..=most_below.min(rest)).map(move |below| [undivided, above, below])
            })
        })
    }

    /// Who does what for the next fragment.
    pub fn next(&mut self) -> Share {
        for (due, part) in self.due.iter_mut().zip(self.parts) {
            *due += part;
        }
        let shares = [Share::Undivided, Share::Above, Share::Below];
        match self.due.iter().position(|due| *due >= PARTS) {
            Some(i) => {
                self.due[i] -= PARTS;
                shares[i]
            }
            None => Share::Own,
        }
    }
}

/// The cycles of all bursts that some work charges.
fn cycles(work: impl FnOnce(&mut dyn FnMut(Burst))) -> u32 {
    let mut cycles = 0;
    work(&mut |burst| cycles += burst.cycles);
    cycles
}

/// Cycles of a fragment in each stage without sharing, and of what can be shared.
struct Load {
    stages: [u32; 3],
    texturing: u32,
    /// Passing a fragment on through stage 3.
    passing: u32,
    dividing: u32,
    /// What the further words of an undivided fragment cost stage 2, and stage 3.
    words: [u32; 2],
}

impl Load {
    fn of(costs: &Costs, options: &Options, info: &PrimInfo, walked: bool) -> Self {
        let (mode, needs) = (info.mode, Interpolants::of(info.mode));
        let looked_up = Textured {
            fragment: Fragment::default(),
            looked_up: mode.uses_texture(),
            addresses: [None; MAX_TEXELS],
        };
        let texturing = cycles(|add| charges::combine(costs, info, &looked_up, add));
        let dividing = cycles(|add| charges::divide(costs, needs, add));
        let (words_in, words_out) =
            (options.fragment_words(needs, true), options.pixel_words(mode, true));
        let send = 1 + costs.s2.send_word.cycles;
        let visit = costs.s2.visit.share(options.visit_parts(needs, walked), 15).cycles;
        let cover = cycles(|add| charges::cover(costs, needs, add));
        let above = visit + cover + dividing + send * words_in;
        let transfer = |words: u32| {
            let parts = options.transfer_parts(words, words_out);
            costs.s3.transfer.share(parts, 13).cycles + words + words_out
        };
        let own = transfer(words_in) + options.switch_counts();
        let more = options.undivided_words(needs, true);
        let s4 = &costs.s4;
        let mut below = s4.buffer.cycles + s4.pixel.cycles + words_out;
        if mode.no_use_z() == 0 {
            // A line is eight depths, of which a burst meets about four.
            let fetched = if options.z_once_per_burst { s4.z_miss / 4 } else { s4.z_miss };
            below += s4.z_test.cycles + fetched;
        }
        below += if mode.no_write_z() == 0 { s4.z_write.cycles } else { 0 };
        below += if options.banked { LOAN } else { 0 };
        if mode.out_of_order() == 0 && !options.blend_in_controller {
            // Ordered fragments are those that blend.
            below += s4.blend.cycles + s4.round_trip;
        }
        let passed = words_in.max(words_out);
        Self {
            stages: [above, own, below],
            texturing,
            passing: options.pass(costs, passed).cycles + words_in + words_out,
            dividing,
            words: [send * (more - words_in), transfer(more) - transfer(words_in)],
        }
    }

    /// The load of the busiest stage, in parts of a fragment.
    fn greatest(&self, [undivided, above, below]: &[u32; 3]) -> u32 {
        let [s2, s3, s4] = self.stages;
        let [sent, received] = self.words;
        let own = PARTS - above - below;
        let loads = [
            PARTS * s2 + above * self.texturing + undivided * sent - undivided * self.dividing,
            own * (s3 + self.texturing)
                + (above + below) * self.passing
                + undivided * (received + self.dividing),
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
        let load = Load::of(&COSTS, &options, &info, false);
        assert!(load.greatest(&division.parts) < load.greatest(&[0; 3]) * 4 / 5);
        let shares: Vec<Share> = (0..320).map(|_| division.next()).collect();
        let count = |share| shares.iter().filter(|s| **s == share).count() as u32;
        let [_, above, below] = division.parts;
        assert!(count(Share::Above).abs_diff(10 * above) <= 1);
        assert!(count(Share::Below).abs_diff(10 * below) <= 1);
        assert!(count(Share::Own) > 0 && count(Share::Below) > 0);
    }

    #[test]
    fn the_busiest_stage_is_relieved() {
        let mut info = PrimInfo::default();
        info.mode.set_out_of_order(1);
        info.mode.set_col_interp(1);
        let division = Division::of(&COSTS, &Options::improved(4), &info);
        assert!(division.walked && division.parts[0] > 0, "{division:?}");
        info.mode.set_col_interp(0);
        let flat = Division::of(&COSTS, &Options::improved(4), &info);
        assert!(!flat.walked && flat.parts[0] == 0, "{flat:?}");
    }

    #[test]
    fn pixel_pipelines_texture_nothing() {
        let options =
            Options { shared_texturing: true, pixel_pipeline: true, ..Options::default() };
        assert_eq!(Division::of(&COSTS, &options, &textured()).parts[2], 0);
    }
}
