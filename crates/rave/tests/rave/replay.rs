//! Calls that were written down draw the same again, on any machine.

use std::io::Cursor;

use fillrate_call::{BlobSource, Decoder, Encoder, Value, from_bytes, to_bytes};
use fillrate_engine::DeviceConfig;
use fillrate_engine::target::TileSize;
use fillrate_player::{Frame, Limits, Pixels, Player, Target, TargetError, Verdict, play};
use fillrate_rave::constants::context::DOUBLE_BUFFER;
use fillrate_rave::constants::{blend, texture_op, vertex_mode};
use fillrate_rave::tags::int;
use fillrate_rave::{Call, Context, PixelType, RaveConfig, VGouraud, VTexture};
use fillrate_simd::Level;
use fillrate_trace::{FrameInfo, Meta, TraceReader, TraceWriter};

use crate::pixels::Dice;
use crate::scene::{Scene, config, textured};

/// Frames of everything that can be drawn, with random places and states.
fn story(pixel_type: PixelType, seed: u64) -> Scene {
    let mut scene = Scene::with(config(), 97, 75, pixel_type, DOUBLE_BUFFER);
    let mut dice = Dice(seed);
    let argb: Vec<u32> = (0..64).map(|_| dice.below(u32::MAX)).collect();
    let texture = scene.texture_new(8, &argb);
    for _ in 0..2 {
        scene.start();
        for _ in 0..60 {
            let mut place =
                || (dice.below(140) as f32 * 0.93 - 20.0, dice.below(110) as f32 * 0.91 - 15.0);
            let corners = [place(), place(), place()];
            let mut unit = || dice.below(300) as f32 / 256.0;
            let v = VGouraud {
                z: unit(),
                inv_w: unit(),
                r: unit(),
                g: unit(),
                b: unit(),
                a: unit(),
                ..VGouraud::default()
            };
            let at = corners.map(|(x, y)| VGouraud { x, y, ..v });
            match dice.below(5) {
                0 => scene.tri(at),
                1 => {
                    let context = scene.context;
                    let (mode, vertices) = (vertex_mode::POLYLINE, at.to_vec());
                    scene.call(Call::DrawVGouraud { context, mode, vertices, flags: None });
                }
                _ => {
                    let ops =
                        [0, texture_op::MODULATE, texture_op::DECAL, texture_op::HIGHLIGHT, 3];
                    scene.int(int::TEXTURE_OP, ops[dice.below(5) as usize]);
                    scene.int(int::BLEND, dice.below(2) * blend::INTERPOLATE);
                    scene.int(int::TEXTURE_FILTER, dice.below(3));
                    scene.texture(texture);
                    scene.tri_texture(at.map(|p| VTexture {
                        x: p.x,
                        y: p.y,
                        inv_w: 0.5 + p.x.abs() / 200.0,
                        u_over_w: p.y / 50.0,
                        v_over_w: p.x / 60.0,
                        kd_r: p.r,
                        ks_g: p.g,
                        a: p.a,
                        ..textured(p.z)
                    }));
                }
            }
        }
        assert_eq!(scene.end(), Ok(()));
    }
    scene
}

#[test]
fn calls_draw_the_same_everywhere() {
    for (seed, pixel_type) in
        [(1, PixelType::Rgb16_565), (2, PixelType::Argb32), (3, PixelType::Rgb16)]
    {
        let mut scene = story(pixel_type, seed);
        let expected = scene.library.shown().unwrap();
        let bytes: Vec<Vec<u8>> = scene.calls.iter().map(to_bytes).collect();
        for level in Level::available() {
            for (threads, asynchronous) in [(1, true), (2, false), (7, true)] {
                let device = DeviceConfig { threads, level, tile: TileSize::Small };
                let config = RaveConfig { device, asynchronous, ..RaveConfig::default() };
                let mut library = Context::new(config);
                for call in &bytes {
                    library.execute(&from_bytes(call).unwrap());
                }
                let shown = library.shown().unwrap();
                assert!(shown == expected, "{pixel_type:?} {level:?} {threads} {asynchronous}");
            }
        }
    }
}

/// A library as the player sees it.
struct Replay(Context);

impl Target for Replay {
    fn start(&mut self, _: &Meta) -> Result<(), TargetError> {
        Ok(())
    }

    fn execute(&mut self, call: &[u8], blobs: &dyn BlobSource) -> Result<(), TargetError> {
        let mut decoder = Decoder::with_blobs(call, blobs);
        let call: Call = decoder.value()?;
        decoder.finish()?;
        self.0.execute(&call);
        Ok(())
    }

    fn frame(&mut self) -> Option<Frame> {
        frame_of(&mut self.0)
    }
}

fn frame_of(library: &mut Context) -> Option<Frame> {
    let shown = library.shown()?;
    Frame::new(shown.width, shown.height, Pixels::Rgba8(shown.rgba8888())).ok()
}

/// A trace in a file has the same hashes, frame by frame.
#[test]
fn a_trace_replays_to_its_hashes() {
    let scene = story(PixelType::Rgb16, 9);
    let mut library = Context::new(config());
    let mut writer = TraceWriter::new(Vec::new(), &Meta::new().with("api", "rave")).unwrap();
    let mut encoder = Encoder::with_blobs();
    for call in &scene.calls {
        encoder.clear();
        call.encode(&mut encoder);
        writer.record_encoded(&mut encoder).unwrap();
        library.execute(call);
        if matches!(call, Call::RenderEnd { .. }) {
            let frame = frame_of(&mut library).unwrap();
            let (width, height, hash) = (frame.width(), frame.height(), Some(frame.hash()));
            writer.end_frame(FrameInfo { width, height, hash }).unwrap();
        }
    }
    let file = writer.finish().unwrap();
    let events = TraceReader::new(Cursor::new(file)).unwrap();
    let replay = Replay(Context::new(RaveConfig { asynchronous: true, ..config() }));
    let report = play(&mut Player::new(events, replay, Limits::default()), |_, _| {});
    assert_eq!((report.frames.len(), report.count(Verdict::Same)), (2, 2), "{:?}", report.stop);
}
