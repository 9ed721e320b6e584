//! The host interface: protocol records in, words for the client out.
//!
//! The thesis simulates the host as a device at port 15 that reads a pipe; it has no intelligence
//! of its own. This one sits before a [`Device`] that answers at once, so a record that waits for a
//! word which is not there would wait for ever; it is an error instead.
//! Source: RAW, appendix on the render host.

use std::collections::VecDeque;

use crate::device::{Device, MAX_SIZE};
use crate::observer::Observer;
use crate::protocol::{MalformedRecord, Record};

/// What a record may be followed by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Expect {
    Any,
    /// The number of words to pass back.
    Count,
    /// Text for the log.
    Text,
}

/// Why the host interface cannot go on.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum HostError {
    /// A wait or read for words that the device will not send.
    #[error("record {record}, word {offset}: {wanted} words are awaited, the device sends {sent}")]
    Starved {
        /// The record, counted from 0.
        record: u64,
        /// Words sent to the device so far.
        offset: u64,
        /// Words the record asked for.
        wanted: u32,
        /// Words the device had.
        sent: u32,
    },
    /// After `read` comes no count.
    #[error("record {record}, word {offset}: `read` is not followed by a count")]
    NoCount {
        /// The record, counted from 0.
        record: u64,
        /// Words sent to the device so far.
        offset: u64,
    },
    /// Text where a record is expected.
    #[error("record {record}, word {offset}: {source}")]
    Malformed {
        /// The record, counted from 0.
        record: u64,
        /// Words sent to the device so far.
        offset: u64,
        /// What stands there.
        source: MalformedRecord,
    },
}

/// A device behind its host interface.
#[derive(Debug)]
pub struct Host<O = ()> {
    device: Device<O>,
    expect: Expect,
    records: u64,
    /// Words for the client, run-length encoded as the device keeps them.
    words: VecDeque<u32>,
    log: Vec<String>,
    halted: bool,
}

/// Lines kept in the log; later ones are dropped.
const MAX_LOG: usize = 4096;
/// The most words one `read` passes back, so that a wrong count cannot fill the memory: the pixels
/// of the largest screen.
pub const MAX_READ: u32 = MAX_SIZE * MAX_SIZE;

impl<O: Observer> Host<O> {
    /// Connects to a booted device: takes its ready word.
    pub fn new(mut device: Device<O>) -> Self {
        device.pop_reply();
        Self {
            device,
            expect: Expect::Any,
            records: 0,
            words: VecDeque::new(),
            log: Vec::new(),
            halted: false,
        }
    }

    /// The device.
    pub fn device(&self) -> &Device<O> {
        &self.device
    }

    /// The device, to change it.
    pub fn device_mut(&mut self) -> &mut Device<O> {
        &mut self.device
    }

    /// The device, disconnected.
    pub fn into_device(self) -> Device<O> {
        self.device
    }

    /// Whether a halt record or command has stopped the run.
    pub fn is_halted(&self) -> bool {
        self.halted || self.device.is_halted()
    }

    /// Records taken so far.
    pub fn records(&self) -> u64 {
        self.records
    }

    /// The next word for the client.
    pub fn pop(&mut self) -> Option<u32> {
        self.words.pop_front()
    }

    /// Takes what was logged: debug texts and counter reports.
    pub fn take_log(&mut self) -> Vec<String> {
        std::mem::take(&mut self.log)
    }

    /// Takes one record. Records after a halt are dropped.
    ///
    /// # Errors
    /// [`HostError`]; the record has no effect, and the next one is taken as usual.
    pub fn push(&mut self, record: Record) -> Result<(), HostError> {
        if self.halted {
            return Ok(());
        }
        let result = self.take(record);
        self.records += 1;
        result
    }

    fn take(&mut self, record: Record) -> Result<(), HostError> {
        let at = (self.records, self.device.words());
        match (std::mem::replace(&mut self.expect, Expect::Any), record) {
            (Expect::Text, record) => self.log(text_of(record)),
            (Expect::Count, Record::Data(count)) => self.read(count)?,
            (Expect::Count, _) => return Err(HostError::NoCount { record: at.0, offset: at.1 }),
            (Expect::Any, Record::Data(word)) => self.device.push(word),
            (Expect::Any, Record::Wait) if self.device.pop_reply().is_none() => {
                return Err(self.starved(1, 0));
            }
            (Expect::Any, Record::Wait) => {}
            (Expect::Any, Record::Halt) => self.halted = true,
            (Expect::Any, Record::AsyncReset) => {
                self.device.reset_now();
                self.device.pop_reply();
            }
            (Expect::Any, Record::Read) => self.expect = Expect::Count,
            (Expect::Any, Record::Debug) => self.expect = Expect::Text,
            (Expect::Any, Record::Text(bytes)) => {
                let source = MalformedRecord { bytes };
                return Err(HostError::Malformed { record: at.0, offset: at.1, source });
            }
            (Expect::Any, meta) => self.meta(meta),
        }
        Ok(())
    }

    fn meta(&mut self, record: Record) {
        self.device.observer_mut().meta(record);
        if record == Record::Report
            && let Some(report) = self.device.observer_mut().report()
        {
            self.log(report);
        }
    }

    fn read(&mut self, count: u32) -> Result<(), HostError> {
        let mut sent = 0;
        while sent < count.min(MAX_READ) {
            let Some(word) = self.device.pop_reply() else { break };
            self.words.push_back(word);
            sent += 1;
        }
        if sent < count { Err(self.starved(count, sent)) } else { Ok(()) }
    }

    fn starved(&self, wanted: u32, sent: u32) -> HostError {
        HostError::Starved { record: self.records, offset: self.device.words(), wanted, sent }
    }

    fn log(&mut self, text: String) {
        if self.log.len() < MAX_LOG {
            self.log.push(text);
        }
    }
}

/// The eleven bytes of a record as the log shows them.
pub(crate) fn text_of(record: Record) -> String {
    String::from_utf8_lossy(&record.bytes()).trim_end_matches(['\n', '*']).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Config;
    use crate::opcode::Opcode;

    fn host() -> Host {
        Host::new(Device::new(Config::default().sized(8, 8)))
    }

    #[test]
    fn reads_pass_words_back() {
        let mut host = host();
        let words = [Opcode::TexMemAvail as u32];
        for record in words.map(Record::Data).into_iter().chain([Record::Read, Record::Data(1)]) {
            host.push(record).expect("a good stream");
        }
        assert_eq!(host.pop(), Some(1 << 20));
        assert_eq!(host.pop(), None);
    }

    #[test]
    fn waiting_for_nothing_is_an_error_that_names_the_place() {
        let mut host = host();
        host.push(Record::Data(Opcode::ClearZ as u32)).expect("a command");
        let starved = HostError::Starved { record: 1, offset: 1, wanted: 1, sent: 0 };
        assert_eq!(host.push(Record::Wait), Err(starved));
        assert_eq!(host.push(Record::Read), Ok(()));
        assert!(host.push(Record::Data(u32::MAX)).is_err());
        assert!(host.push(Record::Text(*b"nonsense!!\n")).is_err());
    }

    #[test]
    fn debug_text_reaches_the_log() {
        let mut host = host();
        host.push(Record::Debug).expect("a record");
        host.push(Record::Text(*b"hello*****\n")).expect("text");
        assert_eq!(host.take_log(), ["hello"]);
    }
}
