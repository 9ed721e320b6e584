//! Streams of Glide calls.

use fillrate_call::{from_bytes, to_bytes};
use fillrate_engine::{Counters, DeviceConfig};
use fillrate_glide::{Call, Context, GlideConfig};

use super::Bytes;
use super::calls::any_call;

/// Calls of a stream at most.
const MAX_CALLS: usize = 64;

/// A library with two boards, started.
///
/// # Panics
/// Where no device can be made.
pub fn context(device: DeviceConfig, check: bool) -> Context {
    let config = GlideConfig { device, check, boards: 2, ..GlideConfig::default() };
    let mut context = Context::new(config).expect("the default board is valid");
    context.execute(&Call::GrGlideInit {});
    context
}

/// What a stream left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Left {
    /// Hash of the displayed buffer of the current board.
    pub hash: u64,
    /// Its counters.
    pub counters: Counters,
}

/// Opens the first board afresh, small, with a small clip window: most streams
/// then draw little. They may open, close and widen as they like.
fn open(context: &mut Context, format: i32, origin: i32) {
    for board in [1, 0] {
        context.execute(&Call::GrGlideInit {});
        context.execute(&Call::GrSstSelect { board });
        context.execute(&Call::GrSstWinClose {});
    }
    context.execute(&Call::GrSstWinOpen {
        window: 0,
        resolution: 0,
        refresh: 0,
        color_format: format,
        origin,
        colors: 2,
        aux: 1,
    });
    context.execute(&Call::GrClipWindow { x0: 0, y0: 0, x1: 64, y1: 48 });
}

/// Executes the stream that bytes describe, and whatever returns something in
/// between.
///
/// # Panics
/// Never: that is what is tested. Calls must also survive being recorded.
pub fn run_stream(context: &mut Context, bytes: &[u8]) -> Left {
    let mut from = Bytes::new(bytes);
    open(context, from.int() & 3, from.int() & 1);
    for _ in 0..MAX_CALLS {
        if from.is_empty() {
            break;
        }
        if from.byte() < 232 {
            let call = any_call(&mut from);
            let encoded = to_bytes(&call);
            let decoded: Call = from_bytes(&encoded).expect("what was encoded decodes");
            assert_eq!(to_bytes(&decoded), encoded, "{call}");
            context.execute(&call);
        } else {
            ask(context, &mut from);
        }
    }
    context.take_reports();
    // What was drawn is looked at too.
    context.execute(&Call::GrBufferSwap { interval: 0 });
    let hash = context.shown().map_or(0, |shown| {
        let mix = |h: u64, &p: &u16| (h ^ u64::from(p)).wrapping_mul(0x100_0000_01b3);
        shown.pixels.iter().fold(u64::from(shown.width), mix)
    });
    Left { hash, counters: context.counters() }
}

/// What is not a call: reads, queries, and stores through locks.
fn ask(context: &mut Context, from: &mut Bytes<'_>) {
    let corner = |from: &mut Bytes<'_>| (from.word() & 63, from.word() & 63);
    match from.byte() % 12 {
        0 => {
            let (buffer, at) = (from.int(), (from.word(), from.word()));
            let _ = context.lfb_read_region(buffer, at, corner(from));
        }
        1 => {
            let (buffer, at) = (from.int(), (from.int(), from.int()));
            let _ = context.lfb_read_old_region(buffer, at, (from.int(), from.int() & 63));
        }
        2 => store(context, from),
        3 => {
            let _ = context.state();
        }
        4 => {
            let _ = context.counters();
        }
        5 => {
            let _ = (context.video_line(), context.in_retrace(), context.status());
        }
        6 => {
            let _ = context.current_mip_map(from.unit());
            let _ = context.mip_map(from.handle());
        }
        7 => {
            let _ = (context.available_texture_memory(from.unit()), context.screen_size());
        }
        8 => {
            // A state saved is a state restored.
            if let Some(state) = context.state() {
                context.execute(&Call::GrGlideSetState { state: state[..].into() });
            }
        }
        9 => {
            let _ = context.shown();
        }
        10 => {
            let _ = context.take_reports();
        }
        _ => context.null_pointer("any"),
    }
}

/// Locks, stores here and there, and unlocks with what was written.
fn store(context: &mut Context, from: &mut Bytes<'_>) {
    let (kind, buffer) = (from.int() & 1, from.int());
    let (mode, origin, pipeline) = (from.int(), from.int(), from.int() & 1);
    context.execute(&Call::GrLfbLock { kind, buffer, mode, origin, pipeline });
    if let Some(words) = context.lfb_memory(kind) {
        for _ in 0..from.byte() & 31 {
            let at = usize::from(from.unsigned_half()) % words.len().max(1);
            if let Some(word) = words.get_mut(at) {
                *word = from.word();
            }
        }
    }
    if from.byte() & 1 == 1
        && let Some(changes) = context.lfb_stores()
    {
        context.execute(&Call::GrLfbStored { changes: changes.into() });
    }
    context.execute(&Call::GrLfbUnlock { kind, buffer, written: None });
}
