//! The texture manager.

use std::collections::BTreeMap;

use fillrate_glide::gu::{MipMap, NCC_TABLE_BYTES, color_mip_map};
use fillrate_glide::{Call, Context};
use fillrate_guard::{bytes, guard, read, write};

use crate::library::calls;
use crate::session::{ask, call, null, session};

/// `GrMipMapInfo`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct MipMapInfo {
    sst: i32,
    valid: i32,
    width: i32,
    height: i32,
    aspect: i32,
    /// Where the program downloaded from, as an address.
    data: usize,
    format: i32,
    mip_map_mode: i32,
    magnify: i32,
    minify: i32,
    s_clamp: i32,
    t_clamp: i32,
    t_lod: u32,
    texture_mode: u32,
    lod_bias: u32,
    small_lod: i32,
    large_lod: i32,
    tmu: i32,
    even_odd: u32,
    base: u32,
    trilinear: i32,
    ncc_table: NccTable,
}

/// `GuNccTable` as bytes of its alignment.
#[repr(C, align(4))]
#[derive(Clone, Copy, Debug)]
struct NccTable([u8; NCC_TABLE_BYTES]);

impl Default for NccTable {
    fn default() -> NccTable {
        NccTable([0; NCC_TABLE_BYTES])
    }
}

#[cfg(target_pointer_width = "64")]
const _: () = assert!(size_of::<MipMapInfo>() == 208);
#[cfg(target_pointer_width = "32")]
const _: () = assert!(size_of::<MipMapInfo>() == 196);

impl MipMapInfo {
    /// The record of a mip map, or that of none.
    fn new(mip_map: Option<&MipMap>, data: usize) -> MipMapInfo {
        let Some(m) = mip_map else { return MipMapInfo::default() };
        MipMapInfo {
            sst: m.board,
            valid: 1,
            width: m.width,
            height: m.height,
            aspect: m.info.aspect,
            data,
            format: m.info.format,
            mip_map_mode: m.mip_map_mode,
            magnify: m.magnify,
            minify: m.minify,
            s_clamp: m.s_clamp,
            t_clamp: m.t_clamp,
            t_lod: m.t_lod(),
            texture_mode: m.texture_mode(),
            lod_bias: m.lod_bias,
            small_lod: m.info.small_lod,
            large_lod: m.info.large_lod,
            tmu: m.tmu,
            even_odd: m.even_odd,
            base: m.base_address(),
            trilinear: i32::from(m.trilinear),
            ncc_table: NccTable(m.ncc_table),
        }
    }
}

/// A board and a handle on it.
type Key = (usize, u32);

/// Records that programs hold pointers to. One that was handed out stays where
/// it is, and is kept up to date, until the process ends.
#[derive(Debug, Default)]
pub struct Records {
    given: BTreeMap<Key, Box<MipMapInfo>>,
    /// Where programs downloaded from last.
    data: BTreeMap<Key, usize>,
}

impl Records {
    /// The record of a handle, up to date; null where there is none.
    fn give(&mut self, context: &Context, id: u32) -> *mut MipMapInfo {
        let key = (context.current_board(), id);
        let Some(mip_map) = context.mip_map(id) else { return std::ptr::null_mut() };
        let now = MipMapInfo::new(Some(mip_map), self.data.get(&key).copied().unwrap_or(0));
        let record = self.given.entry(key).or_insert_with(|| Box::new(now));
        **record = now;
        &raw mut **record
    }

    /// Brings what was given of the current board up to date.
    fn update(&mut self, context: &Context) {
        let board = context.current_board();
        for (&key, record) in self.given.range_mut((board, 0)..=(board, u32::MAX)) {
            let data = self.data.get(&key).copied().unwrap_or(0);
            **record = MipMapInfo::new(context.mip_map(key.1), data);
        }
    }

    /// Forgets where the current board's mip maps came from.
    fn forget(&mut self, context: &Context) {
        let board = context.current_board();
        self.data.retain(|&(owner, _), _| owner != board);
    }
}

/// Executes a call that changes records.
fn change(value: Call) -> u32 {
    let result = call(value);
    let session = &mut *session();
    session.records.update(&session.context);
    result
}

/// Takes texture memory for a mip map; all ones where there is none.
#[unsafe(no_mangle)]
pub extern "C" fn guTexAllocateMemory(
    tmu: i32,
    even_odd: u8,
    width: i32,
    height: i32,
    format: i32,
    mip_map_mode: i32,
    small_lod: i32,
    large_lod: i32,
    aspect: i32,
    s_clamp: i32,
    t_clamp: i32,
    minify: i32,
    magnify: i32,
    lod_bias: f32,
    trilinear: i32,
) -> u32 {
    guard(u32::MAX, || {
        change(Call::GuTexAllocateMemory {
            tmu,
            even_odd,
            width,
            height,
            format,
            mip_map_mode,
            small_lod,
            large_lod,
            aspect,
            s_clamp,
            t_clamp,
            minify,
            magnify,
            lod_bias,
            trilinear,
        })
    })
}

/// Changes how a mip map is sampled; -1 keeps a field.
#[unsafe(no_mangle)]
pub extern "C" fn guTexChangeAttributes(
    id: u32,
    width: i32,
    height: i32,
    format: i32,
    mip_map_mode: i32,
    small_lod: i32,
    large_lod: i32,
    aspect: i32,
    s_clamp: i32,
    t_clamp: i32,
    minify: i32,
    magnify: i32,
) -> i32 {
    guard(0, || {
        change(Call::GuTexChangeAttributes {
            id,
            width,
            height,
            format,
            mip_map_mode,
            small_lod,
            large_lod,
            aspect,
            s_clamp,
            t_clamp,
            minify,
            magnify,
        }) as i32
    })
}

/// Stores all levels of a mip map.
///
/// # Safety
/// `source` is null or points to all levels, `table` is null or points to a
/// compression table.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn guTexDownloadMipMap(id: u32, source: *const u8, table: *const u8) {
    guard((), || {
        let size = ask(|context| context.mip_map(id).map_or(0, MipMap::all_bytes));
        if source.is_null() {
            return null("guTexDownloadMipMap");
        }
        // SAFETY: the caller's data holds all levels.
        let data = unsafe { bytes(source, size) }.into();
        // SAFETY: null, or a table by the caller's promise.
        let table = unsafe { read(table.cast::<[u8; NCC_TABLE_BYTES]>()) };
        if size > 0 {
            let session = &mut *session();
            let key = (session.context.current_board(), id);
            session.records.data.insert(key, source.addr());
        }
        change(Call::GuTexDownloadMipMap { id, data, table: table.map(|t| t[..].into()) });
    })
}

/// Stores one level and moves the source to the next.
///
/// # Safety
/// `source` is null or points to a pointer that is null or points to the
/// level.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn guTexDownloadMipMapLevel(id: u32, lod: i32, source: *mut *const u8) {
    guard((), || {
        // SAFETY: null, or a pointer by the caller's promise.
        let Some(from) = (unsafe { read(source.cast_const()) }).filter(|from| !from.is_null())
        else {
            return null("guTexDownloadMipMapLevel");
        };
        let size = ask(|context| context.mip_map(id).map_or(0, |m| m.level_bytes(lod)));
        // SAFETY: the caller's data holds the level.
        let data = unsafe { bytes(from, size) }.into();
        call(Call::GuTexDownloadMipMapLevel { id, lod, data });
        // SAFETY: it was read above.
        unsafe { write(source, from.wrapping_add(size)) }
    })
}

calls! {
    /// Makes a mip map current.
    guTexSource(id: u32) = Call::GuTexSource { id };
}

/// Forgets all mip maps.
#[unsafe(no_mangle)]
pub extern "C" fn guTexMemReset() {
    guard((), || {
        {
            let session = &mut *session();
            session.records.forget(&session.context);
        }
        change(Call::GuTexMemReset {});
    })
}

/// The mip map that a unit sourced last.
#[unsafe(no_mangle)]
pub extern "C" fn guTexGetCurrentMipMap(tmu: i32) -> u32 {
    guard(u32::MAX, || ask(|context| context.current_mip_map(tmu)))
}

/// The record of a mip map; null where there is none. What a program writes
/// there is not looked at.
#[unsafe(no_mangle)]
pub extern "C" fn guTexGetMipMapInfo(id: u32) -> *mut MipMapInfo {
    guard(std::ptr::null_mut(), || {
        let session = &mut *session();
        session.records.give(&session.context, id)
    })
}

/// Bytes of texture memory that the manager can still hand out.
#[unsafe(no_mangle)]
pub extern "C" fn guTexMemQueryAvail(tmu: i32) -> u32 {
    guard(0, || ask(|context| context.available_texture_memory(tmu)))
}

unsafe extern "C" {
    /// C's `malloc`: the program gives the memory back with `free`.
    fn malloc(size: usize) -> *mut u16;
}

/// A 565 mip map whose levels differ in colour, in memory of its own; null
/// where there is none.
#[unsafe(no_mangle)]
pub extern "C" fn guTexCreateColorMipMap() -> *mut u16 {
    guard(std::ptr::null_mut(), || {
        let texels = color_mip_map();
        // SAFETY: any size is allowed.
        let memory = unsafe { malloc(texels.len() * 2) };
        if !memory.is_null() {
            // SAFETY: both hold that many texels, and one of them is new.
            unsafe { std::ptr::copy_nonoverlapping(texels.as_ptr(), memory, texels.len()) }
        }
        memory
    })
}
