//! The switches of stage 1 under random busy times and grid sizes.

use fillrate_raw::sim::cost::{Burst, COSTS, Costs};
use fillrate_raw::sim::{self, Options};
use fillrate_raw::{Config, scenes};
use proptest::prelude::*;

use crate::common::{on_single, scene};

/// Costs with other busy times, so that tiles become ready in other orders.
fn costs(transform: u32, pixel: u32, host_word: u32, path_words: usize) -> Costs {
    let mut costs = COSTS;
    costs.s1.transform = Burst::new(transform, 60);
    costs.s4.pixel = Burst::new(pixel, 80);
    Costs { host_word, path_words, ..costs }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn every_primitive_is_drawn_once_and_in_order(
        transform in 1u32..20_000,
        pixel in 1u32..3_000,
        host_word in 1u32..60,
        path_words in 1usize..40,
        columns in 1usize..12,
        alpha in prop_oneof![Just(0xffu32), Just(0x88)],
    ) {
        let records = scene(
            |client| client.model(&scenes::pattern_model(0.1, 0.0)),
            |client| {
                scenes::triangle_pattern(client, alpha);
                scenes::order_test(client);
            },
        );
        let options = Options { columns, ..Options::default() };
        let costs = costs(transform, pixel, host_word, path_words);
        // A second active switch would panic inside the simulator.
        let run = sim::play(Config::default(), costs, options, &records, |_| {}).expect("runs");
        prop_assert_eq!(run.accepted.len(), 19);
        prop_assert_eq!(run.token, Some(20));
        prop_assert!(run.accepted.iter().all(|(column, _)| *column < columns));
        prop_assert!(run.accepted.windows(2).all(|w| w[0].1 <= w[1].1));
        prop_assert!(run.core.target == on_single(&records).core().target);
    }
}
