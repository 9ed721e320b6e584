//! The cube scene at 640x480 (frames a second), and a run of the simulator (cycles a second):
//! `cargo bench -p fillrate-raw`.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use fillrate_raw::bench::{run, vectors};
use fillrate_raw::call::Call;
use fillrate_raw::client::Client;
use fillrate_raw::host::Host;
use fillrate_raw::opcode::Opcode;
use fillrate_raw::protocol::Record;
use fillrate_raw::{Config, Device, Errata, scenes};

/// Modes of the textured and lit cubes.
const LIT: [(Opcode, u32); 7] = [
    (Opcode::SetTexMode, 6),
    (Opcode::SetTexAlpha, 0),
    (Opcode::SetTexInterp, 1),
    (Opcode::SetLit, 1),
    (Opcode::SetUseAmb, 1),
    (Opcode::SetUseDir, 1),
    (Opcode::SetLitInterp, 1),
];

/// A device ready for the cubes.
fn device(threads: usize, lit: bool) -> Host {
    let mut client = Client::new(Errata::CORRECT);
    client.call(&Call::AllocateTexture { width: 16, height: 16 });
    client.call(&Call::UploadTexture { id: 0, texels: scenes::decal_texture() });
    scenes::cube_view(&mut client);
    scenes::test_lights(&mut client);
    if lit {
        LIT.into_iter().for_each(|(op, value)| client.set(op, value));
    }
    let config = Config { threads, ..Config::default().sized(640, 480) };
    let mut host = Host::new(Device::new(config));
    push(&mut host, &client.take_records());
    host
}

fn push(host: &mut Host, records: &[Record]) {
    records.iter().for_each(|record| host.push(*record).expect("a good stream"));
}

/// Clears and cubes of one frame.
fn frame() -> Vec<Record> {
    let mut client = Client::new(Errata::CORRECT);
    client.call(&Call::ClearFb { pages: 1, rgbx: 0x1820_3000 });
    client.call(&Call::ClearZ {});
    client.call(&Call::BeginScene {});
    scenes::nine_cubes(&mut client);
    client.call(&Call::EndScene {});
    client.take_records()
}

fn cubes(c: &mut Criterion) {
    let records = frame();
    for (name, lit) in [("cubes, flat", false), ("cubes, textured and lit", true)] {
        let mut group = c.benchmark_group(name);
        group.throughput(Throughput::Elements(1)).sample_size(20);
        for threads in [0, 1, 2, 4] {
            let mut host = device(threads, lit);
            group.bench_function(BenchmarkId::from_parameter(threads), |b| {
                b.iter(|| push(&mut host, &records));
                assert!(host.device().fragments() > 0);
            });
        }
        group.finish();
    }
}

fn simulator(c: &mut Criterion) {
    let mut group = c.benchmark_group("simulator");
    let (outer, inner) = vectors::CHARTED[8].vectors();
    let test = run::Test { outer, inner, scale: 0.5 };
    let setting = run::Setting::default();
    let cycles = run::run(test, &setting).expect("runs").grid.stream_cycles;
    group.throughput(Throughput::Elements(cycles)).sample_size(10);
    group.bench_function("everything on, 0.5", |b| {
        b.iter(|| run::run(test, &setting).expect("runs"));
    });
    group.finish();
}

criterion_group!(benches, cubes, simulator);
criterion_main!(benches);
