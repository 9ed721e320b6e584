//! The headers and the library against each other and against the numbers that
//! programs carry.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

use super::super::{compile, library_folder, root, run};

const HEADERS: [&str; 3] = ["RAVE", "RAVE_system", "RAVE_ati"];

fn header(name: &str) -> String {
    let file = root().join(format!("include/{name}.h"));
    let mut rest = &std::fs::read_to_string(file).expect("a header")[..];
    let mut text = String::new();
    while let Some((before, after)) = rest.split_once("/*") {
        text.push_str(before);
        rest = after.split_once("*/").expect("comments end").1;
    }
    text.push_str(rest);
    text
}

/// Functions that the headers declare.
fn prototypes() -> BTreeSet<String> {
    let text = HEADERS.map(header).concat();
    let declarations = text.split(';').filter_map(|text| {
        let line = text.trim().lines().rev().find(|line| {
            let starts = ["TQA", "void ", "float ", "long ", "void *"];
            starts.iter().any(|start| line.starts_with(start)) && line.contains("QA")
        })?;
        let (before, _) = line.split_once('(')?;
        let name = before.rsplit([' ', '*']).next()?;
        name.starts_with("QA").then(|| name.to_string())
    });
    declarations.collect()
}

/// Functions that the library exports.
fn exports() -> BTreeSet<String> {
    let library = library_folder().join("librave.so");
    let output = run(Command::new("nm").args(["-D", "--defined-only"]).arg(library));
    String::from_utf8_lossy(&output.stdout)
        .lines()
        .filter_map(|line| line.split_whitespace().nth(2))
        .filter(|name| name.starts_with("QA"))
        .map(str::to_string)
        .collect()
}

#[test]
fn headers_and_library_have_the_same_functions() {
    let declared = prototypes();
    assert_eq!(declared.len(), 65, "{declared:?}");
    assert_eq!(declared, exports());
    // Each of the 35 methods has its macro, its function, and its tag.
    let (text, system) = (header("RAVE"), header("RAVE_system"));
    let macros =
        text.lines().filter(|line| line.starts_with("#define QA") && line.contains("(ctx"));
    let macros: Vec<&str> = macros
        .filter_map(|line| line.strip_prefix("#define ")?.split_once('(').map(|(name, _)| name))
        .collect();
    assert_eq!(macros.len(), 35);
    for name in macros {
        assert!(declared.contains(name), "{name}");
        assert!(system.contains(&format!("k{name} = ")), "{name}");
    }
}

/// Every number that the headers name is compared with its value.
#[test]
fn every_constant_is_checked() {
    let values = std::fs::read_to_string(root().join("tests/c/rave_values.c")).expect("the test");
    let text = HEADERS.map(header).concat();
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let names: BTreeSet<&str> = text
        .split(|c| !is_word(c))
        .filter(|word| word.starts_with("kQA") || word.starts_with("kATI"))
        .collect();
    assert!(names.len() > 450, "{}", names.len());
    let missing: Vec<&&str> = names
        .iter()
        .filter(|name| {
            !values.contains(&format!("VALUE({name},")) && !values.contains(&format!("{name} =="))
        })
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}

fn compiles(compiler: &str, arguments: &[&str], file: &Path) {
    run(Command::new(compiler)
        .args(arguments)
        .args(["-Wall", "-Wextra", "-Werror", "-pedantic", "-fsyntax-only", "-I"])
        .arg(root().join("include"))
        .arg(file));
}

/// The headers in every mode, twice, in both orders; numbers and layouts.
#[test]
fn headers_compile_everywhere() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (name, order) in [("forwards", [0, 1, 2]), ("backwards", [2, 1, 0])] {
        let lines = order.map(|i| format!("#include <{}.h>\n", HEADERS[i])).concat();
        let file = folder.path().join(format!("{name}.c"));
        std::fs::write(&file, format!("{lines}{lines}int used;\n")).expect("a file");
        for standard in ["-std=c89", "-std=c99", "-std=c11", "-std=c17"] {
            compiles("cc", &[standard], &file);
        }
        compiles("c++", &["-x", "c++", "-std=c++17"], &file);
    }
    for name in ["rave_values", "rave_layout"] {
        let file = root().join(format!("tests/c/{name}.c"));
        compiles("cc", &["-std=c89", "-DCHECK_STATIC"], &file);
        let program = compile(&file, "rave", folder.path());
        run(Command::new(program).env("LD_LIBRARY_PATH", library_folder()));
    }
}
