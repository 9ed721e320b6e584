use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::View;
use crate::vector::is_usable;

/// The mip-map level at which no texel is smaller than half a pixel, for a
/// texture with `texels_per_unit` in a unit of the world whose nearest polygon
/// lies at `nearest_z`: floor(log2(texels per pixel)), within 0 to `levels` - 1,
/// of which no texture has more than 32.
///
/// Values that are not numbers or not above 0 get level 0.
///
/// Source: TN, application texture management strategies: the level by the
/// closest z.
pub fn mip_level(view: &View, texels_per_unit: f32, nearest_z: f32, levels: u32) -> u32 {
    let usable = |value: f32| is_usable(value) && value > 0.0;
    if !(usable(texels_per_unit) && usable(nearest_z)) {
        return 0;
    }
    let mut texels_per_pixel = texels_per_unit * nearest_z.max(view.hither()) / view.distance();
    let mut level = 0;
    while level + 1 < levels.min(32) && texels_per_pixel >= 2.0 {
        texels_per_pixel *= 0.5;
        level += 1;
    }
    level
}

/// A texture that shall be loaded, and how sharp.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WantedTexture {
    /// Texels in a row of level 0.
    pub width: u32,
    /// Rows of level 0.
    pub height: u32,
    /// Bytes of a texel.
    pub texel_bytes: u32,
    /// The number of levels it has; 0 counts as 1, and at most 32.
    pub levels: u32,
    /// The finest level that is wanted; see [`mip_level`].
    pub finest: u32,
}

impl WantedTexture {
    /// The bytes of the levels from `level` to the last. Each side halves from
    /// level to level, down to 1.
    pub fn bytes_from(&self, level: u32) -> u64 {
        (level..=self.last_level())
            .map(|level| {
                let side = |size: u32| u64::from((size >> level).max(1));
                let texels = side(self.width).saturating_mul(side(self.height));
                texels.saturating_mul(u64::from(self.texel_bytes))
            })
            .fold(0, u64::saturating_add)
    }

    fn last_level(&self) -> u32 {
        self.levels.clamp(1, 32) - 1
    }
}

/// The finest level to load of each texture, so that all together have at most
/// `budget` bytes. While they have more, the texture with the most bytes, of
/// equal ones the last, loses its finest level. If all are down to their last
/// level and still too large, whole textures go in the same way: `None`, to be
/// drawn in one colour, such as that of the smallest level.
///
/// Source: TN, application texture management strategies.
pub fn fit_levels(textures: &[WantedTexture], budget: u64) -> Vec<Option<u32>> {
    let mut chosen: Vec<Option<u32>> =
        textures.iter().map(|texture| Some(texture.finest.min(texture.last_level()))).collect();
    // The largest first; of those that can lose a level before those that cannot.
    let entry = |index: usize, level: u32| {
        let texture: &WantedTexture = &textures[index];
        (Reverse(level == texture.last_level()), texture.bytes_from(level), index, level)
    };
    let mut total: u128 = 0;
    let mut queue = BinaryHeap::with_capacity(textures.len());
    for (index, level) in chosen.iter().enumerate() {
        let entry = entry(index, level.unwrap_or(0));
        total += u128::from(entry.1);
        queue.push(entry);
    }
    while total > u128::from(budget) {
        let Some((Reverse(last), bytes, index, level)) = queue.pop() else { break };
        total -= u128::from(bytes);
        chosen[index] = None;
        if !last {
            let next = entry(index, level + 1);
            total += u128::from(next.1);
            chosen[index] = Some(level + 1);
            queue.push(next);
        }
    }
    chosen
}
