//! Random sequences of calls while other threads draw.

use std::collections::HashMap;
use std::sync::atomic::{AtomicU64, Ordering};

use super::*;

/// What the images of a sequence tell of themselves.
#[derive(Debug, Default)]
struct Watch {
    /// Images there are.
    alive: AtomicU64,
    /// Polygons drawn.
    drawn: AtomicU64,
}

/// An image that knows whether it may go.
#[derive(Debug)]
struct Image {
    version: u64,
    /// Polygons that are submitted and not drawn.
    pending: AtomicU64,
    watch: Arc<Watch>,
}

impl Image {
    fn new(version: u64, watch: &Arc<Watch>) -> Arc<Image> {
        watch.alive.fetch_add(1, Ordering::Relaxed);
        Arc::new(Image { version, pending: AtomicU64::new(0), watch: watch.clone() })
    }
}

impl Drop for Image {
    fn drop(&mut self) {
        self.watch.alive.fetch_sub(1, Ordering::Relaxed);
        if !std::thread::panicking() {
            assert_eq!(self.pending.load(Ordering::SeqCst), 0, "freed before its last use");
        }
    }
}

struct Program {
    memory: TextureMemory<Image>,
    watch: Arc<Watch>,
    /// What each texture looks like to polygons submitted now.
    looks: Arc<Mutex<HashMap<ResourceId, u64>>>,
    owned: Vec<(ResourceId, std::sync::Weak<Image>)>,
    random: Random,
    submitted: u64,
    versions: u64,
    deleted: u64,
}

impl Program {
    fn image(&mut self) -> Arc<Image> {
        self.versions += 1;
        Image::new(self.versions, &self.watch)
    }

    fn create(&mut self) {
        let image = self.image();
        let (version, weak) = (image.version, Arc::downgrade(&image));
        let (bytes, locked) = (1 << self.random.below(6), self.random.below(10) == 0);
        if let Ok(id) = self.memory.create(image, bytes, locked) {
            self.looks.lock().expect("not poisoned").insert(id, version);
            self.owned.push((id, weak));
        } else {
            let state = self.memory.shared.lock();
            let is_too_large = bytes > state.config.video_bytes;
            assert!(is_too_large || state.deferred == 0 || !state.is_busy(), "gave up too early");
        }
    }

    fn submit(&mut self) {
        let picks = 1 + self.random.below(2);
        let mut ids = Vec::new();
        let polygons = 1 + self.random.below(5);
        for _ in 0..picks.min(self.owned.len() as u64) {
            let (id, image) = &self.owned[self.random.below(self.owned.len() as u64) as usize];
            let image = image.upgrade().expect("owned images are there");
            image.pending.fetch_add(polygons, Ordering::SeqCst);
            ids.push(*id);
        }
        self.submitted += polygons * ids.len() as u64;
        assert_eq!(self.memory.submit(&ids, polygons), Ok(()));
    }

    fn delete(&mut self) {
        if self.owned.is_empty() {
            return;
        }
        let at = self.random.below(self.owned.len() as u64) as usize;
        let (id, _) = self.owned.swap_remove(at);
        assert_eq!(self.memory.delete(id), Ok(()));
        self.deleted += 1;
    }

    fn replace(&mut self) {
        if self.owned.is_empty() {
            return;
        }
        let at = self.random.below(self.owned.len() as u64) as usize;
        let image = self.image();
        let version = image.version;
        let id = self.owned[at].0;
        self.owned[at].1 = Arc::downgrade(&image);
        assert_eq!(self.memory.replace(id, image), Ok(()));
        self.looks.lock().expect("not poisoned").insert(id, version);
    }

    fn step(&mut self) {
        match self.random.below(20) {
            0..=4 => self.create(),
            5..=11 => self.submit(),
            12..=14 => self.delete(),
            15 => self.replace(),
            16 => {
                if let Some((id, _)) = self.owned.first() {
                    let id = *id;
                    assert_ne!(self.memory.detach(id), Err(MemoryError::Unknown));
                }
            }
            17 => {
                self.memory.sync();
                assert_eq!(self.watch.drawn.load(Ordering::SeqCst), self.submitted);
            }
            18 => {
                assert!(self.memory.free_bytes() <= self.memory.config().video_bytes);
            }
            _ => {
                self.memory.end_frame();
                self.memory.start_frame();
            }
        }
        check(&self.memory.shared.lock());
    }
}

/// Draws until the memory is closed; what it draws with is what was submitted.
fn renderer(
    memory: &TextureMemory<Image>,
    looks: &Mutex<HashMap<ResourceId, u64>>,
    watch: &Watch,
    seed: u64,
) {
    let mut random = Random::new(seed);
    while let Some(work) = memory.wait_for_work() {
        for (id, image) in work.resources().iter().zip(work.texels()) {
            let expected = looks.lock().expect("not poisoned")[id];
            assert_eq!(image.version, expected, "other texels than at submission");
        }
        if random.below(3) == 0 {
            std::thread::yield_now();
        }
        let polygons = work.polygons();
        for image in work.texels() {
            image.pending.fetch_sub(polygons, Ordering::SeqCst);
        }
        watch.drawn.fetch_add(polygons * work.texels().len() as u64, Ordering::SeqCst);
        memory.retire(work);
    }
}

fn sequence(seed: u64) -> Statistics {
    let mut random = Random::new(seed);
    let config = MemoryConfig {
        kind: any_kind(&mut random),
        video_bytes: 16 + random.below(100),
        host_bytes: 16 + random.below(100),
        drawing: Drawing::Threads,
    };
    let memory = TextureMemory::new(config);
    let (watch, looks) = (Arc::new(Watch::default()), Arc::new(Mutex::new(HashMap::new())));
    std::thread::scope(|scope| {
        for number in 0..1 + random.below(3) {
            let (memory, looks, watch) = (&memory, &looks, &watch);
            scope.spawn(move || renderer(memory, looks, watch, seed ^ number << 32));
        }
        let mut program = Program {
            memory: memory.clone(),
            watch: watch.clone(),
            looks: looks.clone(),
            owned: Vec::new(),
            random,
            submitted: 0,
            versions: 0,
            deleted: 0,
        };
        // Whatever fails, the renderers must not wait for ever.
        let _closes = Closes(&memory);
        (0..40).for_each(|_| program.step());
        memory.end_frame();
        memory.sync();
        let statistics = memory.statistics();
        assert_eq!(statistics.freed, program.deleted, "each deleted texture is freed once");
        let alive = watch.alive.load(Ordering::SeqCst);
        assert_eq!(alive, program.owned.len() as u64, "what is not deleted is there");
    });
    memory.statistics()
}

struct Closes<'a>(&'a TextureMemory<Image>);

impl Drop for Closes<'_> {
    fn drop(&mut self) {
        self.0.close();
    }
}

/// `FILLRATE_CASES` sets the number of sequences.
#[test]
fn random_sequences_while_others_draw() {
    let mut total = Statistics::default();
    for seed in 1..=cases(1500) {
        let one = sequence(seed);
        total.loads += one.loads;
        total.waits += one.waits;
        total.evictions += one.evictions;
        total.freed += one.freed;
    }
    println!("{total:?}");
    assert!(total.waits > 0 && total.evictions > 0 && total.freed > 0, "every rule was met");
}
