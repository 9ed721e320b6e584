//! Carrying out calls.

use crate::board::Board;
use crate::call::Call;
use crate::combine::{alpha_preset, color_preset, is_delta0, texture_preset};
use crate::context::Context;
use crate::enums::*;
use crate::gu::{Attributes, MipMap, MultiPass, NCC_TABLE_BYTES, Sprite};
use crate::lfb::Meeting;
use crate::registers::{lfb_mode, replace, switch};
use crate::texture::layout;
use crate::texture_state::{TextureInfo, crosses_bank, lod_bias_quarters};

impl Context {
    /// Carries out a call. Returns what the original returned as a number:
    /// 1 and 0 for true and false, 0 for nothing.
    pub fn execute(&mut self, call: &Call) -> u32 {
        self.told = false;
        self.told = self.config.check && self.apply_rules(call);
        let index = self.current;
        let board = self.boards.get_mut(index);
        let meeting = board.map_or(Meeting::Nothing, |board| {
            let meeting = board.meeting(call);
            board.meet(meeting);
            meeting
        });
        let result = self.carry_out(call);
        if let Some(board) = self.boards.get_mut(index).filter(|_| meeting != Meeting::Nothing) {
            board.part(meeting);
        }
        result
    }

    fn carry_out(&mut self, call: &Call) -> u32 {
        use fillrate_call::Tagged;
        match call {
            Call::GrGlideInit {} => self.init(),
            Call::GrGlideShutdown {} => self.shutdown(),
            Call::GrSstSelect { board } => self.select(*board),
            Call::GrSstWinOpen { resolution, color_format, origin, colors, aux, .. } => {
                let frame = (*resolution, *colors, *aux);
                return u32::from(self.open(call.name(), frame, *color_format, *origin));
            }
            Call::GrSstOpen { resolution, color_format, origin, smoothing, buffers, .. } => {
                // There is an aux buffer beside two where memory has room for it.
                let wanted = self.variables.resolution.unwrap_or(*resolution);
                let card = &self.config.card;
                let room = usize::try_from(wanted).is_ok_and(|index| card.holds(index, 3));
                let frame = (*resolution, *buffers, i32::from(*buffers == 2 && room));
                let opened = self.open(call.name(), frame, *color_format, *origin);
                if opened && *smoothing == 0 {
                    self.boards[self.current].filter_thresholds = [0; 3];
                }
                return u32::from(opened);
            }
            Call::GrSstWinClose {} => {
                if let Some(board) = self.boards.get_mut(self.current) {
                    board.close();
                }
            }
            Call::GrTexSource { .. }
            | Call::GrTexDownloadMipMap { .. }
            | Call::GrTexDownloadMipMapLevelPartial { .. }
            | Call::GrTexDownloadTable { .. }
            | Call::GrTexNccTable { .. }
            | Call::GrTexClampMode { .. }
            | Call::GrTexCombine { .. }
            | Call::GrTexCombineFunction { .. }
            | Call::GrTexDetailControl { .. }
            | Call::GrTexFilterMode { .. }
            | Call::GrTexLodBiasValue { .. }
            | Call::GrTexMipMapMode { .. }
            | Call::GrTexMultibase { .. }
            | Call::GrTexMultibaseAddress { .. } => self.texture_call(call),
            Call::GuTexAllocateMemory { .. }
            | Call::GuTexChangeAttributes { .. }
            | Call::GuTexDownloadMipMap { .. }
            | Call::GuTexDownloadMipMapLevel { .. }
            | Call::GuTexSource { .. }
            | Call::GuTexMemReset {} => return self.mip_map_call(call),
            Call::GuMpInit {}
            | Call::GuMpTexCombineFunction { .. }
            | Call::GuMpTexSource { .. }
            | Call::GuMpDrawTriangle { .. } => self.multipass_call(call),
            Call::GuMovieStart {} | Call::GuMovieStop {} | Call::GuMovieSetName { .. } => {
                self.warn(call.name(), "movies are not supported");
            }
            Call::ConvertAndDownloadRle { .. } => self.sprite_call(call),
            Call::GrLfbLock { .. }
            | Call::GrLfbUnlock { .. }
            | Call::GrLfbConstantAlpha { .. }
            | Call::GrLfbConstantDepth { .. }
            | Call::GrLfbWriteColorFormat { .. }
            | Call::GrLfbWriteRegion { .. }
            | Call::GrLfbWriteMode { .. }
            | Call::GrLfbOrigin { .. }
            | Call::GrLfbWriteColorSwizzle { .. }
            | Call::GuFbWriteRegion { .. }
            | Call::GrLfbStored { .. }
            | Call::GrLfbBypassMode { .. } => return u32::from(self.lfb_call(call)),
            Call::GrBufferSwap { interval } => self.swap(*interval),
            Call::GrGlideShamelessPlug { on } => self.plug = *on != 0,
            _ => self.board_call(call),
        }
        0
    }

    fn select(&mut self, index: i32) {
        match usize::try_from(index).ok().filter(|&index| index < self.boards.len()) {
            Some(index) => self.current = index,
            None => self.report("grSstSelect", "there is no such board"),
        }
    }

    /// Opens the current board: resolution, colour and aux buffers; colour format;
    /// row order.
    fn open(
        &mut self,
        name: &str,
        (resolution, colors, aux): (i32, i32, i32),
        format: i32,
        origin: i32,
    ) -> bool {
        let Some(board) = self.boards.get_mut(self.current) else {
            self.check(false, name, "the library was not started");
            return false;
        };
        if board.is_open() && self.variables.ignore_reopen {
            board.close();
        } else if board.is_open() {
            self.check(false, name, "the board is open already");
            return false;
        }
        if !(0..=3).contains(&format) {
            self.check(false, name, "unknown colour format");
            return false;
        }
        board.settings.color_format = format;
        let resolution = self.variables.resolution.unwrap_or(resolution);
        let opened = board.open(resolution, origin, colors, aux);
        if opened {
            board.gamma = self.variables.gamma_tables();
            board.filter_thresholds = self.variables.filter_thresholds;
            if self.config.splash && !self.variables.no_splash {
                board.run_splash();
            }
        }
        opened
    }

    fn swap(&mut self, interval: i32) {
        self.check((0..=255).contains(&interval), "grBufferSwap", "interval is outside 0..255");
        let interval = self.variables.swap_interval.unwrap_or(interval.clamp(0, 255) as u32);
        let plug = self.plug;
        if let Some(board) = self.board("grBufferSwap") {
            if plug {
                board.commit_stores();
                board.draw_plug();
            }
            board.swap(interval.min(255));
        }
    }

    /// Calls that need an open board and nothing else.
    fn board_call(&mut self, call: &Call) {
        use fillrate_call::Tagged;
        let name = call.name();
        let Some(board) = self.board(name) else { return };
        let known = pixel_call(board, call) && draw_call(board, call);
        let text = match call {
            Call::GrGlideSetState { .. } => "these bytes are no saved state",
            _ => "an argument is not one of the enumerants",
        };
        self.check(known, name, text);
    }

    fn texture_call(&mut self, call: &Call) {
        use fillrate_call::Tagged;
        let name = call.name();
        match call {
            Call::GrTexSource { tmu, start, even_odd, small_lod, large_lod, aspect, format } => {
                let (small_lod, large_lod, aspect, format) =
                    (*small_lod, *large_lod, *aspect, *format);
                let info = TextureInfo { small_lod, large_lod, aspect, format };
                if let Some((board, unit)) = self.texture_unit(name, *tmu, *start, *even_odd, &info)
                {
                    board.set_source(unit, *start, *even_odd, &info);
                }
            }
            Call::GrTexDownloadMipMap {
                tmu,
                start,
                even_odd,
                small_lod,
                large_lod,
                aspect,
                format,
                data,
            } => {
                let (small_lod, large_lod, aspect, format) =
                    (*small_lod, *large_lod, *aspect, *format);
                let info = TextureInfo { small_lod, large_lod, aspect, format };
                if let Some((board, unit)) = self.texture_unit(name, *tmu, *start, *even_odd, &info)
                {
                    let mut rest = &data[..];
                    for lod in large_lod as u32..=small_lod as u32 {
                        let rows = (0, u32::from(u8::MAX));
                        let used =
                            board.download_rows(unit, *start, lod, &info, *even_odd, rows, rest);
                        rest = &rest[used..];
                    }
                }
            }
            Call::GrTexDownloadMipMapLevelPartial {
                tmu,
                start,
                this_lod,
                large_lod,
                aspect,
                format,
                even_odd,
                data,
                first,
                last,
            } => {
                let (large_lod, aspect, format) = (*large_lod, *aspect, *format);
                let info = TextureInfo { small_lod: *this_lod, large_lod, aspect, format };
                let (width, height) = layout::size(aspect, (*this_lod).clamp(0, 8) as u32);
                let rows = *first >= 0 && first <= last && *last < height as i32 && width > 0;
                self.check(rows, name, "rows are outside the level");
                if rows
                    && let Some((board, unit)) =
                        self.texture_unit(name, *tmu, *start, *even_odd, &info)
                {
                    let rows = (*first as u32, *last as u32);
                    let lod = *this_lod as u32;
                    board.download_rows(unit, *start, lod, &info, *even_odd, rows, data);
                }
            }
            Call::GrTexMultibaseAddress {
                tmu,
                range,
                start,
                even_odd,
                small_lod,
                large_lod,
                aspect,
                format,
            } => {
                let (small_lod, large_lod, aspect, format) =
                    (*small_lod, *large_lod, *aspect, *format);
                let info = TextureInfo { small_lod, large_lod, aspect, format };
                if let Some((board, unit)) = self.texture_unit(name, *tmu, *start, *even_odd, &info)
                {
                    board.set_multibase_address(unit, *range, *start, *even_odd, &info);
                }
            }
            _ => self.texture_mode_call(name, call),
        }
    }

    /// Checks what every call with a texture address needs.
    fn texture_unit(
        &mut self,
        name: &str,
        tmu: i32,
        start: u32,
        even_odd: u32,
        info: &TextureInfo,
    ) -> Option<(&mut Board, usize)> {
        self.unit(name, tmu)?;
        let size = self.config.card.texture_bytes() as u32;
        let valid = info.is_valid() && (1..=3).contains(&even_odd);
        self.check(valid, name, "the texture's description is out of range");
        self.check(start.is_multiple_of(8), name, "the address is not a multiple of eight");
        self.check(start < size, name, "the address is beyond texture memory");
        if !valid {
            return None;
        }
        if crosses_bank(start, info, even_odd) {
            self.report(name, "the texture crosses a boundary of two megabytes");
            return None;
        }
        self.unit(name, tmu)
    }

    fn texture_mode_call(&mut self, name: &str, call: &Call) {
        let known = match *call {
            Call::GrTexDownloadTable { tmu, table, first, ref words } => {
                let Some((board, unit)) = self.unit(name, tmu) else { return };
                download_table(board, unit, table, first as usize, words)
            }
            Call::GrTexNccTable { tmu, table } => {
                let Some((board, unit)) = self.unit(name, tmu) else { return };
                board.set_ncc_table(unit, table)
            }
            Call::GrTexClampMode { tmu, s, t } => {
                let Some((board, unit)) = self.unit(name, tmu) else { return };
                board.set_clamp(unit, s, t)
            }
            Call::GrTexCombine {
                tmu,
                rgb_function,
                rgb_factor,
                alpha_function,
                alpha_factor,
                rgb_invert,
                alpha_invert,
            } => {
                let Some((board, unit)) = self.unit(name, tmu) else { return };
                let functions = [rgb_function, rgb_factor, alpha_function, alpha_factor];
                board.set_texture_combine(unit, functions, [rgb_invert != 0, alpha_invert != 0])
            }
            Call::GrTexCombineFunction { tmu, function } => {
                let Some((board, unit)) = self.unit(name, tmu) else { return };
                match texture_preset(function) {
                    Some((f, factor, invert)) => {
                        board.set_texture_combine(unit, [f, factor, f, factor], [invert; 2])
                    }
                    None => return self.report(name, "unknown texture combine function"),
                }
            }
            Call::GrTexDetailControl { tmu, lod_bias, scale, max } => {
                let Some((board, unit)) = self.unit(name, tmu) else { return };
                board.set_detail(unit, lod_bias, scale, max);
                (-32..=31).contains(&lod_bias) && scale <= 7 && (0.0..=1.0).contains(&max)
            }
            Call::GrTexFilterMode { tmu, minify, magnify } => {
                let Some((board, unit)) = self.unit(name, tmu) else { return };
                board.set_filter(unit, minify, magnify)
            }
            Call::GrTexLodBiasValue { tmu, bias } => {
                let Some((board, unit)) = self.unit(name, tmu) else { return };
                board.set_lod_bias(unit, bias);
                (-8.0..=7.75).contains(&bias)
            }
            Call::GrTexMipMapMode { tmu, mode, blend } => {
                let Some((board, unit)) = self.unit(name, tmu) else { return };
                board.set_mip_map_mode(unit, mode, blend != 0)
            }
            Call::GrTexMultibase { tmu, enable } => {
                let Some((board, unit)) = self.unit(name, tmu) else { return };
                board.set_multibase(unit, enable != 0);
                true
            }
            _ => true,
        };
        self.check(known, name, "an argument is out of range");
    }

    fn mip_map_call(&mut self, call: &Call) -> u32 {
        match call {
            Call::GuTexAllocateMemory { .. } => {
                return described(call).map_or(0, |mip_map| self.allocate_mip_map(mip_map));
            }
            Call::GuTexChangeAttributes { id, .. } => {
                let changes = attributes(call);
                return changes.map_or(0, |changes| u32::from(self.change_mip_map(*id, &changes)));
            }
            Call::GuTexDownloadMipMap { id, data, table } => {
                self.download_mip_map(*id, data, table.as_deref());
            }
            Call::GuTexDownloadMipMapLevel { id, lod, data } => {
                self.download_mip_map_level(*id, *lod, data);
            }
            Call::GuTexSource { id } => self.source_mip_map(*id),
            _ => self.reset_mip_maps(),
        }
        0
    }

    fn multipass_call(&mut self, call: &Call) {
        match call {
            Call::GuMpTexCombineFunction { function } => self.multipass.function = *function,
            Call::GuMpTexSource { tmu, id } => self.set_pass_source(*tmu, *id),
            Call::GuMpDrawTriangle { a, b, c } => self.draw_multipass([a, b, c]),
            _ => self.multipass = MultiPass::default(),
        }
    }

    /// Decodes the rows of a sprite from `v0` on, and of each the pixels from
    /// `u0` on, into the first rows of a level. Where the level wants more rows
    /// than asked for, the last one is stored once more, so that filtering
    /// finds it there.
    fn sprite_call(&mut self, call: &Call) {
        const NAME: &str = "ConvertAndDownloadRle";
        let Call::ConvertAndDownloadRle {
            tmu,
            start,
            this_lod,
            large_lod,
            aspect,
            format,
            even_odd,
            sprite,
            rows,
            u0,
            v0,
            width,
            height,
            dest_width,
            dest_height,
            table,
        } = call
        else {
            return;
        };
        let (small_lod, large_lod, aspect, format) = (*this_lod, *large_lod, *aspect, *format);
        let info = TextureInfo { small_lod, large_lod, aspect, format };
        let colors = format >= 8 && table.len() == 256;
        self.check(colors, NAME, "texels have 16 bits, and 256 colours are needed");
        if !colors || self.texture_unit(NAME, *tmu, *start, *even_odd, &info).is_none() {
            return;
        }
        let sprite = Sprite::new(sprite, usize::try_from(*rows).unwrap_or(0));
        let (width, height) =
            ((*width).min(*dest_width).min(256), (*height).min(*dest_height).min(256));
        // A row is decoded up to the last pixel that is used.
        let first = (*u0).min(256) as usize;
        let mut pixels = vec![0; first + width as usize];
        let mut line = vec![0; (*dest_width).min(256) as usize];
        let extra = u32::from(*dest_height > height);
        for row in 0..height + extra {
            if row < height && !sprite.decode((*v0).saturating_add(row) as usize, &mut pixels) {
                break;
            }
            for (texel, &pixel) in line.iter_mut().zip(&pixels[first..]) {
                *texel = table[usize::from(pixel)];
            }
            let Some((board, unit)) = self.unit(NAME, *tmu) else { return };
            board.download_row_start(unit, *start, small_lod as u32, &info, *even_odd, row, &line);
        }
    }

    fn lfb_call(&mut self, call: &Call) -> bool {
        match call {
            Call::GrLfbLock { kind, buffer, mode, origin, pipeline } => {
                self.lfb_lock(*kind, *buffer, *mode, *origin, *pipeline != 0).is_some()
            }
            Call::GrLfbUnlock { kind, buffer, written } => {
                let Some(board) = self.board("grLfbUnlock") else { return false };
                if let (Some(data), 1) = (written, kind & 0xf) {
                    board.take_whole_memory(data);
                }
                let unlocked = board.unlock(*kind, *buffer);
                self.check(unlocked, "grLfbUnlock", "there is no such lock");
                unlocked
            }
            Call::GrLfbWriteRegion { buffer, x, y, format, width, height, stride, data } => {
                let Some(board) = self.board("grLfbWriteRegion") else { return false };
                let stride = usize::try_from(*stride).unwrap_or(0);
                board.write_region(*buffer, (*x, *y), *format, (*width, *height), stride, data)
            }
            Call::GrLfbStored { changes } => {
                let Some(board) = self.board("grLfbUnlock") else { return false };
                board.apply_stores(changes);
                true
            }
            Call::GuFbWriteRegion { buffer, x, y, width, height, stride, data } => {
                let Some(board) = self.board("guFbWriteRegion") else { return false };
                let stride = usize::try_from(*stride).unwrap_or(0);
                board.write_old_region(*buffer, (*x, *y), (*width, *height), stride, data)
            }
            _ => self.lfb_setting(call),
        }
    }

    fn lfb_setting(&mut self, call: &Call) -> bool {
        use fillrate_call::Tagged;
        let Some(board) = self.board(call.name()) else { return false };
        match *call {
            Call::GrLfbConstantAlpha { alpha } => {
                board.settings.lfb_alpha = alpha;
                if board.lfb.write.is_some() {
                    board.fbi.za_color =
                        replace(board.fbi.za_color, 0xff << 24, u32::from(alpha) << 24);
                }
            }
            Call::GrLfbConstantDepth { depth } => {
                board.settings.lfb_depth = depth;
                if board.lfb.write.is_some() {
                    board.fbi.za_color = replace(board.fbi.za_color, 0xffff, u32::from(depth));
                }
            }
            Call::GrLfbWriteColorFormat { format } if (0..=3).contains(&format) => {
                board.set_lfb_format(format);
            }
            Call::GrLfbWriteColorSwizzle { bytes, words } => {
                let mode = switch(board.fbi.lfb_mode, lfb_mode::SWIZZLE_BYTES, bytes != 0);
                board.fbi.lfb_mode = switch(mode, lfb_mode::SWAP_WORDS, words != 0);
            }
            Call::GrLfbWriteMode { mode } => board.lfb.old.mode = mode,
            Call::GrLfbOrigin { origin } => board.lfb.old.origin = origin,
            Call::GrLfbBypassMode { mode } => board.lfb.old.pipeline = mode == 0,
            _ => {}
        }
        if board.is_locked() && sets_up_old_locks(call) {
            board.set_up_old_locks();
        }
        board.dirty = true;
        true
    }

    /// Write mode, row order and pipeline use of the calls before 2.4.
    pub fn old_lfb_settings(&self) -> (i32, i32, bool) {
        let board = self.boards.get(self.current);
        let old = board.map(|board| board.lfb.old).unwrap_or_default();
        (old.mode, old.origin, old.pipeline)
    }
}

/// Whether a call sets what the calls before 2.4 have for a lock's arguments.
fn sets_up_old_locks(call: &Call) -> bool {
    use Call::{GrLfbBypassMode, GrLfbOrigin, GrLfbWriteMode};
    matches!(call, GrLfbWriteMode { .. } | GrLfbOrigin { .. } | GrLfbBypassMode { .. })
}

/// The mip map that an allocation describes.
fn described(call: &Call) -> Option<MipMap> {
    let Call::GuTexAllocateMemory {
        tmu,
        even_odd,
        width,
        height,
        format,
        mip_map_mode,
        small_lod,
        large_lod,
        aspect,
        s_clamp,
        t_clamp,
        minify,
        magnify,
        lod_bias,
        trilinear,
    } = *call
    else {
        return None;
    };
    Some(MipMap {
        board: 0,
        width,
        height,
        info: TextureInfo { small_lod, large_lod, aspect, format },
        mip_map_mode,
        magnify,
        minify,
        s_clamp,
        t_clamp,
        lod_bias: lod_bias_quarters(lod_bias),
        tmu,
        even_odd: u32::from(even_odd),
        start: 0,
        trilinear: trilinear != 0,
        ncc_table: [0; NCC_TABLE_BYTES],
    })
}

/// The attributes that a change gives.
fn attributes(call: &Call) -> Option<Attributes> {
    let Call::GuTexChangeAttributes {
        id: _,
        width,
        height,
        format,
        mip_map_mode,
        small_lod,
        large_lod,
        aspect,
        s_clamp,
        t_clamp,
        minify,
        magnify,
    } = *call
    else {
        return None;
    };
    Some(Attributes {
        width,
        height,
        format,
        mip_map_mode,
        small_lod,
        large_lod,
        aspect,
        s_clamp,
        t_clamp,
        minify,
        magnify,
    })
}

/// Palette entries, or words of a compression table.
fn download_table(board: &mut Board, unit: usize, table: i32, first: usize, words: &[u32]) -> bool {
    match table {
        0 | 1 => {
            board.memories[unit].set_ncc(table as usize, first, words);
            board.mip_maps.lose_ncc_table(unit, table as usize);
        }
        TEXTABLE_PALETTE => board.memories[unit].set_palette(first, words),
        _ => return false,
    }
    board.dirty = true;
    true
}

/// State of the pixel pipeline. False for an unknown enumerant.
fn pixel_call(board: &mut Board, call: &Call) -> bool {
    match *call {
        Call::GrGlideSetState { ref state } => return board.restore(state),
        Call::GrHints { hint, mask } => return set_hint(board, hint, mask),
        Call::GrSstOrigin { origin } => return board.set_origin(origin),
        Call::GrSstIdle {} => board.clock.idle(),
        Call::GrSstResetPerfStats {} => board.reset_pixel_counters(),
        Call::GrResetTriStats {} => board.reset_triangle_counters(),
        Call::GrSplash { x, y, width, height, frame } => {
            board.draw_splash([x, y, width, height], frame);
        }
        Call::GrSstConfigPipeline { chip, register, value } => {
            return board.write_register(chip, register, value);
        }
        Call::GrBufferClear { color, alpha, depth } => board.clear(color, alpha, depth),
        Call::GrRenderBuffer { buffer } => return board.set_render_buffer(buffer),
        Call::GrClipWindow { x0, y0, x1, y1 } => board.set_clip([x0, y0, x1, y1]),
        Call::GrColorMask { rgb, alpha } => board.set_color_mask(rgb != 0, alpha != 0),
        Call::GrDepthMask { mask } => board.set_depth_mask(mask != 0),
        Call::GrAlphaBlendFunction {
            rgb_source,
            rgb_destination,
            alpha_source,
            alpha_destination,
        } => {
            return board.set_blend([rgb_source, rgb_destination, alpha_source, alpha_destination]);
        }
        Call::GrAlphaCombine { function, factor, local, other, invert } => {
            return board.set_alpha_combine(function, factor, local, other, invert != 0);
        }
        Call::GrAlphaControlsItrgbLighting { enable } => {
            board.set_local_by_texture_alpha(enable != 0);
        }
        Call::GrAlphaTestFunction { function } => return board.set_alpha_test(function),
        Call::GrAlphaTestReferenceValue { value } => board.set_alpha_reference(value),
        Call::GrChromakeyMode { mode } => return board.set_chroma_mode(mode),
        Call::GrChromakeyValue { value } => board.set_chroma_value(value),
        Call::GrColorCombine { function, factor, local, other, invert } => {
            return board.set_color_combine(function, factor, local, other, invert != 0);
        }
        Call::GrConstantColorValue { value } => board.set_constant_color(value),
        Call::GrConstantColorValue4 { a, r, g, b } => {
            board.settings.constant = [r, g, b, a];
            board.dirty = true;
        }
        Call::GrCullMode { mode } => return board.set_cull(mode),
        Call::GrDepthBiasLevel { level } => board.set_depth_bias(level),
        Call::GrDepthBufferFunction { function } => return board.set_depth_function(function),
        Call::GrDepthBufferMode { mode } => return board.set_depth_mode(mode),
        Call::GrDisableAllEffects {} => board.disable_all_effects(),
        Call::GrDitherMode { mode } => return board.set_dither(mode),
        Call::GrFogColorValue { color } => board.set_fog_color(color),
        Call::GrFogMode { mode } => return board.set_fog_mode(mode),
        Call::GrFogTable { ref table } => board.set_fog_table(table),
        Call::GrGammaCorrectionValue { value } => return board.set_gamma(value),
        Call::GuColorCombineFunction { function } => return color_function(board, function),
        Call::GuAlphaSource { mode } => {
            let Some((f, factor, local, other, invert)) = alpha_preset(mode) else { return false };
            return board.set_alpha_combine(f, factor, local, other, invert);
        }
        _ => {}
    }
    true
}

fn color_function(board: &mut Board, function: i32) -> bool {
    let Some((f, factor, local, other, invert)) = color_preset(function) else { return false };
    let known = board.set_color_combine(f, factor, local, other, invert);
    board.settings.delta0 = is_delta0(function);
    known
}

fn set_hint(board: &mut Board, hint: i32, mask: u32) -> bool {
    match hint {
        HINT_STW => board.settings.stw_hints = mask,
        HINT_ALLOW_MIPMAP_DITHER => board.settings.allow_lod_dither = mask != 0,
        _ => {}
    }
    board.dirty = true;
    (0..=6).contains(&hint)
}

/// Primitives. Always true.
fn draw_call(board: &mut Board, call: &Call) -> bool {
    match call {
        Call::GrDrawPoint { point } => board.draw_point(point),
        Call::GrDrawLine { a, b } => board.draw_line(a, b),
        Call::GrDrawTriangle { a, b, c } => board.draw_triangle([a, b, c]),
        Call::GrDrawPolygon { vertices } => board.draw_polygon(vertices),
        Call::GrDrawPlanarPolygon { vertices } => board.draw_planar_polygon(vertices),
        Call::GrAaDrawPoint { point } => board.draw_aa_point(point),
        Call::GrAaDrawLine { a, b } => board.draw_aa_line(a, b),
        Call::GrAaDrawTriangle { a, b, c, ab, bc, ca } => {
            board.draw_aa_triangle([a, b, c], [*ab != 0, *bc != 0, *ca != 0]);
        }
        Call::GrAaDrawPolygon { vertices } => board.draw_aa_polygon(vertices),
        Call::GuDrawTriangleWithClip { a, b, c } => board.draw_triangle_clipped([a, b, c]),
        Call::GuAaDrawTriangleWithClip { a, b, c } => board.draw_aa_triangle_clipped([a, b, c]),
        Call::GuDrawPolygonVertexListWithClip { vertices } => board.draw_polygon_clipped(vertices),
        _ => {}
    }
    true
}
