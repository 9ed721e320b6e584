//! Which functions the C programs call: a library in front of ours notes each.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::super::{root, run};
use super::{Program, compile, conformance_programs, entry_points, sources};

/// C and assembly of a library with every entry point: each notes its number
/// and goes on to the real one. At the end the numbers are appended to the file
/// that `CALLS` names.
fn watcher() -> String {
    let names: Vec<String> = entry_points().into_iter().map(|(name, _)| name).collect();
    let mut text = format!(
        "#define _GNU_SOURCE\n#include <dlfcn.h>\n#include <stdio.h>\n#include <stdlib.h>\n\
         void *real[{0}];\nunsigned char called[{0}];\nstatic const char *names[] = {{",
        names.len()
    );
    for name in &names {
        write!(text, "\"{name}\",").expect("text grows");
    }
    text.push_str(
        "};\n__attribute__((constructor)) static void find(void) {\n\
         for (unsigned i = 0; i < sizeof names / sizeof *names; i++)\n\
         real[i] = dlsym(RTLD_NEXT, names[i]);\n}\n\
         __attribute__((destructor)) static void tell(void) {\n\
         FILE *out = getenv(\"CALLS\") ? fopen(getenv(\"CALLS\"), \"a\") : 0;\n\
         for (unsigned i = 0; out && i < sizeof names / sizeof *names; i++)\n\
         if (called[i]) fprintf(out, \"%s\\n\", names[i]);\n\
         if (out) fclose(out);\n}\n__asm__(\".text\\n\"\n",
    );
    for (i, name) in names.iter().enumerate() {
        let stub = format!(
            "\".globl {name}\\n.type {name},@function\\n{name}:\\n\
             pushq %rax\\nmovq called@GOTPCREL(%rip), %rax\\nmovb $1, {i}(%rax)\\n\
             movq real@GOTPCREL(%rip), %r11\\npopq %rax\\njmp *{}(%r11)\\n\"\n",
            8 * i
        );
        text.push_str(&stub);
    }
    text.push_str(");\n");
    text
}

fn build_watcher(folder: &Path) -> PathBuf {
    let (source, library) = (folder.join("watch.c"), folder.join("libwatch.so"));
    std::fs::write(&source, watcher()).expect("the source can be written");
    let mut command = Command::new("cc");
    run(command.args(["-shared", "-fPIC", "-o"]).arg(&library).arg(&source).arg("-ldl"));
    library
}

/// Every entry point is called by some program of the tests or examples.
#[test]
fn every_function_is_called() {
    if !cfg!(all(target_arch = "x86_64", target_os = "linux")) {
        println!("NOT CHECKED: the stubs that note calls are for x86-64 Linux");
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (watcher, calls) = (build_watcher(folder.path()), folder.path().join("calls"));
    let examples = sources("examples/glide");
    let abuse: Vec<PathBuf> =
        ["bad_input", "bad_values"].map(|name| root().join(format!("tests/c/{name}.c"))).into();
    let others = compile(&[examples, abuse].concat(), folder.path());
    let watch = |program: &Program| {
        let mut command = program.command(folder.path());
        command.env("LD_PRELOAD", &watcher).env("CALLS", &calls).env("FILLRATE_EXIT_AFTER", "60");
        run(&mut command);
    };
    conformance_programs().iter().chain(&others).for_each(watch);
    let called = std::fs::read_to_string(&calls).expect("some calls");
    let called: BTreeSet<&str> = called.lines().collect();
    let table = entry_points();
    let never: Vec<&str> =
        table.iter().map(|(name, _)| &name[..]).filter(|name| !called.contains(name)).collect();
    assert!(never.is_empty(), "never called: {never:?}");
}

/// Any arguments: nothing crashes, hangs or writes elsewhere, and the board
/// draws afterwards. `FILLRATE_CASES` sets how many calls of each run.
#[test]
fn any_arguments_are_survived() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let programs = compile(&[root().join("tests/c/border.c")], folder.path());
    let calls = std::env::var("FILLRATE_CASES").unwrap_or("30000".into());
    for (seed, check, boards) in
        [("1", "0", "1"), ("2", "1", "1"), ("3", "0", "4"), ("4", "1", "2")]
    {
        let mut command = programs[0].command(folder.path());
        command.env("FILLRATE_CHECK", check).env("FILLRATE_BOARDS", boards);
        run(command.args([&calls, seed]));
    }
}
