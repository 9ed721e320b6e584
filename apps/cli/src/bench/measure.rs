//! Timing, after the picture was found right.

use std::time::Instant;

use anyhow::Result;
use fillrate_engine::DeviceConfig;
use serde::{Deserialize, Serialize};

use super::digest::{self, Digests};
use super::prepared::{Prepared, plain_digest};
use super::size::Size;
use super::workload::Workload;

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

/// What to measure, and how.
pub struct Job<'a> {
    /// What to draw.
    pub workload: Workload,
    /// How large.
    pub size: Size,
    /// How.
    pub device: &'a DeviceConfig,
    /// A texture of another size than the workload's own.
    pub texture_side: Option<u32>,
}

/// A workload whose picture is right.
pub struct Checked {
    /// Ready to be timed.
    pub prepared: Prepared,
    /// Of the picture.
    pub digest: String,
    /// Frames drawn while it was timed.
    pub frames: u64,
}

impl Job<'_> {
    /// Draws a frame and compares it with the expected digest: the kept one,
    /// or else that of the scalar level on one thread.
    ///
    /// # Errors
    /// [`WrongPicture`].
    pub fn check(&self, digests: &Digests) -> Result<Checked> {
        let kept = match self.texture_side {
            None => digests.get(&self.size.to_string(), self.workload.name).map(String::from),
            Some(_) => None,
        };
        let expected = match kept {
            Some(kept) => kept,
            None => {
                let (workload, size) = (self.workload, self.size);
                digest::text(plain_digest(workload, size, self.device, self.texture_side)?)
            }
        };
        self.check_against(&expected)
    }

    /// The same with an expected digest.
    ///
    /// # Errors
    /// [`WrongPicture`].
    pub fn check_against(&self, expected: &str) -> Result<Checked> {
        let (workload, size) = (self.workload, self.size);
        let mut prepared = Prepared::new(workload, size, self.device.clone(), self.texture_side)?;
        prepared.frame();
        let digest = self.same(&mut prepared, expected)?;
        Ok(Checked { prepared, digest, frames: 0 })
    }

    /// Times a checked workload; the last frame must still be right.
    ///
    /// # Errors
    /// [`WrongPicture`].
    pub fn time(&self, checked: &mut Checked, runs: u16) -> Result<Measured> {
        let count = self.workload.count(self.size);
        let mut rates: Vec<f64> = (0..runs).map(|_| count * run(checked)).collect();
        self.same(&mut checked.prepared, &checked.digest)?;
        rates.sort_by(f64::total_cmp);
        Ok(Measured {
            workload: self.workload.name.into(),
            size: self.size.to_string(),
            format: "565".into(),
            threads: self.device.threads,
            simd: self.device.level.name().into(),
            unit: self.workload.unit().into(),
            median: rates[rates.len() / 2],
            min: rates[0],
            max: rates[rates.len() - 1],
            runs,
            digest: checked.digest.clone(),
        })
    }

    fn same(&self, prepared: &mut Prepared, expected: &str) -> Result<String> {
        let found = digest::text(prepared.picture()?.hash());
        if found != expected {
            let (workload, size) = (self.workload.name.into(), self.size.to_string());
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
        checked.prepared.frame();
        frames += 1;
    }
    checked.frames += u64::from(frames);
    f64::from(frames) / start.elapsed().as_secs_f64() * 1e-6
}
