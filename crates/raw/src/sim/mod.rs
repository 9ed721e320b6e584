//! The simulator: four stages times any number of columns, as the thesis laid them out on Raw.
//!
//! Tiles run the stage functions of the reference renderer, so the picture is the same; the
//! simulator adds time. Reading order: [`cost`] (the one table), `kernel` and `link` (how time
//! passes), `switch` (who gets a primitive), `stage1` to `stage4` (the tiles' programs).
//!
//! Source: RAW, chapters 3 and 4.

mod cache;
mod charges;
pub mod cost;
mod host;
mod kernel;
mod link;
mod machine;
mod options;
pub mod perf;
pub mod single;
mod stage1;
mod stage2;
mod stage3;
mod stage4;
mod switch;

use std::cell::{Cell, RefCell};
use std::rc::Rc;

pub use self::options::Options;
pub use self::switch::SwitchState;

use self::cost::Costs;
use self::kernel::Ended;
use self::machine::Machine;
use self::perf::Counters;
use crate::device::{Config, Core};
use crate::error::StreamError;
use crate::protocol::Record;

/// The most columns a machine may have.
pub const MAX_COLUMNS: usize = 63;

/// Nothing in the machine can go on.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("deadlock at cycle {cycle}:\n{waits}")]
pub struct Deadlock {
    /// The cycle of the last event.
    pub cycle: u64,
    /// Who waits for whom, a line per tile.
    pub waits: String,
}

/// What a run left behind.
#[derive(Debug)]
pub struct Run {
    /// The counters.
    pub counters: Counters,
    /// State, textures and buffers at the end.
    pub core: Core,
    /// Words the client read.
    pub read: Vec<u32>,
    /// Faults in the stream.
    pub faults: Vec<StreamError>,
    /// Each accepted primitive in the order of the stream: its column and sequence number.
    pub accepted: Vec<(usize, u32)>,
    /// The token's value at the end.
    pub token: Option<u32>,
    /// Cycles from power-on.
    pub cycles: u64,
}

/// Plays records on a machine of `options.columns` pipelines.
///
/// `prepare` may change the state after power-on, for example the first sequence number.
///
/// # Errors
/// The machine got stuck; the error says who waits for whom.
pub fn play(
    config: Config,
    costs: Costs,
    options: Options,
    records: &[Record],
    prepare: impl FnOnce(&mut Core),
) -> Result<Run, Deadlock> {
    let options = Options { columns: options.columns.clamp(1, MAX_COLUMNS), ..options };
    let mut core = Core::new(config);
    prepare(&mut core);
    let first = core.state.prim.seq_num;
    let m = Machine::new(core, costs, options);
    for column in 0..m.columns {
        boot_column(&m, column);
    }
    m.pass_token(0, first);
    let read = Rc::new(RefCell::new(Vec::new()));
    let id = Rc::new(Cell::new(0));
    let host = host::run(Rc::clone(&m), records.to_vec(), Rc::clone(&read), Rc::clone(&id), true);
    id.set(m.k.spawn(Box::pin(host)));
    let ended = m.k.run();
    let result = match ended {
        Ended::Stopped => Ok(finish(&m, read.take())),
        Ended::Stuck => Err(Deadlock { cycle: m.k.now(), waits: m.waits() }),
    };
    m.k.clear();
    result
}

/// Starts the four tiles of a column and its interrupt handler.
fn boot_column(m: &Rc<Machine>, column: usize) {
    let tile = |stage: usize| &m.tile(stage, column).task;
    tile(0).set(m.k.spawn(Box::pin(stage1::run(Rc::clone(m), column))));
    tile(1).set(m.k.spawn(Box::pin(stage2::run(Rc::clone(m), column))));
    tile(2).set(m.k.spawn(Box::pin(stage3::run(Rc::clone(m), column))));
    tile(3).set(m.k.spawn(Box::pin(stage4::run(Rc::clone(m), column))));
    let handler = m.k.spawn(Box::pin(stage4::handler(Rc::clone(m), column)));
    m.tokens[column].handler.set(handler);
}

fn finish(m: &Machine, read: Vec<u32>) -> Run {
    let mut counters = *m.counters.borrow();
    for (stage, sum) in counters.active.iter_mut().enumerate() {
        *sum = (0..m.columns).map(|c| m.tile(stage, c).active.get()).sum();
    }
    let token = m.tokens.iter().find_map(|t| t.incoming.get().map(|(_, value)| value));
    Run {
        counters,
        core: m.core.borrow().clone(),
        read,
        faults: m.faults.take(),
        accepted: m.accepted.take(),
        token,
        cycles: m.k.now(),
    }
}
