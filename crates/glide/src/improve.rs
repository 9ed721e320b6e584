//! Improvements on the board, all off by default: more pixels, more colours.
//!
//! Programs see the board they know: buffers of the resolution they opened,
//! with 565 pixels. A pixel that is read is the middle one of those drawn for
//! it; one that is written replaces all of them, and untouched ones keep their
//! detail.

use fillrate_engine::state::Rect;
use fillrate_engine::target::{pack, unpack};
use fillrate_engine::{EngineError, PixelFormat, PixelRun, SurfaceId};

use crate::board::Board;
use crate::scanout::Picture;

/// The largest scale.
pub use fillrate_engine::setup::MAX_SCALE;

/// What is improved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Improvements {
    /// Every pixel is drawn as so many by so many, 1 to [`MAX_SCALE`].
    pub scale: u32,
    /// Colours keep eight bits a channel; nothing is dithered.
    pub color32: bool,
    /// Pictures have the board's size again: each pixel is the mean of those
    /// drawn for it.
    pub supersample: bool,
}

impl Default for Improvements {
    fn default() -> Improvements {
        Improvements { scale: 1, color32: false, supersample: false }
    }
}

impl Improvements {
    /// The format of colour buffers.
    pub(crate) fn color_format(self) -> PixelFormat {
        if self.color32 { PixelFormat::Argb8888 } else { PixelFormat::Rgb565 }
    }

    /// Whether pictures differ from what the buffer reads as.
    fn shows_more(self) -> bool {
        self.scale > 1 || self.color32
    }

    fn scaled(self, rect: Rect) -> Rect {
        let [x0, y0, x1, y1] =
            [rect.x0, rect.y0, rect.x1, rect.y1].map(|v| v.saturating_mul(self.scale));
        Rect::new(x0, y0, x1, y1)
    }
}

/// A 16-bit element of what a surface holds.
fn element(format: PixelFormat, value: u32) -> u16 {
    use fillrate_engine::state::Dither;
    match format {
        PixelFormat::Argb8888 => pack(PixelFormat::Rgb565, value, Dither::Off, 0, 0) as u16,
        _ => value as u16,
    }
}

impl Board {
    /// Reads a rectangle of the program's pixels as 16-bit elements, rows
    /// `stride` apart. Parts outside are left alone.
    pub(crate) fn read_pixels(
        &mut self,
        id: SurfaceId,
        rect: Rect,
        to: &mut [u16],
        stride: usize,
    ) -> Result<(), EngineError> {
        let Some(buffers) = &self.buffers else { return Ok(()) };
        let inside = rect.intersect(&Rect::new(0, 0, buffers.width, buffers.height));
        let scale = self.improve.scale;
        let surface = self.device.surface(id)?;
        let format = surface.format();
        if scale == 1 && format.bytes() == 2 {
            return self.device.read16(id, rect, to, stride);
        }
        for y in inside.y0..inside.y1 {
            let row = (y - rect.y0) as usize * stride + (inside.x0 - rect.x0) as usize;
            for (x, to) in (inside.x0..inside.x1).zip(to.iter_mut().skip(row)) {
                let value = surface.get(x * scale + scale / 2, y * scale + scale / 2);
                *to = element(format, value);
            }
        }
        Ok(())
    }

    /// Writes a row of the program's pixels: elements of the surface.
    pub(crate) fn write_pixels(&mut self, id: SurfaceId, (x, y): (u32, u32), values: &[u32]) {
        let scale = self.improve.scale;
        let Some(buffers) = &self.buffers else { return };
        let (width, height) = (buffers.width, buffers.height);
        // The surface is one of ours.
        let Ok(surface) = self.device.surface(id) else { return };
        if y >= height {
            return;
        }
        for (x, &value) in (x..width).zip(values) {
            for (dx, dy) in (0..scale).flat_map(|dy| (0..scale).map(move |dx| (dx, dy))) {
                surface.set(x * scale + dx, y * scale + dy, value);
            }
        }
    }

    /// A rectangle of the program's pixels on the surface.
    pub(crate) fn on_surface(&self, rect: Rect) -> Rect {
        self.improve.scaled(rect)
    }

    /// Draws ready-made fragments of the program's pixels.
    pub(crate) fn draw_run(&mut self, run: &PixelRun<'_>) {
        let scale = self.improve.scale;
        if scale == 1 {
            return self.device.draw_pixels(run);
        }
        let wide = |i: usize| core::iter::repeat_n(i, scale as usize);
        let all = || (0..run.colors.len().min(run.depths.len())).flat_map(wide);
        let colors: Vec<u32> = all().map(|i| run.colors[i]).collect();
        let depths: Vec<u16> = all().map(|i| run.depths[i]).collect();
        for row in 0..scale {
            let (x, y) = (run.x * scale, run.y * scale + row);
            self.device.draw_pixels(&PixelRun { x, y, colors: &colors, depths: &depths });
        }
    }

    /// The displayed buffer in all its detail; `None` where the program's view
    /// is all there is.
    pub(crate) fn detail(&mut self) -> Option<Picture> {
        if !self.improve.shows_more() {
            return None;
        }
        let id = self.buffers.as_ref()?.colors[0];
        let scale = self.improve.scale;
        let surface = self.device.surface(id).ok()?;
        let (format, width, height) = (surface.format(), surface.width(), surface.height());
        let rgb = |x: u32, y: u32| {
            let [_, r, g, b] = unpack(format, surface.get(x, y)).to_be_bytes();
            [r, g, b]
        };
        if !self.improve.supersample {
            let all = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
            return Some(Picture { width, height, pixels: all.map(|(x, y)| rgb(x, y)).collect() });
        }
        let (width, height) = (width / scale, height / scale);
        let mean = |x: u32, y: u32| {
            let mut sum = [0u32; 3];
            for (dx, dy) in (0..scale).flat_map(|dy| (0..scale).map(move |dx| (dx, dy))) {
                let pixel = rgb(x * scale + dx, y * scale + dy);
                sum.iter_mut().zip(pixel).for_each(|(sum, c)| *sum += u32::from(c));
            }
            let count = scale * scale;
            sum.map(|sum| ((sum + count / 2) / count) as u8)
        };
        let all = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        Some(Picture { width, height, pixels: all.map(|(x, y)| mean(x, y)).collect() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Call, Context, GlideConfig, GrVertex, ScanOut};
    use fillrate_engine::DeviceConfig;

    fn glide(improve: Improvements, origin: i32) -> Context {
        let device = DeviceConfig { threads: 1, ..DeviceConfig::default() };
        let config = GlideConfig { device, improve, ..GlideConfig::default() };
        let mut glide = Context::new(config).expect("a board");
        glide.execute(&Call::GrGlideInit {});
        let open = Call::GrSstWinOpen {
            window: 0,
            resolution: 1,
            refresh: 0,
            color_format: 0,
            origin,
            colors: 2,
            aux: 1,
        };
        assert_eq!(glide.execute(&open), 1);
        glide.execute(&Call::GrDitherMode { mode: 0 });
        glide.execute(&Call::GrBufferClear { color: 0, alpha: 0, depth: 0 });
        glide
    }

    fn improved(scale: u32, color32: bool, supersample: bool) -> Improvements {
        Improvements { scale, color32, supersample }
    }

    fn corner(x: f32, y: f32) -> GrVertex {
        GrVertex { x, y, r: x / 2.0, g: y, b: 200.0, a: 255.0, oow: 1.0, ..GrVertex::default() }
    }

    fn draw(glide: &mut Context) {
        glide.execute(&Call::GrClipWindow { x0: 20, y0: 10, x1: 300, y1: 200 });
        // Far outside the screen, as far as the board counts.
        let (a, b, c) = (corner(-2000.0, -900.0), corner(2000.0, 30.0), corner(100.0, 2000.0));
        glide.execute(&Call::GrDrawTriangle { a, b, c });
        glide.execute(&Call::GrDrawPoint { point: corner(55.0, 220.0) });
        glide.execute(&Call::GrClipWindow { x0: 0, y0: 0, x1: 320, y1: 240 });
        glide.execute(&Call::GrDrawPoint { point: corner(5.0, 5.0) });
        glide.execute(&Call::GrDrawLine { a: corner(2.0, 210.5), b: corner(200.0, 210.5) });
    }

    fn pixels(glide: &mut Context) -> Vec<u16> {
        glide.lfb_read_region(1, (0, 0), (320, 240)).expect("a buffer")
    }

    /// The program reads nearly what it would read without: the middle of each
    /// pixel is the pixel's centre where the scale is odd.
    #[test]
    fn scaled_pictures_read_like_plain_ones() {
        for origin in [0, 1] {
            let mut plain = glide(Improvements::default(), origin);
            draw(&mut plain);
            let plain = pixels(&mut plain);
            assert!(plain.iter().filter(|&&p| p != 0).count() > 20_000);
            for scale in 2..=MAX_SCALE {
                let mut scaled = glide(improved(scale, false, false), origin);
                draw(&mut scaled);
                let scaled = pixels(&mut scaled);
                let far = |(&a, &b): (&u16, &u16)| {
                    let (a, b) = (
                        unpack(PixelFormat::Rgb565, a.into()),
                        unpack(PixelFormat::Rgb565, b.into()),
                    );
                    let (a, b) = (a.to_be_bytes(), b.to_be_bytes());
                    (1..4).any(|i| a[i].abs_diff(b[i]) > 9)
                };
                let different = plain.iter().zip(&scaled).filter(|&pair| far(pair)).count();
                // Pixels at the edges, where an even scale has no middle.
                let allowed = if scale == 3 { 0 } else { 400 };
                assert!(different <= allowed, "scale {scale}: {different}");
            }
        }
    }

    #[test]
    fn a_point_is_a_whole_pixel() {
        for scale in 1..=MAX_SCALE {
            let mut glide = glide(improved(scale, false, false), 0);
            glide.execute(&Call::GrDrawPoint { point: corner(5.0, 7.9) });
            glide.execute(&Call::GrBufferSwap { interval: 0 });
            let picture = glide.shown().expect("a frame").on_monitor(ScanOut::default());
            assert_eq!((picture.width, picture.height), (320 * scale, 240 * scale));
            let lit: Vec<usize> =
                (0..picture.pixels.len()).filter(|&i| picture.pixels[i] != [0; 3]).collect();
            assert_eq!(lit.len(), (scale * scale) as usize);
            assert_eq!(lit[0] as u32, 7 * scale * 320 * scale + 5 * scale);
        }
    }

    /// What is written is read back, and what is not touched stays as it was.
    #[test]
    fn locks_see_the_programs_pixels() {
        for improve in
            [improved(1, false, false), improved(3, true, true), improved(2, false, false)]
        {
            let mut glide = glide(improve, 0);
            draw(&mut glide);
            let before = pixels(&mut glide);
            glide.lfb_lock(1, 1, 0xff, 0, false).expect("a lock");
            let memory = glide.lfb_memory(1).expect("memory");
            let half = |memory: &[u32], x: usize, y: usize| {
                (memory[(y * 1024 + x) / 2] >> (16 * (x & 1))) as u16
            };
            assert_eq!(half(memory, 101, 50), before[50 * 320 + 101]);
            memory[(60 * 1024 + 100) / 2] = 0x1234_abcd;
            glide.execute(&Call::GrLfbUnlock { kind: 1, buffer: 1, written: None });
            let mut expected = before;
            expected[60 * 320 + 100] = 0xabcd;
            expected[60 * 320 + 101] = 0x1234;
            assert_eq!(pixels(&mut glide), expected);
        }
    }

    #[test]
    fn pipeline_writes_cover_whole_pixels() {
        let mut glide = glide(improved(4, false, false), 0);
        glide.execute(&Call::GrClipWindow { x0: 0, y0: 0, x1: 12, y1: 240 });
        glide.lfb_lock(1, 1, 0, 0, true).expect("a lock");
        let memory = glide.lfb_memory(1).expect("memory");
        memory[(30 * 1024 + 10) / 2] = 0xffff_ffff;
        memory[(30 * 1024 + 12) / 2] = 0xffff_ffff;
        glide.execute(&Call::GrLfbUnlock { kind: 1, buffer: 1, written: None });
        glide.execute(&Call::GrBufferSwap { interval: 0 });
        let picture = glide.shown().expect("a frame").on_monitor(ScanOut::default());
        assert_eq!(picture.pixels.iter().filter(|p| **p == [255; 3]).count(), 2 * 16);
    }

    #[test]
    fn eight_bits_a_channel_and_means() {
        let mut glide = glide(improved(1, true, false), 0);
        glide.execute(&Call::GrDitherMode { mode: 2 });
        glide.execute(&Call::GrBufferClear { color: 0x0012_3456, alpha: 0, depth: 0 });
        glide.execute(&Call::GrBufferSwap { interval: 0 });
        let shown = glide.shown().expect("a frame");
        assert!(
            shown.on_monitor(ScanOut::default()).pixels.iter().all(|p| *p == [0x12, 0x34, 0x56])
        );
        assert_eq!(shown.pixels[0], 0x12 >> 3 << 11 | 0x34 >> 2 << 5 | 0x56 >> 3);

        // A slanted edge: means lie between black and the colour.
        let mut glide = super::tests::glide(improved(4, true, true), 0);
        let (a, b, c) = (corner(10.0, 10.0), corner(200.0, 50.0), corner(60.0, 230.0));
        glide.execute(&Call::GrDrawTriangle { a, b, c });
        glide.execute(&Call::GrBufferSwap { interval: 0 });
        let picture = glide.shown().expect("a frame").on_monitor(ScanOut::default());
        assert_eq!((picture.width, picture.height), (320, 240));
        let between = picture.pixels.iter().filter(|p| (20..180).contains(&p[2])).count();
        assert!(between > 20, "{between}");
    }
}
