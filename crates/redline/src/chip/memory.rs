//! Video memory as bytes, with a mark on each page of when it last changed.

/// log2 of the bytes of a page.
const PAGE_BITS: u32 = 12;

/// Bytes of video memory. Addresses count from the board's first byte; those
/// beyond the last one read as 0 and cannot be written.
#[derive(Debug)]
pub(crate) struct VideoMemory {
    bytes: Vec<u8>,
    /// When a page last changed, in writes.
    pages: Vec<u64>,
    writes: u64,
}

impl VideoMemory {
    /// Zeros.
    pub fn new(bytes: u32) -> VideoMemory {
        let pages = (bytes >> PAGE_BITS) as usize + 1;
        VideoMemory { bytes: vec![0; bytes as usize], pages: vec![0; pages], writes: 0 }
    }

    /// Bytes there are.
    pub fn len(&self) -> u32 {
        self.bytes.len() as u32
    }

    /// Writes so far.
    pub fn writes(&self) -> u64 {
        self.writes
    }

    /// The last write to any page of a range.
    pub fn changed(&self, address: u32, size: u32) -> u64 {
        let from = (address >> PAGE_BITS) as usize;
        let to = (address.saturating_add(size.saturating_sub(1)) >> PAGE_BITS) as usize;
        let pages = self.pages.get(from..(to + 1).min(self.pages.len())).unwrap_or_default();
        pages.iter().copied().max().unwrap_or(0)
    }

    fn touch(&mut self, address: u32, size: u32) {
        if size == 0 || address >= self.len() {
            return;
        }
        self.writes += 1;
        let to = address.saturating_add(size - 1).min(self.len() - 1) >> PAGE_BITS;
        for page in &mut self.pages[(address >> PAGE_BITS) as usize..=to as usize] {
            *page = self.writes;
        }
    }

    /// The bytes of a range that exist.
    pub fn get(&self, address: u32, size: u32) -> &[u8] {
        let to = address.saturating_add(size).min(self.len());
        self.bytes.get(address as usize..to as usize).unwrap_or_default()
    }

    /// The bytes of a range that exist, to be changed.
    pub fn get_mut(&mut self, address: u32, size: u32) -> &mut [u8] {
        self.touch(address, size);
        let to = address.saturating_add(size).min(self.len());
        self.bytes.get_mut(address as usize..to as usize).unwrap_or_default()
    }

    /// Copies bytes in.
    pub fn write(&mut self, address: u32, bytes: &[u8]) {
        let place = self.get_mut(address, bytes.len() as u32);
        let count = place.len();
        place.copy_from_slice(&bytes[..count]);
    }

    /// Rows of `row` bytes, `pitch` apart, one after another.
    pub fn read_rows(&self, base: u32, pitch: u32, row: u32, rows: u32) -> Vec<u8> {
        let mut out = Vec::with_capacity(row as usize * rows as usize);
        for y in 0..rows {
            let bytes = self.get(base.saturating_add(y.saturating_mul(pitch)), row);
            out.extend_from_slice(bytes);
            out.resize(row as usize * (y as usize + 1), 0);
        }
        out
    }
}
