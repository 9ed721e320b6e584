//! Texture memory of a board that draws while the program goes on.
//!
//! Textures, bitmaps and colour tables are counted: one reference for the
//! program that owns them, one for each polygon that is queued. A deletion
//! while polygons are queued is deferred until the last of them is drawn, so
//! that what was submitted draws with the texels it was submitted with. Where
//! memory is short, the program waits for the renderer only as long as deferred
//! deletions may still make room.
//!
//! The manager keeps the queue of polygons, as the board's own, and everyone may
//! draw it: the thread that waits ([`Drawing::Caller`], where all that happens
//! follows from the calls alone), or others, which take [`Work`]
//! ([`Drawing::Threads`]).
//!
//! A front end that draws by other means keeps the books of the modelled board
//! with `Drawing::Caller`: [`TextureMemory::create`], [`TextureMemory::submit`]
//! with the textures of a draw and its polygons, [`TextureMemory::delete`],
//! [`TextureMemory::sync`], and [`TextureMemory::start_frame`] and
//! [`TextureMemory::end_frame`] around frames. What fails, what is loaded and
//! what is free then depends on the calls only, however its own pixels are drawn;
//! images can be `()`.
//!
//! ```
//! use std::sync::Arc;
//! use fillrate_rave::memory::{EngineKind, MemoryConfig, TextureMemory};
//!
//! let board = MemoryConfig { kind: EngineKind::VideoOnly, video_bytes: 100, ..Default::default() };
//! let memory = TextureMemory::new(board);
//! let old = memory.create(Arc::new("brick"), 80, false)?;
//! memory.submit(&[old], 12)?;
//! memory.delete(old)?;                                    // twelve polygons still need it
//! assert_eq!(memory.statistics().freed, 0);
//! let new = memory.create(Arc::new("grass"), 80, false)?; // waits until they are drawn
//! assert_eq!(memory.statistics().freed, 1);
//! # memory.delete(new)?;
//! # Ok::<(), fillrate_rave::memory::MemoryError>(())
//! ```
//!
//! Source: TN, engine texture management strategies.

mod heap;
mod state;
#[cfg(test)]
mod tests;

use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};

use state::{Run, State};

/// Number of a texture, bitmap or colour table; never used twice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ResourceId(u64);

/// Where an engine keeps textures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum EngineKind {
    /// In host memory; copied to the board when they are drawn with, and
    /// evicted from it when others need the room.
    #[default]
    Separate,
    /// On the board alone, from creation to deletion (the technote's
    /// `VRAM_ENGINE`).
    VideoOnly,
    /// As [`EngineKind::VideoOnly`], and nothing that a frame drew with is freed
    /// before the frame ends, as on the first Apple accelerator.
    VideoOnlyUntilFrameEnd,
}

/// Who draws what is queued.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Drawing {
    /// The thread that has to wait for it.
    #[default]
    Caller,
    /// Other threads, by [`TextureMemory::wait_for_work`].
    Threads,
}

/// Sizes and kind of an engine's texture memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MemoryConfig {
    /// Where textures are kept.
    pub kind: EngineKind,
    /// Bytes of board memory for textures.
    pub video_bytes: u64,
    /// Bytes of host memory for copies of detached textures.
    pub host_bytes: u64,
    /// Who draws.
    pub drawing: Drawing,
}

impl Default for MemoryConfig {
    /// 64 MiB on the board, 1 GiB beside it: more than programs of the time ask
    /// for.
    fn default() -> MemoryConfig {
        MemoryConfig {
            kind: EngineKind::Separate,
            video_bytes: 64 << 20,
            host_bytes: 1 << 30,
            drawing: Drawing::Caller,
        }
    }
}

/// Why there is no texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MemoryError {
    /// The board has no room, and no deferred deletion will make any.
    #[error("board memory is exhausted")]
    OutOfVideoMemory,
    /// The host has no room for the engine's copy.
    #[error("host memory is exhausted")]
    OutOfMemory,
    /// There is no such texture, or it has been deleted.
    #[error("no such texture")]
    Unknown,
}

/// What has happened since the start.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Statistics {
    /// Copies to board memory.
    pub loads: u64,
    /// Their bytes.
    pub loaded_bytes: u64,
    /// Copies that left board memory for others.
    pub evictions: u64,
    /// Runs of polygons drawn from host memory, because locked textures filled
    /// the board.
    pub host_draws: u64,
    /// Times that the program waited for the renderer.
    pub waits: u64,
    /// Textures freed for good.
    pub freed: u64,
}

/// The longest queue, in runs; the program waits for the renderer beyond it.
const MAX_QUEUED: usize = 1 << 16;

#[derive(Debug)]
struct Shared<T> {
    state: Mutex<State<T>>,
    /// Work was queued, work was done, or the memory was closed.
    changed: Condvar,
}

impl<T> Shared<T> {
    fn lock(&self) -> MutexGuard<'_, State<T>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn wait<'a>(&self, state: MutexGuard<'a, State<T>>) -> MutexGuard<'a, State<T>> {
        self.changed.wait(state).unwrap_or_else(PoisonError::into_inner)
    }
}

/// The texture memory of an engine. Clones are the same memory.
///
/// `T` is an image: what the renderer reads texels from. It is handed over by
/// `Arc` and never copied; sizes are what the program says they are.
#[derive(Debug)]
pub struct TextureMemory<T> {
    shared: Arc<Shared<T>>,
}

impl<T> Clone for TextureMemory<T> {
    fn clone(&self) -> Self {
        TextureMemory { shared: self.shared.clone() }
    }
}

/// Polygons to be drawn now, and the images to draw them with. They count as
/// drawn when this is dropped, or given to [`TextureMemory::retire`].
#[derive(Debug)]
pub struct Work<T> {
    shared: Arc<Shared<T>>,
    run: Option<Run>,
    texels: Vec<Arc<T>>,
}

impl<T> Work<T> {
    /// What they are drawn with, in the order of submission.
    pub fn resources(&self) -> &[ResourceId] {
        self.run.as_ref().map_or(&[], |run| &run.resources)
    }

    /// The images, as they lie in board memory.
    pub fn texels(&self) -> &[Arc<T>] {
        &self.texels
    }

    /// How many polygons.
    pub fn polygons(&self) -> u64 {
        self.run.as_ref().map_or(0, |run| run.polygons)
    }
}

impl<T> Drop for Work<T> {
    fn drop(&mut self) {
        self.texels.clear();
        if let Some(run) = self.run.take() {
            self.shared.lock().retire(run);
            self.shared.changed.notify_all();
        }
    }
}

impl<T> TextureMemory<T> {
    /// Empty memory.
    pub fn new(config: MemoryConfig) -> TextureMemory<T> {
        let state = Mutex::new(State::new(config));
        TextureMemory { shared: Arc::new(Shared { state, changed: Condvar::new() }) }
    }

    /// How it was made.
    pub fn config(&self) -> MemoryConfig {
        self.shared.lock().config
    }

    /// A texture, bitmap or colour table of `bytes` bytes (at least 1), owned by
    /// the program. `is_locked` keeps it on the board (`kQATexture_Lock`).
    ///
    /// Without separate engine memory it lies on the board at once; the program
    /// waits for deferred deletions where there is no room.
    ///
    /// # Errors
    /// [`MemoryError::OutOfVideoMemory`] where it has to be on the board and
    /// cannot, or is larger than the board.
    pub fn create(
        &self,
        image: Arc<T>,
        bytes: u64,
        is_locked: bool,
    ) -> Result<ResourceId, MemoryError> {
        let mut state = self.shared.lock();
        let bytes = bytes.max(1);
        if bytes > state.config.video_bytes {
            return Err(MemoryError::OutOfVideoMemory);
        }
        let id = state.insert(image, bytes, is_locked);
        if is_locked || state.config.kind != EngineKind::Separate {
            let (mut state, done) =
                self.reserve(state, |state| state.load(id), State::makes_no_room);
            if !done {
                state.forget(id);
                return Err(MemoryError::OutOfVideoMemory);
            }
        }
        Ok(id)
    }

    /// Makes the image the engine's own, so that the program may reuse its
    /// memory (`QATextureDetach`). Nothing to do without separate engine memory.
    ///
    /// # Errors
    /// [`MemoryError::OutOfMemory`] where host memory has no room once deferred
    /// deletions are done; [`MemoryError::Unknown`].
    pub fn detach(&self, id: ResourceId) -> Result<(), MemoryError> {
        let state = self.shared.lock();
        let resource = state.resources.get(&id).filter(|resource| resource.is_owned);
        let resource = resource.ok_or(MemoryError::Unknown)?;
        let (bytes, has_copy) = (resource.bytes, resource.has_copy);
        if has_copy || state.config.kind != EngineKind::Separate {
            return Ok(());
        }
        let room = |state: &mut State<T>| state.has_host_room(bytes);
        let (mut state, done) = self.reserve(state, room, State::makes_no_room);
        if !done {
            return Err(MemoryError::OutOfMemory);
        }
        state.keep_copy(id);
        Ok(())
    }

    /// Replaces the image by another of the same size, once the polygons that
    /// are queued with the old one are drawn.
    ///
    /// # Errors
    /// [`MemoryError::Unknown`].
    pub fn replace(&self, id: ResourceId, image: Arc<T>) -> Result<(), MemoryError> {
        let state = self.shared.lock();
        if !state.resources.get(&id).is_some_and(|resource| resource.is_owned) {
            return Err(MemoryError::Unknown);
        }
        let (mut state, _) = self.reserve(state, |state| !state.is_in_use(id), |_| false);
        let resource = state.resources.get_mut(&id).ok_or(MemoryError::Unknown)?;
        resource.image = image.clone();
        if let Some(address) = resource.address {
            let bytes = resource.bytes;
            state.statistics.loads += 1;
            state.statistics.loaded_bytes += bytes;
            state.board.overwrite(address, image);
        }
        Ok(())
    }

    /// Queues polygons that are drawn with these resources. Polygons are drawn
    /// in the order in which they are submitted.
    ///
    /// # Errors
    /// [`MemoryError::Unknown`] where one has been deleted; nothing is queued.
    pub fn submit(&self, resources: &[ResourceId], polygons: u64) -> Result<(), MemoryError> {
        let mut state = self.shared.lock();
        if polygons == 0 || resources.is_empty() {
            return Ok(());
        }
        state.submit(resources, polygons)?;
        if state.queue.len() > MAX_QUEUED {
            let is_short = |state: &mut State<T>| state.queue.len() <= MAX_QUEUED;
            (state, _) = self.reserve(state, is_short, |_| false);
        }
        if state.config.drawing == Drawing::Threads {
            drop(state);
            self.shared.changed.notify_all();
        }
        Ok(())
    }

    /// The next polygons to draw, whose textures lie on the board from now on;
    /// `None` where none are queued.
    pub fn take_work(&self) -> Option<Work<T>> {
        self.work(self.shared.lock())
    }

    fn work(&self, mut state: MutexGuard<'_, State<T>>) -> Option<Work<T>> {
        let (run, texels) = state.begin()?;
        Some(Work { shared: self.shared.clone(), run: Some(run), texels })
    }

    /// As [`TextureMemory::take_work`], and waits where there is none; `None`
    /// once the memory is closed and all is drawn.
    pub fn wait_for_work(&self) -> Option<Work<T>> {
        let mut state = self.shared.lock();
        while state.queue.is_empty() && !state.is_closed {
            state = self.shared.wait(state);
        }
        self.work(state)
    }

    /// Counts polygons as drawn; what the program deleted meanwhile is freed.
    pub fn retire(&self, work: Work<T>) {
        drop(work);
    }

    /// Draws what is queued, where the caller is the renderer.
    pub fn draw_queued(&self) {
        while let Some(work) = self.take_work() {
            self.retire(work);
        }
    }

    /// Deletes a resource: now, or after the last polygon that is queued with
    /// it. Until then it is kept on the board; where there is no room for it,
    /// the program waits.
    ///
    /// # Errors
    /// [`MemoryError::Unknown`]; nothing is deleted twice.
    pub fn delete(&self, id: ResourceId) -> Result<(), MemoryError> {
        let mut state = self.shared.lock();
        if state.disown(id)? {
            let is_settled =
                |state: &mut State<T>| state.load(id) || !state.resources.contains_key(&id);
            drop(self.reserve(state, is_settled, |_| false));
        }
        Ok(())
    }

    /// Waits until everything that is queued is drawn (`QASync`). Nothing but
    /// the program refers to textures then, outside frames that keep them.
    pub fn sync(&self) {
        let state = self.shared.lock();
        drop(self.reserve(state, |state| !state.is_busy(), |_| false));
    }

    /// Begins a frame.
    pub fn start_frame(&self) {
        self.shared.lock().in_frame = true;
    }

    /// Ends it, complete or not. What the frame kept is given up, once all is
    /// drawn; where nothing is kept, other threads draw on.
    pub fn end_frame(&self) {
        let mut state = self.shared.lock();
        let keeps = state.config.kind == EngineKind::VideoOnlyUntilFrameEnd;
        if keeps || state.config.drawing == Drawing::Caller {
            (state, _) = self.reserve(state, |state| !state.is_busy(), |_| false);
        }
        state.end_frame();
        drop(state);
        self.shared.changed.notify_all();
    }

    /// Bytes of board memory that a new texture could have, after all deferred
    /// deletions (`kQAGestalt_FastTextureMemory`).
    pub fn free_bytes(&self) -> u64 {
        self.settled().available()
    }

    /// Bytes left for textures in ordinary memory, after all deferred deletions
    /// (`kQAGestalt_TextureMemory`): the host's for engines that keep copies
    /// there, else the board's.
    pub fn free_ordinary_bytes(&self) -> u64 {
        let state = self.settled();
        match state.config.kind {
            EngineKind::Separate => state.config.host_bytes - state.host_used,
            _ => state.available(),
        }
    }

    /// The state once no deletion is deferred, or none can be finished.
    fn settled(&self) -> MutexGuard<'_, State<T>> {
        self.reserve(self.shared.lock(), |state| state.deferred == 0, |_| false).0
    }

    /// What has happened so far.
    pub fn statistics(&self) -> Statistics {
        self.shared.lock().statistics
    }

    /// Lets threads that wait for work go once all is drawn.
    pub fn close(&self) {
        self.shared.lock().is_closed = true;
        self.shared.changed.notify_all();
    }

    /// Yields to the renderer until `try_once` succeeds. Gives up where it
    /// fails and `is_hopeless`, or nothing is left to draw.
    fn reserve<'a>(
        &'a self,
        mut state: MutexGuard<'a, State<T>>,
        mut try_once: impl FnMut(&mut State<T>) -> bool,
        is_hopeless: impl Fn(&State<T>) -> bool,
    ) -> (MutexGuard<'a, State<T>>, bool) {
        loop {
            if try_once(&mut state) {
                return (state, true);
            }
            if is_hopeless(&state) || !state.is_busy() {
                return (state, false);
            }
            state.statistics.waits += 1;
            state = match (state.config.drawing, state.queue.is_empty()) {
                (Drawing::Caller, false) => {
                    drop(self.work(state));
                    self.shared.lock()
                }
                _ => self.shared.wait(state),
            };
        }
    }
}
