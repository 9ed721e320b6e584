//! The fragment pipeline of the Quark profile, one stamp at a time.
//!
//! depth -> texel -> key -> intensity -> blend -> write. The steps are few and
//! short, so that they are one function over a stamp's lanes, with nothing
//! kept between stamps but the offsets of the planes within a stamp.

use fillrate_simd::{FloatLanes, IntLanes, MaskLanes, Simd};

use super::block::STAMP;
use super::depth::compare;
use super::lanes::{COLUMN, COLUMN_F, ROW, ROW_F};
use crate::setup::{Plane32, Plane64, Shape, Texels};
use crate::state::{PaletteBlend, PaletteDraw};
use crate::stats::Counters;

/// Where a shape's base colours come from; the axis that kernels are made for.
pub(crate) mod source {
    /// One colour.
    pub const FLAT: u8 = 0;
    /// Texels by coordinate planes.
    pub const AFFINE: u8 = 1;
    /// Texels by planes divided by depth.
    pub const PERSPECTIVE: u8 = 2;
}

/// Planes' offsets of a stamp's fragments from its first.
#[derive(Clone, Copy)]
struct Offsets([i32; STAMP]);

impl Offsets {
    #[inline(always)]
    fn new<S: Simd>(s: S, plane: &Plane32) -> Offsets {
        let mut out = [0; STAMP];
        for j in (0..STAMP).step_by(S::LANES) {
            let lanes = s.load(&COLUMN.0[j..]).mul(s.splat(plane.dx))
                + s.load(&ROW.0[j..]).mul(s.splat(plane.dy));
            s.store(lanes, &mut out[j..]);
        }
        Offsets(out)
    }

    #[inline(always)]
    fn at<S: Simd>(&self, s: S, plane: &Plane32, x: i32, y: i32, j: usize) -> S::I {
        s.splat(plane.at(x, y)) + s.load(&self.0[j..])
    }
}

/// [`Offsets`] of a plane in floats.
#[derive(Clone, Copy)]
struct WideOffsets([f64; STAMP]);

impl WideOffsets {
    #[inline(always)]
    fn new<S: Simd>(s: S, plane: &Plane64) -> WideOffsets {
        let mut out = [0.0; STAMP];
        for j in (0..STAMP).step_by(S::LANES) {
            let lanes = s.load_f(&COLUMN_F.0[j..]) * s.splat_f(plane.dx as f64)
                + s.load_f(&ROW_F.0[j..]) * s.splat_f(plane.dy as f64);
            s.store_f(lanes, &mut out[j..]);
        }
        WideOffsets(out)
    }

    #[inline(always)]
    fn at<S: Simd>(&self, s: S, plane: &Plane64, x: i32, y: i32, j: usize) -> S::F {
        s.splat_f(plane.at(x, y) as f64) + s.load_f(&self.0[j..])
    }
}

/// The finest level of the texture.
struct Sampler<'a> {
    entries: &'a [u64],
    base: i32,
    pitch: i32,
    masks: [i32; 2],
    bits: [u32; 2],
}

/// The texture of a state that has none.
static NO_TEXELS: [u64; 1] = [0];

impl<'a> Sampler<'a> {
    fn new(draw: &'a PaletteDraw) -> Sampler<'a> {
        let Some(texture) = &draw.texture else {
            let entries = &NO_TEXELS;
            return Sampler { entries, base: 0, pitch: 0, masks: [0; 2], bits: [0; 2] };
        };
        let (desc, level) = (texture.desc(), texture.level(0));
        Sampler {
            entries: texture.entries(),
            base: level.base as i32,
            pitch: level.pitch as i32,
            masks: [level.s_mask as i32, level.t_mask as i32],
            bits: [desc.s_bits.into(), desc.t_bits.into()],
        }
    }

    /// The texels at columns and rows that may lie outside.
    #[inline(always)]
    fn fetch<S: Simd>(&self, s: S, column: S::I, row: S::I) -> S::I {
        let column = column & s.splat(self.masks[0]);
        let row = row & s.splat(self.masks[1]);
        let at = s.splat(self.base) + column + row.mul(s.splat(self.pitch));
        s.load_pairs(self.entries, at).0 & s.splat(0xff)
    }
}

/// A stamp's place.
#[derive(Clone, Copy)]
pub(crate) struct Place {
    /// First pixel in the tile.
    pub at: usize,
    /// Screen column and row.
    pub x: i32,
    pub y: i32,
}

/// A tile's planes.
pub(crate) struct Pixels<'a> {
    pub color: &'a mut [u16],
    /// Empty where there is none.
    pub depth: &'a mut [u16],
}

/// A shape within a tile, ready to draw stamps.
pub(crate) struct StampPainter<'a, const SOURCE: u8> {
    draw: &'a PaletteDraw,
    shape: &'a Shape,
    sampler: Sampler<'a>,
    blend: Option<&'a PaletteBlend>,
    depth: Offsets,
    intensity: Offsets,
    texel: [Offsets; 2],
    wide: [WideOffsets; 3],
}

impl<'a, const SOURCE: u8> StampPainter<'a, SOURCE> {
    #[inline(always)]
    pub fn new<S: Simd>(s: S, draw: &'a PaletteDraw, shape: &'a Shape) -> Self {
        let mut texel = [Offsets([0; STAMP]); 2];
        let mut wide = [WideOffsets([0.0; STAMP]); 3];
        match &shape.texels {
            Texels::Affine { planes, .. } if SOURCE == source::AFFINE => {
                texel = [Offsets::new(s, &planes[0]), Offsets::new(s, &planes[1])];
            }
            Texels::Perspective { planes, .. } if SOURCE == source::PERSPECTIVE => {
                for (out, plane) in wide.iter_mut().zip(planes) {
                    *out = WideOffsets::new(s, plane);
                }
            }
            _ => {}
        }
        StampPainter {
            draw,
            shape,
            sampler: Sampler::new(draw),
            blend: draw.blend.as_deref().filter(|_| draw.state.blend),
            depth: Offsets::new(s, &shape.depth),
            intensity: Offsets::new(s, &shape.intensity),
            texel,
            wide,
        }
    }

    /// Draws the fragments of `mask` of a stamp.
    #[inline(always)]
    pub fn stamp<S: Simd>(
        &self,
        s: S,
        place: Place,
        mask: u32,
        pixels: &mut Pixels<'_>,
        counters: &mut Counters,
    ) {
        let Place { at, x, y } = place;
        for j in (0..STAMP).step_by(S::LANES) {
            let mut live = mask >> j & ((1u64 << S::LANES) - 1) as u32;
            if live == 0 {
                continue;
            }
            let depth = self.depth.at(s, &self.shape.depth, x, y, j).shr(16);
            if let Some(test) = self.draw.state.test
                && !pixels.depth.is_empty()
            {
                let passed = compare(s, test, depth, s.load16(&pixels.depth[at + j..])).bits();
                counters.depth_fail += u64::from((live & !passed).count_ones());
                live &= passed;
                if live == 0 {
                    continue;
                }
            }
            let mut base = s.splat(self.shape.color.into());
            if SOURCE != source::FLAT {
                let texel = self.texels(s, x, y, j);
                if let Some(key) = self.draw.state.key {
                    let is_key = texel.eq(s.splat(key.into())).bits();
                    counters.chroma_fail += u64::from((live & is_key).count_ones());
                    live &= !is_key;
                    if live == 0 {
                        continue;
                    }
                }
                if self.draw.state.texel_color {
                    base = texel;
                }
            }
            let light = self.intensity.at(s, &self.shape.intensity, x, y, j).sar(16);
            let light = light.max(s.splat(0)).min(s.splat(255)).shr(3).shl(8);
            let mut color = base | light;
            if let Some(blend) = self.blend {
                color = average(s, blend, color, s.load16(&pixels.color[at + j..]));
            }
            counters.pixels_out += u64::from(live.count_ones());
            let live = s.mask(live);
            s.store16(color, &mut pixels.color[at + j..], live);
            if self.draw.state.depth_write && !pixels.depth.is_empty() {
                s.store16(depth, &mut pixels.depth[at + j..], live);
            }
        }
    }

    /// The texels of fragments `j..` of the stamp at (x, y).
    #[inline(always)]
    fn texels<S: Simd>(&self, s: S, x: i32, y: i32, j: usize) -> S::I {
        match &self.shape.texels {
            Texels::Affine { planes, scale } if SOURCE == source::AFFINE => {
                // 16 fraction bits, and `scale` bits of which a repeat takes
                // as many as the texture has texels.
                let shift = |axis: usize| match scale {
                    0 => 16,
                    scale => 16 + scale - self.sampler.bits[axis].min(16),
                };
                let column = self.texel[0].at(s, &planes[0], x, y, j).sar(shift(0));
                let row = self.texel[1].at(s, &planes[1], x, y, j).sar(shift(1));
                self.sampler.fetch(s, column, row)
            }
            Texels::Perspective { planes, exact: true } if SOURCE == source::PERSPECTIVE => {
                let [u, v, w] = [0, 1, 2].map(|i: usize| self.wide[i].at(s, &planes[i], x, y, j));
                let scale =
                    |axis: usize| s.splat_f((1u32 << self.sampler.bits[axis]) as f64 / 256.0);
                let valid = s.splat_f(0.0).lt(w);
                let column = (u * scale(0) / w).floor_i32().select(s.splat(0), valid);
                let row = (v * scale(1) / w).floor_i32().select(s.splat(0), valid);
                self.sampler.fetch(s, column, row)
            }
            Texels::Perspective { planes, exact: false } if SOURCE == source::PERSPECTIVE => {
                let mut columns = [[0; STAMP]; 2];
                for (axis, columns) in columns.iter_mut().enumerate() {
                    for (i, column) in columns.iter_mut().enumerate().skip(j).take(S::LANES) {
                        let (x, y) = (x + (i & 3) as i32, y + (i >> 2) as i32);
                        let (over, w) = (planes[axis].at(x, y), planes[2].at(x, y));
                        *column = quotient(over, w, self.sampler.bits[axis]);
                    }
                }
                self.sampler.fetch(s, s.load(&columns[0][j..]), s.load(&columns[1][j..]))
            }
            _ => s.splat(0),
        }
    }
}

/// The low bits of `floor(over * 2^bits / (256 * w))`; 0 where w is not
/// positive.
fn quotient(over: i64, w: i64, bits: u32) -> i32 {
    if w <= 0 {
        return 0;
    }
    (i128::from(over) << bits).div_euclid(i128::from(w) << 8) as i32
}

/// Half and half of two palette colours.
#[inline(always)]
fn average<S: Simd>(s: S, blend: &PaletteBlend, a: S::I, b: S::I) -> S::I {
    let (a_rb, a_g) = s.load_pairs(&blend.channels, a);
    let (b_rb, b_g) = s.load_pairs(&blend.channels, b & s.splat(0x1fff));
    let rb = a_rb.add16(b_rb).shr16(4);
    let g = a_g.add16(b_g).shr16(4);
    // Five bits of each channel as red, green, blue.
    let index = (rb & s.splat(31)).shl(10) | g.shl(5) | rb.shr(16);
    let (low, high) = s.load_pairs(&blend.nearest, index.shr(2));
    let upper = s.splat(2).eq(index & s.splat(2));
    let pair = high.select(low, upper);
    pair.sar_each((index & s.splat(1)).shl(4)) & s.splat(0x1fff)
}
