//! Replays find what was recorded, and say so when they do not.

use std::error::Error;

use fillrate_player::{Limits, PlayError, Played, Player, Report, Stop, Target, Verdict, play};
use fillrate_trace::{Ending, FrameInfo, Meta, TraceError, TraceReader, TraceWriter, meta};

use crate::toy::{Toy, four_frames};

/// Plays a trace on a toy.
fn replay(file: &[u8], toy: Toy, limits: Limits) -> Report {
    let events = TraceReader::new(file).expect("header");
    play(&mut Player::new(events, toy, limits), |_, _| {})
}

/// A trace of these records, each of which ends a frame.
fn trace_of(about: &Meta, records: &[&[u8]], hash: Option<u64>) -> Vec<u8> {
    let mut writer = TraceWriter::new(Vec::new(), about).expect("memory");
    for record in records {
        writer.record(record).expect("memory");
        writer.end_frame(FrameInfo { width: 1, height: 1, hash }).expect("memory");
    }
    writer.finish().expect("memory")
}

fn toy_meta() -> Meta {
    Meta::new().with(meta::API, "toy")
}

#[test]
fn replay_equals_recording() {
    let report = replay(&four_frames(), Toy::default(), Limits::default());
    assert_eq!(report.frames.len(), 4);
    assert_eq!(report.count(Verdict::Same), 4);
    assert!(report.first_difference().is_none());
    assert!(matches!(report.stop, Stop::End(Ending::Clean(_))));
    assert_eq!((report.counts.calls, report.counts.blobs), (10, 1));
}

#[test]
fn wrong_frames_are_found() {
    let report = replay(&four_frames(), Toy::faulty(), Limits::default());
    let verdicts: Vec<_> = report.frames.iter().map(|frame| frame.verdict).collect();
    assert_eq!(verdicts, [Verdict::Differs, Verdict::Differs, Verdict::Same, Verdict::Same]);
    let first = report.first_difference().expect("two frames differ");
    assert_eq!((first.recorded.number, first.size), (0, Some((64, 32))));
    assert_ne!(first.hash, first.recorded.info.hash);
}

#[test]
fn frames_reach_the_caller_with_their_pixels() {
    let file = four_frames();
    let events = TraceReader::new(&file[..]).expect("header");
    let mut seen = Vec::new();
    let mut player = Player::new(events, Toy::default(), Limits::default());
    let report = play(&mut player, |result, frame| {
        let frame = frame.expect("the toy shows a frame");
        assert_eq!(result.hash, Some(frame.hash()));
        seen.push(frame.rgba(0, 0).expect("first pixel"));
    });
    assert_eq!(seen[..2], [[255, 0, 0, 255], [0, 255, 0, 255]]);
    assert_eq!(seen.len(), report.frames.len());
}

#[test]
fn frame_limit_stops_the_replay() {
    let limits = Limits { frames: Some(2), ..Limits::default() };
    let report = replay(&four_frames(), Toy::default(), limits);
    assert_eq!(report.frames.len(), 2);
    assert!(matches!(report.stop, Stop::FrameLimit));
}

#[test]
fn cut_trace_plays_up_to_its_last_frame() {
    let file = four_frames();
    let report = replay(&file[..file.len() - 50], Toy::default(), Limits::default());
    assert_eq!(report.count(Verdict::Same), 3);
    let Stop::End(ending) = report.stop else { panic!("{:?}", report.stop) };
    assert_eq!(ending.to_string(), "truncated after frame 2");
}

#[test]
fn damaged_trace_keeps_the_frames_before() {
    let mut file = four_frames();
    let last = file.len() - 1;
    file[last] ^= 1;
    let report = replay(&file, Toy::default(), Limits::default());
    assert_eq!(report.count(Verdict::Same), 4);
    assert!(matches!(report.stop, Stop::Failed(PlayError::Trace(TraceError::Format { .. }))));
}

#[test]
fn blob_limit_is_kept() {
    let limits = Limits { blob_bytes: 1000, ..Limits::default() };
    let report = replay(&four_frames(), Toy::default(), limits);
    assert_eq!(report.frames.len(), 2);
    let limit = PlayError::Limit { size: 4096, limit: 1000 };
    let Stop::Failed(error) = report.stop else { panic!("{:?}", report.stop) };
    assert_eq!(error.to_string(), limit.to_string());
}

#[test]
fn frame_without_recorded_hash_is_unchecked() {
    let resize = [1, 0, 1, 0, 0, 0, 1, 0, 0, 0];
    let file = trace_of(&toy_meta(), &[&resize, &[4, 0]], None);
    let report = replay(&file, Toy::default(), Limits::default());
    let found: Vec<_> = report.frames.iter().map(|frame| (frame.verdict, frame.size)).collect();
    assert_eq!(found, [(Verdict::Unchecked, None), (Verdict::Unchecked, Some((1, 1)))]);
}

#[test]
fn absent_frame_differs_from_a_recorded_one() {
    let file = trace_of(&toy_meta(), &[&[2, 0, 0, 0]], Some(0));
    let report = replay(&file, Toy::default(), Limits::default());
    assert_eq!(report.frames[0].verdict, Verdict::Differs);
}

#[test]
fn unknown_call_names_frame_and_call() {
    let file = trace_of(&toy_meta(), &[&[2, 0, 0, 0], &[99, 0]], None);
    let report = replay(&file, Toy::default(), Limits::default());
    assert_eq!(report.frames.len(), 1);
    let Stop::Failed(error) = report.stop else { panic!("{:?}", report.stop) };
    assert_eq!(error.to_string(), "frame 1: call 1 cannot be executed");
    let source = error.source().expect("the target's error");
    assert_eq!(source.to_string(), "byte 0: unknown tag 99 of Call");
}

#[test]
fn trace_of_another_system_is_refused_before_any_call() {
    for about in [Meta::new(), Meta::new().with(meta::API, "other")] {
        let file = trace_of(&about, &[&[2, 0, 0, 0]], None);
        let report = replay(&file, Toy::default(), Limits::default());
        assert!(report.frames.is_empty());
        assert!(matches!(report.stop, Stop::Failed(PlayError::Start { .. })));
    }
}

#[test]
fn stop_is_told_again() {
    let file = four_frames();
    let events = TraceReader::new(&file[..]).expect("header");
    let mut player = Player::new(events, Toy::default(), Limits::default());
    while let Ok(Played::Frame { .. }) = player.step() {}
    assert!(matches!(player.step(), Ok(Played::Stop(Stop::End(Ending::Clean(_))))));
    assert!(player.target().frame().is_some());
}
