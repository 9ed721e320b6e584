//! Turning values into bytes.

use crate::data::{BlobId, Data};
use crate::value::Value;

/// Data of at least this many bytes is set aside as a blob when an encoder sets blobs aside.
///
/// Below it, the 17 bytes of a reference and the chunk around a blob outweigh the sharing.
pub const BLOB_THRESHOLD: usize = 1024;

/// Marks [`Data`] whose bytes follow in place.
pub(crate) const DATA_INLINE: u8 = 0;
/// Marks [`Data`] of which only the blob id follows.
pub(crate) const DATA_BLOB: u8 = 1;

/// A growing byte buffer with one method per kind of value.
///
/// All integers are little endian. Nothing is aligned or padded. Appending allocates only when the
/// buffer has never been that long before: [`clear`](Self::clear) keeps the memory, so that a
/// recorder that reuses one encoder settles at no allocation per call.
#[derive(Debug, Default)]
pub struct Encoder {
    bytes: Vec<u8>,
    blobs: Option<Vec<(BlobId, Data)>>,
}

impl Encoder {
    /// An encoder that writes all data in place: its bytes can be decoded on their own.
    pub fn new() -> Self {
        Self::default()
    }

    /// An encoder that sets data of [`BLOB_THRESHOLD`] bytes and more aside, writing its id only.
    ///
    /// Whoever uses it stores what [`drain_blobs`](Self::drain_blobs) yields before the bytes.
    pub fn with_blobs() -> Self {
        Self { bytes: Vec::new(), blobs: Some(Vec::new()) }
    }

    /// What was written since the last [`clear`](Self::clear).
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// The written bytes, by value.
    pub fn into_bytes(self) -> Vec<u8> {
        self.bytes
    }

    /// Takes out the data that was set aside, in the order in which it was met.
    ///
    /// Equal data met twice appears twice; the store that receives it drops the second.
    pub fn drain_blobs(&mut self) -> impl Iterator<Item = (BlobId, Data)> + '_ {
        self.blobs.iter_mut().flat_map(|blobs| blobs.drain(..))
    }

    /// Forgets the written bytes and the data set aside, and keeps the memory.
    pub fn clear(&mut self) {
        self.bytes.clear();
        if let Some(blobs) = &mut self.blobs {
            blobs.clear();
        }
    }

    /// Appends any value; the same as `value.encode(self)`.
    pub fn value<T: Value>(&mut self, value: &T) {
        value.encode(self);
    }

    /// Appends bytes as they are, without their length.
    #[inline]
    pub fn raw(&mut self, bytes: &[u8]) {
        self.bytes.extend_from_slice(bytes);
    }

    /// Appends one byte.
    #[inline]
    pub fn u8(&mut self, value: u8) {
        self.bytes.push(value);
    }

    /// Appends two bytes.
    #[inline]
    pub fn u16(&mut self, value: u16) {
        self.raw(&value.to_le_bytes());
    }

    /// Appends four bytes.
    #[inline]
    pub fn u32(&mut self, value: u32) {
        self.raw(&value.to_le_bytes());
    }

    /// Appends eight bytes.
    #[inline]
    pub fn u64(&mut self, value: u64) {
        self.raw(&value.to_le_bytes());
    }

    /// Appends the four bytes of the bit pattern: NaN payloads and the sign of zero are kept.
    #[inline]
    pub fn f32(&mut self, value: f32) {
        self.u32(value.to_bits());
    }

    /// Appends the eight bytes of the bit pattern.
    #[inline]
    pub fn f64(&mut self, value: f64) {
        self.u64(value.to_bits());
    }

    /// Appends one byte, 0 or 1.
    #[inline]
    pub fn bool(&mut self, value: bool) {
        self.u8(u8::from(value));
    }

    /// Appends an unsigned integer in groups of seven bits, lowest first, 1 to 10 bytes.
    ///
    /// The high bit of a byte says that another follows. Used for lengths.
    #[inline]
    pub fn varint(&mut self, mut value: u64) {
        while value >= 0x80 {
            self.u8(value as u8 | 0x80);
            value >>= 7;
        }
        self.u8(value as u8);
    }

    /// Appends the length as a varint, then the bytes.
    pub fn bytes_with_length(&mut self, bytes: &[u8]) {
        self.varint(bytes.len() as u64);
        self.raw(bytes);
    }

    /// Appends a text as its UTF-8 bytes with their length.
    pub fn str(&mut self, text: &str) {
        self.bytes_with_length(text.as_bytes());
    }

    /// Appends the number of values as a varint, then each value.
    pub fn slice<T: Value>(&mut self, values: &[T]) {
        self.varint(values.len() as u64);
        T::encode_slice(values, self);
    }

    /// Appends large data: in place, or as a blob id when it is set aside.
    pub fn data(&mut self, data: &Data) {
        match &mut self.blobs {
            Some(blobs) if data.len() >= BLOB_THRESHOLD => {
                let id = data.id();
                blobs.push((id, data.clone()));
                self.u8(DATA_BLOB);
                self.raw(&id.to_bytes());
            }
            _ => {
                self.u8(DATA_INLINE);
                self.bytes_with_length(data);
            }
        }
    }
}
