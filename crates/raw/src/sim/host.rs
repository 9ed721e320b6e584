//! The host interface: reads protocol records, feeds the device, keeps the counters' switches.

use std::cell::Cell;
use std::rc::Rc;

use super::kernel::TaskId;
use super::machine::{HostWait, Machine, Word};
use super::meters;
use crate::host::{HostError, most_read, text_of};
use crate::protocol::{MalformedRecord, Record};

/// What the host interface is connected to: where records come from and where words and log lines
/// go. Simulated time stands still while the source makes it wait.
pub struct HostSide {
    /// The records, in order.
    pub records: Box<dyn Iterator<Item = Record>>,
    /// Takes a word for the client; `false` when the client is gone, which ends the run.
    pub reply: Box<dyn FnMut(u32) -> bool>,
    /// Takes a line for the log.
    pub log: Box<dyn FnMut(&str)>,
}

struct Host {
    m: Rc<Machine>,
    me: TaskId,
    side: HostSide,
    clock: Cell<u64>,
    /// Records taken, words sent.
    places: (u64, u64),
}

/// Plays the records and stops the kernel.
pub async fn run(m: Rc<Machine>, side: HostSide, me: Rc<Cell<TaskId>>) {
    let clock = Cell::new(m.k.now());
    let mut host = Host { m, me: me.get(), side, clock, places: (0, 0) };
    host.word().await;
    while let Some(record) = host.next() {
        if !host.record(record).await || host.m.halted.get() {
            break;
        }
    }
    host.m.k.catch_up(host.me, &host.clock).await;
    host.m.k.stop();
}

impl Host {
    fn next(&mut self) -> Option<Record> {
        let record = self.side.records.next()?;
        self.places.0 += 1;
        Some(record)
    }

    /// Waits for a word from the device.
    async fn word(&self) -> u32 {
        self.m.host_waits.set(HostWait::Word(self.places.0));
        let (word, _) = self.m.device.receive(&self.m.k, self.me, &self.clock).await;
        self.m.host_waits.set(HostWait::Nothing);
        word
    }

    /// Carries out one record; returns whether the run goes on.
    async fn record(&mut self, record: Record) -> bool {
        match record {
            Record::Data(value) => self.send(value).await,
            Record::Wait => {
                self.word().await;
            }
            Record::AsyncReset => {
                self.m.k.catch_up(self.me, &self.clock).await;
                super::restart(&self.m);
                self.word().await;
            }
            Record::Read => return self.read().await,
            Record::Debug => {
                if let Some(text) = self.next() {
                    (self.side.log)(&text_of(text));
                }
            }
            Record::Halt => return false,
            Record::Text(bytes) => {
                let (record, offset) = (self.places.0 - 1, self.places.1);
                let what = MalformedRecord { bytes };
                self.fault(HostError::Malformed { record, offset, what });
            }
            meta => {
                self.m.k.catch_up(self.me, &self.clock).await;
                meters::meta(&self.m, meta);
                if meta == Record::Report {
                    meters::settle(&self.m);
                    (self.side.log)(self.m.counters().report().trim_end());
                }
            }
        }
        true
    }

    async fn send(&mut self, value: u32) {
        let word = Word { value, offset: self.places.1 };
        self.places.1 += 1;
        self.m.host_waits.set(HostWait::Room(self.places.0));
        self.m.host.send(&self.m.k, self.me, &self.clock, word, 1).await;
        self.m.host_waits.set(HostWait::Nothing);
        self.clock.set(self.clock.get() + u64::from(self.m.costs.host_word) - 1);
    }

    async fn read(&mut self) -> bool {
        let Some(Record::Data(count)) = self.next() else {
            let (record, offset) = self.places;
            self.fault(HostError::NoCount { record: record.saturating_sub(1), offset });
            return true;
        };
        let most = most_read(self.m.core.borrow().screen());
        for sent in 0..count {
            if sent == most {
                let (record, offset) = self.places;
                let record = record.saturating_sub(1);
                self.fault(HostError::TooMany { record, offset, wanted: count, most });
                return false;
            }
            let word = self.word().await;
            if !(self.side.reply)(word) {
                return false;
            }
        }
        true
    }

    fn fault(&self, fault: HostError) {
        self.m.host_faults.borrow_mut().push(fault);
    }
}
