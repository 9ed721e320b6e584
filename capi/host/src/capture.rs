//! Frames as files: pictures and a log.

use std::fs::File;
use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use fillrate_engine::Counters;
use fillrate_player::Frame;

/// Writes frames as they are shown.
#[derive(Debug)]
pub struct Capture {
    folder: PathBuf,
    log: File,
    every: u64,
    started: Instant,
    before: Counters,
}

impl Capture {
    /// Starts a log in a folder, which is made where it is missing.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn new(folder: PathBuf, every: u64) -> std::io::Result<Capture> {
        std::fs::create_dir_all(&folder)?;
        let log = File::create(folder.join("frames.jsonl"))?;
        let before = Counters::default();
        Ok(Capture { folder, log, every, started: Instant::now(), before })
    }

    /// Notes a frame, and writes it where it is its turn.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn frame(&mut self, number: u64, frame: &Frame, now: Counters) -> std::io::Result<()> {
        let nanoseconds = self.started.elapsed().as_nanos();
        // Counters restart where the program resets them.
        let since = |now: u64, before: u64| now.checked_sub(before).unwrap_or(now);
        writeln!(
            self.log,
            "{{\"frame\":{number},\"width\":{},\"height\":{},\"hash\":\"{:016x}\",\
             \"triangles\":{},\"pixels\":{},\"nanoseconds\":{nanoseconds}}}",
            frame.width(),
            frame.height(),
            frame.hash(),
            since(now.triangles_drawn, self.before.triangles_drawn),
            since(now.pixels_in, self.before.pixels_in),
        )?;
        if self.every > 0 && number.is_multiple_of(self.every) {
            let file = self.folder.join(format!("frame_{number:05}.png"));
            let mut bytes = Vec::new();
            frame.write_png(&mut bytes).map_err(std::io::Error::other)?;
            std::fs::write(file, bytes)?;
        }
        self.before = now;
        self.started = Instant::now();
        Ok(())
    }
}
