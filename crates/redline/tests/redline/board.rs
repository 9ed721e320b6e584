//! A board with a display surface, and the ways of programs to use it.

use fillrate_engine::DeviceConfig;
use fillrate_redline::surface::{PRIMARY, Z_BUFFER};
use fillrate_redline::{
    BufferGroup, Call, Chip, CommandBuffer, Context, DmaBlock, HostMemory, PixFmt, RedlineConfig,
    Reply, Segment, Surface, VError, record,
};

/// Host memory of the tests: one object, number 0.
#[derive(Default)]
pub struct Memory(pub Vec<u8>);

impl HostMemory for Memory {
    fn read(&self, block: &DmaBlock, out: &mut Vec<u8>) -> Result<(), VError> {
        let from = block.offset as usize;
        let bytes = self.0.get(from..from + block.words as usize * 4);
        out.extend_from_slice(bytes.ok_or(VError::ParamError)?);
        Ok(())
    }
}

/// An open board and a command buffer.
pub struct Board {
    pub context: Context,
    pub device: u32,
    pub group: u32,
    pub buffer: u32,
    pub commands: CommandBuffer,
    pub memory: Memory,
}

/// A configuration with one thread, carried out where it is issued.
pub fn config(chip: Chip) -> RedlineConfig {
    let device = DeviceConfig { threads: 1, ..DeviceConfig::default() };
    RedlineConfig { chip, background: false, device, ..RedlineConfig::default() }
}

impl Board {
    /// A full-screen board with a front, a back and, for `depth`, a Z buffer.
    pub fn new(config: RedlineConfig, (width, height): (u32, u32), depth: bool) -> Board {
        let mut context = Context::new(config);
        let device = context.execute(&Call::OpenVerite {}).unwrap().number();
        context.execute(&Call::SetDisplayType { device, display_type: 2 }).unwrap();
        let mode = Call::SetDisplayMode { device, width, height, bits: 16, refresh: 60 };
        context.execute(&mode).unwrap();
        let mask = PRIMARY | if depth { Z_BUFFER } else { 0 };
        let (buffers, format) = (2 + u32::from(depth), PixFmt::Rgb565.code());
        let create = Call::CreateSurface { device, mask, buffers, format, width, height };
        let group = context.execute(&create).unwrap().number();
        let create = Call::CreateCmdBuffer { device, entries: 4096, words: 1 << 18 };
        let buffer = context.execute(&create).unwrap().number();
        let commands = CommandBuffer::new(buffer, 4096, 1 << 18).unwrap();
        let memory = Memory::default();
        let mut board = Board { context, device, group, buffer, commands, memory };
        board.install();
        board
    }

    /// The display surface as destination, its depth buffer, black.
    fn install(&mut self) {
        let group = self.display();
        let surface = Surface::new(group.width, group.height, group.format.code());
        record::context_init(&mut self.commands).unwrap();
        record::install_dst_buffer(&mut self.commands, &surface, &group).unwrap();
        let size = [group.width, group.height];
        record::fill_buffer(&mut self.commands, &group, 1, [0, 0], size, 0).unwrap();
        if let Some(z) = group.z_buffer() {
            record::install_z_buffer(&mut self.commands, &group).unwrap();
            record::fill_buffer(&mut self.commands, &group, z, [0, 0], size, 0xffff).unwrap();
        }
    }

    /// The display surface's group.
    pub fn display(&self) -> BufferGroup {
        self.context.group(self.device, self.group).unwrap().clone()
    }

    /// Makes a texture of `texels`, raw pixels row by row.
    pub fn texture(
        &mut self,
        width: u32,
        height: u32,
        format: PixFmt,
        texels: &[u32],
    ) -> (Surface, u32) {
        let (device, code) = (self.device, format.code());
        let create =
            Call::CreateSurface { device, mask: 0, buffers: 1, format: code, width, height };
        let group = self.context.execute(&create).unwrap().number();
        let place = self.context.group(device, group).unwrap().clone();
        let bytes = rows(format, width, texels);
        let offset = self.memory.0.len() as u64;
        let linebytes = (bytes.len() / height as usize) as u32;
        self.memory.0.extend(bytes);
        let data = DmaBlock { offset, ..DmaBlock::default() };
        record::load_buffer(&mut self.commands, &place, 0, linebytes, [width, height], data)
            .unwrap();
        (Surface::new(width, height, code), group)
    }

    /// Installs a texture.
    pub fn bind(&mut self, surface: &Surface, group: u32) {
        let place = self.context.group(self.device, group).unwrap().clone();
        record::install_texture_map(&mut self.commands, surface, &place).unwrap();
    }

    /// Issues what was recorded.
    pub fn issue(&mut self) -> u32 {
        let segments = self.commands.snapshot(&self.memory).unwrap();
        self.commands.reset();
        self.issue_segments(segments)
    }

    /// Issues these words.
    pub fn issue_segments(&mut self, segments: Vec<Segment>) -> u32 {
        let (device, buffer) = (self.device, self.buffer);
        let issue = Call::IssueCmdBuffer { device, buffer, segments, wait: false };
        self.context.execute(&issue).unwrap().number()
    }

    /// The pixels of a buffer, issued work done.
    pub fn pixels(&mut self, buffer: u32) -> Vec<u16> {
        let group = self.display();
        let (width, height) = (group.width, group.height);
        let bytes = self.read(self.group, buffer, [0, 0], [width, height]);
        bytes.as_chunks().0.iter().map(|&two| u16::from_le_bytes(two)).collect()
    }

    /// Bytes of a rectangle of a buffer.
    pub fn read(
        &mut self,
        group: u32,
        buffer: u32,
        [x, y]: [u32; 2],
        [width, height]: [u32; 2],
    ) -> Vec<u8> {
        let device = self.device;
        let read = Call::ReadBuffer { device, group, buffer, x, y, width, height };
        match self.context.execute(&read).unwrap() {
            Reply::Bytes(bytes) => bytes,
            other => panic!("{other:?}"),
        }
    }
}

/// Raw pixels packed as rows that are padded to words.
pub fn rows(format: PixFmt, width: u32, texels: &[u32]) -> Vec<u8> {
    let mut out = Vec::new();
    for row in texels.chunks(width as usize) {
        let mut bytes: Vec<u8> = match format.bits() {
            4 => row.chunks(2).map(|two| (two[0] | two.get(1).unwrap_or(&0) << 4) as u8).collect(),
            bits => {
                row.iter().flat_map(|t| t.to_le_bytes()[..bits as usize / 8].to_vec()).collect()
            }
        };
        bytes.resize(bytes.len().next_multiple_of(4), 0);
        out.extend(bytes);
    }
    out
}
