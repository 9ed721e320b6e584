//! The machine the tasks share: tiles, paths, memories and counters.

use std::cell::{Cell, RefCell};
use std::collections::VecDeque;
use std::rc::Rc;

use super::Options;
use super::bank::{self, Arbiter, Loan};
use super::cost::{Burst, Costs};
use super::gdn::{Gdn, Place};
use super::kernel::{Kernel, TaskId};
use super::link::Link;
use super::meters::Meters;
use super::perf::Counters;
use super::pipe::{STEPS, StepMessage};
use super::ticket::{Progress, Ticket, Tickets};
use crate::device::Core;
use crate::error::StreamError;
use crate::host::HostError;
use crate::stage::{Fragment, TransPrim, UntexFragment};
use crate::state::PrimInfo;

/// From stage 1 to stage 2.
pub enum PrimMessage {
    /// The parts of a transformed primitive, at least one, and its place in the order.
    Prim(Vec<TransPrim>, Ticket),
    /// A flush marker with the column it started from.
    Flush(usize),
}

/// From stage 2 to stage 3.
pub enum FragMessage {
    /// A primitive begins.
    Prim(PrimInfo, Ticket),
    /// A fragment of it.
    Frag(UntexFragment),
    /// A fragment whose values are not divided by w yet.
    Undivided(UntexFragment),
    /// A fragment that stage 2 has textured itself.
    Done(Fragment),
    /// A fragment that stage 4 is to texture.
    Later(UntexFragment),
    /// It ends.
    End,
    /// A flush marker.
    Flush(usize),
}

/// From stage 3 to stage 4.
pub enum PixelMessage {
    /// A primitive begins: state, of which the thesis sends the mode, and place in the order.
    Prim(PrimInfo, Ticket),
    /// A fragment of it.
    Frag(Fragment),
    /// A fragment to be textured here.
    Later(UntexFragment),
    /// It ends.
    End,
    /// A flush marker.
    Flush(usize),
}

/// A word of the command stream and its place there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    /// The word.
    pub value: u32,
    /// Its place in the stream, counted from 0.
    pub offset: u64,
}

impl Word {
    /// A word that does not come from the host: a count of a switch or a go-ahead.
    pub const fn control(value: u32) -> Self {
        Self { value, offset: u64::MAX }
    }
}

/// What the host interface waits for, each with the number of records taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HostWait {
    /// It has work.
    Nothing,
    /// A word from the device.
    Word(u64),
    /// Room for a word to the device.
    Room(u64),
}

/// What a task is waiting for, for the deadlock report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wait {
    /// It has work.
    Nothing,
    /// A word from the tile with that number.
    Words(usize),
    /// A command word from the west.
    Commands,
    /// Room on the way to the tile with that number.
    Room(usize),
    /// The token, with at least or exactly that value.
    Token(u32),
    /// Replies to a flush.
    FlushReplies,
    /// A message from the tile at that row and column.
    Message(Place),
    /// Nothing: it was halted, or hangs as the listing does, for the reason given.
    Forever(&'static str),
}

/// A processor: its clock, its account and what holds it up.
pub struct Tile {
    /// The task of its program.
    pub task: Cell<TaskId>,
    /// Its own time, at or ahead of the queue's.
    pub clock: Cell<u64>,
    /// Active cycles in hundredths.
    pub active: Cell<u64>,
    /// What it waits for.
    pub wait: Cell<Wait>,
}

impl Default for Tile {
    fn default() -> Self {
        Self {
            task: Cell::new(usize::MAX),
            clock: Cell::new(0),
            active: Cell::new(0),
            wait: Cell::new(Wait::Nothing),
        }
    }
}

/// Words that arrive by the dynamic network, each with its cycle.
#[derive(Default)]
pub struct Mailbox {
    /// Arrival cycle and word, in order of sending.
    pub letters: RefCell<VecDeque<(u64, u32)>>,
}

/// The token side of a stage-4 tile: what the interrupt handler and the program share.
pub struct TokenPost {
    /// The program wants the token (`taketurn` in the listing).
    pub wanted: Cell<bool>,
    /// What the tile has of the bank; beyond the thesis.
    pub loan: Cell<Loan>,
    /// The token, when the handler has kept it.
    pub granted: Cell<Option<u32>>,
    /// The token on its way here: arrival after the handler's work, and value.
    pub incoming: Cell<Option<(u64, u32)>>,
    /// The handler's task.
    pub handler: Cell<TaskId>,
}

impl Default for TokenPost {
    fn default() -> Self {
        Self {
            wanted: Cell::new(false),
            loan: Cell::default(),
            granted: Cell::new(None),
            incoming: Cell::new(None),
            handler: Cell::new(usize::MAX),
        }
    }
}

/// Row 0: the switches of stage 1 and their paths.
pub struct Row0 {
    /// From column k to k+1.
    pub east: Vec<Link<Word>>,
    /// From column k+1 to k.
    pub west: Vec<Link<u32>>,
    /// From switch to processor.
    pub to_proc: Vec<Link<Word>>,
    /// From processor to switch.
    pub from_proc: Vec<Link<u32>>,
    /// The processor of that column is ready for a primitive.
    pub ready: Vec<Cell<bool>>,
    /// The column whose switch takes words from the host, for the checks.
    pub active: Cell<Option<usize>>,
    /// Tasks of the switches while a scene is open.
    pub tasks: RefCell<Vec<TaskId>>,
    /// The first switch, asleep because every processor is busy.
    pub sleeping_offer: Cell<Option<TaskId>>,
    /// When each switch was last offered a turn.
    pub offered: Vec<Cell<u64>>,
    /// Since the last offer to the first switch nobody has taken a turn.
    pub all_passed: Cell<bool>,
    /// Until this cycle it is known that no processor was ready.
    pub busy_until: Cell<u64>,
}

impl Row0 {
    /// Empties the paths of the switches and forgets their state.
    pub fn clear(&self) {
        self.east.iter().chain(&self.to_proc).for_each(Link::clear);
        self.west.iter().chain(&self.from_proc).for_each(Link::clear);
        self.all_passed.set(false);
        self.busy_until.set(0);
        self.ready.iter().for_each(|ready| ready.set(true));
        self.active.set(None);
        self.sleeping_offer.set(None);
    }
}

/// Everything.
pub struct Machine {
    /// The event queue.
    pub k: Kernel,
    /// Pipelines.
    pub columns: usize,
    /// The cost table.
    pub costs: Costs,
    /// Switches of the model.
    pub options: Options,
    /// State, textures and buffers.
    pub core: RefCell<Core>,
    /// Tiles, stage by stage.
    pub tiles: Vec<Tile>,
    /// From the host.
    pub host: Link<Word>,
    /// What the host interface waits for.
    pub host_waits: Cell<HostWait>,
    /// Faults in the records.
    pub host_faults: RefCell<Vec<HostError>>,
    /// To the host.
    pub device: Link<u32>,
    /// Stage 1's row.
    pub row0: Row0,
    /// Stage 1 to 2.
    pub prims: Vec<Link<PrimMessage>>,
    /// Stage 2 to 3.
    pub frags: Vec<Link<FragMessage>>,
    /// Stage 3 to 4.
    pub pixels: Vec<Link<PixelMessage>>,
    /// Banks of the frame buffer and of the depths; one in the thesis.
    pub banks: usize,
    /// Tokens of stage 4, bank by bank.
    pub tokens: Vec<TokenPost>,
    /// Who lends the banks; beyond the thesis.
    pub arbiters: Vec<Arbiter>,
    /// What each bank has finished; beyond the thesis.
    pub progress: Vec<Progress>,
    /// Places in the order.
    pub tickets: RefCell<Tickets>,
    /// From stage 3 to the pixel pipelines, pipeline by pipeline; beyond the thesis.
    pub lanes: Vec<Link<PixelMessage>>,
    /// Between the steps of the pixel pipelines.
    pub steps: Vec<Link<StepMessage>>,
    /// Pipelines that a column's flush marker has left.
    pub markers: Vec<Cell<usize>>,
    /// The dynamic network.
    pub gdn: Gdn,
    /// When each port of the frame-buffer controller is free again.
    pub controllers: Vec<Cell<u64>>,
    /// Words that have arrived by the dynamic network for each tile.
    pub mail: Vec<Mailbox>,
    /// When the memory port of each row is free again; stage 4 has one for each bank.
    pub ports: Vec<Cell<u64>>,
    /// Since when the counters count.
    pub meters: Cell<Meters>,
    /// The device was halted for good.
    pub halted: Cell<bool>,
    /// The counters.
    pub counters: RefCell<Counters>,
    /// Faults in the stream.
    pub faults: RefCell<Vec<StreamError>>,
    /// Primitives in the order of their numbers: column and sequence number.
    pub accepted: RefCell<Vec<(usize, u32)>>,
}

impl Machine {
    /// A machine at rest.
    pub fn new(core: Core, costs: Costs, options: Options) -> Rc<Self> {
        let columns = options.columns;
        let banks = options.banks();
        let pipes = if options.uses_pipes() { banks } else { 0 };
        let (room, latency) = (costs.path_words, u64::from(costs.path_latency));
        let words = || (0..columns).map(|_| Link::new(4, 1)).collect::<Vec<_>>();
        let answers = || (0..columns).map(|_| Link::new(4, 1)).collect::<Vec<_>>();
        Rc::new(Self {
            k: Kernel::default(),
            columns,
            core: RefCell::new(core),
            tiles: (0..4 * columns).map(|_| Tile::default()).collect(),
            host: Link::new(4, 1),
            host_waits: Cell::new(HostWait::Nothing),
            host_faults: RefCell::default(),
            device: Link::new(16, 1),
            row0: Row0 {
                east: words(),
                west: answers(),
                to_proc: words(),
                from_proc: answers(),
                ready: (0..columns).map(|_| Cell::new(true)).collect(),
                active: Cell::new(None),
                tasks: RefCell::default(),
                sleeping_offer: Cell::new(None),
                offered: vec![Cell::new(0); columns],
                all_passed: Cell::new(false),
                busy_until: Cell::new(0),
            },
            prims: (0..columns).map(|_| Link::new(room, latency)).collect(),
            // The switch of row 2 lets a fragment in only when the one before has left, so the four
            // places before its processor do not count.
            frags: (0..columns)
                .map(|_| Link::new(room.saturating_sub(4).max(1), latency))
                .collect(),
            pixels: (0..columns).map(|_| Link::new(room, latency)).collect(),
            banks,
            tokens: (0..banks * columns).map(|_| TokenPost::default()).collect(),
            arbiters: (0..banks).map(|_| Arbiter::default()).collect(),
            progress: (0..banks).map(|_| Progress::default()).collect(),
            tickets: RefCell::default(),
            lanes: (0..pipes * columns).map(|_| Link::new(room, latency)).collect(),
            steps: (0..pipes * (STEPS - 1)).map(|_| Link::new(room, latency)).collect(),
            markers: vec![Cell::new(0); columns],
            gdn: Gdn::new(columns, costs.gdn_ends),
            controllers: vec![Cell::new(0); banks],
            mail: (0..4 * columns).map(|_| Mailbox::default()).collect(),
            ports: vec![Cell::new(0); 3 + banks],
            meters: Cell::default(),
            halted: Cell::new(false),
            counters: RefCell::default(),
            faults: RefCell::default(),
            accepted: RefCell::default(),
            costs,
            options,
        })
    }

    /// Ends every task but the host interface and empties all paths.
    pub fn stop_tiles(&self) {
        let handlers = self.tokens.iter().map(|token| token.handler.get());
        let arbiters = self.arbiters.iter().map(|arbiter| arbiter.task.get());
        let tiles = self.tiles.iter().map(|tile| tile.task.get());
        let switches = self.row0.tasks.take();
        let all = tiles.chain(handlers).chain(arbiters).chain(switches);
        // Those that this machine does not have were never started.
        all.filter(|task| *task != usize::MAX).for_each(|task| self.k.kill(task));
        self.host.clear();
        self.device.clear();
        self.row0.clear();
        self.prims.iter().for_each(Link::clear);
        self.frags.iter().for_each(Link::clear);
        self.pixels.iter().chain(&self.lanes).for_each(Link::clear);
        self.steps.iter().for_each(Link::clear);
        self.mail.iter().for_each(|mail| mail.letters.borrow_mut().clear());
        self.markers.iter().for_each(|seen| seen.set(0));
        self.progress.iter().for_each(Progress::restart);
        self.arbiters.iter().for_each(Arbiter::clear);
        *self.tickets.borrow_mut() = Tickets::default();
        for post in &self.tokens {
            post.wanted.set(false);
            post.loan.set(Loan::None);
            post.granted.set(None);
            post.incoming.set(None);
        }
        for tile in &self.tiles {
            tile.clock.set(self.k.now());
            tile.wait.set(Wait::Nothing);
        }
    }

    /// The number of the tile of a stage, 0..=3, in a column.
    pub fn tile_number(&self, stage: usize, column: usize) -> usize {
        stage * self.columns + column
    }

    /// A tile.
    pub fn tile(&self, stage: usize, column: usize) -> &Tile {
        &self.tiles[self.tile_number(stage, column)]
    }

    /// Lets a tile work.
    pub fn work(&self, tile: &Tile, burst: Burst) {
        tile.clock.set(tile.clock.get() + u64::from(burst.cycles));
        self.account(tile, u64::from(burst.cycles) * u64::from(burst.active));
    }

    /// Counts active cycles, in hundredths, without letting time pass.
    pub fn account(&self, tile: &Tile, hundredths: u64) {
        let Meters { perf, scene } = self.meters.get();
        if perf.is_some() && scene.is_some() {
            tile.active.set(tile.active.get() + hundredths);
        }
    }

    /// Lets a tile fetch a line through the memory port of its row.
    pub fn fetch_line(&self, tile: &Tile, row: usize, latency: u32) {
        let start = tile.clock.get().max(self.ports[row].get());
        self.ports[row].set(start + u64::from(self.costs.port));
        tile.clock.set(start + u64::from(latency));
    }

    /// Adds to the counters while counting is on.
    pub fn count(&self, add: impl FnOnce(&mut Counters)) {
        if self.meters.get().perf.is_some() {
            add(&mut self.counters.borrow_mut());
        }
    }

    /// Waits until the queue has reached the tile's clock.
    pub async fn catch_up(&self, tile: &Tile) {
        self.k.catch_up(tile.task.get(), &tile.clock).await;
    }

    /// Receives a packet on a static path; each word costs an active cycle.
    pub async fn receive<T>(&self, tile: &Tile, link: &Link<T>, wait: Wait) -> T {
        tile.wait.set(wait);
        let (packet, words) = link.receive(&self.k, tile.task.get(), &tile.clock).await;
        tile.wait.set(Wait::Nothing);
        self.account(tile, 100 * u64::from(words));
        packet
    }

    /// Sends a packet of `words` words.
    pub async fn send<T>(&self, tile: &Tile, link: &Link<T>, to: usize, packet: T, words: u32) {
        tile.wait.set(Wait::Room(to));
        link.send(&self.k, tile.task.get(), &tile.clock, packet, words).await;
        tile.wait.set(Wait::Nothing);
        self.account(tile, 100 * u64::from(words));
    }

    /// Posts a word to a tile; `at` is the cycle of sending.
    pub fn post(&self, at: u64, from: Place, to: Place, word: u32) {
        let arrival = self.gdn.send(at, from, to, 2);
        let number = self.tile_number(to.0, to.1);
        self.mail[number].letters.borrow_mut().push_back((arrival, word));
        self.k.wake(self.tiles[number].task.get(), arrival);
        self.k.progress();
    }

    /// A word that has arrived at a tile by now.
    pub fn arrived(&self, stage: usize, column: usize) -> Option<u32> {
        let mut letters = self.mail[self.tile_number(stage, column)].letters.borrow_mut();
        letters.front().filter(|(at, _)| *at <= self.k.now())?;
        letters.pop_front().map(|(_, word)| word)
    }

    /// Sets the alarm of a tile for a word that is still on its way.
    pub fn expect_letter(&self, stage: usize, column: usize) {
        let number = self.tile_number(stage, column);
        if let Some((at, _)) = self.mail[number].letters.borrow().front() {
            self.k.wake(self.tiles[number].task.get(), *at);
        }
    }

    /// Waits for a word by the dynamic network.
    pub async fn letter(&self, stage: usize, column: usize, wait: Wait) -> u32 {
        let tile = self.tile(stage, column);
        tile.wait.set(wait);
        loop {
            self.catch_up(tile).await;
            if let Some(word) = self.arrived(stage, column) {
                tile.wait.set(Wait::Nothing);
                return word;
            }
            self.expect_letter(stage, column);
            self.k.suspend().await;
            tile.clock.set(tile.clock.get().max(self.k.now()));
        }
    }

    /// What a column has of a bank; in the thesis its post for the token.
    pub fn token(&self, bank: usize, column: usize) -> &TokenPost {
        &self.tokens[bank * self.columns + column]
    }

    /// Sends the token from a stage-4 tile to the next at the current cycle.
    pub fn pass_token(&self, from: usize, value: u32) {
        let to = (from + 1) % self.columns;
        let handled = u64::from(self.costs.interrupt);
        let arrival = self.gdn.send(self.k.now(), (3, from), (3, to), 2) + handled;
        let post = self.token(0, to);
        post.incoming.set(Some((arrival, value)));
        self.k.wake(post.handler.get(), arrival);
    }

    /// The bank of a fragment.
    pub fn bank_of(&self, fragment: &Fragment) -> usize {
        let address = self.core.borrow().target.frame.address(fragment.x, fragment.y);
        bank::of_address(address, self.banks)
    }

    /// The counters with the active cycles of all tiles so far.
    pub fn counters(&self) -> Counters {
        let mut counters = *self.counters.borrow();
        for (stage, sum) in counters.active.iter_mut().enumerate() {
            *sum = (0..self.columns).map(|c| self.tile(stage, c).active.get()).sum();
        }
        counters
    }

    /// Says who waits for whom.
    pub fn waits(&self) -> String {
        let mut lines = match self.host_waits.get() {
            HostWait::Nothing => String::new(),
            HostWait::Word(at) => format!("the host, after record {at}, waits for a word\n"),
            HostWait::Room(at) => {
                format!("the host, after record {at}, waits for room on the way to tile 0\n")
            }
        };
        for (number, tile) in self.tiles.iter().enumerate() {
            let stage = number / self.columns + 1;
            let text = match tile.wait.get() {
                Wait::Nothing => continue,
                Wait::Words(from) => format!("a word from tile {from}"),
                Wait::Commands => "a command word from the west".to_owned(),
                Wait::Room(to) => format!("room on the way to tile {to}"),
                Wait::Token(value) => format!("the token to reach {value}"),
                Wait::FlushReplies => "replies to its flush".to_owned(),
                Wait::Message((row, column)) => {
                    format!("a message from tile {}", self.tile_number(row, column))
                }
                Wait::Forever(why) => {
                    lines += &format!("tile {number} (stage {stage}) {why}\n");
                    continue;
                }
            };
            lines += &format!("tile {number} (stage {stage}) waits for {text}\n");
        }
        lines + &self.token_is()
    }

    /// Where the token is and what it says; nothing where order is kept in another way.
    fn token_is(&self) -> String {
        let mut text = String::new();
        for (column, post) in self.tokens.iter().take(self.columns).enumerate() {
            let tile = self.tile_number(3, column);
            if let Some((_, value)) = post.incoming.get() {
                text += &format!("the token, at {value}, is on its way to tile {tile}\n");
            }
            if let Some(value) = post.granted.get() {
                text += &format!("tile {tile} has the token, at {value}\n");
            }
        }
        for (bank, progress) in self.progress.iter().enumerate() {
            if self.options.uses_tickets() {
                text += &format!("bank {bank} has finished what is before {}\n", progress.low());
            }
        }
        text
    }
}
