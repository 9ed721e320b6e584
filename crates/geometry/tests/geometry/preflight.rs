//! Texture loads of a frame: known answers, and plans replayed in a naive memory.

use std::collections::{BTreeMap, BTreeSet};

use fillrate_geometry::{Draw, FrameHost, Plan, TextureId, plan_frame, render_frame};

use crate::support::{Random, cases};

fn opaque(texture: TextureId) -> Draw {
    Draw { texture: Some(texture), blended: false }
}

fn blended(texture: TextureId) -> Draw {
    Draw { texture: Some(texture), blended: true }
}

fn sizes(count: u32, bytes: u64) -> BTreeMap<TextureId, u64> {
    (0..count).map(|texture| (texture, bytes)).collect()
}

/// What a frame does that draws in the order given, blended draws last, and sends
/// the least recently used texture away.
fn loads_in_order(draws: &[Draw], sizes: &BTreeMap<TextureId, u64>, budget: u64) -> usize {
    let (mut memory, mut loads) = (Vec::new(), 0);
    let (last, first): (Vec<Draw>, Vec<Draw>) = draws.iter().partition(|draw| draw.blended);
    for texture in first.iter().chain(&last).filter_map(|draw| draw.texture) {
        if memory.contains(&texture) {
            memory.retain(|&other| other != texture);
        } else {
            loads += 1;
        }
        memory.push(texture);
        while memory.iter().map(|texture| sizes[texture]).sum::<u64>() > budget {
            memory.remove(0);
        }
    }
    loads
}

/// Follows a plan; every promise is an assertion.
fn replay(
    plan: &Plan,
    draws: &[Draw],
    sizes: &BTreeMap<TextureId, u64>,
    resident: &[TextureId],
    budget: u64,
) -> BTreeMap<TextureId, usize> {
    let mut memory: BTreeSet<TextureId> = resident.iter().copied().collect();
    let (mut order, mut loads) = (Vec::new(), BTreeMap::new());
    for batch in &plan.batches {
        for texture in &batch.evict {
            assert!(memory.remove(texture), "{texture} was not in memory");
        }
        for &texture in &batch.load {
            assert!(memory.insert(texture), "{texture} was in memory");
            *loads.entry(texture).or_insert(0) += 1;
        }
        let bytes: u64 =
            memory.iter().map(|texture| sizes.get(texture).copied().unwrap_or(0)).sum();
        assert!(bytes <= budget);
        for &index in &batch.draws {
            let loaded = draws[index].texture.is_none_or(|texture| {
                memory.contains(&texture) || plan.unloadable.contains(&texture)
            });
            assert!(loaded, "draw {index} has no texture");
            order.push(index);
        }
    }
    let sorted: BTreeSet<usize> = order.iter().copied().collect();
    assert!(order.len() == draws.len() && sorted.len() == draws.len(), "each draw once");
    let tail: Vec<usize> = order.iter().copied().skip_while(|&i| !draws[i].blended).collect();
    let all: Vec<usize> = (0..draws.len()).filter(|&index| draws[index].blended).collect();
    assert_eq!(tail, all, "blended draws last, in order");
    loads
}

#[test]
fn cycling_through_too_many_textures() {
    // 100 objects, 10 textures in turn, room for 4.
    let draws: Vec<Draw> = (0..100).map(|object| opaque(object % 10)).collect();
    let sizes = sizes(10, 1000);
    assert_eq!(loads_in_order(&draws, &sizes, 4000), 100);
    let plan = plan_frame(&draws, &sizes, &[], 4000);
    let loads = replay(&plan, &draws, &sizes, &[], 4000);
    assert_eq!((plan.loads(), plan.batches.len()), (10, 3));
    assert!(loads.values().all(|&count| count == 1));
    // The next frame starts with what is there.
    let resident = [6, 7, 8, 9];
    let plan = plan_frame(&draws, &sizes, &resident, 4000);
    replay(&plan, &draws, &sizes, &resident, 4000);
    assert_eq!(plan.loads(), 6);
    // With room for all, nothing is loaded, drawn textures stay.
    let all: Vec<TextureId> = (0..10).collect();
    let plan = plan_frame(&draws, &sizes, &all, 10_000);
    assert_eq!((plan.loads(), plan.batches.len()), (0, 1));
    assert!(plan.batches[0].evict.is_empty());
}

#[test]
fn idle_textures_leave_by_age() {
    let draws = [opaque(5)];
    let plan = plan_frame(&draws, &sizes(6, 10), &[3, 1, 2], 30);
    assert_eq!(plan.batches[0].evict, [3]);
    assert_eq!(plan.batches[0].load, [5]);
}

#[test]
fn frames_without_answers() {
    assert_eq!(plan_frame(&[], &sizes(0, 0), &[], 0), Plan::default());
    let draws = [opaque(1), opaque(9), Draw { texture: None, blended: false }, blended(1)];
    let sizes = BTreeMap::from([(1, 500)]);
    let plan = plan_frame(&draws, &sizes, &[], 499);
    assert_eq!(plan.unloadable, [1, 9]);
    assert!(replay(&plan, &draws, &sizes, &[], 499).is_empty());
    let huge = BTreeMap::from([(1, u64::MAX), (2, u64::MAX), (3, u64::MAX)]);
    let plan = plan_frame(&[opaque(1), opaque(2)], &huge, &[1, 2, 3], u64::MAX);
    assert_eq!(plan.loads(), 1);
    assert_eq!(plan.batches.iter().map(|batch| batch.evict.len()).sum::<usize>(), 3);
}

#[test]
fn random_frames() {
    let mut random = Random::new(50);
    let (mut tight, mut planned, mut in_order) = (0, 0, 0);
    for case in 0..cases(3_000) {
        let count = 1 + random.below(16) as u32;
        let is_even = random.below(2) == 0;
        let mut size = || if is_even { 25 } else { 1 + random.below(50) as u64 };
        let sizes: BTreeMap<TextureId, u64> = (0..count).map(|texture| (texture, size())).collect();
        let budget = 50 + random.below(200) as u64;
        let share = [0, 1, 5][random.below(3)];
        let draws: Vec<Draw> = (0..random.below(120))
            .map(|_| Draw {
                texture: (random.below(9) != 0).then(|| random.below(count as usize) as u32),
                blended: random.below(10) < share,
            })
            .collect();
        let resident: Vec<TextureId> =
            (0..count).filter(|_| random.below(4) == 0).take(1).collect();
        let plan = plan_frame(&draws, &sizes, &resident, budget);
        let loads = replay(&plan, &draws, &sizes, &resident, budget);
        assert!(plan.unloadable.is_empty(), "{case}");
        let blended: BTreeSet<TextureId> =
            draws.iter().filter(|draw| draw.blended).filter_map(|draw| draw.texture).collect();
        let together: u64 = blended.iter().map(|texture| sizes[texture]).sum();
        if together <= budget {
            assert!(loads.values().all(|&count| count == 1), "{case}: {loads:?}");
            tight += usize::from(sizes.values().sum::<u64>() > budget);
        }
        if blended.is_empty() {
            assert!(resident.iter().all(|texture| !loads.contains_key(texture)), "{case}");
        }
        let naive = loads_in_order(&draws, &sizes, budget);
        assert!(!is_even || plan.loads() <= naive, "{case}: {} {naive}", plan.loads());
        (planned, in_order) = (planned + plan.loads(), in_order + naive);
    }
    assert!(tight > cases(3_000) / 10 && planned * 2 < in_order, "{tight} {planned} {in_order}");
}

/// An engine with room for so many textures, that may refuse to delete.
#[derive(Default)]
struct Engine {
    room: usize,
    deletes: bool,
    memory: BTreeSet<TextureId>,
    /// Drawn since the last synchronization, or blended in this frame.
    busy: BTreeSet<TextureId>,
    draws: Vec<Draw>,
    drawn: Vec<(usize, bool)>,
    syncs: usize,
    open: bool,
}

impl FrameHost for Engine {
    fn sync(&mut self) {
        self.syncs += 1;
        let draws = &self.draws;
        self.busy.retain(|&texture| draws.contains(&blended(texture)));
    }

    fn start(&mut self) {
        assert!(!std::mem::replace(&mut self.open, true));
    }

    fn end(&mut self) {
        assert!(std::mem::take(&mut self.open));
    }

    fn create(&mut self, texture: TextureId) -> bool {
        self.memory.len() < self.room && self.memory.insert(texture)
    }

    fn delete(&mut self, texture: TextureId) -> bool {
        assert!(!self.busy.contains(&texture), "{texture} is still being drawn");
        self.deletes && self.memory.remove(&texture)
    }

    fn draw(&mut self, index: usize, textured: bool) {
        assert!(self.open);
        if let (Some(texture), true) = (self.draws[index].texture, textured) {
            assert!(self.memory.contains(&texture));
            self.busy.insert(texture);
        }
        self.drawn.push((index, textured));
    }
}

#[test]
fn rendering_loop_of_the_technote() {
    let draws: Vec<Draw> = (0..100).map(|object| opaque(object % 10)).collect();
    let mut loaded = Vec::new();
    let mut engine = Engine { room: 4, deletes: true, draws: draws.clone(), ..Engine::default() };
    assert_eq!(render_frame(&mut engine, &draws, &mut loaded), 10);
    assert_eq!(engine.drawn.len(), 100);
    assert!(engine.drawn.iter().all(|&(_, textured)| textured));
    assert_eq!((engine.syncs, loaded.len()), (3, 4));
    (engine.drawn, engine.busy) = (Vec::new(), BTreeSet::new());
    assert_eq!(render_frame(&mut engine, &draws, &mut loaded), 6);
    assert_eq!(engine.drawn.len(), 100);
}

#[test]
fn rendering_loop_ends_with_any_engine() {
    let mut random = Random::new(51);
    for case in 0..cases(1_000) {
        let draws: Vec<Draw> = (0..random.below(60))
            .map(|_| Draw {
                texture: (random.below(9) != 0).then(|| random.below(12) as u32),
                blended: random.below(5) == 0,
            })
            .collect();
        let mut engine = Engine {
            room: random.below(14),
            deletes: random.below(3) != 0,
            draws: draws.clone(),
            ..Engine::default()
        };
        let mut loaded = Vec::new();
        for frame in 0..3 {
            engine.busy.clear();
            engine.drawn.clear();
            let created = render_frame(&mut engine, &draws, &mut loaded);
            assert_eq!(loaded.iter().copied().collect::<BTreeSet<_>>(), engine.memory);
            assert_eq!(loaded.len(), engine.memory.len());
            let order: Vec<usize> = engine.drawn.iter().map(|&(index, _)| index).collect();
            assert_eq!(order.iter().copied().collect::<BTreeSet<_>>().len(), draws.len(), "{case}");
            assert_eq!(order.len(), draws.len());
            let tail: Vec<usize> = order.into_iter().skip_while(|&i| !draws[i].blended).collect();
            assert!(tail.is_sorted() && tail.iter().all(|&index| draws[index].blended));
            let needed: BTreeSet<TextureId> = draws.iter().filter_map(|d| d.texture).collect();
            assert!(created <= needed.len());
            assert!(frame == 0 || engine.room < needed.len() || created == 0, "{case}");
            // Engines that delete draw all opaque draws with textures.
            let kept = draws.iter().filter(|d| d.blended).filter_map(|d| d.texture);
            let kept: BTreeSet<TextureId> = kept.collect();
            if engine.deletes && engine.room > kept.len() {
                let plain = |&&(index, textured): &&(usize, bool)| {
                    !textured && draws[index].texture.is_some()
                };
                assert_eq!(engine.drawn.iter().find(plain), None, "{case}");
            }
        }
    }
}
