//! Recording calls into a trace file.

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

use fillrate_call::{Encoder, Value};
use fillrate_player::Frame;
use fillrate_trace::{FrameInfo, Meta, TraceError, TraceWriter};

/// Records calls.
pub struct Recorder {
    writer: TraceWriter<BufWriter<File>>,
    encoder: Encoder,
}

impl Recorder {
    /// Starts a trace of the calls of `api`. `more` says what a replay has to know besides.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn new(file: &Path, api: &str, more: &[(&str, &str)]) -> Result<Recorder, Box<dyn Error>> {
        let program = std::env::args().next().unwrap_or_default();
        let meta = Meta::new().with("api", api).with("program", program);
        let meta = more.iter().fold(meta, |meta, (key, value)| meta.with(*key, *value));
        let meta = meta.with("creator", concat!("fillrate ", env!("CARGO_PKG_VERSION")));
        let writer = TraceWriter::new(BufWriter::new(File::create(file)?), &meta)?;
        Ok(Recorder { writer, encoder: Encoder::with_blobs() })
    }

    /// Records a call.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn record(&mut self, call: &impl Value) -> Result<(), TraceError> {
        self.encoder.clear();
        call.encode(&mut self.encoder);
        self.writer.record_encoded(&mut self.encoder)
    }

    /// Ends a frame, with its hash.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn frame(&mut self, frame: &Frame) -> Result<(), TraceError> {
        let (width, height) = (frame.width(), frame.height());
        self.writer.end_frame(FrameInfo { width, height, hash: Some(frame.hash()) })
    }

    /// Writes out what is buffered.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn flush(&mut self) -> Result<(), TraceError> {
        self.writer.flush()
    }

    /// Ends the trace.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn finish(self) -> Result<(), TraceError> {
        self.writer.finish().map(|_| ())
    }
}
