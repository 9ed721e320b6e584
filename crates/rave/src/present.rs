//! Showing: a context's surface as its device holds it.

use fillrate_engine::state::{Dither, Rect};
use fillrate_engine::target::{pack, unpack};
use fillrate_engine::{PixelFormat, Surface};

use crate::front::Front;
use crate::painter::Planes;
use crate::vertex::RaveRect;

/// Shows a rectangle of a context.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Present {
    /// Pixels of the context.
    pub rect: Rect,
    /// `kQABufferComposite`.
    pub composite: u32,
    /// `kQATag_DrawContextFilter`.
    pub filter: u32,
}

impl Present {
    /// Whether nothing is left of an earlier one of the same context.
    pub fn replaces(&self, earlier: &Present) -> bool {
        self.composite == 0 && self.rect.intersect(&earlier.rect) == earlier.rect
    }
}

/// Brings a surface's pixels into the front.
pub(crate) fn carry_out(present: &Present, surface: &Surface, planes: &Planes, front: &mut Front) {
    let shown = front_rect(front, planes.size, present.rect);
    front.note(shown);
    let same_size = (front.width, front.height) == planes.size;
    let plain = same_size && planes.scale == 1 && front.clip.is_none();
    if plain && present.composite == 0 {
        return copy_rows(surface, front, &shown);
    }
    for y in shown.top as u32..shown.bottom as u32 {
        for x in shown.left as u32..shown.right as u32 {
            if front.clip.is_some() && !front.shows(x, y) {
                continue;
            }
            let element = if same_size {
                sample(surface, planes, x, y)
            } else {
                resample(surface, planes, front, present.filter, x, y)
            };
            front.put(x, y, element, present.composite);
        }
    }
}

/// Shows a rectangle as it is; it lies inside both.
fn copy_rows(surface: &Surface, front: &mut Front, rect: &RaveRect) {
    let (left, right) = (rect.left as usize, rect.right as usize);
    let mut scratch = vec![0; if left > 0 { right } else { 0 }];
    let rows = front.elements.chunks_exact_mut(front.width as usize).enumerate();
    for (y, row) in rows.skip(rect.top as usize).take(rect.height() as usize) {
        if left == 0 {
            surface.read_row(y as u32, &mut row[..right]);
        } else {
            surface.read_row(y as u32, &mut scratch);
            row[left..right].copy_from_slice(&scratch[left..]);
        }
    }
}

/// A context's pixel: the mean of its samples.
pub(crate) fn sample(surface: &Surface, planes: &Planes, x: u32, y: u32) -> u32 {
    match planes.scale {
        1 => surface.get(x, y),
        n => mean(surface, planes.format, Rect::new(x * n, y * n, (x + 1) * n, (y + 1) * n)),
    }
}

/// The mean colour of a rectangle of a surface, each channel to the nearest.
fn mean(surface: &Surface, format: PixelFormat, rect: Rect) -> u32 {
    let mut sums = [0u32; 4];
    for y in rect.y0..rect.y1 {
        for x in rect.x0..rect.x1 {
            let channels = unpack(format, surface.get(x, y)).to_be_bytes();
            for (sum, channel) in sums.iter_mut().zip(channels) {
                *sum += u32::from(channel);
            }
        }
    }
    let count = rect.area().max(1) as u32;
    let argb = u32::from_be_bytes(sums.map(|sum| ((sum + count / 2) / count) as u8));
    pack(format, argb, Dither::Off, 0, 0)
}

/// The part of the front that a rectangle of the context reaches.
fn front_rect(front: &Front, (width, height): (u32, u32), rect: Rect) -> RaveRect {
    let low = |v: u32, to: u32, from: u32| (u64::from(v) * u64::from(to) / u64::from(from)) as i32;
    let high = |v: u32, to: u32, from: u32| {
        (u64::from(v) * u64::from(to)).div_ceil(u64::from(from)).min(u64::from(to)) as i32
    };
    RaveRect {
        left: low(rect.x0, front.width, width),
        right: high(rect.x1, front.width, width),
        top: low(rect.y0, front.height, height),
        bottom: high(rect.y1, front.height, height),
    }
}

/// A pixel of a front of another size than the context: the mean where the
/// context is larger, else the nearest pixel or, with a better filter, four.
fn resample(surface: &Surface, planes: &Planes, front: &Front, filter: u32, x: u32, y: u32) -> u32 {
    let (width, height) = (surface.width(), surface.height());
    let span = |v: u32, from: u32, to: u32| {
        let low = (u64::from(v) * u64::from(from) / u64::from(to)) as u32;
        let high = (u64::from(v + 1) * u64::from(from)).div_ceil(u64::from(to)) as u32;
        (low, high.clamp(low + 1, from))
    };
    let ((x0, x1), (y0, y1)) = (span(x, width, front.width), span(y, height, front.height));
    let shrinks = width > front.width || height > front.height;
    if shrinks || filter == 0 {
        let rect =
            if shrinks { Rect::new(x0, y0, x1, y1) } else { Rect::new(x0, y0, x0 + 1, y0 + 1) };
        return mean(surface, planes.format, rect);
    }
    let ((x0, x1, fx), (y0, y1, fy)) =
        (neighbours(x, width, front.width), neighbours(y, height, front.height));
    let texel =
        |x: u32, y: u32| unpack(planes.format, surface.get(x, y)).to_be_bytes().map(u32::from);
    let corners = [texel(x0, y0), texel(x1, y0), texel(x0, y1), texel(x1, y1)];
    let weights = [(256 - fx) * (256 - fy), fx * (256 - fy), (256 - fx) * fy, fx * fy];
    let channel = |i: usize| {
        let sum: u32 = corners.iter().zip(weights).map(|(corner, weight)| corner[i] * weight).sum();
        ((sum + 0x8000) >> 16) as u8
    };
    pack(planes.format, u32::from_be_bytes([0, 1, 2, 3].map(channel)), Dither::Off, 0, 0)
}

/// The two source pixels around a pixel's centre, and the second one's weight
/// in 256ths.
fn neighbours(v: u32, from: u32, to: u32) -> (u32, u32, u32) {
    // Of 512ths of a source pixel, from the first one's centre.
    let at = (i64::from(2 * v + 1) * i64::from(from) * 256 / i64::from(to) - 256).max(0);
    let first = ((at / 512) as u32).min(from - 1);
    (first, (first + 1).min(from - 1), (at % 512 / 2) as u32)
}
