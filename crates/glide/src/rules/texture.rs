//! Rules of texture units and texture memory.

use super::{Rule, rules};
use crate::call::Call;
use crate::enums::{LEVELS_BOTH, TEXTABLE_PALETTE};
use crate::texture::layout;
use crate::texture_state::{TextureInfo, crosses_bank};

fn is_function(function: i32) -> bool {
    matches!(function, 0..=9 | 0x10)
}

fn is_factor(factor: i32) -> bool {
    matches!(factor, 0..=5 | 8..=0xd)
}

fn is_lod(lod: i32) -> bool {
    (0..=layout::SMALLEST as i32).contains(&lod)
}

fn is_format(format: i32) -> bool {
    matches!(format, 0..=5 | 8..=0xe)
}

fn is_split(even_odd: u32) -> bool {
    (1..=LEVELS_BOTH).contains(&even_odd)
}

/// Whether a chain of valid description crosses a bank.
fn crosses(start: u32, even_odd: u32, lods: (i32, i32), aspect: i32, format: i32) -> bool {
    let info = TextureInfo { small_lod: lods.0, large_lod: lods.1, aspect, format };
    info.is_valid() && is_split(even_odd) && crosses_bank(start, &info, even_odd)
}

/// Whether it reaches beyond memory of so many bytes.
fn exceeds(
    size: usize,
    start: u32,
    even_odd: u32,
    lods: (i32, i32),
    aspect: i32,
    format: i32,
) -> bool {
    let info = TextureInfo { small_lod: lods.0, large_lod: lods.1, aspect, format };
    if !info.is_valid() || !is_split(even_odd) || start as usize >= size {
        return false;
    }
    let (small, large) = (lods.0 as u32, lods.1 as u32);
    start as usize + layout::chain_bytes(small, large, aspect, format, even_odd) as usize > size
}

rules! { at;
    "grTexSource": GrTexSource (tmu) "tmu" "is not a unit of the board" fatal
        if !at.has_unit(*tmu);
    "grTexSource": GrTexSource (start) "startAddress" "is not a multiple of eight" fatal
        if !start.is_multiple_of(8);
    "grTexSource": GrTexSource (start) "startAddress" "is beyond texture memory" fatal
        if *start as usize >= at.card.texture_bytes();
    "grTexSource": GrTexSource (start, even_odd, small_lod, large_lod, aspect, format) "startAddress" "leaves too little texture memory" fatal
        if exceeds(at.card.texture_bytes(), *start, *even_odd, (*small_lod, *large_lod), *aspect, *format);
    "grTexSource": GrTexSource (start, even_odd, small_lod, large_lod, aspect, format) "startAddress" "makes the texture cross a boundary of two megabytes" fatal
        if crosses(*start, *even_odd, (*small_lod, *large_lod), *aspect, *format);
    "grTexSource": GrTexSource (even_odd) "evenOdd" "is not one of GR_MIPMAPLEVELMASK_*" fatal
        if !is_split(*even_odd);
    "grTexSource": GrTexSource (small_lod) "smallLod" "is not one of GR_LOD_*" fatal
        if !is_lod(*small_lod);
    "grTexSource": GrTexSource (large_lod) "largeLod" "is not one of GR_LOD_*" fatal
        if !is_lod(*large_lod);
    "grTexSource": GrTexSource (small_lod, large_lod) "largeLod" "is smaller than the other level" fatal
        if is_lod(*small_lod) && is_lod(*large_lod) && small_lod < large_lod;
    "grTexSource": GrTexSource (aspect) "aspectRatio" "is not one of GR_ASPECT_*" fatal
        if !(0..=6).contains(aspect);
    "grTexSource": GrTexSource (format) "format" "is not one of GR_TEXFMT_*" fatal
        if !is_format(*format);
    "grTexDownloadMipMap": GrTexDownloadMipMap (tmu) "tmu" "is not a unit of the board" fatal
        if !at.has_unit(*tmu);
    "grTexDownloadMipMap": GrTexDownloadMipMap (start) "startAddress" "is not a multiple of eight" fatal
        if !start.is_multiple_of(8);
    "grTexDownloadMipMap": GrTexDownloadMipMap (start) "startAddress" "is beyond texture memory" fatal
        if *start as usize >= at.card.texture_bytes();
    "grTexDownloadMipMap": GrTexDownloadMipMap (start, even_odd, small_lod, large_lod, aspect, format) "startAddress" "leaves too little texture memory" fatal
        if exceeds(at.card.texture_bytes(), *start, *even_odd, (*small_lod, *large_lod), *aspect, *format);
    "grTexDownloadMipMap": GrTexDownloadMipMap (start, even_odd, small_lod, large_lod, aspect, format) "startAddress" "makes the texture cross a boundary of two megabytes" fatal
        if crosses(*start, *even_odd, (*small_lod, *large_lod), *aspect, *format);
    "grTexDownloadMipMap": GrTexDownloadMipMap (even_odd) "evenOdd" "is not one of GR_MIPMAPLEVELMASK_*" fatal
        if !is_split(*even_odd);
    "grTexDownloadMipMap": GrTexDownloadMipMap (small_lod) "smallLod" "is not one of GR_LOD_*" fatal
        if !is_lod(*small_lod);
    "grTexDownloadMipMap": GrTexDownloadMipMap (large_lod) "largeLod" "is not one of GR_LOD_*" fatal
        if !is_lod(*large_lod);
    "grTexDownloadMipMap": GrTexDownloadMipMap (small_lod, large_lod) "largeLod" "is smaller than the other level" fatal
        if is_lod(*small_lod) && is_lod(*large_lod) && small_lod < large_lod;
    "grTexDownloadMipMap": GrTexDownloadMipMap (aspect) "aspectRatio" "is not one of GR_ASPECT_*" fatal
        if !(0..=6).contains(aspect);
    "grTexDownloadMipMap": GrTexDownloadMipMap (format) "format" "is not one of GR_TEXFMT_*" fatal
        if !is_format(*format);
    "grTexDownloadMipMapLevelPartial": GrTexDownloadMipMapLevelPartial (tmu) "tmu" "is not a unit of the board" fatal
        if !at.has_unit(*tmu);
    "grTexDownloadMipMapLevelPartial": GrTexDownloadMipMapLevelPartial (start) "startAddress" "is not a multiple of eight" fatal
        if !start.is_multiple_of(8);
    "grTexDownloadMipMapLevelPartial": GrTexDownloadMipMapLevelPartial (start) "startAddress" "is beyond texture memory" fatal
        if *start as usize >= at.card.texture_bytes();
    "grTexDownloadMipMapLevelPartial": GrTexDownloadMipMapLevelPartial (start, even_odd, this_lod, large_lod, aspect, format) "startAddress" "leaves too little texture memory" fatal
        if exceeds(at.card.texture_bytes(), *start, *even_odd, (*this_lod, *large_lod), *aspect, *format);
    "grTexDownloadMipMapLevelPartial": GrTexDownloadMipMapLevelPartial (start, even_odd, this_lod, large_lod, aspect, format) "startAddress" "makes the texture cross a boundary of two megabytes" fatal
        if crosses(*start, *even_odd, (*this_lod, *large_lod), *aspect, *format);
    "grTexDownloadMipMapLevelPartial": GrTexDownloadMipMapLevelPartial (even_odd) "evenOdd" "is not one of GR_MIPMAPLEVELMASK_*" fatal
        if !is_split(*even_odd);
    "grTexDownloadMipMapLevelPartial": GrTexDownloadMipMapLevelPartial (this_lod) "thisLod" "is not one of GR_LOD_*" fatal
        if !is_lod(*this_lod);
    "grTexDownloadMipMapLevelPartial": GrTexDownloadMipMapLevelPartial (large_lod) "largeLod" "is not one of GR_LOD_*" fatal
        if !is_lod(*large_lod);
    "grTexDownloadMipMapLevelPartial": GrTexDownloadMipMapLevelPartial (this_lod, large_lod) "largeLod" "is smaller than the other level" fatal
        if is_lod(*this_lod) && is_lod(*large_lod) && this_lod < large_lod;
    "grTexDownloadMipMapLevelPartial": GrTexDownloadMipMapLevelPartial (aspect) "aspectRatio" "is not one of GR_ASPECT_*" fatal
        if !(0..=6).contains(aspect);
    "grTexDownloadMipMapLevelPartial": GrTexDownloadMipMapLevelPartial (format) "format" "is not one of GR_TEXFMT_*" fatal
        if !is_format(*format);
    "grTexMultibaseAddress": GrTexMultibaseAddress (tmu) "tmu" "is not a unit of the board" fatal
        if !at.has_unit(*tmu);
    "grTexMultibaseAddress": GrTexMultibaseAddress (start) "startAddress" "is not a multiple of eight" fatal
        if !start.is_multiple_of(8);
    "grTexMultibaseAddress": GrTexMultibaseAddress (start) "startAddress" "is beyond texture memory" fatal
        if *start as usize >= at.card.texture_bytes();
    "grTexMultibaseAddress": GrTexMultibaseAddress (start, even_odd, small_lod, large_lod, aspect, format) "startAddress" "leaves too little texture memory" fatal
        if exceeds(at.card.texture_bytes(), *start, *even_odd, (*small_lod, *large_lod), *aspect, *format);
    "grTexMultibaseAddress": GrTexMultibaseAddress (start, even_odd, small_lod, large_lod, aspect, format) "startAddress" "makes the texture cross a boundary of two megabytes" fatal
        if crosses(*start, *even_odd, (*small_lod, *large_lod), *aspect, *format);
    "grTexMultibaseAddress": GrTexMultibaseAddress (even_odd) "evenOdd" "is not one of GR_MIPMAPLEVELMASK_*" fatal
        if !is_split(*even_odd);
    "grTexMultibaseAddress": GrTexMultibaseAddress (small_lod) "smallLod" "is not one of GR_LOD_*" fatal
        if !is_lod(*small_lod);
    "grTexMultibaseAddress": GrTexMultibaseAddress (large_lod) "largeLod" "is not one of GR_LOD_*" fatal
        if !is_lod(*large_lod);
    "grTexMultibaseAddress": GrTexMultibaseAddress (small_lod, large_lod) "largeLod" "is smaller than the other level" fatal
        if is_lod(*small_lod) && is_lod(*large_lod) && small_lod < large_lod;
    "grTexMultibaseAddress": GrTexMultibaseAddress (aspect) "aspectRatio" "is not one of GR_ASPECT_*" fatal
        if !(0..=6).contains(aspect);
    "grTexMultibaseAddress": GrTexMultibaseAddress (format) "format" "is not one of GR_TEXFMT_*" fatal
        if !is_format(*format);
    "grTexDownloadMipMapLevelPartial": GrTexDownloadMipMapLevelPartial (first, last) "start" "is beyond end" fatal
        if first > last;
    "grTexDownloadMipMapLevelPartial": GrTexDownloadMipMapLevelPartial (this_lod, aspect, first, last) "end" "is beyond the level" fatal
        if is_lod(*this_lod) && (0..=6).contains(aspect) && (*first < 0
            || *last >= layout::size(*aspect, *this_lod as u32).1 as i32);
    "grTexMultibaseAddress": GrTexMultibaseAddress (range) "range" "is not one of GR_TEXBASE_*" fatal
        if !(0..=3).contains(range);
    "grTexDownloadTable": GrTexDownloadTable (tmu) "tmu" "is not a unit of the board" fatal
        if !at.has_unit(*tmu);
    "grTexDownloadTable": GrTexDownloadTable (table) "type" "is not one of GR_TEXTABLE_*" fatal
        if !(0..=TEXTABLE_PALETTE).contains(table);
    "grTexDownloadTable": GrTexDownloadTable (table, first, words) "end" "is beyond the table" fatal
        if (0..=TEXTABLE_PALETTE).contains(table) && *first as usize + words.len()
            > if *table == TEXTABLE_PALETTE { 256 } else { 12 };
    "grTexNCCTable": GrTexNccTable (tmu) "tmu" "is not a unit of the board" fatal
        if !at.has_unit(*tmu);
    "grTexClampMode": GrTexClampMode (tmu) "tmu" "is not a unit of the board" fatal
        if !at.has_unit(*tmu);
    "grTexCombine": GrTexCombine (tmu) "tmu" "is not a unit of the board" fatal
        if !at.has_unit(*tmu);
    "grTexCombineFunction": GrTexCombineFunction (tmu) "tmu" "is not a unit of the board" fatal
        if !at.has_unit(*tmu);
    "grTexDetailControl": GrTexDetailControl (tmu) "tmu" "is not a unit of the board" fatal
        if !at.has_unit(*tmu);
    "grTexFilterMode": GrTexFilterMode (tmu) "tmu" "is not a unit of the board" fatal
        if !at.has_unit(*tmu);
    "grTexLodBiasValue": GrTexLodBiasValue (tmu) "tmu" "is not a unit of the board" fatal
        if !at.has_unit(*tmu);
    "grTexMipMapMode": GrTexMipMapMode (tmu) "tmu" "is not a unit of the board" fatal
        if !at.has_unit(*tmu);
    "grTexMultibase": GrTexMultibase (tmu) "tmu" "is not a unit of the board" fatal
        if !at.has_unit(*tmu);
    "grTexNCCTable": GrTexNccTable (table) "table" "is not one of GR_NCCTABLE_*" fatal
        if !(0..=1).contains(table);
    "grTexClampMode": GrTexClampMode (s) "s_clampmode" "is not one of GR_TEXTURECLAMP_*" fatal
        if !(0..=1).contains(s);
    "grTexClampMode": GrTexClampMode (t) "t_clampmode" "is not one of GR_TEXTURECLAMP_*" fatal
        if !(0..=1).contains(t);
    "grTexCombine": GrTexCombine (rgb_function) "rgb_function" "is not one of GR_COMBINE_FUNCTION_*" fatal
        if !is_function(*rgb_function);
    "grTexCombine": GrTexCombine (rgb_factor) "rgb_factor" "is not one of GR_COMBINE_FACTOR_*" fatal
        if !is_factor(*rgb_factor);
    "grTexCombine": GrTexCombine (alpha_function) "alpha_function" "is not one of GR_COMBINE_FUNCTION_*" fatal
        if !is_function(*alpha_function);
    "grTexCombine": GrTexCombine (alpha_factor) "alpha_factor" "is not one of GR_COMBINE_FACTOR_*" fatal
        if !is_factor(*alpha_factor);
    "grTexCombineFunction": GrTexCombineFunction (function) "fnc" "is not one of GR_TEXTURECOMBINE_*" fatal
        if !(0..=0xa).contains(function);
    "guTexSource": GuTexSource (id) "mmid" "is the current mip map already" warning
        if at.open().is_some_and(|board| board.mip_maps.is_current(*id));
    "grTexDetailControl": GrTexDetailControl (lod_bias) "lod_bias" "is outside -32..31" fatal
        if !(-32..=31).contains(lod_bias);
    "grTexDetailControl": GrTexDetailControl (scale) "detail_scale" "is outside 0..7" fatal
        if *scale > 7;
    "grTexDetailControl": GrTexDetailControl (max) "detail_max" "is outside 0..1" fatal
        if !(0.0..=1.0).contains(max);
    "grTexFilterMode": GrTexFilterMode (minify) "minfilter_mode" "is not one of GR_TEXTUREFILTER_*" fatal
        if !(0..=1).contains(minify);
    "grTexFilterMode": GrTexFilterMode (magnify) "magfilter_mode" "is not one of GR_TEXTUREFILTER_*" fatal
        if !(0..=1).contains(magnify);
    "grTexLodBiasValue": GrTexLodBiasValue (bias) "bias" "is outside -8..7.75" fatal
        if !(-8.0..=7.75).contains(bias);
    "grTexMipMapMode": GrTexMipMapMode (mode) "mode" "is not one of GR_MIPMAP_*" fatal
        if !(0..=2).contains(mode);
}
