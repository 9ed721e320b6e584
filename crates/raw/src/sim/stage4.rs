//! The program of a stage-4 tile and its interrupt handler: compositing under the token.
//!
//! Source: RAW, section 3.3.3 and the stage-4 listing.

use std::cell::RefCell;
use std::rc::Rc;

use super::charges;
use super::cost::Burst;
use super::machine::{Machine, PixelMessage, Tile, Wait};
use super::texturing::Texturing;
use crate::color;
use crate::stage::composite::Outcome;
use crate::stage::{Fragment, composite};
use crate::state::{ModeBits, PrimInfo};

/// The interrupt handler of a column: keeps the token when the program wants it, else passes it on.
pub async fn handler(m: Rc<Machine>, column: usize) {
    let post = m.token(0, column);
    loop {
        match post.incoming.get().filter(|(at, _)| *at <= m.k.now()) {
            None => {
                if let Some((at, _)) = post.incoming.get() {
                    m.k.wake(post.handler.get(), at);
                }
                m.k.suspend().await;
            }
            Some((_, value)) => {
                post.incoming.set(None);
                let tile = m.tile(3, column);
                if post.wanted.replace(false) {
                    post.granted.set(Some(value));
                    m.k.wake(tile.task.get(), m.k.now());
                } else {
                    if !m.options.early_release {
                        // Before the late fix this time counted as active.
                        m.account(tile, 100 * u64::from(m.costs.interrupt));
                    }
                    // The handler takes its time from whatever the program is busy with.
                    if tile.clock.get() > m.k.now() {
                        tile.clock.set(tile.clock.get() + u64::from(m.costs.interrupt));
                    }
                    m.pass_token(column, value);
                }
            }
        }
    }
}

struct Stage4 {
    m: Rc<Machine>,
    column: usize,
    mode: ModeBits,
    seq: u32,
    line: DepthLine,
    /// For the fragments that this tile textures.
    texturing: RefCell<Texturing>,
}

/// What a wait for input or token ended with.
enum Arrival {
    Input,
    Token(u32),
}

/// Runs a stage-4 tile for good.
pub async fn run(m: Rc<Machine>, column: usize) {
    let mode = ModeBits::default();
    let texturing = RefCell::new(Texturing::new(&m, 3, column));
    let mut tile = Stage4 { m, column, mode, seq: 0, line: DepthLine::default(), texturing };
    loop {
        match tile.receive().await {
            PixelMessage::Flush(from) => {
                tile.texturing.borrow_mut().forget_table();
                answer_flush(&tile.m, column, from).await;
            }
            PixelMessage::Prim(info, ticket) => {
                // The thesis's number, which a count of finished primitives is compared with.
                (tile.mode, tile.seq) = (info.mode, ticket.number as u32);
                tile.begin(info);
                tile.primitive().await;
            }
            // Fragments and ends are read inside a primitive.
            PixelMessage::Frag(_) | PixelMessage::Later(_) | PixelMessage::End => {}
        }
    }
}

impl Stage4 {
    fn tile(&self) -> &Tile {
        self.m.tile(3, self.column)
    }

    fn begin(&self, info: PrimInfo) {
        if self.m.options.shared_texturing {
            self.texturing.borrow_mut().begin(info);
        }
    }

    async fn receive(&self) -> PixelMessage {
        let above = self.m.tile_number(2, self.column);
        self.m.receive(self.tile(), &self.m.pixels[self.column], Wait::Words(above)).await
    }

    /// The next fragment of the primitive, or `None` at its end.
    async fn fragment(&self) -> Option<Fragment> {
        match self.receive().await {
            PixelMessage::Frag(fragment) => {
                self.m.work(self.tile(), self.m.costs.s4.buffer);
                Some(fragment)
            }
            PixelMessage::Later(fragment) => {
                self.m.work(self.tile(), self.m.costs.s4.buffer);
                Some(self.texturing.borrow_mut().finish(&fragment))
            }
            _ => None,
        }
    }

    async fn primitive(&mut self) {
        match self.fragment().await {
            None => {
                let value = self.token(true).await;
                self.give(value.wrapping_add(1)).await;
            }
            Some(first) if self.mode.out_of_order() == 1 => self.unordered(first).await,
            Some(first) => self.ordered(first).await,
        }
    }

    async fn ordered(&mut self, first: Fragment) {
        let mut next = Some(first);
        // Buffering while waiting is an improvement the thesis suggests.
        let room = if self.m.options.buffer_ordered { self.m.costs.s4.buffered } else { 1 };
        let mut buffer = Vec::with_capacity(room);
        while let Some(fragment) = next.take().filter(|_| buffer.len() < room) {
            buffer.push(fragment);
            if buffer.len() < room {
                next = self.fragment().await;
                if next.is_none() {
                    break;
                }
            }
        }
        let ended = buffer.len() < room;
        let value = self.token(false).await;
        buffer.iter().for_each(|f| self.draw(f));
        if !ended {
            while let Some(fragment) = self.fragment().await {
                self.draw(&fragment);
            }
        }
        self.give(value.wrapping_add(1)).await;
    }

    async fn unordered(&mut self, first: Fragment) {
        let mut next = Some(first);
        let mut buffer = Vec::with_capacity(self.m.costs.s4.buffered);
        while let Some(fragment) = next {
            buffer.clear();
            buffer.extend(Some(fragment).filter(visible));
            let (token, ended) = self.fill(&mut buffer).await;
            let value = match token {
                Some(value) => value,
                None => self.wait_token(true).await,
            };
            buffer.iter().for_each(|f| self.draw(f));
            self.give(value.wrapping_add(u32::from(ended))).await;
            next = if ended { None } else { self.fragment().await };
            if !ended && next.is_none() {
                // The end came after the token was given up: catch it once more.
                let value = self.token(true).await;
                self.give(value.wrapping_add(1)).await;
            }
        }
    }

    /// Buffers fragments until the buffer is full, the primitive ends or the token can be used.
    /// Returns the token if it came, and whether the primitive has ended.
    async fn fill(&self, buffer: &mut Vec<Fragment>) -> (Option<u32>, bool) {
        self.want().await;
        while buffer.len() < self.m.costs.s4.buffered {
            match self.input_or_token(!buffer.is_empty()).await {
                Arrival::Token(value) => return (Some(value), false),
                Arrival::Input => match self.fragment().await {
                    None => return (None, true),
                    Some(fragment) => buffer.extend(Some(fragment).filter(visible)),
                },
            }
        }
        (None, false)
    }

    /// Waits for a word from above; accepts the token meanwhile if `usable` and its value allows.
    async fn input_or_token(&self, usable: bool) -> Arrival {
        let (tile, link) = (self.tile(), &self.m.pixels[self.column]);
        if link.next_word().is_some_and(|at| at <= tile.clock.get()) {
            return Arrival::Input;
        }
        tile.wait.set(Wait::Words(self.m.tile_number(2, self.column)));
        loop {
            self.m.catch_up(tile).await;
            if let Some(value) = self.m.token(0, self.column).granted.take() {
                if usable && value >= self.seq {
                    tile.wait.set(Wait::Nothing);
                    return Arrival::Token(value);
                }
                self.hand_on(value).await;
            }
            match link.next_word() {
                Some(at) if at <= self.m.k.now() => {
                    tile.wait.set(Wait::Nothing);
                    return Arrival::Input;
                }
                Some(at) => self.m.k.wake(tile.task.get(), at),
                None => link.notify(tile.task.get()),
            }
            self.m.k.suspend().await;
            tile.clock.set(tile.clock.get().max(self.m.k.now()));
        }
    }

    /// Asks the handler to keep the token when it comes.
    async fn want(&self) {
        self.m.catch_up(self.tile()).await;
        self.m.token(0, self.column).wanted.set(true);
    }

    async fn hand_on(&self, value: u32) {
        self.m.pass_token(self.column, value);
        self.m.token(0, self.column).wanted.set(true);
    }

    /// Asks for the token and waits for it.
    async fn token(&self, or_later: bool) -> u32 {
        self.want().await;
        self.wait_token(or_later).await
    }

    /// Waits until the token has this primitive's number, or a later one.
    async fn wait_token(&self, or_later: bool) -> u32 {
        let tile = self.tile();
        tile.wait.set(Wait::Token(self.seq));
        loop {
            self.m.catch_up(tile).await;
            if let Some(value) = self.m.token(0, self.column).granted.take() {
                if value == self.seq || (or_later && value > self.seq) {
                    tile.wait.set(Wait::Nothing);
                    return value;
                }
                self.hand_on(value).await;
            }
            self.m.k.suspend().await;
            tile.clock.set(tile.clock.get().max(self.m.k.now()));
        }
    }

    /// Passes the token on.
    async fn give(&mut self, value: u32) {
        self.line.forget();
        self.m.work(self.tile(), Burst::new(self.m.costs.s4.hand_over, 0));
        self.m.catch_up(self.tile()).await;
        self.m.pass_token(self.column, value);
    }

    /// Draws a fragment; the token is held.
    fn draw(&mut self, fragment: &Fragment) {
        if visible(fragment) {
            draw(&self.m, (self.column, 0), self.mode, fragment, &mut self.line);
        }
    }
}

/// Tells who asked that this column is empty.
pub async fn answer_flush(m: &Machine, column: usize, from: usize) {
    m.catch_up(m.tile(3, column)).await;
    m.post(m.k.now(), (3, column), (0, from), 0);
}

/// The line of depths that a tile has fetched, where bursts share one invalidation.
#[derive(Clone, Copy, Debug, Default)]
pub struct DepthLine(Option<u64>);

impl DepthLine {
    /// Drops it: the next depth is fetched.
    pub fn forget(&mut self) {
        self.0 = None;
    }

    /// Fetches the line of a depth through the port of its bank. Every depth is invalidated before
    /// it is read, unless a burst shares one invalidation.
    pub fn fetch(&mut self, m: &Machine, tile: &Tile, bank: usize, address: u64) {
        let line = address / super::cache::LINE_WORDS;
        if !(m.options.z_once_per_burst && self.0 == Some(line)) {
            m.fetch_line(tile, 3 + bank, m.costs.s4.z_miss);
        }
        self.0 = Some(line);
    }
}

/// Draws a fragment on the tile of a column, for a bank whose token is held.
pub fn draw(
    m: &Machine,
    (column, bank): (usize, usize),
    mode: ModeBits,
    fragment: &Fragment,
    line: &mut DepthLine,
) {
    let tile = m.tile(3, column);
    let (outcome, address) = {
        let mut core = m.core.borrow_mut();
        let errata = core.config.errata;
        let outcome = composite::process_at_pixel(&mut core.target, mode, fragment, &errata);
        (outcome, core.target.frame.address(fragment.x, fragment.y))
    };
    m.work(tile, m.costs.s4.pixel);
    let read = m.options.read_by_tile(&outcome);
    charges::composite(&m.costs, &Outcome { page_reads: read, ..outcome }, |burst| {
        m.work(tile, burst);
    });
    if outcome.tested {
        line.fetch(m, tile, bank, address);
    }
    m.work(tile, Burst::new(m.costs.s4.round_trip * read, 0));
    send_pixels(m, tile, (bank, column), &outcome);
    m.count(|c| c.pixels += u64::from(outcome.page_writes));
}

/// Words of a message to the frame-buffer controller: header, address, colour.
const PIXEL_WORDS: u64 = 3;
/// Cycles the controller takes to read a pixel and to mix it with another.
const MIX_CYCLES: u64 = 2;
/// Cycles of work that may wait at a port of the controller before senders are held up.
const PORT_QUEUE: u64 = 16;

/// Sends the writes of a fragment to the controller's port for a bank. The controller takes a cycle
/// for a word and one for an access, and where it blends itself, one for reading and one for mixing; a sender that is too fast for it, or for the network, waits.
pub fn send_pixels(m: &Machine, tile: &Tile, (bank, column): (usize, usize), outcome: &Outcome) {
    let port = bank * m.columns / m.banks;
    let mixes = m.options.blend_in_controller && outcome.page_reads > 0;
    let accesses = PIXEL_WORDS + if mixes { MIX_CYCLES } else { 0 };
    for _ in 0..outcome.page_writes {
        let sent = tile.clock.get();
        let arrival = m.gdn.send(sent, (3, column), (4, port), PIXEL_WORDS);
        let busy = &m.controllers[bank];
        busy.set(busy.get().max(arrival) + accesses);
        let held_up = busy.get().saturating_sub(arrival + accesses + PORT_QUEUE);
        // What the network alone delays shows once its queues are full, too.
        let late = arrival.saturating_sub(sent + PORT_QUEUE + 2 * m.columns as u64);
        tile.clock.set(sent + held_up.max(late));
    }
}

/// Whether a fragment is drawn at all.
pub fn visible(fragment: &Fragment) -> bool {
    color::low(fragment.rgba) != 0
}
