//! The Raw profile's texture look-up, in single precision.
//!
//! Source: RAW, texture listing and its table of wrap examples.

use fillrate_simd::{IntLanes, MAX_LANES, Simd, SingleLanes};

use super::Derivatives;
use super::color::Pairs;
use crate::state::{RawDraw, RawLevel, RawMipmap, RawState, RawTexture, RawTiling};

/// Floats from here on are whole.
const WHOLE: f32 = 8_388_608.0;

#[inline(always)]
fn abs<S: Simd>(s: S, x: S::G) -> S::G {
    S::G::from_bits(x.to_bits() & s.splat(i32::MAX))
}

/// Rounded towards zero.
#[inline(always)]
fn truncate<S: Simd>(s: S, x: S::G) -> S::G {
    let small = abs(s, x).lt(s.splat_g(WHOLE));
    S::G::from_i32(x.to_i32()).select(x, small)
}

/// Rounded down.
#[inline(always)]
pub(crate) fn floor<S: Simd>(s: S, x: S::G) -> S::G {
    let whole = truncate(s, x);
    (whole - s.splat_g(1.0)).select(whole, x.lt(whole))
}

/// A coordinate's texels: the lower and the upper one, and the upper one's
/// weight.
struct Neighbours<S: Simd> {
    low: S::I,
    high: S::I,
    weight: S::G,
}

/// One axis of the levels that the lanes read.
#[derive(Clone, Copy)]
struct Axis<S: Simd> {
    size: S::I,
    size_f: S::G,
    /// Half a texel.
    half: S::G,
}

impl<S: Simd> Axis<S> {
    #[inline(always)]
    fn new(s: S, size: S::I) -> Self {
        let size_f = S::G::from_i32(size);
        Axis { size, size_f, half: s.splat_g(0.5) / size_f }
    }
}

/// The levels that the lanes read.
#[derive(Clone, Copy)]
struct Levels<S: Simd> {
    u: Axis<S>,
    v: Axis<S>,
    base: S::I,
}

impl<S: Simd> Levels<S> {
    /// The same one for all lanes.
    #[inline(always)]
    fn one(s: S, level: &RawLevel) -> Self {
        Levels {
            u: Axis::new(s, s.splat(level.width as i32)),
            v: Axis::new(s, s.splat(level.height as i32)),
            base: s.splat(level.base as i32),
        }
    }

    /// One for each lane; the coarsest where there are fewer.
    #[inline(always)]
    fn each(s: S, texture: &RawTexture, which: &[u32; MAX_LANES]) -> Self {
        let mut sizes = [[1; MAX_LANES]; 3];
        for lane in 0..S::LANES {
            let level = &texture.levels[(which[lane] as usize).min(texture.levels.len() - 1)];
            sizes[0][lane] = level.width as i32;
            sizes[1][lane] = level.height as i32;
            sizes[2][lane] = level.base as i32;
        }
        Levels {
            u: Axis::new(s, s.load(&sizes[0])),
            v: Axis::new(s, s.load(&sizes[1])),
            base: s.load(&sizes[2]),
        }
    }
}

/// Reads texels of a state's texture.
#[derive(Clone, Copy)]
pub(super) struct Sampler<'a> {
    state: &'a RawState,
    texture: &'a RawTexture,
}

impl<'a> Sampler<'a> {
    pub fn new(draw: &'a RawDraw) -> Option<Self> {
        Some(Sampler { state: &draw.state, texture: draw.read_texture()? })
    }

    /// The texels at coordinates; `w` and the planes' steps tell how far the
    /// coordinates move in a pixel.
    #[inline(always)]
    pub fn sample<S: Simd>(
        &self,
        s: S,
        [u, v]: [S::G; 2],
        w: S::G,
        steps: Option<&Derivatives>,
    ) -> Pairs<S::I> {
        let finest = &self.texture.levels[0];
        let mut levels = [Levels::one(s, finest); 2];
        let (mut count, mut fraction) = (1, s.splat_g(0.0));
        if self.state.mipmap != RawMipmap::Off && self.texture.levels.len() > 1 {
            let lod = self.levels_of_detail(s, [u, v, w], steps);
            if self.state.mipmap == RawMipmap::Nearest {
                levels[0] = Levels::each(s, self.texture, &lod.map(|lod| (lod + 0.5) as u32));
            } else {
                let whole = lod.map(|lod| lod as u32);
                let below = S::G::from_i32(s.load(&whole.map(|level| level as i32)));
                fraction = s.load_g(&lod) - below;
                levels[0] = Levels::each(s, self.texture, &whole);
                levels[1] = Levels::each(s, self.texture, &whole.map(|level| level + 1));
                count = 2;
            }
        }
        // One place in the code for both levels: a look-up is long.
        let mut texels = [Pairs::splat(s, 0); 2];
        for (texel, level) in texels.iter_mut().zip(&levels).take(count) {
            *texel = self.look_up(s, level, u, v);
        }
        if count == 1 {
            return texels[0];
        }
        let fade = Fade::<S> { fine: s.splat_g(1.0) - fraction, coarse: fraction };
        let [a, b] = texels;
        Pairs { ga: fade.pairs(s, a.ga, b.ga), rb: fade.pairs(s, a.rb, b.rb) }
    }

    /// The level of each lane, with its fraction; the finest without steps.
    #[inline(always)]
    fn levels_of_detail<S: Simd>(
        &self,
        s: S,
        coordinates: [S::G; 3],
        steps: Option<&Derivatives>,
    ) -> [f32; MAX_LANES] {
        let mut lod = [0.0; MAX_LANES];
        let Some(steps) = steps else { return lod };
        let mut at = [[0.0; MAX_LANES]; 3];
        s.store_g(coordinates[0], &mut at[0]);
        s.store_g(coordinates[1], &mut at[1]);
        s.store_g(coordinates[2], &mut at[2]);
        for (i, lod) in lod.iter_mut().enumerate().take(S::LANES) {
            let footprint = steps.footprint(at[0][i], at[1][i], at[2][i]);
            *lod = level_of_detail(self.texture, footprint);
        }
        lod
    }

    #[inline(always)]
    fn look_up<S: Simd>(&self, s: S, levels: &Levels<S>, u: S::G, v: S::G) -> Pairs<S::I> {
        match self.state.bilinear {
            true => self.bilinear(s, levels, u, v),
            false => self.nearest(s, levels, u, v),
        }
    }

    #[inline(always)]
    fn nearest<S: Simd>(&self, s: S, levels: &Levels<S>, u: S::G, v: S::G) -> Pairs<S::I> {
        let (axis_u, axis_v) = (&levels.u, &levels.v);
        let x = self.index(s, self.wrap(s, u) * axis_u.size_f).to_i32();
        let y = self.index(s, self.wrap(s, v) * axis_v.size_f).to_i32();
        let rows = if self.state.quirks.clamp_v_by_width { axis_u.size } else { axis_v.size };
        let x = self.limit(s, x, axis_u.size, axis_u.size);
        let y = self.limit(s, y, axis_v.size, rows);
        self.fetch(s, levels, x, y)
    }

    #[inline(always)]
    fn bilinear<S: Simd>(&self, s: S, levels: &Levels<S>, u: S::G, v: S::G) -> Pairs<S::I> {
        let (x, y) = (self.neighbours(s, u, &levels.u), self.neighbours(s, v, &levels.v));
        let a = self.fetch(s, levels, x.low, y.low);
        let b = self.fetch(s, levels, x.high, y.low);
        let c = self.fetch(s, levels, x.low, y.high);
        let d = self.fetch(s, levels, x.high, y.high);
        let one = s.splat_g(1.0);
        let filter = Filter::<S> {
            left: one - x.weight,
            right: x.weight,
            above: one - y.weight,
            below: y.weight,
        };
        Pairs {
            ga: filter.pairs(s, a.ga, b.ga, c.ga, d.ga),
            rb: filter.pairs(s, a.rb, b.rb, c.rb, d.rb),
        }
    }

    #[inline(always)]
    fn neighbours<S: Simd>(&self, s: S, c: S::G, axis: &Axis<S>) -> Neighbours<S> {
        let (tiling, quirks) = (self.state.tiling, &self.state.quirks);
        let mut c = self.wrap(s, c - axis.half) * axis.size_f;
        let (zero, one) = (s.splat(0), s.splat(1));
        let last = axis.size - one;
        if tiling == RawTiling::Clamp {
            let (least, most) = (s.splat_g(0.0), axis.size_f - s.splat_g(1.0));
            c = least.select(most.select(c, most.lt(c)), c.lt(least));
        }
        let whole = self.index(s, c);
        let low = whole.to_i32();
        // An index is taken from the coordinate as a 64-bit number.
        let most = s.splat_g(9_223_372_036_854_775_808.0);
        let least = s.splat_g(-9_223_372_036_854_775_808.0);
        let index = most.select(least.select(whole, whole.lt(least)), most.lt(whole));
        let weight = c - index;
        if tiling == RawTiling::Mirror && !quirks.bilinear_mirror_inner {
            let high = (low.min(last) + one).max(zero).min(last);
            return Neighbours { low: low.max(zero).min(last), high, weight };
        }
        let next = low.min(s.splat(i32::MAX - 1)) + one;
        let beyond = next.gt(last);
        let high = match tiling {
            RawTiling::None => next,
            RawTiling::Clamp => low.select(next, beyond),
            RawTiling::Repeat => zero.select(next, beyond),
            RawTiling::Mirror => (low - one).max(zero).select(next, beyond),
        };
        // A repeat can land exactly on the far edge; that is the first texel
        // again.
        let full = tiling == RawTiling::Repeat && !quirks.repeat_to_one;
        let low = if full { zero.select(low, low.gt(last)) } else { low };
        Neighbours { low, high, weight }
    }

    /// Maps coordinates into 0..1 as the tiling says.
    #[inline(always)]
    fn wrap<S: Simd>(&self, s: S, c: S::G) -> S::G {
        let (zero, one) = (s.splat_g(0.0), s.splat_g(1.0));
        match self.state.tiling {
            RawTiling::Repeat => {
                let c = c - truncate(s, c);
                (c + one).select(c, c.lt(zero))
            }
            RawTiling::Mirror => {
                let size = abs(s, c);
                let signed = self.state.quirks.mirror_wrap;
                let whole = truncate(s, if signed { c } else { size });
                let fraction = size - whole;
                // Floats of 2^24 and more are even.
                let odd = whole.to_i32() & s.splat(1);
                let odd = odd.eq(s.splat(1)) & abs(s, whole).lt(s.splat_g(2.0 * WHOLE));
                (one - fraction).select(fraction, odd)
            }
            RawTiling::None | RawTiling::Clamp => c,
        }
    }

    #[inline(always)]
    fn index<S: Simd>(&self, s: S, c: S::G) -> S::G {
        if self.state.quirks.texel_truncates { truncate(s, c) } else { floor(s, c) }
    }

    /// Keeps indices inside the texture where the tiling demands it.
    #[inline(always)]
    fn limit<S: Simd>(&self, s: S, index: S::I, size: S::I, clamp_to: S::I) -> S::I {
        let (zero, one) = (s.splat(0), s.splat(1));
        let quirks = &self.state.quirks;
        match self.state.tiling {
            RawTiling::Clamp => index.max(zero).min(clamp_to - one),
            RawTiling::Repeat if !quirks.repeat_to_one => zero.select(index, index.gt(size - one)),
            RawTiling::Mirror if !quirks.mirror_wrap => index.max(zero).min(size - one),
            _ => index,
        }
    }

    /// The texels at columns and rows; 0 outside.
    #[inline(always)]
    fn fetch<S: Simd>(&self, s: S, levels: &Levels<S>, x: S::I, y: S::I) -> Pairs<S::I> {
        let outside = s.splat(-1);
        let inside = x.gt(outside) & levels.u.size.gt(x) & y.gt(outside) & levels.v.size.gt(y);
        let at = (levels.base + y.mul(levels.u.size) + x).select(s.splat(0), inside);
        let (ga, rb) = s.load_pairs(&self.texture.entries, at);
        let zero = s.splat(0);
        Pairs { ga: ga.select(zero, inside), rb: rb.select(zero, inside) }
    }
}

/// Both channels of a pair as floats.
#[inline(always)]
fn floats<S: Simd>(s: S, pair: S::I) -> [S::G; 2] {
    [S::G::from_i32(pair & s.splat(0xff)), S::G::from_i32(pair.shr(16))]
}

/// A pair from the low bytes of two channels.
#[inline(always)]
fn pair<S: Simd>(s: S, low: S::I, high: S::I) -> S::I {
    (low & s.splat(0xff)) | (high & s.splat(0xff)).shl(16)
}

/// Weights of two levels.
#[derive(Clone, Copy)]
struct Fade<S: Simd> {
    fine: S::G,
    coarse: S::G,
}

impl<S: Simd> Fade<S> {
    #[inline(always)]
    fn pairs(self, s: S, a: S::I, b: S::I) -> S::I {
        let ([a0, a1], [b0, b1]) = (floats(s, a), floats(s, b));
        let low = a0 * self.fine + b0 * self.coarse;
        let high = a1 * self.fine + b1 * self.coarse;
        pair(s, low.to_i32(), high.to_i32())
    }
}

/// Weights of four neighbours.
#[derive(Clone, Copy)]
struct Filter<S: Simd> {
    left: S::G,
    right: S::G,
    above: S::G,
    below: S::G,
}

impl<S: Simd> Filter<S> {
    #[inline(always)]
    fn channel(self, s: S, a: S::G, b: S::G, c: S::G, d: S::G) -> S::I {
        // The upper row is cut to a byte before the second blend, the lower
        // one is not.
        let top = (a * self.left + b * self.right).to_i32() & s.splat(0xff);
        let bottom = c * self.left + d * self.right;
        (S::G::from_i32(top) * self.above + bottom * self.below).to_i32()
    }

    #[inline(always)]
    fn pairs(self, s: S, a: S::I, b: S::I, c: S::I, d: S::I) -> S::I {
        let ([a0, a1], [b0, b1]) = (floats(s, a), floats(s, b));
        let ([c0, c1], [d0, d1]) = (floats(s, c), floats(s, d));
        pair(s, self.channel(s, a0, b0, c0, d0), self.channel(s, a1, b1, c1, d1))
    }
}

/// Which level matches: the logarithm of how many texels of the finest level a
/// pixel covers along its longer side, linear between powers of two.
fn level_of_detail(texture: &RawTexture, [du, dv]: [f32; 2]) -> f32 {
    let finest = &texture.levels[0];
    let texels = (du * finest.width as f32).max(dv * finest.height as f32);
    if texels.is_nan() || texels <= 1.0 {
        return 0.0;
    }
    let exponent = (texels.to_bits() >> 23) as i32 - 127;
    let mantissa = f32::from_bits(texels.to_bits() & 0x7f_ffff | 0x3f80_0000);
    (exponent as f32 + (mantissa - 1.0)).min((texture.levels.len() - 1) as f32)
}
