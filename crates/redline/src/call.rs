//! Every call as a value: the border that all of them cross.
//!
//! Devices, buffer groups and command buffers are named by numbers from 1 on,
//! given out by [`crate::Context`] in order, so that a recording names the same
//! objects when it is replayed.
//!
//! What only touches the program's own memory does not cross: recording of
//! commands, memory objects, members of surfaces, look-ups of names and sizes.
//! What was recorded crosses with the call that issues it, what was written
//! into a locked buffer with the call that unlocks it.

use fillrate_call::{Data, value_enum, value_struct};

use crate::command::Segment;

value_struct! {
    /// `v_rect`: right and bottom are outside.
    #[derive(Copy, Default, Eq)]
    pub struct Rect {
        /// First column.
        pub left: i32,
        /// First row.
        pub top: i32,
        /// One past the last column.
        pub right: i32,
        /// One past the last row.
        pub bottom: i32,
    }
}

value_enum! {
    /// One documented function each, with its arguments, or something that
    /// happens to a program (variants from 80 on).
    ///
    /// Numbers and fields never change; see `fillrate_call`.
    pub enum Call {
        /// `V_CreateVerite`: replies a device.
        1 => CreateVerite { board: u32 },
        /// `V_DestroyVerite`.
        2 => DestroyVerite { device: u32 },
        /// `V_SetUserPrivate`.
        3 => SetUserPrivate { device: u32, value: u64 },
        /// `V_RegisterSyncCmd`.
        4 => RegisterSyncCmd { device: u32, command: u32 },
        /// `V_SetDisplayType`.
        5 => SetDisplayType { device: u32, display_type: u32 },
        /// `V_SetDisplayMode`.
        6 => SetDisplayMode { device: u32, width: u32, height: u32, bits: u32, refresh: i32 },
        /// `V_SetDisplayLinebytes`.
        7 => SetDisplayLinebytes { device: u32, linebytes: u32 },
        /// `V_CreateBufferGroup`: replies a group.
        10 => CreateBufferGroup {
            device: u32, mask: u32, buffers: u32, format: u32, width: u32, height: u32,
        },
        /// `V_PointBufferGroup`: replies a group.
        11 => PointBufferGroup {
            device: u32, mask: u32, buffers: u32, format: u32, width: u32, height: u32,
            address: u32,
        },
        /// `V_DestroyBufferGroup`.
        12 => DestroyBufferGroup { device: u32, group: u32 },
        /// `V_SwapBuffers`.
        13 => SwapBuffers { device: u32, group: u32, a: u32, b: u32 },
        /// `V_RestoreBuffer`.
        14 => RestoreBuffer { device: u32, group: u32, buffer: u32 },
        /// `V_LockBuffer`: replies the buffer's bytes, row by row at its pitch.
        15 => LockBuffer { device: u32, group: u32, buffer: u32 },
        /// `V_UnlockBuffer`: the bytes that changed, as [`crate::lock::changes`]
        /// says.
        16 => UnlockBuffer { device: u32, group: u32, buffer: u32, changes: Data },
        /// `V_ReadBuffer`: replies rows of pixels without padding.
        17 => ReadBuffer {
            device: u32, group: u32, buffer: u32, x: u32, y: u32, width: u32, height: u32,
        },
        /// `V_BltDisplayBuffer`; no rectangle is the whole buffer.
        18 => BltDisplayBuffer {
            device: u32, dst_group: u32, dst_buffer: u32, dst: Option<Rect>,
            src_group: u32, src_buffer: u32, src: Option<Rect>,
        },
        /// `V_CreateCmdBuffer`: replies a command buffer.
        30 => CreateCmdBuffer { device: u32, entries: i32, words: i32 },
        /// `V_DestroyCmdBuffer`.
        31 => DestroyCmdBuffer { device: u32, buffer: u32 },
        /// `V_IssueCmdBufferAsync`, or `V_IssueCmdBuffer` where it waits.
        /// Replies how many times the display is switched in it.
        32 => IssueCmdBuffer { device: u32, buffer: u32, segments: Vec<Segment>, wait: bool },
        /// `V_QueryCmdBuffer`: replies whether it is in use.
        33 => QueryCmdBuffer { device: u32, buffer: u32 },
        /// `VL_OpenVerite`: replies a device.
        50 => OpenVerite { },
        /// `VL_CloseVerite`.
        51 => CloseVerite { device: u32 },
        /// `VL_CreateSurface`: replies a group.
        52 => CreateSurface {
            device: u32, mask: u32, buffers: u32, format: u32, width: u32, height: u32,
        },
        /// `VL_PointSurface`: replies a group.
        53 => PointSurface {
            device: u32, mask: u32, buffers: u32, format: u32, width: u32, height: u32,
            address: u32,
        },
        /// `VL_DestroySurface`.
        54 => DestroySurface { device: u32, group: u32 },
        /// `VL_RestoreSurface`.
        55 => RestoreSurface { device: u32, group: u32 },
        /// The window moved, or covers the whole desktop.
        80 => SetWindow { device: u32, window: Option<Rect> },
        /// Another program took the screen: all buffers are lost.
        81 => LoseBuffers { device: u32 },
        /// Stores through the pointer of a lock that is still held; the bytes
        /// that changed, as for `UnlockBuffer`.
        82 => StoreBuffer { device: u32, group: u32, buffer: u32, changes: Data },
    }
}

/// What a successful call returns.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Reply {
    /// Nothing.
    #[default]
    Nothing,
    /// The number of a device, buffer group or command buffer.
    Made(u32),
    /// A buffer group, and the bytes of video memory it takes.
    Group(u32, u32),
    /// A count or a truth value.
    Number(u32),
    /// Pixels.
    Bytes(Vec<u8>),
}

impl Reply {
    /// The number of whatever was made, or the number.
    pub fn number(&self) -> u32 {
        match self {
            Reply::Made(number) | Reply::Group(number, _) | Reply::Number(number) => *number,
            Reply::Nothing | Reply::Bytes(_) => 0,
        }
    }

    /// The pixels, or none.
    pub fn into_bytes(self) -> Vec<u8> {
        match self {
            Reply::Bytes(bytes) => bytes,
            _ => Vec::new(),
        }
    }
}
