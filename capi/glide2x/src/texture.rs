//! Textures.

use std::ffi::c_void;

use fillrate_glide::texture::layout;
use fillrate_glide::{Call, TextureInfo};
use fillrate_guard::{bytes, guard, read};

use crate::library::calls;
use crate::session::{ask, call, call_as, null};

/// `GrTexInfo`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct TexInfo {
    small_lod: i32,
    large_lod: i32,
    aspect: i32,
    format: i32,
    data: *const u8,
}

impl TexInfo {
    fn info(&self) -> TextureInfo {
        TextureInfo {
            small_lod: self.small_lod,
            large_lod: self.large_lod,
            aspect: self.aspect,
            format: self.format,
        }
    }
}

calls! {
    /// Chooses a compression table.
    grTexNCCTable(tmu: i32, table: i32) = Call::GrTexNccTable { tmu, table };
    /// Sets clamping.
    grTexClampMode(tmu: i32, s: i32, t: i32) = Call::GrTexClampMode { tmu, s, t };
    /// Sets a texture combine unit.
    grTexCombine(
        tmu: i32, rgb_function: i32, rgb_factor: i32, alpha_function: i32, alpha_factor: i32,
        rgb_invert: i32, alpha_invert: i32
    ) = Call::GrTexCombine {
        tmu, rgb_function, rgb_factor, alpha_function, alpha_factor, rgb_invert, alpha_invert
    };
    /// Sets a texture combine unit by a preset.
    grTexCombineFunction(tmu: i32, function: i32) = Call::GrTexCombineFunction { tmu, function };
    /// Sets the detail factor.
    grTexDetailControl(tmu: i32, lod_bias: i32, scale: u8, max: f32) =
        Call::GrTexDetailControl { tmu, lod_bias, scale, max };
    /// Sets the filters.
    grTexFilterMode(tmu: i32, minify: i32, magnify: i32) =
        Call::GrTexFilterMode { tmu, minify, magnify };
    /// Sets the level bias.
    grTexLodBiasValue(tmu: i32, bias: f32) = Call::GrTexLodBiasValue { tmu, bias };
    /// Sets mip mapping.
    grTexMipMapMode(tmu: i32, mode: i32, blend: i32) = Call::GrTexMipMapMode { tmu, mode, blend };
    /// Switches several base addresses.
    grTexMultibase(tmu: i32, enable: i32) = Call::GrTexMultibase { tmu, enable };
}

/// Sets a texture combine unit by a preset.
#[unsafe(no_mangle)]
pub extern "C" fn guTexCombineFunction(tmu: i32, function: i32) {
    guard((), || {
        call_as("guTexCombineFunction", Call::GrTexCombineFunction { tmu, function });
    })
}

/// The lowest address of texture memory.
#[unsafe(no_mangle)]
pub extern "C" fn grTexMinAddress(_tmu: i32) -> u32 {
    0
}

/// The highest address at which the smallest texture fits.
#[unsafe(no_mangle)]
pub extern "C" fn grTexMaxAddress(tmu: i32) -> u32 {
    guard(0, || ask(|context| context.texture_memory(tmu)).saturating_sub(8))
}

fn memory_required(info: &TextureInfo, even_odd: u32) -> u32 {
    if !info.is_valid() {
        return 0;
    }
    let (small, large) = (info.small_lod as u32, info.large_lod as u32);
    layout::chain_bytes(small, large, info.aspect, info.format, even_odd)
}

/// Bytes that a texture takes; 0 for one that cannot be.
#[unsafe(no_mangle)]
pub extern "C" fn grTexCalcMemRequired(small: i32, large: i32, aspect: i32, format: i32) -> u32 {
    memory_required(&TextureInfo { small_lod: small, large_lod: large, aspect, format }, 3)
}

/// Bytes that the even, odd or all levels of a texture take.
///
/// # Safety
/// `info` is null or points to a `GrTexInfo`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grTexTextureMemRequired(even_odd: u32, info: *const TexInfo) -> u32 {
    guard(0, || {
        // SAFETY: the caller's promise.
        let Some(info) = (unsafe { read(info) }) else {
            null("grTexTextureMemRequired");
            return 0;
        };
        memory_required(&info.info(), even_odd)
    })
}

/// Points a unit at a texture.
///
/// # Safety
/// `info` is null or points to a `GrTexInfo`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grTexSource(tmu: i32, start: u32, even_odd: u32, info: *const TexInfo) {
    guard((), || {
        // SAFETY: the caller's promise.
        let Some(TexInfo { small_lod, large_lod, aspect, format, .. }) = (unsafe { read(info) })
        else {
            return null("grTexSource");
        };
        call(Call::GrTexSource { tmu, start, even_odd, small_lod, large_lod, aspect, format });
    })
}

/// Bytes of a level as a program stores it; 0 for one that cannot be.
fn host_bytes(info: &TextureInfo, lod: i32) -> usize {
    if !info.is_valid() || !(0..=8).contains(&lod) {
        return 0;
    }
    let (width, height) = layout::size(info.aspect, lod as u32);
    (width * height * layout::texel_bytes(info.format)) as usize
}

/// Stores all levels of a texture.
///
/// # Safety
/// `info` is null or points to a `GrTexInfo` whose data is null or holds all
/// of its levels.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grTexDownloadMipMap(
    tmu: i32,
    start: u32,
    even_odd: u32,
    info: *const TexInfo,
) {
    guard((), || {
        // SAFETY: the caller's promise.
        let Some(own) = (unsafe { read(info) }) else { return null("grTexDownloadMipMap") };
        let TexInfo { small_lod, large_lod, aspect, format, data } = own;
        if data.is_null() {
            return null("grTexDownloadMipMap");
        }
        let info = own.info();
        let size = (large_lod..=small_lod.min(8)).map(|lod| host_bytes(&info, lod)).sum();
        // SAFETY: the caller's data holds all levels.
        let data = unsafe { bytes(data, size) }.into();
        call(Call::GrTexDownloadMipMap {
            tmu,
            start,
            even_odd,
            small_lod,
            large_lod,
            aspect,
            format,
            data,
        });
    })
}

/// Stores one level.
///
/// # Safety
/// `data` is null or points to the whole level.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grTexDownloadMipMapLevel(
    tmu: i32,
    start: u32,
    this_lod: i32,
    large_lod: i32,
    aspect: i32,
    format: i32,
    even_odd: u32,
    data: *const u8,
) {
    let last = layout::size(aspect, this_lod.clamp(0, 8) as u32).1 as i32 - 1;
    let level = Level { tmu, start, this_lod, large_lod, aspect, format, even_odd };
    // SAFETY: all rows are the whole level.
    guard((), || unsafe { level.download("grTexDownloadMipMapLevel", data, 0, last) })
}

/// A level, and where its texture is.
struct Level {
    tmu: i32,
    start: u32,
    this_lod: i32,
    large_lod: i32,
    aspect: i32,
    format: i32,
    even_odd: u32,
}

impl Level {
    /// Stores rows `first..=last`, for the function of that name.
    ///
    /// # Safety
    /// `data` is null or points to those rows.
    unsafe fn download(self, function: &str, data: *const u8, first: i32, last: i32) {
        if data.is_null() {
            return null(function);
        }
        let Level { tmu, start, this_lod, large_lod, aspect, format, even_odd } = self;
        let info = TextureInfo { small_lod: this_lod, large_lod, aspect, format };
        let (_, height) = layout::size(aspect, this_lod.clamp(0, 8) as u32);
        let rows = if first >= 0 && first <= last && last < height as i32 {
            (last - first + 1) as usize
        } else {
            0
        };
        let size = host_bytes(&info, this_lod) / height as usize * rows;
        // SAFETY: the caller's data holds the rows.
        let data = unsafe { bytes(data, size) }.into();
        let download = Call::GrTexDownloadMipMapLevelPartial {
            tmu,
            start,
            this_lod,
            large_lod,
            aspect,
            format,
            even_odd,
            data,
            first,
            last,
        };
        call_as(function, download);
    }
}

/// Stores rows `first..=last` of a level.
///
/// # Safety
/// `data` is null or points to those rows.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grTexDownloadMipMapLevelPartial(
    tmu: i32,
    start: u32,
    this_lod: i32,
    large_lod: i32,
    aspect: i32,
    format: i32,
    even_odd: u32,
    data: *const u8,
    first: i32,
    last: i32,
) {
    let level = Level { tmu, start, this_lod, large_lod, aspect, format, even_odd };
    // SAFETY: the caller's promise.
    guard((), || unsafe { level.download("grTexDownloadMipMapLevelPartial", data, first, last) })
}

/// Stores a palette or a compression table.
///
/// # Safety
/// `data` is null or points to a whole table of that type.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grTexDownloadTable(tmu: i32, table: i32, data: *const c_void) {
    let last = if table == 2 { 255 } else { 11 };
    // SAFETY: the whole table.
    guard((), || unsafe { download_table("grTexDownloadTable", tmu, table, data, (0, last)) })
}

/// Offset of the packed words in a compression table.
const PACKED: usize = 64;

/// Stores entries `first..=last` of a palette, or a whole compression table.
///
/// # Safety
/// `data` is null or points to a whole table of that type.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grTexDownloadTablePartial(
    tmu: i32,
    table: i32,
    data: *const c_void,
    first: i32,
    last: i32,
) {
    // SAFETY: the caller's promise.
    guard((), || unsafe {
        download_table("grTexDownloadTablePartial", tmu, table, data, (first, last));
    })
}

/// Stores entries of a table, for the function of that name.
///
/// # Safety
/// `data` is null or points to a whole table of that type.
unsafe fn download_table(
    function: &str,
    tmu: i32,
    table: i32,
    data: *const c_void,
    (first, last): (i32, i32),
) {
    let (count, offset) = if table == 2 { (256, 0) } else { (12, PACKED) };
    if data.is_null() {
        return null(function);
    }
    if first < 0 || first > last || last >= count {
        // Past the end, where nothing is stored: for the rules to see.
        let (first, words) = (count as u32, vec![0]);
        call_as(function, Call::GrTexDownloadTable { tmu, table, first, words });
        return;
    }
    let words = data.cast::<u8>().wrapping_add(offset).cast::<u32>();
    // SAFETY: inside the caller's table.
    let word = |i: i32| unsafe { words.add(i as usize).read_unaligned() };
    let words = (first..=last).map(word).collect();
    call_as(function, Call::GrTexDownloadTable { tmu, table, first: first as u32, words });
}

/// Sets one of several base addresses.
///
/// # Safety
/// `info` is null or points to a `GrTexInfo`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grTexMultibaseAddress(
    tmu: i32,
    range: i32,
    start: u32,
    even_odd: u32,
    info: *const TexInfo,
) {
    guard((), || {
        // SAFETY: the caller's promise.
        let Some(TexInfo { small_lod, large_lod, aspect, format, .. }) = (unsafe { read(info) })
        else {
            return null("grTexMultibaseAddress");
        };
        call(Call::GrTexMultibaseAddress {
            tmu,
            range,
            start,
            even_odd,
            small_lod,
            large_lod,
            aspect,
            format,
        });
    })
}
