//! The rules again, slowly: every byte of the board is a cell, every polygon an
//! entry of a list, and counts are taken by looking.

use crate::memory::{EngineKind, MemoryConfig, MemoryError};

pub struct Item {
    pub name: u64,
    bytes: usize,
    owned: bool,
    locked: bool,
    copy: bool,
}

pub struct Naive {
    config: MemoryConfig,
    pub cells: Vec<Option<u64>>,
    pub items: Vec<Item>,
    pub queue: Vec<Vec<u64>>,
    held: Vec<Vec<u64>>,
    in_frame: bool,
    /// Names by last use, the oldest first.
    used: Vec<u64>,
    /// Being drawn with.
    busy: Vec<u64>,
    pub loads: u64,
    pub evictions: u64,
    pub freed: u64,
}

impl Naive {
    pub fn new(config: MemoryConfig) -> Naive {
        Naive {
            config,
            cells: vec![None; config.video_bytes as usize],
            items: Vec::new(),
            queue: Vec::new(),
            held: Vec::new(),
            in_frame: false,
            used: Vec::new(),
            busy: Vec::new(),
            loads: 0,
            evictions: 0,
            freed: 0,
        }
    }

    fn item(&mut self, name: u64) -> Option<&mut Item> {
        self.items.iter_mut().find(|item| item.name == name)
    }

    pub fn is_on_board(&self, name: u64) -> bool {
        self.cells.contains(&Some(name))
    }

    fn is_separate(&self) -> bool {
        self.config.kind == EngineKind::Separate
    }

    fn is_needed(&self, name: u64) -> bool {
        self.queue.iter().chain(&self.held).flatten().any(|&other| other == name)
    }

    pub fn deferred(&self) -> usize {
        self.items.iter().filter(|item| !item.owned).count()
    }

    pub fn copies(&self) -> u64 {
        self.items.iter().filter(|item| item.copy).map(|item| item.bytes as u64).sum()
    }

    fn hole(&self, bytes: usize) -> Option<usize> {
        let mut best: Option<(usize, usize)> = None;
        let mut at = 0;
        while at < self.cells.len() {
            let length = self.cells[at..].iter().take_while(|cell| cell.is_none()).count();
            if length >= bytes && best.is_none_or(|(least, _)| length < least) {
                best = Some((length, at));
            }
            at += length.max(1);
        }
        best.map(|(_, at)| at)
    }

    fn touch(&mut self, name: u64) {
        self.used.retain(|&other| other != name);
        self.used.push(name);
    }

    fn load(&mut self, name: u64) -> bool {
        if self.is_on_board(name) {
            return true;
        }
        let Some(bytes) = self.item(name).map(|item| item.bytes) else { return false };
        loop {
            if let Some(at) = self.hole(bytes) {
                self.cells[at..at + bytes].fill(Some(name));
                self.loads += 1;
                self.touch(name);
                return true;
            }
            let leaves: Vec<&Item> = self
                .used
                .iter()
                .filter_map(|&name| self.items.iter().find(|item| item.name == name))
                .filter(|item| self.is_separate() && self.is_on_board(item.name))
                .filter(|item| !item.locked && !self.busy.contains(&item.name))
                .collect();
            let alike = leaves.iter().find(|item| item.bytes >= bytes && item.bytes <= 2 * bytes);
            let Some(victim) = alike.or(leaves.first()).map(|item| item.name) else { return false };
            self.clear(victim);
            self.evictions += 1;
        }
    }

    fn clear(&mut self, name: u64) {
        self.cells.iter_mut().filter(|cell| **cell == Some(name)).for_each(|cell| *cell = None);
    }

    /// Draws polygons in a row with the same resources, which are loaded once;
    /// false where there are none.
    pub fn draw_run(&mut self) -> bool {
        let Some(polygon) = self.queue.first().cloned() else { return false };
        for &name in &polygon {
            self.load(name);
            self.touch(name);
            self.busy.push(name);
        }
        self.busy.clear();
        while self.queue.first() == Some(&polygon) {
            self.queue.remove(0);
            if self.in_frame && self.config.kind == EngineKind::VideoOnlyUntilFrameEnd {
                self.held.push(polygon.clone());
            }
        }
        self.free_unneeded();
        true
    }

    fn free_unneeded(&mut self) {
        let is_gone = |item: &&Item| !item.owned && !self.is_needed(item.name);
        let gone: Vec<u64> = self.items.iter().filter(is_gone).map(|item| item.name).collect();
        for name in gone {
            self.clear(name);
            self.items.retain(|item| item.name != name);
            self.freed += 1;
        }
    }

    pub fn create(&mut self, name: u64, bytes: u64, locked: bool) -> Result<(), MemoryError> {
        if bytes > self.config.video_bytes {
            return Err(MemoryError::OutOfVideoMemory);
        }
        let bytes = bytes as usize;
        self.items.push(Item { name, bytes, owned: true, locked, copy: false });
        if !locked && self.is_separate() {
            return Ok(());
        }
        while !self.load(name) {
            if self.deferred() == 0 || !self.draw_run() {
                self.items.pop();
                return Err(MemoryError::OutOfVideoMemory);
            }
        }
        Ok(())
    }

    pub fn detach(&mut self, name: u64) -> Result<(), MemoryError> {
        let limit = self.config.host_bytes;
        let item = self.item(name).expect("the test knows what it owns");
        let (bytes, copied) = (item.bytes as u64, item.copy);
        if copied || !self.is_separate() {
            return Ok(());
        }
        while self.copies() + bytes > limit {
            if self.deferred() == 0 || !self.draw_run() {
                return Err(MemoryError::OutOfMemory);
            }
        }
        self.item(name).expect("as above").copy = true;
        Ok(())
    }

    pub fn replace(&mut self, name: u64) {
        while self.queue.iter().flatten().any(|&other| other == name) {
            self.draw_run();
        }
        self.loads += u64::from(self.is_on_board(name));
    }

    pub fn delete(&mut self, name: u64) {
        let item = self.item(name).expect("the test knows what it owns");
        item.owned = false;
        item.locked = true;
        self.free_unneeded();
        while self.items.iter().any(|item| item.name == name) && !self.load(name) {
            self.draw_run();
        }
    }

    pub fn sync(&mut self) {
        while self.draw_run() {}
    }

    pub fn start_frame(&mut self) {
        self.in_frame = true;
    }

    pub fn end_frame(&mut self) {
        self.sync();
        self.in_frame = false;
        self.held.clear();
        self.free_unneeded();
    }

    pub fn free_bytes(&mut self) -> u64 {
        while self.deferred() > 0 && self.draw_run() {}
        let stays = |name: u64| {
            let item = self.items.iter().find(|item| item.name == name);
            !self.is_separate() || item.is_some_and(|item| item.locked)
        };
        let taken = self.cells.iter().filter(|cell| cell.is_some_and(stays)).count();
        (self.cells.len() - taken) as u64
    }
}
