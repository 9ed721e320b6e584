//! The trace container: calls, frames and large data in a file that survives a kill.
//!
//! The container knows bytes and frames. What the bytes of a call mean is the business of the front
//! end that the trace names. The format is described in `docs/trace-format.md`.
//!
//! ```
//! use fillrate_trace::{Ending, Event, FrameInfo, Meta, TraceReader, TraceWriter, meta};
//!
//! let metadata = Meta::new().with(meta::API, "glide2x");
//! let mut writer = TraceWriter::new(Vec::new(), &metadata)?;
//! writer.record(b"a call")?;
//! writer.end_frame(FrameInfo { width: 640, height: 480, hash: None })?;
//! let file = writer.finish()?;
//!
//! let events: Vec<Event> = TraceReader::new(&file[..])?.collect::<Result<_, _>>()?;
//! let [Event::Meta(found), Event::Calls(calls), Event::FrameEnd(end), Event::End(ending)] =
//!     &events[..]
//! else {
//!     panic!("four events");
//! };
//! assert_eq!(found.get(meta::API), Some("glide2x"));
//! assert_eq!(calls.iter().collect::<Vec<_>>(), [b"a call"]);
//! assert_eq!((end.number, end.info.width), (0, 640));
//! assert!(matches!(ending, Ending::Clean(counts) if counts.frames == 1));
//! # Ok::<(), fillrate_trace::TraceError>(())
//! ```
#![forbid(unsafe_code)]

mod chunk;
mod error;
mod event;
pub mod meta;
mod pixels;
mod reader;
mod writer;

pub use chunk::{MAX_CHUNK_BYTES, VERSION, Version};
pub use error::{Damage, TraceError};
pub use event::{CallBatch, Counts, Ending, Event, FrameEnd, FrameInfo};
pub use fillrate_call::{BlobId, Data};
pub use meta::Meta;
pub use pixels::{PixelsRef, hash_frame};
pub use reader::TraceReader;
pub use writer::{TraceWriter, WriterOptions};
