//! Video memory, buffer groups, display modes, command buffers.

use fillrate_redline::surface::{INTERLEAVED, PRIMARY, Z_BUFFER};
use fillrate_redline::{
    Call, Chip, Context, DmaBlock, MemoryObjects, PixFmt, Port, Rect, RedlineConfig, Reply, Ring,
    Segment, Surface, VError, VlError, lock, record,
};

use crate::board::{Board, config};

fn open(config: RedlineConfig) -> (Context, u32) {
    let mut context = Context::new(config);
    let device = context.execute(&Call::OpenVerite {}).unwrap().number();
    (context, device)
}

fn surface(
    context: &mut Context,
    device: u32,
    mask: u32,
    buffers: u32,
    size: (u32, u32),
) -> Option<u32> {
    let (width, height) = size;
    let create = Call::CreateSurface { device, mask, buffers, format: 4, width, height };
    match context.execute(&create) {
        Ok(Reply::Group(group, _)) => Some(group),
        _ => None,
    }
}

/// The guide's worked values of free memory.
#[test]
fn free_memory_is_the_documented_one() {
    let (mut context, device) = open(config(Chip::V1000));
    surface(&mut context, device, PRIMARY | Z_BUFFER, 3, (640, 480)).unwrap();
    assert_eq!(context.free_memory(device), Some(1232 << 10));
    let (mut context, device) = open(config(Chip::V1000));
    context.execute(&Call::SetDisplayType { device, display_type: 2 }).unwrap();
    surface(&mut context, device, PRIMARY, 2, (640, 480)).unwrap();
    assert_eq!(context.free_memory(device), Some(2768 << 10));
    let eight = RedlineConfig { memory: 8, ..config(Chip::V1000) };
    let (context, device) = open(eight);
    assert_eq!(context.free_memory(device), Some((8192 - 128 - 1536) << 10));
}

/// The guide's search for how much memory is free: it finds the same again.
#[test]
fn allocation_probing_restores_everything() {
    let (mut context, device) = open(config(Chip::V2000));
    context.execute(&Call::SetDisplayType { device, display_type: 2 }).unwrap();
    surface(&mut context, device, PRIMARY, 2, (640, 480)).unwrap();
    let mut probe = || {
        let (mut low, mut high) = (0, 1 << 14);
        while high - low > 1 {
            let height = (low + high) / 2;
            let create = Call::CreateBufferGroup {
                device,
                mask: 0,
                buffers: 1,
                format: 4,
                width: 256,
                height,
            };
            match context.execute(&create) {
                Ok(reply) => {
                    let group = reply.number();
                    context.execute(&Call::DestroyBufferGroup { device, group }).unwrap();
                    low = height;
                }
                Err(failure) => {
                    assert_eq!(failure.number(), VError::OutOfVideoMemory.number());
                    high = height;
                }
            }
        }
        low * 512
    };
    let first = probe();
    assert_eq!(first, 2768 << 10);
    assert_eq!(probe(), first);
}

#[test]
fn interleaved_buffers_share_their_rows() {
    let (mut context, device) = open(config(Chip::V1000));
    context.execute(&Call::SetDisplayType { device, display_type: 2 }).unwrap();
    let mask = PRIMARY | Z_BUFFER | INTERLEAVED;
    let group = surface(&mut context, device, mask, 3, (320, 240)).unwrap();
    let group = context.group(device, group).unwrap().clone();
    assert_eq!((group.mask, group.linebytes), (mask, 2048));
    assert_eq!(group.addresses[1] - group.addresses[0], 640);
    // In a window it is never granted, nor where three rows are too long.
    let (mut windowed, device) = open(config(Chip::V1000));
    let group = surface(&mut windowed, device, mask, 3, (320, 240)).unwrap();
    assert_eq!(windowed.group(device, group).unwrap().mask & INTERLEAVED, 0);
}

/// Drawing into interleaved buffers touches no other one.
#[test]
fn interleaved_buffers_keep_apart() {
    let mut context = Context::new(config(Chip::V1000));
    let device = context.execute(&Call::OpenVerite {}).unwrap().number();
    context.execute(&Call::SetDisplayType { device, display_type: 2 }).unwrap();
    let mask = PRIMARY | Z_BUFFER | INTERLEAVED;
    let number = surface(&mut context, device, mask, 3, (64, 48)).unwrap();
    let group = context.group(device, number).unwrap().clone();
    let create = Call::CreateCmdBuffer { device, entries: 0, words: 512 };
    let buffer = context.execute(&create).unwrap().number();
    let mut commands = fillrate_redline::CommandBuffer::new(buffer, 0, 512).unwrap();
    record::install_dst_buffer(&mut commands, &Surface::new(64, 48, 4), &group).unwrap();
    record::install_z_buffer(&mut commands, &group).unwrap();
    for (buffer, value) in [(0, 0x1111), (1, 0x2222), (2, 0x3333)] {
        record::fill_buffer(&mut commands, &group, buffer, [0, 0], [64, 48], value).unwrap();
    }
    record::set_z_buf_wr_mode(&mut commands, 1).unwrap();
    record::set_z(&mut commands, 77 << 16).unwrap();
    record::set_fg_color_argb(&mut commands, 0xffff_0000).unwrap();
    record::square(&mut commands, 1, 200 << 16, &[32 << 16, 24 << 16]).unwrap();
    let segments = commands.snapshot(&fillrate_redline::NoMemory).unwrap();
    context.execute(&Call::IssueCmdBuffer { device, buffer, segments, wait: true }).unwrap();
    for (buffer, value) in [(0, 0x1111u16), (1, 0xf800), (2, 77)] {
        let (width, height) = (64, 48);
        let read = Call::ReadBuffer { device, group: number, buffer, x: 0, y: 0, width, height };
        let bytes = context.execute(&read).unwrap().into_bytes();
        assert!(bytes.chunks(2).all(|two| two == value.to_le_bytes()), "buffer {buffer}");
    }
}

#[test]
fn locks_bring_back_what_changed() {
    let mut board = Board::new(config(Chip::V2000), (64, 48), false);
    board.issue();
    let (device, group) = (board.device, board.group);
    let lock = Call::LockBuffer { device, group, buffer: 1 };
    let before = board.context.execute(&lock).unwrap().into_bytes();
    let pitch = board.display().linebytes as usize;
    let mut after = before.clone();
    after[pitch * 3 + 10..pitch * 3 + 12].copy_from_slice(&0xabcdu16.to_le_bytes());
    // Drawn while it is locked, and kept.
    record::fill_buffer(
        &mut board.commands,
        &board.context.group(device, group).unwrap().clone(),
        1,
        [0, 0],
        [4, 4],
        0x1234,
    )
    .unwrap();
    board.issue();
    let changes = lock::changes(&before, &after);
    board.context.execute(&Call::UnlockBuffer { device, group, buffer: 1, changes }).unwrap();
    let pixels = board.pixels(1);
    assert_eq!((pixels[64 * 3 + 5], pixels[64 * 3 + 3], pixels[64 * 3 + 6]), (0xabcd, 0x1234, 0));
}

#[test]
fn windows_clip_and_stretch() {
    let (mut context, device) = open(config(Chip::V2000));
    let number = surface(&mut context, device, PRIMARY, 2, (64, 48)).unwrap();
    let group = context.group(device, number).unwrap().clone();
    let create = Call::CreateCmdBuffer { device, entries: 0, words: 64 };
    let buffer = context.execute(&create).unwrap().number();
    let mut words = Vec::new();
    // The left half 1, the right half 2.
    for (x, value) in [(0, 0x1_0001), (32, 0x2_0002)] {
        words.extend([13, group.addresses[1] + x * 2, group.linebytes, 64, 48, value]);
    }
    let segments = vec![Segment::of(&words)];
    context.execute(&Call::IssueCmdBuffer { device, buffer, segments, wait: false }).unwrap();
    let window = Rect { left: 10, top: 20, right: 74, bottom: 68 };
    context.execute(&Call::SetWindow { device, window: Some(window) }).unwrap();
    // Twice as large, half of it left of the window.
    let dst = Some(Rect { left: -54, top: 20, right: 74, bottom: 116 });
    let blit = Call::BltDisplayBuffer {
        device,
        dst_group: number,
        dst_buffer: 0,
        dst,
        src_group: number,
        src_buffer: 1,
        src: None,
    };
    context.execute(&blit).unwrap();
    let shown = context.shown().unwrap();
    assert_eq!((shown.width, shown.height), (64, 48));
    assert!(shown.pixels.iter().all(|&p| p == 2), "the right half fills the window");
    let outside = Some(Rect { left: 0, top: 0, right: 65, bottom: 48 });
    let bad = Call::BltDisplayBuffer {
        device,
        dst_group: number,
        dst_buffer: 0,
        dst: None,
        src_group: number,
        src_buffer: 1,
        src: outside,
    };
    assert_eq!(context.execute(&bad).unwrap_err().number(), VError::ParamError.number());
}

#[test]
fn lost_buffers_are_restored() {
    let mut board = Board::new(config(Chip::V2000), (64, 48), true);
    let (texture, number) = board.texture(8, 8, PixFmt::Rgb565, &[7; 64]);
    board.issue();
    let (device, group) = (board.device, board.group);
    let free = board.context.free_memory(device);
    board.context.execute(&Call::LoseBuffers { device }).unwrap();
    assert!(board.context.group(device, number).unwrap().lost);
    let lock = Call::LockBuffer { device, group: number, buffer: 0 };
    assert_eq!(board.context.execute(&lock).unwrap_err().number(), VError::DdIsLost.number());
    for group in [group, number] {
        board.context.execute(&Call::RestoreSurface { device, group }).unwrap();
    }
    assert_eq!(board.context.free_memory(device), free);
    assert!(board.context.execute(&lock).is_ok());
    board.bind(&texture, number);
    board.issue();
}

/// A switch of the display type frees or takes the desktop.
#[test]
fn display_types_change_places() {
    let (mut context, device) = open(config(Chip::V2000));
    let windowed = context.free_memory(device).unwrap();
    let group = surface(&mut context, device, PRIMARY, 2, (640, 480)).unwrap();
    let texture = surface(&mut context, device, 0, 1, (64, 64)).unwrap();
    let mode = Call::SetDisplayMode { device, width: 640, height: 480, bits: 16, refresh: 60 };
    let error = context.execute(&mode).unwrap_err().number();
    assert_eq!(error, VError::FullScreenModeOnly.number());
    context.execute(&Call::DestroySurface { device, group }).unwrap();
    context.execute(&Call::SetDisplayType { device, display_type: 2 }).unwrap();
    context.execute(&mode).unwrap();
    assert!(surface(&mut context, device, PRIMARY, 2, (320, 240)).is_none(), "not the mode's size");
    let group = surface(&mut context, device, PRIMARY, 2, (640, 480)).unwrap();
    assert_eq!(
        context.free_memory(device),
        Some(windowed + (1536 << 10) - (1200 << 10) - 64 * 128)
    );
    context.execute(&Call::DestroySurface { device, group }).unwrap();
    context.execute(&Call::SetDisplayType { device, display_type: 1 }).unwrap();
    assert!(!context.group(device, texture).unwrap().lost, "textures stay where they are");
    assert_eq!(context.free_memory(device), Some(windowed - 64 * 128));
}

/// Buffers of a ring are in use until they are done, in order.
#[test]
fn rings_of_command_buffers() {
    let mut settings = config(Chip::V2000);
    settings.background = true;
    let mut board = Board::new(settings, (640, 480), false);
    let group = board.display();
    board.issue();
    let device = board.device;
    let create = Call::CreateCmdBuffer { device, entries: 0, words: 64 };
    let ring: Vec<u32> = (0..4).map(|_| board.context.execute(&create).unwrap().number()).collect();
    for step in 0..200u32 {
        let buffer = ring[step as usize % ring.len()];
        let value = step * 0x1_0001;
        let words = [13, group.addresses[1] + step * 2, 0, 2, 1, value];
        let segments = vec![Segment::of(&words)];
        board
            .context
            .execute(&Call::IssueCmdBuffer { device, buffer, segments, wait: false })
            .unwrap();
        let next = ring[(step as usize + 1) % ring.len()];
        board.context.wait(device, next);
        let query = Call::QueryCmdBuffer { device, buffer: next };
        assert_eq!(board.context.execute(&query).unwrap(), Reply::Number(0));
    }
    let pixels = board.pixels(1);
    assert!((0..200u16).all(|i| pixels[usize::from(i)] == i));
}

/// A ring of small buffers draws what one large buffer draws.
#[test]
fn rings_issue_what_does_not_fit() {
    let mut board =
        Board::new(RedlineConfig { background: true, ..config(Chip::V2000) }, (64, 48), false);
    board.issue();
    let group = board.display();
    let Board { context, device, group: number, .. } = board;
    let memory = MemoryObjects::default();
    let mut ring = Ring::new(context, device, memory, 3, 4, 40).unwrap();
    let object = ring.memory.alloc_locked(8).unwrap();
    ring.memory.bytes(object).unwrap().copy_from_slice(&[1, 0, 2, 0, 3, 0, 4, 0]);
    for x in 0..48 {
        record::fill_buffer(&mut ring, &group, 1, [x, x], [1, 1], 7).unwrap();
        let data = ring.memory.block(object, Port::Word).unwrap();
        record::mem_write(&mut ring, group.addresses[1] + x * 128 + 112, data, 4, 4).unwrap();
    }
    let too_long = record::int_polyline(&mut ring, true, 60, &[0; 61]).unwrap_err();
    assert_eq!(too_long.number(), VlError::AddToCmdListFailed.number());
    ring.issue().unwrap();
    let read =
        Call::ReadBuffer { device, group: number, buffer: 1, x: 0, y: 0, width: 64, height: 48 };
    let bytes = ring.context.execute(&read).unwrap().into_bytes();
    for y in 0..48usize {
        let pixel = |x: usize| bytes[(y * 64 + x) * 2];
        assert_eq!(pixel(y), 7);
        assert_eq!([56, 57, 58, 59].map(pixel), [1, 2, 3, 4]);
    }
    ring.memory.free(object).unwrap();
    let gone = DmaBlock { memory: object, ..DmaBlock::default() };
    record::mem_write(&mut ring, group.addresses[1], gone, 4, 2).unwrap();
    assert_eq!(ring.issue().unwrap_err().number(), VError::ParamError.number());
    record::fill_buffer(&mut ring, &group, 1, [0, 0], [1, 1], 9).unwrap();
    ring.issue().unwrap();
    assert_eq!(ring.context.execute(&read).unwrap().into_bytes()[0], 9);
}
