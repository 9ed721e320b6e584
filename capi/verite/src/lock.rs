//! Locked buffers: the memory that a program reads and writes.
//!
//! On a board this is the buffer itself. Here it is kept equal to the buffer at
//! the points where the library can see, and a program can tell, that something
//! happened: what was stored is carried out before the next call that goes to
//! the device, issues among them; what was drawn is shown when a call returns
//! that waits for the board or says that it is done. A byte that both changed in
//! between keeps the program's value.

use fillrate_call::Data;
use fillrate_redline::lock::changes;

/// A buffer's bytes. They stay where they are until the buffer's memory is
/// given back, so that a pointer that is used too late harms nobody.
#[derive(Debug)]
pub(crate) struct Lock {
    /// Device and group of the buffer.
    pub owner: (u32, u32),
    /// The buffer's board address.
    pub address: u32,
    /// The buffer may have changed since it was shown.
    pub stale: bool,
    bytes: Vec<u32>,
    /// What was shown, or has been carried out.
    before: Vec<u8>,
    /// How many times it is locked.
    count: u32,
}

impl Lock {
    /// Room for a buffer.
    pub fn new(owner: (u32, u32), address: u32) -> Lock {
        Lock { owner, address, stale: false, bytes: Vec::new(), before: Vec::new(), count: 0 }
    }

    /// Whether the program holds it.
    pub fn is_held(&self) -> bool {
        self.count > 0
    }

    /// Locks it once more. The first time it holds what the buffer holds.
    /// Programs may write `room` bytes, the padding of the last row among them,
    /// which nobody sees.
    pub fn lock(&mut self, room: usize, now: impl FnOnce() -> Vec<u8>) -> *mut u8 {
        if self.count == 0 {
            self.before = now();
            self.stale = false;
            let words = self.before.len().max(room).div_ceil(4);
            if self.bytes.len() < words {
                self.bytes.resize(words, 0);
            }
            for (word, bytes) in self.bytes.iter_mut().zip(self.before.chunks(4)) {
                let mut whole = [0; 4];
                whole[..bytes.len()].copy_from_slice(bytes);
                *word = u32::from_ne_bytes(whole);
            }
        }
        self.count += 1;
        self.bytes.as_mut_ptr().cast()
    }

    /// Whether the program holds it and has stored something that was not
    /// carried out yet.
    pub fn is_changed(&self) -> bool {
        self.is_held() && self.view() != self.before
    }

    /// What the program has stored since the last time.
    pub fn take_changes(&mut self) -> Data {
        let changes = changes(&self.before, self.view());
        self.before = self.view().to_vec();
        changes
    }

    /// Shows what the buffer holds now, but where the program has stored
    /// something else meanwhile.
    pub fn show(&mut self, now: &[u8]) {
        self.stale = false;
        if now.len() != self.before.len() {
            return;
        }
        let count = self.before.len();
        // SAFETY: words are bytes, and there are enough of them.
        let shown =
            unsafe { std::slice::from_raw_parts_mut(self.bytes.as_mut_ptr().cast::<u8>(), count) };
        for ((shown, before), &now) in shown.iter_mut().zip(&mut self.before).zip(now) {
            if *shown == *before {
                *shown = now;
            }
            *before = now;
        }
    }

    /// Gives it back once; what was changed, the last time.
    pub fn unlock(&mut self) -> Option<Data> {
        self.count = self.count.saturating_sub(1);
        (self.count == 0).then(|| changes(&self.before, self.view()))
    }

    fn view(&self) -> &[u8] {
        // SAFETY: words are bytes, and there are enough of them.
        unsafe { std::slice::from_raw_parts(self.bytes.as_ptr().cast(), self.before.len()) }
    }

    /// The board address of a pointer into it.
    pub fn board_address(&self, pointer: usize) -> Option<u32> {
        let offset = pointer.checked_sub(self.bytes.as_ptr().addr())?;
        (self.is_held() && offset < self.before.len()).then(|| self.address + offset as u32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lock_brings_back_changes() {
        let mut lock = Lock::new((1, 1), 1000);
        let pointer = lock.lock(12, || vec![1, 2, 3, 4, 5, 6, 7, 8]);
        assert_eq!(lock.lock(12, || unreachable!()), pointer);
        // SAFETY: twelve bytes are there.
        unsafe { pointer.add(6).write(70) };
        assert_eq!(lock.board_address(pointer.addr() + 6), Some(1006));
        assert_eq!(lock.board_address(pointer.addr() + 8), None);
        assert!(lock.unlock().is_none());
        let changed = lock.unlock().unwrap();
        assert_eq!(fillrate_redline::lock::runs(&changed).collect::<Vec<_>>(), [(6, &[70][..])]);
        assert!(!lock.is_held() && !lock.is_changed());
        assert_eq!(lock.board_address(pointer.addr()), None);
    }

    /// Between two calls the program and the board change bytes of their own.
    #[test]
    fn a_held_lock_shows_what_is_drawn() {
        let mut lock = Lock::new((1, 1), 0);
        let pointer = lock.lock(4, || vec![0; 4]);
        // SAFETY: four bytes are there.
        unsafe { pointer.add(1).write(10) };
        assert!(lock.is_changed());
        lock.show(&[7, 8, 9, 0]);
        assert_eq!(lock.view(), [7, 10, 9, 0]);
        let changed = lock.take_changes();
        assert_eq!(fillrate_redline::lock::runs(&changed).collect::<Vec<_>>(), [(1, &[10][..])]);
        assert!(!lock.is_changed());
        // What was drawn over it is shown.
        lock.show(&[7, 11, 9, 0]);
        assert_eq!(lock.view(), [7, 11, 9, 0]);
        assert!(lock.unlock().unwrap().is_empty());
    }
}
