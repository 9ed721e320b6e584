//! Frames in memory and as files.

use std::io::Cursor;

use fillrate_player::{Frame, FrameError, Pixels, compare};
use proptest::prelude::*;

use crate::{rgb565, rgba};

/// Through a PNG file in memory.
fn through_png(frame: &Frame) -> Frame {
    let mut file = Vec::new();
    frame.write_png(&mut file).expect("memory");
    Frame::read_png(Cursor::new(file)).expect("own file")
}

#[test]
fn size_and_pixels_must_agree() {
    let new = |width, height, bytes| Frame::new(width, height, Pixels::Rgba8(vec![0; bytes]));
    assert!(new(2, 3, 24).is_ok());
    assert!(matches!(new(2, 3, 23), Err(FrameError::Length { needed: 24, found: 23 })));
    assert!(matches!(new(0, 3, 0), Err(FrameError::Size { .. })));
    assert!(matches!(new(u32::MAX, u32::MAX, 4), Err(FrameError::Size { .. })));
}

#[test]
fn short_channels_are_widened_by_their_high_bits() {
    let frame = rgb565(3, 1, vec![0xffff, 0x8401, 0]);
    let expected = [[255; 4], [0x84, 0x82, 0x08, 255], [0, 0, 0, 255]];
    assert_eq!(frame.rgba_pixels().collect::<Vec<_>>(), expected);
    assert_eq!(frame.rgba(1, 0), Some(expected[1]));
    assert_eq!((frame.rgba(3, 0), frame.rgba(0, 1)), (None, None));
}

#[test]
fn hash_is_pinned() {
    // Changing these makes every recorded trace differ.
    let frames = [rgb565(2, 1, vec![0x1234, 0xabcd]), rgba(1, 1, vec![1, 2, 3, 4])];
    let hashes = frames.map(|frame| format!("{:016x}", frame.hash()));
    assert_eq!(hashes, ["a2823357f58126f3", "5d9fa752b0aa2cb0"]);
}

#[test]
fn png_file_replaces_an_older_one() {
    let folder = tempfile::tempdir().expect("temporary folder");
    let path = folder.path().join("frame.png");
    for blue in [1, 2] {
        let frame = rgba(1, 1, vec![0, 0, blue, 4]);
        frame.save_png(&path).expect("written");
        assert_eq!(Frame::load_png(&path).expect("read"), frame);
    }
    let absent = folder.path().join("absent.png");
    assert!(matches!(Frame::load_png(&absent), Err(FrameError::Decode(_))));
}

#[test]
fn grey_png_becomes_rgba() {
    for (color, data) in [
        (png::ColorType::Grayscale, &[7, 9][..]),
        (png::ColorType::GrayscaleAlpha, &[7, 255, 9, 255]),
    ] {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, 2, 1);
        encoder.set_color(color);
        let mut writer = encoder.write_header().expect("memory");
        writer.write_image_data(data).expect("memory");
        writer.finish().expect("memory");
        let frame = Frame::read_png(Cursor::new(file)).expect("valid file");
        assert_eq!(frame, rgba(2, 1, vec![7, 7, 7, 255, 9, 9, 9, 255]));
    }
}

#[test]
fn huge_png_is_refused_before_memory_is_taken() {
    let mut file = Vec::new();
    rgba(1, 1, vec![0; 4]).write_png(&mut file).expect("memory");
    // The header chunk: width and height at byte 16, checksum of its 17 bytes from byte 12.
    file[16..24].copy_from_slice(&[0, 1, 0, 0, 0, 1, 0, 0]);
    let mut checksum = !0u32;
    for byte in &file[12..29] {
        checksum ^= u32::from(*byte);
        for _ in 0..8 {
            checksum = checksum >> 1 ^ if checksum & 1 == 1 { 0xedb8_8320 } else { 0 };
        }
    }
    file[29..33].copy_from_slice(&(!checksum).to_be_bytes());
    assert!(matches!(
        Frame::read_png(Cursor::new(file)),
        Err(FrameError::Size { width: 65536, height: 65536 } | FrameError::Decode(_))
    ));
}

proptest! {
    #[test]
    fn png_keeps_every_pixel(width in 1u32..20, height in 1u32..20, seed: u64) {
        let count = (width * height) as usize;
        let noise = |i: usize| (seed.wrapping_add(i as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 40) as u16;
        let long = rgba(width, height, (0..4 * count).map(|i| noise(i) as u8).collect());
        prop_assert_eq!(&through_png(&long), &long);
        let short = rgb565(width, height, (0..count).map(noise).collect());
        prop_assert!(compare(&short, &through_png(&short)).is_same());
    }

    #[test]
    fn damaged_png_never_panics(place: prop::sample::Index, value: u8) {
        let mut file = Vec::new();
        rgba(4, 4, (0..64).collect()).write_png(&mut file).expect("memory");
        let place = place.index(file.len());
        file[place] = value;
        let _ = Frame::read_png(Cursor::new(file));
    }
}
