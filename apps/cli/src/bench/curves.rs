//! `fillrate bench --curves`: how cost grows with threads, resolution,
//! triangles and textures.

use std::path::Path;

use anyhow::{Context as _, Result, bail};
use fillrate_engine::{Counters, DeviceConfig};
use serde::Serialize;

use super::chart::{Chart, Line};
use super::digest::Digests;
use super::drawing::{self, Drawing};
use super::measure::Job;
use super::size::Size;
use super::workload::{Kind, Workload};

/// The size of everything but the resolutions.
const SCREEN: Size = Size { width: 640, height: 480 };
/// Threads measured. More than there are cores show that the work of a frame
/// does not grow.
const THREADS: [usize; 5] = [1, 2, 4, 8, 16];
/// Sides of the square pictures.
const SIDES: [u32; 5] = [256, 512, 1024, 2048, 4096];
/// Pixels of the triangles.
const AREAS: [u32; 10] = [1, 2, 5, 10, 20, 50, 100, 1000, 10_000, 100_000];
/// Sides of the textures.
const TEXTURES: [u32; 9] = [8, 16, 32, 64, 128, 256, 512, 1024, 2048];

/// Pixels that a frame of the triangle curve covers, about.
const TRIANGLE_PIXELS: u32 = 4_000_000;
/// Triangles that it has at most.
const MAX_TRIANGLES: u32 = 200_000;

/// A point of a curve.
#[derive(Clone, Debug, Serialize)]
struct Point {
    curve: &'static str,
    line: String,
    x: f64,
    threads: usize,
    simd: &'static str,
    /// Frames a second, the middle run's.
    frames: f64,
    /// Nanoseconds for a triangle or a pixel, as `unit` says.
    ns: f64,
    unit: &'static str,
    /// Milliseconds of all threads together for a frame, where the system
    /// tells.
    cpu_ms: Option<f64>,
    /// Fragments of a frame.
    pixels: u64,
    /// Triangles of a frame that had area.
    triangles: u64,
    digest: String,
}

/// What measures points.
pub struct Curves<'a> {
    /// How to draw.
    pub device: DeviceConfig,
    /// Timed runs of a point.
    pub runs: u16,
    /// What pictures must be.
    pub digests: &'a Digests,
}

/// Measures all curves and writes them into a folder: an SVG each, and all
/// points as JSON lines.
///
/// # Errors
/// A wrong picture; another picture or other counts with more threads; files
/// that cannot be written.
pub fn draw(folder: &Path, curves: &Curves<'_>) -> Result<()> {
    std::fs::create_dir_all(folder)
        .with_context(|| format!("cannot create {}", folder.display()))?;
    let threads = curves.threads()?;
    let resolutions = curves.resolutions()?;
    let triangles = curves.triangles()?;
    let textures = curves.textures()?;
    let write = |name: &str, text: String| {
        let file = folder.join(name);
        std::fs::write(&file, text).with_context(|| format!("cannot write {}", file.display()))
    };
    let speed_up = relative(&threads, |p| Some(p.frames));
    write("threads.svg", chart("Speed-up by threads", "threads", "times one thread", &speed_up))?;
    let work = relative(&threads, |p| p.cpu_ms);
    if !work.is_empty() {
        let title = "Time of all threads together";
        write("threads-work.svg", chart(title, "threads", "times one thread", &work))?;
    }
    let lines = lines(&resolutions, |p| Some(p.ns));
    write(
        "resolution.svg",
        chart("Cost by resolution", "side of the picture", "ns a pixel", &lines),
    )?;
    let lines = self::lines(&triangles, |p| Some(p.ns));
    let title = "Cost of a triangle by its size";
    write("triangles.svg", chart(title, "pixels of a triangle", "ns a triangle", &lines))?;
    let lines = self::lines(&textures, |p| Some(p.ns));
    let title = "Cost by size of the texture";
    write("textures.svg", chart(title, "side of the texture", "ns a pixel", &lines))?;
    let mut text = String::new();
    for point in [threads, resolutions, triangles, textures].iter().flatten() {
        text += &serde_json::to_string(point)?;
        text.push('\n');
    }
    write("curves.jsonl", text)
}

impl Curves<'_> {
    fn threads(&self) -> Result<Vec<Point>> {
        let mut points: Vec<Point> = Vec::new();
        for name in [
            "W2_gouraud_z_b2f",
            "W3_tex_bilin_z_b2f",
            "W4_tex_blend",
            "W6a_tri_10px",
            "W7_tri_100px",
        ] {
            let first = points.len();
            for threads in THREADS {
                let device = DeviceConfig { threads, ..self.device.clone() };
                let job = drawing::job(named(name), SCREEN, None);
                let point = self.point("threads", name, threads as f64, &job, &device)?;
                let one = points.get(first).unwrap_or(&point);
                if (one.pixels, one.triangles) != (point.pixels, point.triangles) {
                    bail!("{name}: {threads} threads count {point:?}, one counts {one:?}");
                }
                points.push(point);
            }
        }
        Ok(points)
    }

    fn resolutions(&self) -> Result<Vec<Point>> {
        let mut points = Vec::new();
        for name in ["W1_fill_flat", "W2_gouraud_z_b2f", "W3_tex_bilin_z_b2f", "W4_tex_blend"] {
            for side in SIDES {
                let size = Size::square(side);
                let job = drawing::job(named(name), size, None);
                points.push(self.point("resolution", name, f64::from(side), &job, &self.device)?);
            }
        }
        Ok(points)
    }

    fn triangles(&self) -> Result<Vec<Point>> {
        let line = "textured gouraud z";
        let mut points = Vec::new();
        for area in AREAS {
            let count = (TRIANGLE_PIXELS / area).clamp(8, MAX_TRIANGLES) as usize;
            let workload = Workload {
                name: "triangles",
                kind: Kind::Triangles { count, area },
                front_to_back: false,
            };
            let job = drawing::job(workload, SCREEN, None);
            let mut point = self.point("triangles", line, 0.0, &job, &self.device)?;
            // Large ones reach beyond the screen: what counts is what is seen.
            point.x = point.pixels as f64 / point.triangles.max(1) as f64;
            points.push(point);
        }
        let workload = named("W3_tex_bilin_z_b2f");
        let job = drawing::job(workload, SCREEN, None);
        let mut screen = self.point("triangles", line, 0.0, &job, &self.device)?;
        screen.x = screen.pixels as f64 / screen.triangles as f64;
        screen.ns = 1e9 / screen.frames / screen.triangles as f64;
        screen.unit = "triangle";
        points.push(screen);
        points.sort_by(|a, b| a.x.total_cmp(&b.x));
        Ok(points)
    }

    fn textures(&self) -> Result<Vec<Point>> {
        let mut points = Vec::new();
        for name in ["W3_tex_bilin_z_b2f", "W4_tex_blend"] {
            for side in TEXTURES {
                let job = drawing::job(named(name), SCREEN, Some(side));
                points.push(self.point("textures", name, f64::from(side), &job, &self.device)?);
            }
        }
        Ok(points)
    }

    fn point(
        &self,
        curve: &'static str,
        line: &str,
        x: f64,
        job: &Job,
        device: &DeviceConfig,
    ) -> Result<Point> {
        let mut checked = job.check(device, self.digests)?;
        let counted = frame_counters(&mut *checked.drawing);
        let before = cpu_seconds();
        let measured = job.time(&mut checked, device, self.runs)?;
        let spent = before.zip(cpu_seconds()).map(|(from, to)| to - from);
        let count = checked.drawing.count();
        let rate = measured.median * 1e6 / count;
        Ok(Point {
            curve,
            line: line.into(),
            x,
            threads: device.threads,
            simd: device.level.name(),
            frames: rate,
            ns: 1e9 / rate / count,
            unit: if job.unit == "Mtri/s" { "triangle" } else { "pixel" },
            cpu_ms: spent.map(|seconds| seconds * 1e3 / checked.frames as f64),
            pixels: counted.pixels_in,
            triangles: counted.triangles_drawn,
            digest: checked.digest,
        })
    }
}

fn named(name: &str) -> Workload {
    Workload::by_name(name).expect("the curves name workloads that exist")
}

/// What one frame counts.
fn frame_counters(drawing: &mut dyn Drawing) -> Counters {
    let before = drawing.counters();
    drawing.frame();
    let after = drawing.counters();
    Counters {
        pixels_in: after.pixels_in - before.pixels_in,
        triangles_drawn: after.triangles_drawn - before.triangles_drawn,
        ..Counters::default()
    }
}

/// Seconds that the threads of this process have run so far; `None` where the
/// system does not tell.
fn cpu_seconds() -> Option<f64> {
    let tasks = std::fs::read_dir("/proc/self/task").ok()?;
    let spent = |task: std::io::Result<std::fs::DirEntry>| -> Option<f64> {
        let text = std::fs::read_to_string(task.ok()?.path().join("schedstat")).ok()?;
        text.split_whitespace().next()?.parse().ok()
    };
    Some(tasks.filter_map(spent).sum::<f64>() * 1e-9)
}

/// Points as lines.
fn lines(points: &[Point], y: impl Fn(&Point) -> Option<f64>) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    for point in points {
        let Some(y) = y(point) else { continue };
        match lines.iter_mut().find(|line| line.name == point.line) {
            Some(line) => line.points.push((point.x, y)),
            None => lines.push(Line { name: point.line.clone(), points: vec![(point.x, y)] }),
        }
    }
    lines
}

/// The same, each divided by its first value.
fn relative(points: &[Point], y: impl Fn(&Point) -> Option<f64>) -> Vec<Line> {
    let mut lines = lines(points, y);
    for line in &mut lines {
        let first = line.points[0].1;
        line.points.iter_mut().for_each(|point| point.1 /= first);
    }
    lines
}

fn chart(title: &str, x: &str, y: &str, lines: &[Line]) -> String {
    Chart { title, x, y, lines }.svg()
}
