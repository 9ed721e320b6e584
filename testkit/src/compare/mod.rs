//! The engine against the reference, bit for bit.

mod describe;
mod shrink;

use std::fmt;

use fillrate_engine::target::TileSize;
use fillrate_engine::{Counters, DeviceConfig, EngineError};
use fillrate_simd::Level;

use crate::canvas::{DeviceCanvas, ReferenceCanvas};
use crate::random::Case;
use crate::reference::Reference;

/// What differs first between two results.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "expected and actual mean the same in all variants")]
pub enum Mismatch {
    /// A colour element; screen coordinates.
    Color { x: u32, y: u32, expected: u32, actual: u32 },
    /// An aux element.
    Aux { x: u32, y: u32, expected: u32, actual: u32 },
    /// The counters, where all elements agree.
    Counters { expected: Counters, actual: Counters },
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Mismatch::Color { x, y, expected, actual } => {
                write!(f, "colour at ({x}, {y}): expected {expected:#x}, actual {actual:#x}")
            }
            Mismatch::Aux { x, y, expected, actual } => {
                write!(f, "aux at ({x}, {y}): expected {expected:#x}, actual {actual:#x}")
            }
            Mismatch::Counters { expected, actual } => {
                write!(f, "counters: expected {expected:?}, actual {actual:?}")
            }
        }
    }
}

/// The first difference of two results of the same size and format.
pub fn first_mismatch(expected: &Reference, actual: &Reference) -> Option<Mismatch> {
    let place = |index: usize| (index as u32 % expected.width, index as u32 / expected.width);
    let differs = expected.color.iter().zip(&actual.color).position(|(e, a)| e != a);
    if let Some(index) = differs {
        let (x, y) = place(index);
        let (expected, actual) = (expected.color[index], actual.color[index]);
        return Some(Mismatch::Color { x, y, expected, actual });
    }
    let empty = Vec::new();
    let (e, a) = (expected.aux.as_ref().unwrap_or(&empty), actual.aux.as_ref().unwrap_or(&empty));
    if let Some(index) = e.iter().zip(a).position(|(e, a)| e != a) {
        let (x, y) = place(index);
        return Some(Mismatch::Aux { x, y, expected: e[index], actual: a[index] });
    }
    let (expected, actual) = (expected.counters, actual.counters);
    (expected != actual).then_some(Mismatch::Counters { expected, actual })
}

/// Draws a case with the reference.
pub fn expected(case: &Case) -> Reference {
    let mut canvas = ReferenceCanvas::new(case.surfaces());
    case.commands.iter().for_each(|command| command.draw(&mut canvas));
    canvas.reference
}

/// Draws a case with a device, on fresh surfaces.
///
/// # Errors
/// As [`DeviceCanvas::renew`].
pub fn actual(case: &Case, canvas: &mut DeviceCanvas) -> Result<Reference, EngineError> {
    let first = case.surfaces();
    canvas.renew((case.width, case.height), case.format, case.aux)?;
    if case.contents.is_some() {
        canvas.load(&first.color, first.aux.as_deref());
    }
    case.commands.iter().for_each(|command| command.draw(canvas));
    Ok(canvas.result())
}

/// A name for a device's way of working, for messages.
pub fn cell_name(config: &DeviceConfig) -> String {
    let DeviceConfig { threads, level, tile } = config;
    format!("{level}, {threads} threads, tiles of {}", tile.side())
}

/// Every SIMD level of this machine with each of some thread counts and tile
/// sizes.
pub fn cells(threads: &[usize], tiles: &[TileSize]) -> Vec<DeviceConfig> {
    let mut out = Vec::new();
    for level in Level::available() {
        for &threads in threads {
            out.extend(tiles.iter().map(|&tile| DeviceConfig { threads, level, tile }));
        }
    }
    out
}

/// Devices that cases are compared on: every SIMD level, each with several
/// thread counts and tile sizes in turn.
#[derive(Debug)]
pub struct Comparison {
    /// One list for each pair of thread count and tile size, a device for each
    /// level.
    rounds: Vec<Vec<DeviceCanvas>>,
    next: usize,
}

impl Comparison {
    /// Devices of all levels.
    ///
    /// # Errors
    /// As [`DeviceCanvas::new`].
    pub fn new() -> Result<Comparison, EngineError> {
        let pairs = [
            (1, TileSize::Small),
            (2, TileSize::Medium),
            (3, TileSize::Large),
            (8, TileSize::Small),
        ];
        let round = |(threads, tile): (usize, TileSize)| {
            let canvas = |config| {
                DeviceCanvas::new(config, (1, 1), fillrate_engine::PixelFormat::Rgb565, None)
            };
            cells(&[threads], &[tile]).into_iter().map(canvas).collect::<Result<Vec<_>, _>>()
        };
        let rounds = pairs.into_iter().map(round).collect::<Result<_, _>>()?;
        Ok(Comparison { rounds, next: 0 })
    }

    /// Draws a case with the reference and, at every level, with the next
    /// thread count and tile size.
    ///
    /// # Errors
    /// A report on the first mismatch: the smallest case found that shows one,
    /// its state, commands, and first differing pixel.
    pub fn check(&mut self, case: &Case) -> Result<Counters, String> {
        self.next = (self.next + 1) % self.rounds.len();
        let wanted = expected(case);
        for canvas in &mut self.rounds[self.next] {
            let found = actual(case, canvas).map_err(|error| error.to_string())?;
            if first_mismatch(&wanted, &found).is_some() {
                return Err(report(case, canvas.config()));
            }
        }
        Ok(wanted.counters)
    }
}

/// Draws a case with the reference and a device of its own.
fn mismatch_of(case: &Case, config: &DeviceConfig) -> Option<Mismatch> {
    let size = (case.width, case.height);
    let mut canvas = DeviceCanvas::new(config.clone(), size, case.format, case.aux).ok()?;
    first_mismatch(&expected(case), &actual(case, &mut canvas).ok()?)
}

/// Shrinks a case and describes what is left.
fn report(case: &Case, config: &DeviceConfig) -> String {
    let cell = cell_name(config);
    let Some(mismatch) = mismatch_of(case, config) else {
        return format!("{cell}: a mismatch that a fresh device does not show");
    };
    let small = shrink::shrink(case, &|case| mismatch_of(case, config).is_some());
    let mismatch = mismatch_of(&small, config).unwrap_or(mismatch);
    format!("{cell}: {mismatch}\n{}", describe::case(&small))
}
