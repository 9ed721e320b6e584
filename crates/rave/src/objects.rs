//! What belongs to the engine and is shared by its contexts.

use std::collections::BTreeMap;

use crate::RaveError;
use crate::color_table::ColorTable;
use crate::memory::{MemoryConfig, MemoryError, ResourceId, TextureMemory};
use crate::texture::Picture;

/// Textures, bitmaps and colour tables, by number.
#[derive(Debug)]
pub(crate) struct Objects {
    pub textures: BTreeMap<u32, Picture>,
    pub bitmaps: BTreeMap<u32, Picture>,
    pub tables: BTreeMap<u32, ColorTable>,
    /// The books of the modelled board.
    pub memory: TextureMemory<()>,
    pub usage: Usage,
    /// Numbers given so far.
    pub numbers: u32,
}

impl Objects {
    pub fn new(memory: MemoryConfig) -> Objects {
        Objects {
            textures: BTreeMap::new(),
            bitmaps: BTreeMap::new(),
            tables: BTreeMap::new(),
            memory: TextureMemory::new(memory),
            usage: Usage::default(),
            numbers: 0,
        }
    }

    /// A number for a new object.
    pub fn number(&mut self) -> u32 {
        self.numbers += 1;
        self.numbers
    }

    /// Enters what was drawn into the books.
    pub fn settle(&mut self) {
        self.usage.settle(&self.memory);
    }
}

/// Polygons that were drawn with the same textures in a row, not in the books
/// yet.
#[derive(Debug, Default)]
pub(crate) struct Usage {
    /// Tells whose they are; 0 where there are none.
    serial: u64,
    resources: Vec<ResourceId>,
    polygons: u64,
    /// Runs before.
    runs: Vec<(Vec<ResourceId>, u64)>,
}

impl Usage {
    /// Counts a polygon. Those of one serial, which is not 0, have the same
    /// resources.
    #[inline]
    pub fn add(&mut self, serial: u64, resources: &[ResourceId]) {
        if self.serial != serial {
            self.open(serial, resources);
        }
        self.polygons += 1;
    }

    #[cold]
    fn open(&mut self, serial: u64, resources: &[ResourceId]) {
        self.close();
        self.serial = serial;
        self.resources.extend_from_slice(resources);
    }

    fn close(&mut self) {
        let polygons = std::mem::take(&mut self.polygons);
        let resources = std::mem::take(&mut self.resources);
        self.serial = 0;
        match self.runs.last_mut() {
            _ if polygons == 0 || resources.is_empty() => {}
            Some((last, count)) if *last == resources => *count += polygons,
            _ => self.runs.push((resources, polygons)),
        }
    }

    fn settle(&mut self, memory: &TextureMemory<()>) {
        self.close();
        for (resources, polygons) in self.runs.drain(..) {
            // Resources of drawn polygons exist: deletions settle first.
            let _ = memory.submit(&resources, polygons);
        }
    }
}

impl From<MemoryError> for RaveError {
    fn from(error: MemoryError) -> RaveError {
        match error {
            MemoryError::OutOfVideoMemory => RaveError::OutOfVideoMemory,
            MemoryError::OutOfMemory => RaveError::OutOfMemory,
            _ => RaveError::Parameter,
        }
    }
}
