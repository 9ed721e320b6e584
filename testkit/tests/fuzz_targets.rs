//! The fuzz targets over seeded inputs: a few seconds of each.
//!
//! `FILLRATE_CASES` sets how many (5,000 without it), `FILLRATE_SEED` the first.

use std::collections::BTreeSet;

use fillrate_call::Tagged;
use fillrate_engine::{Counters, DeviceConfig};
use fillrate_glide::Call;
use fillrate_simd::Level;
use fillrate_testkit::fuzz::{
    Bytes, Fuzzer, Target, any_call, any_quark_call, any_rave_call, any_redline_call,
    any_redline_words, context, input, run_quark, run_rave, run_redline_calls, run_redline_words,
    run_stream,
};

/// A number from the environment.
fn setting(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
}

fn seeds() -> std::ops::Range<u64> {
    let first = setting("FILLRATE_SEED", 1);
    first..first + setting("FILLRATE_CASES", 5_000)
}

fn run(target: Target) {
    let mut fuzzer = Fuzzer::new(target);
    for seed in seeds() {
        let bytes = target.input(seed);
        let outcome = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| fuzzer.run(&bytes)));
        assert!(outcome.is_ok(), "{}: FILLRATE_SEED={seed}", target.name());
    }
}

#[test]
fn any_stream_of_calls_is_survived() {
    run(Target::Calls);
}

#[test]
fn texels_of_every_format_are_what_their_bytes_say() {
    run(Target::Textures);
}

#[test]
fn any_texture_file_is_survived() {
    run(Target::Files);
}

#[test]
fn any_stream_of_quark_calls_is_survived() {
    run(Target::Quark);
}

/// Streams of Quark 3D hold every call, and draw the same on any number of
/// threads.
#[test]
fn quark_streams_are_whole_and_steady() {
    let mut seen = BTreeSet::new();
    let mut shown = BTreeSet::new();
    for seed in 0..2_000 {
        let bytes = input(seed);
        let mut from = Bytes::new(&bytes);
        while !from.is_empty() {
            seen.insert(any_quark_call(&mut from).tag());
        }
        if seed % 10 == 0 {
            let frames = run_quark(&bytes, 1);
            assert_eq!(frames, run_quark(&bytes, 3), "FILLRATE_SEED={seed}");
            shown.extend(frames);
        }
    }
    let all: BTreeSet<u16> = fillrate_quark::Call::VARIANTS.iter().map(|(tag, _)| *tag).collect();
    assert_eq!(seen, all);
    assert!(shown.len() > 50, "{} pictures", shown.len());
}

#[test]
fn any_stream_of_rave_calls_is_survived() {
    run(Target::Rave);
}

/// Streams of RAVE hold every call, and draw the same on any number of threads.
#[test]
fn rave_streams_are_whole_and_steady() {
    let mut seen = BTreeSet::new();
    let mut shown = BTreeSet::new();
    for seed in 0..2_000 {
        let bytes = input(seed);
        let mut from = Bytes::new(&bytes);
        while !from.is_empty() {
            seen.insert(any_rave_call(&mut from).tag());
        }
        if seed % 10 == 0 {
            let frames = run_rave(&bytes, 1);
            assert_eq!(frames, run_rave(&bytes, 3), "FILLRATE_SEED={seed}");
            shown.extend(frames);
        }
    }
    let all: BTreeSet<u16> = fillrate_rave::Call::VARIANTS.iter().map(|(tag, _)| *tag).collect();
    assert_eq!(seen, all);
    assert!(shown.len() > 50, "{} pictures", shown.len());
}

#[test]
fn any_stream_of_redline_words_is_survived() {
    run(Target::RedlineWords);
}

#[test]
fn any_stream_of_redline_calls_is_survived() {
    run(Target::RedlineCalls);
}

/// A block of host pixels of no bytes, while the source has four bits a pixel.
#[test]
fn regress_redline_block_of_no_bytes() {
    Fuzzer::new(Target::RedlineCalls).run(&input(208_156));
}

/// No rows, each of nearly 4 GiB.
#[test]
fn regress_redline_rows_of_all_bytes() {
    Fuzzer::new(Target::RedlineCalls).run(&input(407_846));
}

/// A copy of many rows of one pixel, each far from the start of its row, took a
/// gibibyte.
#[test]
fn regress_redline_copies_of_narrow_rows() {
    Fuzzer::new(Target::RedlineWords).run(&input(263_424));
}

/// Streams of RRedline hold every call, command and register, and draw the same
/// on any number of threads.
#[test]
fn redline_streams_are_whole_and_steady() {
    use fillrate_redline::{Call, Chip, Command, Commands, Opcode, Register};
    let (mut calls, mut opcodes) = (BTreeSet::new(), BTreeSet::new());
    let (mut registers, mut drawn, mut streams) = (BTreeSet::new(), BTreeSet::new(), 0);
    for seed in 0..2_000 {
        let bytes = input(seed);
        let mut from = Bytes::new(&bytes);
        while !from.is_empty() {
            calls.insert(any_redline_call(&mut from, 0, Chip::V2000).tag());
            let mut words = Vec::new();
            any_redline_words(&mut from, 0, &mut words);
            match Commands::new(&words, Chip::V2000).next() {
                Some(Ok(Command::State { register, .. })) => drop(registers.insert(register)),
                Some(Ok(Command::Draw { opcode, .. } | Command::Other { opcode, .. })) => {
                    opcodes.insert(opcode);
                }
                _ => {}
            }
        }
        if seed % 10 == 0 {
            let words = run_redline_words(&bytes, 1);
            assert_eq!(words, run_redline_words(&bytes, 3), "FILLRATE_SEED={seed}");
            let calls = run_redline_calls(&bytes, 1);
            assert_eq!(calls, run_redline_calls(&bytes, 3), "FILLRATE_SEED={seed}");
            streams += words.len();
            drawn.extend(words);
        }
    }
    let all: BTreeSet<u16> = Call::VARIANTS.iter().map(|(tag, _)| *tag).collect();
    assert_eq!(calls, all);
    assert_eq!(opcodes.len(), Opcode::ALL.len(), "{opcodes:?}");
    assert_eq!(registers.len(), Register::ALL.len(), "{registers:?}");
    // A wrong command skips its buffer, and some streams draw nothing.
    assert!(drawn.len() * 2 > streams, "{} pictures of {streams} streams", drawn.len());
}

/// Every call there is, calls of the next release included.
#[test]
fn streams_hold_every_call() {
    let mut seen = BTreeSet::new();
    for seed in 0..20_000 {
        let bytes = input(seed);
        seen.insert(any_call(&mut Bytes::new(&bytes)).tag());
    }
    let all: BTreeSet<u16> = Call::VARIANTS.iter().map(|(tag, _)| *tag).collect();
    assert_eq!(seen, all);
}

/// Streams draw, and the same whatever the level and the number of threads.
#[test]
fn streams_draw_the_same_everywhere() {
    let device = |threads, level| DeviceConfig { threads, level, ..DeviceConfig::default() };
    let best = DeviceConfig::default().level;
    let mut total = Counters::default();
    for seed in seeds().take(300) {
        let bytes = input(seed);
        let one = run_stream(&mut context(device(1, best), false), &bytes);
        let other = run_stream(&mut context(device(3, Level::Scalar), true), &bytes);
        assert_eq!(one, other, "FILLRATE_SEED={seed}");
        total += one.counters;
    }
    assert!(total.pixels_out > 10_000 && total.triangles_drawn > 100, "{total:?}");
    println!("{total:?}");
}
