//! Library, boards and queries.

use std::ffi::{c_char, c_void};

use fillrate_glide::{Call, STATE_BYTES};
use fillrate_guard::{bytes, guard, read, write};

use crate::session::{ErrorCallback, ask, call, null, session};

/// Texture unit of a configuration.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct TmuConfig {
    revision: i32,
    megabytes: i32,
}

/// A board of a configuration: its type and the Voodoo member of the union.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct BoardConfig {
    kind: i32,
    frame_buffer: i32,
    revision: i32,
    units: i32,
    interleaved: i32,
    tmus: [TmuConfig; 2],
}

/// `GrHwConfiguration`, 148 bytes.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct HwConfiguration {
    count: i32,
    boards: [BoardConfig; 4],
}

/// `GrSstPerfStats_t`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct PerfStats {
    pixels_in: u32,
    chroma_fail: u32,
    depth_fail: u32,
    alpha_fail: u32,
    pixels_out: u32,
}

const _: () = assert!(size_of::<HwConfiguration>() == 4 + 4 * 36);

/// Exports whose arguments are numbers: each makes a call's value.
macro_rules! calls {
    ($($(#[$doc:meta])* $name:ident($($arg:ident: $type:ty),*) = $call:expr;)*) => {$(
        $(#[$doc])*
        #[unsafe(no_mangle)]
        pub extern "C" fn $name($($arg: $type),*) {
            guard((), || { call($call); })
        }
    )*};
}
pub(crate) use calls;

calls! {
    /// Starts the library.
    grGlideInit() = Call::GrGlideInit {};
    /// Closes all boards and stops the library.
    grGlideShutdown() = Call::GrGlideShutdown {};
    /// Sets a hint.
    grHints(hint: i32, mask: u32) = Call::GrHints { hint, mask };
    /// Chooses the current board.
    grSstSelect(board: i32) = Call::GrSstSelect { board };
    /// Closes the current board.
    grSstWinClose() = Call::GrSstWinClose {};
    /// Chooses the row order.
    grSstOrigin(origin: i32) = Call::GrSstOrigin { origin };
    /// Waits for the board.
    grSstIdle() = Call::GrSstIdle {};
    /// Resets the pixel counters.
    grSstResetPerfStats() = Call::GrSstResetPerfStats {};
    /// Resets the triangle counters.
    grResetTriStats() = Call::GrResetTriStats {};
    /// Draws the start-up picture.
    grSplash(x: f32, y: f32, width: f32, height: f32, frame: u32) =
        Call::GrSplash { x, y, width, height, frame };
    /// Switches the mark in the corner of every frame.
    grGlideShamelessPlug(on: i32) = Call::GrGlideShamelessPlug { on };
    /// Writes a raw register.
    grSstConfigPipeline(chip: i32, register: u32, value: u32) =
        Call::GrSstConfigPipeline { chip, register, value };
}

/// The version, "2.46".
///
/// # Safety
/// `version` is null or has room for 80 bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grGlideGetVersion(version: *mut c_char) {
    guard((), || {
        if version.is_null() {
            null("grGlideGetVersion");
        }
        // SAFETY: five bytes fit in the caller's 80.
        unsafe { write(version.cast(), *b"2.46\0") }
    })
}

/// Saves the state.
///
/// # Safety
/// `state` is null or has room for 312 bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grGlideGetState(state: *mut [u8; STATE_BYTES]) {
    guard((), || {
        if state.is_null() {
            return null("grGlideGetState");
        }
        if let Some(saved) = ask(|context| context.state()) {
            // SAFETY: the caller gives room for a state.
            unsafe { write(state, saved) }
        }
    })
}

/// Restores a saved state.
///
/// # Safety
/// `state` is null or points to 312 bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grGlideSetState(state: *const u8) {
    guard((), || {
        if state.is_null() {
            return null("grGlideSetState");
        }
        // SAFETY: the caller gives a whole state.
        let state = unsafe { bytes(state, STATE_BYTES) }.into();
        call(Call::GrGlideSetState { state });
    })
}

/// Sets the function that hears of misuse; null prints.
#[unsafe(no_mangle)]
pub extern "C" fn grErrorSetCallback(callback: ErrorCallback) {
    guard((), || session().callback = callback)
}

/// How many boards there are.
///
/// # Safety
/// `configuration` is null or points to a configuration.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grSstQueryBoards(configuration: *mut i32) -> i32 {
    guard(0, || {
        if configuration.is_null() {
            null("grSstQueryBoards");
            return 0;
        }
        let count = session().context.board_count() as i32;
        // SAFETY: the count is the configuration's first field.
        unsafe { write(configuration, count) };
        1
    })
}

/// The boards there are.
///
/// # Safety
/// `configuration` is null or points to a configuration.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grSstQueryHardware(configuration: *mut HwConfiguration) -> i32 {
    guard(0, || {
        if configuration.is_null() {
            null("grSstQueryHardware");
            return 0;
        }
        let session = session();
        let card = &session.context.config().card;
        let tmu = TmuConfig { revision: 1, megabytes: card.texture as i32 };
        let board = BoardConfig {
            kind: 0,
            frame_buffer: card.frame_buffer as i32,
            revision: 2,
            units: card.units as i32,
            interleaved: i32::from(card.interleaved),
            tmus: [tmu, if card.units > 1 { tmu } else { TmuConfig::default() }],
        };
        let count = session.context.board_count();
        let mut all = HwConfiguration { count: count as i32, ..HwConfiguration::default() };
        all.boards[..count].fill(board);
        // SAFETY: the caller gives room for a configuration.
        unsafe { write(configuration, all) };
        1
    })
}

/// Opens the current board.
#[unsafe(no_mangle)]
pub extern "C" fn grSstWinOpen(
    window: u32,
    resolution: i32,
    refresh: i32,
    color_format: i32,
    origin: i32,
    colors: i32,
    aux: i32,
) -> i32 {
    guard(0, || {
        let open =
            Call::GrSstWinOpen { window, resolution, refresh, color_format, origin, colors, aux };
        call(open) as i32
    })
}

/// Opens the current board without a window: two buffers come with an aux
/// buffer where memory has room for it, three without. Without smoothing the
/// screen filter leaves the picture as it is.
#[unsafe(no_mangle)]
pub extern "C" fn grSstOpen(
    resolution: i32,
    refresh: i32,
    color_format: i32,
    origin: i32,
    smoothing: i32,
    buffers: i32,
) -> i32 {
    guard(0, || {
        let open =
            Call::GrSstOpen { resolution, refresh, color_format, origin, smoothing, buffers };
        call(open) as i32
    })
}

/// Shows or hides the board's picture; there is no other to show.
#[unsafe(no_mangle)]
pub extern "C" fn grSstControl(_code: u32) -> i32 {
    1
}

/// As `grSstControl`, before 2.4.
#[unsafe(no_mangle)]
pub extern "C" fn grSstControlMode(_code: u32) {}

/// Chooses between two pictures on one monitor; there is one.
#[unsafe(no_mangle)]
pub extern "C" fn grSstPassthruMode(_mode: i32) {}

/// Whether there is a board.
#[unsafe(no_mangle)]
pub extern "C" fn grSstDetectResources() -> i32 {
    1
}

/// Custom video timings, which nothing here needs.
#[unsafe(no_mangle)]
pub extern "C" fn grSstVidMode(_board: u32, _timings: *mut c_void) {}

/// Room in the command queue; there always is.
#[unsafe(no_mangle)]
pub extern "C" fn grCheckForRoom(_count: i32) {}

/// Columns of the screen.
#[unsafe(no_mangle)]
pub extern "C" fn grSstScreenWidth() -> u32 {
    guard(0, || ask(|context| context.screen_size().0))
}

/// Rows of the screen.
#[unsafe(no_mangle)]
pub extern "C" fn grSstScreenHeight() -> u32 {
    guard(0, || ask(|context| context.screen_size().1))
}

/// Whether the board is busy: while a swap waits for its retrace.
#[unsafe(no_mangle)]
pub extern "C" fn grSstIsBusy() -> i32 {
    guard(0, || i32::from(ask(|context| context.is_busy())))
}

/// The status register.
#[unsafe(no_mangle)]
pub extern "C" fn grSstStatus() -> u32 {
    guard(0, || ask(|context| context.status()))
}

/// The line being shown.
#[unsafe(no_mangle)]
pub extern "C" fn grSstVideoLine() -> u32 {
    guard(0, || ask(|context| context.video_line()))
}

/// Retraces since the board was opened.
#[unsafe(no_mangle)]
pub extern "C" fn grSstVRetraceTicks() -> u32 {
    guard(0, || ask(|context| context.retraces()))
}

/// Whether the beam is in vertical retrace.
#[unsafe(no_mangle)]
pub extern "C" fn grSstVRetraceOn() -> i32 {
    guard(0, || i32::from(ask(|context| context.in_retrace())))
}

/// The pixel counters, 24 bits each.
///
/// # Safety
/// `stats` is null or points to a `GrSstPerfStats_t`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grSstPerfStats(stats: *mut PerfStats) {
    guard((), || {
        if stats.is_null() {
            return null("grSstPerfStats");
        }
        let c = ask(|context| context.counters());
        let low = |count: u64| (count & 0x00ff_ffff) as u32;
        let counted = PerfStats {
            pixels_in: low(c.pixels_in),
            chroma_fail: low(c.chroma_fail),
            depth_fail: low(c.depth_fail),
            alpha_fail: low(c.alpha_fail),
            pixels_out: low(c.pixels_out),
        };
        // SAFETY: the caller gives room for the counters.
        unsafe { write(stats, counted) }
    })
}

/// The triangle counters.
///
/// # Safety
/// Both pointers are null or point to a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grTriStats(processed: *mut u32, drawn: *mut u32) {
    guard((), || {
        let c = ask(|context| context.counters());
        // SAFETY: the caller gives room for both.
        unsafe {
            write(processed, c.triangles_in as u32);
            write(drawn, c.triangles_drawn as u32);
        }
    })
}

/// Copies of the vertices at `list`, or those at the indices in front of it.
///
/// # Safety
/// `list` is null or points to as many `T` as `count`, or the largest index
/// plus one, says; `indices` is null or points to `count` numbers.
pub(crate) unsafe fn gather<T: Copy>(
    count: i32,
    indices: Option<*const i32>,
    list: *const T,
) -> Vec<T> {
    let count = usize::try_from(count).unwrap_or(0);
    if list.is_null() || indices.is_some_and(|indices| indices.is_null()) {
        return Vec::new();
    }
    let at = |i: usize| match indices {
        // SAFETY: below `count`.
        Some(indices) => usize::try_from(unsafe { indices.add(i).read_unaligned() }).ok(),
        None => Some(i),
    };
    // SAFETY: the caller's list reaches as far as the indices it gives.
    (0..count).filter_map(|i| at(i).and_then(|i| unsafe { read(list.wrapping_add(i)) })).collect()
}
