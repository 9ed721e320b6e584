//! The single-tile build on the same cost table: the reference renderer, observed.

use super::cache::Cache;
use super::charges;
use super::cost::{Burst, Costs};
use super::perf::Counters;
use crate::device::{Config, Device};
use crate::host::Host;
use crate::observer::Observer;
use crate::opcode::Opcode;
use crate::protocol::Record;
use crate::stage::combine::Textured;
use crate::stage::composite::Outcome;
use crate::stage::geometry::GeometryWork;
use crate::stage::raster::{Interpolants, RasterWork};
use crate::state::{ModeBits, PrimInfo};

/// Word address of the depth buffer in the tile's memory, far from the textures.
const DEPTHS_AT: u64 = 1 << 32;

/// Adds up what a single tile would need.
#[derive(Clone, Debug)]
pub struct SingleTile {
    costs: Costs,
    needs: Option<Interpolants>,
    cache: Cache,
    clock: u64,
    active: u64,
    perf: bool,
    scene: bool,
    counters: Counters,
}

impl SingleTile {
    fn new(costs: Costs) -> Self {
        Self {
            costs,
            needs: None,
            cache: Cache::default(),
            clock: 0,
            active: 0,
            perf: false,
            scene: false,
            counters: Counters::default(),
        }
    }

    fn charge(&mut self, burst: Burst) {
        self.clock += u64::from(burst.cycles);
        self.active += u64::from(burst.cycles) * u64::from(burst.active);
    }

    fn stall(&mut self, cycles: u32) {
        self.charge(Burst::new(cycles, 0));
    }

    /// The counters; time is counted up to now.
    pub fn counters(&self) -> Counters {
        self.counters
    }

    /// Moves the time since the last call into the counters.
    fn settle(&mut self) {
        let (cycles, active) = (std::mem::take(&mut self.clock), std::mem::take(&mut self.active));
        if self.perf {
            self.counters.render_cycles += cycles;
        }
        if self.perf && self.scene {
            self.counters.stream_cycles += cycles;
            self.counters.active[0] += active;
        }
    }
}

impl Observer for SingleTile {
    fn meta(&mut self, record: Record) {
        self.settle();
        match record {
            Record::PerfStart => self.perf = true,
            Record::PerfStop => self.perf = false,
            Record::PerfReset => (self.counters, self.perf) = (Counters::default(), false),
            Record::EnterScene => self.scene = true,
            Record::ExitScene => self.scene = false,
            Record::Frame => self.counters.frames += u64::from(self.perf),
            Record::Prim => self.counters.prims += u64::from(self.perf),
            _ => {}
        }
    }

    fn report(&mut self) -> Option<String> {
        self.settle();
        Some(self.counters.report())
    }

    fn word(&mut self) {
        self.charge(self.costs.s1.word);
    }

    fn command(&mut self, _op: Opcode) {
        self.charge(self.costs.s1.dispatch);
    }

    fn buffers(&mut self, op: Opcode, screen: u64) {
        let costs = self.costs;
        let pixels = charges::command(&costs, op, screen, |burst| self.charge(burst));
        self.counters.pixels += u64::from(self.perf) * pixels;
    }

    fn primitive(&mut self, work: &GeometryWork) {
        let costs = self.costs;
        charges::geometry(&costs, work, |burst| self.charge(burst));
        self.counters.drawn_prims += u64::from(self.perf && work.visible);
    }

    fn setup(&mut self, needs: Interpolants) {
        let costs = self.costs;
        self.needs = Some(needs);
        charges::setup(&costs, needs, |burst| self.charge(burst));
    }

    fn fragment(&mut self, info: &PrimInfo, work: RasterWork, textured: &Textured) {
        let costs = self.costs;
        charges::walk(&costs, work, 15, |burst| self.charge(burst));
        if let Some(needs) = self.needs {
            charges::cover(&costs, needs, |burst| self.charge(burst));
            charges::divide(&costs, needs, |burst| self.charge(burst));
        }
        charges::combine(&costs, info, textured, |burst| self.charge(burst));
        for address in textured.addresses.iter().flatten() {
            if self.cache.touch(*address as u64) {
                self.stall(costs.miss);
            }
        }
        let counts = u64::from(self.perf);
        self.counters.frags += counts;
        self.counters.tex_frags += counts;
        self.counters.texels += counts * u64::from(textured.looked_up);
    }

    fn composite(&mut self, _mode: ModeBits, address: u64, outcome: &Outcome) {
        let costs = self.costs;
        self.charge(costs.s4.pixel_single);
        charges::composite(&costs, outcome, |burst| self.charge(burst));
        if (outcome.tested || outcome.depth_written) && self.cache.touch(DEPTHS_AT + address) {
            self.stall(costs.miss);
        }
        self.stall(costs.s4.round_trip * outcome.page_reads);
        self.counters.pixels += u64::from(self.perf) * u64::from(outcome.page_writes);
    }

    fn rows(&mut self, work: RasterWork) {
        let costs = self.costs;
        charges::walk(&costs, work, 15, |burst| self.charge(burst));
    }
}

/// Plays records on a single tile; returns the device and the words the client would have read.
///
/// A fault of the records ends the run there, as the end of the records would.
pub fn play(config: Config, costs: Costs, records: &[Record]) -> (Device<SingleTile>, Vec<u32>) {
    let mut host = Host::new(observed(config, costs));
    let _ = records.iter().try_for_each(|record| host.push(*record));
    let read = std::iter::from_fn(|| host.pop()).collect();
    let mut device = host.into_device();
    device.observer_mut().settle();
    (device, read)
}

/// A single-tile device that is charged by the cost table.
pub fn observed(config: Config, costs: Costs) -> Device<SingleTile> {
    Device::observed(config, SingleTile::new(costs))
}
