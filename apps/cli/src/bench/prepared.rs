//! A workload ready to be drawn, on a board or beyond.

use anyhow::Result;
use fillrate_engine::{Counters, DeviceConfig};
use fillrate_player::Frame;
use fillrate_simd::Level;

use super::board::Board;
use super::size::Size;
use super::surfaces::Surfaces;
use super::workload::Workload;

/// A workload with somewhere to draw.
pub enum Prepared {
    /// Through Glide.
    Board(Box<Board>),
    /// Through the engine's API, for sizes that no board shows.
    Surfaces(Box<Surfaces>),
}

impl Prepared {
    /// Prepares a workload: through Glide where a board shows the size and the
    /// texture is the workload's own.
    pub fn new(
        workload: Workload,
        size: Size,
        device: DeviceConfig,
        texture_side: Option<u32>,
    ) -> Result<Prepared> {
        Ok(match (size.resolution(), texture_side) {
            (Some(_), None) => Prepared::Board(Box::new(Board::new(workload, size, device)?)),
            _ => {
                let surfaces = Surfaces::new(workload, size, device, texture_side)?;
                Prepared::Surfaces(Box::new(surfaces))
            }
        })
    }

    /// Draws and shows a frame.
    pub fn frame(&mut self) {
        match self {
            Prepared::Board(board) => board.frame(),
            Prepared::Surfaces(surfaces) => surfaces.frame(),
        }
    }

    /// The picture shown.
    pub fn picture(&mut self) -> Result<Frame> {
        match self {
            Prepared::Board(board) => board.picture(),
            Prepared::Surfaces(surfaces) => surfaces.picture(),
        }
    }

    /// What was drawn so far.
    pub fn counters(&mut self) -> Counters {
        match self {
            Prepared::Board(board) => board.counters(),
            Prepared::Surfaces(surfaces) => surfaces.counters(),
        }
    }
}

/// The digest of a workload's picture as the scalar level draws it on one
/// thread.
pub fn plain_digest(
    workload: Workload,
    size: Size,
    device: &DeviceConfig,
    texture_side: Option<u32>,
) -> Result<u64> {
    let plain = DeviceConfig { threads: 1, level: Level::Scalar, ..device.clone() };
    let mut prepared = Prepared::new(workload, size, plain, texture_side)?;
    prepared.frame();
    Ok(prepared.picture()?.hash())
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

    /// Every pixel of the largest picture is drawn: no layer leaves a gap
    /// between its surfaces or at the far edges.
    #[test]
    fn large_pictures_are_covered() {
        let size = Size { width: 2560, height: 2048 };
        let workload = Workload::by_name("W1_fill_flat").unwrap();
        let mut prepared = Prepared::new(workload, size, DeviceConfig::default(), None).unwrap();
        prepared.frame();
        let counted = prepared.counters().pixels_out;
        assert_eq!(counted as f64, workload.count(size));
    }
}
