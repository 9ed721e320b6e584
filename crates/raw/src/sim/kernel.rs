//! The event queue and the coroutines it wakes.
//!
//! A tile is an `async` function: Rust turns it into a state machine, and it reads like the program
//! of the tile. Every task keeps its own clock and may run ahead of the queue as long as it only
//! computes or uses links, because link timing follows from stamps alone. Before it looks at
//! anything that others change at will (a token, a mailbox) it waits for the queue to catch up.

use std::cell::{Cell, RefCell};
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::future::Future;
use std::pin::Pin;
use std::task::{Context, Poll, Waker};

/// A coroutine.
pub type Task = Pin<Box<dyn Future<Output = ()>>>;
/// The place of a coroutine in the kernel.
pub type TaskId = usize;

/// Events handled without a single word moving on any link before the machine counts as stuck.
const STUCK_AFTER: u32 = 100_000;

/// How a run of the kernel ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// A task asked to stop.
    Stopped,
    /// Nothing can happen any more, or nothing but idle circulation.
    Stuck,
}

/// The queue, the time and the tasks.
#[derive(Default)]
pub struct Kernel {
    now: Cell<u64>,
    serial: Cell<u64>,
    queue: RefCell<BinaryHeap<Reverse<(u64, u64, TaskId)>>>,
    tasks: RefCell<Vec<Option<Task>>>,
    /// When each task runs next; `u64::MAX` when nothing is planned.
    alarms: RefCell<Vec<u64>>,
    /// Places of tasks that were ended, for new ones.
    free: RefCell<Vec<TaskId>>,
    /// Tasks whose events alone do not show that anything goes on.
    idle: RefCell<Vec<TaskId>>,
    idle_events: Cell<u32>,
    stopped: Cell<bool>,
}

impl Kernel {
    /// The current cycle.
    pub fn now(&self) -> u64 {
        self.now.get()
    }

    /// Adds a task and schedules its first run for now.
    pub fn spawn(&self, task: Task) -> TaskId {
        let mut tasks = self.tasks.borrow_mut();
        // An event of the task that was there before is a spurious wake.
        let id = self.free.borrow_mut().pop().unwrap_or(tasks.len());
        if id == tasks.len() {
            tasks.push(None);
        }
        tasks[id] = Some(task);
        drop(tasks);
        self.wake(id, self.now());
        id
    }

    /// Notes that a task only passes something round; it does not keep the machine alive.
    pub fn mark_idle(&self, id: TaskId) {
        self.idle.borrow_mut().push(id);
    }

    /// Whether any task that does work has something planned.
    fn work_is_planned(&self) -> bool {
        let idle = self.idle.borrow();
        let alarms = self.alarms.borrow();
        alarms.iter().enumerate().any(|(id, at)| *at != u64::MAX && !idle.contains(&id))
    }

    /// Ends a task other than the running one.
    pub fn kill(&self, id: TaskId) {
        self.tasks.borrow_mut()[id] = None;
        self.idle.borrow_mut().retain(|idle| *idle != id);
        self.free.borrow_mut().push(id);
    }

    /// Runs the task at cycle `at`, or now if that has passed.
    ///
    /// A task has one alarm: if it will run earlier anyway, it looks around then and sets its alarm
    /// again. Without this rule every early wake would leave one more event behind.
    pub fn wake(&self, id: TaskId, at: u64) {
        let at = at.max(self.now());
        let mut alarms = self.alarms.borrow_mut();
        if alarms.len() <= id {
            alarms.resize(id + 1, u64::MAX);
        }
        if alarms[id] <= at {
            return;
        }
        alarms[id] = at;
        let serial = self.serial.get();
        self.serial.set(serial + 1);
        self.queue.borrow_mut().push(Reverse((at, serial, id)));
    }

    /// Notes that a word moved somewhere.
    pub fn progress(&self) {
        self.idle_events.set(0);
    }

    /// Ends the run after the current task.
    pub fn stop(&self) {
        self.stopped.set(true);
    }

    /// Gives the running task up until somebody wakes it. Wakes may be spurious.
    pub async fn suspend(&self) {
        let mut first = true;
        std::future::poll_fn(move |_| {
            if std::mem::take(&mut first) { Poll::Pending } else { Poll::Ready(()) }
        })
        .await;
    }

    /// Waits until the queue has reached the cycle in `clock`, which may move meanwhile.
    pub async fn catch_up(&self, id: TaskId, clock: &Cell<u64>) {
        while self.now() < clock.get() {
            self.wake(id, clock.get());
            self.suspend().await;
        }
        clock.set(self.now());
    }

    /// Drops all tasks and events.
    pub fn clear(&self) {
        self.tasks.borrow_mut().clear();
        self.free.borrow_mut().clear();
        self.queue.borrow_mut().clear();
    }

    /// Runs until a task stops the kernel or nothing can go on.
    pub fn run(&self) -> Ended {
        self.stopped.set(false);
        self.idle_events.set(0);
        let mut context = Context::from_waker(Waker::noop());
        while !self.stopped.get() {
            let Some(Reverse((at, _, id))) = self.queue.borrow_mut().pop() else {
                return Ended::Stuck;
            };
            if self.alarms.borrow()[id] != at {
                continue;
            }
            self.alarms.borrow_mut()[id] = u64::MAX;
            self.now.set(at);
            let idle = self.idle_events.get() + 1;
            self.idle_events.set(idle);
            if idle > STUCK_AFTER {
                if !self.work_is_planned() {
                    return Ended::Stuck;
                }
                self.idle_events.set(0);
            }
            self.poll(id, &mut context);
        }
        Ended::Stopped
    }

    fn poll(&self, id: TaskId, context: &mut Context<'_>) {
        let Some(mut task) = self.tasks.borrow_mut()[id].take() else { return };
        if task.as_mut().poll(context).is_pending() {
            self.tasks.borrow_mut()[id] = Some(task);
        }
    }
}
