//! Random sequences of calls, drawn by the caller: the same results, the same
//! addresses, the same counts as the naive model.

use super::naive::Naive;
use super::*;

struct Both {
    real: TextureMemory<u64>,
    naive: Naive,
    /// What the program owns, with the model's names.
    owned: Vec<(ResourceId, u64)>,
    random: Random,
    names: u64,
}

impl Both {
    fn new(seed: u64) -> Both {
        let mut random = Random::new(seed);
        let config = MemoryConfig {
            kind: any_kind(&mut random),
            video_bytes: 8 + random.below(56),
            host_bytes: 8 + random.below(100),
            drawing: Drawing::Caller,
        };
        let (real, naive) = (TextureMemory::new(config), Naive::new(config));
        Both { real, naive, owned: Vec::new(), random, names: 0 }
    }

    fn step(&mut self) {
        let owned = self.random.pick(&self.owned);
        match (self.random.below(20), owned) {
            (0..=4, _) | (_, None) => self.create(),
            (5..=10, _) => self.submit(),
            (11..=13, Some((id, name))) => {
                self.owned.retain(|&(other, _)| other != id);
                assert_eq!(self.real.delete(id), Ok(()));
                self.naive.delete(name);
                assert_eq!(self.real.delete(id), Err(MemoryError::Unknown));
            }
            (14, Some((id, name))) => assert_eq!(self.real.detach(id), self.naive.detach(name)),
            (15, Some((id, name))) => {
                assert_eq!(self.real.replace(id, Arc::new(name)), Ok(()));
                self.naive.replace(name);
            }
            (16, _) => {
                self.real.sync();
                self.naive.sync();
            }
            (17, _) => assert_eq!(self.real.free_bytes(), self.naive.free_bytes()),
            (18, _) => {
                self.real.start_frame();
                self.naive.start_frame();
            }
            _ => {
                self.real.end_frame();
                self.naive.end_frame();
            }
        }
    }

    fn create(&mut self) {
        self.names += 1;
        let (name, locked) = (self.names, self.random.below(8) == 0);
        let bytes = match self.random.below(3) {
            0 => 1 + self.random.below(20),
            _ => 1 << self.random.below(6),
        };
        let made = self.real.create(Arc::new(name), bytes, locked);
        assert_eq!(made.map(|_| ()), self.naive.create(name, bytes, locked));
        self.owned.extend(made.ok().map(|id| (id, name)));
    }

    fn submit(&mut self) {
        let count = 1 + self.random.below(3).saturating_sub(1);
        let drawn: Vec<_> = (0..count).filter_map(|_| self.random.pick(&self.owned)).collect();
        let polygons = 1 + self.random.below(4);
        let ids: Vec<_> = drawn.iter().map(|&(id, _)| id).collect();
        assert_eq!(self.real.submit(&ids, polygons), Ok(()));
        let names: Vec<_> = drawn.iter().map(|&(_, name)| name).collect();
        if !names.is_empty() {
            (0..polygons).for_each(|_| self.naive.queue.push(names.clone()));
        }
    }

    fn compare(&self) {
        let state = self.real.shared.lock();
        check(&state);
        let statistics = state.statistics;
        assert_eq!(statistics.loads, self.naive.loads);
        assert_eq!(statistics.evictions, self.naive.evictions);
        assert_eq!(statistics.freed, self.naive.freed);
        assert_eq!((state.deferred, state.host_used), (self.naive.deferred(), self.naive.copies()));
        let queued: u64 = state.queue.iter().map(|run| run.polygons).sum();
        assert_eq!(queued as usize, self.naive.queue.len());
        let mut cells = vec![None; self.naive.cells.len()];
        for (start, bytes) in state.board.blocks() {
            let name = **state.board.read(start).expect("a block");
            cells[start as usize..(start + bytes) as usize].fill(Some(name));
        }
        assert_eq!(cells, self.naive.cells);
    }
}

/// `FILLRATE_CASES` sets the number of sequences.
#[test]
fn random_sequences_do_what_the_model_does() {
    let (mut loads, mut evictions, mut waits, mut spilled) = (0, 0, 0, 0);
    for seed in 1..=cases(3000) {
        let mut both = Both::new(seed);
        for _ in 0..60 {
            both.step();
            both.compare();
        }
        let statistics = both.real.statistics();
        loads += statistics.loads;
        evictions += statistics.evictions;
        waits += statistics.waits;
        spilled += statistics.host_draws;
    }
    println!("{loads} loads, {evictions} evictions, {waits} waits, {spilled} drawn from the host");
    assert!(loads > 0 && evictions > 0 && waits > 0 && spilled > 0, "every rule was met");
}
