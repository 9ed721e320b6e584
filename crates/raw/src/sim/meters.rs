//! When the counters count, and for how long they have.

use super::machine::Machine;
use super::perf::Counters;
use crate::protocol::Record;

/// The cycles since which counting is on, and since which a scene is open.
#[derive(Clone, Copy, Debug, Default)]
pub struct Meters {
    /// Counting has been on since then.
    pub perf: Option<u64>,
    /// A scene has been open since then.
    pub scene: Option<u64>,
}

/// Carries out a record for the counters.
pub fn meta(m: &Machine, record: Record) {
    let (now, mut meters) = (m.k.now(), m.meters.get());
    match record {
        Record::PerfStart => meters.perf = Some(meters.perf.unwrap_or(now)),
        Record::PerfStop => {
            settle(m);
            meters.perf = None;
        }
        Record::PerfReset => {
            *m.counters.borrow_mut() = Counters::default();
            m.tiles.iter().for_each(|t| t.active.set(0));
            meters.perf = None;
        }
        Record::EnterScene => meters.scene = Some(meters.scene.unwrap_or(now)),
        Record::ExitScene => {
            settle(m);
            meters = Meters { scene: None, ..m.meters.get() };
        }
        Record::Frame if meters.perf.is_some() => m.counters.borrow_mut().frames += 1,
        Record::Prim if meters.perf.is_some() => m.counters.borrow_mut().prims += 1,
        _ => {}
    }
    m.meters.set(meters);
}

/// Brings the counters up to now and counts on.
pub fn settle(m: &Machine) {
    let (now, Meters { perf, scene }) = (m.k.now(), m.meters.get());
    let mut counters = m.counters.borrow_mut();
    if let Some(perf) = perf {
        counters.render_cycles += now - perf;
        counters.stream_cycles += scene.map_or(0, |scene| now - scene.max(perf));
    }
    m.meters.set(Meters { perf: perf.map(|_| now), scene: scene.map(|_| now) });
}
