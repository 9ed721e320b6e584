//! Calls of every kind from bytes.

use fillrate_call::{Decoder, Tagged, Value};
use fillrate_glide::Call;

use super::Bytes;

/// A call whose arguments follow from bytes: plausible ones mostly, anything
/// else now and then.
pub fn any_call(from: &mut Bytes<'_>) -> Call {
    let kind = from.byte() & 127;
    match known_call(kind, from) {
        Some(call) => call,
        None => decoded_call(from).unwrap_or(Call::GrSstIdle {}),
    }
}

/// A call of any tag, decoded from words in a row. Reaches calls that
/// [`known_call`] does not list, and arguments that it would not make.
fn decoded_call(from: &mut Bytes<'_>) -> Option<Call> {
    let variants = Call::VARIANTS;
    let pick = usize::from(from.byte()) | usize::from(from.byte()) << 8;
    let mut bytes = variants[pick % variants.len()].0.to_le_bytes().to_vec();
    // Lists and data take their lengths from here too.
    bytes.extend((0..40).flat_map(|_| from.int().to_le_bytes()));
    Call::decode(&mut Decoder::new(&bytes)).ok()
}

/// A call with arguments of the right kind for each; `None` past the last.
fn known_call(kind: u8, from: &mut Bytes<'_>) -> Option<Call> {
    Some(match kind {
        0 => Call::GrGlideInit {},
        1 => Call::GrGlideShutdown {},
        2 => Call::GrGlideSetState { state: from.data() },
        3 => Call::GrHints { hint: from.int(), mask: from.word() },
        4 => Call::GrSstSelect { board: from.int() },
        5 => Call::GrSstWinOpen {
            window: from.word(),
            resolution: from.int(),
            refresh: from.int(),
            color_format: from.int(),
            origin: from.int(),
            colors: from.int(),
            aux: from.int(),
        },
        6 => Call::GrSstWinClose {},
        7 => Call::GrSstOrigin { origin: from.int() },
        8 => Call::GrSstIdle {},
        9 => Call::GrSstResetPerfStats {},
        10 => Call::GrResetTriStats {},
        11 => Call::GrSstConfigPipeline {
            chip: from.int(),
            register: from.word(),
            value: from.word(),
        },
        12 => Call::GrBufferClear {
            color: from.word(),
            alpha: from.byte(),
            depth: from.unsigned_half(),
        },
        13 => Call::GrBufferSwap { interval: from.int() },
        14 => Call::GrRenderBuffer { buffer: from.int() },
        15 => Call::GrClipWindow {
            x0: from.word(),
            y0: from.word(),
            x1: from.word(),
            y1: from.word(),
        },
        16 => Call::GrColorMask { rgb: from.int(), alpha: from.int() },
        17 => Call::GrDepthMask { mask: from.int() },
        18 => Call::GrAlphaBlendFunction {
            rgb_source: from.int(),
            rgb_destination: from.int(),
            alpha_source: from.int(),
            alpha_destination: from.int(),
        },
        19 => Call::GrAlphaCombine {
            function: from.int(),
            factor: from.int(),
            local: from.int(),
            other: from.int(),
            invert: from.int(),
        },
        20 => Call::GrAlphaControlsItrgbLighting { enable: from.int() },
        21 => Call::GrAlphaTestFunction { function: from.int() },
        22 => Call::GrAlphaTestReferenceValue { value: from.byte() },
        23 => Call::GrChromakeyMode { mode: from.int() },
        24 => Call::GrChromakeyValue { value: from.word() },
        25 => Call::GrColorCombine {
            function: from.int(),
            factor: from.int(),
            local: from.int(),
            other: from.int(),
            invert: from.int(),
        },
        26 => Call::GrConstantColorValue { value: from.word() },
        27 => Call::GrConstantColorValue4 {
            a: from.float(),
            r: from.float(),
            g: from.float(),
            b: from.float(),
        },
        28 => Call::GrCullMode { mode: from.int() },
        29 => Call::GrDepthBiasLevel { level: from.half() },
        30 => Call::GrDepthBufferFunction { function: from.int() },
        31 => Call::GrDepthBufferMode { mode: from.int() },
        32 => Call::GrDisableAllEffects {},
        33 => Call::GrDitherMode { mode: from.int() },
        34 => Call::GrFogColorValue { color: from.word() },
        35 => Call::GrFogMode { mode: from.int() },
        36 => Call::GrFogTable { table: from.fog_table() },
        37 => Call::GrGammaCorrectionValue { value: from.float() },
        38 => Call::GuColorCombineFunction { function: from.int() },
        39 => Call::GuAlphaSource { mode: from.int() },
        40 => Call::GrDrawPoint { point: from.vertex() },
        41 => Call::GrDrawLine { a: from.vertex(), b: from.vertex() },
        42 => Call::GrDrawTriangle { a: from.vertex(), b: from.vertex(), c: from.vertex() },
        43 => Call::GrDrawPolygon { vertices: from.vertices() },
        44 => Call::GrDrawPlanarPolygon { vertices: from.vertices() },
        45 => Call::GrAaDrawPoint { point: from.vertex() },
        46 => Call::GrAaDrawLine { a: from.vertex(), b: from.vertex() },
        47 => Call::GrAaDrawTriangle {
            a: from.vertex(),
            b: from.vertex(),
            c: from.vertex(),
            ab: from.int(),
            bc: from.int(),
            ca: from.int(),
        },
        48 => Call::GrAaDrawPolygon { vertices: from.vertices() },
        49 => Call::GuDrawTriangleWithClip { a: from.vertex(), b: from.vertex(), c: from.vertex() },
        50 => {
            Call::GuAaDrawTriangleWithClip { a: from.vertex(), b: from.vertex(), c: from.vertex() }
        }
        51 => Call::GuDrawPolygonVertexListWithClip { vertices: from.vertices() },
        52 => Call::GrTexSource {
            tmu: from.unit(),
            start: from.address(),
            even_odd: from.levels(),
            small_lod: from.level(),
            large_lod: from.level(),
            aspect: from.int(),
            format: from.int(),
        },
        53 => Call::GrTexDownloadMipMap {
            tmu: from.unit(),
            start: from.address(),
            even_odd: from.levels(),
            small_lod: from.level(),
            large_lod: from.level(),
            aspect: from.int(),
            format: from.int(),
            data: from.data(),
        },
        54 => Call::GrTexDownloadMipMapLevelPartial {
            tmu: from.unit(),
            start: from.address(),
            this_lod: from.level(),
            large_lod: from.level(),
            aspect: from.int(),
            format: from.int(),
            even_odd: from.levels(),
            data: from.data(),
            first: from.int(),
            last: from.int(),
        },
        55 => Call::GrTexDownloadTable {
            tmu: from.unit(),
            table: from.int(),
            first: from.word(),
            words: from.words(),
        },
        56 => Call::GrTexNccTable { tmu: from.unit(), table: from.int() },
        57 => Call::GrTexClampMode { tmu: from.unit(), s: from.int(), t: from.int() },
        58 => Call::GrTexCombine {
            tmu: from.unit(),
            rgb_function: from.int(),
            rgb_factor: from.int(),
            alpha_function: from.int(),
            alpha_factor: from.int(),
            rgb_invert: from.int(),
            alpha_invert: from.int(),
        },
        59 => Call::GrTexCombineFunction { tmu: from.unit(), function: from.int() },
        60 => Call::GrTexDetailControl {
            tmu: from.unit(),
            lod_bias: from.int(),
            scale: from.byte(),
            max: from.float(),
        },
        61 => Call::GrTexFilterMode { tmu: from.unit(), minify: from.int(), magnify: from.int() },
        62 => Call::GrTexLodBiasValue { tmu: from.unit(), bias: from.float() },
        63 => Call::GrTexMipMapMode { tmu: from.unit(), mode: from.int(), blend: from.int() },
        64 => Call::GrTexMultibase { tmu: from.unit(), enable: from.int() },
        65 => Call::GrTexMultibaseAddress {
            tmu: from.unit(),
            range: from.int(),
            start: from.address(),
            even_odd: from.levels(),
            small_lod: from.level(),
            large_lod: from.level(),
            aspect: from.int(),
            format: from.int(),
        },
        66 => Call::GrLfbLock {
            kind: from.int(),
            buffer: from.int(),
            mode: from.int(),
            origin: from.int(),
            pipeline: from.int(),
        },
        67 => {
            Call::GrLfbUnlock { kind: from.int(), buffer: from.int(), written: from.maybe_data() }
        }
        68 => Call::GrLfbConstantAlpha { alpha: from.byte() },
        69 => Call::GrLfbConstantDepth { depth: from.unsigned_half() },
        70 => Call::GrLfbWriteColorFormat { format: from.int() },
        71 => Call::GrLfbWriteRegion {
            buffer: from.int(),
            x: from.word(),
            y: from.word(),
            format: from.int(),
            width: from.word(),
            height: from.word(),
            stride: from.int(),
            data: from.data(),
        },
        72 => Call::GrLfbWriteMode { mode: from.int() },
        73 => Call::GrLfbOrigin { origin: from.int() },
        74 => Call::GrLfbBypassMode { mode: from.int() },
        75 => Call::GrLfbWriteColorSwizzle { bytes: from.int(), words: from.int() },
        76 => Call::GuTexAllocateMemory {
            tmu: from.unit(),
            even_odd: from.byte(),
            width: from.int(),
            height: from.int(),
            format: from.int(),
            mip_map_mode: from.int(),
            small_lod: from.level(),
            large_lod: from.level(),
            aspect: from.int(),
            s_clamp: from.int(),
            t_clamp: from.int(),
            minify: from.int(),
            magnify: from.int(),
            lod_bias: from.float(),
            trilinear: from.int(),
        },
        77 => Call::GuTexChangeAttributes {
            id: from.handle(),
            width: from.int(),
            height: from.int(),
            format: from.int(),
            mip_map_mode: from.int(),
            small_lod: from.level(),
            large_lod: from.level(),
            aspect: from.int(),
            s_clamp: from.int(),
            t_clamp: from.int(),
            minify: from.int(),
            magnify: from.int(),
        },
        78 => Call::GuTexDownloadMipMap {
            id: from.handle(),
            data: from.data(),
            table: from.maybe_data(),
        },
        79 => {
            Call::GuTexDownloadMipMapLevel { id: from.handle(), lod: from.int(), data: from.data() }
        }
        80 => Call::GuTexSource { id: from.handle() },
        81 => Call::GuTexMemReset {},
        82 => Call::GuMpInit {},
        83 => Call::GuMpTexCombineFunction { function: from.int() },
        84 => Call::GuMpTexSource { tmu: from.unit(), id: from.handle() },
        85 => Call::GuMpDrawTriangle { a: from.vertex(), b: from.vertex(), c: from.vertex() },
        86 => Call::GuMovieStart {},
        87 => Call::GuMovieStop {},
        88 => Call::GuMovieSetName { name: from.data() },
        89 => Call::GuFbWriteRegion {
            buffer: from.int(),
            x: from.int(),
            y: from.int(),
            width: from.int(),
            height: from.int(),
            stride: from.int(),
            data: from.data(),
        },
        90 => Call::ConvertAndDownloadRle {
            tmu: from.unit(),
            start: from.address(),
            this_lod: from.level(),
            large_lod: from.level(),
            aspect: from.int(),
            format: from.int(),
            even_odd: from.levels(),
            sprite: from.data(),
            rows: from.int(),
            u0: from.word(),
            v0: from.word(),
            width: from.word(),
            height: from.word(),
            dest_width: from.word(),
            dest_height: from.word(),
            table: from.halves(),
        },
        // Triangles are what all the state is for.
        91..=111 => Call::GrDrawTriangle { a: from.vertex(), b: from.vertex(), c: from.vertex() },
        112 => Call::GrSstOpen {
            resolution: from.int(),
            refresh: from.int(),
            color_format: from.int(),
            origin: from.int(),
            smoothing: from.int(),
            buffers: from.int(),
        },
        113 => Call::GrLfbStored { changes: from.data() },
        _ => return None,
    })
}
