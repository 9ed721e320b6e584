//! Reading and writing the buffers of a context, and pictures made from one.
//!
//! Source: RAVE 1.6, access to buffers and textures.

use fillrate_engine::state::Rect;
use fillrate_engine::target::unpack;

use crate::RaveError;
use crate::constants::context;
use crate::context::Context;
use crate::front::Shown;
use crate::image::Image;
use crate::pixel::PixelType;
use crate::texture::{Picture, Source};
use crate::translate::Plane;
use crate::vertex::{ImageValue, RaveRect};

/// The depths of a context.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ZBuffer {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Bits of an element: 16 or 32.
    pub depth: u32,
    /// Rows from the top, without padding, the low byte of an element first.
    /// 0 is nearest; under PerspectiveZ the largest is.
    pub elements: Vec<u8>,
}

impl Context {
    /// `QAAccessDrawBuffer`, apart from the pixels: see
    /// [`Context::draw_buffer`].
    pub(crate) fn access_draw_buffer(&mut self, id: u32) -> Result<(), RaveError> {
        self.sync_quietly();
        let context = self.contexts.get_mut(&id).ok_or(RaveError::Parameter)?;
        if context.draw_buffer_accessed {
            return Err(RaveError::Failure);
        }
        context.draw_buffer_accessed = true;
        Ok(())
    }

    /// The pixels that a context draws into: its back buffer. Waits for all
    /// drawing.
    pub fn draw_buffer(&mut self, context: crate::DrawContextId) -> Option<Shown> {
        let (context, painter) = self.context_and_painter(context.0)?;
        let (id, rect) = (context.id.0, context.bounds());
        let elements = painter.read_color(id, rect);
        Some(Shown::new(rect.x1, rect.y1, context.pixel_type, &elements))
    }

    /// `QAAccessDrawBufferEnd`: takes what the program wrote.
    pub(crate) fn access_draw_buffer_end(
        &mut self,
        id: u32,
        rect: &RaveRect,
        pixels: &[u8],
    ) -> Result<(), RaveError> {
        let (context, painter) = self.context_and_painter(id).ok_or(RaveError::Parameter)?;
        if !std::mem::take(&mut context.draw_buffer_accessed) {
            return Err(RaveError::Failure);
        }
        let inside = context.inside(Some(rect));
        if pixels.is_empty() {
            return Ok(());
        }
        let bytes = context.pixel_type.bits() as usize / 8;
        let elements = elements_inside(rect, &inside, bytes, pixels)?;
        painter.write_color(id, inside, &elements);
        Ok(())
    }

    /// `QAAccessZBuffer`, apart from the depths: see [`Context::z_buffer`].
    pub(crate) fn access_z_buffer(&mut self, id: u32) -> Result<(), RaveError> {
        self.sync_quietly();
        let context = self.contexts.get_mut(&id).ok_or(RaveError::Parameter)?;
        if context.z_buffer_accessed {
            return Err(RaveError::Failure);
        }
        if context.has(context::NO_Z_BUFFER) {
            return Err(RaveError::NotSupported);
        }
        context.z_buffer_accessed = true;
        Ok(())
    }

    /// The depths that a context compares with: z, or 1/w under PerspectiveZ.
    /// Waits for all drawing. `None` without a z buffer.
    pub fn z_buffer(&mut self, context: crate::DrawContextId) -> Option<ZBuffer> {
        let (context, painter) = self.context_and_painter(context.0)?;
        let (id, rect, plane) = (context.id.0, context.bounds(), context.plane());
        let depths = painter.read_depth(id, plane, rect);
        let elements = match plane {
            Plane::None => return None,
            Plane::Z16 => depths.iter().flat_map(|&z| (z as u16).to_le_bytes()).collect(),
            // 24 bits, widened to all of them.
            Plane::Deep => depths.iter().flat_map(|&z| (z << 8 | z >> 16).to_le_bytes()).collect(),
            Plane::InverseW => depths.iter().flat_map(|z| z.to_le_bytes()).collect(),
        };
        let depth = if plane == Plane::Z16 { 16 } else { 32 };
        Some(ZBuffer { width: rect.x1, height: rect.y1, depth, elements })
    }

    /// `QAAccessZBufferEnd`: takes what the program wrote.
    pub(crate) fn access_z_buffer_end(
        &mut self,
        id: u32,
        rect: &RaveRect,
        depths: &[u8],
    ) -> Result<(), RaveError> {
        let (context, painter) = self.context_and_painter(id).ok_or(RaveError::Parameter)?;
        if !std::mem::take(&mut context.z_buffer_accessed) {
            return Err(RaveError::Failure);
        }
        let (inside, plane) = (context.inside(Some(rect)), context.plane());
        if depths.is_empty() {
            return Ok(());
        }
        let bytes = if plane == Plane::Z16 { 2 } else { 4 };
        let mut elements = elements_inside(rect, &inside, bytes, depths)?;
        if plane == Plane::Deep {
            elements.iter_mut().for_each(|z| *z >>= 8);
        }
        painter.write_depth(id, plane, inside, &elements);
        Ok(())
    }

    /// The contents of the program's memory, which the next frame is composed
    /// with.
    pub(crate) fn window_contents(&mut self, id: u32, pixels: &[u8]) -> Result<(), RaveError> {
        let (context, painter) = self.context_and_painter(id).ok_or(RaveError::Parameter)?;
        let bytes = context.pixel_type.bits() as usize / 8;
        let front = painter.front(id, true).ok_or(RaveError::Parameter)?;
        if pixels.len() != front.elements.len() * bytes {
            return Err(RaveError::Parameter);
        }
        for (element, bytes) in front.elements.iter_mut().zip(pixels.chunks_exact(bytes)) {
            *element = element_of(bytes);
        }
        Ok(())
    }

    /// `QATextureNewFromDrawContext` and `QABitmapNewFromDrawContext`.
    pub(crate) fn picture_from(
        &mut self,
        id: u32,
        flags: u32,
        is_bitmap: bool,
    ) -> Result<u32, RaveError> {
        let context = self.contexts.get(&id).ok_or(RaveError::Parameter)?;
        let (width, height) = context.size;
        let bytes = vec![0; (width * height * 4) as usize];
        let image = ImageValue { width: width as i32, height: height as i32, pixels: bytes.into() };
        let mut picture = if is_bitmap {
            Picture::bitmap(flags, PixelType::Argb32, &image)?
        } else {
            // A frame is one level.
            let flags = flags & !crate::constants::texture::MIPMAP;
            Picture::texture(flags, PixelType::Argb32, &[image])?
        };
        picture.source = Source::Context(crate::DrawContextId(id));
        let number = self.add_picture(picture, is_bitmap)?;
        self.pictures_of(id);
        Ok(number)
    }

    /// Marks the pictures made from a context as out of date.
    pub(crate) fn pictures_of(&mut self, id: u32) {
        let source = Source::Context(crate::DrawContextId(id));
        let pictures = self.objects.textures.values_mut().chain(self.objects.bitmaps.values_mut());
        for picture in pictures.filter(|picture| picture.source == source) {
            picture.is_stale = true;
            self.has_stale = true;
        }
    }

    /// Copies frames into the pictures that are made from them.
    pub(crate) fn refresh_pictures(&mut self) {
        self.has_stale = false;
        let Some(painter) = &mut self.painter else { return };
        let pictures = self.objects.textures.values_mut().chain(self.objects.bitmaps.values_mut());
        for picture in pictures.filter(|picture| picture.is_stale) {
            picture.is_stale = false;
            let Source::Context(source) = picture.source else { continue };
            let Some(context) = self.contexts.get(&source.0) else { continue };
            let (id, rect, format) = (context.id.0, context.bounds(), context.format);
            let elements = painter.read_color(id, rect);
            let argb = elements.iter().map(|&element| unpack(format, element));
            let pixels: Vec<u8> = argb.flat_map(u32::to_le_bytes).collect();
            picture.levels = vec![Image { width: rect.x1, height: rect.y1, pixels: pixels.into() }];
            picture.changed();
        }
        for context in self.contexts.values_mut() {
            context.prepared = None;
        }
    }
}

/// The first element of at most four bytes, the low one first.
fn element_of(bytes: &[u8]) -> u32 {
    bytes.iter().rev().fold(0, |element, &byte| element << 8 | u32::from(byte))
}

/// The elements of a rectangle's part inside; rows of the whole rectangle lie in
/// `from` without padding.
fn elements_inside(
    rect: &RaveRect,
    inside: &Rect,
    bytes: usize,
    from: &[u8],
) -> Result<Vec<u32>, RaveError> {
    let row = rect.width() as usize * bytes;
    if from.len() < row * rect.height() as usize {
        return Err(RaveError::Parameter);
    }
    let mut elements = Vec::with_capacity(inside.area() as usize);
    for y in inside.y0..inside.y1 {
        let start = (y as i32 - rect.top) as usize * row;
        for x in inside.x0..inside.x1 {
            let at = start + (x as i32 - rect.left) as usize * bytes;
            elements.push(element_of(&from[at..at + bytes]));
        }
    }
    Ok(elements)
}
