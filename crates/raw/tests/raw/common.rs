//! Scenes as records, and running them on both builds.

use fillrate_raw::call::Call;
use fillrate_raw::client::Client;
use fillrate_raw::opcode::Opcode;
use fillrate_raw::protocol::Record;
use fillrate_raw::sim::cost::COSTS;
use fillrate_raw::sim::single::{self, SingleTile};
use fillrate_raw::sim::{self, Options, Run};
use fillrate_raw::{Config, Device, Errata, scenes};

/// The records of a scene: `setup` in command mode, `draw` inside the scene.
pub fn scene(setup: impl FnOnce(&mut Client), draw: impl FnOnce(&mut Client)) -> Vec<Record> {
    let mut client = Client::new(Errata::CORRECT);
    setup(&mut client);
    client.meta(Record::PerfStart);
    client.call(&Call::BeginScene {});
    draw(&mut client);
    client.call(&Call::EndScene {});
    client.take_records()
}

/// The triangle pattern, four times.
pub fn pattern(scale: f32, alpha: u32, modes: &[(Opcode, u32)]) -> Vec<Record> {
    scene(
        |client| {
            client.model(&scenes::pattern_model(scale, 0.0));
            modes.iter().for_each(|(op, value)| client.set(*op, *value));
        },
        |client| (0..4).for_each(|_| scenes::triangle_pattern(client, alpha)),
    )
}

pub fn on_single(records: &[Record]) -> Device<SingleTile> {
    single::play(Config::default(), COSTS, records).0
}

pub fn on_grid(columns: usize, records: &[Record]) -> Run {
    let options = Options { columns, ..Options::default() };
    sim::play(Config::default(), COSTS, options, records, |_| {}).expect("no deadlock")
}
