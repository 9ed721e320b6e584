//! The rules of texture memory, without waiting: who is counted, loaded, evicted
//! and freed. Everything happens under one lock.

use std::collections::VecDeque;
use std::sync::Arc;

use rustc_hash::FxHashMap;

use super::heap::Heap;
use super::{EngineKind, MemoryConfig, MemoryError, ResourceId, Statistics};

/// A texture, bitmap or colour table.
#[derive(Debug)]
pub(super) struct Resource<T> {
    pub(super) bytes: u64,
    /// The program's image; the engine's copy once detached.
    pub(super) image: Arc<T>,
    /// One for the program while it owns the resource, and one for each queued
    /// polygon.
    pub(super) references: u64,
    /// The program has not deleted it.
    pub(super) is_owned: bool,
    /// Never evicted: created so, or deleted while polygons are queued.
    pub(super) is_locked: bool,
    /// Whether `image` is the engine's copy, which takes host memory.
    pub(super) has_copy: bool,
    /// Where it lies in board memory.
    pub(super) address: Option<u64>,
    last_use: u64,
    /// Runs that are being drawn with it now.
    drawing: u32,
}

/// Polygons in a row that are drawn with the same resources.
#[derive(Debug)]
pub(super) struct Run {
    pub(super) resources: Box<[ResourceId]>,
    pub(super) polygons: u64,
}

#[derive(Debug)]
pub(super) struct State<T> {
    pub(super) config: MemoryConfig,
    pub(super) board: Heap<T>,
    pub(super) resources: FxHashMap<ResourceId, Resource<T>>,
    pub(super) queue: VecDeque<Run>,
    /// Runs taken out of the queue and not retired.
    pub(super) drawing: usize,
    /// Resources deleted by the program and still referenced.
    pub(super) deferred: usize,
    /// Bytes of engine copies.
    pub(super) host_used: u64,
    /// Runs drawn in this frame whose references are kept to its end.
    pub(super) held: Vec<Run>,
    pub(super) in_frame: bool,
    pub(super) is_closed: bool,
    clock: u64,
    last_id: u64,
    pub(super) statistics: Statistics,
}

impl<T> State<T> {
    pub(super) fn new(config: MemoryConfig) -> State<T> {
        State {
            board: Heap::new(config.video_bytes),
            config,
            resources: FxHashMap::default(),
            queue: VecDeque::new(),
            drawing: 0,
            deferred: 0,
            host_used: 0,
            held: Vec::new(),
            in_frame: false,
            is_closed: false,
            clock: 0,
            last_id: 0,
            statistics: Statistics::default(),
        }
    }

    /// Whether work is queued or being drawn.
    pub(super) fn is_busy(&self) -> bool {
        !self.queue.is_empty() || self.drawing > 0
    }

    /// Whether polygons with this resource are queued or being drawn.
    pub(super) fn is_in_use(&self, id: ResourceId) -> bool {
        let is_drawn = self.resources.get(&id).is_some_and(|resource| resource.drawing > 0);
        is_drawn || self.queue.iter().any(|run| run.resources.contains(&id))
    }

    /// Whether drawing what is queued frees nothing: no deletion is deferred,
    /// and nothing is kept on the board for the moment only.
    pub(super) fn makes_no_room(&self) -> bool {
        let keeps_drawn = self.config.kind == EngineKind::Separate && self.drawing > 0;
        self.deferred == 0 && !keeps_drawn
    }

    /// A resource with one reference, the program's.
    pub(super) fn insert(&mut self, image: Arc<T>, bytes: u64, is_locked: bool) -> ResourceId {
        self.last_id += 1;
        let id = ResourceId(self.last_id);
        let resource = Resource {
            bytes,
            image,
            references: 1,
            is_owned: true,
            is_locked,
            has_copy: false,
            address: None,
            last_use: 0,
            drawing: 0,
        };
        self.resources.insert(id, resource);
        id
    }

    /// Takes a resource out whose creation failed.
    pub(super) fn forget(&mut self, id: ResourceId) {
        self.resources.remove(&id);
    }

    /// Copies a resource to board memory. With separate engine memory, unlocked
    /// resources make room. Returns whether it lies there.
    pub(super) fn load(&mut self, id: ResourceId) -> bool {
        let Some(resource) = self.resources.get(&id) else { return false };
        if resource.address.is_some() {
            return true;
        }
        let (bytes, image) = (resource.bytes, resource.image.clone());
        if self.config.kind == EngineKind::Separate {
            while !self.board.has_room(bytes) {
                let Some(victim) = self.victim(bytes) else { return false };
                self.evict(victim);
            }
        }
        let Some(address) = self.board.place(bytes, image) else { return false };
        self.statistics.loads += 1;
        self.statistics.loaded_bytes += bytes;
        self.clock += 1;
        if let Some(resource) = self.resources.get_mut(&id) {
            resource.address = Some(address);
            resource.last_use = self.clock;
        }
        true
    }

    /// What leaves board memory next: the least recently used of those about as
    /// large as `bytes` (up to twice, and not smaller), else of all. Locked
    /// resources, and those being drawn with, stay.
    fn victim(&self, bytes: u64) -> Option<ResourceId> {
        let evictable = self.resources.iter().filter(|(_, resource)| {
            resource.address.is_some() && !resource.is_locked && resource.drawing == 0
        });
        let rank = |resource: &Resource<T>| {
            let is_alike = (bytes..=bytes.saturating_mul(2)).contains(&resource.bytes);
            (!is_alike, resource.last_use)
        };
        evictable.min_by_key(|(_, resource)| rank(resource)).map(|(&id, _)| id)
    }

    fn evict(&mut self, id: ResourceId) {
        let address = self.resources.get_mut(&id).and_then(|resource| resource.address.take());
        if let Some(address) = address {
            self.board.release(address);
            self.statistics.evictions += 1;
        }
    }

    /// Whether an engine copy of so many bytes has room.
    pub(super) fn has_host_room(&self, bytes: u64) -> bool {
        self.host_used.saturating_add(bytes) <= self.config.host_bytes
    }

    /// Makes the image the engine's own.
    pub(super) fn keep_copy(&mut self, id: ResourceId) {
        let Some(resource) = self.resources.get_mut(&id) else { return };
        if !resource.has_copy {
            resource.has_copy = true;
            self.host_used += resource.bytes;
        }
    }

    /// Queues polygons that are drawn with these resources.
    ///
    /// # Errors
    /// [`MemoryError::Unknown`] where one was deleted; nothing is queued then.
    pub(super) fn submit(&mut self, ids: &[ResourceId], polygons: u64) -> Result<(), MemoryError> {
        let is_owned = |id| self.resources.get(id).is_some_and(|resource| resource.is_owned);
        if !ids.iter().all(is_owned) {
            return Err(MemoryError::Unknown);
        }
        for id in ids {
            if let Some(resource) = self.resources.get_mut(id) {
                resource.references += polygons;
            }
        }
        match self.queue.back_mut().filter(|last| *last.resources == *ids) {
            Some(last) => last.polygons += polygons,
            None => self.queue.push_back(Run { resources: ids.into(), polygons }),
        }
        Ok(())
    }

    /// Takes the next run out of the queue; its resources are loaded, and stay
    /// until it is retired. What finds no room, because locked resources fill
    /// the board, is drawn from host memory.
    pub(super) fn begin(&mut self) -> Option<(Run, Vec<Arc<T>>)> {
        let run = self.queue.pop_front()?;
        self.drawing += 1;
        let mut texels = Vec::with_capacity(run.resources.len());
        for &id in &run.resources {
            let is_loaded = self.load(id);
            self.clock += 1;
            let resource = self.resources.get_mut(&id).expect("queued resources are referenced");
            resource.drawing += 1;
            resource.last_use = self.clock;
            let on_board = resource.address.and_then(|address| self.board.read(address));
            self.statistics.host_draws += u64::from(!is_loaded);
            texels.push(on_board.unwrap_or(&resource.image).clone());
        }
        Some((run, texels))
    }

    /// Notes that a run is drawn.
    pub(super) fn retire(&mut self, run: Run) {
        self.drawing -= 1;
        for id in &run.resources {
            if let Some(resource) = self.resources.get_mut(id) {
                resource.drawing -= 1;
            }
        }
        if self.in_frame && self.config.kind == EngineKind::VideoOnlyUntilFrameEnd {
            self.held.push(run);
        } else {
            self.release(&run);
        }
    }

    /// Gives up the references of a frame's runs.
    pub(super) fn end_frame(&mut self) {
        self.in_frame = false;
        for run in std::mem::take(&mut self.held) {
            self.release(&run);
        }
    }

    fn release(&mut self, run: &Run) {
        for &id in &run.resources {
            let Some(resource) = self.resources.get_mut(&id) else { continue };
            resource.references -= run.polygons;
            if resource.references == 0 {
                self.deferred -= 1;
                self.free(id);
            }
        }
    }

    /// Takes the program's reference away. Returns whether the resource is
    /// still needed; it is locked then.
    pub(super) fn disown(&mut self, id: ResourceId) -> Result<bool, MemoryError> {
        let resource = self.resources.get_mut(&id).filter(|resource| resource.is_owned);
        let resource = resource.ok_or(MemoryError::Unknown)?;
        resource.is_owned = false;
        resource.references -= 1;
        if resource.references == 0 {
            self.free(id);
            return Ok(false);
        }
        resource.is_locked = true;
        self.deferred += 1;
        Ok(true)
    }

    fn free(&mut self, id: ResourceId) {
        let Some(resource) = self.resources.remove(&id) else { return };
        if let Some(address) = resource.address {
            self.board.release(address);
        }
        if resource.has_copy {
            self.host_used -= resource.bytes;
        }
        self.statistics.freed += 1;
    }

    /// Bytes of board memory that are free or would be made so for a new
    /// resource.
    pub(super) fn available(&self) -> u64 {
        match self.config.kind {
            EngineKind::Separate => {
                let locked = self.resources.values().filter(|r| r.is_locked && r.address.is_some());
                self.board.capacity() - locked.map(|resource| resource.bytes).sum::<u64>()
            }
            _ => self.board.free_bytes(),
        }
    }
}
