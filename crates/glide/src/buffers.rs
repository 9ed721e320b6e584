//! Clearing, swapping and showing buffers.

use fillrate_engine::state::{Dither, Origin, Rect};
use fillrate_engine::{ClearValues, FlushReason};

use crate::board::Board;
use crate::registers::fbz;
use crate::scanout::{GammaTable, Picture, gamma_table};

/// What the board shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shown {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// 565, row by row from the top left; before gamma and filter.
    pub pixels: Vec<u16>,
    /// The gamma tables of red, green and blue.
    pub gamma: [GammaTable; 3],
    /// The screen filter's thresholds for red, green and blue.
    pub thresholds: [u8; 3],
    /// The picture in all its detail, where improvements give it more than
    /// `pixels` have.
    pub detail: Option<Picture>,
}

impl Board {
    /// Fills the clip window of the buffer drawn to, by the current masks.
    ///
    /// Source: G246, `grBufferClear`; SST1, fastfillCMD: the aux plane takes alpha
    /// where it holds alpha, else depth where depth buffering is on, else what
    /// the register has, which is the depth bias.
    pub(crate) fn clear(&mut self, color: u32, alpha: u8, depth: u16) {
        self.update();
        let on = |bit: u32| self.fbi.fbz_mode & bit != 0;
        let aux = match (on(fbz::AUX_WRITE), on(fbz::ALPHA_PLANES), on(fbz::DEPTH_ENABLE)) {
            (true, true, _) => Some(u32::from(alpha)),
            (true, false, true) => Some(u32::from(depth)),
            (true, false, false) => Some(self.fbi.za_color & 0xffff),
            (false, ..) => None,
        };
        let color = on(fbz::RGB_WRITE).then(|| (self.color(color), self.dither()));
        self.fill(ClearValues { color, aux });
    }

    /// Fills the clip window of the current target.
    pub(crate) fn fill(&mut self, values: ClearValues) {
        let Some(buffers) = &self.buffers else { return };
        let rect = self.on_surface(self.clip_on_screen(buffers.height));
        self.device.clear(rect, values);
    }

    /// The dithering in use.
    pub(crate) fn dither(&self) -> Dither {
        if self.improve.color32 {
            return Dither::Off;
        }
        match (self.fbi.fbz_mode & fbz::DITHER != 0, self.fbi.fbz_mode & fbz::DITHER_2X2 != 0) {
            (false, _) => Dither::Off,
            (true, true) => Dither::Ordered2x2,
            (true, false) => Dither::Ordered4x4,
        }
    }

    /// The clip window in screen rows.
    pub(crate) fn clip_on_screen(&self, height: u32) -> Rect {
        let field = |register: u32, shift: u32| register >> shift & 0x3ff;
        let (lr, bt) = (self.fbi.clip_left_right, self.fbi.clip_bottom_top);
        let (y0, y1) = (field(bt, 16), field(bt, 0));
        let (y0, y1) = match self.origin() {
            Origin::UpperLeft => (y0, y1),
            Origin::LowerLeft => (height - y1.min(height), height - y0.min(height)),
        };
        Rect::new(field(lr, 16), y0, field(lr, 0), y1)
    }

    /// Shows the back buffer, on the clock after `interval` retraces.
    /// Contents change places, nothing is copied.
    pub(crate) fn swap(&mut self, interval: u32) {
        // What was stored so far belongs to the buffer it was stored into.
        self.commit(self.screen());
        self.device.submit(FlushReason::Swap);
        if let Some(buffers) = &mut self.buffers {
            buffers.colors.rotate_left(1);
            self.swaps += 1;
            self.dirty = true;
        }
        self.show_all(self.screen());
        self.clock.swap(interval);
    }

    /// The displayed buffer.
    pub(crate) fn shown(&mut self) -> Option<Shown> {
        let buffers = self.buffers.as_ref()?;
        let (width, height, front) = (buffers.width, buffers.height, buffers.colors[0]);
        let mut pixels = vec![0; (width * height) as usize];
        let all = Rect::new(0, 0, width, height);
        self.read_pixels(front, all, &mut pixels, width as usize).ok()?;
        let (gamma, thresholds) = (self.gamma, self.filter_thresholds);
        let detail = self.detail();
        Some(Shown { width, height, pixels, gamma, thresholds, detail })
    }

    /// Sets the gamma of all channels; others than positive numbers are
    /// refused.
    pub(crate) fn set_gamma(&mut self, gamma: f32) -> bool {
        let valid = gamma > 0.0 && gamma.is_finite();
        if valid {
            self.gamma = [gamma_table(gamma); 3];
        }
        valid
    }

    /// The status register: room in both queues, bit 6 clear in retrace, busy
    /// bits while a swap waits, the displayed buffer in bits 11..10, waiting
    /// swaps in bits 30..28.
    pub(crate) fn status(&mut self) -> u32 {
        self.clock.look();
        let retrace = if self.clock.in_retrace() { 0 } else { 1 << 6 };
        let pending = self.clock.pending();
        let busy = if pending > 0 { 1 << 7 | 1 << 9 } else { 0 };
        let count = self.buffers.as_ref().map_or(1, |buffers| buffers.colors.len() as u64);
        let displayed = (self.clock.swaps_done() % count) as u32;
        0x0fff_f03f | retrace | busy | displayed << 10 | pending << 28
    }
}
