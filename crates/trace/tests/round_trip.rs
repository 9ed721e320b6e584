//! What is recorded is delivered, in order, and stored economically.

use std::cell::RefCell;
use std::io::{self, Write};
use std::rc::Rc;

use fillrate_call::{BLOB_THRESHOLD, Encoder};
use fillrate_trace::{
    Counts, Data, Ending, Event, FrameInfo, MAX_CHUNK_BYTES, Meta, TraceError, TraceWriter,
    WriterOptions,
};
use proptest::prelude::*;

use crate::{frame, read_all, sample};

/// The calls of all events.
fn calls(events: &[Event]) -> Vec<Vec<u8>> {
    let batches = events.iter().filter_map(|event| match event {
        Event::Calls(batch) => Some(batch),
        _ => None,
    });
    batches.flat_map(|batch| batch.iter().map(<[u8]>::to_vec)).collect()
}

#[test]
fn sample_is_delivered_in_order() {
    let events = read_all(&sample());
    assert_eq!(events.len(), 1 + 3 * 3 + 1);
    let Event::Meta(about) = &events[0] else { panic!("{:?}", events[0]) };
    let pairs: Vec<_> = about.iter().collect();
    assert_eq!(pairs, [("api", "test"), ("program", "sample")]);
    let Event::Blob { id, data } = &events[4] else { panic!("{:?}", events[4]) };
    assert_eq!((data, *id), (&Data::from(vec![1; 200]), Data::from(vec![1; 200]).id()));
    let Event::Calls(batch) = &events[5] else { panic!("{:?}", events[5]) };
    assert_eq!(batch.iter().collect::<Vec<_>>(), [&[1, 1, 2, 3][..], &[]]);
    let Event::FrameEnd(end) = events[6] else { panic!("{:?}", events[6]) };
    assert_eq!((end.number, end.info), (1, frame(1)));
    let counts = Counts { frames: 3, calls: 6, blobs: 3 };
    assert_eq!(events[10], Event::End(Ending::Clean(counts)));
}

#[test]
fn meta_keeps_the_last_value_of_a_key() {
    let about = Meta::new().with("a", "1").with("b", "").with("a", "2");
    let file = TraceWriter::new(Vec::new(), &about).and_then(TraceWriter::finish).expect("memory");
    let Event::Meta(found) = &read_all(&file)[0] else { panic!("meta first") };
    assert_eq!(found, &about);
    assert_eq!((found.get("a"), found.get("b"), found.get("c")), (Some("2"), Some(""), None));
}

#[test]
fn frame_without_hash() {
    let mut writer = TraceWriter::new(Vec::new(), &Meta::new()).expect("memory");
    let info = FrameInfo { width: 1, height: u32::MAX, hash: None };
    writer.end_frame(info).expect("memory");
    let events = read_all(&writer.finish().expect("memory"));
    assert!(matches!(events[1], Event::FrameEnd(end) if end.info == info));
}

#[test]
fn equal_data_is_stored_once() {
    let image = Data::from(vec![9; BLOB_THRESHOLD]);
    let mut writer = TraceWriter::new(Vec::new(), &Meta::new()).expect("memory");
    let mut encoder = Encoder::with_blobs();
    for _ in 0..5 {
        encoder.clear();
        encoder.data(&image);
        writer.record_encoded(&mut encoder).expect("memory");
    }
    assert_eq!(writer.blob(&image).expect("memory"), image.id());
    let events = read_all(&writer.finish().expect("memory"));
    assert!(matches!(&events[1], Event::Blob { data, .. } if *data == image));
    assert_eq!(calls(&events).len(), 5);
    assert_eq!(events.len(), 4, "meta, blob, calls, end");
}

#[test]
fn batches_are_split_at_their_size() {
    let options = WriterOptions { batch_bytes: 100, compress: false };
    let mut writer = TraceWriter::with_options(Vec::new(), &Meta::new(), options).expect("memory");
    for number in 0..50u8 {
        writer.record(&[number; 30]).expect("memory");
    }
    writer.record(&[7; 1000]).expect("memory");
    let events = read_all(&writer.finish().expect("memory"));
    let sizes: Vec<_> = events
        .iter()
        .filter_map(|event| if let Event::Calls(batch) = event { Some(batch.len()) } else { None })
        .collect();
    assert_eq!(sizes.iter().sum::<usize>(), 51);
    assert!(sizes.iter().all(|&size| size <= 3), "{sizes:?}");
    assert_eq!(calls(&events)[50], [7; 1000]);
}

#[test]
fn sizes_beyond_the_limit_are_refused_and_harmless() {
    let large = vec![0; MAX_CHUNK_BYTES + 1];
    let mut writer = TraceWriter::new(Vec::new(), &Meta::new()).expect("memory");
    assert!(matches!(writer.record(&large), Err(TraceError::Limit { what: "call", .. })));
    assert!(matches!(writer.blob(&large), Err(TraceError::Limit { what: "blob", .. })));
    writer.record(b"small").expect("memory");
    assert_eq!(calls(&read_all(&writer.finish().expect("memory"))), [b"small"]);
}

/// A file that counts its flushes and can be told to fail.
#[derive(Clone, Default)]
struct Watched(Rc<RefCell<Watch>>);

#[derive(Default)]
struct Watch {
    bytes: Vec<u8>,
    writes: usize,
    flushes: usize,
    full: bool,
}

impl Write for Watched {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut watch = self.0.borrow_mut();
        if watch.full {
            return Err(io::ErrorKind::StorageFull.into());
        }
        watch.writes += 1;
        watch.bytes.extend(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.borrow_mut().flushes += 1;
        Ok(())
    }
}

#[test]
fn one_write_and_one_flush_per_frame() {
    let file = Watched::default();
    let mut writer = TraceWriter::new(file.clone(), &Meta::new()).expect("memory");
    assert_eq!((file.0.borrow().writes, file.0.borrow().flushes), (1, 1));
    for number in 0..4 {
        writer.blob(&[number; 64]).expect("memory");
        writer.record(&[number; 64]).expect("memory");
        writer.end_frame(frame(0)).expect("memory");
    }
    assert_eq!((file.0.borrow().writes, file.0.borrow().flushes), (5, 5));
    writer.record(b"lost unless flushed").expect("memory");
    writer.flush().expect("memory");
    let events = read_all(&file.0.borrow().bytes);
    assert_eq!(calls(&events).len(), 5);
    let Some(Event::End(ending)) = events.last() else { panic!("no end") };
    assert_eq!(ending.to_string(), "truncated after frame 3");
}

#[test]
fn failed_write_stops_the_writer() {
    let file = Watched::default();
    let mut writer = TraceWriter::new(file.clone(), &Meta::new()).expect("memory");
    writer.end_frame(frame(0)).expect("memory");
    file.0.borrow_mut().full = true;
    writer.record(b"call").expect("not written yet");
    assert!(matches!(writer.end_frame(frame(0)), Err(TraceError::Io(_))));
    file.0.borrow_mut().full = false;
    assert!(matches!(writer.end_frame(frame(0)), Err(TraceError::Usage)));
    let events = read_all(&file.0.borrow().bytes);
    assert!(matches!(events.last(), Some(Event::End(end)) if end.counts().frames == 1));
}

proptest! {
    #[test]
    fn anything_recorded_is_delivered(
        frames in prop::collection::vec(
            prop::collection::vec(prop::collection::vec(0u8..4, 0..200), 0..20), 0..6),
        batch_bytes in 1usize..2000,
        compress: bool,
    ) {
        let options = WriterOptions { batch_bytes, compress };
        let mut writer = TraceWriter::with_options(Vec::new(), &Meta::new(), options)?;
        for frame_calls in &frames {
            for call in frame_calls {
                writer.record(call)?;
            }
            writer.end_frame(frame(frame_calls.len() as u64))?;
        }
        let events = read_all(&writer.finish()?);
        prop_assert_eq!(calls(&events), frames.concat());
        let ends: Vec<_> = events.iter().filter_map(|event| match event {
            Event::FrameEnd(end) => end.info.hash,
            _ => None,
        }).collect();
        prop_assert_eq!(ends, frames.iter().map(|calls| calls.len() as u64).collect::<Vec<_>>());
    }
}
