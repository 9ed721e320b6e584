//! A small level made here: three rooms with doorways, a pillar of patches, a
//! mesh, a grating, a glow, sky, lightmaps and visibility. It is the level
//! that is shown without any game installed, and the one tests draw.

use crate::assets::Assets;
use crate::bsp::{LIGHTMAP_BYTES, LIGHTMAP_SIDE, lump};
use crate::math::{Vec3, add, cross, dot, length, mix, normalize, scale, sub};

/// The level's name.
pub const NAME: &str = "builtin";

const SCRIPT: &str = "
synth/grate
{
    cull none
    {
        map synth/grate.tga
        alphaFunc GE128
    }
    {
        map $lightmap
        blendFunc filter
    }
}
synth/glow
{
    cull none
    {
        clampmap synth/glow.tga
        blendFunc add
        rgbGen wave sin 0.8 0.2 0 0.5
        tcMod stretch sin 1 0.1 0 0.5
    }
}
synth/metal
{
    {
        map $lightmap
    }
    {
        map synth/metal.tga
        blendFunc filter
    }
    {
        map synth/shine.tga
        blendFunc add
        tcGen environment
        rgbGen const ( 0.5 0.5 0.5 )
    }
}
synth/sky
{
    surfaceparm sky
    skyparms - 512 -
    {
        map synth/cloud.tga
        tcMod scale 2 2
        tcMod scroll 0.02 0.01
    }
    {
        map synth/cloud.tga
        blendFunc add
        tcMod scale 3 3
        tcMod scroll 0.05 0.02
        rgbGen const ( 0.4 0.35 0.3 )
    }
}
synth/hidden
{
    surfaceparm nodraw
}
";

/// Materials in the order of the file's table.
const MATERIALS: [&str; 8] =
    ["brick", "tile", "plaster", "metal", "grate", "glow", "sky", "hidden"];
const BRICK: i32 = 0;
const TILE: i32 = 1;
const PLASTER: i32 = 2;
const METAL: i32 = 3;
const GRATE: i32 = 4;
const GLOW: i32 = 5;
const SKY: i32 = 6;
const HIDDEN: i32 = 7;

/// Height of the rooms.
const TOP: f32 = 256.0;
/// Light sources: position and strength.
const LIGHTS: [(Vec3, Vec3); 4] = [
    ([-256.0, 0.0, 200.0], [1.0, 0.85, 0.6]),
    ([256.0, 160.0, 180.0], [0.5, 0.7, 1.0]),
    ([256.0, -160.0, 180.0], [1.0, 0.4, 0.3]),
    ([768.0, 0.0, 220.0], [0.9, 1.0, 0.8]),
];

/// The files of a game with one level.
pub fn assets() -> Assets {
    let mut assets = Assets::default();
    assets.insert(&format!("maps/{NAME}.bsp"), level());
    assets.insert("scripts/synth.shader", SCRIPT.into());
    for (name, picture) in [
        ("brick", brick as fn(usize, usize) -> [u8; 4]),
        ("tile", tile),
        ("plaster", plaster),
        ("metal", metal),
        ("grate", grate),
        ("glow", glow),
        ("cloud", cloud),
        ("shine", shine),
    ] {
        assets.insert(&format!("synth/{name}.tga"), tga(picture));
    }
    assets
}

/// The light that falls on a point of a surface, 0 to 255.
fn light_at(point: Vec3, normal: Vec3) -> [u8; 3] {
    let mut sum = [0.12f32; 3];
    for (at, color) in LIGHTS {
        let way = sub(at, point);
        let angle = dot(normalize(way, normal), normal).max(0.0);
        let strength = angle * 60_000.0 / (length(way).powi(2) + 8_000.0);
        sum = add(sum, scale(color, strength));
    }
    sum.map(|c| (c * 255.0).min(255.0) as u8)
}

/// The tables of a level file while they are made.
#[derive(Default)]
struct Builder {
    vertices: Vec<u8>,
    vertex_count: usize,
    mesh_vertices: Vec<u8>,
    mesh_count: usize,
    faces: Vec<u8>,
    face_count: usize,
    /// Faces of each room.
    rooms: [Vec<i32>; 3],
    lightmaps: Vec<u8>,
    blocks: usize,
}

fn put(out: &mut Vec<u8>, words: &[i32]) {
    words.iter().for_each(|word| out.extend(word.to_le_bytes()));
}

fn put_floats(out: &mut Vec<u8>, values: &[f32]) {
    values.iter().for_each(|value| out.extend(value.to_le_bytes()));
}

/// Side of a surface's part of a lightmap.
const BLOCK: usize = 32;
const BLOCKS_ACROSS: usize = LIGHTMAP_SIDE / BLOCK;

impl Builder {
    fn vertex(&mut self, at: Vec3, st: [f32; 2], light: [f32; 2], normal: Vec3) {
        put_floats(&mut self.vertices, &at);
        put_floats(&mut self.vertices, &st);
        put_floats(&mut self.vertices, &light);
        put_floats(&mut self.vertices, &normal);
        let [r, g, b] = light_at(at, normal).map(|c| c / 4);
        self.vertices.extend([r, g, b, 255]);
        self.vertex_count += 1;
    }

    /// Adds a face over the vertices since `first`.
    fn face(
        &mut self,
        room: usize,
        (material, kind): (i32, i32),
        first: usize,
        corners: &[i32],
        lightmap: i32,
        normal: Vec3,
        size: [i32; 2],
    ) {
        let count = (self.vertex_count - first) as i32;
        let first_corner = self.mesh_count as i32;
        put(&mut self.mesh_vertices, corners);
        self.mesh_count += corners.len();
        let words = [material, -1, kind, first as i32, count, first_corner, corners.len() as i32];
        put(&mut self.faces, &words);
        put(&mut self.faces, &[lightmap, 0, 0, 0, 0]);
        put_floats(&mut self.faces, &[0.0; 9]);
        put_floats(&mut self.faces, &normal);
        put(&mut self.faces, &size);
        self.rooms[room].push(self.face_count as i32);
        self.face_count += 1;
    }

    /// A part of a lightmap, lit by `light` at places 0..1 across and down:
    /// the lightmap's number, and where place (u, v) is in it.
    fn light_block(
        &mut self,
        light: &dyn Fn(f32, f32) -> [u8; 3],
    ) -> (i32, impl Fn(f32, f32) -> [f32; 2] + use<>) {
        let (map, block) = (self.blocks / BLOCKS_ACROSS.pow(2), self.blocks % BLOCKS_ACROSS.pow(2));
        self.blocks += 1;
        self.lightmaps.resize((map + 1) * LIGHTMAP_BYTES, 0);
        let (x0, y0) = (block % BLOCKS_ACROSS * BLOCK, block / BLOCKS_ACROSS * BLOCK);
        for y in 0..BLOCK {
            for x in 0..BLOCK {
                let place = |i: usize| i as f32 / (BLOCK - 1) as f32;
                let at = map * LIGHTMAP_BYTES + ((y0 + y) * LIGHTMAP_SIDE + x0 + x) * 3;
                let rgb = light(place(x), place(y)).map(|c| c / 4);
                self.lightmaps[at..at + 3].copy_from_slice(&rgb);
            }
        }
        let side = LIGHTMAP_SIDE as f32;
        let inside =
            move |start: usize, t: f32| (start as f32 + 0.5 + t * (BLOCK - 1) as f32) / side;
        (map as i32, move |u, v| [inside(x0, u), inside(y0, v)])
    }

    /// A rectangle from `at` along `u` and `v`, seen from the side where u
    /// turns to v against the clock.
    fn wall(&mut self, room: usize, material: i32, at: Vec3, u: Vec3, v: Vec3) {
        let normal = normalize(cross(u, v), [0.0, 0.0, 1.0]);
        let place = |s: f32, t: f32| add(at, add(scale(u, s), scale(v, t)));
        let (map, light) = self.light_block(&|s, t| light_at(place(s, t), normal));
        let first = self.vertex_count;
        let repeat =
            if material == GLOW { [1.0, 1.0] } else { [length(u) / 128.0, length(v) / 128.0] };
        for (s, t) in [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)] {
            self.vertex(place(s, t), [s * repeat[0], (1.0 - t) * repeat[1]], light(s, t), normal);
        }
        self.face(room, (material, 1), first, &[0, 1, 2, 0, 2, 3], map, normal, [0; 2]);
    }

    /// Half of an upright cylinder as a patch of 5 x 3 control points.
    fn half_pillar(&mut self, room: usize, center: Vec3, radius: f32, turn: f32) {
        let around = [[-1.0, 0.0], [-1.0, 1.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0f32]];
        let out = |i: usize| [around[i][0] * turn, around[i][1] * turn, 0.0];
        let (low, high) = (center, add(center, [0.0, 0.0, TOP]));
        let (map, light) = self.light_block(&|s, t| {
            let angle = s * core::f32::consts::PI;
            let normal = [-angle.cos() * turn, angle.sin() * turn, 0.0];
            light_at(add(mix(high, low, t), scale(normal, radius)), normal)
        });
        let first = self.vertex_count;
        for row in 0..3 {
            let t = row as f32 / 2.0;
            for i in 0..5 {
                let s = i as f32 / 4.0;
                let at = add(mix(high, low, t), scale(out(i), radius));
                self.vertex(
                    at,
                    [s * 2.0, t * 2.0],
                    light(s, t),
                    normalize(out(i), [1.0, 0.0, 0.0]),
                );
            }
        }
        self.face(room, (METAL, 2), first, &[], map, [0.0; 3], [5, 3]);
    }

    /// A pyramid, lit at its vertices.
    fn pyramid(&mut self, room: usize, center: Vec3, size: f32, height: f32) {
        let first = self.vertex_count;
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0f32]];
        for [x, y] in corners {
            let normal = normalize([x, y, 0.5], [0.0, 0.0, 1.0]);
            let at = add(center, [x * size, y * size, 0.0]);
            self.vertex(at, [x, y], [0.0; 2], normal);
        }
        self.vertex(add(center, [0.0, 0.0, height]), [0.0, 0.0], [0.0; 2], [0.0, 0.0, 1.0]);
        let sides = [0, 4, 1, 1, 4, 2, 2, 4, 3, 3, 4, 0];
        self.face(room, (PLASTER, 3), first, &sides, -1, [0.0; 3], [0; 2]);
    }
}

/// Floor, ceiling and outer walls of the room between x0 and x1.
fn room(b: &mut Builder, index: usize, x0: f32, x1: f32) {
    let w = x1 - x0;
    let ceiling = if index == 2 { SKY } else { PLASTER };
    b.wall(index, TILE, [x0, -256.0, 0.0], [w, 0.0, 0.0], [0.0, 512.0, 0.0]);
    b.wall(index, ceiling, [x0, 256.0, TOP], [w, 0.0, 0.0], [0.0, -512.0, 0.0]);
    b.wall(index, BRICK, [x0, 256.0, 0.0], [w, 0.0, 0.0], [0.0, 0.0, TOP]);
    b.wall(index, BRICK, [x1, -256.0, 0.0], [-w, 0.0, 0.0], [0.0, 0.0, TOP]);
    if index == 0 {
        b.wall(index, BRICK, [x0, -256.0, 0.0], [0.0, 512.0, 0.0], [0.0, 0.0, TOP]);
    }
    if index == 2 {
        b.wall(index, BRICK, [x1, 256.0, 0.0], [0.0, -512.0, 0.0], [0.0, 0.0, TOP]);
    }
}

/// A wall at x with a doorway in the middle; seen from +x or -x.
fn doorway(b: &mut Builder, index: usize, x: f32, sign: f32) {
    let y = |v: f32| v * sign;
    let up = |z: f32| [0.0, 0.0, z];
    b.wall(index, BRICK, [x, y(-256.0), 0.0], [0.0, y(192.0), 0.0], up(TOP));
    b.wall(index, BRICK, [x, y(64.0), 0.0], [0.0, y(192.0), 0.0], up(TOP));
    b.wall(index, BRICK, [x, y(-64.0), 128.0], [0.0, y(128.0), 0.0], up(TOP - 128.0));
}

fn entities() -> String {
    let mut text = "{\n\"classname\" \"worldspawn\"\n}\n".to_string();
    for (x, y, angle) in [
        (-400, -120, 0),
        (-150, 100, 0),
        (160, 0, 0),
        (400, 100, 0),
        (700, -100, 90),
        (820, 120, 180),
    ] {
        text += &format!(
            "{{\n\"classname\" \"info_player_deathmatch\"\n\"origin\" \"{x} {y} 40\"\n\"angle\" \"{angle}\"\n}}\n"
        );
    }
    text
}

/// The level file.
pub fn level() -> Vec<u8> {
    let mut b = Builder::default();
    for (index, (x0, x1)) in [(-512.0, 0.0), (0.0, 512.0), (512.0, 1024.0)].into_iter().enumerate()
    {
        room(&mut b, index, x0, x1);
    }
    doorway(&mut b, 0, 0.0, -1.0);
    doorway(&mut b, 1, 0.0, 1.0);
    doorway(&mut b, 1, 512.0, -1.0);
    doorway(&mut b, 2, 512.0, 1.0);
    b.half_pillar(1, [256.0, 0.0, 0.0], 40.0, 1.0);
    b.half_pillar(1, [256.0, 0.0, 0.0], 40.0, -1.0);
    b.pyramid(2, [768.0, 0.0, 0.0], 64.0, 120.0);
    b.wall(2, GRATE, [530.0, -64.0, 0.0], [0.0, 128.0, 0.0], [0.0, 0.0, 128.0]);
    b.wall(0, GLOW, [-300.0, 40.0, 60.0], [0.0, -80.0, 0.0], [0.0, 0.0, 80.0]);
    b.wall(0, HIDDEN, [-400.0, 0.0, 0.0], [0.0, 64.0, 0.0], [0.0, 0.0, 64.0]);
    let first = b.vertex_count;
    b.vertex([0.0, 0.0, 90.0], [0.0; 2], [0.0; 2], [0.0, 0.0, 1.0]);
    b.face(1, (GLOW, 4), first, &[], -1, [0.0; 3], [0; 2]);
    // Where it is, and its colour.
    let mut billboard = Vec::new();
    put_floats(&mut billboard, &[256.0, 160.0, 180.0, 0.5, 0.7, 1.0]);
    let at = b.faces.len() - 104 + 12 * 4;
    b.faces[at..at + billboard.len()].copy_from_slice(&billboard);
    file(&b)
}

/// What is solid in each room: boxes, as lowest and highest corner. Floors and
/// ceilings, outer walls, and the walls around doorways.
fn boxes(room: usize) -> Vec<[Vec3; 2]> {
    let x0 = -512.0 + 512.0 * room as f32;
    let x1 = x0 + 512.0;
    let mut out = vec![
        [[x0, -256.0, -16.0], [x1, 256.0, 0.0]],
        [[x0, -256.0, TOP], [x1, 256.0, TOP + 16.0]],
        [[x0, -272.0, 0.0], [x1, -256.0, TOP]],
        [[x0, 256.0, 0.0], [x1, 272.0, TOP]],
    ];
    for (x, door) in [(x0, room > 0), (x1, room < 2)] {
        let wall = |y: [f32; 2], z: [f32; 2]| [[x - 4.0, y[0], z[0]], [x + 4.0, y[1], z[1]]];
        if door {
            out.push(wall([-256.0, -64.0], [0.0, TOP]));
            out.push(wall([64.0, 256.0], [0.0, TOP]));
            out.push(wall([-64.0, 64.0], [128.0, TOP]));
        } else {
            out.push(wall([-256.0, 256.0], [0.0, TOP]));
        }
    }
    match room {
        1 => out.push([[216.0, -40.0, 0.0], [296.0, 40.0, TOP]]),
        2 => out.push([[704.0, -64.0, 0.0], [832.0, 64.0, 120.0]]),
        _ => {}
    }
    out
}

/// Adds the boxes' planes behind the two of the tree, their sides, and which
/// leaf has which.
fn bodies(lumps: &mut [Vec<u8>; lump::COUNT]) {
    let (mut planes, mut brushes) = (2, 0);
    for room in 0..3 {
        for [low, high] in boxes(room) {
            put(&mut lumps[lump::BRUSHES], &[planes - 2, 6, BRICK]);
            put(&mut lumps[lump::LEAF_BRUSHES], &[brushes]);
            for axis in 0..3 {
                for (corner, sign) in [(high, 1.0), (low, -1.0)] {
                    let mut plane = [0.0; 4];
                    (plane[axis], plane[3]) = (sign, corner[axis] * sign);
                    put_floats(&mut lumps[lump::PLANES], &plane);
                    put(&mut lumps[lump::BRUSH_SIDES], &[planes, BRICK]);
                    planes += 1;
                }
            }
            brushes += 1;
        }
    }
}

fn leafs(b: &Builder) -> (Vec<u8>, Vec<u8>) {
    let (mut leafs, mut leaf_faces) = (Vec::new(), Vec::new());
    let (mut first, mut first_body) = (0, 0);
    for (cluster, faces) in b.rooms.iter().enumerate() {
        let x = -512 + 512 * cluster as i32;
        let count = faces.len() as i32;
        put(&mut leafs, &[cluster as i32, 0, x, -256, 0, x + 512, 256, TOP as i32, first, count]);
        let bodies = boxes(cluster).len() as i32;
        put(&mut leafs, &[first_body, bodies]);
        first_body += bodies;
        put(&mut leaf_faces, faces);
        first += count;
    }
    (leafs, leaf_faces)
}

fn file(b: &Builder) -> Vec<u8> {
    let mut lumps: [Vec<u8>; lump::COUNT] = core::array::from_fn(|_| Vec::new());
    lumps[lump::ENTITIES] = entities().into_bytes();
    for name in MATERIALS {
        let mut bytes = format!("synth/{name}").into_bytes();
        bytes.resize(64, 0);
        put(&mut bytes, &[0, 1]);
        lumps[lump::SHADERS].extend(bytes);
    }
    put_floats(&mut lumps[lump::PLANES], &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 512.0]);
    bodies(&mut lumps);
    // Each node: its plane, what is in front, what is behind; then its box.
    put(&mut lumps[lump::NODES], &[0, 1, !0, -512, -256, 0, 1024, 256, TOP as i32]);
    put(&mut lumps[lump::NODES], &[1, !2, !1, 0, -256, 0, 1024, 256, TOP as i32]);
    (lumps[lump::LEAFS], lumps[lump::LEAF_FACES]) = leafs(b);
    put_floats(&mut lumps[lump::MODELS], &[-512.0, -256.0, 0.0, 1024.0, 256.0, TOP]);
    put(&mut lumps[lump::MODELS], &[0, b.face_count as i32, 0, 0]);
    lumps[lump::VERTICES] = b.vertices.clone();
    lumps[lump::MESH_VERTICES] = b.mesh_vertices.clone();
    lumps[lump::FACES] = b.faces.clone();
    lumps[lump::LIGHTMAPS] = b.lightmaps.clone();
    // The rooms at the ends do not see each other.
    put(&mut lumps[lump::VISIBILITY], &[3, 1]);
    lumps[lump::VISIBILITY].extend([0b011u8, 0b111, 0b110]);
    let mut out = b"IBSP".to_vec();
    put(&mut out, &[46]);
    let mut at = 8 + 8 * lump::COUNT;
    for lump in &lumps {
        put(&mut out, &[at as i32, lump.len() as i32]);
        at += lump.len();
    }
    lumps.iter().for_each(|lump| out.extend(lump));
    out
}

/// A number 0..1 that depends on two others.
fn noise(x: usize, y: usize) -> f32 {
    let mut h = (x as u32).wrapping_mul(0x9e37_79b1) ^ (y as u32).wrapping_mul(0x85eb_ca6b);
    h = (h ^ h >> 15).wrapping_mul(0x2c1b_3c6d);
    (h ^ h >> 12) as u16 as f32 / 65536.0
}

fn shade(rgb: Vec3, by: f32) -> [u8; 4] {
    let [r, g, b] = rgb.map(|c| (c * by).clamp(0.0, 255.0) as u8);
    [r, g, b, 255]
}

fn brick(x: usize, y: usize) -> [u8; 4] {
    let row = y / 16;
    let column = (x + row % 2 * 16) / 32;
    let mortar = y % 16 < 2 || (x + row % 2 * 16) % 32 < 2;
    let base = if mortar { [150.0, 145.0, 135.0] } else { [170.0, 84.0, 60.0] };
    let tone = if mortar { 0.9 } else { 0.75 + 0.3 * noise(column + 7, row) };
    shade(base, tone + 0.15 * noise(x, y))
}

fn tile(x: usize, y: usize) -> [u8; 4] {
    let edge = x % 64 < 2 || y % 64 < 2;
    let dark = (x / 64 + y / 64).is_multiple_of(2);
    let base = if dark { [120.0, 120.0, 128.0] } else { [205.0, 200.0, 188.0] };
    shade(base, if edge { 0.5 } else { 0.85 + 0.15 * noise(x / 2, y / 2) })
}

fn plaster(x: usize, y: usize) -> [u8; 4] {
    shade([214.0, 208.0, 190.0], 0.8 + 0.1 * noise(x / 4, y / 4) + 0.1 * noise(x, y))
}

fn metal(x: usize, y: usize) -> [u8; 4] {
    let ring = if y % 64 < 6 { 0.6 } else { 1.0 };
    shade([150.0, 160.0, 172.0], ring * (0.8 + 0.2 * noise(x, y / 32)))
}

fn grate(x: usize, y: usize) -> [u8; 4] {
    let bar = x % 32 < 6 || y % 32 < 6;
    let [r, g, b, _] = shade([120.0, 110.0, 96.0], 0.8 + 0.3 * noise(x, y));
    [r, g, b, if bar { 255 } else { 0 }]
}

/// Noise of four sizes, the same beyond the edges.
fn cloud(x: usize, y: usize) -> [u8; 4] {
    let mut sum = 0.0;
    for octave in 0..4u32 {
        let (count, cell) = (4usize << octave, 32usize >> octave);
        let smooth = |v: usize| {
            let t = (v % cell) as f32 / cell as f32;
            (v / cell, t * t * (3.0 - 2.0 * t))
        };
        let ((i, u), (j, v)) = (smooth(x), smooth(y));
        let at = |i: usize, j: usize| noise(i % count + 31 * count, j % count);
        let across = |j: usize| at(i, j) * (1.0 - u) + at(i + 1, j) * u;
        sum += (across(j) * (1.0 - v) + across(j + 1) * v) / (2 << octave) as f32;
    }
    let dense = ((sum - 0.4) * 3.0).clamp(0.0, 1.0);
    let [r, g, b] = mix([58.0, 92.0, 150.0], [222.0, 220.0, 214.0], dense);
    [r as u8, g as u8, b as u8, 255]
}

/// What shining things reflect: bright above, dark below.
fn shine(x: usize, y: usize) -> [u8; 4] {
    let bright = ((96.0 - y as f32) / 64.0).clamp(0.0, 1.0).powi(2);
    shade([200.0, 210.0, 230.0], bright * (0.8 + 0.2 * noise(x / 8, y / 8)))
}

fn glow(x: usize, y: usize) -> [u8; 4] {
    let d = |v: usize| (v as f32 - 63.5) / 64.0;
    let fade = (1.0 - (d(x) * d(x) + d(y) * d(y)).sqrt()).clamp(0.0, 1.0);
    shade([120.0, 200.0, 255.0], fade * fade)
}

/// A picture of 128 x 128 as a TGA file with alpha.
fn tga(picture: fn(usize, usize) -> [u8; 4]) -> Vec<u8> {
    // Uncompressed true colour, 32 bits, rows from the top.
    let mut out = vec![0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 128, 0, 128, 0, 32, 0x28];
    for y in 0..128 {
        for x in 0..128 {
            let [r, g, b, a] = picture(x, y);
            out.extend([b, g, r, a]);
        }
    }
    out
}
