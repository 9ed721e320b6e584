//! The Glide front end as the player sees it.

use fillrate_call::{BlobSource, Decoder};
use fillrate_engine::DeviceConfig;
use fillrate_glide::card::Card;
use fillrate_glide::{Call, Context, GlideConfig};
use fillrate_player::{Frame, Pixels, Target, TargetError};
use fillrate_trace::Meta;
use fillrate_trace::meta::CONFIG_PREFIX;

/// Executes recorded Glide calls.
#[derive(Debug)]
pub struct GlideTarget {
    device: DeviceConfig,
    context: Option<Context>,
}

impl GlideTarget {
    /// A target that draws as `device` says.
    pub fn new(device: DeviceConfig) -> GlideTarget {
        GlideTarget { device, context: None }
    }
}

impl Target for GlideTarget {
    fn start(&mut self, meta: &Meta) -> Result<(), TargetError> {
        if let Some(api) = meta.get("api").filter(|&api| api != "glide2x") {
            return Err(format!("the trace holds calls of {api}, which cannot be replayed").into());
        }
        let pairs = meta.iter().filter_map(|(key, value)| {
            Some((key.strip_prefix(CONFIG_PREFIX)?.to_string(), value.to_string()))
        });
        let mut config = GlideConfig::from_description(pairs);
        // Traces of earlier versions name a built-in board.
        if let Some(card) = meta.get("card").and_then(Card::by_name) {
            config.card = card;
        }
        config.device = self.device.clone();
        self.context = Some(Context::new(config)?);
        Ok(())
    }

    fn execute(&mut self, call: &[u8], blobs: &dyn BlobSource) -> Result<(), TargetError> {
        let mut decoder = Decoder::with_blobs(call, blobs);
        let call: Call = decoder.value()?;
        decoder.finish()?;
        let context = self.context.as_mut().ok_or("the trace has no start")?;
        context.execute(&call);
        Ok(())
    }

    fn frame(&mut self) -> Option<Frame> {
        let shown = self.context.as_mut()?.shown()?;
        Frame::new(shown.width, shown.height, Pixels::Rgb565(shown.pixels)).ok()
    }
}
