//! Bytes that are no call: a clear error, no panic, no large allocation.

use fillrate_call::{Data, DecodeErrorKind, Decoder, MAX_NESTING, Value, from_bytes, to_bytes};
use proptest::prelude::*;

use crate::{Call, corner};

/// The error of decoding a `Call`.
fn error_of(bytes: &[u8]) -> (usize, DecodeErrorKind) {
    let error = from_bytes::<Call>(bytes).expect_err("bytes are no call");
    (error.offset, error.kind)
}

#[test]
fn unknown_tag_names_tag_and_place() {
    let error = from_bytes::<Call>(&[0x39, 5]).expect_err("no such tag");
    assert_eq!(error.to_string(), "byte 0: unknown tag 1337 of Call");
    let batch = [7, 0, 2, 1, 0, 99, 0];
    assert_eq!(error_of(&batch), (5, DecodeErrorKind::UnknownTag { type_name: "Call", tag: 99 }));
}

#[test]
fn every_truncation_is_an_unexpected_end() {
    let bytes = to_bytes(&Call::DrawTriangle { a: corner(1.0), b: corner(2.0), c: corner(3.0) });
    for length in 0..bytes.len() {
        let (offset, kind) = error_of(&bytes[..length]);
        assert!(offset <= length, "{length}");
        assert!(matches!(kind, DecodeErrorKind::UnexpectedEnd { .. }), "{length}: {kind:?}");
    }
}

#[test]
fn trailing_bytes_are_refused() {
    assert_eq!(error_of(&[1, 0, 9, 9]), (2, DecodeErrorKind::TrailingBytes { count: 2 }));
}

#[test]
fn markers_have_two_values() {
    let kind = |expected| DecodeErrorKind::InvalidMarker { expected, value: 2 };
    assert_eq!(error_of(&[4, 0, 0, 0, 0, 0, 2]), (6, kind("truth value")));
    assert_eq!(error_of(&[5, 0, 1, 2]), (3, kind("option")));
    let error = from_bytes::<Data>(&[2, 0]).expect_err("two forms of data");
    assert_eq!(error.kind, kind("form of data"));
}

#[test]
fn announced_length_is_checked_before_anything_is_allocated() {
    let mut bytes = vec![5, 0];
    bytes.extend([255, 255, 255, 255, 255, 255, 255, 255, 255, 1]);
    bytes.extend([0; 100]);
    assert_eq!(error_of(&bytes), (2, DecodeErrorKind::TooLong { length: u64::MAX, left: 100 }));
    let error = from_bytes::<String>(&[4, b'a']).expect_err("one letter of four");
    assert_eq!(error.kind, DecodeErrorKind::TooLong { length: 4, left: 1 });
}

#[test]
fn text_must_be_utf8() {
    let error = from_bytes::<String>(&[2, 0xc3, 0x28]).expect_err("not utf-8");
    assert_eq!((error.offset, error.kind), (0, DecodeErrorKind::InvalidText));
}

#[test]
fn nesting_is_bounded() {
    let mut call = Call::Init {};
    for _ in 0..MAX_NESTING {
        call = Call::Batch { calls: vec![call] };
    }
    assert_eq!(from_bytes(&to_bytes(&call)), Ok(call.clone()));
    let deeper = to_bytes(&Call::Batch { calls: vec![call] });
    assert_eq!(error_of(&deeper).1, DecodeErrorKind::TooDeep);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    /// A value has one encoding: whatever decodes encodes to the bytes that were read.
    #[test]
    fn random_bytes_decode_to_their_encoding_or_fail(
        tag in prop::sample::select(vec![1u16, 2, 3, 4, 5, 600, 65535, 7, 8]),
        tail in prop::collection::vec(prop_oneof![0u8..8, any::<u8>()], 0..120),
    ) {
        let mut bytes = tag.to_le_bytes().to_vec();
        bytes.extend(tail);
        let mut decoder = Decoder::new(&bytes);
        if let Ok(call) = Call::decode(&mut decoder) {
            prop_assert_eq!(&to_bytes(&call)[..], &bytes[..decoder.offset()]);
            let _ = call.to_string();
        }
    }
}
