//! Differences between frames.

use fillrate_player::{Comparison, FrameError, compare, difference_image};
use proptest::prelude::*;

use crate::{rgb565, rgba};

#[test]
fn equal_frames_are_the_same() {
    let frame = rgba(2, 1, vec![1, 2, 3, 4, 5, 6, 7, 8]);
    assert!(compare(&frame, &frame.clone()).is_same());
    let image = difference_image(&frame, &frame).expect("same size");
    assert_eq!(image, rgba(2, 1, vec![0, 0, 0, 255, 0, 0, 0, 255]));
}

#[test]
fn first_count_and_largest_are_found() {
    let expected = rgba(2, 2, vec![10; 16]);
    let mut bytes = vec![10; 16];
    (bytes[6], bytes[8], bytes[9]) = (13, 0, 30);
    let comparison = compare(&expected, &rgba(2, 2, bytes));
    let Comparison::Pixels(difference) = comparison else { panic!("{comparison:?}") };
    assert_eq!((difference.first, difference.count, difference.max_channel), ((1, 0), 2, 20));
    assert_eq!((difference.expected, difference.actual), ([10; 4], [10, 10, 13, 10]));
    let text = "first pixel (1, 0): [10, 10, 13, 10], expected [10, 10, 10, 10]; \
                2 pixels, largest difference 20";
    assert_eq!(comparison.to_string(), text);
}

#[test]
fn sizes_are_compared_first() {
    let (wide, high) = (rgba(2, 1, vec![0; 8]), rgba(1, 2, vec![0; 8]));
    let comparison = compare(&wide, &high);
    assert_eq!(comparison, Comparison::Sizes { expected: (2, 1), actual: (1, 2) });
    assert_eq!(comparison.to_string(), "size 1 x 2, expected 2 x 1");
    assert!(matches!(difference_image(&wide, &high), Err(FrameError::SizesDiffer { .. })));
}

#[test]
fn formats_are_compared_by_their_colors() {
    let short = rgb565(2, 1, vec![0xffff, 0x0010]);
    let long = rgba(2, 1, vec![255, 255, 255, 255, 0, 0, 132, 255]);
    assert!(compare(&short, &long).is_same());
    assert_ne!(short.hash(), long.hash(), "a hash covers the format");
}

#[test]
fn difference_image_shows_faint_and_alpha_differences() {
    let expected = rgba(4, 1, vec![0; 16]);
    let actual = rgba(4, 1, vec![1, 0, 0, 0, 0, 200, 0, 0, 0, 0, 0, 100, 0, 0, 0, 0]);
    let image = difference_image(&expected, &actual).expect("same size");
    let pixels: Vec<_> = image.rgba_pixels().collect();
    let grey = [127, 127, 127, 255];
    assert_eq!(pixels, [[64, 0, 0, 255], [0, 255, 0, 255], grey, [0, 0, 0, 255]]);
}

proptest! {
    #[test]
    fn count_is_of_unequal_pixels(words in prop::collection::vec((0u16..3, 0u16..3), 1..60)) {
        let (a, b): (Vec<_>, Vec<_>) = words.iter().copied().unzip();
        let unequal = words.iter().filter(|(a, b)| a != b).count() as u64;
        let size = words.len() as u32;
        let count = match compare(&rgb565(size, 1, a), &rgb565(size, 1, b)) {
            Comparison::Pixels(difference) => difference.count,
            _ => 0,
        };
        prop_assert_eq!(count, unequal);
    }
}
