//! `fillrate doctor`: what this machine offers and how we are set up.

use anyhow::Result;
use clap::Args;
use fillrate_simd::Level;
use serde_json::json;

use crate::Outcome;
use crate::library;

/// Options of `fillrate doctor`.
#[derive(Args, Debug)]
pub struct DoctorArgs {
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

/// The command.
pub fn doctor(args: &DoctorArgs) -> Result<Outcome> {
    let levels: Vec<&str> = Level::available().map(Level::name).collect();
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let found = library::folder();
    let settings = variables();
    let loaded = fillrate_settings::Settings::load();
    if args.json {
        let object = json!({
            "version": env!("CARGO_PKG_VERSION"),
            "target": std::env::consts::ARCH,
            "levels": levels,
            "best": Level::best().name(),
            "cores": threads,
            "library": found,
            "config": loaded.file,
            "problems": loaded.problems,
            "variables": settings.iter().cloned().collect::<std::collections::BTreeMap<_, _>>(),
        });
        println!("{object}");
        return Ok(if found.is_some() { Outcome::Same } else { Outcome::BadInput });
    }
    println!("fillrate {} on {}", env!("CARGO_PKG_VERSION"), std::env::consts::ARCH);
    println!("simd levels  {} (best: {})", levels.join(" "), Level::best());
    println!("cores        {threads}");
    match &found {
        Some(folder) => println!("libraries    {}", folder.display()),
        None => println!("libraries    not found"),
    }
    for folder in library::candidates() {
        let mark = if Some(&folder) == found.as_ref() { "*" } else { " " };
        println!("  looked in {mark} {}", folder.display());
    }
    for library in library::LIBRARIES {
        let state = if library::folder_of(library).is_some() { "found" } else { "not found" };
        println!("library      {} {state}", library::file_name(library));
    }
    if settings.is_empty() {
        println!("variables    none set");
    }
    for (name, value) in &settings {
        println!("variable     {name}={value}");
    }
    match &loaded.file {
        Some(file) => println!("settings     {}", file.display()),
        None => println!("settings     no fillrate.toml"),
    }
    for problem in &loaded.problems {
        println!("problem      {problem}");
    }
    if !loaded.problems.is_empty() {
        return Ok(Outcome::BadInput);
    }
    Ok(if found.is_some() { Outcome::Same } else { Outcome::BadInput })
}

/// Our variables and the original library's that are set, by name.
fn variables() -> Vec<(String, String)> {
    let ours = |name: &str| {
        ["FILLRATE_", "FX_GLIDE_", "SST_"].iter().any(|prefix| name.starts_with(prefix))
    };
    let mut list: Vec<_> = std::env::vars().filter(|(name, _)| ours(name)).collect();
    list.sort();
    list
}
