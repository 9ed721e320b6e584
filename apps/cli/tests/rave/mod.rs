//! RAVE as a program meets it: its headers, its library, its examples, and one
//! program for each topic.

mod interface;

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use fillrate_player::{Frame, compare, difference_image};

use super::{compile, examples, fillrate, library_folder, root, run};

/// Programs of the tests: one for each topic.
fn conformance() -> Vec<PathBuf> {
    let mut files = examples("tests/c/rave");
    files.sort();
    files
}

fn name_of(file: &Path) -> String {
    file.file_stem().expect("a name").to_string_lossy().into_owned()
}

/// A program as its author starts it, without settings of whoever runs the tests.
fn program(file: &Path, folder: &Path) -> Command {
    let mut command = Command::new(compile(file, "rave", folder));
    for (name, _) in std::env::vars().filter(|(name, _)| name.starts_with("FILLRATE_")) {
        command.env_remove(name);
    }
    command.env("LD_LIBRARY_PATH", library_folder()).env("DYLD_LIBRARY_PATH", library_folder());
    command
}

/// Runs a program, recorded; returns what it printed and its last frame.
fn draw(mut command: Command, folder: &Path) -> (Output, Frame) {
    let frames = folder.join("shown");
    let _ = std::fs::remove_dir_all(&frames);
    command.env("FILLRATE_CAPTURE", &frames).env("FILLRATE_TRACE", folder.join("trace"));
    let output = run(&mut command);
    let pictures = std::fs::read_dir(&frames).expect("frames were captured");
    let pictures = pictures.map(|entry| entry.expect("a file").path());
    let last = pictures.filter(|path| path.extension() == Some("png".as_ref())).max();
    (output, load(&last.expect("a frame")))
}

fn load(path: &Path) -> Frame {
    Frame::load_png(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Compares a picture with the kept one; where they differ, all three are written.
/// `BLESS=1` keeps the present one.
fn check(name: &str, actual: &Frame) -> Result<(), String> {
    let kept = root().join(format!("tests/golden/rave/{name}.png"));
    if std::env::var_os("BLESS").is_some() {
        std::fs::create_dir_all(kept.parent().expect("a folder")).map_err(|e| e.to_string())?;
        actual.save_png(&kept).map_err(|error| error.to_string())?;
    }
    let expected = load(&kept);
    let comparison = compare(&expected, actual);
    if comparison.is_same() {
        return Ok(());
    }
    let folder = root().join("target/golden-failures/rave");
    std::fs::create_dir_all(&folder).map_err(|error| error.to_string())?;
    let save = |kind: &str, frame: &Frame| {
        let file = folder.join(format!("{name}.{kind}.png"));
        frame.save_png(&file).map_err(|error| error.to_string())
    };
    save("actual", actual)?;
    save("expected", &expected)?;
    if let Ok(difference) = difference_image(&expected, actual) {
        save("difference", &difference)?;
    }
    Err(format!("{name}: {comparison:?}; see {}", folder.display()))
}

/// Every program's checks hold, its last picture is the kept one, and its
/// recording replays to the same frames.
#[test]
fn programs_conform() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut problems = Vec::new();
    for file in conformance() {
        let (_, frame) = draw(program(&file, folder.path()), folder.path());
        run(fillrate().arg("replay").arg(folder.path().join("trace")));
        problems.extend(check(&name_of(&file), &frame).err());
    }
    // Other boards, and another order of bytes: the same picture.
    for (name, argument) in
        [("memory", "video"), ("memory", "frame"), ("order", "pictures"), ("order", "1")]
    {
        let file = root().join(format!("tests/c/rave/{name}.c"));
        let mut command = program(&file, folder.path());
        command.arg(argument);
        let (_, frame) = draw(command, folder.path());
        run(fillrate().arg("replay").arg(folder.path().join("trace")));
        if name == "order" {
            problems.extend(check(name, &frame).err());
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

/// The last frame of each example is the kept one, and its recording replays to
/// the same frames. Preflighting loads no texture
/// twice in a frame, and fewer than drawing as objects come.
#[test]
fn examples_draw_what_they_drew() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut problems = Vec::new();
    for file in examples("examples/rave") {
        let name = name_of(&file);
        let (output, frame) = draw(program(&file, folder.path()), folder.path());
        run(fillrate().arg("replay").arg(folder.path().join("trace")));
        problems.extend(check(&format!("example_{name}"), &frame).err());
        if name == "world" {
            let text = String::from_utf8_lossy(&output.stdout).into_owned();
            check_loads(&text);
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

/// Numbers of needed textures and of loads, of frames drawn one way.
fn loads(text: &str, how: &str) -> Vec<[u32; 3]> {
    let lines = text.lines().filter(|line| line.starts_with(how));
    lines
        .map(|line| {
            let (_, numbers) = line.split_once(": ").expect("numbers follow");
            let mut words = numbers.split(' ').filter_map(|word| word.parse().ok());
            std::array::from_fn(|_| words.next().expect("three numbers"))
        })
        .collect()
}

fn check_loads(text: &str) {
    let (plain, sorted) = (loads(text, "as it comes"), loads(text, "preflighted"));
    assert_eq!((plain.len(), sorted.len()), (4, 4), "{text}");
    for ([needed, loaded, twice], [_, as_it_comes, often]) in sorted.into_iter().zip(plain) {
        assert!(loaded <= needed && twice == 0, "{text}");
        assert!(as_it_comes > needed && often > 0, "{text}");
    }
}

/// Nothing is read or written that is not there, and nothing is lost.
#[test]
fn memory_checker_is_content() {
    if Command::new("valgrind").arg("--version").output().is_err() {
        println!("NOT CHECKED: valgrind is not installed");
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (name, argument) in [
        ("memory", "separate"),
        ("memory", "video"),
        ("memory", "frame"),
        ("engines", ""),
        ("order", "1"),
        ("devices", ""),
        ("late", ""),
    ] {
        let file = root().join(format!("tests/c/rave/{name}.c"));
        let direct = program(&file, folder.path());
        let mut command = Command::new("valgrind");
        command
            .args(["--quiet", "--error-exitcode=9", "--leak-check=full"])
            .args(["--errors-for-leak-kinds=definite"])
            .arg(direct.get_program())
            .arg(argument)
            .env("LD_LIBRARY_PATH", library_folder())
            // Instructions that the checker knows.
            .env("FILLRATE_SIMD", "sse4.1")
            .env("FILLRATE_THREADS", "2");
        run(&mut command);
    }
}
