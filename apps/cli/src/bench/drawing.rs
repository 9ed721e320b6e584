//! What benches draw, whatever the front end.

use anyhow::{Context as _, Result};
use fillrate_engine::{Counters, DeviceConfig};
use fillrate_player::Frame;

use super::board::Board;
use super::measure::Job;
use super::quark;
use super::rave;
use super::redline;
use super::size::Size;
use super::surfaces::Surfaces;
use super::workload::Workload;

/// Something that is drawn frame by frame, always the same.
pub trait Drawing {
    /// Draws and shows a frame.
    fn frame(&mut self);
    /// Pixels or triangles of a frame.
    fn count(&self) -> f64;
    /// The picture shown.
    fn picture(&mut self) -> Result<Frame>;
    /// What was drawn so far.
    fn counters(&mut self) -> Counters;
}

/// The job of a workload: through Glide where a board shows the size and the
/// texture is the workload's own, else through the engine's API.
pub fn job(workload: Workload, size: Size, texture_side: Option<u32>) -> Job {
    let make = move |device: DeviceConfig| -> Result<Box<dyn Drawing>> {
        Ok(match (size.resolution(), texture_side) {
            (Some(_), None) => Box::new(Board::new(workload, size, device)?),
            _ => Box::new(Surfaces::new(workload, size, device, texture_side)?),
        })
    };
    Job {
        name: workload.name,
        unit: workload.unit(),
        format: "565",
        size,
        kept: texture_side.is_none(),
        make: Box::new(make),
    }
}

/// The job of a workload of Quark 3D.
///
/// # Errors
/// Sizes that no board shows: its scene is also drawn through Glide.
pub fn quark_job(name: &'static str, kind: quark::Kind, size: Size) -> Result<Job> {
    size.resolution().with_context(|| format!("{name}: no board shows {size}"))?;
    let make = move |device: DeviceConfig| -> Result<Box<dyn Drawing>> {
        Ok(Box::new(quark::Prepared::new(kind, size, device)?))
    };
    let unit = quark::unit(kind);
    Ok(Job { name, unit, format: "palette", size, kept: true, make: Box::new(make) })
}

/// The job of a workload of RRedline.
pub fn redline_job(name: &'static str, kind: redline::Kind, size: Size) -> Job {
    let make = move |device: DeviceConfig| -> Result<Box<dyn Drawing>> {
        Ok(Box::new(redline::Prepared::new(kind, size, device)?))
    };
    let unit = redline::unit(kind);
    Job { name, unit, format: "565", size, kept: true, make: Box::new(make) }
}

/// The job of a workload of RAVE.
pub fn rave_job(name: &'static str, kind: rave::Kind, size: Size) -> Job {
    let make = move |device: DeviceConfig| -> Result<Box<dyn Drawing>> {
        Ok(Box::new(rave::Prepared::new(kind, size, device)?))
    };
    let unit = rave::unit(kind);
    Job { name, unit, format: "565", size, kept: true, make: Box::new(make) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::workload::{Kind, WORKLOADS};

    /// A board and the engine's own surfaces draw the same picture.
    #[test]
    fn surfaces_draw_what_boards_draw() {
        let size = Size { width: 320, height: 240 };
        for mut workload in WORKLOADS {
            if let Kind::Triangles { count, .. } = &mut workload.kind {
                *count = 2000;
            }
            let mut board = Board::new(workload, size, DeviceConfig::default()).unwrap();
            let mut surfaces =
                Surfaces::new(workload, size, DeviceConfig::default(), None).unwrap();
            board.frame();
            surfaces.frame();
            let (board, surfaces) = (board.picture().unwrap(), surfaces.picture().unwrap());
            assert!(board == surfaces, "{}", workload.name);
        }
    }

    /// Every pixel of a picture of several surfaces is drawn: no layer leaves
    /// a gap between them or at the far edges.
    #[test]
    fn large_pictures_are_covered() {
        let size = Size { width: 2560, height: 2048 };
        let workload = Workload::by_name("W1_fill_flat").unwrap();
        let mut drawing = (job(workload, size, None).make)(DeviceConfig::default()).unwrap();
        drawing.frame();
        assert_eq!(drawing.counters().pixels_out as f64, drawing.count());
    }
}
