//! The library: engines, draw contexts and other objects by number.

use fillrate_engine::DeviceConfig;

use crate::call::{Call, Reply};

/// How a library works.
#[derive(Clone, Debug)]
pub struct RaveConfig {
    /// How the engine draws; none of it changes a pixel.
    pub device: DeviceConfig,
    /// Draws frames while the program goes on.
    pub asynchronous: bool,
    /// Bytes for textures.
    pub texture_memory: u64,
    /// Says that the engine is Apple's software engine, for programs that look
    /// for that one.
    pub as_apple_software: bool,
}

impl Default for RaveConfig {
    /// All cores, asynchronous, 16 MB of textures, under its own name.
    fn default() -> RaveConfig {
        RaveConfig {
            device: DeviceConfig::default(),
            asynchronous: true,
            texture_memory: 16 << 20,
            as_apple_software: false,
        }
    }
}

/// A RAVE library without global state.
#[derive(Debug)]
pub struct Context {
    config: RaveConfig,
}

impl Context {
    /// A library without objects besides its engine.
    pub fn new(config: RaveConfig) -> Context {
        Context { config }
    }

    /// How it works.
    pub fn config(&self) -> &RaveConfig {
        &self.config
    }

    /// Carries a call out.
    pub fn execute(&mut self, call: &Call) -> Reply {
        let _ = call;
        Reply::Nothing
    }
}
