//! RRedline's headers and libraries against the tables of its functions,
//! constants and structures.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::process::Command;

use super::super::{library_folder, root, run};

const HEADERS: [&str; 8] =
    ["v_env", "v_res", "vl_res", "verite", "rlfifo", "redline", "rlfifoex", "rlex"];

/// A header without comments.
fn header(name: &str) -> String {
    let file = root().join(format!("include/{name}.h"));
    let whole = std::fs::read_to_string(file).expect("a header");
    let (mut text, mut rest) = (String::new(), &whole[..]);
    while let Some((before, after)) = rest.split_once("/*") {
        text.push_str(before);
        rest = after.split_once("*/").expect("comments end").1;
    }
    text + rest
}

/// The lines of a table.
fn table(name: &str) -> Vec<Vec<String>> {
    let file = root().join("tests/c/redline").join(name);
    let text = std::fs::read_to_string(file).expect("a table");
    let lines = text.lines().filter(|line| !line.starts_with('#') && !line.is_empty());
    lines.map(|line| line.split_whitespace().map(str::to_string).collect()).collect()
}

/// Functions of a library, with the number of their arguments.
fn functions(library: &str) -> BTreeMap<String, usize> {
    let rows = table("functions.txt").into_iter().filter(|row| row[0] == library);
    rows.map(|row| (row[1].clone(), row[2].parse().expect("a number"))).collect()
}

/// Prototypes of a header, with the number of their arguments.
fn prototypes(name: &str) -> BTreeMap<String, usize> {
    let text = header(name);
    let declarations = text.split("V_IMPORT ").skip(1);
    declarations
        .map(|text| {
            let (declaration, _) = text.split_once(';').expect("declarations end");
            let (_, called) = declaration.split_once("V_CDECL").expect("a convention");
            let (name, arguments) = called.split_once('(').expect("arguments");
            let arguments = arguments.trim_end().strip_suffix(')').expect("arguments end");
            let none = arguments.trim() == "void";
            (name.trim().to_string(), if none { 0 } else { arguments.split(',').count() })
        })
        .collect()
}

/// Functions that a library exports.
fn exports(library: &str) -> BTreeSet<String> {
    let file = library_folder().join(format!("lib{library}.so"));
    let output = run(Command::new("nm").args(["-D", "--defined-only"]).arg(file));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let names = text.lines().filter_map(|line| line.split_whitespace().nth(2));
    names.map(str::to_string).collect()
}

/// Every documented function is declared with its arguments and exported by the
/// library it belongs to; the libraries export nothing else but the functions
/// that one needs of the other.
#[test]
fn headers_and_libraries_have_every_function() {
    for (library, prefix, count) in [("verite", "V_", 60), ("redline", "VL_", 135)] {
        let expected = functions(library);
        assert_eq!(expected.len(), count);
        assert_eq!(prototypes(library), expected);
        let exported = exports(library);
        let ours: BTreeSet<String> =
            exported.iter().filter(|name| name.starts_with(prefix)).cloned().collect();
        assert_eq!(ours, expected.into_keys().collect());
        let others = exported.difference(&ours).filter(|name| !name.starts_with("redline_"));
        let others: Vec<&String> = others.filter(|name| !name.starts_with("rust_")).collect();
        assert!(others.is_empty(), "{others:?}");
    }
    // Extensions come from VL_GetExtensionFunction alone.
    assert!(exports("redline").iter().all(|name| !name.contains("Specular")));
}

/// Every constant that a header names, macros with arguments left out.
fn constants() -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for name in HEADERS {
        let text = header(name);
        for line in text.lines() {
            let define = line.trim().strip_prefix("#define ");
            if let Some((name, value)) = define.and_then(|rest| rest.split_once(' ')) {
                let is_number = !name.contains('(') && !value.contains("extern");
                names.extend(is_number.then(|| name.to_string()));
            }
            let member = line.trim().trim_end_matches(',').split_once(" = ");
            names.extend(member.map(|(name, _)| name.to_string()));
        }
    }
    names.retain(|name| {
        !matches!(&name[..], "V_IMPORT" | "V_CDECL" | "V_DLLIMPORT" | "V_DLLEXPORT")
    });
    names
}

/// Compiles a C program whose assertions hold.
fn assertions(name: &str, lines: &str) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join(format!("{name}.c"));
    let text = format!(
        "#include <rlex.h>\n#include <stddef.h>\n\
         #define HOLDS(x) _Static_assert(x, #x)\n{lines}"
    );
    std::fs::write(&file, text).expect("the source can be written");
    let include = root().join("include");
    run(Command::new("cc").args(["-std=c11", "-fsyntax-only", "-I"]).arg(include).arg(&file));
}

/// The headers name exactly the constants of the table, with their values.
#[test]
fn constants_have_their_values() {
    let rows = table("constants.txt");
    let names: BTreeSet<String> = rows.iter().map(|row| row[0].clone()).collect();
    assert_eq!(names.len(), 497);
    let named = constants();
    let missing: Vec<_> = names.symmetric_difference(&named).collect();
    assert!(missing.is_empty(), "{missing:?}");
    let mut lines = String::new();
    for row in rows {
        writeln!(lines, "HOLDS((v_u32)({}) == {}u);", row[0], row[1]).expect("text grows");
    }
    assertions("constants", &lines);
}

/// Every structure has the table's members in their order, packed as on the
/// original machines but for the size of pointers and longs.
#[test]
fn structures_have_their_members() {
    let mut lines = String::new();
    for row in table("layouts.txt") {
        let (name, members) = row.split_first().expect("a name");
        let mut offset = "0".to_string();
        for member in members {
            let (member, size) = member.split_once(':').unwrap_or((member, "4"));
            let size = match size {
                "p" => "sizeof(void *)",
                "l" => "sizeof(long)",
                size => size,
            };
            let at = format!("(({offset}) + ({size}) - 1) / ({size}) * ({size})");
            writeln!(lines, "HOLDS(offsetof({name}, {member}) == {at});").expect("text grows");
            writeln!(lines, "HOLDS(sizeof((({name} *)0)->{member}) == {size});").expect("it grows");
            offset = format!("offsetof({name}, {member}) + {size}");
        }
        writeln!(lines, "HOLDS(sizeof({name}) - ({offset}) < sizeof(void *));").expect("it grows");
    }
    lines.push_str(
        "HOLDS(V_FIFO_PACK_XY(0x12345, 0xABCDE) == 0x2345BCDEu);\n\
         HOLDS(V_SCISSORX(1, 2) == 0x10002u); HOLDS(V_SCISSORY(3, 4) == 0x30004u);\n\
         HOLDS(V_DITHEROFFSET(2, 3) == 0x32u); HOLDS(V_FIFO_VTX_CMD(18, 24) == 0x120018u);\n\
         HOLDS(V_FIFO_FLAGS_CMD(1, 18) == 0x10012u);\n\
         HOLDS(V_FIFO_SSMSK(3) + V_FIFO_SSOP(2) + V_FIFO_SSSHFT(1) + V_FIFO_SSREG(92) == 0x320DCu);\n\
         HOLDS(V_PIXEL_SIZE(V_PIXFMT_332) == 1 && V_PIXEL_SIZE(V_PIXFMT_4444) == 2);\n\
         HOLDS(V_PIXEL_SIZE(V_PIXFMT_8888) == 4 && V_PIXEL_SIZE(V_PIXFMT_Y0CRY1CB) == 2);\n\
         HOLDS(V_PIXEL_SIZE(V_PIXFMT_4I_565) == 0 && V_PIXEL_SIZE(99) == 0);\n",
    );
    assertions("layouts", &lines);
}

/// The headers compile by themselves, twice, in every mode of C and as C++.
#[test]
fn headers_stand_alone() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let strict = ["-Wall", "-Wextra", "-Werror", "-pedantic", "-fsyntax-only"];
    for name in HEADERS {
        let file = folder.path().join("twice.c");
        let text = format!("#include <{name}.h>\n#include <{name}.h>\nint used;\n");
        std::fs::write(&file, text).expect("the source can be written");
        for (compiler, standard) in
            [("cc", "c89"), ("cc", "c99"), ("cc", "c17"), ("c++", "c++98"), ("c++", "c++17")]
        {
            let mut command = Command::new(compiler);
            let language = if compiler == "cc" { "c" } else { "c++" };
            command.args(["-x", language, &format!("-std={standard}"), "-I"]);
            run(command.arg(root().join("include")).args(strict).arg(&file));
        }
    }
}
