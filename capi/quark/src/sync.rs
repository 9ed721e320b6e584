//! Members that programs set by themselves: what was seen of them last.

use fillrate_guard::read;
use fillrate_quark::{Call, StateValue};

use crate::layout::{RawGpu, RawState};
use crate::session::Session;

/// What is known of a texture.
#[derive(Debug)]
pub struct KnownTexture {
    /// Its number at the border.
    pub number: u32,
    /// Whether keyed modes leave texels out.
    pub keyed: bool,
    /// Grows with each change, so that states which use it are told again.
    pub version: u64,
    /// Its texels in our memory; null before `Init`.
    pub block: *mut u8,
}

// SAFETY: the block belongs to the session's memory, which one thread at a time
// uses.
unsafe impl Send for KnownTexture {}

impl KnownTexture {
    /// A texture that was not seen before. Programs that fill the members
    /// themselves have their key applied already.
    pub fn new(number: u32) -> KnownTexture {
        KnownTexture { number, keyed: true, version: 0, block: std::ptr::null_mut() }
    }
}

/// A state and the version of its texture.
type Seen = (StateValue, u64);

/// The members of a processor as the library knows them.
#[derive(Debug, Default)]
pub struct KnownGpu {
    /// Its number at the border.
    pub number: u32,
    /// Text, line and sprite states.
    states: [Seen; 3],
    triangle_state: Option<Seen>,
    triangle_mode: i32,
    view_matrix: Option<[i32; 12]>,
    zc_error_max: i32,
    /// Zoom, near, far, and normals.
    camera: [i32; 3],
    frustum: [[i32; 3]; 4],
    frame_counter: i32,
    /// The frame buffer's words, once the program asked for them.
    pub frame: Option<FrameWords>,
}

/// The frame buffer as the program sees it.
#[derive(Debug)]
pub struct FrameWords {
    /// In the session's memory.
    pub block: *mut u32,
    /// What the program was shown last.
    pub shown: Vec<u32>,
}

// SAFETY: the block belongs to the session's memory, which one thread at a time
// uses.
unsafe impl Send for FrameWords {}

impl KnownGpu {
    /// A processor as `Init` leaves it.
    pub fn new(number: u32, raw: &RawGpu) -> KnownGpu {
        let state = StateValue {
            draw_mode: raw.text_state.draw_mode,
            draw_color: raw.text_state.draw_color,
            draw_intensity: raw.text_state.draw_intensity,
            test_culling: raw.text_state.test_culling,
            z_sort: raw.text_state.z_sort,
            texture: 0,
        };
        KnownGpu {
            number,
            states: [(state, 0); 3],
            triangle_mode: raw.triangle_mode,
            camera: [raw.zoom, raw.clip_near, raw.clip_far],
            frustum: raw.frustum,
            ..KnownGpu::default()
        }
    }

    /// Takes over what a call of the library changed.
    pub fn camera_changed(&mut self, raw: &RawGpu) {
        self.camera = [raw.zoom, raw.clip_near, raw.clip_far];
        self.frustum = raw.frustum;
    }

    /// Takes over the count of a frame that was shown.
    pub fn frame_counted(&mut self, count: i32) {
        self.frame_counter = count;
    }
}

/// Which of the processor's own states a call reads.
#[derive(Clone, Copy)]
pub enum OwnState {
    /// `TextState`.
    Text,
    /// `LineState`.
    Line,
    /// `SpriteState`.
    Sprite,
}

impl Session {
    /// A state's value, its texture brought up to date.
    ///
    /// # Safety
    /// The texture is null or can be read with its texels.
    pub unsafe fn state_value(&mut self, raw: &RawState) -> (StateValue, u64) {
        // SAFETY: the caller's promise.
        let (texture, version) = unsafe { self.sync_texture(raw.texture) };
        let value = StateValue {
            draw_mode: raw.draw_mode,
            draw_color: raw.draw_color,
            draw_intensity: raw.draw_intensity,
            test_culling: raw.test_culling,
            z_sort: raw.z_sort,
            texture,
        };
        (value, version)
    }

    /// Tells the library of one of a processor's own states.
    ///
    /// # Safety
    /// As [`Session::state_value`].
    pub unsafe fn sync_own_state(&mut self, address: usize, raw: &RawGpu, which: OwnState) {
        let state = match which {
            OwnState::Text => &raw.text_state,
            OwnState::Line => &raw.line_state,
            OwnState::Sprite => &raw.sprite_state,
        };
        // SAFETY: the caller's promise.
        let seen = unsafe { self.state_value(state) };
        let Some(known) = self.gpus.get_mut(&address) else { return };
        if known.states[which as usize] == seen {
            return;
        }
        known.states[which as usize] = seen;
        let (gpu, state) = (known.number, seen.0);
        self.call(&match which {
            OwnState::Text => Call::TextState { gpu, state },
            OwnState::Line => Call::LineState { gpu, state },
            OwnState::Sprite => Call::SpriteState { gpu, state },
        });
    }

    /// Tells the library of the triangle state.
    ///
    /// # Safety
    /// `TriangleState` is null or points to a state; and as
    /// [`Session::state_value`].
    pub unsafe fn sync_triangle_state(&mut self, address: usize, raw: &RawGpu) {
        // SAFETY: the caller's promise.
        let state = unsafe { read(raw.triangle_state) };
        // SAFETY: the caller's promise.
        let seen = state.map(|state| unsafe { self.state_value(&state) });
        let Some(known) = self.gpus.get_mut(&address) else { return };
        if known.triangle_state != seen {
            known.triangle_state = seen;
            let (gpu, state) = (known.number, seen.map(|(state, _)| state));
            self.call(&Call::TriangleState { gpu, state });
        }
    }

    /// Tells the library of how triangles are drawn.
    pub fn sync_triangle_mode(&mut self, address: usize, raw: &RawGpu) {
        let Some(known) = self.gpus.get_mut(&address) else { return };
        let gpu = known.number;
        let mode = (known.triangle_mode != raw.triangle_mode).then_some(raw.triangle_mode);
        let error = (known.zc_error_max != raw.zc_error_max).then_some(raw.zc_error_max);
        known.triangle_mode = raw.triangle_mode;
        known.zc_error_max = raw.zc_error_max;
        if let Some(mode) = mode {
            self.call(&Call::TriangleMode { gpu, mode });
        }
        if let Some(error) = error {
            self.call(&Call::ZcErrorMax { gpu, error });
        }
    }

    /// Tells the library of the camera.
    pub fn sync_camera(&mut self, address: usize, raw: &RawGpu) {
        let Some(known) = self.gpus.get_mut(&address) else { return };
        let camera = [raw.zoom, raw.clip_near, raw.clip_far];
        if (known.camera, known.frustum) != (camera, raw.frustum) {
            known.camera_changed(raw);
            let (gpu, [zoom, near, far]) = (known.number, camera);
            self.call(&Call::Camera { gpu, zoom, near, far, frustum: raw.frustum });
        }
    }

    /// Tells the library of the view matrix.
    ///
    /// # Safety
    /// `ViewMatrix` is null or points to a matrix.
    pub unsafe fn sync_view_matrix(&mut self, address: usize, raw: &RawGpu) {
        // SAFETY: the caller's promise.
        let matrix = unsafe { read(raw.view_matrix) };
        let Some(known) = self.gpus.get_mut(&address) else { return };
        if known.view_matrix != matrix {
            known.view_matrix = matrix;
            let gpu = known.number;
            self.call(&Call::ViewMatrix { gpu, matrix });
        }
    }

    /// Tells the library of the frame counter.
    pub fn sync_frame_counter(&mut self, address: usize, raw: &RawGpu) {
        let Some(known) = self.gpus.get_mut(&address) else { return };
        if known.frame_counter != raw.frame_counter {
            known.frame_counter = raw.frame_counter;
            let (gpu, count) = (known.number, raw.frame_counter);
            self.call(&Call::FrameCounter { gpu, count });
        }
    }
}
