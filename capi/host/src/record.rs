//! Recording calls into a trace.

use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

use fillrate_call::{Encoder, Value};
use fillrate_trace::{FrameInfo, Meta, TraceError, TraceWriter};

/// Records calls.
pub(crate) struct Recorder {
    writer: TraceWriter<BufWriter<File>>,
    encoder: Encoder,
}

impl Recorder {
    pub fn new(file: &Path, meta: &Meta) -> Result<Recorder, Box<dyn std::error::Error>> {
        let writer = TraceWriter::new(BufWriter::new(File::create(file)?), meta)?;
        Ok(Recorder { writer, encoder: Encoder::with_blobs() })
    }

    pub fn record(&mut self, call: &impl Value) -> Result<(), TraceError> {
        self.encoder.clear();
        call.encode(&mut self.encoder);
        self.writer.record_encoded(&mut self.encoder)
    }

    pub fn end_frame(&mut self, info: FrameInfo) -> Result<(), TraceError> {
        self.writer.end_frame(info)
    }

    pub fn finish(self) -> Result<(), TraceError> {
        self.writer.finish().map(drop)
    }
}
