//! The structures of `RAVE.h` as they lie in memory.

use std::ffi::c_void;

use fillrate_guard::{bytes, read};
use fillrate_rave::{
    DeviceValue, ImageValue, IndexedTriangle, PixelType, RaveRect, VGouraud, VMultiTexture,
    VTexture,
};

use crate::order::Order;

/// Vertices, triangles and parameters that one call may hand over: more than any
/// program sends, less than exhausts memory.
pub const MAX_ELEMENTS: u32 = 1 << 22;

/// Pixels of one picture that are read.
const MAX_PIXELS: u64 = 1 << 26;

/// `kQAParamErr`.
pub const PARAM_ERR: i32 = 5;
/// `kQANotSupported`.
pub const NOT_SUPPORTED: i32 = 3;

/// Methods of a draw context.
pub const METHODS: usize = 35;

/// A function of any signature; null where there is none.
pub type Method = *const ();

/// `TQADrawContext`.
#[repr(C)]
pub struct RawDrawContext {
    /// The engine's own.
    pub draw_private: *mut c_void,
    /// `TQAVersion`.
    pub version: u32,
    /// In the order of `TQADrawMethodTag`.
    pub methods: [Method; METHODS],
}

/// `TQAImage`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct RawImage {
    pub width: i32,
    pub height: i32,
    pub row_bytes: i32,
    pub pixmap: *const u8,
}

/// `TQARect`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct RawRect {
    pub left: i32,
    pub right: i32,
    pub top: i32,
    pub bottom: i32,
}

/// `TQADeviceMemory` and `TQAPixelBuffer`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct RawMemory {
    pub row_bytes: i32,
    pub pixel_type: u32,
    pub width: i32,
    pub height: i32,
    pub base: *mut u8,
}

/// `TQADevice`, of a memory device. Of an off-screen one the pixel type comes
/// first.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct RawDevice {
    pub device_type: u32,
    pub memory: RawMemory,
}

/// `TQAZBuffer`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct RawZBuffer {
    pub width: i32,
    pub height: i32,
    pub row_bytes: i32,
    pub zbuffer: *mut u8,
    pub z_depth: i32,
    pub is_big_endian: i32,
}

/// `TQAClip`, of rectangles.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct RawClip {
    pub clip_type: u32,
    pub rects: *const RawClipRects,
}

/// `TQAClipRectList`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct RawClipRects {
    pub count: i32,
    pub rects: *const RawRect,
}

/// `TQAGlobalRect`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct RawGlobalRect {
    pub top: i16,
    pub left: i16,
    pub bottom: i16,
    pub right: i16,
}

/// `kQAClipRects`.
pub const CLIP_RECTS: u32 = 1000;

/// What lies in the program's memory in one layout, and crosses in another.
pub trait Raw: Copy {
    /// In the program's memory.
    type Layout: Copy;
    /// What it means.
    fn from_layout(raw: Self::Layout) -> Self;
}

impl Raw for VGouraud {
    type Layout = [f32; 8];
    fn from_layout([x, y, z, inv_w, r, g, b, a]: [f32; 8]) -> VGouraud {
        VGouraud { x, y, z, inv_w, r, g, b, a }
    }
}

impl Raw for VTexture {
    type Layout = [f32; 16];
    fn from_layout(raw: [f32; 16]) -> VTexture {
        let [x, y, z, inv_w, r, g, b, a, u_over_w, v_over_w, kd_r, kd_g, kd_b, ks_r, ks_g, ks_b] =
            raw;
        VTexture {
            x,
            y,
            z,
            inv_w,
            r,
            g,
            b,
            a,
            u_over_w,
            v_over_w,
            kd_r,
            kd_g,
            kd_b,
            ks_r,
            ks_g,
            ks_b,
        }
    }
}

impl Raw for VMultiTexture {
    type Layout = [f32; 3];
    fn from_layout([inv_w, u_over_w, v_over_w]: [f32; 3]) -> VMultiTexture {
        VMultiTexture { inv_w, u_over_w, v_over_w }
    }
}

impl Raw for IndexedTriangle {
    type Layout = [u32; 4];
    fn from_layout([flags, a, b, c]: [u32; 4]) -> IndexedTriangle {
        IndexedTriangle { flags, vertices: [a, b, c] }
    }
}

impl Raw for u32 {
    type Layout = u32;
    fn from_layout(raw: u32) -> u32 {
        raw
    }
}

impl Raw for RaveRect {
    type Layout = RawRect;
    fn from_layout(raw: RawRect) -> RaveRect {
        RaveRect { left: raw.left, right: raw.right, top: raw.top, bottom: raw.bottom }
    }
}

/// What a pointer points to; `None` for null.
///
/// # Safety
/// `pointer` is null or points to a readable value.
pub unsafe fn value<T: Raw>(pointer: *const T::Layout) -> Option<T> {
    // SAFETY: the caller's promise.
    unsafe { read(pointer) }.map(T::from_layout)
}

/// An array; `None` for null, unless nothing is in it, or for more than
/// [`MAX_ELEMENTS`].
///
/// # Safety
/// `pointer` is null or points to `count` readable values.
pub unsafe fn values<T: Raw>(pointer: *const T::Layout, count: u32) -> Option<Vec<T>> {
    if count == 0 {
        return Some(Vec::new());
    }
    if pointer.is_null() || count > MAX_ELEMENTS {
        return None;
    }
    // SAFETY: the caller's promise; a layout may lie at any address.
    let at = |i| unsafe { pointer.add(i).read_unaligned() };
    Some((0..count as usize).map(|i| T::from_layout(at(i))).collect())
}

impl From<RaveRect> for RawRect {
    fn from(rect: RaveRect) -> RawRect {
        RawRect { left: rect.left, right: rect.right, top: rect.top, bottom: rect.bottom }
    }
}

/// A picture with its pixels; none where it cannot be a picture, which the
/// library then refuses.
///
/// # Safety
/// The rows can be read as its members say.
pub unsafe fn image(pixel_type: u32, raw: &RawImage) -> ImageValue {
    let empty = ImageValue { width: raw.width, height: raw.height, ..ImageValue::default() };
    let (Ok(width), Ok(height)) = (u32::try_from(raw.width), u32::try_from(raw.height)) else {
        return empty;
    };
    let row = PixelType::from_number(pixel_type).map_or(0, |kind| kind.row_bytes(width));
    let stride = usize::try_from(raw.row_bytes).unwrap_or(0);
    let is_large = u64::from(width) * u64::from(height) > MAX_PIXELS;
    if raw.pixmap.is_null() || row == 0 || row > stride || is_large {
        return empty;
    }
    let mut pixels = Vec::with_capacity(row * height as usize);
    for y in 0..height as usize {
        // SAFETY: the caller's promise.
        pixels.extend_from_slice(unsafe { bytes(raw.pixmap.add(y * stride), row) });
    }
    if let Some(kind) = PixelType::from_number(pixel_type) {
        Order::of_pictures(kind).turn(&mut pixels);
    }
    ImageValue { pixels: pixels.into(), ..empty }
}

/// The images of a texture: one, or with `is_mipmapped` as many as the first
/// one's size asks for.
///
/// # Safety
/// `images` is null or points to that many, which can be read.
pub unsafe fn image_chain(images: *const RawImage, is_mipmapped: bool) -> Vec<RawImage> {
    // SAFETY: the caller's promise.
    let Some(first) = (unsafe { read(images) }) else { return Vec::new() };
    let longest = first.width.max(first.height);
    let is_chain = is_mipmapped && (1..=1 << 15).contains(&longest);
    let count = if is_chain { longest.ilog2() as usize + 1 } else { 1 };
    // SAFETY: the caller's promise.
    (0..count).filter_map(|i| unsafe { read(images.add(i)) }).collect()
}

/// A device without its address.
pub fn device_value(raw: &RawDevice) -> DeviceValue {
    if raw.device_type == fillrate_rave::constants::device::OFFSCREEN {
        let pixel_type = raw.memory.row_bytes as u32;
        return DeviceValue { device_type: raw.device_type, pixel_type, ..DeviceValue::default() };
    }
    DeviceValue {
        device_type: raw.device_type,
        pixel_type: raw.memory.pixel_type,
        width: raw.memory.width,
        height: raw.memory.height,
        row_bytes: raw.memory.row_bytes,
    }
}

/// Reads a device. Only as much is read as its type has.
///
/// # Safety
/// `pointer` is null or points to a device.
pub unsafe fn read_device(pointer: *const RawDevice) -> Option<RawDevice> {
    if pointer.is_null() {
        return None;
    }
    let nothing =
        RawMemory { row_bytes: 0, pixel_type: 0, width: 0, height: 0, base: std::ptr::null_mut() };
    // SAFETY: not null, so a device by the caller's promise.
    let device_type = unsafe { (&raw const (*pointer).device_type).read_unaligned() };
    let memory = match device_type {
        // SAFETY: memory devices have this.
        0 => unsafe { (&raw const (*pointer).memory).read_unaligned() },
        fillrate_rave::constants::device::OFFSCREEN => RawMemory {
            // SAFETY: off-screen devices start with a pixel type.
            row_bytes: unsafe { (&raw const (*pointer).memory.row_bytes).read_unaligned() },
            ..nothing
        },
        _ => nothing,
    };
    Some(RawDevice { device_type, memory })
}

/// A clip's rectangles; `Err` for clips of window systems.
///
/// # Safety
/// `pointer` is null or points to a clip, with its rectangles.
pub unsafe fn read_clip(pointer: *const RawClip) -> Result<Option<Vec<RaveRect>>, i32> {
    // SAFETY: the caller's promise.
    let Some(clip) = (unsafe { read(pointer) }) else { return Ok(None) };
    if clip.clip_type != CLIP_RECTS {
        return Err(PARAM_ERR);
    }
    // SAFETY: the caller's promise.
    let list = unsafe { read(clip.rects) }.ok_or(PARAM_ERR)?;
    let count = u32::try_from(list.count).map_err(|_| PARAM_ERR)?;
    // SAFETY: the caller's promise.
    let rects = if count == 0 { Some(Vec::new()) } else { unsafe { values(list.rects, count) } };
    rects.map(Some).ok_or(PARAM_ERR)
}
