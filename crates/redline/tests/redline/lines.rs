//! Which pixels lines, dots and spans are.

use fillrate_redline::{Chip, VertexType, record};

use crate::board::{Board, config};
use crate::random::{Random, cases};

const SIZE: (u32, u32) = (64, 48);

fn board() -> Board {
    let mut board = Board::new(config(Chip::V2000), SIZE, false);
    record::set_fg_color_argb(&mut board.commands, 0xffff_ffff).unwrap();
    board
}

fn drawn(board: &mut Board) -> Vec<(i64, i64)> {
    board.issue();
    let pixels = board.pixels(1);
    let at = |i: usize| ((i % 64) as i64, (i / 64) as i64);
    pixels.iter().enumerate().filter(|(_, p)| **p != 0).map(|(i, _)| at(i)).collect()
}

/// One pixel for each column (row) whose centre is between the ends, in the
/// row (column) that the line crosses there.
#[test]
fn lines_are_one_pixel_wide() {
    for case in 0..cases(300) {
        let mut random = Random::new(case);
        let end = |random: &mut Random| {
            [random.below(80 << 16), random.below(60 << 16)].map(|v| v.wrapping_sub(8 << 16))
        };
        let (a, b) = (end(&mut random), end(&mut random));
        let mut board = board();
        record::line(&mut board.commands, VertexType::XY.code(), &a, &b).unwrap();
        let mut found = drawn(&mut board);
        let [x0, y0, x1, y1] = [a[0], a[1], b[0], b[1]].map(|v| f64::from(v as i32) / 65536.0);
        let steep = (y1 - y0).abs() > (x1 - x0).abs();
        let (p0, q0, p1, q1) = if steep { (y0, x0, y1, x1) } else { (x0, y0, x1, y1) };
        let mut expected = Vec::new();
        for p in -20..100 {
            let center = f64::from(p) + 0.5;
            let inside =
                if p1 >= p0 { p0 <= center && center < p1 } else { p1 < center && center <= p0 };
            if inside {
                let q = (q0 + (q1 - q0) * (center - p0) / (p1 - p0)).floor() as i64;
                let (x, y) = if steep { (q, i64::from(p)) } else { (i64::from(p), q) };
                if (0..64).contains(&x) && (0..48).contains(&y) {
                    expected.push((x, y));
                }
            }
        }
        found.sort_unstable();
        expected.sort_unstable();
        assert_eq!(found, expected, "case {case}: {x0} {y0} to {x1} {y1}");
    }
}

#[test]
fn whole_lines_end_on_their_pixels() {
    for (from, to, last, count) in [
        ([3u16, 4u16], [13u16, 9u16], true, 11),
        ([3, 4], [13, 9], false, 10),
        ([13, 9], [3, 4], true, 11),
        ([5, 5], [5, 5], true, 1),
        ([5, 5], [5, 5], false, 0),
        ([5, 40], [7, 2], true, 39),
        ([60, 5], [70, 5], true, 4),
    ] {
        let mut board = board();
        record::int_line(&mut board.commands, last, from, to).unwrap();
        let found = drawn(&mut board);
        assert_eq!(found.len(), count, "{from:?} {to:?} {last}");
        let has = |[x, y]: [u16; 2]| found.contains(&(i64::from(x), i64::from(y)));
        assert_eq!(has(from), count > 0);
        assert_eq!(has(to), last && to[0] < 64);
    }
}

#[test]
fn patterns_count_along_lines() {
    let mut board = board();
    record::set_pat(&mut board.commands, 0xd000_0000).unwrap();
    record::set_pat_length(&mut board.commands, 4).unwrap();
    record::set_pat_enable(&mut board.commands, 1).unwrap();
    record::int_line(&mut board.commands, true, [10, 10], [10, 17]).unwrap();
    let rows: Vec<i64> = drawn(&mut board).iter().map(|at| at.1).collect();
    assert_eq!(rows, [10, 11, 13, 14, 15, 17]);
}

#[test]
fn dots_and_spans() {
    let mut board = board();
    let commands = &mut board.commands;
    record::dot(commands, VertexType::XY.code(), &[(5 << 16) + 0xffff, 6 << 16]).unwrap();
    // Red rises by 16 a pixel.
    let start = [8 << 16, 0, 0, 0, 20 << 16, 12 << 16];
    let delta = [16 << 16, 0, 0, 0, 10 << 16, 0];
    record::span(commands, VertexType::RGBFXY.code(), &start, &delta).unwrap();
    board.issue();
    let pixels = board.pixels(1);
    assert_eq!(pixels[6 * 64 + 5], 0xffff);
    let span: Vec<u16> = pixels[12 * 64 + 19..][..12].iter().map(|p| p >> 11).collect();
    assert_eq!(span, [0, 1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 0]);
}

/// An antialiased line's two pixels share its colour.
#[test]
fn antialiased_lines_share_their_pixels() {
    let mut board = board();
    let (a, b) = ([4 << 16, (10 << 16) + 0xc000], [20 << 16, (10 << 16) + 0xc000]);
    record::aa_line(&mut board.commands, VertexType::XY.code(), &a, &b).unwrap();
    board.issue();
    let pixels = board.pixels(1);
    let green = |x: usize, y: usize| i32::from(pixels[y * 64 + x] >> 5 & 63);
    for x in 4..20 {
        assert!((green(x, 10) - 47).abs() <= 1 && (green(x, 11) - 16).abs() <= 1);
        assert_eq!((green(x, 9), green(x, 12)), (0, 0));
    }
    assert_eq!((green(3, 10), green(20, 10)), (0, 0));
}

/// Along an edge, the pixels outside get the part that is inside.
#[test]
fn antialiased_edges_blend_what_is_outside() {
    let mut board = board();
    // Everything below row 10.25, drawn, then its edge from left to right.
    let y = (10 << 16) + 0x4000;
    let commands = &mut board.commands;
    let (edge_a, edge_b) = ([0, y], [64 << 16, y]);
    record::aa_edge(commands, VertexType::XY.code(), &edge_a, &edge_b).unwrap();
    record::aa_edge(commands, VertexType::XY.code(), &[40 << 16, 30 << 16], &[0, 30 << 16])
        .unwrap();
    board.issue();
    let pixels = board.pixels(1);
    // Pixel 10's centre is inside; pixel 9 has no part inside.
    assert_eq!(pixels[10 * 64 + 5], 0);
    assert_eq!(pixels[9 * 64 + 5], 0);
    let mut second = self::board();
    let y = (10 << 16) + 0xc000;
    record::aa_edge(&mut second.commands, VertexType::XY.code(), &[0, y], &[64 << 16, y]).unwrap();
    second.issue();
    let pixels = second.pixels(1);
    let green = i32::from(pixels[10 * 64 + 5] >> 5 & 63);
    assert!((green - 16).abs() <= 1, "a quarter of the pixel is inside: {green}");
}

/// The fog of a fast triangle is the high byte of its word; the rest of the
/// word is no second colour.
#[test]
fn fast_triangles_take_fog_alone() {
    for (fog, expected) in [(0xff12_3456u32, 0xf81f), (0x0012_3456, 0x07e0)] {
        let mut board = board();
        let commands = &mut board.commands;
        record::set_specular_enable(commands, 1).unwrap();
        record::set_fog_enable(commands, 1).unwrap();
        record::set_fog_color_rgb(commands, 0x0000_ff00).unwrap();
        let corner = |x: u32, y: u32| [0xff_00ff, fog, x << 16, y << 16, 0, 0, 0, 0x40_0000];
        let words = [&[50][..], &corner(0, 0), &corner(40, 0), &corner(0, 40)].concat();
        let out = fillrate_redline::CommandSink::reserve(commands, words.len(), 0).unwrap();
        out.copy_from_slice(&words);
        board.issue();
        assert_eq!(board.pixels(1)[64 * 5 + 5], expected);
    }
}
