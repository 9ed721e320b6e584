//! A launched triangle with its parameters in lanes, so that set-up works on
//! several at once. [`Registers`] holds the same by name.

use super::{Param, Registers, WideParam};
use crate::fixed;
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
    pub wide: [WideParams; MAX_TMUS],
}

/// 64-bit parameters of a group. They are integers, and nearly always such that
/// floats hold them; those that are not numbers there lie in `large`.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct WideParams {
    pub floats: Params<[f64; GROUP]>,
    large: Params<[i64; GROUP]>,
}

impl WideParams {
    /// From values of 32 fraction bits in the chip.
    #[inline(always)]
    pub fn convert(&mut self, values: [[f32; GROUP]; 3]) {
        if !self.set_floats(values.map(fixed::wide_floats)) {
            self.set_large(values.map(|values| values.map(fixed::wide)));
        }
    }

    /// From values that are what the chip has, but for a fraction: truncated
    /// toward zero, those beyond 64 bits kept within them.
    #[inline(always)]
    pub fn truncate(&mut self, values: [[f64; GROUP]; 3]) {
        if !self.set_floats(values.map(fixed::truncated)) {
            self.set_large(values.map(|values| values.map(|value| value as i64)));
        }
    }

    /// All of them zero.
    #[inline(always)]
    pub fn clear(&mut self) {
        self.floats = Params::default();
    }

    /// Sets the floats; false where some are not numbers.
    #[inline(always)]
    fn set_floats(&mut self, [start, dx, dy]: [[f64; GROUP]; 3]) -> bool {
        self.floats = Params { start, dx, dy };
        let mut fits = true;
        for lane in 0..GROUP {
            // A sum with something that is not a number is none either.
            let sum = start[lane] + dx[lane] + dy[lane];
            fits &= !sum.is_nan();
        }
        fits
    }

    #[cold]
    fn set_large(&mut self, [start, dx, dy]: [[i64; GROUP]; 3]) {
        self.large = Params { start, dx, dy };
    }

    /// One parameter.
    fn get(&self, lane: usize) -> WideParam {
        let either = |float: f64, large: i64| if float.is_nan() { large } else { float as i64 };
        WideParam {
            start: either(self.floats.start[lane], self.large.start[lane]),
            dx: either(self.floats.dx[lane], self.large.dx[lane]),
            dy: either(self.floats.dy[lane], self.large.dy[lane]),
        }
    }

    fn set(&mut self, lane: usize, param: &WideParam) {
        self.large.set(lane, param);
        self.floats.start[lane] = fixed::to_float(param.start);
        self.floats.dx[lane] = fixed::to_float(param.dx);
        self.floats.dy[lane] = fixed::to_float(param.dy);
    }

    /// All of them as integers.
    pub fn integers(&self) -> Params<[i64; GROUP]> {
        let mut out = Params::default();
        for lane in 0..GROUP {
            out.set(lane, &self.get(lane));
        }
        out
    }
}

/// Group and lane of parameter 0, 1, 2 (s, t, w) of a unit.
pub(crate) fn wide_lane(unit: usize, param: usize) -> (usize, usize) {
    (unit, param + usize::from(unit == 0))
}

impl<const N: usize> Params<[i64; N]> {
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
            for lane in 0..GROUP {
                let WideParam { start, dx, dy } = params.get(lane);
                let (dx, dy) = (share(dx, scale), share(dy, scale));
                params.set(lane, &WideParam { start, dx, dy });
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
