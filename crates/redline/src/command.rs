//! Command buffers: words and references to host memory, in sequence.
//!
//! Recording is host work and crosses no border: functions of
//! [`crate::record`] write words into a [`CommandSink`]. What is issued is the
//! contents of a buffer as [`Segment`]s, with the memory that its DMA entries
//! refer to as it is at that moment.
//!
//! Source: RR, command buffers and DMA.

use fillrate_call::{Data, value_struct};

use crate::error::{Failure, VError, VRoutine};

/// The most words of a command list.
pub const MAX_CMD_WORDS: usize = 1 << 22;
/// The most entries of a DMA list.
pub const MAX_DMA_ENTRIES: usize = 1 << 16;
/// The most words of one block of a DMA list: a count of 22 bits.
pub const MAX_BLOCK_WORDS: u32 = (1 << 22) - 1;
/// Bytes of a page of locked memory.
pub const PAGE_BYTES: u64 = 4096;

/// How the words of a DMA block are rearranged on their way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Port {
    /// As they are.
    #[default]
    Word = 0,
    /// The four bytes reversed.
    Byte = 1,
    /// The bytes of each half exchanged.
    Other = 2,
    /// The halves exchanged.
    Short = 3,
}

impl Port {
    /// The port with this number.
    pub fn from_number(number: u32) -> Option<Port> {
        [Port::Word, Port::Byte, Port::Other, Port::Short].get(number as usize).copied()
    }

    /// One word after it has passed.
    #[inline]
    pub fn pass(self, word: u32) -> u32 {
        match self {
            Port::Word => word,
            Port::Byte => word.swap_bytes(),
            Port::Other => (word & 0x00ff_00ff) << 8 | word >> 8 & 0x00ff_00ff,
            Port::Short => word.rotate_left(16),
        }
    }
}

/// A reference to host memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DmaBlock {
    /// How its words are rearranged.
    pub port: Port,
    /// The memory object; what numbers mean is up to the [`HostMemory`].
    pub memory: u64,
    /// Where the block starts in it, in bytes; a multiple of 4.
    pub offset: u64,
    /// Its length in words.
    pub words: u32,
}

impl DmaBlock {
    /// DMA entries it needs: one for each page that it touches
    /// (`V_GetDMAEntries`). The object counts as starting at a page.
    pub fn entries(&self) -> u32 {
        dma_entries(self.offset, self.words)
    }
}

/// See [`DmaBlock::entries`].
pub fn dma_entries(offset: u64, words: u32) -> u32 {
    if words == 0 {
        return 0;
    }
    let last = offset.saturating_add(u64::from(words) * 4 - 1);
    u32::try_from(last / PAGE_BYTES - offset / PAGE_BYTES + 1).unwrap_or(u32::MAX)
}

/// Where commands are written.
///
/// A sink may change buffers in [`reserve`](CommandSink::reserve) when one is
/// full, as the overflow callback of C programs does; a command is never split
/// because it reserves all it needs at once.
pub trait CommandSink {
    /// Makes room for `words` words and `entries` DMA entries, and appends the
    /// words, which the caller fills.
    ///
    /// # Errors
    /// [`VError::CmdBufferTooSmall`], [`VError::CmdBufferNoDmaEntries`], and
    /// whatever the sink's way of making room can fail with.
    fn reserve(&mut self, words: usize, entries: usize) -> Result<&mut [u32], VError>;

    /// Appends a reference to memory, for which there must be room.
    ///
    /// # Errors
    /// [`VError::CmdBufferNoDmaEntries`], [`VError::ParamError`] for blocks that
    /// are too long or whose offset is no multiple of 4.
    fn add_dma(&mut self, block: DmaBlock) -> Result<(), VError>;

    /// Whether the board knows vertices with specular colours. Recording for
    /// boards that do not refuses them.
    fn has_specular(&self) -> bool {
        true
    }
}

/// Where the memory of DMA blocks is found.
pub trait HostMemory {
    /// Appends the block's bytes as they are now to `out`.
    ///
    /// # Errors
    /// [`VError::ParamError`] where there is no such memory, or not that much of
    /// it; nothing is appended then.
    fn read(&self, block: &DmaBlock, out: &mut Vec<u8>) -> Result<(), VError>;
}

/// No memory at all, for programs without DMA.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoMemory;

impl HostMemory for NoMemory {
    fn read(&self, _: &DmaBlock, _: &mut Vec<u8>) -> Result<(), VError> {
        Err(VError::ParamError)
    }
}

value_struct! {
    /// A part of an issued command buffer: words, the low byte first, that
    /// follow those of the part before.
    #[derive(Default)]
    pub struct Segment {
        /// Number of the [`Port`] they pass.
        pub port: u8,
        /// The words' bytes.
        pub words: Data,
    }
}

impl Segment {
    /// Words as they are.
    pub fn of(words: &[u32]) -> Segment {
        Segment { port: 0, words: word_bytes(words).into() }
    }

    /// Appends the words after the port.
    pub fn append_to(&self, out: &mut Vec<u32>) {
        let port = Port::from_number(u32::from(self.port)).unwrap_or_default();
        let words = self.words.as_chunks().0.iter().map(|&bytes| u32::from_le_bytes(bytes));
        match port {
            Port::Word => out.extend(words),
            port => out.extend(words.map(|word| port.pass(word))),
        }
    }
}

/// Words as bytes, the low byte first.
pub fn word_bytes(words: &[u32]) -> Vec<u8> {
    words.iter().map(|word| word.to_le_bytes()).collect::<Vec<[u8; 4]>>().into_flattened()
}

/// All words of segments, in order.
pub fn stream_words(segments: &[Segment]) -> Vec<u32> {
    let mut words = Vec::with_capacity(segments.iter().map(|s| s.words.len() / 4).sum());
    segments.iter().for_each(|segment| segment.append_to(&mut words));
    words
}

/// One command buffer of fixed size.
#[derive(Clone, Debug)]
pub struct CommandBuffer {
    id: u32,
    words: Vec<u32>,
    /// Words in use.
    used: usize,
    dma: Vec<Entry>,
    /// DMA entries in use, and all of them.
    entries: [usize; 2],
}

/// A place in what was recorded; see [`CommandBuffer::mark`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Mark {
    words: usize,
    blocks: usize,
    entries: usize,
}

/// A DMA block, after so many words of the list.
#[derive(Clone, Copy, Debug)]
struct Entry {
    after: usize,
    block: DmaBlock,
}

impl CommandBuffer {
    /// An empty buffer. `id` is what the device calls it.
    ///
    /// # Errors
    /// [`VError::ParamError`] for more than [`MAX_CMD_WORDS`] words or
    /// [`MAX_DMA_ENTRIES`] entries.
    pub fn new(id: u32, entries: usize, words: usize) -> Result<CommandBuffer, VError> {
        if words > MAX_CMD_WORDS || entries > MAX_DMA_ENTRIES {
            return Err(VError::ParamError);
        }
        let dma = Vec::new();
        Ok(CommandBuffer { id, words: vec![0; words], used: 0, dma, entries: [0, entries] })
    }

    /// What the device calls it.
    pub fn id(&self) -> u32 {
        self.id
    }

    /// Forgets its contents (`V_ResetCmdBuffer`).
    pub fn reset(&mut self) {
        self.used = 0;
        self.dma.clear();
        self.entries[0] = 0;
    }

    /// How much is recorded, to go back to.
    pub fn mark(&self) -> Mark {
        Mark { words: self.used, blocks: self.dma.len(), entries: self.entries[0] }
    }

    /// Forgets what was recorded after a mark, so that a command that failed
    /// half-way leaves nothing behind.
    pub fn rewind(&mut self, mark: Mark) {
        self.used = self.used.min(mark.words);
        self.dma.truncate(mark.blocks);
        self.entries[0] = self.entries[0].min(mark.entries);
    }

    /// Words and DMA entries that are free (`V_GetCmdBufferFreeSpace`).
    pub fn free_space(&self) -> (usize, usize) {
        (self.words.len() - self.used, self.entries[1] - self.entries[0])
    }

    /// Whether nothing was recorded.
    pub fn is_empty(&self) -> bool {
        self.used == 0 && self.dma.is_empty()
    }

    /// The words of the list; DMA blocks are not among them.
    pub fn words(&self) -> &[u32] {
        &self.words[..self.used]
    }

    /// The contents as they are now, and the memory as it is now.
    ///
    /// # Errors
    /// Those of [`HostMemory::read`].
    pub fn snapshot(&self, memory: &impl HostMemory) -> Result<Vec<Segment>, VError> {
        let mut segments = Vec::with_capacity(2 * self.dma.len() + 1);
        let mut at = 0;
        for Entry { after, block } in &self.dma {
            if *after > at {
                segments.push(Segment::of(&self.words[at..*after]));
                at = *after;
            }
            let mut bytes = Vec::with_capacity(block.words as usize * 4);
            memory.read(block, &mut bytes)?;
            segments.push(Segment { port: block.port as u8, words: bytes.into() });
        }
        if self.used > at {
            segments.push(Segment::of(&self.words[at..self.used]));
        }
        Ok(segments)
    }
}

impl CommandSink for CommandBuffer {
    #[inline]
    fn reserve(&mut self, words: usize, entries: usize) -> Result<&mut [u32], VError> {
        let from = self.used;
        let Some(reserved) = self.words.get_mut(from..from.saturating_add(words)) else {
            return Err(VError::CmdBufferTooSmall);
        };
        if entries > self.entries[1] - self.entries[0] {
            return Err(VError::CmdBufferNoDmaEntries);
        }
        self.used = from + words;
        Ok(reserved)
    }

    fn add_dma(&mut self, block: DmaBlock) -> Result<(), VError> {
        if !block.offset.is_multiple_of(4) || block.words > MAX_BLOCK_WORDS {
            return Err(VError::ParamError);
        }
        let used = self.entries[0] + block.entries() as usize;
        if used > self.entries[1] {
            return Err(VError::CmdBufferNoDmaEntries);
        }
        self.entries[0] = used;
        self.dma.push(Entry { after: self.used, block });
        Ok(())
    }
}

/// `V_AddToDMAList`: reserves the block's entries and appends it.
///
/// # Errors
/// Those of the sink.
pub fn add_to_dma_list(sink: &mut impl CommandSink, block: DmaBlock) -> Result<(), Failure> {
    let failed = |error| Failure::v(VRoutine::AddToDMAList, error);
    sink.reserve(0, block.entries() as usize).map_err(failed)?;
    sink.add_dma(block).map_err(failed)
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Pages(Vec<u8>);

    impl HostMemory for Pages {
        fn read(&self, block: &DmaBlock, out: &mut Vec<u8>) -> Result<(), VError> {
            let from = block.offset as usize;
            let bytes = self.0.get(from..from + block.words as usize * 4);
            out.extend(bytes.ok_or(VError::ParamError)?);
            Ok(())
        }
    }

    #[test]
    fn ports_rearrange_words() {
        let passed =
            [Port::Word, Port::Byte, Port::Other, Port::Short].map(|p| p.pass(0x1122_3344));
        assert_eq!(passed, [0x1122_3344, 0x4433_2211, 0x2211_4433, 0x3344_1122]);
    }

    #[test]
    fn words_and_blocks_keep_their_order() {
        let memory = Pages((0..16).collect());
        let mut buffer = CommandBuffer::new(1, 4, 8).unwrap();
        buffer.reserve(2, 0).unwrap().copy_from_slice(&[1, 2]);
        let block = DmaBlock { port: Port::Byte, memory: 0, offset: 4, words: 1 };
        add_to_dma_list(&mut buffer, block).unwrap();
        buffer.reserve(1, 0).unwrap()[0] = 3;
        let words = stream_words(&buffer.snapshot(&memory).unwrap());
        assert_eq!(words, [1, 2, 0x0405_0607, 3]);
        assert_eq!(buffer.free_space(), (5, 3));
        assert_eq!(buffer.reserve(6, 0), Err(VError::CmdBufferTooSmall));
        assert_eq!(buffer.reserve(0, 4), Err(VError::CmdBufferNoDmaEntries));
        let mark = buffer.mark();
        buffer.reserve(3, 0).unwrap();
        add_to_dma_list(&mut buffer, block).unwrap();
        buffer.rewind(mark);
        assert_eq!((buffer.free_space(), buffer.words()), ((5, 3), &[1, 2, 3][..]));
        buffer.reset();
        assert!(buffer.is_empty());
        assert_eq!(buffer.free_space(), (8, 4));
    }

    #[test]
    fn pages_count_as_entries() {
        assert_eq!(dma_entries(0, 0), 0);
        assert_eq!(dma_entries(4092, 1), 1);
        assert_eq!(dma_entries(4092, 2), 2);
        assert_eq!(dma_entries(0, 2048), 2);
    }
}
