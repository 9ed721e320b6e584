//! Random states over every source and destination format, against the model:
//! 400 of them, `FILLRATE_CASES=n` for more.

use fillrate_redline::{CommandBuffer, DmaBlock, PixFmt, VertexType, record};

use crate::board::{Board, config, rows};
use crate::model::Model;
use crate::random::{Random, cases};

const SIDE: u32 = 16;
const DESTINATIONS: [PixFmt; 7] = [
    PixFmt::Rgb565,
    PixFmt::Argb4444,
    PixFmt::Argb1555,
    PixFmt::Argb8888,
    PixFmt::Rgb332,
    PixFmt::Gray8,
    PixFmt::Alpha8,
];

fn noise(random: &mut Random, format: PixFmt, count: u32) -> Vec<u32> {
    let mut texels: Vec<u32> = (0..count).map(|_| random.word() & format.full_mask()).collect();
    // Some equal ones, for keys and comparisons.
    for i in 0..count as usize / 4 {
        texels[i * 4] = texels[0];
    }
    texels
}

/// A state, and the commands that set it.
fn state(
    random: &mut Random,
    commands: &mut CommandBuffer,
    source: PixFmt,
    texels: &[u32],
) -> Model {
    let mut model = Model { alu: 0xc, planes: u32::MAX, ..Model::default() };
    model.source = random.below(4);
    record::set_src_func(commands, model.source).unwrap();
    model.color = random.word();
    record::set_fg_color_argb(commands, model.color).unwrap();
    model.pad = random.flag();
    record::set_src_color_no_pad(commands, u32::from(!model.pad)).unwrap();
    model.bgr = random.flag();
    record::set_src_bgr(commands, model.bgr.into()).unwrap();
    model.yuv = random.below(4) != 0;
    record::set_yuv2rgb(commands, model.yuv.into()).unwrap();
    if random.below(3) == 0 && source != PixFmt::Yuv422 {
        let (key, mask) = (texels[0], random.word() | random.word());
        model.key = Some((key & source.full_mask(), mask & source.full_mask()));
        record::set_chroma_key(commands, 1).unwrap();
        record::set_chroma_color(commands, key, source.code()).unwrap();
        record::set_chroma_mask(commands, mask, source.code()).unwrap();
    }
    if model.key.is_none() && random.below(4) == 0 {
        pattern(random, commands, &mut model);
    }
    if random.below(3) == 0 {
        let threshold = random.below(256);
        model.threshold = Some(threshold);
        record::set_transp_reject(commands, 1).unwrap();
        record::set_alpha_threshold(commands, threshold as u8).unwrap();
    }
    shading(random, commands, &mut model);
    output(random, commands, &mut model);
    model
}

fn pattern(random: &mut Random, commands: &mut CommandBuffer, model: &mut Model) {
    let (bits, length, offset) = (random.word(), random.below(32) + 1, random.below(40));
    let background = random.flag().then(|| random.word());
    model.pattern = Some((bits, length, offset, background));
    record::set_pat(commands, bits).unwrap();
    record::set_pat_length(commands, length).unwrap();
    record::set_pat_offset(commands, offset).unwrap();
    record::set_pat_enable(commands, 1).unwrap();
    record::set_pat_opaque(commands, background.is_some().into()).unwrap();
    record::set_bg_color_argb(commands, background.unwrap_or(0)).unwrap();
}

fn shading(random: &mut Random, commands: &mut CommandBuffer, model: &mut Model) {
    if random.below(3) == 0 {
        let (factor, color) = (random.below(256), random.word() & 0xff_ffff);
        model.fog = Some((factor, color));
        record::set_fog_enable(commands, 1).unwrap();
        record::set_f(commands, factor << 16).unwrap();
        record::set_fog_color_rgb(commands, color).unwrap();
    }
    if random.below(3) == 0 {
        let color = random.word() & 0xff_ffff;
        model.specular = Some(color);
        record::set_specular_enable(commands, 1).unwrap();
        record::set_specular_color_rgb(commands, color).unwrap();
    }
}

fn output(random: &mut Random, commands: &mut CommandBuffer, model: &mut Model) {
    match random.below(4) {
        0 | 1 => {
            let factors = (random.below(10), random.below(8));
            model.blend = Some(factors);
            record::set_blend_enable(commands, 1).unwrap();
            record::set_blend_src_func(commands, factors.0).unwrap();
            record::set_blend_dst_func(commands, factors.1).unwrap();
            if random.below(3) == 0 {
                let color = random.word();
                model.constant = Some(color);
                record::set_dst_rd_disable(commands, 1).unwrap();
                record::set_dst_color_argb(commands, color).unwrap();
            }
        }
        2 => {
            model.alu = random.below(16);
            record::set_alu_mode(commands, model.alu).unwrap();
        }
        _ => {}
    }
    if random.below(3) == 0 {
        let (x, y) = (random.below(4), random.below(4));
        model.dither = Some((x, y));
        record::set_dither_enable(commands, 1).unwrap();
        record::set_dither_offset(commands, y << 4 | x).unwrap();
    }
    if random.below(4) == 0 {
        model.planes = random.word();
        record::set_p_mask(commands, model.planes).unwrap();
    }
}

/// Depth test with a constant z; what the buffer holds is near it.
fn depth(random: &mut Random, commands: &mut CommandBuffer, model: &mut Model) {
    let z = 1000 + random.below(3);
    model.depth = (random.below(7), random.flag(), z);
    record::set_z(commands, z << 16 | random.below(0x1_0000)).unwrap();
    record::set_z_buf_mode(commands, model.depth.0).unwrap();
    record::set_z_buf_wr_mode(commands, model.depth.1.into()).unwrap();
}

fn set_palette(
    random: &mut Random,
    commands: &mut CommandBuffer,
    source: PixFmt,
    model: &mut Model,
) {
    let entries: [u32; 16] = std::array::from_fn(|_| random.word());
    let bits = match source {
        PixFmt::Palette4444 => [4; 4],
        PixFmt::Palette1555 => [1, 5, 5, 5],
        _ => [0, 5, 6, 5],
    };
    model.palette = entries.map(|argb| {
        let channels = argb.to_be_bytes().into_iter().zip(bits);
        channels.fold(0, |all, (c, bits)| all << bits | u32::from(c) >> (8 - bits))
    });
    record::set_texture_palette(commands, 0, &entries, source.code()).unwrap();
}

/// Raw pixels of the source, and pairs of YUV, as the model takes them.
fn source_pixels(bytes: &[u8], source: PixFmt, at: u32) -> (u32, ([u32; 4], usize)) {
    let row = bytes.len() / SIDE as usize * (at / SIDE) as usize;
    let x = (at % SIDE) as usize;
    let byte = |i: usize| u32::from(bytes[row + i]);
    let raw = match source.bits() {
        4 => byte(x / 2) >> (x % 2 * 4) & 15,
        8 => byte(x),
        16 => byte(2 * x) | byte(2 * x + 1) << 8,
        _ => [3, 2, 1, 0].iter().fold(0, |all, i| all << 8 | byte(4 * x + i)),
    };
    let pair = match source {
        PixFmt::Yuv422 => [0, 1, 2, 3].map(|i| byte(x / 2 * 4 + i)),
        _ => [0; 4],
    };
    (raw, (pair, x % 2))
}

#[test]
fn every_format_and_state() {
    let (mut all, mut changed) = (0, 0);
    for case in 0..cases(400) {
        let mut random = Random::new(case);
        let mut board = Board::new(config(fillrate_redline::Chip::V2000), (64, 48), true);
        let source = random.pick(&PixFmt::ALL);
        let format = random.pick(&DESTINATIONS);
        let texels = noise(&mut random, source, SIDE * SIDE);
        let (surface, texture) = board.texture(SIDE, SIDE, source, &texels);
        let old = noise(&mut random, format, SIDE * SIDE);
        let (mut target, target_group) = board.texture(SIDE, SIDE, format, &old);
        board.bind(&surface, texture);
        let place = board.context.group(board.device, target_group).unwrap().clone();
        target.bgr = u32::from(random.below(4) == 0);
        record::install_dst_buffer(&mut board.commands, &target, &place).unwrap();
        let mut model = state(&mut random, &mut board.commands, source, &texels);
        model.dst_bgr = target.bgr != 0;
        if source.bits() == 4 {
            set_palette(&mut random, &mut board.commands, source, &mut model);
        }
        depth(&mut random, &mut board.commands, &mut model);
        let old_z = depths(&mut random, &mut board);
        let half = (SIDE / 2) << 16;
        let center = [half, half];
        let code = VertexType::XY.code();
        record::square(&mut board.commands, code, SIDE << 16, &center).unwrap();
        board.issue();
        let found = board.read(target_group, 0, [0, 0], [SIDE, SIDE]);
        let z = board.read(board.group, 2, [0, 0], [SIDE, SIDE]);
        let bytes = rows(source, SIDE, &texels);
        for at in 0..SIDE * SIDE {
            let (raw, pair) = source_pixels(&bytes, source, at);
            let texel = match model.source {
                0 => ([0; 4], false),
                _ => model.texel(source, raw, pair),
            };
            let before = (old[at as usize], old_z[at as usize]);
            let expected = model.draw(texel, format, before, (at % SIDE, at / SIDE));
            all += 1;
            changed += u32::from(expected != before);
            let size = format.bits() as usize / 8;
            let pixel = &found[at as usize * size..][..size];
            let pixel = pixel.iter().rev().fold(0, |all, &b| all << 8 | u32::from(b));
            let depth = u32::from(u16::from_le_bytes([z[at as usize * 2], z[at as usize * 2 + 1]]));
            assert_eq!(
                (pixel, depth),
                expected,
                "case {case}: {source:?} to {format:?} at {at}, before {before:x?}\n{model:?}"
            );
        }
    }
    assert!(changed * 4 > all, "most fragments are dropped: {changed} of {all}");
}

/// Random depths in the display's Z buffer.
fn depths(random: &mut Random, board: &mut Board) -> Vec<u32> {
    let old: Vec<u32> = (0..SIDE * SIDE).map(|_| 1000 + random.below(3)).collect();
    let offset = board.memory.0.len() as u64;
    board.memory.0.extend(rows(PixFmt::Rgb565, SIDE, &old));
    let group = board.display();
    let data = DmaBlock { offset, ..DmaBlock::default() };
    let size = [SIDE, SIDE];
    record::load_buffer(&mut board.commands, &group, 2, SIDE * 2, size, data).unwrap();
    old
}

/// Texture addresses: masks, clamps and offsets, against the equations.
#[test]
fn texture_addresses() {
    for case in 0..cases(200) {
        let mut random = Random::new(case);
        let mut board = Board::new(config(fillrate_redline::Chip::V2000), (64, 48), false);
        let (width, height) = (random.below(40) + 1, random.below(40) + 1);
        let texels: Vec<u32> = (0..width * height).map(|i| i + 1).collect();
        let (surface, group) = board.texture(width, height, PixFmt::Rgb565, &texels);
        board.bind(&surface, group);
        let commands = &mut board.commands;
        let (u_mask, v_mask) = (random.below(64), random.below(64));
        let (u_clamp, v_clamp) = (random.flag(), random.flag());
        let offset =
            [random.below(8 << 16), random.below(8 << 16)].map(|v| v.wrapping_sub(4 << 16));
        record::set_src_func(commands, 1).unwrap();
        record::set_u_mask(commands, u_mask).unwrap();
        record::set_v_mask(commands, v_mask).unwrap();
        record::set_u_clamp(commands, u_clamp.into()).unwrap();
        record::set_v_clamp(commands, v_clamp.into()).unwrap();
        record::set_u_multiplier(commands, 1 << 16).unwrap();
        record::set_v_multiplier(commands, 1 << 16).unwrap();
        record::set_s_offset(commands, offset[0]).unwrap();
        record::set_t_offset(commands, offset[1]).unwrap();
        // U = 3x - 20, V = 2y - 10 at pixel corners.
        let u = |x: i64| (3 * x - 20) << 16;
        let v = |y: i64| (2 * y - 10) << 16;
        let corner =
            |x: i64, y: i64| [(x << 16) as u32, (y << 16) as u32, u(x) as u32, v(y) as u32];
        let [a, b, c] = [corner(0, 0), corner(48, 0), corner(0, 48)];
        record::triangle(commands, VertexType::XYUV.code(), &a, &b, &c).unwrap();
        board.issue();
        let pixels = board.pixels(1);
        let axis = |at: i64, offset: u32, mask: u32, clamp: bool| {
            let texel = (at + i64::from(offset as i32)) >> 16;
            if clamp { texel.min(mask.into()).max(0) } else { texel & i64::from(mask) }
        };
        for (x, y) in [(0, 0), (5, 7), (20, 20), (1, 40), (40, 1), (13, 3), (9, 30)] {
            let center = |f: &dyn Fn(i64) -> i64, at: i64| (f(at) + f(at + 1)) / 2;
            let s = axis(center(&u, x), offset[0], u_mask, u_clamp);
            let t = axis(center(&v, y), offset[1], v_mask, v_clamp);
            if s < i64::from(width) && t < i64::from(height) {
                let expected = texels[(t * i64::from(width) + s) as usize];
                let found = u32::from(pixels[(y * 64 + x) as usize]);
                assert_eq!(found, expected, "case {case}: ({x}, {y}), texel ({s}, {t})");
            }
        }
    }
}

/// Filtered samples show no trace of the key's colour.
#[test]
fn keys_do_not_bleed() {
    let mut board = Board::new(config(fillrate_redline::Chip::V2000), (64, 48), false);
    let texels: Vec<u32> = (0..64).map(|i| if i % 8 < 3 { 0xf81f } else { 0x07e0 }).collect();
    let (mut surface, group) = board.texture(8, 8, PixFmt::Rgb565, &texels);
    (surface.chromakey, surface.chroma_color, surface.clamp) = (1, 0xf81f, 3);
    board.bind(&surface, group);
    let commands = &mut board.commands;
    record::set_src_func(commands, 1).unwrap();
    record::set_src_filter(commands, 1).unwrap();
    record::set_s_offset(commands, 0xffff_8000).unwrap();
    record::set_t_offset(commands, 0xffff_8000).unwrap();
    record::square(commands, VertexType::XY.code(), 40 << 16, &[20 << 16, 20 << 16]).unwrap();
    board.issue();
    let pixels = board.pixels(1);
    assert!(pixels.iter().all(|p| *p == 0 || p & 0xf81f == 0), "only green");
    // Five pixels a texel: the edge of the key is at 15.
    let row = &pixels[64 * 20..][..40];
    assert!(row[..15].iter().all(|&p| p == 0) && row[16..].iter().all(|&p| p != 0), "{row:x?}");
}
