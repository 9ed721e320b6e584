//! RRedline, the library of the Verite chips, on the pixel engine.
//!
//! A [`Context`] holds devices and carries out [`Call`]s. Commands are words:
//! the functions of [`record`] write them into a [`CommandBuffer`], or a program
//! writes them itself; issuing the buffer hands the words to the chip, which
//! carries them out in the background. [`stream`] takes words apart again.
//!
//! ```
//! use fillrate_redline::{Call, CommandBuffer, Context, NoMemory, RedlineConfig, Surface, record};
//!
//! let mut redline = Context::new(RedlineConfig::default());
//! let device = redline.execute(&Call::OpenVerite {})?.number();
//! let (mask, format) = (fillrate_redline::surface::PRIMARY, 4);
//! redline.execute(&Call::SetDisplayType { device, display_type: 2 })?;
//! let group = redline
//!     .execute(&Call::CreateSurface { device, mask, buffers: 2, format, width: 640, height: 480 })?
//!     .number();
//! let back = redline.group(device, group).expect("it was made").clone();
//! let buffer = redline.execute(&Call::CreateCmdBuffer { device, entries: 8, words: 256 })?.number();
//!
//! let mut commands = CommandBuffer::new(buffer, 8, 256).expect("a valid size");
//! record::install_dst_buffer(&mut commands, &Surface::new(640, 480, format), &back)?;
//! record::fill_buffer(&mut commands, &back, 1, [0, 0], [640, 480], 0x001f)?;
//! record::swap_display_surface(&mut commands, &back)?;
//! let segments = commands.snapshot(&NoMemory).expect("no memory is referred to");
//! redline.execute(&Call::SwapBuffers { device, group, a: 0, b: 1 })?;
//! redline.execute(&Call::IssueCmdBuffer { device, buffer, segments, wait: false })?;
//! assert_eq!(redline.shown().expect("a device is open").pixels[1000], 0x001f);
//! # Ok::<(), fillrate_redline::Failure>(())
//! ```
//!
//! Source tag: RR; see `docs/sources.md`.

#![forbid(unsafe_code)]

pub mod board;
pub mod command;
pub mod cost;
pub mod error;
pub mod format;
pub mod lock;
pub mod memory;
pub mod opcode;
pub mod record;
pub mod stream;
pub mod surface;
pub mod vertex;

mod allocate;
mod call;
mod chip;
mod config;
mod context;
mod device;
mod ring;
mod worker;

pub use board::Chip;
pub use call::{Call, Rect, Reply};
pub use command::{
    CommandBuffer, CommandSink, DmaBlock, HostMemory, NoMemory, Port, Segment, add_to_dma_list,
};
pub use config::RedlineConfig;
pub use context::{BoardInfo, Context, MAX_DEVICES};
pub use device::{FULL_SCREEN, Shown, WINDOWED};
pub use error::{Failure, Fault, Result, VError, VRoutine, VlError, VlRoutine};
pub use format::PixFmt;
pub use memory::MemoryObjects;
pub use opcode::{Opcode, Register};
pub use ring::Ring;
pub use stream::{Command, Commands, StreamError};
pub use surface::{BufferGroup, Surface};
pub use vertex::VertexType;
