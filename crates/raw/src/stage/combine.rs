//! Stage 3, second half: conditioning alpha, combining colour with texture, and lighting.
//!
//! Source: RAW, combine listing and its tables.

use super::sample::{MAX_TEXELS, sample};
use super::{Fragment, UntexFragment};
use crate::color::{self, low, mul, with_low};
use crate::errata::Errata;
use crate::state::{PrimInfo, alpha, texmode};
use crate::texture::TextureManager;

/// A finished fragment and what it took, for the cost model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Textured {
    /// The fragment, ready for stage 4; alpha 0 means it is not drawn.
    pub fragment: Fragment,
    /// Whether a texel was looked up.
    pub looked_up: bool,
    /// Word addresses read in texture memory.
    pub addresses: [Option<usize>; MAX_TEXELS],
}

/// Takes one fragment through stage 3.
#[inline(always)]
pub fn process(
    textures: &TextureManager,
    info: &PrimInfo,
    input: &UntexFragment,
    errata: &Errata,
) -> Textured {
    let s = sample(textures, info, [input.u, input.v], input.footprint, errata);
    let (texel, base) = condition(info, s.texel, input.rgba);
    let combined = combine(info, base, texel, errata);
    let rgba = match info.mode.lit() {
        0 => combined,
        _ => light(info, combined, input, errata),
    };
    Textured {
        fragment: Fragment { x: input.x, y: input.y, z: input.z, rgba },
        looked_up: s.looked_up,
        addresses: s.addresses,
    }
}

/// Applies the alpha modes to texel and colour; returns both.
#[inline(always)]
fn condition(info: &PrimInfo, texel: u32, base: u32) -> (u32, u32) {
    let mode = info.mode;
    let mut texel = condition_one(texel, mode.tex_alpha(), info.alpha_thresh);
    let mut base = condition_one(base, mode.col_alpha(), info.alpha_thresh);
    if mode.texmode() == texmode::BLEND {
        // A hard hole in one layer stays a hole in the blend.
        if mode.tex_alpha() == alpha::HARD && low(texel) == 0 {
            base = with_low(base, 0);
        }
        if mode.col_alpha() == alpha::HARD && low(base) == 0 {
            texel = with_low(texel, 0);
        }
    }
    (texel, base)
}

#[inline(always)]
fn condition_one(word: u32, mode: u32, threshold: u32) -> u32 {
    match mode {
        alpha::NONE => word | color::OPAQUE,
        alpha::HARD => with_low(word, if low(word) >= threshold { 255 } else { 0 }),
        _ => word,
    }
}

#[inline(always)]
fn combine(info: &PrimInfo, base: u32, texel: u32, errata: &Errata) -> u32 {
    let decal = |over: u32, under: u32, k: u32| {
        let mixed = color::mix(over, under, k);
        if !errata.decal_over_alpha {
            return mixed;
        }
        with_low(mixed, k + mul(low(under), 255 - k))
    };
    match info.mode.texmode() {
        texmode::COLOR => base,
        texmode::TEXTURE => texel,
        texmode::BLEND => color::mix(base, texel, balance(info.col_tex_balance)),
        texmode::TEXDECAL => decal(texel, base, low(texel)),
        texmode::COLDECAL => decal(base, texel, low(base)),
        texmode::MODULATE => color::modulate(base, texel),
        _ => color::OPAQUE,
    }
}

/// The blend weight 0.0..=1.0 as 0..=255.
#[inline(always)]
pub(crate) fn balance(weight: f32) -> u32 {
    ((weight * 256.0) as u32).min(255)
}

#[inline(always)]
fn light(info: &PrimInfo, fragment: u32, input: &UntexFragment, errata: &Errata) -> u32 {
    let (mode, intensity) = (info.mode, input.intensity);
    let ambient = term(mode.use_amb(), info.amb_color, low(info.amb_color), fragment);
    let strength = light_byte(intensity, errata);
    let direct = term(mode.use_dir(), info.dir_color, strength, fragment);
    let mut lit = color::add(ambient, direct);
    if mode.more_light() == 1 {
        // Further lights shine on the surface like the first; highlights are on top of it.
        let further = color::modulate(input.diffuse, fragment);
        for light in [further, input.specular] {
            lit = color::add(lit, light);
        }
    }
    with_low(lit, low(fragment))
}

/// One light's share of each channel: light colour times its intensity times the fragment.
#[inline(always)]
fn term(used: u32, light: u32, intensity: u32, fragment: u32) -> u32 {
    if used == 0 {
        return 0;
    }
    color::modulate(color::scale(light, intensity), fragment)
}

#[inline(always)]
fn light_byte(intensity: f32, errata: &Errata) -> u32 {
    let scaled = intensity * 256.0;
    // Converted to an unsigned word, a negative intensity becomes huge.
    if errata.channels_wrap && scaled <= -1.0 { 255 } else { (scaled as u32).min(255) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn info(tm: u32) -> PrimInfo {
        let mut info = PrimInfo::default();
        info.mode.set_texmode(tm);
        info
    }

    fn combined(tm: u32, base: u32, texel: u32) -> u32 {
        let info = info(tm);
        let (t, c) = condition(&info, texel, base);
        combine(&info, c, t, &Errata::CORRECT)
    }

    #[test]
    fn modes_match_the_table() {
        let (c, t) = (0x80ff_00ff, 0x4020_ff80);
        assert_eq!(combined(0, c, t), 0xff);
        assert_eq!(combined(1, c, t), c);
        assert_eq!(combined(2, c, t), t);
        assert_eq!(combined(6, c, t), color::pack(mul(0x80, 0x40), 0x20, 0, 0x80));
        assert_eq!(combined(5, c, t), c);
        assert_eq!(combined(7, c, t), 0xff);
    }

    #[test]
    fn hard_holes_survive_a_blend() {
        let mut info = info(texmode::BLEND);
        info.mode.set_tex_alpha(alpha::HARD);
        let (t, c) = condition(&info, 0x1020_3010, 0xffff_ffff);
        assert_eq!((low(t), low(c)), (0, 0));
    }

    #[test]
    fn over_alpha_keeps_an_opaque_base_opaque() {
        let info = info(texmode::TEXDECAL);
        let over = Errata { decal_over_alpha: true, ..Errata::CORRECT };
        assert_eq!(low(combine(&info, 0xff, 0x80, &over)), 255);
        assert!(low(combine(&info, 0xff, 0x80, &Errata::CORRECT)) < 255);
    }

    #[test]
    fn lit_without_terms_is_black_and_keeps_alpha() {
        let mut info = info(texmode::COLOR);
        info.mode.set_lit(1);
        let at = |intensity| UntexFragment { intensity, ..UntexFragment::default() };
        assert_eq!(light(&info, 0x1234_5678, &at(1.0), &Errata::CORRECT), 0x78);
        info.mode.set_use_dir(1);
        info.dir_color = 0xffff_ff00;
        assert_eq!(light(&info, 0x1234_5678, &at(1.0), &Errata::CORRECT), 0x1234_5678);
        assert_eq!(light(&info, 0x1234_5678, &at(-1.0), &Errata::CORRECT), 0x78);
        assert_eq!(light(&info, 0x1234_5678, &at(-1.0), &Errata::FAITHFUL), 0x1234_5678);
    }
}
