use crate::{Containment, Error, Frustum, HalfSpace, LeafSet, Plane, PlaneMask, Sphere, Vec3};

/// What lies on one side of a node's plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Child {
    /// Another node, listed after its parent.
    Node(u32),
    /// A leaf: a convex piece of the world.
    Leaf(u32),
    /// Nothing to be in or to see: solid matter.
    Solid,
}

/// A plane that divides space, and what lies around it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// Divides the node's space.
    pub plane: Plane,
    /// Where N.P >= D.
    pub inside: Child,
    /// Where N.P < D.
    pub outside: Child,
    /// Around all leaves below.
    pub bounds: Sphere,
}

/// In which order leaves are visited.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Order {
    /// The nearest first: for tests cheaper than writes, and for culling.
    FrontToBack,
    /// The farthest first: right without a depth buffer, and for blending.
    BackToFront,
}

/// A tree of planes that sorts the leaves of a world from any point of view.
///
/// Source: TN, visibility determination, BSP trees.
#[derive(Clone, Debug, Default)]
pub struct BspTree {
    nodes: Vec<Node>,
    leaves: Vec<Sphere>,
}

impl BspTree {
    /// The most nodes and the most leaves.
    pub const MAX_NODES: usize = 1 << 24;

    /// A tree whose root is the first node; without nodes, the first leaf is all
    /// of space. `leaves` are the bounds of the leaves.
    ///
    /// # Errors
    /// [`Error::Limit`] for too many nodes or leaves; [`Error::Node`] for a node
    /// whose plane is none, or with a child that does not exist, comes before its
    /// parent or has two.
    pub fn new(nodes: Vec<Node>, leaves: Vec<Sphere>) -> Result<Self, Error> {
        if nodes.len().max(leaves.len()) > Self::MAX_NODES {
            return Err(Error::Limit { what: "nodes" });
        }
        let mut has_parent = vec![false; nodes.len()];
        let mut is_held = vec![false; leaves.len()];
        for (index, node) in nodes.iter().enumerate() {
            let mut take = |child| match child {
                Child::Solid => true,
                Child::Leaf(leaf) => is_held
                    .get_mut(leaf as usize)
                    .is_some_and(|held| !std::mem::replace(held, true)),
                Child::Node(node) => {
                    node as usize > index
                        && has_parent
                            .get_mut(node as usize)
                            .is_some_and(|held| !std::mem::replace(held, true))
                }
            };
            if !(node.plane.is_usable() && take(node.inside) && take(node.outside)) {
                return Err(Error::Node { node: index });
            }
        }
        Ok(Self { nodes, leaves })
    }

    /// The leaf that holds a point; `None` in solid matter or for a point that
    /// cannot be used.
    pub fn leaf_at(&self, point: Vec3) -> Option<u32> {
        if !point.is_usable() {
            return None;
        }
        let mut child = self.root();
        loop {
            match child {
                Child::Solid => return None,
                Child::Leaf(leaf) => return Some(leaf),
                Child::Node(node) => {
                    let node = &self.nodes[node as usize];
                    child = if node.plane.contains(point) { node.inside } else { node.outside };
                }
            }
        }
    }

    /// Visits the leaves that may be seen from `eye`, in order, each with the
    /// planes of `frustum` (in the world) that it may cross.
    ///
    /// Whole subtrees are left out where their bounds lie outside the frustum, or
    /// where `visible`, the set of the eye's leaf, holds none of their leaves.
    pub fn visit(
        &self,
        order: Order,
        eye: Vec3,
        frustum: &Frustum,
        visible: Option<LeafSet<'_>>,
        mut visit: impl FnMut(u32, PlaneMask),
    ) {
        if !eye.is_usable() {
            return;
        }
        let marks = visible.map(|set| self.mark(set));
        let mut todo = vec![(self.root(), frustum.used())];
        while let Some((child, mask)) = todo.pop() {
            let bounds = match child {
                Child::Solid => continue,
                Child::Leaf(leaf) if visible.is_some_and(|set| !set.contains(leaf)) => continue,
                Child::Leaf(leaf) => &self.leaves[leaf as usize],
                Child::Node(node) if marks.as_ref().is_some_and(|m| !m[node as usize]) => continue,
                Child::Node(node) => &self.nodes[node as usize].bounds,
            };
            let Containment::Within(mask) = frustum.test_sphere(bounds, mask) else { continue };
            match child {
                Child::Leaf(leaf) => visit(leaf, mask),
                Child::Node(node) => {
                    let node = &self.nodes[node as usize];
                    let (near, far) = if node.plane.contains(eye) {
                        (node.inside, node.outside)
                    } else {
                        (node.outside, node.inside)
                    };
                    let last_first = match order {
                        Order::FrontToBack => [far, near],
                        Order::BackToFront => [near, far],
                    };
                    todo.extend(last_first.map(|child| (child, mask)));
                }
                Child::Solid => {}
            }
        }
    }

    fn root(&self) -> Child {
        match (self.nodes.is_empty(), self.leaves.is_empty()) {
            (false, _) => Child::Node(0),
            (true, false) => Child::Leaf(0),
            (true, true) => Child::Solid,
        }
    }

    /// Which nodes hold a leaf of the set. Children come after their parents.
    fn mark(&self, set: LeafSet<'_>) -> Vec<bool> {
        let mut marks = vec![false; self.nodes.len()];
        for index in (0..self.nodes.len()).rev() {
            let node = &self.nodes[index];
            marks[index] = [node.inside, node.outside].into_iter().any(|child| match child {
                Child::Solid => false,
                Child::Leaf(leaf) => set.contains(leaf),
                Child::Node(node) => marks[node as usize],
            });
        }
        marks
    }
}
