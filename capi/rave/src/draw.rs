//! State and drawing of built-in contexts: pointers are checked, vertices read,
//! calls made.

use std::ffi::c_void;

use fillrate_guard::guard;
use fillrate_rave::{Call, DrawContextId, IndexedTriangle, VGouraud, VTexture, constants, tags};

use crate::context::extension;
use crate::layout::{MAX_ELEMENTS, RawDrawContext, value, values};
use crate::session::{Lent, Session, as_pointer, number_of, session};

/// Does something with a built-in context; others are ignored.
pub fn on<T: Copy>(
    context: *const RawDrawContext,
    fallback: T,
    action: impl FnOnce(&mut Session, u32) -> T,
) -> T {
    guard(fallback, || {
        let mut session = session();
        let known = session.contexts.get(&(context as usize)).map(|known| known.number);
        known.map_or(fallback, |number| action(&mut session, number))
    })
}

/// The number of a context that a call refers to; 0 for null.
pub fn context_number(session: &Session, context: *const RawDrawContext) -> u32 {
    if context.is_null() {
        return 0;
    }
    session.contexts.get(&(context as usize)).map_or(u32::MAX, |known| known.number)
}

/// `QASetFloat`.
pub extern "C" fn set_float(context: *mut RawDrawContext, tag: u32, value: f32) {
    on(context, (), |session, context| {
        session.call(&Call::SetFloat { context, tag, value });
    });
}

/// `QASetInt`.
pub extern "C" fn set_int(context: *mut RawDrawContext, tag: u32, value: u32) {
    on(context, (), |session, context| {
        session.call(&Call::SetInt { context, tag, value });
    });
}

/// `QASetPtr`: all pointer tags are textures.
pub extern "C" fn set_ptr(context: *mut RawDrawContext, tag: u32, value: *const c_void) {
    on(context, (), |session, context| {
        let texture = number_of(value);
        session.call(&Call::SetTexture { context, tag, texture });
    });
}

/// `QAGetFloat`.
pub extern "C" fn get_float(context: *const RawDrawContext, tag: u32) -> f32 {
    on(context, 0.0, |session, number| session.context.get_float(DrawContextId(number), tag))
}

/// `QAGetInt`.
pub extern "C" fn get_int(context: *const RawDrawContext, tag: u32) -> u32 {
    on(context, 0, |session, number| session.context.get_int(DrawContextId(number), tag))
}

/// `QAGetPtr`.
pub extern "C" fn get_ptr(context: *const RawDrawContext, tag: u32) -> *mut c_void {
    on(context, std::ptr::null_mut(), |session, number| {
        let texture = || {
            let texture = session.context.get_texture(DrawContextId(number), tag);
            as_pointer(texture.map_or(0, |texture| texture.0))
        };
        extension(tag).unwrap_or_else(texture)
    })
}

/// `QADrawPoint`.
///
/// # Safety
/// The vertex is null or can be read.
pub unsafe extern "C" fn draw_point(context: *const RawDrawContext, v: *const [f32; 8]) {
    on(context, (), |session, context| {
        // SAFETY: the caller's promise.
        let Some(v) = (unsafe { value(v) }) else { return session.draw_nothing(context) };
        session.call(&Call::DrawPoint { context, v });
    });
}

/// `QADrawLine`.
///
/// # Safety
/// The vertices are null or can be read.
pub unsafe extern "C" fn draw_line(
    context: *const RawDrawContext,
    a: *const [f32; 8],
    b: *const [f32; 8],
) {
    on(context, (), |session, context| {
        // SAFETY: the caller's promise.
        let (Some(a), Some(b)) = (unsafe { (value(a), value(b)) }) else {
            return session.draw_nothing(context);
        };
        session.call(&Call::DrawLine { context, a, b });
    });
}

/// `QADrawTriGouraud`.
///
/// # Safety
/// The vertices are null or can be read.
pub unsafe extern "C" fn draw_tri_gouraud(
    context: *const RawDrawContext,
    a: *const [f32; 8],
    b: *const [f32; 8],
    c: *const [f32; 8],
    flags: u32,
) {
    on(context, (), |session, context| {
        // SAFETY: the caller's promise.
        let corners = unsafe { (value(a), value(b), value(c)) };
        let (Some(a), Some(b), Some(c)) = corners else { return session.draw_nothing(context) };
        session.call(&Call::DrawTriGouraud { context, a, b, c, flags });
    });
}

/// `QADrawTriTexture`.
///
/// # Safety
/// The vertices are null or can be read, and so are the parameters submitted
/// last.
pub unsafe extern "C" fn draw_tri_texture(
    context: *const RawDrawContext,
    a: *const [f32; 16],
    b: *const [f32; 16],
    c: *const [f32; 16],
    flags: u32,
) {
    let address = context as usize;
    on(context, (), |session, context| {
        // SAFETY: the caller's promise.
        let corners = unsafe { (value(a), value(b), value(c)) };
        let (Some(a), Some(b), Some(c)) = corners else { return session.draw_nothing(context) };
        // SAFETY: the caller's promise.
        unsafe { session.send_params(address) };
        session.call(&Call::DrawTriTexture { context, a, b, c, flags });
    });
}

/// The flags of an array's triangles, one each; `None` for null.
///
/// # Safety
/// `flags` is null or has as many as there are triangles.
unsafe fn triangle_flags(flags: *const u32, count: u32, mode: u32) -> Option<Vec<u32>> {
    if flags.is_null() {
        return None;
    }
    let triangles = match mode {
        constants::vertex_mode::TRI => count / 3,
        constants::vertex_mode::STRIP | constants::vertex_mode::FAN => count.saturating_sub(2),
        _ => 0,
    };
    // SAFETY: the caller's promise.
    unsafe { values(flags, triangles) }
}

/// `QADrawVGouraud`.
///
/// # Safety
/// The arrays are null or as long as `count` and the mode say.
pub unsafe extern "C" fn draw_v_gouraud(
    context: *const RawDrawContext,
    count: u32,
    mode: u32,
    vertices: *const [f32; 8],
    flags: *const u32,
) {
    on(context, (), |session, context| {
        // SAFETY: the caller's promise.
        let Some(vertices) = (unsafe { values::<VGouraud>(vertices, count) }) else {
            return session.draw_nothing(context);
        };
        // SAFETY: the caller's promise.
        let flags = unsafe { triangle_flags(flags, count, mode) };
        session.call(&Call::DrawVGouraud { context, mode, vertices, flags });
    });
}

/// `QADrawVTexture`.
///
/// # Safety
/// The arrays are null or as long as `count` and the mode say.
pub unsafe extern "C" fn draw_v_texture(
    context: *const RawDrawContext,
    count: u32,
    mode: u32,
    vertices: *const [f32; 16],
    flags: *const u32,
) {
    let address = context as usize;
    on(context, (), |session, context| {
        // SAFETY: the caller's promise.
        let Some(vertices) = (unsafe { values::<VTexture>(vertices, count) }) else {
            return session.draw_nothing(context);
        };
        // SAFETY: the caller's promise.
        let flags = unsafe { triangle_flags(flags, count, mode) };
        // SAFETY: the caller's promise.
        unsafe { session.send_params(address) };
        session.call(&Call::DrawVTexture { context, mode, vertices, flags });
    });
}

/// `QADrawBitmap`.
///
/// # Safety
/// The vertex is null or can be read.
pub unsafe extern "C" fn draw_bitmap(
    context: *const RawDrawContext,
    v: *const [f32; 8],
    bitmap: *const c_void,
) {
    on(context, (), |session, context| {
        // SAFETY: the caller's promise.
        let Some(v) = (unsafe { value(v) }) else { return session.draw_nothing(context) };
        session.call(&Call::DrawBitmap { context, v, bitmap: number_of(bitmap) });
    });
}

/// `QASubmitVerticesGouraud`: keeps the pointer.
pub extern "C" fn submit_vertices_gouraud(
    context: *const RawDrawContext,
    count: u32,
    vertices: *const [f32; 8],
) {
    let address = context as usize;
    on(context, (), |session, _| {
        if let Some(known) = session.contexts.get_mut(&address) {
            known.gouraud = Lent::new(vertices, count.min(MAX_ELEMENTS));
        }
    });
}

/// `QASubmitVerticesTexture`: keeps the pointer.
pub extern "C" fn submit_vertices_texture(
    context: *const RawDrawContext,
    count: u32,
    vertices: *const [f32; 16],
) {
    let address = context as usize;
    on(context, (), |session, _| {
        if let Some(known) = session.contexts.get_mut(&address) {
            known.texture = Lent::new(vertices, count.min(MAX_ELEMENTS));
        }
    });
}

/// `QADrawTriMeshGouraud`: reads the vertices now.
///
/// # Safety
/// The triangles can be read, and so can the vertices submitted last.
pub unsafe extern "C" fn draw_tri_mesh_gouraud(
    context: *const RawDrawContext,
    count: u32,
    triangles: *const [u32; 4],
) {
    let address = context as usize;
    on(context, (), |session, context| {
        let Some(known) = session.contexts.get_mut(&address) else { return };
        // SAFETY: the caller's promise.
        if let Some(vertices) = unsafe { known.gouraud.news() } {
            session.call(&Call::SubmitVerticesGouraud { context, vertices });
        }
        // SAFETY: the caller's promise.
        let triangles = unsafe { values::<IndexedTriangle>(triangles, count) };
        let Some(triangles) = triangles else { return session.draw_nothing(context) };
        session.call(&Call::DrawTriMeshGouraud { context, triangles });
    });
}

/// `QADrawTriMeshTexture`: reads the vertices now.
///
/// # Safety
/// The triangles can be read, and so can the vertices and parameters submitted
/// last.
pub unsafe extern "C" fn draw_tri_mesh_texture(
    context: *const RawDrawContext,
    count: u32,
    triangles: *const [u32; 4],
) {
    let address = context as usize;
    on(context, (), |session, context| {
        let Some(known) = session.contexts.get_mut(&address) else { return };
        // SAFETY: the caller's promise.
        if let Some(vertices) = unsafe { known.texture.news() } {
            session.call(&Call::SubmitVerticesTexture { context, vertices });
        }
        // SAFETY: the caller's promise.
        unsafe { session.send_params(address) };
        // SAFETY: the caller's promise.
        let triangles = unsafe { values::<IndexedTriangle>(triangles, count) };
        let Some(triangles) = triangles else { return session.draw_nothing(context) };
        session.call(&Call::DrawTriMeshTexture { context, triangles });
    });
}

/// `QASubmitMultiTextureParams`: keeps the pointer, for the current layer.
pub extern "C" fn submit_multi_texture_params(
    context: *const RawDrawContext,
    count: u32,
    params: *const [f32; 3],
) {
    let address = context as usize;
    on(context, (), |session, number| {
        let layer =
            session.context.get_int(DrawContextId(number), tags::int::MULTI_TEXTURE_CURRENT);
        if let Some(known) = session.contexts.get_mut(&address) {
            known.params.insert(layer, Lent::new(params, count.min(MAX_ELEMENTS)));
        }
    });
}

impl Session {
    /// What a drawing call without its vertices, or with too many of them, comes
    /// to: a point that is nowhere, which is an error of the frame.
    fn draw_nothing(&mut self, context: u32) {
        let v = VGouraud { x: f32::NAN, ..VGouraud::default() };
        self.call(&Call::DrawPoint { context, v });
    }

    /// Tells the library of parameters of further textures that it does not know
    /// yet.
    ///
    /// # Safety
    /// The arrays are as they were submitted.
    unsafe fn send_params(&mut self, address: usize) {
        let Some(known) = self.contexts.get_mut(&address) else { return };
        let context = known.number;
        let mut calls = Vec::new();
        for (&layer, lent) in &mut known.params {
            // SAFETY: the caller's promise.
            if let Some(params) = unsafe { lent.news() } {
                calls.push(Call::SubmitMultiTextureParams { context, layer, params });
            }
        }
        for call in &calls {
            self.call(call);
        }
    }
}
