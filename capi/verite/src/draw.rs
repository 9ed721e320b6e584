//! Primitives of the upper layer.

use std::ffi::c_int;

use fillrate_guard::{read, write};
use fillrate_redline::command::MAX_CMD_WORDS;
use fillrate_redline::vertex::{q_normalize, q_offset, vertex_size};
use fillrate_redline::{VlRoutine, record};

use crate::handle::Opaque;
use crate::host_memory::block;
use crate::sink::recorded;

/// `count` words; none for null and for more than any buffer holds.
///
/// # Safety
/// `pointer` is null or points to so many words.
pub(crate) unsafe fn words<'a>(pointer: *const u32, count: u64) -> &'a [u32] {
    if pointer.is_null() || count > MAX_CMD_WORDS as u64 || !pointer.addr().is_multiple_of(4) {
        return &[];
    }
    // SAFETY: the caller's promise.
    unsafe { std::slice::from_raw_parts(pointer, count as usize) }
}

/// `count` vertices of a type.
///
/// # Safety
/// `pointer` is null or points to so many vertices.
unsafe fn vertices<'a>(pointer: *const u32, vertex: u32, count: u64) -> &'a [u32] {
    // SAFETY: the caller's promise.
    unsafe { words(pointer, count * u64::from(vertex_size(vertex) / 4)) }
}

/// Declares primitives of single vertices: C name, name, routine, function,
/// numbers before the vertices, vertices.
macro_rules! primitives {
    ($($c:literal $name:ident $routine:ident $record:ident ($($n:ident)*) ($($v:ident)*);)*) => {$(
        #[doc = concat!("Records `", stringify!($name), "`.")]
        ///
        /// # Safety
        /// `cmdbuffer` is null or points to a handle; each vertex is null or can
        /// be read.
        #[unsafe(export_name = $c)]
        pub unsafe extern "C" fn $name(
            cmdbuffer: *mut Opaque,
            vertex: u32,
            $($n: u32,)*
            $($v: *const u32,)*
        ) -> c_int {
            // SAFETY: the caller's promise.
            unsafe {
                recorded(cmdbuffer, VlRoutine::$routine, |sink| {
                    record::$record(sink, vertex, $($n,)* $(vertices($v, vertex, 1)),*)
                })
            }
        }
    )*};
}

primitives! {
    "redline_Dot" VL_Dot Dot dot () (a);
    "redline_Line" VL_Line Line line () (a b);
    "redline_AALine" VL_AALine AALine aa_line () (a b);
    "redline_AAEdge" VL_AAEdge AAEdge aa_edge () (a b);
    "redline_Span" VL_Span Span span () (start delta);
    "redline_Square" VL_Square Square square (side) (center);
    "redline_Rectangle" VL_Rectangle Rectangle rectangle (width height) (center);
    "redline_Triangle" VL_Triangle Triangle triangle () (a b c);
}

/// Records `VL_TriangleNormQ`, which is also `VL_Triangle3`.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle; each vertex is null or can be
/// read.
#[unsafe(export_name = "redline_TriangleNormQ")]
pub unsafe extern "C" fn VL_TriangleNormQ(
    cmdbuffer: *mut Opaque,
    vertex: u32,
    a: *const u32,
    b: *const u32,
    c: *const u32,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, VlRoutine::TriangleNormQ, |sink| {
            let corners = [a, b, c].map(|corner| vertices(corner, vertex, 1));
            record::triangle_norm_q(sink, vertex, corners)
        })
    }
}

/// Declares chains of vertices: C name, name, routine, function, vertices more
/// than the count.
macro_rules! chains {
    ($($c:literal $name:ident $routine:ident $record:ident $more:literal;)*) => {$(
        #[doc = concat!("Records `", stringify!($name), "`.")]
        ///
        /// # Safety
        /// `cmdbuffer` is null or points to a handle; `verts` is null or points
        /// to all vertices.
        #[unsafe(export_name = $c)]
        pub unsafe extern "C" fn $name(
            cmdbuffer: *mut Opaque,
            vertex: u32,
            count: u32,
            verts: *const u32,
        ) -> c_int {
            // SAFETY: the caller's promise.
            unsafe {
                recorded(cmdbuffer, VlRoutine::$routine, |sink| {
                    let verts = vertices(verts, vertex, u64::from(count) + $more);
                    record::$record(sink, vertex, count, verts)
                })
            }
        }
    )*};
}

chains! {
    "redline_Polyline" VL_Polyline Polyline polyline 1;
    "redline_Tristrip" VL_Tristrip Tristrip tristrip 2;
    "redline_Trifan" VL_Trifan Trifan trifan 0;
}

/// Records a line between whole coordinates.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_IntLine")]
pub unsafe extern "C" fn VL_IntLine(
    cmdbuffer: *mut Opaque,
    last_pixel: u32,
    x0: u16,
    y0: u16,
    x1: u16,
    y1: u16,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, VlRoutine::IntLine, |sink| {
            record::int_line(sink, last_pixel != 0, [x0, y0], [x1, y1])
        })
    }
}

/// Records lines through packed points.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle; `points` is null or points to one
/// more than `segments`.
#[unsafe(export_name = "redline_IntPolyline")]
pub unsafe extern "C" fn VL_IntPolyline(
    cmdbuffer: *mut Opaque,
    last_pixel: u32,
    segments: u32,
    points: *const u32,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, VlRoutine::IntPolyline, |sink| {
            let points = words(points, u64::from(segments) + 1);
            record::int_polyline(sink, last_pixel != 0, segments, points)
        })
    }
}

/// Records a triangle in the default colour.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_TriangleFill")]
pub unsafe extern "C" fn VL_TriangleFill(
    cmdbuffer: *mut Opaque,
    x0: u32,
    y0: u32,
    x1: u32,
    y1: u32,
    x2: u32,
    y2: u32,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, VlRoutine::TriangleFill, |sink| {
            record::triangle_fill(sink, &[x0, y0, x1, y1, x2, y2])
        })
    }
}

/// Records an affinely textured rectangle.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_Affine")]
pub unsafe extern "C" fn VL_Affine(
    cmdbuffer: *mut Opaque,
    ulx: u32,
    uly: u32,
    ulu: u32,
    ulv: u32,
    width: u32,
    height: u32,
    dudx: u32,
    dvdx: u32,
    dudy: u32,
    dvdy: u32,
) -> c_int {
    let arguments = [ulx, uly, ulu, ulv, width, height, dudx, dvdx, dudy, dvdy];
    // SAFETY: the caller's promise.
    unsafe { recorded(cmdbuffer, VlRoutine::Affine, |sink| record::affine(sink, &arguments)) }
}

/// Records a rectangle with coordinates for each pixel.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle; `tex_coords` is null or points to
/// two words for each pixel.
#[unsafe(export_name = "redline_Warp")]
pub unsafe extern "C" fn VL_Warp(
    cmdbuffer: *mut Opaque,
    ulx: u16,
    uly: u16,
    width: u16,
    height: u16,
    ulu: u32,
    ulv: u32,
    tex_coords: *const u32,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, VlRoutine::Warp, |sink| {
            let pairs = words(tex_coords, u64::from(width) * u64::from(height) * 2);
            record::warp(sink, [ulx, uly], [width, height], [ulu, ulv], pairs)
        })
    }
}

/// Records rectangles of one colour each from host memory.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_Particles")]
pub unsafe extern "C" fn VL_Particles(cmdbuffer: *mut Opaque, count: u32, memory: Opaque) -> c_int {
    let routine = VlRoutine::Particles;
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, routine, |sink| {
            let records = block(&sink.session().memories, memory, std::ptr::null());
            record::particles_dma(sink, count, records.ok_or(crate::copy::invalid(routine))?)
        })
    }
}

/// Bytes of a vertex, 0 for unknown types.
#[unsafe(export_name = "redline_VertexSize")]
pub extern "C" fn VL_VertexSize(vertex: u32) -> u32 {
    vertex_size(vertex)
}

/// The word that holds Q, all ones where none does.
#[unsafe(export_name = "redline_QOffset")]
pub extern "C" fn VL_QOffset(vertex: u32) -> u32 {
    q_offset(vertex) as u32
}

/// Scales three Q so that the largest fills its highest bit.
///
/// # Safety
/// Each pointer is null or points to a number.
#[unsafe(export_name = "redline_QNormalize")]
pub unsafe extern "C" fn VL_QNormalize(q0: *mut u32, q1: *mut u32, q2: *mut u32) {
    let all = [q0, q1, q2];
    // SAFETY: the caller's promise.
    let mut q = all.map(|q| unsafe { read(q) }.unwrap_or(0));
    q_normalize(&mut q);
    for (to, q) in all.into_iter().zip(q) {
        // SAFETY: the caller's promise.
        unsafe { write(to, q) }
    }
}
