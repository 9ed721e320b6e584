//! The conformance programs: one for each topic.

use std::path::PathBuf;

use super::super::{fillrate, root, run};
use super::{CHIPS, check, compile, draw};

fn sources() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(root().join("tests/c/redline")).expect("programs exist");
    let files = entries.map(|entry| entry.expect("a file").path());
    let mut files: Vec<PathBuf> =
        files.filter(|file| file.extension().is_some_and(|e| e == "c")).collect();
    files.sort();
    files
}

/// Every program's checks hold on both chips, its last picture is the kept one
/// and, but for the extension, the same on both, and its recording replays to
/// the same frames.
#[test]
fn programs_conform_on_both_chips() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut problems = Vec::new();
    let sources = sources();
    assert!(sources.len() >= 15, "{}", sources.len());
    for file in sources {
        let program = compile(&file, folder.path());
        let name = file.file_stem().expect("a name").to_string_lossy().into_owned();
        let mut last = Vec::new();
        for chip in CHIPS {
            let frames = folder.path().join(format!("{name}.{chip}"));
            let ran = draw(&program, chip, &[], &frames);
            let passed = ran.printed.lines().last().unwrap_or_default();
            assert!(passed.ends_with(" passed, 0 failed"), "{name}: {passed}");
            let Some(picture) = ran.pictures.last() else { continue };
            last.push(ran.hashes.last().cloned());
            let kept = if name == "specular" { format!("{name}.{chip}") } else { name.clone() };
            problems.extend(check(&kept, picture).err());
            let replayed = run(fillrate().arg("replay").arg("--hash").arg(frames.join("trace")));
            let replayed = String::from_utf8_lossy(&replayed.stdout).into_owned();
            for hash in &ran.hashes {
                assert!(replayed.contains(hash.as_str()), "{name} on {chip}:\n{replayed}");
            }
        }
        if name != "specular" && last.len() == 2 && last[0] != last[1] {
            problems.push(format!("{name}: the chips differ"));
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

/// Flips in one command buffer are frames of their own: the same as those of
/// buffers with one flip each.
#[test]
fn every_flip_is_a_frame() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let program = compile(&root().join("tests/c/redline/flips.c"), folder.path());
    for chip in CHIPS {
        let together = draw(&program, chip, &[], &folder.path().join("together"));
        let apart = draw(&program, chip, &["apart"], &folder.path().join("apart"));
        assert_eq!(together.hashes, apart.hashes, "{chip}");
        let [first, second, third] = &together.hashes[..] else {
            panic!("three flips, {} frames", together.hashes.len())
        };
        assert!(first != second && second != third && first != third);
    }
}
