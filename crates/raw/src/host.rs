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
    /// A read of more words than a screen of this size could be asked for. The words that are left
    /// are dropped, and the run ends.
    #[error(
        "record {record}, word {offset}: {wanted} words are awaited; one read passes {most} back"
    )]
    TooMany {
        /// The record, counted from 0.
        record: u64,
        /// Words sent to the device so far.
        offset: u64,
        /// Words the record asked for.
        wanted: u32,
        /// Words that were passed back.
        most: u32,
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
    #[error("record {record}, word {offset}: {what}")]
    Malformed {
        /// The record, counted from 0.
        record: u64,
        /// Words sent to the device so far.
        offset: u64,
        /// What stands there.
        what: MalformedRecord,
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
/// The most words one `read` passes back from a device of so many pixels, so that a wrong count
/// neither fills the memory nor takes for ever: both pages and the depths, and some to spare.
pub fn most_read(screen: u64) -> u32 {
    const { assert!(4 * MAX_SIZE as u64 * (MAX_SIZE as u64) < 1 << 31) };
    (4 * screen) as u32 + (1 << 16)
}

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
                let what = MalformedRecord { bytes };
                return Err(HostError::Malformed { record: at.0, offset: at.1, what });
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
            self.log(report.trim_end().to_owned());
        }
    }

    fn read(&mut self, count: u32) -> Result<(), HostError> {
        let mut sent = 0;
        let most = most_read(self.device.core().screen());
        while sent < count.min(most) {
            let Some(word) = self.device.pop_reply() else { break };
            self.words.push_back(word);
            sent += 1;
        }
        if sent < count && sent == most {
            self.device.drop_replies();
            let (record, offset) = (self.records, self.device.words());
            return Err(HostError::TooMany { record, offset, wanted: count, most });
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
    fn a_read_of_everything_ends() {
        let mut host = host();
        for word in [Opcode::ReadZBlock as u32, 0, 0, u32::MAX] {
            host.push(Record::Data(word)).expect("a command");
        }
        host.push(Record::Read).expect("a record");
        let most = most_read(64);
        let too_many = HostError::TooMany { record: 5, offset: 4, wanted: u32::MAX, most };
        assert_eq!(host.push(Record::Data(u32::MAX)), Err(too_many));
        assert_eq!(std::iter::from_fn(|| host.pop()).count(), most as usize);
        // Nothing is left for the next question.
        assert!(host.push(Record::Wait).is_err());
    }

    #[test]
    fn debug_text_reaches_the_log() {
        let mut host = host();
        host.push(Record::Debug).expect("a record");
        host.push(Record::Text(*b"hello*****\n")).expect("text");
        assert_eq!(host.take_log(), ["hello"]);
    }
}
