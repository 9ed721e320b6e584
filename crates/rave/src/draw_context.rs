//! A draw context: its state, its frame, and what was submitted to it.
//!
//! Source: RAVE, draw contexts.

use std::sync::Arc;

use fillrate_engine::PixelFormat;
use fillrate_engine::state::{Dither, FogTable, Rect};

use crate::RaveError;
use crate::constants::{antialias, context, device, notice};
use crate::draw::Prepared;
use crate::fog::FogCurve;
use crate::front::{Front, surface_format};
use crate::handle::DrawContextId;
use crate::painter::TargetSpec;
use crate::pixel::PixelType;
use crate::state::{MAX_LAYERS, State};
use crate::tags::{float, int};
use crate::translate::Plane;
use crate::vertex::{DeviceValue, RaveRect, VGouraud, VMultiTexture, VTexture};

/// The longest side of a draw context.
pub const MAX_CONTEXT_SIDE: u32 = 2047;
/// The most samples of a context's surfaces.
const MAX_SAMPLES: u64 = 1 << 24;

/// What a draw context is made with.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ContextSpec {
    pub engine: u32,
    pub device: DeviceValue,
    pub rect: RaveRect,
    pub scaled: Option<RaveRect>,
    pub clip: Option<Vec<RaveRect>>,
    pub flags: u32,
}

/// A draw context.
#[derive(Debug)]
pub(crate) struct DrawContext {
    pub id: DrawContextId,
    pub spec: ContextSpec,
    pub pixel_type: PixelType,
    pub format: PixelFormat,
    /// Columns and rows of the drawing coordinates.
    pub size: (u32, u32),
    pub state: State,
    /// Between RenderStart and RenderEnd.
    pub in_frame: bool,
    /// Samples of a pixel along one side.
    pub scale: u32,
    /// The first error that was not reported yet.
    error: Option<RaveError>,
    /// Frames that were started.
    pub frames: u64,
    /// The renderer's counts after which frames are complete.
    pub pending: Vec<u64>,
    pub vertices_gouraud: Arc<[VGouraud]>,
    pub vertices_texture: Arc<[VTexture]>,
    pub params: [Vec<VMultiTexture>; MAX_LAYERS],
    /// Which notices have a method.
    pub notices: [bool; notice::NUM_SELECTORS as usize],
    pub draw_buffer_accessed: bool,
    pub z_buffer_accessed: bool,
    /// The fog that was used last, and its table.
    pub fog_table: (Option<FogCurve>, FogTable),
    /// What drawing needs of the state; `None` after a change.
    pub prepared: Option<Box<Prepared>>,
}

impl DrawContext {
    /// A context with everything at its default.
    ///
    /// # Errors
    /// [`RaveError::Parameter`], [`RaveError::NotSupported`],
    /// [`RaveError::OutOfVideoMemory`].
    pub fn new(id: DrawContextId, spec: ContextSpec) -> Result<DrawContext, RaveError> {
        let pixel_type = check_device(&spec.device)?;
        let format = surface_format(pixel_type).ok_or(RaveError::NotSupported)?;
        let size = check_rectangles(&spec)?;
        Ok(DrawContext {
            id,
            pixel_type,
            format,
            size,
            state: State::new(spec.flags, size.0, size.1),
            in_frame: false,
            scale: 1,
            error: None,
            frames: 0,
            pending: Vec::new(),
            vertices_gouraud: Arc::new([]),
            vertices_texture: Arc::new([]),
            params: Default::default(),
            notices: [false; notice::NUM_SELECTORS as usize],
            draw_buffer_accessed: false,
            z_buffer_accessed: false,
            fog_table: (None, FogTable::default()),
            prepared: None,
            spec,
        })
    }

    /// Whether a flag was given.
    pub fn has(&self, flag: u32) -> bool {
        self.spec.flags & flag != 0
    }

    /// The surfaces that it needs.
    pub fn target_spec(&self) -> TargetSpec {
        let plane = match (self.has(context::NO_Z_BUFFER), self.has(context::DEEP_Z)) {
            (true, _) => Plane::None,
            (false, true) => Plane::Deep,
            (false, false) => Plane::Z16,
        };
        let (width, height) = self.size;
        TargetSpec { width, height, format: self.format, plane, scale: self.scale }
    }

    /// The plane that it compares with now.
    pub fn plane(&self) -> Plane {
        match self.target_spec().plane {
            Plane::None => Plane::None,
            _ if self.state.int(int::PERSPECTIVE_Z) != 0 => Plane::InverseW,
            plane => plane,
        }
    }

    /// All pixels.
    pub fn bounds(&self) -> Rect {
        Rect::new(0, 0, self.size.0, self.size.1)
    }

    /// A rectangle of the program inside the context; all of it for none.
    pub fn inside(&self, rect: Option<&RaveRect>) -> Rect {
        let Some(rect) = rect else { return self.bounds() };
        let (width, height) = (self.size.0 as i32, self.size.1 as i32);
        let (x, y) = (|v: i32| v.clamp(0, width) as u32, |v: i32| v.clamp(0, height) as u32);
        let inside = Rect::new(x(rect.left), y(rect.top), x(rect.right), y(rect.bottom));
        // Sides may be exchanged: nothing lies between them.
        if inside.is_empty() { Rect::new(0, 0, 0, 0) } else { inside }
    }

    /// How its colours are reduced.
    pub fn dither(&self) -> Dither {
        if self.format.is_reduced() && !self.has(context::NO_DITHER) {
            Dither::Ordered4x4
        } else {
            Dither::Off
        }
    }

    /// The background colour, 0xAARRGGBB.
    pub fn background(&self) -> u32 {
        self.state.color(float::COLOR_BG_A)
    }

    /// Records an error; the first one counts.
    pub fn fail(&mut self, error: RaveError) {
        self.error.get_or_insert(error);
    }

    /// The first error. Reports inside a frame leave it for the frame's end.
    pub fn report(&mut self) -> Result<(), RaveError> {
        let error = if self.in_frame { self.error } else { self.error.take() };
        error.map_or(Ok(()), Err)
    }

    /// Samples of a pixel along one side that the antialiasing asks for.
    pub fn wanted_scale(&self) -> u32 {
        let wanted = match self.state.int(int::ANTIALIAS) {
            antialias::MID => 2,
            antialias::BEST => 4,
            _ => 1,
        };
        let pixels = u64::from(self.size.0) * u64::from(self.size.1);
        let fits = |scale: &u32| pixels * u64::from(scale * scale) <= MAX_SAMPLES;
        [wanted, 2].into_iter().filter(|&scale| scale <= wanted).find(fits).unwrap_or(1)
    }

    /// Whether what is drawn is seen without a swap.
    pub fn draws_to_front(&self) -> bool {
        const GL_FRONT: u32 = 3;
        !self.has(context::CACHE)
            && (!self.has(context::DOUBLE_BUFFER)
                || self.state.int(int::GL_DRAW_BUFFER) & GL_FRONT != 0)
    }

    /// A picture as its device holds it, of zeros.
    pub fn new_front(&self) -> Front {
        let shown = self.spec.scaled.unwrap_or(self.spec.rect);
        let clip = self.spec.clip.as_ref().map(|clip| relative(clip, &shown));
        Front::new(shown.width(), shown.height(), self.format, clip)
    }
}

/// The pixel type of a device that can be drawn to.
///
/// # Errors
/// [`RaveError::NotSupported`] for other devices, [`RaveError::Parameter`] for
/// impossible sizes or an unknown pixel type.
pub(crate) fn check_device(value: &DeviceValue) -> Result<PixelType, RaveError> {
    if !matches!(value.device_type, device::MEMORY | device::OFFSCREEN) {
        return Err(RaveError::NotSupported);
    }
    let pixel_type = PixelType::from_number(value.pixel_type).ok_or(RaveError::Parameter)?;
    if surface_format(pixel_type).is_none() {
        return Err(RaveError::NotSupported);
    }
    if value.device_type == device::MEMORY {
        let width = u32::try_from(value.width).map_err(|_| RaveError::Parameter)?;
        let row = i64::try_from(pixel_type.row_bytes(width)).map_err(|_| RaveError::Parameter)?;
        let fits = i64::from(value.row_bytes) >= row;
        if width == 0 || value.height <= 0 || !fits {
            return Err(RaveError::Parameter);
        }
    }
    Ok(pixel_type)
}

/// The size of the drawing coordinates.
fn check_rectangles(spec: &ContextSpec) -> Result<(u32, u32), RaveError> {
    let scales = spec.flags & context::SCALE != 0;
    if scales != spec.scaled.is_some() {
        return Err(RaveError::Parameter);
    }
    let shown = spec.scaled.unwrap_or(spec.rect);
    for rect in [&spec.rect, &shown] {
        if rect.is_empty() {
            return Err(RaveError::Parameter);
        }
        if rect.width().max(rect.height()) > MAX_CONTEXT_SIDE {
            return Err(RaveError::OutOfVideoMemory);
        }
    }
    let device = RaveRect::new(0, 0, spec.device.width, spec.device.height);
    let is_memory = spec.device.device_type == device::MEMORY;
    if is_memory && shown.intersect(&device) != shown {
        return Err(RaveError::Parameter);
    }
    Ok((spec.rect.width(), spec.rect.height()))
}

/// Rectangles of the device as pixels of the picture.
fn relative(clip: &[RaveRect], shown: &RaveRect) -> Vec<RaveRect> {
    let inside = clip.iter().map(|rect| rect.intersect(shown));
    inside
        .filter(|rect| !rect.is_empty())
        .map(|rect| RaveRect {
            left: rect.left - shown.left,
            right: rect.right - shown.left,
            top: rect.top - shown.top,
            bottom: rect.bottom - shown.top,
        })
        .collect()
}
