//! The reference: the whole fragment pipeline, one pixel at a time.
//!
//! Nothing here is fast. Every pixel of the surface is asked whether a
//! triangle covers it, every value is computed from the start registers, every
//! quotient is an exact integer division. Stages follow the hardware's order,
//! one file each.
//!
//! Source: SST1, pixel pipeline; G246, triangle set-up.

mod combine;
mod coverage;
mod depth;
mod dither;
mod fog;
mod iterate;
mod lod;
mod log2;
mod output;
mod pixel;
mod setup;
mod shade;
mod texture;

use std::sync::Arc;

use fillrate_engine::state::{DrawState, MAX_TMUS, Origin, Rect};
use fillrate_engine::{
    ClearValues, Counters, Cull, PixelFormat, PixelRun, Registers, Texture, VeriteExtra,
    VeriteVertex, Vertex, VertexExtra,
};

pub use dither::{pack, unpack};
pub use log2::{log2_8_f64, log2_8_u64};
pub use setup::{SetUp, set_up, set_up_extended, set_up_verite};

use pixel::{Iterated, Position, Shaded};

/// The textures of a chain, by unit.
pub type Textures = [Option<Arc<Texture>>; MAX_TMUS];

/// A colour surface, an aux surface and counters, drawn on by the definition
/// of the pipeline.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reference {
    /// Columns, at least 1.
    pub width: u32,
    /// Rows, at least 1.
    pub height: u32,
    /// Format of the colour elements.
    pub format: PixelFormat,
    /// Colour elements, row by row from the top of the screen.
    pub color: Vec<u32>,
    /// Format of the aux elements, where there are any. Without them there is no
    /// depth test, no aux write, and no alpha plane.
    pub aux_format: Option<PixelFormat>,
    /// Aux elements in the same order.
    pub aux: Option<Vec<u32>>,
    /// What happened so far.
    pub counters: Counters,
}

impl Reference {
    /// Surfaces of zeros.
    pub fn new(
        width: u32,
        height: u32,
        format: PixelFormat,
        aux: Option<PixelFormat>,
    ) -> Reference {
        let area = width as usize * height as usize;
        Reference {
            width,
            height,
            format,
            color: vec![0; area],
            aux_format: aux,
            aux: aux.map(|_| vec![0; area]),
            counters: Counters::default(),
        }
    }

    /// Sets a triangle up and draws it.
    pub fn triangle(
        &mut self,
        state: &DrawState,
        textures: &Textures,
        vertices: &[Vertex; 3],
        cull: Cull,
    ) {
        self.counters.triangles_in += 1;
        if let SetUp::Drawn(registers) = set_up(vertices, cull) {
            self.counters.triangles_drawn += 1;
            self.raster(state, textures, &registers);
        }
    }

    /// Sets a triangle up with what its vertices have besides, and draws it.
    pub fn extended(
        &mut self,
        state: &DrawState,
        textures: &Textures,
        vertices: &[Vertex; 3],
        extras: &[VertexExtra; 3],
        cull: Cull,
    ) {
        self.counters.triangles_in += 1;
        if let SetUp::Drawn(registers) = setup::set_up_extended(vertices, extras, cull) {
            self.counters.triangles_drawn += 1;
            self.raster(state, textures, &registers);
        }
    }

    /// Sets a triangle up as the Vérité's and draws it.
    pub fn verite(
        &mut self,
        state: &DrawState,
        textures: &Textures,
        corners: &[(VeriteVertex, VeriteExtra); 3],
    ) {
        self.counters.triangles_in += 1;
        if let SetUp::Drawn(registers) = set_up_verite(corners) {
            self.counters.triangles_drawn += 1;
            self.raster(state, textures, &registers);
        }
    }

    /// Draws a triangle that was set up elsewhere.
    pub fn launch(&mut self, state: &DrawState, textures: &Textures, registers: &Registers) {
        self.counters.triangles_in += 1;
        self.counters.triangles_drawn += 1;
        self.raster(state, textures, registers);
    }

    /// Draws ready-made fragments: no coverage, no textures, no combine, no
    /// depth bias. Depth serves as z and as pseudo-float w.
    pub fn pixels(&mut self, state: &DrawState, run: &PixelRun<'_>) {
        for ((&argb, &depth), index) in run.colors.iter().zip(run.depths).zip(0u64..) {
            let x = u64::from(run.x) + index;
            if x >= u64::from(self.width) || run.y >= self.height {
                return;
            }
            let at = self.position(state, x as u32, run.y);
            let [r, g, b, alpha] = dither::channels(argb);
            let depth = i32::from(depth);
            let values = Iterated {
                z: depth,
                w: depth,
                deep: depth as u32,
                is_outside: false,
                alpha,
                fog_part: None,
                bias: None,
            };
            let shaded = Shaded { other: [r, g, b], out: [r, g, b, alpha] };
            self.fragment(state, at, values, || Some(shaded));
        }
    }

    /// Fills a rectangle given in screen coordinates.
    pub fn clear(&mut self, rect: Rect, values: ClearValues) {
        for y in rect.y0..rect.y1.min(self.height) {
            for x in rect.x0..rect.x1.min(self.width) {
                let index = (y * self.width + x) as usize;
                if let Some((argb, dither)) = values.color {
                    self.color[index] = pack(self.format, argb, dither, x, y);
                }
                if let (Some(value), Some(aux)) = (values.aux, &mut self.aux) {
                    aux[index] = value & self.aux_format.map_or(0, PixelFormat::element_mask);
                }
                self.counters.pixels_out += 1;
            }
        }
    }

    fn raster(&mut self, state: &DrawState, textures: &Textures, registers: &Registers) {
        let start = iterate::centred(registers);
        for y in 0..self.height {
            for x in 0..self.width {
                if !coverage::covers(registers, x, y) {
                    continue;
                }
                let at = self.position(state, x, y);
                let colors = iterate::colors(&start, x, y);
                let values = Iterated {
                    z: iterate::z(&start, state.depth.z_overflow, x, y),
                    deep: depth::deep(state.depth.source, &start, x, y),
                    is_outside: iterate::is_z_outside(&start, x, y),
                    w: depth::float_w(iterate::w(&start, x, y)),
                    alpha: colors[3],
                    fog_part: Some(iterate::second(&start, x, y)[3]),
                    bias: state.depth.bias,
                };
                self.fragment(state, at, values, || {
                    let texel = texture::chain(state, textures, &start, at)?;
                    let mut shaded = combine::pixel(state, colors, values.z, texel);
                    let [r, g, b, _] = iterate::second(&start, x, y);
                    let inputs = shade::ShadeInputs {
                        iterated: colors,
                        over: iterate::whole_colors(&start, x, y),
                        texel,
                        specular: [r, g, b],
                        base: iterate::third(&start, x, y),
                    };
                    shaded.out = shade::apply(state, shaded.out, &inputs);
                    Some(shaded)
                });
            }
        }
    }

    /// A pixel of the surface by its drawing coordinates.
    fn position(&self, state: &DrawState, x: u32, y: u32) -> Position {
        let row = match state.origin {
            Origin::UpperLeft => y,
            Origin::LowerLeft => self.height - 1 - y,
        };
        Position { x, y, row }
    }
}
