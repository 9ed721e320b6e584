//! Drawing: the state in the engine's terms, and primitives of triangles.
//!
//! Source: RR, primitives.

use std::sync::Arc;

use fillrate_engine::state::{DrawState, Filter, MAX_TMUS, Rect};
use fillrate_engine::{Texture, VeriteExtra, VeriteVertex};

use super::VeriteChip;
use super::area::Area;
use super::setup::{self, Attributes, Corner, Extent, Values};
use super::target::{DepthBuffer, Kind, Place, Resident};
use super::texture::Binding;
use super::translate::{self, SourceFunction};
use super::window::{self, Windows};
use crate::opcode::{Opcode, Register};
use crate::vertex::{KFXYZUVQ, KSXYZ, KXYZUVQ, Layout, VertexType};

/// Which of a state's pipelines a primitive needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mode {
    /// The iterated colour.
    Flat,
    /// The source function; texture coordinates are linear on the screen.
    Affine,
    /// The source function with perspective.
    Perspective,
    /// Whatever `Flat` or `Affine` would be, alpha times iterated alpha, blended.
    Coverage {
        /// With the source function.
        textured: bool,
        /// With perspective.
        perspective: bool,
    },
    /// As the others, without the pattern.
    Plain {
        /// With the source function.
        textured: bool,
        /// With perspective.
        perspective: bool,
    },
}

impl Mode {
    fn textured(self) -> bool {
        match self {
            Mode::Flat => false,
            Mode::Affine | Mode::Perspective => true,
            Mode::Coverage { textured, .. } | Mode::Plain { textured, .. } => textured,
        }
    }

    fn perspective(self) -> bool {
        match self {
            Mode::Flat | Mode::Affine => false,
            Mode::Perspective => true,
            Mode::Coverage { perspective, .. } | Mode::Plain { perspective, .. } => perspective,
        }
    }
}

/// The registers in the engine's terms, worked out when something is drawn
/// after they changed.
#[derive(Debug)]
pub(super) struct Prepared {
    /// Without source function and texture.
    pub base: DrawState,
    pub function: SourceFunction,
    pub attributes: Attributes,
    /// What can be drawn in the window, in pixels of the destination.
    pub scissor: Rect,
    windows: Windows,
    /// There is no other window to be drawn.
    is_one: bool,
    /// The engine's target is the window.
    entered: bool,
    pub binding: Option<Binding>,
    /// The decoded source, once something needed it, and what of it.
    texture: Option<(Binding, Option<Arc<Texture>>)>,
    /// What the engine's state is set to.
    mode: Option<Mode>,
    /// Of that mode's triangles, places and texels are the engine's.
    direct: bool,
    pub depth: bool,
}

impl Prepared {
    /// Goes on to another window.
    fn select(&mut self, window: Rect) {
        if window != self.windows.window() {
            self.windows.select(window, &mut self.base);
            self.scissor = self.windows.scissor();
            (self.entered, self.mode) = (false, None);
        }
    }

    /// The pixel of the destination that the window begins with.
    pub fn origin(&self) -> [u32; 2] {
        self.windows.origin()
    }

    /// The mode of vertices of a layout.
    #[inline]
    fn mode_of(&self, layout: &Layout) -> Mode {
        match (self.binding.is_some(), layout.word(crate::vertex::Attribute::Q).is_some()) {
            (false, _) => Mode::Flat,
            (true, false) => Mode::Affine,
            (true, true) => Mode::Perspective,
        }
    }

    /// Whether the engine is set to a mode, and takes its triangles as they are.
    #[inline]
    fn is_direct(&self, mode: Mode) -> bool {
        self.direct && self.mode == Some(mode)
    }

    /// The first texel of a texture that is decoded in part.
    fn first_texel(&self) -> Option<[f64; 2]> {
        let (binding, _) = self.texture.as_ref()?;
        let origin = [binding.columns.origin, binding.rows.origin];
        (origin != [0, 0]).then(|| origin.map(f64::from))
    }
}

/// Three corners, read or to be read by what the state makes of attributes.
pub(super) trait Corners {
    /// Where they are, in sixteenths.
    fn places(&self) -> [[i32; 2]; 3];
    /// The corners.
    fn read(&self, attributes: &Attributes) -> [Corner; 3];
    /// As the engine takes them, at their places.
    fn read_to(&self, attributes: &Attributes, at: [[i32; 2]; 3], to: &mut [VeriteVertex; 3]);
    /// The same with what some states read.
    fn read_extended_to(
        &self,
        attributes: &Attributes,
        at: [[i32; 2]; 3],
        to: &mut [(VeriteVertex, VeriteExtra); 3],
    );
}

impl Corners for [Corner; 3] {
    fn places(&self) -> [[i32; 2]; 3] {
        self.each_ref().map(|corner| corner.place)
    }

    fn read(&self, _: &Attributes) -> [Corner; 3] {
        *self
    }

    fn read_to(&self, _: &Attributes, _: [[i32; 2]; 3], to: &mut [VeriteVertex; 3]) {
        *to = self.each_ref().map(|corner| corner.vertex);
    }

    fn read_extended_to(
        &self,
        _: &Attributes,
        _: [[i32; 2]; 3],
        to: &mut [(VeriteVertex, VeriteExtra); 3],
    ) {
        *to = self.each_ref().map(|corner| (corner.vertex, corner.extra));
    }
}

/// Vertices of a layout.
#[derive(Clone, Copy)]
struct Words<'a> {
    layout: &'static Layout,
    a: &'a [u32],
    b: &'a [u32],
    c: &'a [u32],
    textured: bool,
}

impl Corners for Words<'_> {
    #[inline(always)]
    fn places(&self) -> [[i32; 2]; 3] {
        let place = |words| setup::place(self.layout, words);
        [place(self.a), place(self.b), place(self.c)]
    }

    #[cold]
    fn read(&self, attributes: &Attributes) -> [Corner; 3] {
        [self.a, self.b, self.c].map(|words| attributes.read(self.layout, words, self.textured))
    }

    #[inline(always)]
    fn read_to(&self, attributes: &Attributes, at: [[i32; 2]; 3], to: &mut [VeriteVertex; 3]) {
        let [to_a, to_b, to_c] = to;
        attributes.read_to(self.layout, self.a, at[0], to_a);
        attributes.read_to(self.layout, self.b, at[1], to_b);
        attributes.read_to(self.layout, self.c, at[2], to_c);
    }

    #[inline]
    fn read_extended_to(
        &self,
        attributes: &Attributes,
        at: [[i32; 2]; 3],
        to: &mut [(VeriteVertex, VeriteExtra); 3],
    ) {
        let words = [self.a, self.b, self.c];
        for (((vertex, extra), words), at) in to.iter_mut().zip(words).zip(at) {
            attributes.read_to(self.layout, words, at, vertex);
            attributes.read_extra_to(self.layout, words, self.textured, extra);
        }
    }
}

/// Which of two columns and rows the corners of a rectangle have.
const UPPER_LEFT_FIRST: [[usize; 2]; 4] = [[0, 0], [1, 0], [0, 1], [1, 1]];
/// The triangles of these corners that a rectangle is drawn as.
pub(super) const HALVES: [[usize; 3]; 2] = [[0, 1, 2], [3, 2, 1]];

impl VeriteChip {
    /// The registers have changed, or bytes that a texture may come from.
    pub(super) fn invalidate(&mut self) {
        self.prepared = None;
    }

    /// The destination's place and size; `None` where nothing can be drawn.
    pub(super) fn destination(&self) -> Option<(Place, (u32, u32))> {
        let state = &self.state;
        let format = state.destination_format()?;
        let kind = Kind::Color { format, bgr: state.is_set(Register::DstBgr) };
        let pitch = self.config.chip.linebytes(state.get(Register::DstStride));
        let place = Place { base: state.get(Register::DstBase), pitch, kind };
        let [_, right, _, bottom] = state.scissor();
        let width = right.min(place.columns());
        let height = bottom.min(place.rows(width, self.memory.len()));
        (width > 0 && height > 0).then_some((place, (width, height)))
    }

    /// The depth buffer of the destination, and how many rows both have without
    /// lying in one another: a depth buffer within the destination is none, nor
    /// is one without memory.
    fn depth_buffer(&self, color: &Place, (width, height): (u32, u32)) -> (DepthBuffer, u32) {
        let state = &self.state;
        if !translate::uses_depth(state) {
            return (DepthBuffer::Unused, height);
        }
        let depth = Place {
            base: state.get(Register::ZBase),
            pitch: self.config.chip.linebytes(state.get(Register::ZStride)),
            kind: Kind::Depth,
        };
        let area = |place: &Place| Resident::area_of(place, (width, height), self.memory.len());
        let place = area(&depth);
        if place.is_empty() {
            return (DepthBuffer::Missing, height);
        }
        match area(color).rows_before(&place) {
            None => (DepthBuffer::At(depth), height),
            Some(0) => (DepthBuffer::Missing, height),
            Some(rows) => (DepthBuffer::At(depth), rows.min(height)),
        }
    }

    /// Works the state out; `None` where nothing can be drawn.
    #[inline]
    pub(super) fn prepare(&mut self) -> Option<&mut Prepared> {
        if self.prepared.is_none() {
            self.prepare_anew()?;
        }
        self.prepared.as_mut()
    }

    #[cold]
    fn prepare_anew(&mut self) -> Option<()> {
        let (place, (width, height)) = self.destination()?;
        let (depth, rows) = self.depth_buffer(&place, (width, height));
        let uses_depth = translate::uses_depth(&self.state);
        let mut base = translate::draw_state(&self.state, self.config.chip.has_specular());
        let clip = base.clip.unwrap_or_default().intersect(&Rect::new(0, 0, width, rows));
        base.clip = Some(clip);
        let windows = Windows::new(place, depth, (width, rows), clip);
        self.prepared = Some(self.work_out(base, windows, uses_depth));
        Some(())
    }

    fn work_out(&self, base: DrawState, windows: Windows, depth: bool) -> Prepared {
        let state = &self.state;
        let function = SourceFunction::of(state);
        let extended = base.shade.specular || base.fog.is_some();
        let filtered = translate::filter(state) == Filter::Bilinear;
        let pitch = self.config.chip.linebytes(state.get(Register::SrcStride));
        let textured = function != SourceFunction::NoTexture;
        let binding = if textured { Binding::new(state, pitch) } else { None };
        let attributes = Attributes::new(state, filtered, extended);
        Prepared {
            base: windows.state(&base),
            function,
            attributes,
            scissor: windows.scissor(),
            is_one: windows.is_one(),
            windows,
            entered: false,
            binding,
            texture: None,
            mode: None,
            direct: false,
            depth,
        }
    }

    /// Whether what is drawn next as before needs one window.
    #[inline]
    pub(super) fn is_in_one_window(&self) -> bool {
        self.prepared.as_ref().is_some_and(|prepared| prepared.is_one)
    }

    /// Draws a command in each window of the destination.
    #[inline]
    pub(super) fn in_windows(&mut self, draw: impl Fn(&mut VeriteChip)) {
        let Some(prepared) = self.prepare() else { return };
        if prepared.is_one {
            return draw(self);
        }
        let windows = prepared.windows;
        for window in windows.all() {
            if let Some(prepared) = self.prepare() {
                prepared.select(window);
            }
            draw(self);
        }
    }

    /// Whether an area is part of what is about to be drawn on, all of which is
    /// one window.
    pub(super) fn aims_at(&mut self, area: &Area) -> bool {
        let memory = self.memory.len();
        let Some(prepared) = self.prepare() else { return false };
        let window = prepared.windows.window();
        let size = (window.x1 - window.x0, window.y1 - window.y0);
        let (color, depth) = prepared.windows.places();
        let depth = if let DepthBuffer::At(depth) = depth { Some(depth) } else { None };
        let mut places = [Some(color), depth].into_iter().flatten();
        prepared.is_one
            && places.any(|place| Resident::area_of(&place, size, memory).overlaps(area))
    }

    /// Where the source lies that is drawn with.
    pub(super) fn texture_area(&self) -> Option<Area> {
        Some(self.prepared.as_ref()?.binding?.area())
    }

    /// Makes the window the engine's target; false where that cannot be.
    #[inline]
    pub(super) fn enter(&mut self) -> bool {
        match &self.prepared {
            Some(prepared) if prepared.entered => true,
            Some(prepared) => {
                let (windows, at) = (prepared.windows, prepared.windows.window());
                self.choose(&windows, at)
            }
            None => false,
        }
    }

    #[cold]
    fn choose(&mut self, windows: &Windows, at: Rect) -> bool {
        let (color, depth) = windows.places();
        let size = (at.x1 - at.x0, at.y1 - at.y0);
        let room = 2 * windows.count();
        let chosen = self.targets.choose(&mut self.memory, color, depth, size, room);
        if let Some(prepared) = &mut self.prepared {
            prepared.entered = chosen;
        }
        chosen
    }

    /// See [`Prepared::mode_of`].
    pub(super) fn mode_of(&self, layout: &Layout) -> Mode {
        self.prepared.as_ref().map_or(Mode::Flat, |prepared| prepared.mode_of(layout))
    }

    /// The mode without a pattern, or with coverage, of vertices of a layout.
    pub(super) fn stepped_mode(&self, layout: &Layout, coverage: bool) -> Mode {
        let mode = self.mode_of(layout);
        let (textured, perspective) = (mode.textured(), mode.perspective());
        match coverage {
            true => Mode::Coverage { textured, perspective },
            false => Mode::Plain { textured, perspective },
        }
    }

    /// Gives the engine the state of a mode. For large textures only what
    /// `range` (first and last texel of both axes) says is decoded.
    fn set_mode(&mut self, mode: Mode, range: Option<[[i64; 2]; 2]>) {
        let Some(prepared) = &mut self.prepared else { return };
        let large = mode.textured() && prepared.binding.is_some_and(|binding| binding.is_large());
        if prepared.mode == Some(mode) && !large {
            return;
        }
        let mut draw = prepared.base;
        let mut textures = [const { None }; MAX_TMUS];
        if let (true, Some(whole)) = (mode.textured(), prepared.binding) {
            let binding = match range {
                Some(range) if large => whole.narrowed(range),
                _ => whole,
            };
            let decoded = prepared.texture.as_ref().filter(|(of, _)| *of == binding);
            let texture = match decoded {
                Some((_, texture)) => texture.clone(),
                None => {
                    self.targets.sync(&mut self.memory, &binding.area());
                    self.textures.get(&self.memory, &binding)
                }
            };
            draw.units[0] = Some(translate::bound_unit(&self.state, &binding, mode.perspective()));
            textures[0] = texture.clone();
            prepared.texture = Some((binding, texture));
        }
        let function = if mode.textured() { prepared.function } else { SourceFunction::NoTexture };
        let coverage = matches!(mode, Mode::Coverage { .. });
        translate::source(&mut draw, function, coverage);
        if coverage {
            draw.blend = Some(translate::coverage_blend(&self.state));
            draw.logic_op = None;
        }
        if matches!(mode, Mode::Coverage { .. } | Mode::Plain { .. }) {
            draw.pattern = None;
        }
        self.targets.engine.set_state(&draw, textures);
        prepared.mode = Some(mode);
        prepared.direct = prepared.entered && !large && prepared.origin() == [0, 0];
    }

    /// Draws with a state of its own; the next primitive sets its own again.
    pub(super) fn set_special(
        &mut self,
        draw: &DrawState,
        textures: [Option<Arc<Texture>>; MAX_TMUS],
    ) {
        self.targets.engine.set_state(draw, textures);
        if let Some(prepared) = &mut self.prepared {
            prepared.mode = None;
        }
    }

    /// The texels that corners may touch, where the texture is so large that it
    /// matters.
    fn range(&self, mode: Mode, texels: &[[f64; 3]]) -> Option<[[i64; 2]; 2]> {
        let binding = self.prepared.as_ref()?.binding.filter(|_| mode.textured())?;
        if !binding.is_large() {
            return None;
        }
        let texel = |texel: &[f64; 3], axis: usize| {
            let quotient = texel[axis] / texel[2];
            if quotient.is_finite() { quotient.floor() as i64 } else { i64::MAX }
        };
        Some([0, 1].map(|axis| {
            let texels = texels.iter().map(|corner| texel(corner, axis));
            [texels.clone().min().unwrap_or(0), texels.max().unwrap_or(0)]
                .map(|texel| texel.clamp(-1 << 20, 1 << 20))
        }))
    }

    /// Draws a triangle of the destination, read with the whole texture.
    #[inline(always)]
    pub(super) fn launch(&mut self, mode: Mode, corners: &impl Corners) {
        let Some(prepared) = &self.prepared else { return };
        let places = corners.places();
        let extent = Extent::new(places);
        let drawn = extent.pixels().intersect(&prepared.scissor);
        if drawn.is_empty() {
            return;
        }
        let attributes = &prepared.attributes;
        if !prepared.is_direct(mode) || !extent.is_near() {
            return self.launch_anyhow(mode, &corners.read(attributes), &drawn);
        }
        self.targets.drawn(&drawn, prepared.depth);
        let engine = &mut self.targets.engine;
        if mode.textured() || attributes.extended {
            let Some(to) = engine.draw_verite_extended() else { return };
            corners.read_extended_to(attributes, places, to);
        } else {
            let Some(to) = engine.draw_verite() else { return };
            corners.read_to(attributes, places, to);
        }
    }

    /// The same where the engine has to be set to the window and the mode, where
    /// the window or the texture begins elsewhere, or where corners lie far away.
    #[inline(never)]
    fn launch_anyhow(&mut self, mode: Mode, corners: &[Corner; 3], drawn: &Rect) {
        let texels = corners.each_ref().map(|corner| corner.extra.texel);
        let Some((at, first_texel)) = self.begin(mode, &texels, drawn) else { return };
        let engine = &mut self.targets.engine;
        let corners = corners.each_ref().map(|corner| match first_texel {
            Some(texel) => corner.moved(at).beginning_at(texel),
            None => corner.moved(at),
        });
        if Extent::new(corners.each_ref().map(|corner| corner.place)).is_near() {
            let Some(to) = engine.draw_verite_extended() else { return };
            *to = corners.map(|corner| (corner.vertex, corner.extra));
            return;
        }
        let [a, b, c] = &corners;
        setup::parts([a, b, c]).iter().for_each(|registers| engine.launch(registers));
    }

    /// Sets the engine to the window and a mode, for drawing the pixels `drawn` of
    /// the destination with these texels at the corners. Gives the first pixel of
    /// the window, and the first texel of a texture that is decoded in part.
    fn begin(
        &mut self,
        mode: Mode,
        texels: &[[f64; 3]],
        drawn: &Rect,
    ) -> Option<([u32; 2], Option<[f64; 2]>)> {
        if !self.enter() {
            return None;
        }
        let range = self.range(mode, texels);
        self.set_mode(mode, range);
        let prepared = self.prepared.as_ref()?;
        let at = prepared.origin();
        self.targets.drawn(&window::moved(drawn, at), prepared.depth);
        Some((at, prepared.first_texel()))
    }

    /// Draws one pixel with the same values all over it, if it is visible.
    pub(super) fn pixel(&mut self, mode: Mode, x: i64, y: i64, values: &Values) {
        let Some(prepared) = &self.prepared else { return };
        let scissor = prepared.scissor;
        let (Ok(x), Ok(y)) = (u32::try_from(x), u32::try_from(y)) else { return };
        if x < scissor.x0 || x >= scissor.x1 || y < scissor.y0 || y >= scissor.y1 {
            return;
        }
        let drawn = Rect::new(x, y, x + 1, y + 1);
        let begun = self.begin(mode, std::slice::from_ref(&values.texel), &drawn);
        let Some(([left, top], first_texel)) = begun else { return };
        let values = first_texel.map_or(*values, |texel| values.beginning_at(texel));
        self.targets.engine.launch(&setup::pixel(x - left, y - top, &values));
    }

    /// Draws a triangle by the words of its corners.
    #[inline(always)]
    pub(super) fn triangle(&mut self, layout: &'static Layout, a: &[u32], b: &[u32], c: &[u32]) {
        let Some(prepared) = self.prepare() else { return };
        let mode = prepared.mode_of(layout);
        self.launch(mode, &Words { layout, a, b, c, textured: mode.textured() });
    }

    /// The halves of a rectangle, of its upper left, upper right, lower left and
    /// lower right corner.
    pub(super) fn halves(&mut self, mode: Mode, corners: &[Corner; 4]) {
        for half in HALVES {
            self.launch(mode, &half.map(|i| corners[i]));
        }
    }

    /// A rectangle, from its upper left and lower right corner in sixteenths,
    /// with U and V of these corners.
    pub(super) fn rectangle(&mut self, mode: Mode, at: [[i32; 2]; 2], uv: [[u32; 2]; 2]) {
        let Some(prepared) = &self.prepared else { return };
        let corners = UPPER_LEFT_FIRST
            .map(|[i, j]| prepared.attributes.corner([at[i][0], at[j][1]], [uv[i][0], uv[j][1]]));
        self.halves(mode, &corners);
    }

    /// A primitive with vertices.
    pub(super) fn draw(&mut self, opcode: Opcode, vertex: VertexType, head: &[u32], words: &[u32]) {
        let layout = vertex.layout();
        let size = vertex.words();
        let word = |i: usize| &words[i * size..(i + 1) * size];
        let mut triangle = |a, b, c| self.triangle(layout, word(a), word(b), word(c));
        match opcode {
            Opcode::Triangle => triangle(0, 1, 2),
            Opcode::Tristrip => (2..words.len() / size).for_each(|i| triangle(i - 2, i - 1, i)),
            Opcode::Trifan => (2..words.len() / size).for_each(|i| triangle(0, i - 1, i)),
            Opcode::Square => self.centered(layout, words, [head[0], head[0]]),
            Opcode::Rectangle => self.centered(layout, words, [head[0], head[1]]),
            Opcode::Dot => self.dot(layout, words),
            Opcode::Span => self.span(layout, word(0), word(1)),
            Opcode::Line => self.line(layout, [word(0), word(1)]),
            Opcode::Polyline => {
                for i in 1..words.len() / size {
                    self.line(layout, [word(i - 1), word(i)]);
                }
            }
            Opcode::AALine => self.antialiased_line(layout, [word(0), word(1)]),
            Opcode::AAEdge => self.antialiased_edge(layout, [word(0), word(1)]),
            _ => {}
        }
    }

    /// `V_FIFO_SQUARE`, `V_FIFO_RECTANGLE`: around a vertex, of which only the
    /// place counts; the texture lies exactly on it.
    fn centered(&mut self, layout: &Layout, words: &[u32], size: [u32; 2]) {
        if self.prepare().is_none() {
            return;
        }
        let mode = self.mode_of(&NO_Q);
        let place = |attribute| layout.get(words, attribute).unwrap_or(0);
        let center = [place(crate::vertex::Attribute::X), place(crate::vertex::Attribute::Y)];
        let side = |i: usize| {
            let (center, size) = (i64::from(center[i] as i32), i64::from(size[i] as i32).max(0));
            let low = center - size / 2;
            [low, low + size].map(|v| ((v + 0x800) >> 12) as i32)
        };
        let ([x0, x1], [y0, y1]) = (side(0), side(1));
        self.rectangle(mode, [[x0, y0], [x1, y1]], [[0, 0], [0x1_0000, 0x1_0000]]);
    }

    /// The fast triangles, whose layouts are no vertex types.
    pub(super) fn fast_triangle(&mut self, opcode: Opcode, words: &[u32]) {
        let layout = match opcode {
            Opcode::FtriKxyz => VertexType::KXYZ.layout(),
            Opcode::FtriKxyzuvq => &KXYZUVQ,
            Opcode::FtriKfxyzuvq => &KFXYZUVQ,
            Opcode::FtriKsxyz => &KSXYZ,
            _ => VertexType::KSXYZUVQ.layout(),
        };
        let size = words.len() / 3;
        self.triangle(layout, &words[..size], &words[size..2 * size], &words[2 * size..]);
    }

    /// `V_FIFO_TRI_FILL`: the default colour, whatever the source function.
    pub(super) fn triangle_fill(&mut self, words: &[u32]) {
        let Some(prepared) = self.prepare() else { return };
        let corners = [0, 2, 4].map(|i| {
            let place = [words[i], words[i + 1]].map(setup::sixteenths);
            prepared.attributes.corner(place, [0, 0])
        });
        self.launch(Mode::Flat, &corners);
    }

    /// `V_FIFO_PARTICLES`: rectangles of one colour and depth.
    pub(super) fn particles(&mut self, words: &[u32]) {
        if self.prepare().is_none() {
            return;
        }
        for record in words[1..].as_chunks::<4>().0 {
            let [place, size, z, color] = *record;
            let Some(prepared) = &self.prepared else { return };
            let [x, y] = [place >> 16, place & 0xffff].map(|v| i32::from(v as u16 as i16) * 16);
            let [width, height] = [size >> 16, size & 0xffff].map(|v| v as i32 * 16);
            let layout = VertexType::KXYZ.layout();
            let corner = prepared.attributes.read(layout, &[color, 0, 0, z], false);
            let place = |[i, j]: [usize; 2]| [x + [0, width][i], y + [0, height][j]];
            let corners = UPPER_LEFT_FIRST.map(|at| corner.at(place(at)));
            self.halves(Mode::Flat, &corners);
        }
    }

    /// `V_FIFO_AFFINE`: a rectangle with given steps of U and V, times 2^8.
    pub(super) fn affine(&mut self, words: &[u32]) {
        let Some(prepared) = self.prepare() else { return };
        let [ulx, uly, ulu, ulv, width, height] = [0, 1, 2, 3, 4, 5].map(|i| words[i] as i32);
        let step = [6, 7, 8, 9].map(|i| f64::from(words[i] as i32) / 256.0);
        let attributes = prepared.attributes;
        let [x, y] = [ulx, uly].map(|v| setup::sixteenths(v as u32));
        let [right, down] = [width, height].map(|v| i64::from(v.max(0)));
        let [x1, y1] =
            [i64::from(ulx) + right, i64::from(uly) + down].map(|v| ((v + 0x800) >> 12) as i32);
        let corner = |x1: i32, y1: i32| {
            let (columns, rows) = (f64::from(x1 - x) / 16.0, f64::from(y1 - y) / 16.0);
            let u = f64::from(ulu) + step[0] * columns + step[2] * rows;
            let v = f64::from(ulv) + step[1] * columns + step[3] * rows;
            attributes.corner([x1, y1], [u as i32 as u32, v as i32 as u32])
        };
        let corners = UPPER_LEFT_FIRST.map(|[i, j]| corner([x, x1][i], [y, y1][j]));
        let mode = self.mode_of(&NO_Q);
        self.halves(mode, &corners);
    }
}

/// A layout without anything, Q least of all.
pub(super) static NO_Q: Layout = Layout::EMPTY;
