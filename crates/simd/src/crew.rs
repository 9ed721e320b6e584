//! Threads that help with something borrowed, without taking memory for it.
//!
//! Helpers sleep until there is work. A round hands all of them the same
//! closure, which takes its items from a queue of its own; the caller works
//! along and returns when nobody works any more. A helper that wakes up too
//! late finds the round over, so that short rounds wait for nobody.

use core::sync::atomic::{AtomicU64, Ordering};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};

/// What a round works on, once its lifetime is left out.
type Work = dyn Fn(usize) + Sync + 'static;

/// A round's closure, its lifetime left out.
#[derive(Clone, Copy)]
struct Lent(*const Work);

// SAFETY: the closure may be called by any thread, and `Crew::together` does
// not return while a helper holds it.
unsafe impl Send for Lent {}

#[derive(Default)]
struct State {
    /// There while a round goes on.
    work: Option<Lent>,
    /// Helpers inside the round's closure.
    working: usize,
    /// One of them panicked.
    panicked: bool,
    /// The crew goes home.
    closing: bool,
}

#[derive(Default)]
struct Shared {
    state: Mutex<State>,
    /// Rounds started so far; written under the lock.
    round: AtomicU64,
    /// A round has started, or the crew goes home.
    start: Condvar,
    /// No helper works any more.
    idle: Condvar,
}

impl Shared {
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Helpers that share the caller's work.
#[derive(Debug)]
pub struct Crew {
    shared: Arc<Shared>,
    /// Held during a round.
    turn: Mutex<()>,
    helpers: Vec<JoinHandle<()>>,
}

impl core::fmt::Debug for Shared {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Shared").finish_non_exhaustive()
    }
}

/// How often a helper with a core of its own looks for the next round, giving
/// way each time, before it sleeps: batches of a frame follow each other closely.
const PATIENCE: u32 = 64;

impl Crew {
    /// Starts helpers.
    ///
    /// # Errors
    /// Where the system starts no thread.
    pub fn new(helpers: usize) -> std::io::Result<Crew> {
        let shared = Arc::new(Shared::default());
        // Where threads share cores, looking out would take time from those that work.
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let patience = if helpers < cores { PATIENCE } else { 0 };
        // Dropping the crew sends home those that were started.
        let turn = Mutex::new(());
        let mut crew = Crew { shared, turn, helpers: Vec::with_capacity(helpers) };
        for i in 0..helpers {
            let shared = crew.shared.clone();
            let thread = thread::Builder::new().name(format!("fillrate-{i}"));
            crew.helpers.push(thread.spawn(move || help(&shared, patience, i + 1))?);
        }
        Ok(crew)
    }

    /// Runs `work` on the caller and on every helper that wakes up while it
    /// lasts, and returns when all have come back from it. `work` is told who it
    /// is: 0 the caller, a helper's number otherwise. A second caller
    /// waits for its turn; `work` itself must not call this.
    ///
    /// # Panics
    /// Where `work` panics on any thread.
    pub fn together(&self, work: &(dyn Fn(usize) + Sync)) {
        let turn = self.turn.lock().unwrap_or_else(PoisonError::into_inner);
        // SAFETY: only the lifetime changes. `work` outlives the round: no helper
        // takes it once it is removed below, and this waits for those that did,
        // also where the caller's own part panics.
        let lent = unsafe {
            core::mem::transmute::<*const (dyn Fn(usize) + Sync + '_), *const Work>(work)
        };
        let mut state = self.shared.lock();
        state.work = Some(Lent(lent));
        self.shared.round.fetch_add(1, Ordering::Relaxed);
        drop(state);
        self.shared.start.notify_all();

        let own = catch_unwind(AssertUnwindSafe(|| work(0)));

        let mut state = self.shared.lock();
        state.work = None;
        while state.working > 0 {
            state = self.shared.idle.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
        let panicked = core::mem::take(&mut state.panicked);
        drop(state);
        drop(turn);
        if let Err(payload) = own {
            resume_unwind(payload);
        }
        assert!(!panicked, "a helper panicked");
    }
}

impl Drop for Crew {
    fn drop(&mut self) {
        self.shared.lock().closing = true;
        self.shared.start.notify_all();
        for helper in self.helpers.drain(..) {
            // A helper does not panic: the work's panics are caught.
            let _ = helper.join();
        }
    }
}

/// A helper's life.
fn help(shared: &Shared, patience: u32, number: usize) {
    let mut seen = 0;
    loop {
        for _ in 0..patience {
            if shared.round.load(Ordering::Relaxed) != seen {
                break;
            }
            thread::yield_now();
        }
        let mut state = shared.lock();
        let work = loop {
            if state.closing {
                return;
            }
            let round = shared.round.load(Ordering::Relaxed);
            if round != seen {
                seen = round;
                // A round that is over already is none.
                if let Some(work) = state.work {
                    break work;
                }
            }
            state = shared.start.wait(state).unwrap_or_else(PoisonError::into_inner);
        };
        state.working += 1;
        drop(state);
        // SAFETY: the round cannot end while `working` counts this helper.
        let result = catch_unwind(AssertUnwindSafe(|| unsafe { (*work.0)(number) }));
        let mut state = shared.lock();
        state.working -= 1;
        state.panicked |= result.is_err();
        if state.working == 0 {
            shared.idle.notify_all();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::sync::atomic::AtomicUsize;

    /// Every item of many short rounds is worked on once.
    #[test]
    fn rounds_are_complete() {
        let crew = Crew::new(3).unwrap();
        for round in 0..2000usize {
            let items = round % 7;
            let (next, done) = (AtomicUsize::new(0), Mutex::new(vec![0; items]));
            crew.together(&|_| {
                loop {
                    let item = next.fetch_add(1, Ordering::Relaxed);
                    if item >= items {
                        return;
                    }
                    done.lock().unwrap()[item] += 1;
                }
            });
            assert!(done.into_inner().unwrap().iter().all(|&count| count == 1));
        }
    }

    /// Helpers take part.
    #[test]
    fn rounds_are_shared() {
        let crew = Crew::new(2).unwrap();
        let present = AtomicUsize::new(0);
        crew.together(&|_| {
            present.fetch_add(1, Ordering::SeqCst);
            while present.load(Ordering::SeqCst) < 3 {
                thread::yield_now();
            }
        });
        assert_eq!(present.into_inner(), 3);
    }

    /// A panic reaches the caller once nobody works any more, and the crew
    /// goes on.
    #[test]
    fn panics_come_back() {
        let crew = Crew::new(2).unwrap();
        for caller in [true, false] {
            let main = thread::current().id();
            let helped = AtomicUsize::new(0);
            let result = catch_unwind(AssertUnwindSafe(|| {
                crew.together(&|_| {
                    let here = thread::current().id() == main;
                    helped.fetch_add(usize::from(!here), Ordering::SeqCst);
                    while helped.load(Ordering::SeqCst) < 2 {
                        thread::yield_now();
                    }
                    assert!(here != caller, "on purpose");
                });
            }));
            assert!(result.is_err());
            let count = AtomicUsize::new(0);
            crew.together(&|_| {
                count.fetch_add(1, Ordering::SeqCst);
            });
            assert!(count.into_inner() >= 1);
        }
    }

    /// Callers on several threads take turns.
    #[test]
    fn callers_take_turns() {
        let crew = Crew::new(1).unwrap();
        let inside = AtomicUsize::new(0);
        thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| {
                    for _ in 0..200 {
                        let mine = AtomicUsize::new(0);
                        crew.together(&|_| {
                            if mine.fetch_add(1, Ordering::SeqCst) == 0 {
                                assert_eq!(inside.fetch_add(1, Ordering::SeqCst), 0);
                                inside.fetch_sub(1, Ordering::SeqCst);
                            }
                        });
                    }
                });
            }
        });
    }
}
