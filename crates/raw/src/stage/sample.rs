//! Stage 3, first half: fetching a texel.
//!
//! Source: RAW, texture listing and its table of wrap examples; f32 arithmetic in its order.

use super::{floor_f32, trunc_f32, trunc_i32};
use crate::color;
use crate::errata::Errata;
use crate::state::{PrimInfo, mipmap, textile};
use crate::texture::{Texture, TextureManager};

/// The texel of one fragment, and the memory words it was made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sample {
    /// The texel, rgba; 0 when there is no texture.
    pub texel: u32,
    /// Whether a texture was looked up at all.
    pub looked_up: bool,
    /// Word addresses read, for the cache model.
    pub addresses: [Option<usize>; MAX_TEXELS],
}

/// The most texels one lookup reads: four of each of two levels.
pub const MAX_TEXELS: usize = 8;

/// Looks the texel for coordinates `u`, `v` up. `footprint` is how far they move in one pixel.
#[inline(always)]
pub fn sample(
    textures: &TextureManager,
    info: &PrimInfo,
    [u, v]: [f32; 2],
    footprint: [f32; 2],
    errata: &Errata,
) -> Sample {
    if !info.mode.uses_texture() {
        return Sample::default();
    }
    let Some(texture) = textures.get(info.texture_id) else { return Sample::default() };
    let at = |texture| Sampler { textures, texture, tile: info.mode.textile(), errata };
    let smooth = info.mode.tex_interp() == 1;
    if info.mode.mipmap() == mipmap::OFF || texture.levels == 1 {
        return at(texture).look_up([u, v], smooth);
    }
    let lod = level_of_detail(&texture, footprint);
    if info.mode.mipmap() == mipmap::NEAREST {
        return at(texture.level((lod + 0.5) as u32)).look_up([u, v], smooth);
    }
    let (level, fraction) = (lod as u32, lod - (lod as u32) as f32);
    let fine = at(texture.level(level)).look_up([u, v], smooth);
    if fraction == 0.0 {
        return fine;
    }
    let coarse = at(texture.level(level + 1)).look_up([u, v], smooth);
    blend(&fine, &coarse, fraction)
}

/// Which level matches: the logarithm of how many texels of the finest level a pixel covers along
/// its longer side, at least 0, at most the coarsest level. Between powers of two the logarithm is
/// taken as linear. Beyond the thesis.
fn level_of_detail(texture: &Texture, [du, dv]: [f32; 2]) -> f32 {
    let texels = (du * texture.width as f32).max(dv * texture.height as f32);
    if texels.is_nan() || texels <= 1.0 {
        return 0.0;
    }
    let exponent = (texels.to_bits() >> 23) as i32 - 127;
    let mantissa = f32::from_bits(texels.to_bits() & 0x7f_ffff | 0x3f80_0000);
    (exponent as f32 + (mantissa - 1.0)).min((texture.levels - 1) as f32)
}

/// Two levels mixed; channels are cut to bytes.
fn blend(fine: &Sample, coarse: &Sample, fraction: f32) -> Sample {
    let mixed = color::per_channel(fine.texel, coarse.texel, |a, b| {
        trunc_i32(a as f32 * (1.0 - fraction) + b as f32 * fraction) as u32
    });
    let mut addresses = fine.addresses;
    addresses[MAX_TEXELS / 2..].copy_from_slice(&coarse.addresses[..MAX_TEXELS / 2]);
    Sample { texel: mixed, looked_up: true, addresses }
}

struct Sampler<'a> {
    textures: &'a TextureManager,
    texture: Texture,
    tile: u32,
    errata: &'a Errata,
}

impl Sampler<'_> {
    #[inline(always)]
    fn look_up(&self, [u, v]: [f32; 2], smooth: bool) -> Sample {
        if smooth { self.bilinear(u, v) } else { self.nearest(u, v) }
    }

    #[inline(always)]
    fn nearest(&self, u: f32, v: f32) -> Sample {
        let (w, h) = (self.texture.width, self.texture.height);
        let x = self.index(self.wrap(u) * w as f32);
        let y = self.index(self.wrap(v) * h as f32);
        let v_size = if self.errata.clamp_v_by_width { w } else { h };
        let address = self.address(self.limit(x, w, w), self.limit(y, h, v_size));
        let texel = address.map_or(0, |a| self.textures.word(a));
        Sample { texel, looked_up: true, addresses: first(&[address]) }
    }

    #[inline(always)]
    fn bilinear(&self, u: f32, v: f32) -> Sample {
        let (x0, x1, fx) = self.neighbours(u, self.texture.width);
        let (y0, y1, fy) = self.neighbours(v, self.texture.height);
        let at = [(x0, y0), (x1, y0), (x0, y1), (x1, y1)].map(|(x, y)| self.address(x, y));
        let texels = at.map(|a| {
            let word = a.map_or(0, |a| self.textures.word(a));
            color::unpack(word).map(|c| c as f32)
        });
        let across = |left: &[f32; 4], right: &[f32; 4]| -> [f32; 4] {
            std::array::from_fn(|c| left[c] * (1.0 - fx) + right[c] * fx)
        };
        // The upper row is cut to a byte before the second blend, the lower one is not.
        let top = across(&texels[0], &texels[1]).map(|t| (trunc_i32(t) & 0xff) as f32);
        let bottom = across(&texels[2], &texels[3]);
        let channels: [u32; 4] =
            std::array::from_fn(|c| trunc_i32(top[c] * (1.0 - fy) + bottom[c] * fy) as u32);
        let texel = color::pack(channels[0], channels[1], channels[2], channels[3]);
        Sample { texel, looked_up: true, addresses: first(&at) }
    }

    /// Lower and upper texel index along one axis, and the weight of the upper one.
    #[inline(always)]
    fn neighbours(&self, c: f32, size: u32) -> (i64, i64, f32) {
        let mut c = self.wrap(c - 0.5 / size as f32) * size as f32;
        if self.tile == textile::CLAMP {
            c = c.clamp(0.0, size as f32 - 1.0);
        }
        if self.tile == textile::MIRROR && !self.errata.bilinear_mirror_inner {
            return self.mirrored(c, size);
        }
        let low = self.index(c);
        let fraction = c - low as f32;
        let mut high = low + 1;
        if high >= i64::from(size) {
            high = match self.tile {
                textile::CLAMP => low,
                textile::REPEAT => 0,
                textile::MIRROR => (low - 1).max(0),
                _ => high,
            };
        }
        // A repeat can land exactly on the far edge; that is the first texel again.
        let low = if self.repeats_fully() { repeated(low, size) } else { low };
        (low, high, fraction)
    }

    /// Neighbours under mirroring, where the texel beyond an edge is the edge texel itself.
    #[inline(always)]
    fn mirrored(&self, c: f32, size: u32) -> (i64, i64, f32) {
        let low = self.index(c);
        let last = i64::from(size) - 1;
        (low.clamp(0, last), (low + 1).clamp(0, last), c - low as f32)
    }

    #[inline(always)]
    fn repeats_fully(&self) -> bool {
        self.tile == textile::REPEAT && !self.errata.repeat_to_one
    }

    /// Maps a coordinate into 0..1 as the tiling mode says.
    #[inline(always)]
    fn wrap(&self, c: f32) -> f32 {
        match self.tile {
            textile::REPEAT => {
                let c = c - trunc_f32(c);
                if c < 0.0 { c + 1.0 } else { c }
            }
            textile::MIRROR => self.mirror(c),
            _ => c,
        }
    }

    #[inline(always)]
    fn mirror(&self, c: f32) -> f32 {
        let size = c.abs();
        // The listing takes the whole part of the signed coordinate.
        let whole = if self.errata.mirror_wrap { trunc_f32(c) } else { trunc_f32(size) };
        let fraction = size - whole;
        if whole % 2.0 != 0.0 { 1.0 - fraction } else { fraction }
    }

    #[inline(always)]
    fn index(&self, c: f32) -> i64 {
        let whole = if self.errata.texel_truncates { trunc_f32(c) } else { floor_f32(c) };
        whole as i64
    }

    /// Keeps an index inside the texture where the tiling mode demands it. `clamp_to` is the size
    /// the clamp mode uses.
    #[inline(always)]
    fn limit(&self, index: i64, size: u32, clamp_to: u32) -> i64 {
        match self.tile {
            textile::CLAMP => index.clamp(0, i64::from(clamp_to) - 1),
            textile::REPEAT if !self.errata.repeat_to_one => repeated(index, size),
            textile::MIRROR if !self.errata.mirror_wrap => index.clamp(0, i64::from(size) - 1),
            _ => index,
        }
    }

    #[inline(always)]
    fn address(&self, x: i64, y: i64) -> Option<usize> {
        let inside = (0..i64::from(self.texture.width)).contains(&x)
            && (0..i64::from(self.texture.height)).contains(&y);
        inside.then(|| self.texture.address(x as u32, y as u32))
    }
}

/// An index modulo the size; nearly always it is inside already.
#[inline(always)]
fn repeated(index: i64, size: u32) -> i64 {
    let size = i64::from(size);
    if (0..size).contains(&index) { index } else { index.rem_euclid(size) }
}

/// The addresses of one level.
#[inline(always)]
fn first(addresses: &[Option<usize>]) -> [Option<usize>; MAX_TEXELS] {
    std::array::from_fn(|i| addresses.get(i).copied().flatten())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn setup(tile: u32, interp: u32) -> (TextureManager, PrimInfo) {
        let mut textures = TextureManager::new(4096, 4, Errata::CORRECT);
        let id = textures.allocate(10, 1);
        for x in 0..10 {
            textures.upload_word(id, x, x as u32 + 1);
        }
        let mut info = PrimInfo::default();
        info.mode.set_texmode(2);
        info.mode.set_textile(tile);
        info.mode.set_tex_interp(interp);
        (textures, info)
    }

    fn nearest(tile: u32, u: f32) -> u32 {
        let (textures, info) = setup(tile, 0);
        sample(&textures, &info, [u, 0.5], [0.0; 2], &Errata::CORRECT).texel
    }

    #[test]
    fn wrap_examples_of_the_thesis() {
        let cases = [
            (textile::REPEAT, -1.4, 0.6),
            (textile::REPEAT, 1.3, 0.3),
            (textile::REPEAT, -3.9, 0.1),
            (textile::MIRROR, -1.4, 0.6),
            (textile::MIRROR, -1.2, 0.8),
            (textile::MIRROR, -0.4, 0.4),
            (textile::MIRROR, 1.2, 0.8),
            (textile::MIRROR, 1.8, 0.2),
            (textile::MIRROR, 2.2, 0.2),
        ];
        for (tile, from, to) in cases {
            // Half a texel away from the border between texels, so that rounding does not matter.
            assert_eq!(nearest(tile, from + 0.01), {
                let sign = if nearest_slope(tile, from) { 0.01 } else { -0.01 };
                nearest(textile::NONE, to + sign)
            });
        }
    }

    /// Whether the mapped coordinate grows with the original one.
    fn nearest_slope(tile: u32, from: f32) -> bool {
        tile == textile::REPEAT || from.floor().rem_euclid(2.0) == 0.0
    }

    #[test]
    fn outside_is_transparent_without_tiling_and_edge_when_clamped() {
        assert_eq!(nearest(textile::NONE, -0.05), 0);
        assert_eq!(nearest(textile::NONE, 1.05), 0);
        assert_eq!(nearest(textile::CLAMP, -3.0), 1);
        assert_eq!(nearest(textile::CLAMP, 3.0), 10);
        assert_eq!(nearest(textile::MIRROR, -1.0), 10);
        assert_eq!(nearest(textile::REPEAT, -1e-9), 1);
        assert_eq!(nearest(textile::REPEAT, f32::NAN), 1);
    }

    #[test]
    fn bilinear_truncates_the_upper_row_first() {
        let mut textures = TextureManager::new(64, 1, Errata::CORRECT);
        let id = textures.allocate(2, 2);
        for (index, texel) in [1, 2, 2, 4].into_iter().enumerate() {
            textures.upload_word(id, index, texel);
        }
        let (_, mut info) = setup(textile::CLAMP, 1);
        info.texture_id = id;
        let s = sample(&textures, &info, [0.5; 2], [0.0; 2], &Errata::CORRECT);
        // Upper row: trunc(1.5) = 1; lower row 3; halves: trunc(2.0) = 2, not trunc(2.25).
        assert_eq!(s.texel, 2);
        assert_eq!(s.addresses.iter().flatten().count(), 4);
    }

    #[test]
    fn bad_texture_ids_give_no_texel() {
        let (textures, mut info) = setup(textile::REPEAT, 0);
        info.texture_id = u32::MAX;
        assert_eq!(
            sample(&textures, &info, [0.5; 2], [0.0; 2], &Errata::FAITHFUL),
            Sample::default()
        );
    }

    #[test]
    fn the_footprint_chooses_the_level() {
        let mut textures = TextureManager::new(4096, 1, Errata::CORRECT);
        let id = textures.allocate_mipmapped(8, 8);
        let texture = textures.get(id).expect("allocated");
        let mut next = 0;
        for level in 0..4 {
            let size = texture.level(level);
            for _ in 0..size.width * size.height {
                textures.upload_word(id, next, 0x10 * (level + 1));
                next += 1;
            }
        }
        let mut info = PrimInfo::default();
        info.mode.set_texmode(2);
        info.texture_id = id;
        let mut texel = |mode: u32, footprint: f32| {
            info.mode.set_mipmap(mode);
            sample(&textures, &info, [0.5; 2], [footprint, 0.0], &Errata::CORRECT).texel
        };
        assert_eq!(texel(0, 1.0), 0x10);
        assert_eq!([0.1, 0.25, 0.5, 1.0, 9.0].map(|f| texel(1, f)), [0x10, 0x20, 0x30, 0x40, 0x40]);
        assert_eq!([0.1, 0.1875, 0.25, f32::NAN].map(|f| texel(2, f)), [0x10, 0x18, 0x20, 0x10]);
    }
}
