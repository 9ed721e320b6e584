//! A level ready to be drawn: surfaces as triangles, materials, textures.

use std::collections::HashMap;
use std::ops::Range;

use anyhow::{Result, bail};

use crate::assets::Assets;
use crate::bsp::{self, Bsp, FLAG_NODRAW, FLAG_SKY, Face, FaceKind, LIGHTMAP_SIDE};
use crate::entities;
use crate::math::{Vec3, add, dot, length, normalize, sub};
use crate::patch;
use crate::picture::{Picture, Texture};
use crate::script::{self, Deform, Gen, Mode, Move, Shader, Shaders, Sky, Source, Stage};
use crate::wave::Wave;

/// How far patches may be from their curves, in units of the level (an inch).
const PATCH_ERROR: f32 = 2.0;

/// A vertex to be drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// Position.
    pub position: Vec3,
    /// Coordinates of the material's pictures, 1 a repetition.
    pub st: [f32; 2],
    /// Coordinates of the lightmap, in the board's units.
    pub light: [f32; 2],
    /// Red, green, blue, 0 to 255.
    pub color: [f32; 3],
    /// 0 to 255.
    pub alpha: f32,
    /// Normal.
    pub normal: Vec3,
}

/// A stage of a material: see [`Stage`], with textures for pictures.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// Indices of its textures, shown in turn; none for the lightmap.
    pub textures: Vec<usize>,
    /// So many of them a second.
    pub frequency: f32,
    /// How it meets what is there.
    pub mode: Mode,
    /// Colour that it is multiplied with.
    pub color: Gen,
    /// Alpha that it is multiplied with.
    pub alpha: Gen,
    /// What moves its coordinates.
    pub moves: Vec<Move>,
    /// Coordinates are those of a reflection.
    pub environment: bool,
    /// It is multiplied with the lightmap.
    pub lit: bool,
}

impl Layer {
    /// The texture at a time in seconds; `None` for the lightmap.
    pub fn texture(&self, time: f32) -> Option<usize> {
        let count = self.textures.len().max(1);
        self.textures.get((time * self.frequency).max(0.0) as usize % count).copied()
    }
}

/// A material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its layers, at least one, the first one drawn first.
    pub layers: Vec<Layer>,
    /// What moves its vertices.
    pub deforms: Vec<Deform>,
    /// Both sides are seen.
    pub two_sided: bool,
}

impl Material {
    /// Whether what is behind it is seen through it.
    pub fn is_blended(&self) -> bool {
        matches!(self.layers[0].mode, Mode::Blended(..))
    }

    /// The texture that its surfaces are grouped by.
    pub fn texture(&self) -> usize {
        self.layers[0].textures.first().copied().unwrap_or(0)
    }
}

/// What is seen behind the level.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SkyMaterial {
    /// Six textures far away, in the order of [`crate::sky::SIDES`].
    pub far: Option<[usize; 6]>,
    /// Height of the clouds.
    pub height: f32,
    /// The clouds.
    pub clouds: Vec<Layer>,
}

/// A surface: triangles of one material and one lightmap.
#[derive(Clone, Debug)]
pub struct Surface {
    /// Index of its material.
    pub material: usize,
    /// Index of its lightmap's texture.
    pub lightmap: Option<usize>,
    /// Its vertices.
    pub vertices: Range<usize>,
    /// Its corners: offsets from the first vertex.
    pub corners: Range<usize>,
    /// Lowest and highest corner.
    pub bounds: [Vec3; 2],
    /// A flat surface's normal and distance; it is seen from in front only.
    pub plane: Option<(Vec3, f32)>,
}

/// What was left out, and why.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Skipped {
    /// Surfaces that are not drawn.
    pub hidden: usize,
    /// Patches whose grid is invalid.
    pub invalid: usize,
    /// Materials without a picture; they are drawn in grey.
    pub missing_pictures: usize,
}

/// A level.
#[derive(Debug, Default)]
pub struct Level {
    /// The file: tree and visibility.
    pub bsp: Bsp,
    /// The surface of each face, where it has one.
    pub surface_of: Vec<Option<usize>>,
    /// The sky that a face shows, and its bounds.
    pub sky_of: Vec<Option<(usize, [Vec3; 2])>>,
    /// The skies.
    pub skies: Vec<SkyMaterial>,
    /// Surfaces.
    pub surfaces: Vec<Surface>,
    /// Vertices of all surfaces.
    pub vertices: Vec<Vertex>,
    /// Corners of all surfaces.
    pub corners: Vec<u32>,
    /// Materials.
    pub materials: Vec<Material>,
    /// Pictures, then lightmaps.
    pub textures: Vec<Texture>,
    /// Where players start, and the direction they look, in degrees.
    pub spawns: Vec<(Vec3, f32)>,
    /// What is not drawn.
    pub skipped: Skipped,
}

/// Half the side of a billboard.
const BILLBOARD: f32 = 24.0;
/// The name of a picture that is white.
const WHITE: &str = "$whiteimage";

/// What a shader of the file is.
#[derive(Clone, Copy, Debug)]
enum Drawn {
    Nothing,
    Material(usize),
    Sky(usize),
}

/// Pictures on their way to textures.
struct Loader<'a> {
    assets: &'a mut Assets,
    largest: usize,
    /// Textures by picture, clamping and alpha test.
    known: HashMap<(String, bool, bool), usize>,
}

/// How far vertices move at most.
fn reach(deforms: &[Deform], vertices: &[bsp::Vertex]) -> f32 {
    let most = |wave: &Wave| wave.base.abs() + wave.amplitude.abs();
    let size = || {
        let [low, high] = bounds(vertices);
        length(sub(high, low))
    };
    let reaches = deforms.iter().map(|deform| match deform {
        Deform::Sprite | Deform::Axis => size(),
        Deform::Wave(_, wave) => most(wave),
        Deform::Bulge(_, height, _) => height.abs(),
        Deform::Move(way, wave) => length(*way) * most(wave),
    });
    reaches.sum()
}

/// Reads every script of a game.
fn scripts(assets: &mut Assets) -> Shaders {
    let mut shaders = Shaders::new();
    for name in assets.names("scripts/", ".shader") {
        if let Some(bytes) = assets.read(&name) {
            script::parse(&String::from_utf8_lossy(&bytes), &mut shaders);
        }
    }
    shaders
}

/// Light is stored at a quarter of its strength; too bright colours keep
/// their hue.
fn brighten([r, g, b]: [u8; 3]) -> [u8; 3] {
    let bright = [r, g, b].map(|c| u32::from(c) * 4);
    let top = bright[0].max(bright[1]).max(bright[2]).max(255);
    bright.map(|c| (c * 255 / top) as u8)
}

fn lightmap_texture(bytes: &[u8]) -> Texture {
    let pixels = bytes.as_chunks::<3>().0.iter().map(|&rgb| {
        let [r, g, b] = brighten(rgb);
        [r, g, b, 255]
    });
    let side = LIGHTMAP_SIDE;
    let picture = Picture { width: side, height: side, pixels: pixels.collect() };
    let mut texture = Texture::new(&picture, side, true, false);
    // Seen from near, and of smooth content: one level is enough.
    texture.data.truncate(side * side * 2);
    texture
}

impl Level {
    /// Loads a level and everything it shows. `largest` limits the sides of
    /// textures.
    ///
    /// # Errors
    /// Where the file is missing or invalid.
    pub fn load(assets: &mut Assets, name: &str, largest: usize) -> Result<Level> {
        let file = format!("maps/{name}.bsp");
        let Some(bytes) = assets.read(&file) else {
            bail!("there is no {file}; levels are: {}", level_names(assets).join(", "));
        };
        let bsp = Bsp::parse(&bytes)?;
        let shaders = scripts(assets);
        let spawns = entities::spawn_points(&entities::parse(&bsp.entities));
        let mut level = Level { spawns, ..Level::default() };
        let materials = level.load_materials(assets, &bsp, &shaders, largest);
        let pictures = level.textures.len();
        level.textures.extend(bsp.lightmaps.iter().map(|bytes| lightmap_texture(bytes)));
        for face in &bsp.faces {
            let (first, count) = face.vertices;
            let bounds = bounds(&bsp.vertices[first..first + count]);
            let sky = match materials[face.shader] {
                Drawn::Sky(sky) => Some((sky, bounds)),
                _ => None,
            };
            level.sky_of.push(sky);
            let surface = level.add_face(&bsp, face, &materials, pictures);
            level.surface_of.push(surface);
        }
        level.bsp = bsp;
        Ok(level)
    }

    /// What each shader of the file is.
    fn load_materials(
        &mut self,
        assets: &mut Assets,
        bsp: &Bsp,
        shaders: &Shaders,
        largest: usize,
    ) -> Vec<Drawn> {
        let mut loader = Loader { assets, largest, known: HashMap::new() };
        let mut out = Vec::new();
        for reference in &bsp.shaders {
            let shader = shader_of(shaders, reference);
            if let Some(sky) = &shader.sky {
                let sky = self.load_sky(&mut loader, sky, &shader.stages);
                self.skies.push(sky);
                out.push(Drawn::Sky(self.skies.len() - 1));
                continue;
            }
            if shader.nodraw {
                out.push(Drawn::Nothing);
                continue;
            }
            let mut layers = self.load_layers(&mut loader, &shader.stages);
            if layers.is_empty() {
                let picture = Shader::picture(&reference.name);
                layers = self.load_layers(&mut loader, &picture.stages);
            }
            let Shader { deforms, two_sided, .. } = shader;
            self.materials.push(Material { layers, deforms, two_sided });
            out.push(Drawn::Material(self.materials.len() - 1));
        }
        out
    }

    fn load_layers(&mut self, loader: &mut Loader<'_>, stages: &[Stage]) -> Vec<Layer> {
        let mut layers = Vec::new();
        for stage in stages {
            let tested = matches!(stage.mode, Mode::Tested { .. });
            let (textures, frequency) = match &stage.source {
                Source::Pictures(files, frequency) => {
                    let load = |file: &String| self.load_texture(loader, file, stage.clamp, tested);
                    (files.iter().map(load).collect(), *frequency)
                }
                Source::White => (vec![self.load_texture(loader, WHITE, false, false)], 0.0),
                Source::Lightmap => (Vec::new(), 0.0),
                Source::None => continue,
            };
            let Stage { mode, color, alpha, environment, lit, .. } = *stage;
            let moves = stage.moves.clone();
            layers.push(Layer { textures, frequency, mode, color, alpha, moves, environment, lit });
        }
        layers
    }

    fn load_sky(&mut self, loader: &mut Loader<'_>, sky: &Sky, stages: &[Stage]) -> SkyMaterial {
        let far = sky.far.as_ref().and_then(|name| {
            let mut sides = [0; 6];
            for (side, suffix) in sides.iter_mut().zip(crate::sky::SIDES) {
                let file = format!("{name}_{suffix}");
                Picture::find(loader.assets, &file)?;
                *side = self.load_texture(loader, &file, true, false);
            }
            Some(sides)
        });
        SkyMaterial { far, height: sky.clouds, clouds: self.load_layers(loader, stages) }
    }

    /// The texture of a picture.
    fn load_texture(
        &mut self,
        loader: &mut Loader<'_>,
        file: &str,
        clamp: bool,
        tested: bool,
    ) -> usize {
        let key = (file.to_ascii_lowercase(), clamp, tested);
        if let Some(&texture) = loader.known.get(&key) {
            return texture;
        }
        let picture = match file {
            WHITE => Picture { width: 8, height: 8, pixels: vec![[255; 4]; 64] },
            _ => Picture::find(loader.assets, file).unwrap_or_else(|| {
                self.skipped.missing_pictures += 1;
                Picture::missing()
            }),
        };
        self.textures.push(Texture::new(&picture, loader.largest, clamp, tested));
        loader.known.insert(key, self.textures.len() - 1);
        self.textures.len() - 1
    }

    fn add_face(
        &mut self,
        bsp: &Bsp,
        face: &Face,
        materials: &[Drawn],
        pictures: usize,
    ) -> Option<usize> {
        let material = match materials[face.shader] {
            Drawn::Material(material) => material,
            Drawn::Sky(_) => return None,
            Drawn::Nothing => {
                self.skipped.hidden += 1;
                return None;
            }
        };
        let (first, count) = face.vertices;
        let points = &bsp.vertices[first..first + count];
        let (vertices, corners) = match face.kind {
            FaceKind::Polygon | FaceKind::Mesh => {
                let (first, count) = face.triangles;
                let offsets = &bsp.mesh_vertices[first..first + count];
                if offsets.iter().any(|&offset| offset >= points.len()) {
                    self.skipped.invalid += 1;
                    return None;
                }
                (points.to_vec(), offsets.iter().map(|&offset| offset as u32).collect())
            }
            FaceKind::Patch(width, height) => {
                match patch::tessellate(points, width, height, PATCH_ERROR) {
                    Some(mesh) => mesh,
                    None => {
                        self.skipped.invalid += 1;
                        return None;
                    }
                }
            }
            FaceKind::Billboard => return Some(self.add_billboard(face, material)),
        };
        if vertices.is_empty() || corners.len() < 3 {
            return None;
        }
        let lightmap = face.lightmap.filter(|&index| index < bsp.lightmaps.len());
        let Material { two_sided, ref deforms, .. } = self.materials[material];
        let plane = (face.kind == FaceKind::Polygon && !two_sided && deforms.is_empty())
            .then(|| (face.normal, dot(face.normal, vertices[0].position)));
        let reach = reach(deforms, &vertices);
        let bounds = bounds(&vertices);
        let surface = Surface {
            material,
            lightmap: lightmap.map(|index| pictures + index),
            vertices: 0..0,
            corners: 0..0,
            bounds: [bounds[0].map(|v| v - reach), bounds[1].map(|v| v + reach)],
            plane,
        };
        Some(self.add_surface(surface, &vertices, &corners))
    }

    /// A square that turns to the viewer and adds light of the face's colour.
    fn add_billboard(&mut self, face: &Face, material: usize) -> usize {
        let mut sprite = self.materials[material].clone();
        (sprite.deforms, sprite.two_sided) = (vec![Deform::Sprite], true);
        sprite.layers.truncate(1);
        (sprite.layers[0].color, sprite.layers[0].mode) = (Gen::Vertex, Mode::Blended(4, 4));
        sprite.layers[0].lit = false;
        self.materials.push(sprite);
        let (center, color) = face.billboard;
        // As bright as light is stored: a quarter.
        let [r, g, b] = color.map(|c| (c.clamp(0.0, 1.0) * 63.0) as u8);
        let corner = |[s, t]: [f32; 2]| {
            let out = [s * 2.0 - 1.0, 0.0, 1.0 - t * 2.0].map(|v| v * BILLBOARD);
            let position = add(center, out);
            bsp::Vertex { position, st: [s, t], color: [r, g, b, 255], ..bsp::Vertex::default() }
        };
        let vertices = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(corner);
        let far = BILLBOARD * 1.5;
        let surface = Surface {
            material: self.materials.len() - 1,
            lightmap: None,
            vertices: 0..0,
            corners: 0..0,
            bounds: [center.map(|v| v - far), center.map(|v| v + far)],
            plane: None,
        };
        self.add_surface(surface, &vertices, &[0, 1, 2, 0, 2, 3])
    }

    fn add_surface(
        &mut self,
        mut surface: Surface,
        vertices: &[bsp::Vertex],
        corners: &[u32],
    ) -> usize {
        let start = self.vertices.len();
        self.vertices.extend(vertices.iter().map(|v| {
            let [r, g, b, a] = v.color;
            Vertex {
                position: v.position,
                st: v.st,
                light: v.light.map(|c| c * 256.0),
                color: brighten([r, g, b]).map(f32::from),
                alpha: f32::from(a),
                normal: normalize(v.normal, [0.0, 0.0, 1.0]),
            }
        }));
        surface.vertices = start..self.vertices.len();
        let start = self.corners.len();
        self.corners.extend_from_slice(&corners[..corners.len() / 3 * 3]);
        surface.corners = start..self.corners.len();
        self.surfaces.push(surface);
        self.surfaces.len() - 1
    }

    /// Triangles of all surfaces.
    pub fn triangle_count(&self) -> usize {
        self.corners.len() / 3
    }
}

/// Names of all levels.
pub fn level_names(assets: &Assets) -> Vec<String> {
    let name = |file: &String| file["maps/".len()..file.len() - ".bsp".len()].to_string();
    assets.names("maps/", ".bsp").iter().map(name).collect()
}

/// What a script says of a material, or else its picture as it is.
fn shader_of(shaders: &Shaders, reference: &bsp::ShaderRef) -> Shader {
    let known = shaders.get(&reference.name.to_ascii_lowercase()).cloned();
    let mut shader = known.unwrap_or_else(|| Shader::picture(&reference.name));
    if reference.flags & FLAG_SKY != 0 {
        shader.sky.get_or_insert_default();
    }
    shader.nodraw |= reference.flags & FLAG_NODRAW != 0;
    shader
}

fn bounds(vertices: &[bsp::Vertex]) -> [Vec3; 2] {
    let each = |start: f32, pick: fn(f32, f32) -> f32| {
        core::array::from_fn(|axis| vertices.iter().map(|v| v.position[axis]).fold(start, pick))
    };
    [each(f32::MAX, f32::min), each(f32::MIN, f32::max)]
}
