//! The manager against a naive model, and under threads that draw.

mod naive;
mod sequences;
mod threads;

use std::sync::Arc;

use super::state::State;
use super::*;

fn config(kind: EngineKind, video_bytes: u64) -> MemoryConfig {
    MemoryConfig { kind, video_bytes, ..MemoryConfig::default() }
}

/// Every kind; the one that evicts twice as often.
fn any_kind(random: &mut Random) -> EngineKind {
    [
        EngineKind::Separate,
        EngineKind::Separate,
        EngineKind::VideoOnly,
        EngineKind::VideoOnlyUntilFrameEnd,
    ][random.below(4) as usize]
}

/// How many random sequences to try.
fn cases(usual: u64) -> u64 {
    let asked = std::env::var("FILLRATE_CASES").ok().and_then(|text| text.parse().ok());
    asked.unwrap_or(usual)
}

/// Numbers that look random.
struct Random(u64);

impl Random {
    fn new(seed: u64) -> Random {
        Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    fn below(&mut self, limit: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) % limit
    }

    fn pick<T: Copy>(&mut self, from: &[T]) -> Option<T> {
        if from.is_empty() { None } else { Some(from[self.below(from.len() as u64) as usize]) }
    }
}

/// What the specification promises of every state that the program can see.
fn check<T>(state: &State<T>) {
    state.board.check();
    assert!(state.host_used <= state.config.host_bytes);
    let queued = |id| -> u64 {
        let uses = |run: &Run| run.resources.iter().filter(|&&other| other == id).count() as u64;
        state.queue.iter().chain(&state.held).map(|run| uses(run) * run.polygons).sum()
    };
    let (mut deferred, mut copies, mut blocks) = (0, 0, Vec::new());
    for (&id, resource) in &state.resources {
        let by_polygons = resource.references - u64::from(resource.is_owned);
        assert!(by_polygons >= queued(id), "queued polygons are counted");
        assert!(state.drawing > 0 || by_polygons == queued(id), "nothing else is counted");
        assert!(resource.references > 0, "what nobody needs is freed");
        if !resource.is_owned {
            deferred += 1;
            assert!(resource.is_locked && resource.address.is_some(), "deferred ones stay loaded");
        }
        if resource.is_locked || state.config.kind != EngineKind::Separate {
            assert!(resource.address.is_some(), "locked ones stay loaded");
        }
        copies += if resource.has_copy { resource.bytes } else { 0 };
        blocks.extend(resource.address.map(|address| (address, resource.bytes)));
    }
    assert_eq!((state.deferred, state.host_used), (deferred, copies));
    blocks.sort_unstable();
    assert!(state.board.blocks().eq(blocks), "the board holds what resources say");
    let used: u64 = state.board.blocks().map(|(_, bytes)| bytes).sum();
    assert!(used <= state.config.video_bytes);
}

#[test]
fn deletion_waits_for_polygons() {
    let memory = TextureMemory::new(config(EngineKind::Separate, 100));
    let id = memory.create(Arc::new(()), 60, false).expect("room");
    memory.submit(&[id], 3).expect("owned");
    memory.delete(id).expect("owned");
    assert_eq!(memory.delete(id), Err(MemoryError::Unknown));
    assert_eq!(memory.submit(&[id], 1), Err(MemoryError::Unknown));
    assert_eq!(memory.statistics().freed, 0);
    memory.sync();
    assert_eq!((memory.statistics().freed, memory.statistics().loads), (1, 1));
    check(&memory.shared.lock());
}

#[test]
fn least_recently_used_of_the_same_size_leaves_first() {
    let memory = TextureMemory::new(config(EngineKind::Separate, 100));
    let make = |bytes| memory.create(Arc::new(()), bytes, false).expect("less than the board");
    let (old_small, old, young, new) = (make(10), make(40), make(40), make(40));
    for id in [old_small, old, young, new] {
        memory.submit(&[id], 1).expect("owned");
        memory.sync();
    }
    let state = memory.shared.lock();
    let lies = |id| state.resources[&id].address.is_some();
    assert_eq!([old_small, old, young, new].map(lies), [true, false, true, true]);
}

#[test]
fn board_memory_alone_fails_at_once_or_waits() {
    let memory = TextureMemory::new(config(EngineKind::VideoOnly, 100));
    let first = memory.create(Arc::new(()), 60, false).expect("room");
    let refused = memory.create(Arc::new(()), 60, false);
    assert_eq!((refused, memory.statistics().waits), (Err(MemoryError::OutOfVideoMemory), 0));
    memory.submit(&[first], 5).expect("owned");
    assert!(memory.create(Arc::new(()), 60, false).is_err(), "queued, but not deleted");
    memory.delete(first).expect("owned");
    assert_eq!(memory.free_bytes(), 100, "asking waits for deletions");
    assert!(memory.create(Arc::new(()), 101, false).is_err());
}

#[test]
fn first_accelerator_keeps_all_of_a_frame() {
    let memory = TextureMemory::new(config(EngineKind::VideoOnlyUntilFrameEnd, 100));
    memory.start_frame();
    let first = memory.create(Arc::new(()), 60, false).expect("room");
    memory.submit(&[first], 5).expect("owned");
    memory.sync();
    memory.delete(first).expect("owned");
    assert!(memory.create(Arc::new(()), 60, false).is_err(), "nothing is freed in the frame");
    memory.end_frame();
    assert!(memory.create(Arc::new(()), 60, false).is_ok());
}

#[test]
fn locked_textures_fill_the_board() {
    let memory = TextureMemory::new(config(EngineKind::Separate, 100));
    let locked = memory.create(Arc::new(1), 90, true).expect("room");
    assert!(memory.create(Arc::new(2), 20, true).is_err());
    let other = memory.create(Arc::new(3), 20, false).expect("not loaded yet");
    memory.submit(&[other, locked], 1).expect("owned");
    let work = memory.take_work().expect("a polygon");
    assert_eq!(*work.texels()[0] + *work.texels()[1], 4);
    drop(work);
    assert_eq!((memory.statistics().host_draws, memory.free_bytes()), (1, 10));
    // Deleted while queued, it cannot be loaded: the program waits.
    memory.submit(&[other], 1).expect("owned");
    memory.delete(other).expect("owned");
    assert_eq!(memory.statistics().freed, 1);
}

#[test]
fn copies_have_a_limit_of_their_own() {
    let limit = MemoryConfig { host_bytes: 50, ..config(EngineKind::Separate, 100) };
    let memory = TextureMemory::new(limit);
    let [a, b] = [30, 30].map(|n| memory.create(Arc::new(()), n, false).expect("room"));
    assert_eq!((memory.detach(a), memory.detach(a)), (Ok(()), Ok(())));
    assert_eq!(memory.detach(b), Err(MemoryError::OutOfMemory));
    memory.submit(&[a], 1).expect("owned");
    memory.delete(a).expect("owned");
    assert_eq!((memory.detach(b), memory.statistics().waits), (Ok(()), 1));
    assert_eq!(memory.free_ordinary_bytes(), 20);
}
