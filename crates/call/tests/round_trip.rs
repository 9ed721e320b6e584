//! What is written is read back, bit for bit.

use std::collections::HashMap;

use fillrate_call::{
    BLOB_THRESHOLD, BlobId, Data, DecodeErrorKind, Decoder, Encoder, Value, from_bytes, to_bytes,
};
use proptest::prelude::*;

use crate::{Call, Compare, Corner, corner};

/// Asserts that decoding the encoding of `value` gives its encoding again.
fn assert_round_trip<T: Value>(value: &T) {
    let bytes = to_bytes(value);
    let back: T = from_bytes(&bytes).expect("own encoding decodes");
    assert_eq!(to_bytes(&back), bytes);
}

#[test]
fn call_layout_is_tag_then_fields() {
    let call = Call::DepthFunction { function: Compare::ALWAYS, mask: true };
    assert_eq!(to_bytes(&call), [4, 0, 7, 0, 0, 0, 1]);
    let call = Call::Download {
        address: 0x0102_0304,
        image: Data::from(&[9u8, 8][..]),
        table: vec![5],
        note: "hé".into(),
    };
    let expected = [0x58, 2, 4, 3, 2, 1, 0, 2, 9, 8, 1, 5, 3, b'h', 0xc3, 0xa9];
    assert_eq!(to_bytes(&call), expected);
    assert_eq!(from_bytes(&expected), Ok(call));
}

#[test]
fn arrays_and_lists_differ_by_the_length() {
    assert_eq!(to_bytes(&[1u16, 2]), [1, 0, 2, 0]);
    assert_eq!(to_bytes(&vec![1u16, 2]), [2, 1, 0, 2, 0]);
    assert_eq!(to_bytes(&vec![Some(1u8), None]), [2, 1, 1, 0]);
}

#[test]
fn varints_are_shortest() {
    for (value, expected) in [
        (0, &[0][..]),
        (127, &[127]),
        (128, &[0x80, 1]),
        (300, &[0xac, 2]),
        (u64::MAX, &[255, 255, 255, 255, 255, 255, 255, 255, 255, 1]),
    ] {
        let mut encoder = Encoder::new();
        encoder.varint(value);
        assert_eq!(encoder.bytes(), expected);
        assert_eq!(Decoder::new(expected).varint(), Ok(value));
    }
    for malformed in [&[0x80, 0][..], &[255; 10], &[255; 11]] {
        let error = Decoder::new(malformed).varint().expect_err("not shortest");
        assert_eq!((error.offset, error.kind), (0, DecodeErrorKind::MalformedVarint));
    }
}

#[test]
fn float_bits_survive() {
    for bits in [0, 0x8000_0000, 1, 0x7f80_0000, 0x7f80_0001, 0x7fc0_1234, 0xffff_ffff] {
        let back: f32 = from_bytes(&to_bytes(&f32::from_bits(bits))).expect("four bytes");
        assert_eq!(back.to_bits(), bits);
    }
}

#[test]
fn large_data_is_set_aside_and_found_again() {
    let image = Data::from(vec![7; BLOB_THRESHOLD]);
    let small = Data::from(vec![7; BLOB_THRESHOLD - 1]);
    let mut encoder = Encoder::with_blobs();
    encoder.data(&image);
    encoder.data(&small);
    assert_eq!(encoder.bytes().len(), 17 + 3 + BLOB_THRESHOLD - 1);
    let blobs: HashMap<_, _> = encoder.drain_blobs().collect();
    assert_eq!(blobs.keys().collect::<Vec<_>>(), [&BlobId::of(&image)]);
    let mut decoder = Decoder::with_blobs(encoder.bytes(), &blobs);
    assert_eq!(decoder.data(), Ok(image.clone()));
    assert_eq!(decoder.data(), Ok(small));
    assert_eq!(decoder.finish(), Ok(()));

    let error = Decoder::new(encoder.bytes()).data().expect_err("no blobs given");
    assert_eq!(error.kind, DecodeErrorKind::MissingBlob { id: image.id() });
}

#[test]
fn cleared_encoder_starts_over() {
    let mut encoder = Encoder::with_blobs();
    encoder.data(&Data::from(vec![1; BLOB_THRESHOLD]));
    encoder.clear();
    assert!(encoder.bytes().is_empty());
    assert_eq!(encoder.drain_blobs().count(), 0);
}

#[test]
fn blob_id_is_xxh3_least_significant_byte_first() {
    // The published XXH3 128-bit value of no bytes with seed 0.
    let empty = BlobId::of(&[]);
    assert_eq!(empty.to_string(), "99aa06d3014798d86001c324468d497f");
    assert_eq!(empty.to_bytes()[0], 0x7f);
    assert_eq!(BlobId::from_bytes(empty.to_bytes()), empty);
}

/// Any bit pattern, not only numbers.
fn any_float() -> impl Strategy<Value = f32> {
    any::<u32>().prop_map(f32::from_bits)
}

fn any_corner() -> impl Strategy<Value = Corner> {
    (any_float(), any_float(), prop::array::uniform6(any_float())).prop_map(|(x, y, t)| Corner {
        x,
        y,
        tmu: [[t[0], t[1], t[2]], [t[3], t[4], t[5]]],
    })
}

/// Any call that holds no other calls.
fn any_call() -> impl Strategy<Value = Call> {
    let bytes = || prop::collection::vec(any::<u8>(), 0..300);
    prop_oneof![
        Just(Call::Init {}),
        (any_corner(), any_corner(), any_corner()).prop_map(|(a, b, c)| Call::DrawTriangle {
            a,
            b,
            c
        }),
        (any::<u32>(), any::<bool>())
            .prop_map(|(function, mask)| Call::DepthFunction { function: Compare(function), mask }),
        prop::collection::vec(prop::option::of(any_corner()), 0..20)
            .prop_map(|corners| Call::DrawPolygon { corners }),
        (any::<u32>(), bytes(), bytes(), ".*").prop_map(|(address, image, table, note)| {
            Call::Download { address, image: Data::from(image), table, note }
        }),
        (any::<[u64; 4]>(), any::<f64>()).prop_map(|(n, f)| Call::Wide {
            a: n[0] as i8,
            b: n[1] as i16,
            c: n[2] as i32,
            d: n[3] as i64,
            e: n[0],
            f
        }),
    ]
}

proptest! {
    #[test]
    fn calls_round_trip(calls in prop::collection::vec(any_call(), 0..10)) {
        assert_round_trip(&Call::Batch { calls });
    }

    #[test]
    fn varints_round_trip(value: u64, shift in 0u32..64) {
        let mut encoder = Encoder::new();
        encoder.varint(value >> shift);
        let mut decoder = Decoder::new(encoder.bytes());
        prop_assert_eq!(decoder.varint(), Ok(value >> shift));
        prop_assert_eq!(decoder.finish(), Ok(()));
    }
}

#[test]
fn triangle_round_trips_exactly() {
    let call = Call::DrawTriangle { a: corner(0.1), b: corner(-2.0), c: corner(f32::MIN) };
    assert_eq!(to_bytes(&call).len(), 2 + 3 * 8 * 4);
    assert_eq!(from_bytes(&to_bytes(&call)), Ok(call));
}
