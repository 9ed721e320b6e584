//! Draws small fixed scenes, one for each draw state that has a budget of
//! instructions: `fillrate-budget LEVEL` prints a JSON object for each.
//!
//! Run under callgrind with `--dump-before=*budget_mark*`, every second part
//! holds the instructions of one scene's [`FRAMES`] frames and nothing else:
//! `cargo run -p fillrate-xtask -- budget`.

#![forbid(unsafe_code)]

mod kernels;
mod scene;

use anyhow::{Context as _, Result};
use fillrate_engine::DeviceConfig;
use fillrate_simd::Level;

use kernels::KERNELS;
use scene::Scene;

/// Frames counted of each scene.
const FRAMES: u32 = 3;
/// Frames before those: memory is taken, textures are decoded.
const WARM_UP: u32 = 2;

/// Where the counting of a scene starts and ends.
#[inline(never)]
fn budget_mark(number: u32) {
    std::hint::black_box(number);
}

fn main() -> Result<()> {
    let name = std::env::args().nth(1).context("usage: fillrate-budget LEVEL")?;
    let level: Level = name.parse()?;
    anyhow::ensure!(level.is_available(), "this machine has no {level}");
    for kernel in &KERNELS {
        let device = DeviceConfig { threads: 1, level, ..DeviceConfig::default() };
        let mut scene = Scene::new(kernel, device)?;
        (0..WARM_UP).for_each(|_| scene.frame());
        budget_mark(0);
        (0..FRAMES).for_each(|_| scene.frame());
        budget_mark(1);
        let line = serde_json::json!({
            "kernel": kernel.name,
            "unit": kernel.unit(),
            "count": scene.count() * u64::from(FRAMES),
            "picture": format!("{:016x}", scene.picture()?.hash()),
        });
        println!("{line}");
    }
    Ok(())
}
