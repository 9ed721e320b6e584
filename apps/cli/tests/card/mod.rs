//! The boards as a C program sees them, and the settings that reach it.

mod rules;

use std::path::PathBuf;
use std::process::Command;

use super::{fillrate, library_folder, root, run};

/// A C test program, linked with the library.
fn compiled(folder: &tempfile::TempDir, name: &str) -> PathBuf {
    let program = folder.path().join(name);
    run(Command::new("cc")
        .args(["-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", "-I"])
        .arg(root().join("include"))
        .arg(root().join(format!("tests/c/{name}.c")))
        .arg("-o")
        .arg(&program)
        .arg("-L")
        .arg(library_folder())
        .args(["-lglide2x", "-lm"]));
    program
}

#[test]
fn boards_clock_and_counters() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let program = compiled(&folder, "hardware");
    let frames = folder.path().join("frames");
    let output = run(fillrate()
        .args(["run", "--json", "--boards", "2", "--out"])
        .arg(&frames)
        .arg("--")
        .arg(&program));
    let text = String::from_utf8_lossy(&output.stdout);
    let notes: Vec<serde_json::Value> =
        text.lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
    // Frames of both boards, in the order in which they were shown.
    let first: Vec<_> =
        notes[..4].iter().map(|n| (n["board"].as_u64(), n["width"].as_u64())).collect();
    let (one, two) = ((Some(0), Some(320)), (Some(1), Some(512)));
    assert_eq!(first, [one, two, one, two]);
    assert_eq!(notes[1]["pixels"].as_u64(), notes[0]["pixels"].as_u64());
    for name in ["frame_00000.png", "frame_00001_board1.png", "frame_00002.png"] {
        assert!(frames.join(name).is_file(), "{name}");
    }
}

/// The file, a variable over it, and an option over both.
#[test]
fn settings_reach_the_library_in_their_order() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let program = compiled(&folder, "hardware");
    let file = folder.path().join("settings.toml");
    std::fs::write(&file, "[board]\nboards = 3\n[output]\ngamma = true\n").expect("a file");
    let fillrate_run = |configure: fn(&mut Command)| {
        let mut command = fillrate();
        command.args(["run", "--config"]).arg(&file);
        configure(&mut command);
        command.arg("--").arg(&program).output().expect("the program starts").status.code()
    };
    // The program wants two boards, no more and no less.
    assert_eq!(fillrate_run(|_| {}), Some(3));
    let variable = |c: &mut Command| {
        c.env("FILLRATE_BOARDS", "2");
    };
    assert_eq!(fillrate_run(variable), Some(0));
    let both = |c: &mut Command| {
        c.env("FILLRATE_BOARDS", "1").args(["--boards", "2"]);
    };
    assert_eq!(fillrate_run(both), Some(0));
}

/// A recording of a board from a file is drawn again on that board.
#[test]
fn recordings_keep_their_board() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let program = compiled(&folder, "hardware");
    let (file, trace) = (folder.path().join("settings.toml"), folder.path().join("trace"));
    let card = "[board]\ncard = \"own\"\nboards = 2\n[cards.own]\nframe_buffer = 2\nunits = 3\ntexture = 1\n";
    std::fs::write(&file, card).expect("a file");
    run(fillrate()
        .args(["run", "--config"])
        .arg(&file)
        .arg("--trace")
        .arg(&trace)
        .arg("--")
        .arg(&program));
    let output = run(fillrate().args(["replay", "--json"]).arg(&trace));
    assert!(String::from_utf8_lossy(&output.stdout).lines().count() > 100);
}
