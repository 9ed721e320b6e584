//! From the vertices of a primitive to its triangles, lines and points.

use super::Shape;
use crate::state::topology;
use crate::stream::MAX_VERTICES;

/// The fewest vertices that draw anything.
pub fn fewest(kind: u32) -> usize {
    match kind {
        topology::TRIANGLE | topology::TRIANGLES | topology::STRIP | topology::FAN => 3,
        topology::LINES | topology::LINE_STRIP => 2,
        _ => 1,
    }
}

/// The most vertices that a primitive uses.
pub fn most(kind: u32) -> usize {
    if kind == topology::TRIANGLE { 3 } else { MAX_VERTICES }
}

/// What the primitive consists of.
pub fn shape(kind: u32) -> Shape {
    match fewest(kind) {
        3 => Shape::Triangle,
        2 => Shape::Line,
        _ => Shape::Point,
    }
}

/// The parts of a primitive of `count` vertices, each as three indices; lines use two of them,
/// points one. Every other triangle of a strip is turned so that all face the same way.
pub fn parts(kind: u32, count: usize) -> impl Iterator<Item = [usize; 3]> {
    let (step, width) = match kind {
        topology::TRIANGLE | topology::TRIANGLES => (3, 3),
        topology::STRIP | topology::FAN => (1, 3),
        topology::LINES => (2, 2),
        topology::LINE_STRIP => (1, 2),
        _ => (1, 1),
    };
    let starts = (0..count).step_by(step).take_while(move |i| i + width <= count);
    starts.map(move |i| match (kind, i % 2) {
        (topology::STRIP, 1) => [i + 1, i, i + 2],
        (topology::FAN, _) => [0, i + 1, i + 2],
        _ => [i, i + 1, i + 2],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(kind: u32, count: usize) -> Vec<[usize; 3]> {
        parts(kind, count).collect()
    }

    #[test]
    fn vertices_make_parts() {
        assert_eq!(all(topology::TRIANGLE, 3), [[0, 1, 2]]);
        assert_eq!(all(topology::TRIANGLES, 7), [[0, 1, 2], [3, 4, 5]]);
        assert_eq!(all(topology::STRIP, 5), [[0, 1, 2], [2, 1, 3], [2, 3, 4]]);
        assert_eq!(all(topology::FAN, 4), [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(all(topology::LINES, 5), [[0, 1, 2], [2, 3, 4]]);
        assert_eq!(all(topology::LINE_STRIP, 3).len(), 2);
        assert_eq!(all(topology::POINTS, 3).len(), 3);
        assert_eq!(all(topology::STRIP, 2).len(), 0);
    }
}
