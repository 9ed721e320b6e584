//! The host interface: reads protocol records, feeds the device, keeps the counters' switches.

use std::cell::Cell;
use std::rc::Rc;

use super::kernel::TaskId;
use super::machine::Machine;
use super::perf::Counters;
use crate::protocol::Record;

/// When counting began, and what has been counted.
#[derive(Default)]
struct Meters {
    perf: Option<u64>,
    scene: Option<u64>,
}

/// Plays a list of records and stops the kernel. Words the client would read are put into `read`.
pub async fn run(
    m: Rc<Machine>,
    records: Vec<Record>,
    read: Rc<std::cell::RefCell<Vec<u32>>>,
    me: Rc<Cell<TaskId>>,
    boot: bool,
) {
    let clock = Cell::new(m.k.now());
    let mut meters = Meters::default();
    let mut records = records.into_iter();
    if boot {
        m.device.receive(&m.k, me.get(), &clock).await;
    }
    while let Some(record) = records.next() {
        match record {
            Record::Data(word) => {
                m.host.send(&m.k, me.get(), &clock, word, 1).await;
                clock.set(clock.get() + u64::from(m.costs.host_word) - 1);
            }
            Record::Wait => {
                m.device.receive(&m.k, me.get(), &clock).await;
            }
            Record::Read => {
                let Some(Record::Data(count)) = records.next() else { continue };
                for _ in 0..count {
                    let (word, _) = m.device.receive(&m.k, me.get(), &clock).await;
                    read.borrow_mut().push(word);
                }
            }
            Record::Debug => {
                records.next();
            }
            Record::Halt => break,
            meta => {
                m.k.catch_up(me.get(), &clock).await;
                meters.meta(&m, meta);
            }
        }
    }
    m.k.catch_up(me.get(), &clock).await;
    meters.stop(&m);
    m.k.stop();
}

impl Meters {
    fn meta(&mut self, m: &Machine, record: Record) {
        let now = m.k.now();
        match record {
            Record::PerfStart => self.perf = Some(now),
            Record::PerfStop => self.stop(m),
            Record::PerfReset => {
                self.stop(m);
                *m.counters.borrow_mut() = Counters::default();
                m.tiles.iter().for_each(|t| t.active.set(0));
            }
            Record::EnterScene => self.scene = Some(now),
            Record::ExitScene => {
                self.close_scene(m);
                self.scene = None;
            }
            Record::Frame if self.perf.is_some() => m.counters.borrow_mut().frames += 1,
            Record::Prim if self.perf.is_some() => m.counters.borrow_mut().prims += 1,
            _ => {}
        }
        m.counting.set(self.perf.is_some() && self.scene.is_some());
    }

    /// Adds the cycles of the open scene that were counted.
    fn close_scene(&mut self, m: &Machine) {
        if let (Some(scene), Some(perf)) = (self.scene, self.perf) {
            m.counters.borrow_mut().stream_cycles += m.k.now() - scene.max(perf);
        }
    }

    fn stop(&mut self, m: &Machine) {
        self.close_scene(m);
        if let Some(since) = self.perf.take() {
            m.counters.borrow_mut().render_cycles += m.k.now() - since;
        }
        m.counting.set(false);
    }
}
