//! The manager: which engines there are, in which order, and what they offer.
//!
//! Source: RAVE, engines.

use crate::RaveError;
use crate::context::RaveConfig;
use crate::draw_context::check_device;
use crate::engine::Engine;
use crate::gestalt::{Answer, fast, optional, optional2, selector};
use crate::handle::EngineId;
use crate::pixel::PixelType;
use crate::state::MAX_LAYERS;
use crate::vertex::DeviceValue;

/// Vendor and engine of this crate's engine: no number that Apple gave away.
pub const FILLRATE: (i32, i32) = (0x4d33, 1);
/// Vendor and engine of Apple's software engine.
pub const APPLE_SOFTWARE: (i32, i32) = (0, 0);
/// The vendor that stands for whichever engine is best, `kQAVendor_BestChoice`.
pub const BEST_CHOICE: i32 = -1;

const NAME: &str = "Fillrate";
const REVISION: u32 = 1;

/// The most engines at a time.
const MAX_ENGINES: usize = 64;

const OPTIONAL: u32 = optional::DEEP_Z
    | optional::TEXTURE
    | optional::TEXTURE_HQ
    | optional::TEXTURE_COLOR
    | optional::BLEND
    | optional::BLEND_ALPHA
    | optional::ANTIALIAS
    | optional::PERSPECTIVE_Z
    | optional::OPEN_GL
    | optional::CL4
    | optional::CL8
    | optional::BUFFER_COMPOSITE
    | optional::NO_DITHER
    | optional::FOG_ALPHA
    | optional::FOG_DEPTH
    | optional::MULTI_TEXTURES
    | optional::MIPMAP_BIAS
    | optional::CHANNEL_MASK
    | optional::Z_BUFFER_MASK
    | optional::ALPHA_TEST
    | optional::ACCESS_TEXTURE
    | optional::ACCESS_BITMAP
    | optional::ACCESS_DRAW_BUFFER
    | optional::ACCESS_Z_BUFFER
    | optional::CLEAR_DRAW_BUFFER
    | optional::CLEAR_Z_BUFFER;

const OPTIONAL_2: u32 = optional2::TEXTURE_DRAW_CONTEXTS
    | optional2::BITMAP_DRAW_CONTEXTS
    | optional2::BUSY
    | optional2::SWAP_BUFFERS
    | optional2::CHROMAKEY
    | optional2::NON_RELOCATABLE
    | optional2::NO_COPY
    | optional2::PRIORITY_BITS
    | optional2::FLIP_ORIGIN
    | optional2::BITMAP_SCALE
    | optional2::DRAW_CONTEXT_SCALE
    | optional2::DRAW_CONTEXT_NON_RELOCATABLE;

const FAST: u32 = fast::LINE
    | fast::GOURAUD
    | fast::TEXTURE
    | fast::TEXTURE_HQ
    | fast::BLEND
    | fast::CL4
    | fast::CL8
    | fast::FOG_ALPHA
    | fast::FOG_DEPTH
    | fast::MULTI_TEXTURES
    | fast::BITMAP_SCALE
    | fast::DRAW_CONTEXT_SCALE;

/// Pixel types that contexts can have.
fn context_types() -> u32 {
    let all = PixelType::ALL.into_iter();
    all.filter(|&t| crate::front::surface_format(t).is_some()).fold(0, |mask, t| mask | t.bit())
}

/// Pixel types that pictures can have: all of them.
fn picture_types() -> u32 {
    PixelType::ALL.into_iter().fold(0, |mask, pixel_type| mask | pixel_type.bit())
}

/// An engine with what orders it among others.
#[derive(Debug)]
struct Entry {
    id: EngineId,
    vendor: i32,
    engine: i32,
    revision: u32,
    optional: u32,
    fast: u32,
    enabled: bool,
    /// `None` for the engine of this crate.
    foreign: Option<Box<dyn Engine>>,
}

/// All engines.
#[derive(Debug)]
pub(crate) struct Manager {
    engines: Vec<Entry>,
    last: u32,
    /// Moved to the front by the user.
    preferred: Option<(i32, i32)>,
}

impl Manager {
    /// A manager with this crate's engine.
    pub fn new(config: &RaveConfig) -> Manager {
        let (vendor, engine) = if config.as_apple_software { APPLE_SOFTWARE } else { FILLRATE };
        let built_in = Entry {
            id: EngineId::BUILT_IN,
            vendor,
            engine,
            revision: REVISION,
            optional: OPTIONAL,
            fast: FAST,
            enabled: true,
            foreign: None,
        };
        Manager { engines: vec![built_in], last: EngineId::BUILT_IN.0, preferred: None }
    }

    /// Puts an engine before all others.
    pub fn prefer(&mut self, vendor: i32, engine: i32) {
        self.preferred = Some((vendor, engine));
    }

    /// Registers an engine of the application; of two with one identity the one
    /// of the larger revision stays.
    ///
    /// # Errors
    /// [`RaveError::OutOfDate`], [`RaveError::OutOfMemory`], and the engine's
    /// own where it does not say who it is.
    pub fn register(&mut self, mut engine: Box<dyn Engine>) -> Result<EngineId, RaveError> {
        let mut number = |selector: u32| match engine.gestalt(selector)? {
            Answer::Number(number) => Ok(number),
            Answer::Text(_) => Err(RaveError::Parameter),
        };
        let vendor = number(selector::VENDOR_ID)? as i32;
        let identity = (vendor, number(selector::ENGINE_ID)? as i32);
        let revision = number(selector::REVISION)?;
        // Engines that do not know them have none.
        let optional = number(selector::OPTIONAL_FEATURES).unwrap_or(0);
        let fast = number(selector::FAST_FEATURES).unwrap_or(0);
        let same = |entry: &Entry| (entry.vendor, entry.engine) == identity;
        if self.engines.iter().any(|entry| same(entry) && entry.revision >= revision) {
            return Err(RaveError::OutOfDate);
        }
        if self.engines.len() >= MAX_ENGINES {
            return Err(RaveError::OutOfMemory);
        }
        // The older one's objects live on; it only cannot be found any more.
        for entry in self.engines.iter_mut().filter(|entry| same(entry)) {
            entry.enabled = false;
        }
        self.last += 1;
        let id = EngineId(self.last);
        let (vendor, number) = identity;
        let foreign = Some(engine);
        self.engines.push(Entry {
            id,
            vendor,
            engine: number,
            revision,
            optional,
            fast,
            enabled: true,
            foreign,
        });
        Ok(id)
    }

    /// Whether there are engines of the application.
    pub fn has_foreign(&self) -> bool {
        self.engines.len() > 1
    }

    /// An engine of the application.
    pub fn foreign(&mut self, id: EngineId) -> Option<&mut (dyn Engine + 'static)> {
        self.engines.iter_mut().find(|entry| entry.id == id)?.foreign.as_deref_mut()
    }

    /// The enabled engines that accept a device (`None`: any), in order: the
    /// user's choice, those bound to the device, those that accelerate most.
    pub fn engines(&mut self, device: Option<&DeviceValue>) -> Vec<EngineId> {
        let preferred = self.preferred;
        let mut found: Vec<_> = self
            .engines
            .iter_mut()
            .filter(|entry| entry.enabled)
            .filter_map(|entry| {
                entry.check_device(device).ok()?;
                let is_preferred = preferred == Some((entry.vendor, entry.engine));
                let is_bound = device.is_some() && entry.optional & optional::BOUND_TO_DEVICE != 0;
                let rank = (is_preferred, is_bound, entry.fast.count_ones());
                Some((std::cmp::Reverse(rank), entry.id))
            })
            .collect();
        found.sort();
        found.into_iter().map(|(_, id)| id).collect()
    }

    /// `QAEngineCheckDevice`.
    ///
    /// # Errors
    /// Why the engine cannot draw there.
    pub fn check_device(
        &mut self,
        id: EngineId,
        device: Option<&DeviceValue>,
    ) -> Result<(), RaveError> {
        self.entry(id)?.check_device(device)
    }

    /// `QAEngineEnable` and `QAEngineDisable`.
    ///
    /// # Errors
    /// [`RaveError::Parameter`] where there is no such engine.
    pub fn enable(&mut self, vendor: i32, engine: i32, enabled: bool) -> Result<(), RaveError> {
        // The newest of one identity is the one that counts.
        let same = |entry: &&mut Entry| entry.vendor == vendor && entry.engine == engine;
        let entry = self.engines.iter_mut().rev().find(same).ok_or(RaveError::Parameter)?;
        entry.enabled = enabled;
        Ok(())
    }

    /// `QAEngineGestalt`, but for the free texture memory of this crate's
    /// engine.
    ///
    /// # Errors
    /// [`RaveError::GestaltUnknown`], [`RaveError::Parameter`].
    pub fn gestalt(&mut self, id: EngineId, selector: u32) -> Result<Answer, RaveError> {
        let entry = self.entry(id)?;
        if let Some(foreign) = &mut entry.foreign {
            return foreign.gestalt(selector);
        }
        let preferred = PixelType::Rgb16_565.bit() | PixelType::Argb32.bit();
        Ok(Answer::Number(match selector {
            selector::OPTIONAL_FEATURES => entry.optional,
            selector::FAST_FEATURES => entry.fast,
            selector::VENDOR_ID => entry.vendor as u32,
            selector::ENGINE_ID => entry.engine as u32,
            selector::REVISION => entry.revision,
            selector::ASCII_NAME_LENGTH => NAME.len() as u32,
            selector::ASCII_NAME => return Ok(Answer::Text(NAME.to_string())),
            selector::DRAW_CONTEXT_PIXEL_TYPES_ALLOWED => context_types(),
            selector::DRAW_CONTEXT_PIXEL_TYPES_PREFERRED => preferred,
            selector::TEXTURE_PIXEL_TYPES_ALLOWED | selector::BITMAP_PIXEL_TYPES_ALLOWED => {
                picture_types()
            }
            selector::TEXTURE_PIXEL_TYPES_PREFERRED | selector::BITMAP_PIXEL_TYPES_PREFERRED => {
                PixelType::Argb32.bit()
            }
            selector::OPTIONAL_FEATURES_2 => OPTIONAL_2,
            selector::MULTI_TEXTURE_MAX => MAX_LAYERS as u32,
            selector::NUM_SELECTORS => selector::NUM_SELECTORS,
            _ => return Err(RaveError::GestaltUnknown),
        }))
    }

    fn entry(&mut self, id: EngineId) -> Result<&mut Entry, RaveError> {
        self.engines.iter_mut().find(|entry| entry.id == id).ok_or(RaveError::Parameter)
    }
}

impl Entry {
    fn check_device(&mut self, device: Option<&DeviceValue>) -> Result<(), RaveError> {
        match (&mut self.foreign, device) {
            (Some(foreign), _) => foreign.check_device(device),
            (None, Some(device)) => check_device(device).map(|_| ()),
            (None, None) => Ok(()),
        }
    }
}
