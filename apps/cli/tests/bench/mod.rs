//! `fillrate bench`: pictures are checked, and figures compared.

use std::collections::BTreeMap;

use crate::{fillrate, root, run};

/// Digest of every workload's picture at a size, as drawn now.
fn drawn(size: &str) -> BTreeMap<String, String> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let none = folder.path().join("none.json");
    std::fs::write(&none, "{}").expect("a file");
    let mut command = fillrate();
    command.args(["bench", "--check", "--threads", "2", "--size", size, "--digests"]).arg(&none);
    let output = run(&mut command);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let lines = text.lines().filter_map(|line| line.split_once(' '));
    lines.map(|(name, digest)| (name.to_string(), digest.trim().to_string())).collect()
}

/// Digests are the kept ones, on a board and beyond; the bench itself compares
/// each picture with the scalar level's on one thread. `BLESS=1` keeps the
/// present ones.
#[test]
fn pictures_are_as_they_were() {
    let file = root().join("tests/golden/bench.json");
    let sizes = ["640x480", "800x600", "1920x1080"];
    let drawn: BTreeMap<_, _> = sizes.into_iter().map(|s| (s.to_string(), drawn(s))).collect();
    let counts = drawn.values().map(BTreeMap::len).collect::<Vec<_>>();
    // Quark 3D, RRedline and RAVE are measured where boards show the size, to compare with Glide.
    assert_eq!(counts, [13, 37, 37], "{drawn:?}");
    if std::env::var_os("BLESS").is_some() {
        let text = serde_json::to_string_pretty(&drawn).expect("digests are text");
        std::fs::write(&file, text + "\n").expect("the golden file can be written");
    }
    let kept = std::fs::read_to_string(&file).expect("the golden file exists");
    let kept: BTreeMap<String, BTreeMap<String, String>> =
        serde_json::from_str(&kept).expect("it is JSON");
    assert_eq!(drawn, kept);
}

/// A wrong digest ends the bench before anything is timed, with exit code 1.
#[test]
fn wrong_pictures_are_told() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("digests.json");
    let text = r#"{"640x480": {"W8_clear": "0123456789abcdef"}}"#;
    std::fs::write(&file, text).expect("a file");
    let mut command = fillrate();
    command.args(["bench", "--only", "W8_clear", "--json", "--digests"]).arg(&file);
    let output = command.output().expect("the program starts");
    assert_eq!(output.status.code(), Some(1));
    assert!(output.stdout.is_empty());
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(error.contains("W8_clear at 640x480"), "{error}");
    assert!(error.contains("expected 0123456789abcdef"), "{error}");
}

/// Our figures stand beside others' of the same size and format.
#[test]
fn figures_are_compared() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let csv = folder.path().join("peers.csv");
    let lines = "\
peer,workload,res,format,ms_frame,Mpix_med,Mpix_min,Mpix_max,Mtri_med,Mtri_min,Mtri_max,frames_s,checksum
slow,W8_clear,640x480,565,1.0,10.0,9.0,11.0,0.1,0.1,0.1,1.0,00000000
fast,W8_clear,640x480,565,1.0,20.0,19.0,21.0,0.1,0.1,0.1,1.0,00000000
other,W8_clear,640x480,8888,1.0,90.0,89.0,91.0,0.1,0.1,0.1,1.0,00000000
";
    std::fs::write(&csv, lines).expect("a file");
    let measured = folder.path().join("ours.jsonl");
    let output = run(fillrate().args(["bench", "--only", "W8_clear", "--runs", "1", "--json"]));
    std::fs::write(&measured, output.stdout).expect("a file");
    let mut command = fillrate();
    command.args(["bench", "--vs"]).arg(&csv).arg("--measured").arg(&measured);
    let output = run(&mut command);
    let table = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(table.starts_with("| workload | unit | fillrate | fast | slow | x best |"), "{table}");
    assert!(table.contains("| 20.0 (19.0-21.0) | 10.0 (9.00-11.0) |"), "{table}");

    let mut wrong = fillrate();
    wrong.args(["bench", "--vs"]).arg(root().join("Cargo.toml"));
    assert_eq!(wrong.output().expect("the program starts").status.code(), Some(3));
}
