//! The frame-buffer controller (two pages of colour words) and the depth buffer.
//!
//! Source: RAW, frame-buffer controller (message format, page register) and z-buffer listings.

/// The depth every pixel is cleared to: the far end of the range.
pub const FAR: i32 = i32::MAX;

/// Pages as a mask of the command set: 0 none, 1 back, 2 front, 3 both.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Pages(u32);

impl Pages {
    /// No page.
    pub const NONE: Self = Self(0);
    /// The page that is not displayed.
    pub const BACK: Self = Self(1);
    /// The displayed page.
    pub const FRONT: Self = Self(2);
    /// Both pages.
    pub const BOTH: Self = Self(3);

    /// Reads a page mask from a command; only the low two bits count.
    pub const fn from_word(word: u32) -> Self {
        Self(word & 3)
    }

    /// Whether the back page is selected.
    pub const fn back(self) -> bool {
        self.0 & 1 != 0
    }

    /// Whether the front page is selected.
    pub const fn front(self) -> bool {
        self.0 & 2 != 0
    }

    /// The mask as a word of the command set.
    pub const fn word(self) -> u32 {
        self.0
    }
}

/// Two pages of `width` x `height` colour words; the low byte of a word is unused.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FrameBuffer {
    width: u32,
    height: u32,
    pages: [Vec<u32>; 2],
    /// The number of the displayed page, 0 or 1.
    shown: usize,
}

impl FrameBuffer {
    /// A frame buffer of zeros, showing page 1.
    pub fn new(width: u32, height: u32) -> Self {
        let page = vec![0; width as usize * height as usize];
        Self { width, height, pages: [page.clone(), page], shown: 1 }
    }

    /// Width in pixels.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height in pixels.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The word address of a pixel; coordinates outside wrap as in a linear run.
    pub fn address(&self, x: u32, y: u32) -> u64 {
        u64::from(y) * u64::from(self.width) + u64::from(x)
    }

    /// The words of the back page, or the front page.
    pub fn page(&self, front: bool) -> &[u32] {
        &self.pages[self.index(front)]
    }

    /// The number of the back page, or of the front page: 0 or 1.
    pub fn page_number(&self, front: bool) -> usize {
        self.index(front)
    }

    /// The words of the page of that number.
    pub(crate) fn numbered(&self, number: usize) -> &[u32] {
        &self.pages[number]
    }

    /// The words of the page of that number, to change them.
    pub(crate) fn numbered_mut(&mut self, number: usize) -> &mut [u32] {
        &mut self.pages[number]
    }

    fn index(&self, front: bool) -> usize {
        if front { self.shown } else { 1 - self.shown }
    }

    /// Reads a word; addresses beyond the page give 0.
    pub fn read(&self, address: u64, front: bool) -> u32 {
        self.page(front).get(address as usize).copied().unwrap_or(0)
    }

    /// Writes a word to the selected pages; addresses beyond the page are ignored.
    pub fn write(&mut self, address: u64, pages: Pages, word: u32) {
        for (front, selected) in [(false, pages.back()), (true, pages.front())] {
            let index = self.index(front);
            if let Some(cell) = self.pages[index].get_mut(address as usize).filter(|_| selected) {
                *cell = word;
            }
        }
    }

    /// Fills the selected pages.
    pub fn clear(&mut self, pages: Pages, word: u32) {
        for (front, selected) in [(false, pages.back()), (true, pages.front())] {
            if selected {
                let index = self.index(front);
                self.pages[index].fill(word);
            }
        }
    }

    /// Swaps the displayed page and the back page.
    pub fn flip(&mut self) {
        self.shown = 1 - self.shown;
    }

    /// The controller's reset message: page 1 is displayed, contents stay.
    pub fn reset(&mut self) {
        self.shown = 1;
    }
}

/// Commands of a frame-buffer message: the top three bits of its first payload word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Message {
    /// Write one word.
    Write = 0,
    /// Read one word.
    Read = 1,
    /// Write a run of words.
    WriteBlock = 2,
    /// Read a run of words.
    ReadBlock = 3,
    /// Swap pages now.
    Flip = 4,
    /// Swap pages at vertical sync, then reply.
    FlipSync = 5,
    /// Reset the controller.
    Reset = 7,
}

impl FrameBuffer {
    /// Handles one message as it arrives on the dynamic network, and returns the reply's payload.
    ///
    /// `payload[0]` is the frame-buffer header: command in bits 31-29, page bits 20-19 (01 front,
    /// 10 back), address in 18-0. Empty messages and blocks without a length are ignored, extra
    /// words are drained.
    pub fn message(&mut self, payload: &[u32]) -> Vec<u32> {
        let Some((&header, rest)) = payload.split_first() else { return Vec::new() };
        let address = u64::from(header & 0x7_ffff);
        let pages = Pages::from_word((header >> 20 & 1) | (header >> 19 & 1) << 1);
        let front = header >> 19 & 1 == 1;
        match (header >> 29, rest.first().copied()) {
            (0, Some(word)) => self.write(address, pages, word),
            (1, _) => return vec![self.read(address, front)],
            (2, Some(length)) => {
                for (offset, word) in (0..u64::from(length)).zip(&rest[1..]) {
                    self.write(address + offset, pages, *word);
                }
            }
            // A reply is at most one message long.
            (3, Some(length)) => {
                let count = u64::from(length.min(31));
                return (0..count).map(|i| self.read(address + i, front)).collect();
            }
            (4, _) => self.flip(),
            (5, _) => {
                self.flip();
                return vec![header];
            }
            (7, _) => self.reset(),
            _ => {}
        }
        Vec::new()
    }

    /// Builds the first payload word of a message.
    pub fn header(message: Message, pages: Pages, address: u32) -> u32 {
        let page_bits = u32::from(pages.back()) << 20 | u32::from(pages.front()) << 19;
        (message as u32) << 29 | page_bits | address & 0x7_ffff
    }
}

/// Signed depths, one per pixel: smaller is nearer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DepthBuffer {
    depths: Vec<i32>,
}

impl DepthBuffer {
    /// A buffer of `width` x `height` depths, all [`FAR`].
    pub fn new(width: u32, height: u32) -> Self {
        Self { depths: vec![FAR; width as usize * height as usize] }
    }

    /// Sets every depth to [`FAR`].
    pub fn clear(&mut self) {
        self.depths.fill(FAR);
    }

    /// All depths, row by row.
    pub fn depths(&self) -> &[i32] {
        &self.depths
    }

    /// All depths, to change them.
    pub fn depths_mut(&mut self) -> &mut [i32] {
        &mut self.depths
    }

    /// Reads a depth; addresses beyond the buffer give 0.
    pub fn read(&self, address: u64) -> i32 {
        self.depths.get(address as usize).copied().unwrap_or(0)
    }

    /// Writes a depth; addresses beyond the buffer are ignored.
    pub fn write(&mut self, address: u64, depth: i32) {
        if let Some(cell) = self.depths.get_mut(address as usize) {
            *cell = depth;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_are_separate_and_flip() {
        let mut fb = FrameBuffer::new(4, 2);
        fb.write(3, Pages::BACK, 7);
        fb.write(3, Pages::FRONT, 9);
        assert_eq!((fb.read(3, false), fb.read(3, true)), (7, 9));
        fb.flip();
        assert_eq!((fb.read(3, false), fb.read(3, true)), (9, 7));
        fb.write(99, Pages::BOTH, 1);
        assert_eq!(fb.read(99, true), 0);
    }

    #[test]
    fn messages_follow_the_header() {
        let mut fb = FrameBuffer::new(4, 4);
        let write = FrameBuffer::header(Message::WriteBlock, Pages::BOTH, 2);
        assert!(fb.message(&[write, 2, 10, 11, 12]).is_empty());
        let read = FrameBuffer::header(Message::ReadBlock, Pages::FRONT, 2);
        assert_eq!(fb.message(&[read, 3]), [10, 11, 0]);
        assert_eq!(fb.message(&[0xa000_0000]), [0xa000_0000]);
        assert!(fb.message(&[]).is_empty());
        assert!(fb.message(&[write]).is_empty());
    }
}
