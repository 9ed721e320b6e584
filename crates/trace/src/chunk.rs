//! Headers of the file and of its chunks, and the compression of chunks.

use std::fmt;

use fillrate_call::{DecodeError, Decoder};

use crate::error::{Damage, TraceError};

/// The first eight bytes. Not text, and damaged by any conversion of line ends.
pub(crate) const MAGIC: [u8; 8] = *b"\x8bFRT\r\n\x1a\n";

/// Bytes before the first chunk.
pub(crate) const FILE_HEADER_BYTES: usize = 16;

/// Bytes of a chunk before its payload.
pub(crate) const CHUNK_HEADER_BYTES: usize = 20;

/// Of those, the ones that the checksum covers: all but the checksum itself.
const CHECKED_HEADER_BYTES: usize = 16;

/// The most bytes that a chunk holds, before compression.
pub const MAX_CHUNK_BYTES: usize = 64 << 20;

/// Flag of a chunk: the payload is an LZ4 block.
const COMPRESSED: u32 = 1;

/// Flags with these bits change the meaning of what follows; a reader must know them. The others
/// may be ignored.
const MANDATORY_FLAGS: u32 = 0xffff;

/// Payloads below this many bytes are not worth an attempt at compression.
const COMPRESS_FROM: usize = 64;

/// The most bytes that one byte of an LZ4 block stands for.
const LZ4_MAX_RATIO: u64 = 255;

/// The version of the format that this crate writes.
pub const VERSION: Version = Version::CURRENT;

/// A version of the format.
///
/// Readers refuse another major number. A higher minor number adds chunk kinds, or fields at the
/// end of a chunk, which older readers skip.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Version {
    /// Raised when older readers would misunderstand.
    pub major: u16,
    /// Raised when something is added that older readers may skip.
    pub minor: u16,
}

impl Version {
    /// What this crate writes.
    pub const CURRENT: Self = Self { major: 1, minor: 0 };
}

impl fmt::Display for Version {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.major, self.minor)
    }
}

/// The kind of a chunk: four ASCII characters.
pub(crate) type Tag = [u8; 4];

/// Keys and values that describe the trace.
pub(crate) const META: Tag = *b"META";
/// Calls.
pub(crate) const CALL: Tag = *b"CALL";
/// Data that calls refer to.
pub(crate) const BLOB: Tag = *b"BLOB";
/// The end of a frame.
pub(crate) const FRAM: Tag = *b"FRAM";
/// The end of a complete trace.
pub(crate) const END: Tag = *b"END ";

/// The file header as written.
pub(crate) fn file_header() -> [u8; FILE_HEADER_BYTES] {
    let mut header = [0; FILE_HEADER_BYTES];
    header[..8].copy_from_slice(&MAGIC);
    header[8..10].copy_from_slice(&VERSION.major.to_le_bytes());
    header[10..12].copy_from_slice(&VERSION.minor.to_le_bytes());
    header
}

/// Checks a complete file header and returns the version in it.
pub(crate) fn parse_file_header(header: &[u8]) -> Result<Version, TraceError> {
    let rest = header.strip_prefix(&MAGIC).ok_or(TraceError::NotATrace)?;
    let mut decoder = Decoder::new(rest);
    let mut fields = || -> Result<_, DecodeError> {
        Ok((Version { major: decoder.u16()?, minor: decoder.u16()? }, decoder.u32()?))
    };
    let (found, flags) = fields().map_err(|_| TraceError::NotATrace)?;
    if found.major != VERSION.major {
        return Err(TraceError::UnsupportedVersion { found });
    }
    if flags & MANDATORY_FLAGS != 0 {
        return Err(TraceError::UnsupportedFlags { offset: 0, flags });
    }
    Ok(found)
}

/// What precedes the payload of a chunk.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ChunkHeader {
    bytes: [u8; CHUNK_HEADER_BYTES],
}

impl ChunkHeader {
    /// The header of a payload as it is stored.
    fn new(tag: Tag, flags: u32, stored: &[u8], raw: usize) -> Self {
        let length = |bytes: usize| u32::try_from(bytes).expect("chunks are far below 4 GiB");
        let mut bytes = [0; CHUNK_HEADER_BYTES];
        bytes[..4].copy_from_slice(&tag);
        bytes[4..8].copy_from_slice(&flags.to_le_bytes());
        bytes[8..12].copy_from_slice(&length(stored.len()).to_le_bytes());
        bytes[12..16].copy_from_slice(&length(raw).to_le_bytes());
        let mut header = Self { bytes };
        let checksum = header.checksum(stored);
        header.bytes[16..].copy_from_slice(&checksum.to_le_bytes());
        header
    }

    /// A header as found in a file; nothing is checked yet.
    pub(crate) fn from_bytes(bytes: [u8; CHUNK_HEADER_BYTES]) -> Self {
        Self { bytes }
    }

    /// The 32-bit field at `offset`.
    fn field(&self, offset: usize) -> u32 {
        let mut field = [0; 4];
        field.copy_from_slice(&self.bytes[offset..offset + 4]);
        u32::from_le_bytes(field)
    }

    pub(crate) fn tag(&self) -> Tag {
        self.field(0).to_le_bytes()
    }

    pub(crate) fn flags(&self) -> u32 {
        self.field(4)
    }

    pub(crate) fn stored_len(&self) -> u32 {
        self.field(8)
    }

    pub(crate) fn raw_len(&self) -> u32 {
        self.field(12)
    }

    /// CRC-32 over the header before the checksum, then the payload as stored. The header is
    /// covered so that a damaged tag is not taken for a chunk of an unknown kind.
    fn checksum(&self, stored: &[u8]) -> u32 {
        let mut hasher = crc32fast::Hasher::new();
        hasher.update(&self.bytes[..CHECKED_HEADER_BYTES]);
        hasher.update(stored);
        hasher.finalize()
    }

    /// Checks what can be known before the payload is read. `offset` is where the chunk starts.
    pub(crate) fn check_lengths(&self, offset: u64) -> Result<(), TraceError> {
        let (stored, raw) = (self.stored_len(), self.raw_len());
        let largest = stored.max(raw);
        if largest as usize > MAX_CHUNK_BYTES {
            let (size, limit) = (largest.into(), MAX_CHUNK_BYTES as u64);
            return Err(TraceError::Limit { what: "chunk", size, limit });
        }
        let possible = match self.flags() & COMPRESSED {
            0 => stored == raw,
            _ => stored < raw && u64::from(raw) <= u64::from(stored) * LZ4_MAX_RATIO,
        };
        if possible {
            Ok(())
        } else {
            Err(TraceError::Format { offset, damage: Damage::Lengths { stored, raw } })
        }
    }

    /// Checks the payload and undoes its compression. The lengths have been checked.
    pub(crate) fn open(&self, offset: u64, stored: Vec<u8>) -> Result<Vec<u8>, TraceError> {
        let (expected, found) = (self.field(16), self.checksum(&stored));
        if expected != found {
            let damage = Damage::Checksum { expected, found };
            return Err(TraceError::Format { offset, damage });
        }
        let flags = self.flags();
        if flags & MANDATORY_FLAGS & !COMPRESSED != 0 {
            return Err(TraceError::UnsupportedFlags { offset, flags });
        }
        if flags & COMPRESSED == 0 {
            return Ok(stored);
        }
        let mut raw = vec![0; self.raw_len() as usize];
        match lz4_flex::block::decompress_into(&stored, &mut raw) {
            Ok(length) if length == raw.len() => Ok(raw),
            _ => Err(TraceError::Format { offset, damage: Damage::Compression }),
        }
    }
}

/// Appends chunks to a buffer, compressed where that makes them smaller.
#[derive(Debug)]
pub(crate) struct ChunkEncoder {
    compress: bool,
    scratch: Vec<u8>,
}

impl ChunkEncoder {
    /// An encoder that compresses, or never does.
    pub(crate) fn new(compress: bool) -> Self {
        Self { compress, scratch: Vec::new() }
    }

    /// Appends one chunk to `out`. The caller has checked `payload` against [`MAX_CHUNK_BYTES`].
    pub(crate) fn append(&mut self, out: &mut Vec<u8>, tag: Tag, payload: &[u8]) {
        let (flags, stored) = match self.compressed(payload) {
            Some(stored) => (COMPRESSED, stored),
            None => (0, payload),
        };
        out.extend_from_slice(&ChunkHeader::new(tag, flags, stored, payload.len()).bytes);
        out.extend_from_slice(stored);
    }

    /// The LZ4 block of `payload`, if it is worth having.
    fn compressed(&mut self, payload: &[u8]) -> Option<&[u8]> {
        if !self.compress || payload.len() < COMPRESS_FROM {
            return None;
        }
        let bound = lz4_flex::block::get_maximum_output_size(payload.len());
        if self.scratch.len() < bound {
            self.scratch.resize(bound, 0);
        }
        let length = lz4_flex::block::compress_into(payload, &mut self.scratch).ok()?;
        (length < payload.len()).then(|| &self.scratch[..length])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn header_fields_are_little_endian_in_order() {
        let header = ChunkHeader::new(CALL, COMPRESSED, &[1, 2, 3], 0x0102_0304);
        assert_eq!(header.bytes[..12], *b"CALL\x01\0\0\0\x03\0\0\0");
        assert_eq!(header.bytes[12..16], [4, 3, 2, 1]);
        assert_eq!(header.tag(), CALL);
        assert_eq!((header.flags(), header.stored_len(), header.raw_len()), (1, 3, 0x0102_0304));
    }

    /// An LZ4 block written by hand: one literal, then 99 bytes from one byte back.
    #[test]
    fn compressed_chunk_opens() {
        // Token: 1 literal, match of 15 + 4 and more; offset 1; 15 + 4 + 70 = 89 bytes.
        // Then the last sequence, literals only: 10 of them.
        let block = [
            0x1f, b'a', 1, 0, 70, 0xa0, b'b', b'b', b'b', b'b', b'b', b'b', b'b', b'b', b'b', b'b',
        ];
        let header = ChunkHeader::new(BLOB, COMPRESSED, &block, 100);
        header.check_lengths(0).expect("lengths agree");
        let expected = ["a".repeat(90), "b".repeat(10)].concat();
        assert_eq!(header.open(0, block.to_vec()).expect("opens"), expected.as_bytes());
    }

    #[test]
    fn incompressible_payload_is_stored_as_it_is() {
        let noise: Vec<u8> =
            (0..200u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
        let mut out = Vec::new();
        ChunkEncoder::new(true).append(&mut out, BLOB, &noise);
        assert_eq!(out[4..8], [0; 4]);
        assert_eq!(out[CHUNK_HEADER_BYTES..], noise);
    }

    #[test]
    fn repetitive_payload_shrinks_unless_told_not_to() {
        let zeros = [0; 1000];
        for (compress, flag) in [(true, 1), (false, 0)] {
            let mut out = Vec::new();
            ChunkEncoder::new(compress).append(&mut out, BLOB, &zeros);
            assert_eq!(out[4], flag);
            assert_eq!(out.len() < 100, compress);
        }
    }
}
