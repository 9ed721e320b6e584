//! Ways through a level that do not pass through walls.
//!
//! Places are those of a grid, looked at only as a search comes to them. A
//! camera has room at a place where nothing solid is within `ROOM` of it.

use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

use crate::bsp::Bsp;
use crate::math::{Vec3, add, length, mix, scale, sub};

/// What a camera keeps from walls.
const ROOM: f32 = 12.0;
/// Distance of places of the grid.
const GRID: f32 = 32.0;
/// Places a search looks at before it gives up.
const MAX_PLACES: usize = 60_000;
/// Nobody likes to be higher above a floor than this.
const FLOOR: f32 = 96.0;
/// Distance of the points of a smooth way.
const STEP: f32 = 16.0;

/// Whether a camera has room at a point.
fn is_free(bsp: &Bsp, point: Vec3) -> bool {
    let sides = (0..6).map(|i| {
        let mut way = [0.0; 3];
        way[i / 2] = if i % 2 == 0 { ROOM } else { -ROOM };
        way
    });
    !bsp.is_solid(point) && sides.into_iter().all(|side| !bsp.is_solid(add(point, side)))
}

/// Whether a camera can go straight from one point to another.
pub fn is_clear(bsp: &Bsp, from: Vec3, to: Vec3) -> bool {
    let steps = (length(sub(to, from)) / (ROOM * 0.5)).ceil().clamp(1.0, 4096.0) as usize;
    (0..=steps).all(|i| is_free(bsp, mix(from, to, i as f32 / steps as f32)))
}

/// A place of the grid around a start.
type Place = [i32; 3];

struct Search<'a> {
    bsp: &'a Bsp,
    start: Vec3,
    free: HashMap<Place, bool>,
    floor: HashMap<Place, bool>,
}

impl Search<'_> {
    fn point(&self, place: Place) -> Vec3 {
        add(self.start, place.map(|v| v as f32 * GRID))
    }

    fn is_free(&mut self, place: Place) -> bool {
        let point = self.point(place);
        *self.free.entry(place).or_insert_with(|| is_free(self.bsp, point))
    }

    /// Whether a floor is near enough below.
    fn has_floor(&mut self, place: Place) -> bool {
        let point = self.point(place);
        let below = |i: i32| add(point, [0.0, 0.0, -(i as f32) * 16.0]);
        let bsp = self.bsp;
        *self
            .floor
            .entry(place)
            .or_insert_with(|| (1..=(FLOOR / 16.0) as i32).any(|i| bsp.is_solid(below(i))))
    }
}

/// The shortest way over the grid from one point to another that stays near
/// floors where it can, in as few straight parts as that takes.
pub fn find(bsp: &Bsp, from: Vec3, to: Vec3) -> Option<Vec<Vec3>> {
    if is_clear(bsp, from, to) {
        return Some(vec![from, to]);
    }
    let mut search = Search { bsp, start: from, free: HashMap::new(), floor: HashMap::new() };
    let mut open = BinaryHeap::from([(Reverse(0u32), [0; 3])]);
    let mut best: HashMap<Place, (u32, Place)> = HashMap::from([([0; 3], (0, [0; 3]))]);
    while let Some((_, place)) = open.pop() {
        let here = search.point(place);
        if length(sub(here, to)) < 1.8 * GRID && is_clear(bsp, here, to) {
            return Some(straighten(bsp, &back(&search, &best, place, to)));
        }
        if best.len() > MAX_PLACES {
            return None;
        }
        let spent = best[&place].0;
        for step in STEPS {
            let next = core::array::from_fn(|i| place[i] + step[i]);
            if !search.is_free(next) {
                continue;
            }
            let there = search.point(next);
            // Walls thinner than the grid.
            if !is_free(bsp, mix(here, there, 0.5)) {
                continue;
            }
            let effort = if search.has_floor(next) { 1.0 } else { 4.0 };
            let cost = spent + (length(sub(there, here)) * effort) as u32;
            if best.get(&next).is_none_or(|&(old, _)| cost < old) {
                best.insert(next, (cost, place));
                open.push((Reverse(cost + length(sub(to, there)) as u32), next));
            }
        }
    }
    None
}

/// Neighbours: along the floor, slanted, and straight up and down.
const STEPS: [Place; 18] = [
    [1, 0, 0],
    [-1, 0, 0],
    [0, 1, 0],
    [0, -1, 0],
    [1, 1, 0],
    [1, -1, 0],
    [-1, 1, 0],
    [-1, -1, 0],
    [0, 0, 1],
    [0, 0, -1],
    [1, 0, 1],
    [-1, 0, 1],
    [0, 1, 1],
    [0, -1, 1],
    [1, 0, -1],
    [-1, 0, -1],
    [0, 1, -1],
    [0, -1, -1],
];

/// The points from the start to a place, and the end.
fn back(
    search: &Search<'_>,
    best: &HashMap<Place, (u32, Place)>,
    mut place: Place,
    end: Vec3,
) -> Vec<Vec3> {
    let mut points = vec![end];
    while place != [0; 3] {
        points.push(search.point(place));
        place = best[&place].1;
    }
    points.push(search.start);
    points.reverse();
    points
}

/// Leaves out points that a straight line can.
fn straighten(bsp: &Bsp, points: &[Vec3]) -> Vec<Vec3> {
    let mut out = vec![points[0]];
    let mut at = 0;
    while at + 1 < points.len() {
        // Not too far: ways along floors stay there.
        let reach = (at + 8).min(points.len() - 1);
        let next = (at + 2..=reach).rev().find(|&i| is_clear(bsp, points[at], points[i]));
        at = next.unwrap_or(at + 1);
        out.push(points[at]);
    }
    out
}

/// A closed way through all points, in small steps and with round corners.
/// Where `bsp` knows no way between two points, it is straight.
pub fn smooth(bsp: &Bsp, corners: &[Vec3]) -> Vec<Vec3> {
    let mut points = Vec::new();
    for (i, &from) in corners.iter().enumerate() {
        let to = corners[(i + 1) % corners.len()];
        let steps = (length(sub(to, from)) / STEP).ceil().clamp(1.0, 4096.0) as usize;
        points.extend((0..steps).map(|i| mix(from, to, i as f32 / steps as f32)));
    }
    // Every point moves to the middle of its neighbours, where there is room.
    for _ in 0..48 {
        for i in 0..points.len() {
            let count = points.len();
            let (last, next) = (points[(i + count - 1) % count], points[(i + 1) % count]);
            let wanted = mix(points[i], scale(add(last, next), 0.5), 0.5);
            let tight = !is_free(bsp, points[i]) && !bsp.is_solid(wanted);
            if tight || is_free(bsp, wanted) {
                points[i] = wanted;
            }
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthetic;

    #[test]
    fn ways_go_through_doors() {
        let bsp = Bsp::parse(&synthetic::level()).expect("the level is valid");
        // Between rooms, far from the door in the middle of the wall.
        let (from, to) = ([-100.0, -200.0, 60.0], [100.0, -200.0, 60.0]);
        assert!(!is_clear(&bsp, from, to));
        let way = find(&bsp, from, to).expect("there is a door");
        assert!(way.len() > 2);
        for pair in way.windows(2) {
            assert!(is_clear(&bsp, pair[0], pair[1]), "{pair:?}");
        }
        let at_door = way.windows(2).find_map(|pair| {
            let t = -pair[0][0] / (pair[1][0] - pair[0][0]);
            (0.0..=1.0).contains(&t).then(|| mix(pair[0], pair[1], t))
        });
        let door = at_door.expect("the way crosses the wall");
        assert!(door[1].abs() < 64.0 && door[2] < 128.0, "{door:?}");
        assert!(find(&bsp, from, [0.0, 0.0, 5000.0]).is_none());
        let there_and_back: Vec<Vec3> =
            way.iter().chain(way[1..way.len() - 1].iter().rev()).copied().collect();
        let round = smooth(&bsp, &there_and_back);
        assert!(round.iter().all(|&point| !bsp.is_solid(point)));
    }
}
