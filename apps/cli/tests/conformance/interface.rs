//! The headers and the library against the table of entry points, and the
//! tests of constants and layouts against the headers.

use std::collections::{BTreeMap, BTreeSet};
use std::process::Command;

use super::super::{library_folder, root, run};
use super::entry_points;

/// All headers, without comments.
fn headers() -> String {
    let names = ["3dfx", "fxdll", "glidesys", "sst1vid", "glide", "glideutl", "gump"];
    let mut text = String::new();
    for name in names {
        let file = root().join(format!("include/{name}.h"));
        let mut rest = &std::fs::read_to_string(file).expect("a header")[..];
        while let Some((before, after)) = rest.split_once("/*") {
            text.push_str(before);
            rest = after.split_once("*/").expect("comments end").1;
        }
        text.push_str(rest);
    }
    text
}

/// Bytes of arguments of every prototype. All arguments are numbers of at most
/// four bytes, or pointers, which had four.
fn prototypes() -> BTreeMap<String, usize> {
    let headers = headers();
    let declarations = headers.split("FX_ENTRY ").skip(1);
    declarations
        .filter_map(|text| {
            let (declaration, _) = text.split_once(';')?;
            let (_, called) = declaration.split_once("FX_CALL")?;
            let (name, arguments) = called.split_once('(')?;
            let arguments = arguments.trim_end().strip_suffix(')')?;
            let count = if arguments.trim() == "void" { 0 } else { arguments.split(',').count() };
            Some((name.trim().to_string(), 4 * count))
        })
        .collect()
}

/// Functions that a library exports.
fn exports(library: &std::path::Path) -> BTreeSet<String> {
    let output = run(Command::new("nm").args(["-D", "--defined-only"]).arg(library));
    String::from_utf8_lossy(&output.stdout)
        .lines()
        .filter_map(|line| line.split_whitespace().nth(2))
        .filter(|name| ["gr", "gu", "Convert"].iter().any(|prefix| name.starts_with(prefix)))
        .map(str::to_string)
        .collect()
}

#[test]
fn headers_and_library_have_every_entry_point() {
    let table: BTreeMap<String, usize> = entry_points().into_iter().collect();
    assert_eq!(table.len(), 144);
    assert_eq!(prototypes(), table);
    let names: BTreeSet<String> = table.into_keys().collect();
    assert_eq!(exports(&library_folder().join("libglide2x.so")), names);
}

/// Every number that the headers name is compared with its value in values.c.
#[test]
fn every_constant_is_checked() {
    let values = std::fs::read_to_string(root().join("tests/c/values.c")).expect("the test");
    let headers = headers();
    let names: Vec<&str> = headers
        .lines()
        .filter_map(|line| line.trim().strip_prefix("#define "))
        .filter_map(|rest| rest.split_once(char::is_whitespace))
        .map(|(name, _)| name)
        .filter(|name| name.starts_with("GR_") && !name.contains('('))
        .collect();
    assert!(names.len() > 250, "{}", names.len());
    let missing: Vec<&&str> = names
        .iter()
        .filter(|name| {
            let call =
                [format!("VALUE({name},"), format!("CHECK({name} =="), format!("&& {name} ==")];
            !call.iter().any(|call| values.contains(call.as_str()))
        })
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}

/// Every field of every structure is compared with its offset in layout.c, and
/// every structure with its size.
#[test]
fn every_field_is_checked() {
    let layout = std::fs::read_to_string(root().join("tests/c/layout.c")).expect("the test");
    let headers = headers();
    let mut missing = Vec::new();
    let mut count = 0;
    for text in headers.split("typedef struct {").skip(1) {
        let (body, rest) = text.split_once("\n}").expect("a structure ends");
        let name = rest.split_once(';').expect("a structure has a name").0.trim();
        if !layout.contains(&format!("SIZE({name},"))
            && !layout.contains(&format!("sizeof({name})"))
        {
            missing.push(name.to_string());
        }
        // What is inside a union has its own structure.
        for declaration in body.split(';').filter(|d| !d.contains('{') && !d.contains('}')) {
            let after_type = declaration.trim().split_once(char::is_whitespace);
            for field in after_type.map_or("", |(_, fields)| fields).split(',') {
                let field = field.trim().trim_start_matches('*');
                let field = field.split('[').next().unwrap_or_default().trim();
                if field.is_empty() || matches!(name, "GrState" | "GrSstConfig_t" | "GuTexPalette")
                {
                    continue;
                }
                count += 1;
                let checks = [
                    format!("FIELD({name}, {field},"),
                    format!("FIELD({name}, {field}[0]."),
                    format!("FLOAT({field},"),
                ];
                if !checks.iter().any(|check| layout.contains(check)) {
                    missing.push(format!("{name}.{field}"));
                }
            }
        }
    }
    assert!(count > 70, "{count}");
    assert!(missing.is_empty(), "{missing:?}");
}
