//! The fast path: what stage 1 made, drawn by the pixel engine's Raw profile.
//!
//! It is exact: the engine makes every value by the additions of the reference, in its order, so
//! pictures are equal bit for bit at every SIMD level and thread count.
//!
//! The buffers of [`Target`] and the engine's surfaces hold the same pixels in two orders. Each is
//! brought up to date when somebody needs it: the surfaces before drawing, the buffers when the host
//! looks at them. Clears go to the surfaces alone, where they cost nothing until they are drawn on.

use std::collections::HashMap;
use std::sync::Arc;

use fillrate_engine::state::{
    RawAlpha, RawCombine, RawLight, RawMipmap, RawQuirks, RawState, RawTiling,
};
use fillrate_engine::{
    Device, DeviceConfig, EngineError, FlushReason, PixelFormat, RawDraw, RawPrimitive, RawTexture,
    RawVertex, SurfaceId,
};

use crate::color;
use crate::device::{Config, Core};
use crate::errata::Errata;
use crate::framebuffer::{FAR, Pages};
use crate::opcode::Opcode;
use crate::stage::composite::Target;
use crate::stage::{Shape, TransPrim, Vertex};
use crate::state::{PrimInfo, alpha, mipmap, texmode, textile};
use crate::texture::TextureManager;

/// Primitives collected before they are drawn, at most.
pub const MAX_QUEUED: usize = 4096;

/// The two pages by their numbers, and the depths.
const BUFFERS: usize = 3;
/// The place of the depths among the buffers.
const DEPTH: usize = 2;

/// An engine device and what it draws on.
#[derive(Debug)]
pub(crate) struct Painter {
    device: Device,
    surfaces: [SurfaceId; BUFFERS],
    /// Which surfaces lack what the host did.
    stale_surfaces: [bool; BUFFERS],
    /// Which buffers lack what was drawn.
    stale_buffers: [bool; BUFFERS],
    textures: Textures,
}

impl Painter {
    /// A painter for a device's buffers.
    ///
    /// # Errors
    /// What the engine cannot make: threads, or surfaces of such a size.
    pub fn new(config: &Config) -> Result<Self, EngineError> {
        let Config { threads, level, tile, width, height, .. } = *config;
        let mut device = Device::new(DeviceConfig { threads, level, tile })?;
        let formats = [PixelFormat::Rgbx8888, PixelFormat::Rgbx8888, PixelFormat::Aux32];
        let [a, b, z] = formats.map(|format| device.create_surface(width, height, format));
        Ok(Self {
            device,
            surfaces: [a?, b?, z?],
            stale_surfaces: [true; BUFFERS],
            stale_buffers: [false; BUFFERS],
            textures: Textures::default(),
        })
    }

    /// Draws primitives in order; returns how many fragments were made.
    ///
    /// # Errors
    /// None that a painter's own surfaces can cause.
    pub fn draw(&mut self, core: &mut Core, prims: &[TransPrim]) -> Result<u64, EngineError> {
        self.update_surfaces(&core.target)?;
        self.textures.follow(&core.textures);
        self.device.reset_counters();
        let pages = core.target.pages;
        let number = |front: bool| core.target.frame.page_number(front);
        let (first, second) = match (pages.back(), pages.front()) {
            (true, true) => (number(false), Some(number(true))),
            (true, false) => (number(false), None),
            (false, _) => (number(true), None),
        };
        let before = match second {
            // Each page blends with what it holds itself; both meet the same depths.
            Some(_) => Some(self.device.surface(self.surfaces[DEPTH])?.clone()),
            None => None,
        };
        self.draw_on(first, pages != Pages::NONE, core, prims)?;
        let fragments = self.device.counters().pixels_in;
        if let (Some(second), Some(before)) = (second, before) {
            *self.device.surface(self.surfaces[DEPTH])? = before;
            self.draw_on(second, true, core, prims)?;
        }
        Ok(fragments)
    }

    fn draw_on(
        &mut self,
        page: usize,
        color_write: bool,
        core: &Core,
        prims: &[TransPrim],
    ) -> Result<(), EngineError> {
        self.device.set_target(self.surfaces[page], Some(self.surfaces[DEPTH]))?;
        let mut last: Option<(PrimInfo, RawDraw)> = None;
        for prim in prims {
            let draw = match last.take().filter(|(info, _)| info.draws_like(&prim.info)) {
                Some((_, draw)) => draw,
                None => {
                    let state =
                        RawState { color_write, ..translate(&prim.info, &core.config.errata) };
                    RawDraw { state, texture: self.textures.get(&core.textures, &prim.info) }
                }
            };
            self.device.draw_raw(&draw, primitive(prim));
            last = Some((prim.info, draw));
        }
        self.device.flush(FlushReason::Explicit);
        self.stale_buffers[page] |= color_write;
        self.stale_buffers[DEPTH] = true;
        Ok(())
    }

    /// Brings the surfaces up to date.
    fn update_surfaces(&mut self, target: &Target) -> Result<(), EngineError> {
        for page in (0..DEPTH).filter(|page| self.stale_surfaces[*page]) {
            self.device.write32(self.surfaces[page], target.frame.numbered(page))?;
        }
        if self.stale_surfaces[DEPTH] {
            let words: Vec<u32> = target.depth.depths().iter().map(|z| *z as u32).collect();
            self.device.write32(self.surfaces[DEPTH], &words)?;
        }
        self.stale_surfaces = [false; BUFFERS];
        Ok(())
    }

    /// Brings the buffers up to date.
    ///
    /// # Errors
    /// None that a painter's own surfaces can cause.
    pub fn update_buffers(&mut self, target: &mut Target) -> Result<(), EngineError> {
        for page in (0..DEPTH).filter(|page| self.stale_buffers[*page]) {
            self.device.read32(self.surfaces[page], target.frame.numbered_mut(page))?;
        }
        if self.stale_buffers[DEPTH] {
            let depths = target.depth.depths_mut();
            let mut words = vec![0; depths.len()];
            self.device.read32(self.surfaces[DEPTH], &mut words)?;
            depths.iter_mut().zip(words).for_each(|(z, word)| *z = word as i32);
        }
        self.stale_buffers = [false; BUFFERS];
        Ok(())
    }

    /// Notes that the buffers may have changed; they must have been up to date.
    pub fn buffers_changed(&mut self) {
        self.stale_surfaces = [true; BUFFERS];
    }

    /// Carries a command out on the surfaces alone, if it is a clear.
    ///
    /// # Errors
    /// None that a painter's own surfaces can cause.
    pub fn clear(&mut self, target: &Target, op: Opcode, p: &[u32]) -> Result<bool, EngineError> {
        match op {
            Opcode::ClearFb => {
                let pages = Pages::from_word(p[0]);
                for (front, selected) in [(false, pages.back()), (true, pages.front())] {
                    if selected {
                        self.fill(target.frame.page_number(front), p[1])?;
                    }
                }
            }
            Opcode::ClearZ => self.fill(DEPTH, FAR as u32)?,
            _ => return Ok(false),
        }
        Ok(true)
    }

    fn fill(&mut self, buffer: usize, value: u32) -> Result<(), EngineError> {
        self.device.fill(self.surfaces[buffer], value)?;
        self.stale_surfaces[buffer] = false;
        self.stale_buffers[buffer] = true;
        Ok(())
    }
}

/// Whether a command can go by the buffers: it neither reads nor writes them.
pub(crate) fn leaves_buffers(op: Opcode) -> bool {
    !matches!(
        op,
        Opcode::WriteFb
            | Opcode::WriteFbBlock
            | Opcode::ReadFb
            | Opcode::ReadFbBlock
            | Opcode::WriteZ
            | Opcode::WriteZBlock
            | Opcode::ReadZ
            | Opcode::ReadZBlock
            | Opcode::Reset
            | Opcode::Resize
    )
}

/// Textures as the engine reads them, made when they are drawn with.
#[derive(Debug, Default)]
struct Textures {
    made: HashMap<u32, Arc<RawTexture>>,
    /// The changes that `made` knows.
    changes: u64,
}

impl Textures {
    /// Forgets what was made before the last change.
    fn follow(&mut self, manager: &TextureManager) {
        if self.changes != manager.changes() {
            self.made.clear();
            self.changes = manager.changes();
        }
    }

    fn get(&mut self, manager: &TextureManager, info: &PrimInfo) -> Option<Arc<RawTexture>> {
        if !info.mode.uses_texture() {
            return None;
        }
        let id = info.texture_id;
        if let Some(texture) = self.made.get(&id) {
            return Some(Arc::clone(texture));
        }
        let (sizes, texels) = manager.texels(id)?;
        let texture = Arc::new(RawTexture::new(&sizes, texels));
        self.made.insert(id, Arc::clone(&texture));
        Some(texture)
    }
}

/// The state that draws as a primitive's mode says.
fn translate(info: &PrimInfo, errata: &Errata) -> RawState {
    let mode = info.mode;
    let alpha = |mode: u32| match mode {
        alpha::NONE => RawAlpha::Opaque,
        alpha::HARD => RawAlpha::Hard,
        _ => RawAlpha::Soft,
    };
    let lit = |used: u32, color: u32| (used == 1).then_some(color);
    let ambient = color::scale(info.amb_color, color::low(info.amb_color));
    RawState {
        combine: match mode.texmode() {
            texmode::COLOR => RawCombine::Color,
            texmode::TEXTURE => RawCombine::Texture,
            texmode::BLEND => RawCombine::Blend,
            texmode::TEXDECAL => RawCombine::TextureDecal,
            texmode::COLDECAL => RawCombine::ColorDecal,
            texmode::MODULATE => RawCombine::Modulate,
            _ => RawCombine::Black,
        },
        balance: crate::stage::combine::balance(info.col_tex_balance) as u8,
        texel_alpha: alpha(mode.tex_alpha()),
        color_alpha: alpha(mode.col_alpha()),
        threshold: info.alpha_thresh,
        smooth_color: mode.col_interp() == 1,
        bilinear: mode.tex_interp() == 1,
        tiling: match mode.textile() {
            textile::REPEAT => RawTiling::Repeat,
            textile::MIRROR => RawTiling::Mirror,
            textile::CLAMP => RawTiling::Clamp,
            _ => RawTiling::None,
        },
        mipmap: match mode.mipmap() {
            mipmap::OFF => RawMipmap::Off,
            mipmap::NEAREST => RawMipmap::Nearest,
            _ => RawMipmap::Linear,
        },
        light: (mode.lit() == 1).then(|| RawLight {
            ambient: lit(mode.use_amb(), ambient),
            direct: lit(mode.use_dir(), info.dir_color),
            // With the fields mixed up, a light that is used is interpolated.
            smooth: mode.lit_interp() == 1 || errata.single_tile_mode_mixup,
            more: mode.more_light() == 1,
        }),
        test: mode.no_use_z() == 0,
        depth_write: mode.no_write_z() == 0,
        color_write: true,
        quirks: quirks(errata),
    }
}

fn quirks(errata: &Errata) -> RawQuirks {
    RawQuirks {
        unsigned_depth: errata.unsigned_depth,
        depth_overflows: errata.depth_overflows,
        channels_wrap: errata.channels_wrap,
        mirror_wrap: errata.mirror_wrap,
        clamp_v_by_width: errata.clamp_v_by_width,
        repeat_to_one: errata.repeat_to_one,
        texel_truncates: errata.texel_truncates,
        bilinear_mirror_inner: errata.bilinear_mirror_inner,
        box_clamp_moves: errata.box_clamp_moves,
        box_skips_exact_centre: errata.box_skips_exact_centre,
        decal_over_alpha: errata.decal_over_alpha,
        top_left_rule: errata.top_left_rule,
    }
}

fn primitive(prim: &TransPrim) -> RawPrimitive {
    let [a, b, _] = &prim.vertices;
    match prim.shape {
        Shape::Triangle => RawPrimitive::Triangle(prim.vertices.each_ref().map(vertex)),
        Shape::Line => RawPrimitive::Line([vertex(a), vertex(b)]),
        Shape::Point => RawPrimitive::Point { at: vertex(a), size: prim.info.point_size },
    }
}

fn vertex(v: &Vertex) -> RawVertex {
    let Vertex { x, y, z, w1, u, v, rgba, intensity, more } = *v;
    RawVertex { x, y, z, w1, u, v, rgba, intensity, more }
}
