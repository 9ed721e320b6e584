//! Matrices: built here, sent as one view or model matrix. Null pointers send nothing.

use fillrate_guard::{guard, read, write};
use fillrate_raw::call::Call;
use fillrate_raw::client::flat;
use fillrate_raw::matrix::{self, Matrix};

use crate::globals::{g_RCamera, g_RPerspective};
use crate::session::{call, client};

/// Sends the model matrix.
///
/// # Safety
/// `m` is null or points to four rows of four.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn RModelMatrix(m: *const Matrix) {
    guard((), || {
        // SAFETY: the caller's promise.
        if let Some(m) = unsafe { read(m) } {
            call(Call::ModelMatrix { m: flat(&m) });
        }
    })
}

/// Sends the view matrix.
///
/// # Safety
/// `m` is null or points to four rows of four.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn RViewMatrix(m: *const Matrix) {
    guard((), || {
        // SAFETY: the caller's promise.
        if let Some(m) = unsafe { read(m) } {
            call(Call::ViewMatrix { m: flat(&m) });
        }
    })
}

/// Stores the product `m * y` in `x`, which may be one of them.
///
/// # Safety
/// Each pointer is null or points to four rows of four.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn MatrixMult(x: *mut Matrix, m: *const Matrix, y: *const Matrix) {
    guard((), || {
        // SAFETY: the caller's promise.
        if let (Some(m), Some(y)) = unsafe { (read(m), read(y)) } {
            // SAFETY: the caller's promise.
            unsafe { write(x, matrix::multiply(&m, &y)) };
        }
    })
}

/// Sends projection times camera as the view matrix.
#[unsafe(no_mangle)]
pub extern "C" fn RUpdateMatrices() {
    guard((), || {
        let view = matrix::multiply(&g_RPerspective.get(), &g_RCamera.get());
        call(Call::ViewMatrix { m: flat(&view) });
    })
}

fn project(m: Matrix) {
    g_RPerspective.set(m);
    RUpdateMatrices();
}

/// Sets the projection.
///
/// # Safety
/// `m` is null or points to four rows of four.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn RSetProjMatrix(m: *const Matrix) {
    // SAFETY: the caller's promise.
    guard((), || unsafe { read(m) }.into_iter().for_each(project))
}

/// Sets a perspective projection from the edges of the near rectangle.
#[unsafe(no_mangle)]
pub extern "C" fn RProjMatrix(l: f32, r: f32, t: f32, b: f32, n: f32, f: f32) {
    guard((), || project(matrix::perspective(l, r, t, b, n, f)))
}

/// Sets a perspective projection from two angles in radians.
#[unsafe(no_mangle)]
pub extern "C" fn RProjMatrixUV(u: f32, v: f32, n: f32, f: f32) {
    guard((), || project(matrix::perspective_angles(u, v, n, f)))
}

/// Sets the projection of a box.
#[unsafe(no_mangle)]
pub extern "C" fn ROrthMatrix(l: f32, r: f32, t: f32, b: f32, n: f32, f: f32) {
    guard((), || project(matrix::orthographic(l, r, t, b, n, f)))
}

/// Sets the camera: where it is, what it looks at, a point upwards.
///
/// # Safety
/// Each pointer is null or points to three numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn RCameraMatrix(
    vrp: *const [f32; 3],
    fp: *const [f32; 3],
    up: *const [f32; 3],
) {
    guard((), || {
        // SAFETY: the caller's promise.
        let (Some(eye), Some(focus), Some(up)) = (unsafe { (read(vrp), read(fp), read(up)) })
        else {
            return;
        };
        let camera = client(|client| client.camera_matrix(eye, focus, up));
        g_RCamera.set(camera);
        RUpdateMatrices();
    })
}
