//! Parameters that only some draw states read: a second and a third colour, the
//! fog factor, deep z. They follow a triangle's planes where its state asks for
//! them, so that other triangles carry nothing of it.

use super::Registers;
use super::launch::{GROUP, NARROW, Params, share};

/// Lanes of the second colour, whose fourth is the fog factor.
pub(crate) const SPECULAR: usize = 0;
/// Lanes of the third colour; the fourth means nothing.
pub(crate) const BASE: usize = 4;

/// Which of them a draw state reads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct ExtraNeeds {
    /// The colours and the fog factor.
    pub colors: bool,
    /// Deep z.
    pub deep_z: bool,
}

impl ExtraNeeds {
    pub fn any(self) -> bool {
        self.colors || self.deep_z
    }
}

/// The parameters at launch, in lanes: see [`Registers`].
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Extra {
    pub colors: Params<[i32; NARROW]>,
    /// In the first lane.
    pub deep_z: Params<[i64; GROUP]>,
}

impl Extra {
    /// Those of a triangle that came without: black, no fog, depth 0.
    pub fn none() -> Extra {
        let mut extra = Extra::default();
        extra.colors.start[SPECULAR + 3] = Registers::NO_FOG.start;
        extra
    }

    /// The same where every pixel is `scale` x `scale` pixels of the surface.
    pub fn scaled(&self, scale: u32) -> Extra {
        let mut out = *self;
        for step in out.colors.dx.iter_mut().chain(&mut out.colors.dy) {
            *step = share(i64::from(*step), scale) as i32;
        }
        for step in out.deep_z.dx.iter_mut().chain(&mut out.deep_z.dy) {
            *step = share(*step, scale);
        }
        out
    }
}

impl From<&Registers> for Extra {
    fn from(registers: &Registers) -> Extra {
        let mut extra = Extra::default();
        let params = registers.specular.iter().chain(&registers.base);
        for (lane, param) in params.enumerate() {
            extra.colors.start[lane] = param.start;
            extra.colors.dx[lane] = param.dx;
            extra.colors.dy[lane] = param.dy;
        }
        extra.deep_z.set(0, &registers.deep_z);
        extra
    }
}
