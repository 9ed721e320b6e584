//! Opening boards, clearing, and state that nobody draws with.

use fillrate_glide::{Call, ScanOut};

use super::{SIZE, draw, opened, pixel, started, vertex};

fn old_open(resolution: i32, smoothing: i32, buffers: i32) -> Call {
    Call::GrSstOpen { resolution, refresh: 0, color_format: 0, origin: 0, smoothing, buffers }
}

/// Two buffers have an auxiliary one where memory has room for it.
#[test]
fn the_old_open_takes_the_aux_buffer_that_fits() {
    let mut glide = started("voodoo-4mb", true);
    for (resolution, buffers, opens, aux) in
        [(7, 2, 1, true), (7, 3, 1, false), (8, 2, 1, false), (8, 3, 0, false), (7, 1, 0, false)]
    {
        assert_eq!(glide.execute(&old_open(resolution, 1, buffers)), opens, "{resolution}");
        let has_aux = opens == 1 && glide.lfb_read_region(2, (0, 0), (1, 1)).is_some();
        assert_eq!(has_aux, aux, "{resolution} with {buffers}");
        glide.execute(&Call::GrSstWinClose {});
    }
    let told: Vec<String> = glide.take_reports().iter().map(ToString::to_string).collect();
    let expected = [
        "grSstOpen: screen_resolution does not fit the frame buffer with so many buffers",
        "grSstOpen: num_buffers is neither 2 nor 3",
    ];
    assert_eq!(told, expected);
}

/// The old call's smoothing is the screen filter, which the new one leaves on.
#[test]
fn smoothing_switches_the_screen_filter() {
    let mut glide = started("voodoo-4mb", false);
    let mut is_filtered = |open: &Call| {
        assert_eq!(glide.execute(open), 1);
        // Neighbours of one step, which the filter mixes.
        let stripes: Vec<u8> = [0x20, 0, 0x40, 0].repeat(160);
        let data = stripes.into();
        let (width, height, stride) = (SIZE.0, 1, 640);
        glide.execute(&Call::GrDitherMode { mode: 0 });
        let write = Call::GrLfbWriteRegion {
            buffer: 1,
            x: 0,
            y: 0,
            format: 0,
            width,
            height,
            stride,
            data,
        };
        assert_eq!(glide.execute(&write), 1);
        glide.execute(&Call::GrBufferSwap { interval: 0 });
        let shown = glide.shown().expect("a frame");
        glide.execute(&Call::GrSstWinClose {});
        let filter = ScanOut { gamma: false, filter: true };
        shown.on_monitor(filter) != shown.on_monitor(ScanOut::default())
    };
    assert!(!is_filtered(&old_open(1, 0, 2)));
    assert!(is_filtered(&old_open(1, 1, 2)));
    assert!(!is_filtered(&old_open(1, 0, 2)));
    let (window, resolution, refresh, color_format, origin) = (0, 1, 0, 0, 0);
    let new =
        Call::GrSstWinOpen { window, resolution, refresh, color_format, origin, colors: 2, aux: 1 };
    assert!(is_filtered(&new));
}

/// A fill looks at the aux buffer's mask alone; what it writes there is depth
/// while depth is buffered, else what zaColor holds.
#[test]
fn clears_write_the_aux_buffer_by_its_mask() {
    let mut glide = opened("voodoo-4mb", 0);
    let mut cleared = |calls: &[Call]| {
        for call in calls {
            glide.execute(call);
        }
        glide.execute(&Call::GrBufferClear { color: 0, alpha: 0x55, depth: 0x1234 });
        pixel(&mut glide, 2, 7, 7)
    };
    assert_eq!(cleared(&[Call::GrDepthMask { mask: 0 }]), 0);
    let bias = Call::GrDepthBiasLevel { level: 77 };
    assert_eq!(cleared(&[Call::GrDepthMask { mask: 1 }, bias]), 77);
    assert_eq!(cleared(&[Call::GrDepthBufferMode { mode: 1 }]), 0x1234);
    let planes = [Call::GrDepthBufferMode { mode: 0 }, Call::GrColorMask { rgb: 1, alpha: 1 }];
    assert_eq!(cleared(&planes), 0x55);
    // Both at once is the program's mistake: the board keeps the alpha planes.
    assert_eq!(cleared(&[Call::GrDepthBufferMode { mode: 2 }]), 0x55);
}

/// Only calls that name the texture turn texturing on: the local colour is
/// chosen by the alpha of no texture then, which is 0.
#[test]
fn lighting_by_alpha_does_not_turn_texturing_on() {
    let mut glide = opened("voodoo-4mb", 0);
    let (function, factor, local, other, invert) = (1, 0, 0, 2, 0);
    glide.execute(&Call::GrColorCombine { function, factor, local, other, invert });
    glide.execute(&Call::GrConstantColorValue { value: 0x0000_ff00 });
    glide.execute(&Call::GrAlphaControlsItrgbLighting { enable: 1 });
    // All ones, were it asked.
    glide.execute(&Call::GrTexCombineFunction { tmu: 0, function: 0xa });
    draw(&mut glide, |v| v.r = 255.0);
    assert_eq!(pixel(&mut glide, 1, 20, 20), 0xf800);
    glide.execute(&Call::GrAlphaCombine { function: 3, factor: 8, local: 1, other: 1, invert: 0 });
    draw(&mut glide, |v| v.r = 255.0);
    assert_eq!(pixel(&mut glide, 1, 20, 20), 0x07e0);
}

#[test]
fn bytes_that_are_no_state_are_told_of() {
    let mut glide = started("voodoo-4mb", true);
    glide.execute(&old_open(1, 0, 2));
    glide.execute(&Call::GrGlideSetState { state: vec![7; 312].into() });
    let told = glide.take_reports();
    assert_eq!(told[0].to_string(), "grGlideSetState: these bytes are no saved state");
    let state = glide.state().expect("the board is open").to_vec();
    glide.execute(&Call::GrGlideSetState { state: state.into() });
    assert!(!glide.has_reports());
}

/// Only triangles count as triangles; culled and empty ones count as given.
#[test]
fn points_lines_and_smooth_edges_are_no_triangles() {
    let mut glide = opened("voodoo-4mb", 0);
    let [a, b, c] = [(10.0, 10.0), (90.0, 20.0), (30.0, 80.0)].map(|(x, y)| vertex(x, y, 0.0, 0.0));
    let mut counted = |calls: &[Call]| {
        glide.execute(&Call::GrResetTriStats {});
        for call in calls {
            glide.execute(call);
        }
        let counters = glide.counters();
        (counters.triangles_in, counters.triangles_drawn)
    };
    let smooth = [Call::GrAaDrawPoint { point: a }, Call::GrAaDrawLine { a, b }];
    assert_eq!(counted(&smooth), (0, 0));
    assert_eq!(counted(&[Call::GrDrawPoint { point: a }, Call::GrDrawLine { a, b }]), (0, 0));
    let edges = Call::GrAaDrawTriangle { a, b, c, ab: 1, bc: 1, ca: 1 };
    assert_eq!(counted(&[edges.clone(), Call::GrDrawTriangle { a, b, c }]), (2, 2));
    let planar = Call::GrDrawPlanarPolygon { vertices: vec![a, a, b, c] };
    assert_eq!(counted(core::slice::from_ref(&planar)), (2, 1));
    let empty = Call::GrAaDrawTriangle { a, b: a, c, ab: 1, bc: 1, ca: 1 };
    assert_eq!(counted(&[empty]), (1, 0));
    let cull = Call::GrCullMode { mode: 2 };
    assert_eq!(counted(&[cull, planar, edges]), (3, 0));
}
