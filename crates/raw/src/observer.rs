//! Watching the single-tile renderer work, for the cost model.

use crate::opcode::Opcode;
use crate::protocol::Record;
use crate::stage::combine::Textured;
use crate::stage::composite::Outcome;
use crate::stage::geometry::GeometryWork;
use crate::stage::raster::{Interpolants, RasterWork};
use crate::state::{ModeBits, PrimInfo};

/// Receives each piece of work the renderer does. Every method does nothing by default.
pub trait Observer {
    /// Whether it wants to know; what nobody watches may be done another way.
    const WATCHES: bool = true;

    /// A word was read from the host.
    fn word(&mut self) {}
    /// A meta record for the host interface arrived.
    fn meta(&mut self, _record: Record) {}
    /// The counters as the simulator printed them, if this observer counts.
    fn report(&mut self) -> Option<String> {
        None
    }
    /// A command was carried out.
    fn command(&mut self, _op: Opcode) {}
    /// A command mode command, or a word of its block (`op` then is the command for a single one),
    /// wrote to buffers of so many pixels.
    fn buffers(&mut self, _op: Opcode, _screen: u64) {}
    /// Stage 1 finished a primitive, visible or not.
    fn primitive(&mut self, _work: &GeometryWork) {}
    /// Stage 2 set a visible primitive up.
    fn setup(&mut self, _needs: Interpolants) {}
    /// Stages 2 and 3 made a fragment; `work` is the walking since the fragment before.
    fn fragment(&mut self, _info: &PrimInfo, _work: RasterWork, _textured: &Textured) {}
    /// Stage 4 dealt with a fragment at a word address of the screen.
    fn composite(&mut self, _mode: ModeBits, _address: u64, _outcome: &Outcome) {}
    /// Stage 2 left a primitive; `work` is the walking since its last fragment.
    fn rows(&mut self, _work: RasterWork) {}
}

impl Observer for () {
    const WATCHES: bool = false;
}
