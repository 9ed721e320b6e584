//! Methods that the manager has for engines without their own: arrays and meshes
//! are split into single points, lines and triangles. The others do nothing, or
//! are refused.

use std::ffi::c_void;

use fillrate_guard::guard;
use fillrate_rave::constants::vertex_mode;

use crate::layout::{MAX_ELEMENTS, METHODS, Method, NOT_SUPPORTED, RawDrawContext};
use crate::session::session;

/// Places of the methods that others are split into.
const DRAW_POINT: usize = 6;
const DRAW_LINE: usize = 7;
const DRAW_TRI_GOURAUD: usize = 8;
const DRAW_TRI_TEXTURE: usize = 9;

/// What a draw context has before its engine registers anything.
pub const METHODS_OF_NONE: [Method; METHODS] = {
    // Functions that return nothing may as well return something: the callers
    // do not look.
    let mut methods = [refuse as Method; METHODS];
    methods[3] = get_float as Method;
    methods[4] = get_nothing as Method;
    methods[5] = get_nothing as Method;
    methods[10] = draw_v_gouraud as Method;
    methods[11] = draw_v_texture as Method;
    methods[18] = submit_gouraud as Method;
    methods[19] = submit_texture as Method;
    methods[20] = draw_mesh_gouraud as Method;
    methods[21] = draw_mesh_texture as Method;
    methods[33] = get_nothing as Method;
    methods
};

extern "C" fn refuse() -> i32 {
    NOT_SUPPORTED
}

extern "C" fn get_float() -> f32 {
    0.0
}

extern "C" fn get_nothing() -> usize {
    0
}

type Point = unsafe extern "C" fn(*const RawDrawContext, *const c_void);
type Line = unsafe extern "C" fn(*const RawDrawContext, *const c_void, *const c_void);
type Triangle =
    unsafe extern "C" fn(*const RawDrawContext, *const c_void, *const c_void, *const c_void, u32);

/// Vertices of a size, at an address.
#[derive(Clone, Copy)]
struct Vertices {
    base: *const u8,
    count: u32,
    size: usize,
}

impl Vertices {
    /// A vertex, where it is among them.
    fn at(&self, index: u32) -> Option<*const c_void> {
        let is_there = index < self.count && !self.base.is_null();
        is_there.then(|| self.base.wrapping_add(index as usize * self.size).cast())
    }
}

/// A context of a program's engine.
#[derive(Clone, Copy)]
struct Split(*const RawDrawContext);

impl Split {
    /// A context, if it is one.
    fn of(context: *const RawDrawContext) -> Option<Split> {
        session().foreign.contains_key(&(context as usize)).then_some(Split(context))
    }

    fn method(self, slot: usize) -> Method {
        // SAFETY: a context of ours that is still there.
        unsafe { (*self.0).methods[slot] }
    }

    fn point(self, a: Option<*const c_void>) {
        let Some(a) = a else { return };
        // SAFETY: registered for this slot, or a refusal of any arguments.
        let method: Point = unsafe { std::mem::transmute(self.method(DRAW_POINT)) };
        // SAFETY: the vertex is the program's.
        unsafe { method(self.0, a) };
    }

    fn line(self, a: Option<*const c_void>, b: Option<*const c_void>) {
        let (Some(a), Some(b)) = (a, b) else { return };
        // SAFETY: as above.
        let method: Line = unsafe { std::mem::transmute(self.method(DRAW_LINE)) };
        // SAFETY: the vertices are the program's.
        unsafe { method(self.0, a, b) };
    }

    fn triangle(self, slot: usize, vertices: Vertices, corners: [u32; 3], flags: u32) {
        let [a, b, c] = corners.map(|index| vertices.at(index));
        let (Some(a), Some(b), Some(c)) = (a, b, c) else { return };
        // SAFETY: as above.
        let method: Triangle = unsafe { std::mem::transmute(self.method(slot)) };
        // SAFETY: the vertices are the program's.
        unsafe { method(self.0, a, b, c, flags) };
    }

    /// Triangles of an array. A strip and a fan have two fewer than vertices.
    ///
    /// # Safety
    /// `flags` is null or has one for each triangle.
    unsafe fn triangles(self, slot: usize, mode: u32, vertices: Vertices, flags: *const u32) {
        let count = match mode {
            vertex_mode::TRI => vertices.count / 3,
            vertex_mode::STRIP | vertex_mode::FAN => vertices.count.saturating_sub(2),
            _ => 0,
        };
        for n in 0..count {
            let corners = match mode {
                vertex_mode::TRI => [3 * n, 3 * n + 1, 3 * n + 2],
                vertex_mode::STRIP => [n, n + 1, n + 2],
                _ => [0, n + 1, n + 2],
            };
            let flags = match flags.is_null() {
                true => 0,
                // SAFETY: the caller's promise.
                false => unsafe { flags.add(n as usize).read_unaligned() },
            };
            self.triangle(slot, vertices, corners, flags);
        }
    }
}

/// Splits an array of vertices with a colour.
unsafe extern "C" fn draw_v_gouraud(
    context: *const RawDrawContext,
    count: u32,
    mode: u32,
    vertices: *const u8,
    flags: *const u32,
) {
    guard((), || {
        let Some(split) = Split::of(context).filter(|_| count <= MAX_ELEMENTS) else { return };
        let vertices = Vertices { base: vertices, count, size: 32 };
        match mode {
            vertex_mode::POINT => (0..count).for_each(|n| split.point(vertices.at(n))),
            vertex_mode::LINE => {
                let starts = (0..count / 2).map(|n| 2 * n);
                starts.for_each(|n| split.line(vertices.at(n), vertices.at(n + 1)));
            }
            vertex_mode::POLYLINE => {
                let starts = 0..count.saturating_sub(1);
                starts.for_each(|n| split.line(vertices.at(n), vertices.at(n + 1)));
            }
            // SAFETY: the caller's promise.
            _ => unsafe { split.triangles(DRAW_TRI_GOURAUD, mode, vertices, flags) },
        }
    });
}

/// Splits an array of vertices with a texture coordinate; there are no textured
/// points and lines.
unsafe extern "C" fn draw_v_texture(
    context: *const RawDrawContext,
    count: u32,
    mode: u32,
    vertices: *const u8,
    flags: *const u32,
) {
    guard((), || {
        let Some(split) = Split::of(context).filter(|_| count <= MAX_ELEMENTS) else { return };
        let vertices = Vertices { base: vertices, count, size: 64 };
        // SAFETY: the caller's promise.
        unsafe { split.triangles(DRAW_TRI_TEXTURE, mode, vertices, flags) };
    });
}

/// Keeps the vertices of meshes: 0 with a colour, 1 with a texture coordinate.
fn submit(context: *const RawDrawContext, which: usize, count: u32, vertices: *const u8) {
    guard((), || {
        let mut session = session();
        if let Some(foreign) = session.foreign.get_mut(&(context as usize)) {
            foreign.submitted[which] = (vertices as usize, count);
        }
    });
}

extern "C" fn submit_gouraud(context: *const RawDrawContext, count: u32, vertices: *const u8) {
    submit(context, 0, count, vertices);
}

extern "C" fn submit_texture(context: *const RawDrawContext, count: u32, vertices: *const u8) {
    submit(context, 1, count, vertices);
}

/// Splits a mesh of the vertices submitted last.
///
/// # Safety
/// The triangles and vertices can be read.
unsafe fn draw_mesh(
    context: *const RawDrawContext,
    which: usize,
    count: u32,
    triangles: *const [u32; 4],
) {
    guard((), || {
        let submitted = |foreign: &crate::session::Foreign| foreign.submitted[which];
        let found = session().foreign.get(&(context as usize)).map(submitted);
        let Some((base, length)) = found else { return };
        if triangles.is_null() || count > MAX_ELEMENTS {
            return;
        }
        let (slot, size) = [(DRAW_TRI_GOURAUD, 32), (DRAW_TRI_TEXTURE, 64)][which];
        let vertices = Vertices { base: base as *const u8, count: length, size };
        for n in 0..count as usize {
            // SAFETY: the caller's promise.
            let [flags, corners @ ..] = unsafe { triangles.add(n).read_unaligned() };
            Split(context).triangle(slot, vertices, corners, flags);
        }
    });
}

unsafe extern "C" fn draw_mesh_gouraud(
    context: *const RawDrawContext,
    count: u32,
    triangles: *const [u32; 4],
) {
    // SAFETY: the caller's promise.
    unsafe { draw_mesh(context, 0, count, triangles) };
}

unsafe extern "C" fn draw_mesh_texture(
    context: *const RawDrawContext,
    count: u32,
    triangles: *const [u32; 4],
) {
    // SAFETY: the caller's promise.
    unsafe { draw_mesh(context, 1, count, triangles) };
}
