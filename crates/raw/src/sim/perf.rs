//! The performance counters of the experiment, and the metrics derived from them.
//!
//! Source: RAW, section 5.2 (performance counters).

/// The counters of one run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Cycles while counting was on.
    pub render_cycles: u64,
    /// Cycles while counting was on inside a scene.
    pub stream_cycles: u64,
    /// Active cycles of each stage, in hundredths, summed over its tiles.
    pub active: [u64; 4],
    /// Frames, as the host reported them.
    pub frames: u64,
    /// Primitives, as the host reported them.
    pub prims: u64,
    /// Primitives visible after stage 1.
    pub drawn_prims: u64,
    /// Fragments made by stage 2.
    pub frags: u64,
    /// Fragments that went through stage 3.
    pub tex_frags: u64,
    /// Texels looked up, one per textured fragment.
    pub texels: u64,
    /// Data words written by the frame-buffer controller.
    pub pixels: u64,
}

impl Counters {
    /// Utilisation of each stage over `columns` tiles, 0..=1.
    pub fn utilisation(&self, columns: usize) -> [f64; 4] {
        self.active.map(|a| ratio(a, 100 * columns as u64 * self.stream_cycles))
    }

    /// Utilisation of the whole chip: the mean of the stages.
    pub fn chip_utilisation(&self, columns: usize) -> f64 {
        self.utilisation(columns).iter().sum::<f64>() / 4.0
    }

    /// Utilisation of a single-tile run: its one tile counts as stage 1.
    pub fn single_utilisation(&self) -> f64 {
        ratio(self.active[0], 100 * self.stream_cycles)
    }

    /// Pixels per second at `hertz`.
    pub fn pixel_rate(&self, hertz: f64) -> f64 {
        self.pixels as f64 / self.stream_cycles.max(1) as f64 * hertz
    }

    /// Drawn primitives per second at `hertz`.
    pub fn triangle_rate(&self, hertz: f64) -> f64 {
        self.drawn_prims as f64 / self.stream_cycles.max(1) as f64 * hertz
    }

    /// The report the simulator printed: three lines.
    pub fn report(&self) -> String {
        let [a, b, c, d] = self.active.map(|a| a / 100);
        format!(
            "RenderCycles {} StreamCycles {}\nStage1 {a} Stage2 {b} Stage3 {c} Stage4 {d}\n\
             Frames {} Prims {} DrawnPrims {} Frags {} TexFrags {} Texels {} Pixels {}\n",
            self.render_cycles,
            self.stream_cycles,
            self.frames,
            self.prims,
            self.drawn_prims,
            self.frags,
            self.tex_frags,
            self.texels,
            self.pixels
        )
    }
}

fn ratio(part: u64, whole: u64) -> f64 {
    if whole == 0 { 0.0 } else { part as f64 / whole as f64 }
}
