//! The trace container through its public interface.

mod corrupt;
mod cut;
mod document;
mod forge;
mod round_trip;
mod versions;

use fillrate_trace::{Event, FrameInfo, Meta, TraceError, TraceReader, TraceWriter, meta};

/// A frame of one size, with a hash.
pub fn frame(hash: u64) -> FrameInfo {
    FrameInfo { width: 640, height: 480, hash: Some(hash) }
}

/// A small trace of three frames that has a chunk of every kind, one of them compressed.
pub fn sample() -> Vec<u8> {
    let about = Meta::new().with(meta::API, "test").with(meta::PROGRAM, "sample");
    let mut writer = TraceWriter::new(Vec::new(), &about).expect("memory");
    for number in 0..3u8 {
        writer.blob(&[number; 200]).expect("memory");
        writer.record(&[number, 1, 2, 3]).expect("memory");
        writer.record(&[]).expect("memory");
        writer.end_frame(frame(number.into())).expect("memory");
    }
    writer.finish().expect("memory")
}

/// All events, up to the first error if there is one.
pub fn read(file: &[u8]) -> (Vec<Event>, Option<TraceError>) {
    let mut events = Vec::new();
    let reader = match TraceReader::new(file) {
        Ok(reader) => reader,
        Err(error) => return (events, Some(error)),
    };
    for event in reader {
        match event {
            Ok(event) => events.push(event),
            Err(error) => return (events, Some(error)),
        }
    }
    (events, None)
}

/// All events of a trace without damage.
pub fn read_all(file: &[u8]) -> Vec<Event> {
    match read(file) {
        (events, None) => events,
        (_, Some(error)) => panic!("{error}"),
    }
}
