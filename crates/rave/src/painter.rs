//! The renderer: the pixel engine with the surfaces of all contexts.
//!
//! The engine draws behind the caller. A frame that is shown is looked at late:
//! its surface stays as it is, and the next frame is drawn on another where that
//! one begins with a clear.

use std::collections::BTreeMap;
use std::sync::Arc;

use fillrate_engine::state::{Dither, MAX_TMUS, Rect};
use fillrate_engine::target::{pack, unpack};
use fillrate_engine::{
    ClearValues, Counters, Cull, Device, DeviceConfig, DrawState, EngineError, FlushReason,
    PixelFormat, Surface, SurfaceId, Texture, Vertex, VertexExtra,
};

use crate::front::Front;
use crate::present::{Present, carry_out, sample};
use crate::translate::{Plane, Variant};

/// The greatest z in 16 bits.
pub(crate) const Z16_MAX: f32 = 65_535.0;
/// The greatest z in 24 bits.
pub(crate) const DEEP_MAX: f32 = 16_777_215.0;

/// A corner with all that it may carry.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Corner {
    pub vertex: Vertex,
    pub extra: VertexExtra,
}

/// What a clear writes; absent planes stay.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ClearPlanes {
    /// Pixels of the context.
    pub rect: Rect,
    /// 0xAARRGGBB.
    pub color: Option<(u32, Dither)>,
    /// z, 0..=1, and with it the plane of 1/w.
    pub depth: Option<f32>,
}

/// What the surfaces of a new context are.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TargetSpec {
    pub width: u32,
    pub height: u32,
    pub format: PixelFormat,
    /// The kind of z plane.
    pub plane: Plane,
    /// Surface pixels of a context's pixel.
    pub scale: u32,
}

/// The surfaces of a context.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Planes {
    pub format: PixelFormat,
    /// Columns and rows of the context.
    pub size: (u32, u32),
    /// What is drawn into.
    color: SurfaceId,
    /// The frame before, once one was left as it is.
    spare: Option<SurfaceId>,
    /// z, in 16 or 32 bits.
    z: Option<SurfaceId>,
    is_deep: bool,
    /// 1/w, once the context used it.
    w: Option<SurfaceId>,
    /// Surface pixels of a context's pixel.
    pub scale: u32,
}

impl Planes {
    /// A rectangle of the context in its surfaces.
    fn scaled(&self, rect: Rect) -> Rect {
        let n = self.scale;
        Rect::new(rect.x0 * n, rect.y0 * n, rect.x1 * n, rect.y1 * n)
    }

    /// Whether a rectangle is the whole context.
    fn are_covered(&self, rect: Rect) -> bool {
        rect == Rect::new(0, 0, self.size.0, self.size.1)
    }
}

/// A frame that is shown and not in the front yet.
#[derive(Clone, Copy, Debug)]
struct Waiting {
    present: Present,
    surface: SurfaceId,
    /// The engine's batch after which the surface holds it.
    batch: u64,
}

/// A context's surfaces and what it shows.
#[derive(Debug)]
struct Target {
    planes: Planes,
    front: Front,
    /// At most two, the later of which replaces all of the other. The earlier
    /// one's surface is the one that is drawn into: it is as it was until a
    /// batch starts after the later one's, which is then complete.
    waiting: Vec<Waiting>,
}

impl Target {
    /// Whether what is shown is what would be drawn over.
    fn shows_color(&self) -> bool {
        self.waiting.last().is_some_and(|last| last.surface == self.planes.color)
    }
}

/// The pixel engine and its surfaces, by context.
#[derive(Debug)]
pub(crate) struct Painter {
    device: Device,
    /// Nothing is drawn behind the caller.
    waits: bool,
    targets: BTreeMap<u32, Target>,
    /// The context and plane that are drawn into, once something is.
    current: Option<(u32, Plane)>,
    /// Whose draw state is set, and for which primitives.
    chosen: Option<(u64, Variant)>,
    /// Numbers given by [`Painter::serial`].
    serials: u64,
}

impl Painter {
    /// A renderer without contexts, which draws behind the caller where it is
    /// asynchronous; then there is a thread besides the caller's.
    ///
    /// # Errors
    /// [`EngineError::Threads`].
    pub fn new(config: DeviceConfig, asynchronous: bool) -> Result<Painter, EngineError> {
        let threads = if asynchronous { config.threads.max(2) } else { config.threads };
        Ok(Painter {
            device: Device::new(DeviceConfig { threads, ..config })?,
            waits: !asynchronous,
            targets: BTreeMap::new(),
            current: None,
            chosen: None,
            serials: 0,
        })
    }

    /// Makes the surfaces of a context that shows what `front` holds.
    ///
    /// # Errors
    /// [`EngineError::SurfaceSize`].
    pub fn create(
        &mut self,
        context: u32,
        spec: &TargetSpec,
        front: Front,
    ) -> Result<(), EngineError> {
        let planes = self.create_planes(spec)?;
        self.targets.insert(context, Target { planes, front, waiting: Vec::new() });
        Ok(())
    }

    fn create_planes(&mut self, spec: &TargetSpec) -> Result<Planes, EngineError> {
        let (width, height) = (spec.width * spec.scale, spec.height * spec.scale);
        let color = self.device.create_surface(width, height, spec.format)?;
        let z_format = match spec.plane {
            Plane::None => None,
            Plane::Deep => Some(PixelFormat::Aux32),
            _ => Some(PixelFormat::Aux16),
        };
        let z = z_format.map(|format| self.device.create_surface(width, height, format));
        Ok(Planes {
            format: spec.format,
            size: (spec.width, spec.height),
            color,
            spare: None,
            z: z.transpose()?,
            is_deep: spec.plane == Plane::Deep,
            w: None,
            scale: spec.scale,
        })
    }

    /// Gives a context more or fewer samples for each pixel; what it shows stays.
    ///
    /// # Errors
    /// [`EngineError::SurfaceSize`]; then nothing has changed.
    pub fn rescale(&mut self, context: u32, scale: u32) -> Result<(), EngineError> {
        self.settle(context, true);
        let Some(old) = self.planes(context) else { return Ok(()) };
        let all = Rect::new(0, 0, old.size.0, old.size.1);
        let colors = self.read_color(context, all);
        let kind = if old.is_deep { Plane::Deep } else { Plane::Z16 };
        let plane = if old.z.is_some() { kind } else { Plane::None };
        let depths = self.read_depth(context, plane, all);
        let inverses = old.w.map(|_| self.read_depth(context, Plane::InverseW, all));
        let (width, height) = old.size;
        let spec = TargetSpec { width, height, format: old.format, plane, scale };
        let new = self.create_planes(&spec)?;
        if let Some(target) = self.targets.get_mut(&context) {
            target.planes = new;
        }
        self.free(&old);
        self.write_color(context, all, &colors);
        self.write_depth(context, plane, all, &depths);
        if let Some(inverses) = inverses {
            self.write_depth(context, Plane::InverseW, all, &inverses);
        }
        Ok(())
    }

    /// Frees the surfaces of a context.
    pub fn destroy(&mut self, context: u32) {
        if let Some(target) = self.targets.remove(&context) {
            self.free(&target.planes);
        }
    }

    fn free(&mut self, planes: &Planes) {
        self.forget_target();
        for id in [Some(planes.color), planes.spare, planes.z, planes.w].into_iter().flatten() {
            // They exist: they were made with the target.
            let _ = self.device.destroy_surface(id);
        }
    }

    /// Starts to draw what was collected.
    pub fn submit(&mut self) {
        if self.waits {
            self.sync();
        } else {
            self.device.submit(FlushReason::Swap);
        }
    }

    /// Draws everything, and waits for it.
    pub fn sync(&mut self) {
        self.device.flush(FlushReason::Explicit);
    }

    /// How much was started, to be compared with [`Painter::drawn`].
    pub fn started(&self) -> u64 {
        self.device.started()
    }

    /// How much of it is drawn. It does not wait.
    pub fn drawn(&mut self) -> u64 {
        self.device.drawn()
    }

    /// Counters since the start. Waits for all drawing.
    pub fn counters(&mut self) -> Counters {
        self.device.counters()
    }

    fn planes(&self, context: u32) -> Option<Planes> {
        self.targets.get(&context).map(|target| target.planes)
    }
}

/// Drawing.
impl Painter {
    /// A number that was not given before.
    pub fn serial(&mut self) -> u64 {
        self.serials += 1;
        self.serials
    }

    /// Whether triangles are drawn by the draw state that was set with this
    /// serial and variant.
    #[inline]
    pub fn draws_by(&self, serial: u64, variant: &Variant) -> bool {
        self.chosen.as_ref().is_some_and(|(last, known)| *last == serial && known == variant)
    }

    /// Draws into a context by a state from here on.
    pub fn choose(
        &mut self,
        (context, plane): (u32, Plane),
        by: (u64, Variant),
        state: &DrawState,
        textures: [Option<Arc<Texture>>; MAX_TMUS],
    ) {
        if self.current != Some((context, plane)) {
            self.set_target(context, plane);
        }
        self.device.set_state(state, textures);
        self.chosen = Some(by);
    }

    /// Draws a triangle by the chosen state.
    #[inline(always)]
    pub fn triangle(&mut self, corner: impl Fn(usize) -> Vertex) {
        self.device.draw_triangle_made(Cull::Disabled, corner);
    }

    /// Draws a triangle with all values by the chosen state.
    pub fn extended(&mut self, corners: &[Corner; 3]) {
        let vertices = corners.each_ref().map(|corner| &corner.vertex);
        let extras = corners.each_ref().map(|corner| &corner.extra);
        self.device.draw_extended(vertices, extras, Cull::Disabled);
    }

    fn set_target(&mut self, context: u32, plane: Plane) {
        self.keep_color(context);
        let aux = match plane {
            Plane::InverseW => self.plane_of_w(context),
            _ => self.planes(context).and_then(|planes| planes.z),
        };
        let Some(planes) = self.planes(context) else { return };
        // Surfaces of one context agree in size.
        let _ = self.device.set_target(planes.color, aux);
        self.device.set_scale(planes.scale);
        self.current = Some((context, plane));
    }

    /// Says target and state again before the next primitive.
    fn forget_target(&mut self) {
        (self.current, self.chosen) = (None, None);
    }

    /// The plane of 1/w of a context; made where there is none, all far.
    fn plane_of_w(&mut self, context: u32) -> Option<SurfaceId> {
        let planes = &mut self.targets.get_mut(&context)?.planes;
        if planes.w.is_none() {
            let (width, height) = planes.size;
            let (width, height) = (width * planes.scale, height * planes.scale);
            planes.w = self.device.create_surface(width, height, PixelFormat::Aux32).ok();
        }
        planes.w
    }

    /// Fills a rectangle of a context.
    pub fn clear(&mut self, context: u32, clear: &ClearPlanes) {
        if clear.rect.is_empty() {
            return;
        }
        if clear.color.is_some() {
            self.prepare_color(context, clear.rect);
        }
        let Some(planes) = self.planes(context) else { return };
        self.forget_target();
        let rect = planes.scaled(clear.rect);
        if clear.depth.is_some() {
            self.clear_w(&planes, rect);
        }
        let aux = clear.depth.filter(|_| planes.z.is_some());
        let aux = aux.map(|z| z_element(z, planes.is_deep));
        let _ = self.device.set_target(planes.color, planes.z);
        self.device.clear(rect, ClearValues { color: clear.color, aux });
    }

    /// Sets 1/w to infinitely far, where there is such a plane.
    fn clear_w(&mut self, planes: &Planes, rect: Rect) {
        if planes.w.is_some() {
            let _ = self.device.set_target(planes.color, planes.w);
            self.device.clear(rect, ClearValues { color: None, aux: Some(0) });
        }
    }

    /// Copies planes of another context of the same size.
    pub fn copy(&mut self, context: u32, from: u32, rect: Rect, [color, depth]: [bool; 2]) {
        if rect.is_empty() {
            return;
        }
        if color {
            self.prepare_color(context, rect);
        }
        let Some(source) = self.planes(from) else { return };
        if depth && source.w.is_some() {
            self.plane_of_w(context);
        }
        let Some(to) = self.planes(context) else { return };
        self.forget_target();
        // Surfaces are written at once: what is drawn is seen first.
        self.sync();
        let scales = (source.scale, to.scale);
        if color {
            let formats = (source.format, to.format);
            self.copy_surface((source.color, to.color), scales, rect, Some(formats));
        }
        if depth {
            if let (Some(a), Some(b)) = (source.z, to.z)
                && source.is_deep == to.is_deep
            {
                self.copy_surface((a, b), scales, rect, None);
            }
            match (source.w, to.w) {
                (Some(a), Some(b)) => self.copy_surface((a, b), scales, rect, None),
                _ => self.clear_w(&to, to.scaled(rect)),
            }
        }
    }

    /// Copies elements; colours are repacked where formats differ, and pixels
    /// of another size are taken from the first of the source.
    fn copy_surface(
        &mut self,
        (from, to): (SurfaceId, SurfaceId),
        (from_scale, to_scale): (u32, u32),
        rect: Rect,
        formats: Option<(PixelFormat, PixelFormat)>,
    ) {
        let Ok(source) = self.device.surface(from).map(|surface| surface.clone()) else { return };
        let Ok(surface) = self.device.surface(to) else { return };
        let same_format = formats.is_none_or(|(a, b)| a == b);
        if same_format && from_scale == to_scale && covers(rect, surface, to_scale) {
            *surface = source;
            return;
        }
        for y in rect.y0 * to_scale..(rect.y1 * to_scale).min(surface.height()) {
            for x in rect.x0 * to_scale..(rect.x1 * to_scale).min(surface.width()) {
                let at = (x * from_scale / to_scale, y * from_scale / to_scale);
                if at.0 >= source.width() || at.1 >= source.height() {
                    continue;
                }
                let element = source.get(at.0, at.1);
                let element = match formats {
                    Some((a, b)) if a != b => pack(b, unpack(a, element), Dither::Off, 0, 0),
                    _ => element,
                };
                surface.set(x, y, element);
            }
        }
    }
}

/// Reading and writing pixels. All that was drawn is seen.
impl Painter {
    /// The colours of a rectangle inside a context, as elements.
    pub fn read_color(&mut self, context: u32, rect: Rect) -> Vec<u32> {
        let Some(target) = self.planes(context) else { return Vec::new() };
        let Ok(surface) = self.device.surface(target.color) else { return Vec::new() };
        let mut out = Vec::with_capacity(rect.area() as usize);
        let mut row = vec![0; rect.x1 as usize];
        for y in rect.y0..rect.y1 {
            if target.scale == 1 {
                surface.read_row(y, &mut row);
                out.extend_from_slice(&row[rect.x0 as usize..]);
            } else {
                out.extend((rect.x0..rect.x1).map(|x| sample(surface, &target, x, y)));
            }
        }
        out
    }

    /// Writes elements into a rectangle inside a context.
    pub fn write_color(&mut self, context: u32, rect: Rect, elements: &[u32]) {
        self.keep_color(context);
        let Some(target) = self.planes(context) else { return };
        self.write(target.color, target.scale, rect, elements);
    }

    /// The depths of a rectangle inside a context, as elements.
    pub fn read_depth(&mut self, context: u32, plane: Plane, rect: Rect) -> Vec<u32> {
        let Some((id, scale)) = self.depth_surface(context, plane) else { return Vec::new() };
        let Ok(surface) = self.device.surface(id) else { return Vec::new() };
        let mut out = Vec::with_capacity(rect.area() as usize);
        for y in rect.y0..rect.y1 {
            out.extend((rect.x0..rect.x1).map(|x| surface.get(x * scale, y * scale)));
        }
        out
    }

    /// Writes depths into a rectangle inside a context.
    pub fn write_depth(&mut self, context: u32, plane: Plane, rect: Rect, elements: &[u32]) {
        if let Some((id, scale)) = self.depth_surface(context, plane) {
            self.write(id, scale, rect, elements);
        }
    }

    fn depth_surface(&mut self, context: u32, plane: Plane) -> Option<(SurfaceId, u32)> {
        let target = self.planes(context)?;
        let id = match plane {
            Plane::None => None,
            Plane::Z16 | Plane::Deep => target.z,
            Plane::InverseW => self.plane_of_w(context),
        };
        Some((id?, target.scale))
    }

    fn write(&mut self, id: SurfaceId, scale: u32, rect: Rect, elements: &[u32]) {
        let Ok(surface) = self.device.surface(id) else { return };
        let width = (rect.x1 - rect.x0).max(1) as usize;
        for (y, row) in (rect.y0..rect.y1).zip(elements.chunks_exact(width)) {
            for (x, &element) in (rect.x0..rect.x1).zip(row) {
                for sub in 0..scale * scale {
                    surface.set(x * scale + sub % scale, y * scale + sub / scale, element);
                }
            }
        }
    }
}

/// Showing.
impl Painter {
    /// Shows a rectangle of a context.
    pub fn present(&mut self, context: u32, present: Present) {
        self.submit();
        self.forget_target();
        let Some(target) = self.targets.get_mut(&context) else { return };
        let color = target.planes.color;
        // What is shown twice was drawn when it was shown first.
        let again = target.waiting.last().filter(|last| last.surface == color);
        let batch = again.map_or(self.device.started(), |last| last.batch);
        let (is_again, replaced) = (again.is_some(), target.waiting.last());
        if replaced.is_some_and(|last| !present.replaces(&last.present)) {
            self.settle(context, is_again);
        } else if is_again {
            target.waiting.pop();
        }
        let Some(target) = self.targets.get_mut(&context) else { return };
        // What was on this surface before has been drawn over.
        target.waiting.retain(|waiting| waiting.surface != color);
        target.waiting.push(Waiting { present, surface: color, batch });
    }

    /// What a context shows: of all that was drawn, or of what is drawn already.
    pub fn front(&mut self, context: u32, waits: bool) -> Option<&mut Front> {
        self.settle(context, waits);
        Some(&mut self.targets.get_mut(&context)?.front)
    }

    /// Brings what is shown into the front: all of it, or what is drawn already.
    fn settle(&mut self, context: u32, waits: bool) {
        if self.targets.get(&context).is_none_or(|target| target.waiting.is_empty()) {
            return;
        }
        if waits {
            self.sync();
        }
        let drawn = self.device.drawn();
        let Some(Target { planes, front, waiting }) = self.targets.get_mut(&context) else {
            return;
        };
        let Some(last) = waiting.iter().rposition(|waiting| waiting.batch <= drawn) else { return };
        // It replaces all before.
        let Waiting { present, surface, .. } = waiting[last];
        waiting.drain(..=last);
        // What is collected for the surface may be the next frame.
        if let Ok(surface) = self.device.drawn_surface(surface) {
            carry_out(&present, surface, planes, front);
        }
    }

    /// Called before colours of a rectangle are replaced.
    fn prepare_color(&mut self, context: u32, rect: Rect) {
        if self.planes(context).is_some_and(|planes| planes.are_covered(rect)) {
            self.renew_color(context);
        } else {
            self.keep_color(context);
        }
    }

    /// Called before all colours are replaced: what is shown is left as it is,
    /// and drawing goes to the other surface.
    fn renew_color(&mut self, context: u32) {
        let Some(target) = self.targets.get_mut(&context).filter(|t| t.shows_color()) else {
            return;
        };
        let planes = &mut target.planes;
        let (width, height) = (planes.size.0 * planes.scale, planes.size.1 * planes.scale);
        let made = || self.device.create_surface(width, height, planes.format).ok();
        match planes.spare.or_else(made) {
            Some(spare) => planes.spare = Some(std::mem::replace(&mut planes.color, spare)),
            None => self.settle(context, true),
        }
    }

    /// Called before some colours are changed: what is shown is copied first.
    fn keep_color(&mut self, context: u32) {
        if self.targets.get(&context).is_some_and(Target::shows_color) {
            self.settle(context, true);
        }
    }
}

/// Whether a rectangle of a context is a whole surface.
fn covers(rect: Rect, surface: &Surface, scale: u32) -> bool {
    rect.x0 == 0
        && rect.y0 == 0
        && rect.x1 * scale >= surface.width()
        && rect.y1 * scale >= surface.height()
}

/// z as the plane holds it.
pub(crate) fn z_element(z: f32, is_deep: bool) -> u32 {
    (z.clamp(0.0, 1.0) * if is_deep { DEEP_MAX } else { Z16_MAX }) as u32
}
