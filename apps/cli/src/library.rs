//! Finding our drop-in libraries.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

/// File name of the Glide 2.x library on this system.
pub const GLIDE2X: &str = if cfg!(target_os = "macos") {
    "libglide2x.dylib"
} else if cfg!(windows) {
    "glide2x.dll"
} else {
    "libglide2x.so"
};

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

/// The folder that holds a library.
pub fn folder_of(library: &str) -> Option<PathBuf> {
    candidates().into_iter().find(|folder| folder.join(library).is_file())
}

/// The folder of the Glide library, as an error where there is none.
pub fn glide_folder() -> Result<PathBuf> {
    folder_of(GLIDE2X).with_context(|| {
        let tried: Vec<String> =
            candidates().iter().map(|folder| folder.display().to_string()).collect();
        format!(
            "{GLIDE2X} was not found; looked in {} (build it with: cargo build --release -p \
             fillrate-glide2x, or set FILLRATE_LIB_DIR)",
            tried.join(", ")
        )
    })
}

/// The search path with `folder` first.
pub fn search_path(folder: &Path) -> Result<std::ffi::OsString> {
    let old = std::env::var_os(SEARCH_PATH).unwrap_or_default();
    let rest = std::env::split_paths(&old).filter(|p| !p.as_os_str().is_empty());
    Ok(std::env::join_paths(std::iter::once(folder.to_path_buf()).chain(rest))?)
}
