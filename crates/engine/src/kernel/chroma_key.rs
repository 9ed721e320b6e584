//! Chroma key: drops fragments of one colour.

use fillrate_simd::{IntLanes, MaskLanes, Simd};

use super::Tile;
use super::block::{Block, Colors};

/// Drops the fragments whose `colors` equal `key` (0x00RRGGBB).
///
/// Source: SST1, chromaKey; the colour is the combine unit's "other".
#[inline(always)]
pub(crate) fn drop_key<S: Simd>(
    s: S,
    live: &mut u64,
    colors: &Colors,
    len: usize,
    key: u32,
) -> u64 {
    let key = Colors::splat(key & 0x00ff_ffff);
    let (rb, g) = (s.splat(key.rb.0[0]), s.splat(key.ga.0[0]));
    let mut equal = 0u64;
    for k in (0..len).step_by(S::LANES) {
        let same_rb = s.load(&colors.rb.0[k..]).eq(rb);
        let same_g = (s.load(&colors.ga.0[k..]) & s.splat(0xffff)).eq(g);
        equal |= u64::from((same_rb & same_g).bits()) << k;
    }
    let dropped = (*live & equal).count_ones();
    *live &= !equal;
    u64::from(dropped)
}

/// [`drop_key`] on the texture, iterated or constant colour that is "other".
#[inline(always)]
pub(crate) fn chroma_key<S: Simd>(
    s: S,
    block: &mut Block,
    pass: &super::Pass<'_>,
    tile: &mut Tile<'_>,
) {
    use crate::state::Other;
    let Some(key) = pass.pipeline.state.chroma_key else { return };
    let len = block.len();
    let colors = match pass.pipeline.state.color_combine.other {
        Other::Iterated => &block.iterated,
        Other::Texture => pass.pipeline.texture_output(&block.texture),
        Other::Constant => &pass.pipeline.color1,
    };
    tile.counters.chroma_fail += drop_key(s, &mut block.live, colors, len, key);
}
