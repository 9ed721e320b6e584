//! Timing, after the picture was found right.

use std::time::Instant;

use anyhow::Result;
use fillrate_engine::DeviceConfig;
use fillrate_simd::Level;
use serde::{Deserialize, Serialize};

use super::digest::{self, Digests};
use super::drawing::Drawing;
use super::size::Size;

/// A run is as many frames as take this long, in seconds.
const RUN: f64 = 0.05;

/// What was measured of one workload.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Measured {
    /// The workload's name.
    pub workload: String,
    /// WxH.
    pub size: String,
    /// Of the colours.
    pub format: String,
    /// Threads that drew.
    pub threads: usize,
    /// SIMD level.
    pub simd: String,
    /// Of the rates.
    pub unit: String,
    /// The middle run's rate.
    pub median: f64,
    /// The slowest run's.
    pub min: f64,
    /// The fastest run's.
    pub max: f64,
    /// How many runs.
    pub runs: u16,
    /// Of the picture.
    pub digest: String,
}

/// A picture that is not the expected one.
#[derive(Debug, thiserror::Error)]
#[error("{workload} at {size}: the picture is wrong: digest {found}, expected {expected}")]
pub struct WrongPicture {
    /// What drew it.
    pub workload: String,
    /// WxH.
    pub size: String,
    /// What was drawn.
    pub found: String,
    /// What should have been.
    pub expected: String,
}

/// Makes a drawing on a device.
type Make = Box<dyn Fn(DeviceConfig) -> Result<Box<dyn Drawing>>>;

/// What to measure.
pub struct Job {
    /// The workload's name.
    pub name: &'static str,
    /// What its rate counts.
    pub unit: &'static str,
    /// Of the colours.
    pub format: &'static str,
    /// How large it is drawn.
    pub size: Size,
    /// Its digest may be kept.
    pub kept: bool,
    /// Makes it.
    pub make: Make,
}

/// A workload whose picture is right.
pub struct Checked {
    /// Ready to be timed.
    pub drawing: Box<dyn Drawing>,
    /// Of the picture.
    pub digest: String,
    /// Frames drawn while it was timed.
    pub frames: u64,
}

impl Job {
    /// Draws a frame and compares it with the expected digest: the kept one,
    /// or else that of the scalar level on one thread.
    ///
    /// # Errors
    /// [`WrongPicture`].
    pub fn check(&self, device: &DeviceConfig, digests: &Digests) -> Result<Checked> {
        let kept = if self.kept { digests.get(&self.size.to_string(), self.name) } else { None };
        let expected = match kept {
            Some(kept) => kept.to_string(),
            None => {
                let plain = DeviceConfig { threads: 1, level: Level::Scalar, ..device.clone() };
                let mut drawing = (self.make)(plain)?;
                drawing.frame();
                digest::text(drawing.picture()?.hash())
            }
        };
        let mut drawing = (self.make)(device.clone())?;
        drawing.frame();
        let digest = self.same(&mut *drawing, &expected)?;
        Ok(Checked { drawing, digest, frames: 0 })
    }

    /// Times a checked workload; the last frame must still be right.
    ///
    /// # Errors
    /// [`WrongPicture`].
    pub fn time(
        &self,
        checked: &mut Checked,
        device: &DeviceConfig,
        runs: u16,
    ) -> Result<Measured> {
        let count = checked.drawing.count();
        let mut rates: Vec<f64> = (0..runs).map(|_| count * run(checked)).collect();
        self.same(&mut *checked.drawing, &checked.digest)?;
        rates.sort_by(f64::total_cmp);
        Ok(Measured {
            workload: self.name.into(),
            size: self.size.to_string(),
            format: self.format.into(),
            threads: device.threads,
            simd: device.level.name().into(),
            unit: self.unit.into(),
            median: rates[rates.len() / 2],
            min: rates[0],
            max: rates[rates.len() - 1],
            runs,
            digest: checked.digest.clone(),
        })
    }

    fn same(&self, drawing: &mut dyn Drawing, expected: &str) -> Result<String> {
        let found = digest::text(drawing.picture()?.hash());
        if found != expected {
            let (workload, size) = (self.name.into(), self.size.to_string());
            return Err(WrongPicture { workload, size, found, expected: expected.into() }.into());
        }
        Ok(found)
    }
}

/// Millions of frames a second over a run.
fn run(checked: &mut Checked) -> f64 {
    let start = Instant::now();
    let mut frames = 0u32;
    while frames == 0 || start.elapsed().as_secs_f64() < RUN {
        checked.drawing.frame();
        frames += 1;
    }
    // The last frames may still be drawn behind the caller.
    checked.drawing.counters();
    checked.frames += u64::from(frames);
    f64::from(frames) / start.elapsed().as_secs_f64() * 1e-6
}
