//! Large data of calls: texture images, linear frame buffer contents.

use std::collections::HashMap;
use std::fmt;
use std::ops::Deref;
use std::sync::Arc;

use xxhash_rust::xxh3::xxh3_128;

/// The name of large data: its XXH3 hash of 128 bits, seed 0.
///
/// Equal bytes have equal ids. Stored as 16 bytes, least significant first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BlobId(u128);

impl BlobId {
    /// The id of these bytes.
    pub fn of(bytes: &[u8]) -> Self {
        Self(xxh3_128(bytes))
    }

    /// The id as stored.
    pub fn to_bytes(self) -> [u8; 16] {
        self.0.to_le_bytes()
    }

    /// The id from its stored form.
    pub fn from_bytes(bytes: [u8; 16]) -> Self {
        Self(u128::from_le_bytes(bytes))
    }
}

impl fmt::Display for BlobId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:032x}", self.0)
    }
}

impl fmt::Debug for BlobId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "BlobId({self})")
    }
}

/// Bytes of a call that may be large; cheap to clone.
///
/// Use it for arguments such as a texture image, `Vec<u8>` for small ones: a recorder stores equal
/// `Data` once, however often a program downloads it.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Data(Arc<[u8]>);

impl Data {
    /// The id under which these bytes are stored; hashes them each time.
    pub fn id(&self) -> BlobId {
        BlobId::of(&self.0)
    }
}

impl Default for Data {
    fn default() -> Self {
        Self(Arc::from([]))
    }
}

impl Deref for Data {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        &self.0
    }
}

impl From<&[u8]> for Data {
    fn from(bytes: &[u8]) -> Self {
        Self(bytes.into())
    }
}

impl From<Vec<u8>> for Data {
    fn from(bytes: Vec<u8>) -> Self {
        Self(bytes.into())
    }
}

impl fmt::Debug for Data {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Data({} bytes, {})", self.len(), self.id())
    }
}

/// Where a decoder finds data that was set aside.
pub trait BlobSource {
    /// The data of this id, if it is known.
    fn find(&self, id: BlobId) -> Option<Data>;
}

impl BlobSource for HashMap<BlobId, Data> {
    fn find(&self, id: BlobId) -> Option<Data> {
        self.get(&id).cloned()
    }
}
