//! Memory that drawing takes, seen by an allocator that counts: a steady frame
//! takes none, a full board little, a frame of a million triangles a bounded
//! amount.
//!
//! The test lies here because an allocator is `unsafe` code.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use fillrate_engine::DeviceConfig;
use fillrate_glide::{Call, Context, GlideConfig, GrTmuVertex, GrVertex};

/// The system's allocator, counted.
struct Counting;

/// Allocations and reallocations so far.
static ALLOCATIONS: AtomicUsize = AtomicUsize::new(0);
/// Bytes held now.
static HELD: AtomicUsize = AtomicUsize::new(0);
/// The most bytes ever held since the last reset.
static PEAK: AtomicUsize = AtomicUsize::new(0);

fn taken(bytes: usize) {
    ALLOCATIONS.fetch_add(1, Relaxed);
    let held = HELD.fetch_add(bytes, Relaxed) + bytes;
    PEAK.fetch_max(held, Relaxed);
}

// SAFETY: everything is passed on to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        taken(layout.size());
        // SAFETY: the caller's promise.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        HELD.fetch_sub(layout.size(), Relaxed);
        // SAFETY: the caller's promise.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

const MB: usize = 1 << 20;

/// What `body` returns, and the most bytes it held above what was held before.
fn peak<T>(body: impl FnOnce() -> T) -> (T, usize) {
    let before = HELD.load(Relaxed);
    PEAK.store(before, Relaxed);
    let result = body();
    (result, PEAK.load(Relaxed) - before)
}

/// A board of 640x480 with two units of 2 MB, gouraud, depth less or equal.
fn board(threads: usize) -> Context {
    let device = DeviceConfig { threads, ..DeviceConfig::default() };
    let config = GlideConfig { device, ..GlideConfig::default() };
    let mut context = Context::new(config).expect("the board exists");
    let open = Call::GrSstWinOpen {
        window: 0,
        resolution: 7,
        refresh: 0,
        color_format: 0,
        origin: 0,
        colors: 2,
        aux: 1,
    };
    for call in [
        Call::GrGlideInit {},
        open,
        Call::GrDitherMode { mode: 2 },
        Call::GrDepthBufferMode { mode: 1 },
        Call::GrDepthBufferFunction { function: 3 },
        Call::GrDepthMask { mask: 1 },
        Call::GuColorCombineFunction { function: 6 },
        Call::GrTexCombineFunction { tmu: 1, function: 1 },
        Call::GrTexCombineFunction { tmu: 0, function: 1 },
    ] {
        context.execute(&call);
    }
    context
}

/// Bytes of a chain of 8-bit levels from 256x256 down.
const CHAIN: u32 = 87_384;

/// Points a unit at an 8-bit texture.
fn source(tmu: i32, start: u32) -> Call {
    let (even_odd, small_lod, large_lod, aspect, format) = (3, 8, 0, 3, 3);
    Call::GrTexSource { tmu, start, even_odd, small_lod, large_lod, aspect, format }
}

fn download(context: &mut Context, tmu: i32, start: u32) {
    let (even_odd, small_lod, large_lod, aspect, format) = (3, 8, 0, 3, 3);
    let data: Vec<u8> = (0..87_381u32).map(|i| (i * 7 + start) as u8).collect();
    context.execute(&Call::GrTexDownloadMipMap {
        tmu,
        start,
        even_odd,
        small_lod,
        large_lod,
        aspect,
        format,
        data: data.into(),
    });
}

/// Triangle `i` of a fixed scene: of 1 to 600 pixels, all over the screen.
fn triangle(i: u32) -> [GrVertex; 3] {
    let random = |n: u32| (i * 3 + n).wrapping_mul(2_654_435_761) >> 8;
    let at = ((random(0) % 600) as f32, (random(1) % 440) as f32);
    let side = 2.0 + (random(2) % 34) as f32;
    [(0.0, 0.0), (side, 0.0), (0.0, side)].map(|(dx, dy)| {
        let (x, y) = (at.0 + dx, at.1 + dy);
        let color = random(5);
        GrVertex {
            x,
            y,
            z: 0.0,
            r: (color & 0xff) as f32,
            g: (color >> 8 & 0xff) as f32,
            b: dx * 6.0,
            ooz: (random(3) & 0xffff) as f32,
            a: 255.0,
            oow: 1.0,
            tmuvtx: [GrTmuVertex { sow: x, tow: y, oow: 1.0 }; 2],
        }
    })
}

/// Draws triangles, with a flush after every `piece`.
fn frame(context: &mut Context, triangles: u32, piece: u32) {
    context.execute(&Call::GrBufferClear { color: 0, alpha: 0, depth: 0xffff });
    for i in 0..triangles {
        let [a, b, c] = triangle(i);
        context.draw_triangle(&a, &b, &c);
        if i % piece == piece - 1 {
            context.counters();
        }
    }
    context.execute(&Call::GrBufferSwap { interval: 0 });
}

fn a_steady_frame_takes_no_memory(threads: usize) {
    let mut context = board(threads);
    download(&mut context, 0, 0);
    context.execute(&source(0, 0));
    let mut draw = |frames: u32| {
        for _ in 0..frames {
            frame(&mut context, 5000, u32::MAX);
        }
    };
    draw(20);
    let before = ALLOCATIONS.load(Relaxed);
    draw(50);
    let taken = ALLOCATIONS.load(Relaxed) - before;
    assert_eq!(taken, 0, "allocations of 50 frames on {threads} threads");
}

/// Every texture that 4 MB can hold, decoded, and both kinds of locks.
fn a_full_board_is_small() {
    let (_, bytes) = peak(|| {
        let mut context = board(2);
        context.execute(&Call::GrTexCombineFunction { tmu: 0, function: 4 });
        let starts: Vec<u32> = (0..2 * MB as u32 / CHAIN).map(|i| i * CHAIN).collect();
        for &start in &starts {
            for tmu in [0, 1] {
                download(&mut context, tmu, start);
                context.execute(&source(tmu, start));
            }
            let [a, b, c] = triangle(start);
            context.draw_triangle(&a, &b, &c);
        }
        frame(&mut context, 20_000, u32::MAX);
        for kind in [0, 1] {
            assert!(context.lfb_lock(kind, 1, 0, 0, false).is_some());
        }
        assert_eq!(starts.len(), 23);
    });
    println!("a full board: {:.1} MB", bytes as f64 / MB as f64);
    assert!(bytes < 64 * MB, "{bytes} bytes");
}

fn a_million_triangles_are_drawn_in_bounded_memory() {
    const COUNT: u32 = 1_000_000;
    let draw = |piece: u32| {
        peak(|| {
            let mut context = board(2);
            download(&mut context, 0, 0);
            context.execute(&source(0, 0));
            frame(&mut context, COUNT, piece);
            assert_eq!(context.total_counters().triangles_in, u64::from(COUNT));
            context.shown().expect("something is shown").pixels
        })
    };
    let (whole, bytes) = draw(u32::MAX);
    let (pieces, _) = draw(977);
    println!("a million triangles: {:.1} MB", bytes as f64 / MB as f64);
    assert!(bytes < 512 * MB, "{bytes} bytes");
    assert!(whole == pieces, "a frame is the same drawn in pieces");
}

/// One test, because allocations of another one would count.
#[test]
fn memory() {
    a_full_board_is_small();
    a_million_triangles_are_drawn_in_bounded_memory();
    a_steady_frame_takes_no_memory(1);
    a_steady_frame_takes_no_memory(2);
}
