//! Order without counting: which primitives are finished, and which one waits for which.
//!
//! The token of the thesis counts finished primitives, so an ordered one waits for all before it.
//! With the overlap test (RAW, chapter 6) it waits only for those it overlaps; then the token has to
//! say which are finished, not only how many.

use std::cell::{Cell, RefCell};
use std::collections::{BTreeSet, VecDeque};

use crate::stage::{Shape, TransPrim};

/// A primitive's place in the order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Ticket {
    /// Its number in the order of arrival, from 1.
    pub number: u64,
    /// It may be drawn when all primitives with smaller numbers are finished.
    pub after: u64,
}

/// Which primitives are finished, for one bank of pixels.
#[derive(Debug)]
pub struct Progress {
    low: Cell<u64>,
    done: RefCell<BTreeSet<u64>>,
}

impl Default for Progress {
    fn default() -> Self {
        Self { low: Cell::new(1), done: RefCell::default() }
    }
}

impl Progress {
    /// The smallest number that is not finished.
    pub fn low(&self) -> u64 {
        self.low.get()
    }

    /// Whether a primitive may be drawn.
    pub fn admits(&self, ticket: Ticket) -> bool {
        self.low.get() >= ticket.after
    }

    /// Back to the beginning.
    pub fn restart(&self) {
        self.low.set(1);
        self.done.borrow_mut().clear();
    }

    /// Notes that a primitive is finished.
    pub fn finish(&self, number: u64) {
        let mut done = self.done.borrow_mut();
        done.insert(number);
        while done.remove(&self.low.get()) {
            self.low.set(self.low.get() + 1);
        }
    }
}

/// The screen rectangle of a primitive, in normalised coordinates; larger than it needs to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    low: [f32; 2],
    high: [f32; 2],
}

/// Room around a primitive for rounding, points and the width of lines.
const MARGIN: f32 = 0.01;

impl Extent {
    /// The rectangle around the visible parts of a primitive; `None` if there are none.
    pub fn of(parts: &[TransPrim]) -> Option<Self> {
        let visible = parts.iter().filter(|part| part.info.mode.draw() == 1);
        let corners = visible.flat_map(|part| {
            let used = match part.shape {
                Shape::Triangle => 3,
                Shape::Line => 2,
                Shape::Point => 1,
            };
            let size = if part.shape == Shape::Point { part.info.point_size as f32 } else { 0.0 };
            part.vertices[..used].iter().map(move |v| ([v.x, v.y], MARGIN * (1.0 + size)))
        });
        corners.fold(None, |extent, (at, room)| Some(Self::grown(extent, at, room)))
    }

    fn grown(extent: Option<Self>, [x, y]: [f32; 2], room: f32) -> Self {
        let old = extent.unwrap_or(Self { low: [f32::INFINITY; 2], high: [f32::NEG_INFINITY; 2] });
        Self {
            low: [old.low[0].min(x - room), old.low[1].min(y - room)],
            high: [old.high[0].max(x + room), old.high[1].max(y + room)],
        }
    }

    /// Whether two rectangles share a point.
    pub fn overlaps(&self, other: &Self) -> bool {
        (0..2).all(|axis| self.low[axis] <= other.high[axis] && other.low[axis] <= self.high[axis])
    }
}

/// A primitive that stage 1 has numbered.
#[derive(Clone, Copy, Debug)]
struct Numbered {
    number: u64,
    extent: Option<Extent>,
    ordered: bool,
}

/// How many earlier primitives are compared with; those before count as overlapping.
pub const WINDOW: usize = 64;

/// Hands out tickets in the order of arrival.
#[derive(Debug, Default)]
pub struct Tickets {
    last: u64,
    /// The number after the last ordered primitive.
    after_ordered: u64,
    window: VecDeque<Numbered>,
}

impl Tickets {
    /// The ticket of the next primitive when ordered ones wait for all before them.
    pub fn next(&mut self, ordered: bool) -> Ticket {
        self.last += 1;
        let number = self.last;
        if ordered {
            self.after_ordered = number + 1;
        }
        Ticket { number, after: if ordered { number } else { self.after_ordered } }
    }

    /// The ticket of the next primitive when it waits only for those it overlaps, where one of the
    /// two is ordered. Also returns how many were compared.
    pub fn next_overlapping(&mut self, ordered: bool, extent: Option<Extent>) -> (Ticket, u32) {
        self.last += 1;
        let number = self.last;
        let meets = |other: &&Numbered| {
            let both = extent.zip(other.extent);
            (ordered || other.ordered) && both.is_some_and(|(a, b)| a.overlaps(&b))
        };
        let compared = self.window.len() as u32;
        let last_met = self.window.iter().rev().find(meets).map_or(0, |other| other.number);
        let forgotten = number.saturating_sub(WINDOW as u64);
        if self.window.len() == WINDOW {
            self.window.pop_front();
        }
        self.window.push_back(Numbered { number, extent, ordered });
        (Ticket { number, after: last_met.max(forgotten.saturating_sub(1)) + 1 }, compared)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn extent(x: f32) -> Option<Extent> {
        Some(Extent { low: [x, 0.0], high: [x + 1.0, 1.0] })
    }

    #[test]
    fn progress_counts_what_is_finished_without_gaps() {
        let progress = Progress::default();
        progress.finish(2);
        assert!(progress.admits(Ticket { number: 1, after: 1 }));
        assert_eq!(progress.low(), 1);
        progress.finish(1);
        assert_eq!(progress.low(), 3);
    }

    #[test]
    fn only_what_overlaps_is_waited_for() {
        let mut tickets = Tickets::default();
        let mut after = |ordered, x| tickets.next_overlapping(ordered, extent(x)).0.after;
        assert_eq!(after(true, 0.0), 1);
        assert_eq!(after(true, 5.0), 1);
        assert_eq!(after(true, 0.5), 2);
        assert_eq!(after(false, 0.7), 4);
        assert_eq!(after(false, 5.5), 3);
        assert_eq!(after(false, 9.0), 1);
        for _ in 0..WINDOW {
            tickets.next_overlapping(false, None);
        }
        assert!(tickets.next_overlapping(true, None).0.after >= 7);
    }

    #[test]
    fn tickets_follow_the_sequence_numbers_of_the_thesis() {
        let mut tickets = Tickets::default();
        let kinds = "OOOIIIOOOOIIOIOIOOOI";
        let after: Vec<u64> = kinds.chars().map(|k| tickets.next(k == 'I').after.max(1)).collect();
        let want = [1, 1, 1, 4, 5, 6, 7, 7, 7, 7, 11, 12, 13, 14, 15, 16, 17, 17, 17, 20];
        assert_eq!(after, want);
    }
}
