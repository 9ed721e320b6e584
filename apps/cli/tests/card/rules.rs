//! Every rule of the checking mode, broken from C.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

use fillrate_glide::rules;

use super::super::{library_folder, root, run};
use super::compiled;

/// What the callback heard: step, fatal or not, message.
type Heard = (i64, bool, String);

fn misuse(program: &Path, board: &str, arguments: &[&str], check: bool) -> Vec<Heard> {
    let mut command = Command::new(program);
    for (name, _) in std::env::vars().filter(|(name, _)| name.starts_with("FILLRATE_")) {
        command.env_remove(name);
    }
    command.args(arguments).env("LD_LIBRARY_PATH", library_folder()).env("FILLRATE_CARD", board);
    command.env("FILLRATE_CHECK", if check { "1" } else { "0" });
    let output = run(&mut command);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let line = |line: &str| {
        let mut parts = line.splitn(3, '\t');
        let (step, fatal) = (parts.next()?.parse().ok()?, parts.next()? == "1");
        Some((step, fatal, parts.next()?.to_string()))
    };
    text.lines().filter_map(line).collect()
}

fn message(function: &str, argument: &str, text: &str) -> String {
    let gap = if argument.is_empty() { "" } else { " " };
    format!("{function}: {argument}{gap}{text}")
}

/// A message with the name of the function whose rule it is.
fn under_the_rule(text: &str) -> String {
    let (name, rest) = text.split_once(':').expect("messages begin with a function");
    let shared = rules::SHARED.iter().find(|(shared, _)| *shared == name);
    format!("{}:{rest}", shared.map_or(name, |(_, function)| function))
}

#[test]
fn every_rule_is_told_of() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let program = compiled(&folder, "misuse");
    let mut heard = misuse(&program, "voodoo-4mb", &[], true);
    // Setting the stage breaks no rule, and every step breaks one.
    assert!(heard.iter().all(|(step, ..)| *step > 0), "{heard:?}");
    let steps: BTreeSet<i64> = heard.iter().map(|(step, ..)| *step).collect();
    let last = steps.last().copied().expect("steps");
    let silent: Vec<i64> = (1..=last).filter(|step| !steps.contains(step)).collect();
    assert_eq!(silent, Vec::<i64>::new());
    heard.extend(misuse(&program, "voodoo-6mb", &["banks"], true));
    heard.extend(misuse(&program, "voodoo-sli-8mb", &["halves"], true));
    let told: BTreeSet<(bool, String)> =
        heard.into_iter().map(|(_, fatal, text)| (fatal, text)).collect();
    let names: BTreeSet<&str> =
        told.iter().filter_map(|(_, text)| text.split(':').next()).collect();
    for (name, _) in rules::SHARED {
        assert!(names.contains(name), "{name} is told of under another name");
    }
    let told: BTreeSet<(bool, String)> =
        told.iter().map(|(fatal, text)| (*fatal, under_the_rule(text))).collect();
    for rule in rules::all() {
        let expected = (rule.fatal, message(rule.function, rule.argument, rule.text));
        assert!(told.contains(&expected), "nobody was told: {}", expected.1);
    }
    let known: BTreeSet<(bool, String)> = rules::all()
        .map(|rule| (rule.fatal, message(rule.function, rule.argument, rule.text)))
        .collect();
    for (fatal, text) in &told {
        let general = rules::GENERAL.iter().any(|(argument, rule)| {
            text.ends_with(message("", argument, rule).trim_start_matches(": "))
        });
        assert!(general || known.contains(&(*fatal, text.clone())), "in no table: {text}");
    }
    for (argument, rule) in rules::GENERAL {
        let end = message("", argument, rule);
        assert!(told.iter().any(|(_, text)| text.ends_with(end.trim_start_matches(": "))), "{end}");
    }
}

/// Without checking, only what the release library reported is.
#[test]
fn the_release_library_keeps_nearly_everything_to_itself() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let program = compiled(&folder, "misuse");
    let heard = misuse(&program, "voodoo-4mb", &[], false);
    let functions: BTreeSet<&str> =
        heard.iter().filter_map(|(.., text)| text.split(':').next()).collect();
    let always = ["grSstSelect", "grTexCombineFunction", "guTexCombineFunction"];
    let addresses = [
        "grTexDownloadMipMap",
        "grTexDownloadMipMapLevel",
        "grTexDownloadMipMapLevelPartial",
        "grTexMultibaseAddress",
        "grTexSource",
    ];
    let expected: BTreeSet<&str> = always.into_iter().chain(addresses).collect();
    assert!(functions.is_subset(&expected), "{functions:?}");
    assert!(functions.contains("grSstSelect"), "{functions:?}");
}

/// The debugging library checks without being asked, and can be told not to.
#[test]
fn the_debugging_library_checks_by_default() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    run(Command::new(env!("CARGO"))
        .args(["build", "--quiet", "--offline", "-p", "fillrate-glide2x-debug"])
        .current_dir(root()));
    let library = library_folder().join("..").join("libglide2x_debug.so");
    let program = folder.path().join("misuse");
    run(Command::new("cc")
        .arg("-I")
        .arg(root().join("include"))
        .arg(root().join("tests/c/misuse.c"))
        .arg(&library)
        .arg("-o")
        .arg(&program));
    let heard = |check: Option<&str>| {
        let mut command = Command::new(&program);
        command.env_remove("FILLRATE_CHECK").env("FILLRATE_CARD", "voodoo-4mb");
        command.env("LD_LIBRARY_PATH", library.parent().expect("a folder"));
        check.map(|value| command.env("FILLRATE_CHECK", value));
        run(&mut command).stdout.iter().filter(|&&byte| byte == b'\n').count()
    };
    assert!(heard(None) > 140 && heard(Some("0")) < 30);
}
