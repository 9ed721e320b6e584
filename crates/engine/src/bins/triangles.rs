//! The set-up of triangles, together with their neighbours where that is possible.

use std::sync::Arc;

use fillrate_simd::Simd;

use super::{Chunk, Entry, Grid, add_edges, triangle_edges};
use crate::device::arena::{Arena, BatchState};
use crate::reused::Reused;
use crate::setup::{
    Extra, ExtraNeeds, Fate, Lane, Launch, Registers, Screen, Sorted, VeriteCorners, VeriteExtra,
    VeriteSorted, VeriteVertex, prepare, prepare_extra, set_up, set_up_verite, verite_extra,
};

/// Triangles that are set up together: as many as there are lanes, of one of the
/// arena's lists, as if all were of one state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Together {
    kind: Kind,
    /// Counts vectors of the list.
    vector: u32,
    state: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Sst1,
    Verite,
    Extended,
}

/// A list of triangles for the Vérité's set-up.
#[derive(Clone, Copy)]
pub(super) enum List<'a> {
    Verite(&'a Reused<[VeriteVertex; 3]>),
    Extended(&'a Reused<[(VeriteVertex, VeriteExtra); 3]>),
}

impl<'a> List<'a> {
    #[inline(always)]
    fn get(self, index: usize) -> Option<VeriteCorners<'a>> {
        match self {
            List::Verite(list) => list.get(index).map(|v| (v.each_ref(), None)),
            List::Extended(list) => {
                let [a, b, c] = list.get(index)?;
                Some(([&a.0, &b.0, &c.0], Some([&a.1, &b.1, &c.1])))
            }
        }
    }

    fn kind(self) -> Kind {
        match self {
            List::Verite(_) => Kind::Verite,
            List::Extended(_) => Kind::Extended,
        }
    }
}

/// Whether triangles of a state are set up one by one.
#[inline(always)]
fn one_by_one<S: Simd>(batch: &BatchState) -> bool {
    S::ONE_BY_ONE || batch.screen.scale > 1 || batch.pipeline.needs.extra.any()
}

impl Chunk {
    /// Sets up one of the arena's triangles.
    #[inline(always)]
    pub(super) fn triangle<S: Simd>(
        &mut self,
        s: S,
        arena: &Arena,
        states: &[Arc<BatchState>],
        index: u32,
        grid: &Grid,
    ) {
        self.counters.triangles_in += 1;
        let corners = arena.triangles.get(index);
        let (state, lane) = (corners.state(), index as usize % S::LANES);
        let batch = &*states[state as usize];
        if one_by_one::<S>(batch) {
            return self.single(batch, &corners, grid);
        }
        if self.begins::<S>(Kind::Sst1, index, state) {
            self.many.set_up(s, &corners, &batch.screen, batch.pipeline.unit_count);
        }
        match self.many.fate(lane) {
            Fate::Drawn if self.many.is_plain(lane) => self.place::<S>(lane, state, grid),
            Fate::Drawn => self.single(batch, &corners, grid),
            Fate::Empty | Fate::Culled => {}
        }
    }

    /// The same of one for the Vérité's set-up.
    #[inline(always)]
    pub(super) fn verite<S: Simd>(
        &mut self,
        s: S,
        list: List<'_>,
        index: u32,
        (state, batch): (u32, &BatchState),
        grid: &Grid,
    ) {
        self.counters.triangles_in += 1;
        let lane = index as usize % S::LANES;
        let Some(corners) = list.get(index as usize) else { return };
        if one_by_one::<S>(batch) {
            return self.single_verite(batch, corners, state, grid);
        }
        if self.begins::<S>(list.kind(), index, state) {
            let first = index as usize - lane;
            let corners = |lane| list.get(first + lane);
            self.many.set_up_verite(s, corners, &batch.screen, batch.pipeline.unit_count);
        }
        match self.many.fate(lane) {
            Fate::Drawn if self.many.is_plain(lane) => self.place::<S>(lane, state, grid),
            Fate::Drawn => self.single_verite(batch, corners, state, grid),
            Fate::Empty | Fate::Culled => {}
        }
    }

    /// Sets up a triangle that launches by its registers.
    pub(super) fn registers(
        &mut self,
        registers: &Registers,
        (state, batch): (u32, &BatchState),
        grid: &Grid,
    ) {
        self.counters.triangles_in += 1;
        let groups = batch.pipeline.unit_count.max(1);
        let extra = || Extra::from(registers);
        self.launch(batch, &Launch::from(registers), extra, groups, state, grid);
    }

    /// Whether a triangle and its neighbours are not those that were set up last. They
    /// are from here on.
    #[inline(always)]
    fn begins<S: Simd>(&mut self, kind: Kind, index: u32, state: u32) -> bool {
        let together = Together { kind, vector: index / S::LANES as u32, state };
        self.together.replace(together) != Some(together)
    }

    /// Adds one of those that were set up together.
    #[inline(always)]
    fn place<S: Simd>(&mut self, lane: usize, state: u32, grid: &Grid) {
        self.counters.triangles_drawn += 1;
        let entry = Entry::Triangle(self.triangles.list.len() as u32);
        if let Some(triangle) = self.many.push::<S>(lane, state, &mut self.triangles) {
            add_edges(&mut self.pairs, &triangle.bounds, triangle_edges(triangle), entry, grid);
        }
    }

    /// Sets a triangle up by itself.
    #[inline(always)]
    fn single(&mut self, batch: &BatchState, corners: &Lane<'_>, grid: &Grid) {
        let units = batch.pipeline.unit_count;
        let sorted = Sorted::new(corners, corners.cull());
        if sorted.fate == Fate::Drawn {
            let mut launch = Launch::default();
            set_up(corners, &sorted, units, &mut launch);
            self.launch(batch, &launch, Extra::none, units.max(1), corners.state(), grid);
        }
    }

    /// The same for the Vérité's set-up.
    #[inline(always)]
    fn single_verite(
        &mut self,
        batch: &BatchState,
        (vertices, extras): VeriteCorners<'_>,
        state: u32,
        grid: &Grid,
    ) {
        let units = batch.pipeline.unit_count;
        let sorted = VeriteSorted::new(vertices);
        if sorted.drawn {
            let mut launch = Launch::default();
            set_up_verite(vertices, extras, &sorted, units, &mut launch);
            let extra = || verite_extra(vertices, extras, &sorted);
            // There is no w of the pixel pipeline.
            self.launch(batch, &launch, extra, units, state, grid);
        }
    }

    #[inline(always)]
    fn launch(
        &mut self,
        batch: &BatchState,
        launch: &Launch,
        extra: impl FnOnce() -> Extra,
        groups: usize,
        state: u32,
        grid: &Grid,
    ) {
        self.counters.triangles_drawn += 1;
        let counts = [batch.pipeline.unit_count, groups];
        let index = self.triangles.list.len() as u32;
        let screen = &batch.screen;
        let triangle = if screen.scale == 1 {
            prepare(launch, screen, state, counts, &mut self.triangles)
        } else {
            prepare(&launch.scaled(screen.scale), screen, state, counts, &mut self.triangles)
        };
        if triangle.is_none() {
            return;
        }
        let needs = batch.pipeline.needs.extra;
        if needs.any() {
            self.extend(launch, &extra(), screen, needs);
        }
        let Some(triangle) = self.triangles.list.last() else { return };
        let entry = Entry::Triangle(index);
        add_edges(&mut self.pairs, &triangle.bounds, triangle_edges(triangle), entry, grid);
    }

    /// Adds what a state reads besides to the triangle prepared last.
    fn extend(&mut self, launch: &Launch, extra: &Extra, screen: &Screen, needs: ExtraNeeds) {
        if screen.scale == 1 {
            return prepare_extra(extra, launch, screen, needs, &mut self.triangles);
        }
        let (launch, extra) = (launch.scaled(screen.scale), extra.scaled(screen.scale));
        prepare_extra(&extra, &launch, screen, needs, &mut self.triangles);
    }
}
