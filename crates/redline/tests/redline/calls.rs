//! Calls as values: what was executed runs again to the same pictures.

use fillrate_call::{Tagged, from_bytes, to_bytes};
use fillrate_redline::{Call, Chip, Context, Reply, Segment, VError, VlError, error, record};

use crate::board::config;

/// A small program, as calls.
fn program() -> Vec<Call> {
    let device = 1;
    let (width, height) = (64, 48);
    let mut calls = vec![
        Call::OpenVerite {},
        Call::SetDisplayType { device, display_type: 2 },
        Call::SetDisplayMode { device, width, height, bits: 16, refresh: -1 },
        Call::CreateSurface { device, mask: 2, buffers: 2, format: 4, width, height },
        Call::CreateCmdBuffer { device, entries: 4, words: 1024 },
    ];
    let mut context = Context::new(config(Chip::V2000));
    for call in &calls {
        context.execute(call).unwrap();
    }
    let (group, buffer) = (1, 2);
    for frame in 0..3u32 {
        let place = context.group(device, group).unwrap().clone();
        let mut commands = fillrate_redline::CommandBuffer::new(buffer, 4, 1024).unwrap();
        let surface = fillrate_redline::Surface::new(width, height, 4);
        record::install_dst_buffer(&mut commands, &surface, &place).unwrap();
        record::fill_buffer(&mut commands, &place, 1, [0, 0], [width, height], frame * 77).unwrap();
        record::set_fg_color_argb(&mut commands, 0xff00_00ff << (frame * 3)).unwrap();
        let corners = [5 << 16, 5 << 16, 60 << 16, 9 << 16, (20 + frame) << 16, 40 << 16];
        record::triangle_fill(&mut commands, &corners).unwrap();
        record::swap_display_surface(&mut commands, &place).unwrap();
        record::wait_for_display_switch(&mut commands).unwrap();
        let segments = commands.snapshot(&fillrate_redline::NoMemory).unwrap();
        let frame = [
            Call::SwapBuffers { device, group, a: 0, b: 1 },
            Call::IssueCmdBuffer { device, buffer, segments, wait: false },
        ];
        for call in &frame {
            context.execute(call).unwrap();
        }
        calls.extend(frame);
    }
    calls
}

fn pictures(calls: &[Call], background: bool) -> Vec<Vec<u16>> {
    let mut context =
        Context::new(fillrate_redline::RedlineConfig { background, ..config(Chip::V2000) });
    let mut shown = Vec::new();
    for call in calls {
        let reply = context.execute(call).unwrap();
        if matches!(call, Call::IssueCmdBuffer { .. }) {
            assert_eq!(reply, Reply::Number(1), "one switch of the display");
            shown.push(context.shown().unwrap().pixels);
        }
    }
    shown
}

#[test]
fn encoded_calls_run_again() {
    let calls = program();
    let again: Vec<Call> = calls.iter().map(|call| from_bytes(&to_bytes(call)).unwrap()).collect();
    assert_eq!(calls, again);
    let first = pictures(&calls, false);
    assert_eq!(first, pictures(&again, true));
    assert!(first[0] != first[1] && first[1] != first[2]);
}

#[test]
fn every_call_comes_back_and_is_shown() {
    for (tag, name) in Call::VARIANTS {
        // Zeros decode as some call of every variant.
        let mut bytes = tag.to_le_bytes().to_vec();
        bytes.resize(80, 0);
        let call = (2..80).find_map(|end| from_bytes::<Call>(&bytes[..end]).ok()).unwrap();
        assert_eq!((call.tag(), call.name()), (*tag, *name));
        assert!(call.to_string().starts_with(name));
        assert_eq!(from_bytes::<Call>(&to_bytes(&call)).unwrap(), call);
    }
}

#[test]
fn commands_are_shown_in_words() {
    let mut words = vec![0x3013, 0xff00_ff00, 1 << 16 | 24];
    words.extend([0; 6]);
    words.extend([13, 1, 2, 3, 4, 5]);
    let shown: Vec<String> = fillrate_redline::Commands::new(&words, Chip::V1000)
        .map(|command| command.unwrap().to_string())
        .collect();
    assert_eq!(
        shown,
        [
            "V_FIFO_SETSTATE_FGCOLORARGB 0xff00ff00",
            "V_FIFO_TRIANGLE V_FIFO_XY (0x0 0x0) (0x0 0x0) (0x0 0x0)",
            "V_FIFO_MEM_CLEAR_RECT flags 0x0 0x1 0x2 0x3 0x4 0x5",
        ]
    );
}

#[test]
fn numbers_have_names_and_texts() {
    assert_eq!(error::error_text(500), Some("success"));
    assert_eq!(error::error_text(633), Some("video memory is used up"));
    assert_eq!(error::error_text(507), None);
    assert_eq!(error::function_name(101), Some("V_IssueCmdBuffer"));
    assert_eq!(error::function_name(322), Some("VL_Triangle"));
    assert_eq!(VError::ALL.len() + VlError::ALL.len(), 54);
    for error in VError::ALL {
        assert_eq!(VError::from_number(error.number()), Some(*error));
    }
    let empty = Segment::default();
    assert!(empty.words.is_empty());
}
