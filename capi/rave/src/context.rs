//! Draw contexts: making and deleting them, and the methods they start with.

use std::ffi::c_void;

use fillrate_guard::{guard, write};
use fillrate_rave::{Call, constants};

use crate::draw;
use crate::engine::Engine;
use crate::fallback;
use crate::layout::{
    METHODS, Method, PARAM_ERR, RawClip, RawDevice, RawDrawContext, RawRect, device_value,
    read_clip, read_device, value,
};
use crate::manager::Who;
use crate::session::{Foreign, Known, as_pointer, session};
use crate::{access, ati, notice, render};

/// `kQAVersion_1_6`.
const VERSION: u32 = constants::VERSION;
/// `kQAError`.
const ERROR: i32 = 1;

/// Methods of the built-in engine, in the order of their tags.
pub const BUILT_IN_METHODS: [Method; METHODS] = [
    draw::set_float as Method,
    draw::set_int as Method,
    draw::set_ptr as Method,
    draw::get_float as Method,
    draw::get_int as Method,
    draw::get_ptr as Method,
    draw::draw_point as Method,
    draw::draw_line as Method,
    draw::draw_tri_gouraud as Method,
    draw::draw_tri_texture as Method,
    draw::draw_v_gouraud as Method,
    draw::draw_v_texture as Method,
    draw::draw_bitmap as Method,
    render::render_start as Method,
    render::render_end as Method,
    render::render_abort as Method,
    render::flush as Method,
    render::sync as Method,
    draw::submit_vertices_gouraud as Method,
    draw::submit_vertices_texture as Method,
    draw::draw_tri_mesh_gouraud as Method,
    draw::draw_tri_mesh_texture as Method,
    notice::set_notice_method as Method,
    notice::get_notice_method as Method,
    draw::submit_multi_texture_params as Method,
    access::access_draw_buffer as Method,
    access::access_draw_buffer_end as Method,
    access::access_z_buffer as Method,
    access::access_z_buffer_end as Method,
    access::clear_draw_buffer as Method,
    access::clear_z_buffer as Method,
    access::texture_from_context as Method,
    access::bitmap_from_context as Method,
    render::busy as Method,
    render::swap_buffers as Method,
];

/// Makes a draw context.
///
/// # Safety
/// All pointers are null or point to what they are declared as; with the flag
/// Scale `rect` points to two rectangles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QADrawContextNew(
    device: *const RawDevice,
    rect: *const RawRect,
    clip: *const RawClip,
    engine: *const c_void,
    flags: u32,
    made: *mut *mut RawDrawContext,
) -> i32 {
    guard(ERROR, || {
        // SAFETY: the caller's promise.
        unsafe { write(made, std::ptr::null_mut()) };
        if made.is_null() || device.is_null() || rect.is_null() {
            return PARAM_ERR;
        }
        let who = session().engine(engine);
        let result = match who {
            None => Err(PARAM_ERR),
            // SAFETY: the caller's promise.
            Some(Who::BuiltIn) => unsafe { new_built_in(device, rect, clip, flags) },
            // SAFETY: the caller's promise.
            Some(Who::Program(engine)) => unsafe { new_foreign(engine, device, rect, clip, flags) },
        };
        match result {
            Ok(context) => {
                // SAFETY: the caller's promise.
                unsafe { write(made, context) };
                0
            }
            Err(status) => status,
        }
    })
}

/// # Safety
/// As [`QADrawContextNew`].
unsafe fn new_built_in(
    device: *const RawDevice,
    rect: *const RawRect,
    clip: *const RawClip,
    flags: u32,
) -> Result<*mut RawDrawContext, i32> {
    // SAFETY: the caller's promise.
    let raw = unsafe { read_device(device) }.ok_or(PARAM_ERR)?;
    // SAFETY: the caller's promise.
    let first = unsafe { value(rect) }.ok_or(PARAM_ERR)?;
    let is_scaled = flags & constants::context::SCALE != 0;
    // SAFETY: with the flag there are two.
    let scaled = if is_scaled { unsafe { value(rect.add(1)) } } else { None };
    // SAFETY: the caller's promise.
    let clip = unsafe { read_clip(clip) }?;
    let is_memory = raw.device_type == constants::device::MEMORY;
    if is_memory && raw.memory.base.is_null() && flags & constants::context::CACHE == 0 {
        return Err(PARAM_ERR);
    }
    let mut session = session();
    let reply = session.call(&Call::DrawContextNew {
        engine: fillrate_rave::EngineId::BUILT_IN.0,
        device: device_value(&raw),
        rect: first,
        scaled,
        clip: clip.clone(),
        flags,
    });
    let number = reply.created();
    if number == 0 {
        return Err(reply.number());
    }
    let context = Box::into_raw(Box::new(RawDrawContext {
        draw_private: as_pointer(number),
        version: VERSION,
        methods: BUILT_IN_METHODS,
    }));
    let is_cache = flags & constants::context::CACHE != 0;
    let known = Known {
        number,
        device: (is_memory && !raw.memory.base.is_null()).then_some(raw.memory),
        rect: scaled.unwrap_or(first),
        clip,
        is_cache,
        screen: if is_cache { 0 } else { session.new_screen() },
        ..Known::default()
    };
    session.contexts.insert(context as usize, known);
    Ok(context)
}

/// # Safety
/// As [`QADrawContextNew`].
unsafe fn new_foreign(
    engine: Engine,
    device: *const RawDevice,
    rect: *const RawRect,
    clip: *const RawClip,
    flags: u32,
) -> Result<*mut RawDrawContext, i32> {
    let context = Box::into_raw(Box::new(RawDrawContext {
        draw_private: std::ptr::null_mut(),
        version: VERSION,
        methods: fallback::METHODS_OF_NONE,
    }));
    let foreign = Foreign { engine, submitted: [(0, 0); 2] };
    session().foreign.insert(context as usize, foreign);
    // SAFETY: the caller's promise; the context is new.
    let status =
        unsafe { engine.draw_private_new(context, device.cast(), rect.cast(), clip.cast(), flags) };
    if status != 0 {
        session().foreign.remove(&(context as usize));
        // SAFETY: made above, and known to nobody now.
        drop(unsafe { Box::from_raw(context) });
        return Err(status);
    }
    Ok(context)
}

/// Deletes a draw context. Others than ours are ignored.
///
/// # Safety
/// The context is not used afterwards.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QADrawContextDelete(context: *mut RawDrawContext) {
    guard((), || {
        let address = context as usize;
        // SAFETY: no lock is held.
        unsafe { render::show_late(context) };
        let mut locked = session();
        if let Some(known) = locked.contexts.remove(&address) {
            locked.call(&Call::DrawContextDelete { context: known.number });
        } else if let Some(foreign) = locked.foreign.remove(&address) {
            drop(locked);
            // SAFETY: a context of ours that is still there.
            let draw_private = unsafe { (*context).draw_private };
            // SAFETY: what the engine made.
            unsafe { foreign.engine.draw_private_delete(draw_private) };
        } else {
            return;
        }
        // SAFETY: a context of ours; it has left the lists.
        drop(unsafe { Box::from_raw(context) });
    })
}

/// Replaces a method of a draw context.
///
/// # Safety
/// The method has the signature of the tag.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QARegisterDrawMethod(
    context: *mut RawDrawContext,
    tag: i32,
    method: Method,
) -> i32 {
    guard(ERROR, || {
        let session = session();
        let address = context as usize;
        let is_ours =
            session.contexts.contains_key(&address) || session.foreign.contains_key(&address);
        let slot = usize::try_from(tag).ok().filter(|&slot| slot < METHODS);
        match slot {
            Some(slot) if is_ours && !method.is_null() => {
                // SAFETY: a context of ours.
                unsafe { (*context).methods[slot] = method };
                0
            }
            _ => PARAM_ERR,
        }
    })
}

/// The ATI extension's table, for its tag.
pub fn extension(tag: u32) -> Option<*mut c_void> {
    (tag == fillrate_rave::tags::ati::EXTENSION_FUNCTIONS).then(ati::functions)
}
