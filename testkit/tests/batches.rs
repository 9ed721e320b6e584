//! Batches that are drawn behind the caller: whoever reads, destroys or draws
//! elsewhere meanwhile sees what one thread shows, which draws them at once.

use fillrate_engine::state::{Dither, Rect};
use fillrate_engine::{ClearValues, Device, DeviceConfig, EngineError, FlushReason, PixelFormat};

const SIDE: u32 = 256;
const ALL: Rect = Rect { x0: 0, y0: 0, x1: SIDE, y1: SIDE };

/// Clears to a grey of 0 to 255, a row of pixels at a time, so that a batch is work.
fn fill(device: &mut Device, grey: u32) {
    for y in 0..SIDE {
        let color = Some((0xff00_0000 | (grey * 0x01_0101), Dither::Off));
        let rect = Rect { y0: y, y1: y + 1, ..ALL };
        device.clear(rect, ClearValues { color, aux: None });
    }
}

#[test]
fn batches_in_flight_are_waited_for() -> Result<(), EngineError> {
    for threads in [1, 2, 5] {
        let mut device = Device::new(DeviceConfig { threads, ..DeviceConfig::default() })?;
        let mut surface = || device.create_surface(SIDE, SIDE, PixelFormat::Rgb565);
        let [a, b, c] = [surface()?, surface()?, surface()?];
        let read = |device: &mut Device, id| {
            let mut pixels = vec![0; (SIDE * SIDE) as usize];
            device.read16(id, ALL, &mut pixels, SIDE as usize).map(|()| pixels)
        };
        for round in 0..50 {
            for (id, grey) in [(a, 255), (b, 0), (c, 255)] {
                device.set_target(id, None)?;
                fill(&mut device, if round % 2 == 0 { grey } else { 255 - grey });
                device.submit(FlushReason::Swap);
            }
            // The last batch is in flight, or still waits for its turn.
            let white = if round % 2 == 0 { 0xffff } else { 0 };
            assert!(read(&mut device, c)?.iter().all(|&pixel| pixel == white), "{threads} threads");
            assert!(read(&mut device, b)?.iter().all(|&pixel| pixel == !white));
            assert!(read(&mut device, a)?.iter().all(|&pixel| pixel == white));
        }
        assert_eq!(device.counters().pixels_out, u64::from(3 * 50 * SIDE * SIDE));
        // What is drawn on may go at any time.
        device.set_target(a, None)?;
        fill(&mut device, 7);
        device.submit(FlushReason::Swap);
        device.destroy_surface(a)?;
        assert!(read(&mut device, a).is_err());
        assert!(read(&mut device, b)?.iter().all(|&pixel| pixel == 0xffff));
    }
    Ok(())
}

/// What is collected is not seen in what is drawn, which nobody waits for.
#[test]
fn what_is_drawn_can_be_read_while_more_is_collected() -> Result<(), EngineError> {
    for threads in [1, 2, 5] {
        let mut device = Device::new(DeviceConfig { threads, ..DeviceConfig::default() })?;
        let mut surface = || device.create_surface(SIDE, SIDE, PixelFormat::Rgb565);
        let [a, b] = [surface()?, surface()?];
        for (id, grey) in [(a, 255), (b, 0)] {
            device.set_target(id, None)?;
            fill(&mut device, grey);
            device.submit(FlushReason::Swap);
        }
        device.set_target(a, None)?;
        fill(&mut device, 0);
        assert_eq!(device.drawn_surface(a)?.get(3, 5), 0xffff, "what was drawn");
        assert_eq!(device.drawn_surface(b)?.get(3, 5), 0);
        assert_eq!(device.started(), 2, "the rest is still collected");
        assert_eq!(device.surface(a)?.get(3, 5), 0);
    }
    Ok(())
}

/// Batches are counted when they start, and again when they are drawn, whether
/// somebody waits for them or not.
#[test]
fn batches_are_counted() -> Result<(), EngineError> {
    for threads in [1, 2, 5] {
        let mut device = Device::new(DeviceConfig { threads, ..DeviceConfig::default() })?;
        let surface = device.create_surface(SIDE, SIDE, PixelFormat::Rgb565)?;
        device.set_target(surface, None)?;
        for round in 1..=50 {
            fill(&mut device, 255);
            device.submit(FlushReason::Swap);
            assert_eq!(device.started(), round);
            assert!(device.drawn() + 1 >= round, "one batch is drawn at a time");
            if round % 2 == 0 {
                device.flush(FlushReason::Explicit);
                assert_eq!(device.drawn(), round);
            }
            while device.drawn() < round {
                std::thread::yield_now();
            }
            // A batch of nothing is none.
            device.submit(FlushReason::Swap);
        }
        assert_eq!(device.counters().pixels_out, u64::from(50 * SIDE * SIDE));
    }
    Ok(())
}
