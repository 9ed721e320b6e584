//! Finding our drop-in libraries.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

/// The file name of a library on this system.
pub fn file_name(library: &str) -> String {
    if cfg!(target_os = "macos") {
        format!("lib{library}.dylib")
    } else if cfg!(windows) {
        format!("{library}.dll")
    } else {
        format!("lib{library}.so")
    }
}

/// The Glide 2.x library.
pub const GLIDE2X: &str = "glide2x";
/// The client interface of the Raw pipeline.
pub const RENDER_CLIENT: &str = "render_client";
/// Quark 3D.
pub const QUARK3D: &str = "quark3d";
/// QuickDraw 3D RAVE.
pub const RAVE: &str = "rave";
/// RRedline's upper layer, which needs [`VERITE`].
pub const REDLINE: &str = "redline";
/// RRedline's lower layer.
pub const VERITE: &str = "verite";
/// Every drop-in library.
pub const LIBRARIES: [&str; 6] = [GLIDE2X, RENDER_CLIENT, QUARK3D, RAVE, REDLINE, VERITE];

/// Libraries that programs link besides one of these.
pub fn also(library: &str) -> &'static [&'static str] {
    if library == REDLINE { &[VERITE] } else { &[] }
}

/// The variable that makes the dynamic linker look into our folder first.
pub const SEARCH_PATH: &str =
    if cfg!(target_os = "macos") { "DYLD_LIBRARY_PATH" } else { "LD_LIBRARY_PATH" };

/// Where libraries are looked for, in order: `FILLRATE_LIB_DIR`, beside the
/// program, the build folder's `deps`, and an installation's `lib/fillrate`.
pub fn candidates() -> Vec<PathBuf> {
    let mut folders: Vec<PathBuf> =
        std::env::var_os("FILLRATE_LIB_DIR").map(PathBuf::from).into_iter().collect();
    if let Some(program) = std::env::current_exe().ok().as_deref().and_then(Path::parent) {
        folders.push(program.to_path_buf());
        folders.push(program.join("deps"));
        folders.push(program.join("../lib/fillrate"));
    }
    folders
}

/// The folder that holds a library: the one that was asked for, else the one with the newest, since
/// a build may renew only one of several copies.
pub fn folder_of(library: &str) -> Option<PathBuf> {
    let file = file_name(library);
    let holds = |folder: &PathBuf| folder.join(&file).is_file();
    if let Some(asked) = std::env::var_os("FILLRATE_LIB_DIR").map(PathBuf::from).filter(holds) {
        return Some(asked);
    }
    let age = |folder: &PathBuf| folder.join(&file).metadata().and_then(|m| m.modified()).ok();
    candidates().into_iter().filter(holds).max_by_key(age)
}

/// The first folder that holds any of our libraries.
pub fn folder() -> Option<PathBuf> {
    LIBRARIES.into_iter().find_map(folder_of)
}

/// The folder of a library, as an error where there is none.
pub fn need(library: &str) -> Result<PathBuf> {
    folder_of(library).with_context(|| not_found(&format!("no {}", file_name(library))))
}

/// The first folder that holds any of our libraries, as an error where there is none.
pub fn need_any() -> Result<PathBuf> {
    folder().with_context(|| not_found("no library of ours"))
}

fn not_found(what: &str) -> String {
    let tried: Vec<String> =
        candidates().iter().map(|folder| folder.display().to_string()).collect();
    format!(
        "{what} was found; looked in {} (build the libraries with: cargo build --release, or set \
         FILLRATE_LIB_DIR)",
        tried.join(", ")
    )
}

/// The search path with `folder` first.
pub fn search_path(folder: &Path) -> Result<std::ffi::OsString> {
    let old = std::env::var_os(SEARCH_PATH).unwrap_or_default();
    let rest = std::env::split_paths(&old).filter(|p| !p.as_os_str().is_empty());
    Ok(std::env::join_paths(std::iter::once(folder.to_path_buf()).chain(rest))?)
}
