//! Stage 4 as a pipeline of four tiles: depth read, depth write, blend, frame-buffer write.
//!
//! Beyond the thesis (RAW, chapter 6). The first tile takes fragments of all columns as the order
//! allows, so no token is needed; with a banked frame buffer every four columns make up a pipeline
//! of their own, which owns a bank.

use std::rc::Rc;

use super::cost::Burst;
use super::link::Link;
use super::machine::{Machine, PixelMessage, Tile, Wait};
use super::stage4::{self, DepthLine, visible};
use super::ticket::Ticket;
use crate::stage::composite::Outcome;
use crate::stage::{Fragment, composite};
use crate::state::ModeBits;

/// Tiles in a pipeline.
pub const STEPS: usize = 4;
/// Words of a fragment between steps: address, colour, depth.
const STEP_WORDS: u32 = 3;

/// From step to step.
pub enum StepMessage {
    /// A fragment: what happens to it.
    Pixel(Outcome),
    /// A flush marker: the column it came by, and the one that asked.
    Flush(usize, usize),
}

/// A column as the first tile of a pipeline sees it.
#[derive(Clone, Copy, Default)]
struct Lane {
    mode: Option<(ModeBits, Ticket)>,
    next: Option<Fragment>,
}

struct Head {
    m: Rc<Machine>,
    pipe: usize,
    lanes: Vec<Lane>,
    turn: usize,
    line: DepthLine,
}

/// Runs the first tile of a pipeline for good.
pub async fn head(m: Rc<Machine>, pipe: usize) {
    let lanes = vec![Lane::default(); m.columns];
    let mut head = Head { m, pipe, lanes, turn: 0, line: DepthLine::default() };
    loop {
        head.step().await;
    }
}

impl Head {
    fn tile(&self) -> &Tile {
        self.m.tile(3, STEPS * self.pipe)
    }

    fn link(&self, column: usize) -> &Link<PixelMessage> {
        &self.m.lanes[self.pipe * self.m.columns + column]
    }

    /// Takes the next thing that can be done, columns in turn.
    async fn step(&mut self) {
        let column = self.choose().await;
        self.turn = column + 1;
        if let Some(fragment) = self.lanes[column].next.take() {
            self.draw(column, &fragment).await;
            return;
        }
        let link = self.link(column);
        let above = self.m.tile_number(2, column);
        let message = self.m.receive(self.tile(), link, Wait::Words(above)).await;
        match message {
            PixelMessage::Prim(info, ticket) => {
                self.lanes[column].mode = Some((info.mode, ticket));
            }
            PixelMessage::Frag(fragment) if visible(&fragment) => {
                self.lanes[column].next = Some(fragment);
            }
            // Pipelines are sent nothing to texture.
            PixelMessage::Frag(_) | PixelMessage::Later(_) => {}
            PixelMessage::End => {
                if let Some((_, ticket)) = self.lanes[column].mode.take() {
                    self.m.progress[self.pipe].finish(ticket.number);
                }
                self.line.forget();
            }
            PixelMessage::Flush(from) => self.pass(StepMessage::Flush(column, from), 2).await,
        }
    }

    /// The next column with a fragment that may be drawn, or with a word to read.
    async fn choose(&self) -> usize {
        let (m, tile) = (&self.m, self.tile());
        loop {
            m.catch_up(tile).await;
            let now = m.k.now();
            let mut waits_for = None;
            for offset in 0..m.columns {
                let column = (self.turn + offset) % m.columns;
                let lane = &self.lanes[column];
                match (lane.next, lane.mode) {
                    (Some(_), Some((_, ticket))) => {
                        if m.progress[self.pipe].admits(ticket) {
                            return column;
                        }
                        waits_for = Some(Wait::Token(ticket.after as u32));
                    }
                    _ => match self.link(column).next_word() {
                        Some(at) if at <= now => return column,
                        Some(at) => m.k.wake(tile.task.get(), at),
                        None => self.link(column).notify(tile.task.get()),
                    },
                }
            }
            tile.wait.set(waits_for.unwrap_or(Wait::Commands));
            m.k.suspend().await;
            tile.clock.set(tile.clock.get().max(m.k.now()));
            tile.wait.set(Wait::Nothing);
        }
    }

    /// Tests a fragment, and sends it down the steps if it is drawn.
    async fn draw(&mut self, column: usize, fragment: &Fragment) {
        let Some((mode, _)) = self.lanes[column].mode else { return };
        let m = Rc::clone(&self.m);
        let (outcome, address) = {
            let mut core = m.core.borrow_mut();
            let errata = core.config.errata;
            let outcome = composite::process_at_pixel(&mut core.target, mode, fragment, &errata);
            (outcome, core.target.frame.address(fragment.x, fragment.y))
        };
        m.work(self.tile(), m.costs.s4.pixel.share(1, STEPS as u32));
        if outcome.tested {
            m.work(self.tile(), m.costs.s4.z_test);
            let tile = m.tile(3, STEPS * self.pipe);
            self.line.fetch(&m, tile, self.pipe, address);
        }
        m.count(|c| c.pixels += u64::from(outcome.page_writes));
        if outcome.drawn {
            self.pass(StepMessage::Pixel(outcome), STEP_WORDS).await;
        }
    }

    async fn pass(&self, message: StepMessage, words: u32) {
        let next = self.m.tile_number(3, STEPS * self.pipe + 1);
        self.m
            .send(self.tile(), &self.m.steps[(STEPS - 1) * self.pipe], next, message, words)
            .await;
    }
}

/// Runs step 1, 2 or 3 of a pipeline for good.
pub async fn step(m: Rc<Machine>, pipe: usize, step: usize) {
    let column = STEPS * pipe + step;
    let (from, links) = (m.tile_number(3, column - 1), (STEPS - 1) * pipe);
    loop {
        let tile = m.tile(3, column);
        let message = m.receive(tile, &m.steps[links + step - 1], Wait::Words(from)).await;
        match (&message, step) {
            (StepMessage::Pixel(outcome), _) => work(&m, tile, (pipe, column), step, outcome).await,
            (StepMessage::Flush(by, from), 3) => flushed(&m, column, *by, *from).await,
            _ => {}
        }
        if step + 1 < STEPS {
            let words = if matches!(message, StepMessage::Pixel(_)) { STEP_WORDS } else { 2 };
            let next = m.tile_number(3, column + 1);
            m.send(tile, &m.steps[links + step], next, message, words).await;
        }
    }
}

/// The share of a step in drawing a fragment.
async fn work(m: &Machine, tile: &Tile, at: (usize, usize), step: usize, outcome: &Outcome) {
    m.work(tile, m.costs.s4.pixel.share(1, STEPS as u32));
    match step {
        1 if outcome.depth_written => m.work(tile, m.costs.s4.z_write),
        2 => {
            let read = m.options.read_by_tile(outcome);
            m.work(tile, m.costs.s4.blend.times(read));
            m.work(tile, Burst::new(m.costs.s4.round_trip * read, 0));
        }
        3 => {
            m.catch_up(tile).await;
            stage4::send_pixels(m, tile, at, outcome);
        }
        _ => {}
    }
}

/// The marker of a column has left a pipeline; when it has left all of them, the column is empty.
async fn flushed(m: &Machine, column: usize, by: usize, from: usize) {
    m.catch_up(m.tile(3, column)).await;
    let seen = &m.markers[by];
    seen.set(seen.get() + 1);
    if seen.get() == m.banks {
        seen.set(0);
        m.post(m.k.now(), (3, column), (0, from), 0);
    }
}
