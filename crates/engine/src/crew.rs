//! Threads that help with a job while its owner goes on with something else.
//!
//! Helpers sleep until a round starts, take their shares of the job and sleep
//! again. The owner may join at any time, and gets the job back when nobody works
//! on it any more. A helper that wakes up too late finds the round over, so that
//! short rounds wait for nobody.

use core::any::Any;
use core::sync::atomic::{AtomicU64, Ordering};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{
    Arc, Condvar, Mutex, MutexGuard, PoisonError, RwLock, RwLockReadGuard, RwLockWriteGuard,
};
use std::thread::{self, JoinHandle};

/// What several threads can work on.
pub(crate) trait Job: Send + Sync + 'static {
    /// Takes shares of the job until there are none; other workers may still be
    /// at theirs. `worker` is 0 for the owner, a helper's number otherwise.
    fn work(&self, worker: usize);
}

#[derive(Default)]
struct State {
    /// A round goes on.
    open: bool,
    /// Helpers inside the job.
    working: usize,
    /// A helper found nothing left to begin in this round.
    exhausted: bool,
    /// What one of them panicked with.
    panic: Option<Box<dyn Any + Send>>,
    /// The crew goes home.
    closing: bool,
}

struct Shared<J> {
    /// Read by those who work, written between rounds.
    job: RwLock<J>,
    state: Mutex<State>,
    /// Rounds started so far; written under the lock of `state`.
    round: AtomicU64,
    /// A round has started, or the crew goes home.
    start: Condvar,
    /// No helper works any more.
    idle: Condvar,
}

impl<J> Shared<J> {
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn job(&self) -> RwLockReadGuard<'_, J> {
        self.job.read().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A job's owner and its helpers.
pub(crate) struct Crew<J> {
    shared: Arc<Shared<J>>,
    helpers: Vec<JoinHandle<()>>,
}

impl<J> core::fmt::Debug for Crew<J> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Crew").field("helpers", &self.helpers.len()).finish_non_exhaustive()
    }
}

/// How often a helper with a core of its own looks for the next round, giving
/// way each time, before it sleeps: batches of a frame follow each other closely.
const PATIENCE: u32 = 64;

impl<J: Job> Crew<J> {
    /// Starts helpers; there may be none.
    ///
    /// # Errors
    /// Where the system starts no thread.
    pub fn new(job: J, helpers: usize) -> std::io::Result<Crew<J>> {
        let shared = Arc::new(Shared {
            job: RwLock::new(job),
            state: Mutex::default(),
            round: AtomicU64::new(0),
            start: Condvar::new(),
            idle: Condvar::new(),
        });
        // Where threads share cores, looking out would take time from those that work.
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let patience = if helpers < cores { PATIENCE } else { 0 };
        // Dropping the crew sends home those that were started.
        let mut crew = Crew { shared, helpers: Vec::with_capacity(helpers) };
        for i in 0..helpers {
            let shared = crew.shared.clone();
            let thread = thread::Builder::new().name(format!("fillrate-{i}"));
            crew.helpers.push(thread.spawn(move || help(&shared, patience, i + 1))?);
        }
        Ok(crew)
    }

    /// Whether nobody helps.
    pub fn is_alone(&self) -> bool {
        self.helpers.is_empty()
    }

    /// The job between two rounds; waits where one goes on.
    pub fn job(&mut self) -> RwLockWriteGuard<'_, J> {
        self.shared.job.write().unwrap_or_else(PoisonError::into_inner)
    }

    /// Starts a round: helpers begin, the caller goes on.
    pub fn start(&mut self) {
        let mut state = self.shared.state();
        (state.open, state.exhausted) = (true, false);
        self.shared.round.fetch_add(1, Ordering::Relaxed);
        drop(state);
        if !self.is_alone() {
            self.shared.start.notify_all();
        }
    }

    /// Whether helpers have done all of the round. It does not wait.
    pub fn is_done(&self) -> bool {
        let state = self.shared.state();
        state.exhausted && state.working == 0
    }

    /// Works along, and returns when the round is over.
    ///
    /// # Errors
    /// What the job panicked with, on whichever thread.
    pub fn finish(&mut self) -> thread::Result<()> {
        let own = catch_unwind(AssertUnwindSafe(|| self.shared.job().work(0)));
        let mut state = self.shared.state();
        state.open = false;
        while state.working > 0 {
            state = self.shared.idle.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
        let helped = state.panic.take().map_or(Ok(()), Err);
        own.and(helped)
    }
}

impl<J> Drop for Crew<J> {
    fn drop(&mut self) {
        self.shared.state().closing = true;
        self.shared.start.notify_all();
        for helper in self.helpers.drain(..) {
            // A helper does not panic: the job's panics are caught.
            let _ = helper.join();
        }
    }
}

/// A helper's life.
fn help<J: Job>(shared: &Shared<J>, patience: u32, number: usize) {
    let mut seen = 0;
    loop {
        for _ in 0..patience {
            if shared.round.load(Ordering::Relaxed) != seen {
                break;
            }
            thread::yield_now();
        }
        let mut state = shared.state();
        loop {
            if state.closing {
                return;
            }
            let round = shared.round.load(Ordering::Relaxed);
            // A round that is over already is none.
            if core::mem::replace(&mut seen, round) != round && state.open {
                break;
            }
            state = shared.start.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
        state.working += 1;
        drop(state);
        let result = catch_unwind(AssertUnwindSafe(|| shared.job().work(number)));
        let mut state = shared.state();
        state.working -= 1;
        state.exhausted = true;
        if let Err(panic) = result {
            state.panic = Some(panic);
        }
        if state.working == 0 {
            shared.idle.notify_all();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::sync::atomic::AtomicUsize;

    /// Items that are to be worked on once.
    #[derive(Default)]
    struct Items {
        next: AtomicUsize,
        done: Vec<AtomicUsize>,
    }

    impl Job for Items {
        fn work(&self, _: usize) {
            while let Some(item) = self.done.get(self.next.fetch_add(1, Ordering::Relaxed)) {
                item.fetch_add(1, Ordering::Relaxed);
            }
        }
    }

    /// Every item of many short rounds is worked on once, with helpers or not.
    #[test]
    fn rounds_are_complete() {
        for helpers in [0, 3] {
            let mut crew = Crew::new(Items::default(), helpers).unwrap();
            for round in 0..2000 {
                let mut job = crew.job();
                *job = Items::default();
                job.done.resize_with(round % 7, AtomicUsize::default);
                drop(job);
                crew.start();
                crew.finish().unwrap();
                assert!(crew.job().done.iter_mut().all(|count| *count.get_mut() == 1));
            }
        }
    }

    /// Waits for others to come.
    struct Meeting {
        expected: usize,
        present: AtomicUsize,
    }

    impl Job for Meeting {
        fn work(&self, _: usize) {
            self.present.fetch_add(1, Ordering::SeqCst);
            while self.present.load(Ordering::SeqCst) < self.expected {
                thread::yield_now();
            }
        }
    }

    /// Helpers take part, and begin without the owner.
    #[test]
    fn rounds_are_shared() {
        let meeting = |expected| Meeting { expected, present: AtomicUsize::new(0) };
        let mut crew = Crew::new(meeting(3), 2).unwrap();
        crew.start();
        crew.finish().unwrap();
        assert_eq!(crew.job().present.load(Ordering::SeqCst), 3);
        *crew.job() = meeting(2);
        crew.start();
        while crew.shared.job().present.load(Ordering::SeqCst) < 2 {
            thread::yield_now();
        }
        crew.finish().unwrap();
    }

    /// Panics, on the owner's thread or on the others.
    struct Fall {
        owner: bool,
        helped: AtomicUsize,
        on: bool,
    }

    impl Job for Fall {
        fn work(&self, worker: usize) {
            self.helped.fetch_add(usize::from(worker != 0), Ordering::SeqCst);
            while self.on && self.helped.load(Ordering::SeqCst) < 2 {
                thread::yield_now();
            }
            assert!(!self.on || (worker == 0) != self.owner, "on purpose");
        }
    }

    /// A panic reaches the owner once nobody works any more, and the crew goes
    /// on.
    #[test]
    fn panics_come_back() {
        let fall = |owner, on| Fall { owner, helped: AtomicUsize::new(0), on };
        let mut crew = Crew::new(fall(true, true), 2).unwrap();
        for owner in [true, false] {
            *crew.job() = fall(owner, true);
            crew.start();
            assert!(crew.finish().is_err());
            *crew.job() = fall(owner, false);
            crew.start();
            crew.finish().unwrap();
        }
    }

    /// A round that nobody joins is told to be done once all its items are, and
    /// not before.
    #[test]
    fn rounds_are_done_without_the_owner() {
        let mut crew = Crew::new(Items::default(), 2).unwrap();
        for _ in 0..200 {
            let mut job = crew.job();
            *job = Items::default();
            job.done.resize_with(50, AtomicUsize::default);
            drop(job);
            crew.start();
            while !crew.is_done() {
                thread::yield_now();
            }
            let done = crew.shared.job().done.iter().all(|n| n.load(Ordering::SeqCst) == 1);
            assert!(done);
            crew.finish().unwrap();
        }
    }

    /// A crew that is dropped during a round leaves no thread.
    #[test]
    fn all_go_home() {
        let mut crew = Crew::new(Items::default(), 1).unwrap();
        crew.job().done.resize_with(100, AtomicUsize::default);
        crew.start();
        let shared = crew.shared.clone();
        drop(crew);
        assert_eq!(Arc::strong_count(&shared), 1);
    }
}
