//! What everything costs: the one table of the simulator.
//!
//! A burst is a number of cycles and the share of them in which the tile issues instructions; the
//! rest are pipeline stalls (float latency, load delay).
//!
//! The values began as estimates from instruction counts. Those of plain geometry, flat colour and
//! the depth miss were then fitted to six published numbers: cycles of a tiny triangle and of a
//! pixel of a large flat one, on one tile and on sixteen, the active share of one tile, and the
//! speed-up with depth. The costs of lighting, texturing and blending were moved as well, within a
//! factor of three of their estimates, until every mode lay inside its published range; they are
//! fitted, too, and the ranges of those modes are no independent confirmation. What follows without
//! being fitted are the shapes: how speed-up and utilisation change with size, and their order.

/// Cycles of work, and how many percent of them are active.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Burst {
    /// Cycles.
    pub cycles: u32,
    /// Active share in percent, 0..=100.
    pub active: u32,
}

impl Burst {
    /// `cycles` of which `active` percent are active.
    pub const fn new(cycles: u32, active: u32) -> Self {
        Self { cycles, active }
    }

    /// This burst `count` times.
    pub const fn times(self, count: u32) -> Self {
        Self { cycles: self.cycles.saturating_mul(count), active: self.active }
    }

    /// `part` of `whole` of this burst.
    pub const fn share(self, part: u32, whole: u32) -> Self {
        let cycles = self.cycles as u64 * part as u64 / whole as u64;
        Self { cycles: cycles as u32, active: self.active }
    }
}

/// Costs of stage 1, geometry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stage1Costs {
    /// Per word of the stream.
    pub word: Burst,
    /// Per command.
    pub dispatch: Burst,
    /// Invalidating the cached state, per word.
    pub invalidate_word: Burst,
    /// Lines of the state fetched again.
    pub state_lines: u32,
    /// Ordering decision and numbers.
    pub numbering: Burst,
    /// Clearing and copying the records.
    pub records: Burst,
    /// Three vertices through the matrix.
    pub transform: Burst,
    /// Near test and back-face test.
    pub visibility: Burst,
    /// Directional light for one vertex.
    pub light_vertex: Burst,
    /// A vertex made by clipping.
    pub clip_vertex: Burst,
    /// Position and colour times 1/w, three vertices.
    pub premultiply: Burst,
    /// One more attribute times 1/w, three vertices.
    pub premultiply_extra: Burst,
    /// Comparing where two primitives lie.
    pub compare_extent: Burst,
    /// Sending, per word.
    pub send_word: Burst,
    /// Writing a pixel or a depth in command mode, as clears do for the whole screen.
    pub command_pixel: Burst,
}

/// Costs of stage 2, rasterisation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stage2Costs {
    /// Receiving a primitive, per word.
    pub receive_word: Burst,
    /// Edges, box and common terms.
    pub setup: Burst,
    /// One attribute plane.
    pub plane: Burst,
    /// Averages instead of planes.
    pub average: Burst,
    /// One row.
    pub row: Burst,
    /// One pixel tested.
    pub visit: Burst,
    /// One pixel covered.
    pub cover: Burst,
    /// Depth of a fragment.
    pub z: Burst,
    /// Interpolated colour of a fragment.
    pub color: Burst,
    /// Interpolated alpha of a fragment.
    pub alpha: Burst,
    /// Texture coordinates of a fragment.
    pub uv: Burst,
    /// Intensity of a fragment.
    pub intensity: Burst,
    /// Recovering w.
    pub reciprocal: Burst,
    /// Sending, per word.
    pub send_word: Burst,
}

/// Costs of stage 3, texturing and combining.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stage3Costs {
    /// Receiving and sending a fragment, beyond the words themselves.
    pub transfer: Burst,
    /// Every fragment.
    pub core: Burst,
    /// A nearest texel.
    pub nearest: Burst,
    /// A bilinear texel.
    pub bilinear: Burst,
    /// Blend and decal modes.
    pub blend: Burst,
    /// Modulate mode.
    pub modulate: Burst,
    /// Ambient light.
    pub ambient: Burst,
    /// Directional light.
    pub directional: Burst,
}

/// Costs of stage 4, compositing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stage4Costs {
    /// Buffering a fragment, beyond the words themselves.
    pub buffer: Burst,
    /// Drawing a fragment with the token held.
    pub pixel: Burst,
    /// Drawing a fragment in the single tile.
    pub pixel_single: Burst,
    /// Depth test.
    pub z_test: Burst,
    /// Waiting for the depth after invalidating its line.
    pub z_miss: u32,
    /// Depth write and flush.
    pub z_write: Burst,
    /// Blending, without the round trip to the frame buffer.
    pub blend: Burst,
    /// Reading the frame buffer.
    pub round_trip: u32,
    /// Taking the token and passing it on.
    pub hand_over: u32,
    /// A message to the arbiter of a bank; beyond the thesis.
    pub ask: Burst,
    /// Fragments buffered at most.
    pub buffered: usize,
}

/// The whole table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Costs {
    /// Stage 1.
    pub s1: Stage1Costs,
    /// Stage 2.
    pub s2: Stage2Costs,
    /// Stage 3.
    pub s3: Stage3Costs,
    /// Stage 4.
    pub s4: Stage4Costs,
    /// A cache miss to the memory at the row's east port.
    pub miss: u32,
    /// A memory port is busy for this long per line.
    pub port: u32,
    /// Interrupt entry, handler and exit.
    pub interrupt: u32,
    /// Injection and ejection of a dynamic message.
    pub gdn_ends: u32,
    /// The host sends a word every so many cycles.
    pub host_word: u32,
    /// Words a static path holds between two processors.
    pub path_words: usize,
    /// Cycles from one processor to its neighbour.
    pub path_latency: u32,
    /// Cycles until the switch of row 2 lets the next words in: two of control, two on the way.
    pub switch_turn: u32,
}

/// The table used throughout.
pub const COSTS: Costs = Costs {
    s1: Stage1Costs {
        word: Burst::new(10, 75),
        dispatch: Burst::new(25, 80),
        invalidate_word: Burst::new(4, 100),
        state_lines: 11,
        numbering: Burst::new(130, 70),
        records: Burst::new(200, 80),
        transform: Burst::new(510, 60),
        visibility: Burst::new(120, 70),
        light_vertex: Burst::new(120, 65),
        clip_vertex: Burst::new(150, 65),
        premultiply: Burst::new(330, 65),
        premultiply_extra: Burst::new(40, 65),
        compare_extent: Burst::new(8, 80),
        send_word: Burst::new(4, 80),
        command_pixel: Burst::new(8, 80),
    },
    s2: Stage2Costs {
        receive_word: Burst::new(4, 90),
        setup: Burst::new(950, 60),
        plane: Burst::new(50, 65),
        average: Burst::new(120, 65),
        row: Burst::new(40, 62),
        visit: Burst::new(60, 62),
        cover: Burst::new(85, 62),
        z: Burst::new(20, 70),
        color: Burst::new(25, 70),
        alpha: Burst::new(10, 70),
        uv: Burst::new(10, 70),
        intensity: Burst::new(6, 70),
        reciprocal: Burst::new(12, 0),
        send_word: Burst::new(3, 90),
    },
    s3: Stage3Costs {
        transfer: Burst::new(67, 52),
        core: Burst::new(105, 75),
        nearest: Burst::new(100, 70),
        bilinear: Burst::new(220, 70),
        blend: Burst::new(44, 70),
        modulate: Burst::new(50, 70),
        ambient: Burst::new(50, 70),
        directional: Burst::new(50, 70),
    },
    s4: Stage4Costs {
        buffer: Burst::new(15, 80),
        pixel: Burst::new(66, 80),
        pixel_single: Burst::new(100, 80),
        z_test: Burst::new(15, 80),
        z_miss: 27,
        z_write: Burst::new(15, 80),
        blend: Burst::new(158, 80),
        round_trip: 60,
        hand_over: 12,
        ask: Burst::new(6, 80),
        buffered: 16,
    },
    miss: 54,
    port: 9,
    interrupt: 20,
    gdn_ends: 4,
    host_word: 2,
    path_words: 12,
    path_latency: 4,
    switch_turn: 4,
};

impl Default for Costs {
    fn default() -> Self {
        COSTS
    }
}
