//! The client library as a value: calls in, words and pictures out, over either transport.

use std::collections::VecDeque;
use std::io::{self, BufWriter, Read, Write};

use crate::call::Call;
use crate::client::Client;
use crate::device::{Config, Device, MAX_SIZE};
use crate::error::StreamError;
use crate::host::{Host, HostError};
use crate::protocol::{RECORD_BYTES, Record};

/// The page that is displayed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shown {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Red, green, blue and 255 of each pixel, row by row.
    pub rgba: Vec<u8>,
}

/// Something the device or its host interface has to say.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Report {
    /// A fault in the command words.
    #[error(transparent)]
    Stream(#[from] StreamError),
    /// A record that asks for the impossible.
    #[error(transparent)]
    Host(#[from] HostError),
    /// The other side of a pipe is gone.
    #[error("the renderer at the other end of the pipe is gone: {0}")]
    Gone(String),
    /// A line for the log.
    #[error("{0}")]
    Log(String),
}

/// How records reach a device.
enum Transport {
    /// A device in this process.
    Here(Box<Host>),
    /// Pipes to a device elsewhere.
    Pipes {
        to: BufWriter<Box<dyn Write + Send>>,
        from: Box<dyn Read + Send>,
        /// Records can no longer be written.
        closed: bool,
        /// No more words come.
        ended: bool,
    },
}

/// Words one call can ask for: all pixels of the largest screen.
const MAX_ANSWERS: u32 = MAX_SIZE * MAX_SIZE;

/// Reports kept; later ones are dropped.
const MAX_REPORTS: usize = 256;

/// A client and the device it talks to.
pub struct Context {
    client: Client,
    transport: Transport,
    words: VecDeque<u32>,
    reports: Vec<Report>,
    primitives: u64,
}

impl Context {
    /// A client with a device of its own, in this process.
    pub fn new(config: Config) -> Self {
        let host = Host::new(Device::new(config));
        Self::with(Client::new(config.errata), Transport::Here(Box::new(host)))
    }

    /// A client that writes records to `to` and reads words from `from`.
    pub fn piped(config: Config, to: Box<dyn Write + Send>, from: Box<dyn Read + Send>) -> Self {
        let transport =
            Transport::Pipes { to: BufWriter::new(to), from, closed: false, ended: false };
        Self::with(Client::new(config.errata), transport)
    }

    fn with(client: Client, transport: Transport) -> Self {
        Self { client, transport, words: VecDeque::new(), reports: Vec::new(), primitives: 0 }
    }

    /// Whether a scene is open.
    pub fn in_scene(&self) -> bool {
        self.client.in_scene()
    }

    /// Primitives begun so far.
    pub fn primitives(&self) -> u64 {
        self.primitives
    }

    /// The client: its matrices and errata.
    pub fn client(&mut self) -> &mut Client {
        &mut self.client
    }

    /// Executes a call; returns the words it asks for, zeros where none come.
    pub fn execute(&mut self, call: &Call) -> Vec<u32> {
        let answers = call.answers(self.client.in_scene());
        self.primitives += u64::from(matches!(call, Call::BeginPrim {}) && self.in_scene());
        self.client.call(call);
        self.send();
        let wanted = answers.min(MAX_ANSWERS);
        (0..wanted).map(|_| self.word().unwrap_or(0)).collect()
    }

    /// Sends what the client has made; needed only after using [`Context::client`].
    pub fn send(&mut self) {
        let records = self.client.take_records();
        match &mut self.transport {
            Transport::Here(host) => {
                let results = records.into_iter().map(|record| host.push(record));
                let failed: Vec<_> = results.filter_map(Result::err).collect();
                self.words.extend(std::iter::from_fn(|| host.pop()));
                let log = host.take_log().into_iter().map(Report::Log);
                let faults = host.device_mut().take_faults().into_iter().map(Report::Stream);
                let host_faults = failed.into_iter().map(Report::Host);
                let room = MAX_REPORTS.saturating_sub(self.reports.len());
                self.reports.extend(faults.chain(host_faults).chain(log).take(room));
            }
            Transport::Pipes { closed: true, .. } => {}
            Transport::Pipes { to, closed, .. } => {
                let written = records.iter().try_for_each(|record| to.write_all(&record.bytes()));
                if let Err(error) = written {
                    *closed = true;
                    self.reports.push(Report::Gone(error.to_string()));
                }
            }
        }
    }

    /// The next word that comes back, if one does.
    fn word(&mut self) -> Option<u32> {
        match &mut self.transport {
            Transport::Here(_) => self.words.pop_front(),
            Transport::Pipes { ended: true, .. } => None,
            Transport::Pipes { to, from, ended, .. } => {
                let word = to.flush().and_then(|()| read_word(from));
                word.map_err(|error| {
                    *ended = true;
                    self.reports.push(Report::Gone(error.to_string()));
                })
                .ok()
            }
        }
    }

    /// Sends what is buffered; nothing to do for a device in this process.
    pub fn flush(&mut self) {
        if let Transport::Pipes { to, closed: false, .. } = &mut self.transport
            && let Err(error) = to.flush()
        {
            self.reports.push(Report::Gone(error.to_string()));
        }
    }

    /// Whether there is something to tell.
    pub fn has_reports(&self) -> bool {
        !self.reports.is_empty()
    }

    /// Takes what there is to tell, oldest first.
    pub fn take_reports(&mut self) -> Vec<Report> {
        std::mem::take(&mut self.reports)
    }

    /// The device, where it is in this process.
    pub fn device(&self) -> Option<&Device> {
        match &self.transport {
            Transport::Here(host) => Some(host.device()),
            Transport::Pipes { .. } => None,
        }
    }

    /// The displayed page, where the device is in this process.
    pub fn shown(&mut self) -> Option<Shown> {
        if let Transport::Here(host) = &mut self.transport {
            host.device_mut().flush();
        }
        Some(shown(&self.device()?.core().target.frame, true))
    }
}

/// A page as bytes; `front` chooses the displayed one.
pub fn shown(frame: &crate::framebuffer::FrameBuffer, front: bool) -> Shown {
    let pixel = |word: &u32| {
        let [r, g, b, _] = word.to_be_bytes();
        [r, g, b, 0xff]
    };
    let rgba = frame.page(front).iter().flat_map(pixel).collect();
    Shown { width: frame.width(), height: frame.height(), rgba }
}

/// Reads a data record.
fn read_word(from: &mut dyn Read) -> io::Result<u32> {
    let mut bytes = [0; RECORD_BYTES];
    from.read_exact(&mut bytes)?;
    match Record::parse(bytes) {
        Ok(Record::Data(word)) => Ok(word),
        Ok(_) => Err(io::Error::other("a record that is no word came back")),
        Err(error) => Err(io::Error::other(error)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_come_back_with_the_call() {
        let mut context = Context::new(Config::default().sized(4, 4));
        assert_eq!(context.execute(&Call::AllocateTexture { width: 2, height: 2 }), [0]);
        context.execute(&Call::WriteFb { x: 1, y: 0, pages: 2, rgbx: 0x1122_3300 });
        assert_eq!(context.execute(&Call::ReadFb { x: 1, y: 0, page: 1 }), [0x1122_3300]);
        let shown = context.shown().expect("a device");
        assert_eq!(shown.rgba[4..8], [0x11, 0x22, 0x33, 0xff]);
        context.execute(&Call::SendWord { word: 99 });
        assert!(matches!(context.take_reports()[..], [Report::Stream(_)]));
    }

    #[test]
    fn raw_words_and_records_pass_through() {
        let mut context = Context::new(Config::default());
        context.execute(&Call::SendWord { word: 36 });
        context.execute(&Call::Meta { text: "read".into() });
        context.execute(&Call::SendWord { word: 1 });
        assert_eq!(context.execute(&Call::ReadWord {}), [1 << 20]);
        assert_eq!(context.execute(&Call::ReadWord {}), [0]);
    }

    #[test]
    fn a_closed_pipe_is_told_once() {
        let from: &[u8] = b"0x0000002a\n";
        let mut context = Context::piped(Config::default(), Box::new(Vec::new()), Box::new(from));
        assert_eq!(context.execute(&Call::TexMemAvail {}), [42]);
        assert_eq!(context.execute(&Call::TexMemAvail {}), [0]);
        assert_eq!(context.execute(&Call::TexMemAvail {}), [0]);
        assert_eq!(context.take_reports().len(), 1);
    }
}
