//! Any bytes through every way in: what tests and fuzzing feed. No panic, no hang, no large memory.

use std::io;

use crate::call::Call;
use crate::context::Context;
use crate::device::{Config, Device};
use crate::errata::Errata;
use crate::opcode::Opcode;
use crate::protocol::Record;
use crate::serve::{self, Build, RecordReader, Repair};
use crate::sim::Options;

/// A small device of either preset.
fn config(faithful: bool) -> Config {
    let errata = if faithful { Errata::FAITHFUL } else { Errata::CORRECT };
    Config { errata, texture_bytes: 4096, ..Config::default().sized(24, 16) }
}

/// Plays bytes: the first chooses the way in, the rest is the stream.
pub fn feed(bytes: &[u8]) {
    let Some((&way, stream)) = bytes.split_first() else { return };
    let config = config(way & 0x80 != 0);
    match way & 7 {
        0 => records(stream.to_vec(), config, Build::Single),
        1 => records(as_records(stream), config, Build::Single),
        2 => records(as_records(stream), config, Build::Fast(2)),
        3 => records(as_records(stream), config, Build::Grid(Options::default())),
        4 => records(as_records(stream), config, Build::Grid(Options::improved(4))),
        5 => calls(stream, config),
        6 => words(stream, config),
        _ => any_machine(stream, config),
    }
}

/// A grid of one to eight columns with any of its switches changed, by the first three bytes.
fn any_machine(stream: &[u8], config: Config) {
    let (switches, stream) = stream.split_at(stream.len().min(3));
    let bits = switches.iter().fold(0u32, |bits, byte| bits << 8 | u32::from(*byte));
    let mut options = Options { columns: 1 + (bits >> 16 & 7) as usize, ..Options::default() };
    for (i, name) in Options::NAMES.iter().enumerate() {
        let on = Options::of_the_thesis().any(|on| on == *name);
        options.set(name, on != (bits >> i & 1 == 1));
    }
    records(as_records(stream), config, Build::Grid(options));
}

/// Numbers that are the same on every machine: xorshift.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }
}

/// What to feed for a seed, up to 400 bytes; seeds in a row go every way in.
pub fn stream(seed: u64) -> Vec<u8> {
    let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    let length = random.next() % 400;
    let mut bytes = vec![(seed % 8) as u8 | (random.next() as u8 & 0x80)];
    // Half of the streams enter a scene first and send triangles between the nonsense.
    if random.next().is_multiple_of(2) {
        bytes.extend([0xc0, 100, 102]);
    }
    while (bytes.len() as u64) < length {
        match random.next() % 8 {
            0 => triangle(&mut bytes, &mut random),
            _ => bytes.push(random.next() as u8),
        }
    }
    bytes
}

/// Three framed vertices and an end marker.
fn triangle(bytes: &mut Vec<u8>, random: &mut Random) {
    for _ in 0..3 {
        bytes.extend([6, 3]);
        (0..5).for_each(|_| bytes.push(0x80 | random.next() as u8 & 0x3f));
    }
    bytes.push(0);
}

fn records(stream: Vec<u8>, config: Config, build: Build) {
    let reader = RecordReader::new(io::Cursor::new(stream), Repair::NextLine);
    serve::serve(build, config, reader, io::sink(), |_| {});
}

/// Words that resemble commands, since plain bytes hardly ever would: each byte is an opcode, a
/// small number, a float or a count.
fn words_of(stream: &[u8]) -> impl Iterator<Item = u32> + '_ {
    stream.iter().enumerate().map(|(place, &byte)| match byte {
        0..=0x7f => u32::from(byte),
        0x80..=0xbf => (f32::from(byte) / 32.0 - 5.0).to_bits(),
        0xc0..=0xef => Opcode::ALL[usize::from(byte - 0xc0) % Opcode::ALL.len()] as u32,
        0xf0..=0xf7 => u32::MAX - u32::from(byte),
        _ => (place as u32).wrapping_mul(0x9e37_79b9),
    })
}

fn as_records(stream: &[u8]) -> Vec<u8> {
    let record = |word: u32| match word {
        // A few words stand for meta records; scenes need them to wait.
        100 => Record::Wait,
        101 => Record::Read,
        102 => Record::EnterScene,
        103 => Record::PerfStart,
        104 => Record::Report,
        105 => Record::AsyncReset,
        word => Record::Data(word),
    };
    words_of(stream).flat_map(|word| record(word).bytes()).collect()
}

fn words(stream: &[u8], config: Config) {
    let mut device = Device::new(Config { threads: 1, ..config });
    words_of(stream).for_each(|word| device.push(word));
    while device.pop_reply().is_some_and(|word| word != 0) {}
    device.into_core();
}

/// Calls as a damaged trace may hold them.
fn calls(stream: &[u8], config: Config) {
    let mut context = Context::new(config);
    for chunk in stream.chunks(24) {
        if let Ok(call) = fillrate_call::from_bytes::<Call>(chunk) {
            context.execute(&bounded(call));
        }
    }
    context.shown();
    context.take_reports();
}

/// A call that asks for no more than a test can wait for.
fn bounded(call: Call) -> Call {
    match call {
        Call::ReadFbBlock { x, y, page, count } => {
            Call::ReadFbBlock { x, y, page, count: count % 4096 }
        }
        Call::ReadZBlock { x, y, count } => Call::ReadZBlock { x, y, count: count % 4096 },
        Call::Resize { width, height } => Call::Resize { width: width % 256, height: height % 256 },
        call => call,
    }
}
