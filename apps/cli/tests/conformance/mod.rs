//! The C interface as a whole: every function there, with the arguments it
//! has, called at least once; every constant and field checked; and one program
//! for each topic, whose pictures are kept.

mod coverage;
mod interface;
mod pictures;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use super::{library_folder, root, run};

/// A C program of the tests, compiled.
struct Program {
    name: String,
    binary: PathBuf,
}

/// The C files of a folder, by name.
fn sources(folder: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(root().join(folder)).expect("the folder exists");
    let files = entries.map(|entry| entry.expect("a file").path());
    let mut files: Vec<PathBuf> =
        files.filter(|file| file.extension() == Some("c".as_ref())).collect();
    files.sort();
    files
}

fn name_of(file: &Path) -> String {
    file.file_stem().expect("a file has a name").to_string_lossy().into_owned()
}

/// Compiles programs against the headers and the library of this build.
fn compile(files: &[PathBuf], to: &Path) -> Vec<Program> {
    files
        .iter()
        .map(|file| {
            let (name, binary) = (name_of(file), to.join(name_of(file)));
            // Contracted arithmetic would give other coordinates elsewhere.
            run(Command::new("cc")
                .args(["-std=c99", "-O1", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror"])
                .args(["-pedantic", "-I"])
                .arg(root().join("include"))
                .arg(file)
                .arg("-o")
                .arg(&binary)
                .arg("-L")
                .arg(library_folder())
                .args(["-lglide2x", "-lm"]));
            Program { name, binary }
        })
        .collect()
}

/// The conformance programs, compiled once for all tests.
fn conformance_programs() -> &'static [Program] {
    static COMPILED: OnceLock<(tempfile::TempDir, Vec<Program>)> = OnceLock::new();
    let (_, programs) = COMPILED.get_or_init(|| {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let programs = compile(&sources("tests/c/conformance"), folder.path());
        (folder, programs)
    });
    programs
}

impl Program {
    /// The program, ready to run in checking mode in a folder of its own.
    fn command(&self, folder: &Path) -> Command {
        let mut command = Command::new(&self.binary);
        for (name, _) in std::env::vars() {
            if ["FILLRATE_", "FX_GLIDE_", "SST_"].iter().any(|prefix| name.starts_with(prefix)) {
                command.env_remove(name);
            }
        }
        command
            .current_dir(folder)
            .env("LD_LIBRARY_PATH", library_folder())
            .env("DYLD_LIBRARY_PATH", library_folder())
            .env("TMPDIR", folder)
            .env("FILLRATE_CHECK", "1");
        if self.name == "boards" {
            command.env("FILLRATE_BOARDS", "2");
        }
        command
    }
}

/// Names and bytes of arguments of every entry point.
fn entry_points() -> Vec<(String, usize)> {
    let text = std::fs::read_to_string(root().join("tests/c/entry_points.txt")).expect("the table");
    text.lines()
        .filter(|line| !line.is_empty() && !line.starts_with('#'))
        .map(|line| {
            let (name, bytes) = line.split_once(' ').expect("a name and a number");
            (name.to_string(), bytes.parse().expect("a number"))
        })
        .collect()
}
