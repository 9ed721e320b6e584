//! The guide's example scenes htri1 to htri6: the sample points of its text.

use fillrate_redline::surface::{UCLAMP, VCLAMP};
use fillrate_redline::{Chip, PixFmt, VertexType, record};

use crate::board::{Board, config};

const GREEN: u16 = 0x07e0;
const BLUE: u16 = 0x001f;
const MAGENTA: u16 = 0xf81f;
const CYAN: u16 = 0x07ff;

const CHIPS: [Chip; 2] = [Chip::V1000, Chip::V2000];

/// 16.16.
fn fix(v: f64) -> u32 {
    (v * 65536.0) as i64 as u32
}

fn board(chip: Chip, depth: bool) -> Board {
    Board::new(config(chip), (640, 480), depth)
}

/// Squares of two colours; the first one is at the origin.
fn checker(width: u32, height: u32, (w, h): (u32, u32), colors: [u32; 2]) -> Vec<u32> {
    let square = |x: u32, y: u32| colors[((x / w + y / h) % 2) as usize];
    (0..width * height).map(|i| square(i % width, i / width)).collect()
}

/// The two textures: repeated 128x256 and clamped 200x100.
fn checkers(
    board: &mut Board,
    format: PixFmt,
    colors: [[u32; 2]; 2],
) -> [(fillrate_redline::Surface, u32); 2] {
    let one = checker(128, 256, (16, 32), colors[0]);
    let two = checker(200, 100, (10, 10), colors[1]);
    let first = board.texture(128, 256, format, &one);
    let mut second = board.texture(200, 100, format, &two);
    second.0.clamp = UCLAMP | VCLAMP;
    [first, second]
}

fn rgb565(colors: [[u16; 2]; 2]) -> [[u32; 2]; 2] {
    colors.map(|two| two.map(u32::from))
}

const BRIGHT: [[u16; 2]; 2] = [[GREEN, BLUE], [MAGENTA, CYAN]];

/// Corners of the two textured triangles: x, y, u, v.
const TRIANGLES: [[[f64; 4]; 3]; 2] = [
    [[100., 100., 0., 0.], [500., 100., 2., 0.], [100., 300., 0., 2.]],
    [[200., 150., 0., 0.], [600., 150., 2., 0.], [200., 350., 0., 2.]],
];

fn check(pixels: &[u16], samples: &[(u32, u32, u16)]) {
    for &(x, y, color) in samples {
        let found = pixels[(y * 640 + x) as usize];
        assert_eq!(found, color, "({x}, {y}): {found:#06x}, not {color:#06x}");
    }
}

#[test]
fn htri1_flat_triangle() {
    for chip in CHIPS {
        let mut board = board(chip, false);
        record::set_fg_color_argb(&mut board.commands, 0xffff_0000).unwrap();
        let [a, b, c] = [[100., 100.], [400., 100.], [250., 300.]].map(|p: [f64; 2]| p.map(fix));
        record::triangle(&mut board.commands, VertexType::XY.code(), &a, &b, &c).unwrap();
        board.issue();
        let pixels = board.pixels(1);
        check(&pixels, &[(250, 150, 0xf800), (120, 250, 0), (250, 298, 0xf800), (100, 99, 0)]);
        let red = pixels.iter().filter(|&&p| p == 0xf800).count();
        assert!((29_700..=30_300).contains(&red), "{red} pixels");
        assert!(pixels.iter().all(|&p| p == 0 || p == 0xf800));
    }
}

fn htri3(board: &mut Board, bilinear: bool) {
    let textures = checkers(board, PixFmt::Rgb565, rgb565(BRIGHT));
    record::set_src_func(&mut board.commands, 1).unwrap();
    filter(board, bilinear);
    for ((surface, group), triangle) in textures.iter().zip(TRIANGLES) {
        board.bind(surface, *group);
        let [a, b, c] = triangle.map(|p| p.map(fix));
        record::triangle(&mut board.commands, VertexType::XYUV.code(), &a, &b, &c).unwrap();
    }
    board.issue();
}

/// The filter with its offsets.
fn filter(board: &mut Board, bilinear: bool) {
    let offset = if bilinear { 0xffff_8000 } else { 0 };
    record::set_src_filter(&mut board.commands, u32::from(bilinear)).unwrap();
    record::set_s_offset(&mut board.commands, offset).unwrap();
    record::set_t_offset(&mut board.commands, offset).unwrap();
}

/// Samples at the centres of squares, which the filter does not change.
#[test]
fn htri3_textures() {
    for (chip, bilinear) in CHIPS.into_iter().flat_map(|chip| [(chip, false), (chip, true)]) {
        let mut board = board(chip, false);
        htri3(&mut board, bilinear);
        let pixels = board.pixels(1);
        check(
            &pixels,
            &[
                (110, 105, GREEN),
                (130, 105, BLUE),
                (110, 118, BLUE),
                (205, 155, MAGENTA),
                (215, 155, CYAN),
                (205, 165, CYAN),
                (450, 155, CYAN),
                (450, 165, MAGENTA),
                (500, 175, CYAN),
                (205, 300, CYAN),
                (215, 300, MAGENTA),
                (50, 50, 0),
            ],
        );
        let drawn = pixels.iter().filter(|&&p| p != 0).count();
        assert!((69_500..=70_500).contains(&drawn), "{drawn} pixels");
        let pure = pixels.iter().all(|p| [0, GREEN, BLUE, MAGENTA, CYAN].contains(p));
        assert_eq!(pure, !bilinear, "filtering mixes neighbours, and only filtering");
    }
}

/// z and 1/w of the corners of both triangles.
const DEPTHS: [[(f64, u32); 3]; 2] = [
    [(2., 0x7f_ffff), (4., 0x3f_ffff), (2., 0x7f_ffff)],
    [(6., 0x55_5555), (8., 0x33_3333), (6., 0x55_5555)],
];

fn htri4(board: &mut Board, bilinear: bool) {
    let textures = checkers(board, PixFmt::Rgb565, rgb565(BRIGHT));
    record::set_src_func(&mut board.commands, 1).unwrap();
    record::set_z_buf_mode(&mut board.commands, 1).unwrap();
    record::set_z_buf_wr_mode(&mut board.commands, 1).unwrap();
    filter(board, bilinear);
    for (((surface, group), triangle), depths) in textures.iter().zip(TRIANGLES).zip(DEPTHS) {
        board.bind(surface, *group);
        let mut corners = triangle
            .iter()
            .zip(depths)
            .map(|([x, y, u, v], (z, q))| [fix(*x), fix(*y), fix(z), fix(*u), fix(*v), q]);
        let [a, b, c] = std::array::from_fn(|_| corners.next().unwrap());
        record::triangle(&mut board.commands, VertexType::XYZUVQ.code(), &a, &b, &c).unwrap();
    }
    board.issue();
}

#[test]
fn htri4_depth_and_perspective() {
    for (chip, bilinear) in CHIPS.into_iter().flat_map(|chip| [(chip, false), (chip, true)]) {
        let mut board = board(chip, true);
        htri4(&mut board, bilinear);
        check(
            &board.pixels(1),
            &[(300, 150, GREEN), (250, 200, GREEN), (500, 160, MAGENTA), (300, 280, CYAN)],
        );
        // S is 150.47: between two squares where it is filtered.
        if !bilinear {
            check(&board.pixels(1), &[(400, 220, CYAN)]);
        }
        let depths = board.pixels(2);
        check(
            &depths,
            &[(110, 105, 2), (480, 102, 3), (210, 300, 6), (580, 152, 7), (10, 10, 0xffff)],
        );
        let other: Vec<_> = depths.iter().filter(|z| ![2, 3, 6, 7, 0xffff].contains(z)).collect();
        assert!(other.is_empty(), "{other:?}");
    }
}

#[test]
fn htri5_blending() {
    for chip in CHIPS {
        let mut board = board(chip, false);
        let colors = [[0xf0f0, 0xf00f], [0x7f00, 0x7fff]];
        let textures = checkers(&mut board, PixFmt::Argb4444, colors);
        record::set_src_func(&mut board.commands, 1).unwrap();
        record::set_blend_enable(&mut board.commands, 1).unwrap();
        record::set_blend_src_func(&mut board.commands, 2).unwrap();
        record::set_blend_dst_func(&mut board.commands, 3).unwrap();
        for ((surface, group), triangle) in textures.iter().zip(TRIANGLES) {
            let mut surface = *surface;
            surface.color_pad = 1;
            board.bind(&surface, *group);
            let [a, b, c] = triangle.map(|p| p.map(fix));
            record::triangle(&mut board.commands, VertexType::XYUV.code(), &a, &b, &c).unwrap();
        }
        board.issue();
        let pixels = board.pixels(1);
        let expected = [0x7000u16, 0x73ae, 0x7440, 0x7011, 0x77ee, 0x73bf, GREEN, BLUE, 0];
        let near = |p: u16, e: u16| {
            let channels = |c: u16| [c >> 11, c >> 5 & 63, c & 31].map(i32::from);
            channels(p).iter().zip(channels(e)).all(|(a, b)| (a - b).abs() <= 1)
        };
        let all = |p: &u16| expected.iter().any(|&e| near(*p, e));
        assert!(pixels.iter().all(all), "{:x?}", pixels.iter().find(|p| !all(p)));
        for e in expected {
            assert!(pixels.iter().any(|&p| near(p, e)), "{e:#06x} is nowhere");
        }
    }
}

/// Scale of the specular colour at each corner.
const HIGHLIGHTS: [u32; 3] = [255, 0, 200];

fn htri6(board: &mut Board, specular: bool) {
    let textures = checkers(board, PixFmt::Rgb565, rgb565(BRIGHT));
    let commands = &mut board.commands;
    record::set_z_buf_mode(commands, 1).unwrap();
    record::set_z_buf_wr_mode(commands, 1).unwrap();
    if specular {
        record::set_src_func(commands, 1).unwrap();
        record::set_specular_enable(commands, 1).unwrap();
    } else {
        record::set_src_func(commands, 3).unwrap();
        record::set_blend_enable(commands, 1).unwrap();
        record::set_blend_src_func(commands, 7).unwrap();
        record::set_blend_dst_func(commands, 2).unwrap();
        record::set_dst_rd_disable(commands, 1).unwrap();
    }
    for (i, ((surface, group), triangle)) in textures.iter().zip(TRIANGLES).enumerate() {
        let mut surface = *surface;
        surface.color_pad = 1;
        board.bind(&surface, *group);
        let shift = [16, 0][i];
        let color = 0xff00_0000 | 0xff << shift;
        record::set_dst_color_argb(&mut board.commands, color).unwrap();
        let mut corners = triangle.iter().zip(DEPTHS[i]).zip(HIGHLIGHTS).map(
            |(([x, y, u, v], (z, q)), highlight)| {
                let second = if specular { highlight << shift } else { highlight << 16 };
                [0xffff_ffff, second, fix(*x), fix(*y), fix(z), fix(*u), fix(*v), q]
            },
        );
        let [a, b, c] = std::array::from_fn(|_| corners.next().unwrap());
        let vertex = if specular { VertexType::KSXYZUVQ } else { VertexType::KAXYZUVQ };
        record::triangle(&mut board.commands, vertex.code(), &a, &b, &c).unwrap();
    }
    board.issue();
}

#[test]
fn htri6_specular() {
    let mut old = board(Chip::V1000, true);
    htri6(&mut old, false);
    let mut new = board(Chip::V2000, true);
    htri6(&mut new, true);
    let (old, new) = (old.pixels(1), new.pixels(1));
    for pixels in [&old, &new] {
        // Yellow at the first corner, green at the second; cyan and magenta stay.
        check(pixels, &[(101, 100, 0xffe0), (201, 340, CYAN), (10, 10, 0)]);
    }
    let channels = |c: u16| [c >> 11, c >> 5 & 63, c & 31].map(i32::from);
    for (at, (&a, &b)) in old.iter().zip(&new).enumerate() {
        let near = channels(a).iter().zip(channels(b)).all(|(a, b)| (a - b).abs() <= 1);
        assert!(near, "({}, {}): {a:#06x}, {b:#06x}", at % 640, at / 640);
    }
}
