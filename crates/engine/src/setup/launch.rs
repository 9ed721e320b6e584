//! A launched triangle with its parameters in lanes, so that set-up works on
//! several at once. [`Registers`] holds the same by name.

use super::{Param, Registers, WideParam};
use crate::state::MAX_TMUS;

/// How many 32-bit parameters there are, padded to a vector: red, green, blue,
/// alpha, z.
pub(crate) const NARROW: usize = 8;
/// Lane of z.
pub(crate) const Z: usize = 4;
/// 64-bit parameters of a group.
pub(crate) const GROUP: usize = 4;

/// Start value and steps of parameters, lane by lane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Params<T> {
    pub start: T,
    pub dx: T,
    pub dy: T,
}

/// What launches a triangle: see [`Registers`].
///
/// The 64-bit parameters come in a group for each texture unit: the first is
/// w of the pixel pipeline, s, t, w; the others are s, t, w and a lane without
/// meaning.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Launch {
    pub x: [i32; 3],
    pub y: [i32; 3],
    pub negative: bool,
    pub narrow: Params<[i32; NARROW]>,
    pub wide: [Params<[i64; GROUP]>; MAX_TMUS],
}

/// Group and lane of parameter 0, 1, 2 (s, t, w) of a unit.
pub(crate) fn wide_lane(unit: usize, param: usize) -> (usize, usize) {
    (unit, param + usize::from(unit == 0))
}

impl<const N: usize> Params<[i64; N]> {
    fn get(&self, lane: usize) -> WideParam {
        WideParam { start: self.start[lane], dx: self.dx[lane], dy: self.dy[lane] }
    }

    pub(super) fn set(&mut self, lane: usize, param: &WideParam) {
        (self.start[lane], self.dx[lane], self.dy[lane]) = (param.start, param.dx, param.dy);
    }
}

impl From<&Registers> for Launch {
    fn from(registers: &Registers) -> Launch {
        let Registers { x, y, negative, color, z, w, tmu, .. } = registers;
        let mut launch = Launch { x: *x, y: *y, negative: *negative, ..Launch::default() };
        for (lane, param) in color.iter().chain([z]).enumerate() {
            launch.narrow.start[lane] = param.start;
            launch.narrow.dx[lane] = param.dx;
            launch.narrow.dy[lane] = param.dy;
        }
        launch.wide[0].set(0, w);
        for (unit, params) in tmu.iter().enumerate() {
            for (i, param) in params.iter().enumerate() {
                let (group, lane) = wide_lane(unit, i);
                launch.wide[group].set(lane, param);
            }
        }
        launch
    }
}

/// A step where every pixel is `scale` x `scale` pixels, to the nearest.
pub(super) fn share(step: i64, scale: u32) -> i64 {
    let n = i64::from(scale);
    step.wrapping_add(n / 2).div_euclid(n)
}

impl Launch {
    /// The same triangle where every pixel is `scale` x `scale` pixels of the
    /// surface. Steps are rounded to the nearest.
    pub fn scaled(&self, scale: u32) -> Launch {
        let mut out = *self;
        for coordinate in out.x.iter_mut().chain(&mut out.y) {
            *coordinate *= scale as i32;
        }
        for step in out.narrow.dx.iter_mut().chain(&mut out.narrow.dy) {
            *step = share(i64::from(*step), scale) as i32;
        }
        for params in &mut out.wide {
            for step in params.dx.iter_mut().chain(&mut params.dy) {
                *step = share(*step, scale);
            }
        }
        out
    }

    /// By name; units from `units` on count as zero.
    pub fn registers(&self, units: usize) -> Registers {
        let narrow = |lane: usize| Param {
            start: self.narrow.start[lane],
            dx: self.narrow.dx[lane],
            dy: self.narrow.dy[lane],
        };
        let mut registers = Registers {
            x: self.x,
            y: self.y,
            negative: self.negative,
            color: core::array::from_fn(narrow),
            z: narrow(Z),
            w: self.wide[0].get(0),
            ..Registers::default()
        };
        registers.specular[3] = Registers::NO_FOG;
        for (unit, params) in registers.tmu.iter_mut().enumerate().take(units) {
            for (i, param) in params.iter_mut().enumerate() {
                let (group, lane) = wide_lane(unit, i);
                *param = self.wide[group].get(lane);
            }
        }
        registers
    }
}
