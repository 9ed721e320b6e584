//! Primitives.

use super::{invalid, pair, put, unadded};
use crate::command::{CommandSink, DmaBlock};
use crate::error::{Result, VlRoutine};
use crate::opcode::Opcode;
use crate::vertex::{Attribute, VertexType, q_normalize};

/// The vertex type with this code, for `routine`, if the sink's board knows it.
#[inline]
fn vertex_type<S: CommandSink + ?Sized>(
    sink: &S,
    routine: VlRoutine,
    code: u32,
) -> Result<VertexType> {
    let vertex = VertexType::from_code(code);
    let known = |v: &VertexType| !v.is_specular() || sink.has_specular();
    vertex.filter(known).ok_or(invalid(routine))
}

/// A first word, `head` words and vertices.
#[inline]
fn primitive<S: CommandSink + ?Sized, const N: usize>(
    sink: &mut S,
    routine: VlRoutine,
    opcode: Opcode,
    vertex: VertexType,
    head: [u32; N],
    vertices: &[&[u32]],
) -> Result<()> {
    let size = vertex.words();
    if vertices.iter().any(|vertex| vertex.len() < size) {
        return Err(invalid(routine));
    }
    let words = 1 + N + vertices.len() * size;
    let out = sink.reserve(words, 0).map_err(|error| unadded(routine, error))?;
    let (first, out) = out.split_at_mut(1 + N);
    first[0] = vertex.code() << 16 | opcode as u32;
    first[1..].copy_from_slice(&head);
    for (out, vertex) in out.chunks_exact_mut(size).zip(vertices) {
        put_vertex(out, &vertex[..size]);
    }
    Ok(())
}

/// Copies a vertex: four words first, which is all that many have, so that no
/// function has to be called for a copy of unknown length.
#[inline]
fn put_vertex(out: &mut [u32], vertex: &[u32]) {
    match (out.split_first_chunk_mut::<4>(), vertex.split_first_chunk::<4>()) {
        (Some((four, out)), Some((words, rest))) => {
            *four = *words;
            if !rest.is_empty() {
                out.copy_from_slice(rest);
            }
        }
        _ => out.copy_from_slice(vertex),
    }
}

/// A first word, a count and `count` vertices that lie together.
fn chain<S: CommandSink + ?Sized>(
    sink: &mut S,
    routine: VlRoutine,
    opcode: Opcode,
    code: u32,
    [number, count]: [u32; 2],
    vertices: &[u32],
) -> Result<()> {
    let vertex = vertex_type(sink, routine, code)?;
    let words = count as usize * vertex.words();
    let vertices = vertices.get(..words).ok_or(invalid(routine))?;
    let out = sink.reserve(2 + words, 0).map_err(|error| unadded(routine, error))?;
    out[0] = vertex.code() << 16 | opcode as u32;
    out[1] = number;
    out[2..].copy_from_slice(vertices);
    Ok(())
}

/// Declares primitives of some vertices.
macro_rules! primitives {
    ($($(#[$meta:meta])* $name:ident($opcode:ident, $($head:ident,)*; $($v:ident),*);)*) => {$(
        $(#[$meta])*
        ///
        /// # Errors
        /// [`crate::VlError::ParamError`] for an unknown type or too short a vertex; those of the sink.
        #[inline]
        pub fn $name<S: CommandSink + ?Sized>(
            sink: &mut S,
            vertex: u32,
            $($head: u32,)*
            $($v: &[u32],)*
        ) -> Result<()> {
            let routine = VlRoutine::$opcode;
            let vertex = vertex_type(sink, routine, vertex)?;
            primitive(sink, routine, Opcode::$opcode, vertex, [$($head),*], &[$($v),*])
        }
    )*};
}

primitives! {
    /// `VL_Triangle`: one triangle.
    triangle(Triangle,; a, b, c);
    /// `VL_Dot`: one pixel.
    dot(Dot,; a);
    /// `VL_Line`: a line.
    line(Line,; a, b);
    /// `VL_AALine`: an antialiased line.
    aa_line(AALine,; a, b);
    /// `VL_AAEdge`: antialiases an edge that has been drawn.
    aa_edge(AAEdge,; a, b);
    /// `VL_Span`: a horizontal span; the second vertex holds the steps.
    span(Span,; start, delta);
    /// `VL_Square`: a square around a vertex; `side` is 16.16.
    square(Square, side,; center);
    /// `VL_Rectangle`: a rectangle around a vertex; sizes are 16.16.
    rectangle(Rectangle, width, height,; center);
}

/// `VL_TriangleNormQ`, `VL_Triangle3`: a triangle whose Q are normalised first.
///
/// # Errors
/// As [`triangle`].
pub fn triangle_norm_q<S: CommandSink + ?Sized>(
    sink: &mut S,
    vertex: u32,
    corners: [&[u32]; 3],
) -> Result<()> {
    let routine = VlRoutine::TriangleNormQ;
    let vertex = vertex_type(sink, routine, vertex)?;
    let size = vertex.words();
    if corners.iter().any(|corner| corner.len() < size) {
        return Err(invalid(routine));
    }
    let words = sink.reserve(1 + 3 * size, 0).map_err(|error| unadded(routine, error))?;
    words[0] = vertex.code() << 16 | Opcode::Triangle as u32;
    for (out, corner) in words[1..].chunks_exact_mut(size).zip(corners) {
        out.copy_from_slice(&corner[..size]);
    }
    if let Some(at) = vertex.layout().word(Attribute::Q) {
        let mut q = [0, 1, 2].map(|corner| words[1 + corner * size + at]);
        q_normalize(&mut q);
        for (corner, q) in q.into_iter().enumerate() {
            words[1 + corner * size + at] = q;
        }
    }
    Ok(())
}

/// `VL_Tristrip`: `triangles` triangles of `triangles + 2` vertices.
///
/// # Errors
/// As [`triangle`]; also for no triangles.
pub fn tristrip<S: CommandSink + ?Sized>(
    sink: &mut S,
    vertex: u32,
    triangles: u32,
    vertices: &[u32],
) -> Result<()> {
    let routine = VlRoutine::Tristrip;
    let count = triangles.checked_add(2).filter(|_| triangles > 0).ok_or(invalid(routine))?;
    chain(sink, routine, Opcode::Tristrip, vertex, [triangles, count], vertices)
}

/// `VL_Trifan`: `count` vertices around the first one.
///
/// # Errors
/// As [`triangle`]; also for fewer than three vertices.
pub fn trifan<S: CommandSink + ?Sized>(
    sink: &mut S,
    vertex: u32,
    count: u32,
    vertices: &[u32],
) -> Result<()> {
    let routine = VlRoutine::Trifan;
    if count < 3 {
        return Err(invalid(routine));
    }
    chain(sink, routine, Opcode::Trifan, vertex, [count, count], vertices)
}

/// `VL_Polyline`: `segments` lines through `segments + 1` vertices.
///
/// # Errors
/// As [`triangle`]; also for no segments.
pub fn polyline<S: CommandSink + ?Sized>(
    sink: &mut S,
    vertex: u32,
    segments: u32,
    vertices: &[u32],
) -> Result<()> {
    let routine = VlRoutine::Polyline;
    let count = segments.checked_add(1).filter(|_| segments > 0).ok_or(invalid(routine))?;
    chain(sink, routine, Opcode::Polyline, vertex, [segments, count], vertices)
}

/// `VL_IntLine`: a line in the default colour; `last` draws its last pixel.
///
/// # Errors
/// Those of the sink.
pub fn int_line<S: CommandSink + ?Sized>(
    sink: &mut S,
    last: bool,
    from: [u16; 2],
    to: [u16; 2],
) -> Result<()> {
    let [from, to] = [from, to].map(|[x, y]| pair(x.into(), y.into()));
    let first = u32::from(last) << 16 | Opcode::IntLine as u32;
    put(sink, VlRoutine::IntLine, &[first, from, to])
}

/// `VL_IntPolyline`: lines through points packed as x in the high half, y in
/// the low one; `segments + 1` of them.
///
/// # Errors
/// [`crate::VlError::ParamError`] for no segments or too few points; those of the sink.
pub fn int_polyline<S: CommandSink + ?Sized>(
    sink: &mut S,
    last: bool,
    segments: u32,
    points: &[u32],
) -> Result<()> {
    let routine = VlRoutine::IntPolyline;
    let count = segments as usize + 1;
    let points = points.get(..count).filter(|_| segments > 0).ok_or(invalid(routine))?;
    let out = sink.reserve(2 + count, 0).map_err(|error| unadded(routine, error))?;
    out[0] = u32::from(last) << 16 | Opcode::IntPolyline as u32;
    out[1] = segments;
    out[2..].copy_from_slice(points);
    Ok(())
}

/// `VL_TriangleFill`: a flat triangle; x and y of each corner, 16.16.
///
/// # Errors
/// Those of the sink.
pub fn triangle_fill<S: CommandSink + ?Sized>(sink: &mut S, corners: &[u32; 6]) -> Result<()> {
    let [a, b, c, d, e, f] = *corners;
    put(sink, VlRoutine::TriangleFill, &[Opcode::TriFill as u32, a, b, c, d, e, f])
}

/// `VL_Affine`: x, y, u, v of the upper left corner, width, height, and the
/// steps du/dx, dv/dx, du/dy, dv/dy times 2^8.
///
/// # Errors
/// Those of the sink.
pub fn affine<S: CommandSink + ?Sized>(sink: &mut S, arguments: &[u32; 10]) -> Result<()> {
    let mut words = [Opcode::Affine as u32; 11];
    words[1..].copy_from_slice(arguments);
    put(sink, VlRoutine::Affine, &words)
}

/// `VL_Warp` with the pairs of coordinates in the stream: u and v of each
/// pixel, row by row.
///
/// # Errors
/// [`crate::VlError::ParamError`] for too few pairs; those of the sink.
pub fn warp<S: CommandSink + ?Sized>(
    sink: &mut S,
    at: [u16; 2],
    size: [u16; 2],
    offset: [u32; 2],
    pairs: &[u32],
) -> Result<()> {
    let routine = VlRoutine::Warp;
    let count = usize::from(size[0]) * usize::from(size[1]) * 2;
    let pairs = pairs.get(..count).ok_or(invalid(routine))?;
    let out = sink.reserve(5 + count, 0).map_err(|error| unadded(routine, error))?;
    out[..5].copy_from_slice(&warp_head(at, size, offset));
    out[5..].copy_from_slice(pairs);
    Ok(())
}

/// `VL_Warp` with the pairs in host memory; see [`warp`]. The block's length
/// is set here.
///
/// # Errors
/// Those of the sink.
pub fn warp_dma<S: CommandSink + ?Sized>(
    sink: &mut S,
    at: [u16; 2],
    size: [u16; 2],
    offset: [u32; 2],
    pairs: DmaBlock,
) -> Result<()> {
    let words = u32::from(size[0]) * u32::from(size[1]) * 2;
    super::put_with_data(sink, VlRoutine::Warp, &warp_head(at, size, offset), pairs, words)
}

fn warp_head([x, y]: [u16; 2], [width, height]: [u16; 2], [u, v]: [u32; 2]) -> [u32; 5] {
    let size = pair(width.into(), height.into());
    [Opcode::Warp as u32, pair(x.into(), y.into()), size, u, v]
}

/// `VL_Particles` with the records in the stream, four words each: x and y,
/// width and height, depth 16.16, colour 0x00RRGGBB.
///
/// # Errors
/// [`crate::VlError::ParamError`] for too few words; those of the sink.
pub fn particles<S: CommandSink + ?Sized>(sink: &mut S, count: u32, records: &[u32]) -> Result<()> {
    let routine = VlRoutine::Particles;
    let records = records.get(..count as usize * 4).ok_or(invalid(routine))?;
    let out = sink.reserve(2 + records.len(), 0).map_err(|error| unadded(routine, error))?;
    out[..2].copy_from_slice(&[Opcode::Particles as u32, count]);
    out[2..].copy_from_slice(records);
    Ok(())
}

/// `VL_Particles` with the records in host memory; the block's length is set
/// here.
///
/// # Errors
/// [`crate::VlError::ParamError`] for more than 2^20 records; those of the sink.
pub fn particles_dma<S: CommandSink + ?Sized>(
    sink: &mut S,
    count: u32,
    records: DmaBlock,
) -> Result<()> {
    let routine = VlRoutine::Particles;
    let words = count.checked_mul(4).ok_or(invalid(routine))?;
    super::put_with_data(sink, routine, &[Opcode::Particles as u32, count], records, words)
}
