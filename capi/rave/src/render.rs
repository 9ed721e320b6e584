//! Frames: beginning, ending, waiting, and showing them in the program's memory.

use fillrate_guard::guard;
use fillrate_rave::{Call, DrawContextId, PixelType, RaveRect, constants, tags};

use crate::draw::{context_number, on};
use crate::layout::{PARAM_ERR, RawDrawContext, RawMemory, RawRect, value};
use crate::notice;
use crate::order::Order;
use crate::session::{Session, session};

/// `kQAError`.
const ERROR: i32 = 1;

/// `QARenderStart`.
///
/// # Safety
/// `dirty` is null or can be read.
pub unsafe extern "C" fn render_start(
    context: *const RawDrawContext,
    dirty: *const RawRect,
    initial: *const RawDrawContext,
) {
    // SAFETY: the caller's promise.
    let dirty = unsafe { value::<RaveRect>(dirty) };
    // SAFETY: no lock is held.
    guard((), || unsafe { notice::deliver() });
    let is_ours = on(context, false, |session, number| {
        // SAFETY: what the program lends can be read.
        unsafe { session.send_lent_pictures() };
        let initial = context_number(session, initial);
        session.call(&Call::RenderStart { context: number, dirty, initial });
        true
    });
    if is_ours && initial.is_null() {
        let selector = constants::notice::IMAGE_BUFFER_INITIALIZE;
        // SAFETY: no lock is held.
        guard((), || unsafe { notice::buffer(context, selector, dirty) });
    }
}

/// `QARenderEnd`: composite notice, the frame, completion notice.
///
/// # Safety
/// `modified` is null or can be read.
pub unsafe extern "C" fn render_end(
    context: *const RawDrawContext,
    modified: *const RawRect,
) -> i32 {
    guard(ERROR, || {
        // SAFETY: the caller's promise.
        let modified = unsafe { value::<RaveRect>(modified) };
        let Some(number) = on(context, None, |_, number| Some(number)) else { return PARAM_ERR };
        // SAFETY: no lock is held.
        unsafe { show_late(context) };
        let selector = constants::notice::IMAGE_BUFFER_2D_COMPOSITE;
        // SAFETY: the context is ours, and no lock is held.
        unsafe { notice::buffer(context, selector, modified) };
        session().send_window(context);
        let status = session().call(&Call::RenderEnd { context: number, modified }).number();
        let is_late = session().is_shown_late(context);
        if !is_late {
            // SAFETY: as above.
            unsafe { show(context, true) };
        }
        // SAFETY: as above.
        unsafe { notice::deliver() };
        status
    })
}

/// `QARenderAbort`.
pub extern "C" fn render_abort(context: *const RawDrawContext) -> i32 {
    // SAFETY: no lock is held.
    guard((), || unsafe { show_late(context) });
    on(context, PARAM_ERR, |session, context| session.call(&Call::RenderAbort { context }).number())
}

/// Makes a call, and shows what it made visible.
fn call_and_show(
    context: *const RawDrawContext,
    is_frame: bool,
    call: impl FnOnce(u32) -> Call,
) -> i32 {
    guard(ERROR, || {
        let status = on(context, PARAM_ERR, |session, number| session.call(&call(number)).number());
        // SAFETY: no lock is held.
        unsafe { show(context, is_frame) };
        // SAFETY: as above.
        unsafe { notice::deliver() };
        status
    })
}

/// `QAFlush`.
pub extern "C" fn flush(context: *const RawDrawContext) -> i32 {
    call_and_show(context, false, |context| Call::Flush { context })
}

/// `QASync`.
pub extern "C" fn sync(context: *const RawDrawContext) -> i32 {
    call_and_show(context, false, |context| Call::Sync { context })
}

/// `QASwapBuffers`.
///
/// # Safety
/// `dirty` is null or can be read.
pub unsafe extern "C" fn swap_buffers(
    context: *const RawDrawContext,
    dirty: *const RawRect,
) -> i32 {
    // SAFETY: the caller's promise.
    let dirty = unsafe { value::<RaveRect>(dirty) };
    // SAFETY: no lock is held.
    guard((), || unsafe { show_late(context) });
    on(context, (), |session, _| session.send_window(context));
    call_and_show(context, true, |context| Call::SwapBuffers { context, dirty })
}

/// `QABusy`.
pub extern "C" fn busy(context: *const RawDrawContext) -> u8 {
    // SAFETY: no lock is held.
    guard((), || unsafe { notice::deliver() });
    on(context, 0, |session, context| session.call(&Call::Busy { context }).number() as u8)
}

impl Session {
    /// Tells the library what a frame is composed with, where it is.
    fn send_window(&mut self, context: *const RawDrawContext) {
        let Some(known) = self.contexts.get(&(context as usize)) else { return };
        let (number, rect) = (known.number, known.rect);
        let Some(device) = known.device else { return };
        if self.context.get_int(DrawContextId(number), tags::int::BUFFER_COMPOSITE) == 0 {
            return;
        }
        let Some(kind) = PixelType::from_number(device.pixel_type) else { return };
        let row = kind.row_bytes(rect.width());
        let mut pixels = Vec::with_capacity(row * rect.height() as usize);
        for y in rect.top..rect.bottom {
            let Some(at) = place(&device, rect.left, y) else { return };
            // SAFETY: the device's memory is as the program described it, and
            // the library refused rectangles beyond it.
            pixels.extend_from_slice(unsafe { std::slice::from_raw_parts(at, row) });
        }
        Order::of_buffers(kind).turn(&mut pixels);
        self.call(&Call::WindowContents { context: number, pixels: pixels.into() });
    }
}

/// Shows a context's frame that is drawn behind the program's back, if there is
/// one, and tells of it. Waits for it.
///
/// # Safety
/// As [`show`].
pub unsafe fn show_late(context: *const RawDrawContext) {
    if on(context, false, |session, _| session.has_late_frame(context)) {
        // SAFETY: the caller's promise.
        unsafe { show(context, false) };
        // SAFETY: as above.
        unsafe { notice::deliver() };
    }
}

/// Waits for what was drawn and copies what became visible into the program's
/// memory. Nothing waits for contexts that show nothing to the program.
///
/// # Safety
/// No lock is held, and the device's memory is as the program described it.
unsafe fn show(context: *const RawDrawContext, is_frame: bool) {
    let is_seen = on(context, false, |session, _| {
        let is_seen = session.is_seen(context);
        if is_seen {
            session.context.finish();
        }
        is_seen
    });
    if is_seen {
        // SAFETY: the caller's promise.
        unsafe { show_what_is_drawn(context, is_frame) };
    }
}

/// Copies what became visible so far into the program's memory, within the clip;
/// a frame is noted.
///
/// # Safety
/// As [`show`].
pub unsafe fn show_what_is_drawn(context: *const RawDrawContext, is_frame: bool) {
    let shown = on(context, None, |session, number| {
        let area = session.context.take_changed(DrawContextId(number))?;
        let known = session.contexts.get_mut(&(context as usize))?;
        let is_frame = is_frame || std::mem::take(&mut known.has_late_frame);
        let area = on_device(&known.rect, &area);
        (!known.is_cache).then_some((area, is_frame, known.device.is_some()))
    });
    let Some((area, is_frame, has_memory)) = shown else { return };
    if has_memory {
        // SAFETY: no lock is held.
        unsafe { notice::about_to_draw(area) };
    }
    on(context, (), |session, number| {
        // SAFETY: the caller's promise.
        let screen = unsafe { session.copy_out(context, &area) };
        if is_frame && let Some(screen) = screen {
            session.frame_shown(number, screen);
        }
    });
}

/// An area of a context, on its device.
fn on_device(rect: &RaveRect, area: &RaveRect) -> RaveRect {
    let moved = RaveRect::new(
        rect.left + area.left,
        rect.top + area.top,
        rect.left + area.right,
        rect.top + area.bottom,
    );
    moved.intersect(rect)
}

impl Session {
    /// Whether the program, or whoever watches it, sees what a context shows.
    fn is_seen(&self, context: *const RawDrawContext) -> bool {
        let known = self.contexts.get(&(context as usize));
        known.is_some_and(|known| known.device.is_some() || self.is_watched())
    }

    /// Whether the frame that just ended is shown once it is drawn, and not now.
    fn is_shown_late(&mut self, context: *const RawDrawContext) -> bool {
        let is_late = self.late_frames;
        if is_late && let Some(known) = self.contexts.get_mut(&(context as usize)) {
            known.has_late_frame = true;
        }
        is_late
    }

    /// Whether a frame of a context is still to be shown.
    fn has_late_frame(&self, context: *const RawDrawContext) -> bool {
        self.contexts.get(&(context as usize)).is_some_and(|known| known.has_late_frame)
    }

    /// Copies an area of the device into the program's memory. Returns the
    /// context's screen.
    ///
    /// # Safety
    /// The device's memory is as the program described it; the library refused
    /// rectangles beyond it.
    unsafe fn copy_out(
        &mut self,
        context: *const RawDrawContext,
        area: &RaveRect,
    ) -> Option<usize> {
        let known = self.contexts.get(&(context as usize))?;
        let Some(device) = known.device else { return Some(known.screen) };
        let mut shown = self.context.shown_so_far(DrawContextId(known.number))?;
        Order::of_buffers(shown.pixel_type).turn(&mut shown.pixels);
        let bytes = shown.pixel_type.bits() as usize / 8;
        let row = shown.pixel_type.row_bytes(shown.width);
        let whole = [*area];
        for part in known.clip.as_deref().unwrap_or(&whole) {
            let part = part.intersect(area);
            if part.is_empty() {
                continue;
            }
            let count = part.width() as usize * bytes;
            let left = (part.left - known.rect.left) as usize * bytes;
            for y in part.top..part.bottom {
                let at = (y - known.rect.top) as usize * row + left;
                let from = shown.pixels.get(at..at + count)?;
                let to = place(&device, part.left, y)?;
                // SAFETY: the caller's promise.
                unsafe { to.copy_from_nonoverlapping(from.as_ptr(), count) };
            }
        }
        Some(known.screen)
    }
}

/// A pixel of the device in the program's memory.
fn place(device: &RawMemory, x: i32, y: i32) -> Option<*mut u8> {
    let kind = PixelType::from_number(device.pixel_type)?;
    let bytes = kind.bits() as isize / 8;
    Some(device.base.wrapping_offset(y as isize * device.row_bytes as isize + x as isize * bytes))
}
