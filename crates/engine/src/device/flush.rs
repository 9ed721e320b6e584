//! When what was collected is drawn.
//!
//! A batch of commands is handed to the crew and drawn behind the caller, who
//! goes on collecting the next one, and joins where it needs the result.

use std::panic::resume_unwind;

use super::{Device, FlushReason, SurfaceId};
use crate::target::Surface;

/// States that are kept from one batch to the next before they are dropped.
const KEPT_STATES: usize = 256;

/// The surfaces that a batch draws on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Targets {
    color: SurfaceId,
    aux: Option<SurfaceId>,
}

impl Targets {
    pub fn contain(&self, id: SurfaceId) -> bool {
        self.color == id || self.aux == Some(id)
    }
}

impl Device {
    /// Draws everything collected so far, and waits for it.
    pub fn flush(&mut self, reason: FlushReason) {
        self.submit(reason);
        self.complete();
    }

    /// Starts to draw everything collected so far. With one thread there is
    /// nobody to draw behind the caller, who then draws it here.
    pub fn submit(&mut self, reason: FlushReason) {
        if self.arena.commands.is_empty() {
            return;
        }
        self.complete();
        self.flushes.by_reason[reason as usize] += 1;
        self.flushes.commands += self.arena.commands.len() as u64;
        self.start();
        if self.states.len() > KEPT_STATES {
            self.states.clear();
            self.state = None;
        }
        if self.crew.is_alone() {
            self.complete();
        }
    }

    /// How many batches were started since the device was made: the number of
    /// the last one.
    pub fn started(&self) -> u64 {
        self.started
    }

    /// How many of them are drawn. It does not wait.
    pub fn drawn(&mut self) -> u64 {
        if self.in_flight.is_some() && self.crew.is_done() {
            self.complete();
        }
        self.started - u64::from(self.in_flight.is_some())
    }

    /// Hands commands and tiles to the crew; without a target they are dropped.
    fn start(&mut self) {
        let (Some(color), aux) = (self.color, self.aux) else { return self.arena.clear() };
        let targets = Targets { color, aux };
        let Some((color, aux)) = targets_of(&mut self.surfaces, targets) else {
            return self.arena.clear();
        };
        let mut batch = self.crew.job();
        batch.take(&mut self.arena, self.states.list(), color, aux, self.config.threads);
        drop(batch);
        self.in_flight = Some(targets);
        self.started += 1;
        self.crew.start();
    }

    /// Waits for the batch that is being drawn, and helps with it.
    pub(super) fn complete(&mut self) {
        let Some(targets) = self.in_flight.take() else { return };
        let result = self.crew.finish();
        if let Some((color, aux)) = targets_of(&mut self.surfaces, targets) {
            let counters = self.crew.job().give_back(color, aux);
            self.counters += counters;
        }
        if let Err(panic) = result {
            resume_unwind(panic);
        }
    }

    /// The same where a surface is drawn on.
    pub(super) fn complete_for(&mut self, id: SurfaceId) {
        if self.in_flight.is_some_and(|targets| targets.contain(id)) {
            self.complete();
        }
    }
}

/// The surfaces of a batch, which are two of the device's.
fn targets_of(
    surfaces: &mut [Option<Surface>],
    targets: Targets,
) -> Option<(&mut Surface, Option<&mut Surface>)> {
    let color = targets.color.0 as usize;
    let Some(aux) = targets.aux.map(|id| id.0 as usize) else {
        return Some((surfaces.get_mut(color)?.as_mut()?, None));
    };
    let [color, aux] = surfaces.get_disjoint_mut([color, aux]).ok()?;
    Some((color.as_mut()?, aux.as_mut()))
}
