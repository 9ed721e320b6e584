//! Records from a stream of bytes, played on a device: pipes, files, standard input.
//!
//! A record that cannot be read stops the run, since the words behind it would be taken for
//! something else; with [`Repair::NextLine`] reading goes on behind the next newline instead.

use std::cell::RefCell;
use std::io::{self, BufWriter, Read, Write};
use std::rc::Rc;

use crate::device::{Config, Core, Device};
use crate::error::StreamError;
use crate::follower::Follower;
use crate::host::{Host, HostError};
use crate::observer::Observer;
use crate::protocol::{MalformedRecord, RECORD_BYTES, Record};
use crate::sim::cost::Costs;
use crate::sim::perf::Counters;
use crate::sim::{self, Deadlock, Options, single};

/// What to do about a malformed record.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Repair {
    /// Stop and say where.
    #[default]
    Stop,
    /// Drop it and go on behind the next newline.
    NextLine,
}

/// Why reading records ended before its time.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RecordError {
    /// Bytes that are no record.
    #[error("record {record} at byte {byte}: {what}")]
    Malformed {
        /// The record, counted from 0.
        record: u64,
        /// Its first byte in the stream.
        byte: u64,
        /// What stands there.
        what: MalformedRecord,
    },
    /// The stream ends inside a record.
    #[error("record {record} at byte {byte}: the stream ends after {bytes} of 11 bytes")]
    Cut {
        /// The record, counted from 0.
        record: u64,
        /// Its first byte in the stream.
        byte: u64,
        /// How many bytes there are.
        bytes: usize,
    },
    /// The stream cannot be read.
    #[error("record {record} cannot be read")]
    Read {
        /// The record, counted from 0.
        record: u64,
        /// Why.
        source: io::Error,
    },
}

/// Reads records from bytes.
#[derive(Debug)]
pub struct RecordReader<R> {
    input: R,
    repair: Repair,
    records: u64,
    bytes: u64,
    text_follows: bool,
    ended: bool,
}

impl<R: Read> RecordReader<R> {
    /// A reader at the start of a stream.
    pub fn new(input: R, repair: Repair) -> Self {
        Self { input, repair, records: 0, bytes: 0, text_follows: false, ended: false }
    }

    fn read_record(&mut self) -> Result<Option<Record>, RecordError> {
        let (record, byte) = (self.records, self.bytes);
        let mut buffer = [0; RECORD_BYTES];
        let filled = self.fill(&mut buffer)?;
        match filled {
            0 => return Ok(None),
            RECORD_BYTES => {}
            bytes => return Err(RecordError::Cut { record, byte, bytes }),
        }
        self.records += 1;
        if std::mem::take(&mut self.text_follows) {
            return Ok(Some(Record::Text(buffer)));
        }
        match Record::parse(buffer) {
            Ok(parsed) => {
                self.text_follows = parsed == Record::Debug;
                Ok(Some(parsed))
            }
            Err(what) => Err(RecordError::Malformed { record, byte, what }),
        }
    }

    /// Fills the buffer as far as the stream goes.
    fn fill(&mut self, buffer: &mut [u8]) -> Result<usize, RecordError> {
        let mut filled = 0;
        while filled < buffer.len() {
            match self.input.read(&mut buffer[filled..]) {
                Ok(0) => break,
                Ok(n) => filled += n,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(source) => return Err(RecordError::Read { record: self.records, source }),
            }
        }
        self.bytes += filled as u64;
        Ok(filled)
    }

    /// Moves behind the next newline, unless the malformed record has ended with one.
    fn skip_line(&mut self, bytes: &[u8; RECORD_BYTES]) -> Result<(), RecordError> {
        let mut last = [bytes[RECORD_BYTES - 1]];
        while last[0] != b'\n' {
            if self.fill(&mut last)? == 0 {
                break;
            }
        }
        Ok(())
    }
}

impl<R: Read> Iterator for RecordReader<R> {
    type Item = Result<Record, RecordError>;

    /// The next record. After an error: with [`Repair::NextLine`] reading goes on, else it ends.
    fn next(&mut self) -> Option<Self::Item> {
        if self.ended {
            return None;
        }
        let result = self.read_record();
        let skipped = match &result {
            Err(RecordError::Malformed { what, .. }) if self.repair == Repair::NextLine => {
                self.skip_line(&what.bytes).is_ok()
            }
            Ok(Some(_)) => true,
            _ => false,
        };
        self.ended = !skipped;
        result.transpose()
    }
}

/// Which machine plays the records.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Build {
    /// The reference renderer, with the counters of one tile.
    Single,
    /// The fast path on so many threads; nothing is counted.
    Fast(usize),
    /// The grid of tiles.
    Grid(Options),
}

/// What a run of records left behind.
#[derive(Debug)]
pub struct Served {
    /// State, textures and buffers at the end.
    pub core: Core,
    /// The counters.
    pub counters: Counters,
    /// Faults in the words, oldest first.
    pub faults: Vec<StreamError>,
    /// Faults in the records, oldest first; the last one may have ended the run.
    pub errors: Vec<ServeError>,
    /// Cycles from power-on, where the build has a clock for them.
    pub cycles: Option<u64>,
}

/// A fault in a stream of records.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ServeError {
    /// Bytes that are no record.
    #[error(transparent)]
    Record(#[from] RecordError),
    /// A record that asks for the impossible.
    #[error(transparent)]
    Host(#[from] HostError),
    /// The grid is stuck.
    #[error(transparent)]
    Deadlock(#[from] Deadlock),
    /// The client does not take its words.
    #[error("words cannot be passed back")]
    Write(#[source] io::Error),
}

/// Faults of records kept.
const MAX_ERRORS: usize = 256;

/// Plays records on a machine; words for the client are written to `output` as records, which are
/// flushed before more is expected of it, and what the device logs is passed to `log`.
///
/// The run ends with the stream, a halt, or an error that [`Served::errors`] then ends with.
pub fn serve<R, W>(
    build: Build,
    config: Config,
    mut records: RecordReader<R>,
    output: W,
    log: impl FnMut(&str) + 'static,
) -> Served
where
    R: Read + 'static,
    W: Write + 'static,
{
    let output = Rc::new(RefCell::new(BufWriter::new(output)));
    let follower = Rc::new(RefCell::new(Follower::new(config.beyond)));
    let (sent, followed) = (Rc::clone(&output), Rc::clone(&follower));
    let records = std::iter::from_fn(move || {
        // A client may wait for its words before it goes on. One that is gone is told of below.
        let _ = sent.borrow_mut().flush();
        let record = records.next();
        if let Some(Ok(record)) = record {
            followed.borrow_mut().record(record);
        }
        record
    });
    let mut served = play(build, config, records, Rc::clone(&output), log);
    let flushed = output.borrow_mut().flush().map_err(ServeError::Write);
    if served.errors.is_empty() {
        served.faults.extend(follower.borrow().unfinished());
        keep(&mut served.errors, flushed);
    }
    served
}

/// What words for the client are written to.
type Output<W> = Rc<RefCell<BufWriter<W>>>;

/// Plays records on the machine that `build` says.
fn play<W: Write + 'static>(
    build: Build,
    config: Config,
    records: impl Iterator<Item = Result<Record, RecordError>> + 'static,
    output: Output<W>,
    log: impl FnMut(&str) + 'static,
) -> Served {
    match build {
        Build::Single => {
            let device = single::observed(config, Costs::default());
            let (device, errors) = serve_here(device, records, &output, log);
            let counters = device.observer().counters();
            finish(device, counters, errors)
        }
        Build::Fast(threads) => {
            let device = Device::new(Config { threads: threads.max(1), ..config });
            let (device, errors) = serve_here(device, records, &output, log);
            finish(device, Counters::default(), errors)
        }
        Build::Grid(options) => serve_grid(config, options, records, output, log),
    }
}

fn serve_here<O: Observer, W: Write>(
    device: Device<O>,
    records: impl Iterator<Item = Result<Record, RecordError>>,
    output: &Output<W>,
    mut log: impl FnMut(&str),
) -> (Device<O>, Vec<ServeError>) {
    let mut host = Host::new(device);
    let mut errors = Vec::new();
    for record in records {
        let result = match record {
            Ok(record) => host.push(record).map_err(ServeError::from),
            Err(error) => Err(error.into()),
        };
        let fatal = matches!(
            result,
            Err(ServeError::Host(HostError::Starved { .. } | HostError::TooMany { .. }))
        );
        keep(&mut errors, result);
        host.take_log().iter().for_each(|line| log(line));
        let passed = pass_words(output, std::iter::from_fn(|| host.pop()));
        let broken = passed.is_err();
        keep(&mut errors, passed);
        if fatal || broken || host.is_halted() {
            break;
        }
    }
    let mut device = host.into_device();
    device.observer_mut().report();
    (device, errors)
}

fn finish<O: Observer>(
    mut device: Device<O>,
    counters: Counters,
    errors: Vec<ServeError>,
) -> Served {
    Served {
        faults: device.take_faults(),
        counters,
        core: device.into_core(),
        errors,
        cycles: None,
    }
}

fn keep(errors: &mut Vec<ServeError>, result: Result<(), ServeError>) {
    if let Err(error) = result
        && errors.len() < MAX_ERRORS
    {
        errors.push(error);
    }
}

fn pass_words<W: Write>(
    output: &Output<W>,
    mut words: impl Iterator<Item = u32>,
) -> Result<(), ServeError> {
    let mut output = output.borrow_mut();
    let written = words.try_for_each(|word| output.write_all(&Record::Data(word).bytes()));
    written.map_err(ServeError::Write)
}

fn serve_grid<W: Write + 'static>(
    config: Config,
    options: Options,
    records: impl Iterator<Item = Result<Record, RecordError>> + 'static,
    output: Output<W>,
    log: impl FnMut(&str) + 'static,
) -> Served {
    let errors = Rc::new(RefCell::new(Vec::new()));
    let (reading, writing) = (Rc::clone(&errors), Rc::clone(&errors));
    let good = records.filter_map(move |record| match record {
        Ok(record) => Some(record),
        Err(error) => {
            keep(&mut reading.borrow_mut(), Err(error.into()));
            None
        }
    });
    let client = sim::HostSide {
        records: Box::new(good),
        reply: Box::new(move |word| {
            let passed = pass_words(&output, std::iter::once(word));
            let open = passed.is_ok();
            keep(&mut writing.borrow_mut(), passed);
            open
        }),
        log: Box::new(log),
    };
    let (run, stuck) = sim::play_stream(config, Costs::default(), options, client, |_| {});
    let mut errors = std::mem::take(&mut *errors.borrow_mut());
    errors.extend(run.host_faults.into_iter().map(ServeError::from));
    errors.extend(stuck.map(ServeError::from));
    Served {
        core: run.core,
        counters: run.counters,
        faults: run.faults,
        errors,
        cycles: Some(run.cycles),
    }
}
