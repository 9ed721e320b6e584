//! The fast path draws what the reference draws, bit for bit, whatever the modes.

use fillrate_raw::call::Call;
use fillrate_raw::client::Client;
use fillrate_raw::host::Host;
use fillrate_raw::opcode::Opcode;
use fillrate_raw::{Config, Device, Errata, matrix, scenes};
use proptest::prelude::*;

use fillrate_raw::stage::composite::Target;

/// Draws records on a device with so many threads.
fn draw(client: &Client, errata: Errata, threads: usize) -> (Target, u64) {
    let config = Config { errata, threads, ..Config::default().sized(72, 50) };
    let mut host = Host::new(Device::new(config));
    for record in client.clone().take_records() {
        host.push(record).expect("a good stream");
    }
    let device = host.into_device();
    let fragments = device.fragments();
    (device.into_core().target, fragments)
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
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn any_scene_is_drawn_alike(
        modes in prop::collection::vec((8u32..21, 0u32..8), 0..24),
        more in prop::collection::vec((0u32..4, 0u32..8), 0..6),
        triangles in prop::collection::vec(triangle(), 1..12),
        faithful in any::<bool>(),
        perspective in any::<bool>(),
        threads in 1usize..6,
        pages in 0u32..4,
    ) {
        let errata = if faithful { Errata::FAITHFUL } else { Errata::CORRECT };
        let mut client = Client::new(Errata::CORRECT);
        client.call(&Call::AllocateMipMapped { width: 16, height: 16 });
        client.call(&Call::UploadTexture { id: 0, texels: scenes::decal_texture() });
        client.call(&Call::MakeMipMaps { id: 0 });
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
        let reference = draw(&client, errata, 0);
        prop_assert!(draw(&client, errata, threads) == reference);
    }
}

#[test]
fn a_scene_left_open_is_drawn_when_it_is_looked_at() {
    let mut client = Client::new(Errata::CORRECT);
    scenes::cube_view(&mut client);
    client.call(&Call::BeginScene {});
    client.set(Opcode::SetTexMode, 1);
    scenes::nine_cubes(&mut client);
    let (reference, fragments) = draw(&client, Errata::CORRECT, 0);
    let (fast, _) = draw(&client, Errata::CORRECT, 3);
    assert!(fragments > 1000 && fast == reference);
}
