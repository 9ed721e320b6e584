//! The grid draws what the single tile draws.

use fillrate_raw::opcode::Opcode;
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
}
