//! Level files of version 46: a header, and seventeen tables ("lumps").
//!
//! Source: the format as public descriptions give it. Everything read is
//! checked; a reference beyond a table makes the file invalid where drawing
//! would follow it.

use anyhow::{Result, bail};

use crate::math::{Vec3, dot};

/// Texels on a side of a lightmap.
pub const LIGHTMAP_SIDE: usize = 128;
/// Bytes of a lightmap: red, green, blue.
pub const LIGHTMAP_BYTES: usize = LIGHTMAP_SIDE * LIGHTMAP_SIDE * 3;

/// Lump numbers, in file order.
pub mod lump {
    #![allow(missing_docs)]
    pub const ENTITIES: usize = 0;
    pub const SHADERS: usize = 1;
    pub const PLANES: usize = 2;
    pub const NODES: usize = 3;
    pub const LEAFS: usize = 4;
    pub const LEAF_FACES: usize = 5;
    pub const LEAF_BRUSHES: usize = 6;
    pub const MODELS: usize = 7;
    pub const BRUSHES: usize = 8;
    pub const BRUSH_SIDES: usize = 9;
    pub const VERTICES: usize = 10;
    pub const MESH_VERTICES: usize = 11;
    pub const FACES: usize = 13;
    pub const LIGHTMAPS: usize = 14;
    pub const VISIBILITY: usize = 16;
    pub const COUNT: usize = 17;
}

/// A surface's material, by name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ShaderRef {
    /// Path without extension.
    pub name: String,
    /// Surface flags.
    pub flags: u32,
    /// What is inside.
    pub contents: u32,
}

/// Contents through which players do not go: what is solid, and clips.
const CONTENTS_SOLID: u32 = 0x1_0001;
/// Surface flag: the sky.
pub const FLAG_SKY: u32 = 0x4;
/// Surface flag: not drawn.
pub const FLAG_NODRAW: u32 = 0x80;

/// A vertex as the file has it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vertex {
    /// Position.
    pub position: Vec3,
    /// Texture coordinates, 1 a repetition.
    pub st: [f32; 2],
    /// Lightmap coordinates, 0 to 1.
    pub light: [f32; 2],
    /// Normal.
    pub normal: Vec3,
    /// Red, green, blue, alpha.
    pub color: [u8; 4],
}

/// What a face is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaceKind {
    /// A convex polygon, with triangles given.
    Polygon,
    /// Quadratic Bezier patches: a grid of control points of this width and
    /// height, both odd.
    Patch(usize, usize),
    /// Triangles.
    Mesh,
    /// A picture that turns to the viewer.
    Billboard,
}

/// A face.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// Index of its shader.
    pub shader: usize,
    /// What it is.
    pub kind: FaceKind,
    /// First vertex and count.
    pub vertices: (usize, usize),
    /// First mesh vertex and count: triangles as offsets from the first vertex.
    pub triangles: (usize, usize),
    /// Lightmap, where there is one.
    pub lightmap: Option<usize>,
    /// Normal of a polygon.
    pub normal: Vec3,
    /// Where a billboard is, and its red, green and blue, 0 to 1.
    pub billboard: (Vec3, Vec3),
}

/// A node: a plane and what lies on both sides of it.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    plane: usize,
    children: [Child; 2],
}

#[derive(Clone, Copy, Debug)]
enum Child {
    Node(usize),
    Leaf(usize),
}

/// A leaf: a convex part of the level.
#[derive(Clone, Copy, Debug)]
pub struct Leaf {
    /// Its row and column in the visibility table; `None` in solid parts.
    pub cluster: Option<usize>,
    /// Lowest corner.
    pub low: Vec3,
    /// Highest corner.
    pub high: Vec3,
    faces: (usize, usize),
    brushes: (usize, usize),
}

/// A level file.
#[derive(Debug, Default)]
pub struct Bsp {
    /// The entities' text.
    pub entities: String,
    /// Materials.
    pub shaders: Vec<ShaderRef>,
    planes: Vec<(Vec3, f32)>,
    nodes: Vec<Node>,
    /// Leaves.
    pub leafs: Vec<Leaf>,
    leaf_faces: Vec<usize>,
    leaf_brushes: Vec<usize>,
    /// Convex bodies: first side, count, shader.
    brushes: Vec<(usize, usize, usize)>,
    /// The plane of each side.
    brush_sides: Vec<usize>,
    /// Vertices.
    pub vertices: Vec<Vertex>,
    /// Offsets of triangles' corners.
    pub mesh_vertices: Vec<usize>,
    /// Faces.
    pub faces: Vec<Face>,
    /// Faces of the level itself; those after belong to doors and the like.
    pub world_faces: usize,
    /// Lightmaps, [`LIGHTMAP_BYTES`] each.
    pub lightmaps: Vec<Vec<u8>>,
    /// Bytes of a row, and the rows.
    visibility: Option<(usize, Vec<u8>)>,
}

/// A record of a lump, read field by field.
struct Record<'a>(&'a [u8]);

impl Record<'_> {
    fn word(&self, at: usize) -> u32 {
        let bytes = self.0.get(at * 4..at * 4 + 4);
        bytes.map_or(0, |b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]))
    }

    fn int(&self, at: usize) -> i32 {
        self.word(at) as i32
    }

    /// A count or index; negative ones are too large for any table.
    fn index(&self, at: usize) -> usize {
        usize::try_from(self.int(at)).unwrap_or(usize::MAX / 4)
    }

    /// A finite number.
    fn float(&self, at: usize) -> f32 {
        let value = f32::from_bits(self.word(at));
        if value.is_finite() { value.clamp(-1e6, 1e6) } else { 0.0 }
    }

    fn floats<const N: usize>(&self, at: usize) -> [f32; N] {
        core::array::from_fn(|i| self.float(at + i))
    }

    fn ints(&self, at: usize) -> Vec3 {
        core::array::from_fn(|i| self.int(at + i) as f32)
    }
}

/// The bytes of a lump.
fn lump_of(bytes: &[u8], index: usize) -> Result<&[u8]> {
    let header = Record(bytes.get(8..).unwrap_or_default());
    let (start, length) = (header.index(index * 2), header.index(index * 2 + 1));
    match bytes.get(start..start.saturating_add(length)) {
        Some(lump) => Ok(lump),
        None => bail!("table {index} lies beyond the end of the file"),
    }
}

fn records<T>(lump: &[u8], size: usize, read: impl Fn(Record<'_>) -> T) -> Vec<T> {
    lump.chunks_exact(size).map(|bytes| read(Record(bytes))).collect()
}

fn text(bytes: &[u8]) -> String {
    let end = bytes.iter().position(|&b| b == 0).unwrap_or(bytes.len());
    String::from_utf8_lossy(&bytes[..end]).into_owned()
}

fn child(value: i32) -> Child {
    match usize::try_from(value) {
        Ok(node) => Child::Node(node),
        Err(_) => Child::Leaf(!value as usize),
    }
}

fn face(r: Record<'_>) -> Face {
    let size = (r.index(24), r.index(25));
    Face {
        shader: r.index(0),
        kind: match r.int(2) {
            1 => FaceKind::Polygon,
            2 => FaceKind::Patch(size.0, size.1),
            3 => FaceKind::Mesh,
            _ => FaceKind::Billboard,
        },
        vertices: (r.index(3), r.index(4)),
        triangles: (r.index(5), r.index(6)),
        lightmap: usize::try_from(r.int(7)).ok(),
        normal: r.floats(21),
        billboard: (r.floats(12), r.floats(15)),
    }
}

impl Bsp {
    /// Reads a level.
    ///
    /// # Errors
    /// For files of another kind or version, and references beyond tables.
    pub fn parse(bytes: &[u8]) -> Result<Bsp> {
        if bytes.get(..4) != Some(b"IBSP") || Record(bytes).word(1) != 46 {
            bail!("this is no level of version 46");
        }
        let lump = |index| lump_of(bytes, index);
        let mut bsp = Bsp {
            entities: text(lump(lump::ENTITIES)?),
            shaders: records(lump(lump::SHADERS)?, 72, |r| ShaderRef {
                name: text(&r.0[..64]),
                flags: r.word(16),
                contents: r.word(17),
            }),
            planes: records(lump(lump::PLANES)?, 16, |r| (r.floats(0), r.float(3))),
            nodes: records(lump(lump::NODES)?, 36, |r| Node {
                plane: r.index(0),
                children: [child(r.int(1)), child(r.int(2))],
            }),
            leafs: records(lump(lump::LEAFS)?, 48, |r| Leaf {
                cluster: usize::try_from(r.int(0)).ok(),
                low: r.ints(2),
                high: r.ints(5),
                faces: (r.index(8), r.index(9)),
                brushes: (r.index(10), r.index(11)),
            }),
            leaf_faces: records(lump(lump::LEAF_FACES)?, 4, |r| r.index(0)),
            leaf_brushes: records(lump(lump::LEAF_BRUSHES)?, 4, |r| r.index(0)),
            brushes: records(lump(lump::BRUSHES)?, 12, |r| (r.index(0), r.index(1), r.index(2))),
            brush_sides: records(lump(lump::BRUSH_SIDES)?, 8, |r| r.index(0)),
            vertices: records(lump(lump::VERTICES)?, 44, |r| Vertex {
                position: r.floats(0),
                st: r.floats(3),
                light: r.floats(5),
                normal: r.floats(7),
                color: r.word(10).to_le_bytes(),
            }),
            mesh_vertices: records(lump(lump::MESH_VERTICES)?, 4, |r| r.index(0)),
            faces: records(lump(lump::FACES)?, 104, face),
            lightmaps: lump(lump::LIGHTMAPS)?
                .chunks_exact(LIGHTMAP_BYTES)
                .map(<[u8]>::to_vec)
                .collect(),
            world_faces: 0,
            visibility: visibility(lump(lump::VISIBILITY)?),
        };
        let world = records(lump(lump::MODELS)?, 40, |r| (r.index(6), r.index(7)));
        bsp.world_faces = match world.first() {
            Some(&(first, count)) => first.saturating_add(count).min(bsp.faces.len()),
            None => bsp.faces.len(),
        };
        bsp.validate()?;
        Ok(bsp)
    }

    fn validate(&self) -> Result<()> {
        let inside = |(first, count): (usize, usize), len: usize| {
            first.checked_add(count).is_some_and(|end| end <= len)
        };
        for (i, face) in self.faces.iter().enumerate() {
            let known = face.shader < self.shaders.len()
                && inside(face.vertices, self.vertices.len())
                && inside(face.triangles, self.mesh_vertices.len());
            if !known {
                bail!("face {i} refers beyond a table");
            }
        }
        for (i, node) in self.nodes.iter().enumerate() {
            let children = node.children.iter().all(|child| match *child {
                // Children come after their parents, so that a walk ends.
                Child::Node(node) => node > i && node < self.nodes.len(),
                Child::Leaf(leaf) => leaf < self.leafs.len(),
            });
            if node.plane >= self.planes.len() || !children {
                bail!("node {i} refers beyond a table");
            }
        }
        let leafs = self.leafs.iter().all(|leaf| inside(leaf.faces, self.leaf_faces.len()));
        if !leafs || self.leaf_faces.iter().any(|&face| face >= self.faces.len()) {
            bail!("a leaf refers beyond a table");
        }
        let bodies = self.brushes.iter().all(|&(first, count, shader)| {
            inside((first, count), self.brush_sides.len()) && shader < self.shaders.len()
        });
        let sides = self.brush_sides.iter().all(|&plane| plane < self.planes.len());
        let leafs = self.leafs.iter().all(|leaf| inside(leaf.brushes, self.leaf_brushes.len()));
        let brushes = self.leaf_brushes.iter().all(|&brush| brush < self.brushes.len());
        if !(bodies && sides && leafs && brushes) {
            bail!("a body refers beyond a table");
        }
        Ok(())
    }

    /// The leaf that holds a point.
    pub fn leaf_at(&self, point: Vec3) -> Option<&Leaf> {
        let mut at = match self.nodes.is_empty() {
            true => Child::Leaf(0),
            false => Child::Node(0),
        };
        loop {
            match at {
                Child::Leaf(leaf) => return self.leafs.get(leaf),
                Child::Node(node) => {
                    let node = &self.nodes[node];
                    let (normal, distance) = self.planes[node.plane];
                    at = node.children[usize::from(dot(normal, point) < distance)];
                }
            }
        }
    }

    /// Whether a point is outside the level or inside something solid.
    pub fn is_solid(&self, point: Vec3) -> bool {
        let Some(leaf) = self.leaf_at(point) else { return true };
        if leaf.cluster.is_none() {
            return true;
        }
        let (first, count) = leaf.brushes;
        self.leaf_brushes[first..first + count].iter().any(|&brush| {
            let (first, count, shader) = self.brushes[brush];
            let mut sides = self.brush_sides[first..first + count].iter();
            count > 0
                && self.shaders[shader].contents & CONTENTS_SOLID != 0
                && sides.all(|&plane| {
                    let (normal, distance) = self.planes[plane];
                    dot(normal, point) <= distance
                })
        })
    }

    /// The faces of a leaf.
    pub fn leaf_faces(&self, leaf: &Leaf) -> &[usize] {
        &self.leaf_faces[leaf.faces.0..leaf.faces.0 + leaf.faces.1]
    }

    /// Whether something in cluster `to` can be seen from cluster `from`.
    /// Without a table, or from solid parts, everything can.
    pub fn sees(&self, from: Option<usize>, to: usize) -> bool {
        let (Some((row, bits)), Some(from)) = (&self.visibility, from) else { return true };
        match from.checked_mul(*row).and_then(|start| bits.get(start + to / 8)) {
            Some(byte) => byte >> (to % 8) & 1 != 0,
            None => true,
        }
    }
}

fn visibility(lump: &[u8]) -> Option<(usize, Vec<u8>)> {
    let row = Record(lump).index(1);
    let bits = lump.get(8..)?;
    (row > 0 && !bits.is_empty()).then(|| (row, bits.to_vec()))
}
