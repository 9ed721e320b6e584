//! A program of the time in Rust: `fillrate-geometry` does its half, RAVE draws.
//!
//! A hundred boxes with 36 textures, on a board that keeps textures in its own
//! memory alone and has room for nine. The objects are culled by their spheres;
//! polygons that cross the edge of the view are clipped; the frame is drawn as
//! the technote's loop has it, which loads no texture twice.
//!
//!     cargo run --release -p fillrate-rave --example world [PICTURE.ppm]

use std::error::Error;

use fillrate_geometry::{
    Clipper, Containment, DepthMap, DepthScale, Draw, FrameHost, Frustum, PlaneMask, Projection,
    Sphere, TextureId, Transform, Vec3, Vertex, View, render_frame,
};
use fillrate_rave::constants::{context, texture_op, vertex_mode};
use fillrate_rave::memory::{EngineKind, MemoryConfig};
use fillrate_rave::tags::{float, int, pointer};
use fillrate_rave::{
    Call, Context, DeviceValue, DrawContextId, EngineId, ImageValue, PixelType, RaveConfig,
    RaveRect, VTexture,
};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 240;
const OBJECTS: u32 = 100;
const TEXTURES: u32 = 36;
const SIDE: usize = 64;
const ENGINE: u32 = EngineId::BUILT_IN.0;

/// A box on the ground.
struct Object {
    centre: Vec3,
    half: Vec3,
    texture: TextureId,
}

/// A fixed sequence of numbers below a limit.
struct Numbers(u32);

impl Numbers {
    fn below(&mut self, limit: u32) -> u32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (self.0 >> 8) % limit
    }
}

fn objects() -> Vec<Object> {
    let mut numbers = Numbers(11);
    let mut metres = |limit: u32| numbers.below(10 * limit) as f32 / 10.0;
    (0..OBJECTS)
        .map(|n| {
            let half = Vec3::new(2.0 + metres(3), 1.5 + metres(5), 2.0 + metres(3));
            let x = (n % 10) as f32 * 16.0 - 72.0 + metres(4);
            let centre = Vec3::new(x, half.y, (n / 10) as f32 * 18.0 + 8.0 + metres(4));
            Object { centre, half, texture: metres(1000) as u32 % TEXTURES }
        })
        .collect()
}

/// A texture of bricks, each number in a tint of its own.
fn bricks(number: TextureId) -> ImageValue {
    let mut numbers = Numbers(number * 77 + 5);
    let tint: [u32; 3] = std::array::from_fn(|_| 70 + numbers.below(110));
    let mut pixels = Vec::with_capacity(SIDE * SIDE * 4);
    for y in 0..SIDE {
        for x in 0..SIDE {
            let is_seam = y % 8 == 0 || (x + y / 8 % 2 * 8) % 16 == 0;
            let light = numbers.below(28) + if is_seam { 0 } else { 34 };
            let [r, g, b] = tint.map(|channel| (channel + light) as u8);
            pixels.extend([b, g, r, 255]);
        }
    }
    ImageValue { width: SIDE as i32, height: SIDE as i32, pixels: pixels.into() }
}

/// The six faces of a box: corners as signs, and the light on each.
const FACES: [([[f32; 3]; 4], f32); 6] = [
    ([[-1.0, 1.0, -1.0], [1.0, 1.0, -1.0], [1.0, -1.0, -1.0], [-1.0, -1.0, -1.0]], 0.95),
    ([[1.0, 1.0, 1.0], [-1.0, 1.0, 1.0], [-1.0, -1.0, 1.0], [1.0, -1.0, 1.0]], 0.4),
    ([[1.0, 1.0, -1.0], [1.0, 1.0, 1.0], [1.0, -1.0, 1.0], [1.0, -1.0, -1.0]], 0.6),
    ([[-1.0, 1.0, 1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, -1.0], [-1.0, -1.0, 1.0]], 0.75),
    ([[-1.0, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 1.0, -1.0], [-1.0, 1.0, -1.0]], 1.0),
    ([[-1.0, -1.0, -1.0], [1.0, -1.0, -1.0], [1.0, -1.0, 1.0], [-1.0, -1.0, 1.0]], 0.3),
];

/// The program: the library, and what it has to draw in this frame.
struct Program {
    library: Context,
    context: u32,
    projection: Projection,
    camera: Transform,
    frustum: Frustum,
    objects: Vec<Object>,
    /// Objects that are seen, with the planes that they cross.
    seen: Vec<(usize, PlaneMask)>,
    /// The engine's numbers of loaded textures.
    loaded: Vec<(TextureId, u32)>,
    loads: Vec<u32>,
}

impl Program {
    fn new() -> Result<Program, Box<dyn Error>> {
        let memory = MemoryConfig {
            kind: EngineKind::VideoOnly,
            video_bytes: 9 * (SIDE * SIDE * 4) as u64,
            ..MemoryConfig::default()
        };
        let mut library = Context::new(RaveConfig { memory, ..RaveConfig::default() });
        let device = DeviceValue {
            device_type: 0,
            pixel_type: PixelType::Rgb32.number(),
            width: WIDTH as i32,
            height: HEIGHT as i32,
            row_bytes: 4 * WIDTH as i32,
        };
        let rect = RaveRect::new(0, 0, WIDTH as i32, HEIGHT as i32);
        let flags = context::DOUBLE_BUFFER;
        let new =
            Call::DrawContextNew { engine: ENGINE, device, rect, scaled: None, clip: None, flags };
        let context = library.execute(&new).created();
        let id = DrawContextId(context);
        for (tag, value) in
            [(float::COLOR_BG_R, 0.6), (float::COLOR_BG_G, 0.7), (float::COLOR_BG_B, 0.85)]
        {
            library.execute(&Call::SetFloat { context, tag, value });
        }
        let modulate = Call::SetInt { context, tag: int::TEXTURE_OP, value: texture_op::MODULATE };
        library.execute(&modulate);
        let view = View::with_field_of_view(WIDTH as f32, HEIGHT as f32, 1.35, 1.0, 220.0)?;
        let scale = DepthScale::new(
            library.get_float(id, float::Z_MIN_SCALE),
            library.get_float(id, float::Z_MIN_OFFSET),
        )?;
        Ok(Program {
            library,
            context,
            projection: Projection { view, map: DepthMap::Projective, scale },
            camera: Transform::IDENTITY,
            frustum: Frustum::new(&view),
            objects: objects(),
            seen: Vec::new(),
            loaded: Vec::new(),
            loads: vec![0; TEXTURES as usize],
        })
    }

    /// Finds out which objects a camera at `eye` sees.
    fn look_from(&mut self, eye: Vec3) {
        self.camera = Transform::translation(Vec3::new(-eye.x, -eye.y, -eye.z));
        let frustum = self.frustum.in_world(&self.camera);
        let sees = |(n, object): (usize, &Object)| {
            let sphere = Sphere { centre: object.centre, radius: object.half.length() };
            match frustum.test_sphere(&sphere, PlaneMask::ALL) {
                Containment::Within(crossed) => Some((n, crossed)),
                Containment::Outside => None,
            }
        };
        self.seen = self.objects.iter().enumerate().filter_map(sees).collect();
    }

    fn draws(&self) -> Vec<Draw> {
        let texture = |&(n, _): &(usize, PlaneMask)| Some(self.objects[n].texture);
        self.seen.iter().map(|seen| Draw { texture: texture(seen), blended: false }).collect()
    }

    /// Clips and projects the faces of an object: fans of vertices.
    fn faces(&self, object: &Object, crossed: PlaneMask) -> Vec<Vec<VTexture>> {
        let mut clipper = Clipper::<2>::new();
        let corner = |signs: [f32; 3], [u, v]: [f32; 2]| {
            let (c, h) = (object.centre, object.half);
            let point = Vec3::new(c.x + signs[0] * h.x, c.y + signs[1] * h.y, c.z + signs[2] * h.z);
            Vertex::new(self.camera.point(point), [u, v])
        };
        let coordinates = [[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]];
        FACES
            .iter()
            .filter_map(|(corners, light)| {
                let polygon: [Vertex<2>; 4] =
                    std::array::from_fn(|i| corner(corners[i], coordinates[i]));
                let clipped = self.frustum.clip(&mut clipper, &polygon, crossed);
                let projected = clipped.iter().filter_map(|v| self.projection.project(v));
                let fan: Vec<VTexture> = projected
                    .map(|v| VTexture {
                        x: v.x,
                        y: v.y,
                        z: v.z,
                        inv_w: v.inv_w,
                        a: 1.0,
                        u_over_w: v.over_w(0),
                        v_over_w: v.over_w(1),
                        kd_r: *light,
                        kd_g: *light,
                        kd_b: *light,
                        ..VTexture::default()
                    })
                    .collect();
                (fan.len() >= 3 && shows_front(&fan)).then_some(fan)
            })
            .collect()
    }
}

/// Whether the corners turn to the right.
fn shows_front(v: &[VTexture]) -> bool {
    let [a, b, c] = [&v[0], &v[1], &v[2]];
    (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y) > 0.0
}

impl FrameHost for Program {
    fn sync(&mut self) {
        self.library.execute(&Call::Sync { context: self.context });
    }

    fn start(&mut self) {
        self.library.execute(&Call::RenderStart { context: self.context, dirty: None, initial: 0 });
    }

    fn end(&mut self) {
        self.library.execute(&Call::RenderEnd { context: self.context, modified: None });
    }

    fn create(&mut self, texture: TextureId) -> bool {
        let pixel_type = PixelType::Argb32.number();
        let images = vec![bricks(texture)];
        let new = Call::TextureNew { engine: ENGINE, flags: 0, pixel_type, images };
        let number = self.library.execute(&new).created();
        if number != 0 {
            self.loaded.push((texture, number));
            self.loads[texture as usize] += 1;
        }
        number != 0
    }

    fn delete(&mut self, texture: TextureId) -> bool {
        let Some(at) = self.loaded.iter().position(|&(id, _)| id == texture) else { return false };
        let (_, number) = self.loaded.swap_remove(at);
        self.library.execute(&Call::TextureDelete { engine: ENGINE, texture: number });
        true
    }

    fn draw(&mut self, index: usize, _textured: bool) {
        let (n, crossed) = self.seen[index];
        let id = self.objects[n].texture;
        let found = self.loaded.iter().find(|&&(other, _)| other == id);
        let texture = found.map_or(0, |&(_, number)| number);
        let context = self.context;
        self.library.execute(&Call::SetTexture { context, tag: pointer::TEXTURE, texture });
        for fan in self.faces(&self.objects[n], crossed) {
            let mode = vertex_mode::FAN;
            self.library.draw_v_texture(DrawContextId(context), mode, &fan);
        }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut program = Program::new()?;
    let mut loaded = Vec::new();
    for frame in 0..6 {
        program.look_from(Vec3::new(frame as f32, 9.0, -12.0 + 3.0 * frame as f32));
        program.loads.fill(0);
        let draws = program.draws();
        let created = render_frame(&mut program, &draws, &mut loaded);
        let most = program.loads.iter().max().copied().unwrap_or(0);
        println!("frame {frame}: {} objects, {created} textures loaded", draws.len());
        assert!(most <= 1, "no texture is loaded twice in a frame");
    }
    if let Some(file) = std::env::args().nth(1) {
        let shown = program.library.shown().ok_or("nothing was shown")?;
        let mut picture = format!("P6 {} {} 255\n", shown.width, shown.height).into_bytes();
        picture.extend(shown.rgba8888().chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]));
        std::fs::write(file, picture)?;
    }
    Ok(())
}
