//! Rules of primitives.

use super::{Rule, Situation, rules};
use crate::call::Call;
use crate::draw::is_in_range;
use crate::registers::alpha;
use crate::vertex::GrVertex;

fn out_of_range(vertices: &[&GrVertex]) -> bool {
    !vertices.iter().all(|v| is_in_range(v))
}

fn any_out_of_range(vertices: &[GrVertex]) -> bool {
    !vertices.iter().all(is_in_range)
}

/// Whether a polygon turns both ways, or around more than once.
fn is_concave(vertices: &[GrVertex]) -> bool {
    let count = vertices.len();
    if count < 4 || any_out_of_range(vertices) {
        return false;
    }
    let edge = |i: usize| {
        let (a, b) = (&vertices[i % count], &vertices[(i + 1) % count]);
        [f64::from(b.x) - f64::from(a.x), f64::from(b.y) - f64::from(a.y)]
    };
    let turn = |i: usize| {
        let ([ax, ay], [bx, by]) = (edge(i), edge(i + 1));
        ax * by - ay * bx
    };
    let turns = || (0..count).map(turn).filter(|t| t.abs() > 1.0 / 64.0);
    let both_ways = turns().any(|t| t > 0.0) && turns().any(|t| t < 0.0);
    // The direction across changes twice in one turn around.
    let across: Vec<bool> =
        (0..count).map(edge).filter(|e| e[0] != 0.0).map(|e| e[0] > 0.0).collect();
    let changes =
        (0..across.len()).filter(|&i| across[i] != across[(i + 1) % across.len()]).count();
    both_ways || changes > 2
}

fn blends(at: &Situation<'_>) -> bool {
    at.open().is_none() || at.register(|b| b.fbi.alpha_mode, alpha::BLEND)
}

rules! { at;
    "grDrawPoint": GrDrawPoint (point) "pt" "is outside -2048..2047" fatal
        if out_of_range(&[point]);
    "grDrawLine": GrDrawLine (a, b) "v1" "or v2 is outside -2048..2047" fatal
        if out_of_range(&[a, b]);
    "grDrawTriangle": GrDrawTriangle (a, b, c) "a" "or b or c is outside -2048..2047" fatal
        if out_of_range(&[a, b, c]);
    "grDrawPolygon": GrDrawPolygon (vertices) "vlist" "has a vertex outside -2048..2047" fatal
        if any_out_of_range(vertices);
    "grDrawPolygon": GrDrawPolygon (vertices) "nverts" "is below 3" fatal
        if vertices.len() < 3;
    "grDrawPolygon": GrDrawPolygon (vertices) "vlist" "is not a convex polygon" warning
        if is_concave(vertices);
    "grDrawPlanarPolygon": GrDrawPlanarPolygon (vertices) "vlist" "has a vertex outside -2048..2047" fatal
        if any_out_of_range(vertices);
    "grDrawPlanarPolygon": GrDrawPlanarPolygon (vertices) "nverts" "is below 3" fatal
        if vertices.len() < 3;
    "grDrawPlanarPolygon": GrDrawPlanarPolygon (vertices) "vlist" "is not a convex polygon" warning
        if is_concave(vertices);
    "grAADrawPoint": GrAaDrawPoint (point) "p" "is outside -2048..2047" fatal
        if out_of_range(&[point]);
    "grAADrawPoint": GrAaDrawPoint () "" "alpha blending is off" warning
        if !blends(at);
    "grAADrawLine": GrAaDrawLine (a, b) "v1" "or v2 is outside -2048..2047" fatal
        if out_of_range(&[a, b]);
    "grAADrawLine": GrAaDrawLine () "" "alpha blending is off" warning
        if !blends(at);
    "grAADrawTriangle": GrAaDrawTriangle (a, b, c) "a" "or b or c is outside -2048..2047" fatal
        if out_of_range(&[a, b, c]);
    "grAADrawTriangle": GrAaDrawTriangle () "" "alpha blending is off" warning
        if !blends(at);
    "grAADrawPolygon": GrAaDrawPolygon (vertices) "vlist" "has a vertex outside -2048..2047" fatal
        if any_out_of_range(vertices);
    "grAADrawPolygon": GrAaDrawPolygon (vertices) "nverts" "is below 3" fatal
        if vertices.len() < 3;
    "grAADrawPolygon": GrAaDrawPolygon (vertices) "vlist" "is not a convex polygon" warning
        if is_concave(vertices);
    "grAADrawPolygon": GrAaDrawPolygon () "" "alpha blending is off" warning
        if !blends(at);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(points: &[(f32, f32)]) -> Vec<GrVertex> {
        points.iter().map(|&(x, y)| GrVertex { x, y, ..GrVertex::default() }).collect()
    }

    #[test]
    fn convex_polygons_are_told_from_others() {
        let square = [(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0)];
        assert!(!is_concave(&polygon(&square)));
        let repeated = [(0.0, 0.0), (9.0, 0.0), (9.0, 0.0), (9.0, 9.0), (4.0, 9.0), (0.0, 9.0)];
        assert!(!is_concave(&polygon(&repeated)));
        let arrow = [(0.0, 0.0), (9.0, 0.0), (3.0, 3.0), (0.0, 9.0)];
        assert!(is_concave(&polygon(&arrow)));
        let crossed = [(0.0, 0.0), (9.0, 9.0), (9.0, 0.0), (0.0, 9.0)];
        assert!(is_concave(&polygon(&crossed)));
        // A five-pointed star always turns the same way, twice around.
        let star = [(50.0, 0.0), (79.0, 90.0), (2.0, 35.0), (98.0, 35.0), (21.0, 90.0)];
        assert!(is_concave(&polygon(&star)));
    }
}
