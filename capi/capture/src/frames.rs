//! Frames as files: pictures and a log.

use std::fs::File;
use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use fillrate_player::Frame;

/// What has been drawn since the start, or since the program reset its counters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Drawn {
    /// Triangles drawn.
    pub triangles: u64,
    /// Fragments covered.
    pub pixels: u64,
}

/// Writes frames as they are shown.
#[derive(Debug)]
pub struct FrameLog {
    folder: PathBuf,
    log: File,
    every: u64,
    started: Instant,
    before: Drawn,
}

impl FrameLog {
    /// Starts a log in a folder, which is made where it is missing. Every `every`th frame is
    /// written as a picture; 0 writes none.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn new(folder: PathBuf, every: u64) -> std::io::Result<FrameLog> {
        std::fs::create_dir_all(&folder)?;
        let log = File::create(folder.join("frames.jsonl"))?;
        Ok(FrameLog { folder, log, every, started: Instant::now(), before: Drawn::default() })
    }

    /// Notes a frame, and writes it where it is its turn.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn frame(&mut self, number: u64, frame: &Frame, now: Drawn) -> std::io::Result<()> {
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
            since(now.triangles, self.before.triangles),
            since(now.pixels, self.before.pixels),
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
