//! `fillrate-level`: flies through a level.

#![forbid(unsafe_code)]

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

use anyhow::{Context, Result, bail};
use clap::Parser;
use fillrate_engine::DeviceConfig;
use fillrate_glide::Improvements;
use fillrate_glide::card::{Card, RESOLUTIONS};
use fillrate_level::assets::Assets;
use fillrate_level::camera::Path;
use fillrate_level::draw::{Difference, DrawOptions, FrameStats, ROUNDING, Renderer};
use fillrate_level::level::{Level, level_names};
use fillrate_level::output::Output;
use fillrate_level::synthetic;
use fillrate_level::view::View;

/// Flies through a level, drawn by Glide on a modelled board.
#[derive(Debug, Parser)]
#[command(version, about)]
struct Options {
    /// Folder with the game's archives (.pk3); scripts/fetch-level.sh makes one
    #[arg(long, value_name = "DIR")]
    data: Option<PathBuf>,
    /// Level; without one, a level made here
    #[arg(long, value_name = "NAME", default_value = synthetic::NAME)]
    map: String,
    /// Print the names of all levels
    #[arg(long)]
    list: bool,
    /// Size of the picture, as WIDTHxHEIGHT
    #[arg(long, value_name = "SIZE", default_value = "640x480")]
    size: String,
    /// Frames of the flight around the level
    #[arg(long, value_name = "N", default_value_t = 600, value_parser = clap::value_parser!(u64).range(1..))]
    frames: u64,
    /// Part of the flight to draw: start and end, 0 to 1
    #[arg(long, value_name = "FROM:TO", default_value = "0:1")]
    part: String,
    /// Picture and lightmap in one pass on two units, or in two on one
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=2))]
    passes: u32,
    /// Draw every frame in one pass and in two, and print the largest difference
    #[arg(long)]
    compare: bool,
    /// Fog, of this density
    #[arg(long, value_name = "DENSITY", num_args = 0..=1, default_missing_value = "0.0008")]
    fog: Option<f32>,
    /// Board to model
    #[arg(long, value_name = "NAME", default_value = "arcade-12mb-2tmu")]
    card: String,
    /// Longest side of textures: 256, 128, 64 or 32
    #[arg(long, value_name = "TEXELS", default_value_t = 256)]
    texels: usize,
    /// Threads that draw
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    threads: Option<u16>,
    /// Write frames as PNG into this folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write a video (y4m) into this file; - is the standard output
    #[arg(long, value_name = "FILE")]
    video: Option<PathBuf>,
    /// Frames as on the monitor: with the board's gamma
    #[arg(long)]
    gamma: bool,
    /// Draw every pixel as N by N
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=4))]
    scale: u8,
    /// Scale frames back: each pixel is the mean of those drawn for it
    #[arg(long)]
    supersample: bool,
    /// Eight bits a colour channel, without dithering
    #[arg(long)]
    color32: bool,
    /// Report every misuse of Glide
    #[arg(long)]
    check: bool,
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(error) => {
            eprintln!("fillrate-level: {error:#}");
            ExitCode::from(3)
        }
    }
}

fn draw_options(options: &Options, passes: u32) -> Result<DrawOptions> {
    let card = Card::by_name(&options.card)
        .with_context(|| format!("there is no board '{}'", options.card))?;
    let resolution = RESOLUTIONS
        .iter()
        .position(|(w, h)| format!("{w}x{h}") == options.size)
        .with_context(|| format!("a board cannot show {}", options.size))?;
    let mut device = DeviceConfig::default();
    device.threads = options.threads.map_or(device.threads, usize::from);
    Ok(DrawOptions {
        card,
        resolution: resolution as i32,
        passes,
        fog: options.fog,
        device,
        check: options.check,
        improve: Improvements {
            scale: u32::from(options.scale),
            color32: options.color32,
            supersample: options.supersample,
        },
    })
}

fn part(text: &str) -> Result<(f32, f32)> {
    let parse = |text: &str| text.parse().ok().filter(|v: &f32| v.is_finite());
    let both = text.split_once(':').and_then(|(a, b)| Some((parse(a)?, parse(b)?)));
    both.with_context(|| format!("'{text}' is not FROM:TO"))
}

fn run(options: &Options) -> Result<bool> {
    let mut assets = match &options.data {
        Some(folder) => Assets::open(folder)?,
        None => synthetic::assets(),
    };
    if options.list {
        level_names(&assets).iter().for_each(|name| println!("{name}"));
        return Ok(true);
    }
    if options.data.is_none() && options.map != synthetic::NAME {
        bail!("'{}' needs --data; scripts/fetch-level.sh fetches free levels", options.map);
    }
    let level = Level::load(&mut assets, &options.map, options.texels)?;
    let (pictures, maps) =
        (level.textures.len() - level.bsp.lightmaps.len(), level.bsp.lightmaps.len());
    eprintln!(
        "{}: {} surfaces, {} triangles, {pictures} pictures, {maps} lightmaps, {} starting points",
        options.map,
        level.surfaces.len(),
        level.triangle_count(),
        level.spawns.len()
    );
    let skipped = &level.skipped;
    if skipped.invalid + skipped.missing_pictures > 0 {
        eprintln!(
            "not drawn: {} invalid surfaces; in grey: {} pictures not found",
            skipped.invalid, skipped.missing_pictures
        );
    }
    let passes = if options.compare { vec![1, 2] } else { vec![options.passes] };
    let mut renderers = passes
        .into_iter()
        .map(|passes| Renderer::new(draw_options(options, passes)?, level.surfaces.len()))
        .collect::<Result<Vec<_>>>()?;
    fly(options, &level, &mut renderers)
}

/// Draws the flight. False where misuse was found.
fn fly(options: &Options, level: &Level, renderers: &mut [Renderer]) -> Result<bool> {
    let path = Path::new(&level.bsp, &level.spawns, [0.0, 0.0, 64.0]);
    let (from, to) = part(&options.part)?;
    let mut output = Output::new(options.out.as_deref(), options.video.as_deref(), options.gamma)?;
    let (width, height) = renderers[0].size();
    let mut stats = Vec::new();
    let mut difference = Difference::default();
    let mut clean = true;
    for frame in 0..options.frames {
        let t = from + (to - from) * frame as f32 / options.frames as f32;
        let view = View::new(path.camera(t), width, height);
        for renderer in renderers.iter_mut() {
            stats.push(renderer.draw(level, &view, frame as f32 / 60.0));
            for problem in renderer.problems() {
                eprintln!("fillrate-level: {problem}");
                clean = false;
            }
        }
        if let [one, two] = renderers
            && let (Some(one), Some(two)) = (one.shown(), two.shown())
        {
            difference.add(&one, &two);
        }
        if output.wants_frames()
            && let Some(shown) = renderers[0].shown()
        {
            output.frame(shown)?;
        }
    }
    output.finish()?;
    report(&stats);
    if renderers.len() == 2 {
        let Difference { largest, pixels, beyond } = difference;
        eprintln!(
            "one pass and two differ by {largest} of 255 at most; {beyond} of {pixels} pixels by \
             more than rounding ({ROUNDING})"
        );
    }
    Ok(clean)
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1000.0
}

fn report(stats: &[FrameStats]) {
    let count = stats.len() as f64;
    let mean = |value: fn(&FrameStats) -> f64| stats.iter().map(value).sum::<f64>() / count;
    let mut times: Vec<f64> = stats.iter().map(|s| milliseconds(s.total)).collect();
    times.sort_by(f64::total_cmp);
    let at = |part: f64| times[((times.len() - 1) as f64 * part) as usize];
    eprintln!(
        "{} frames; a frame: {:.0} triangles of {:.0} surfaces, {:.2} downloads",
        stats.len(),
        mean(|s| s.triangles as f64),
        mean(|s| s.surfaces as f64),
        mean(|s| s.downloads as f64)
    );
    eprintln!(
        "frame times in ms: median {:.2}, fastest {:.2}, 95 % {:.2}, slowest {:.2}; \
         mean {:.2}, of it {:.2} before drawing",
        at(0.5),
        at(0.0),
        at(0.95),
        at(1.0),
        mean(|s| milliseconds(s.total)),
        mean(|s| milliseconds(s.front))
    );
    eprintln!("{:.1} frames/s", 1000.0 / mean(|s| milliseconds(s.total)));
}
