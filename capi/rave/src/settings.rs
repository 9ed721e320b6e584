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
    if let Some(asynchronous) = variable("FILLRATE_RAVE_ASYNCHRONOUS", number) {
        config.asynchronous = asynchronous != 0;
    }
}
