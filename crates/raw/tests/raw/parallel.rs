//! The grid draws what the single tile draws.

use fillrate_raw::call::Call;
use fillrate_raw::client::Client;
use fillrate_raw::opcode::Opcode;
use fillrate_raw::protocol::Record;
use fillrate_raw::sim::cost::COSTS;
use fillrate_raw::sim::{self, Options};
use fillrate_raw::{Config, Errata, scenes};

use crate::common::{on_grid, on_single, pattern, scene};

#[test]
fn pattern_is_identical_on_one_to_eight_columns() {
    for modes in [&[][..], &[(Opcode::SetNoUseZ, 1), (Opcode::SetNoWriteZ, 1)]] {
        let records = pattern(0.3, 0x88, modes);
        let single = on_single(&records);
        for columns in [1, 2, 3, 4, 8] {
            let run = on_grid(columns, &records);
            assert!(run.core.target == single.core().target, "{columns} columns");
            assert_eq!(run.counters.frags, single.observer().counters().frags);
            assert_eq!(run.counters.pixels, single.observer().counters().pixels);
            assert_eq!(run.token, Some(25));
        }
    }
}

/// A large triangle, and many tiny ones behind it.
fn large_then_small(client: &mut Client) {
    for index in 0..40u8 {
        let size = if index == 0 { 0.9 } else { 0.02 };
        let (left, z) = (f32::from(index) / 45.0, f32::from(index) / 100.0);
        client.call(&Call::BeginPrim {});
        for [x, y] in [[0.0, 0.0], [size, 0.0], [0.0, size]] {
            client.vertex([left + x - 0.9, y, z], [0.0; 2]);
        }
        client.call(&Call::EndPrim {});
    }
}

#[test]
fn busy_tiles_are_skipped() {
    let records = scene(|_| {}, large_then_small);
    let run = |skip_busy| {
        let options = Options { skip_busy, ..Options::default() };
        sim::play(Config::default(), COSTS, options, &records, |_| {}).expect("no deadlock")
    };
    let (skips, waits) = (run(true), run(false));
    assert!(skips.core.target == on_single(&records).core().target);
    assert!(waits.core.target == skips.core.target);
    // In the row, tile after tile.
    let columns = |run: &sim::Run| run.accepted.iter().map(|a| a.0).collect::<Vec<_>>();
    assert!(columns(&waits).iter().enumerate().all(|(i, column)| *column == i % 4));
    let of_the_first = columns(&skips).iter().filter(|column| **column == 0).count();
    assert!(of_the_first < 5, "{of_the_first}");
    assert!(skips.cycles < waits.cycles);
}

#[test]
fn order_test_is_identical() {
    let records = scene(|_| {}, scenes::order_test);
    let single = on_single(&records);
    let run = on_grid(4, &records);
    assert!(run.core.target == single.core().target);
    assert_eq!(run.token, Some(14));
}

#[test]
fn cubes_are_identical() {
    let records = scene(scenes::cube_view, scenes::nine_cubes);
    let single = on_single(&records);
    assert!(single.observer().counters().frags > 1000);
    let run = on_grid(4, &records);
    assert!(run.core.target == single.core().target);
}

/// The order test twice, with a reset between.
fn with_a_reset() -> Vec<Record> {
    let mut client = Client::new(Errata::CORRECT);
    for _ in 0..2 {
        client.call(&Call::BeginScene {});
        scenes::order_test(&mut client);
        client.call(&Call::EndScene {});
        client.call(&Call::Reset {});
    }
    client.call(&Call::BeginScene {});
    scenes::order_test(&mut client);
    client.call(&Call::EndScene {});
    client.take_records()
}

#[test]
fn numbers_go_on_after_a_reset() {
    let records = with_a_reset();
    let single = on_single(&records);
    assert_eq!(single.core().state.prim.seq_num, 14);
    for columns in [1, 4] {
        let run = on_grid(columns, &records);
        assert!(run.core.target == single.core().target, "{columns} columns");
        assert_eq!((run.token, run.core.state.prim.seq_num), (Some(40), 40));
    }
}

#[test]
fn clears_count_pixels_and_take_time() {
    let mut client = Client::new(Errata::CORRECT);
    client.meta(Record::PerfStart);
    client.call(&Call::ClearFb { pages: 3, rgbx: 7 });
    client.call(&Call::ClearZ {});
    client.call(&Call::WriteFb { x: 1, y: 1, pages: 1, rgbx: 7 });
    client.call(&Call::WriteFbBlock { x: 1, y: 1, pages: 1, pixels: vec![1, 2, 3] });
    client.call(&Call::WriteZBlock { x: 1, y: 1, depths: vec![1, 2] });
    client.meta(Record::PerfStop);
    let mut records = client.take_records();
    // The grid counts what has been done when the host stops it.
    records.splice(records.len() - 1.., [Record::Data(36), Record::Wait, Record::PerfStop]);
    let single = on_single(&records).observer().counters();
    let grid = on_grid(4, &records).counters;
    let written = 2 * 320 * 240 + 1 + 3 + 2;
    for counters in [single, grid] {
        assert_eq!(counters.pixels, 320 * 240 + 1 + 3);
        assert_eq!((counters.stream_cycles, counters.active), (0, [0; 4]));
        let words = (records.len() - 3) as u64;
        let expected = 8 * written + 10 * words;
        assert!((expected..expected + 300).contains(&counters.render_cycles), "{counters:?}");
    }
}

#[test]
fn a_halted_machine_stops() {
    let words = [30, 47, 30, 30, 30, 30, 30, 30, 30].map(Record::Data);
    let run = on_grid(4, &words);
    assert!(run.faults.is_empty());
}

#[test]
fn forced_roll_over_flushes_and_goes_on() {
    let records = pattern(0.1, 0xff, &[]);
    for back in 1..=6 {
        let options = Options::default();
        let run = sim::play(Config::default(), COSTS, options, &records, |core| {
            core.state.prim.seq_num = 0u32.wrapping_sub(back);
            core.state.lagged_seq_num = core.state.prim.seq_num;
        })
        .expect("no deadlock");
        assert_eq!(run.token, Some(24 - back));
        assert!(run.core.target == on_single(&records).core().target);
    }
}

#[test]
fn faithful_roll_over_hangs_and_says_who_waits() {
    let errata = Errata { rollover_keeps_lagged: true, ..Errata::CORRECT };
    let config = Config { errata, ..Config::default() };
    let stuck = sim::play(config, COSTS, Options::default(), &pattern(0.1, 0xff, &[]), |core| {
        core.state.prim.seq_num = u32::MAX - 2;
        core.state.lagged_seq_num = u32::MAX - 2;
    })
    .expect_err("unordered primitives wait for a number that never comes");
    assert!(stuck.waits.contains("(stage 4) waits for the token"), "{stuck}");
    assert!(stuck.waits.contains("the token, at"), "{stuck}");
}

/// Every switch alone, all that improve, and the pixel pipelines with them.
fn machines(columns: usize) -> Vec<(String, Options)> {
    let base = Options { columns, ..Options::default() };
    let mut machines = vec![("improved".to_owned(), Options::improved(columns))];
    for name in Options::NAMES {
        let mut options = base;
        options.set(name, !Options::of_the_thesis().any(|on| on == *name));
        machines.push(((*name).to_owned(), options));
    }
    let piped = Options { pixel_pipeline: true, ..Options::improved(columns) };
    machines.push(("piped".to_owned(), piped));
    machines
}

#[test]
fn every_switch_draws_the_same_picture() {
    let scenes = [
        scene(|_| {}, scenes::order_test),
        pattern(0.2, 0x88, &[]),
        pattern(0.05, 0xff, &[(Opcode::SetNoUseZ, 1)]),
        scene(scenes::cube_view, scenes::nine_cubes),
    ];
    for records in &scenes {
        let single = on_single(records);
        for columns in [1, 4, 6, 9] {
            for (name, options) in machines(columns) {
                let run = sim::play(Config::default(), COSTS, options, records, |_| {});
                let run = run.unwrap_or_else(|stuck| panic!("{name}, {columns}: {stuck}"));
                assert!(run.core.target == single.core().target, "{name} on {columns} columns");
                let primitives = run.accepted.len() as u32;
                assert_eq!(run.token, Some(primitives + 1), "{name} on {columns} columns");
            }
        }
    }
}

#[test]
fn uploads_stay_in_the_caches_of_the_listing() {
    let square = |client: &mut Client| {
        client.call(&Call::BeginScene {});
        client.call(&Call::BeginPrim {});
        for ([x, y], uv) in [([-1., -1.], [0., 0.]), ([1., -1.], [1., 0.]), ([-1., 1.], [0., 1.])] {
            client.vertex([x, y, 0.0], uv);
        }
        client.call(&Call::EndPrim {});
        client.call(&Call::EndScene {});
    };
    let mut client = Client::new(Errata::CORRECT);
    client.call(&Call::AllocateTexture { width: 4, height: 4 });
    client.set(Opcode::SetTexMode, 2);
    for texel in [0x1122_33ff, 0x4455_66ff] {
        client.call(&Call::UploadTexture { id: 0, texels: vec![texel; 16] });
        square(&mut client);
        square(&mut client);
    }
    let records = client.take_records();
    let listing = Errata { uploads_stay_cached: true, ..Errata::CORRECT };
    for (errata, color) in [(Errata::CORRECT, 0x4455_6600), (listing, 0x1122_3300)] {
        let config = Config { errata, ..Config::default() };
        let options = Options { columns: 1, ..Options::default() };
        let run = sim::play(config, COSTS, options, &records, |_| {}).expect("runs");
        assert_eq!(run.core.target.frame.read(0, false), color);
        // One tile has one cache, and the manager writes through it.
        let (device, _) = sim::single::play(config, COSTS, &records);
        assert_eq!(device.core().target.frame.read(0, false), 0x4455_6600);
    }
}

#[test]
fn large_triangles_without_pixels_are_no_deadlock() {
    // The box is searched in vain for millions of cycles, while only the token moves.
    let config = Config::default().sized(2048, 2048);
    let records = scene(
        |_| {},
        |client| {
            client.call(&Call::BeginPrim {});
            for [x, y] in [[-1.0, -1.0], [1.0, 1.0], [0.9999, 1.0]] {
                client.vertex([x, y, 0.0], [0.0; 2]);
            }
            client.call(&Call::EndPrim {});
        },
    );
    let run = sim::play(config, COSTS, Options::default(), &records, |_| {}).expect("no deadlock");
    assert_eq!(run.token, Some(2));
}
