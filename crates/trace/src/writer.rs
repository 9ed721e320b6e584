//! Writing traces.

use std::collections::HashSet;
use std::io::Write;

use fillrate_call::{BlobId, Encoder};

use crate::chunk::{self, BLOB, CALL, ChunkEncoder, END, FRAM, MAX_CHUNK_BYTES, META, Tag};
use crate::error::TraceError;
use crate::event::{Counts, FrameEnd, FrameInfo};
use crate::meta::Meta;

/// The most bytes that the length before a record takes.
const MAX_LENGTH_BYTES: usize = 10;

/// How many blobs are remembered. Beyond it the memory starts over, and data that comes again is
/// stored again: correct, and bounded however long a recording runs.
const MAX_KNOWN_BLOBS: usize = 1 << 20;

/// How a trace is written.
#[derive(Clone, Copy, Debug)]
pub struct WriterOptions {
    /// Calls are gathered into chunks of about this many bytes, 1 to [`MAX_CHUNK_BYTES`]. No more
    /// than about twice this and one blob is held in memory.
    pub batch_bytes: usize,
    /// Whether chunks are compressed where that makes them smaller.
    pub compress: bool,
}

impl Default for WriterOptions {
    /// Chunks of 1 MiB, compressed.
    fn default() -> Self {
        Self { batch_bytes: 1 << 20, compress: true }
    }
}

/// Writes one trace.
///
/// Whole chunks only reach `W`, and all that belongs to a frame has reached it when
/// [`end_frame`](Self::end_frame) returns. A trace that is dropped without
/// [`finish`](Self::finish) lacks the calls after its last frame and reads as truncated.
#[derive(Debug)]
pub struct TraceWriter<W: Write> {
    file: W,
    chunks: ChunkEncoder,
    batch_bytes: usize,
    /// Chunks that have not reached `file`.
    pending: Vec<u8>,
    /// Records of the chunk of calls that is being gathered.
    calls: Encoder,
    known_blobs: HashSet<BlobId>,
    counts: Counts,
    failed: bool,
}

impl<W: Write> TraceWriter<W> {
    /// Starts a trace with the default options. The header and `meta` are written at once.
    ///
    /// # Errors
    /// [`TraceError::Io`]; [`TraceError::Limit`] for metadata beyond [`MAX_CHUNK_BYTES`].
    pub fn new(file: W, meta: &Meta) -> Result<Self, TraceError> {
        Self::with_options(file, meta, WriterOptions::default())
    }

    /// Starts a trace.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_options(file: W, meta: &Meta, options: WriterOptions) -> Result<Self, TraceError> {
        let mut writer = Self {
            file,
            chunks: ChunkEncoder::new(options.compress),
            batch_bytes: options.batch_bytes.clamp(1, MAX_CHUNK_BYTES),
            pending: chunk::file_header().to_vec(),
            calls: Encoder::new(),
            known_blobs: HashSet::new(),
            counts: Counts::default(),
            failed: false,
        };
        writer.append(META, "metadata", &meta.encode())?;
        writer.flush()?;
        Ok(writer)
    }

    /// Adds one encoded call.
    ///
    /// # Errors
    /// [`TraceError::Io`]; [`TraceError::Limit`] for a call that no chunk can hold, which is not
    /// recorded; [`TraceError::Usage`] after an earlier I/O error.
    pub fn record(&mut self, call: &[u8]) -> Result<(), TraceError> {
        check_size("call", call.len(), MAX_CHUNK_BYTES - MAX_LENGTH_BYTES)?;
        let gathered = self.calls.bytes().len();
        if gathered > 0 && gathered + call.len() + MAX_LENGTH_BYTES > self.batch_bytes {
            self.close_batch()?;
        }
        self.calls.bytes_with_length(call);
        self.counts.calls += 1;
        Ok(())
    }

    /// Stores data that calls recorded from now on may refer to, unless it is stored already.
    ///
    /// # Errors
    /// As [`record`](Self::record).
    pub fn blob(&mut self, data: &[u8]) -> Result<BlobId, TraceError> {
        let id = BlobId::of(data);
        self.blob_with_id(id, data)?;
        Ok(id)
    }

    /// Stores everything that `encoder` has set aside, then records what it has written.
    ///
    /// # Errors
    /// As [`record`](Self::record).
    pub fn record_encoded(&mut self, encoder: &mut Encoder) -> Result<(), TraceError> {
        for (id, data) in encoder.drain_blobs() {
            self.blob_with_id(id, &data)?;
        }
        self.record(encoder.bytes())
    }

    /// Ends the frame to which the calls since the last end belong, writes it out and flushes.
    ///
    /// # Errors
    /// [`TraceError::Io`]; [`TraceError::Limit`] after 2^32 frames; [`TraceError::Usage`] after an
    /// earlier I/O error.
    pub fn end_frame(&mut self, info: FrameInfo) -> Result<(), TraceError> {
        let number = u32::try_from(self.counts.frames).map_err(|_| TraceError::Limit {
            what: "frame number",
            size: self.counts.frames,
            limit: u32::MAX.into(),
        })?;
        self.close_batch()?;
        self.append(FRAM, "frame", &FrameEnd { number, info }.encode())?;
        self.counts.frames += 1;
        self.flush()
    }

    /// Writes out all that was recorded, even in the middle of a frame.
    ///
    /// # Errors
    /// [`TraceError::Io`]; [`TraceError::Usage`] after an earlier I/O error.
    pub fn flush(&mut self) -> Result<(), TraceError> {
        self.close_batch()?;
        self.write_pending()?;
        let flushed = self.file.flush();
        self.failed |= flushed.is_err();
        Ok(flushed?)
    }

    /// Ends the trace and gives the file back.
    ///
    /// # Errors
    /// As [`flush`](Self::flush).
    pub fn finish(mut self) -> Result<W, TraceError> {
        self.close_batch()?;
        self.append(END, "counts", &self.counts.encode())?;
        self.flush()?;
        Ok(self.file)
    }

    /// What has been recorded so far.
    pub fn counts(&self) -> Counts {
        self.counts
    }

    /// Stores `data`, the id of which is known, unless it is stored already.
    fn blob_with_id(&mut self, id: BlobId, data: &[u8]) -> Result<(), TraceError> {
        let id_bytes = id.to_bytes();
        check_size("blob", data.len(), MAX_CHUNK_BYTES - id_bytes.len())?;
        if self.known_blobs.contains(&id) {
            return Ok(());
        }
        // The batch of calls stays open: a blob need only precede the calls that refer to it.
        self.append(BLOB, "blob", &[&id_bytes, data].concat())?;
        self.counts.blobs += 1;
        if self.known_blobs.len() == MAX_KNOWN_BLOBS {
            self.known_blobs.clear();
        }
        self.known_blobs.insert(id);
        Ok(())
    }

    /// Turns the gathered calls, if any, into a chunk.
    fn close_batch(&mut self) -> Result<(), TraceError> {
        if self.calls.bytes().is_empty() {
            return Ok(());
        }
        self.chunks.append(&mut self.pending, CALL, self.calls.bytes());
        self.calls.clear();
        self.write_if_large()
    }

    /// Adds a chunk of any other kind.
    fn append(&mut self, tag: Tag, what: &'static str, payload: &[u8]) -> Result<(), TraceError> {
        check_size(what, payload.len(), MAX_CHUNK_BYTES)?;
        self.chunks.append(&mut self.pending, tag, payload);
        self.write_if_large()
    }

    /// Bounds the memory that waits for the end of the frame.
    fn write_if_large(&mut self) -> Result<(), TraceError> {
        if self.pending.len() < self.batch_bytes { Ok(()) } else { self.write_pending() }
    }

    /// Hands the finished chunks to the file.
    fn write_pending(&mut self) -> Result<(), TraceError> {
        // After a failed write the file may end within a chunk: anything that follows would be
        // taken for its rest.
        if self.failed {
            return Err(TraceError::Usage);
        }
        let written = self.file.write_all(&self.pending);
        self.failed = written.is_err();
        self.pending.clear();
        Ok(written?)
    }
}

/// Asserts a limit of the format.
fn check_size(what: &'static str, size: usize, limit: usize) -> Result<(), TraceError> {
    if size <= limit {
        return Ok(());
    }
    Err(TraceError::Limit { what, size: size as u64, limit: limit as u64 })
}
