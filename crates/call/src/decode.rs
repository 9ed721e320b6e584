//! Turning bytes back into values.

use crate::data::{BlobId, BlobSource, Data};
use crate::encode::{DATA_BLOB, DATA_INLINE};
use crate::value::Value;

/// The deepest nesting of lists that is decoded; bounds the stack for types that contain
/// themselves.
pub const MAX_NESTING: u32 = 16;

/// Why bytes are not the value they should be, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("byte {offset}: {kind}")]
pub struct DecodeError {
    /// Where the unacceptable part starts, in bytes from the start of the decoded bytes.
    pub offset: usize,
    /// What is wrong there.
    pub kind: DecodeErrorKind,
}

/// What was wrong with the bytes.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum DecodeErrorKind {
    /// A value needs more bytes than are left.
    #[error("{needed} bytes needed, {left} left")]
    UnexpectedEnd {
        /// Bytes the value takes.
        needed: usize,
        /// Bytes there are.
        left: usize,
    },
    /// Bytes remain after a value that should fill them.
    #[error("{count} bytes too many")]
    TrailingBytes {
        /// How many.
        count: usize,
    },
    /// An enum has no variant of this number: damaged, or written by a newer version.
    #[error("unknown tag {tag} of {type_name}")]
    UnknownTag {
        /// The enum that was expected.
        type_name: &'static str,
        /// The number found.
        tag: u16,
    },
    /// A marker byte has none of its possible values.
    #[error("{value} is no {expected}")]
    InvalidMarker {
        /// What the byte should say.
        expected: &'static str,
        /// The byte found.
        value: u8,
    },
    /// A varint does not fit 64 bits, or is longer than it needs to be.
    #[error("malformed varint")]
    MalformedVarint,
    /// A list or data announces more elements than the remaining bytes can hold.
    #[error("length {length} exceeds the {left} bytes left")]
    TooLong {
        /// Elements announced; each takes at least one byte.
        length: u64,
        /// Bytes there are.
        left: usize,
    },
    /// Lists within lists beyond [`MAX_NESTING`].
    #[error("nested deeper than {MAX_NESTING}")]
    TooDeep,
    /// Text that is not UTF-8.
    #[error("text is not utf-8")]
    InvalidText,
    /// Data that is stored elsewhere was not found there.
    #[error("blob {id} is missing")]
    MissingBlob {
        /// The content hash that was asked for.
        id: BlobId,
    },
}

/// A position in bytes, with one method per kind of value.
///
/// No method panics, whatever the bytes are. Memory that is allocated is bounded by a constant
/// (the size of one element) times the number of bytes present, never by an announced length.
#[derive(Clone)]
pub struct Decoder<'a> {
    bytes: &'a [u8],
    offset: usize,
    depth: u32,
    blobs: Option<&'a dyn BlobSource>,
}

impl<'a> Decoder<'a> {
    /// Starts at the first of `bytes`, which hold all data in place.
    pub fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, offset: 0, depth: 0, blobs: None }
    }

    /// Starts at the first of `bytes`, whose large data is found in `blobs`.
    pub fn with_blobs(bytes: &'a [u8], blobs: &'a dyn BlobSource) -> Self {
        Self { bytes, offset: 0, depth: 0, blobs: Some(blobs) }
    }

    /// How many bytes have been read.
    pub fn offset(&self) -> usize {
        self.offset
    }

    /// The bytes not yet read.
    pub fn remaining(&self) -> &'a [u8] {
        &self.bytes[self.offset..]
    }

    /// An error at the current position; for `Value` implementations.
    pub fn error(&self, kind: DecodeErrorKind) -> DecodeError {
        DecodeError { offset: self.offset, kind }
    }

    /// Asserts that nothing is left.
    ///
    /// # Errors
    /// [`DecodeErrorKind::TrailingBytes`].
    pub fn finish(&self) -> Result<(), DecodeError> {
        match self.remaining().len() {
            0 => Ok(()),
            count => Err(self.error(DecodeErrorKind::TrailingBytes { count })),
        }
    }

    /// Reads any value; the same as `T::decode(self)`.
    ///
    /// # Errors
    /// Those of the type.
    pub fn value<T: Value>(&mut self) -> Result<T, DecodeError> {
        T::decode(self)
    }

    /// Reads the next `count` bytes.
    ///
    /// # Errors
    /// [`DecodeErrorKind::UnexpectedEnd`].
    #[inline]
    pub fn raw(&mut self, count: usize) -> Result<&'a [u8], DecodeError> {
        let left = self.remaining();
        let Some(bytes) = left.get(..count) else {
            let kind = DecodeErrorKind::UnexpectedEnd { needed: count, left: left.len() };
            return Err(self.error(kind));
        };
        self.offset += count;
        Ok(bytes)
    }

    /// Reads the next `N` bytes.
    ///
    /// # Errors
    /// [`DecodeErrorKind::UnexpectedEnd`].
    #[inline]
    pub fn array<const N: usize>(&mut self) -> Result<[u8; N], DecodeError> {
        let mut array = [0; N];
        array.copy_from_slice(self.raw(N)?);
        Ok(array)
    }

    /// Reads one byte.
    ///
    /// # Errors
    /// [`DecodeErrorKind::UnexpectedEnd`].
    #[inline]
    pub fn u8(&mut self) -> Result<u8, DecodeError> {
        self.array().map(u8::from_le_bytes)
    }

    /// Reads two bytes.
    ///
    /// # Errors
    /// [`DecodeErrorKind::UnexpectedEnd`].
    #[inline]
    pub fn u16(&mut self) -> Result<u16, DecodeError> {
        self.array().map(u16::from_le_bytes)
    }

    /// Reads four bytes.
    ///
    /// # Errors
    /// [`DecodeErrorKind::UnexpectedEnd`].
    #[inline]
    pub fn u32(&mut self) -> Result<u32, DecodeError> {
        self.array().map(u32::from_le_bytes)
    }

    /// Reads eight bytes.
    ///
    /// # Errors
    /// [`DecodeErrorKind::UnexpectedEnd`].
    #[inline]
    pub fn u64(&mut self) -> Result<u64, DecodeError> {
        self.array().map(u64::from_le_bytes)
    }

    /// Reads the bit pattern of an `f32`; every pattern is accepted and kept.
    ///
    /// # Errors
    /// [`DecodeErrorKind::UnexpectedEnd`].
    #[inline]
    pub fn f32(&mut self) -> Result<f32, DecodeError> {
        self.u32().map(f32::from_bits)
    }

    /// Reads the bit pattern of an `f64`; every pattern is accepted and kept.
    ///
    /// # Errors
    /// [`DecodeErrorKind::UnexpectedEnd`].
    #[inline]
    pub fn f64(&mut self) -> Result<f64, DecodeError> {
        self.u64().map(f64::from_bits)
    }

    /// Reads one byte that is 0 or 1.
    ///
    /// # Errors
    /// [`DecodeErrorKind::InvalidMarker`] for other bytes, [`DecodeErrorKind::UnexpectedEnd`].
    pub fn bool(&mut self) -> Result<bool, DecodeError> {
        Ok(self.marker("truth value", 1)? == 1)
    }

    /// Reads one byte that is at most `last`; `expected` says in errors what it stands for.
    ///
    /// # Errors
    /// [`DecodeErrorKind::InvalidMarker`] for other bytes, [`DecodeErrorKind::UnexpectedEnd`].
    pub fn marker(&mut self, expected: &'static str, last: u8) -> Result<u8, DecodeError> {
        let start = self.offset;
        let value = self.u8()?;
        if value > last {
            let kind = DecodeErrorKind::InvalidMarker { expected, value };
            return Err(DecodeError { offset: start, kind });
        }
        Ok(value)
    }

    /// Reads a varint, in its shortest form only: a value has one encoding.
    ///
    /// # Errors
    /// [`DecodeErrorKind::MalformedVarint`], [`DecodeErrorKind::UnexpectedEnd`].
    pub fn varint(&mut self) -> Result<u64, DecodeError> {
        let start = self.offset;
        let malformed = DecodeError { offset: start, kind: DecodeErrorKind::MalformedVarint };
        let mut value = 0u64;
        for shift in (0..64).step_by(7) {
            let byte = self.u8()?;
            let bits = u64::from(byte & 0x7f);
            if shift == 63 && bits > 1 {
                return Err(malformed);
            }
            value |= bits << shift;
            if byte < 0x80 {
                let padded = byte == 0 && shift > 0;
                return if padded { Err(malformed) } else { Ok(value) };
            }
        }
        Err(malformed)
    }

    /// Reads the length of a list, each element of which takes at least one byte.
    ///
    /// # Errors
    /// [`DecodeErrorKind::TooLong`] if the list cannot fit the bytes left, and those of
    /// [`varint`](Self::varint).
    pub fn length(&mut self) -> Result<usize, DecodeError> {
        let start = self.offset;
        let length = self.varint()?;
        let left = self.remaining().len();
        match usize::try_from(length) {
            Ok(count) if count <= left => Ok(count),
            _ => {
                let kind = DecodeErrorKind::TooLong { length, left };
                Err(DecodeError { offset: start, kind })
            }
        }
    }

    /// Reads a length, then that many bytes.
    ///
    /// # Errors
    /// Those of [`length`](Self::length).
    pub fn bytes_with_length(&mut self) -> Result<&'a [u8], DecodeError> {
        let count = self.length()?;
        self.raw(count)
    }

    /// Reads text.
    ///
    /// # Errors
    /// [`DecodeErrorKind::InvalidText`], and those of [`length`](Self::length).
    pub fn str(&mut self) -> Result<&'a str, DecodeError> {
        let start = self.offset;
        let bytes = self.bytes_with_length()?;
        std::str::from_utf8(bytes)
            .map_err(|_| DecodeError { offset: start, kind: DecodeErrorKind::InvalidText })
    }

    /// Reads a list written by [`Encoder::slice`](crate::Encoder::slice).
    ///
    /// # Errors
    /// [`DecodeErrorKind::TooDeep`], those of [`length`](Self::length) and of the elements.
    pub fn list<T: Value>(&mut self) -> Result<Vec<T>, DecodeError> {
        let count = self.length()?;
        if self.depth == MAX_NESTING {
            return Err(self.error(DecodeErrorKind::TooDeep));
        }
        self.depth += 1;
        let list = T::decode_list(count, self);
        self.depth -= 1;
        list
    }

    /// Reads large data, in place or from the blobs.
    ///
    /// # Errors
    /// [`DecodeErrorKind::MissingBlob`] if there is no such blob, or no blobs at all;
    /// [`DecodeErrorKind::InvalidMarker`], and those of [`length`](Self::length).
    pub fn data(&mut self) -> Result<Data, DecodeError> {
        let start = self.offset;
        if self.marker("form of data", DATA_BLOB)? == DATA_INLINE {
            return self.bytes_with_length().map(Data::from);
        }
        let id = BlobId::from_bytes(self.array()?);
        let found = self.blobs.and_then(|blobs| blobs.find(id));
        found.ok_or(DecodeError { offset: start, kind: DecodeErrorKind::MissingBlob { id } })
    }
}
