//! The virtual graphics processor. Objects that were not initialized, and null
//! pointers, are ignored.

use std::ffi::{CStr, c_char};
use std::mem::offset_of;

use fillrate_guard::{guard, read, write};
use fillrate_quark::{Call, ErrorCode, ListView, RasterState, Reply};

use crate::layout::{RawGpu, RawList, RawState, RawVertex};
use crate::list::{list_value, parts};
use crate::session::{Session, Target, session};
use crate::sync::{FrameWords, KnownGpu, OwnState};

/// An initialized processor during a call.
struct Object {
    address: usize,
    number: u32,
    raw: RawGpu,
}

/// Does something with an initialized processor. What the program wrote into
/// the frame buffer is taken over before, what was drawn is shown after.
///
/// # Safety
/// `gpu` is null or points to a processor.
unsafe fn on<T: Copy>(
    gpu: *const RawGpu,
    fallback: T,
    action: impl FnOnce(&mut Session, &Object) -> T,
) -> T {
    guard(fallback, || {
        let address = gpu as usize;
        let mut session = session();
        let Some(number) = session.gpus.get(&address).map(|known| known.number) else {
            return fallback;
        };
        // SAFETY: the caller's promise.
        let Some(raw) = (unsafe { read(gpu) }) else { return fallback };
        session.import_frame(address);
        let result = action(&mut session, &Object { address, number, raw });
        session.export_frame(address);
        result
    })
}

/// The states that a processor starts with.
fn default_state() -> RawState {
    let state = RasterState::default();
    RawState {
        draw_mode: state.draw_mode as u8,
        draw_color: state.draw_color,
        draw_intensity: state.draw_intensity,
        test_culling: state.test_culling.into(),
        z_sort: state.z_sort.into(),
        padding: [0; 3],
        texture: std::ptr::null(),
    }
}

/// Makes the frame buffer and the default states; 1 on success.
///
/// # Safety
/// `gpu` is null or points to room for a processor.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_gpu_init(gpu: *mut RawGpu, near: i32, far: i32, fov: i32) -> i32 {
    guard(0, || {
        if gpu.is_null() {
            return 0;
        }
        let mut session = session();
        let raw = session.init(gpu as usize, near, far, fov);
        let Some(raw) = raw else { return 0 };
        // SAFETY: the caller's promise.
        unsafe { write(gpu, raw) };
        session.export_frame(gpu as usize);
        1
    })
}

impl Session {
    fn init(&mut self, address: usize, near: i32, far: i32, fov: i32) -> Option<RawGpu> {
        let old = self.gpus.remove(&address);
        let number = old.as_ref().map_or(self.last_gpu + 1, |known| known.number);
        self.last_gpu = self.last_gpu.max(number);
        let made = self.call(&Call::Init { gpu: number, near, far, fov }).number();
        let camera = self.context.gpu(number).filter(|_| made != 0)?.camera;
        let frame = old.and_then(|known| known.frame);
        let raw = RawGpu {
            text_state: default_state(),
            line_state: default_state(),
            sprite_state: default_state(),
            triangle_state: std::ptr::null(),
            triangle_mode: 0,
            zoom: camera.zoom,
            clip_near: camera.near,
            clip_far: camera.far,
            frustum: camera.frustum,
            view_matrix: std::ptr::null(),
            frame_counter: 0,
            frame_buffer: frame.as_ref().map_or(std::ptr::null_mut(), |frame| frame.block),
            zc_error_max: 0,
        };
        let mut known = KnownGpu::new(number, &raw);
        known.frame = frame;
        self.gpus.insert(address, known);
        Some(raw)
    }

    /// Takes over what the program wrote into the frame buffer.
    fn import_frame(&mut self, address: usize) {
        let Some(known) = self.gpus.get(&address) else { return };
        let Some(frame) = &known.frame else { return };
        let mut changes = Vec::new();
        for (i, shown) in frame.shown.iter().enumerate() {
            // SAFETY: the block holds as many words as were shown.
            let word = unsafe { frame.block.add(i).read_volatile() };
            if word != *shown {
                changes.extend((i as u32).to_le_bytes());
                changes.extend(word.to_le_bytes());
            }
        }
        if !changes.is_empty() {
            let gpu = known.number;
            self.call(&Call::FrameBuffer { gpu, words: changes.into() });
        }
    }

    /// Shows the program what was drawn.
    fn export_frame(&mut self, address: usize) {
        let Some(known) = self.gpus.get_mut(&address) else { return };
        let Some(frame) = &mut known.frame else { return };
        let Some(gpu) = self.context.gpu(known.number) else { return };
        frame.shown = gpu.frame_buffer();
        for (i, word) in frame.shown.iter().enumerate() {
            // SAFETY: the block holds a screen's words.
            unsafe { frame.block.add(i).write_volatile(*word) };
        }
    }

    /// The program's view of the frame buffer, from now on up to date.
    fn map_frame(&mut self, address: usize) -> *mut u32 {
        let Some(known) = self.gpus.get(&address) else { return std::ptr::null_mut() };
        if let Some(frame) = &known.frame {
            return frame.block;
        }
        let number = known.number;
        let words = self.context.gpu(number).map_or(0, |gpu| {
            let (width, height) = gpu.size();
            (width * height) as usize
        });
        let Some(block) = self.memory.allocate(words * 4) else { return std::ptr::null_mut() };
        let block = block.cast();
        if let Some(known) = self.gpus.get_mut(&address) {
            known.frame = Some(FrameWords { block, shown: Vec::new() });
        }
        self.export_frame(address);
        block
    }
}

/// Frees everything.
///
/// # Safety
/// `gpu` is null or points to a processor.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_gpu_delete(gpu: *mut RawGpu) {
    guard((), || {
        let mut session = session();
        let Some(known) = session.gpus.remove(&(gpu as usize)) else { return };
        session.call(&Call::Delete { gpu: known.number });
        if let Some(frame) = known.frame {
            session.memory.free(frame.block);
            // SAFETY: an initialized processor is not null.
            unsafe { write(&raw mut (*gpu).frame_buffer, std::ptr::null_mut()) };
        }
    })
}

/// The words of the frame buffer of the processor that `member` is part of.
///
/// # Safety
/// `member` is null or the address of a processor's `FrameBuffer`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_frame_buffer(member: *const *mut u32) -> *mut u32 {
    guard(std::ptr::null_mut(), || {
        let address = (member as usize).wrapping_sub(offset_of!(RawGpu, frame_buffer));
        let mut session = session();
        let block = session.map_frame(address);
        if !block.is_null() {
            // SAFETY: part of an initialized processor.
            unsafe { write(member.cast_mut(), block) };
        }
        block
    })
}

/// Exports that make a call of numbers after bringing a state up to date.
macro_rules! draws {
    ($($(#[$doc:meta])* $name:ident($($arg:ident: $type:ty),*) $state:expr => $call:expr;)*) => {$(
        $(#[$doc])*
        ///
        /// # Safety
        /// `gpu` is null or points to a processor whose members can be read.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(gpu: *const RawGpu $(, $arg: $type)*) {
            // SAFETY: the caller's promise.
            unsafe {
                on(gpu, (), |session, object| {
                    let state: Option<OwnState> = $state;
                    if let Some(state) = state {
                        session.sync_own_state(object.address, &object.raw, state);
                    }
                    let make: fn(u32 $(, $type)*) -> Call = $call;
                    session.call(&make(object.number $(, $arg)*));
                })
            }
        }
    )*};
}

draws! {
    /// Draws the frame rate.
    quark_gpu_print_fps(ticks: u32) Some(OwnState::Text) =>
        |gpu, ticks| Call::PrintFps { gpu, ticks };
    /// Sets a pixel.
    quark_gpu_put_pixel(x: i32, y: i32, color: i32) None =>
        |gpu, x, y, color| Call::PutPixel { gpu, x, y, color };
    /// Draws a sprite.
    quark_gpu_draw_sprite(x: i32, y: i32) Some(OwnState::Sprite) =>
        |gpu, x, y| Call::DrawSprite { gpu, x, y };
    /// Draws a scaled sprite.
    quark_gpu_draw_sprite_scale(x: i32, y: i32, scale: i32) Some(OwnState::Sprite) =>
        |gpu, x, y, scale| Call::DrawSpriteScale { gpu, x, y, scale };
    /// Empties the sort table.
    quark_gpu_sort_reset() None => |gpu| Call::SortReset { gpu };
}

/// Draws text that ends with a zero.
///
/// # Safety
/// `gpu` is null or points to a processor whose members can be read; `text` is
/// null or ends with a zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_gpu_print_xy(
    gpu: *const RawGpu,
    text: *const c_char,
    x: i32,
    y: i32,
) {
    // SAFETY: the caller's promise.
    unsafe {
        on(gpu, (), |session, object| {
            if text.is_null() {
                return;
            }
            let text = CStr::from_ptr(text).to_bytes().to_vec();
            session.sync_own_state(object.address, &object.raw, OwnState::Text);
            session.call(&Call::PrintXy { gpu: object.number, text, x, y });
        })
    }
}

/// Draws a line.
///
/// # Safety
/// `gpu` is null or points to a processor whose members can be read; `a` and
/// `b` are null or point to three numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_gpu_draw_line(
    gpu: *const RawGpu,
    a: *const [i32; 3],
    b: *const [i32; 3],
) {
    // SAFETY: the caller's promise.
    unsafe {
        on(gpu, (), |session, object| {
            let (Some(a), Some(b)) = (read(a), read(b)) else { return };
            session.sync_own_state(object.address, &object.raw, OwnState::Line);
            session.call(&Call::DrawLine { gpu: object.number, a, b });
        })
    }
}

/// Draws a sprite over a rectangle.
///
/// # Safety
/// `gpu` is null or points to a processor whose members can be read; the
/// corners are null or point to two numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_gpu_draw_sprite_scale_zb(
    gpu: *const RawGpu,
    top_left: *const [i32; 2],
    bottom_right: *const [i32; 2],
    z: i32,
) {
    // SAFETY: the caller's promise.
    unsafe {
        on(gpu, (), |session, object| {
            let (Some(top_left), Some(bottom_right)) = (read(top_left), read(bottom_right)) else {
                return;
            };
            session.sync_own_state(object.address, &object.raw, OwnState::Sprite);
            let gpu = object.number;
            session.call(&Call::DrawSpriteScaleZb { gpu, top_left, bottom_right, z });
        })
    }
}

/// Draws a triangle.
///
/// # Safety
/// `gpu` is null or points to a processor whose members, and what they point
/// to, can be read; corners are null or point to vertices.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_gpu_draw_triangle(
    gpu: *const RawGpu,
    a: *const RawVertex,
    b: *const RawVertex,
    c: *const RawVertex,
) {
    // SAFETY: the caller's promise.
    unsafe {
        on(gpu, (), |session, object| {
            let (Some(a), Some(b), Some(c)) = (read(a), read(b), read(c)) else { return };
            session.sync_triangle_mode(object.address, &object.raw);
            session.sync_triangle_state(object.address, &object.raw);
            session.call(&Call::DrawTriangle { gpu: object.number, a, b, c });
        })
    }
}

/// Draws a triangle list; an error code.
///
/// # Safety
/// `gpu` is null or points to a processor whose members, and what they point
/// to, can be read; `list` is null or points to a list whose memory, and the
/// states that its commands name, can be read.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_gpu_draw_triangle_list(
    gpu: *const RawGpu,
    list: *const RawList,
) -> i32 {
    // SAFETY: the caller's promise.
    unsafe {
        on(gpu, ErrorCode::Memory.code(), |session, object| {
            let Some(list) = read(list) else { return ErrorCode::Memory.code() };
            session.sync_triangle_mode(object.address, &object.raw);
            session.sync_view_matrix(object.address, &object.raw);
            session.sync_camera(object.address, &object.raw);
            session.draw_list(object.number, &list).map_or_else(ErrorCode::code, |()| 0)
        })
    }
}

impl Session {
    /// # Safety
    /// The list's memory and the states it names can be read.
    unsafe fn draw_list(&mut self, gpu: u32, list: &RawList) -> Result<(), ErrorCode> {
        // SAFETY: the caller's promise.
        let parts = unsafe { parts(list)? };
        let last = parts.commands.iter().map(|command| usize::from(command.state)).max();
        let count = if list.state.is_null() { 0 } else { last.map_or(0, |last| last + 1) };
        let mut values = Vec::with_capacity(count);
        for i in 0..count {
            // SAFETY: a state that a command names.
            let state = unsafe { list.state.add(i).read_unaligned() };
            // SAFETY: the caller's promise.
            values.push(unsafe { self.state_value(&state) }.0);
        }
        if self.is_recording() {
            let list = list_value(&parts, values);
            let reply = self.call(&Call::DrawTriangleList { gpu, list }).number();
            return match ErrorCode::ALL.into_iter().find(|code| code.code() == reply) {
                None | Some(ErrorCode::None) => Ok(()),
                Some(code) => Err(code),
            };
        }
        // The hot path: what nobody records is not copied.
        let states: Vec<RasterState> =
            values.iter().map(|value| self.context.state(value)).collect();
        let view = ListView {
            vertex_format: parts.vertex_format,
            index_format: parts.index_format,
            vertices: parts.vertices,
            indices: parts.indices,
            commands: parts.commands,
            states: &states,
        };
        self.context.gpu(gpu).map_or(Ok(()), |gpu| gpu.draw_list(&view))
    }
}

/// Draws the sorted faces.
///
/// # Safety
/// `gpu` is null or points to a processor.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_gpu_sort_draw(gpu: *const RawGpu) {
    // SAFETY: the caller's promise.
    unsafe {
        on(gpu, (), |session, object| {
            session.sync_triangle_mode(object.address, &object.raw);
            session.call(&Call::SortDraw { gpu: object.number });
        })
    }
}

/// Makes room for lists and sorted faces; 1 on success.
///
/// # Safety
/// `gpu` is null or points to a processor.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_gpu_set_work_memory(
    gpu: *const RawGpu,
    max_vertex: i32,
    max_sort: i32,
) -> i32 {
    // SAFETY: the caller's promise.
    unsafe {
        on(gpu, 0, |session, object| {
            let gpu = object.number;
            session.call(&Call::SetWorkMemory { gpu, max_vertex, max_sort }).number()
        })
    }
}

/// Shows the frame and clears the frame buffer.
///
/// # Safety
/// `gpu` is null or points to a processor; the memory of the target `address`
/// is as large as was said.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_gpu_flush_fb(gpu: *mut RawGpu, address: u32, clear_color: i32) {
    // SAFETY: the caller's promise.
    unsafe {
        on(gpu, (), |session, object| {
            session.sync_frame_counter(object.address, &object.raw);
            session.call(&Call::FlushFb { gpu: object.number, address, clear_color });
            let count = session.context.gpu(object.number).map_or(0, |gpu| gpu.frame_counter);
            if let Some(known) = session.gpus.get_mut(&object.address) {
                known.frame_counted(count);
            }
            write(&raw mut (*gpu).frame_counter, count);
            session.copy_to_target(address);
            session.frame_shown();
        })
    }
}

/// What addresses of targets have in common; the rest counts them.
const TARGET_TAG: u32 = 0x5133_0000;
/// The most targets.
const MAX_TARGETS: usize = 1 << 12;

impl Session {
    fn target(&self, address: u32) -> Option<Target> {
        let index = address ^ TARGET_TAG;
        self.targets.get(index as usize).copied().flatten()
    }

    /// # Safety
    /// The target's memory is as large as was said.
    unsafe fn copy_to_target(&mut self, address: u32) {
        let Some(target) = self.target(address) else { return };
        let Some(shown) = self.context.shown() else { return };
        for (offset, pixel) in shown.placed(target.right, target.down) {
            let place = target.base.wrapping_add_signed(offset as isize) as *mut u16;
            // SAFETY: the caller's promise.
            unsafe { place.write_unaligned(pixel) };
        }
    }
}

/// Makes memory a target of frames.
///
/// # Safety
/// Until the target is deleted, 240x320 pixels at these distances can be
/// written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_target(base: *mut u16, right: i32, down: i32) -> u32 {
    guard(0, || {
        let mut session = session();
        if base.is_null() {
            return 0;
        }
        let free = session.targets.iter().position(Option::is_none);
        let index = free.unwrap_or(session.targets.len());
        if index >= MAX_TARGETS {
            return 0;
        }
        let target = Target { base: base as usize, right: right.into(), down: down.into() };
        if index == session.targets.len() {
            session.targets.push(None);
        }
        session.targets[index] = Some(target);
        TARGET_TAG | index as u32
    })
}

/// Forgets a target.
#[unsafe(no_mangle)]
pub extern "C" fn quark_target_delete(address: u32) {
    guard((), || {
        let mut session = session();
        if let Some(target) = session.targets.get_mut((address ^ TARGET_TAG) as usize) {
            *target = None;
        }
    })
}

/// Sets the field of view; half of it as an angle, 0 on failure.
///
/// # Safety
/// `gpu` is null or points to a processor.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_gpu_set_fov(gpu: *mut RawGpu, fov: i32) -> i32 {
    // SAFETY: the caller's promise.
    unsafe {
        on(gpu, 0, |session, object| {
            session.sync_camera(object.address, &object.raw);
            let half = session.call(&Call::SetFov { gpu: object.number, fov }).number();
            session.show_camera(object, gpu);
            half
        })
    }
}

/// Sets the clipping planes; 1 on success.
///
/// # Safety
/// `gpu` is null or points to a processor.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_gpu_set_nf_clip(gpu: *mut RawGpu, near: i32, far: i32) -> i32 {
    // SAFETY: the caller's promise.
    unsafe {
        on(gpu, 0, |session, object| {
            session.sync_camera(object.address, &object.raw);
            let gpu_number = object.number;
            let done = session.call(&Call::SetNfClip { gpu: gpu_number, near, far }).number();
            session.show_camera(object, gpu);
            done
        })
    }
}

impl Session {
    /// Writes the camera into the program's members.
    ///
    /// # Safety
    /// `gpu` points to the processor.
    unsafe fn show_camera(&mut self, object: &Object, gpu: *mut RawGpu) {
        let Some(camera) = self.context.gpu(object.number).map(|gpu| gpu.camera) else { return };
        let raw = RawGpu {
            zoom: camera.zoom,
            clip_near: camera.near,
            clip_far: camera.far,
            frustum: camera.frustum,
            ..object.raw
        };
        // SAFETY: the caller's promise.
        unsafe { write(gpu, raw) };
        if let Some(known) = self.gpus.get_mut(&object.address) {
            known.camera_changed(&raw);
        }
    }
}

/// Projects a point; its clip mask.
///
/// # Safety
/// `gpu` is null or points to a processor; `position` is null or points to
/// three numbers; `screen` is null or has room for three.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_gpu_scr_projection(
    gpu: *const RawGpu,
    position: *const [i32; 3],
    screen: *mut [i32; 3],
) -> i32 {
    // SAFETY: the caller's promise.
    unsafe {
        on(gpu, 0, |session, object| {
            let Some(position) = read(position) else { return 0 };
            session.sync_camera(object.address, &object.raw);
            let reply = session.call(&Call::ScrProjection { gpu: object.number, position });
            if let Reply::Projected(_, Some(at)) = reply {
                write(screen, at);
            }
            reply.number()
        })
    }
}

/// The clip mask of a point.
///
/// # Safety
/// `gpu` is null or points to a processor; `position` is null or points to
/// three numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_gpu_clip_msk(gpu: *const RawGpu, position: *const [i32; 3]) -> i32 {
    // SAFETY: the caller's promise.
    unsafe {
        on(gpu, 0, |session, object| {
            let Some(position) = read(position) else { return 0 };
            session.sync_camera(object.address, &object.raw);
            session.call(&Call::ClipMsk { gpu: object.number, position }).number()
        })
    }
}

/// Whether a box may be visible.
///
/// # Safety
/// `gpu` is null or points to a processor; `corners` is null or points to 24
/// numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_gpu_cross_frustrum(
    gpu: *const RawGpu,
    corners: *const [[i32; 3]; 8],
) -> i32 {
    // SAFETY: the caller's promise.
    unsafe {
        on(gpu, 0, |session, object| {
            let Some(corners) = read(corners) else { return 0 };
            session.sync_camera(object.address, &object.raw);
            session.call(&Call::CrossFrustrum { gpu: object.number, corners }).number()
        })
    }
}
