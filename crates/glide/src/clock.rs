//! The video side of a board on a clock of its own.
//!
//! The clock counts lines. It moves by a line whenever a program looks at it,
//! and as far as it must where a program waits: for a swap, or for the board
//! to be idle. Nothing sleeps, and the same calls see the same lines on every
//! machine.
//!
//! Source: SST1, status, vRetrace and swapbufferCMD; G22, swapping buffers.

use std::collections::VecDeque;

/// Swaps that may wait before another one has to.
const MAX_PENDING: usize = 7;

/// The beam and the swaps that wait for it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Clock {
    /// Lines that are shown; 0 while the board is closed.
    height: u32,
    /// Lines since the board was opened.
    line: u64,
    /// Line at which each waiting swap is carried out, in order.
    pending: VecDeque<u64>,
    /// Line of the last swap that was queued.
    last_swap: u64,
    swaps_done: u64,
}

impl Clock {
    /// A clock at the first line of a picture of so many.
    pub fn new(height: u32) -> Clock {
        Clock { height, ..Clock::default() }
    }

    /// Lines of a frame: about a tenth of them are retrace.
    fn total(&self) -> u64 {
        u64::from(self.height + self.height / 10 + 1)
    }

    fn advance_to(&mut self, line: u64) {
        self.line = self.line.max(line);
        while self.pending.front().is_some_and(|&due| due <= self.line) {
            self.pending.pop_front();
            self.swaps_done += 1;
        }
    }

    /// Somebody looks: a line passes.
    pub fn look(&mut self) {
        if self.height > 0 {
            self.advance_to(self.line + 1);
        }
    }

    /// Everything queued is carried out.
    pub fn idle(&mut self) {
        if let Some(&last) = self.pending.back() {
            self.advance_to(last);
        }
    }

    /// Queues a swap: at once where `interval` is 0, else at the first retrace
    /// that is at least so many retraces after the previous swap. Waits while
    /// seven others wait.
    pub fn swap(&mut self, interval: u32) {
        if self.height == 0 {
            return;
        }
        if self.pending.len() >= MAX_PENDING {
            self.advance_to(self.pending[self.pending.len() - MAX_PENDING]);
        }
        let earliest = self.line.max(self.last_swap);
        let due = match u64::from(interval) {
            0 => earliest,
            interval => {
                let after = self.retraces_at(self.last_swap) + interval;
                let next = self.retraces_at(earliest) + 1;
                self.start_of_retrace(after.max(next))
            }
        };
        self.last_swap = due;
        self.pending.push_back(due);
        self.advance_to(self.line);
    }

    /// Retraces that have begun by a line.
    fn retraces_at(&self, line: u64) -> u64 {
        (line + self.total() - u64::from(self.height)) / self.total()
    }

    /// The line at which retrace number `count` (from 1) begins.
    fn start_of_retrace(&self, count: u64) -> u64 {
        count * self.total() - (self.total() - u64::from(self.height))
    }

    /// Swaps that wait, 0 to 7.
    pub fn pending(&self) -> u32 {
        self.pending.len() as u32
    }

    /// Swaps carried out since the board was opened.
    pub fn swaps_done(&self) -> u64 {
        self.swaps_done
    }

    /// The line being shown, 0 in retrace.
    pub fn video_line(&self) -> u32 {
        match self.in_retrace() {
            true => 0,
            false => (self.line % self.total()) as u32,
        }
    }

    /// Whether the beam is in vertical retrace.
    pub fn in_retrace(&self) -> bool {
        self.height > 0 && self.line % self.total() >= u64::from(self.height)
    }

    /// Retraces since the board was opened.
    pub fn retraces(&self) -> u32 {
        if self.height == 0 { 0 } else { self.retraces_at(self.line) as u32 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_retrace_take_turns() {
        let mut clock = Clock::new(480);
        let (mut lines, mut retrace) = (0, 0);
        for _ in 0..529 {
            clock.look();
            retrace += u32::from(clock.in_retrace());
            lines += u32::from(clock.video_line() > 0);
        }
        assert_eq!((lines, retrace, clock.retraces()), (479, 49, 1));
    }

    #[test]
    fn swaps_wait_for_their_retrace() {
        let mut clock = Clock::new(480);
        clock.swap(1);
        assert_eq!(clock.pending(), 1);
        while clock.pending() > 0 {
            clock.look();
        }
        assert!(clock.in_retrace());
        assert_eq!((clock.retraces(), clock.swaps_done()), (1, 1));
        clock.swap(3);
        clock.swap(1);
        clock.idle();
        assert_eq!((clock.retraces(), clock.swaps_done()), (5, 3));
        clock.swap(0);
        assert_eq!((clock.pending(), clock.swaps_done()), (0, 4));
    }

    #[test]
    fn seven_swaps_wait_at_most() {
        let mut clock = Clock::new(200);
        for _ in 0..20 {
            clock.swap(2);
            assert!(clock.pending() <= 7);
        }
        assert_eq!(clock.swaps_done(), 13);
    }

    #[test]
    fn a_closed_board_has_no_lines() {
        let mut clock = Clock::default();
        clock.look();
        clock.swap(1);
        clock.idle();
        assert_eq!((clock.video_line(), clock.in_retrace(), clock.pending()), (0, false, 0));
        assert_eq!(clock.retraces(), 0);
    }
}
