//! Reading traces.

use std::io::{BufReader, ErrorKind, Read};

use fillrate_call::{BlobId, Data, DecodeError, Decoder};

use crate::chunk::{
    self, BLOB, CALL, CHUNK_HEADER_BYTES, ChunkHeader, END, FILE_HEADER_BYTES, FRAM, MAGIC, META,
    Tag, VERSION, Version,
};
use crate::error::{Damage, TraceError};
use crate::event::{CallBatch, Counts, Ending, Event, FrameEnd};
use crate::meta::Meta;

/// Reads one trace: an iterator of events, the last of which is [`Event::End`] or an error.
///
/// Whatever the bytes are, reading does not panic, and holds one chunk in memory, whose size is
/// checked before it is allocated. Chunks of unknown kinds are skipped.
#[derive(Debug)]
pub struct TraceReader<R: Read> {
    file: BufReader<R>,
    version: Version,
    /// Where the next chunk starts.
    offset: u64,
    counts: Counts,
    last_frame: Option<u32>,
    skipped_chunks: u64,
    state: State,
}

/// Whether there is anything more to deliver.
#[derive(Debug, PartialEq, Eq)]
enum State {
    /// Chunks may follow.
    Reading,
    /// The file ended within its header, of which this many bytes exist.
    CutHeader(u64),
    /// The end or an error has been delivered.
    Done,
}

/// What stands at a position of the file.
enum Found {
    Chunk(ChunkHeader, Vec<u8>),
    /// The file ends this many bytes after the position.
    Cut(u64),
}

impl<R: Read> TraceReader<R> {
    /// Reads the header.
    ///
    /// # Errors
    /// [`TraceError::NotATrace`] if the file does not start with the magic bytes;
    /// [`TraceError::UnsupportedVersion`] for another major version;
    /// [`TraceError::UnsupportedFlags`]; [`TraceError::Io`].
    pub fn new(file: R) -> Result<Self, TraceError> {
        let mut reader = Self {
            file: BufReader::new(file),
            version: VERSION,
            offset: 0,
            counts: Counts::default(),
            last_frame: None,
            skipped_chunks: 0,
            state: State::Reading,
        };
        let header = reader.read_up_to(FILE_HEADER_BYTES)?;
        reader.offset = header.len() as u64;
        if header.len() == FILE_HEADER_BYTES {
            reader.version = chunk::parse_file_header(&header)?;
        } else if header.starts_with(&MAGIC) {
            reader.state = State::CutHeader(reader.offset);
        } else {
            return Err(TraceError::NotATrace);
        }
        Ok(reader)
    }

    /// The version of the format in which the file was written.
    pub fn version(&self) -> Version {
        self.version
    }

    /// How many chunks of unknown kinds have been skipped.
    pub fn skipped_chunks(&self) -> u64 {
        self.skipped_chunks
    }

    /// What has been delivered so far.
    pub fn counts(&self) -> Counts {
        self.counts
    }

    /// Reads `count` bytes, or fewer at the end of the file. Memory grows with what is there.
    fn read_up_to(&mut self, count: usize) -> Result<Vec<u8>, TraceError> {
        let mut bytes = Vec::new();
        match self.file.by_ref().take(count as u64).read_to_end(&mut bytes) {
            Err(error) if error.kind() != ErrorKind::UnexpectedEof => Err(error.into()),
            _ => Ok(bytes),
        }
    }

    /// Reads the chunk at the current position. Its payload is not checked yet.
    fn read_chunk(&mut self) -> Result<Found, TraceError> {
        let header = self.read_up_to(CHUNK_HEADER_BYTES)?;
        let Ok(header_bytes) = <[u8; CHUNK_HEADER_BYTES]>::try_from(&header[..]) else {
            return Ok(Found::Cut(header.len() as u64));
        };
        let header = ChunkHeader::from_bytes(header_bytes);
        header.check_lengths(self.offset)?;
        let stored_len = header.stored_len() as usize;
        let stored = self.read_up_to(stored_len)?;
        if stored.len() < stored_len {
            return Ok(Found::Cut((CHUNK_HEADER_BYTES + stored.len()) as u64));
        }
        Ok(Found::Chunk(header, stored))
    }

    /// The next event, or `None` after a chunk that is skipped.
    fn step(&mut self) -> Result<Option<Event>, TraceError> {
        let (header, stored) = match self.read_chunk()? {
            Found::Chunk(header, stored) => (header, stored),
            Found::Cut(lost_bytes) => return Ok(Some(self.truncated(lost_bytes))),
        };
        let start = self.offset;
        self.offset += (CHUNK_HEADER_BYTES + stored.len()) as u64;
        let payload = header.open(start, stored)?;
        self.interpret(header.tag(), payload)
            .map_err(|damage| TraceError::Format { offset: start, damage })
    }

    /// The event that a chunk stands for, or `None` for an unknown kind.
    fn interpret(&mut self, tag: Tag, payload: Vec<u8>) -> Result<Option<Event>, Damage> {
        let event = match tag {
            META => Event::Meta(Meta::decode(&payload)?),
            CALL => self.calls(payload)?,
            BLOB => self.blob(&payload)?,
            FRAM => self.frame_end(&payload)?,
            END => self.end(&payload)?,
            _ => {
                self.skipped_chunks += 1;
                return Ok(None);
            }
        };
        Ok(Some(event))
    }

    fn calls(&mut self, payload: Vec<u8>) -> Result<Event, DecodeError> {
        let batch = CallBatch::decode(payload)?;
        self.counts.calls += batch.len() as u64;
        Ok(Event::Calls(batch))
    }

    fn blob(&mut self, payload: &[u8]) -> Result<Event, Damage> {
        let mut decoder = Decoder::new(payload);
        let named = BlobId::from_bytes(decoder.array()?);
        let bytes = decoder.remaining();
        let actual = BlobId::of(bytes);
        if named != actual {
            return Err(Damage::BlobId { named, actual });
        }
        self.counts.blobs += 1;
        Ok(Event::Blob { id: named, data: Data::from(bytes) })
    }

    fn frame_end(&mut self, payload: &[u8]) -> Result<Event, DecodeError> {
        let end = FrameEnd::decode(payload)?;
        self.counts.frames += 1;
        self.last_frame = Some(end.number);
        Ok(Event::FrameEnd(end))
    }

    /// The clean end; what may follow it in the file is not read.
    fn end(&mut self, payload: &[u8]) -> Result<Event, Damage> {
        let counts = Counts::decode(payload)?;
        if counts != self.counts {
            return Err(Damage::Counts);
        }
        self.state = State::Done;
        Ok(Event::End(Ending::Clean(counts)))
    }

    fn truncated(&mut self, lost_bytes: u64) -> Event {
        self.state = State::Done;
        let (counts, last_frame) = (self.counts, self.last_frame);
        Event::End(Ending::Truncated { counts, last_frame, lost_bytes })
    }
}

impl<R: Read> Iterator for TraceReader<R> {
    type Item = Result<Event, TraceError>;

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            match self.state {
                State::Done => return None,
                State::CutHeader(bytes) => return Some(Ok(self.truncated(bytes))),
                State::Reading => {}
            }
            let step = self.step();
            if step.is_err() {
                self.state = State::Done;
            }
            if let Some(item) = step.transpose() {
                return Some(item);
            }
        }
    }
}
