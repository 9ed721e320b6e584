//! A short flight, for whoever shows one beside other pictures.

use std::path::Path as File;

use anyhow::{Context, Result};
use fillrate_engine::DeviceConfig;
use fillrate_glide::card::Card;
use fillrate_glide::{Improvements, Shown};

use crate::assets::Assets;
use crate::camera::Path;
use crate::draw::{DrawOptions, Renderer};
use crate::level::{Level, level_names};
use crate::synthetic;
use crate::view::View;

/// The level that is flown through where a game has it.
const FAVOURITE: &str = "oa_dm1";
/// 640x480.
const RESOLUTION: i32 = 7;
/// The last frame is so much of the way around.
const PART: f32 = 0.4;

/// What a flight came to.
#[derive(Debug)]
pub struct Flight {
    /// The level.
    pub name: String,
    /// Its last frame.
    pub shown: Shown,
    /// Frames.
    pub frames: usize,
    /// Triangles of all frames.
    pub triangles: u64,
    /// Fragments of all frames.
    pub fragments: u64,
    /// Time that drawing took, in seconds.
    pub seconds: f64,
}

/// Flies through a level of a game whose archives are in `data`, or else the
/// one made here, at 640x480, with two texture units in one pass.
///
/// # Errors
/// Where the files cannot be read or hold no level.
pub fn fly(data: Option<&File>, device: DeviceConfig, frames: usize) -> Result<Flight> {
    let (mut assets, name) = match data {
        None => (synthetic::assets(), synthetic::NAME.to_string()),
        Some(folder) => {
            let assets = Assets::open(folder)?;
            let names = level_names(&assets);
            let name = names.iter().find(|name| *name == FAVOURITE).or(names.first());
            let name = name.with_context(|| format!("{} has no level", folder.display()))?.clone();
            (assets, name)
        }
    };
    let level = Level::load(&mut assets, &name, 256)?;
    let card = Card::by_name("arcade-12mb-2tmu").context("the board is a known one")?;
    let improve = Improvements::default();
    let (resolution, passes, fog, check) = (RESOLUTION, 1, None, false);
    let options = DrawOptions { card, resolution, passes, fog, device, check, improve };
    let mut renderer = Renderer::new(options, level.surfaces.len())?;
    let path = Path::new(&level.bsp, &level.spawns, [0.0, 0.0, 64.0]);
    let (width, height) = renderer.size();
    let (mut triangles, mut seconds) = (0, 0.0);
    for frame in 1..=frames {
        let camera = path.camera(PART * frame as f32 / frames as f32);
        let view = View::new(camera, width, height);
        let stats = renderer.draw(&level, &view, frame as f32 / 60.0);
        triangles += stats.triangles;
        seconds += stats.total.as_secs_f64();
    }
    let fragments = renderer.fragments();
    let shown = renderer.shown().context("nothing was drawn")?;
    Ok(Flight { name, shown, frames, triangles, fragments, seconds })
}
