//! The client's state as C programs see it: three global variables.

use std::cell::UnsafeCell;

/// A variable that C programs read and write as they like.
#[repr(transparent)]
pub struct Global<T>(UnsafeCell<T>);

// SAFETY: the client interface belongs to one thread, as its original did; Rust code copies the
// contents in and out and keeps no reference.
unsafe impl<T> Sync for Global<T> {}

impl<T: Copy> Global<T> {
    /// The present value.
    pub fn get(&self) -> T {
        // SAFETY: the cell is valid for the life of the process, and nothing holds a reference.
        unsafe { self.0.get().read() }
    }

    /// Sets the value.
    pub fn set(&self, value: T) {
        // SAFETY: as for `get`.
        unsafe { self.0.get().write(value) }
    }
}

const IDENTITY: [[f32; 4]; 4] = fillrate_raw::matrix::IDENTITY;

/// 1 while a scene is open.
#[unsafe(no_mangle)]
pub static g_RInSceneStream: Global<u32> = Global(UnsafeCell::new(0));
/// The projection.
#[unsafe(no_mangle)]
pub static g_RPerspective: Global<[[f32; 4]; 4]> = Global(UnsafeCell::new(IDENTITY));
/// The camera.
#[unsafe(no_mangle)]
pub static g_RCamera: Global<[[f32; 4]; 4]> = Global(UnsafeCell::new(IDENTITY));
