//! The program of a stage-1 tile: command mode on tile 0, scenes on all of them.
//!
//! Source: RAW, sections 4.2.2 and 4.2.3.1 and the stage-1 listing.

use std::cell::Cell;
use std::rc::Rc;

use super::boot;
use super::charges;
use super::cost::Burst;
use super::machine::{Machine, PrimMessage, Tile, Wait};
use super::options::EDGE_PARTS;
use super::switch;
use super::texturing::Division;
use super::ticket::{Extent, Ticket};
use crate::device::{MAX_FAULTS, READY, Replies};
use crate::error::StreamError;
use crate::opcode::Opcode;
use crate::stage::raster::{Interpolants, Rasterizer};
use crate::stage::{InputVertex, TransPrim, geometry, ordering};
use crate::state::{RenderState, STATE_WORDS};
use crate::stream::{SceneEvent, SceneReader};

/// The word that ends a scene for the tiles of row 0.
const END_SCENE: u32 = u32::MAX;
/// Words of a primitive on the dynamic network: two messages with headers, tag and 40 words.
const PRIM_WORDS: u32 = 43;
/// Words of a row of covered pixels: its place, its first column and its last.
const ROW_WORDS: u32 = 3;
/// Words of a message beside its header.
const MESSAGE_WORDS: u32 = 31;
/// Words of a further part: two headers, a tag and three vertices.
const PART_WORDS: u32 = 36;

struct Stage1 {
    m: Rc<Machine>,
    column: usize,
    /// This tile's cached copy of the render state.
    state: RenderState,
    /// The place in the stream of the word read last.
    offset: u64,
}

/// What the idle loop found.
enum Work {
    Words,
    Flush(usize),
    EndScene,
}

/// Runs a stage-1 tile for good.
pub async fn run(m: Rc<Machine>, column: usize) {
    let state = m.core.borrow().state.clone();
    let mut tile = Stage1 { m, column, state, offset: 0 };
    boot::tile(&tile.m, 0, column).await;
    if column == 0 {
        tile.reply(READY).await;
    }
    loop {
        if column == 0 {
            tile.command_mode().await;
            tile.enter_scene().await;
        }
        tile.scene().await;
    }
}

impl Stage1 {
    fn tile(&self) -> &Tile {
        self.m.tile(0, self.column)
    }

    async fn reply(&self, word: u32) {
        self.m.send(self.tile(), &self.m.device, 0, word, 1).await;
    }

    async fn host_word(&mut self) -> u32 {
        let word = self.m.receive(self.tile(), &self.m.host, Wait::Commands).await;
        self.m.work(self.tile(), self.m.costs.s1.word);
        self.offset = word.offset;
        word.value
    }

    /// Carries commands out until a scene begins.
    async fn command_mode(&mut self) {
        let mut replies = Replies::default();
        loop {
            let word = self.host_word().await;
            let known = Opcode::in_command_mode(word);
            let known = known.filter(|op| self.m.core.borrow().state.allows(*op));
            let Some(op) = known else {
                let offset = self.offset;
                self.fault(StreamError::Opcode { word, offset, mode: "command" });
                continue;
            };
            self.m.work(self.tile(), self.m.costs.s1.dispatch);
            let mut params = Vec::with_capacity(op.inputs());
            for _ in 0..op.inputs() {
                params.push(self.host_word().await);
            }
            match op {
                Opcode::BeginScene => return,
                Opcode::Halt => {
                    self.m.halted.set(true);
                    self.hang("was halted").await;
                }
                Opcode::Reset => self.reset(),
                _ => {
                    self.check_texture(op, &params);
                    self.m.core.borrow_mut().execute(op, &params, &mut replies);
                }
            }
            self.write_buffers(op);
            let count = op.data_length_at().map_or(0, |at| params[at]);
            let discards = self.m.core.borrow().config.errata.blocks_do_nothing;
            for index in 0..count {
                let word = self.host_word().await;
                self.m.core.borrow_mut().block_word(op, &params, index, word);
                if !discards {
                    self.write_buffers(op.of_one_word());
                }
            }
            while let Some(word) = replies.pop() {
                self.reply(word).await;
            }
        }
    }

    /// Charges for what a command writes to the buffers.
    fn write_buffers(&self, op: Opcode) {
        let screen = self.m.core.borrow().screen();
        let costs = &self.m.costs;
        let pixels = charges::command(costs, op, screen, |burst| self.m.work(self.tile(), burst));
        self.m.count(|c| c.pixels += pixels);
    }

    /// The reset command. The sequence numbers go on: stage 4 does not hear of it.
    fn reset(&self) {
        let mut core = self.m.core.borrow_mut();
        let (next, lagged) = (core.state.prim.seq_num, core.state.lagged_seq_num);
        core.reset();
        (core.state.prim.seq_num, core.state.lagged_seq_num) = (next, lagged);
    }

    /// Does nothing any more.
    async fn hang(&self, why: &'static str) -> ! {
        self.m.catch_up(self.tile()).await;
        self.tile().wait.set(Wait::Forever(why));
        loop {
            self.m.k.suspend().await;
        }
    }

    fn fault(&self, fault: StreamError) {
        let mut faults = self.m.faults.borrow_mut();
        if faults.len() < MAX_FAULTS {
            faults.push(fault);
        }
    }

    fn check_texture(&self, op: Opcode, params: &[u32]) {
        let fault = self.m.core.borrow().texture_fault(op, params, self.offset);
        fault.into_iter().for_each(|fault| self.fault(fault));
    }

    /// Tells the other tiles that the state changed, loads the switches and lets the host go on.
    async fn enter_scene(&mut self) {
        let m = &self.m;
        let everyone = (1u64 << m.columns.min(63)) - 1;
        {
            let mut core = m.core.borrow_mut();
            let hides = core.config.errata.scene_start_hides_state;
            core.state.updated = if hides { 0 } else { everyone & !1 };
            self.state = core.state.clone();
        }
        // Flushing the state and one dummy read of the frame buffer order the writes.
        m.work(self.tile(), Burst::new(STATE_WORDS as u32 * 4, 100));
        m.work(self.tile(), Burst::new(m.costs.s4.round_trip, 0));
        m.catch_up(self.tile()).await;
        m.row0.ready.iter().for_each(|r| r.set(true));
        for column in 0..m.columns {
            let id = Rc::new(Cell::new(0));
            let task = m.k.spawn(Box::pin(switch::run(Rc::clone(m), column, Rc::clone(&id))));
            id.set(task);
            m.row0.tasks.borrow_mut().push(task);
        }
        self.reply(READY).await;
    }

    async fn scene(&mut self) {
        loop {
            match self.idle().await {
                Work::Words => self.primitive().await,
                Work::Flush(from) => self.send_flush(from).await,
                Work::EndScene => break,
            }
        }
        if self.column == 0 {
            self.leave_scene().await;
        }
    }

    /// Back to command mode: the switches are stopped, what is left in the row is dropped.
    async fn leave_scene(&mut self) {
        let row = &self.m.row0;
        for task in row.tasks.take() {
            self.m.k.kill(task);
        }
        row.clear();
        self.reply(READY).await;
    }

    /// Polls for a word from the switch or a message; not counted as active.
    async fn idle(&self) -> Work {
        let (tile, link) = (self.tile(), &self.m.row0.to_proc[self.column]);
        tile.wait.set(Wait::Commands);
        loop {
            self.m.catch_up(tile).await;
            let now = self.m.k.now();
            if let Some(word) = self.m.arrived(0, self.column) {
                tile.wait.set(Wait::Nothing);
                tile.clock.set(now + u64::from(self.m.costs.interrupt));
                return if word == END_SCENE { Work::EndScene } else { Work::Flush(word as usize) };
            }
            match link.next_word() {
                Some(at) if at <= now => {
                    tile.wait.set(Wait::Nothing);
                    return Work::Words;
                }
                Some(at) => self.m.k.wake(tile.task.get(), at),
                None => link.notify(tile.task.get()),
            }
            self.m.expect_letter(0, self.column);
            self.m.k.suspend().await;
        }
    }

    /// Reads a primitive, numbers it, lets the next tile start, and sends it down.
    async fn primitive(&mut self) {
        self.refresh_state();
        let mut reader = SceneReader::default();
        loop {
            let link = &self.m.row0.to_proc[self.column];
            let word = self.m.receive(self.tile(), link, Wait::Commands).await;
            self.m.work(self.tile(), self.m.costs.s1.word);
            let errata = self.m.core.borrow().config.errata;
            self.offset = word.offset;
            match reader.push(word.value, word.offset, &mut self.state, &errata) {
                SceneEvent::More => {}
                SceneEvent::Vertex => self.m.work(self.tile(), self.m.costs.s1.dispatch),
                SceneEvent::State(op) => self.publish(op, reader.last_params()),
                SceneEvent::Primitive(vertices) => return self.accept(&vertices).await,
                SceneEvent::EndScene => return self.end_scene().await,
                SceneEvent::Empty => return self.release().await,
                SceneEvent::Fault(fault) => {
                    let marker = matches!(fault, StreamError::ShortCommand { .. });
                    let hung = matches!(fault, StreamError::Hung { .. });
                    self.fault(fault);
                    if hung {
                        self.hang("hangs: a primitive ended inside a command").await;
                    }
                    if marker {
                        return self.release().await;
                    }
                }
            }
        }
    }

    /// Step 1: looks whether another tile changed the state, and reloads what is stale.
    fn refresh_state(&mut self) {
        let own = 1u64 << self.column.min(63);
        let costs = self.m.costs.s1;
        let stale = {
            let mut core = self.m.core.borrow_mut();
            let stale = core.state.updated & own != 0;
            if stale {
                self.state = core.state.clone();
            }
            self.state.prim.seq_num = core.state.prim.seq_num;
            self.state.lagged_seq_num = core.state.lagged_seq_num;
            core.state.updated &= !own;
            stale
        };
        let words = if stale && !self.m.options.direct_state { STATE_WORDS as u32 } else { 3 };
        self.m.work(self.tile(), costs.invalidate_word.times(words));
        let lines = if words > 3 { costs.state_lines } else { 1 };
        for _ in 0..lines {
            self.m.fetch_line(self.tile(), 0, self.m.costs.miss);
        }
    }

    /// Writes a state change through to memory, for all tiles.
    fn publish(&self, op: Opcode, params: &[u32]) {
        let mut core = self.m.core.borrow_mut();
        let errata = core.config.errata;
        core.state.execute(op, params, &errata);
        core.state.updated = (1u64 << self.m.columns.min(63)) - 1;
        self.m.work(self.tile(), self.m.costs.s1.dispatch);
        if !self.m.options.early_release {
            // Before the late fix every change flushed the whole state.
            let all = self.m.costs.s1.invalidate_word.times(STATE_WORDS as u32);
            self.m.work(self.tile(), all);
        }
    }

    async fn accept(&mut self, vertices: &[InputVertex]) {
        let m = Rc::clone(&self.m);
        let errata = m.core.borrow().config.errata;
        let mut info = self.state.prim;
        let unordered = ordering::is_unordered(info.mode, vertices, &errata);
        let numbered = ordering::number(&mut self.state, unordered, &errata);
        info.seq_num = numbered.seq_num;
        info.mode.set_out_of_order(u32::from(unordered));
        {
            let mut core = m.core.borrow_mut();
            core.state.prim.seq_num = self.state.prim.seq_num;
            core.state.lagged_seq_num = self.state.lagged_seq_num;
        }
        m.accepted.borrow_mut().push((self.column, info.seq_num));
        m.work(self.tile(), m.costs.s1.numbering);
        if numbered.rolled_over && errata.rollover_keeps_lagged {
            self.flush().await;
        }
        let (parts, work) = geometry::process(&mut self.state, info, vertices, &errata);
        let ticket = self.ticket(info.seq_num, unordered, &parts);
        let early = m.options.early_release && !numbered.rolled_over;
        if early && !m.options.overlap_test {
            self.go_ahead().await;
        }
        charges::geometry(&m.costs, &work, |burst| m.work(self.tile(), burst));
        if early && m.options.overlap_test {
            // Where a primitive lies must be known before the next one is numbered.
            self.go_ahead().await;
        }
        m.count(|c| c.drawn_prims += u64::from(work.visible));
        let mut further = (parts.len() as u32 - 1) * PART_WORDS;
        if m.options.setup_in_stage1 && work.visible {
            let needs = Interpolants::of(info.mode);
            for _ in &parts {
                charges::setup(&m.costs, needs, |burst| m.work(self.tile(), burst));
                // Three edges and the planes, three words each, instead of positions.
                further += 3 * needs.planes();
            }
        }
        if work.visible && Division::of(&m.costs, &m.options, &info).walked {
            further += self.walk(&parts);
        }
        let words = m.options.prim_words(info.mode, PRIM_WORDS) + further;
        m.work(self.tile(), m.costs.s1.send_word.times(words));
        let down = m.tile_number(1, self.column);
        let link = &m.prims[self.column];
        m.send(self.tile(), link, down, PrimMessage::Prim(parts, ticket), words).await;
        if numbered.rolled_over && !errata.rollover_keeps_lagged {
            self.flush().await;
        }
        if !early {
            self.go_ahead().await;
        }
        self.ready().await;
    }

    /// Walks the edges of all parts; returns the words that the rows of covered pixels take.
    fn walk(&self, parts: &[TransPrim]) -> u32 {
        let (m, tile) = (&self.m, self.tile());
        let config = m.core.borrow().config;
        let mut words = 0;
        for part in parts.iter().filter(|part| part.info.mode.draw() == 1) {
            let mut walker = Rasterizer::new(part, config.width, config.height, &config.errata);
            let mut rows = None;
            for fragment in walker.by_ref() {
                if rows.replace(fragment.y) != Some(fragment.y) {
                    words += ROW_WORDS;
                }
            }
            let work = walker.take_work();
            charges::walk(&m.costs, work, EDGE_PARTS, |burst| m.work(tile, burst));
        }
        // A message has a header and a tag.
        words + 2 * words.div_ceil(MESSAGE_WORDS - 1)
    }

    /// The place of a primitive in the order: its sequence number, or where stage 4 keeps track of
    /// what is finished, what it has to wait for.
    fn ticket(&self, seq_num: u32, unordered: bool, parts: &[TransPrim]) -> Ticket {
        let (m, mut tickets) = (&self.m, self.m.tickets.borrow_mut());
        if !m.options.uses_tickets() {
            return Ticket { number: u64::from(seq_num), after: u64::from(seq_num) };
        }
        if !m.options.overlap_test {
            return tickets.next(!unordered);
        }
        let (ticket, compared) = tickets.next_overlapping(!unordered, Extent::of(parts));
        m.work(self.tile(), m.costs.s1.compare_extent.times(compared));
        ticket
    }

    /// After a primitive that draws nothing.
    async fn release(&self) {
        self.go_ahead().await;
        self.ready().await;
    }

    async fn go_ahead(&self) {
        self.m.send(self.tile(), &self.m.row0.from_proc[self.column], 0, 1, 1).await;
    }

    /// Tells the switch that the processor can take another primitive.
    async fn ready(&self) {
        self.m.catch_up(self.tile()).await;
        self.m.row0.ready[self.column].set(true);
        if let Some(task) = self.m.row0.sleeping_offer.take() {
            self.m.k.wake(task, self.m.k.now());
        }
    }

    async fn send_flush(&self, from: usize) {
        let down = self.m.tile_number(1, self.column);
        let link = &self.m.prims[self.column];
        self.m.send(self.tile(), link, down, PrimMessage::Flush(from), 3).await;
    }

    /// Empties the pipelines: markers down every column, one reply from each.
    async fn flush(&self) {
        let m = &self.m;
        m.catch_up(self.tile()).await;
        for other in (0..m.columns).filter(|c| *c != self.column) {
            m.post(m.k.now(), (0, self.column), (0, other), self.column as u32);
        }
        self.send_flush(self.column).await;
        self.tile().wait.set(Wait::FlushReplies);
        let mut replies = 0;
        while replies < m.columns {
            m.catch_up(self.tile()).await;
            while m.arrived(0, self.column).is_some() {
                replies += 1;
            }
            if replies < m.columns {
                m.expect_letter(0, self.column);
                m.k.suspend().await;
                self.tile().clock.set(self.tile().clock.get().max(m.k.now()));
            }
        }
        self.tile().wait.set(Wait::Nothing);
    }

    async fn end_scene(&self) {
        self.flush().await;
        for column in 0..self.m.columns {
            self.m.post(self.m.k.now(), (0, self.column), (0, column), END_SCENE);
        }
    }
}
