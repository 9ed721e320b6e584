//! The program and the C library as a user meets them: examples compiled by
//! the system's C compiler, run, recorded and replayed.

mod bench;
mod card;
#[path = "conformance/mod.rs"]
mod conformance;
#[path = "quark/mod.rs"]
mod quark;
#[path = "rave/mod.rs"]
mod rave;
#[path = "redline/mod.rs"]
mod redline;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn fillrate() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_fillrate"));
    // Settings of the person who runs the tests must not reach them.
    for (name, _) in std::env::vars() {
        if ["FILLRATE_", "FX_GLIDE_", "SST_"].iter().any(|prefix| name.starts_with(prefix)) {
            command.env_remove(name);
        }
    }
    // An older library may lie beside the program.
    command.env("FILLRATE_LIB_DIR", library_folder());
    command.current_dir(root());
    command
}

fn run(command: &mut Command) -> Output {
    let output = command.output().expect("the program starts");
    assert!(
        output.status.success(),
        "{command:?}: {}\n{}",
        output.status,
        String::from_utf8_lossy(&output.stderr)
    );
    output
}

/// The folder of the library that was built with this test.
fn library_folder() -> PathBuf {
    let program = Path::new(env!("CARGO_BIN_EXE_fillrate"));
    program.parent().expect("a program has a folder").join("deps")
}

/// Hash of every scene of the gallery, drawn with these variables.
fn gallery(variables: &[(&str, String)]) -> BTreeMap<String, String> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut command = fillrate();
    command.args(["demo", "--json", "--out"]).arg(folder.path());
    let output = run(command.envs(variables.iter().map(|(n, v)| (*n, v.as_str()))));
    String::from_utf8_lossy(&output.stdout)
        .lines()
        .filter_map(|line| serde_json::from_str::<serde_json::Value>(line).ok())
        .map(|scene| {
            let text = |key: &str| scene[key].as_str().unwrap_or_default().to_string();
            (text("name"), text("hash"))
        })
        .collect()
}

/// Every scene's hash is the one kept; `BLESS=1` keeps the present ones.
#[test]
fn gallery_is_as_it_was() {
    let file = root().join("tests/golden/gallery.json");
    let mut drawn = gallery(&[]);
    // The viewer's camera takes sines from the system: its picture is no
    // other machine's.
    assert!(drawn.remove("level").is_some());
    assert!(drawn.len() >= 25, "{drawn:?}");
    if std::env::var_os("BLESS").is_some() {
        let text = serde_json::to_string_pretty(&drawn).expect("hashes are text");
        std::fs::write(&file, text + "\n").expect("the golden file can be written");
    }
    let kept = std::fs::read_to_string(&file).expect("the golden file exists");
    let kept: BTreeMap<String, String> = serde_json::from_str(&kept).expect("it is JSON");
    assert_eq!(drawn, kept);
}

/// One hash a scene over levels, thread counts and tile sizes: a part of the
/// combinations, all of them with `FILLRATE_FULL=1`.
#[test]
fn gallery_is_the_same_everywhere() {
    let full = std::env::var_os("FILLRATE_FULL").is_some();
    let expected = gallery(&[]);
    let (threads, tiles) = ([1, 2, 3, 8], [32, 128]);
    for (i, level) in fillrate_simd::Level::available().enumerate() {
        let all = threads.into_iter().flat_map(|n| tiles.map(|t| (n, t)));
        for (j, (threads, tile)) in all.enumerate() {
            if !full && j != (i * 3) % 8 {
                continue;
            }
            let settings = [
                ("FILLRATE_SIMD", level.to_string()),
                ("FILLRATE_THREADS", threads.to_string()),
                ("FILLRATE_TILE", tile.to_string()),
            ];
            assert_eq!(gallery(&settings), expected, "{settings:?}");
        }
    }
}

/// Compiles a program as its author would; returns where it is.
fn compile(file: &Path, library: &str, folder: &Path) -> PathBuf {
    let program = folder.join(file.file_stem().expect("a name"));
    let is_cpp = file.extension().is_some_and(|extension| extension == "cpp");
    let (compiler, standard) = if is_cpp { ("c++", "-std=c++17") } else { ("cc", "-std=c99") };
    run(Command::new(compiler)
        .args([standard, "-O2", "-I"])
        .arg(root().join("include"))
        .arg(file)
        .arg("-o")
        .arg(&program)
        .arg("-L")
        .arg(library_folder())
        .arg(format!("-l{library}"))
        .args((library == "redline").then_some("-lverite"))
        .arg("-lm"));
    program
}

/// The programs of a folder of examples.
fn examples(folder: &str) -> Vec<PathBuf> {
    let files = std::fs::read_dir(root().join(folder)).expect("examples exist");
    let files = files.map(|entry| entry.expect("a file").path());
    files.filter(|file| file.extension().is_some_and(|e| e == "c" || e == "cpp")).collect()
}

/// A recording of every example replays to the same hashes.
#[test]
fn recordings_replay_to_the_same_frames() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut count = 0;
    for (examples_of, library) in [
        ("glide", "glide2x"),
        ("raw", "render_client"),
        ("quark", "quark3d"),
        ("rave", "rave"),
        ("redline", "redline"),
    ] {
        for file in examples(&format!("examples/{examples_of}")) {
            let program = compile(&file, library, folder.path());
            let trace = folder.path().join("trace");
            run(fillrate()
                .args(["run", "--frames", "8", "--trace"])
                .arg(&trace)
                .arg("--")
                .arg(&program));
            let replayed = run(fillrate().arg("replay").arg("--hash").arg(&trace));
            assert!(!replayed.stdout.is_empty(), "{} shows no frame", file.display());
            count += 1;
        }
    }
    assert!(count >= 46, "{count}");
}

/// A client of the Raw pipeline draws the same on the other side of pipes: on one tile, on sixteen,
/// and from a file of the records it sent.
#[test]
fn raw_clients_draw_the_same_over_every_transport() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for file in examples("examples/raw") {
        let program = compile(&file, "render_client", folder.path());
        let [here, single, grid] = ["here", "single", "grid"].map(|name| folder.path().join(name));
        run(fillrate().args(["run", "--out"]).arg(&here).arg("--").arg(&program));
        let mut frames: Vec<_> = std::fs::read_dir(&here)
            .expect("frames")
            .map(|entry| entry.expect("a file").path())
            .filter(|file| file.extension().is_some_and(|extension| extension == "png"))
            .collect();
        frames.sort();
        let last = std::fs::read(frames.last().expect("a frame")).expect("a picture");
        for (build, out) in [("single", &single), ("grid", &grid), ("fast", &grid)] {
            let mut serve = fillrate();
            serve.args(["raw", "serve", "--build", build, "--out"]).arg(out);
            run(serve.arg("--").arg(&program));
            let served = std::fs::read(out.join("front.png")).expect("a picture");
            assert!(served == last, "{} on {build}", file.display());
        }
        let records = folder.path().join("records");
        let sent = std::fs::File::create(&records).expect("a file");
        let status = Command::new(&program)
            .env("FILLRATE_RAW_TRANSPORT", "pipe")
            .env("LD_LIBRARY_PATH", library_folder())
            .stdin(std::process::Stdio::null())
            .stdout(sent)
            .stderr(std::process::Stdio::null())
            .status();
        assert!(status.expect("the program starts").success());
        run(fillrate().args(["raw", "play", "--out"]).arg(&single).arg(&records));
        let played = std::fs::read(single.join("front.png")).expect("a picture");
        assert!(played == last, "{} from a file", file.display());
        std::fs::remove_dir_all(&here).expect("removed");
    }
}

/// Faults of records end with exit code 3 and name their place.
#[test]
fn raw_faults_name_their_place() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let play = |text: &str, more: &[&str]| {
        let file = folder.path().join("records");
        std::fs::write(&file, text).expect("a file");
        let output = fillrate().args(["raw", "play"]).args(more).arg(&file).output();
        let output = output.expect("the program starts");
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    for build in [&[][..], &["--build", "grid"]] {
        let (code, text) = play("0x0000001e\n", build);
        assert_eq!((code, text.as_str()), (Some(0), ""));
        let (code, text) = play("0x0000001e\n0x00000063\n0x00000022\n0x00000007\n", build);
        assert_eq!(code, Some(3));
        assert!(text.contains("word 1: opcode 0x00000063"), "{text}");
        assert!(text.contains("word 3: texture 7 does not exist"), "{text}");
        let (code, text) = play("0x0000001e\nnonsense!!\n", build);
        assert_eq!(code, Some(3));
        assert!(text.contains("record 1 at byte 11"), "{text}");
        let (code, text) = play("0x0000001e\nwait******\n", build);
        assert_eq!(code, Some(3));
        assert!(text.contains("waits for a word") || text.contains("record 1, word 1"), "{text}");
        // A clear that lacks its colour, and a scene that does not end.
        let (code, text) = play("0x0000001d\n0x00000003\n", build);
        assert_eq!(code, Some(3));
        assert!(
            text.contains("word 2: the stream ends inside RENDER_CLEARFB, words missing: 1"),
            "{text}"
        );
        let (code, text) = play("0x00000001\nwait******\n0x00000001\n0x00000002\n", build);
        assert_eq!(code, Some(3));
        assert!(text.contains("word 3: the stream ends inside a scene"), "{text}");
        let (code, text) = play("0x0000001e0", build);
        assert_eq!(code, Some(3));
        assert!(text.contains("malformed record \"0x0000001e0\""), "{text}");
        let (code, text) = play("0x0000002f\n0x0000001e\n", build);
        assert_eq!((code, text.as_str()), (Some(0), ""));
        let (code, text) = play("0x00000", build);
        assert_eq!(code, Some(3));
        assert!(text.contains("ends after 7 of 11 bytes"), "{text}");
    }
    let (code, text) = play("bad\n0x00000063\n", &["--resync"]);
    assert_eq!(code, Some(3));
    assert!(text.contains("record 0 at byte 0"), "{text}");
}

/// Headers in every language mode, layouts, values, bad input: the scripts'
/// own checks, against this library.
#[test]
fn c_programs_conform() {
    let script = root().join("tests/c/headers.sh");
    let output = run(Command::new("sh").arg(script).arg(library_folder()).current_dir(root()));
    print!("{}", String::from_utf8_lossy(&output.stdout));
}

/// Wrong usage, bad files and missing programs end with their exit codes.
#[test]
fn exit_codes() {
    let code = |arguments: &[&str]| {
        fillrate().args(arguments).output().expect("the program starts").status.code()
    };
    assert_eq!(code(&["no-such-command"]), Some(2));
    assert_eq!(code(&["bench", "--simd", "mmx"]), Some(2));
    assert_eq!(code(&["bench", "--size", "5000x480"]), Some(2));
    assert_eq!(code(&["replay", "Cargo.toml"]), Some(3));
    assert_eq!(code(&["run", "--", "/no/such/program"]), Some(3));
    assert_eq!(code(&["demo", "--only", "no-such-scene"]), Some(3));
}

/// The direction of dependencies: nothing on the left knows what is right.
#[test]
fn dependencies_point_one_way() {
    let output = run(Command::new(env!("CARGO"))
        .args(["metadata", "--format-version", "1", "--no-deps", "--offline"])
        .current_dir(root()));
    let metadata: serde_json::Value =
        serde_json::from_slice(&output.stdout).expect("metadata is JSON");
    let allowed: BTreeMap<&str, &[&str]> = BTreeMap::from([
        ("fillrate-simd", &[][..]),
        ("fillrate-call", &[]),
        ("fillrate-guard", &[]),
        ("fillrate-geometry", &[]),
        ("fillrate-engine", &["fillrate-simd"]),
        ("fillrate-glide", &["fillrate-engine", "fillrate-call"]),
        (
            "fillrate-settings",
            &["fillrate-glide", "fillrate-redline", "fillrate-engine", "fillrate-simd"],
        ),
        ("fillrate-raw", &["fillrate-engine", "fillrate-simd", "fillrate-call"]),
        ("fillrate-quark", &["fillrate-engine", "fillrate-call"]),
        ("fillrate-redline", &["fillrate-engine", "fillrate-call"]),
        ("fillrate-rave", &["fillrate-engine", "fillrate-call"]),
        ("fillrate-trace", &["fillrate-call"]),
        ("fillrate-player", &["fillrate-call", "fillrate-trace"]),
    ]);
    for package in metadata["packages"].as_array().expect("packages") {
        let name = package["name"].as_str().expect("a name");
        let Some(allowed) = allowed.get(name) else { continue };
        for dependency in package["dependencies"].as_array().expect("dependencies") {
            let on = dependency["name"].as_str().expect("a name");
            let internal = on.starts_with("fillrate-") && dependency["kind"].is_null();
            assert!(!internal || allowed.contains(&on), "{name} must not depend on {on}");
        }
    }
}
