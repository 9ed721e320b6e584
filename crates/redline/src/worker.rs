//! Who carries issued commands out.
//!
//! In the background, a thread of the device takes issued streams one after
//! another; issuing only hands over a stream that has been checked. Whoever
//! looks at memory waits until all streams are done, so that what it sees does
//! not depend on time. Without a background thread a stream is carried out
//! while it is issued. Both give the same pixels.

use std::any::Any;
use std::collections::VecDeque;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;

use crate::chip::VeriteChip;

/// Words that may wait; issuing more waits for the chip.
const MAX_WAITING_WORDS: usize = 1 << 24;

/// The chip, and how streams get to it.
#[derive(Debug)]
pub(crate) struct Worker {
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

#[derive(Debug)]
struct Shared {
    queue: Mutex<Queue>,
    /// A stream came, or the end.
    issued: Condvar,
    /// A stream is done.
    done: Condvar,
    chip: Mutex<VeriteChip>,
}

#[derive(Debug, Default)]
struct Queue {
    streams: VecDeque<Vec<u32>>,
    waiting_words: usize,
    issued: u64,
    completed: u64,
    stop: bool,
    /// What a broken invariant of the chip said; passed on to whoever waits.
    panic: Option<Box<dyn Any + Send>>,
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Worker {
    /// Puts a chip to work.
    pub fn new(chip: VeriteChip, background: bool) -> Worker {
        let shared = Arc::new(Shared {
            queue: Mutex::default(),
            issued: Condvar::new(),
            done: Condvar::new(),
            chip: Mutex::new(chip),
        });
        let theirs = Arc::clone(&shared);
        let thread = std::thread::Builder::new().name("verite".to_string());
        // Without threads, streams are carried out while they are issued.
        let thread = if background { thread.spawn(move || theirs.run()).ok() } else { None };
        Worker { shared, thread }
    }

    /// Hands a stream over; gives the number by which to ask for it.
    pub fn issue(&self, words: Vec<u32>) -> u64 {
        let mut queue = locked(&self.shared.queue);
        while queue.waiting_words > MAX_WAITING_WORDS {
            queue = self.shared.done.wait(queue).unwrap_or_else(PoisonError::into_inner);
        }
        queue.issued += 1;
        let number = queue.issued;
        if self.thread.is_some() {
            queue.waiting_words += words.len();
            queue.streams.push_back(words);
            self.shared.issued.notify_one();
        } else {
            queue.completed = number;
            drop(queue);
            locked(&self.shared.chip).execute(&words);
        }
        number
    }

    /// Whether a stream is done.
    pub fn is_done(&self, number: u64) -> bool {
        locked(&self.shared.queue).completed >= number
    }

    /// Waits for a stream.
    pub fn wait(&self, number: u64) {
        let mut queue = locked(&self.shared.queue);
        while queue.completed < number {
            queue = self.shared.done.wait(queue).unwrap_or_else(PoisonError::into_inner);
        }
        if let Some(panic) = queue.panic.take() {
            drop(queue);
            resume_unwind(panic);
        }
    }

    /// The chip, once all streams are done.
    pub fn chip(&self) -> MutexGuard<'_, VeriteChip> {
        let issued = locked(&self.shared.queue).issued;
        self.wait(issued);
        locked(&self.shared.chip)
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        locked(&self.shared.queue).stop = true;
        self.shared.issued.notify_one();
        if let Some(thread) = self.thread.take() {
            // A panic there has been passed on, or nobody waited for it.
            drop(thread.join());
        }
    }
}

impl Shared {
    /// What the thread does: streams in order until there are no more.
    fn run(&self) {
        while let Some(words) = self.next() {
            let work = || locked(&self.chip).execute(&words);
            let result = catch_unwind(AssertUnwindSafe(work));
            let mut queue = locked(&self.queue);
            queue.completed += 1;
            queue.waiting_words -= words.len();
            if let Err(panic) = result {
                queue.panic = Some(panic);
            }
            self.done.notify_all();
        }
    }

    fn next(&self) -> Option<Vec<u32>> {
        let mut queue = locked(&self.queue);
        loop {
            if let Some(words) = queue.streams.pop_front() {
                return Some(words);
            }
            if queue.stop {
                return None;
            }
            queue = self.issued.wait(queue).unwrap_or_else(PoisonError::into_inner);
        }
    }
}
