//! A network path of the static kind: a flow-controlled queue of words.
//!
//! Contents travel as packets, timing word by word: each word carries the cycle at which it can be
//! read, each free place the cycle at which it became free. Timing is therefore the same in
//! whatever order sender and receiver happen to be simulated.

use std::cell::{Cell, RefCell};
use std::collections::VecDeque;

use super::kernel::{Kernel, TaskId};

/// A path that carries packets of type `T`, each some words long.
pub struct Link<T> {
    latency: u64,
    packets: RefCell<VecDeque<(T, u32)>>,
    words: RefCell<VecDeque<u64>>,
    places: RefCell<VecDeque<u64>>,
    capacity: usize,
    /// No word leaves before this cycle.
    held_until: Cell<u64>,
    reader: Cell<Option<TaskId>>,
    writer: Cell<Option<TaskId>>,
}

impl<T> Link<T> {
    /// A path of `capacity` words with `latency` cycles from end to end.
    pub fn new(capacity: usize, latency: u64) -> Self {
        Self {
            latency,
            packets: RefCell::default(),
            words: RefCell::default(),
            places: RefCell::new(std::iter::repeat_n(0, capacity).collect()),
            capacity,
            held_until: Cell::new(0),
            reader: Cell::new(None),
            writer: Cell::new(None),
        }
    }

    /// Empties the path, as reloading the switches does.
    pub fn clear(&self) {
        self.packets.borrow_mut().clear();
        self.words.borrow_mut().clear();
        *self.places.borrow_mut() = std::iter::repeat_n(0, self.capacity).collect();
        self.reader.set(None);
        self.writer.set(None);
    }

    /// Holds words back until a cycle, as a switch does that is busy with something else.
    pub fn hold_until(&self, cycle: u64) {
        self.held_until.set(cycle);
    }

    /// The cycle at which the next word can be read, if one is on its way.
    pub fn next_word(&self) -> Option<u64> {
        self.words.borrow().front().copied()
    }

    /// Asks to wake `task` when the next word is sent.
    pub fn notify(&self, task: TaskId) {
        self.reader.set(Some(task));
    }

    /// Sends a packet of `count` words, one per cycle of `clock` at most.
    pub async fn send(&self, k: &Kernel, me: TaskId, clock: &Cell<u64>, packet: T, count: u32) {
        self.packets.borrow_mut().push_back((packet, count));
        for _ in 0..count {
            let free = loop {
                let place = self.places.borrow_mut().pop_front();
                if let Some(free) = place {
                    break free;
                }
                self.writer.set(Some(me));
                k.suspend().await;
            };
            let sent = clock.get().max(free);
            self.words.borrow_mut().push_back(sent + self.latency);
            clock.set(sent + 1);
            if let Some(reader) = self.reader.take() {
                k.wake(reader, sent + self.latency);
            }
        }
        k.progress();
    }

    /// Receives a packet, one word per cycle of `clock` at most. Returns its contents and length.
    pub async fn receive(&self, k: &Kernel, me: TaskId, clock: &Cell<u64>) -> (T, u32) {
        self.word(k, me, clock).await;
        let (packet, count) =
            self.packets.borrow_mut().pop_front().expect("a word belongs to a packet");
        for _ in 1..count {
            self.word(k, me, clock).await;
        }
        (packet, count)
    }

    async fn word(&self, k: &Kernel, me: TaskId, clock: &Cell<u64>) {
        let ready = loop {
            let word = self.words.borrow_mut().pop_front();
            if let Some(ready) = word {
                break ready;
            }
            self.reader.set(Some(me));
            k.suspend().await;
        };
        let taken = clock.get().max(ready).max(self.held_until.get());
        self.places.borrow_mut().push_back(taken);
        clock.set(taken + 1);
        k.progress();
        if let Some(writer) = self.writer.take() {
            k.wake(writer, taken);
        }
    }
}
