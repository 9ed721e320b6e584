//! Alpha blending.
//!
//! Source: SST1, alphaMode register and dither subtraction.

use fillrate_engine::PixelFormat;
use fillrate_engine::state::{Blend, BlendFactor, DrawState};

use super::dither;
use super::pixel::Position;

/// What the surfaces hold where a fragment goes.
#[derive(Clone, Copy, Debug)]
pub struct Destination {
    /// Format of the colour element.
    pub format: PixelFormat,
    /// Colour element.
    pub color: u32,
    /// Aux element, where there is an aux plane.
    pub aux: Option<u16>,
}

impl Destination {
    /// Red, green, blue, alpha as blending sees them.
    fn channels(&self, blend: &Blend, at: Position) -> [i32; 4] {
        let [r, g, b, own_alpha] = dither::unpack(self.format, self.color);
        let alpha = match self.aux {
            Some(aux) if blend.alpha_plane => i32::from(aux & 0xff),
            _ => own_alpha,
        };
        let whole =
            [PixelFormat::Argb8888, PixelFormat::Xrgb8888, PixelFormat::Gray8, PixelFormat::Alpha8];
        if !blend.subtract_dither || whole.contains(&self.format) {
            return [r, g, b, alpha];
        }
        let lost = 15 - dither::matrix(at.x, at.row) as i32;
        let raise = |value: i32, by: i32| (value + by).min(255);
        [raise(r, lost >> 1), raise(g, lost >> 2), raise(b, lost >> 1), alpha]
    }
}

/// Values that blend factors are made of, for one channel.
struct Terms {
    source_alpha: i32,
    destination_alpha: i32,
    /// The colour of the operand that the factor does not multiply.
    other_color: i32,
    prefog: i32,
}

/// A factor in 256ths.
fn factor(factor: BlendFactor, terms: &Terms) -> i32 {
    match factor {
        BlendFactor::Zero => 0,
        BlendFactor::SourceAlpha => terms.source_alpha + 1,
        BlendFactor::OtherColor => terms.other_color + 1,
        BlendFactor::DestinationAlpha => terms.destination_alpha + 1,
        BlendFactor::One => 256,
        BlendFactor::OneMinusSourceAlpha => 256 - terms.source_alpha,
        BlendFactor::OneMinusOtherColor => 256 - terms.other_color,
        BlendFactor::OneMinusDestinationAlpha => 256 - terms.destination_alpha,
        BlendFactor::AlphaSaturate => terms.source_alpha.min(256 - terms.destination_alpha) + 1,
        BlendFactor::PrefogColor => terms.prefog + 1,
        BlendFactor::OneMinusAlphaSaturate => {
            256 - terms.source_alpha.min(255 - terms.destination_alpha)
        }
    }
}

/// The colour to write: `source` as it is without blending, else joined with
/// the destination. `prefog` is the source before fog.
pub fn blend(
    state: &DrawState,
    source: [i32; 4],
    prefog: [i32; 4],
    destination: &Destination,
    at: Position,
) -> [i32; 4] {
    let Some(blend) = &state.blend else { return source };
    let destination = destination.channels(blend, at);
    let terms = |other_color: i32, channel: usize| Terms {
        source_alpha: source[3],
        destination_alpha: destination[3],
        other_color,
        prefog: prefog[channel],
    };
    let mut out = [0; 4];
    for channel in 0..3 {
        let (s, d) = (source[channel], destination[channel]);
        let by_source = factor(blend.source, &terms(d, channel));
        let by_destination = factor(blend.destination, &terms(s, channel));
        out[channel] = ((s * by_source + d * by_destination) >> 8).clamp(0, 255);
    }
    let kept = if blend.source_alpha { source[3] } else { 0 };
    let added = if blend.destination_alpha { destination[3] } else { 0 };
    out[3] = (kept + added).min(255);
    out
}
