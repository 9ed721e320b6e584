//! Many at once against one by one, at every level.

use fillrate_simd::{Kernel, Level, Simd};

use super::Many;
use crate::setup::corners::{CornerBlocks, UsedState};
use crate::setup::launch::Launch;
use crate::setup::planes::{PlaneF, Screen, Triangle, Triangles, prepare};
use crate::setup::sst1::{Cull, Fate, Sorted, set_up};
use crate::setup::verite::{VeriteCorners, VeriteSorted, set_up_verite};
use crate::setup::{TmuVertex, VeriteExtra, VeriteVertex, Vertex};
use crate::state::{MAX_TMUS, Origin};

/// A small generator with a fixed seed.
struct Random(u32);

impl Random {
    fn word(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        let word = (self.0 >> (self.0 >> 28).wrapping_add(4) ^ self.0).wrapping_mul(277_803_737);
        word >> 22 ^ word
    }

    /// From 0 to `limit`.
    fn float(&mut self, limit: f32) -> f32 {
        (self.word() >> 8) as f32 / (1 << 24) as f32 * limit
    }

    /// Any bits, now and then; else a value in range, now and then a whole one.
    fn value(&mut self, limit: f32) -> f32 {
        match self.word() % 64 {
            0 => f32::from_bits(self.word()),
            1..8 => self.float(limit).trunc(),
            _ => self.float(limit),
        }
    }

    fn vertex(&mut self) -> Vertex {
        let mut tmu = || {
            let w = self.value(1.0);
            TmuVertex { s: self.value(256.0) * w, t: self.value(256.0) * w, w }
        };
        let tmu = [tmu(), tmu(), tmu()];
        Vertex {
            x: self.value(130.0) - 10.0,
            y: self.value(120.0) - 10.0,
            r: self.value(255.0),
            g: self.value(255.0),
            b: self.value(255.0),
            a: self.value(255.0),
            z: self.value(65535.0),
            w: self.value(1.0),
            tmu,
        }
    }

    /// Near each other, and with level sides, more often than by chance.
    fn corners(&mut self) -> [Vertex; 3] {
        let mut corners = [self.vertex(), self.vertex(), self.vertex()];
        if self.word().is_multiple_of(2) {
            for i in 1..3 {
                corners[i].x = corners[0].x + self.float(6.0) - 3.0;
                corners[i].y = corners[0].y + self.float(6.0) - 3.0;
            }
        }
        if self.word().is_multiple_of(4) {
            corners[self.word() as usize % 3].y = corners[self.word() as usize % 3].y;
        }
        if self.word().is_multiple_of(8) {
            self.make_steep(&mut corners);
        }
        corners
    }

    /// Lets them begin far outside the screen with coordinates that floats hardly
    /// hold, and end where these are small.
    fn make_steep(&mut self, corners: &mut [Vertex; 3]) {
        let slope = self.float(2048.0);
        for (v, x) in corners.iter_mut().zip([-240.0, 2.0, 4.0]) {
            v.x = x;
            for tmu in &mut v.tmu {
                tmu.s = (3.0 - x) * slope;
            }
        }
    }
}

const SCREENS: [Screen; 2] = [
    Screen { width: 96, height: 84, origin: Origin::UpperLeft, scale: 1 },
    Screen { width: 94, height: 81, origin: Origin::LowerLeft, scale: 1 },
];

/// Without the signs of zeros, which no sum shows.
fn unsigned(plane: PlaneF) -> PlaneF {
    let PlaneF { start, dx, dy } = plane;
    PlaneF { start: start + 0.0, dx: dx + 0.0, dy: dy + 0.0 }
}

/// What tiles read of a triangle; the order of its edges is no matter.
fn described(triangles: &Triangles, triangle: &Triangle, units: usize) -> String {
    let mut edges = triangle.edges[..triangle.edge_count as usize].to_vec();
    edges.sort_by_key(|edge| (edge.a, edge.b, edge.c));
    let Triangle { bounds, state, exact, compact, narrow, .. } = triangle;
    let wide = unsigned(triangles.exact_w(triangle));
    let units: Vec<_> = (0..units)
        .map(|unit| (triangle.lod_base[unit], triangles.exact_unit(triangle, unit).map(unsigned)))
        .collect();
    format!("{bounds:?} {state} {exact} {compact} {edges:?} {narrow:?} {wide:?} {units:?}")
}

/// Sets triangles up by vectors; how many were plain.
struct Compared<'a> {
    blocks: &'a CornerBlocks,
    count: u32,
    screen: &'a Screen,
    units: usize,
}

impl Kernel for Compared<'_> {
    type Output = usize;
    #[inline(always)]
    fn run<S: Simd>(self, s: S) -> usize {
        let Compared { blocks, count, screen, units } = self;
        let (mut many, mut plain) = (Many::default(), 0);
        for index in 0..count {
            let (corners, lane) = (blocks.get(index), index as usize % S::LANES);
            if lane == 0 {
                many.set_up(s, &corners, screen, units);
            }
            let sorted = Sorted::new(&corners, corners.cull());
            assert_eq!(many.fate(lane), sorted.fate, "{index}");
            if sorted.fate != Fate::Drawn || !many.is_plain(lane) {
                continue;
            }
            let mut launch = Launch::default();
            set_up(&corners, &sorted, units, &mut launch);
            let groups = [units, units.max(1)];
            plain += usize::from(is_same::<S>(&many, lane, &launch, screen, groups));
        }
        plain
    }
}

/// Checks a lane against its launch; whether there is something to be seen of it.
fn is_same<S: Simd>(
    many: &Many,
    lane: usize,
    launch: &Launch,
    screen: &Screen,
    [units, groups]: [usize; 2],
) -> bool {
    let (mut one, mut other) = (Triangles::default(), Triangles::default());
    let found = many.push::<S>(lane, 7, &mut one).is_some();
    let expected = prepare(launch, screen, 7, [units, groups], &mut other).is_some();
    assert_eq!(found, expected);
    if let (Some(found), Some(expected)) = (one.list.last(), other.list.last()) {
        assert!(expected.exact && expected.compact);
        assert_eq!(described(&one, found, units), described(&other, expected, units));
    }
    found
}

#[test]
fn many_are_what_each_is() {
    let mut random = Random(2026);
    for units in 0..=MAX_TMUS {
        for screen in &SCREENS {
            let (mut blocks, count) = (CornerBlocks::default(), 4096);
            for _ in 0..count {
                let culls = [Cull::Disabled, Cull::Negative, Cull::Positive];
                let cull = culls[random.word() as usize % 3];
                let corners = random.corners();
                blocks.push(Level::best(), UsedState { index: 7, units }, cull, |i| corners[i]);
            }
            for level in Level::available() {
                let compared = Compared { blocks: &blocks, count, screen, units };
                let plain = level.dispatch(compared);
                // Of those that are not culled, a part has values that are any bits.
                assert!(plain > count as usize / 8, "{plain} at {level}");
            }
        }
    }
}

/// The same for the Vérité's.
struct ComparedVerites<'a> {
    list: &'a [[(VeriteVertex, VeriteExtra); 3]],
    screen: &'a Screen,
    units: usize,
}

impl Kernel for ComparedVerites<'_> {
    type Output = usize;
    #[inline(always)]
    fn run<S: Simd>(self, s: S) -> usize {
        let ComparedVerites { list, screen, units } = self;
        let get = |index: usize| -> Option<VeriteCorners<'_>> {
            let [a, b, c] = list.get(index)?;
            Some(([&a.0, &b.0, &c.0], Some([&a.1, &b.1, &c.1])))
        };
        let (mut many, mut plain) = (Many::default(), 0);
        for index in 0..list.len() {
            let lane = index % S::LANES;
            if lane == 0 {
                many.set_up_verite(s, |lane| get(index + lane), screen, units);
            }
            let Some((vertices, extras)) = get(index) else { continue };
            let sorted = VeriteSorted::new(vertices);
            assert_eq!(many.fate(lane) == Fate::Drawn, sorted.drawn, "{index}");
            if !sorted.drawn || !many.is_plain(lane) {
                continue;
            }
            let mut launch = Launch::default();
            set_up_verite(vertices, extras, &sorted, units, &mut launch);
            plain += usize::from(is_same::<S>(&many, lane, &launch, screen, [units, units]));
        }
        plain
    }
}

impl Random {
    fn verite(&mut self) -> (VeriteVertex, VeriteExtra) {
        let vertex = self.vertex();
        let [s, t, w] = [vertex.tmu[0].s, vertex.tmu[0].t, vertex.tmu[0].w];
        let mut color = [vertex.r, vertex.g, vertex.b, vertex.a].map(|v| (v * 4096.0) as i32);
        let mut z = (vertex.z * 2048.0) as i32;
        if self.word().is_multiple_of(64) {
            (color, z) = ([0; 4].map(|_| self.word() as i32), self.word() as i32);
        }
        let sixteenths = |v: f32| (v * 16.0) as i16;
        let texel = [s, t, w].map(|v| (f64::from(v) * (1u64 << 32) as f64).trunc());
        let extra = VeriteExtra { texel, ..VeriteExtra::default() };
        let (x, y) = (sixteenths(vertex.x), sixteenths(vertex.y));
        (VeriteVertex { color, z, x, y }, extra)
    }
}

#[test]
fn many_of_the_verites_are_what_each_is() {
    let mut random = Random(6);
    for units in 0..=2 {
        for screen in &SCREENS {
            // The last vector is not full.
            let list: Vec<_> = (0..4090)
                .map(|_| {
                    let mut corners = [random.verite(), random.verite(), random.verite()];
                    if random.word().is_multiple_of(4) {
                        corners[2].0.y = corners[random.word() as usize % 2].0.y;
                    }
                    corners
                })
                .collect();
            for level in Level::available() {
                let plain = level.dispatch(ComparedVerites { list: &list, screen, units });
                assert!(plain > list.len() / 4, "{plain} at {level}");
            }
        }
    }
}
