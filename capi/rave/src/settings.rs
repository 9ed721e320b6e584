//! Settings of the built-in engine, from the environment.

use fillrate_capture::{number, variable};
use fillrate_rave::RaveConfig;
use fillrate_rave::memory::EngineKind;

/// Bytes, with K or M for multiples of 1024.
fn size(text: &str) -> Result<u64, String> {
    let (digits, unit) = match text.as_bytes().last() {
        Some(b'K' | b'k') => (&text[..text.len() - 1], 1 << 10),
        Some(b'M' | b'm') => (&text[..text.len() - 1], 1 << 20),
        _ => (text, 1),
    };
    let bytes = number(digits)?.checked_mul(unit).filter(|bytes| *bytes <= 1 << 32);
    bytes.ok_or_else(|| "it is more than 4096M".into())
}

fn kind(text: &str) -> Result<EngineKind, String> {
    match text {
        "separate" => Ok(EngineKind::Separate),
        "video" => Ok(EngineKind::VideoOnly),
        "frame" => Ok(EngineKind::VideoOnlyUntilFrameEnd),
        _ => Err("kinds are 'separate', 'video' and 'frame'".into()),
    }
}

/// Changes a configuration as the environment asks.
pub fn apply(config: &mut RaveConfig) {
    if let Some(bytes) = variable("FILLRATE_RAVE_TEXTURE_MEMORY", size) {
        config.memory.video_bytes = bytes;
    }
    if let Some(kind) = variable("FILLRATE_RAVE_TEXTURES", kind) {
        config.memory.kind = kind;
    }
    if let Some(apple) = variable("FILLRATE_RAVE_APPLE", number) {
        config.as_apple_software = apple != 0;
    }
    if let Some(asynchronous) = asynchronous() {
        config.asynchronous = asynchronous != 0;
    }
}

/// 0: drawing is done in the calls. 1: behind the program's back, up to the end of
/// a frame. 2: beyond it.
fn asynchronous() -> Option<u64> {
    variable("FILLRATE_RAVE_ASYNCHRONOUS", |text| match number(text)? {
        known @ 0..=2 => Ok(known),
        _ => Err("it may be 0, 1 or 2".into()),
    })
}

/// Whether a frame's end does not wait for the frame.
pub fn late_frames() -> bool {
    asynchronous() == Some(2)
}

/// Vendor and number of the engine that the user wants before all others.
pub fn preferred_engine() -> Option<(u32, u32)> {
    variable("FILLRATE_RAVE_ENGINE", |text| {
        let numbers = text.split_once(':').map(|(a, b)| (a.trim().parse(), b.trim().parse()));
        match numbers {
            Some((Ok::<i32, _>(vendor), Ok::<i32, _>(engine))) => {
                Ok((vendor as u32, engine as u32))
            }
            _ => Err("it is not VENDOR:ENGINE".into()),
        }
    })
}
