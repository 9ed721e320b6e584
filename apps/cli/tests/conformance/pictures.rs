//! The pictures of the conformance programs, and that recordings replay them.

use std::collections::BTreeMap;
use std::path::Path;

use fillrate_player::{Frame, compare, difference_image};

use super::super::{fillrate, root, run};
use super::{Program, conformance_programs};

/// Hash of every frame of a program, in order.
type Hashes = Vec<String>;

/// Runs a program, records it, and returns its frames' hashes.
fn draw(program: &Program, folder: &Path) -> Hashes {
    let mut command = program.command(folder);
    command.env("FILLRATE_CAPTURE", folder).env("FILLRATE_TRACE", folder.join("trace"));
    run(&mut command);
    let log = std::fs::read_to_string(folder.join("frames.jsonl")).expect("a log");
    log.lines()
        .map(|line| {
            let note: serde_json::Value = serde_json::from_str(line).expect("a line of JSON");
            note["hash"].as_str().expect("a hash").to_string()
        })
        .collect()
}

/// Compares a picture with the kept one; where they differ, both and their
/// difference are written.
fn check_picture(name: &str, drawn: &Path, kept: &Path) -> Result<(), String> {
    let load = |path: &Path| Frame::load_png(path).map_err(|e| format!("{}: {e}", path.display()));
    let (actual, expected) = (load(drawn)?, load(kept)?);
    let comparison = compare(&expected, &actual);
    if comparison.is_same() {
        return Ok(());
    }
    let folder = root().join("target/golden-failures/conformance");
    std::fs::create_dir_all(&folder).map_err(|e| e.to_string())?;
    let save = |kind: &str, frame: &Frame| {
        frame.save_png(&folder.join(format!("{name}.{kind}.png"))).map_err(|e| e.to_string())
    };
    save("actual", &actual)?;
    save("expected", &expected)?;
    if let Ok(difference) = difference_image(&expected, &actual) {
        save("difference", &difference)?;
    }
    Err(format!("{name}: {comparison:?}; see {}", folder.display()))
}

/// Every program's checks hold, its pictures are the kept ones, and its
/// recording replays to the same frames. `BLESS=1` keeps the present ones.
#[test]
fn programs_draw_what_they_drew() {
    let (golden, pictures) =
        (root().join("tests/golden/conformance.json"), root().join("tests/golden/conformance"));
    let bless = std::env::var_os("BLESS").is_some();
    let mut drawn: BTreeMap<String, Hashes> = BTreeMap::new();
    let mut problems = Vec::new();
    for program in conformance_programs() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let hashes = draw(program, folder.path());
        assert!(!hashes.is_empty(), "{} shows nothing", program.name);
        run(fillrate().arg("replay").arg(folder.path().join("trace")));
        let last = folder.path().join(format!("frame_{:05}.png", hashes.len() - 1));
        let kept = pictures.join(format!("{}.png", program.name));
        if bless {
            std::fs::create_dir_all(&pictures).expect("the folder can be made");
            std::fs::copy(&last, &kept).expect("the picture can be kept");
        }
        problems.extend(check_picture(&program.name, &last, &kept).err());
        drawn.insert(program.name.clone(), hashes);
    }
    assert!(drawn.len() >= 30, "{} programs", drawn.len());
    if bless {
        let text = serde_json::to_string_pretty(&drawn).expect("hashes are text");
        std::fs::write(&golden, text + "\n").expect("the golden file can be written");
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    let kept = std::fs::read_to_string(&golden).expect("the golden file exists");
    let kept: BTreeMap<String, Hashes> = serde_json::from_str(&kept).expect("it is JSON");
    assert_eq!(drawn, kept);
}
