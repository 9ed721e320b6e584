//! The texture chain: coordinates, addressing, filtering, texture combine.
//!
//! Source: SST1, texture units and textureMode register.

use fillrate_engine::state::{CombineUnit, DrawState, Filter, TextureFactor, TextureUnit};
use fillrate_engine::{Registers, Texture};

use super::Textures;
use super::combine::{Inputs, channel};
use super::dither::channels;
use super::iterate::wide;
use super::lod::{self, Lod};
use super::pixel::Position;
use super::shade::rounded;

/// 1/w of a unit without perspective: 1.
const UNIT_W: i64 = 1 << 32;

/// The chain's output; 0 where no unit is in use. Units run from the last one
/// down to unit 0, whose output it is. `None` where a unit shows keyed texels and
/// drops them.
pub fn chain(
    state: &DrawState,
    textures: &Textures,
    centred: &Registers,
    at: Position,
) -> Option<[i32; 4]> {
    let mut is_keyed = false;
    let mut other = [0; 4];
    for index in (0..state.units.len()).rev() {
        if let Some(unit) = &state.units[index] {
            let texture = textures[index].as_deref();
            other = unit_output(unit, texture, other, (centred, index, at), &mut is_keyed);
        }
    }
    (!is_keyed).then_some(other)
}

fn unit_output(
    unit: &TextureUnit,
    texture: Option<&Texture>,
    other: [i32; 4],
    (centred, index, at): (&Registers, usize, Position),
    is_keyed: &mut bool,
) -> [i32; 4] {
    let [s, t, w] = centred.tmu[index].map(|param| wide(centred, &param, at.x, at.y));
    let w = if unit.perspective { w } else { UNIT_W };
    let lod = lod::at(unit, centred, index, w, at);
    let (s, t) = (coordinate(unit, s, w), coordinate(unit, t, w));
    let at = |coarser: i32| Sample { unit, lod, coarser, s, t };
    let sampled = |sample: &Sample<'_>| texture.map_or([0; 4], |texture| sample.color(texture));
    let mut local = sampled(&at(0));
    if unit.mix_levels {
        let (coarse, part) = (sampled(&at(1)), lod.fraction());
        for (fine, coarse) in local.iter_mut().zip(coarse) {
            *fine = rounded(*fine * (256 - part) + coarse * part, 256);
        }
    }
    *is_keyed |= unit.drop_keyed && texture.is_some_and(|texture| at(0).is_keyed(texture));
    combine(unit, local, other, lod)
}

/// floor(256 * value / w) in 32 bits: 8 fraction bits of a texel of level 0.
fn coordinate(unit: &TextureUnit, value: i64, w: i64) -> i32 {
    if w == 0 || (w < 0 && unit.clamp_negative_w) {
        return 0;
    }
    let quotient = floor_div(256 * i128::from(value), i128::from(w));
    quotient.clamp(i32::MIN.into(), i32::MAX.into()) as i32
}

fn floor_div(a: i128, b: i128) -> i128 {
    let (quotient, remainder) = (a / b, a % b);
    let is_below = remainder != 0 && (remainder < 0) != (b < 0);
    quotient - i128::from(is_below)
}

/// Where a texture is sampled: a level of detail, how many levels coarser than
/// it, and coordinates with 8 fraction bits.
struct Sample<'a> {
    unit: &'a TextureUnit,
    lod: Lod,
    coarser: i32,
    s: i32,
    t: i32,
}

impl Sample<'_> {
    /// The texel, filtered.
    fn color(&self, texture: &Texture) -> [i32; 4] {
        let color = |level, place: Option<(u32, u32)>| {
            let border = texture.border().unwrap_or_default();
            channels(place.map_or(border, |(x, y)| texture.texel(level, x, y)))
        };
        self.filtered(&color, texture)
    }

    /// Whether half of the weights or more belong to keyed texels.
    fn is_keyed(&self, texture: &Texture) -> bool {
        let mark = |level, place: Option<(u32, u32)>| {
            let is_keyed = place.is_some_and(|(x, y)| texture.is_keyed(level, x, y));
            [128 * i32::from(is_keyed); 4]
        };
        self.filtered(&mark, texture)[0] >= 64
    }

    fn filtered(&self, texel: &Texel<'_>, texture: &Texture) -> [i32; 4] {
        let (unit, lod) = (self.unit, self.lod);
        let filter = if lod.is_finest { unit.magnify } else { unit.minify };
        let mut number = lod.level() + self.coarser;
        if unit.odd_levels.is_some_and(|odd| (number & 1 != 0) != odd) {
            number += 1;
        }
        let view = View { unit, texture, texel, number: number as usize };
        let shift = texture.level(view.number).shift;
        let half = if filter == Filter::Bilinear { 0x80 } else { 0 };
        let (s, t) = view.start(self.s >> shift, self.t >> shift, half);
        match filter {
            Filter::Point => view.texel(s >> 8, t >> 8),
            Filter::Bilinear => bilinear(&view, s, t),
        }
    }
}

/// Red, green, blue and alpha of a level's texel, or of the border.
type Texel<'a> = dyn Fn(usize, Option<(u32, u32)>) -> [i32; 4] + 'a;

/// Four texels weighted by four fraction bits: one exact sum, one truncation. The
/// coordinates are those of the first one.
fn bilinear(view: &View<'_>, s: i32, t: i32) -> [i32; 4] {
    let (column, row) = (s >> 8, t >> 8);
    let (ds, dt) = (s >> 4 & 15, t >> 4 & 15);
    let corners = [
        (view.texel(column, row), (16 - ds) * (16 - dt)),
        (view.texel(column + 1, row), ds * (16 - dt)),
        (view.texel(column, row + 1), (16 - ds) * dt),
        (view.texel(column + 1, row + 1), ds * dt),
    ];
    let mut sum = [0; 4];
    for (texel, weight) in corners {
        for (sum, texel) in sum.iter_mut().zip(texel) {
            *sum += texel * weight;
        }
    }
    sum.map(|sum| sum >> 8)
}

/// One level of a texture under a unit's addressing modes.
struct View<'a> {
    unit: &'a TextureUnit,
    texture: &'a Texture,
    texel: &'a Texel<'a>,
    number: usize,
}

impl View<'_> {
    /// Coordinates of 8 fraction bits less half a texel where filtered; those of
    /// a clamped texture with a border are brought between its sides first.
    fn start(&self, s: i32, t: i32, half: i32) -> (i32, i32) {
        let level = self.texture.level(self.number);
        let limit = |v: i32, mask: u32, clamps: bool| match clamps && self.has_border() {
            true => v.wrapping_sub(half).clamp(-half, mask as i32 * 256 + half),
            false => v.wrapping_sub(half),
        };
        let (clamp_s, clamp_t) = (self.unit.clamp_s, self.unit.clamp_t);
        (limit(s, level.s_mask, clamp_s), limit(t, level.t_mask, clamp_t))
    }

    fn has_border(&self) -> bool {
        self.texture.border().is_some()
    }

    /// A texel, or the border where it is outside.
    fn texel(&self, column: i32, row: i32) -> [i32; 4] {
        let level = self.texture.level(self.number);
        let is_outside = |at: i32, mask: u32, clamps: bool| {
            clamps && self.has_border() && !(0..=mask as i32).contains(&at)
        };
        if is_outside(column, level.s_mask, self.unit.clamp_s)
            || is_outside(row, level.t_mask, self.unit.clamp_t)
        {
            return (self.texel)(self.number, None);
        }
        let column = place(column, level.s_mask, self.unit.clamp_s);
        let row = place(row, level.t_mask, self.unit.clamp_t);
        (self.texel)(self.number, Some((column, row)))
    }
}

/// An index brought into 0..=mask.
fn place(index: i32, mask: u32, clamp: bool) -> u32 {
    match clamp {
        true => index.clamp(0, mask as i32) as u32,
        false => index as u32 & mask,
    }
}

fn combine(unit: &TextureUnit, local: [i32; 4], other: [i32; 4], lod: Lod) -> [i32; 4] {
    let flip = unit.trilinear && lod.level() & 1 != 0;
    let mut out = [0; 4];
    for (index, out) in out.iter_mut().enumerate() {
        let arithmetic = if index == 3 { &unit.combine.alpha } else { &unit.combine.color };
        let inputs = Inputs {
            other: other[index],
            local: local[index],
            local_alpha: local[3],
            factor: factor(arithmetic, unit, local, other, index, lod),
            one_minus: arithmetic.one_minus != flip,
        };
        *out = channel(arithmetic, inputs);
    }
    out
}

fn factor(
    arithmetic: &CombineUnit<TextureFactor>,
    unit: &TextureUnit,
    local: [i32; 4],
    other: [i32; 4],
    index: usize,
    lod: Lod,
) -> i32 {
    match arithmetic.factor {
        TextureFactor::Zero => 0,
        TextureFactor::Local => local[index],
        TextureFactor::OtherAlpha => other[3],
        TextureFactor::LocalAlpha => local[3],
        TextureFactor::Detail => detail(unit, lod),
        TextureFactor::LodFraction => lod.fraction(),
    }
}

/// The detail factor: rises as the level falls below the bias, up to a limit.
fn detail(unit: &TextureUnit, lod: Lod) -> i32 {
    let bias = i32::from(unit.detail_bias) * 256;
    if bias <= lod.value {
        return 0;
    }
    (((bias - lod.value) << unit.detail_scale) >> 8).min(i32::from(unit.detail_max))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quotients_are_rounded_down() {
        assert_eq!(floor_div(7, 2), 3);
        assert_eq!(floor_div(-7, 2), -4);
        assert_eq!(floor_div(7, -2), -4);
        assert_eq!(floor_div(-7, -2), 3);
        assert_eq!(floor_div(-8, 2), -4);
    }
}
