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
    /// What each screen had drawn at its last frame.
    before: Vec<Drawn>,
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
        Ok(FrameLog { folder, log, every, started: Instant::now(), before: Vec::new() })
    }

    /// Notes a frame of the only screen, and writes it where it is its turn.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn frame(&mut self, number: u64, frame: &Frame, now: Drawn) -> std::io::Result<()> {
        self.frame_of_screen(number, 0, frame, frame, now)
    }

    /// Notes a frame of one of several screens, and writes it where it is its turn: `picture`,
    /// which may differ from the frame that is noted. Frames of all screens are counted together;
    /// files of screens after the first say so in their names.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn frame_of_screen(
        &mut self,
        number: u64,
        screen: usize,
        frame: &Frame,
        picture: &Frame,
        now: Drawn,
    ) -> std::io::Result<()> {
        let nanoseconds = self.started.elapsed().as_nanos();
        if self.before.len() <= screen {
            self.before.resize(screen + 1, Drawn::default());
        }
        let before = core::mem::replace(&mut self.before[screen], now);
        // Counters restart where the program resets them.
        let since = |now: u64, before: u64| now.checked_sub(before).unwrap_or(now);
        writeln!(
            self.log,
            "{{\"frame\":{number},\"board\":{screen},\"width\":{},\"height\":{},\"hash\":\"{:016x}\",\
             \"triangles\":{},\"pixels\":{},\"nanoseconds\":{nanoseconds}}}",
            frame.width(),
            frame.height(),
            frame.hash(),
            since(now.triangles, before.triangles),
            since(now.pixels, before.pixels),
        )?;
        if self.every > 0 && number.is_multiple_of(self.every) {
            let suffix = match screen {
                0 => String::new(),
                screen => format!("_board{screen}"),
            };
            let file = self.folder.join(format!("frame_{number:05}{suffix}.png"));
            let mut bytes = Vec::new();
            picture.write_png(&mut bytes).map_err(std::io::Error::other)?;
            std::fs::write(file, bytes)?;
        }
        self.started = Instant::now();
        Ok(())
    }
}
