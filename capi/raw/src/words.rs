//! Words and records as they are.

use std::ffi::{CStr, c_char};

use fillrate_guard::{guard, read};
use fillrate_raw::call::Call;

use crate::command::calls;
use crate::session::{ask, call};

calls! {
    /// Sends one word.
    RSendUnsigned(word: u32) = Call::SendWord { word };
    /// Sends one word.
    RSendSigned(word: i32) = Call::SendWord { word: word as u32 };
    /// Sends one word.
    RSendFloat(word: f32) = Call::SendWord { word: word.to_bits() };
    /// Pauses or stops the simulation.
    RMETAHalt() = Call::Meta { text: "halt".into() };
    /// Waits for a word and drops it.
    RMETAWait() = Call::Meta { text: "wait".into() };
    /// The next text is for the log.
    RMETADebug() = Call::Meta { text: "debug".into() };
}

/// Sends the word a pointer points to; null sends nothing.
///
/// # Safety
/// `val` is null or points to a word.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn RSendPVal(val: *const u32) {
    // SAFETY: the caller's promise.
    guard((), || unsafe { read(val) }.into_iter().for_each(|word| RSendUnsigned(word)))
}

/// Asks for `count` words, to be read one by one.
#[unsafe(no_mangle)]
pub extern "C" fn RMETARead(count: u32) {
    guard((), || {
        call(Call::Meta { text: "read".into() });
        call(Call::SendWord { word: count });
    })
}

/// Sends a record by its name, cut to ten characters; null sends nothing.
///
/// # Safety
/// `val` is null or points to a text that ends with a zero byte.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn RSendMeta(val: *const c_char) {
    guard((), || {
        if val.is_null() {
            return;
        }
        // SAFETY: not null, so a text by the caller's promise.
        let text = unsafe { CStr::from_ptr(val) };
        call(Call::Meta { text: text.to_string_lossy().chars().take(10).collect() });
    })
}

/// The next word that came back; 0 at the end.
#[unsafe(no_mangle)]
pub extern "C" fn RReadUnsigned() -> u32 {
    guard(0, || ask(Call::ReadWord {}, 0))
}

/// The next word that came back; 0 at the end.
#[unsafe(no_mangle)]
pub extern "C" fn RReadSigned() -> i32 {
    RReadUnsigned() as i32
}

/// The next word that came back; 0 at the end.
#[unsafe(no_mangle)]
pub extern "C" fn RReadFloat() -> f32 {
    f32::from_bits(RReadUnsigned())
}
