//! Surfaces and buffer groups.
//!
//! A buffer group is a block of video memory cut into buffers of one size; a
//! surface is a group with what a texture needs besides, in the program's own
//! memory.
//!
//! Source: RR, surfaces.

use crate::format::PixFmt;

/// `V_SURFACE_Z_BUFFER`: the last buffer holds depths.
pub const Z_BUFFER: u32 = 1;
/// `V_SURFACE_PRIMARY`: buffer 0 is shown.
pub const PRIMARY: u32 = 2;
/// `V_SURFACE_INTERLEAVED`: rows of all buffers lie together.
pub const INTERLEAVED: u32 = 4;
/// `V_SURFACE_UCLAMP`.
pub const UCLAMP: u32 = 1;
/// `V_SURFACE_VCLAMP`.
pub const VCLAMP: u32 = 2;
/// The most buffers of a group.
pub const MAX_BUFFERS: u32 = 16;

/// Buffers of one size and format in video memory, as a device keeps them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BufferGroup {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Format of all buffers but the depth buffer, which has 16 bits.
    pub format: PixFmt,
    /// `V_SURFACE_` bits that were granted.
    pub mask: u32,
    /// Bytes from one row to the next.
    pub linebytes: u32,
    /// The pitch's code.
    pub stride: u32,
    /// Board address of each buffer.
    pub addresses: Vec<u32>,
    /// Bytes of video memory that were taken.
    pub bytes: u32,
    /// Whether the memory was taken away.
    pub lost: bool,
    /// The block of memory that belongs to it: address and size.
    pub(crate) owned: Option<(u32, u32)>,
    /// Whether buffer 0 is the desktop.
    pub(crate) on_desktop: bool,
}

impl BufferGroup {
    /// Address of a buffer.
    pub fn address(&self, buffer: u32) -> Option<u32> {
        self.addresses.get(buffer as usize).copied()
    }

    /// How many buffers.
    pub fn count(&self) -> u32 {
        self.addresses.len() as u32
    }

    /// The depth buffer's number.
    pub fn z_buffer(&self) -> Option<u32> {
        (self.mask & Z_BUFFER != 0).then(|| self.count().saturating_sub(1))
    }

    /// The buffer to draw into: the back buffer where there is one, else
    /// buffer 0. Source: RR, `VL_InstallDstBuffer`.
    pub fn drawing_buffer(&self) -> u32 {
        u32::from(self.has_back_buffer())
    }

    /// Whether buffer 1 is there and no depth buffer.
    pub fn has_back_buffer(&self) -> bool {
        self.count() > 1 && self.z_buffer() != Some(1)
    }

    /// The pixel format of a buffer: depths count as 565.
    pub fn buffer_format(&self, buffer: u32) -> PixFmt {
        if self.z_buffer() == Some(buffer) { PixFmt::Rgb565 } else { self.format }
    }

    /// Bytes from the start of a buffer to the end of its last row.
    pub fn span(&self) -> u32 {
        let row = self.format.row_bytes(self.width).max(if self.mask & Z_BUFFER != 0 {
            u64::from(self.width) * 2
        } else {
            0
        });
        (self.height.saturating_sub(1)) * self.linebytes + row as u32
    }
}

/// `v_surface` without its group: members 0 to 11.
///
/// All members are the program's to change; [`crate::record`] reads them when a
/// texture is installed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Surface {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Code of a [`PixFmt`].
    pub pixel_fmt: u32,
    /// Key, in the surface's own pixel layout.
    pub chroma_color: u32,
    /// Bits of the key that count.
    pub chroma_mask: u32,
    /// Not 0: the key is in use.
    pub chromakey: u32,
    /// Not 0: channels are padded.
    pub color_pad: u32,
    /// Not 0: red and blue are exchanged.
    pub bgr: u32,
    /// [`UCLAMP`], [`VCLAMP`].
    pub clamp: u32,
    /// Palette of a 4-bit texture, 0xAARRGGBB.
    pub palette: Option<[u32; 16]>,
    /// First palette entry in use.
    pub start_index: u32,
    /// Palette entries in use.
    pub num_entries: u32,
}

impl Surface {
    /// A surface as it is made: no key, no padding, repeated, no palette.
    pub fn new(width: u32, height: u32, pixel_fmt: u32) -> Surface {
        let mask = PixFmt::from_code(pixel_fmt).map_or(0, PixFmt::full_mask);
        Surface {
            width,
            height,
            pixel_fmt,
            chroma_color: 0,
            chroma_mask: mask,
            chromakey: 0,
            color_pad: 0,
            bgr: 0,
            clamp: 0,
            palette: None,
            start_index: 0,
            num_entries: 0,
        }
    }

    /// Clamps or repeats (`VL_SetSurfaceClamp`).
    pub fn set_clamp(&mut self, u: bool, v: bool) {
        self.clamp = if u { UCLAMP } else { 0 } | if v { VCLAMP } else { 0 };
    }

    /// The U or V mask: the last texel of a clamped side, else that of the
    /// power of two that holds the side.
    pub(crate) fn axis_mask(side: u32, clamped: bool) -> u32 {
        let last = side.max(1) - 1;
        let mask = if clamped { last } else { side.max(1).next_power_of_two() - 1 };
        mask.min(0xffff)
    }

    /// V mask and U mask, as the texture is installed.
    pub fn masks(&self) -> [u32; 2] {
        let v = Surface::axis_mask(self.height, self.clamp & VCLAMP != 0);
        let u = Surface::axis_mask(self.width, self.clamp & UCLAMP != 0);
        [v, u]
    }
}
