//! What a reader delivers.

use std::fmt;

use fillrate_call::{BlobId, Data, DecodeError, Decoder, Encoder};

use crate::meta::Meta;

/// Flag of a frame: its pixels were hashed.
const FRAME_HASHED: u32 = 1;

/// One step through a trace.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Event {
    /// Keys and values; the first event of a trace, and possible again later.
    Meta(Meta),
    /// Calls, in order.
    Calls(CallBatch),
    /// Data that later calls may refer to.
    Blob {
        /// Its content hash, which has been verified.
        id: BlobId,
        /// The bytes.
        data: Data,
    },
    /// A frame is complete.
    FrameEnd(FrameEnd),
    /// The last event.
    End(Ending),
}

/// What is known of a complete frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameInfo {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Hash of the pixels, if it was taken: see [`hash_frame`](crate::hash_frame).
    pub hash: Option<u64>,
}

/// The end of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameEnd {
    /// Counts from 0 in the recording.
    pub number: u32,
    /// Size and hash.
    pub info: FrameInfo,
}

impl FrameEnd {
    /// The payload of a chunk with this frame: 24 bytes.
    pub(crate) fn encode(&self) -> Vec<u8> {
        let mut encoder = Encoder::new();
        encoder.u32(self.number);
        encoder.u32(self.info.width);
        encoder.u32(self.info.height);
        encoder.u32(if self.info.hash.is_some() { FRAME_HASHED } else { 0 });
        encoder.u64(self.info.hash.unwrap_or(0));
        encoder.into_bytes()
    }

    /// The frame in the payload of a chunk. Further bytes belong to a later minor version.
    pub(crate) fn decode(payload: &[u8]) -> Result<Self, DecodeError> {
        let mut decoder = Decoder::new(payload);
        let number = decoder.u32()?;
        let (width, height) = (decoder.u32()?, decoder.u32()?);
        let flags = decoder.u32()?;
        let hash = decoder.u64()?;
        let hash = (flags & FRAME_HASHED != 0).then_some(hash);
        Ok(Self { number, info: FrameInfo { width, height, hash } })
    }
}

/// Some calls of one frame, in order, as the bytes that were recorded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CallBatch {
    /// Records, each a length and that many bytes; the framing has been checked.
    payload: Vec<u8>,
    count: usize,
}

impl CallBatch {
    /// The calls in the payload of a chunk.
    pub(crate) fn decode(payload: Vec<u8>) -> Result<Self, DecodeError> {
        let mut decoder = Decoder::new(&payload);
        let mut count = 0;
        while !decoder.remaining().is_empty() {
            decoder.bytes_with_length()?;
            count += 1;
        }
        Ok(Self { payload, count })
    }

    /// How many calls there are.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The calls in order.
    pub fn iter(&self) -> Calls<'_> {
        Calls { decoder: Decoder::new(&self.payload) }
    }
}

impl<'a> IntoIterator for &'a CallBatch {
    type Item = &'a [u8];
    type IntoIter = Calls<'a>;

    fn into_iter(self) -> Calls<'a> {
        self.iter()
    }
}

/// The calls of a [`CallBatch`].
#[derive(Clone)]
pub struct Calls<'a> {
    decoder: Decoder<'a>,
}

impl<'a> Iterator for Calls<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        // The framing was checked in `CallBatch::decode`, so that the only error left is the end.
        self.decoder.bytes_with_length().ok()
    }
}

/// How much a trace holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Complete frames.
    pub frames: u64,
    /// Calls.
    pub calls: u64,
    /// Blobs as stored; the same data may have been stored twice in a very long trace.
    pub blobs: u64,
}

impl Counts {
    /// The payload of the end chunk: 24 bytes.
    pub(crate) fn encode(&self) -> Vec<u8> {
        let mut encoder = Encoder::new();
        encoder.u64(self.frames);
        encoder.u64(self.calls);
        encoder.u64(self.blobs);
        encoder.into_bytes()
    }

    /// The counts in the payload of the end chunk.
    pub(crate) fn decode(payload: &[u8]) -> Result<Self, DecodeError> {
        let mut decoder = Decoder::new(payload);
        Ok(Self { frames: decoder.u64()?, calls: decoder.u64()?, blobs: decoder.u64()? })
    }
}

/// How a trace ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// The recorder closed it.
    Clean(Counts),
    /// The recorder was stopped, or the file was cut: what was delivered is all there is.
    Truncated {
        /// What was delivered.
        counts: Counts,
        /// The number of the last complete frame.
        last_frame: Option<u32>,
        /// Bytes of an incomplete chunk at the end of the file that were not delivered.
        lost_bytes: u64,
    },
}

impl Ending {
    /// What was delivered.
    pub fn counts(&self) -> Counts {
        match *self {
            Self::Clean(counts) | Self::Truncated { counts, .. } => counts,
        }
    }

    /// Whether the trace lacks its end.
    pub fn is_truncated(&self) -> bool {
        matches!(self, Self::Truncated { .. })
    }
}

impl fmt::Display for Ending {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Clean(_) => f.write_str("complete"),
            Self::Truncated { last_frame: Some(number), .. } => {
                write!(f, "truncated after frame {number}")
            }
            Self::Truncated { last_frame: None, .. } => {
                f.write_str("truncated before the end of the first frame")
            }
        }
    }
}
