//! The workloads: what they draw and how it is counted.

use fillrate_glide::GrVertex;

use super::scene::{self, Quad};
use super::size::Size;

/// What a workload draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Quads of one colour each, no depth.
    Flat,
    /// Quads with colours at their corners, depth tested.
    Gouraud,
    /// The same, textured in perspective.
    Textured,
    /// Textured quads blended by their alpha, depth not written.
    Blended,
    /// Two textures and fog.
    TwoTextures,
    /// Small textured triangles of `area` pixels, depth tested.
    Triangles {
        /// Triangles of a frame.
        count: usize,
        /// Pixels of each.
        area: u32,
    },
    /// A clear of both planes, and what makes it matter.
    Clear {
        /// A pixel drawn in every 32x32 pixels, so that all memory has to be
        /// written; otherwise one in all.
        written: bool,
    },
}

/// A workload.
#[derive(Clone, Copy, Debug)]
pub struct Workload {
    /// The name that all renderers measured share.
    pub name: &'static str,
    /// What it draws.
    pub kind: Kind,
    /// Nearest layer first: only the first passes the depth test.
    pub front_to_back: bool,
}

const fn workload(name: &'static str, kind: Kind, front_to_back: bool) -> Workload {
    Workload { name, kind, front_to_back }
}

/// All of them.
pub const WORKLOADS: [Workload; 13] = [
    workload("W1_fill_flat", Kind::Flat, false),
    workload("W2_gouraud_z_b2f", Kind::Gouraud, false),
    workload("W2_gouraud_z_f2b", Kind::Gouraud, true),
    workload("W3_tex_bilin_z_b2f", Kind::Textured, false),
    workload("W3_tex_bilin_z_f2b", Kind::Textured, true),
    workload("W4_tex_blend", Kind::Blended, false),
    workload("W5_multitex_fog_z", Kind::TwoTextures, false),
    workload("W6a_tri_10px", Kind::Triangles { count: 1_000_000, area: 10 }, false),
    workload("W6b_tri_2px", Kind::Triangles { count: 1_000_000, area: 2 }, false),
    workload("W7_tri_100px", Kind::Triangles { count: 100_000, area: 100 }, false),
    workload("W8_clear", Kind::Clear { written: false }, false),
    workload("W8_clear_written", Kind::Clear { written: true }, false),
    workload("W9_immediate", Kind::Triangles { count: 200_000, area: 10 }, false),
];

/// Layers of the full-screen workloads.
pub const OVERDRAW: u32 = 20;
/// Pixels between those that make a clear be written, in each direction.
const CLEAR_STEP: u32 = 32;

impl Workload {
    /// The workload of that name.
    pub fn by_name(name: &str) -> Option<Workload> {
        WORKLOADS.into_iter().find(|workload| workload.name == name)
    }

    /// One of `parts` surfaces' share: the triangles are divided, full-screen
    /// layers are not.
    pub fn share(self, parts: usize) -> Workload {
        match self.kind {
            Kind::Triangles { count, area } => {
                Workload { kind: Kind::Triangles { count: count / parts, area }, ..self }
            }
            _ => self,
        }
    }

    /// What is counted.
    pub fn unit(&self) -> &'static str {
        if matches!(self.kind, Kind::Triangles { .. }) { "Mtri/s" } else { "Mpix/s" }
    }

    /// Pixels or triangles of a frame.
    pub fn count(&self, size: Size) -> f64 {
        let pixels = f64::from(size.width) * f64::from(size.height);
        match self.kind {
            Kind::Triangles { count, .. } => count as f64,
            Kind::Clear { .. } => pixels,
            _ => pixels * f64::from(OVERDRAW),
        }
    }

    /// Whether depth is tested.
    pub fn uses_depth(&self) -> bool {
        self.kind != Kind::Flat
    }

    /// Whether depth is written.
    pub fn writes_depth(&self) -> bool {
        !matches!(self.kind, Kind::Flat | Kind::Blended)
    }

    /// A frame's triangles.
    pub fn vertices(&self, size: Size) -> Vec<GrVertex> {
        let screen = (size.width as f32, size.height as f32);
        let layers = |gouraud: bool, perspective: bool, alpha: u32| {
            let quad = |i: u32| {
                let at = 0.04 * i as f32;
                let near = match (self.uses_depth(), self.front_to_back) {
                    (false, _) => 0.5,
                    (true, true) => 0.1 + at,
                    (true, false) => 0.9 - at,
                };
                scene::quad(screen, &Quad { near, gouraud, perspective, alpha, seed: i + 1 })
            };
            (0..OVERDRAW).flat_map(quad).collect()
        };
        match self.kind {
            Kind::Flat => layers(false, false, 255),
            Kind::Gouraud => layers(true, false, 255),
            Kind::Textured | Kind::TwoTextures => layers(true, true, 255),
            Kind::Blended => layers(true, true, 160),
            Kind::Triangles { count, area } => scene::triangles(count, screen, area as f32),
            Kind::Clear { written: false } => scene::triangles(1, screen, 1.0),
            Kind::Clear { written: true } => scene::dots(screen, CLEAR_STEP),
        }
    }
}
