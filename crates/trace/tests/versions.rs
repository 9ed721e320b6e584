//! What readers do with files of other versions.

use fillrate_trace::{Event, TraceError, TraceReader, VERSION, Version};

use crate::forge::{FILE_HEADER, chunk, chunk_of, file, header};
use crate::{read, read_all, sample};

#[test]
fn writer_states_the_current_version() {
    let file = sample();
    assert_eq!(file[..FILE_HEADER], header(VERSION.major, VERSION.minor, 0));
    assert_eq!(TraceReader::new(&file[..]).expect("header").version(), VERSION);
    assert_eq!(VERSION.to_string(), "1.0");
}

#[test]
fn other_major_version_is_refused() {
    for major in [0, 2, u16::MAX] {
        let (_, error) = read(&header(major, 7, 0));
        let error = error.expect("refused");
        assert!(matches!(
            error,
            TraceError::UnsupportedVersion { found } if found == Version { major, minor: 7 }
        ));
        let text = format!("trace format {major}.7 is not supported: this reader knows format 1.x");
        assert_eq!(error.to_string(), text);
    }
}

#[test]
fn later_minor_version_is_read() {
    let mut later = header(1, 9, 0x8000_0000);
    later.extend(&sample()[FILE_HEADER..]);
    assert_eq!(read_all(&later), read_all(&sample()));
}

#[test]
fn mandatory_flags_are_refused_and_others_ignored() {
    let (_, error) = read(&header(1, 0, 1));
    assert!(matches!(error, Some(TraceError::UnsupportedFlags { offset: 0, flags: 1 })));
    let (_, error) = read(&file(&[chunk_of(b"CALL", 2, &[], 0)]));
    assert!(matches!(error, Some(TraceError::UnsupportedFlags { offset: 16, flags: 2 })));
    let events = read_all(&file(&[chunk_of(b"CALL", 0x1_0000, &[], 0)]));
    assert!(matches!(&events[0], Event::Calls(batch) if batch.is_empty()));
}

#[test]
fn unknown_chunks_are_skipped() {
    let mut bytes = sample()[..FILE_HEADER].to_vec();
    bytes.extend(chunk(b"NEW!", b"from a later version"));
    bytes.extend(&sample()[FILE_HEADER..]);
    assert_eq!(read_all(&bytes), read_all(&sample()));
    let mut reader = TraceReader::new(&bytes[..]).expect("header");
    assert_eq!(reader.by_ref().count(), 11);
    assert_eq!(reader.skipped_chunks(), 1);
    assert_eq!(reader.counts().frames, 3);
}

#[test]
fn longer_frame_of_a_later_minor_version_is_read() {
    let mut payload = vec![5, 0, 0, 0, 64, 0, 0, 0, 48, 0, 0, 0, 0, 0, 0, 0];
    payload.extend([0xff; 16]);
    let events = read_all(&file(&[chunk(b"FRAM", &payload)]));
    let Event::FrameEnd(end) = events[0] else { panic!("{:?}", events[0]) };
    assert_eq!((end.number, end.info.width, end.info.height, end.info.hash), (5, 64, 48, None));
}
