//! The fast path draws what the reference draws, bit for bit: whatever the modes and the errors kept,
//! on however many threads, at every SIMD level, in tiles of every size.

use fillrate_raw::call::Call;
use fillrate_raw::client::Client;
use fillrate_raw::host::Host;
use fillrate_raw::opcode::Opcode;
use fillrate_raw::stage::composite::Target;
use fillrate_raw::{Config, Device, Errata, Level, TileSize, matrix, scenes};
use proptest::prelude::*;

/// Draws records on a device of this kind.
fn draw(client: &Client, config: Config) -> (Target, u64) {
    let mut host = Host::new(Device::new(config));
    for record in client.clone().take_records() {
        host.push(record).expect("a good stream");
    }
    let device = host.into_device();
    let fragments = device.fragments();
    (device.into_core().target, fragments)
}

/// The screen of these tests: several tiles, the last ones cut.
fn screen(errata: Errata) -> Config {
    Config { errata, ..Config::default().sized(150, 70) }
}

/// Any set of kept errors and options.
fn errata() -> impl Strategy<Value = Errata> {
    let mixed = (any::<u32>(), any::<bool>(), any::<bool>()).prop_map(|(kept, over, rule)| {
        let mut errata = Errata { decal_over_alpha: over, top_left_rule: rule, ..Errata::CORRECT };
        for (i, name) in Errata::NAMES.iter().enumerate() {
            errata.set(name, kept >> i & 1 == 1);
        }
        // A device that hangs draws nothing.
        Errata { zero_count_hangs: false, ..errata }
    });
    prop_oneof![Just(Errata::CORRECT), Just(Errata::FAITHFUL), mixed]
}

/// Threads, level and tile size of a fast device.
fn fast() -> impl Strategy<Value = (usize, Level, TileSize)> {
    let levels: Vec<Level> = Level::available().collect();
    let tiles = vec![TileSize::Small, TileSize::Medium, TileSize::Large];
    (1usize..4, prop::sample::select(levels), prop::sample::select(tiles))
}

fn cases() -> u32 {
    std::env::var("FILLRATE_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(400)
}

/// A triangle: corners, texture coordinates, colour.
type Triangle = [([f32; 3], [f32; 2], u32); 3];

fn triangle() -> impl Strategy<Value = Triangle> {
    let place = prop_oneof![4 => -1.2f32..1.2, 1 => -40.0f32..40.0, 1 => Just(0.5f32)];
    let corner =
        ([place.clone(), place.clone(), place], [-3.0f32..3.0, -3.0f32..3.0], any::<u32>());
    [corner.clone(), corner.clone(), corner]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(cases()))]

    #[test]
    fn any_scene_is_drawn_alike(
        modes in prop::collection::vec((8u32..22, 0u32..8), 0..24),
        more in prop::collection::vec((0u32..4, 0u32..8), 0..6),
        triangles in prop::collection::vec(triangle(), 1..12),
        errata in errata(),
        perspective in any::<bool>(),
        (threads, level, tile) in fast(),
        balance in -0.2f32..1.2,
        threshold in 0u32..300,
        pages in 0u32..4,
    ) {
        let mut client = Client::new(Errata::CORRECT);
        client.call(&Call::AllocateMipMapped { width: 16, height: 16 });
        client.call(&Call::UploadTexture { id: 0, texels: scenes::decal_texture() });
        client.call(&Call::MakeMipMaps { id: 0 });
        client.call(&Call::AllocateTexture { width: 5, height: 3 });
        client.call(&Call::UploadTexture { id: 1, texels: (1..16).map(|i: u32| i.wrapping_mul(0x1123_4721)).collect() });
        client.call(&Call::ColTexBalance { balance });
        client.call(&Call::AlphaThresh { threshold });
        scenes::test_lights(&mut client);
        client.call(&Call::Light { number: 1, rgbi: 0x40ff_8090, x: 0.3, y: -0.2, z: 0.9 });
        client.call(&Call::SetPage { pages });
        if perspective {
            client.set_projection(matrix::perspective_angles(0.8, 0.7, 0.2, 50.0));
            client.set_camera([0.1, 0.2, -1.5], [0.0; 3], [0.1, 10.0, -1.5]);
        }
        for (opcode, value) in modes {
            client.call(&Call::Set { opcode, value });
        }
        client.call(&Call::BeginScene {});
        for corners in triangles {
            for (which, value) in &more {
                client.call(&match which {
                    0 => Call::SetPrimitive { kind: *value },
                    1 => Call::SetClip { planes: *value },
                    2 => Call::SetMipMap { mode: *value },
                    _ => Call::Specular { rgbi: 0x80ff_ffff, exponent: *value },
                });
            }
            client.call(&Call::BeginPrim {});
            for (p, uv, rgba) in corners {
                client.call(&Call::Color { rgba });
                client.vertex(p, uv);
            }
            client.call(&Call::EndPrim {});
        }
        client.call(&Call::EndScene {});
        let reference = draw(&client, screen(errata));
        let config = Config { threads, level, tile, ..screen(errata) };
        prop_assert!(draw(&client, config) == reference);
    }
}

#[test]
fn a_scene_left_open_is_drawn_when_it_is_looked_at() {
    let mut client = Client::new(Errata::CORRECT);
    scenes::cube_view(&mut client);
    client.call(&Call::BeginScene {});
    client.set(Opcode::SetTexMode, 1);
    scenes::nine_cubes(&mut client);
    let (reference, fragments) = draw(&client, screen(Errata::CORRECT));
    let (fast, _) = draw(&client, Config { threads: 3, ..screen(Errata::CORRECT) });
    assert!(fragments > 1000 && fast == reference);
}
