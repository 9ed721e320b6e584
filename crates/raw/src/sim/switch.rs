//! The switches of stage 1: which tile gets the next primitive.
//!
//! The commands of the host enter at the west. One switch is active and feeds its processor; when
//! its primitive ends and the processor lets go, the next tile to the east is offered a turn, takes
//! it if its processor is ready, or passes it on. Every switch counts the answers of those to its
//! east, so that it knows whether words are to be passed through.
//! Source: RAW, section 4.2.3.1 and the switch listing, for any number of columns.

use std::cell::Cell;
use std::rc::Rc;

use super::kernel::TaskId;
use super::link::Link;
use super::machine::{Machine, Word};

/// A state of a switch. Whether its processor is ready is kept apart, in `Row0::ready`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SwitchState {
    /// Feeds its processor from the west.
    Active,
    /// Waits for its processor to let the next tile start.
    DoneActive,
    /// Waits for the answer of the n-th tile to the east.
    Counting(usize),
    /// Passes a primitive on to the east, for the n-th tile.
    Passing(usize),
    /// Carries the last tile's go-ahead west to tile 0 (the last tile: its own).
    Relay,
    /// Waits for an offer from the west.
    Idle,
    /// Tile 0: waits for the go-ahead of the last tile.
    Await,
    /// Takes or passes the turn.
    Turn,
}

struct Switch {
    m: Rc<Machine>,
    column: usize,
    task: TaskId,
    clock: Cell<u64>,
}

/// Runs the switch of a column until it is killed.
pub async fn run(m: Rc<Machine>, column: usize, task: Rc<Cell<TaskId>>) {
    let clock = Cell::new(m.k.now());
    let switch = Switch { m, column, task: task.get(), clock };
    let mut state = if column == 0 { SwitchState::Active } else { SwitchState::Idle };
    loop {
        state = switch.step(state).await;
    }
}

impl Switch {
    fn last(&self) -> bool {
        self.column + 1 == self.m.columns
    }

    /// How many tiles to the east may take a turn before this one is offered one again.
    fn levels(&self) -> usize {
        self.m.columns - 1 - self.column
    }

    async fn take<T>(&self, link: &Link<T>) -> T {
        link.receive(&self.m.k, self.task, &self.clock).await.0
    }

    async fn put<T>(&self, link: &Link<T>, word: T) {
        link.send(&self.m.k, self.task, &self.clock, word, 1).await;
    }

    fn west_side(&self) -> &Link<Word> {
        match self.column {
            0 => &self.m.host,
            k => &self.m.row0.east[k - 1],
        }
    }

    async fn step(&self, state: SwitchState) -> SwitchState {
        let row = &self.m.row0;
        match state {
            SwitchState::Active => self.feed().await,
            SwitchState::DoneActive => {
                let go = self.take(&row.from_proc[self.column]).await;
                if self.m.columns == 1 {
                    return SwitchState::Turn;
                }
                self.put(&row.east[self.column], Word::control(go)).await;
                SwitchState::Counting(1)
            }
            SwitchState::Counting(n) => {
                let answer = self.take(&row.west[self.column]).await;
                if self.column > 0 {
                    self.put(&row.west[self.column - 1], answer).await;
                }
                if answer != 0 { SwitchState::Passing(n) } else { self.after(n, false) }
            }
            SwitchState::Passing(n) => {
                self.route(&row.east[self.column]).await;
                self.after(n, true)
            }
            SwitchState::Relay => {
                let own = self.last();
                let from = if own { &row.from_proc } else { &row.west };
                let go = self.take(&from[self.column]).await;
                self.put(&row.west[self.column - 1], go).await;
                SwitchState::Idle
            }
            SwitchState::Idle => {
                self.take(self.west_side()).await;
                SwitchState::Turn
            }
            SwitchState::Await => {
                self.take(&row.west[0]).await;
                SwitchState::Turn
            }
            SwitchState::Turn => self.turn().await,
        }
    }

    /// What follows the n-th answer; `taken` says whether that tile took the turn.
    fn after(&self, n: usize, taken: bool) -> SwitchState {
        match (n < self.levels(), self.column, taken) {
            (true, ..) => SwitchState::Counting(n + 1),
            (false, 0, true) => SwitchState::Await,
            (false, 0, false) => SwitchState::Turn,
            (false, _, true) => SwitchState::Relay,
            (false, _, false) => SwitchState::Idle,
        }
    }

    async fn feed(&self) -> SwitchState {
        let row = &self.m.row0;
        assert_eq!(row.active.replace(Some(self.column)), None, "only one switch is active");
        row.ready[self.column].set(false);
        self.route(&row.to_proc[self.column]).await;
        row.active.set(None);
        if self.last() && self.column > 0 { SwitchState::Relay } else { SwitchState::DoneActive }
    }

    /// Routes one primitive from the west: blocks up to the zero count.
    async fn route(&self, to: &Link<Word>) {
        loop {
            // A count goes through a register, and is routed by the next instruction.
            let count = self.take(self.west_side()).await;
            self.put(to, count).await;
            for _ in 0..count.value {
                let word = self.take(self.west_side()).await;
                // Taken and put by one instruction.
                self.clock.set(self.clock.get() - 1);
                self.put(to, word).await;
            }
            if count.value == 0 {
                return;
            }
        }
    }

    async fn turn(&self) -> SwitchState {
        let row = &self.m.row0;
        if self.column == 0 && self.m.options.skip_busy {
            self.sleep_while_all_busy().await;
        }
        row.offered[self.column].set(self.clock.get());
        if self.is_ready().await {
            row.all_passed.set(false);
            if self.column > 0 {
                self.put(&row.west[self.column - 1], 1).await;
            }
            return SwitchState::Active;
        }
        if self.column == 0 {
            row.all_passed.set(true);
        }
        if !self.last() {
            self.put(&row.east[self.column], Word::control(0)).await;
        }
        if self.column > 0 {
            self.put(&row.west[self.column - 1], 0).await;
        }
        match (self.last(), self.column) {
            // Alone, it offers the turn to itself again.
            (true, 0) => SwitchState::Turn,
            (true, _) => SwitchState::Idle,
            (false, _) => SwitchState::Counting(1),
        }
    }

    /// Whether the processor can take a primitive at the switch's time.
    async fn is_ready(&self) -> bool {
        let row = &self.m.row0;
        if !self.m.options.skip_busy {
            self.wait_for_processor().await;
            return true;
        }
        if self.clock.get() < row.busy_until.get() {
            return false;
        }
        self.m.k.catch_up(self.task, &self.clock).await;
        row.ready[self.column].get()
    }

    /// Waits until this column's processor can take a primitive.
    async fn wait_for_processor(&self) {
        let row = &self.m.row0;
        self.m.k.catch_up(self.task, &self.clock).await;
        while !row.ready[self.column].get() {
            row.sleeping_offer.set(Some(self.task));
            self.m.k.suspend().await;
        }
        self.clock.set(self.clock.get().max(self.m.k.now()));
    }

    /// While no processor is ready the offer only circles. When one becomes ready, the circle then
    /// under way is gone through again from its start, so that the offer reaches the processor when
    /// it would have; until now everybody was busy.
    async fn sleep_while_all_busy(&self) {
        let row = &self.m.row0;
        let since = self.clock.get();
        let circle = since.saturating_sub(row.offered[0].get());
        let circled = self.m.columns > 1 && circle > 0 && row.all_passed.get();
        if row.ready.iter().any(Cell::get) || !(circled || self.m.columns == 1) {
            return;
        }
        while !row.ready.iter().any(Cell::get) {
            row.sleeping_offer.set(Some(self.task));
            self.m.k.suspend().await;
        }
        let now = self.m.k.now();
        if self.m.columns == 1 {
            self.clock.set(since.max(now));
            return;
        }
        let whole_circles = now.saturating_sub(since) / circle * circle;
        self.clock.set(since + whole_circles);
        row.busy_until.set(now);
    }
}
