//! Links `libredline` with `libverite`, which lies beside it.

use std::path::PathBuf;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let out = PathBuf::from(std::env::var_os("OUT_DIR").expect("Cargo sets it"));
    // OUT_DIR is PROFILE/build/NAME/out; libraries are made in PROFILE/deps.
    let profile = out.ancestors().nth(3).expect("a folder of build outputs");
    let deps = profile.join("deps");
    println!("cargo::rustc-cdylib-link-arg=-L{}", deps.display());
    println!("cargo::rustc-cdylib-link-arg=-lverite");
    if cfg!(target_os = "linux") {
        println!("cargo::rustc-cdylib-link-arg=-Wl,-rpath,$ORIGIN");
        println!("cargo::rustc-cdylib-link-arg=-Wl,--no-undefined");
    }
}
