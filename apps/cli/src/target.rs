//! The front ends as the player sees them.

use fillrate_call::{BlobSource, Decoder};
use fillrate_engine::DeviceConfig;
use fillrate_glide::card::Card;
use fillrate_glide::{Call, Context, GlideConfig};
use fillrate_player::{Frame, Pixels, Target, TargetError};
use fillrate_quark as quark;
use fillrate_rave as rave;
use fillrate_raw as raw;
use fillrate_redline as redline;
use fillrate_trace::Meta;
use fillrate_trace::meta::CONFIG_PREFIX;

/// Executes the calls of whichever front end a trace was recorded from.
pub struct AnyTarget {
    device: DeviceConfig,
    target: Option<Box<dyn Target>>,
}

impl AnyTarget {
    /// A target that draws as `device` says.
    pub fn new(device: DeviceConfig) -> AnyTarget {
        AnyTarget { device, target: None }
    }
}

impl Target for AnyTarget {
    fn start(&mut self, meta: &Meta) -> Result<(), TargetError> {
        let target: Box<dyn Target> = match meta.get("api") {
            None | Some("glide2x") => Box::new(GlideTarget::start(meta, &self.device)?),
            Some("raw") => Box::new(RawTarget::start(meta, &self.device)?),
            Some("quark3d") => Box::new(QuarkTarget(quark::Context::new(self.device.clone()))),
            Some("redline") => Box::new(RedlineTarget::start(meta, &self.device)),
            Some("rave") => Box::new(RaveTarget::start(meta, &self.device)?),
            Some(api) => {
                return Err(format!("the trace holds calls of {api}, which is unknown").into());
            }
        };
        self.target = Some(target);
        Ok(())
    }

    fn execute(&mut self, call: &[u8], blobs: &dyn BlobSource) -> Result<(), TargetError> {
        self.target.as_mut().ok_or("the trace has no start")?.execute(call, blobs)
    }

    fn frame(&mut self) -> Option<Frame> {
        self.target.as_mut()?.frame()
    }
}

/// Executes recorded Glide calls.
#[derive(Debug)]
struct GlideTarget(Context);

impl GlideTarget {
    fn start(meta: &Meta, device: &DeviceConfig) -> Result<GlideTarget, TargetError> {
        let pairs = meta.iter().filter_map(|(key, value)| {
            Some((key.strip_prefix(CONFIG_PREFIX)?.to_string(), value.to_string()))
        });
        let mut config = GlideConfig::from_description(pairs);
        // Traces of earlier versions name a built-in board.
        if let Some(card) = meta.get("card").and_then(Card::by_name) {
            config.card = card;
        }
        config.device = device.clone();
        Ok(GlideTarget(Context::new(config)?))
    }
}

impl Target for GlideTarget {
    fn start(&mut self, _meta: &Meta) -> Result<(), TargetError> {
        Ok(())
    }

    fn execute(&mut self, call: &[u8], blobs: &dyn BlobSource) -> Result<(), TargetError> {
        let mut decoder = Decoder::with_blobs(call, blobs);
        let call: Call = decoder.value()?;
        decoder.finish()?;
        self.0.execute(&call);
        Ok(())
    }

    fn frame(&mut self) -> Option<Frame> {
        let shown = self.0.shown()?;
        Frame::new(shown.width, shown.height, Pixels::Rgb565(shown.pixels)).ok()
    }
}

/// Executes recorded calls of the Raw client interface.
struct RawTarget(raw::Context);

impl RawTarget {
    fn start(meta: &Meta, device: &DeviceConfig) -> Result<RawTarget, TargetError> {
        let DeviceConfig { threads, level, tile } = *device;
        let mut config = raw::Config { threads, level, tile, ..raw::Config::default() };
        if let Some(size) = meta.get("size") {
            let sides = size
                .split_once('x')
                .and_then(|(w, h)| Some((w.parse::<u32>().ok()?, h.parse::<u32>().ok()?)));
            let (width, height) = sides.ok_or_else(|| format!("'{size}' is no screen size"))?;
            config = config.sized(width, height);
        }
        if let Some(errata) = meta.get("errata") {
            config.errata = raw::Errata::by_name(errata)
                .ok_or_else(|| format!("'{errata}' is no preset of errata"))?;
        }
        Ok(RawTarget(raw::Context::new(config)))
    }
}

impl Target for RawTarget {
    fn start(&mut self, _meta: &Meta) -> Result<(), TargetError> {
        Ok(())
    }

    fn execute(&mut self, call: &[u8], blobs: &dyn BlobSource) -> Result<(), TargetError> {
        let mut decoder = Decoder::with_blobs(call, blobs);
        let call: raw::call::Call = decoder.value()?;
        decoder.finish()?;
        self.0.execute(&call);
        Ok(())
    }

    fn frame(&mut self) -> Option<Frame> {
        let shown = self.0.shown()?;
        Frame::new(shown.width, shown.height, Pixels::Rgba8(shown.rgba)).ok()
    }
}

/// Executes recorded calls of Quark 3D.
struct QuarkTarget(quark::Context);

impl Target for QuarkTarget {
    fn start(&mut self, _meta: &Meta) -> Result<(), TargetError> {
        Ok(())
    }

    fn execute(&mut self, call: &[u8], blobs: &dyn BlobSource) -> Result<(), TargetError> {
        let mut decoder = Decoder::with_blobs(call, blobs);
        let call: quark::Call = decoder.value()?;
        decoder.finish()?;
        self.0.execute(&call);
        Ok(())
    }

    fn frame(&mut self) -> Option<Frame> {
        let shown = self.0.shown()?;
        Frame::new(shown.width, shown.height, Pixels::Rgba8(shown.rgba8888())).ok()
    }
}

/// Executes recorded calls of RAVE.
struct RaveTarget(rave::Context);

impl RaveTarget {
    fn start(meta: &Meta, device: &DeviceConfig) -> Result<RaveTarget, TargetError> {
        let mut config = rave::RaveConfig { device: device.clone(), ..rave::RaveConfig::default() };
        config.describe(|key| meta.get(key))?;
        Ok(RaveTarget(rave::Context::new(config)))
    }
}

impl Target for RaveTarget {
    fn start(&mut self, _meta: &Meta) -> Result<(), TargetError> {
        Ok(())
    }

    fn execute(&mut self, call: &[u8], blobs: &dyn BlobSource) -> Result<(), TargetError> {
        let mut decoder = Decoder::with_blobs(call, blobs);
        let call: rave::Call = decoder.value()?;
        decoder.finish()?;
        self.0.execute(&call);
        Ok(())
    }

    fn frame(&mut self) -> Option<Frame> {
        let shown = self.0.shown()?;
        Frame::new(shown.width, shown.height, Pixels::Rgba8(shown.rgba8888())).ok()
    }
}

/// Executes recorded calls of RRedline.
struct RedlineTarget(redline::Context);

impl RedlineTarget {
    fn start(meta: &Meta, device: &DeviceConfig) -> RedlineTarget {
        let pairs = meta.iter().filter_map(|(key, value)| {
            Some((key.strip_prefix(CONFIG_PREFIX)?.to_string(), value.to_string()))
        });
        let config = redline::RedlineConfig::from_description(pairs);
        let device = device.clone();
        RedlineTarget(redline::Context::new(redline::RedlineConfig { device, ..config }))
    }
}

impl Target for RedlineTarget {
    fn start(&mut self, _meta: &Meta) -> Result<(), TargetError> {
        Ok(())
    }

    fn execute(&mut self, call: &[u8], blobs: &dyn BlobSource) -> Result<(), TargetError> {
        let mut decoder = Decoder::with_blobs(call, blobs);
        let call: redline::Call = decoder.value()?;
        decoder.finish()?;
        // A call that failed when it was recorded fails again.
        let _ = self.0.execute(&call);
        Ok(())
    }

    fn frame(&mut self) -> Option<Frame> {
        let shown = self.0.shown()?;
        Frame::new(shown.width, shown.height, Pixels::Rgb565(shown.pixels)).ok()
    }
}
