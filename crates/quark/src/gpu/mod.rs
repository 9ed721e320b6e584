//! The virtual graphics processor.
//!
//! Source: QK, `CVGpu`.

mod brush;
mod camera;
mod face;
mod flat;
mod list;
mod present;
mod sort;
mod text;

use std::sync::Arc;

use fillrate_engine::state::Compare;
use fillrate_engine::{Counters, Device, DeviceConfig, PixelFormat, SurfaceId};

pub use camera::{CLIPZ_FAR, CLIPZ_NEAR, Camera};
pub use present::Shown;

use self::brush::Brush;
use self::list::WorkMemory;
use self::sort::SortTable;
use self::text::FrameRate;
use crate::error::{ErrorCode, QuarkError};
use crate::matrix::Matrix;
use crate::state::{RasterState, TriangleMode};

/// Columns of the original's screen.
pub const SCR_X: u32 = 240;
/// Rows of the original's screen.
pub const SCR_Y: u32 = 320;
/// Bits that 1/z is scaled by.
pub const INVTBL_SHIFT: u32 = 22;

/// The most faces that can wait for sorting.
pub const MAX_SORTED: usize = 1 << 20;

/// How a [`Gpu`] is made.
#[derive(Clone, Debug)]
pub struct GpuConfig {
    /// Columns, 16 to 2048.
    pub width: u32,
    /// Rows, 16 to 2048.
    pub height: u32,
    /// z of the near plane, -64 or less.
    pub near: i32,
    /// z of the far plane, -4095 or more.
    pub far: i32,
    /// Horizontal field of view in degrees, 8 to 120.
    pub field_of_view: i32,
    /// How a fragment's 1/z is compared with the stored one. Strictly greater
    /// passes by default: of equally near fragments the first stays.
    pub depth_test: Compare,
    /// Threads, SIMD level and tile size.
    pub device: DeviceConfig,
}

impl Default for GpuConfig {
    /// The original's screen, all of the depth range, 60 degrees.
    fn default() -> GpuConfig {
        GpuConfig {
            width: SCR_X,
            height: SCR_Y,
            near: CLIPZ_NEAR,
            far: CLIPZ_FAR,
            field_of_view: 60,
            depth_test: Compare::Greater,
            device: DeviceConfig::default(),
        }
    }
}

/// A frame buffer and everything that draws into it.
#[derive(Debug)]
pub struct Gpu {
    /// State of text.
    pub text_state: RasterState,
    /// State of lines.
    pub line_state: RasterState,
    /// State of sprites.
    pub sprite_state: RasterState,
    /// State of triangles; without one nothing is drawn.
    pub triangle_state: Option<RasterState>,
    /// Mode of triangles; without one nothing is drawn.
    pub triangle_mode: Option<TriangleMode>,
    /// From a list's coordinates to the world's; none leaves them.
    pub view_matrix: Option<Matrix>,
    /// Perspective errors below this are allowed, in 1/256 pixel.
    pub zc_error_max: i32,
    /// Projection and frustum.
    pub camera: Camera,
    /// Frames shown.
    pub frame_counter: i32,
    device: Device,
    /// Drawn to, and shown.
    back: SurfaceId,
    front: SurfaceId,
    depth: SurfaceId,
    depth_test: Compare,
    work: WorkMemory,
    sort: SortTable,
    rate: FrameRate,
    brush: Option<Arc<Brush>>,
}

/// The stored depth of a distance: (2^22 - 1) / z; of what is nearer than 64,
/// 65535. Source: QK, frame buffer.
pub fn inverse_z(z: i32) -> u16 {
    if z < -CLIPZ_NEAR { u16::MAX } else { (((1 << INVTBL_SHIFT) - 1) / z) as u16 }
}

impl Gpu {
    /// A cleared frame buffer with default states. Source: QK, `Init`.
    ///
    /// # Errors
    /// [`QuarkError`], by the field that is out of range.
    pub fn new(config: GpuConfig) -> Result<Gpu, QuarkError> {
        let (width, height) = (config.width, config.height);
        let allowed = 16..=2048;
        if !allowed.contains(&width) || !allowed.contains(&height) {
            return Err(QuarkError::Size { width, height });
        }
        let size = [width as i32, height as i32];
        let camera = Camera::new(size, config.near, config.far, config.field_of_view)?;
        let mut device = Device::new(config.device)?;
        let back = device.create_surface(width, height, PixelFormat::Palette)?;
        let front = device.create_surface(width, height, PixelFormat::Palette)?;
        let depth = device.create_surface(width, height, PixelFormat::Aux16)?;
        device.set_target(back, Some(depth))?;
        Ok(Gpu {
            text_state: RasterState::default(),
            line_state: RasterState::default(),
            sprite_state: RasterState::default(),
            triangle_state: None,
            triangle_mode: Some(TriangleMode::Affine),
            view_matrix: None,
            zc_error_max: 0,
            camera,
            frame_counter: 0,
            device,
            back,
            front,
            depth,
            depth_test: config.depth_test,
            work: WorkMemory::default(),
            sort: SortTable::default(),
            rate: FrameRate::default(),
            brush: None,
        })
    }

    /// Columns and rows of the screen.
    pub fn size(&self) -> (u32, u32) {
        (self.camera.size[0] as u32, self.camera.size[1] as u32)
    }

    /// Makes room for lists of up to `vertices` vertices, and for `faces`
    /// faces that wait for sorting; those that wait are forgotten.
    /// Source: QK, `SetWorkMemory`.
    ///
    /// # Errors
    /// [`ErrorCode::Memory`] for more than [`MAX_SORTED`] faces.
    pub fn set_work_memory(&mut self, vertices: usize, faces: usize) -> Result<(), ErrorCode> {
        if faces > MAX_SORTED {
            return Err(ErrorCode::Memory);
        }
        self.work = WorkMemory::new(vertices);
        self.sort = SortTable::new(faces);
        Ok(())
    }

    /// What was drawn and dropped so far.
    pub fn counters(&mut self) -> Counters {
        self.device.counters()
    }
}
