//! A system with four calls, enough to record and replay.

use fillrate_call::{BlobSource, Data, Decoder, Encoder, Value, value_enum};
use fillrate_player::{Frame, Pixels, Target, TargetError};
use fillrate_trace::{FrameInfo, Meta, TraceWriter, meta};

value_enum! {
    /// The calls of the toy system.
    pub enum Call {
        /// Sets the size of the picture, in pixels, and blackens it.
        1 => Resize { width: u32, height: u32 },
        /// Sets every pixel.
        2 => Fill { color: u16 },
        /// Sets the first pixels from 16-bit little-endian words.
        3 => Upload { image: Data },
        /// Shows the picture.
        4 => Swap {},
    }
}

/// The toy system, with a fault on request.
#[derive(Default)]
pub struct Toy {
    width: u32,
    height: u32,
    pixels: Vec<u16>,
    shown: Option<Frame>,
    /// Added to every filled colour.
    fault: u16,
}

impl Toy {
    /// A toy that fills with wrong colours.
    pub fn faulty() -> Self {
        Self { fault: 1, ..Self::default() }
    }

    /// Executes one call.
    pub fn call(&mut self, call: Call) -> Result<(), TargetError> {
        match call {
            Call::Resize { width, height } => {
                (self.width, self.height) = (width, height);
                self.pixels = vec![0; width as usize * height as usize];
            }
            Call::Fill { color } => self.pixels.fill(color.wrapping_add(self.fault)),
            Call::Upload { image } => {
                for (pixel, bytes) in self.pixels.iter_mut().zip(image.as_chunks().0) {
                    *pixel = u16::from_le_bytes(*bytes);
                }
            }
            Call::Swap {} => {
                let pixels = Pixels::Rgb565(self.pixels.clone());
                self.shown = Some(Frame::new(self.width, self.height, pixels)?);
            }
        }
        Ok(())
    }
}

impl Target for Toy {
    fn start(&mut self, meta: &Meta) -> Result<(), TargetError> {
        match meta.get(meta::API) {
            Some("toy") => Ok(()),
            api => Err(format!("api {api:?} is not toy").into()),
        }
    }

    fn execute(&mut self, call: &[u8], blobs: &dyn BlobSource) -> Result<(), TargetError> {
        let mut decoder = Decoder::with_blobs(call, blobs);
        let call = Call::decode(&mut decoder)?;
        decoder.finish()?;
        self.call(call)
    }

    fn frame(&mut self) -> Option<Frame> {
        self.shown.clone()
    }
}

/// Runs the calls and records them; each swap ends a frame.
pub fn record(calls: &[Call]) -> Vec<u8> {
    let mut live = Toy::default();
    let about = Meta::new().with(meta::API, "toy");
    let mut writer = TraceWriter::new(Vec::new(), &about).expect("memory");
    let mut encoder = Encoder::with_blobs();
    for call in calls {
        encoder.clear();
        call.encode(&mut encoder);
        writer.record_encoded(&mut encoder).expect("memory");
        live.call(call.clone()).expect("live calls are sound");
        if let (Call::Swap {}, Some(frame)) = (call, &live.shown) {
            let (width, height) = (frame.width(), frame.height());
            let info = FrameInfo { width, height, hash: Some(frame.hash()) };
            writer.end_frame(info).expect("memory");
        }
    }
    writer.finish().expect("memory")
}

/// Four frames: two fills, an upload, and the same upload in another size.
pub fn four_frames() -> Vec<u8> {
    let image = Data::from((0..=255u8).cycle().take(64 * 32 * 2).collect::<Vec<_>>());
    record(&[
        Call::Resize { width: 64, height: 32 },
        Call::Fill { color: 0xf800 },
        Call::Swap {},
        Call::Fill { color: 0x07e0 },
        Call::Swap {},
        Call::Upload { image: image.clone() },
        Call::Swap {},
        Call::Resize { width: 32, height: 64 },
        Call::Upload { image },
        Call::Swap {},
    ])
}
