//! Call values: one description of a historic entry point serves encoding, decoding, naming and
//! printing.
//!
//! A front end lists its entry points once with [`value_enum!`], its argument records with
//! [`value_struct!`] and its enumerants with [`value_symbols!`]. The result is plain data that can
//! be turned into bytes and back. This crate knows nothing of files: how encoded calls are stored
//! is the business of the trace container.
//!
//! ```
//! use fillrate_call::{Tagged, Value, from_bytes, to_bytes, value_enum, value_struct};
//!
//! value_struct! {
//!     /// A corner of a triangle.
//!     #[derive(Copy)]
//!     pub struct Corner {
//!         /// Distance from the left edge, in pixels.
//!         pub x: f32,
//!         /// Distance from the origin's edge, in pixels.
//!         pub y: f32,
//!     }
//! }
//!
//! value_enum! {
//!     /// Everything a program can ask of this system.
//!     pub enum Call {
//!         /// Starts the system.
//!         1 => Init {},
//!         /// Draws one triangle.
//!         2 => DrawTriangle { a: Corner, b: Corner, c: Corner },
//!         /// Fills the buffers.
//!         3 => BufferClear { color: u32, alpha: u8, depth: u16 },
//!     }
//! }
//!
//! let call = Call::BufferClear { color: 0xff, alpha: 1, depth: 0xffff };
//! let bytes = to_bytes(&call);
//! assert_eq!(bytes, [3, 0, 0xff, 0, 0, 0, 1, 0xff, 0xff]);
//! assert_eq!(from_bytes::<Call>(&bytes), Ok(call.clone()));
//! assert_eq!(call.name(), "BufferClear");
//! assert_eq!(call.to_string(), "BufferClear(color=255, alpha=1, depth=65535)");
//! ```
#![forbid(unsafe_code)]

mod data;
mod decode;
mod encode;
mod macros;
mod show;
mod tagged;
mod value;

pub use data::{BlobId, BlobSource, Data};
pub use decode::{DecodeError, DecodeErrorKind, Decoder, MAX_NESTING};
pub use encode::{BLOB_THRESHOLD, Encoder};
pub use show::{Field, Fields, Shown, show_record};
pub use tagged::{Tagged, assert_distinct_tags};
pub use value::{Value, from_bytes, to_bytes};
