//! Files that no writer makes, with valid checksums.

/// Bytes of the file header.
pub const FILE_HEADER: usize = 16;

/// A file header of any version and flags.
pub fn header(major: u16, minor: u16, flags: u32) -> Vec<u8> {
    let mut bytes = b"\x8bFRT\r\n\x1a\n".to_vec();
    bytes.extend(major.to_le_bytes());
    bytes.extend(minor.to_le_bytes());
    bytes.extend(flags.to_le_bytes());
    bytes
}

/// A chunk as the format describes it, whose stored bytes stand for `raw_len` bytes.
pub fn chunk_of(tag: &[u8; 4], flags: u32, stored: &[u8], raw_len: u32) -> Vec<u8> {
    let mut bytes = tag.to_vec();
    bytes.extend(flags.to_le_bytes());
    bytes.extend((stored.len() as u32).to_le_bytes());
    bytes.extend(raw_len.to_le_bytes());
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&bytes);
    hasher.update(stored);
    bytes.extend(hasher.finalize().to_le_bytes());
    bytes.extend(stored);
    bytes
}

/// An uncompressed chunk.
pub fn chunk(tag: &[u8; 4], payload: &[u8]) -> Vec<u8> {
    chunk_of(tag, 0, payload, payload.len() as u32)
}

/// A file of the current version with these chunks.
pub fn file(chunks: &[Vec<u8>]) -> Vec<u8> {
    let mut bytes = header(1, 0, 0);
    bytes.extend(chunks.concat());
    bytes
}
