//! Alpha blending.
//!
//! Source: SST1, alphaMode register and dither subtraction.

use fillrate_engine::PixelFormat;
use fillrate_engine::state::{AlphaEquation, Blend, BlendFactor, Channels, DrawState};

use super::dither;
use super::pixel::Position;
use super::shade::rounded;

/// What the surfaces hold where a fragment goes.
#[derive(Clone, Copy, Debug)]
pub struct Destination {
    /// Format of the colour element.
    pub format: PixelFormat,
    /// Colour element.
    pub color: u32,
    /// Aux element, where there is a 16-bit aux plane.
    pub aux: Option<u32>,
}

impl Destination {
    /// Red, green, blue, alpha as blending sees them.
    fn channels(&self, blend: &Blend, at: Position) -> [i32; 4] {
        let [r, g, b, own_alpha] = dither::unpack(self.format, self.color);
        let alpha = match self.aux {
            Some(aux) if blend.alpha_plane => (aux & 0xff) as i32,
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
    let destination = match blend.constant_destination {
        Some(constant) => dither::channels(constant),
        None => destination.channels(blend, at),
    };
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
    let (s, d) = (source[3], destination[3]);
    out[3] = match blend.alpha {
        AlphaEquation::Switches => {
            let kept = if blend.source_alpha { s } else { 0 };
            let added = if blend.destination_alpha { d } else { 0 };
            (kept + added).min(255)
        }
        AlphaEquation::Factors => {
            let by_source = factor(blend.source, &terms(d, 3));
            let by_destination = factor(blend.destination, &terms(s, 3));
            ((s * by_source + d * by_destination) >> 8).min(255)
        }
        AlphaEquation::Union => 255 - rounded((255 - s) * (255 - d), 255),
    };
    out
}

/// The element to store: a new one joined with the old one by the logic
/// operation and the masks.
pub fn merge(state: &DrawState, format: PixelFormat, new: u32, old: u32) -> u32 {
    let channels = match state.channels {
        Channels::ALL => u32::MAX,
        channels => channel_bits(format, channels),
    };
    let mut out = 0;
    for bit in 0..32 {
        let (source, destination) = (new >> bit & 1, old >> bit & 1);
        let result = match state.logic_op {
            Some(op) if state.blend.is_none() => {
                u32::from(op.table()) >> (2 * source + destination) & 1
            }
            _ => source,
        };
        let is_written = state.plane_mask & channels & format.element_mask() & 1 << bit != 0;
        out |= if is_written { result } else { destination } << bit;
    }
    out
}

/// The bits of an element whose change changes one of some channels.
fn channel_bits(format: PixelFormat, channels: Channels) -> u32 {
    let wanted = [channels.red, channels.green, channels.blue, channels.alpha];
    let zero = dither::unpack(format, 0);
    (0..32)
        .filter(|bit| {
            let set = dither::unpack(format, 1 << bit);
            (0..4).any(|channel| wanted[channel] && set[channel] != zero[channel])
        })
        .map(|bit| 1 << bit)
        .sum()
}
