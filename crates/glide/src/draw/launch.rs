//! Triangles whose gradients the library computes itself.

use fillrate_engine::fixed;
use fillrate_engine::state::MAX_TMUS;
use fillrate_engine::{Param, Registers, Vertex, WideParam};

/// Everything a triangle iterates, as floats: red, green, blue, alpha, z, w,
/// then s, t, w of each unit.
pub(super) type Values = [f32; 6 + 3 * MAX_TMUS];

/// The place of alpha in [`Values`].
pub(super) const ALPHA: usize = 3;

/// The values of a vertex.
pub(super) fn values(v: &Vertex) -> Values {
    let mut out = [0.0; 6 + 3 * MAX_TMUS];
    out[..6].copy_from_slice(&[v.r, v.g, v.b, v.a, v.z, v.w]);
    for (out, tmu) in out[6..].chunks_exact_mut(3).zip(&v.tmu) {
        out.copy_from_slice(&[tmu.s, tmu.t, tmu.w]);
    }
    out
}

/// `f` of each pair.
pub(super) fn zip(a: &Values, b: &Values, f: impl Fn(f32, f32) -> f32) -> Values {
    core::array::from_fn(|i| f(a[i], b[i]))
}

/// A triangle with its values at the first corner and their steps.
pub(super) struct Ramp {
    pub start: Values,
    pub dx: Values,
    pub dy: Values,
}

impl Ramp {
    /// The same values everywhere.
    pub fn constant(start: Values) -> Ramp {
        Ramp { start, dx: Default::default(), dy: Default::default() }
    }

    /// The registers of a triangle with these corners; `negative` is its sign.
    pub fn registers(&self, corners: [(f32, f32); 3], negative: bool) -> Registers {
        let param = |i: usize, convert: fn(f32) -> i32| Param {
            start: convert(self.start[i]),
            dx: convert(self.dx[i]),
            dy: convert(self.dy[i]),
        };
        let wide = |i: usize| WideParam {
            start: fixed::wide(self.start[i]),
            dx: fixed::wide(self.dx[i]),
            dy: fixed::wide(self.dy[i]),
        };
        Registers {
            x: corners.map(|(x, _)| fixed::coord(x)),
            y: corners.map(|(_, y)| fixed::coord(y)),
            negative,
            color: core::array::from_fn(|i| param(i, fixed::color)),
            z: param(4, fixed::depth),
            w: wide(5),
            tmu: core::array::from_fn(|unit| core::array::from_fn(|i| wide(6 + 3 * unit + i))),
            ..Registers::default()
        }
    }
}

/// Registers whose launch ends up where `registers` would without sub-pixel
/// adjustment: the adjustment is taken off first.
pub(super) fn without_adjustment(registers: &Registers) -> Registers {
    let mut out = *registers;
    let moved = after_launch(registers);
    let narrow = |out: &mut Param, moved: &Param| {
        out.start = out.start.wrapping_sub(moved.start.wrapping_sub(out.start));
    };
    let wide = |out: &mut WideParam, moved: &WideParam| {
        out.start = out.start.wrapping_sub(moved.start.wrapping_sub(out.start));
    };
    out.color.iter_mut().zip(&moved.color).for_each(|(out, moved)| narrow(out, moved));
    narrow(&mut out.z, &moved.z);
    wide(&mut out.w, &moved.w);
    let units = out.tmu.iter_mut().flatten().zip(moved.tmu.iter().flatten());
    units.for_each(|(out, moved)| wide(out, moved));
    out
}

/// The start registers as a launch leaves them: moved to the centre of the
/// first corner's pixel. A second launch without new starts moves them again.
///
/// Source: SST1, sub-pixel correction; G246, `grDrawLine` relies on it.
pub(super) fn after_launch(registers: &Registers) -> Registers {
    let (dx, dy) = (8 - (registers.x[0] & 15), 8 - (registers.y[0] & 15));
    let mut out = *registers;
    let narrow = |p: &mut Param| {
        let moved = p.dx.wrapping_mul(dx).wrapping_add(p.dy.wrapping_mul(dy)) >> 4;
        p.start = p.start.wrapping_add(moved);
    };
    let wide = |p: &mut WideParam| {
        let step = |d: i64, by: i32| d.wrapping_mul(i64::from(by));
        p.start = p.start.wrapping_add(step(p.dx, dx).wrapping_add(step(p.dy, dy)) >> 4);
    };
    out.color.iter_mut().for_each(narrow);
    narrow(&mut out.z);
    wide(&mut out.w);
    out.tmu.iter_mut().flatten().for_each(wide);
    out
}
