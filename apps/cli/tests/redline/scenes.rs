//! The programs of the guide, and the flight.

use std::path::{Path, PathBuf};

use fillrate_player::Frame;

use super::super::{fillrate, root, run};
use super::{CHIPS, check, compile, draw, load};

fn example(name: &str) -> PathBuf {
    root().join(format!("examples/redline/{name}.c"))
}

/// Red, green and blue of a pixel.
fn rgb(frame: &Frame, x: u32, y: u32) -> [u8; 3] {
    let rgba = frame.rgba(x, y).expect("a pixel");
    [rgba[0], rgba[1], rgba[2]]
}

const BLACK: [u8; 3] = [0, 0, 0];
const RED: [u8; 3] = [255, 0, 0];
const GREEN: [u8; 3] = [0, 255, 0];
const BLUE: [u8; 3] = [0, 0, 255];
const MAGENTA: [u8; 3] = [255, 0, 255];
const CYAN: [u8; 3] = [0, 255, 255];

/// Column, row and colour.
type Sample = (u32, u32, [u8; 3]);

/// Columns, rows and colours that a scene has with point filtering, computed
/// from the guide's numbers.
const SAMPLES: [(&str, &[Sample]); 4] = [
    ("htri1", &[(250, 150, RED), (120, 250, BLACK)]),
    ("htri2", &[(250, 150, RED), (120, 250, BLACK)]),
    (
        "htri3",
        &[
            (110, 105, GREEN),
            (130, 105, BLUE),
            (110, 118, BLUE),
            (205, 155, MAGENTA),
            (215, 155, CYAN),
            (205, 165, CYAN),
            (450, 155, CYAN),
            (450, 165, MAGENTA),
            (500, 175, CYAN),
            (205, 300, CYAN),
            (215, 300, MAGENTA),
        ],
    ),
    (
        "htri4",
        &[
            (300, 150, GREEN),
            (250, 200, GREEN),
            (500, 160, MAGENTA),
            (400, 220, CYAN),
            (300, 280, CYAN),
        ],
    ),
];

/// Whether two colours agree within what five bits and padding lose.
fn close(a: [u8; 3], b: [u8; 3], tolerance: u8) -> bool {
    a.iter().zip(&b).all(|(a, b)| a.abs_diff(*b) <= tolerance)
}

/// A program drawn on both chips, with both filters, in a window and on the
/// full screen: all are what the guide says, the pictures are the kept ones,
/// and only htri6, which takes other ways, may differ between the chips, by
/// rounding.
#[test]
fn guide_programs_draw_what_they_drew() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut problems = Vec::new();
    for number in 1..=6 {
        let name = format!("htri{number}");
        let program = compile(&example(&name), folder.path());
        for (filter, keys) in [("point", "."), ("bilinear", "f")] {
            if number < 3 && filter == "bilinear" {
                continue;
            }
            let mut pictures = Vec::new();
            for chip in CHIPS {
                let frames = folder.path().join(format!("{name}.{filter}.{chip}"));
                let ran = draw(&program, chip, &["-w", "-k", keys], &frames);
                let full = draw(&program, chip, &["-s", "-k", keys], &frames.join("full"));
                assert_eq!(ran.hashes.last(), full.hashes.last(), "{name} on the full screen");
                let picture = ran.pictures.last().expect("a frame").clone();
                let kept = match number {
                    6 => format!("{name}.{filter}.{chip}"),
                    _ => format!("{name}.{filter}"),
                };
                problems.extend(check(&kept, &picture).err());
                pictures.push(load(&picture));
            }
            let samples = SAMPLES.iter().filter(|(sampled, _)| *sampled == name);
            for &(x, y, expected) in samples.flat_map(|(_, samples)| *samples) {
                let found = rgb(&pictures[1], x, y);
                if filter == "point" && !close(found, expected, 8) {
                    problems.push(format!("{name} at {x}, {y}: {found:?}, not {expected:?}"));
                }
            }
            problems.extend(same_picture(&name, filter, &pictures[0], &pictures[1]).err());
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

/// Both chips' pictures: equal, or for htri6 within one step of five bits and
/// the padding.
fn same_picture(name: &str, filter: &str, a: &Frame, b: &Frame) -> Result<(), String> {
    let tolerance = if name == "htri6" { 17 } else { 0 };
    for y in 0..a.height() {
        for x in 0..a.width() {
            if !close(rgb(a, x, y), rgb(b, x, y), tolerance) {
                let (a, b) = (rgb(a, x, y), rgb(b, x, y));
                return Err(format!("{name} {filter} at {x}, {y}: {a:?} and {b:?}"));
            }
        }
    }
    Ok(())
}

/// The six mixtures of htri5 are those of the blending equation, and htri6's
/// corners are the texture plus the highlight.
#[test]
fn mixtures_are_the_equations() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let picture = |name: &str| {
        let program = compile(&example(name), folder.path());
        let ran =
            draw(&program, "v2000", &["-k", "."], &folder.path().join(name).with_extension("d"));
        load(ran.pictures.last().expect("a frame"))
    };
    let htri5 = picture("htri5");
    let mut found: Vec<[u8; 3]> = Vec::new();
    for y in 100..350 {
        for x in 100..600 {
            let color = rgb(&htri5, x, y);
            if !found.contains(&color) {
                found.push(color);
            }
        }
    }
    // 7/15 of red or white over black, green and blue, in 565.
    for expected in [0x7000, 0x73ae, 0x7440, 0x7011, 0x77ee, 0x73bf_u16] {
        let wide = |value: u16, bits: u32| (u32::from(value) * 255 / ((1 << bits) - 1)) as u8;
        let expected =
            [wide(expected >> 11, 5), wide(expected >> 5 & 63, 6), wide(expected & 31, 5)];
        assert!(found.iter().any(|color| close(*color, expected, 9)), "{expected:?} of {found:?}");
    }
    let htri6 = picture("htri6");
    assert!(close(rgb(&htri6, 103, 102), [255, 255, 0], 12));
    let right = rgb(&htri6, 485, 101);
    assert!(close(right, GREEN, 20) || close(right, BLUE, 20), "{right:?}");
    // The second triangle's colours have all the blue there is.
    assert!(close(rgb(&htri6, 222, 300), MAGENTA, 12) && close(rgb(&htri6, 208, 300), CYAN, 12));
}

/// The flight pages its pictures, and draws the same on every chip.
#[test]
fn flight_pages_textures() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let program = compile(&example("frame"), folder.path());
    let mut hashes = Vec::new();
    for chip in CHIPS {
        let frames = folder.path().join(chip);
        let ran = draw(&program, chip, &["-n", "8"], &frames);
        let numbers: Vec<u32> =
            ran.printed.split_whitespace().filter_map(|word| word.parse().ok()).collect();
        let [loads, evictions] = numbers[..] else { panic!("{}", ran.printed) };
        assert!(loads > 60 && evictions > 5, "{}", ran.printed);
        assert_eq!(ran.hashes.len(), 8);
        check("frame", &ran.pictures[7]).unwrap_or_else(|problem| panic!("{problem}"));
        hashes.push(ran.hashes);
    }
    assert_eq!(hashes[0], hashes[1]);
}

/// With command buffers dropped nothing is drawn, and the program runs on.
#[test]
fn speed_of_light_draws_nothing() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let program = compile(&example("htri1"), folder.path());
    let go = |more: &[&str]| {
        let mut command = fillrate();
        command.args(["run", "--hash"]).args(more).arg("--").arg(&program).args(["-n", "5"]);
        String::from_utf8_lossy(&run(&mut command).stdout).lines().count()
    };
    assert_eq!((go(&[]), go(&["--speed-of-light"])), (5, 0));
}

/// A program that finds all functions at run time, as the games did.
#[test]
fn libraries_opened_by_hand_share_the_device() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let text = r#"
        #define _GNU_SOURCE
        #include <dlfcn.h>
        #include <stdio.h>
        #include <string.h>
        #include <redline.h>
        #define GET(type, name, library) type name; { void *p = dlsym(library, #name); \
            if (!p) { printf("no %s\n", #name); return 1; } memcpy(&name, &p, sizeof p); }
        typedef int (*Open)(void *, v_handle *);
        typedef v_u32 (*Type)(v_handle);
        typedef int (*SetType)(v_handle, v_u32);
        typedef v_cmdbuffer (*Create)(v_handle, int, int);
        typedef int (*Set)(v_cmdbuffer *, v_u32);
        typedef int (*Issue)(v_handle, v_cmdbuffer);
        int main(void) {
            void *verite = dlopen("libverite.so", RTLD_NOW | RTLD_LOCAL);
            void *redline = dlopen("libredline.so", RTLD_NOW | RTLD_LOCAL);
            v_handle handle = 0; v_cmdbuffer buffer;
            if (!verite || !redline) { printf("%s\n", dlerror()); return 1; }
            { GET(Open, VL_OpenVerite, redline) GET(Type, V_GetDisplayType, verite)
              GET(SetType, V_SetDisplayType, verite) GET(Create, V_CreateCmdBuffer, verite)
              GET(Set, VL_SetSrcFunc, redline) GET(Issue, V_IssueCmdBuffer, verite)
              if (VL_OpenVerite(0, &handle) != VL_SUCCESS) return 2;
              if (V_GetDisplayType(handle) != V_WINDOWED_APP) return 3;
              if (V_SetDisplayType(handle, V_FULLSCREEN_APP) != V_SUCCESS) return 4;
              buffer = V_CreateCmdBuffer(handle, 4, 64);
              if (VL_SetSrcFunc(&buffer, V_SRCFUNC_REPLACE) != VL_SUCCESS) return 5;
              if (V_IssueCmdBuffer(handle, buffer) != V_SUCCESS) return 6; }
            return 0;
        }"#;
    let file = folder.path().join("by_hand.c");
    std::fs::write(&file, text).expect("the source can be written");
    let program = folder.path().join("by_hand");
    let include = root().join("include");
    run(std::process::Command::new("cc")
        .arg("-I")
        .arg(include)
        .arg(&file)
        .arg("-o")
        .arg(&program)
        .arg("-ldl"));
    let with: &Path = &super::super::library_folder();
    run(std::process::Command::new(&program).env("LD_LIBRARY_PATH", with));
}
