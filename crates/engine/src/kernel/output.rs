//! Blending, dithering, packing and the colour write.
//!
//! Source: SST1, alphaMode and fbzMode.

use fillrate_simd::{IntLanes, Simd};

use super::block::{Block, Colors, STAMP, Strip};
use super::lanes::{div_255, join, spread_alpha};
use super::{ColorTile, Pass, Tile};
use crate::state::{AlphaEquation, AuxWrite, Blend, BlendFactor, Dither, LogicOp};
use crate::target::PixelFormat;

/// Widens elements to (red, blue) and (green, alpha) by bit replication;
/// absent alpha is 255.
#[inline(always)]
fn unpack<S: Simd>(s: S, format: PixelFormat, p: S::I) -> [S::I; 2] {
    match format {
        PixelFormat::Rgb565 => {
            let rb = (p.shr(11) & s.splat(31)) | (p & s.splat(31)).shl(16);
            let g = p.shr(5) & s.splat(63);
            [rb.shl16(3) | rb.shr16(2), g.shl(2) | g.shr(4) | s.splat(0x00ff_0000)]
        }
        PixelFormat::Argb1555 => {
            let rb = (p.shr(10) & s.splat(31)) | (p & s.splat(31)).shl(16);
            let g = p.shr(5) & s.splat(31);
            let a = p.shl(16).sar(31) & s.splat(0x00ff_0000);
            [rb.shl16(3) | rb.shr16(2), g.shl(3) | g.shr(2) | a]
        }
        PixelFormat::Xrgb1555 => {
            let rb = (p.shr(10) & s.splat(31)) | (p & s.splat(31)).shl(16);
            let g = p.shr(5) & s.splat(31);
            [rb.shl16(3) | rb.shr16(2), g.shl(3) | g.shr(2) | s.splat(0x00ff_0000)]
        }
        PixelFormat::Argb4444 => {
            let rb = (p.shr(8) & s.splat(15)) | (p & s.splat(15)).shl(16);
            let ga = (p.shr(4) & s.splat(15)) | (p & s.splat(0xf000)).shl(4);
            [rb.shl16(4) | rb, ga.shl16(4) | ga]
        }
        PixelFormat::Xrgb8888 => {
            let [rb, ga] = unpack_bytes(s, p);
            [rb, ga | s.splat(0x00ff_0000)]
        }
        PixelFormat::Rgb332 => {
            let (r, g, b) = (p.shr(5) & s.splat(7), p.shr(2) & s.splat(7), p & s.splat(3));
            let rg = r | g.shl(16);
            let rg = rg.shl16(5) | rg.shl16(2) | rg.shr16(1);
            let rb = (rg & s.splat(0xff)) | b.mul(s.splat(85)).shl(16);
            [rb, rg.shr(16) | s.splat(0x00ff_0000)]
        }
        PixelFormat::Gray8 => {
            let gray = p & s.splat(0xff);
            [gray | gray.shl(16), gray | s.splat(0x00ff_0000)]
        }
        PixelFormat::Alpha8 => {
            let white = s.splat(0x00ff_00ff);
            [white, join(s, white, p.shl(16) & white)]
        }
        PixelFormat::Argb8888
        | PixelFormat::Palette
        | PixelFormat::Rgbx8888
        | PixelFormat::Aux16
        | PixelFormat::Aux32 => unpack_bytes(s, p),
    }
}

/// 0xAARRGGBB as channel pairs.
#[inline(always)]
fn unpack_bytes<S: Simd>(s: S, p: S::I) -> [S::I; 2] {
    let rb = (p.shr(16) & s.splat(0xff)) | (p & s.splat(0xff)).shl(16);
    let ga = (p.shr(8) & s.splat(0xff)) | (p.shr(24)).shl(16);
    [rb, ga]
}

/// Reduces channel pairs to `bits` bits, with the dither value `d` or by
/// truncation.
#[inline(always)]
fn reduce<S: Simd>(c: S::I, bits: u32, d: Option<S::I>) -> S::I {
    let Some(d) = d else { return c.shr16(8 - bits) };
    let scaled = match bits {
        6 => c.shl16(2).sub16(c.shr16(4)).add16(c.shr16(6)),
        5 => c.shl16(1).sub16(c.shr16(4)).add16(c.shr16(7)),
        _ => c.shr16(4 - bits).sub16(c.shr16(4)),
    };
    scaled.add16(d).shr16(4)
}

/// Packs colours into elements.
#[inline(always)]
pub(super) fn pack<S: Simd>(
    s: S,
    format: PixelFormat,
    [rb, ga]: [S::I; 2],
    d: Option<S::I>,
) -> S::I {
    let alpha = ga.shr(16);
    match format {
        PixelFormat::Rgb565 => {
            let (rb, g) = (reduce::<S>(rb, 5, d), reduce::<S>(ga, 6, d));
            (rb & s.splat(31)).shl(11) | (g & s.splat(63)).shl(5) | rb.shr(16)
        }
        PixelFormat::Argb1555 => {
            let (rb, g) = (reduce::<S>(rb, 5, d), reduce::<S>(ga, 5, d));
            let color = (rb & s.splat(31)).shl(10) | (g & s.splat(31)).shl(5) | rb.shr(16);
            color | alpha.shr(7).shl(15)
        }
        PixelFormat::Argb4444 => {
            let (rb, g) = (reduce::<S>(rb, 4, d), reduce::<S>(ga, 4, d));
            let color = (rb & s.splat(15)).shl(8) | (g & s.splat(15)).shl(4) | rb.shr(16);
            color | alpha.shr(4).shl(12)
        }
        PixelFormat::Xrgb1555 => {
            let (rb, g) = (reduce::<S>(rb, 5, d), reduce::<S>(ga, 5, d));
            (rb & s.splat(31)).shl(10) | (g & s.splat(31)).shl(5) | rb.shr(16)
        }
        PixelFormat::Xrgb8888 => {
            (rb & s.splat(0xff)).shl(16) | (ga & s.splat(0xff)).shl(8) | rb.shr(16)
        }
        PixelFormat::Rgb332 => {
            let (r, g) = (reduce::<S>(rb, 3, d), reduce::<S>(ga, 3, d));
            let b = reduce::<S>(rb, 2, d).shr(16);
            (r & s.splat(7)).shl(5) | (g & s.splat(7)).shl(2) | b
        }
        PixelFormat::Gray8 => {
            let (r, b) = (rb & s.splat(0xff), rb.shr(16));
            let g = ga & s.splat(0xff);
            let sum = r.mul(s.splat(77)) + g.mul(s.splat(150)) + b.mul(s.splat(29));
            (sum + s.splat(128)).shr(8)
        }
        PixelFormat::Alpha8 => alpha,
        PixelFormat::Argb8888
        | PixelFormat::Palette
        | PixelFormat::Rgbx8888
        | PixelFormat::Aux16
        | PixelFormat::Aux32 => {
            alpha.shl(24) | (rb & s.splat(0xff)).shl(16) | (ga & s.splat(0xff)).shl(8) | rb.shr(16)
        }
    }
}

/// A blend's operands: (red, blue) and (green, alpha) of each.
struct Operands<S: Simd> {
    source: [S::I; 2],
    destination: [S::I; 2],
    prefog: [S::I; 2],
}

/// A factor in 256ths for both vectors; `other` is the opposite operand.
#[inline(always)]
fn factor<S: Simd>(s: S, factor: BlendFactor, o: &Operands<S>, other: &[S::I; 2]) -> [S::I; 2] {
    let one = s.splat(0x0001_0001);
    let whole = s.splat(0x0100_0100);
    let source_alpha = spread_alpha(s, o.source[1]);
    let destination_alpha = spread_alpha(s, o.destination[1]);
    match factor {
        BlendFactor::Zero => [s.splat(0); 2],
        BlendFactor::One => [whole; 2],
        BlendFactor::SourceAlpha => [source_alpha.add16(one); 2],
        BlendFactor::DestinationAlpha => [destination_alpha.add16(one); 2],
        BlendFactor::OneMinusSourceAlpha => [whole.sub16(source_alpha); 2],
        BlendFactor::OneMinusDestinationAlpha => [whole.sub16(destination_alpha); 2],
        BlendFactor::OtherColor => [other[0].add16(one), other[1].add16(one)],
        BlendFactor::OneMinusOtherColor => [whole.sub16(other[0]), whole.sub16(other[1])],
        BlendFactor::AlphaSaturate => {
            [source_alpha.min16(whole.sub16(destination_alpha)).add16(one); 2]
        }
        BlendFactor::OneMinusAlphaSaturate => {
            let top = s.splat(0x00ff_00ff);
            [whole.sub16(source_alpha.min16(top.sub16(destination_alpha))); 2]
        }
        BlendFactor::PrefogColor => [o.prefog[0].add16(one), o.prefog[1].add16(one)],
    }
}

/// `(a * fa + b * fb) >> 8`, at most 255, channel by channel.
#[inline(always)]
fn weighted_sum<S: Simd>(a: S::I, fa: S::I, b: S::I, fb: S::I) -> S::I {
    a.mul16(fa).add_sat_u16(b.mul16(fb)).shr16(8)
}

/// The factors of the source and of the destination.
#[inline(always)]
fn factors<S: Simd>(s: S, blend: &Blend, o: &Operands<S>) -> [[S::I; 2]; 2] {
    let over = blend.source == BlendFactor::SourceAlpha
        && blend.destination == BlendFactor::OneMinusSourceAlpha;
    if over {
        // The commonest, without a choice for each vector.
        let alpha = spread_alpha(s, o.source[1]);
        let rest = s.splat(0x0100_0100).sub16(alpha);
        return [[alpha.add16(s.splat(0x0001_0001)); 2], [rest; 2]];
    }
    [factor(s, blend.source, o, &o.destination), factor(s, blend.destination, o, &o.source)]
}

/// The blended colour; its alpha means nothing without `ALPHA`. The sum of two
/// products saturates at 65535, which the shift turns into the limit of 255.
#[inline(always)]
fn blend<S: Simd, const ALPHA: bool>(s: S, blend: &Blend, o: &Operands<S>) -> [S::I; 2] {
    let [fs, fd] = factors(s, blend, o);
    let (mut fs_ga, mut fd_ga) = (fs[1], fd[1]);
    if ALPHA {
        fs_ga = join(s, fs_ga, s.splat(i32::from(blend.source_alpha) << 24));
        fd_ga = join(s, fd_ga, s.splat(i32::from(blend.destination_alpha) << 24));
    }
    [
        weighted_sum::<S>(o.source[0], fs[0], o.destination[0], fd[0]),
        weighted_sum::<S>(o.source[1], fs_ga, o.destination[1], fd_ga),
    ]
}

/// The destination as blending sees it: widened, with what dithering took
/// given back, and with its alpha from the aux plane or 255. `j` is the first
/// fragment's place in its stamp, and `aux` begins with its element.
#[inline(always)]
fn destination<S: Simd>(
    s: S,
    pass: &Pass<'_>,
    config: &Blend,
    format: PixelFormat,
    element: S::I,
    aux: &[u16],
    j: usize,
) -> [S::I; 2] {
    let [mut rb, mut ga] = unpack(s, format, element);
    if config.subtract_dither && format.is_reduced() {
        let top = s.splat(0x00ff_00ff);
        let rest = s.load(&pass.pipeline.undither[j..]);
        rb = rb.add16(rest.shr16(1)).min16(top);
        ga = ga.add16(rest.shr16(2) & s.splat(0xffff)).min16(top);
    }
    if config.alpha_plane {
        let alpha = (s.load16(aux) & s.splat(0xff)).shl(16);
        ga = join(s, ga, alpha);
    }
    [rb, ga]
}

/// Blends a colour with an element of the colour plane. Without `ALPHA` nothing
/// reads the alpha of the result.
#[inline(always)]
pub(super) fn blended<S: Simd, const ALPHA: bool>(
    s: S,
    pass: &Pass<'_>,
    config: &Blend,
    format: PixelFormat,
    [source, prefog]: [[S::I; 2]; 2],
    element: S::I,
    aux: &[u16],
    j: usize,
) -> [S::I; 2] {
    let destination = destination(s, pass, config, format, element, aux, j);
    blend::<S, ALPHA>(s, config, &Operands { source, destination, prefog })
}

/// Blends the fragments into `block.color`.
#[inline(always)]
pub(crate) fn blend_stage<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>, tile: &Tile<'_>) {
    let Some(config) = &pass.pipeline.state.blend else { return };
    // Without fog the colour before fog is the colour.
    let fogged = pass.pipeline.state.fog.is_some();
    for slot in 0..block.count {
        let at = block.slots[slot].at as usize;
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let source = [s.load(&block.color.rb.0[k..]), s.load(&block.color.ga.0[k..])];
            let prefog = if fogged {
                [s.load(&block.prefog.rb.0[k..]), s.load(&block.prefog.ga.0[k..])]
            } else {
                source
            };
            let (element, format) = match &tile.color {
                ColorTile::Bits16(pixels, format) => (s.load16(&pixels[at + j..]), *format),
                ColorTile::Bits32(pixels, format) => (s.load(&pixels[at + j..]), *format),
            };
            let aux = tile.aux.get(at + j..).unwrap_or(&[]);
            let colors = [source, prefog];
            let [rb, ga] = blended::<S, true>(s, pass, config, format, colors, element, aux, j);
            s.store(rb, &mut block.color.rb.0[k..]);
            s.store(ga, &mut block.color.ga.0[k..]);
        }
    }
}

/// Blends the fragments into `block.color` where the destination is constant
/// or alpha has an equation of its own.
#[inline(always)]
pub(crate) fn blend_fully<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>, tile: &Tile<'_>) {
    let Some(config) = &pass.pipeline.state.blend else { return };
    let fogged = pass.pipeline.state.fog.is_some();
    let constant = Colors::splat(config.constant_destination.unwrap_or(0));
    for slot in 0..block.count {
        let at = block.slots[slot].at as usize;
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let source = [s.load(&block.color.rb.0[k..]), s.load(&block.color.ga.0[k..])];
            let prefog = if fogged {
                [s.load(&block.prefog.rb.0[k..]), s.load(&block.prefog.ga.0[k..])]
            } else {
                source
            };
            let destination = if config.constant_destination.is_some() {
                [s.splat(constant.rb.0[0]), s.splat(constant.ga.0[0])]
            } else {
                let (element, format) = tile.color.elements(s, at + j);
                let aux = tile.aux.get(at + j..).unwrap_or(&[]);
                destination(s, pass, config, format, element, aux, j)
            };
            let operands = Operands { source, destination, prefog };
            let [rb, g] = blend::<S, true>(s, config, &operands);
            let alpha = blended_alpha(s, config, &operands, g);
            s.store(rb, &mut block.color.rb.0[k..]);
            s.store(join(s, g, alpha), &mut block.color.ga.0[k..]);
        }
    }
}

/// The alpha of a blend, in the high halves; `switched` holds that of its
/// switches.
#[inline(always)]
fn blended_alpha<S: Simd>(s: S, config: &Blend, o: &Operands<S>, switched: S::I) -> S::I {
    let (source, destination) = (o.source[1], o.destination[1]);
    match config.alpha {
        AlphaEquation::Switches => switched,
        AlphaEquation::Factors => {
            let fs = factor(s, config.source, o, &o.destination)[1];
            let fd = factor(s, config.destination, o, &o.source)[1];
            weighted_sum::<S>(source, fs, destination, fd)
        }
        AlphaEquation::Union => {
            let top = s.splat(0x00ff_00ff);
            top.sub16(div_255(s, top.sub16(source).mul16(top.sub16(destination))))
        }
    }
}

/// Counts and writes the fragments left where all have one colour.
#[inline(always)]
pub(crate) fn write_flat<S: Simd>(s: S, block: &Block, pass: &Pass<'_>, tile: &mut Tile<'_>) {
    let Some(stamp) = &pass.pipeline.flat else { return };
    let ColorTile::Bits16(pixels, _) = &mut tile.color else { return };
    tile.counters.pixels_out += u64::from(block.live.count_ones());
    for slot in 0..block.count {
        let to = &mut pixels[block.slots[slot].at as usize..][..STAMP];
        copy_stamp(s, stamp, to, (block.live >> (slot * STAMP)) as u16);
    }
}

/// The same for a strip.
#[inline(always)]
pub(crate) fn flat_strip<S: Simd>(s: S, strip: &Strip, pass: &Pass<'_>, tile: &mut Tile<'_>) {
    let Some(stamp) = &pass.pipeline.flat else { return };
    let ColorTile::Bits16(pixels, _) = &mut tile.color else { return };
    tile.counters.pixels_out += strip.len();
    copy_strip(s, stamp, strip, pixels);
}

/// Writes the live fragments of a strip whose stamps are all the same.
#[inline(always)]
pub(super) fn copy_strip<S: Simd>(s: S, stamp: &[u16; STAMP], strip: &Strip, pixels: &mut [u16]) {
    for (live, to) in strip.live.iter().zip(strip.elements(pixels)) {
        copy_stamp(s, stamp, to, *live);
    }
}

#[inline(always)]
fn copy_stamp<S: Simd>(s: S, stamp: &[u16; STAMP], to: &mut [u16], live: u16) {
    if live == 0xffff {
        to.copy_from_slice(stamp);
        return;
    }
    for j in (0..STAMP).step_by(S::LANES) {
        s.store16(s.load16(&stamp[j..]), &mut to[j..], s.mask(u32::from(live) >> j));
    }
}

/// Counts the fragments left, and writes their alpha where the aux plane holds
/// it.
#[inline(always)]
fn count<S: Simd>(s: S, block: &Block, pass: &Pass<'_>, tile: &mut Tile<'_>) {
    tile.counters.pixels_out += u64::from(block.live.count_ones());
    if pass.pipeline.state.aux_write == AuxWrite::Alpha && !tile.aux.is_empty() {
        write_alpha(s, block, tile);
    }
}

/// Counts and writes the fragments left where a logic operation joins them with
/// what is there, or where some bits stay.
#[inline(always)]
pub(crate) fn write_bits<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>, tile: &mut Tile<'_>) {
    count(s, block, pass, tile);
    let pipeline = pass.pipeline;
    if !pipeline.state.color_write {
        return;
    }
    let dithered = pipeline.state.dither != Dither::Off;
    let mask = s.splat(pipeline.write_mask as i32);
    for slot in 0..block.count {
        let at = block.slots[slot].at as usize;
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let live = s.mask((block.live >> k) as u32);
            let color = [s.load(&block.color.rb.0[k..]), s.load(&block.color.ga.0[k..])];
            let (old, format) = tile.color.elements(s, at + j);
            let dither = if dithered { Some(s.load(&pipeline.dither[j..])) } else { None };
            let new = pack(s, format, color, dither);
            let new = match pipeline.logic_op {
                Some(op) => logic(s, op, new, old),
                None => new,
            };
            let merged = old ^ ((old ^ new) & mask);
            match &mut tile.color {
                ColorTile::Bits16(pixels, _) => s.store16(merged, &mut pixels[at + j..], live),
                ColorTile::Bits32(pixels, _) => s.store_masked(merged, &mut pixels[at + j..], live),
            }
        }
    }
}

/// A logic operation on elements: the bits of its table whose index the
/// operands' bits are.
#[inline(always)]
fn logic<S: Simd>(s: S, op: LogicOp, source: S::I, destination: S::I) -> S::I {
    let ones = s.splat(-1);
    let [a, b, c, d] = [3, 2, 1, 0].map(|index| -i32::from(op.table() >> index & 1));
    let with_source = (destination & s.splat(a)) | ((destination ^ ones) & s.splat(b));
    let without = (destination & s.splat(c)) | ((destination ^ ones) & s.splat(d));
    (source & with_source) | ((source ^ ones) & without)
}

/// Counts and writes the fragments left: colour, and alpha where the aux
/// plane holds it.
#[inline(always)]
pub(crate) fn write<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>, tile: &mut Tile<'_>) {
    count(s, block, pass, tile);
    let state = &pass.pipeline.state;
    if !state.color_write {
        return;
    }
    let dither = (state.dither != Dither::Off).then_some(&pass.pipeline.dither);
    match &mut tile.color {
        ColorTile::Bits16(pixels, PixelFormat::Rgb565) => {
            write16(s, block, dither, PixelFormat::Rgb565, pixels);
        }
        ColorTile::Bits16(pixels, format) => write16(s, block, dither, *format, pixels),
        ColorTile::Bits32(pixels, format) => write32(s, block, *format, pixels),
    }
}

/// One loop with and one without dithering; the format is known when it is
/// given as a constant.
#[inline(always)]
fn write16<S: Simd>(
    s: S,
    block: &Block,
    dither: Option<&[i32; STAMP]>,
    format: PixelFormat,
    pixels: &mut [u16],
) {
    for slot in 0..block.count {
        let at = block.slots[slot].at as usize;
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let color = [s.load(&block.color.rb.0[k..]), s.load(&block.color.ga.0[k..])];
            let packed = match dither {
                Some(pattern) => pack(s, format, color, Some(s.load(&pattern[j..]))),
                None => pack(s, format, color, None),
            };
            s.store16(packed, &mut pixels[at + j..], s.mask((block.live >> k) as u32));
        }
    }
}

#[inline(always)]
fn write32<S: Simd>(s: S, block: &Block, format: PixelFormat, pixels: &mut [i32]) {
    for slot in 0..block.count {
        let at = block.slots[slot].at as usize;
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let color = [s.load(&block.color.rb.0[k..]), s.load(&block.color.ga.0[k..])];
            let packed = pack(s, format, color, None);
            s.store_masked(packed, &mut pixels[at + j..], s.mask((block.live >> k) as u32));
        }
    }
}

#[inline(always)]
fn write_alpha<S: Simd>(s: S, block: &Block, tile: &mut Tile<'_>) {
    for slot in 0..block.count {
        let at = block.slots[slot].at as usize;
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let alpha = s.load(&block.color.ga.0[k..]).shr(16);
            s.store16(alpha, &mut tile.aux[at + j..], s.mask((block.live >> k) as u32));
        }
    }
}
