//! RRedline as a program meets it: its headers, its two libraries, the programs
//! that check it, and its examples on both chips.

mod interface;
mod model;
mod programs;
mod scenes;

use std::path::{Path, PathBuf};
use std::process::Command;

use fillrate_player::{Frame, compare, difference_image};

use super::{library_folder, root, run};

/// The chips by name.
const CHIPS: [&str; 2] = ["v1000", "v2000"];

/// Compiles a program against the headers and libraries of this build.
fn compile(file: &Path, folder: &Path) -> PathBuf {
    let program = folder.join(file.file_stem().expect("a name"));
    // Contracted arithmetic would give other coordinates elsewhere.
    run(Command::new("cc")
        .args(["-std=c99", "-O1", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror"])
        .args(["-pedantic", "-I"])
        .arg(root().join("include"))
        .arg(file)
        .arg("-o")
        .arg(&program)
        .arg("-L")
        .arg(library_folder())
        .args(["-lredline", "-lverite", "-lm"]));
    program
}

/// What a program showed, as files, and what it printed.
struct Ran {
    pictures: Vec<PathBuf>,
    hashes: Vec<String>,
    printed: String,
}

/// Runs a program on a chip; its frames and its recording are in `folder`.
fn draw(program: &Path, chip: &str, arguments: &[&str], folder: &Path) -> Ran {
    std::fs::create_dir_all(folder).expect("a folder for frames");
    let mut command = Command::new(program);
    for (name, _) in std::env::vars().filter(|(name, _)| name.starts_with("FILLRATE_")) {
        command.env_remove(name);
    }
    command
        .args(arguments)
        .env("LD_LIBRARY_PATH", library_folder())
        .env("DYLD_LIBRARY_PATH", library_folder())
        .env("FILLRATE_VERITE_CHIP", chip)
        .env("FILLRATE_CAPTURE", folder)
        .env("FILLRATE_TRACE", folder.join("trace"));
    let output = command.output().expect("the program starts");
    let printed = String::from_utf8_lossy(&output.stdout).into_owned();
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{} on {chip}:\n{printed}{told}", program.display());
    let log = std::fs::read_to_string(folder.join("frames.jsonl")).expect("a log");
    let hash = |line: &str| {
        let note: serde_json::Value = serde_json::from_str(line).expect("a line of JSON");
        note["hash"].as_str().expect("a hash").to_string()
    };
    let hashes: Vec<String> = log.lines().map(hash).collect();
    let pictures = (0..hashes.len()).map(|i| folder.join(format!("frame_{i:05}.png"))).collect();
    Ran { pictures, hashes, printed }
}

fn load(path: &Path) -> Frame {
    Frame::load_png(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Compares a picture with the kept one; where they differ, all three are
/// written. `BLESS=1` keeps the present one.
fn check(name: &str, drawn: &Path) -> Result<(), String> {
    let kept = root().join("tests/golden/redline").join(format!("{name}.png"));
    if std::env::var_os("BLESS").is_some() {
        let folder = kept.parent().expect("a folder");
        std::fs::create_dir_all(folder).map_err(|error| error.to_string())?;
        std::fs::copy(drawn, &kept).map_err(|error| error.to_string())?;
    }
    let (actual, expected) = (load(drawn), load(&kept));
    let comparison = compare(&expected, &actual);
    if comparison.is_same() {
        return Ok(());
    }
    let folder = root().join("target/golden-failures/redline");
    std::fs::create_dir_all(&folder).map_err(|error| error.to_string())?;
    let save = |kind: &str, frame: &Frame| {
        let file = folder.join(format!("{name}.{kind}.png"));
        frame.save_png(&file).map_err(|error| error.to_string())
    };
    save("actual", &actual)?;
    save("expected", &expected)?;
    if let Ok(difference) = difference_image(&expected, &actual) {
        save("difference", &difference)?;
    }
    Err(format!("{name}: {comparison:?}; see {}", folder.display()))
}
