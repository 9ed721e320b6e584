//! Frames, buffers, notices and caches.

use fillrate_rave::constants::context::{CACHE, DOUBLE_BUFFER, NO_Z_BUFFER, SCALE};
use fillrate_rave::constants::{compare, device, notice};
use fillrate_rave::gestalt::Answer;
use fillrate_rave::notice::{Host, deliver, render_end, render_start};
use fillrate_rave::tags::{float, int};
use fillrate_rave::{
    Call, Context, DeviceValue, DrawContextId, EngineId, PixelType, RaveConfig, RaveError,
    RaveRect, Reply, Shown, VGouraud,
};

use crate::scene::{Scene, area, colored, config, context_new, memory};

const RED: u32 = 0xffff_0000;
const BLUE: u32 = 0xff00_00ff;

fn scene() -> Scene {
    let mut scene = Scene::new(16, 16, PixelType::Rgb32);
    scene.color(float::COLOR_BG_A, [1.0, 0.0, 0.0, 1.0]);
    scene
}

fn red(scene: &mut Scene, z: f32) {
    scene.rect([0.0, 0.0, 16.0, 16.0], colored([1.0, 0.0, 0.0], z));
}

fn frame(scene: &mut Scene, draw: impl FnOnce(&mut Scene)) {
    scene.start();
    draw(scene);
    assert_eq!(scene.end(), Ok(()));
}

#[test]
fn nothing_is_seen_before_the_end() {
    let mut scene = scene();
    scene.start();
    red(&mut scene, 0.5);
    scene.call(Call::Sync { context: scene.context });
    assert_eq!(scene.pixel(3, 3), 0xff00_0000);
    scene.end().unwrap();
    assert_eq!(scene.pixel(3, 3), RED);
}

#[test]
fn without_a_back_buffer_a_flush_shows() {
    let mut scene = Scene::with(config(), 16, 16, PixelType::Rgb32, 0);
    scene.start();
    red(&mut scene, 0.5);
    scene.call(Call::Flush { context: scene.context });
    assert_eq!(scene.pixel(3, 3), RED);
}

#[test]
fn a_swap_may_wait() {
    let mut scene = scene();
    scene.int(int::DONT_SWAP, 1);
    frame(&mut scene, |scene| red(scene, 0.5));
    assert_eq!(scene.pixel(3, 3), 0xff00_0000);
    let half = RaveRect::new(0, 0, 8, 16);
    scene.call(Call::SwapBuffers { context: scene.context, dirty: Some(half) });
    assert_eq!([scene.pixel(3, 3), scene.pixel(12, 3)], [RED, 0xff00_0000]);
}

#[test]
fn without_a_back_buffer_there_is_no_swap_to_wait_for() {
    let mut scene = Scene::with(config(), 16, 16, PixelType::Rgb32, 0);
    scene.int(int::DONT_SWAP, 1);
    frame(&mut scene, |scene| red(scene, 0.5));
    assert_eq!(scene.pixel(3, 3), RED);
}

/// A device that is no memory of the program, in every pixel type that a context
/// can have: the picture is that of a memory device.
#[test]
fn devices_without_memory_draw_the_same() {
    let mask = Context::default().gestalt(EngineId::BUILT_IN, 9).expect("a known selector");
    let Answer::Number(allowed) = mask else { panic!("{mask:?}") };
    assert_eq!(allowed, 0x179e);
    for pixel_type in PixelType::ALL {
        let mut pictures = Vec::new();
        for device_type in [device::MEMORY, device::OFFSCREEN] {
            let mut scene = Scene::new(16, 16, PixelType::Rgb32);
            let (rect, flags) = (area(16, 16), DOUBLE_BUFFER);
            let device = DeviceValue { device_type, ..memory(16, 16, pixel_type) };
            let call =
                Call::DrawContextNew { engine: 1, device, rect, scaled: None, clip: None, flags };
            let reply = scene.call(call);
            if allowed & pixel_type.bit() == 0 {
                assert_eq!(reply, Reply::Created(Err(RaveError::NotSupported)), "{pixel_type:?}");
                continue;
            }
            scene.context = reply.created();
            frame(&mut scene, |scene| {
                scene.rect([2.0, 2.0, 14.0, 9.0], colored([0.9, 0.4, 0.2], 0.5))
            });
            pictures.push(scene.library.shown().expect("a frame"));
        }
        assert!(pictures.iter().all(|picture| *picture == pictures[0]), "{pixel_type:?}");
    }
}

#[test]
fn an_abort_shows_nothing() {
    let mut scene = scene();
    frame(&mut scene, |_| {});
    scene.start();
    red(&mut scene, 0.5);
    let reply = scene.call(Call::RenderAbort { context: scene.context });
    assert_eq!(reply, Reply::Status(Ok(())));
    assert_eq!(scene.pixel(3, 3), BLUE);
    assert_eq!(scene.end(), Err(RaveError::Failure));
}

#[test]
fn only_dirty_parts_are_cleared_and_shown() {
    let mut scene = scene();
    frame(&mut scene, |scene| red(scene, 0.5));
    let dirty = Some(RaveRect::new(4, 4, 8, 8));
    scene.call(Call::RenderStart { context: scene.context, dirty, initial: 0 });
    scene.call(Call::RenderEnd { context: scene.context, modified: None });
    assert_eq!([scene.pixel(4, 4), scene.pixel(7, 7)], [BLUE; 2]);
    assert_eq!([scene.pixel(3, 4), scene.pixel(8, 8)], [RED; 2]);
}

#[test]
fn z_functions_do_what_their_names_say() {
    let mut scene = scene();
    frame(&mut scene, |scene| {
        red(scene, 1.0);
    });
    assert_eq!(scene.pixel(3, 3), BLUE, "z of 1 is not less than 1");
    frame(&mut scene, |scene| {
        let (offset, factor) = (
            scene.library.get_float(scene.id(), float::Z_MIN_OFFSET),
            scene.library.get_float(scene.id(), float::Z_MIN_SCALE),
        );
        red(scene, 1.0 * factor + offset);
    });
    assert_eq!(scene.pixel(3, 3), RED, "the smallest offset is seen");
    frame(&mut scene, |scene| {
        scene.int(int::Z_FUNCTION, compare::TRUE);
        red(scene, 1.0);
        scene.rect([0.0, 0.0, 16.0, 16.0], colored([0.0, 1.0, 0.0], 0.9));
        scene.int(int::Z_FUNCTION, compare::NONE);
        scene.rect([0.0, 0.0, 8.0, 16.0], colored([1.0, 1.0, 0.0], 0.1));
        scene.int(int::Z_FUNCTION, compare::LT);
        red(scene, 0.8);
    });
    assert_eq!(scene.pixel(3, 3), RED, "None left the 0.9 that True wrote");
    frame(&mut scene, |scene| {
        scene.int(int::Z_BUFFER_MASK, 0);
        scene.rect([0.0, 0.0, 16.0, 16.0], colored([0.0, 1.0, 0.0], 0.1));
        scene.int(int::Z_BUFFER_MASK, 1);
        red(scene, 0.8);
    });
    assert_eq!(scene.pixel(3, 3), RED, "the mask kept 1.0");
}

/// Larger 1/w is nearer, whatever z says.
#[test]
fn perspective_z_compares_the_other_way_round() {
    let mut scene = scene();
    scene.int(int::PERSPECTIVE_Z, 1);
    frame(&mut scene, |scene| {
        let near = VGouraud { inv_w: 0.9, z: 0.9, ..colored([1.0, 0.0, 0.0], 0.0) };
        let far = VGouraud { inv_w: 0.0001, z: 0.1, ..colored([0.0, 1.0, 0.0], 0.0) };
        scene.rect([0.0, 0.0, 16.0, 16.0], far);
        scene.rect([0.0, 0.0, 16.0, 16.0], near);
        scene.rect([0.0, 0.0, 16.0, 16.0], VGouraud { inv_w: 0.8999, ..far });
    });
    assert_eq!(scene.pixel(3, 3), RED);
    let plane = scene.library.z_buffer(scene.id()).unwrap();
    assert_eq!(plane.depth, 32);
}

#[test]
fn deep_z_tells_24_bits_apart() {
    let mut scene = Scene::with(config(), 16, 16, PixelType::Rgb32, DOUBLE_BUFFER | 2);
    let step = 2.0 / 16_777_216.0;
    frame(&mut scene, |scene| {
        scene.rect([0.0, 0.0, 16.0, 16.0], colored([0.0, 1.0, 0.0], 0.5));
        red(scene, 0.5 - step);
        scene.rect([0.0, 0.0, 8.0, 16.0], colored([0.0, 1.0, 0.0], 0.5));
    });
    assert_eq!([scene.pixel(3, 3), scene.pixel(12, 3)], [RED; 2]);
    let z = scene.library.z_buffer(scene.id()).unwrap();
    assert_eq!((z.depth, z.elements.len()), (32, 16 * 16 * 4));
}

#[test]
fn without_z_the_last_is_seen() {
    let mut scene = Scene::with(config(), 16, 16, PixelType::Rgb32, NO_Z_BUFFER);
    scene.int(int::Z_FUNCTION, compare::LT);
    frame(&mut scene, |scene| {
        scene.rect([0.0, 0.0, 16.0, 16.0], colored([0.0, 1.0, 0.0], 0.1));
        red(scene, 1.0);
    });
    assert_eq!(scene.pixel(3, 3), RED);
    assert!(scene.library.z_buffer(scene.id()).is_none());
}

#[test]
fn a_cache_holds_color_and_depth() {
    let mut scene = scene();
    let screen = scene.context;
    let cache = scene.call(context_new(16, 16, PixelType::Rgb32, DOUBLE_BUFFER | CACHE)).created();
    scene.context = cache;
    frame(&mut scene, |scene| {
        scene.rect([0.0, 0.0, 8.0, 16.0], colored([0.0, 1.0, 0.0], 0.2));
    });
    scene.context = screen;
    scene.call(Call::RenderStart { context: screen, dirty: None, initial: cache });
    red(&mut scene, 0.5);
    assert_eq!(scene.end(), Ok(()));
    assert_eq!([scene.pixel(3, 3), scene.pixel(12, 3)], [0xff00_ff00, RED]);
    // One of another size is an error, and a clear.
    let small = scene.call(context_new(8, 8, PixelType::Rgb32, DOUBLE_BUFFER | CACHE)).created();
    scene.call(Call::RenderStart { context: screen, dirty: None, initial: small });
    assert_eq!(scene.end(), Err(RaveError::Parameter));
    assert_eq!(scene.pixel(3, 3), BLUE);
}

#[test]
fn clears_fill_or_copy_in_mid_frame() {
    let mut scene = scene();
    scene.start();
    red(&mut scene, 0.2);
    let rect = Some(RaveRect::new(0, 0, 8, 8));
    let context = scene.context;
    scene.int(int::GL_SCISSOR_X_MAX, 4);
    scene.call(Call::ClearDrawBuffer { context, rect, initial: 0 });
    scene.int(int::GL_SCISSOR_X_MAX, 16);
    scene.call(Call::ClearZBuffer { context, rect: None, initial: 0 });
    scene.rect([8.0, 8.0, 16.0, 16.0], colored([0.0, 1.0, 0.0], 0.9));
    assert_eq!(scene.end(), Ok(()));
    let seen = [(3, 3), (5, 3), (12, 12), (3, 12)].map(|(x, y)| scene.pixel(x, y));
    assert_eq!(seen, [BLUE, RED, 0xff00_ff00, RED]);
}

#[test]
fn a_scaled_context_is_averaged() {
    let mut scene = Scene::new(4, 4, PixelType::Rgb32);
    let call = Call::DrawContextNew {
        engine: 1,
        device: memory(64, 64, PixelType::Rgb32),
        rect: area(16, 16),
        scaled: Some(area(8, 8)),
        clip: None,
        flags: DOUBLE_BUFFER | SCALE,
    };
    scene.context = scene.call(call).created();
    frame(&mut scene, |scene| {
        scene.rect([0.0, 0.0, 5.0, 16.0], colored([1.0, 1.0, 1.0], 0.5));
    });
    let shown = scene.library.shown().unwrap();
    assert_eq!((shown.width, shown.height), (8, 8));
    assert_eq!([1, 2, 3].map(|x| shown.argb(x, 4)), [0xffff_ffff, 0xff80_8080, 0xff00_0000]);
}

#[test]
fn edges_are_smooth_with_antialiasing() {
    let mut scene = scene();
    for (level, sides) in [(0, 1), (1, 1), (2, 2), (3, 4)] {
        scene.int(int::ANTIALIAS, level);
        frame(&mut scene, |scene| {
            scene.rect([0.0, 0.0, 8.5, 16.0], colored([1.0, 0.0, 0.0], 0.5));
        });
        assert_eq!([scene.pixel(7, 4), scene.pixel(9, 4)], [RED, BLUE]);
        let smooth = scene.pixel(8, 4);
        assert_eq!(sides > 1, smooth != RED && smooth != BLUE, "level {level}: {smooth:08x}");
    }
}

#[test]
fn composing_uses_alpha() {
    let mut scene = Scene::new(16, 16, PixelType::Argb32);
    scene.color(float::COLOR_BG_A, [1.0, 0.0, 0.0, 1.0]);
    frame(&mut scene, |_| {});
    scene.int(int::BUFFER_COMPOSITE, 2);
    scene.color(float::COLOR_BG_A, [0.0, 0.0, 0.0, 0.0]);
    frame(&mut scene, |scene| {
        scene.rect([0.0, 0.0, 8.0, 16.0], colored([1.0, 0.0, 0.0], 0.5));
    });
    assert_eq!([scene.pixel(3, 3), scene.pixel(12, 3)], [RED, BLUE]);
}

#[test]
fn misuse_is_reported_once_and_loses_nothing() {
    let mut scene = scene();
    let sync = |scene: &mut Scene| scene.call(Call::Sync { context: scene.context });
    red(&mut scene, 0.5);
    assert_eq!(sync(&mut scene), Reply::Status(Err(RaveError::Failure)), "outside a frame");
    assert_eq!(sync(&mut scene), Reply::Status(Ok(())));
    scene.start();
    scene.rect([0.0, 0.0, 16.0, 16.0], VGouraud { z: f32::NAN, ..colored([0.0; 3], 0.0) });
    scene.rect([0.0, 0.0, f32::INFINITY, 16.0], colored([0.0; 3], 0.0));
    red(&mut scene, 0.5);
    assert_eq!(sync(&mut scene), Reply::Status(Err(RaveError::Parameter)));
    assert_eq!(scene.end(), Err(RaveError::Parameter));
    assert_eq!(scene.pixel(3, 3), RED, "what was right is drawn");
    assert_eq!(scene.end(), Err(RaveError::Failure), "a second end");
}

/// A program with notices.
struct Program {
    scene: Scene,
    heard: Vec<u32>,
    paint: Option<[u8; 4]>,
}

impl Host for Program {
    fn library(&mut self) -> &mut Context {
        &mut self.scene.library
    }

    fn call(&mut self, call: &Call) -> Reply {
        self.scene.call(call.clone())
    }

    fn standard(&mut self, _: DrawContextId, selector: u32) {
        self.heard.push(selector);
    }

    fn buffer(&mut self, _: DrawContextId, selector: u32, buffer: &mut Shown, _: RaveRect) {
        self.heard.push(selector);
        if let Some(pixel) = self.paint {
            buffer.pixels.as_chunks_mut().0.fill(pixel);
        }
    }
}

#[test]
fn notices_come_in_order_and_replace_the_clear() {
    let mut program = Program { scene: scene(), heard: Vec::new(), paint: None };
    let id = program.scene.id();
    let all = [
        notice::RENDER_COMPLETION,
        notice::IMAGE_BUFFER_INITIALIZE,
        notice::IMAGE_BUFFER_2D_COMPOSITE,
    ];
    let install = |program: &mut Program, selector: u32, installed: bool| {
        program.scene.call(Call::SetNoticeMethod { context: id.0, selector, installed });
    };
    // A first frame leaves red behind.
    render_start(&mut program, id, None, 0);
    red(&mut program.scene, 0.5);
    render_end(&mut program, id, None);
    all.iter().for_each(|&selector| install(&mut program, selector, true));
    render_start(&mut program, id, None, 0);
    program.scene.rect([0.0, 0.0, 4.0, 16.0], colored([0.0, 1.0, 0.0], 0.9));
    assert_eq!(render_end(&mut program, id, None), Reply::Status(Ok(())));
    deliver(&mut program);
    assert_eq!(program.heard, [all[1], all[2], all[0]]);
    // Nothing was written: the old colours stay, z is cleared.
    assert_eq!([program.scene.pixel(3, 3), program.scene.pixel(12, 3)], [0xff00_ff00, RED]);
    program.paint = Some([9, 8, 7, 0]);
    install(&mut program, notice::IMAGE_BUFFER_2D_COMPOSITE, false);
    render_start(&mut program, id, None, 0);
    render_end(&mut program, id, None);
    assert_eq!(program.scene.pixel(12, 3), 0xff07_0809);
    // Without a method the clear is back.
    install(&mut program, notice::IMAGE_BUFFER_INITIALIZE, false);
    render_start(&mut program, id, None, 0);
    render_end(&mut program, id, None);
    assert_eq!(program.scene.pixel(12, 3), BLUE);
}

/// Frames drawn behind the program's back are the same, in order, and each is
/// told of once.
#[test]
fn frames_overlap_and_stay_the_same() {
    let draw = |asynchronous: bool| {
        let config = RaveConfig { asynchronous, ..config() };
        let mut scene = Scene::with(config, 64, 64, PixelType::Rgb16_565, DOUBLE_BUFFER);
        let mut completed = 0;
        for i in 0..40u32 {
            scene.start();
            for k in 0..200u32 {
                let at = ((i * 7 + k * 13) % 60) as f32;
                let color = [k as f32 / 200.0, 0.5, i as f32 / 40.0];
                let v = VGouraud { a: 0.5, ..colored(color, 0.9 - k as f32 / 400.0) };
                scene.rect([at, at / 2.0, at + 20.0, at + 9.5], v);
            }
            assert_eq!(scene.end(), Ok(()));
            completed += scene.library.take_completed().len();
        }
        let busy = scene.call(Call::Busy { context: scene.context });
        assert!(asynchronous || busy == Reply::Busy(false));
        scene.call(Call::Sync { context: scene.context });
        assert_eq!(scene.call(Call::Busy { context: scene.context }), Reply::Busy(false));
        completed += scene.library.take_completed().len();
        assert_eq!(completed, 40);
        (scene.library.shown().unwrap(), scene.library.counters().pixels_out)
    };
    assert_eq!(draw(false), draw(true));
}
