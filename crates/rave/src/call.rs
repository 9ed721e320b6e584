//! Every call as a value: the border that all of them cross.
//!
//! Objects are named by numbers (see [`crate::handle`]); 0 stands for `NULL`.
//! Pointers are replaced by what they point to when the interface reads it:
//! vertices of a mesh at the draw call, images at creation. What only returns
//! something is a method of [`crate::Context`].
//!
//! Engines that an application registers draw by themselves; calls on their
//! objects do not cross here.

use fillrate_call::{Data, value_enum};

use crate::RaveError;
use crate::vertex::{
    DeviceValue, ImageValue, IndexedTriangle, RaveRect, VGouraud, VMultiTexture, VTexture,
};

value_enum! {
    /// One documented entry point each, with its arguments as the program gave
    /// them, or memory of the program that the library reads.
    ///
    /// Numbers and fields never change; see `fillrate_call`.
    pub enum Call {
        /// `QAEngineEnable`.
        1 => EngineEnable { vendor: i32, engine: i32 },
        /// `QAEngineDisable`.
        2 => EngineDisable { vendor: i32, engine: i32 },
        /// `QADrawContextNew`. `scaled` is the second rectangle of the flag Scale;
        /// `clip` lists rectangles of the device.
        3 => DrawContextNew { engine: u32, device: DeviceValue, rect: RaveRect, scaled: Option<RaveRect>, clip: Option<Vec<RaveRect>>, flags: u32 },
        /// `QADrawContextDelete`.
        4 => DrawContextDelete { context: u32 },
        /// `QASetFloat`.
        5 => SetFloat { context: u32, tag: u32, value: f32 },
        /// `QASetInt`.
        6 => SetInt { context: u32, tag: u32, value: u32 },
        /// `QASetPtr` of a texture.
        7 => SetTexture { context: u32, tag: u32, texture: u32 },
        /// `QADrawPoint`.
        10 => DrawPoint { context: u32, v: VGouraud },
        /// `QADrawLine`.
        11 => DrawLine { context: u32, a: VGouraud, b: VGouraud },
        /// `QADrawTriGouraud`.
        12 => DrawTriGouraud { context: u32, a: VGouraud, b: VGouraud, c: VGouraud, flags: u32 },
        /// `QADrawTriTexture`.
        13 => DrawTriTexture { context: u32, a: VTexture, b: VTexture, c: VTexture, flags: u32 },
        /// `QADrawVGouraud`; one flag for each triangle.
        14 => DrawVGouraud { context: u32, mode: u32, vertices: Vec<VGouraud>, flags: Option<Vec<u32>> },
        /// `QADrawVTexture`.
        15 => DrawVTexture { context: u32, mode: u32, vertices: Vec<VTexture>, flags: Option<Vec<u32>> },
        /// `QADrawBitmap`.
        16 => DrawBitmap { context: u32, v: VGouraud, bitmap: u32 },
        /// `QASubmitVerticesGouraud`, or the program's memory where it changed
        /// since: the vertices that the meshes that follow refer to.
        17 => SubmitVerticesGouraud { context: u32, vertices: Vec<VGouraud> },
        /// `QASubmitVerticesTexture`, or the program's memory where it changed.
        18 => SubmitVerticesTexture { context: u32, vertices: Vec<VTexture> },
        /// `QADrawTriMeshGouraud`.
        19 => DrawTriMeshGouraud { context: u32, triangles: Vec<IndexedTriangle> },
        /// `QADrawTriMeshTexture`.
        20 => DrawTriMeshTexture { context: u32, triangles: Vec<IndexedTriangle> },
        /// `QASubmitMultiTextureParams`, or the program's memory where it
        /// changed: the coordinates of the current layer for what follows.
        21 => SubmitMultiTextureParams { context: u32, layer: u32, params: Vec<VMultiTexture> },
        /// `QARenderStart`; `initial` is a cache context.
        30 => RenderStart { context: u32, dirty: Option<RaveRect>, initial: u32 },
        /// `QARenderEnd`.
        31 => RenderEnd { context: u32, modified: Option<RaveRect> },
        /// `QARenderAbort`.
        32 => RenderAbort { context: u32 },
        /// `QAFlush`.
        33 => Flush { context: u32 },
        /// `QASync`.
        34 => Sync { context: u32 },
        /// `QABusy`.
        35 => Busy { context: u32 },
        /// `QASwapBuffers`.
        36 => SwapBuffers { context: u32, dirty: Option<RaveRect> },
        /// `QASetNoticeMethod`, as far as the engine is concerned: whether there
        /// is a method.
        37 => SetNoticeMethod { context: u32, selector: u32, installed: bool },
        /// `QAAccessDrawBuffer`.
        40 => AccessDrawBuffer { context: u32 },
        /// `QAAccessDrawBufferEnd`, or the end of a buffer notice. `pixels` holds
        /// the rows of `rect` without padding in the context's pixel type, and
        /// is empty where the program wrote nothing.
        41 => AccessDrawBufferEnd { context: u32, rect: RaveRect, pixels: Data },
        /// `QAAccessZBuffer`.
        42 => AccessZBuffer { context: u32 },
        /// `QAAccessZBufferEnd`; elements of the depth's bytes, the low one first.
        43 => AccessZBufferEnd { context: u32, rect: RaveRect, depths: Data },
        /// `QAClearDrawBuffer`; `initial` is a cache context.
        44 => ClearDrawBuffer { context: u32, rect: Option<RaveRect>, initial: u32 },
        /// `QAClearZBuffer`.
        45 => ClearZBuffer { context: u32, rect: Option<RaveRect>, initial: u32 },
        /// `QATextureNewFromDrawContext`.
        46 => TextureFromContext { context: u32, flags: u32 },
        /// `QABitmapNewFromDrawContext`.
        47 => BitmapFromContext { context: u32, flags: u32 },
        /// The contents of the program's memory that a frame is composed with:
        /// rows without padding in the context's pixel type.
        48 => WindowContents { context: u32, pixels: Data },
        /// `QATextureNew`.
        50 => TextureNew { engine: u32, flags: u32, pixel_type: u32, images: Vec<ImageValue> },
        /// `QATextureDetach`.
        51 => TextureDetach { engine: u32, texture: u32 },
        /// `QATextureDelete`.
        52 => TextureDelete { engine: u32, texture: u32 },
        /// `QATextureBindColorTable`.
        53 => TextureBindColorTable { engine: u32, texture: u32, table: u32 },
        /// The program changed the memory of a texture that it lends (NoCopy),
        /// or the ATI extension's texture update.
        54 => TextureUpdate { engine: u32, texture: u32, flags: u32, pixel_type: u32, images: Vec<ImageValue> },
        /// `QAAccessTexture`.
        55 => AccessTexture { engine: u32, texture: u32, level: i32, flags: i32 },
        /// `QAAccessTextureEnd`; rows of `rect` without padding.
        56 => AccessTextureEnd { engine: u32, texture: u32, rect: RaveRect, pixels: Data },
        /// `QABitmapNew`.
        60 => BitmapNew { engine: u32, flags: u32, pixel_type: u32, image: ImageValue },
        /// `QABitmapDetach`.
        61 => BitmapDetach { engine: u32, bitmap: u32 },
        /// `QABitmapDelete`.
        62 => BitmapDelete { engine: u32, bitmap: u32 },
        /// `QABitmapBindColorTable`.
        63 => BitmapBindColorTable { engine: u32, bitmap: u32, table: u32 },
        /// The program changed the memory of a bitmap that it lends.
        64 => BitmapUpdate { engine: u32, bitmap: u32, image: ImageValue },
        /// `QAAccessBitmap`.
        65 => AccessBitmap { engine: u32, bitmap: u32, flags: i32 },
        /// `QAAccessBitmapEnd`.
        66 => AccessBitmapEnd { engine: u32, bitmap: u32, rect: RaveRect, pixels: Data },
        /// `QAColorTableNew`; entries 0x00RRGGBB, four bytes each, the low one
        /// first.
        70 => ColorTableNew { engine: u32, table_type: u32, entries: Data, transparent_index: i32 },
        /// `QAColorTableDelete`.
        71 => ColorTableDelete { engine: u32, table: u32 },
    }
}

/// What a call returns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Reply {
    /// Nothing.
    #[default]
    Nothing,
    /// Success or an error.
    Status(Result<(), RaveError>),
    /// The number of a new object, or why there is none.
    Created(Result<u32, RaveError>),
    /// Whether work is pending.
    Busy(bool),
}

impl Reply {
    /// The `TQAError` that a C function returns, or its truth value.
    pub fn number(&self) -> i32 {
        match self {
            Reply::Nothing => 0,
            Reply::Status(result) => crate::error::status_code(result),
            Reply::Created(result) => crate::error::status_code(result),
            Reply::Busy(busy) => i32::from(*busy),
        }
    }

    /// The new object's number; 0 where there is none.
    pub fn created(&self) -> u32 {
        match self {
            Reply::Created(Ok(number)) => *number,
            _ => 0,
        }
    }
}
