//! Files that are not what was written: no panic, no false event, a clear error.

use fillrate_call::DecodeErrorKind;
use fillrate_trace::{BlobId, Damage, Event, TraceError};
use proptest::prelude::*;

use crate::forge::{FILE_HEADER, chunk, chunk_of, file, header};
use crate::{read, read_all, sample};

/// The damage in a file whose first chunk is damaged.
fn damage_of(chunk: Vec<u8>) -> Damage {
    match read(&file(&[chunk])) {
        (events, Some(TraceError::Format { offset: 16, damage })) if events.is_empty() => damage,
        other => panic!("{other:?}"),
    }
}

#[test]
fn every_flipped_bit_is_noticed() {
    let file = sample();
    let complete = read_all(&file);
    for bit in FILE_HEADER * 8..file.len() * 8 {
        let mut damaged = file.clone();
        damaged[bit / 8] ^= 1 << (bit % 8);
        let (events, error) = read(&damaged);
        // A length that grew beyond the end of the file looks like a cut; all else is an error.
        let cut = matches!(events.last(), Some(Event::End(ending)) if ending.is_truncated());
        assert!(error.is_some() || cut, "bit {bit}");
        let sound = events.len() - usize::from(cut);
        assert_eq!(events[..sound], complete[..sound], "bit {bit}");
    }
}

#[test]
fn checksum_error_tells_where() {
    let mut damaged = sample();
    let last = damaged.len() - 1;
    damaged[last] ^= 1;
    let (events, error) = read(&damaged);
    assert_eq!(events.len(), 10);
    let error = error.expect("damage").to_string();
    let start = format!("byte {}: damaged trace: checksum is 0x", damaged.len() - 44);
    assert!(error.starts_with(&start), "{error}");
}

#[test]
fn lengths_are_checked_before_memory_is_taken() {
    let huge = chunk_of(b"CALL", 1, &[0; 10], u32::MAX);
    let (_, error) = read(&file(&[huge]));
    assert!(matches!(error, Some(TraceError::Limit { what: "chunk", size: 0xffff_ffff, .. })));
    // Within the limit, but beyond what ten bytes of LZ4 can hold.
    let damage = damage_of(chunk_of(b"CALL", 1, &[0; 10], 64 << 20));
    assert_eq!(damage, Damage::Lengths { stored: 10, raw: 64 << 20 });
    let damage = damage_of(chunk_of(b"CALL", 0, &[0; 10], 11));
    assert_eq!(damage, Damage::Lengths { stored: 10, raw: 11 });
    let damage = damage_of(chunk_of(b"CALL", 1, &[0; 10], 10));
    assert_eq!(damage, Damage::Lengths { stored: 10, raw: 10 });
}

#[test]
fn compression_must_yield_the_announced_length() {
    // One literal, then 89 times the byte before, then ten literals: a hundred bytes.
    let mut block = vec![0x1f, b'a', 1, 0, 70, 0xa0];
    block.extend([0; 10]);
    assert!(matches!(read(&file(&[chunk_of(b"junk", 1, &block, 100)])), (_, None)));
    for wrong in [99, 101] {
        assert_eq!(damage_of(chunk_of(b"CALL", 1, &block, wrong)), Damage::Compression);
    }
    block[2] = 2;
    assert_eq!(damage_of(chunk_of(b"CALL", 1, &block, 100)), Damage::Compression);
    assert_eq!(damage_of(chunk_of(b"CALL", 1, &block[..1], 2)), Damage::Compression);
}

#[test]
fn blob_is_what_its_name_says() {
    let named = BlobId::of(b"that");
    let payload = [&named.to_bytes()[..], b"this"].concat();
    let damage = damage_of(chunk(b"BLOB", &payload));
    assert_eq!(damage, Damage::BlobId { named, actual: BlobId::of(b"this") });
}

#[test]
fn contents_are_checked() {
    let kind_of = |tag, payload: &[u8]| match damage_of(chunk(tag, payload)) {
        Damage::Content(error) => (error.offset, error.kind),
        other => panic!("{other:?}"),
    };
    let too_long = DecodeErrorKind::TooLong { length: 5, left: 1 };
    assert_eq!(kind_of(b"CALL", &[1, 9, 5, 9]), (2, too_long));
    assert_eq!(kind_of(b"META", &[1, b'k', 1, 0xff]), (2, DecodeErrorKind::InvalidText));
    let end = |left, needed| DecodeErrorKind::UnexpectedEnd { needed, left };
    assert_eq!(kind_of(b"FRAM", &[0; 23]), (16, end(7, 8)));
    assert_eq!(kind_of(b"BLOB", &[0; 15]), (0, end(15, 16)));
    assert_eq!(kind_of(b"END ", &[0; 8]), (8, end(0, 8)));
}

#[test]
fn end_must_count_what_was_there() {
    let mut counts = [0; 24];
    assert_eq!(read_all(&file(&[chunk(b"END ", &counts)])).len(), 1);
    counts[8] = 1;
    assert_eq!(damage_of(chunk(b"END ", &counts)), Damage::Counts);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn damaged_samples_never_panic(
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
        keep in any::<prop::sample::Index>(),
    ) {
        let mut bytes = sample();
        for (place, value) in edits {
            let place = place.index(bytes.len());
            bytes[place] = value;
        }
        let _ = read(&bytes[..=keep.index(bytes.len())]);
    }

    /// Payloads that pass the checksum reach the parsers and the decompressor.
    #[test]
    fn forged_chunks_never_panic(
        chunks in prop::collection::vec(
            (0usize..6, 0u32..3, prop::collection::vec(prop_oneof![0u8..4, any::<u8>()], 0..80),
             0u32..400), 0..6),
    ) {
        let tags = [b"META", b"CALL", b"BLOB", b"FRAM", b"END ", b"NEW!"];
        let mut bytes = header(1, 0, 0);
        for (tag, flags, stored, raw_len) in chunks {
            let raw_len = if flags == 1 { raw_len } else { stored.len() as u32 };
            bytes.extend(chunk_of(tags[tag], flags, &stored, raw_len));
        }
        let _ = read(&bytes);
    }

    #[test]
    fn random_bytes_never_panic(tail in prop::collection::vec(any::<u8>(), 0..200)) {
        let _ = read(&tail);
        let _ = read(&[header(1, 0, 0), tail].concat());
    }
}
