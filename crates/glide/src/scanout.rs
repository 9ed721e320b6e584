//! From the displayed buffer to the monitor: gamma and the screen filter.
//! Reading the buffer never sees either.
//!
//! Source: SST1, clutData; G246, `grGammaCorrectionValue`. The filter's exact
//! kernel is not published; ours is in `docs/sources.md`.

use fillrate_engine::PixelFormat;
use fillrate_engine::target::unpack;

use crate::buffers::Shown;

/// A gamma table: the values at 0, 8, ..., 248, and 255.
pub type GammaTable = [u8; 33];

/// What scan-out does besides copying.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ScanOut {
    /// Gamma, by the board's tables.
    pub gamma: bool,
    /// The screen filter, which takes dithering back.
    pub filter: bool,
}

/// How far a neighbour's red, green and blue may be off to be mixed in.
pub(crate) const FILTER_THRESHOLDS: [u8; 3] = [8, 4, 8];

/// The table of a gamma above 0.
pub(crate) fn gamma_table(gamma: f32) -> GammaTable {
    core::array::from_fn(|i| {
        let x = (i * 8).min(255) as f64 / 255.0;
        (255.0 * x.powf(1.0 / f64::from(gamma)) + 0.5) as u8
    })
}

/// A channel's value on the monitor, between the table's entries.
fn corrected(table: &GammaTable, v: u8) -> u8 {
    let (i, f) = (usize::from(v >> 3), u16::from(v & 7));
    ((u16::from(table[i]) * (8 - f) + u16::from(table[i + 1]) * f) >> 3) as u8
}

/// Half a pixel and a quarter of each neighbour in its row; a neighbour
/// beyond the thresholds counts as the pixel itself.
fn filter_row(row: &[[u8; 3]], thresholds: [u8; 3], out: &mut Vec<[u8; 3]>) {
    let near = |a: [u8; 3], b: [u8; 3]| {
        a.iter().zip(b).zip(thresholds).all(|((&a, b), limit)| a.abs_diff(b) <= limit)
    };
    for (x, &own) in row.iter().enumerate() {
        let neighbour = |at: Option<usize>| {
            at.and_then(|at| row.get(at)).copied().filter(|&other| near(own, other)).unwrap_or(own)
        };
        let (left, right) = (neighbour(x.checked_sub(1)), neighbour(Some(x + 1)));
        let mix = |c: usize| {
            let sum = u16::from(own[c]) * 2 + u16::from(left[c]) + u16::from(right[c]);
            ((sum + 2) >> 2) as u8
        };
        out.push([mix(0), mix(1), mix(2)]);
    }
}

/// A picture of eight bits a channel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Red, green, blue of each pixel, row by row from the top left.
    pub pixels: Vec<[u8; 3]>,
}

impl Shown {
    /// The picture on the monitor.
    pub fn on_monitor(&self, scan_out: ScanOut) -> Picture {
        let widen = |&pixel: &u16| {
            let [_, r, g, b] = unpack(PixelFormat::Rgb565, u32::from(pixel)).to_be_bytes();
            [r, g, b]
        };
        let plain = || Picture {
            width: self.width,
            height: self.height,
            pixels: self.pixels.iter().map(widen).collect(),
        };
        let Picture { width, height, mut pixels } = self.detail.clone().unwrap_or_else(plain);
        if scan_out.filter {
            let mut out = Vec::with_capacity(pixels.len());
            for row in pixels.chunks(width.max(1) as usize) {
                filter_row(row, self.thresholds, &mut out);
            }
            pixels = out;
        }
        if scan_out.gamma {
            for pixel in &mut pixels {
                for (channel, table) in pixel.iter_mut().zip(&self.gamma) {
                    *channel = corrected(table, *channel);
                }
            }
        }
        Picture { width, height, pixels }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(pixels: Vec<u16>, gamma: f32) -> Shown {
        Shown {
            width: pixels.len() as u32,
            height: 1,
            pixels,
            gamma: [gamma_table(gamma); 3],
            thresholds: FILTER_THRESHOLDS,
            detail: None,
        }
    }

    #[test]
    fn gamma_one_changes_nothing_and_others_keep_the_ends() {
        let all: Vec<u16> = (0..=0xffff).collect();
        let raw = shown(all.clone(), 1.0).on_monitor(ScanOut::default()).pixels;
        let scan = ScanOut { gamma: true, filter: false };
        let one = shown(all.clone(), 1.0).on_monitor(scan).pixels;
        // The last step of the table is one of seven.
        let near = |(a, b): (&[u8; 3], &[u8; 3])| (0..3).all(|i| a[i].abs_diff(b[i]) <= 1);
        assert!(raw.iter().zip(&one).all(near));
        let bright = shown(all, 1.7).on_monitor(scan).pixels;
        assert_eq!((bright[0], bright[0xffff]), ([0; 3], one[0xffff]));
        // 0x84 is 132: 255 * (128/255)^(1/1.7) = 170, (136/255)... = 176.
        assert_eq!(bright[0x8410][0], 173);
    }

    #[test]
    fn the_filter_mixes_what_dithering_parted_and_keeps_edges() {
        let scan = ScanOut { gamma: false, filter: true };
        // Neighbouring greens of one step alternate: they become even.
        let row = shown(vec![0x0020, 0x0040, 0x0020, 0x0040], 1.0).on_monitor(scan).pixels;
        assert_eq!([row[1], row[2]], [[0, 6, 0]; 2]);
        let edge = vec![0, 0, 0xffff, 0xffff];
        let raw = shown(edge.clone(), 1.0).on_monitor(ScanOut::default()).pixels;
        assert_eq!(shown(edge, 1.0).on_monitor(scan).pixels, raw);
    }
}
