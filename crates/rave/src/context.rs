//! The library: engines, draw contexts and other objects by number.

use std::collections::BTreeMap;
use std::sync::Arc;

use fillrate_engine::{Counters, DeviceConfig};

use crate::RaveError;
use crate::call::{Call, Reply};
use crate::color_table::ColorTable;
use crate::constants::{context, notice, texture};
use crate::draw::Pen;
use crate::draw_context::{ContextSpec, DrawContext};
use crate::engine::Engine;
use crate::foreign::Foreign;
use crate::front::Shown;
use crate::gestalt::{Answer, selector};
use crate::handle::{BitmapId, DrawContextId, EngineId, TextureId};
use crate::manager::Manager;
use crate::memory::MemoryConfig;
use crate::objects::Objects;
use crate::painter::Painter;
use crate::pixel::PixelType;
use crate::texture::Picture;
use crate::vertex::{DeviceValue, ImageValue, RaveRect, VGouraud, VMultiTexture, VTexture};

/// The most draw contexts at a time.
pub const MAX_CONTEXTS: usize = 64;
/// The most pixels of all draw contexts.
const MAX_PIXELS: u64 = 1 << 26;
/// The most textures and bitmaps at a time.
const MAX_PICTURES: usize = 1 << 16;
/// The most vertices that are submitted at once.
const MAX_VERTICES: usize = 1 << 24;

/// How a library works.
#[derive(Clone, Debug)]
pub struct RaveConfig {
    /// How the engine draws; none of it changes a pixel.
    pub device: DeviceConfig,
    /// Draws frames while the program goes on, on one thread more where the device
    /// has only the caller's. It changes no pixel.
    pub asynchronous: bool,
    /// The modelled board's memory for textures.
    pub memory: MemoryConfig,
    /// Says that the engine is Apple's software engine, for programs that look
    /// for that one.
    pub as_apple_software: bool,
}

impl Default for RaveConfig {
    /// All cores, asynchronous, ample memory, under its own name.
    fn default() -> RaveConfig {
        RaveConfig {
            device: DeviceConfig::default(),
            asynchronous: true,
            memory: MemoryConfig::default(),
            as_apple_software: false,
        }
    }
}

/// A RAVE library without global state.
#[derive(Debug)]
pub struct Context {
    config: RaveConfig,
    pub(crate) manager: Manager,
    /// The renderer, once there is something to draw on.
    pub(crate) painter: Option<Painter>,
    pub(crate) objects: Objects,
    pub(crate) contexts: BTreeMap<u32, DrawContext>,
    /// Objects of the application's engines.
    pub(crate) foreign: Foreign,
    /// The context that showed a frame last.
    pub(crate) shown: Option<u32>,
    /// Some picture is older than the context that it is made from.
    pub(crate) has_stale: bool,
}

impl Default for Context {
    fn default() -> Context {
        Context::new(RaveConfig::default())
    }
}

impl Context {
    /// A library without objects besides its engine.
    pub fn new(config: RaveConfig) -> Context {
        Context {
            manager: Manager::new(&config),
            painter: None,
            objects: Objects::new(config.memory),
            contexts: BTreeMap::new(),
            foreign: Foreign::default(),
            shown: None,
            has_stale: false,
            config,
        }
    }

    /// How it works.
    pub fn config(&self) -> &RaveConfig {
        &self.config
    }

    /// Carries a call out.
    pub fn execute(&mut self, call: &Call) -> Reply {
        if self.manager.has_foreign()
            && let Some(reply) = self.execute_foreign(call)
        {
            return reply;
        }
        match call {
            Call::EngineEnable { vendor, engine } => {
                Reply::Status(self.manager.enable(*vendor, *engine, true))
            }
            Call::EngineDisable { vendor, engine } => {
                Reply::Status(self.manager.enable(*vendor, *engine, false))
            }
            Call::DrawContextNew { engine, device, rect, scaled, clip, flags } => {
                let spec = ContextSpec {
                    engine: *engine,
                    device: *device,
                    rect: *rect,
                    scaled: *scaled,
                    clip: clip.clone(),
                    flags: *flags,
                };
                Reply::Created(self.context_new(spec))
            }
            Call::DrawContextDelete { context } => {
                self.context_delete(*context);
                Reply::Nothing
            }
            Call::SetFloat { context, tag, value } => {
                self.change(*context, |context| context.state.set_float(*tag, *value))
            }
            Call::SetInt { context, tag, value } => {
                self.change(*context, |context| context.state.set_int(*tag, *value))
            }
            Call::SetTexture { context, tag, texture } => {
                self.set_texture(*context, *tag, *texture)
            }
            Call::SubmitVerticesGouraud { context, vertices } => {
                self.submit_vertices_gouraud(DrawContextId(*context), vertices);
                Reply::Nothing
            }
            Call::SubmitVerticesTexture { context, vertices } => {
                self.submit_vertices_texture(DrawContextId(*context), vertices);
                Reply::Nothing
            }
            Call::SubmitMultiTextureParams { context, layer, params } => {
                self.submit_params(DrawContextId(*context), *layer, params);
                Reply::Nothing
            }
            Call::SetNoticeMethod { context, selector, installed } => {
                Reply::Status(self.set_notice(*context, *selector, *installed))
            }
            Call::RenderStart { .. }
            | Call::RenderEnd { .. }
            | Call::RenderAbort { .. }
            | Call::Flush { .. }
            | Call::Sync { .. }
            | Call::Busy { .. }
            | Call::SwapBuffers { .. }
            | Call::AccessDrawBuffer { .. }
            | Call::AccessDrawBufferEnd { .. }
            | Call::AccessZBuffer { .. }
            | Call::AccessZBufferEnd { .. }
            | Call::ClearDrawBuffer { .. }
            | Call::ClearZBuffer { .. }
            | Call::TextureFromContext { .. }
            | Call::BitmapFromContext { .. }
            | Call::WindowContents { .. } => self.execute_frame(call),
            Call::DrawPoint { .. }
            | Call::DrawLine { .. }
            | Call::DrawTriGouraud { .. }
            | Call::DrawTriTexture { .. }
            | Call::DrawVGouraud { .. }
            | Call::DrawVTexture { .. }
            | Call::DrawBitmap { .. }
            | Call::DrawTriMeshGouraud { .. }
            | Call::DrawTriMeshTexture { .. } => self.execute_draw(call),
            _ => self.execute_object(call),
        }
    }

    /// Calls that draw.
    fn execute_draw(&mut self, call: &Call) -> Reply {
        macro_rules! pen {
            ($context:expr, |$pen:ident| $body:expr) => {
                if let Some(mut $pen) = self.pen(*$context) {
                    $body;
                }
            };
        }
        match call {
            Call::DrawPoint { context, v } => pen!(context, |pen| pen.point(v)),
            Call::DrawLine { context, a, b } => pen!(context, |pen| pen.line([a, b])),
            Call::DrawTriGouraud { context, a, b, c, .. } => {
                pen!(context, |pen| pen.tri_gouraud([a, b, c]))
            }
            Call::DrawTriTexture { context, a, b, c, .. } => {
                pen!(context, |pen| pen.tri_texture([a, b, c], [0, 1, 2]))
            }
            Call::DrawVGouraud { context, mode, vertices, .. } => {
                pen!(context, |pen| pen.v_gouraud(*mode, vertices))
            }
            Call::DrawVTexture { context, mode, vertices, .. } => {
                pen!(context, |pen| pen.v_texture(*mode, vertices))
            }
            Call::DrawBitmap { context, v, bitmap } => {
                pen!(context, |pen| pen.bitmap(v, *bitmap))
            }
            Call::DrawTriMeshGouraud { context, triangles } => {
                pen!(context, |pen| pen.mesh_gouraud(triangles))
            }
            Call::DrawTriMeshTexture { context, triangles } => {
                pen!(context, |pen| pen.mesh_texture(triangles))
            }
            _ => {}
        }
        Reply::Nothing
    }

    /// Calls on frames and buffers.
    fn execute_frame(&mut self, call: &Call) -> Reply {
        match call {
            Call::RenderStart { context, dirty, initial } => {
                self.render_start(*context, dirty.as_ref(), *initial);
                Reply::Nothing
            }
            Call::RenderEnd { context, modified } => {
                Reply::Status(self.render_end(*context, modified.as_ref()))
            }
            Call::RenderAbort { context } => Reply::Status(self.render_abort(*context)),
            Call::Flush { context } => Reply::Status(self.flush(*context)),
            Call::Sync { context } => Reply::Status(self.sync(*context)),
            Call::Busy { context } => {
                let exists = self.contexts.contains_key(context);
                Reply::Busy(exists && self.is_busy())
            }
            Call::SwapBuffers { context, dirty } => {
                Reply::Status(self.swap_buffers(*context, dirty.as_ref()))
            }
            Call::AccessDrawBuffer { context } => Reply::Status(self.access_draw_buffer(*context)),
            Call::AccessDrawBufferEnd { context, rect, pixels } => {
                Reply::Status(self.access_draw_buffer_end(*context, rect, pixels))
            }
            Call::AccessZBuffer { context } => Reply::Status(self.access_z_buffer(*context)),
            Call::AccessZBufferEnd { context, rect, depths } => {
                Reply::Status(self.access_z_buffer_end(*context, rect, depths))
            }
            Call::ClearDrawBuffer { context, rect, initial } => {
                Reply::Status(self.clear_buffer(*context, rect.as_ref(), *initial, [true, false]))
            }
            Call::ClearZBuffer { context, rect, initial } => {
                Reply::Status(self.clear_buffer(*context, rect.as_ref(), *initial, [false, true]))
            }
            Call::TextureFromContext { context, flags } => {
                Reply::Created(self.picture_from(*context, *flags, false))
            }
            Call::BitmapFromContext { context, flags } => {
                Reply::Created(self.picture_from(*context, *flags, true))
            }
            Call::WindowContents { context, pixels } => {
                Reply::Status(self.window_contents(*context, pixels))
            }
            _ => Reply::Nothing,
        }
    }

    /// Calls on textures, bitmaps and colour tables.
    fn execute_object(&mut self, call: &Call) -> Reply {
        match call {
            Call::TextureNew { engine, flags, pixel_type, images } => {
                Reply::Created(self.texture_new(*engine, *flags, *pixel_type, images))
            }
            Call::BitmapNew { engine, flags, pixel_type, image } => {
                Reply::Created(self.bitmap_new(*engine, *flags, *pixel_type, image))
            }
            Call::TextureDetach { engine, texture } => {
                Reply::Status(self.detach(*engine, *texture, false))
            }
            Call::BitmapDetach { engine, bitmap } => {
                Reply::Status(self.detach(*engine, *bitmap, true))
            }
            Call::TextureDelete { engine, texture } => {
                self.picture_delete(*engine, *texture, false);
                Reply::Nothing
            }
            Call::BitmapDelete { engine, bitmap } => {
                self.picture_delete(*engine, *bitmap, true);
                Reply::Nothing
            }
            Call::TextureBindColorTable { engine, texture, table } => {
                Reply::Status(self.bind_table(*engine, *texture, *table, false))
            }
            Call::BitmapBindColorTable { engine, bitmap, table } => {
                Reply::Status(self.bind_table(*engine, *bitmap, *table, true))
            }
            Call::TextureUpdate { engine, texture, flags, pixel_type, images } => {
                Reply::Status(self.texture_update(*engine, *texture, *flags, *pixel_type, images))
            }
            Call::BitmapUpdate { engine, bitmap, image } => {
                Reply::Status(self.bitmap_update(*engine, *bitmap, image))
            }
            Call::AccessTexture { engine, texture, level, .. } => {
                Reply::Status(self.access_picture(*engine, *texture, *level, false))
            }
            Call::AccessBitmap { engine, bitmap, .. } => {
                Reply::Status(self.access_picture(*engine, *bitmap, 0, true))
            }
            Call::AccessTextureEnd { engine, texture, rect, pixels } => {
                Reply::Status(self.access_picture_end(*engine, *texture, rect, pixels, false))
            }
            Call::AccessBitmapEnd { engine, bitmap, rect, pixels } => {
                Reply::Status(self.access_picture_end(*engine, *bitmap, rect, pixels, true))
            }
            Call::ColorTableNew { engine, table_type, entries, transparent_index } => {
                let made = self.check_engine(*engine).and_then(|()| {
                    let table = ColorTable::new(*table_type, entries, *transparent_index)?;
                    self.check_room(self.objects.tables.len())?;
                    let number = self.objects.number();
                    self.objects.tables.insert(number, table);
                    Ok(number)
                });
                Reply::Created(made)
            }
            Call::ColorTableDelete { table, .. } => {
                // What it is bound to keeps the entries.
                self.objects.tables.remove(table);
                Reply::Nothing
            }
            _ => Reply::Nothing,
        }
    }
}

/// Reading, and calls without the detour over a value.
impl Context {
    /// Registers an engine of the application (`QARegisterEngine`).
    ///
    /// # Errors
    /// [`RaveError::OutOfDate`] where a newer one of its identity is there, and
    /// the engine's own where it does not say who it is.
    pub fn register_engine(&mut self, engine: Box<dyn Engine>) -> Result<EngineId, RaveError> {
        self.manager.register(engine)
    }

    /// Puts an engine before all others, as the user's choice does.
    pub fn prefer_engine(&mut self, vendor: i32, engine: i32) {
        self.manager.prefer(vendor, engine);
    }

    /// The engines that draw on a device, or all of them, the best first
    /// (`QADeviceGetFirstEngine`, `QADeviceGetNextEngine`).
    pub fn engines(&mut self, device: Option<&DeviceValue>) -> Vec<EngineId> {
        self.manager.engines(device)
    }

    /// `QAEngineCheckDevice`.
    ///
    /// # Errors
    /// Why the engine cannot draw there.
    pub fn check_device(&mut self, id: EngineId, device: &DeviceValue) -> Result<(), RaveError> {
        self.manager.check_device(id, Some(device))
    }

    /// `QAEngineGestalt`. Free memory is told once deferred deletions are done.
    ///
    /// # Errors
    /// [`RaveError::GestaltUnknown`], [`RaveError::Parameter`].
    pub fn gestalt(&mut self, id: EngineId, selector: u32) -> Result<Answer, RaveError> {
        let number = |bytes: u64| Ok(Answer::Number(u32::try_from(bytes).unwrap_or(u32::MAX)));
        match selector {
            selector::TEXTURE_MEMORY if id == EngineId::BUILT_IN => {
                self.objects.settle();
                number(self.objects.memory.free_ordinary_bytes())
            }
            selector::FAST_TEXTURE_MEMORY if id == EngineId::BUILT_IN => {
                self.objects.settle();
                number(self.objects.memory.free_bytes())
            }
            selector::TEXTURE_LOADS if id == EngineId::BUILT_IN => {
                self.objects.settle();
                number(self.objects.memory.statistics().loads)
            }
            selector::TEXTURE_EVICTIONS if id == EngineId::BUILT_IN => {
                self.objects.settle();
                number(self.objects.memory.statistics().evictions)
            }
            _ => self.manager.gestalt(id, selector),
        }
    }

    /// `QAGetFloat`; 0 for what is not known.
    pub fn get_float(&self, context: DrawContextId, tag: u32) -> f32 {
        self.contexts.get(&context.0).map_or(0.0, |context| context.state.get_float(tag))
    }

    /// `QAGetInt`; 0 for what is not known.
    pub fn get_int(&self, context: DrawContextId, tag: u32) -> u32 {
        self.contexts.get(&context.0).map_or(0, |context| context.state.get_int(tag))
    }

    /// `QAGetPtr` of a texture.
    pub fn get_texture(&self, context: DrawContextId, tag: u32) -> Option<TextureId> {
        self.contexts.get(&context.0)?.state.get_texture(tag)
    }

    /// Columns and rows of a context's drawing coordinates.
    pub fn size(&self, context: DrawContextId) -> Option<(u32, u32)> {
        Some(self.contexts.get(&context.0)?.size)
    }

    /// The pixel type of a context.
    pub fn pixel_type(&self, context: DrawContextId) -> Option<PixelType> {
        Some(self.contexts.get(&context.0)?.pixel_type)
    }

    /// Whether a notice has a method.
    pub fn has_notice(&self, context: DrawContextId, selector: u32) -> bool {
        let context = self.contexts.get(&context.0);
        context.is_some_and(|context| context.notices.get(selector as usize) == Some(&true))
    }

    /// The frame that was shown last, by whichever context; complete.
    pub fn shown(&mut self) -> Option<Shown> {
        self.shown_by(DrawContextId(self.shown?))
    }

    /// What a context shows: what its device holds, once all is drawn.
    pub fn shown_by(&mut self, context: DrawContextId) -> Option<Shown> {
        self.look(context, true)
    }

    /// What a context shows of what is drawn already; it does not wait.
    pub fn shown_so_far(&mut self, context: DrawContextId) -> Option<Shown> {
        self.look(context, false)
    }

    fn look(&mut self, context: DrawContextId, waits: bool) -> Option<Shown> {
        let (context, painter) = self.context_and_painter(context.0)?;
        let front = painter.front(context.id.0, waits)?;
        Some(Shown::new(front.width, front.height, context.pixel_type, &front.elements))
    }

    /// Waits until everything is drawn.
    pub fn finish(&mut self) {
        self.sync_quietly();
    }

    /// The part of a context's picture that changed since this was asked last,
    /// among what is drawn already; `None` where nothing did.
    pub fn take_changed(&mut self, context: DrawContextId) -> Option<RaveRect> {
        self.painter.as_mut()?.front(context.0, false)?.fresh.take()
    }

    /// The contexts of frames that were completed since this was asked last, once
    /// for each frame. It does not wait.
    pub fn take_completed(&mut self) -> Vec<DrawContextId> {
        let mut completed = Vec::new();
        let Some(painter) = &mut self.painter else { return completed };
        let done = painter.drawn();
        for context in self.contexts.values_mut() {
            let id = context.id;
            let before = context.pending.len();
            context.pending.retain(|&count| count > done);
            completed.extend(std::iter::repeat_n(id, before - context.pending.len()));
        }
        completed
    }

    /// Counters of everything drawn so far. Waits for all drawing.
    pub fn counters(&mut self) -> Counters {
        self.painter.as_mut().map(Painter::counters).unwrap_or_default()
    }

    /// [`Call::DrawVGouraud`], without copying the vertices.
    pub fn draw_v_gouraud(&mut self, context: DrawContextId, mode: u32, v: &[VGouraud]) {
        if let Some(mut pen) = self.pen(context.0) {
            pen.v_gouraud(mode, v);
        }
    }

    /// [`Call::DrawVTexture`], without copying the vertices.
    pub fn draw_v_texture(&mut self, context: DrawContextId, mode: u32, v: &[VTexture]) {
        if let Some(mut pen) = self.pen(context.0) {
            pen.v_texture(mode, v);
        }
    }

    /// [`Call::SubmitVerticesGouraud`].
    pub fn submit_vertices_gouraud(&mut self, context: DrawContextId, v: &[VGouraud]) {
        if let Some(context) = self.contexts.get_mut(&context.0) {
            match v.len() <= MAX_VERTICES {
                true => context.vertices_gouraud = v.into(),
                false => context.fail(RaveError::OutOfMemory),
            }
        }
    }

    /// [`Call::SubmitVerticesTexture`].
    pub fn submit_vertices_texture(&mut self, context: DrawContextId, v: &[VTexture]) {
        if let Some(context) = self.contexts.get_mut(&context.0) {
            match v.len() <= MAX_VERTICES {
                true => context.vertices_texture = v.into(),
                false => context.fail(RaveError::OutOfMemory),
            }
        }
    }

    /// [`Call::SubmitMultiTextureParams`].
    pub fn submit_params(&mut self, context: DrawContextId, layer: u32, v: &[VMultiTexture]) {
        let Some(context) = self.contexts.get_mut(&context.0) else { return };
        match context.params.get_mut(layer as usize) {
            Some(params) if v.len() <= MAX_VERTICES => {
                params.clear();
                params.extend_from_slice(v);
            }
            _ => context.fail(RaveError::Parameter),
        }
    }

    /// The level that the program has access to: columns, rows and pixels in
    /// the picture's pixel type.
    pub fn accessed_texture(&self, texture: TextureId) -> Option<(PixelType, ImageValue)> {
        accessed(self.objects.textures.get(&texture.0)?)
    }

    /// The bitmap that the program has access to.
    pub fn accessed_bitmap(&self, bitmap: BitmapId) -> Option<(PixelType, ImageValue)> {
        accessed(self.objects.bitmaps.get(&bitmap.0)?)
    }
}

fn accessed(picture: &Picture) -> Option<(PixelType, ImageValue)> {
    let level = picture.levels.get(picture.accessed?)?;
    let (width, height) = (level.width as i32, level.height as i32);
    Some((picture.pixel_type, ImageValue { width, height, pixels: level.pixels.clone() }))
}

/// Objects.
impl Context {
    /// The renderer; started when it is needed first.
    fn painter(&mut self) -> Result<&mut Painter, RaveError> {
        match &mut self.painter {
            Some(painter) => Ok(painter),
            none => {
                let made = Painter::new(self.config.device.clone(), self.config.asynchronous);
                Ok(none.insert(made.map_err(|_| RaveError::OutOfMemory)?))
            }
        }
    }

    /// Whether something that was asked for is not drawn yet.
    fn is_busy(&mut self) -> bool {
        self.painter.as_mut().is_some_and(|painter| painter.drawn() < painter.started())
    }

    /// A context and the renderer.
    pub(crate) fn context_and_painter(
        &mut self,
        id: u32,
    ) -> Option<(&mut DrawContext, &mut Painter)> {
        Some((self.contexts.get_mut(&id)?, self.painter.as_mut()?))
    }

    /// What draws into a context.
    #[inline]
    fn pen(&mut self, id: u32) -> Option<Pen<'_>> {
        if self.has_stale {
            self.refresh_pictures();
        }
        let (context, painter) = (self.contexts.get_mut(&id)?, self.painter.as_mut()?);
        Some(Pen { context, painter, objects: &mut self.objects })
    }

    /// Waits for all drawing.
    pub(crate) fn sync_quietly(&mut self) {
        self.objects.settle();
        if let Some(painter) = &mut self.painter {
            painter.sync();
        }
    }

    /// Changes a context's state.
    fn change(&mut self, id: u32, change: impl FnOnce(&mut DrawContext)) -> Reply {
        if let Some(context) = self.contexts.get_mut(&id) {
            change(context);
            context.prepared = None;
        }
        Reply::Nothing
    }

    fn set_texture(&mut self, id: u32, tag: u32, texture: u32) -> Reply {
        let known = texture == 0 || self.objects.textures.contains_key(&texture);
        self.change(id, |context| {
            if !known {
                context.fail(RaveError::Parameter);
            }
            let texture = (texture != 0 && known).then_some(TextureId(texture));
            context.state.set_texture(tag, texture);
        })
    }

    fn set_notice(&mut self, id: u32, which: u32, installed: bool) -> Result<(), RaveError> {
        let context = self.contexts.get_mut(&id).ok_or(RaveError::Parameter)?;
        if which >= notice::NUM_SELECTORS {
            return Err(RaveError::Parameter);
        }
        context.notices[which as usize] = installed;
        Ok(())
    }

    fn check_engine(&self, engine: u32) -> Result<(), RaveError> {
        if EngineId(engine) == EngineId::BUILT_IN { Ok(()) } else { Err(RaveError::Parameter) }
    }

    fn check_room(&self, count: usize) -> Result<(), RaveError> {
        if count < MAX_PICTURES { Ok(()) } else { Err(RaveError::OutOfMemory) }
    }

    fn context_new(&mut self, spec: ContextSpec) -> Result<u32, RaveError> {
        const KNOWN: u32 = context::NO_Z_BUFFER
            | context::DEEP_Z
            | context::DOUBLE_BUFFER
            | context::CACHE
            | context::NO_DITHER
            | context::SCALE
            | context::NON_RELOCATABLE;
        self.check_engine(spec.engine)?;
        if spec.flags & !KNOWN != 0 {
            return Err(RaveError::NotSupported);
        }
        let number = self.objects.numbers + 1;
        let made = DrawContext::new(DrawContextId(number), spec)?;
        let pixels = |context: &DrawContext| u64::from(context.size.0) * u64::from(context.size.1);
        let used: u64 = self.contexts.values().map(pixels).sum();
        if self.contexts.len() >= MAX_CONTEXTS || used + pixels(&made) > MAX_PIXELS {
            return Err(RaveError::OutOfVideoMemory);
        }
        let created = self.painter()?.create(number, &made.target_spec(), made.new_front());
        created.map_err(|_| RaveError::OutOfVideoMemory)?;
        self.objects.numbers = number;
        self.contexts.insert(number, made);
        Ok(number)
    }

    fn context_delete(&mut self, id: u32) {
        if self.has_stale {
            self.refresh_pictures();
        }
        let Some(context) = self.contexts.remove(&id) else { return };
        if context.in_frame {
            self.objects.settle();
            self.objects.memory.end_frame();
        }
        if let Some(painter) = &mut self.painter {
            painter.destroy(id);
        }
        if self.shown == Some(id) {
            self.shown = None;
        }
    }

    /// Adds a picture to the objects and to the books.
    pub(crate) fn add_picture(
        &mut self,
        mut picture: Picture,
        is_bitmap: bool,
    ) -> Result<u32, RaveError> {
        self.check_room(self.objects.textures.len() + self.objects.bitmaps.len())?;
        self.objects.settle();
        let lock = if is_bitmap { crate::constants::bitmap::LOCK } else { texture::LOCK };
        let locked = picture.flags & lock != 0;
        picture.resource =
            Some(self.objects.memory.create(Arc::new(()), picture.bytes(), locked)?);
        let number = self.objects.number();
        self.pictures(is_bitmap).insert(number, picture);
        Ok(number)
    }

    fn pictures(&mut self, is_bitmap: bool) -> &mut BTreeMap<u32, Picture> {
        if is_bitmap { &mut self.objects.bitmaps } else { &mut self.objects.textures }
    }

    fn picture(
        &mut self,
        engine: u32,
        number: u32,
        is_bitmap: bool,
    ) -> Result<&mut Picture, RaveError> {
        self.check_engine(engine)?;
        self.pictures(is_bitmap).get_mut(&number).ok_or(RaveError::Parameter)
    }

    fn texture_new(
        &mut self,
        engine: u32,
        flags: u32,
        pixel_type: u32,
        images: &[ImageValue],
    ) -> Result<u32, RaveError> {
        self.check_engine(engine)?;
        let pixel_type = PixelType::from_number(pixel_type).ok_or(RaveError::NotSupported)?;
        self.add_picture(Picture::texture(flags, pixel_type, images)?, false)
    }

    fn bitmap_new(
        &mut self,
        engine: u32,
        flags: u32,
        pixel_type: u32,
        image: &ImageValue,
    ) -> Result<u32, RaveError> {
        self.check_engine(engine)?;
        let pixel_type = PixelType::from_number(pixel_type).ok_or(RaveError::NotSupported)?;
        self.add_picture(Picture::bitmap(flags, pixel_type, image)?, true)
    }

    fn detach(&mut self, engine: u32, number: u32, is_bitmap: bool) -> Result<(), RaveError> {
        let resource = self.picture(engine, number, is_bitmap)?.resource;
        self.objects.settle();
        resource.map_or(Ok(()), |id| Ok(self.objects.memory.detach(id)?))
    }

    fn picture_delete(&mut self, engine: u32, number: u32, is_bitmap: bool) {
        if self.check_engine(engine).is_err() {
            return;
        }
        let Some(picture) = self.pictures(is_bitmap).remove(&number) else { return };
        self.objects.settle();
        if let Some(resource) = picture.resource {
            // The program owned it: the picture was among the objects.
            let _ = self.objects.memory.delete(resource);
        }
        self.forget_prepared();
    }

    /// Has all contexts look at their textures again.
    fn forget_prepared(&mut self) {
        for context in self.contexts.values_mut() {
            context.prepared = None;
        }
    }

    fn bind_table(
        &mut self,
        engine: u32,
        number: u32,
        table: u32,
        is_bitmap: bool,
    ) -> Result<(), RaveError> {
        let table = self.objects.tables.get(&table).cloned().ok_or(RaveError::Parameter)?;
        self.picture(engine, number, is_bitmap)?.bind(&table)?;
        self.forget_prepared();
        Ok(())
    }

    fn texture_update(
        &mut self,
        engine: u32,
        number: u32,
        flags: u32,
        pixel_type: u32,
        images: &[ImageValue],
    ) -> Result<(), RaveError> {
        let pixel_type = PixelType::from_number(pixel_type).ok_or(RaveError::NotSupported)?;
        let picture = self.picture(engine, number, false)?;
        let before = picture.bytes();
        picture.replace(flags, pixel_type, images)?;
        self.replaced(number, before, false)
    }

    fn bitmap_update(
        &mut self,
        engine: u32,
        number: u32,
        image: &ImageValue,
    ) -> Result<(), RaveError> {
        let picture = self.picture(engine, number, true)?;
        let (before, flags, pixel_type) = (picture.bytes(), picture.flags, picture.pixel_type);
        picture.replace(flags, pixel_type, std::slice::from_ref(image))?;
        self.replaced(number, before, true)
    }

    /// Enters new images into the books, in place of some of `before` bytes.
    fn replaced(&mut self, number: u32, before: u64, is_bitmap: bool) -> Result<(), RaveError> {
        self.forget_prepared();
        self.objects.settle();
        let Some(picture) = self.pictures(is_bitmap).get(&number) else { return Ok(()) };
        let (Some(old), bytes) = (picture.resource, picture.bytes()) else { return Ok(()) };
        let memory = &self.objects.memory;
        if bytes == before {
            return Ok(memory.replace(old, Arc::new(()))?);
        }
        memory.delete(old)?;
        let new = memory.create(Arc::new(()), bytes, false);
        if let Some(picture) = self.pictures(is_bitmap).get_mut(&number) {
            picture.resource = new.ok();
        }
        new.map(|_| ()).map_err(RaveError::from)
    }

    fn access_picture(
        &mut self,
        engine: u32,
        number: u32,
        level: i32,
        is_bitmap: bool,
    ) -> Result<(), RaveError> {
        if self.has_stale {
            self.refresh_pictures();
        }
        self.picture(engine, number, is_bitmap)?.access(level)?;
        self.forget_prepared();
        Ok(())
    }

    fn access_picture_end(
        &mut self,
        engine: u32,
        number: u32,
        rect: &RaveRect,
        pixels: &[u8],
        is_bitmap: bool,
    ) -> Result<(), RaveError> {
        let corner = |v: i32| u32::try_from(v).unwrap_or(u32::MAX);
        let rect = [corner(rect.left), corner(rect.top), rect.width(), rect.height()];
        let result = self.picture(engine, number, is_bitmap)?.access_end(rect, pixels);
        self.forget_prepared();
        result
    }
}
