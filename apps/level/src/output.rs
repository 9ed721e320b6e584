//! Frames as files: PNG pictures, and video as uncompressed y4m.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use fillrate_glide::{ScanOut, Shown};
use fillrate_player::{Frame, Pixels};

/// Where frames go.
pub struct Output {
    folder: Option<PathBuf>,
    video: Option<Box<dyn Write>>,
    scan_out: ScanOut,
    frames: u64,
}

impl Output {
    /// Frames go into `folder` as PNG and to `video` as y4m ("-" is the
    /// standard output); with `gamma`, as the monitor shows them.
    ///
    /// # Errors
    /// Where they cannot be made.
    pub fn new(folder: Option<&Path>, video: Option<&Path>, gamma: bool) -> Result<Output> {
        if let Some(folder) = folder {
            std::fs::create_dir_all(folder)
                .with_context(|| format!("cannot create {}", folder.display()))?;
        }
        let video = match video {
            None => None,
            Some(path) if path.as_os_str() == "-" => {
                Some(Box::new(BufWriter::new(std::io::stdout())) as Box<dyn Write>)
            }
            Some(path) => {
                let file = File::create(path)
                    .with_context(|| format!("cannot create {}", path.display()))?;
                Some(Box::new(BufWriter::new(file)) as Box<dyn Write>)
            }
        };
        let scan_out = ScanOut { gamma, filter: false };
        Ok(Output { folder: folder.map(Path::to_path_buf), video, scan_out, frames: 0 })
    }

    /// Whether frames are wanted at all.
    pub fn wants_frames(&self) -> bool {
        self.folder.is_some() || self.video.is_some()
    }

    /// Writes a frame.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn frame(&mut self, shown: Shown) -> Result<()> {
        let picture = shown.on_monitor(self.scan_out);
        let (width, height) = (picture.width, picture.height);
        let rgba = picture.pixels.iter().flat_map(|&[r, g, b]| [r, g, b, 255]).collect();
        let frame = Frame::new(width, height, Pixels::Rgba8(rgba))?;
        if let Some(folder) = &self.folder {
            frame.save_png(&folder.join(format!("frame_{:05}.png", self.frames)))?;
        }
        if let Some(video) = &mut self.video {
            if self.frames == 0 {
                writeln!(video, "YUV4MPEG2 W{width} H{height} F60:1 Ip A1:1 C444")?;
            }
            let pixels: Vec<[u8; 4]> = frame.rgba_pixels().collect();
            video.write_all(b"FRAME\n")?;
            video.write_all(&planes(&pixels))?;
        }
        self.frames += 1;
        Ok(())
    }

    /// Ends the video.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn finish(mut self) -> Result<()> {
        if let Some(video) = &mut self.video {
            video.flush()?;
        }
        Ok(())
    }
}

/// Brightness, blue and red difference, a plane each (BT.601, 16 to 235).
fn planes(pixels: &[[u8; 4]]) -> Vec<u8> {
    let plane = |weights: [i32; 3], offset: i32| {
        pixels.iter().map(move |p| {
            let sum: i32 = p.iter().zip(weights).map(|(&c, w)| i32::from(c) * w).sum();
            (((sum + 128) >> 8) + offset) as u8
        })
    };
    let mut out: Vec<u8> = plane([66, 129, 25], 16).collect();
    out.extend(plane([-38, -74, 112], 128));
    out.extend(plane([112, -94, -18], 128));
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn black_and_white_in_video() {
        let out = planes(&[[0, 0, 0, 255], [255, 255, 255, 255]]);
        assert_eq!(out, [16, 235, 128, 128, 128, 128]);
    }
}
