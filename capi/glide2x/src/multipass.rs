//! Multi-pass texturing.

use fillrate_glide::{Call, GrVertex};
use fillrate_guard::{guard, read};

use crate::library::calls;
use crate::session::{call, null};

calls! {
    /// Forgets the virtual texture units.
    guMPInit() = Call::GuMpInit {};
    /// Sets how the virtual texture units are put together.
    guMPTexCombineFunction(function: i32) = Call::GuMpTexCombineFunction { function };
    /// Chooses the mip map of a virtual texture unit.
    guMPTexSource(tmu: i32, id: u32) = Call::GuMpTexSource { tmu, id };
}

/// Draws a triangle with both virtual texture units.
///
/// # Safety
/// Each pointer is null or points to a vertex.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn guMPDrawTriangle(
    a: *const GrVertex,
    b: *const GrVertex,
    c: *const GrVertex,
) {
    guard((), || {
        // SAFETY: null, or a vertex by the caller's promise.
        let (Some(a), Some(b), Some(c)) = (unsafe { (read(a), read(b), read(c)) }) else {
            return null("guMPDrawTriangle");
        };
        call(Call::GuMpDrawTriangle { a, b, c });
    })
}
