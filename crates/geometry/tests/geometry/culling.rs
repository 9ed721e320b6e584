//! Portals, BSP trees and visible sets.

use std::collections::BTreeSet;

use fillrate_geometry::{
    BspTree, Child, Error, Frustum, Node, Order, Plane, PlaneMask, Portal, Rooms, Sphere,
    Transform, Vec3, View, VisibleSets,
};

use crate::support::{Random, cases};

const SIDES: PlaneMask = PlaneMask::ALL;

/// A square world of rooms of size 10 in the x, z plane, 4 high, with openings of
/// width 4 in some of the walls.
struct Grid {
    side: usize,
    rooms: Rooms,
    open: BTreeSet<(usize, usize)>,
}

impl Grid {
    fn new(side: usize, random: &mut Random) -> Self {
        let (mut portals, mut open) = (Vec::new(), BTreeSet::new());
        for room in 0..side * side {
            let (x, z) = (room % side, room / side);
            let neighbours = [(x + 1 < side, room + 1), (z + 1 < side, room + side)];
            for (axis, (exists, other)) in neighbours.into_iter().enumerate() {
                if !exists || random.below(3) == 0 {
                    continue;
                }
                let corners = opening(x, z, axis == 0);
                for (from, to) in [(room, other), (other, room)] {
                    open.insert((from, to));
                    portals.push(Portal {
                        from: from as u32,
                        to: to as u32,
                        corners: corners.clone(),
                    });
                }
            }
        }
        let rooms = Rooms::new(side * side, &portals).expect("rooms");
        Self { side, rooms, open }
    }

    /// The rooms on a ray, until it meets a wall or is longer than 200.
    fn march(&self, eye: Vec3, ray: Vec3, seen: &mut BTreeSet<u32>) {
        let room_of = |p: Vec3| {
            let inside = |v: f32| (0.0..10.0 * self.side as f32).contains(&v);
            (inside(p.x) && inside(p.z) && p.y.abs() <= 2.0)
                .then(|| (p.x / 10.0) as usize + self.side * (p.z / 10.0) as usize)
        };
        let Some(mut room) = room_of(eye) else { return };
        seen.insert(room as u32);
        for step in 1..4000 {
            let point = eye + ray * (step as f32 * 0.05);
            let Some(next) = room_of(point) else { return };
            if next != room {
                // Well within the opening, so that the steps' length is no matter.
                let along = if next.abs_diff(room) == 1 { point.z } else { point.x };
                let passes = ((along % 10.0) - 5.0).abs() < 1.9 && point.y.abs() < 1.9;
                if !(self.open.contains(&(room, next)) && passes) {
                    return;
                }
                room = next;
                seen.insert(room as u32);
            }
        }
    }
}

/// An opening in the wall at greater x, or greater z, of a room.
fn opening(x: usize, z: usize, in_x: bool) -> Vec<Vec3> {
    let (x, z) = (x as f32 * 10.0, z as f32 * 10.0);
    [(3.0, -2.0), (3.0, 2.0), (7.0, 2.0), (7.0, -2.0)]
        .map(|(along, y)| {
            if in_x { Vec3::new(x + 10.0, y, z + along) } else { Vec3::new(x + along, y, z + 10.0) }
        })
        .to_vec()
}

fn view_planes(eye: Vec3, forward: Vec3) -> (Frustum, Vec<Plane>) {
    let view = View::new(640.0, 480.0, 320.0, 0.1, 150.0).expect("a view");
    let camera = Transform::camera(eye, forward, Vec3::new(0.0, 1.0, 0.0)).expect("a camera");
    let frustum = Frustum::new(&view).in_world(&camera);
    let planes = frustum.planes(SIDES).skip(1).copied().collect();
    (frustum, planes)
}

fn visible(rooms: &Rooms, room: u32, eye: Vec3, planes: &[Plane]) -> BTreeSet<u32> {
    let mut seen = BTreeSet::new();
    assert!(rooms.visit_visible(room, eye, 0.1, planes, |room, _| {
        seen.insert(room);
    }));
    seen
}

/// Whatever a ray reaches through openings is visited.
#[test]
fn portals_miss_no_room() {
    let mut random = Random::new(30);
    let (mut reached, mut visited, mut all) = (0, 0, 0);
    for case in 0..cases(150) {
        let grid = Grid::new(6, &mut random);
        let room = random.below(36);
        let place = |random: &mut Random, cell: usize| 10.0 * cell as f32 + random.range(0.2, 9.8);
        let eye = Vec3::new(
            place(&mut random, room % 6),
            random.range(-1.5, 1.5),
            place(&mut random, room / 6),
        );
        let forward = Vec3::new(random.range(-1.0, 1.0), 0.01, random.range(-1.0, 1.0));
        let (frustum, planes) = view_planes(eye, forward);
        let seen = visible(&grid.rooms, room as u32, eye, &planes);
        let mut marched = BTreeSet::from([room as u32]);
        for _ in 0..200 {
            let ray = Vec3::new(
                random.range(-1.0, 1.0),
                random.range(-0.1, 0.1),
                random.range(-1.0, 1.0),
            );
            let Some(ray) = ray.normalized() else { continue };
            if frustum.contains(eye + ray * 10.0) {
                grid.march(eye, ray, &mut marched);
            }
        }
        assert!(marched.is_subset(&seen), "{case}: {marched:?} {seen:?}");
        reached += marched.len();
        visited += seen.len();
        all += 36;
    }
    assert!(reached > cases(150) * 3 / 2, "{reached}");
    assert!(visited < all / 4 && visited < reached * 2, "{visited} of {all}, {reached} reached");
}

#[test]
fn doorway_shows_the_room_behind_it_only() {
    let portals = [(0, 1, true), (0, 2, false)].map(|(from, to, in_x)| Portal {
        from,
        to,
        corners: opening(0, 0, in_x),
    });
    let rooms = Rooms::new(3, &portals).expect("rooms");
    let eye = Vec3::new(5.0, 0.0, 5.0);
    let seen_to = |forward| visible(&rooms, 0, eye, &view_planes(eye, forward).1);
    assert_eq!(seen_to(Vec3::new(1.0, 0.0, 0.0)), BTreeSet::from([0, 1]));
    assert_eq!(seen_to(Vec3::new(0.0, 0.0, 1.0)), BTreeSet::from([0, 2]));
    assert_eq!(seen_to(Vec3::new(-1.0, 0.0, 0.0)), BTreeSet::from([0]));
    // An eye in the opening, a little past its plane, looks on through it.
    for (x, is_seen) in [(9.95, true), (10.0, true), (10.05, true), (10.5, false)] {
        let eye = Vec3::new(x, 0.0, 5.0);
        let planes = view_planes(eye, Vec3::new(1.0, 0.0, 0.0)).1;
        assert_eq!(visible(&rooms, 0, eye, &planes).contains(&1), is_seen, "{x}");
    }
    // The planes of the room behind are those of the opening.
    let eye = Vec3::new(5.0, 0.0, 5.0);
    let planes = view_planes(eye, Vec3::new(1.0, 0.0, 0.0)).1;
    rooms.visit_visible(0, eye, 0.1, &planes, |room, planes| {
        if room == 1 {
            let inside = |p: Vec3| planes.iter().all(|plane| plane.contains(p));
            assert!(inside(Vec3::new(15.0, 0.0, 5.0)) && inside(Vec3::new(15.0, 0.0, 8.9)));
            assert!(!inside(Vec3::new(15.0, 0.0, 9.1)));
        }
    });
}

#[test]
fn portals_bad_input_and_bounds() {
    let good = Portal { from: 0, to: 1, corners: opening(0, 0, true) };
    let nan = Vec3::new(f32::NAN, 0.0, 0.0);
    let line = [0.0, 1.0, 2.0].map(|x| Vec3::new(x, 0.0, 0.0)).to_vec();
    for bad in [
        Portal { from: 2, ..good.clone() },
        Portal { to: 2, ..good.clone() },
        Portal { corners: vec![], ..good.clone() },
        Portal { corners: line, ..good.clone() },
        Portal { corners: vec![nan; 4], ..good.clone() },
        Portal { corners: vec![Vec3::ZERO; 33], ..good.clone() },
    ] {
        let result = Rooms::new(2, &[good.clone(), bad]);
        assert_eq!(result.err(), Some(Error::Portal { portal: 1 }));
    }
    let rooms = Rooms::new(2, std::slice::from_ref(&good)).expect("rooms");
    assert!(visible(&rooms, 9, Vec3::ZERO, &[]).is_empty());
    assert!(visible(&rooms, 0, nan, &[]).is_empty());
    // Rooms that all see each other end after the bound.
    let all = (0..40 * 40).map(|i| Portal { from: i / 40, to: i % 40, ..good.clone() });
    let rooms = Rooms::new(40, &all.collect::<Vec<_>>()).expect("rooms");
    let mut visits = 0;
    let eye = Vec3::new(5.0, 0.0, 5.0);
    assert!(!rooms.visit_visible(0, eye, 0.1, &[], |_, _| visits += 1));
    assert!(visits > 1000 && visits < Rooms::MAX_STEPS);
}

/// A tree over boxes: leaves are the cells of a grid of 2^`depth` by 2^`depth`.
fn tree(depth: u32) -> (BspTree, Vec<Sphere>) {
    fn split(
        nodes: &mut Vec<Node>,
        leaves: &mut Vec<Sphere>,
        low: [f32; 2],
        high: [f32; 2],
        depth: u32,
    ) -> Child {
        let middle = [(low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0];
        let centre = Vec3::new(middle[0], 0.0, middle[1]);
        let radius = (Vec3::new(high[0], 1.0, high[1]) - centre).length();
        let bounds = Sphere { centre, radius };
        if depth == 0 {
            leaves.push(bounds);
            return Child::Leaf(leaves.len() as u32 - 1);
        }
        let axis = (depth % 2) as usize;
        let normal = if axis == 0 { Vec3::new(1.0, 0.0, 0.0) } else { Vec3::new(0.0, 0.0, 1.0) };
        let index = nodes.len();
        let plane = Plane::through(normal, centre);
        nodes.push(Node { plane, inside: Child::Solid, outside: Child::Solid, bounds });
        let (mut cut_low, mut cut_high) = (low, high);
        cut_low[axis] = middle[axis];
        cut_high[axis] = middle[axis];
        nodes[index].inside = split(nodes, leaves, cut_low, high, depth - 1);
        nodes[index].outside = split(nodes, leaves, low, cut_high, depth - 1);
        Child::Node(index as u32)
    }
    let (mut nodes, mut leaves) = (Vec::new(), Vec::new());
    split(&mut nodes, &mut leaves, [0.0; 2], [64.0; 2], 2 * depth);
    (BspTree::new(nodes, leaves.clone()).expect("a tree"), leaves)
}

#[test]
fn tree_order_culling_and_sets() {
    let (tree, leaves) = tree(3);
    let mut random = Random::new(31);
    let (mut culled, mut seen) = (0, 0);
    for case in 0..cases(300) {
        let eye = Vec3::new(random.range(0.0, 64.0), 0.0, random.range(0.0, 64.0));
        let forward = Vec3::new(random.range(-1.0, 1.0), 0.0, random.range(-1.0, 1.0));
        let (frustum, _) = view_planes(eye, forward);
        let leaf = tree.leaf_at(eye).expect("in a leaf");
        assert!((leaves[leaf as usize].centre - eye).length() <= leaves[leaf as usize].radius);
        let mut sets = VisibleSets::new(leaves.len()).expect("sets");
        for to in 0..64 {
            if random.below(2) == 0 {
                sets.add(leaf, to);
            }
        }
        let set = sets.from_leaf(leaf);
        let mut front = Vec::new();
        tree.visit(Order::FrontToBack, eye, &frustum, Some(set), |leaf, _| front.push(leaf));
        let mut back = Vec::new();
        tree.visit(Order::BackToFront, eye, &frustum, Some(set), |leaf, _| back.push(leaf));
        back.reverse();
        assert_eq!(front, back, "{case}");
        // No leaf too many: each is within by itself. None too few: a leaf with a
        // point that is seen is visited.
        let expected: BTreeSet<u32> = (0..64)
            .filter(|&leaf| set.contains(leaf))
            .filter(|&leaf| {
                frustum.test_sphere(&leaves[leaf as usize], SIDES)
                    != fillrate_geometry::Containment::Outside
            })
            .collect();
        assert!(front.iter().all(|leaf| expected.contains(leaf)), "{case}");
        for _ in 0..200 {
            let point = Vec3::new(random.range(0.0, 64.0), 0.0, random.range(0.0, 64.0));
            let leaf = tree.leaf_at(point).expect("in a leaf");
            if set.contains(leaf) && frustum.contains(point) {
                assert!(front.contains(&leaf), "{case}: {leaf}");
                seen += 1;
            }
        }
        culled += 64 - front.len();
        // A nearer leaf hides a farther one on a ray through both, never the reverse.
        let place = |leaf: u32| front.iter().position(|&other| other == leaf);
        for _ in 0..8 {
            let ray = Vec3::new(random.range(-1.0, 1.0), 0.0, random.range(-1.0, 1.0));
            let along = (0..64).filter_map(|step| tree.leaf_at(eye + ray * step as f32));
            let places: Vec<usize> = along.filter_map(place).collect();
            let sorted = places.windows(2).all(|pair| pair[0] <= pair[1]);
            assert!(sorted, "{case}");
        }
    }
    assert!(culled > cases(300) * 32 && seen > cases(300) * 10, "{culled} {seen}");
}

#[test]
fn trees_that_are_none() {
    let bounds = Sphere { centre: Vec3::ZERO, radius: 1.0 };
    let plane = Plane { normal: Vec3::new(1.0, 0.0, 0.0), distance: 0.0 };
    let node = |inside, outside| Node { plane, inside, outside, bounds };
    let bad = |nodes: Vec<Node>| BspTree::new(nodes, vec![bounds; 2]).err();
    let error = |node| Some(Error::Node { node });
    assert_eq!(bad(vec![node(Child::Node(0), Child::Solid)]), error(0));
    assert_eq!(bad(vec![node(Child::Node(1), Child::Solid)]), error(0));
    assert_eq!(bad(vec![node(Child::Leaf(0), Child::Leaf(2))]), error(0));
    assert_eq!(bad(vec![node(Child::Leaf(0), Child::Leaf(0))]), error(0));
    let leaf = node(Child::Leaf(0), Child::Solid);
    assert_eq!(bad(vec![node(Child::Node(1), Child::Node(1)), leaf]), error(0));
    assert_eq!(bad(vec![leaf, node(Child::Node(0), Child::Solid)]), error(1));
    let flat = Plane { normal: Vec3::ZERO, distance: 0.0 };
    assert_eq!(bad(vec![Node { plane: flat, ..leaf }]), error(0));
    let tree = BspTree::new(vec![leaf], vec![bounds]).expect("a tree");
    assert_eq!(tree.leaf_at(Vec3::new(1.0, 0.0, 0.0)), Some(0));
    assert_eq!(tree.leaf_at(Vec3::new(-1.0, 0.0, 0.0)), None);
    assert_eq!(tree.leaf_at(Vec3::new(f32::NAN, 0.0, 0.0)), None);
    assert_eq!(BspTree::default().leaf_at(Vec3::ZERO), None);
    assert_eq!(BspTree::new(vec![], vec![bounds]).expect("a leaf").leaf_at(Vec3::ZERO), Some(0));
}

#[test]
fn visible_sets_of_runs() {
    let mut sets = VisibleSets::new(100).expect("sets");
    // Leaves 1 and 3; then 24 leaves without; then leaf 1 + 32; then a cut run.
    sets.add_runs(7, 1, &[0b101, 0, 3, 1, 0]);
    let seen: Vec<u32> = (0..200).filter(|&leaf| sets.from_leaf(7).contains(leaf)).collect();
    assert_eq!(seen, [1, 3, 33]);
    sets.add_runs(8, 90, &[0xff, 0xff, 0xff]);
    let seen: Vec<u32> = (0..200).filter(|&leaf| sets.from_leaf(8).contains(leaf)).collect();
    assert_eq!(seen, (90..100).collect::<Vec<u32>>());
    sets.add(100, 0);
    sets.add(0, u32::MAX);
    sets.add_runs(u32::MAX, u32::MAX, &[1, 2, 3]);
    assert!((0..200).all(|leaf| !sets.from_leaf(0).contains(leaf)));
    assert!(!sets.from_leaf(u32::MAX).contains(0));
    let many = VisibleSets::new(VisibleSets::MAX_LEAVES + 1);
    assert_eq!(many.err(), Some(Error::Limit { what: "leaves" }));
}

/// Eyes, planes and spheres of any bits: walks end, and visit only what exists.
#[test]
fn nonsense_ends() {
    let mut random = Random::new(32);
    let grid = Grid::new(6, &mut random);
    let (tree, _) = tree(2);
    let view = View::new(640.0, 480.0, 320.0, 0.1, 150.0).expect("a view");
    for _ in 0..cases(2_000) {
        let planes: Vec<Plane> = (0..random.below(6))
            .map(|_| Plane { normal: random.nasty_vector(), distance: random.nasty() })
            .collect();
        let eye = if random.below(2) == 0 { random.nasty_vector() } else { random.vector(60.0) };
        let room = random.below(40) as u32;
        let slack = random.nasty();
        grid.rooms.visit_visible(
            room,
            eye,
            slack,
            &planes[..planes.len().min(1)],
            |room, planes| {
                assert!(room < 36 && planes.len() < 64);
            },
        );
        let rows = [random.nasty_vector(), random.nasty_vector(), random.nasty_vector()];
        let frustum =
            Frustum::new(&view).in_world(&Transform { rows, shift: random.nasty_vector() });
        let mut visits = 0;
        tree.visit(Order::FrontToBack, eye, &frustum, None, |leaf, _| {
            assert!(leaf < 16);
            visits += 1;
        });
        assert!(visits <= 16);
        let corners = (0..random.below(6)).map(|_| random.nasty_vector()).collect();
        if let Ok(rooms) = Rooms::new(2, &[Portal { from: 0, to: 1, corners }]) {
            rooms.visit_visible(0, random.vector(9.0), 0.1, &[], |room, _| assert!(room < 2));
        }
        let _ = (Sphere::of_points([eye]), Transform::camera(eye, random.nasty_vector(), eye));
    }
}
