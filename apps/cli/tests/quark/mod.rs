//! Quark 3D as a program meets it: its header, its library, its fifteen
//! examples.

use std::path::{Path, PathBuf};
use std::process::Command;

use fillrate_player::{Frame, compare, difference_image};

use super::{compile, library_folder, root, run};

/// Compiles and runs a program, and returns what it printed and its frames.
fn draw(file: &Path, folder: &Path) -> (String, Vec<PathBuf>) {
    let program = compile(file, "quark3d", folder);
    let frames = folder.join(file.file_stem().expect("a name")).with_extension("frames");
    std::fs::create_dir_all(&frames).expect("a folder for frames");
    let mut command = Command::new(program);
    command.env("LD_LIBRARY_PATH", library_folder()).env("FILLRATE_CAPTURE", &frames);
    let output = run(&mut command);
    let mut pictures: Vec<PathBuf> = std::fs::read_dir(&frames)
        .expect("frames were captured")
        .map(|entry| entry.expect("a file").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "png"))
        .collect();
    pictures.sort();
    (String::from_utf8_lossy(&output.stdout).into_owned(), pictures)
}

fn demo(number: u32) -> PathBuf {
    root().join(format!("examples/quark/demo{number}.cpp"))
}

fn load(path: &Path) -> Frame {
    Frame::load_png(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Compares a picture with the kept one; where they differ, all three are
/// written.
fn check(name: &str, actual: &Frame, kept: &Path) -> Result<(), String> {
    let expected = load(kept);
    let comparison = compare(&expected, actual);
    if comparison.is_same() {
        return Ok(());
    }
    let folder = root().join("target/golden-failures/quark");
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

/// The last frame of each example is the kept one; `BLESS=1` keeps the present
/// ones. The cube from a list is the cube of single triangles; the benchmark
/// prints its score.
#[test]
fn demos_draw_what_they_drew() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let golden = root().join("tests/golden/quark");
    let bless = std::env::var_os("BLESS").is_some();
    let mut problems = Vec::new();
    let mut last_frames = Vec::new();
    for number in 0..15 {
        let (text, pictures) = draw(&demo(number), folder.path());
        let last = pictures.last().expect("a frame");
        let kept = golden.join(format!("demo{number}.png"));
        if bless {
            std::fs::create_dir_all(&golden).expect("the folder can be made");
            std::fs::copy(last, &kept).expect("the picture can be kept");
        }
        let frame = load(last);
        assert_eq!((frame.width(), frame.height()), (240, 320));
        problems.extend(check(&format!("demo{number}"), &frame, &kept).err());
        last_frames.push(frame);
        if number == 14 {
            assert_eq!(text.matches("score").count(), 3, "{text}");
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    assert!(compare(&last_frames[7], &last_frames[8]).is_same(), "demo8 draws demo7's cube");
    let different = |a: usize, b: usize| !compare(&last_frames[a], &last_frames[b]).is_same();
    assert!((0..15).all(|a| (0..a).all(|b| different(a, b) || (a, b) == (8, 7))));
}

/// Every one of the 8192 colours of the palette chart is the table's colour.
#[test]
fn palette_chart_shows_every_colour() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (_, pictures) = draw(&demo(0), folder.path());
    let frame = load(&pictures[0]);
    let mut shown = 0;
    for color in 0..8192u32 {
        let (x, y) = (color % 256 * 15 / 16, 160 + color / 256);
        // Columns that fall together show the later base colour.
        let next = (color % 256 + 1) * 15 / 16;
        if color % 256 < 255 && next == x {
            continue;
        }
        let expected = fillrate_quark::color::rgb888(color as u16);
        assert_eq!(frame.rgba(x, y).expect("a pixel")[..3], expected, "{color:#x}");
        shown += 1;
    }
    assert_eq!(shown, 240 * 32);
}

/// The header in every mode, its layouts and values, and the checks of two
/// programs written to the document: what it promises, and bad input.
#[test]
fn programs_written_to_the_document_conform() {
    let script = root().join("tests/c/quark.sh");
    let output = run(Command::new("sh").arg(script).arg(library_folder()).current_dir(root()));
    print!("{}", String::from_utf8_lossy(&output.stdout));
}
