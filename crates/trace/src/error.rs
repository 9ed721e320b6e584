//! What can go wrong with a trace, sorted by who must act.

use std::io;

use fillrate_call::{BlobId, DecodeError};

use crate::chunk::Version;

/// Why a trace cannot be written or read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TraceError {
    /// The file below failed. A file that merely ends is no error: see
    /// [`Ending::Truncated`](crate::Ending::Truncated).
    #[error("trace file cannot be read or written")]
    Io(#[from] io::Error),
    /// The file does not start as a trace does.
    #[error("not a fillrate trace")]
    NotATrace,
    /// The file was written in a version of the format with another meaning.
    #[error(
        "trace format {found} is not supported: this reader knows format {}.x",
        Version::CURRENT.major
    )]
    UnsupportedVersion {
        /// The version in the file.
        found: Version,
    },
    /// The file, or a chunk of it, uses a mandatory feature that this reader lacks.
    #[error("byte {offset}: unknown mandatory feature in flags {flags:#x}")]
    UnsupportedFlags {
        /// Where the header with the flags starts, in bytes from the start of the file.
        offset: u64,
        /// The flags found.
        flags: u32,
    },
    /// The file is not what was written. Everything before the damage has been delivered.
    #[error("byte {offset}: damaged trace: {damage}")]
    Format {
        /// Where the damaged chunk starts, in bytes from the start of the file.
        offset: u64,
        /// What is wrong with it.
        damage: Damage,
    },
    /// Something is larger than the format allows.
    #[error("{what} of {size} bytes exceeds the limit of {limit} bytes")]
    Limit {
        /// What is too large.
        what: &'static str,
        /// Its size in bytes.
        size: u64,
        /// The largest size allowed, in bytes.
        limit: u64,
    },
    /// A writer was used again after it had failed.
    #[error("trace writer was used after an error")]
    Usage,
}

/// What is wrong with a chunk.
#[derive(Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Damage {
    /// The bytes are not those that were written.
    #[error("checksum is {found:#010x}, should be {expected:#010x}")]
    Checksum {
        /// The checksum stored in the chunk header.
        expected: u32,
        /// The checksum of the bytes found.
        found: u32,
    },
    /// The two lengths of a chunk contradict one another.
    #[error("{stored} stored bytes cannot hold {raw} bytes")]
    Lengths {
        /// Bytes in the file.
        stored: u32,
        /// Bytes they stand for.
        raw: u32,
    },
    /// The compressed bytes do not expand to the announced length.
    #[error("compressed data is malformed")]
    Compression,
    /// The content is not that of a chunk of this kind.
    #[error("content: {0}")]
    Content(#[from] DecodeError),
    /// A blob is not the data that its id names.
    #[error("blob is named {named} but is {actual}")]
    BlobId {
        /// The id stored with the data.
        named: BlobId,
        /// The id of the data.
        actual: BlobId,
    },
    /// The end chunk counts frames, records or blobs that did not occur.
    #[error("end counts differ from the content")]
    Counts,
}
