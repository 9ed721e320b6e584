use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

/// A program's number for a texture.
pub type TextureId = u32;

/// One thing to draw in a frame, as far as textures go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Draw {
    /// What it is drawn with.
    pub texture: Option<TextureId>,
    /// Blended with what is behind it: drawn after all that is not, in the order
    /// given.
    pub blended: bool,
}

/// Textures that are loaded together, and what is drawn with them.
///
/// Wait until the batch before is drawn (`QASync`), delete `evict`, load `load`,
/// draw `draws`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Batch {
    /// Leave memory.
    pub evict: Vec<TextureId>,
    /// Enter memory.
    pub load: Vec<TextureId>,
    /// Indices of draws, sorted by texture where they are not blended.
    pub draws: Vec<usize>,
}

/// A frame in batches.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Plan {
    /// In the order in which they are drawn.
    pub batches: Vec<Batch>,
    /// Textures that can never be loaded: larger than the memory, or of unknown
    /// size. Their draws are in the batches; draw them in one colour.
    pub unloadable: Vec<TextureId>,
}

impl Plan {
    /// The number of texture loads of the frame.
    pub fn loads(&self) -> usize {
        self.batches.iter().map(|batch| batch.load.len()).sum()
    }
}

/// Draws in a row that share a texture.
struct Run {
    texture: Option<TextureId>,
    draws: Vec<usize>,
}

/// Sorts a frame's draws by texture and says which textures to load when, for
/// an engine with `budget` bytes of texture memory.
///
/// `sizes` has the bytes of each texture, `resident` what is in memory, the
/// least recently used first. Each texture that the opaque draws need is loaded
/// at most once, and not at all if it is resident and stays; so are those of
/// blended draws if they all fit together. Otherwise the one needed last makes
/// room: with equal sizes there are never more loads than in the order given. What the frame does not need stays as long as there is room.
///
/// Source: TN, preflighting texture allocation.
pub fn plan_frame(
    draws: &[Draw],
    sizes: &BTreeMap<TextureId, u64>,
    resident: &[TextureId],
    budget: u64,
) -> Plan {
    let fits = |texture: &TextureId| sizes.get(texture).is_some_and(|&bytes| bytes <= budget);
    let needed: BTreeSet<TextureId> = draws.iter().filter_map(|draw| draw.texture).collect();
    let unloadable = needed.into_iter().filter(|texture| !fits(texture)).collect();
    let runs = sort_runs(draws, resident, fits);
    let mut uses: BTreeMap<TextureId, Vec<usize>> = BTreeMap::new();
    for (index, run) in runs.iter().enumerate() {
        if let Some(texture) = run.texture {
            uses.entry(texture).or_default().push(index);
        }
    }
    let mut memory = Memory::new(sizes, uses, budget);
    let mut batch = Batch::default();
    for (age, &texture) in resident.iter().enumerate() {
        memory.adopt(texture, age);
    }
    memory.shrink_to_budget(&mut batch);
    let batches = fill_batches(&runs, memory, batch, resident.len());
    Plan { batches, unloadable }
}

/// Opaque draws by texture: those without, those resident, the others; of each,
/// textures that blended draws need again come last, the first needed at the very
/// end, to stay in memory for them. Then the blended draws in order.
fn sort_runs(
    draws: &[Draw],
    resident: &[TextureId],
    fits: impl Fn(&TextureId) -> bool,
) -> Vec<Run> {
    let resident: BTreeSet<TextureId> = resident.iter().copied().collect();
    let texture_of = |draw: &Draw| draw.texture.filter(&fits);
    let mut first_blended: BTreeMap<TextureId, usize> = BTreeMap::new();
    for (index, draw) in draws.iter().enumerate().filter(|(_, draw)| draw.blended) {
        if let Some(texture) = texture_of(draw) {
            first_blended.entry(texture).or_insert(index);
        }
    }
    let needed_again =
        |texture: &TextureId| Reverse(first_blended.get(texture).copied().unwrap_or(NEVER));
    let mut opaque: BTreeMap<_, Vec<usize>> = BTreeMap::new();
    let mut ordered: Vec<Run> = Vec::new();
    for (index, draw) in draws.iter().enumerate() {
        let texture = texture_of(draw);
        if !draw.blended {
            let rank = texture.map(|id| (!resident.contains(&id), needed_again(&id), id));
            opaque.entry(rank).or_default().push(index);
        } else if let Some(run) = ordered.last_mut().filter(|run| run.texture == texture) {
            run.draws.push(index);
        } else {
            ordered.push(Run { texture, draws: vec![index] });
        }
    }
    opaque
        .into_iter()
        .map(|(rank, draws)| Run { texture: rank.map(|(_, _, id)| id), draws })
        .chain(ordered)
        .collect()
}

/// When a texture is next used ([`NEVER`] again in this frame), how long ago it
/// was last, and which it is. The greatest leaves memory first.
type Key = (usize, Reverse<usize>, TextureId);

const NEVER: usize = usize::MAX;

/// Texture memory while a frame is planned.
struct Memory<'a> {
    sizes: &'a BTreeMap<TextureId, u64>,
    uses: BTreeMap<TextureId, Vec<usize>>,
    budget: u128,
    used: u128,
    /// The part of `used` that the rest of the frame does not need.
    idle: u128,
    keys: BTreeMap<TextureId, Key>,
    queue: BTreeSet<Key>,
}

impl<'a> Memory<'a> {
    fn new(
        sizes: &'a BTreeMap<TextureId, u64>,
        uses: BTreeMap<TextureId, Vec<usize>>,
        budget: u64,
    ) -> Self {
        let (keys, queue) = (BTreeMap::new(), BTreeSet::new());
        Self { sizes, uses, budget: budget.into(), used: 0, idle: 0, keys, queue }
    }

    fn size(&self, texture: TextureId) -> u128 {
        self.sizes.get(&texture).map_or(0, |&bytes| u128::from(bytes))
    }

    /// The first use of a texture in run `from` or later.
    fn next_use(&self, texture: TextureId, from: usize) -> usize {
        let uses = self.uses.get(&texture).map_or(&[][..], Vec::as_slice);
        uses.get(uses.partition_point(|&run| run < from)).copied().unwrap_or(NEVER)
    }

    fn insert(&mut self, key: Key) {
        let bytes = self.size(key.2);
        self.used += bytes;
        self.idle += if key.0 == NEVER { bytes } else { 0 };
        self.keys.insert(key.2, key);
        self.queue.insert(key);
    }

    fn remove(&mut self, texture: TextureId) {
        let Some(key) = self.keys.remove(&texture) else { return };
        let bytes = self.size(texture);
        self.queue.remove(&key);
        self.used -= bytes;
        self.idle -= if key.0 == NEVER { bytes } else { 0 };
    }

    /// Takes a resident texture over; a second mention makes it younger.
    fn adopt(&mut self, texture: TextureId, age: usize) {
        self.remove(texture);
        self.insert((self.next_use(texture, 0), Reverse(age), texture));
    }

    fn evict_last(&mut self, batch: &mut Batch) -> bool {
        let Some(&(_, _, texture)) = self.queue.last() else { return false };
        self.remove(texture);
        batch.evict.push(texture);
        true
    }

    fn shrink_to_budget(&mut self, batch: &mut Batch) {
        while self.used > self.budget && self.evict_last(batch) {}
    }

    /// Loads a texture for run `run`. Only if `must` is set do textures go that
    /// the frame needs again. Returns whether it is in memory.
    fn load(&mut self, texture: TextureId, run: usize, must: bool, batch: &mut Batch) -> bool {
        if self.keys.contains_key(&texture) {
            return true;
        }
        let bytes = self.size(texture);
        let room = self.budget - self.used;
        if bytes > room + self.idle && !must {
            return false;
        }
        while bytes > self.budget - self.used && self.evict_last(batch) {}
        self.insert((run, Reverse(0), texture));
        batch.load.push(texture);
        true
    }

    /// Notes that run `run` has been drawn.
    fn drawn(&mut self, texture: TextureId, run: usize, age: usize) {
        self.remove(texture);
        self.insert((self.next_use(texture, run + 1), Reverse(age), texture));
    }
}

/// Each batch loads, in the order of the runs, what fits without sending away
/// anything still needed, and draws the runs that this completes.
fn fill_batches(runs: &[Run], mut memory: Memory<'_>, first: Batch, ages: usize) -> Vec<Batch> {
    let mut batches = Vec::new();
    let mut batch = first;
    let mut start = 0;
    while start < runs.len() {
        let mut end = start;
        while let Some(run) = runs.get(end) {
            let loaded =
                run.texture.is_none_or(|id| memory.load(id, end, end == start, &mut batch));
            if !loaded {
                break;
            }
            end += 1;
        }
        for (index, run) in runs.iter().enumerate().take(end).skip(start) {
            batch.draws.extend_from_slice(&run.draws);
            if let Some(texture) = run.texture {
                memory.drawn(texture, index, ages + index);
            }
        }
        batches.push(std::mem::take(&mut batch));
        start = end;
    }
    if batch != Batch::default() {
        batches.push(batch);
    }
    batches
}
