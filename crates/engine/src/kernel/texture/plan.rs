//! What a texture unit's stages need, worked out once per draw state.

use std::sync::Arc;

use crate::kernel::combine::{Arithmetic, Switches};
use crate::state::{Addend, CombineUnit, Filter, TextureCombine, TextureFactor, TextureUnit};
use crate::texture::{MAX_LEVELS, Texture};

/// Level tables of a texture, indexed by level of detail; the level a split
/// chain lacks is already replaced.
#[derive(Clone, Debug)]
pub(crate) struct LevelTables {
    pub base: [i32; 16],
    pub pitch: [i32; 16],
    pub s_mask: [i32; 16],
    pub t_mask: [i32; 16],
    pub shift: [i32; 16],
}

/// A texture unit, compiled.
#[derive(Clone, Debug)]
pub(crate) struct UnitPlan {
    pub index: usize,
    pub unit: TextureUnit,
    pub texture: Arc<Texture>,
    pub tables: LevelTables,
    /// Limits of the level of detail, 8 fraction bits; the second wins.
    pub lod_min: i32,
    pub lod_max: i32,
    /// The level of detail itself is needed for every fragment, not only the
    /// level it selects. Borders go the same way, so that other textures know
    /// nothing of them.
    pub needs_lod: bool,
    /// Both filters sample one point.
    pub point: bool,
    /// Samples at the sides of a clamped texture reach into its border.
    pub has_border: bool,
    /// The combine unit passes the texel through.
    pub texel_only: bool,
    /// The combine unit multiplies the texel with the unit upstream.
    pub multiplies: bool,
    /// The unit upstream counts.
    pub has_other: bool,
    /// Where levels are mixed: the same plan one level coarser.
    pub next: Option<Box<UnitPlan>>,
    /// This is such a plan.
    pub is_next: bool,
    pub switches: Switches,
    pub arithmetic: Arithmetic,
}

/// The coarsest level of detail there is.
const COARSEST: i32 = (MAX_LEVELS as i32 - 1) << 8;

impl UnitPlan {
    /// Compiles unit `index`; `has_other` where a unit upstream is in use.
    pub fn new(index: usize, unit: TextureUnit, texture: Arc<Texture>, has_other: bool) -> Self {
        let mut plan = Self::of_level(index, unit, texture, has_other, 0);
        if unit.mix_levels {
            let texture = plan.texture.clone();
            plan.next = Some(Box::new(Self::of_level(index, unit, texture, has_other, 1)));
        }
        plan
    }

    /// The plan whose levels are all coarser by `coarser` than those selected.
    fn of_level(
        index: usize,
        unit: TextureUnit,
        texture: Arc<Texture>,
        has_other: bool,
        coarser: usize,
    ) -> Self {
        let combine = unit.combine;
        let lod_max = i32::from(unit.lod.max).min(COARSEST);
        UnitPlan {
            index,
            unit,
            tables: tables(&texture, unit.odd_levels, coarser),
            lod_min: i32::from(unit.lod.min).min(lod_max),
            lod_max,
            needs_lod: unit.lod_dither
                || unit.mix_levels
                || uses_lod(&combine, unit.trilinear)
                || texture.border().is_some(),
            point: unit.minify == Filter::Point && unit.magnify == Filter::Point,
            texel_only: passes_texel(&combine),
            multiplies: multiplies(&combine) && !unit.trilinear,
            has_other,
            next: None,
            is_next: coarser > 0,
            has_border: texture.border().is_some(),
            switches: Switches::new(&combine.color, &combine.alpha),
            arithmetic: Arithmetic::of(&combine.color, &combine.alpha, true),
            texture,
        }
    }

    /// Level of detail after bias and limits.
    pub fn limit(&self, lod: i32) -> i32 {
        lod.max(self.lod_min).min(self.lod_max)
    }

    /// The finest and the coarsest level that can be selected.
    pub fn levels(&self) -> (i32, i32) {
        (self.lod_min >> 8, self.lod_max >> 8)
    }
}

/// Whether the unit's output is its texel, unchanged.
fn passes_texel(combine: &TextureCombine) -> bool {
    combine.color.passes_local()
        && combine.color.add == Addend::Local
        && combine.alpha.passes_local()
}

/// Whether the unit's output is its texel times that of the unit upstream, if no
/// level inverts factors.
fn multiplies(combine: &TextureCombine) -> bool {
    let TextureCombine { color, alpha } = combine;
    let own_alpha = matches!(alpha.factor, TextureFactor::Local | TextureFactor::LocalAlpha);
    color.scales() && alpha.scales() && color.factor == TextureFactor::Local && own_alpha
}

fn uses_lod(combine: &TextureCombine, trilinear: bool) -> bool {
    let needs = |unit: &CombineUnit<TextureFactor>| {
        matches!(unit.factor, TextureFactor::Detail | TextureFactor::LodFraction)
    };
    trilinear || needs(&combine.color) || needs(&combine.alpha)
}

fn tables(texture: &Texture, odd_levels: Option<bool>, coarser: usize) -> LevelTables {
    let level = |i: usize| {
        let i = i + coarser;
        let missing = odd_levels.is_some_and(|odd| (i & 1 == 1) != odd);
        texture.level(i + usize::from(missing))
    };
    LevelTables {
        base: core::array::from_fn(|i| level(i).base as i32),
        pitch: core::array::from_fn(|i| level(i).pitch as i32),
        s_mask: core::array::from_fn(|i| level(i).s_mask as i32),
        t_mask: core::array::from_fn(|i| level(i).t_mask as i32),
        shift: core::array::from_fn(|i| level(i).shift as i32),
    }
}
