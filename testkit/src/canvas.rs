//! What scenes draw on: the reference or a device, without knowing which.

use std::sync::Arc;

use fillrate_engine::state::{DrawState, MAX_TMUS, Rect};
use fillrate_engine::{
    ClearValues, Cull, Device, DeviceConfig, EngineError, PixelFormat, PixelRun, Registers,
    SurfaceId, Texture, VeriteExtra, VeriteVertex, Vertex, VertexExtra,
};

use crate::reference::{Reference, Textures};

/// The drawing commands of a [`Device`].
pub trait Canvas {
    /// Chooses how to draw what follows.
    fn set_state(&mut self, state: &DrawState, textures: &Textures);
    /// Sets a triangle up and draws it.
    fn triangle(&mut self, vertices: &[Vertex; 3], cull: Cull);
    /// Sets a triangle up with what its vertices have besides, and draws it.
    fn extended(&mut self, vertices: &[Vertex; 3], extras: &[VertexExtra; 3], cull: Cull);
    /// Sets a triangle up as the Vérité's and draws it.
    fn verite(&mut self, corners: &[(VeriteVertex, VeriteExtra); 3]);
    /// Draws a triangle that was set up elsewhere.
    fn launch(&mut self, registers: &Registers);
    /// Draws ready-made fragments.
    fn pixels(&mut self, run: &PixelRun<'_>);
    /// Fills a rectangle of the screen.
    fn clear(&mut self, rect: Rect, values: ClearValues);
}

/// The reference with a current state.
#[derive(Clone, Debug)]
pub struct ReferenceCanvas {
    /// What was drawn so far.
    pub reference: Reference,
    state: DrawState,
    textures: Textures,
}

impl ReferenceCanvas {
    /// Surfaces of zeros and the default state.
    pub fn new(reference: Reference) -> ReferenceCanvas {
        let textures = [const { None::<Arc<Texture>> }; MAX_TMUS];
        ReferenceCanvas { reference, state: DrawState::default(), textures }
    }
}

impl Canvas for ReferenceCanvas {
    fn set_state(&mut self, state: &DrawState, textures: &Textures) {
        self.state = *state;
        self.textures.clone_from(textures);
    }

    fn triangle(&mut self, vertices: &[Vertex; 3], cull: Cull) {
        self.reference.triangle(&self.state, &self.textures, vertices, cull);
    }

    fn extended(&mut self, vertices: &[Vertex; 3], extras: &[VertexExtra; 3], cull: Cull) {
        self.reference.extended(&self.state, &self.textures, vertices, extras, cull);
    }

    fn verite(&mut self, corners: &[(VeriteVertex, VeriteExtra); 3]) {
        self.reference.verite(&self.state, &self.textures, corners);
    }

    fn launch(&mut self, registers: &Registers) {
        self.reference.launch(&self.state, &self.textures, registers);
    }

    fn pixels(&mut self, run: &PixelRun<'_>) {
        self.reference.pixels(&self.state, run);
    }

    fn clear(&mut self, rect: Rect, values: ClearValues) {
        self.reference.clear(rect, values);
    }
}

/// A device drawing on a colour surface and, on demand, an aux surface of its
/// own.
#[derive(Debug)]
pub struct DeviceCanvas {
    device: Device,
    size: (u32, u32),
    color: SurfaceId,
    aux: Option<SurfaceId>,
}

impl DeviceCanvas {
    /// A device with surfaces of zeros.
    ///
    /// # Errors
    /// As [`Device::new`] and [`Device::create_surface`].
    pub fn new(
        config: DeviceConfig,
        (width, height): (u32, u32),
        format: PixelFormat,
        aux: Option<PixelFormat>,
    ) -> Result<DeviceCanvas, EngineError> {
        let mut device = Device::new(config)?;
        let color = device.create_surface(width, height, format)?;
        let aux = match aux {
            Some(aux) => Some(device.create_surface(width, height, aux)?),
            None => None,
        };
        device.set_target(color, aux)?;
        Ok(DeviceCanvas { device, size: (width, height), color, aux })
    }

    /// The same device with fresh surfaces; the old ones are destroyed and the
    /// counters reset.
    ///
    /// # Errors
    /// As [`Device::create_surface`].
    pub fn renew(
        &mut self,
        (width, height): (u32, u32),
        format: PixelFormat,
        aux: Option<PixelFormat>,
    ) -> Result<(), EngineError> {
        let device = &mut self.device;
        let old = [Some(self.color), self.aux];
        self.color = device.create_surface(width, height, format)?;
        self.aux = match aux {
            Some(aux) => Some(device.create_surface(width, height, aux)?),
            None => None,
        };
        self.size = (width, height);
        device.set_target(self.color, self.aux)?;
        old.into_iter().flatten().try_for_each(|id| device.destroy_surface(id))?;
        device.reset_counters();
        Ok(())
    }

    /// How the device works.
    pub fn config(&self) -> &DeviceConfig {
        self.device.config()
    }

    /// Puts elements into the surfaces, row by row from the top.
    pub fn load(&mut self, color: &[u32], aux: Option<&[u32]>) {
        store(&mut self.device, self.color, color.iter().copied());
        if let (Some(id), Some(aux)) = (self.aux, aux) {
            store(&mut self.device, id, aux.iter().copied());
        }
    }

    /// What was drawn, in the reference's form. A flush.
    pub fn result(&mut self) -> Reference {
        let counters = self.device.counters();
        let (format, color) = elements(&mut self.device, self.color);
        let aux = self.aux.map(|id| elements(&mut self.device, id));
        Reference {
            width: self.size.0,
            height: self.size.1,
            format,
            color,
            aux_format: aux.as_ref().map(|aux| aux.0),
            aux: aux.map(|aux| aux.1),
            counters,
        }
    }
}

fn store(device: &mut Device, id: SurfaceId, values: impl Iterator<Item = u32>) {
    let surface = device.surface(id).expect("the canvas owns its surfaces");
    let (width, height) = (surface.width(), surface.height());
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    places.zip(values).for_each(|((x, y), value)| surface.set(x, y, value));
}

fn elements(device: &mut Device, id: SurfaceId) -> (PixelFormat, Vec<u32>) {
    let surface = device.surface(id).expect("the canvas owns its surfaces");
    let (width, height) = (surface.width(), surface.height());
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    (surface.format(), places.map(|(x, y)| surface.get(x, y)).collect())
}

impl Canvas for DeviceCanvas {
    fn set_state(&mut self, state: &DrawState, textures: &Textures) {
        self.device.set_state(state, textures.clone());
    }

    fn triangle(&mut self, [a, b, c]: &[Vertex; 3], cull: Cull) {
        self.device.draw_triangle([a, b, c], cull);
    }

    fn extended(&mut self, vertices: &[Vertex; 3], extras: &[VertexExtra; 3], cull: Cull) {
        self.device.draw_extended(vertices.each_ref(), extras.each_ref(), cull);
    }

    fn verite(&mut self, corners: &[(VeriteVertex, VeriteExtra); 3]) {
        if corners.iter().any(|corner| corner.1 != VeriteExtra::default()) {
            *self.device.draw_verite_extended().expect("the canvas is a target") = *corners;
        } else {
            let vertices = corners.map(|corner| corner.0);
            *self.device.draw_verite().expect("the canvas is a target") = vertices;
        }
    }

    fn launch(&mut self, registers: &Registers) {
        self.device.launch(registers);
    }

    fn pixels(&mut self, run: &PixelRun<'_>) {
        self.device.draw_pixels(run);
    }

    fn clear(&mut self, rect: Rect, values: ClearValues) {
        self.device.clear(rect, values);
    }
}
