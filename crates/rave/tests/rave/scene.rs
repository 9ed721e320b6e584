//! A library with one draw context, for tests.

use fillrate_engine::DeviceConfig;
use fillrate_engine::target::TileSize;
use fillrate_rave::constants::context::DOUBLE_BUFFER;
use fillrate_rave::{
    Call, Context, DeviceValue, DrawContextId, ImageValue, PixelType, RaveConfig, RaveError,
    RaveRect, Reply, VGouraud, VTexture,
};
use fillrate_simd::Level;

/// A library whose calls are made one by one.
pub struct Scene {
    pub library: Context,
    pub context: u32,
    /// Everything that was called, for a replay.
    pub calls: Vec<Call>,
}

/// How the tests draw by default: on this thread alone.
pub fn config() -> RaveConfig {
    let device = DeviceConfig { threads: 1, level: Level::best(), tile: TileSize::Medium };
    RaveConfig { device, asynchronous: false, ..RaveConfig::default() }
}

/// A memory device of a size.
pub fn memory(width: u32, height: u32, pixel_type: PixelType) -> DeviceValue {
    DeviceValue {
        device_type: 0,
        pixel_type: pixel_type.number(),
        width: width as i32,
        height: height as i32,
        row_bytes: pixel_type.row_bytes(width) as i32,
    }
}

/// A rectangle from the origin.
pub fn area(width: u32, height: u32) -> RaveRect {
    RaveRect::new(0, 0, width as i32, height as i32)
}

/// The call that makes a context.
pub fn context_new(width: u32, height: u32, pixel_type: PixelType, flags: u32) -> Call {
    let (device, rect) = (memory(width, height, pixel_type), area(width, height));
    Call::DrawContextNew { engine: 1, device, rect, scaled: None, clip: None, flags }
}

impl Scene {
    /// A double-buffered context with 16 bits of z.
    pub fn new(width: u32, height: u32, pixel_type: PixelType) -> Scene {
        Scene::with(config(), width, height, pixel_type, DOUBLE_BUFFER)
    }

    pub fn with(
        config: RaveConfig,
        width: u32,
        height: u32,
        pixel_type: PixelType,
        flags: u32,
    ) -> Scene {
        let mut scene = Scene { library: Context::new(config), context: 0, calls: Vec::new() };
        scene.context = scene.call(context_new(width, height, pixel_type, flags)).created();
        assert_ne!(scene.context, 0, "the context is made");
        scene
    }

    pub fn call(&mut self, call: Call) -> Reply {
        let reply = self.library.execute(&call);
        self.calls.push(call);
        reply
    }

    pub fn id(&self) -> DrawContextId {
        DrawContextId(self.context)
    }

    pub fn int(&mut self, tag: u32, value: u32) {
        self.call(Call::SetInt { context: self.context, tag, value });
    }

    pub fn float(&mut self, tag: u32, value: f32) {
        self.call(Call::SetFloat { context: self.context, tag, value });
    }

    /// Sets a colour by the tag of its alpha.
    pub fn color(&mut self, alpha_tag: u32, argb: [f32; 4]) {
        for (tag, value) in (alpha_tag..).zip(argb) {
            self.float(tag, value);
        }
    }

    pub fn texture(&mut self, texture: u32) {
        self.call(Call::SetTexture { context: self.context, tag: 13, texture });
    }

    pub fn start(&mut self) {
        self.call(Call::RenderStart { context: self.context, dirty: None, initial: 0 });
    }

    pub fn end(&mut self) -> Result<(), RaveError> {
        match self.call(Call::RenderEnd { context: self.context, modified: None }) {
            Reply::Status(status) => status,
            other => panic!("{other:?}"),
        }
    }

    pub fn tri(&mut self, [a, b, c]: [VGouraud; 3]) {
        self.call(Call::DrawTriGouraud { context: self.context, a, b, c, flags: 0 });
    }

    pub fn tri_texture(&mut self, [a, b, c]: [VTexture; 3]) {
        self.call(Call::DrawTriTexture { context: self.context, a, b, c, flags: 0 });
    }

    /// A rectangle with the values of a vertex.
    pub fn rect(&mut self, [x0, y0, x1, y1]: [f32; 4], v: VGouraud) {
        let at = |x, y| VGouraud { x, y, ..v };
        self.tri([at(x0, y0), at(x1, y0), at(x0, y1)]);
        self.tri([at(x1, y0), at(x1, y1), at(x0, y1)]);
    }

    /// A rectangle with the values of a vertex, and a texture once across.
    pub fn rect_texture(&mut self, [x0, y0, x1, y1]: [f32; 4], v: VTexture) {
        let w = v.inv_w;
        let at = |x, y, u: f32, t: f32| VTexture { x, y, u_over_w: u * w, v_over_w: t * w, ..v };
        let (a, b) = (at(x0, y0, 0.0, 1.0), at(x1, y0, 1.0, 1.0));
        let (c, d) = (at(x0, y1, 0.0, 0.0), at(x1, y1, 1.0, 0.0));
        self.tri_texture([a, b, c]);
        self.tri_texture([b, d, c]);
    }

    /// A texture of one level from 0xAARRGGBB.
    pub fn texture_new(&mut self, width: u32, argb: &[u32]) -> u32 {
        let images = vec![image(width, argb)];
        let pixel_type = PixelType::Argb32.number();
        self.call(Call::TextureNew { engine: 1, flags: 0, pixel_type, images }).created()
    }

    /// What the context shows: a pixel as 0xAARRGGBB.
    pub fn pixel(&mut self, x: u32, y: u32) -> u32 {
        self.library.shown_by(self.id()).expect("the context is there").argb(x, y)
    }
}

/// An image of 0xAARRGGBB.
pub fn image(width: u32, argb: &[u32]) -> ImageValue {
    let pixels: Vec<u8> = argb.iter().flat_map(|p| p.to_le_bytes()).collect();
    let height = argb.len() as i32 / width as i32;
    ImageValue { width: width as i32, height, pixels: pixels.into() }
}

/// An opaque vertex of a colour.
pub fn colored([r, g, b]: [f32; 3], z: f32) -> VGouraud {
    VGouraud { z, inv_w: 1.0, r, g, b, a: 1.0, ..VGouraud::default() }
}

/// A textured vertex without light.
pub fn textured(z: f32) -> VTexture {
    let white = VTexture { kd_r: 1.0, kd_g: 1.0, kd_b: 1.0, ..VTexture::default() };
    VTexture { z, inv_w: 1.0, a: 1.0, ..white }
}

/// Channels of 0xAARRGGBB as alpha, red, green, blue.
pub fn channels(argb: u32) -> [u32; 4] {
    argb.to_be_bytes().map(u32::from)
}
