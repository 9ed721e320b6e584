//! Fills, copies and writes against bytes that are changed one by one.

use fillrate_redline::{Chip, DmaBlock, PixFmt, Port, Segment, record};

use crate::board::{Board, config, rows};
use crate::random::{Random, cases};

const SIZE: (u32, u32) = (64, 48);

/// What a back buffer should hold.
struct Picture(Vec<u16>);

impl Picture {
    fn change(&mut self, [x, y, w, h]: [u32; 4], mut pixel: impl FnMut(u32, u32, u16) -> u16) {
        for row in y..(y + h).min(SIZE.1) {
            for column in x..(x + w).min(SIZE.0) {
                let at = &mut self.0[(row * SIZE.0 + column) as usize];
                *at = pixel(column - x, row - y, *at);
            }
        }
    }
}

fn alu(mode: u32, source: u16, destination: u16, mask: u16) -> u16 {
    (0..16).fold(0, |all, bit| {
        let (s, d) = (u32::from(source >> bit & 1), u32::from(destination >> bit & 1));
        let new = (mode >> (2 * s + d) & 1) as u16;
        all | if mask >> bit & 1 != 0 { new } else { d as u16 } << bit
    })
}

#[test]
fn copies_and_fills() {
    for case in 0..cases(200) {
        let mut random = Random::new(case);
        let mut board = Board::new(config(Chip::V2000), SIZE, false);
        let texels: Vec<u32> = (0..64 * 48).map(|_| random.below(0x1_0000)).collect();
        let (_, texture) = board.texture(64, 48, PixFmt::Rgb565, &texels);
        let source = board.context.group(board.device, texture).unwrap().clone();
        let group = board.display();
        let mut picture = Picture(vec![0; 64 * 48]);
        for _ in 0..12 {
            let commands = &mut board.commands;
            let mode = random.pick(&[0xc, 0xc, 0, 3, 5, 6, 9, 0xe, 0xf]);
            let mask = random.pick(&[0xffff, 0xffff, 0xf81f, 0x5555]);
            record::set_alu_mode(commands, mode).unwrap();
            record::set_p_mask(commands, mask).unwrap();
            let mask = mask as u16;
            let [x, y, w, h] =
                [random.below(70), random.below(50), random.below(40), random.below(30)];
            let half = |v: u32| v as u16;
            let (at, size) = ([half(x), half(y)], [half(w), half(h)]);
            match random.below(5) {
                0 => {
                    let [sx, sy] = [random.below(64 - w), random.below(48 - h)];
                    let from = [half(sx), half(sy)];
                    record::copy_buffer(commands, &source, 0, mode, at, size, from).unwrap();
                    picture.change([x, y, w, h], |i, j, old| {
                        alu(mode, texels[((sy + j) * 64 + sx + i) as usize] as u16, old, mask)
                    });
                }
                1 => {
                    let color = random.word();
                    record::set_fg_color_argb(commands, color).unwrap();
                    record::bitfill(commands, at, size).unwrap();
                    let [_, r, g, b] = color.to_be_bytes().map(u16::from);
                    let packed = r >> 3 << 11 | g >> 2 << 5 | b >> 3;
                    picture.change([x, y, w, h], |_, _, old| alu(mode, packed, old, mask));
                }
                2 => {
                    // Raw fills and writes know neither mode nor mask.
                    let (w, h) = (w.min(64 - x.min(64)), h.min(48 - y.min(48)));
                    let value = random.word();
                    record::fill_buffer(commands, &group, 1, [x.min(64), y.min(48)], [w, h], value)
                        .unwrap();
                    picture.change([x, y, w, h], |_, _, _| value as u16);
                }
                3 => {
                    let (x, y) = (x.min(60), y.min(44));
                    let pixels: Vec<u32> = (0..12).map(|_| random.below(0x1_0000)).collect();
                    let bytes = rows(PixFmt::Rgb565, 3, &pixels);
                    let words: Vec<u32> =
                        bytes.as_chunks().0.iter().map(|&w| u32::from_le_bytes(w)).collect();
                    let to = group.addresses[1] + y * group.linebytes + x * 2;
                    record::mem_write_rect_inline(commands, [to, group.linebytes], [6, 4], &words)
                        .unwrap();
                    picture.change([x, y, 3, 4], |i, j, _| pixels[(j * 3 + i) as usize] as u16);
                }
                _ => {
                    // Onto itself, one pixel further, as if it were copied first.
                    let before = picture.0.clone();
                    record::set_src_base(commands, group.addresses[1]).unwrap();
                    record::set_src_stride(commands, group.stride).unwrap();
                    record::set_src_fmt(commands, 4).unwrap();
                    record::bitblt(commands, [1, 1], [60, 40], [0, 0]).unwrap();
                    picture.change([1, 1, 60, 40], |i, j, old| {
                        alu(mode, before[(j * 64 + i) as usize], old, mask)
                    });
                }
            }
            // A triangle between them: the same bytes in the engine's hands.
            let corners = [0, 0, 9 << 16, 0, 0, 9 << 16];
            if mode == 0xc && random.flag() {
                record::set_fg_color_argb(&mut board.commands, 0xff00_ff00).unwrap();
                record::triangle_fill(&mut board.commands, &corners).unwrap();
                picture.change([0, 0, 9, 9], |i, j, old| {
                    if i + j + 1 < 9 { alu(mode, 0x07e0, old, mask) } else { old }
                });
            }
        }
        board.issue();
        assert!(board.pixels(1) == picture.0, "case {case}");
    }
}

/// Blocks of memory pass their port, and hold what they hold when issued.
#[test]
fn memory_counts_when_it_is_issued() {
    for (port, value) in [
        (Port::Word, 0x2211u16),
        (Port::Byte, 0x3344),
        (Port::Other, 0x1122),
        (Port::Short, 0x4433),
    ] {
        let mut board = Board::new(config(Chip::V2000), SIZE, false);
        let group = board.display();
        board.memory.0 = vec![0; 8];
        let data = DmaBlock { port, ..DmaBlock::default() };
        record::mem_write(&mut board.commands, group.addresses[1], data, 4, 2).unwrap();
        // Filled after it was recorded.
        board.memory.0[..4].copy_from_slice(&[0x11, 0x22, 0x33, 0x44]);
        board.issue();
        board.memory.0.fill(9);
        assert_eq!(board.pixels(1)[0], value, "{port:?}");
    }
}

/// A sprite's gaps show what was there.
#[test]
fn sprites_have_gaps() {
    let mut board = Board::new(config(Chip::V2000), SIZE, false);
    let group = board.display();
    let mut words = vec![13, group.addresses[1], group.linebytes, 128, 48, 0x5_0005];
    words.extend([14, group.addresses[1], 4, 4, 0x7_0007, 4 << 16 | 2, 0x8, 0]);
    board.issue();
    board.issue_segments(vec![Segment::of(&words)]);
    assert_eq!(board.pixels(1)[..7], [7, 7, 5, 5, 8, 5, 5]);
}

/// Palette indices become pixels of any surface.
#[test]
fn lookups_take_texels_by_index() {
    let mut board = Board::new(config(Chip::V1000), SIZE, false);
    let palette: Vec<u32> = (0..256).map(|i| i * 257 % 0x1_0000).collect();
    // Wider than the display: made on a board of its own size.
    let create = fillrate_redline::Call::CreateSurface {
        device: board.device,
        mask: 0,
        buffers: 1,
        format: 4,
        width: 64,
        height: 4,
    };
    let number = board.context.execute(&create).unwrap().number();
    let place = board.context.group(board.device, number).unwrap().clone();
    let bytes = rows(PixFmt::Rgb565, 256, &palette);
    let words: Vec<u32> = bytes.as_chunks().0.iter().map(|&w| u32::from_le_bytes(w)).collect();
    let commands = &mut board.commands;
    let to = [place.addresses[0], place.linebytes];
    record::mem_write_rect_inline(commands, to, [512, 1], &words).unwrap();
    record::set_src_base(commands, place.addresses[0]).unwrap();
    record::set_src_stride(commands, place.stride).unwrap();
    record::set_src_fmt(commands, 4).unwrap();
    record::set_src_func(commands, 1).unwrap();
    record::set_src_color_no_pad(commands, 1).unwrap();
    let indices: Vec<u8> = (0..40).map(|i| (i * 37 % 256) as u8).collect();
    board.memory.0 = indices.clone();
    record::lookup(&mut board.commands, [10, 5], [7, 5], DmaBlock::default()).unwrap();
    board.issue();
    let pixels = board.pixels(1);
    for (y, row) in indices.chunks(8).enumerate() {
        for (x, &index) in row[..7].iter().enumerate() {
            let found = u32::from(pixels[(5 + y) * 64 + 10 + x]);
            assert_eq!(found, palette[usize::from(index)], "({x}, {y})");
        }
        assert_eq!(pixels[(5 + y) * 64 + 17], 0, "no more than seven of a row");
    }
}

/// Host pixels of an odd width through the pipeline, with a key.
#[test]
fn host_pixels_are_keyed() {
    let mut board = Board::new(config(Chip::V1000), SIZE, false);
    let pixels = [1u32, 2, 3, 2, 1, 3];
    board.memory.0 = rows(PixFmt::Rgb565, 3, &pixels);
    let commands = &mut board.commands;
    record::set_src_color_no_pad(commands, 1).unwrap();
    record::set_chroma_key(commands, 1).unwrap();
    record::set_chroma_color(commands, 2, 4).unwrap();
    record::bitblt_mem(commands, [62, 46], [3, 2], 2, DmaBlock::default()).unwrap();
    record::bitblt_mem(commands, [8, 8], [3, 2], 2, DmaBlock::default()).unwrap();
    board.issue();
    let found = board.pixels(1);
    assert_eq!(found[64 * 8 + 7..][..5], [0, 1, 0, 3, 0]);
    assert_eq!(found[64 * 9 + 7..][..5], [0, 0, 1, 3, 0]);
    assert_eq!((found[64 * 46 + 62], found[64 * 47 + 63]), (1, 1));
}
