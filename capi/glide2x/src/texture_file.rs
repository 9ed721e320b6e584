//! `.3df` files and coded sprites.

use std::ffi::{c_char, c_void};
use std::fs::File;
use std::io::Read;

use fillrate_glide::Call;
use fillrate_glide::gu::{File3df, Header3df, MAX_3DF_FILE, MAX_3DF_HEADER, Sprite, Table3df};
use fillrate_guard::{bytes, guard, read, text, write};

use crate::session::{call, null};

/// `Gu3dfHeader`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Header {
    width: u32,
    height: u32,
    small_lod: i32,
    large_lod: i32,
    aspect: i32,
    format: i32,
}

/// `Gu3dfInfo`.
#[repr(C)]
pub struct Info {
    header: Header,
    table: [u32; 256],
    data: *mut c_void,
    mem_required: u32,
}

impl Header {
    fn new(header: &Header3df) -> Header {
        let (width, height) = header.size();
        let info = &header.info;
        Header {
            width,
            height,
            small_lod: info.small_lod,
            large_lod: info.large_lod,
            aspect: info.aspect,
            format: info.format,
        }
    }
}

#[cfg(unix)]
fn path(name: &[u8]) -> &std::path::Path {
    use std::os::unix::ffi::OsStrExt;
    std::path::Path::new(std::ffi::OsStr::from_bytes(name))
}

#[cfg(not(unix))]
fn path(name: &[u8]) -> std::path::PathBuf {
    String::from_utf8_lossy(name).into_owned().into()
}

/// The first bytes of a file; `None` where there is no such file.
///
/// # Safety
/// `name` is null or a text that ends.
unsafe fn start_of_file(name: *const c_char, most: usize) -> Option<Vec<u8>> {
    // SAFETY: the caller's promise.
    let name = unsafe { text(name) }?;
    let file = File::open(path(name)).ok()?;
    // A pipe or device could keep us waiting.
    if !file.metadata().ok()?.is_file() {
        return None;
    }
    let mut start = Vec::new();
    file.take(most as u64).read_to_end(&mut start).ok()?;
    Some(start)
}

/// Reads what a `.3df` file says of its texture.
///
/// # Safety
/// `name` is null or a text that ends, `info` is null or points to a
/// `Gu3dfInfo`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gu3dfGetInfo(name: *const c_char, info: *mut Info) -> i32 {
    guard(0, || {
        if info.is_null() {
            null("gu3dfGetInfo");
            return 0;
        }
        // SAFETY: the caller's text.
        let start = unsafe { start_of_file(name, MAX_3DF_HEADER) }.unwrap_or_default();
        let Ok(header) = Header3df::parse(&start) else { return 0 };
        // SAFETY: not null, so an info by the caller's promise.
        unsafe {
            write(&raw mut (*info).header, Header::new(&header));
            write(&raw mut (*info).mem_required, header.texel_bytes() as u32);
        }
        1
    })
}

/// Reads the texture of a `.3df` file into the memory that `info` names. The
/// header there must be that of the file, as `gu3dfGetInfo` filled it in.
///
/// # Safety
/// `name` is null or a text that ends, `info` is null or points to a
/// `Gu3dfInfo` whose data is null or has room for `mem_required` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gu3dfLoad(name: *const c_char, info: *mut Info) -> i32 {
    guard(0, || {
        if info.is_null() {
            null("gu3dfLoad");
            return 0;
        }
        // SAFETY: the caller's text.
        let whole = unsafe { start_of_file(name, MAX_3DF_FILE) }.unwrap_or_default();
        let (Ok(header), Ok(file)) = (Header3df::parse(&whole), File3df::parse(&whole)) else {
            return 0;
        };
        // SAFETY: not null, so an info by the caller's promise.
        let (asked, data, room) = unsafe {
            let asked = (&raw const (*info).header).read_unaligned();
            let data = (&raw const (*info).data).read_unaligned();
            (asked, data, (&raw const (*info).mem_required).read_unaligned())
        };
        let fits = file.texels.len() <= room as usize && asked == Header::new(&header);
        if data.is_null() || !fits {
            return 0;
        }
        // SAFETY: the caller's memory has room for as much.
        unsafe {
            std::ptr::copy_nonoverlapping(file.texels.as_ptr(), data.cast(), file.texels.len());
            store_table(&file.table, (&raw mut (*info).table).cast());
        }
        1
    })
}

/// Stores a table as `GuTexTable`.
///
/// # Safety
/// `to` has room for 1024 bytes.
unsafe fn store_table(table: &Table3df, to: *mut u8) {
    let stored: Vec<u8> = match table {
        Table3df::None => Vec::new(),
        Table3df::Palette(colors) => colors.iter().flat_map(|c| c.to_ne_bytes()).collect(),
        Table3df::Ncc(ncc) => {
            let numbers = ncc.i.iter().chain(&ncc.q).flatten().flat_map(|n| n.to_ne_bytes());
            let words = ncc.packed();
            let words = words.iter().flat_map(|word| word.to_ne_bytes());
            ncc.y.into_iter().chain(numbers).chain(words).collect()
        }
    };
    // SAFETY: at most 256 words.
    unsafe { std::ptr::copy_nonoverlapping(stored.as_ptr(), to, stored.len().min(1024)) }
}

/// Decodes a sprite into a texture level.
///
/// # Safety
/// `sprite` is null or points to a sprite with `rows` row lengths, `table` is
/// null or points to 256 texels.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ConvertAndDownloadRle(
    tmu: i32,
    start: u32,
    this_lod: i32,
    large_lod: i32,
    aspect: i32,
    format: i32,
    even_odd: u32,
    sprite: *const u8,
    rows: i32,
    u0: u32,
    v0: u32,
    width: u32,
    height: u32,
    dest_width: u32,
    dest_height: u32,
    table: *const [u16; 256],
) {
    guard((), || {
        // SAFETY: null, or a table by the caller's promise.
        let table = unsafe { read(table) };
        let (Some(table), false, 0..=0xffff) = (table, sprite.is_null(), rows) else {
            return null("ConvertAndDownloadRle");
        };
        // SAFETY: the caller's sprite has so many row lengths.
        let head = unsafe { bytes(sprite, Sprite::lengths_at() + rows as usize) };
        let size = Sprite::size(&head[Sprite::lengths_at()..]);
        // SAFETY: the row lengths say how long the rows are.
        let sprite = unsafe { bytes(sprite, size) }.into();
        let table = table.to_vec();
        call(Call::ConvertAndDownloadRle {
            tmu,
            start,
            this_lod,
            large_lod,
            aspect,
            format,
            even_odd,
            sprite,
            rows,
            u0,
            v0,
            width,
            height,
            dest_width,
            dest_height,
            table,
        });
    })
}
