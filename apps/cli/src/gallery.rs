//! The gallery page.

use std::fmt::Write as _;
use std::path::Path;

use anyhow::{Context, Result};
use serde::Serialize;

/// One picture of the gallery and what it took.
#[derive(Clone, Debug, Serialize)]
pub struct Picture {
    /// The example's name.
    pub name: String,
    /// File in the gallery's folder.
    pub file: String,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Hash of the picture's pixels.
    pub hash: String,
    /// Frames the example showed.
    pub frames: usize,
    /// Triangles of all frames.
    pub triangles: u64,
    /// Fragments of all frames.
    pub pixels: u64,
    /// Time the renderer took, in seconds.
    pub seconds: f64,
    /// Threads that drew.
    pub threads: usize,
    /// SIMD level.
    pub simd: String,
}

impl Picture {
    /// Frames a second.
    pub fn frame_rate(&self) -> f64 {
        if self.seconds > 0.0 { self.frames as f64 / self.seconds } else { 0.0 }
    }

    /// Millions of fragments a second.
    pub fn rate(&self) -> f64 {
        if self.seconds > 0.0 { self.pixels as f64 / self.seconds * 1e-6 } else { 0.0 }
    }
}

const HEAD: &str = "<!doctype html>
<html lang=\"en\">
<meta charset=\"utf-8\">
<title>Fillrate gallery</title>
<style>
body { font: 15px/1.4 system-ui, sans-serif; margin: 2rem; background: #14161a; color: #d8dce2 }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(20rem, 1fr)); gap: 1.5rem }
figure { margin: 0; background: #1d2026; border-radius: 6px; overflow: hidden }
img { width: 100%; display: block; image-rendering: pixelated }
figcaption { padding: .6rem .8rem }
h1 { font-weight: 600 } b { color: #fff } code { color: #9fb4c7 } small { color: #8b93a0 }
</style>
<h1>Fillrate gallery</h1>
<main>
";

/// Writes `index.html` beside the pictures.
pub fn write_page(folder: &Path, pictures: &[Picture]) -> Result<()> {
    let mut page = String::from(HEAD);
    for p in pictures {
        // Names, hashes and files come from our own examples: plain words.
        writeln!(
            page,
            "<figure><img src=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\"><figcaption><b>{}</b> \
             <code>{}</code><br><small>{} frames, {:.0} frames/s, {} triangles, {:.1} Mpixel/s, \
             {} threads, {}\
             </small></figcaption></figure>",
            p.file,
            p.name,
            p.width,
            p.height,
            p.name,
            p.hash,
            p.frames,
            p.frame_rate(),
            p.triangles,
            p.rate(),
            p.threads,
            p.simd
        )?;
    }
    page.push_str("</main>\n");
    let file = folder.join("index.html");
    std::fs::write(&file, page).with_context(|| format!("cannot write {}", file.display()))
}
