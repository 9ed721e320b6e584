//! Notices: functions of the program that the library calls.

use std::ffi::{c_long, c_void};

use fillrate_guard::{guard, write};
use fillrate_rave::{Call, DrawContextId, RaveRect, constants};

use crate::layout::{
    Method, PARAM_ERR, RawDevice, RawDrawContext, RawGlobalRect, RawMemory, RawRect,
};
use crate::order::Order;
use crate::render::show_what_is_drawn;
use crate::session::session;

/// A function of the program and what it is called with.
#[derive(Clone, Copy)]
pub struct Notice {
    method: Method,
    ref_con: *mut c_void,
}

impl Default for Notice {
    fn default() -> Notice {
        Notice { method: std::ptr::null(), ref_con: std::ptr::null_mut() }
    }
}

/// `TQAStandardNoticeMethod`.
type Standard = unsafe extern "C" fn(*const RawDrawContext, *mut c_void);
/// `TQABufferNoticeMethod`.
type Buffer =
    unsafe extern "C" fn(*const RawDrawContext, *const RawDevice, *const RawRect, *mut c_void);
/// `TQADrawNotificationProc`.
type DrawProc = unsafe extern "C" fn(i16, i16, i16, i16, c_long);

/// Somebody who wants to know of every drawing to the screen.
#[derive(Clone, Copy)]
pub struct DrawNotice {
    rect: RaveRect,
    proc: DrawProc,
    ref_con: c_long,
}

/// `kQAError`.
const ERROR: i32 = 1;

fn slot_of(selector: i32) -> Option<usize> {
    let slot = usize::try_from(selector).ok()?;
    (slot < constants::notice::NUM_SELECTORS as usize).then_some(slot)
}

/// `QASetNoticeMethod`: null removes it.
pub extern "C" fn set_notice_method(
    context: *const RawDrawContext,
    selector: i32,
    method: Method,
    ref_con: *mut c_void,
) -> i32 {
    guard(ERROR, || {
        let mut session = session();
        let known = session.contexts.get_mut(&(context as usize));
        let (Some(known), Some(slot)) = (known, slot_of(selector)) else { return PARAM_ERR };
        known.notices[slot] = Notice { method, ref_con };
        let (context, installed) = (known.number, !method.is_null());
        let selector = slot as u32;
        session.call(&Call::SetNoticeMethod { context, selector, installed }).number()
    })
}

/// `QAGetNoticeMethod`: null where there is none.
///
/// # Safety
/// The pointers are null or can be written.
pub unsafe extern "C" fn get_notice_method(
    context: *const RawDrawContext,
    selector: i32,
    method: *mut Method,
    ref_con: *mut *mut c_void,
) -> i32 {
    guard(ERROR, || {
        let session = session();
        let known = session.contexts.get(&(context as usize));
        let (Some(known), Some(slot)) = (known, slot_of(selector)) else { return PARAM_ERR };
        // SAFETY: the caller's promise.
        unsafe { write(method, known.notices[slot].method) };
        // SAFETY: the caller's promise.
        unsafe { write(ref_con, known.notices[slot].ref_con) };
        0
    })
}

/// The notice of a context, where there is one.
fn notice(context: *const RawDrawContext, selector: u32) -> Option<Notice> {
    let session = session();
    let notice = session.contexts.get(&(context as usize))?.notices[selector as usize];
    (!notice.method.is_null()).then_some(notice)
}

/// Tells of a frame that is done.
///
/// # Safety
/// The context is one of ours; no lock is held.
pub unsafe fn standard(context: *const RawDrawContext, selector: u32) {
    let Some(notice) = notice(context, selector) else { return };
    // SAFETY: the program set this function under a selector of this signature.
    let method: Standard = unsafe { std::mem::transmute(notice.method) };
    // SAFETY: as above.
    unsafe { method(context, notice.ref_con) };
}

/// Tells of the frames that are done by now.
///
/// # Safety
/// No lock is held.
pub unsafe fn deliver() {
    let done = session().context.take_completed();
    for id in done {
        let address = {
            let session = session();
            let mut contexts = session.contexts.iter();
            contexts.find(|(_, known)| known.number == id.0).map(|(&address, _)| address)
        };
        let Some(address) = address else { continue };
        let context = address as *const RawDrawContext;
        // SAFETY: no lock is held.
        unsafe { show_what_is_drawn(context, false) };
        // SAFETY: a context of ours; no lock is held.
        unsafe { standard(context, constants::notice::RENDER_COMPLETION) };
    }
}

/// Lets the program write into the back buffer, and takes over what it wrote.
///
/// # Safety
/// The context is one of ours; no lock is held.
pub unsafe fn buffer(context: *const RawDrawContext, selector: u32, dirty: Option<RaveRect>) {
    let Some(notice) = notice(context, selector) else { return };
    let (number, before) = {
        let mut session = session();
        let Some(known) = session.contexts.get(&(context as usize)) else { return };
        let number = known.number;
        session.call(&Call::AccessDrawBuffer { context: number });
        let Some(shown) = session.context.draw_buffer(DrawContextId(number)) else { return };
        (number, shown)
    };
    let all = RaveRect::new(0, 0, before.width as i32, before.height as i32);
    let mut pixels = before.pixels.clone();
    let order = Order::of_buffers(before.pixel_type);
    order.turn(&mut pixels);
    let memory = RawMemory {
        row_bytes: before.pixel_type.row_bytes(before.width) as i32,
        pixel_type: before.pixel_type.number(),
        width: before.width as i32,
        height: before.height as i32,
        base: pixels.as_mut_ptr(),
    };
    let device = RawDevice { device_type: constants::device::MEMORY, memory };
    let dirty = RawRect::from(dirty.unwrap_or(all).intersect(&all));
    // SAFETY: the program set this function under a selector of this signature.
    let method: Buffer = unsafe { std::mem::transmute(notice.method) };
    // SAFETY: the buffer is as the device says.
    unsafe { method(context, &device, &dirty, notice.ref_con) };
    order.turn(&mut pixels);
    let pixels = if pixels == before.pixels { Vec::new() } else { pixels };
    let pixels = pixels.into();
    session().call(&Call::AccessDrawBufferEnd { context: number, rect: all, pixels });
}

/// Tells everybody who asked of a part of the device that is about to change.
///
/// # Safety
/// No lock is held.
pub unsafe fn about_to_draw(rect: RaveRect) {
    let notices: Vec<DrawNotice> = session().draw_notices.values().copied().collect();
    for notice in notices {
        let seen = notice.rect.intersect(&rect);
        if seen.is_empty() {
            continue;
        }
        let [left, top, right, bottom] =
            [rect.left, rect.top, rect.right, rect.bottom].map(|n| n.clamp(-32768, 32767) as i16);
        // SAFETY: the program registered this function for it.
        unsafe { (notice.proc)(left, top, right, bottom, notice.ref_con) };
    }
}

/// Asks to be told of every drawing in an area.
///
/// # Safety
/// The pointers are null or as declared.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QARegisterDrawNotificationProc(
    rect: *const RawGlobalRect,
    proc: Option<DrawProc>,
    ref_con: c_long,
    ref_num: *mut i32,
) -> i32 {
    guard(ERROR, || {
        // SAFETY: the caller's promise.
        let rect = unsafe { fillrate_guard::read(rect) };
        let (Some(rect), Some(proc)) = (rect, proc) else { return PARAM_ERR };
        if ref_num.is_null() {
            return PARAM_ERR;
        }
        let [left, top, right, bottom] =
            [rect.left, rect.top, rect.right, rect.bottom].map(i32::from);
        let rect = RaveRect::new(left, top, right, bottom);
        let mut session = session();
        session.last_draw_notice += 1;
        let number = session.last_draw_notice;
        session.draw_notices.insert(number, DrawNotice { rect, proc, ref_con });
        // SAFETY: the caller's promise.
        unsafe { write(ref_num, number) };
        0
    })
}

/// Ends it.
#[unsafe(no_mangle)]
pub extern "C" fn QAUnregisterDrawNotificationProc(ref_num: i32) -> i32 {
    guard(ERROR, || if session().draw_notices.remove(&ref_num).is_some() { 0 } else { PARAM_ERR })
}
