//! Any bytes through the trace reader: no panic, no large allocation, an end.
//!
//! Bytes alone would hardly ever pass a checksum, so that half of the inputs are chunks that are
//! given a valid header first.

#![no_main]

use arbitrary::Arbitrary;
use fillrate_trace::{Event, TraceReader};
use libfuzzer_sys::fuzz_target;

/// What the fuzzer varies.
#[derive(Arbitrary, Debug)]
enum Input {
    /// A whole file.
    File(Vec<u8>),
    /// The chunks of a file of the current version.
    Chunks(Vec<Chunk>),
}

/// A chunk whose checksum will be right.
#[derive(Arbitrary, Debug)]
struct Chunk {
    tag: u8,
    compressed: bool,
    raw_len: u32,
    stored: Vec<u8>,
}

const HEADER: &[u8] = b"\x8bFRT\r\n\x1a\n\x01\0\0\0\0\0\0\0";
const TAGS: [&[u8; 4]; 6] = [b"META", b"CALL", b"BLOB", b"FRAM", b"END ", b"NEW!"];

impl Chunk {
    /// The bytes of the chunk.
    fn to_bytes(&self) -> Vec<u8> {
        let stored_len = self.stored.len() as u32;
        let raw_len = if self.compressed { self.raw_len } else { stored_len };
        let mut bytes = TAGS[usize::from(self.tag) % TAGS.len()].to_vec();
        for field in [u32::from(self.compressed), stored_len, raw_len] {
            bytes.extend(field.to_le_bytes());
        }
        let mut hasher = crc32fast::Hasher::new();
        hasher.update(&bytes);
        hasher.update(&self.stored);
        bytes.extend(hasher.finalize().to_le_bytes());
        bytes.extend(&self.stored);
        bytes
    }
}

/// Reads everything, and the calls in it.
fn read(file: &[u8]) {
    let Ok(reader) = TraceReader::new(file) else { return };
    for event in reader {
        if let Ok(Event::Calls(batch)) = event {
            assert_eq!(batch.iter().count(), batch.len());
        }
    }
}

fuzz_target!(|input: Input| match input {
    Input::File(bytes) => read(&bytes),
    Input::Chunks(chunks) => {
        let chunks = chunks.iter().flat_map(Chunk::to_bytes);
        read(&HEADER.iter().copied().chain(chunks).collect::<Vec<_>>());
    }
});
