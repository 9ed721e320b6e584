//! The simulator: four stages times any number of columns, as the thesis laid them out on Raw.
//!
//! Tiles run the stage functions of the reference renderer, so the picture is the same; the
//! simulator adds time. Reading order: [`cost`] (the one table), `kernel` and `link` (how time
//! passes), `switch` (who gets a primitive), `stage1` to `stage4` (the tiles' programs).
//!
//! Source: RAW, chapters 3 and 4.

mod bank;
mod boot;
mod cache;
mod charges;
pub mod cost;
mod gdn;
mod host;
mod kernel;
mod link;
mod machine;
mod meters;
mod options;
pub mod perf;
mod pipe;
pub mod single;
mod stage1;
mod stage2;
mod stage3;
mod stage4;
mod switch;
mod texturing;
mod ticket;

use std::cell::{Cell, RefCell};
use std::rc::Rc;

pub use self::host::HostSide;
pub use self::options::Options;
pub use self::switch::SwitchState;

use self::cost::Costs;
use self::kernel::Ended;
use self::machine::Machine;
use self::perf::Counters;
use crate::device::{Config, Core};
use crate::error::StreamError;
use crate::host::HostError;
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
    /// Faults in the records.
    pub host_faults: Vec<HostError>,
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
    let read = Rc::new(RefCell::new(Vec::new()));
    let taken = Rc::clone(&read);
    let owned: Vec<Record> = records.into();
    let side = HostSide {
        records: Box::new(owned.into_iter()),
        reply: Box::new(move |word| {
            taken.borrow_mut().push(word);
            true
        }),
        log: Box::new(|_| {}),
    };
    let (mut run, stuck) = play_stream(config, costs, options, side, prepare);
    run.read = read.take();
    stuck.map_or(Ok(run), Err)
}

/// As [`play`], with records and words passed as they come; where the machine gets stuck, what it
/// has done until then is returned as well.
pub fn play_stream(
    config: Config,
    costs: Costs,
    options: Options,
    side: HostSide,
    prepare: impl FnOnce(&mut Core),
) -> (Run, Option<Deadlock>) {
    let options = Options { columns: options.columns.clamp(1, MAX_COLUMNS), ..options };
    let mut core = Core::new(config);
    prepare(&mut core);
    let m = Machine::new(core, costs, options);
    boot(&m);
    let id = Rc::new(Cell::new(0));
    id.set(m.k.spawn(Box::pin(host::run(Rc::clone(&m), side, Rc::clone(&id)))));
    let stuck = match m.k.run() {
        Ended::Stopped => None,
        // A host that sends words to a halted device is left alone with them.
        Ended::Stuck if m.halted.get() => None,
        Ended::Stuck => Some(Deadlock { cycle: m.k.now(), waits: m.waits() }),
    };
    meters::settle(&m);
    let run = finish(&m);
    m.k.clear();
    (run, stuck)
}

/// Starts every tile.
fn boot(m: &Rc<Machine>) {
    for column in 0..m.columns {
        start_column(m, column);
    }
    if !m.options.uses_tickets() {
        (0..m.columns).for_each(|column| start_handler(m, column));
    } else if !m.options.uses_pipes() {
        (0..m.banks).for_each(|bank| start_arbiter(m, bank));
    }
}

/// Stops everything but the host interface and starts again. Beyond the thesis.
fn restart(m: &Rc<Machine>) {
    m.stop_tiles();
    m.halted.set(false);
    m.core.borrow_mut().reset();
    boot(m);
}

/// Starts the four tiles of a column.
fn start_column(m: &Rc<Machine>, column: usize) {
    let tile = |stage: usize| &m.tile(stage, column).task;
    tile(0).set(m.k.spawn(Box::pin(stage1::run(Rc::clone(m), column))));
    tile(1).set(m.k.spawn(Box::pin(stage2::run(Rc::clone(m), column))));
    tile(2).set(m.k.spawn(Box::pin(stage3::run(Rc::clone(m), column))));
    tile(3).set(m.k.spawn(Box::pin(stage4_program(Rc::clone(m), column))));
}

/// The program of a tile of row 3, after its boot.
async fn stage4_program(m: Rc<Machine>, column: usize) {
    boot::tile(&m, 3, column).await;
    let (pipe, step) = (column / pipe::STEPS, column % pipe::STEPS);
    match (m.options.uses_pipes(), step) {
        (true, 0) if pipe < m.banks => pipe::head(m, pipe).await,
        (true, _) if pipe < m.banks => pipe::step(m, pipe, step).await,
        (true, _) => {}
        _ if m.options.uses_tickets() => bank::run(m, column).await,
        _ => {
            if column == 0 {
                // The first tile of the row sends the token on its way.
                let first = m.core.borrow().state.prim.seq_num;
                m.pass_token(0, first);
            }
            stage4::run(m, column).await;
        }
    }
}

/// Starts the interrupt handler of a column.
fn start_handler(m: &Rc<Machine>, column: usize) {
    let task = m.k.spawn(Box::pin(stage4::handler(Rc::clone(m), column)));
    m.k.mark_idle(task);
    m.token(0, column).handler.set(task);
}

/// Starts the arbiter of a bank.
fn start_arbiter(m: &Rc<Machine>, bank: usize) {
    let task = m.k.spawn(Box::pin(bank::arbiter(Rc::clone(m), bank)));
    m.arbiters[bank].task.set(task);
}

fn finish(m: &Machine) -> Run {
    let token = match m.options.uses_tickets() {
        true => m.progress.iter().map(|bank| bank.low() as u32).min(),
        false => m.tokens.iter().find_map(|t| t.incoming.get().map(|(_, value)| value)),
    };
    Run {
        counters: m.counters(),
        core: m.core.borrow().clone(),
        read: Vec::new(),
        faults: m.faults.take(),
        host_faults: m.host_faults.take(),
        accepted: m.accepted.take(),
        token,
        cycles: m.k.now(),
    }
}
