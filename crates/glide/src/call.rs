//! Every call as a value: the border that all of them cross.

use fillrate_call::{Data, value_enum};

use crate::vertex::GrVertex;

value_enum! {
    /// One historic entry point each, with its arguments as the program gave
    /// them. Pointers are replaced by what they pointed to; calls that only
    /// return something carry no data.
    ///
    /// Numbers and fields never change; see `fillrate_call`.
    pub enum Call {
        /// Starts the library.
        1 => GrGlideInit {},
        /// Closes all boards and stops the library.
        2 => GrGlideShutdown {},
        /// Restores a saved state.
        3 => GrGlideSetState { state: Data },
        /// Sets a hint.
        4 => GrHints { hint: i32, mask: u32 },
        /// Chooses the current board.
        5 => GrSstSelect { board: i32 },
        /// Opens the current board.
        6 => GrSstWinOpen { window: u32, resolution: i32, refresh: i32, color_format: i32, origin: i32, colors: i32, aux: i32 },
        /// Closes the current board.
        7 => GrSstWinClose {},
        /// Chooses the row order.
        8 => GrSstOrigin { origin: i32 },
        /// Waits for the board.
        9 => GrSstIdle {},
        /// Resets the pixel counters.
        10 => GrSstResetPerfStats {},
        /// Resets the triangle counters.
        11 => GrResetTriStats {},
        /// Writes a raw register.
        12 => GrSstConfigPipeline { chip: i32, register: u32, value: u32 },
        /// Draws the start-up picture: one frame, or all of it for frame 0.
        13 => GrSplash { x: f32, y: f32, width: f32, height: f32, frame: u32 },
        /// Switches the mark in the corner.
        14 => GrGlideShamelessPlug { on: i32 },
        /// Fills the clip window.
        20 => GrBufferClear { color: u32, alpha: u8, depth: u16 },
        /// Shows the back buffer.
        21 => GrBufferSwap { interval: i32 },
        /// Chooses the buffer to draw into.
        22 => GrRenderBuffer { buffer: i32 },
        /// Sets the clip window.
        23 => GrClipWindow { x0: u32, y0: u32, x1: u32, y1: u32 },
        /// Sets the colour and alpha masks.
        24 => GrColorMask { rgb: i32, alpha: i32 },
        /// Sets the depth mask.
        25 => GrDepthMask { mask: i32 },
        /// Sets the blend factors.
        30 => GrAlphaBlendFunction { rgb_source: i32, rgb_destination: i32, alpha_source: i32, alpha_destination: i32 },
        /// Sets the alpha combine unit.
        31 => GrAlphaCombine { function: i32, factor: i32, local: i32, other: i32, invert: i32 },
        /// Lets texture alpha choose the local colour.
        32 => GrAlphaControlsItrgbLighting { enable: i32 },
        /// Sets the alpha test.
        33 => GrAlphaTestFunction { function: i32 },
        /// Sets the alpha test's reference.
        34 => GrAlphaTestReferenceValue { value: u8 },
        /// Switches the chroma key.
        35 => GrChromakeyMode { mode: i32 },
        /// Sets the chroma key.
        36 => GrChromakeyValue { value: u32 },
        /// Sets the colour combine unit.
        37 => GrColorCombine { function: i32, factor: i32, local: i32, other: i32, invert: i32 },
        /// Sets the constant colour.
        38 => GrConstantColorValue { value: u32 },
        /// Sets the delta-0 colour.
        39 => GrConstantColorValue4 { a: f32, r: f32, g: f32, b: f32 },
        /// Sets culling.
        40 => GrCullMode { mode: i32 },
        /// Sets the depth bias.
        41 => GrDepthBiasLevel { level: i16 },
        /// Sets the depth comparison.
        42 => GrDepthBufferFunction { function: i32 },
        /// Sets depth buffering.
        43 => GrDepthBufferMode { mode: i32 },
        /// Switches effects off.
        44 => GrDisableAllEffects {},
        /// Sets dithering.
        45 => GrDitherMode { mode: i32 },
        /// Sets the fog colour.
        46 => GrFogColorValue { color: u32 },
        /// Sets fog.
        47 => GrFogMode { mode: i32 },
        /// Sets the fog table.
        48 => GrFogTable { table: [u8; 64] },
        /// Sets gamma.
        49 => GrGammaCorrectionValue { value: f32 },
        /// Sets the colour combine unit by a preset.
        50 => GuColorCombineFunction { function: i32 },
        /// Sets the alpha combine unit by a preset.
        51 => GuAlphaSource { mode: i32 },
        /// Draws a point.
        60 => GrDrawPoint { point: GrVertex },
        /// Draws a line.
        61 => GrDrawLine { a: GrVertex, b: GrVertex },
        /// Draws a triangle.
        62 => GrDrawTriangle { a: GrVertex, b: GrVertex, c: GrVertex },
        /// Draws a fan.
        63 => GrDrawPolygon { vertices: Vec<GrVertex> },
        /// Draws a fan of one plane.
        64 => GrDrawPlanarPolygon { vertices: Vec<GrVertex> },
        /// Draws a smooth point.
        65 => GrAaDrawPoint { point: GrVertex },
        /// Draws a smooth line.
        66 => GrAaDrawLine { a: GrVertex, b: GrVertex },
        /// Draws a triangle with smooth edges.
        67 => GrAaDrawTriangle { a: GrVertex, b: GrVertex, c: GrVertex, ab: i32, bc: i32, ca: i32 },
        /// Draws a fan with smooth edges.
        68 => GrAaDrawPolygon { vertices: Vec<GrVertex> },
        /// Draws a triangle clipped to the clip window.
        69 => GuDrawTriangleWithClip { a: GrVertex, b: GrVertex, c: GrVertex },
        /// Draws a smooth triangle clipped to the clip window.
        70 => GuAaDrawTriangleWithClip { a: GrVertex, b: GrVertex, c: GrVertex },
        /// Draws a fan clipped to the clip window.
        71 => GuDrawPolygonVertexListWithClip { vertices: Vec<GrVertex> },
        /// Points a unit at a texture.
        80 => GrTexSource { tmu: i32, start: u32, even_odd: u32, small_lod: i32, large_lod: i32, aspect: i32, format: i32 },
        /// Stores all levels of a texture.
        81 => GrTexDownloadMipMap { tmu: i32, start: u32, even_odd: u32, small_lod: i32, large_lod: i32, aspect: i32, format: i32, data: Data },
        /// Stores rows of a level.
        82 => GrTexDownloadMipMapLevelPartial { tmu: i32, start: u32, this_lod: i32, large_lod: i32, aspect: i32, format: i32, even_odd: u32, data: Data, first: i32, last: i32 },
        /// Stores palette or compression table words from `first` on.
        83 => GrTexDownloadTable { tmu: i32, table: i32, first: u32, words: Vec<u32> },
        /// Chooses a compression table.
        84 => GrTexNccTable { tmu: i32, table: i32 },
        /// Sets clamping.
        85 => GrTexClampMode { tmu: i32, s: i32, t: i32 },
        /// Sets a texture combine unit.
        86 => GrTexCombine { tmu: i32, rgb_function: i32, rgb_factor: i32, alpha_function: i32, alpha_factor: i32, rgb_invert: i32, alpha_invert: i32 },
        /// Sets a texture combine unit by a preset.
        87 => GrTexCombineFunction { tmu: i32, function: i32 },
        /// Sets the detail factor.
        88 => GrTexDetailControl { tmu: i32, lod_bias: i32, scale: u8, max: f32 },
        /// Sets the filters.
        89 => GrTexFilterMode { tmu: i32, minify: i32, magnify: i32 },
        /// Sets the level bias.
        90 => GrTexLodBiasValue { tmu: i32, bias: f32 },
        /// Sets mip mapping.
        91 => GrTexMipMapMode { tmu: i32, mode: i32, blend: i32 },
        /// Switches several base addresses.
        92 => GrTexMultibase { tmu: i32, enable: i32 },
        /// Sets one of several base addresses.
        93 => GrTexMultibaseAddress { tmu: i32, range: i32, start: u32, even_odd: u32, small_lod: i32, large_lod: i32, aspect: i32, format: i32 },
        /// Starts frame buffer access.
        100 => GrLfbLock { kind: i32, buffer: i32, mode: i32, origin: i32, pipeline: i32 },
        /// Ends frame buffer access; in recordings of 0.1 and before with the whole
        /// memory, where anything was stored.
        101 => GrLfbUnlock { kind: i32, buffer: i32, written: Option<Data> },
        /// Sets the alpha of writes without alpha.
        102 => GrLfbConstantAlpha { alpha: u8 },
        /// Sets the depth of writes without depth.
        103 => GrLfbConstantDepth { depth: u16 },
        /// Sets the colour format of writes.
        104 => GrLfbWriteColorFormat { format: i32 },
        /// Writes a rectangle.
        105 => GrLfbWriteRegion { buffer: i32, x: u32, y: u32, format: i32, width: u32, height: u32, stride: i32, data: Data },
        /// Sets the write mode of the calls before 2.4.
        106 => GrLfbWriteMode { mode: i32 },
        /// Sets the row order of the calls before 2.4.
        107 => GrLfbOrigin { origin: i32 },
        /// Sets the pixel pipeline's bypass of the calls before 2.4.
        108 => GrLfbBypassMode { mode: i32 },
        /// Exchanges the bytes or half words of what is written.
        109 => GrLfbWriteColorSwizzle { bytes: i32, words: i32 },
        /// Takes texture memory for a mip map.
        130 => GuTexAllocateMemory { tmu: i32, even_odd: u8, width: i32, height: i32, format: i32, mip_map_mode: i32, small_lod: i32, large_lod: i32, aspect: i32, s_clamp: i32, t_clamp: i32, minify: i32, magnify: i32, lod_bias: f32, trilinear: i32 },
        /// Changes how a mip map is sampled; -1 keeps a field.
        131 => GuTexChangeAttributes { id: u32, width: i32, height: i32, format: i32, mip_map_mode: i32, small_lod: i32, large_lod: i32, aspect: i32, s_clamp: i32, t_clamp: i32, minify: i32, magnify: i32 },
        /// Stores all levels of a mip map, and its compression table.
        132 => GuTexDownloadMipMap { id: u32, data: Data, table: Option<Data> },
        /// Stores one level of a mip map.
        133 => GuTexDownloadMipMapLevel { id: u32, lod: i32, data: Data },
        /// Makes a mip map current.
        134 => GuTexSource { id: u32 },
        /// Forgets all mip maps.
        135 => GuTexMemReset {},
        /// Forgets the virtual texture units.
        136 => GuMpInit {},
        /// Sets how the virtual texture units are put together.
        137 => GuMpTexCombineFunction { function: i32 },
        /// Chooses the mip map of a virtual texture unit.
        138 => GuMpTexSource { tmu: i32, id: u32 },
        /// Draws a triangle with both virtual texture units.
        139 => GuMpDrawTriangle { a: GrVertex, b: GrVertex, c: GrVertex },
        /// Starts a movie, which no release ever did.
        140 => GuMovieStart {},
        /// Stops a movie.
        141 => GuMovieStop {},
        /// Names a movie.
        142 => GuMovieSetName { name: Data },
        /// Writes a rectangle of 16-bit pixels as the calls before 2.4 did.
        143 => GuFbWriteRegion { buffer: i32, x: i32, y: i32, width: i32, height: i32, stride: i32, data: Data },
        /// Decodes a sprite into a texture level.
        144 => ConvertAndDownloadRle { tmu: i32, start: u32, this_lod: i32, large_lod: i32, aspect: i32, format: i32, even_odd: u32, sprite: Data, rows: i32, u0: u32, v0: u32, width: u32, height: u32, dest_width: u32, dest_height: u32, table: Vec<u16> },
        /// What was stored through the write lock: runs of pixels.
        145 => GrLfbStored { changes: Data },
        /// Opens the current board as before 2.4.
        146 => GrSstOpen { resolution: i32, refresh: i32, color_format: i32, origin: i32, smoothing: i32, buffers: i32 },
    }
}
