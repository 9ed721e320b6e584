//! Nonsense: the documented error or nothing, and a board that goes on.
//!
//! `FILLRATE_CASES=n` runs more of the random ones.

use fillrate_redline::{Call, Chip, Reply, Segment, VError, VertexType, VlError, record};

use crate::board::{Board, config};
use crate::random::{Random, cases};

/// The board draws and shows a triangle as if nothing had happened.
fn still_works(board: &mut Board) {
    let group = board.display();
    let surface = fillrate_redline::Surface::new(group.width, group.height, 4);
    let commands = &mut board.commands;
    record::context_init(commands).unwrap();
    record::install_dst_buffer(commands, &surface, &group).unwrap();
    record::fill_buffer(commands, &group, 1, [0, 0], [64, 48], 0).unwrap();
    record::set_fg_color_argb(commands, 0xff00_ff00).unwrap();
    let corner = |x: u32, y: u32| [x << 16, y << 16];
    let [a, b, c] = [corner(4, 4), corner(60, 4), corner(4, 44)];
    record::triangle(commands, VertexType::XY.code(), &a, &b, &c).unwrap();
    board.issue();
    let pixels = board.pixels(1);
    assert_eq!((pixels[64 * 10 + 10], pixels[64 * 46 + 60]), (0x07e0, 0));
}

fn board() -> Board {
    Board::new(config(Chip::V2000), (64, 48), true)
}

#[test]
fn unknown_commands_skip_the_buffer() {
    let mut board = board();
    let (device, buffer) = (board.device, board.buffer);
    // A fill that must not be carried out comes before each.
    let group = board.display();
    let fill = [13, group.addresses[1], group.linebytes, 128, 48, 0xffff_ffff];
    board.issue();
    let type_13 = 13 << 16 | 24;
    let cases: [&[u32]; 12] = [
        &[0],
        &[1],
        &[3],
        &[39, 0, 0, 0, 0],
        &[40],
        &[54, 0],
        &[62],
        &[type_13, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        &[0x1000],
        &[1 << 16 | 24, 0, 0, 0],
        &[1 << 16 | 27, 2, 0, 0, 0, 0],
        &[0x1001, 5],
    ];
    for words in cases {
        let segments = vec![Segment::of(&fill), Segment::of(words)];
        let issue = Call::IssueCmdBuffer { device, buffer, segments, wait: true };
        let failure = board.context.execute(&issue).unwrap_err();
        assert_eq!(failure.number(), VError::VeriteCommandErr.number(), "{words:x?}");
        assert!(board.pixels(1).iter().all(|&p| p == 0), "{words:x?}");
    }
    still_works(&mut board);
}

#[test]
fn specular_commands_need_the_extension() {
    for (chip, works) in [(Chip::V1000, false), (Chip::V2000, true)] {
        let mut board = Board::new(config(chip), (64, 48), true);
        let (device, buffer) = (board.device, board.buffer);
        for words in [vec![34 << 16 | 24; 25], vec![51; 16]] {
            let segments = vec![Segment::of(&words)];
            let issue = Call::IssueCmdBuffer { device, buffer, segments, wait: true };
            assert_eq!(board.context.execute(&issue).is_ok(), works);
        }
    }
}

#[test]
fn things_that_are_gone() {
    let mut board = board();
    board.issue();
    let (device, group, buffer) = (board.device, board.group, board.buffer);
    let mut number = |call: Call| board.context.execute(&call).map_err(|f| f.number());
    let create =
        Call::CreateSurface { device, mask: 0, buffers: 1, format: 4, width: 16, height: 16 };
    let Ok(Reply::Group(texture, bytes)) = number(create) else { panic!("it fits") };
    assert_eq!(bytes, 32 * 16);
    assert!(number(Call::DestroySurface { device, group: texture }).is_ok());
    let gone = Err(VlError::ParamError.number());
    assert_eq!(number(Call::DestroySurface { device, group: texture }), gone);
    let gone = Err(VError::ParamError.number());
    assert_eq!(number(Call::LockBuffer { device, group: texture, buffer: 0 }), gone);
    let outside = Err(VError::InvalidBuffer.number());
    assert_eq!(number(Call::LockBuffer { device, group, buffer: 3 }), outside);
    assert!(number(Call::DestroyCmdBuffer { device, buffer }).is_ok());
    assert_eq!(number(Call::DestroyCmdBuffer { device, buffer }), gone);
    let segments = vec![Segment::of(&[2])];
    assert_eq!(number(Call::IssueCmdBuffer { device, buffer, segments, wait: false }), gone);
    assert!(number(Call::CloseVerite { device }).is_ok());
    assert_eq!(number(Call::CloseVerite { device }), Err(VlError::ParamError.number()));
    assert_eq!(number(Call::SetDisplayType { device, display_type: 1 }), gone);
    assert_eq!(board.context.last_v_error().unwrap().1, VError::ParamError);
    assert_eq!(board.context.last_vl_error().unwrap().1, VlError::ParamError);
}

#[test]
fn surfaces_that_cannot_be() {
    let mut board = board();
    board.issue();
    let device = board.device;
    let mut try_one = |mask: u32, buffers: u32, format: u32, width: u32, height: u32| {
        let create = Call::CreateSurface { device, mask, buffers, format, width, height };
        board.context.execute(&create).map_err(|failure| {
            let codes: Vec<i32> = failure.faults().map(|fault| fault.error()).collect();
            codes
        })
    };
    assert_eq!(try_one(0, 1, 4, 65, 8), Err(vec![501, 601]), "wider than the primary surface");
    assert_eq!(try_one(2, 1, 4, 64, 48), Err(vec![501, 601]), "a second primary surface");
    assert_eq!(try_one(0, 1, 7, 16, 16), Err(vec![550, 603]), "no format");
    assert_eq!(try_one(0, 0, 4, 16, 16), Err(vec![501, 601]), "no buffers");
    assert_eq!(try_one(0, 1, 4, 0, 16), Err(vec![501, 601]), "no columns");
    assert_eq!(try_one(0, 1, 4, 64, 65_535), Err(vec![561, 633]), "too much memory");
    assert_eq!(try_one(0, 1, 4, 64, 65_536), Err(vec![501, 601]), "rows beyond the scissor");
    assert_eq!(try_one(0, 1, 4, 64, u32::MAX), Err(vec![501, 601]), "too many rows");
    assert!(try_one(0, 1, 12, 64, 8).is_ok());
    still_works(&mut board);
}

#[test]
fn random_words_do_no_harm() {
    for case in 0..cases(300) {
        let mut random = Random::new(case);
        let mut board = board();
        board.issue();
        let (device, buffer) = (board.device, board.buffer);
        let mut words: Vec<u32> = Vec::new();
        for _ in 0..random.below(40) + 1 {
            nonsense(&mut random, &mut words);
        }
        let segments = vec![Segment::of(&words)];
        let issue = Call::IssueCmdBuffer { device, buffer, segments, wait: true };
        // An error skips the buffer; anything else has been drawn.
        let _ = board.context.execute(&issue);
        if case % 16 == 0 {
            still_works(&mut board);
        }
    }
}

/// A command of known shape and arbitrary values.
fn nonsense(random: &mut Random, words: &mut Vec<u32>) {
    use fillrate_redline::{Opcode, Register};
    let wild = |random: &mut Random| match random.below(4) {
        0 => random.word(),
        1 => random.below(64 << 16),
        2 => random.below(256),
        _ => random.pick(&[0, u32::MAX, 0x8000_0000, 0x7fff_ffff, 1 << 16]),
    };
    let many = |random: &mut Random, words: &mut Vec<u32>, count: usize| {
        words.extend((0..count).map(|_| wild(random)));
    };
    match random.below(10) {
        0..=3 => {
            let register = random.pick(Register::ALL);
            let mask = if random.below(8) == 0 { random.word() & 0xffff_0000 } else { 0 };
            words.push(mask | register.word());
            many(random, words, 1);
        }
        4..=6 => {
            let vertex = random.pick(VertexType::ALL);
            let (opcode, head, vertices) = random.pick(&[
                (24, 0, 3),
                (16, 0, 2),
                (20, 0, 2),
                (25, 0, 2),
                (21, 0, 2),
                (15, 0, 1),
                (22, 1, 1),
                (23, 2, 1),
            ]);
            words.push(vertex.code() << 16 | opcode);
            many(random, words, head + vertices * vertex.words());
        }
        7 => {
            let (opcode, count) = random.pick(&[
                (Opcode::Bitblt, 3),
                (Opcode::Bitfill, 2),
                (Opcode::MemClearRect, 5),
                (Opcode::IntLine, 2),
                (Opcode::TriFill, 6),
                (Opcode::Affine, 10),
                (Opcode::FtriKxyz, 12),
                (Opcode::FtriKxyzuvq, 21),
                (Opcode::Display, 1),
                (Opcode::StereoDisplay, 2),
            ]);
            words.push(opcode as u32);
            many(random, words, count);
        }
        8 => {
            let [width, height] = [random.below(20), random.below(9)];
            let at = random.word() & 0x7f_007f;
            words.extend([42, at, width << 16 | height]);
            many(random, words, (width.div_ceil(4) * height) as usize);
            words.extend([41, at, width << 16 | height, random.pick(&[0, 1, 2, 3, 4])]);
            many(random, words, (width * height) as usize);
            words.extend([29, at, width << 16 | height]);
            many(random, words, 2 + 2 * (width * height) as usize);
        }
        _ => {
            words.push(0x4000);
            many(random, words, 5);
            words.push(0x7020);
            many(random, words, 8);
            words.extend([14, random.below(1 << 23), 4, random.below(1 << 16) << 16 | 6, 1, 2, 0]);
        }
    }
}

/// Streams that a program cut anywhere.
#[test]
fn cut_streams_are_refused_or_drawn() {
    let mut board = board();
    board.issue();
    let mut words = Vec::new();
    let mut random = Random::new(1);
    while words.len() < 200 {
        nonsense(&mut random, &mut words);
    }
    let (device, buffer) = (board.device, board.buffer);
    for end in 0..words.len() {
        let segments = vec![Segment::of(&words[..end])];
        let issue = Call::IssueCmdBuffer { device, buffer, segments, wait: true };
        let _ = board.context.execute(&issue);
    }
    still_works(&mut board);
}
