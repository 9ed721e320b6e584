//! The renderer: the pixel engine with the surfaces of all contexts.

use std::collections::BTreeMap;
use std::sync::PoisonError;

use fillrate_engine::state::{Dither, Rect};
use fillrate_engine::target::{pack, unpack};
use fillrate_engine::{
    ClearValues, Counters, Cull, Device, DeviceConfig, EngineError, FlushReason, PixelFormat,
    Surface, SurfaceId,
};

use crate::batch::{Batch, ClearPlanes, Command, Present};
use crate::front::Front;
use crate::translate::Plane;
use crate::vertex::RaveRect;

/// The greatest z in 16 bits.
pub(crate) const Z16_MAX: f32 = 65_535.0;
/// The greatest z in 24 bits.
pub(crate) const DEEP_MAX: f32 = 16_777_215.0;

/// The surfaces of a context.
#[derive(Clone, Copy, Debug)]
struct Target {
    format: PixelFormat,
    /// Columns and rows of the context.
    size: (u32, u32),
    color: SurfaceId,
    /// z, in 16 or 32 bits.
    z: Option<SurfaceId>,
    is_deep: bool,
    /// 1/w, once the context used it.
    w: Option<SurfaceId>,
    /// Surface pixels of a context's pixel.
    scale: u32,
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

/// The pixel engine and its surfaces, by context.
#[derive(Debug)]
pub(crate) struct Painter {
    device: Device,
    targets: BTreeMap<u32, Target>,
    current: Option<u32>,
}

impl Painter {
    pub fn new(config: DeviceConfig) -> Result<Painter, EngineError> {
        Ok(Painter { device: Device::new(config)?, targets: BTreeMap::new(), current: None })
    }

    /// Makes the surfaces of a context, in place of those that it has.
    pub fn create(&mut self, context: u32, spec: &TargetSpec) -> Result<(), EngineError> {
        self.destroy(context);
        let (width, height) = (spec.width * spec.scale, spec.height * spec.scale);
        let color = self.device.create_surface(width, height, spec.format)?;
        let z_format = match spec.plane {
            Plane::None => None,
            Plane::Deep => Some(PixelFormat::Aux32),
            _ => Some(PixelFormat::Aux16),
        };
        let z = z_format.map(|format| self.device.create_surface(width, height, format));
        let target = Target {
            format: spec.format,
            size: (spec.width, spec.height),
            color,
            z: z.transpose()?,
            is_deep: spec.plane == Plane::Deep,
            w: None,
            scale: spec.scale,
        };
        self.targets.insert(context, target);
        Ok(())
    }

    /// Gives a context more or fewer samples for each pixel; what it shows stays.
    pub fn rescale(&mut self, context: u32, scale: u32) -> Result<(), EngineError> {
        let Some(old) = self.targets.get(&context).copied() else { return Ok(()) };
        if old.scale == scale {
            return Ok(());
        }
        let all = Rect::new(0, 0, old.size.0, old.size.1);
        let colors = self.read_color(context, all);
        let kind = if old.is_deep { Plane::Deep } else { Plane::Z16 };
        let plane = if old.z.is_some() { kind } else { Plane::None };
        let depths = self.read_depth(context, plane, all);
        let inverses = old.w.map(|_| self.read_depth(context, Plane::InverseW, all));
        let (width, height) = old.size;
        let spec = TargetSpec { width, height, format: old.format, plane, scale };
        self.create(context, &spec)?;
        self.write_color(context, all, &colors);
        self.write_depth(context, plane, all, &depths);
        if let Some(inverses) = inverses {
            self.write_depth(context, Plane::InverseW, all, &inverses);
        }
        Ok(())
    }

    /// Frees the surfaces of a context.
    pub fn destroy(&mut self, context: u32) {
        self.device.flush(FlushReason::Target);
        if self.current == Some(context) {
            self.current = None;
        }
        let Some(target) = self.targets.remove(&context) else { return };
        for id in [Some(target.color), target.z, target.w].into_iter().flatten() {
            // They exist: they were made with the target.
            let _ = self.device.destroy_surface(id);
        }
    }

    /// Carries a batch out.
    pub fn run(&mut self, batch: &Batch) {
        let (mut triangles, mut extended) = (batch.triangles.iter(), batch.extended.iter());
        for command in &batch.commands {
            match command {
                Command::Target { context, plane } => self.set_target(*context, *plane),
                Command::State(index) => {
                    let state = &batch.states[*index as usize];
                    self.device.set_state(&state.draw, state.textures.clone());
                }
                Command::Triangles(count) => {
                    for [a, b, c] in triangles.by_ref().take(*count as usize) {
                        self.device.draw_triangle([a, b, c], Cull::Disabled);
                    }
                }
                Command::Extended(count) => {
                    for corners in extended.by_ref().take(*count as usize) {
                        let vertices = corners.each_ref().map(|corner| &corner.vertex);
                        let extras = corners.each_ref().map(|corner| &corner.extra);
                        self.device.draw_extended(vertices, extras, Cull::Disabled);
                    }
                }
                Command::Clear(clear) => self.clear(clear),
                Command::Copy { from, rect, color, depth } => {
                    self.copy(*from, *rect, *color, *depth);
                }
                Command::Present(present) => self.present(present),
            }
        }
    }

    /// Draws into a context from here on.
    pub fn set_target(&mut self, context: u32, plane: Plane) {
        let Some(target) = self.targets.get(&context).copied() else { return };
        let aux = match plane {
            Plane::None => None,
            Plane::Z16 | Plane::Deep => target.z,
            Plane::InverseW => self.plane_of_w(context),
        };
        // Surfaces of one context agree in size.
        if self.device.set_target(target.color, aux).is_ok() {
            self.device.set_scale(target.scale);
            self.current = Some(context);
        }
    }

    /// The plane of 1/w of a context; made where there is none, all far.
    fn plane_of_w(&mut self, context: u32) -> Option<SurfaceId> {
        let target = self.targets.get_mut(&context)?;
        if target.w.is_none() {
            let (width, height) = target.size;
            let (width, height) = (width * target.scale, height * target.scale);
            target.w = self.device.create_surface(width, height, PixelFormat::Aux32).ok();
        }
        target.w
    }

    /// Fills the current target; what is drawn next needs a target again.
    fn clear(&mut self, clear: &ClearPlanes) {
        let Some(target) = self.current.and_then(|id| self.targets.get(&id)).copied() else {
            return;
        };
        let n = target.scale;
        let rect = clear.rect;
        let rect = Rect::new(rect.x0 * n, rect.y0 * n, rect.x1 * n, rect.y1 * n);
        let aux = clear.depth.map(|z| z_element(z, target.is_deep));
        if clear.depth.is_some() && target.w.is_some() {
            let _ = self.device.set_target(target.color, target.w);
            self.device.clear(rect, ClearValues { color: None, aux: Some(0) });
        }
        let _ = self.device.set_target(target.color, target.z);
        self.device.clear(
            rect,
            ClearValues { color: clear.color, aux: aux.filter(|_| target.z.is_some()) },
        );
    }

    /// Copies planes of another context of the same size into the current one.
    fn copy(&mut self, from: u32, rect: Rect, color: bool, depth: bool) {
        let Some(to) = self.current.and_then(|id| self.targets.get(&id)).copied() else { return };
        let Some(from_target) = self.targets.get(&from).copied() else { return };
        if depth && from_target.w.is_some() {
            self.current.map(|id| self.plane_of_w(id));
        }
        let to = self.current.and_then(|id| self.targets.get(&id)).copied().unwrap_or(to);
        let scales = (from_target.scale, to.scale);
        if color {
            let formats = (from_target.format, to.format);
            self.copy_surface((from_target.color, to.color), scales, rect, Some(formats));
        }
        if depth {
            if let (Some(a), Some(b)) = (from_target.z, to.z)
                && from_target.is_deep == to.is_deep
            {
                self.copy_surface((a, b), scales, rect, None);
            }
            match (from_target.w, to.w) {
                (Some(a), Some(b)) => self.copy_surface((a, b), scales, rect, None),
                (None, Some(b)) => {
                    let n = to.scale;
                    let rect = Rect::new(rect.x0 * n, rect.y0 * n, rect.x1 * n, rect.y1 * n);
                    let _ = self.device.set_target(to.color, Some(b));
                    self.device.clear(rect, ClearValues { color: None, aux: Some(0) });
                }
                _ => {}
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

    /// The colours of a rectangle inside a context, as elements.
    pub fn read_color(&mut self, context: u32, rect: Rect) -> Vec<u32> {
        let Some(target) = self.targets.get(&context).copied() else { return Vec::new() };
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
        let Some(target) = self.targets.get(&context).copied() else { return };
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
        let target = *self.targets.get(&context)?;
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

    /// Counters since the start.
    pub fn counters(&mut self) -> Counters {
        self.device.counters()
    }

    fn present(&mut self, present: &Present) {
        let Some(target) = self.targets.get(&present.context).copied() else { return };
        let Ok(surface) = self.device.surface(target.color) else { return };
        let mut front = present.front.lock().unwrap_or_else(PoisonError::into_inner);
        let shown = front_rect(&front, target.size, present.rect);
        let same_size = (front.width, front.height) == target.size;
        let plain = same_size && target.scale == 1 && front.clip.is_none();
        if plain && present.composite == 0 {
            copy_rows(surface, &mut front, &shown);
            front.note(shown);
            return;
        }
        for y in shown.top as u32..shown.bottom as u32 {
            for x in shown.left as u32..shown.right as u32 {
                if front.clip.is_some() && !front.shows(x, y) {
                    continue;
                }
                let element = if same_size {
                    sample(surface, &target, x, y)
                } else {
                    resample(surface, &target, &front, present.filter, x, y)
                };
                front.put(x, y, element, present.composite);
            }
        }
        front.note(shown);
    }
}

/// Shows a rectangle as it is; it lies inside both.
fn copy_rows(surface: &Surface, front: &mut Front, rect: &RaveRect) {
    let (left, right) = (rect.left as usize, rect.right as usize);
    let mut scratch = vec![0; if left > 0 { right } else { 0 }];
    let rows = front.elements.chunks_exact_mut(front.width as usize).enumerate();
    for (y, row) in rows.skip(rect.top as usize).take(rect.height() as usize) {
        if left == 0 {
            surface.read_row(y as u32, &mut row[..right]);
        } else {
            surface.read_row(y as u32, &mut scratch);
            row[left..right].copy_from_slice(&scratch[left..]);
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

/// A context's pixel: the mean of its samples.
fn sample(surface: &Surface, target: &Target, x: u32, y: u32) -> u32 {
    match target.scale {
        1 => surface.get(x, y),
        n => mean(surface, target.format, Rect::new(x * n, y * n, (x + 1) * n, (y + 1) * n)),
    }
}

/// The mean colour of a rectangle of a surface, each channel to the nearest.
fn mean(surface: &Surface, format: PixelFormat, rect: Rect) -> u32 {
    let mut sums = [0u32; 4];
    for y in rect.y0..rect.y1 {
        for x in rect.x0..rect.x1 {
            let channels = unpack(format, surface.get(x, y)).to_be_bytes();
            for (sum, channel) in sums.iter_mut().zip(channels) {
                *sum += u32::from(channel);
            }
        }
    }
    let count = rect.area().max(1) as u32;
    let argb = u32::from_be_bytes(sums.map(|sum| ((sum + count / 2) / count) as u8));
    pack(format, argb, Dither::Off, 0, 0)
}

/// The part of the front that a rectangle of the context reaches.
fn front_rect(front: &Front, (width, height): (u32, u32), rect: Rect) -> RaveRect {
    let low = |v: u32, to: u32, from: u32| (u64::from(v) * u64::from(to) / u64::from(from)) as i32;
    let high = |v: u32, to: u32, from: u32| {
        (u64::from(v) * u64::from(to)).div_ceil(u64::from(from)).min(u64::from(to)) as i32
    };
    RaveRect {
        left: low(rect.x0, front.width, width),
        right: high(rect.x1, front.width, width),
        top: low(rect.y0, front.height, height),
        bottom: high(rect.y1, front.height, height),
    }
}

/// A pixel of a front of another size than the context: the mean where the
/// context is larger, else the nearest pixel or, with a better filter, four.
fn resample(surface: &Surface, target: &Target, front: &Front, filter: u32, x: u32, y: u32) -> u32 {
    let (width, height) = (surface.width(), surface.height());
    let span = |v: u32, from: u32, to: u32| {
        let low = (u64::from(v) * u64::from(from) / u64::from(to)) as u32;
        let high = (u64::from(v + 1) * u64::from(from)).div_ceil(u64::from(to)) as u32;
        (low, high.clamp(low + 1, from))
    };
    let ((x0, x1), (y0, y1)) = (span(x, width, front.width), span(y, height, front.height));
    let shrinks = width > front.width || height > front.height;
    if shrinks || filter == 0 {
        let rect =
            if shrinks { Rect::new(x0, y0, x1, y1) } else { Rect::new(x0, y0, x0 + 1, y0 + 1) };
        return mean(surface, target.format, rect);
    }
    let ((x0, x1, fx), (y0, y1, fy)) =
        (neighbours(x, width, front.width), neighbours(y, height, front.height));
    let texel =
        |x: u32, y: u32| unpack(target.format, surface.get(x, y)).to_be_bytes().map(u32::from);
    let corners = [texel(x0, y0), texel(x1, y0), texel(x0, y1), texel(x1, y1)];
    let weights = [(256 - fx) * (256 - fy), fx * (256 - fy), (256 - fx) * fy, fx * fy];
    let channel = |i: usize| {
        let sum: u32 = corners.iter().zip(weights).map(|(corner, weight)| corner[i] * weight).sum();
        ((sum + 0x8000) >> 16) as u8
    };
    pack(target.format, u32::from_be_bytes([0, 1, 2, 3].map(channel)), Dither::Off, 0, 0)
}

/// The two source pixels around a pixel's centre, and the second one's weight
/// in 256ths.
fn neighbours(v: u32, from: u32, to: u32) -> (u32, u32, u32) {
    // Of 512ths of a source pixel, from the first one's centre.
    let at = (i64::from(2 * v + 1) * i64::from(from) * 256 / i64::from(to) - 256).max(0);
    let first = ((at / 512) as u32).min(from - 1);
    (first, (first + 1).min(from - 1), (at % 512 / 2) as u32)
}
