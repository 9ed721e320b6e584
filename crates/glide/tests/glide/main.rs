//! The front end by its calls alone: what programs can see of a board's state.

mod board;
mod locks;
mod textures;

use fillrate_engine::DeviceConfig;
use fillrate_glide::card::Card;
use fillrate_glide::{Call, Context, GlideConfig, GrVertex};

/// Columns and rows of the boards of these tests.
const SIZE: (u32, u32) = (320, 240);

/// A started library with a board of that name.
fn started(card: &str, check: bool) -> Context {
    let device = DeviceConfig { threads: 1, ..DeviceConfig::default() };
    let card = Card::by_name(card).expect("a built-in board");
    let config = GlideConfig { device, card, check, ..GlideConfig::default() };
    let mut glide = Context::new(config).expect("the board is valid");
    glide.execute(&Call::GrGlideInit {});
    glide
}

/// An open board, undithered and cleared to black.
fn opened(card: &str, color_format: i32) -> Context {
    let mut glide = started(card, false);
    let open = Call::GrSstWinOpen {
        window: 0,
        resolution: 1,
        refresh: 0,
        color_format,
        origin: 0,
        colors: 2,
        aux: 1,
    };
    assert_eq!(glide.execute(&open), 1);
    glide.execute(&Call::GrDitherMode { mode: 0 });
    glide.execute(&Call::GrBufferClear { color: 0, alpha: 0, depth: 0 });
    glide
}

/// A pixel of the back buffer (1) or the aux buffer (2).
fn pixel(glide: &mut Context, buffer: i32, x: u32, y: u32) -> u16 {
    glide.lfb_read_region(buffer, (x, y), (1, 1)).expect("a buffer")[0]
}

/// A vertex without colour and depth; s and t are those of the first unit.
fn vertex(x: f32, y: f32, s: f32, t: f32) -> GrVertex {
    let mut v = GrVertex { x, y, oow: 1.0, ..GrVertex::default() };
    (v.tmuvtx[0].sow, v.tmuvtx[0].tow) = (s, t);
    v
}

/// A triangle over the upper left half of the screen.
fn draw(glide: &mut Context, change: impl Fn(&mut GrVertex)) {
    let [mut a, mut b, mut c] =
        [(0.0, 0.0), (320.0, 0.0), (0.0, 240.0)].map(|(x, y)| vertex(x, y, 0.0, 0.0));
    [&mut a, &mut b, &mut c].into_iter().for_each(change);
    glide.execute(&Call::GrDrawTriangle { a, b, c });
}
