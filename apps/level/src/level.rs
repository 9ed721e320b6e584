//! A level ready to be drawn: surfaces as triangles, materials, textures.

use std::collections::HashMap;
use std::ops::Range;

use anyhow::{Result, bail};

use crate::assets::Assets;
use crate::bsp::{self, Bsp, FLAG_NODRAW, FLAG_SKY, Face, FaceKind, LIGHTMAP_SIDE};
use crate::entities;
use crate::math::{Vec3, dot};
use crate::patch;
use crate::picture::{Picture, Texture};
use crate::script::{self, Mode, Shader, Shaders};

/// How far patches may be from their curves, in units of the level (an inch).
const PATCH_ERROR: f32 = 2.0;

/// A vertex to be drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// Position.
    pub position: Vec3,
    /// Coordinates of the material's texture, in the board's units (256 along
    /// the longer side).
    pub st: [f32; 2],
    /// Coordinates of the lightmap, in the board's units.
    pub light: [f32; 2],
    /// Red, green, blue, 0 to 255.
    pub color: [f32; 3],
}

/// A material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Index of its texture.
    pub texture: usize,
    /// How it meets what is there.
    pub mode: Mode,
    /// Coloured by the vertices.
    pub vertex_color: bool,
    /// Both sides are seen.
    pub two_sided: bool,
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
    /// Sky and surfaces that are not drawn.
    pub hidden: usize,
    /// Billboards.
    pub billboards: usize,
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
            let surface = level.add_face(&bsp, face, &materials, pictures);
            level.surface_of.push(surface);
        }
        level.bsp = bsp;
        Ok(level)
    }

    /// The material of each shader of the file; `None` for what is not drawn.
    fn load_materials(
        &mut self,
        assets: &mut Assets,
        bsp: &Bsp,
        shaders: &Shaders,
        largest: usize,
    ) -> Vec<Option<(usize, Shader)>> {
        let mut pictures = HashMap::new();
        let mut out = Vec::new();
        for reference in &bsp.shaders {
            let shader = shader_of(shaders, reference);
            if shader.sky || shader.nodraw {
                out.push(None);
                continue;
            }
            let file = shader.map.clone().unwrap_or_else(|| reference.name.clone());
            let tested = matches!(shader.mode, Mode::Tested { .. });
            let key = (file.to_ascii_lowercase(), shader.clamp, tested);
            let texture = *pictures.entry(key).or_insert_with(|| {
                let picture = Picture::find(assets, &file).unwrap_or_else(|| {
                    self.skipped.missing_pictures += 1;
                    Picture::missing()
                });
                self.textures.push(Texture::new(&picture, largest, shader.clamp, tested));
                self.textures.len() - 1
            });
            let Shader { mode, vertex_color, two_sided, .. } = shader;
            self.materials.push(Material { texture, mode, vertex_color, two_sided });
            out.push(Some((self.materials.len() - 1, shader)));
        }
        out
    }

    fn add_face(
        &mut self,
        bsp: &Bsp,
        face: &Face,
        materials: &[Option<(usize, Shader)>],
        pictures: usize,
    ) -> Option<usize> {
        let Some((material, shader)) = &materials[face.shader] else {
            self.skipped.hidden += 1;
            return None;
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
            FaceKind::Billboard => {
                self.skipped.billboards += 1;
                return None;
            }
        };
        if vertices.is_empty() || corners.len() < 3 {
            return None;
        }
        let lightmap = face.lightmap.filter(|&index| index < bsp.lightmaps.len());
        let blended = matches!(shader.mode, Mode::Blended(..));
        let plane = (face.kind == FaceKind::Polygon && !shader.two_sided)
            .then(|| (face.normal, dot(face.normal, vertices[0].position)));
        self.add_surface(
            Surface {
                material: *material,
                lightmap: lightmap.filter(|_| !blended).map(|index| pictures + index),
                vertices: 0..0,
                corners: 0..0,
                bounds: bounds(&vertices),
                plane,
            },
            shader,
            &vertices,
            &corners,
        )
    }

    fn add_surface(
        &mut self,
        mut surface: Surface,
        shader: &Shader,
        vertices: &[bsp::Vertex],
        corners: &[u32],
    ) -> Option<usize> {
        let [es, et] = self.textures[self.materials[surface.material].texture].extent;
        let coordinates = |v: &bsp::Vertex| [v.st[0] * shader.scale[0], v.st[1] * shader.scale[1]];
        // Whole repetitions are taken off: small coordinates are exact ones.
        let least = |axis: usize| {
            let least = vertices.iter().map(|v| coordinates(v)[axis]).fold(f32::MAX, f32::min);
            if shader.clamp { 0.0 } else { least.floor() }
        };
        let (s0, t0) = (least(0), least(1));
        let start = self.vertices.len();
        self.vertices.extend(vertices.iter().map(|v| {
            let [s, t] = coordinates(v);
            let [r, g, b, _] = v.color;
            Vertex {
                position: v.position,
                st: [(s - s0) * es, (t - t0) * et],
                light: v.light.map(|c| c * 256.0),
                color: brighten([r, g, b]).map(f32::from),
            }
        }));
        surface.vertices = start..self.vertices.len();
        let start = self.corners.len();
        self.corners.extend_from_slice(&corners[..corners.len() / 3 * 3]);
        surface.corners = start..self.corners.len();
        self.surfaces.push(surface);
        Some(self.surfaces.len() - 1)
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
    let mut shader = known.unwrap_or(Shader { scale: [1.0; 2], ..Shader::default() });
    shader.sky |= reference.flags & FLAG_SKY != 0;
    shader.nodraw |= reference.flags & FLAG_NODRAW != 0;
    shader
}

fn bounds(vertices: &[bsp::Vertex]) -> [Vec3; 2] {
    let each = |start: f32, pick: fn(f32, f32) -> f32| {
        core::array::from_fn(|axis| vertices.iter().map(|v| v.position[axis]).fold(start, pick))
    };
    [each(f32::MAX, f32::min), each(f32::MIN, f32::max)]
}
