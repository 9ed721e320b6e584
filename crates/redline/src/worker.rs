//! Who carries issued commands out.
//!
//! In the background, a thread of the device takes issued streams one after
//! another; issuing only hands over a stream that has been checked. Whoever
//! looks at memory waits until all streams are done, so that what it sees does
//! not depend on time. Without a background thread a stream is carried out
//! while it is issued. Both give the same pixels.
//!
//! A command that breaks an invariant of the chip is lost alone: standard error
//! says which, the chip goes on with the next one, and whoever asks for the
//! stream is told that it was not carried out as a whole.

use std::collections::{BTreeSet, VecDeque};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;

use crate::chip::VeriteChip;
use crate::error::VError;

/// Words that may wait; issuing more waits for the chip.
const MAX_WAITING_WORDS: usize = 1 << 24;
/// Commands of a stream that may be lost before the rest of it is.
const MAX_LOST: usize = 16;
/// Streams with lost commands that nobody has asked for are remembered up to
/// so many.
const MAX_MAIMED: usize = 1024;

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
    /// Commands and questions that broke off.
    lost: AtomicU64,
}

#[derive(Debug, Default)]
struct Queue {
    streams: VecDeque<Vec<u32>>,
    waiting_words: usize,
    issued: u64,
    completed: u64,
    stop: bool,
    /// Streams of which commands were lost.
    maimed: BTreeSet<u64>,
}

impl Queue {
    /// A stream is done.
    fn complete(&mut self, whole: bool) {
        self.completed += 1;
        if !whole {
            self.maimed.insert(self.completed);
            if self.maimed.len() > MAX_MAIMED {
                self.maimed.pop_first();
            }
        }
    }
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
            lost: AtomicU64::new(0),
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
            drop(queue);
            let whole = self.shared.carry_out(&words);
            locked(&self.shared.queue).complete(whole);
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
    }

    /// Waits for all streams.
    pub fn finish(&self) {
        let issued = locked(&self.shared.queue).issued;
        self.wait(issued);
    }

    /// Whether commands of a stream that is done were lost; says so once.
    pub fn take_loss(&self, number: u64) -> bool {
        locked(&self.shared.queue).maimed.remove(&number)
    }

    /// Does something with the chip once all streams are done.
    ///
    /// # Errors
    /// [`VError::Failed`] where that breaks an invariant of the chip, which
    /// stays usable.
    pub fn with<T>(&self, work: impl FnOnce(&mut VeriteChip) -> T) -> Result<T, VError> {
        self.finish();
        let mut chip = locked(&self.shared.chip);
        let result = catch_unwind(AssertUnwindSafe(|| work(&mut chip)));
        result.map_err(|_| {
            eprintln!(
                "fillrate: RRedline: the board could not be asked; what was drawn last is lost"
            );
            chip.recover();
            self.shared.lost.fetch_add(1, Ordering::Relaxed);
            VError::Failed
        })
    }

    /// How often the chip broke off.
    pub fn lost(&self) -> u64 {
        self.shared.lost.load(Ordering::Relaxed)
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        locked(&self.shared.queue).stop = true;
        self.shared.issued.notify_one();
        if let Some(thread) = self.thread.take() {
            // It catches what goes wrong in there.
            drop(thread.join());
        }
    }
}

impl Shared {
    /// Carries a stream out; false where commands of it were lost.
    fn carry_out(&self, words: &[u32]) -> bool {
        let (mut chip, mut at) = (locked(&self.chip), 0);
        for lost in 0..MAX_LOST {
            if catch_unwind(AssertUnwindSafe(|| chip.execute(words, &mut at))).is_ok() {
                return lost == 0;
            }
            self.lost.fetch_add(1, Ordering::Relaxed);
            let (first, count) = (words.get(at).copied().unwrap_or_default(), words.len());
            eprintln!("fillrate: RRedline: command {first:#010x}, word {at} of {count}, is lost");
            chip.recover();
            chip.skip(words, &mut at);
        }
        eprintln!("fillrate: RRedline: {} words after it are lost, too", words.len() - at);
        false
    }

    /// What the thread does: streams in order until there are no more.
    fn run(&self) {
        while let Some(words) = self.next() {
            let whole = self.carry_out(&words);
            let mut queue = locked(&self.queue);
            queue.complete(whole);
            queue.waiting_words -= words.len();
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chip::BROKEN_FRAME;
    use crate::config::RedlineConfig;
    use crate::opcode::Opcode;

    /// Clears two bytes at an address to a value.
    fn clear(address: u32, value: u32) -> [u32; 6] {
        [Opcode::MemClearRect as u32, address, 0, 2, 1, value]
    }

    fn bytes(worker: &Worker) -> Vec<u8> {
        worker.with(|chip| chip.read_rows(0, 0, 8, 1)).unwrap()
    }

    /// What follows a command that fails is carried out, in its stream and in
    /// others.
    #[test]
    fn a_command_is_lost_alone() {
        for background in [false, true] {
            let config = RedlineConfig::default();
            let worker = Worker::new(VeriteChip::new(&config).unwrap(), background);
            let broken = [Opcode::FrameMarker as u32, 0xa5c3_1697, BROKEN_FRAME];
            let words = [&clear(0, 0x0101)[..], &broken, &clear(2, 0x0202), &broken].concat();
            let first = worker.issue(words);
            let second = worker.issue(clear(4, 0x0303).to_vec());
            worker.wait(second);
            assert!(worker.is_done(first) && worker.is_done(second));
            assert!(worker.take_loss(first) && !worker.take_loss(first));
            assert!(!worker.take_loss(second));
            assert_eq!(bytes(&worker), [1, 1, 2, 2, 3, 3, 0, 0]);
            // A stream that loses all is given up, and the next one is not.
            let third = worker.issue([broken; 100].concat());
            let fourth = worker.issue(clear(6, 0x0404).to_vec());
            worker.finish();
            assert!(worker.take_loss(third) && !worker.take_loss(fourth));
            assert_eq!(worker.with(|_| panic!("asked for")), Err::<(), _>(VError::Failed));
            assert_eq!(bytes(&worker), [1, 1, 2, 2, 3, 3, 4, 4]);
            assert_eq!(worker.lost(), 2 + MAX_LOST as u64 + 1);
        }
    }
}
