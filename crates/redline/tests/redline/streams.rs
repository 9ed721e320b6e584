//! Random valid programs, written by the recording functions and by hand: the
//! same words, and the same picture.
//!
//! 150 programs; `FILLRATE_CASES=10000` runs more.

use fillrate_redline::{Chip, Segment, VertexType, record};

use crate::board::{Board, config};
use crate::random::{Random, cases};
use crate::raw::Words;

/// A setter, its word in the document's table, and its values.
type Setter =
    (fn(&mut fillrate_redline::CommandBuffer, u32) -> fillrate_redline::Result<()>, u32, u32);

/// Setters of one value from 0 to before the last number.
const SETTERS: &[Setter] = &[
    (record::set_src_func, 0x1231, 4),
    (record::set_src_filter, 0x13b2, 2),
    (record::set_src_color_no_pad, 0x14b3, 2),
    (record::set_swap_uv, 0x1534, 2),
    (record::set_chroma_key, 0x15b5, 2),
    (record::set_z_scissor_enable, 0x1636, 2),
    (record::set_src_bgr, 0x16b7, 2),
    (record::set_u_clamp, 0x17be, 2),
    (record::set_v_clamp, 0x183f, 2),
    (record::set_u_mask, 0x1038, 64),
    (record::set_v_mask, 0x1839, 64),
    (record::set_u_multiplier, 0x5028, 64 << 16),
    (record::set_v_multiplier, 0x5029, 64 << 16),
    (record::set_s_offset, 0x602a, 4 << 16),
    (record::set_t_offset, 0x602b, 4 << 16),
    (record::set_alu_mode, 0x1040, 16),
    (record::set_blend_src_func, 0x1241, 10),
    (record::set_blend_dst_func, 0x1442, 8),
    (record::set_z_buf_mode, 0x1643, 7),
    (record::set_z_buf_wr_mode, 0x1844, 2),
    (record::set_yuv2rgb, 0x9945, 2),
    (record::set_blend_enable, 0x89c6, 2),
    (record::set_dither_enable, 0xaa47, 2),
    (record::set_fog_enable, 0x1ac8, 2),
    (record::set_dst_rd_disable, 0x1bca, 2),
    (record::set_dst_bgr, 0x1c4b, 2),
    (record::set_transp_reject, 0x1ccc, 2),
    (record::set_p_mask, 0x1007, u32::MAX),
    (record::set_pat, 0x1008, u32::MAX),
    (record::set_pat_enable, 0x1851, 2),
    (record::set_pat_opaque, 0x18d2, 2),
    (record::set_pat_offset, 0x100d, 32),
    (record::set_dither_offset, 0x1011, 64),
    (record::set_fg_color_argb, 0x3013, u32::MAX),
    (record::set_bg_color_argb, 0x1014, u32::MAX),
    (record::set_fog_color_rgb, 0x1015, 1 << 24),
    (record::set_dst_color_argb, 0x1016, u32::MAX),
    (record::set_z, 0x2054, u32::MAX),
    (record::set_r, 0x2056, 256 << 16),
    (record::set_g, 0x2058, 256 << 16),
    (record::set_b, 0x2059, 256 << 16),
    (record::set_a, 0x2055, 256 << 16),
    (record::set_f, 0x205b, 256 << 16),
    (record::set_u, 0x205a, 2 << 16),
    (record::set_v, 0x2057, 2 << 16),
];

/// Setters whose packed colour has blue first, with the word of the other one.
const SWAPPED: &[Setter] = &[
    (record::set_fg_color_abgr, 0x3013, u32::MAX),
    (record::set_bg_color_abgr, 0x1014, u32::MAX),
    (record::set_dst_color_abgr, 0x1016, u32::MAX),
    (record::set_fog_color_bgr, 0x1015, u32::MAX),
];

const SIZE: (u32, u32) = (96, 64);

/// A vertex of a type with values that mean something.
fn vertex(random: &mut Random, vertex: VertexType) -> Vec<u32> {
    use fillrate_redline::vertex::Attribute as A;
    let word = |attribute: &A| match attribute {
        A::X => (random.below(SIZE.0 << 16)).wrapping_sub(8 << 16),
        A::Y => (random.below(SIZE.1 << 16)).wrapping_sub(8 << 16),
        A::Z => random.word(),
        A::U | A::V => random.below(3 << 16).wrapping_sub(1 << 16),
        A::Q => random.below(0xff_fffe) + 1,
        A::R | A::G | A::B | A::A | A::F | A::I => random.below(256 << 16),
        A::K | A::Ka | A::S | A::Sf | A::Fp => random.word(),
    };
    vertex.attributes().iter().map(word).collect()
}

fn vertex_type(random: &mut Random, chip: Chip) -> VertexType {
    loop {
        let vertex = random.pick(VertexType::ALL);
        if chip.has_specular() || !vertex.is_specular() {
            return vertex;
        }
    }
}

/// One command, by both writers.
fn step(random: &mut Random, board: &mut Board, raw: &mut Words, chip: Chip) {
    let commands = &mut board.commands;
    match random.below(12) {
        0..=4 => {
            let (set, word, end) = random.pick(SETTERS);
            let value = random.below(end);
            set(commands, value).unwrap();
            raw.state(word, value);
        }
        5 => {
            let (set, word, _) = random.pick(SWAPPED);
            let value = random.word();
            set(commands, value).unwrap();
            let [a, b, g, r] = value.to_be_bytes();
            raw.state(word, u32::from_be_bytes([a, r, g, b]));
        }
        6 => odd_setters(random, board, raw),
        7 | 8 => chains(random, board, raw, chip),
        9 => shapes(random, board, raw, chip),
        _ => plane(random, board, raw),
    }
}

/// Setters with more than a value.
fn odd_setters(random: &mut Random, board: &mut Board, raw: &mut Words) {
    let commands = &mut board.commands;
    match random.below(5) {
        0 => {
            let length = random.below(32) + 1;
            record::set_pat_length(commands, length).unwrap();
            raw.state(0x1050, length - 1);
        }
        1 => {
            let value = random.word() as u8;
            record::set_alpha_threshold(commands, value).unwrap();
            raw.state(0x101d, value.into());
        }
        2 => {
            let value = random.word();
            record::set_chroma_color(commands, value, 4).unwrap();
            raw.state(0x1017, value & 0xffff);
            record::set_chroma_mask(commands, value >> 4, 4).unwrap();
            raw.state(0x101a, value >> 4 & 0xffff);
        }
        3 => {
            let (base, stride) = (random.below(1 << 20), random.below(0x78));
            let (v, u) = (random.below(256), random.below(256));
            record::set_current_texture(
                commands,
                base,
                stride,
                v as u16,
                u as u16,
                [u << 16, v << 16],
            )
            .unwrap();
            raw.command(0x4000, &[base, stride, v << 16 | u, u << 16, v << 16]);
        }
        _ => {
            // 565: each entry is white or the low byte's blue.
            let entries: Vec<u32> =
                (0..16).map(|_| if random.flag() { 0xffff_ffff } else { 0xf8 }).collect();
            record::set_texture_palette(commands, 0, &entries, 8).unwrap();
            let entry = |argb: u32| if argb == 0xf8 { 0x1f } else { 0xffff };
            let words: Vec<u32> =
                entries.chunks(2).map(|e| entry(e[0]) << 16 | entry(e[1])).collect();
            raw.command(0x7020, &words);
        }
    }
}

/// Primitives of vertices.
fn chains(random: &mut Random, board: &mut Board, raw: &mut Words, chip: Chip) {
    let kind = vertex_type(random, chip);
    let code = kind.code();
    let count = random.below(4) + 1;
    let vertices: Vec<Vec<u32>> = (0..count + 2).map(|_| vertex(random, kind)).collect();
    let all = vertices.concat();
    let commands = &mut board.commands;
    let [a, b, c] = [&vertices[0], &vertices[1], &vertices[2]];
    match random.below(8) {
        0 | 1 => {
            record::triangle(commands, code, a, b, c).unwrap();
            raw.primitive(code, 24, &[], &[a.as_slice(), b, c].concat());
        }
        2 => {
            record::tristrip(commands, code, count, &all).unwrap();
            raw.primitive(code, 26, &[count], &all);
        }
        3 => {
            record::trifan(commands, code, count + 2, &all).unwrap();
            raw.primitive(code, 27, &[count + 2], &all);
        }
        4 => {
            record::polyline(commands, code, count + 1, &all).unwrap();
            raw.primitive(code, 17, &[count + 1], &all);
        }
        5 => {
            record::line(commands, code, a, b).unwrap();
            raw.primitive(code, 16, &[], &[a.as_slice(), b].concat());
        }
        6 => {
            record::aa_line(commands, code, a, b).unwrap();
            raw.primitive(code, 20, &[], &[a.as_slice(), b].concat());
            record::aa_edge(commands, code, b, c).unwrap();
            raw.primitive(code, 25, &[], &[b.as_slice(), c].concat());
        }
        _ => {
            record::dot(commands, code, a).unwrap();
            raw.primitive(code, 15, &[], a);
        }
    }
}

/// Rectangles and the like.
fn shapes(random: &mut Random, board: &mut Board, raw: &mut Words, chip: Chip) {
    let kind = vertex_type(random, chip);
    let code = kind.code();
    let one = vertex(random, kind);
    let [w, h] = [random.below(30 << 16), random.below(30 << 16)];
    let commands = &mut board.commands;
    match random.below(6) {
        0 => {
            record::square(commands, code, w, &one).unwrap();
            raw.primitive(code, 22, &[w], &one);
        }
        1 => {
            record::rectangle(commands, code, w, h, &one).unwrap();
            raw.primitive(code, 23, &[w, h], &one);
        }
        2 => {
            let corners: [u32; 6] = std::array::from_fn(|_| random.below(80 << 16));
            record::triangle_fill(commands, &corners).unwrap();
            raw.command(38, &corners);
        }
        3 => {
            let step = [random.below(1 << 22), random.below(1 << 22)];
            let words = [4 << 16, 5 << 16, 0, 0, w, h, step[0], 0, 0, step[1]];
            record::affine(commands, &words).unwrap();
            raw.command(28, &words);
        }
        4 => {
            let pairs: Vec<u32> = (0..24).map(|_| random.below(2 << 16)).collect();
            record::warp(commands, [7, 9], [4, 3], [w, h], &pairs).unwrap();
            raw.command(29, &[&[7 << 16 | 9, 4 << 16 | 3, w, h], pairs.as_slice()].concat());
        }
        _ => {
            let mut delta = vertex(random, kind);
            if let Some(x) = kind.layout().word(fillrate_redline::vertex::Attribute::X) {
                delta[x] = random.below(20) << 16;
            }
            record::span(commands, code, &one, &delta).unwrap();
            raw.primitive(code, 21, &[], &[one.as_slice(), &delta].concat());
        }
    }
}

/// Two-dimensional commands.
fn plane(random: &mut Random, board: &mut Board, raw: &mut Words) {
    let group = board.display();
    let commands = &mut board.commands;
    let [x, y, w, h]: [u32; 4] = std::array::from_fn(|i| random.below([60, 40, 30, 20][i]));
    let half = |v: u32| v as u16;
    match random.below(8) {
        0 => {
            let value = random.word();
            let buffer = random.below(3);
            record::fill_buffer(commands, &group, buffer, [x, y], [w, h], value).unwrap();
            let address = group.addresses[buffer as usize] + y * group.linebytes + x * 2;
            raw.command(13, &[address, group.linebytes, w * 2, h, (value & 0xffff) * 0x1_0001]);
        }
        1 => {
            record::bitfill(commands, [half(x), half(y)], [half(w), half(h)]).unwrap();
            raw.command(31, &[x << 16 | y, w << 16 | h]);
        }
        2 => {
            record::bitblt(commands, [half(x), half(y)], [half(w), half(h)], [3, 5]).unwrap();
            raw.command(30, &[x << 16 | y, w << 16 | h, 3 << 16 | 5]);
        }
        3 => {
            let last = random.flag();
            record::int_line(commands, last, [half(x), half(y)], [half(w), half(h)]).unwrap();
            raw.command(u32::from(last) << 16 | 18, &[x << 16 | y, w << 16 | h]);
        }
        4 => {
            let points = [x << 16 | y, w << 16 | h, h << 16 | w, y << 16 | x];
            record::int_polyline(commands, true, 3, &points).unwrap();
            raw.command(1 << 16 | 19, &[&[3], points.as_slice()].concat());
        }
        5 => {
            let records: Vec<u32> = (0..8).map(|_| random.below(40 << 16)).collect();
            record::particles(commands, 2, &records).unwrap();
            raw.command(37, &[&[2], records.as_slice()].concat());
        }
        6 => {
            record::set_scissor_x(commands, x << 16 | (x + w)).unwrap();
            raw.state(0x100e, x << 16 | (x + w));
            record::set_scissor_y(commands, y << 16 | (y + h)).unwrap();
            raw.state(0x100f, y << 16 | (y + h));
        }
        _ => {
            let value = random.word();
            let address = group.addresses[1] + y * group.linebytes;
            record::mem_fill(commands, address, value, 4, w).unwrap();
            raw.command(13, &[address, 0, w * 2, 1, (value & 0xffff) * 0x1_0001]);
        }
    }
}

/// A texture of noise, bound.
fn noise(random: &mut Random, board: &mut Board) {
    let texels: Vec<u32> = (0..64 * 64).map(|_| random.below(0x1_0000)).collect();
    let (surface, group) = board.texture(64, 64, fillrate_redline::PixFmt::Rgb565, &texels);
    board.bind(&surface, group);
}

#[test]
fn recorded_and_raw_words_agree() {
    for case in 0..cases(150) {
        let mut random = Random::new(case);
        let chip = random.pick(&[Chip::V1000, Chip::V2000]);
        let mut recorded = Board::new(config(chip), SIZE, true);
        let mut by_hand = Board::new(config(chip), SIZE, true);
        noise(&mut Random::new(case), &mut recorded);
        noise(&mut Random::new(case), &mut by_hand);
        recorded.issue();
        by_hand.issue();
        let mut raw = Words::default();
        for _ in 0..random.below(60) + 5 {
            step(&mut random, &mut recorded, &mut raw, chip);
        }
        assert_eq!(recorded.commands.words(), raw.0, "case {case}");
        recorded.issue();
        by_hand.issue_segments(vec![Segment::of(&raw.0)]);
        for buffer in 0..3 {
            assert!(
                recorded.pixels(buffer) == by_hand.pixels(buffer),
                "case {case}, buffer {buffer}"
            );
        }
    }
}

/// Threads, the device's own thread, and where the stream is cut change
/// nothing.
#[test]
fn pictures_do_not_depend_on_how_it_is_issued() {
    for case in 0..cases(40) {
        let chip = Chip::V2000;
        let mut pictures = Vec::new();
        for way in 0..3 {
            let mut settings = config(chip);
            settings.background = way > 0;
            settings.device.threads = 1 + way;
            let mut board = Board::new(settings, SIZE, true);
            noise(&mut Random::new(case), &mut board);
            let mut random = Random::new(case);
            let mut raw = Words::default();
            for _ in 0..40 {
                step(&mut random, &mut board, &mut raw, chip);
                if way == 2 {
                    board.issue();
                }
            }
            board.issue();
            pictures.push([0, 1, 2].map(|buffer| board.pixels(buffer)));
        }
        assert!(pictures[0] == pictures[1] && pictures[0] == pictures[2], "case {case}");
    }
}

/// A stream with several flips falls into parts that show a frame each.
#[test]
fn streams_fall_into_frames() {
    let (chip, flip, wait) = (Chip::V1000, [4, 0x1000], [6]);
    let fill = [31, 0, 0x5_0005];
    let stream = |parts: &[&[u32]]| parts.concat();
    let (first, second) =
        (stream(&[&fill, &flip, &wait, &fill]), stream(&[&flip, &fill, &[5, 1, 2]]));
    let whole = stream(&[&first, &second, &fill]);
    let frames = fillrate_redline::stream::frames(&whole, chip);
    assert_eq!(frames, [&first[..], &second[..5], &whole[first.len() + 5..]]);
    assert_eq!(fillrate_redline::stream::switches(&whole, chip), Ok(3));
    assert_eq!(fillrate_redline::stream::frames(&fill, chip), [&fill]);
    assert_eq!(fillrate_redline::stream::frames(&[], chip), [&[0u32; 0]]);
    assert!(fillrate_redline::stream::switches(&[4], chip).is_err());
}
