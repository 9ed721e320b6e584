//! Recording, reading and drawing of word streams: `cargo bench -p
//! fillrate-redline`. Rates are triangles a second on one thread; whole pictures
//! are `fillrate bench --only R`.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use fillrate_engine::DeviceConfig;
use fillrate_redline::surface::{PRIMARY, Z_BUFFER};
use fillrate_redline::{
    Call, Chip, CommandBuffer, Commands, Context, NoMemory, RedlineConfig, Surface, record,
};

const TRIANGLES: usize = 1024;
/// `V_FIFO_KXYZ`.
const KXYZ: u32 = 18;

/// A triangle of ten pixels by number.
fn corners(i: usize) -> [[u32; 4]; 3] {
    let (x, y) = ((i % 60 * 10) as u32, (i / 60 % 47 * 10) as u32);
    [(0, 0), (5, 1), (1, 5)]
        .map(|(dx, dy)| [(i * 0x01_0305) as u32, (x + dx) << 16, (y + dy) << 16, 100 << 16])
}

fn buffer() -> CommandBuffer {
    CommandBuffer::new(1, 8, TRIANGLES * 13 + 64).expect("a valid size")
}

fn record_all(to: &mut CommandBuffer, all: &[[[u32; 4]; 3]]) {
    for [a, b, c] in all {
        record::triangle(to, KXYZ, a, b, c).expect("there is room");
    }
}

fn recording(c: &mut Criterion) {
    let all: Vec<_> = (0..TRIANGLES).map(corners).collect();
    let mut group = c.benchmark_group("record");
    group.throughput(Throughput::Elements(TRIANGLES as u64));
    let mut to = buffer();
    group.bench_function("triangle/kxyz", |b| {
        b.iter(|| {
            to.reset();
            record_all(&mut to, black_box(&all));
            black_box(to.words().len())
        })
    });
    group.bench_function("set_z", |b| {
        b.iter(|| {
            to.reset();
            for i in 0..TRIANGLES as u32 {
                record::set_z(&mut to, black_box(i)).expect("there is room");
            }
        })
    });
    group.finish();
}

fn reading(c: &mut Criterion) {
    let all: Vec<_> = (0..TRIANGLES).map(corners).collect();
    let mut words = buffer();
    record_all(&mut words, &all);
    let mut group = c.benchmark_group("read");
    group.throughput(Throughput::Elements(TRIANGLES as u64));
    group.bench_function("commands/kxyz", |b| {
        b.iter(|| Commands::new(black_box(words.words()), Chip::V2000).count())
    });
    group.finish();
}

/// Issuing small triangles and waiting for them.
fn drawing(c: &mut Criterion) {
    let device = DeviceConfig { threads: 1, ..DeviceConfig::default() };
    let config = RedlineConfig { background: false, device, ..RedlineConfig::default() };
    let mut context = Context::new(config);
    let mut make = |call: &Call| context.execute(call).expect("it is valid").number();
    let device = make(&Call::OpenVerite {});
    let (mask, format, width, height) = (PRIMARY | Z_BUFFER, 4, 640, 480);
    make(&Call::SetDisplayType { device, display_type: 2 });
    let group = make(&Call::CreateSurface { device, mask, buffers: 3, format, width, height });
    let id = make(&Call::CreateCmdBuffer { device, entries: 8, words: 64 });
    let display = context.group(device, group).expect("it was made").clone();
    let mut to = buffer();
    record::install_dst_buffer(&mut to, &Surface::new(width, height, 4), &display)
        .expect("there is room");
    record::install_z_buffer(&mut to, &display).expect("there is room");
    record_all(&mut to, &(0..TRIANGLES).map(corners).collect::<Vec<_>>());
    let segments = to.snapshot(&NoMemory).expect("no memory is referred to");
    let issue = Call::IssueCmdBuffer { device, buffer: id, segments, wait: true };
    let mut bench = c.benchmark_group("draw");
    bench.throughput(Throughput::Elements(TRIANGLES as u64));
    bench.bench_function("triangle/kxyz", |b| b.iter(|| context.execute(black_box(&issue))));
    bench.finish();
}

criterion_group!(benches, recording, reading, drawing);
criterion_main!(benches);
