//! Drawing a level through Glide.

use std::time::{Duration, Instant};

use anyhow::{Result, bail};
use fillrate_engine::DeviceConfig;
use fillrate_glide::card::{Card, RESOLUTIONS};
use fillrate_glide::{Call, Context, GlideConfig, GrVertex, Improvements, Shown, gu};

use crate::level::{Layer, Level, Material, SkyMaterial, Surface, Vertex};
use crate::memory::{Placed, TextureMemory};
use crate::picture::Texture;
use crate::script::Mode;
use crate::sky;
use crate::view::{CLIP, OUTSIDE, Seen, View};
use crate::wave::{self, Point};

/// How to draw.
#[derive(Clone, Debug)]
pub struct DrawOptions {
    /// The board.
    pub card: Card,
    /// Resolution as Glide numbers it.
    pub resolution: i32,
    /// Picture and lightmap on two units in one pass, or one after the other.
    pub passes: u32,
    /// Density of fog; `None` for none.
    pub fog: Option<f32>,
    /// Threads and SIMD level.
    pub device: DeviceConfig,
    /// Report misuse of the API.
    pub check: bool,
    /// More pixels and colours than the board has.
    pub improve: Improvements,
}

/// What a frame took.
#[derive(Clone, Copy, Debug, Default)]
pub struct FrameStats {
    /// Triangles given to the board.
    pub triangles: u64,
    /// Surfaces drawn.
    pub surfaces: usize,
    /// Textures downloaded.
    pub downloads: u64,
    /// Time of finding, clipping, projecting, and handing over.
    pub front: Duration,
    /// All of the time, drawing included.
    pub total: Duration,
}

/// What is drawn with one state.
#[derive(Clone, Copy, Debug, PartialEq)]
struct State {
    base: Option<usize>,
    lightmap: Option<usize>,
    /// The texture is multiplied with iterated colours.
    colored: bool,
    /// Its alpha, too.
    faded: bool,
    mode: Mode,
    two_sided: bool,
}

/// A surface in sight.
#[derive(Clone, Copy, Debug)]
struct Item {
    surface: usize,
    distance: f32,
}

/// The passes over the surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Pass {
    /// Picture times lightmap on two units.
    Both,
    /// The picture alone.
    Base,
    /// The lightmap, multiplied with what is there.
    Light,
    /// The fog, added to what is there.
    Fog,
    /// A further layer of surfaces that are there.
    Layer,
    /// The sky.
    Sky,
}

/// Glide, and what it holds.
#[derive(Debug)]
pub struct Renderer {
    glide: Context,
    options: DrawOptions,
    size: (u32, u32),
    memories: Vec<TextureMemory>,
    /// The texture each unit is pointed at.
    current: [Option<usize>; 2],
    state: Option<(Pass, State)>,
    /// Frame in which a surface was last collected.
    stamps: Vec<u64>,
    frame: u64,
    items: Vec<Item>,
    /// The sky in sight.
    sky: Option<usize>,
    /// Seconds since the start.
    time: f32,
    points: Vec<Point>,
    seen: Vec<Seen>,
    projected: Vec<GrVertex>,
    polygon: Vec<Seen>,
    scratch: Vec<Seen>,
    triangles: u64,
}

/// What is behind everything, and the colour of fog.
const SKY: u32 = 0x0058_6878;

impl Renderer {
    /// Opens a board for a level of so many surfaces.
    ///
    /// # Errors
    /// Where the board cannot show that resolution, or lacks a second unit.
    pub fn new(options: DrawOptions, surfaces: usize) -> Result<Renderer> {
        if options.passes == 1 && options.card.units < 2 {
            bail!("{} has one texture unit: use two passes", options.card.name);
        }
        let (device, card, check) = (options.device.clone(), options.card.clone(), options.check);
        let improve = options.improve;
        let config = GlideConfig { device, card, check, improve, ..GlideConfig::default() };
        let mut glide = Context::new(config)?;
        glide.execute(&Call::GrGlideInit {});
        let open = Call::GrSstWinOpen {
            window: 0,
            resolution: options.resolution,
            refresh: 0,
            color_format: 0,
            origin: 0,
            colors: 2,
            aux: 1,
        };
        if glide.execute(&open) == 0 {
            bail!("{} cannot show this size with a depth buffer", options.card.name);
        }
        let size = RESOLUTIONS[options.resolution as usize];
        let bytes = options.card.texture_bytes() as u32;
        let mut renderer = Renderer {
            glide,
            size,
            memories: (0..options.card.units.min(2)).map(|_| TextureMemory::new(bytes)).collect(),
            options,
            current: [None; 2],
            state: None,
            stamps: vec![0; surfaces],
            frame: 0,
            items: Vec::new(),
            sky: None,
            time: 0.0,
            points: Vec::new(),
            seen: Vec::new(),
            projected: Vec::new(),
            polygon: Vec::new(),
            scratch: Vec::new(),
            triangles: 0,
        };
        renderer.set_up();
        Ok(renderer)
    }

    fn call(&mut self, call: Call) {
        self.glide.execute(&call);
    }

    /// The state that never changes.
    fn set_up(&mut self) {
        // Depth by w, nearer wins; textures have their own coordinates.
        self.call(Call::GrDepthBufferMode { mode: 2 });
        self.call(Call::GrHints { hint: 0, mask: 0x10 });
        for tmu in 0..self.memories.len() as i32 {
            self.call(Call::GrTexFilterMode { tmu, minify: 1, magnify: 1 });
        }
        if let Some(density) = self.options.fog {
            self.call(Call::GrFogTable { table: gu::fog_table_exp(density) });
        }
        self.call(Call::GuAlphaSource { mode: 2 });
    }

    /// Columns and rows.
    pub fn size(&self) -> (u32, u32) {
        self.size
    }

    /// The frame drawn last.
    pub fn shown(&mut self) -> Option<Shown> {
        self.glide.shown()
    }

    /// Fragments drawn so far.
    pub fn fragments(&mut self) -> u64 {
        self.glide.total_counters().pixels_out
    }

    /// What checking found.
    pub fn problems(&mut self) -> Vec<String> {
        self.glide.take_reports().iter().map(ToString::to_string).collect()
    }

    /// Draws a frame as it is at a time in seconds, and shows it.
    pub fn draw(&mut self, level: &Level, view: &View, time: f32) -> FrameStats {
        let start = Instant::now();
        let downloads = self.downloads();
        self.triangles = 0;
        self.time = time;
        self.collect(level, view);
        let items = core::mem::take(&mut self.items);
        let material = |item: &Item| &level.materials[level.surfaces[item.surface].material];
        let blended = |item: &&Item| material(item).is_blended();
        let mut opaque: Vec<Item> = items.iter().filter(|i| !blended(i)).copied().collect();
        let mut clear: Vec<Item> = items.iter().filter(blended).copied().collect();
        self.call(Call::GrColorMask { rgb: 1, alpha: 0 });
        self.call(Call::GrDepthMask { mask: 1 });
        self.call(Call::GrBufferClear { color: SKY, alpha: 0, depth: 0xffff });
        self.state = None;
        if let Some(sky) = self.sky {
            self.draw_sky(level, view, &level.skies[sky]);
        }
        self.sort_opaque(level, &mut opaque);
        if self.options.passes == 1 {
            self.draw_pass(level, view, &opaque, Pass::Both);
        } else {
            self.draw_pass(level, view, &opaque, Pass::Base);
            opaque.sort_by_key(|item| level.surfaces[item.surface].lightmap);
            self.draw_pass(level, view, &opaque, Pass::Light);
            if self.options.fog.is_some() {
                self.draw_pass(level, view, &opaque, Pass::Fog);
            }
        }
        for item in &opaque {
            for layer in 1..material(item).layers.len() {
                self.draw_item(level, view, item, Pass::Layer, layer);
            }
        }
        // What is seen through comes last, the farthest first.
        clear.sort_by(|a, b| b.distance.total_cmp(&a.distance));
        for item in &clear {
            for layer in 0..material(item).layers.len() {
                self.draw_item(level, view, item, Pass::Base, layer);
            }
        }
        let surfaces = items.len();
        self.items = items;
        let front = start.elapsed();
        self.call(Call::GrBufferSwap { interval: 0 });
        // Drawing goes on behind the caller; a frame's time is that until it is done.
        self.glide.counters();
        FrameStats {
            triangles: self.triangles,
            surfaces,
            downloads: self.downloads() - downloads,
            front,
            total: start.elapsed(),
        }
    }

    fn downloads(&self) -> u64 {
        self.memories.iter().map(|memory| memory.downloads).sum()
    }

    /// Finds the surfaces in sight: by the visibility table, the tree's boxes,
    /// their own boxes, and the side they are seen from.
    fn collect(&mut self, level: &Level, view: &View) {
        self.frame += 1;
        self.items.clear();
        self.sky = None;
        let bsp = &level.bsp;
        let from = bsp.leaf_at(view.eye()).and_then(|leaf| leaf.cluster);
        for leaf in &bsp.leafs {
            let Some(cluster) = leaf.cluster else { continue };
            if bsp.sees(from, cluster) && view.may_see([leaf.low, leaf.high]) {
                for &face in bsp.leaf_faces(leaf) {
                    self.add(level, view, face);
                }
            }
        }
        // Doors and the like are in no leaf.
        for face in bsp.world_faces..bsp.faces.len() {
            self.add(level, view, face);
        }
    }

    fn add(&mut self, level: &Level, view: &View, face: usize) {
        if let Some((sky, bounds)) = level.sky_of[face]
            && view.may_see(bounds)
        {
            self.sky = Some(sky);
        }
        let Some(index) = level.surface_of[face] else { return };
        if self.stamps[index] == self.frame {
            return;
        }
        self.stamps[index] = self.frame;
        let surface = &level.surfaces[index];
        let faces_away = surface
            .plane
            .is_some_and(|(normal, distance)| crate::math::dot(normal, view.eye()) <= distance);
        if faces_away || !view.may_see(surface.bounds) {
            return;
        }
        let [low, high] = surface.bounds;
        let nearest = core::array::from_fn(|i| view.eye()[i].clamp(low[i], high[i]));
        let away = crate::math::sub(nearest, view.eye());
        let middle = view.depth(crate::math::mix(low, high, 0.5)).max(0.0);
        let distance = if surface.lightmap.is_some() { crate::math::length(away) } else { middle };
        self.items.push(Item { surface: index, distance });
    }

    /// Groups surfaces by texture: those already in texture memory first, so
    /// that they are used before they have to go; then the nearest group.
    fn sort_opaque(&self, level: &Level, items: &mut [Item]) {
        let texture =
            |item: &Item| level.materials[level.surfaces[item.surface].material].texture();
        let mut nearest = vec![f32::MAX; level.textures.len()];
        for item in items.iter() {
            let entry = &mut nearest[texture(item)];
            *entry = entry.min(item.distance);
        }
        let memory = &self.memories[self.base_unit()];
        let resident: Vec<bool> = (0..nearest.len()).map(|key| memory.is_resident(key)).collect();
        items.sort_by(|a, b| {
            let key = |item: &Item| {
                let texture = texture(item);
                let group = nearest[texture].to_bits();
                let lightmap = level.surfaces[item.surface].lightmap;
                (!resident[texture], group, texture, lightmap, item.distance.to_bits())
            };
            key(a).cmp(&key(b))
        });
    }

    /// The unit that holds pictures: the second where both draw at once.
    fn base_unit(&self) -> usize {
        usize::from(self.options.passes == 1)
    }

    fn draw_pass(&mut self, level: &Level, view: &View, items: &[Item], pass: Pass) {
        items.iter().for_each(|item| self.draw_item(level, view, item, pass, 0));
    }

    /// Draws a layer of a surface.
    fn draw_item(&mut self, level: &Level, view: &View, item: &Item, pass: Pass, layer: usize) {
        let surface = &level.surfaces[item.surface];
        let material = &level.materials[surface.material];
        let layer = &material.layers[layer];
        let lightmap = surface.lightmap.filter(|_| layer.lit);
        if pass == Pass::Light && lightmap.is_none() {
            return;
        }
        let base = layer.texture(self.time).or(surface.lightmap);
        if base.is_none() {
            // A lightmap on a surface that has none.
            return;
        }
        let draws_picture = !matches!(pass, Pass::Light | Pass::Fog);
        let wanted = State {
            base: base.filter(|_| draws_picture),
            lightmap: lightmap.filter(|_| matches!(pass, Pass::Both | Pass::Light)),
            colored: is_colored(surface, layer),
            faded: !layer.alpha.is_identity(),
            mode: layer.mode,
            two_sided: material.two_sided,
        };
        self.set_state(level, pass, wanted);
        self.draw_surface(level, view, surface, pass, layer);
    }

    /// The sky is behind everything: first, and compared with nothing.
    fn draw_sky(&mut self, level: &Level, view: &View, sky: &SkyMaterial) {
        let opaque = |texture: usize| State {
            base: Some(texture),
            lightmap: None,
            colored: false,
            faded: false,
            mode: Mode::Opaque,
            two_sided: true,
        };
        for (side, &texture) in sky.far.iter().flatten().enumerate() {
            self.set_state(level, Pass::Sky, opaque(texture));
            self.draw_far(level, view, texture, &[sky::side(side)], [255.0; 4]);
        }
        for layer in &sky.clouds {
            let Some(texture) = layer.texture(self.time) else { continue };
            let colored = !layer.color.is_identity();
            let faded = !layer.alpha.is_identity();
            let state = State { colored, faded, mode: layer.mode, ..opaque(texture) };
            let [r, g, b] = layer.color.at([255.0; 3], self.time);
            let [a, ..] = layer.alpha.at([255.0; 3], self.time);
            let mut clouds = sky::clouds(sky.height);
            for (at, st) in clouds.iter_mut().flatten() {
                *st = wave::moved(&layer.moves, *st, *at, self.time);
            }
            self.set_state(level, Pass::Sky, state);
            self.draw_far(level, view, texture, &clouds, [r, g, b, a]);
        }
    }

    /// Rectangles around the eye.
    fn draw_far(
        &mut self,
        level: &Level,
        view: &View,
        texture: usize,
        rectangles: &[[sky::Corner; 4]],
        [r, g, b, alpha]: [f32; 4],
    ) {
        let swapped = self.options.passes != 1;
        let texture = &level.textures[texture];
        for rectangle in rectangles {
            let mut st = rectangle.map(|(_, st)| st);
            into_texels(&mut st, texture);
            self.seen.clear();
            self.projected.clear();
            for ((way, _), st) in rectangle.iter().zip(st) {
                let position = crate::math::add(view.eye(), *way);
                let (light, color, normal) = ([0.0; 2], [r, g, b], *way);
                let vertex = Vertex { position, st, light, color, alpha, normal };
                self.push(view, &vertex, swapped);
            }
            self.draw_triangles(view, &[0, 1, 2, 0, 2, 3], swapped);
        }
    }

    fn set_state(&mut self, level: &Level, pass: Pass, wanted: State) {
        let old = self.state.filter(|(old, _)| *old == pass).map(|(_, state)| state);
        if old == Some(wanted) {
            return;
        }
        if old.is_none() {
            self.begin_pass(pass);
        }
        let (base_unit, light_unit) = (self.base_unit(), 0);
        if let Some(base) = wanted.base {
            self.use_texture(level, base_unit, base);
        }
        if let Some(lightmap) = wanted.lightmap {
            self.use_texture(level, light_unit, lightmap);
        }
        let differs =
            |same: fn(&State, &State) -> bool| !old.is_some_and(|old| same(&old, &wanted));
        if differs(|a, b| a.mode == b.mode) {
            self.set_mode(pass, wanted.mode);
        }
        if differs(|a, b| a.two_sided == b.two_sided) {
            self.call(Call::GrCullMode { mode: if wanted.two_sided { 0 } else { 1 } });
        }
        let combines = |a: &State, b: &State| {
            (a.lightmap.is_some(), a.colored, a.faded) == (b.lightmap.is_some(), b.colored, b.faded)
        };
        if differs(combines) {
            self.set_combine(pass, &wanted);
        }
        self.state = Some((pass, wanted));
    }

    /// The state of a pass.
    fn begin_pass(&mut self, pass: Pass) {
        let (function, mask) = match pass {
            Pass::Both | Pass::Base => (1, 1),
            Pass::Light | Pass::Fog | Pass::Layer => (2, 0),
            Pass::Sky => (7, 0),
        };
        self.call(Call::GrDepthBufferFunction { function });
        self.call(Call::GrDepthMask { mask });
        if self.options.fog.is_none() {
            return;
        }
        // A picture that will be multiplied fades to black instead; the fog
        // is added at the end.
        let (mode, color) = match (pass, self.options.passes) {
            (Pass::Both, _) => (2, SKY),
            (Pass::Base, 1) => (2, SKY),
            (Pass::Base, _) => (2 | 0x200, SKY),
            (Pass::Light | Pass::Layer | Pass::Sky, _) => (0, SKY),
            (Pass::Fog, _) => (2 | 0x100, SKY),
        };
        self.call(Call::GrFogMode { mode });
        self.call(Call::GrFogColorValue { color });
    }

    /// The fog of what is blended: light that is added fades to nothing, and
    /// what filters stays as it is.
    fn set_blended_fog(&mut self, destination: i32) {
        if self.options.fog.is_some() {
            let mode = match destination {
                4 => 2 | 0x200,
                5 => 2,
                _ => 0,
            };
            self.call(Call::GrFogMode { mode });
        }
    }

    /// Blending and alpha test.
    fn set_mode(&mut self, pass: Pass, mode: Mode) {
        let (source, destination) = match (pass, mode) {
            (Pass::Light, _) => (2, 0),
            (Pass::Fog, _) => (4, 4),
            (_, Mode::Blended(source, destination)) => (source, destination),
            _ => (4, 0),
        };
        self.call(Call::GrAlphaBlendFunction {
            rgb_source: source,
            rgb_destination: destination,
            alpha_source: 4,
            alpha_destination: 0,
        });
        let (function, value) = match (pass, mode) {
            (Pass::Light | Pass::Fog, _) => (7, 0),
            (_, Mode::Tested { reference, below: false }) => (6, reference),
            (_, Mode::Tested { reference, below: true }) => (1, reference),
            _ => (7, 0),
        };
        self.call(Call::GrAlphaTestFunction { function });
        self.call(Call::GrAlphaTestReferenceValue { value });
        if let (Pass::Both | Pass::Base | Pass::Layer, Mode::Blended(_, destination)) = (pass, mode)
        {
            self.call(Call::GrDepthMask { mask: 0 });
            self.set_blended_fog(destination);
        }
    }

    /// Texture and colour combine.
    fn set_combine(&mut self, pass: Pass, state: &State) {
        // Picture on the second unit, lightmap on the first: multiply, or pass
        // the picture on. With one unit at a time: that unit's texel.
        if self.options.passes == 1 {
            let function = if state.lightmap.is_some() { 4 } else { 2 };
            self.call(Call::GrTexCombineFunction { tmu: 1, function: 1 });
            self.call(Call::GrTexCombineFunction { tmu: 0, function });
            // A lightmap's alpha must not change the picture's.
            if state.lightmap.is_some() {
                self.call(Call::GrTexCombine {
                    tmu: 0,
                    rgb_function: 3,
                    rgb_factor: 1,
                    alpha_function: 3,
                    alpha_factor: 8,
                    rgb_invert: 0,
                    alpha_invert: 0,
                });
            }
        } else {
            self.call(Call::GrTexCombineFunction { tmu: 0, function: 1 });
        }
        let draws_picture = !matches!(pass, Pass::Light | Pass::Fog);
        let colored = state.colored && draws_picture;
        self.call(Call::GuColorCombineFunction { function: if colored { 6 } else { 4 } });
        let faded = state.faded && draws_picture;
        self.call(Call::GuAlphaSource { mode: if faded { 3 } else { 2 } });
    }

    /// Points a unit at a texture, which is downloaded where it is missing.
    fn use_texture(&mut self, level: &Level, unit: usize, key: usize) {
        let texture = &level.textures[key];
        let Some(placed) = self.memories[unit].place(key, bytes(texture)) else { return };
        if self.current[unit] == Some(key) && matches!(placed, Placed::Resident(_)) {
            return;
        }
        let tmu = unit as i32;
        let (aspect, format, large_lod) = (texture.aspect, texture.format, texture.large_lod);
        let small_lod = smallest_lod(texture);
        let even_odd = 3;
        let start = match placed {
            Placed::Resident(start) => start,
            Placed::Download(start) => {
                let data = texture.data.as_slice().into();
                self.call(Call::GrTexDownloadMipMap {
                    tmu,
                    start,
                    even_odd,
                    small_lod,
                    large_lod,
                    aspect,
                    format,
                    data,
                });
                start
            }
        };
        self.call(Call::GrTexSource { tmu, start, even_odd, small_lod, large_lod, aspect, format });
        let clamp = i32::from(texture.clamp);
        self.call(Call::GrTexClampMode { tmu, s: clamp, t: clamp });
        let levels = i32::from(small_lod != large_lod);
        self.call(Call::GrTexMipMapMode { tmu, mode: levels, blend: 0 });
        self.current[unit] = Some(key);
    }

    fn draw_surface(
        &mut self,
        level: &Level,
        view: &View,
        surface: &Surface,
        pass: Pass,
        layer: &Layer,
    ) {
        // Where one unit draws, it reads the first pair of coordinates.
        let swapped = self.options.passes != 1 && pass != Pass::Light;
        let vertices = &level.vertices[surface.vertices.clone()];
        self.place(level, view, surface, layer, vertices);
        let points = core::mem::take(&mut self.points);
        self.seen.clear();
        self.projected.clear();
        let by_vertices = surface.lightmap.is_none() && layer.lit;
        for (vertex, point) in vertices.iter().zip(&points) {
            let color = match by_vertices {
                true => vertex.color,
                false => layer.color.at(vertex.color, self.time),
            };
            let [alpha, ..] = layer.alpha.at([vertex.alpha; 3], self.time);
            let (position, st) = (point.at, point.st);
            self.push(view, &Vertex { position, st, color, alpha, ..*vertex }, swapped);
        }
        self.points = points;
        self.draw_triangles(view, &level.corners[surface.corners.clone()], swapped);
    }

    /// Where vertices and their coordinates are now, in the board's units.
    fn place(
        &mut self,
        level: &Level,
        view: &View,
        surface: &Surface,
        layer: &Layer,
        vertices: &[Vertex],
    ) {
        let point = |v: &Vertex| Point { at: v.position, normal: v.normal, st: v.st };
        self.points.clear();
        self.points.extend(vertices.iter().map(point));
        let Material { deforms, .. } = &level.materials[surface.material];
        let camera = view.camera();
        wave::deform(deforms, &mut self.points, self.time, camera.right, camera.up);
        let Some(texture) = layer.texture(self.time) else {
            // The lightmap, whose coordinates are in the board's units.
            self.points.iter_mut().zip(vertices).for_each(|(point, v)| point.st = v.light);
            return;
        };
        for point in &mut self.points {
            if layer.environment {
                point.st = wave::reflected(point.at, point.normal, camera.eye);
            }
            point.st = wave::moved(&layer.moves, point.st, point.at, self.time);
        }
        let texture = &level.textures[texture];
        let [s0, t0] = first_repetition(self.points.iter().map(|point| point.st), texture);
        let [es, et] = texture.extent;
        for Point { st: [s, t], .. } in &mut self.points {
            (*s, *t) = ((*s - s0) * es, (*t - t0) * et);
        }
    }

    fn push(&mut self, view: &View, vertex: &Vertex, swapped: bool) {
        let seen = view.see(vertex);
        self.seen.push(seen);
        let drawn = match seen.code & CLIP {
            0 => view.project(&seen, swapped),
            _ => GrVertex::default(),
        };
        self.projected.push(drawn);
    }

    fn draw_triangles(&mut self, view: &View, corners: &[u32], swapped: bool) {
        for corners in corners.as_chunks::<3>().0 {
            let [a, b, c] = corners.map(|i| i as usize);
            let codes = [a, b, c].map(|i| self.seen[i].code);
            if codes[0] & codes[1] & codes[2] & OUTSIDE != 0 {
                continue;
            }
            if (codes[0] | codes[1] | codes[2]) & CLIP == 0 {
                let [a, b, c] = [a, b, c].map(|i| self.projected[i]);
                self.glide.draw_triangle(&a, &b, &c);
                self.triangles += 1;
            } else {
                self.draw_clipped(view, [a, b, c], swapped);
            }
        }
    }

    fn draw_clipped(&mut self, view: &View, corners: [usize; 3], swapped: bool) {
        self.polygon.clear();
        self.polygon.extend(corners.map(|i| self.seen[i]));
        view.clip(&mut self.polygon, &mut self.scratch);
        let drawn: Vec<GrVertex> = self.polygon.iter().map(|v| view.project(v, swapped)).collect();
        let [first, rest @ ..] = drawn.as_slice() else { return };
        for pair in rest.windows(2) {
            self.glide.draw_triangle(first, &pair[0], &pair[1]);
            self.triangles += 1;
        }
    }
}

/// Whether a layer's picture is multiplied with iterated colours.
fn is_colored(surface: &Surface, layer: &Layer) -> bool {
    !layer.color.is_identity() || surface.lightmap.is_none() && layer.lit
}

/// The whole repetitions that all of some coordinates are beyond: small
/// coordinates are exact ones.
fn first_repetition(all: impl Iterator<Item = [f32; 2]>, texture: &Texture) -> [f32; 2] {
    if texture.clamp {
        return [0.0; 2];
    }
    let least = all.fold([f32::MAX; 2], |[s0, t0], [s, t]| [s0.min(s), t0.min(t)]);
    least.map(f32::floor)
}

/// Coordinates in the board's units.
fn into_texels(st: &mut [[f32; 2]; 4], texture: &Texture) {
    let [s0, t0] = first_repetition(st.iter().copied(), texture);
    let [es, et] = texture.extent;
    *st = st.map(|[s, t]| [(s - s0) * es, (t - t0) * et]);
}

/// The smallest level there is: 1x1, or the only one.
fn smallest_lod(texture: &Texture) -> i32 {
    let (width, height) = texture.size();
    if texture.data.len() == width * height * 2 { texture.large_lod } else { 8 }
}

/// Bytes in texture memory.
fn bytes(texture: &Texture) -> u32 {
    use fillrate_glide::texture::layout::chain_bytes;
    let (small, large) = (smallest_lod(texture) as u32, texture.large_lod as u32);
    chain_bytes(small, large, texture.aspect, texture.format, 3)
}

/// How two pictures of one size differ, in steps of 8 bits a channel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Difference {
    /// The largest difference.
    pub largest: u32,
    /// Pixels compared.
    pub pixels: u64,
    /// Pixels that differ by more than [`ROUNDING`].
    pub beyond: u64,
}

/// What four reductions to five bits can make: the picture, the product and
/// the sum with fog in two passes, and the one of one pass.
///
/// More is seen only where two surfaces have equal depths at a pixel, mostly
/// where they meet: there the second pass multiplies twice.
pub const ROUNDING: u32 = 33;

impl Difference {
    /// Adds what two more pictures differ by.
    pub fn add(&mut self, one: &Shown, two: &Shown) {
        use fillrate_engine::PixelFormat;
        use fillrate_engine::target::unpack;
        let widen = |pixel: u16| unpack(PixelFormat::Rgb565, u32::from(pixel)).to_be_bytes();
        for (&a, &b) in one.pixels.iter().zip(&two.pixels) {
            let (a, b) = (widen(a), widen(b));
            let largest = (1..4).map(|i| u32::from(a[i].abs_diff(b[i]))).max().unwrap_or(0);
            self.largest = self.largest.max(largest);
            self.beyond += u64::from(largest > ROUNDING);
            self.pixels += 1;
        }
    }
}
