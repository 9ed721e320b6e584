//! `fillrate demo`: every example scene as a gallery.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use anyhow::{Context, Result, bail};
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};

use fillrate_player::{Frame, Pixels};

use crate::Outcome;
use crate::gallery::{self, Picture};
use crate::library;
use crate::run::{Request, execute};
use crate::settings::Settings;

/// Options of `fillrate demo`.
#[derive(Args, Debug)]
pub struct DemoArgs {
    #[command(flatten)]
    settings: Settings,
    /// Folder for the pictures and the page
    #[arg(long, value_name = "DIR", default_value = "gallery")]
    out: PathBuf,
    /// Draw only the scenes whose name starts with this
    #[arg(long, value_name = "PREFIX", default_value = "")]
    only: String,
    /// The folder with `examples` and `include`
    #[arg(long, value_name = "DIR")]
    source: Option<PathBuf>,
    /// Folder of the game whose level is shown; default: level-data, else a
    /// level made here
    #[arg(long, value_name = "DIR")]
    level_data: Option<PathBuf>,
    /// Print one JSON object a scene instead of a table
    #[arg(long)]
    json: bool,
}

/// The command.
pub fn demo(args: &DemoArgs) -> Result<Outcome> {
    let source = source_folder(args.source.as_deref())?;
    let scenes = scenes(&source, &args.only)?;
    if scenes.is_empty() && !LEVEL.starts_with(&args.only) {
        bail!("no example starts with '{}'", args.only);
    }
    std::fs::create_dir_all(&args.out)
        .with_context(|| format!("cannot create {}", args.out.display()))?;
    let build = tempfile::tempdir()?;
    let progress = progress_bar(scenes.len() as u64);
    let mut pictures = Vec::new();
    for scene in &scenes {
        progress.set_message(scene.name.clone());
        let program = compile(&source, scene, build.path())?;
        pictures.push(draw(args, scene, &program, build.path())?);
        progress.inc(1);
    }
    progress.finish_and_clear();
    if LEVEL.starts_with(&args.only) {
        pictures.push(fly(args, &source)?);
    }
    gallery::write_page(&args.out, &pictures)?;
    report(args, &pictures)?;
    Ok(Outcome::Same)
}

/// The folders of examples, each with the library its programs link.
const EXAMPLES: [(&str, &str); 5] = [
    ("examples/glide", library::GLIDE2X),
    ("examples/raw", library::RENDER_CLIENT),
    ("examples/quark", library::QUARK3D),
    ("examples/rave", library::RAVE),
    ("examples/redline", library::REDLINE),
];

/// A program of the examples.
struct Scene {
    name: String,
    file: PathBuf,
    library: &'static str,
}

/// The checkout: as asked, the working directory, or where this was built.
fn source_folder(asked: Option<&Path>) -> Result<PathBuf> {
    let built = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let candidates = match asked {
        Some(folder) => vec![folder.to_path_buf()],
        None => vec![PathBuf::from("."), built],
    };
    candidates
        .into_iter()
        .find(|folder| folder.join("examples/glide").is_dir() && folder.join("include").is_dir())
        .context("no folder with 'examples' and 'include' was found; name one with --source")
}

/// The scenes by name. A file that others share starts with "common".
fn scenes(source: &Path, prefix: &str) -> Result<Vec<Scene>> {
    let mut scenes = Vec::new();
    for (folder, library) in EXAMPLES {
        let folder = source.join(folder);
        if !folder.is_dir() {
            continue;
        }
        for entry in std::fs::read_dir(folder)? {
            let file = entry?.path();
            let Some(name) = file.file_stem().and_then(|name| name.to_str()) else { continue };
            let is_program = file.extension().is_some_and(|e| e == "c" || e == "cpp");
            if is_program && !name.starts_with("common") && name.starts_with(prefix) {
                scenes.push(Scene { name: name.to_string(), file: file.clone(), library });
            }
        }
    }
    scenes.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(scenes)
}

/// Builds an example with the system's C or C++ compiler, as its author would.
fn compile(source: &Path, scene: &Scene, build: &Path) -> Result<PathBuf> {
    let program = build.join(&scene.name);
    let is_cpp = scene.file.extension().is_some_and(|extension| extension == "cpp");
    let (variable, usual, standard) =
        if is_cpp { ("CXX", "c++", "-std=c++17") } else { ("CC", "cc", "-std=c99") };
    let compiler = std::env::var(variable).unwrap_or_else(|_| usual.into());
    let common = scene.file.with_file_name("common.c");
    let mut command = Command::new(&compiler);
    command.args([standard, "-O2", "-I"]).arg(source.join("include")).arg(&scene.file);
    if common.is_file() {
        command.arg(common);
    }
    command.arg("-o").arg(&program).arg("-L").arg(library::need(scene.library)?);
    command.arg(format!("-l{}", scene.library));
    command.args(library::also(scene.library).iter().map(|also| format!("-l{also}"))).arg("-lm");
    let output = command
        .output()
        .with_context(|| format!("cannot start the compiler '{compiler}'; set {variable}"))?;
    if !output.status.success() {
        bail!("{} does not compile:\n{}", scene.name, String::from_utf8_lossy(&output.stderr));
    }
    Ok(program)
}

/// Runs an example and keeps its last frame.
fn draw(args: &DemoArgs, scene: &Scene, program: &Path, build: &Path) -> Result<Picture> {
    let folder = build.join(format!("{}-frames", scene.name));
    std::fs::create_dir_all(&folder)?;
    let finished = execute(
        &[program.as_os_str().to_os_string()],
        &Request {
            settings: args.settings.clone(),
            frames: None,
            every: 1,
            folder: &folder,
            trace: None,
            variables: Vec::new(),
            quiet: true,
        },
    )?;
    if !finished.success {
        bail!("{} ended with {}", scene.name, finished.ending);
    }
    let Some(last) = finished.frames.last() else { bail!("{} shows no frame", scene.name) };
    let file = format!("{}.png", scene.name);
    std::fs::copy(folder.join(format!("frame_{:05}.png", last.frame)), args.out.join(&file))?;
    let drawing: Duration =
        finished.frames.iter().map(|note| Duration::from_nanos(note.nanoseconds)).sum();
    Ok(Picture {
        name: scene.name.clone(),
        file,
        width: last.width,
        height: last.height,
        hash: last.hash.clone(),
        frames: finished.frames.len(),
        triangles: finished.frames.iter().map(|note| note.triangles).sum(),
        pixels: finished.frames.iter().map(|note| note.pixels).sum(),
        seconds: drawing.as_secs_f64(),
        threads: args.settings.device().threads,
        simd: args.settings.device().level.to_string(),
    })
}

/// The scene that flies through a level.
const LEVEL: &str = "level";
/// Its frames.
const LEVEL_FRAMES: usize = 90;

/// Flies through a level: one that `scripts/fetch-level.sh` fetched, whose name
/// the picture then has, or else the one that the viewer makes.
fn fly(args: &DemoArgs, source: &Path) -> Result<Picture> {
    let fetched = args.level_data.clone().unwrap_or_else(|| source.join("level-data"));
    let data = (args.level_data.is_some() || fetched.is_dir()).then_some(fetched.as_path());
    let device = args.settings.device();
    let (threads, simd) = (device.threads, device.level.to_string());
    let flight = fillrate_level::flight::fly(data, device, LEVEL_FRAMES)?;
    let name = if data.is_some() { flight.name } else { LEVEL.to_string() };
    let (width, height) = (flight.shown.width, flight.shown.height);
    let frame = Frame::new(width, height, Pixels::Rgb565(flight.shown.pixels))?;
    let file = format!("{name}.png");
    frame.save_png(&args.out.join(&file))?;
    Ok(Picture {
        name,
        file,
        width,
        height,
        hash: format!("{:016x}", frame.hash()),
        frames: flight.frames,
        triangles: flight.triangles,
        pixels: flight.fragments,
        seconds: flight.seconds,
        threads,
        simd,
    })
}

/// A bar on a terminal, nothing in a pipe.
fn progress_bar(length: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}");
    ProgressBar::new(length).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

fn report(args: &DemoArgs, pictures: &[Picture]) -> Result<()> {
    if args.json {
        for picture in pictures {
            println!("{}", serde_json::to_string(picture)?);
        }
        return Ok(());
    }
    println!(
        "{:14} {:16} {:>7} {:>8} {:>10} {:>9}",
        "scene", "hash", "frames", "frames/s", "triangles", "Mpixel/s"
    );
    for p in pictures {
        println!(
            "{:14} {:16} {:>7} {:>8.0} {:>10} {:>9.1}",
            p.name,
            p.hash,
            p.frames,
            p.frame_rate(),
            p.triangles,
            p.rate()
        );
    }
    println!("\n{}", args.out.join("index.html").display());
    Ok(())
}
