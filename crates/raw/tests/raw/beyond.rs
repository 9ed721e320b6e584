//! What lies beyond the thesis: the grid draws what the single tile draws, and what is switched off
//! is not there.

use fillrate_raw::call::Call;
use fillrate_raw::client::Client;
use fillrate_raw::opcode::Opcode;
use fillrate_raw::protocol::Record;
use fillrate_raw::sim::cost::COSTS;
use fillrate_raw::sim::{self, Options, single};
use fillrate_raw::{Config, Device, Errata, StreamError, matrix, scenes};

use crate::common::{on_grid, on_single, scene};

/// A mipmapped texture, three lights, and a view from among the cubes, cut at all planes.
fn set_up(client: &mut Client) {
    client.call(&Call::AllocateMipMapped { width: 16, height: 16 });
    client.call(&Call::UploadTexture { id: 0, texels: scenes::decal_texture() });
    client.call(&Call::MakeMipMaps { id: 0 });
    scenes::test_lights(client);
    let eighth = std::f32::consts::FRAC_PI_4;
    client.set_projection(matrix::perspective_angles(eighth, eighth, 0.9, 100.0));
    client.set_camera([0.9, 0.3, -0.8], [0.0; 3], [0.9, 10.0, -0.8]);
    for (op, value) in [
        (Opcode::SetTexMode, 6),
        (Opcode::SetTexAlpha, 0),
        (Opcode::SetTexInterp, 1),
        (Opcode::SetLit, 1),
        (Opcode::SetUseAmb, 1),
        (Opcode::SetUseDir, 1),
        (Opcode::SetLitInterp, 1),
    ] {
        client.set(op, value);
    }
    client.call(&Call::SetClip { planes: 2 });
    client.call(&Call::SetMipMap { mode: 2 });
    client.call(&Call::Light { number: 3, rgbi: 0xff80_00c0, x: 1.0, y: -0.5, z: 0.0 });
    client.call(&Call::Specular { rgbi: 0xffff_ffff, exponent: 12 });
    client.call(&Call::Eye { x: 0.9, y: 0.3, z: -0.8 });
}

/// Cubes, then a strip of stored vertices, lines and points.
fn draw(client: &mut Client) {
    scenes::nine_cubes(client);
    for index in 0..40u32 {
        let (x, y) = (index as f32 / 10.0 - 2.0, (index % 2) as f32 - 1.6);
        client.color(index * 6, 255 - index * 6, 128, 0xff);
        client.call(&Call::StoreVertex { index, x, y, z: 0.4, u: x, v: y });
    }
    for (kind, steps) in [(2, 1), (5, 3), (6, 2), (4, 1), (3, 5), (1, 1)] {
        client.call(&Call::SetPrimitive { kind });
        client.call(&Call::SetPointSize { pixels: kind });
        client.call(&Call::BeginPrim {});
        for index in (0..40).step_by(steps) {
            client.call(&Call::Index { index });
        }
        client.call(&Call::EndPrim {});
    }
}

#[test]
fn everything_at_once_is_identical_on_the_grid() {
    let records = scene(set_up, draw);
    let single = on_single(&records);
    let frags = single.observer().counters().frags;
    assert!(frags > 10_000, "{frags}");
    for columns in [1, 3, 4] {
        let run = on_grid(columns, &records);
        assert!(run.core.target == single.core().target, "{columns} columns");
        assert_eq!(run.counters.frags, frags);
        assert_eq!(run.token, Some(1 + 108 + 6));
    }
}

#[test]
fn clipping_draws_more_than_dropping_and_the_same_where_nothing_is_cut() {
    let with_clip = |planes: u32, view: fn(&mut Client)| {
        let records = scene(
            |client| {
                view(client);
                client.call(&Call::SetClip { planes });
            },
            scenes::nine_cubes,
        );
        let device = on_single(&records);
        let frags = device.observer().counters().frags;
        (frags, device.into_core().target)
    };
    let inside = |client: &mut Client| {
        let eighth = std::f32::consts::FRAC_PI_4;
        client.set_projection(matrix::perspective_angles(eighth, eighth, 0.9, 100.0));
        client.set_camera([0.9, 0.3, -0.8], [0.0; 3], [0.9, 10.0, -0.8]);
    };
    let [drop, near, all] = [0, 1, 2].map(|planes| with_clip(planes, inside).0);
    assert!(drop < near, "{drop} {near}");
    // Cut at the sides, pixels stay the same but for rounding at the edges of the parts.
    assert!(near.abs_diff(all) < near / 50, "{near} {all}");
    let [drop, near, all] = [0, 1, 2].map(|planes| with_clip(planes, scenes::cube_view));
    assert!(drop == near && near == all);
}

#[test]
fn a_sphere_of_strips_counts_shared_vertices_once() {
    let records = scene(
        |_| {},
        |client| {
            client.call(&Call::SetPrimitive { kind: 2 });
            client.call(&Call::BeginPrim {});
            for i in 0..6u8 {
                client.vertex([f32::from(i) * 0.1, f32::from(i % 2) * -0.2, 0.0], [0.0; 2]);
            }
            client.call(&Call::EndPrim {});
        },
    );
    let lists = scene(
        |_| {},
        |client| {
            for i in 0..4u8 {
                let order = if i % 2 == 0 { [i, i + 1, i + 2] } else { [i + 1, i, i + 2] };
                client.call(&Call::BeginPrim {});
                for j in order {
                    client.vertex([f32::from(j) * 0.1, f32::from(j % 2) * -0.2, 0.0], [0.0; 2]);
                }
                client.call(&Call::EndPrim {});
            }
        },
    );
    let (strip, list) = (on_single(&records), on_single(&lists));
    assert!(strip.core().target == list.core().target);
    let cycles = |device: &Device<single::SingleTile>| device.observer().counters().render_cycles;
    assert!(cycles(&strip) < cycles(&list));
}

#[test]
fn asynchronous_reset_works_in_the_middle_of_anything() {
    for cut in [1, 7, 30, 200] {
        let mut records = scene(scenes::cube_view, scenes::nine_cubes);
        let data = |r: &&Record| matches!(r, Record::Data(_) | Record::Wait);
        let mut broken: Vec<Record> = records.iter().filter(data).copied().take(cut).collect();
        broken.push(Record::AsyncReset);
        broken.append(&mut records);
        let clean = on_single(&scene(scenes::cube_view, scenes::nine_cubes));
        let single = on_single(&broken);
        assert!(single.core().target == clean.core().target, "after {cut}");
        let run = on_grid(4, &broken);
        assert!(run.core.target.depth == clean.core().target.depth, "after {cut}");
        assert_eq!(run.token, Some(109));
    }
}

#[test]
fn a_device_of_the_thesis_knows_nothing_of_it() {
    let config = Config { beyond: false, errata: Errata::FAITHFUL, ..Config::default() };
    let records = [64, 2, 75].map(Record::Data);
    let (mut device, _) = single::play(config, COSTS, &records);
    let run = sim::play(config, COSTS, Options::default(), &records, |_| {}).expect("runs");
    let faults = device.take_faults();
    assert_eq!(faults, run.faults);
    assert!(matches!(faults[0], StreamError::Opcode { word: 64, offset: 0, .. }), "{faults:?}");
    assert_eq!(faults.len(), 3);
}
