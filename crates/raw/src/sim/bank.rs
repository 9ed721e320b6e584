//! Stage 4 with a banked frame buffer, or with the overlap test: banks that are lent.
//!
//! Beyond the thesis (RAW, chapter 6). Pixels are spread over the banks line by line of the depth
//! cache; each bank has its own memory port and its own port of the frame buffer, so that as many
//! tiles draw at once as there are banks. At its port sits an arbiter that lends the bank to one
//! tile at a time, and knows which primitives are finished there: instead of a token that circles,
//! a tile asks, is answered, and gives back. A tile keeps fragments by bank, and draws those of a
//! bank while it has it.

use std::cell::{Cell, RefCell};
use std::collections::VecDeque;
use std::rc::Rc;

use super::cache::LINE_WORDS;
use super::kernel::TaskId;
use super::machine::{Machine, PixelMessage, Tile, Wait};
use super::stage4::{self, DepthLine, visible};
use super::texturing::Texturing;
use super::ticket::Ticket;
use crate::stage::Fragment;
use crate::state::ModeBits;

/// Words of a message to or from an arbiter: header, and what it says.
const REQUEST_WORDS: u64 = 3;

/// What a tile has of a bank.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Loan {
    /// Nothing.
    #[default]
    None,
    /// It has asked for it.
    Asked,
    /// It has it from that cycle on.
    From(u64),
}

/// A message to an arbiter.
#[derive(Clone, Copy, Debug)]
enum Letter {
    /// A column asks for the bank.
    Request(usize, Ticket),
    /// The bank is given back.
    Return,
    /// A primitive is finished in this bank.
    Finished(u64),
}

/// Lends a bank to one tile at a time.
pub struct Arbiter {
    letters: RefCell<VecDeque<(u64, Letter)>>,
    /// The arbiter's task.
    pub task: Cell<TaskId>,
}

impl Default for Arbiter {
    fn default() -> Self {
        Self { letters: RefCell::default(), task: Cell::new(usize::MAX) }
    }
}

impl Arbiter {
    /// Forgets everything.
    pub fn clear(&self) {
        self.letters.borrow_mut().clear();
    }
}

/// Where the port of a bank is.
fn port(m: &Machine, bank: usize) -> (usize, usize) {
    (4, bank * m.columns / m.banks)
}

/// Sends a message from a tile of row 3 to an arbiter at the tile's cycle.
fn tell(m: &Machine, column: usize, bank: usize, letter: Letter) {
    let tile = m.tile(3, column);
    m.work(tile, m.costs.s4.ask);
    let at = m.gdn.send(tile.clock.get(), (3, column), port(m, bank), REQUEST_WORDS);
    let arbiter = &m.arbiters[bank];
    arbiter.letters.borrow_mut().push_back((at, letter));
    m.k.wake(arbiter.task.get(), at);
}

/// Runs the arbiter of a bank for good.
pub async fn arbiter(m: Rc<Machine>, bank: usize) {
    let own = &m.arbiters[bank];
    let (mut lent, mut requests) = (false, VecDeque::new());
    loop {
        let mut next = u64::MAX;
        own.letters.borrow_mut().retain(|(at, letter)| {
            if *at > m.k.now() {
                next = next.min(*at);
                return true;
            }
            match letter {
                Letter::Request(column, ticket) => requests.push_back((*column, *ticket)),
                Letter::Return => lent = false,
                Letter::Finished(number) => m.progress[bank].finish(*number),
            }
            false
        });
        let admitted = |(_, ticket): &(usize, Ticket)| m.progress[bank].admits(*ticket);
        if let Some(place) = requests.iter().position(admitted).filter(|_| !lent)
            && let Some((column, _)) = requests.remove(place)
        {
            lent = true;
            let at = m.gdn.send(m.k.now(), port(&m, bank), (3, column), REQUEST_WORDS);
            m.token(bank, column).loan.set(Loan::From(at));
            m.k.wake(m.tile(3, column).task.get(), at);
        }
        if next != u64::MAX {
            m.k.wake(own.task.get(), next);
        }
        m.k.suspend().await;
    }
}

struct Banked {
    m: Rc<Machine>,
    column: usize,
    mode: ModeBits,
    ticket: Ticket,
    /// Fragments waiting, by bank.
    waiting: Vec<VecDeque<Fragment>>,
    /// Banks in which the primitive is not finished.
    open: Vec<bool>,
    /// A fragment whose bank has no room.
    held_back: Option<Fragment>,
    /// The primitive has been read to its end.
    ended: bool,
    line: DepthLine,
    /// For the fragments that this tile textures.
    texturing: Texturing,
}

/// What a wait ended with.
enum Event {
    Input,
    Bank(usize),
}

/// Runs a stage-4 tile for good.
pub async fn run(m: Rc<Machine>, column: usize) {
    let mut tile = Banked {
        column,
        mode: ModeBits::default(),
        ticket: Ticket::default(),
        waiting: vec![VecDeque::new(); m.banks],
        open: vec![false; m.banks],
        held_back: None,
        ended: true,
        line: DepthLine::default(),
        texturing: Texturing::new(&m, 3, column),
        m,
    };
    loop {
        match tile.receive().await {
            PixelMessage::Flush(from) => {
                tile.texturing.forget_table();
                stage4::answer_flush(&tile.m, column, from).await;
            }
            PixelMessage::Prim(info, ticket) => {
                (tile.mode, tile.ticket) = (info.mode, ticket);
                if tile.m.options.shared_texturing {
                    tile.texturing.begin(info);
                }
                tile.primitive().await;
            }
            // Fragments and ends are read inside a primitive.
            PixelMessage::Frag(_) | PixelMessage::Later(_) | PixelMessage::End => {}
        }
    }
}

impl Banked {
    fn tile(&self) -> &Tile {
        self.m.tile(3, self.column)
    }

    async fn receive(&self) -> PixelMessage {
        let above = self.m.tile_number(2, self.column);
        self.m.receive(self.tile(), &self.m.pixels[self.column], Wait::Words(above)).await
    }

    /// Draws a primitive: fragments are read as they come, and drawn as banks are lent.
    async fn primitive(&mut self) {
        self.ended = false;
        self.open.fill(true);
        while self.open.contains(&true) {
            match self.next().await {
                Event::Bank(bank) => self.draw(bank).await,
                Event::Input => self.read().await,
            }
        }
    }

    /// Whether words from above may be read.
    fn reads(&self) -> bool {
        !self.ended && self.held_back.is_none()
    }

    /// Reads one message of the primitive.
    async fn read(&mut self) {
        match self.receive().await {
            PixelMessage::Frag(fragment) => self.take(fragment),
            PixelMessage::Later(fragment) => {
                let fragment = self.texturing.finish(&fragment);
                self.take(fragment);
            }
            _ => {
                self.ended = true;
                // A bank with nothing to draw need not be asked for.
                (0..self.m.banks).for_each(|bank| self.close_if_done(bank));
            }
        }
    }

    fn take(&mut self, fragment: Fragment) {
        self.m.work(self.tile(), self.m.costs.s4.buffer);
        if visible(&fragment) {
            self.keep(fragment);
        }
    }

    fn keep(&mut self, fragment: Fragment) {
        let bank = self.m.bank_of(&fragment);
        if self.waiting[bank].len() < self.m.costs.s4.buffered {
            self.waiting[bank].push_back(fragment);
        } else {
            self.held_back = Some(fragment);
        }
        self.want(bank);
    }

    /// Asks for a bank.
    fn want(&self, bank: usize) {
        let loan = &self.m.token(bank, self.column).loan;
        if loan.get() == Loan::None {
            loan.set(Loan::Asked);
            tell(&self.m, self.column, bank, Letter::Request(self.column, self.ticket));
        }
    }

    /// Notes that the primitive is finished in a bank, if it is.
    fn close_if_done(&mut self, bank: usize) {
        let idle = self.m.token(bank, self.column).loan.get() == Loan::None;
        if self.ended && self.open[bank] && idle && self.waiting[bank].is_empty() {
            self.open[bank] = false;
            tell(&self.m, self.column, bank, Letter::Finished(self.ticket.number));
        }
    }

    /// The bank that this tile has by a cycle, if any; else when it will.
    fn loan(&self, now: u64) -> (Option<usize>, u64) {
        let mut soon = u64::MAX;
        for bank in 0..self.m.banks {
            match self.m.token(bank, self.column).loan.get() {
                Loan::From(at) if at <= now => return (Some(bank), at),
                Loan::From(at) => soon = soon.min(at),
                Loan::None | Loan::Asked => {}
            }
        }
        (None, soon)
    }

    /// Waits for a bank, or for a word from above.
    async fn next(&self) -> Event {
        let (tile, link) = (self.tile(), &self.m.pixels[self.column]);
        tile.wait.set(Wait::Token(self.ticket.after as u32));
        loop {
            self.m.catch_up(tile).await;
            let (bank, soon) = self.loan(self.m.k.now());
            let event = match bank {
                Some(bank) => Some(Event::Bank(bank)),
                None => self.input_by(self.m.k.now()).then_some(Event::Input),
            };
            if let Some(event) = event {
                tile.wait.set(Wait::Nothing);
                return event;
            }
            if soon != u64::MAX {
                self.m.k.wake(tile.task.get(), soon);
            }
            match link.next_word().filter(|_| self.reads()) {
                Some(at) => self.m.k.wake(tile.task.get(), at),
                None => link.notify(tile.task.get()),
            }
            self.m.k.suspend().await;
            tile.clock.set(tile.clock.get().max(self.m.k.now()));
        }
    }

    /// Whether there is a word to read at a cycle.
    fn input_by(&self, cycle: u64) -> bool {
        self.reads() && self.m.pixels[self.column].next_word().is_some_and(|at| at <= cycle)
    }

    /// Draws fragments of a bank that this tile has, while reading what comes meanwhile, and gives
    /// it back.
    async fn draw(&mut self, bank: usize) {
        let m = Rc::clone(&self.m);
        let tile = m.tile(3, self.column);
        for _ in 0..m.costs.s4.buffered {
            let Some(fragment) = self.waiting[bank].pop_front() else { break };
            // Other banks are at work on the same network.
            m.catch_up(tile).await;
            stage4::draw(&m, (self.column, bank), self.mode, &fragment, &mut self.line);
            if let Some(fragment) = self.held_back.take() {
                self.keep(fragment);
            }
            while self.input_by(tile.clock.get()) {
                self.read().await;
            }
        }
        self.line.forget();
        m.catch_up(tile).await;
        tell(&m, self.column, bank, Letter::Return);
        m.token(bank, self.column).loan.set(Loan::None);
        if self.waiting[bank].is_empty() {
            self.close_if_done(bank);
        } else {
            self.want(bank);
        }
    }
}

/// Which bank of `banks` a word address belongs to: line by line.
pub fn of_address(address: u64, banks: usize) -> usize {
    (address / LINE_WORDS % banks as u64) as usize
}
