//! Triangle lists. Null pointers and indices outside are ignored.

use std::mem::offset_of;

use fillrate_guard::{guard, read, write};
use fillrate_quark::{
    Call, Command, ErrorCode, IndexFormat, Layout, ListValue, MAX_COUNT, Reply, StateValue,
    TriangleList, VertexFormat,
};

use crate::layout::{RawList, RawState};
use crate::session::{Session, session};

/// A list's memory, as far as it can be read.
pub(crate) struct Parts<'a> {
    pub vertex_format: VertexFormat,
    pub index_format: IndexFormat,
    pub vertices: &'a [i16],
    pub indices: &'a [u16],
    pub commands: &'a [Command],
}

/// Formats and layout of a list, from its offsets.
fn layout(raw: &RawList) -> Result<(VertexFormat, IndexFormat, Layout), ErrorCode> {
    let vertex = VertexFormat { intensity: raw.vertex_intensity != 0, uv: raw.vertex_uv != 0 };
    let index = IndexFormat {
        intensity: raw.index_intensity != 0,
        color: raw.index_color != 0,
        uv: raw.index_uv != 0,
    };
    let layout = Layout::new(vertex, index)?;
    let is = |member: i32, number: usize| usize::try_from(member) == Ok(number);
    let vertices = is(raw.vertex_stride, layout.vertex_stride)
        && is(raw.vertex_intensity, layout.vertex_intensity)
        && is(raw.vertex_uv, layout.vertex_uv);
    let indices = is(raw.index_stride, layout.index_stride)
        && is(raw.index_intensity, layout.index_intensity)
        && is(raw.index_color, layout.index_color)
        && is(raw.index_uv, layout.index_uv);
    match (vertices, indices) {
        (false, _) => Err(ErrorCode::VertexFormat),
        (_, false) => Err(ErrorCode::IndexFormat),
        _ => Ok((vertex, index, layout)),
    }
}

fn count(number: i32) -> Result<usize, ErrorCode> {
    usize::try_from(number).ok().filter(|&n| n <= MAX_COUNT).ok_or(ErrorCode::Memory)
}

/// Numbers of the program; an error for null and odd addresses.
///
/// # Safety
/// `from` is null or points to `count` readable numbers.
unsafe fn numbers<'a, T>(from: *const T, count: usize) -> Result<&'a [T], ErrorCode> {
    if count == 0 {
        return Ok(&[]);
    }
    if from.is_null() || !from.is_aligned() {
        return Err(ErrorCode::Memory);
    }
    // SAFETY: not null and aligned, and readable by the caller's promise.
    Ok(unsafe { std::slice::from_raw_parts(from, count) })
}

/// The memory of a list.
///
/// # Safety
/// Its pointers are null or point to as much as its counts say.
pub(crate) unsafe fn parts<'a>(raw: &RawList) -> Result<Parts<'a>, ErrorCode> {
    let (vertex_format, index_format, layout) = layout(raw)?;
    let vertices = count(raw.vertex_list_size)? * layout.vertex_stride;
    let indices = count(raw.index_list_size)? * layout.index_stride;
    let commands = count(raw.command_list_size)?;
    // SAFETY: the caller's promise; a command is two numbers.
    unsafe {
        Ok(Parts {
            vertex_format,
            index_format,
            vertices: numbers(raw.vertex_list, vertices)?,
            indices: numbers(raw.index_list, indices)?,
            commands: numbers(raw.command_list.cast(), commands)?,
        })
    }
}

/// A list as a value.
pub(crate) fn list_value(parts: &Parts<'_>, states: Vec<StateValue>) -> ListValue {
    let vertices: Vec<u8> = parts.vertices.iter().flat_map(|n| n.to_le_bytes()).collect();
    let indices: Vec<u8> = parts.indices.iter().flat_map(|n| n.to_le_bytes()).collect();
    ListValue {
        vertex_format: parts.vertex_format.bits(),
        index_format: parts.index_format.bits(),
        vertices: vertices.into(),
        indices: indices.into(),
        commands: parts.commands.iter().flat_map(|c| [c.count, c.state]).collect(),
        states,
    }
}

/// A list of nothing.
fn empty(state: *const RawState, error: ErrorCode) -> RawList {
    RawList {
        vertex_list: std::ptr::null_mut(),
        vertex_list_size: 0,
        vertex_stride: 0,
        index_list: std::ptr::null_mut(),
        index_list_size: 0,
        index_stride: 0,
        vertex_uv: 0,
        vertex_intensity: 0,
        index_uv: 0,
        index_intensity: 0,
        index_color: 0,
        state,
        command_minimal: [0; 2],
        command_list: std::ptr::null_mut(),
        command_list_size: 0,
        error_code: error.code(),
    }
}

/// Makes a list of zeros; 1 on success.
///
/// # Safety
/// `list` is null or points to room for a list.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_list_init(
    list: *mut RawList,
    vertex_format: i32,
    vertices: i32,
    index_format: i32,
    triangles: i32,
    states: *const RawState,
) -> i32 {
    guard(0, || {
        if list.is_null() {
            return 0;
        }
        let mut session = session();
        let call = Call::ListInit { vertex_format, vertices, index_format, triangles };
        let Reply::List(made) = session.call(&call) else { return 0 };
        let made = made.and_then(|made| session.new_list(&made, list as usize, states));
        // SAFETY: the caller's promise.
        unsafe { write(list, made.unwrap_or_else(|error| empty(states, error))) };
        i32::from(made.is_ok())
    })
}

impl Session {
    /// A new list's members, for an object at `address`.
    fn new_list(
        &mut self,
        list: &TriangleList,
        address: usize,
        state: *const RawState,
    ) -> Result<RawList, ErrorCode> {
        let layout = list.layout();
        let vertex_list = self.memory.store(list.vertices()).ok_or(ErrorCode::Memory)?;
        let index_list = self.memory.store(list.indices()).ok_or(ErrorCode::Memory)?;
        Ok(RawList {
            vertex_list,
            vertex_list_size: list.vertex_count() as i32,
            vertex_stride: layout.vertex_stride as i32,
            index_list,
            index_list_size: list.triangle_count() as i32,
            index_stride: layout.index_stride as i32,
            vertex_uv: layout.vertex_uv as i32,
            vertex_intensity: layout.vertex_intensity as i32,
            index_uv: layout.index_uv as i32,
            index_intensity: layout.index_intensity as i32,
            index_color: layout.index_color as i32,
            command_minimal: [list.triangle_count() as u16, 0],
            command_list: minimal_of(address),
            command_list_size: 1,
            ..empty(state, ErrorCode::None)
        })
    }

    /// Puts a changed list into the program's memory: in place where the size
    /// stayed, else into a block of the new size.
    ///
    /// # Safety
    /// The members' memory can be written.
    unsafe fn store_list(
        &mut self,
        raw: &mut RawList,
        list: &TriangleList,
        address: usize,
    ) -> Result<(), ErrorCode> {
        let stride = raw.vertex_stride.max(1) as usize;
        let vertices = raw.vertex_list_size as usize * stride;
        // SAFETY: the caller's promise.
        raw.vertex_list = unsafe { self.replace(raw.vertex_list, vertices, list.vertices())? };
        raw.vertex_list_size = list.vertex_count() as i32;
        let stride = raw.index_stride.max(1) as usize;
        let indices = raw.index_list_size as usize * stride;
        // SAFETY: the caller's promise.
        raw.index_list = unsafe { self.replace(raw.index_list, indices, list.indices())? };
        raw.index_list_size = list.triangle_count() as i32;
        self.store_commands(raw, list, address)
    }

    /// # Safety
    /// `old` is null or points to `count` writable numbers.
    unsafe fn replace<T: Copy>(
        &mut self,
        old: *mut T,
        count: usize,
        new: &[T],
    ) -> Result<*mut T, ErrorCode> {
        if count == new.len() {
            if count > 0 {
                // SAFETY: the caller's promise; `new` is memory of ours.
                unsafe { old.copy_from_nonoverlapping(new.as_ptr(), count) };
            }
            return Ok(old);
        }
        let block = self.memory.store(new).ok_or(ErrorCode::Memory)?;
        self.memory.free(old);
        Ok(block)
    }

    fn store_commands(
        &mut self,
        raw: &mut RawList,
        list: &TriangleList,
        address: usize,
    ) -> Result<(), ErrorCode> {
        let old = raw.command_list;
        let numbers: Vec<u16> = list.commands().iter().flat_map(|c| [c.count, c.state]).collect();
        match numbers[..] {
            [count, state] => {
                raw.command_minimal = [count, state];
                raw.command_list = minimal_of(address);
            }
            _ => raw.command_list = self.memory.store(&numbers).ok_or(ErrorCode::Memory)?,
        }
        raw.command_list_size = list.commands().len() as i32;
        self.memory.free(old);
        Ok(())
    }
}

/// Where a list's built-in command lies.
fn minimal_of(address: usize) -> *mut u16 {
    address.wrapping_add(offset_of!(RawList, command_minimal)) as *mut u16
}

/// Changes a list by a call; 1 on success, else the error is noted.
///
/// # Safety
/// `list` is null or points to a list whose memory can be read and written.
unsafe fn change(
    list: *mut RawList,
    make: impl FnOnce(&RawList, ListValue) -> Result<Call, ErrorCode>,
) -> i32 {
    guard(0, || {
        // SAFETY: the caller's promise.
        let Some(mut raw) = (unsafe { read(list) }) else { return 0 };
        let mut session = session();
        // SAFETY: the caller's promise.
        let value = unsafe { parts(&raw) }.map(|parts| list_value(&parts, Vec::new()));
        let call = value.and_then(|value| make(&raw, value));
        let changed = call.and_then(|call| match session.call(&call) {
            Reply::List(changed) => *changed,
            _ => Err(ErrorCode::Memory),
        });
        let done = changed.and_then(|changed| {
            // SAFETY: the caller's promise.
            unsafe { session.store_list(&mut raw, &changed, list as usize) }
        });
        raw.error_code = done.err().unwrap_or_default().code();
        // SAFETY: it was just read.
        unsafe { write(list, raw) };
        i32::from(done.is_ok())
    })
}

/// Merges near vertices; 1 on success.
///
/// # Safety
/// `list` is null or points to a list whose memory can be read and written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_list_weld(
    list: *mut RawList,
    position: i32,
    intensity: i32,
    uv: i32,
) -> i32 {
    // SAFETY: the caller's promise.
    unsafe { change(list, |_, list| Ok(Call::WeldVertex { list, position, intensity, uv })) }
}

/// Gathers triangles by state; 1 on success.
///
/// # Safety
/// `list` is null or points to a list whose memory can be read and written;
/// `states` is null or points to as many numbers as the list has triangles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_list_build_commands(list: *mut RawList, states: *const u16) -> i32 {
    // SAFETY: the caller's promise.
    unsafe {
        change(list, |raw, list| {
            let states = numbers(states, count(raw.index_list_size)?)?.to_vec();
            Ok(Call::BuildCmdList { list, states })
        })
    }
}

/// Writes normals `stride` numbers apart; 1 on success.
///
/// # Safety
/// `list` is null or points to a list whose memory can be read; `out` is null
/// or has room for `stride` numbers for each normal.
unsafe fn normals(
    list: *const RawList,
    out: *mut i16,
    stride: i32,
    make: impl FnOnce(ListValue) -> Call,
) -> i32 {
    guard(0, || {
        // SAFETY: the caller's promise.
        let Some(raw) = (unsafe { read(list) }) else { return 0 };
        // SAFETY: the caller's promise.
        let Ok(parts) = (unsafe { parts(&raw) }) else { return 0 };
        if out.is_null() || stride < 3 {
            return 0;
        }
        let reply = session().call(&make(list_value(&parts, Vec::new())));
        let Reply::Normals(Ok(normals)) = reply else { return 0 };
        for (i, normal) in normals.into_iter().enumerate() {
            // SAFETY: the caller gives room for each.
            unsafe { write(out.add(i * stride as usize).cast(), normal) };
        }
        1
    })
}

/// Writes the normal of each triangle; 1 on success.
///
/// # Safety
/// `list` is null or points to a list whose memory can be read; `out` is null
/// or has room for `stride` numbers for each triangle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_list_face_normals(
    list: *const RawList,
    out: *mut i16,
    stride: i32,
) -> i32 {
    // SAFETY: the caller's promise.
    unsafe { normals(list, out, stride, |list| Call::BuildFNormalList { list }) }
}

/// Writes the normal of each vertex; 1 on success.
///
/// # Safety
/// `list` is null or points to a list whose memory can be read; `out` is null
/// or has room for `stride` numbers for each vertex.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_list_vertex_normals(
    list: *const RawList,
    out: *mut i16,
    stride: i32,
) -> i32 {
    // SAFETY: the caller's promise.
    unsafe { normals(list, out, stride, |list| Call::BuildVNormalList { list }) }
}

/// Frees a list's memory, as far as it is ours.
///
/// # Safety
/// `list` is null or points to a list.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_list_delete(list: *mut RawList) {
    guard((), || {
        // SAFETY: the caller's promise.
        let Some(raw) = (unsafe { read(list) }) else { return };
        let mut session = session();
        session.memory.free(raw.vertex_list);
        session.memory.free(raw.index_list);
        session.memory.free(raw.command_list);
        // SAFETY: it was just read.
        unsafe { write(list, empty(raw.state, ErrorCode::None)) };
    })
}

/// Where an item of a vertex or triangle lies; `None` outside, and where the
/// list has no memory.
fn place<T>(base: *mut T, size: i32, stride: i32, index: i32, offset: i32) -> Option<*mut T> {
    let inside = (0..size).contains(&index) && stride >= 3 && (0..stride).contains(&offset);
    let at = index as usize * stride.max(0) as usize + offset.max(0) as usize;
    (inside && !base.is_null()).then(|| base.wrapping_add(at))
}

fn vertex(raw: &RawList, index: i32, offset: i32) -> Option<*mut i16> {
    place(raw.vertex_list, raw.vertex_list_size, raw.vertex_stride, index, offset)
}

fn triangle(raw: &RawList, index: i32, offset: i32) -> Option<*mut u16> {
    place(raw.index_list, raw.index_list_size, raw.index_stride, index, offset)
}

/// Accessors: each reads the list's members first.
macro_rules! accessors {
    ($($(#[$doc:meta])* $name:ident($($arg:ident: $type:ty),*) $(-> $result:ty)? |$raw:ident| $body:expr;)*) => {$(
        $(#[$doc])*
        ///
        /// # Safety
        /// `list` is null or points to a list whose memory can be read and
        /// written; other pointers are null or point to as many numbers as the
        /// format asks for.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(list: *const RawList $(, $arg: $type)*) $(-> $result)? {
            guard(Default::default(), || {
                // SAFETY: the caller's promise.
                let Some($raw) = (unsafe { read(list) }) else { return Default::default() };
                // SAFETY: places are inside the list, by the caller's promise.
                unsafe { $body }
            })
        }
    )*};
}

/// Copies `count` numbers, converted; null is ignored.
///
/// # Safety
/// Both are null or point to `count` numbers.
unsafe fn copy<A: Copy, B>(from: *const A, to: *mut B, count: usize, convert: fn(A) -> B) {
    if from.is_null() || to.is_null() {
        return;
    }
    for i in 0..count {
        // SAFETY: the caller's promise.
        unsafe { to.add(i).write_unaligned(convert(from.add(i).read_unaligned())) }
    }
}

accessors! {
    /// Sets a triangle's corners.
    quark_list_set_abc(index: i32, abc: *const u16) |raw| {
        if let Some(to) = triangle(&raw, index, 0) {
            copy(abc, to, 3, |n| n);
        }
    };
    /// Sets a vertex's position.
    quark_list_set_xyz(index: i32, xyz: *const i16) |raw| {
        if let Some(to) = vertex(&raw, index, 0) {
            copy(xyz, to, 3, |n| n);
        }
    };
    /// Sets texture coordinates: two of a vertex, six of a triangle.
    quark_list_set_uv(index: i32, uv: *const i16) |raw| {
        if raw.vertex_uv > 0 {
            if let Some(to) = vertex(&raw, index, raw.vertex_uv) {
                copy(uv, to, 2, |n| n);
            }
        } else if raw.index_uv > 0
            && let Some(to) = triangle(&raw, index, raw.index_uv)
        {
            copy(uv, to, 6, |n| n as u16);
        }
    };
    /// Sets the intensity of a vertex or a triangle.
    quark_list_set_i(index: i32, intensity: i32) |raw| {
        if raw.vertex_intensity > 0 {
            if let Some(to) = vertex(&raw, index, raw.vertex_intensity) {
                write(to, intensity as i16);
            }
        } else if raw.index_intensity > 0
            && let Some(to) = triangle(&raw, index, raw.index_intensity)
        {
            write(to, intensity as u16);
        }
    };
    /// Sets a triangle's base colour.
    quark_list_set_c(index: i32, color: i32) |raw| {
        if raw.index_color > 0
            && let Some(to) = triangle(&raw, index, raw.index_color)
        {
            write(to, color as u16);
        }
    };
    /// A triangle's corners.
    quark_list_get_abc(index: i32, abc: *mut i32) |raw| {
        if let Some(from) = triangle(&raw, index, 0) {
            copy(from.cast_const(), abc, 3, i32::from);
        }
    };
    /// A vertex's position.
    quark_list_get_xyz(index: i32, xyz: *mut i32) |raw| {
        if let Some(from) = vertex(&raw, index, 0) {
            copy(from.cast_const(), xyz, 3, i32::from);
        }
    };
    /// Texture coordinates: two of a vertex, six of a triangle.
    quark_list_get_uv(index: i32, uv: *mut i32) |raw| {
        if raw.vertex_uv > 0 {
            if let Some(from) = vertex(&raw, index, raw.vertex_uv) {
                copy(from.cast_const(), uv, 2, i32::from);
            }
        } else if raw.index_uv > 0
            && let Some(from) = triangle(&raw, index, raw.index_uv)
        {
            copy(from.cast_const(), uv, 6, |n| i32::from(n as i16));
        }
    };
    /// The intensity of a vertex or a triangle; 0 where there is none.
    quark_list_get_i(index: i32) -> i32 |raw| {
        if raw.vertex_intensity > 0 {
            vertex(&raw, index, raw.vertex_intensity).and_then(|at| read(at)).map_or(0, i32::from)
        } else if raw.index_intensity > 0 {
            triangle(&raw, index, raw.index_intensity)
                .and_then(|at| read(at))
                .map_or(0, i32::from)
        } else {
            0
        }
    };
    /// A triangle's base colour; 0 where there is none.
    quark_list_get_c(index: i32) -> i32 |raw| {
        if raw.index_color > 0 {
            triangle(&raw, index, raw.index_color).and_then(|at| read(at)).map_or(0, i32::from)
        } else {
            0
        }
    };
}
