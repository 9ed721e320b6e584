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
    resources: Vec<ResourceId>,
    polygons: u64,
    /// Runs before.
    runs: Vec<(Vec<ResourceId>, u64)>,
}

impl Usage {
    /// Counts a polygon.
    #[inline]
    pub fn add(&mut self, resources: &[ResourceId]) {
        if self.resources != resources {
            self.close();
            self.resources.extend_from_slice(resources);
        }
        self.polygons += 1;
    }

    fn close(&mut self) {
        let resources = std::mem::take(&mut self.resources);
        if self.polygons > 0 && !resources.is_empty() {
            self.runs.push((resources, self.polygons));
        }
        self.polygons = 0;
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
