//! The fragment pipeline of the Raw profile, one stamp at a time.
//!
//! depth -> texel -> alpha -> combine -> light -> blend -> write, as one
//! function over a stamp's lanes. What fails the depth test leaves no trace
//! whatever its colour, so the test comes first.
//!
//! Source: RAW, stages 2 (fragments), 3 and 4.

mod color;
mod texel;

use fillrate_simd::{IntLanes, Kernel, MaskLanes, Simd, SingleLanes};

use self::color::{Pairs, product};
use self::texel::Sampler;
pub(crate) use self::texel::floor;
use super::block::STAMP;
use super::lanes::{COLUMN, ROW};
use crate::setup::{ATTRIBUTES, RawShape, Slots, Walk};
use crate::state::{RawAlpha, RawCombine, RawDraw, RawLight};
use crate::stats::Counters;

/// The values of a stamp's slots; the one after the slots is the depth of a
/// shape without a depth plane.
pub(crate) type StampValues = [[f32; STAMP]; ATTRIBUTES + 1];

/// The scale of depths: one more than the greatest.
const DEPTHS: f32 = 2_147_483_648.0;
/// The greatest float below it.
const BELOW_DEPTHS: f32 = 2_147_483_520.0;

/// A stamp's place.
#[derive(Clone, Copy)]
pub(crate) struct Place {
    /// First pixel in the tile.
    pub at: usize,
    /// Screen column and row.
    pub x: u32,
    pub y: u32,
}

/// A tile's planes.
pub(crate) struct Pixels<'a> {
    pub color: &'a mut [i32],
    /// Empty where there is none.
    pub depth: &'a mut [i32],
}

/// Steps of u, v and 1/w from column to column and from row to row.
pub(super) struct Derivatives([[f32; 3]; 2]);

impl Derivatives {
    fn new(walk: &Walk, slots: &Slots) -> Option<Derivatives> {
        let (u, w1) = (slots.u()?, slots.w1()?);
        Some(Derivatives([&walk.dx, &walk.dy].map(|step| [step[u], step[u + 1], step[w1]])))
    }

    /// How far u and v move from a pixel to the next, the larger of both axes:
    /// the slopes of the quotients u = U / q, v = V / q, where w = 1 / q.
    fn footprint(&self, u: f32, v: f32, w: f32) -> [f32; 2] {
        let along = |i: usize, value: f32| {
            let slope = |step: &[f32; 3]| ((step[i] - value * step[2]) * w).abs();
            slope(&self.0[0]).max(slope(&self.0[1]))
        };
        [along(0, u), along(1, v)]
    }
}

/// A shape within a tile, ready to draw stamps.
pub(crate) struct RawPainter<'a> {
    draw: &'a RawDraw,
    shape: &'a RawShape,
    walk: Option<&'a Walk>,
    slots: Slots,
    sampler: Option<Sampler<'a>>,
    steps: Option<Derivatives>,
}

impl<'a> RawPainter<'a> {
    pub fn new(draw: &'a RawDraw, shape: &'a RawShape, walk: Option<&'a Walk>) -> Self {
        let slots = Slots::of(draw);
        RawPainter {
            draw,
            shape,
            walk,
            slots,
            sampler: Sampler::new(draw),
            steps: walk.and_then(|walk| Derivatives::new(walk, &slots)),
        }
    }

    /// The slots in use.
    pub fn slots(&self) -> &Slots {
        &self.slots
    }

    /// The fragments of `mask` that pass the depth test; the stamp's depths go
    /// to `depths`.
    #[inline(always)]
    pub fn test<S: Simd>(
        &self,
        s: S,
        place: Place,
        mask: u32,
        values: &StampValues,
        pixels: &Pixels<'_>,
        depths: &mut [i32; STAMP],
    ) -> u32 {
        let state = &self.draw.state;
        if !state.uses_depth() || pixels.depth.is_empty() {
            return mask;
        }
        let mut live = mask;
        for j in (0..STAMP).step_by(S::LANES) {
            let z = match self.walk {
                Some(walk) => plane(s, &walk.z, place, j),
                None => s.load_g(&values[ATTRIBUTES][j..]),
            };
            let z = self.depth_word(s, z);
            s.store(z, &mut depths[j..]);
            if state.test {
                let stored = s.load(&pixels.depth[place.at + j..]);
                let farther = if state.quirks.unsigned_depth {
                    let sign = s.splat(i32::MIN);
                    (z ^ sign).gt(stored ^ sign)
                } else {
                    z.gt(stored)
                };
                live &= !(farther.bits() << j);
            }
        }
        live
    }

    #[inline(always)]
    fn depth_word<S: Simd>(&self, s: S, z: S::G) -> S::I {
        let scaled = z * s.splat_g(DEPTHS);
        let word = scaled.to_i32();
        if !self.draw.state.quirks.depth_overflows {
            return word;
        }
        s.splat(i32::MIN).select(word, s.splat_g(BELOW_DEPTHS).lt(scaled))
    }

    /// Draws the fragments of `mask` of a stamp, which passed the depth test. A
    /// function of its own: it is long.
    #[inline(always)]
    pub fn draw<S: Simd>(
        &self,
        s: S,
        place: Place,
        mask: u32,
        (values, depths): (&StampValues, &[i32; STAMP]),
        pixels: &mut Pixels<'_>,
        counters: &mut Counters,
    ) {
        s.vectorize(Fragments { painter: self, place, mask, values, depths, pixels, counters });
    }

    #[inline(always)]
    fn fragments<S: Simd>(
        &self,
        s: S,
        place: Place,
        mask: u32,
        (values, depths): (&StampValues, &[i32; STAMP]),
        pixels: &mut Pixels<'_>,
        counters: &mut Counters,
    ) {
        let state = &self.draw.state;
        for j in (0..STAMP).step_by(S::LANES) {
            let mut live = mask >> j & ((1u64 << S::LANES) - 1) as u32;
            if live == 0 {
                continue;
            }
            let color = self.color(s, values, j);
            let alpha = color.alpha(s);
            live &= !alpha.eq(s.splat(0)).bits();
            if live == 0 {
                continue;
            }
            counters.pixels_out += u64::from(live.count_ones());
            let on = s.mask(live);
            if state.color_write {
                let to = &mut pixels.color[place.at + j..];
                let opaque = alpha.eq(s.splat(255)).bits();
                let color = match live & !opaque {
                    0 => color,
                    // An alpha of 255 leaves the colour as it is.
                    _ => color.mix(s, Pairs::unpack(s, s.load(to)), alpha),
                };
                s.store_masked(color.opaque_words(s), to, on);
            }
            if state.depth_write && !pixels.depth.is_empty() {
                s.store_masked(s.load(&depths[j..]), &mut pixels.depth[place.at + j..], on);
            }
        }
    }

    /// The colours of fragments `j..` of a stamp.
    #[inline(always)]
    fn color<S: Simd>(&self, s: S, values: &StampValues, j: usize) -> Pairs<S::I> {
        let state = &self.draw.state;
        let at = Fragment { values, j, w: self.w(s, values, j) };
        let wraps = state.quirks.channels_wrap;
        let base = match self.slots.red() {
            Some(red) => {
                let alpha = match self.slots.alpha() {
                    Some(alpha) => at.byte(s, alpha, wraps),
                    None => s.splat(0),
                };
                at.color(s, red, alpha, wraps)
            }
            None => Pairs::splat(s, self.shape.color),
        };
        let texel = match (&self.sampler, self.slots.u()) {
            (Some(sampler), Some(u)) => {
                let uv = [at.value(s, u), at.value(s, u + 1)];
                sampler.sample(s, uv, at.w, self.steps.as_ref())
            }
            _ => Pairs::splat(s, 0),
        };
        let color = self.combine(s, base, texel);
        match &state.light {
            Some(light) => self.light(s, light, color, &at),
            None => color,
        }
    }

    /// w of fragments `j..` of a stamp, where something is interpolated.
    #[inline(always)]
    fn w<S: Simd>(&self, s: S, values: &StampValues, j: usize) -> S::G {
        match self.slots.w1() {
            Some(w1) => s.splat_g(1.0) / s.load_g(&values[w1][j..]),
            None => s.splat_g(0.0),
        }
    }

    /// An alpha as its rule counts it.
    #[inline(always)]
    fn condition<S: Simd>(&self, s: S, color: Pairs<S::I>, rule: RawAlpha) -> Pairs<S::I> {
        match rule {
            RawAlpha::Opaque => Pairs { ga: color.ga | s.splat(0xff), ..color },
            RawAlpha::Soft => color,
            RawAlpha::Hard => {
                let below = self.draw.state.threshold.min(256) as i32 - 1;
                let passes = color.alpha(s).gt(s.splat(below));
                color.with_alpha(s, s.splat(255).select(s.splat(0), passes))
            }
        }
    }

    #[inline(always)]
    fn combine<S: Simd>(&self, s: S, base: Pairs<S::I>, texel: Pairs<S::I>) -> Pairs<S::I> {
        let state = &self.draw.state;
        let mut texel = self.condition(s, texel, state.texel_alpha);
        let mut base = self.condition(s, base, state.color_alpha);
        match state.combine {
            RawCombine::Black => Pairs::splat(s, 0xff),
            RawCombine::Color => base,
            RawCombine::Texture => texel,
            RawCombine::Modulate => base.modulate(s, texel),
            RawCombine::TextureDecal => self.decal(s, texel, base),
            RawCombine::ColorDecal => self.decal(s, base, texel),
            RawCombine::Blend => {
                // A hard hole in one layer stays a hole in the blend.
                if state.texel_alpha == RawAlpha::Hard {
                    base = base.with_hole(s, texel);
                }
                if state.color_alpha == RawAlpha::Hard {
                    texel = texel.with_hole(s, base);
                }
                base.mix(s, texel, s.splat(state.balance.into()))
            }
        }
    }

    #[inline(always)]
    fn decal<S: Simd>(&self, s: S, over: Pairs<S::I>, under: Pairs<S::I>) -> Pairs<S::I> {
        let k = over.alpha(s);
        let mixed = over.mix(s, under, k);
        if !self.draw.state.quirks.decal_over_alpha {
            return mixed;
        }
        mixed.with_alpha(s, k + product(s, under.alpha(s), s.splat(255) - k))
    }

    #[inline(always)]
    fn light<S: Simd>(
        &self,
        s: S,
        light: &RawLight,
        color: Pairs<S::I>,
        at: &Fragment<'_, S>,
    ) -> Pairs<S::I> {
        let wraps = self.draw.state.quirks.channels_wrap;
        let mut lit = Pairs::splat(s, 0);
        if let Some(ambient) = light.ambient {
            lit = Pairs::splat(s, ambient).modulate(s, color);
        }
        if let Some(direct) = light.direct {
            let intensity = match self.slots.intensity() {
                Some(i) => at.value(s, i),
                None => s.splat_g(self.shape.intensity),
            };
            let scaled = intensity * s.splat_g(256.0);
            let mut strength = scaled.to_i32().max(s.splat(0)).min(s.splat(255));
            if wraps {
                // As an unsigned word, a negative intensity becomes huge.
                let negative = scaled.lt(s.splat_g(f32::from_bits(0xbf7f_ffff)));
                strength = s.splat(255).select(strength, negative);
            }
            let direct = Pairs::splat(s, direct).scale(s, strength);
            lit = lit.add(s, direct.modulate(s, color));
        }
        if let Some(more) = self.slots.more() {
            let diffuse = at.color(s, more, s.splat(0), false);
            let specular = at.color(s, more + 3, s.splat(0), false);
            lit = lit.add(s, diffuse.modulate(s, color)).add(s, specular);
        }
        lit.with_alpha(s, color.alpha(s))
    }
}

/// Some of a stamp's fragments.
struct Fragment<'a, S: Simd> {
    values: &'a StampValues,
    /// The first of them.
    j: usize,
    w: S::G,
}

impl<S: Simd> Fragment<'_, S> {
    /// What a slot's attribute is.
    #[inline(always)]
    fn value(&self, s: S, slot: usize) -> S::G {
        s.load_g(&self.values[slot][self.j..]) * self.w
    }

    /// The same rounded to a byte.
    #[inline(always)]
    fn byte(&self, s: S, slot: usize, wraps: bool) -> S::I {
        let rounded = (self.value(s, slot) + s.splat_g(0.5)).to_i32();
        if wraps { rounded & s.splat(0xff) } else { rounded.max(s.splat(0)).min(s.splat(255)) }
    }

    /// The colour of three slots.
    #[inline(always)]
    fn color(&self, s: S, red: usize, alpha: S::I, wraps: bool) -> Pairs<S::I> {
        let (r, g) = (self.byte(s, red, wraps), self.byte(s, red + 1, wraps));
        Pairs::from_channels(r, g, self.byte(s, red + 2, wraps), alpha)
    }
}

/// A call of [`RawPainter::draw`].
struct Fragments<'a, 'b, 'c> {
    painter: &'a RawPainter<'b>,
    place: Place,
    mask: u32,
    values: &'a StampValues,
    depths: &'a [i32; STAMP],
    pixels: &'a mut Pixels<'c>,
    counters: &'a mut Counters,
}

impl Kernel for Fragments<'_, '_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        let values = (self.values, self.depths);
        self.painter.fragments(s, self.place, self.mask, values, self.pixels, self.counters);
    }
}

/// A plane at the pixel centres of fragments `j..` of a stamp.
#[inline(always)]
fn plane<S: Simd>(s: S, [dx, dy, c]: &[f32; 3], place: Place, j: usize) -> S::G {
    let half = s.splat_g(0.5);
    let x = S::G::from_i32(s.splat(place.x as i32) + s.load(&COLUMN.0[j..])) + half;
    let y = S::G::from_i32(s.splat(place.y as i32) + s.load(&ROW.0[j..])) + half;
    s.splat_g(*dx) * x + s.splat_g(*dy) * y + s.splat_g(*c)
}
