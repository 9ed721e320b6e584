//! Running the matrix: each test on one tile and on the grid.

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use super::vectors::{CHARTED, INNER, Inner, OUTER, Outer, SCALES, records};
use crate::device::Config;
use crate::protocol::Record;
use crate::sim::cost::Costs;
use crate::sim::perf::Counters;
use crate::sim::{self, Deadlock, Options, single};

/// One test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Test {
    /// Colour, texture and light.
    pub outer: Outer,
    /// Alpha, depth and order.
    pub inner: Inner,
    /// Scale of the pattern.
    pub scale: f32,
}

/// What to run, and on what.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// The device.
    pub config: Config,
    /// The cost table.
    pub costs: Costs,
    /// The grid.
    pub options: Options,
    /// Repetitions of the pattern; the thesis has four.
    pub frames: u32,
}

impl Default for Setting {
    fn default() -> Self {
        Self {
            config: Config::default(),
            costs: Costs::default(),
            options: Options::default(),
            frames: 4,
        }
    }
}

/// The result of one test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// The test.
    pub test: Test,
    /// Counters of the single tile.
    pub single: Counters,
    /// Counters of the grid.
    pub grid: Counters,
    /// Columns of the grid.
    pub columns: usize,
    /// Whether both pictures are equal, bit for bit.
    pub same_picture: bool,
}

impl Outcome {
    /// How many times faster the grid is.
    pub fn speed_up(&self) -> f64 {
        self.single.stream_cycles as f64 / self.grid.stream_cycles.max(1) as f64
    }

    /// The speed-up that the utilisation alone would give.
    pub fn expected_speed_up(&self) -> f64 {
        let tiles = 4.0 * self.columns as f64;
        tiles * self.grid.chip_utilisation(self.columns) / self.single.single_utilisation()
    }

    /// The part of the expected speed-up that is missing; negative when there is more.
    pub fn overhead(&self) -> f64 {
        1.0 - self.speed_up() / self.expected_speed_up()
    }

    /// Speed-up per tile.
    pub fn efficiency(&self) -> f64 {
        self.speed_up() / (4.0 * self.columns as f64)
    }
}

/// The twelve charted modes at all sizes: 84 tests.
pub fn charted() -> Vec<Test> {
    let lines = CHARTED.iter().map(|line| line.vectors());
    tests(lines)
}

/// The whole published matrix: 2520 tests.
pub fn matrix() -> Vec<Test> {
    tests(OUTER.iter().flat_map(|outer| INNER.iter().map(|inner| (*outer, *inner))))
}

fn tests(lines: impl Iterator<Item = (Outer, Inner)>) -> Vec<Test> {
    lines.flat_map(|(outer, inner)| SCALES.map(|scale| Test { outer, inner, scale })).collect()
}

/// Runs one test on both builds.
///
/// # Errors
/// The grid got stuck.
pub fn run(test: Test, setting: &Setting) -> Result<Outcome, Deadlock> {
    compare(test, setting, &records(test.outer, test.inner, test.scale, setting.frames))
}

/// Plays records on both builds; `test` says what they are.
///
/// # Errors
/// The grid got stuck.
pub fn compare(test: Test, setting: &Setting, records: &[Record]) -> Result<Outcome, Deadlock> {
    let (device, _) = single::play(setting.config, setting.costs, records);
    let grid = sim::play(setting.config, setting.costs, setting.options, records, |_| {})?;
    Ok(Outcome {
        test,
        single: device.observer().counters(),
        grid: grid.counters,
        columns: setting.options.columns,
        same_picture: device.core().target == grid.core.target,
    })
}

/// Runs tests on `threads` threads; results come in the order of the tests. `done` is told how
/// many are finished, from any thread.
///
/// # Errors
/// The first test, in order, whose grid got stuck.
pub fn run_all(
    tests: &[Test],
    setting: &Setting,
    threads: usize,
    done: impl Fn(usize) + Sync,
) -> Result<Vec<Outcome>, Deadlock> {
    let next = AtomicUsize::new(0);
    let finished = AtomicUsize::new(0);
    let results = Mutex::new(vec![None; tests.len()]);
    let work = || {
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(test) = tests.get(index) else { return };
            let outcome = run(*test, setting);
            if let Ok(mut results) = results.lock() {
                results[index] = Some(outcome);
            }
            done(finished.fetch_add(1, Ordering::Relaxed) + 1);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..threads.max(1) {
            scope.spawn(work);
        }
    });
    let results = results.into_inner().expect("no worker panics while holding the lock");
    results.into_iter().map(|r| r.expect("every test ran")).collect()
}
