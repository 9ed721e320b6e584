//! One board: registers, memories, buffers.

use std::sync::Arc;

use fillrate_engine::state::{Blend, Dither, FogTable, MAX_TMUS, Origin};
use fillrate_engine::{Counters, Device, DrawState, PixelFormat, Registers, SurfaceId, Texture};

use crate::card::{Card, RESOLUTIONS};
use crate::clock::Clock;
use crate::enums::{LEVELS_BOTH, MIPMAP_DISABLE, RESOLUTION_NONE};
use crate::gu::MipMaps;
use crate::improve::Improvements;
use crate::lfb::Lfb;
use crate::registers::{FbiRegisters, TmuRegisters, fbz};
use crate::scanout::GammaTable;
use crate::texture::TextureMemory;
use crate::translate::{draw_state, uses_texel};
use crate::variables::Variables;
use crate::vertex::VertexRules;

/// What a texture unit's registers do not say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct UnitSettings {
    pub mip_map_mode: i32,
    pub small_lod: u32,
    pub large_lod: u32,
    /// The even, odd or all levels, as the texture was sourced.
    pub even_odd: u32,
}

impl Default for UnitSettings {
    fn default() -> UnitSettings {
        UnitSettings {
            mip_map_mode: MIPMAP_DISABLE,
            small_lod: 0,
            large_lod: 0,
            even_odd: LEVELS_BOTH,
        }
    }
}

/// State outside the registers. All of it is saved and restored with them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Settings {
    pub cull: i32,
    pub stw_hints: u32,
    pub allow_lod_dither: bool,
    pub delta0: bool,
    /// Red, green, blue, alpha.
    pub constant: [f32; 4],
    pub lfb_alpha: u8,
    pub lfb_depth: u16,
    pub color_format: i32,
    /// As given: min x, min y, max x, max y.
    pub clip: [f32; 4],
    pub units: [UnitSettings; MAX_TMUS],
}

/// The buffers of an open board.
#[derive(Debug)]
pub(crate) struct Buffers {
    pub width: u32,
    pub height: u32,
    /// Displayed first, then back, then the third.
    pub colors: Vec<SurfaceId>,
    pub aux: Option<SurfaceId>,
}

/// What the engine's counters are off by, where one triangle took several
/// launches.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Correction {
    pub pixels_in: i64,
    pub submitted: i64,
    pub drawn: i64,
}

/// A board and everything on it.
#[derive(Debug)]
pub(crate) struct Board {
    pub card: Card,
    pub device: Device,
    pub fbi: FbiRegisters,
    pub tmus: Vec<TmuRegisters>,
    pub settings: Settings,
    pub fog_table: FogTable,
    /// Red, green, blue.
    pub gamma: [GammaTable; 3],
    pub filter_thresholds: [u8; 3],
    pub memories: Vec<TextureMemory>,
    /// The texture manager of the utility library.
    pub mip_maps: MipMaps,
    pub buffers: Option<Buffers>,
    pub lfb: Lfb,
    /// Swaps since the board was opened.
    pub swaps: u64,
    pub clock: Clock,
    /// The triangle registers as raw writes left them; those that Glide's own
    /// calls would leave are not kept.
    pub set_up: Registers,
    pub correction: Correction,
    /// Counters at the last reset of the pixel and of the triangle counters.
    pub counted: [Counters; 2],
    /// Launches that are none of the program's triangles: points, lines, smooth
    /// edges. Now, and at the last reset of the triangle counters.
    pub helpers: [u64; 2],
    /// Registers changed since the engine was told.
    pub dirty: bool,
    /// How vertices are read, while not dirty.
    pub rules: VertexRules,
    pub dither_subtract: bool,
    pub improve: Improvements,
    /// Drop triangles with a corner out of range.
    pub bounds_check: bool,
}

impl Board {
    pub fn new(card: Card, device: Device, variables: &Variables, improve: Improvements) -> Board {
        let memory = || TextureMemory::new(card.texture_bytes());
        Board {
            device,
            fbi: FbiRegisters::default(),
            tmus: vec![TmuRegisters::default(); card.units],
            settings: default_settings(0, (0, 0)),
            fog_table: FogTable::default(),
            gamma: variables.gamma_tables(),
            filter_thresholds: variables.filter_thresholds,
            memories: (0..card.units).map(|_| memory()).collect(),
            mip_maps: MipMaps::new(card.units),
            card,
            buffers: None,
            lfb: Lfb::default(),
            swaps: 0,
            clock: Clock::default(),
            set_up: Registers::default(),
            correction: Correction::default(),
            counted: [Counters::default(); 2],
            helpers: [0; 2],
            dirty: true,
            rules: VertexRules::default(),
            dither_subtract: !variables.no_dither_subtraction,
            improve,
            bounds_check: variables.bounds_check,
        }
    }

    pub fn is_open(&self) -> bool {
        self.buffers.is_some()
    }

    /// Makes the buffers and the default state; false where the board cannot.
    ///
    /// Source: G246, `grSstWinOpen`.
    pub fn open(&mut self, resolution: i32, origin: i32, colors: i32, aux: i32) -> bool {
        // There is one buffer besides the two: a third colour buffer, or the
        // auxiliary one.
        let buffers = matches!((colors, aux), (2, 0 | 1) | (3, 0));
        if resolution == RESOLUTION_NONE || !buffers {
            return false;
        }
        let Some(&(width, height)) =
            usize::try_from(resolution).ok().and_then(|index| RESOLUTIONS.get(index))
        else {
            return false;
        };
        if !self.card.holds(resolution as usize, (colors + aux) as u32) {
            return false;
        }
        let Ok(buffers) = self.make_buffers(width, height, colors as usize, aux == 1) else {
            return false;
        };
        self.buffers = Some(buffers);
        self.swaps = 0;
        self.fog_table = FogTable::default();
        self.clock = Clock::new(height);
        self.set_up = Registers::default();
        self.device.reset_counters();
        self.correction = Correction::default();
        self.counted = [Counters::default(); 2];
        self.helpers = [0; 2];
        self.mip_maps.reset();
        self.set_defaults(origin, (width, height));
        true
    }

    fn make_buffers(
        &mut self,
        width: u32,
        height: u32,
        colors: usize,
        aux: bool,
    ) -> Result<Buffers, fillrate_engine::EngineError> {
        let mut buffers = Buffers { width, height, colors: Vec::new(), aux: None };
        let Improvements { scale, .. } = self.improve;
        let (width, height) = (width * scale, height * scale);
        let format = self.improve.color_format();
        self.device.set_scale(scale);
        for _ in 0..colors {
            buffers.colors.push(self.device.create_surface(width, height, format)?);
        }
        if aux {
            buffers.aux = Some(self.device.create_surface(width, height, PixelFormat::Aux16)?);
        }
        Ok(buffers)
    }

    pub fn close(&mut self) {
        let Some(buffers) = self.buffers.take() else { return };
        self.lfb = Lfb::default();
        self.clock = Clock::default();
        for id in buffers.colors.into_iter().chain(buffers.aux) {
            // They were made by this device and are destroyed once.
            let _ = self.device.destroy_surface(id);
        }
    }

    /// The surface a buffer number means: 0 the displayed one, 1 the one
    /// behind it.
    pub fn color_surface(&self, buffer: u32) -> Option<SurfaceId> {
        let buffers = self.buffers.as_ref()?;
        buffers.colors.get(if buffer == 0 { 0 } else { 1 }).copied()
    }

    /// Tells the engine what the registers say, where that changed.
    #[inline]
    pub fn update(&mut self) {
        if self.dirty && self.buffers.is_some() {
            self.tell_engine();
        }
    }

    #[cold]
    fn tell_engine(&mut self) {
        self.dirty = false;
        let (state, textures) = self.engine_state();
        let color = self.color_surface(self.fbi.fbz_mode >> 14 & 3);
        let aux = self.buffers.as_ref().and_then(|buffers| buffers.aux);
        if let Some(color) = color {
            // Both were made by this device, of one size.
            let _ = self.device.set_target(color, aux);
        }
        self.device.set_state(&state, textures);
        self.rules = VertexRules {
            hints: self.settings.stw_hints,
            unit0_active: uses_texel(&self.tmus[0]),
            constant: self.settings.delta0.then(|| {
                let [r, g, b, _] = self.settings.constant;
                [r, g, b].map(f32::to_bits)
            }),
        };
    }

    /// The state and textures that [`Board::update`] tells the engine.
    pub fn engine_state(&mut self) -> (DrawState, [Option<Arc<Texture>>; MAX_TMUS]) {
        let mut state = draw_state(&self.fbi, &self.tmus, &self.fog_table);
        if self.improve.color32 {
            state.dither = Dither::Off;
            state.blend = state.blend.map(|blend| Blend { subtract_dither: false, ..blend });
        }
        let textures = self.textures(&state);
        (state, textures)
    }

    fn textures(&mut self, state: &DrawState) -> [Option<Arc<Texture>>; MAX_TMUS] {
        let mut textures = [const { None }; MAX_TMUS];
        for (i, texture) in textures.iter_mut().enumerate() {
            if state.units[i].is_some() && uses_texel(&self.tmus[i]) {
                *texture = Some(self.memories[i].texture(&self.tmus[i]));
            }
        }
        textures
    }

    /// Everything counted since the board was opened. A flush.
    pub fn totals(&mut self) -> Counters {
        let counted = self.device.counters();
        let by = |count: u64, correction: i64| count.saturating_add_signed(correction);
        Counters {
            pixels_in: by(counted.pixels_in, self.correction.pixels_in),
            triangles_in: by(counted.triangles_in, self.correction.submitted),
            triangles_drawn: by(counted.triangles_drawn, self.correction.drawn),
            ..counted
        }
    }

    /// What was counted since the last resets.
    ///
    /// Source: G246, triangle set-up: only what it is given counts as a triangle.
    pub fn counters(&mut self) -> Counters {
        let now = self.totals();
        let [pixels, triangles] = &self.counted;
        let helpers = self.helpers[0] - self.helpers[1];
        Counters {
            pixels_in: now.pixels_in - pixels.pixels_in,
            chroma_fail: now.chroma_fail - pixels.chroma_fail,
            depth_fail: now.depth_fail - pixels.depth_fail,
            alpha_fail: now.alpha_fail - pixels.alpha_fail,
            pixels_out: now.pixels_out - pixels.pixels_out,
            triangles_in: now.triangles_in - triangles.triangles_in - helpers,
            triangles_drawn: now.triangles_drawn - triangles.triangles_drawn - helpers,
        }
    }

    pub fn reset_pixel_counters(&mut self) {
        self.counted[0] = self.totals();
    }

    pub fn reset_triangle_counters(&mut self) {
        self.counted[1] = self.totals();
        self.helpers[1] = self.helpers[0];
    }

    /// Row order of drawing.
    pub fn origin(&self) -> Origin {
        if self.fbi.fbz_mode & fbz::LOWER_LEFT != 0 { Origin::LowerLeft } else { Origin::UpperLeft }
    }
}

/// The state outside the registers after a board is opened.
pub(crate) fn default_settings(color_format: i32, (width, height): (u32, u32)) -> Settings {
    Settings {
        cull: 0,
        stw_hints: 0,
        allow_lod_dither: false,
        delta0: false,
        constant: [0.0; 4],
        lfb_alpha: 0xff,
        lfb_depth: 0,
        color_format,
        clip: [0.0, 0.0, width as f32, height as f32],
        units: [UnitSettings::default(); MAX_TMUS],
    }
}
