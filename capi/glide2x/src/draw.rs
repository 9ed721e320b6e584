//! Primitives. Null vertices are ignored.

use fillrate_glide::{Call, GrVertex};
use fillrate_guard::{guard, read};

use crate::library::gather;
use crate::session::{call, call_as, draw_triangle, null};

/// Exports that take vertices by pointer.
macro_rules! primitives {
    ($($(#[$doc:meta])* $name:ident([$($v:ident),*] $(, $arg:ident: $type:ty)*) = $call:expr;)*) => {$(
        $(#[$doc])*
        ///
        /// # Safety
        /// Each vertex pointer is null or points to a vertex.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name($($v: *const GrVertex,)* $($arg: $type),*) {
            guard((), || {
                // SAFETY: null, or a vertex by the caller's promise.
                $(let Some($v) = (unsafe { read($v) }) else {
                    return null(stringify!($name));
                };)*
                call($call);
            })
        }
    )*};
}

primitives! {
    /// Draws a point.
    grDrawPoint([point]) = Call::GrDrawPoint { point };
    /// Draws a line.
    grDrawLine([a, b]) = Call::GrDrawLine { a, b };
    /// Draws a smooth point.
    grAADrawPoint([point]) = Call::GrAaDrawPoint { point };
    /// Draws a smooth line.
    grAADrawLine([a, b]) = Call::GrAaDrawLine { a, b };
    /// Draws a triangle with smooth edges.
    grAADrawTriangle([a, b, c], ab: i32, bc: i32, ca: i32) =
        Call::GrAaDrawTriangle { a, b, c, ab, bc, ca };
    /// Draws a triangle clipped to the clip window.
    guDrawTriangleWithClip([a, b, c]) = Call::GuDrawTriangleWithClip { a, b, c };
    /// Draws a smooth triangle clipped to the clip window.
    guAADrawTriangleWithClip([a, b, c]) = Call::GuAaDrawTriangleWithClip { a, b, c };
}

/// Draws a triangle.
///
/// # Safety
/// Each pointer is null or points to a vertex.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grDrawTriangle(
    a: *const GrVertex,
    b: *const GrVertex,
    c: *const GrVertex,
) {
    guard((), || {
        // SAFETY: null, or a vertex by the caller's promise.
        let (Some(a), Some(b), Some(c)) = (unsafe { (read(a), read(b), read(c)) }) else {
            return null("grDrawTriangle");
        };
        draw_triangle(&a, &b, &c);
    })
}

/// Exports that take a list of vertices, by index or in order.
macro_rules! polygons {
    ($($(#[$doc:meta])* $indexed:ident $listed:ident = $call:ident;)*) => {$(
        $(#[$doc])*
        ///
        /// # Safety
        /// `indices` is null or points to `count` numbers, `vertices` to as
        /// many vertices as they reach.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $indexed(
            count: i32,
            indices: *const i32,
            vertices: *const GrVertex,
        ) {
            guard((), || {
                if indices.is_null() || vertices.is_null() {
                    return null(stringify!($indexed));
                }
                // SAFETY: the caller's promise.
                let vertices = unsafe { gather(count, Some(indices), vertices) };
                call_as(stringify!($indexed), Call::$call { vertices });
            })
        }
        $(#[$doc])*
        ///
        /// # Safety
        /// `vertices` is null or points to `count` vertices.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $listed(count: i32, vertices: *const GrVertex) {
            guard((), || {
                if vertices.is_null() {
                    return null(stringify!($listed));
                }
                // SAFETY: the caller's promise.
                let vertices = unsafe { gather(count, None, vertices) };
                call_as(stringify!($listed), Call::$call { vertices });
            })
        }
    )*};
}

polygons! {
    /// Draws a convex polygon.
    grDrawPolygon grDrawPolygonVertexList = GrDrawPolygon;
    /// Draws a convex polygon of one plane.
    grDrawPlanarPolygon grDrawPlanarPolygonVertexList = GrDrawPlanarPolygon;
    /// Draws a convex polygon with smooth edges.
    grAADrawPolygon grAADrawPolygonVertexList = GrAaDrawPolygon;
}

/// Draws a convex polygon clipped to the clip window.
///
/// # Safety
/// `vertices` is null or points to `count` vertices.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn guDrawPolygonVertexListWithClip(count: i32, vertices: *const GrVertex) {
    guard((), || {
        if vertices.is_null() {
            return null("guDrawPolygonVertexListWithClip");
        }
        // SAFETY: the caller's promise.
        let vertices = unsafe { gather(count, None, vertices) };
        call(Call::GuDrawPolygonVertexListWithClip { vertices });
    })
}
