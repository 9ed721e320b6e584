//! Fog: how much of a fragment's colour stays at a distance.
//!
//! Source: RAVE, fog; docs/sources.md says how distances are sampled.

use fillrate_engine::state::{FOG_SAMPLES, FogTable};

use crate::constants::fog;
use crate::state::State;
use crate::tags::{float, int};

/// Fog as the state sets it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FogCurve {
    mode: u32,
    start: f32,
    end: f32,
    density: f32,
}

impl FogCurve {
    /// The fog of a state; `None` where it is off or comes from alpha.
    pub fn of(state: &State) -> Option<FogCurve> {
        let mode = state.int(int::FOG_MODE);
        (mode >= fog::LINEAR).then(|| FogCurve {
            mode,
            start: state.float(float::FOG_START),
            end: state.float(float::FOG_END),
            density: state.float(float::FOG_DENSITY),
        })
    }

    /// The part of the colour that stays at distance `d`, 0..=1.
    pub fn stays(&self, d: f64) -> f64 {
        let [start, end, density] = [self.start, self.end, self.density].map(f64::from);
        let stays = match self.mode {
            fog::LINEAR if start == end => f64::from(u8::from(d < end)),
            fog::LINEAR => (end - d) / (end - start),
            fog::EXPONENTIAL => exp(-density * d),
            _ => exp(-(density * d) * (density * d)),
        };
        if stays.is_nan() { 1.0 } else { stays.clamp(0.0, 1.0) }
    }

    /// A power of two that `invW` is to be multiplied with, so that the engine's
    /// range of distances, 65536 to 1, ends where fog is at its end or later.
    pub fn scale(&self) -> f32 {
        let farthest = match self.mode {
            fog::LINEAR => self.start.abs().max(self.end.abs()),
            // Less than half of a 255th is left.
            fog::EXPONENTIAL => 6.3 / self.density.abs(),
            _ => 2.6 / self.density.abs(),
        };
        let farthest = if farthest.is_finite() { farthest.clamp(1e-6, 1e6) } else { 1.0 };
        // The last sample is a little short of 65536 times the first distance.
        let exponent = (farthest.to_bits() >> 23) as i32 - 127 + 2;
        f32::from_bits(((exponent - 16 + 127) as u32) << 23)
    }

    /// The engine's table for distances that were scaled by [`FogCurve::scale`].
    pub fn table(&self) -> FogTable {
        let scale = f64::from(self.scale());
        let sample = |i: usize| {
            let distance = scale / FogTable::w_of_sample(i);
            (self.stays(distance) * 255.0 + 0.5) as u8
        };
        FogTable::by_w(&core::array::from_fn::<u8, FOG_SAMPLES, _>(sample))
    }
}

/// e to the power of x, for x up to 0: the same bits on every machine, which a
/// platform's own function does not promise. The error is below 2^-40.
fn exp(x: f64) -> f64 {
    if x.is_nan() || x <= -700.0 {
        return 0.0;
    }
    if x > 0.0 {
        // Negative densities: nothing is lost.
        return 1.0;
    }
    let n = (x * core::f64::consts::LOG2_E).floor();
    let r = x - n * core::f64::consts::LN_2;
    let mut term = 1.0;
    let mut sum = 1.0;
    for i in 1..16 {
        term = term * r / f64::from(i);
        sum += term;
    }
    sum * f64::from_bits(((n as i64 + 1023) as u64) << 52)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(mode: u32, start: f32, end: f32, density: f32) -> FogCurve {
        FogCurve { mode, start, end, density }
    }

    #[test]
    fn the_exponential_is_one() {
        for i in 0..7000 {
            let x = f64::from(-i) / 10.0;
            let (ours, theirs) = (exp(x), x.exp());
            assert!((ours - theirs).abs() <= theirs * 1e-12, "{x}: {ours} {theirs}");
        }
        assert_eq!((exp(f64::NEG_INFINITY), exp(f64::NAN), exp(1.0)), (0.0, 0.0, 1.0));
    }

    #[test]
    fn distances_in_the_table_are_those_of_the_curve() {
        for fog in [
            curve(fog::LINEAR, 0.0, 1.0, 0.0),
            curve(fog::LINEAR, 10.0, 3000.0, 0.0),
            curve(fog::EXPONENTIAL, 0.0, 0.0, 0.02),
            curve(fog::EXPONENTIAL_SQUARED, 0.0, 0.0, 4.0),
        ] {
            let (table, scale) = (fog.table(), f64::from(fog.scale()));
            let last = scale / FogTable::w_of_sample(FOG_SAMPLES - 1);
            assert!(fog.stays(last) < 0.5 / 255.0, "{fog:?}: {last}");
            for i in 0..FOG_SAMPLES {
                let stays = fog.stays(scale / FogTable::w_of_sample(i)) * 255.0;
                assert!((f64::from(table.sample(i)) - stays).abs() <= 0.5);
            }
        }
    }

    #[test]
    fn without_a_range_fog_is_a_step() {
        let fog = curve(fog::LINEAR, 0.5, 0.5, 0.0);
        assert_eq!((fog.stays(0.4), fog.stays(0.5)), (1.0, 0.0));
        let reversed = curve(fog::LINEAR, 1.0, 0.0, 0.0);
        assert_eq!((reversed.stays(0.0), reversed.stays(1.0)), (0.0, 1.0));
        assert_eq!(curve(fog::LINEAR, 0.0, f32::MAX, 0.0).stays(1.0), 1.0);
    }
}
