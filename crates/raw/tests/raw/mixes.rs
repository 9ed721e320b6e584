//! Any mix of modes on any machine: the grid draws what the single tile draws, as long as no two
//! primitives that overlap have equal depths and nobody forces the order.

use fillrate_raw::call::Call;
use fillrate_raw::client::Client;
use fillrate_raw::opcode::Opcode;
use fillrate_raw::protocol::Record;
use fillrate_raw::sim::cost::{Burst, COSTS, Costs};
use fillrate_raw::sim::{self, Options, single};
use fillrate_raw::{Config, scenes};
use proptest::prelude::*;

use crate::common::scene;

/// A primitive: corners with texture coordinates and colours, and modes set before it.
#[derive(Clone, Debug)]
struct Primitive {
    corners: Vec<([f32; 2], [f32; 2], u32)>,
    modes: Vec<(u32, u32)>,
    kind: u32,
}

/// Alpha of the corners: all transparent, all opaque, or each its own.
fn alpha() -> impl Strategy<Value = Option<u32>> {
    prop_oneof![Just(Some(0)), Just(Some(255)), Just(None)]
}

/// The mode commands but the one that forces the order.
fn modes() -> impl Strategy<Value = Vec<(u32, u32)>> {
    let opcode = prop_oneof![8u32..17, 18u32..21, Just(Opcode::SetTexMode as u32)];
    prop::collection::vec((opcode, 0u32..8), 0..5)
}

fn primitive() -> impl Strategy<Value = Primitive> {
    let place = -1.1f32..1.1;
    let corner = ([place.clone(), place], [-2.0f32..2.0, -2.0f32..2.0], any::<u32>());
    let kind = prop_oneof![4 => Just(0u32), 1 => 1u32..7];
    (prop::collection::vec(corner, 3..7), modes(), kind, alpha()).prop_map(
        |(mut corners, modes, kind, alpha)| {
            for (_, _, rgba) in &mut corners {
                *rgba = alpha.map_or(*rgba, |alpha| *rgba & !0xff | alpha);
            }
            Primitive { corners, modes, kind }
        },
    )
}

fn draw(client: &mut Client, primitives: &[Primitive]) {
    for (index, primitive) in primitives.iter().enumerate() {
        primitive.modes.iter().for_each(|&(opcode, value)| {
            client.call(&Call::Set { opcode, value });
        });
        client.call(&Call::SetPrimitive { kind: primitive.kind });
        client.call(&Call::BeginPrim {});
        // Neighbours in time are neither sorted nor equal in depth.
        let z = (index * 7 % 16) as f32 / 16.0 - 0.4;
        for (p, uv, rgba) in &primitive.corners {
            client.call(&Call::Color { rgba: *rgba });
            client.vertex([p[0], p[1], z], *uv);
        }
        client.call(&Call::EndPrim {});
    }
}

fn records(primitives: &[Primitive], pages: u32) -> Vec<Record> {
    scene(
        |client| {
            client.call(&Call::AllocateTexture { width: 16, height: 16 });
            client.call(&Call::UploadTexture { id: 0, texels: scenes::decal_texture() });
            scenes::test_lights(client);
            client.call(&Call::SetPage { pages });
        },
        |client| draw(client, primitives),
    )
}

/// The machine with some of its switches changed.
fn options() -> impl Strategy<Value = Options> {
    let changed = prop_oneof![Just(0u32), any::<u32>()];
    (1usize..9, changed).prop_map(|(columns, changed)| {
        let mut options = Options { columns, ..Options::default() };
        for (i, name) in Options::NAMES.iter().enumerate() {
            let on = Options::of_the_thesis().any(|on| on == *name);
            options.set(name, on != (changed >> i & 1 == 1));
        }
        options
    })
}

fn costs() -> impl Strategy<Value = Costs> {
    (1u32..9000, 1u32..2000, 1u32..400, 1usize..30).prop_map(|(s1, s2, s4, path_words)| {
        let mut costs = COSTS;
        costs.s1.transform = Burst::new(s1, 60);
        costs.s2.setup = Burst::new(s2, 60);
        costs.s4.pixel = Burst::new(s4, 80);
        Costs { path_words, ..costs }
    })
}

fn cases() -> u32 {
    std::env::var("FILLRATE_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(200)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(cases()))]

    #[test]
    fn every_mix_is_drawn_alike(
        primitives in prop::collection::vec(primitive(), 1..16),
        pages in 1u32..4,
        options in options(),
        costs in costs(),
    ) {
        let config = Config::default().sized(72, 40);
        let records = records(&primitives, pages);
        let (device, _) = single::play(config, costs, &records);
        let run = sim::play(config, costs, options, &records, |_| {}).expect("no deadlock");
        prop_assert!(run.core.target == device.core().target);
        prop_assert_eq!(run.token, Some(run.accepted.len() as u32 + 1));
        prop_assert_eq!(run.counters.frags, device.observer().counters().frags);
    }
}
