//! Files that end early, as after a kill.

use std::io::{self, Read};

use fillrate_trace::{Ending, Event, TraceError, TraceReader};

use crate::{read, read_all, sample};

/// Bytes of a file that must exist for it to be recognised.
const MAGIC_BYTES: usize = 8;

#[test]
fn every_cut_keeps_every_complete_chunk() {
    let file = sample();
    let complete = read_all(&file);
    let mut delivered = 0;
    for length in MAGIC_BYTES..file.len() {
        let events = read_all(&file[..length]);
        let (last, before) = events.split_last().expect("an end");
        assert_eq!(before, &complete[..before.len()], "cut at {length}");
        assert!(before.len() >= delivered, "cut at {length}");
        delivered = before.len();
        let Event::End(Ending::Truncated { counts, last_frame, .. }) = last else {
            panic!("cut at {length}: {last:?}");
        };
        let frames = before.iter().filter(|event| matches!(event, Event::FrameEnd(_))).count();
        assert_eq!(counts.frames, frames as u64);
        assert_eq!(last_frame.map_or(0, |number| number + 1), frames as u32);
    }
    assert_eq!(delivered, complete.len() - 1);
}

#[test]
fn cut_inside_the_magic_is_no_trace() {
    for length in 0..MAGIC_BYTES {
        let (events, error) = read(&sample()[..length]);
        assert!(events.is_empty());
        assert!(matches!(error, Some(TraceError::NotATrace)));
    }
}

#[test]
fn truncation_is_told_in_words() {
    let file = sample();
    let words = |length: usize| match read_all(&file[..length]).pop() {
        Some(Event::End(ending)) => ending.to_string(),
        other => panic!("{other:?}"),
    };
    assert_eq!(words(12), "truncated before the end of the first frame");
    assert_eq!(words(file.len() - 1), "truncated after frame 2");
}

#[test]
fn lost_bytes_are_counted() {
    let file = sample();
    // The end chunk: a header of 20 bytes and 24 bytes of counts.
    for lost in 0..44 {
        let events = read_all(&file[..file.len() - 44 + lost]);
        let Some(Event::End(Ending::Truncated { lost_bytes, .. })) = events.last() else {
            panic!("{lost}");
        };
        assert_eq!(*lost_bytes, lost as u64);
    }
}

#[test]
fn reader_ends_after_its_last_event() {
    let file = sample();
    let mut reader = TraceReader::new(&file[..file.len() - 1]).expect("header");
    assert_eq!(reader.by_ref().count(), 11);
    assert!(reader.next().is_none());
}

/// Delivers one byte at a time, then fails.
struct Failing<'a>(&'a [u8]);

impl Read for Failing<'_> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        match (self.0.split_first(), out.first_mut()) {
            (Some((&byte, rest)), Some(place)) => {
                (*place, self.0) = (byte, rest);
                Ok(1)
            }
            _ => Err(io::ErrorKind::PermissionDenied.into()),
        }
    }
}

#[test]
fn failing_file_is_an_error_and_no_truncation() {
    let file = sample();
    let mut reader = TraceReader::new(Failing(&file[..file.len() - 10])).expect("header");
    let results: Vec<_> = reader.by_ref().collect();
    assert_eq!(results.len(), 11);
    assert!(results[..10].iter().all(Result::is_ok));
    assert!(matches!(results[10], Err(TraceError::Io(_))));
    assert!(reader.next().is_none());
}
