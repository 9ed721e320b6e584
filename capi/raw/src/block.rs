//! Blocks of words behind pointers. Null pointers and blocks that no device could hold send
//! nothing.

use fillrate_guard::{guard, write};
use fillrate_raw::call::Call;

use crate::session::call;

/// The longest block: every pixel of the largest screen, or all of the texture memory.
const MAX_WORDS: u32 = 1 << 22;

/// Copies `count` words; `None` for null or a block that is too long.
///
/// # Safety
/// `data` is null or points to `count` readable words of any alignment.
unsafe fn words<T: Copy>(data: *const T, count: u32, name: &str) -> Option<Vec<T>> {
    if data.is_null() && count > 0 || count > MAX_WORDS {
        eprintln!("fillrate: {name}: {count} words at {data:p} cannot be sent; call dropped");
        return None;
    }
    // SAFETY: the caller's promise; not null where anything is read.
    Some((0..count as usize).map(|i| unsafe { data.add(i).read_unaligned() }).collect())
}

/// Stores the words that came back.
///
/// # Safety
/// `data` is null or points to `count` writable words of any alignment.
unsafe fn store(data: *mut u32, count: u32, name: &str, request: Call) {
    if data.is_null() || count > MAX_WORDS {
        eprintln!("fillrate: {name}: {count} words cannot be stored at {data:p}; call dropped");
        return;
    }
    for (index, word) in call(request).into_iter().take(count as usize).enumerate() {
        // SAFETY: fewer than `count` words before this one, so inside the caller's block.
        unsafe { write(data.add(index), word) };
    }
}

/// Writes texels.
///
/// # Safety
/// `data` is null or points to `n` texels.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn RUploadTexture(id: i32, n: u32, data: *const u32) {
    guard((), || {
        // SAFETY: the caller's promise.
        let Some(texels) = (unsafe { words(data, n, "RUploadTexture") }) else { return };
        call(Call::UploadTexture { id: id as u32, texels });
    })
}

/// Writes a run of pixels.
///
/// # Safety
/// `data` is null or points to `n` pixels.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn RWriteFBBlock(x: u32, y: u32, page: u32, n: u32, data: *const u32) {
    guard((), || {
        // SAFETY: the caller's promise.
        let Some(pixels) = (unsafe { words(data, n, "RWriteFBBlock") }) else { return };
        call(Call::WriteFbBlock { x, y, pages: page, pixels });
    })
}

/// Writes a run of depths.
///
/// # Safety
/// `data` is null or points to `n` depths.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn RWriteZBlock(x: u32, y: u32, n: u32, data: *const i32) {
    guard((), || {
        // SAFETY: the caller's promise.
        let Some(depths) = (unsafe { words(data, n, "RWriteZBlock") }) else { return };
        call(Call::WriteZBlock { x, y, depths });
    })
}

/// Reads a run of pixels; nothing is stored in a scene.
///
/// # Safety
/// `data` is null or has room for `n` pixels.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn RReadFBBlock(x: u32, y: u32, page: u32, n: u32, data: *mut u32) {
    guard((), || {
        // SAFETY: the caller's promise.
        unsafe { store(data, n, "RReadFBBlock", Call::ReadFbBlock { x, y, page, count: n }) }
    })
}

/// Reads a run of depths; nothing is stored in a scene. The page is not used.
///
/// # Safety
/// `data` is null or has room for `n` depths.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn RReadZBlock(x: u32, y: u32, page: u32, n: u32, data: *mut i32) {
    guard((), || {
        let _ = page;
        // SAFETY: the caller's promise; a depth is a word.
        unsafe { store(data.cast(), n, "RReadZBlock", Call::ReadZBlock { x, y, count: n }) }
    })
}

/// Starts the client afresh: no scene, identity matrices.
#[unsafe(no_mangle)]
pub extern "C" fn RInit() {
    guard((), || afresh(Call::Init {}))
}

/// Puts the device back to its defaults, and the client with it; nothing happens in a scene.
#[unsafe(no_mangle)]
pub extern "C" fn RReset() {
    guard((), || {
        if crate::globals::g_RInSceneStream.get() == 0 {
            afresh(Call::Reset {});
        }
    })
}

/// Resets the device whatever it is doing, and the client with it. Beyond the thesis.
#[unsafe(no_mangle)]
pub extern "C" fn RXAsyncReset() {
    guard((), || afresh(Call::AsyncReset {}))
}

fn afresh(request: Call) {
    call(request);
    crate::globals::g_RPerspective.set(fillrate_raw::matrix::IDENTITY);
    crate::globals::g_RCamera.set(fillrate_raw::matrix::IDENTITY);
}
