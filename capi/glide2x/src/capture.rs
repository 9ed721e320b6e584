//! Frames as files: pictures and a log.

use std::fs::File;
use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use fillrate_engine::Counters;
use fillrate_glide::{MAX_BOARDS, ScanOut, Shown};
use fillrate_player::{Frame, Pixels};

/// Writes frames as they are shown.
#[derive(Debug)]
pub struct Capture {
    folder: PathBuf,
    log: File,
    every: u64,
    scan_out: ScanOut,
    /// Frames noted of all boards.
    frames: u64,
    started: Instant,
    /// Counters of each board at its last frame.
    before: [Counters; MAX_BOARDS],
}

impl Capture {
    /// Starts a log in a folder, which is made where it is missing. Pictures
    /// look as `scan_out` says; hashes are of the buffers.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn new(folder: PathBuf, every: u64, scan_out: ScanOut) -> std::io::Result<Capture> {
        std::fs::create_dir_all(&folder)?;
        let log = File::create(folder.join("frames.jsonl"))?;
        let before = [Counters::default(); MAX_BOARDS];
        Ok(Capture { folder, log, every, scan_out, frames: 0, started: Instant::now(), before })
    }

    /// Notes a frame of a board, and writes it where it is its turn. Frames of
    /// all boards are counted together; pictures of boards after the first say
    /// so in their names.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn frame(
        &mut self,
        board: usize,
        shown: &Shown,
        frame: &Frame,
        now: Counters,
    ) -> std::io::Result<()> {
        let number = self.frames;
        self.frames += 1;
        let before = self.before[board.min(MAX_BOARDS - 1)];
        let nanoseconds = self.started.elapsed().as_nanos();
        // Counters restart where the board is opened again.
        let since = |now: u64, before: u64| now.checked_sub(before).unwrap_or(now);
        writeln!(
            self.log,
            "{{\"frame\":{number},\"board\":{board},\"width\":{},\"height\":{},\"hash\":\"{:016x}\",\
             \"triangles\":{},\"pixels\":{},\"nanoseconds\":{nanoseconds}}}",
            frame.width(),
            frame.height(),
            frame.hash(),
            since(now.triangles_drawn, before.triangles_drawn),
            since(now.pixels_in, before.pixels_in),
        )?;
        if self.every > 0 && number.is_multiple_of(self.every) {
            let suffix = if board == 0 { String::new() } else { format!("_board{board}") };
            let file = self.folder.join(format!("frame_{number:05}{suffix}.png"));
            let mut bytes = Vec::new();
            let monitor = on_monitor(shown, self.scan_out);
            let picture = monitor.as_ref().unwrap_or(frame);
            picture.write_png(&mut bytes).map_err(std::io::Error::other)?;
            std::fs::write(file, bytes)?;
        }
        self.before[board.min(MAX_BOARDS - 1)] = now;
        self.started = Instant::now();
        Ok(())
    }
}

/// What a board's buffer holds, as a frame.
pub fn frame_of(shown: &Shown) -> Option<Frame> {
    Frame::new(shown.width, shown.height, Pixels::Rgb565(shown.pixels.clone())).ok()
}

/// What its monitor shows; `None` where that is what the buffer holds.
fn on_monitor(shown: &Shown, scan_out: ScanOut) -> Option<Frame> {
    if scan_out == ScanOut::default() {
        return None;
    }
    let pixels = shown.on_monitor(scan_out);
    let rgba = pixels.into_iter().flat_map(|[r, g, b]| [r, g, b, 255]).collect();
    Frame::new(shown.width, shown.height, Pixels::Rgba8(rgba)).ok()
}
