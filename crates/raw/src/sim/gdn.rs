//! The dynamic network: wormhole messages, first along the row, then along the column.
//!
//! A link carries one word a cycle and is held for a whole message, so messages that cross wait for
//! each other. Each link remembers until when it is taken. Source: RAW, chapter 2 on the chip.

use std::cell::Cell;

/// A place of the grid: row 0 to 3, or 4 for the ports south of it, and column.
pub type Place = (usize, usize);

/// Rows of places, with the southern ports.
const ROWS: usize = 5;

/// Directions of the links that leave a place.
const EAST: usize = 0;
const WEST: usize = 1;
const SOUTH: usize = 2;
const NORTH: usize = 3;

/// The links of the network.
pub struct Gdn {
    columns: usize,
    /// Cycles of injection and of ejection.
    ends: u64,
    /// The first free cycle of each link, four to a place.
    free: Vec<Cell<u64>>,
}

impl Gdn {
    /// A network of `columns` columns; a message takes `ends` cycles in and out together.
    pub fn new(columns: usize, ends: u32) -> Self {
        let free = vec![Cell::new(0); ROWS * columns * 4];
        Self { columns, ends: u64::from(ends), free }
    }

    /// Sends a message of `words` words, the header included, at cycle `at`. Returns the cycle at
    /// which its last word has arrived.
    pub fn send(&self, at: u64, from: Place, to: Place, words: u64) -> u64 {
        let mut here = from;
        let mut time = at + self.ends / 2;
        while here != to {
            let (direction, next) = step(here, to);
            let link = &self.free[(here.0 * self.columns + here.1) * 4 + direction];
            let start = time.max(link.get());
            link.set(start + words);
            time = start + 1;
            here = next;
        }
        time + words + self.ends.div_ceil(2)
    }
}

/// The way on: columns first.
fn step((row, column): Place, to: Place) -> (usize, Place) {
    if column < to.1 {
        (EAST, (row, column + 1))
    } else if column > to.1 {
        (WEST, (row, column - 1))
    } else if row < to.0 {
        (SOUTH, (row + 1, column))
    } else {
        (NORTH, (row - 1, column))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_free_network_takes_a_cycle_a_hop() {
        let gdn = Gdn::new(4, 4);
        assert_eq!(gdn.send(100, (3, 1), (3, 2), 2), 100 + 2 + 1 + 2 + 2);
        assert_eq!(gdn.send(200, (0, 0), (0, 0), 2), 200 + 2 + 2 + 2);
    }

    #[test]
    fn crossing_messages_wait_for_each_other() {
        let gdn = Gdn::new(4, 4);
        let alone = gdn.send(0, (3, 3), (4, 0), 10);
        assert_eq!(alone, 2 + 4 + 10 + 2);
        // The second shares the links west of column 2 and comes one cycle behind the first there.
        let second = gdn.send(0, (3, 2), (4, 0), 10);
        assert!(second > 2 + 3 + 10 + 2 && second <= alone + 11, "{second}");
        // Another direction is free.
        assert_eq!(gdn.send(0, (3, 0), (3, 1), 2), 2 + 1 + 2 + 2);
    }
}
