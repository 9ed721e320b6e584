//! The levels, their names, detection and dispatch.

use core::fmt;
use core::str::FromStr;

use crate::{Kernel, Scalar, Simd};

/// A set of vector instructions. Which exist on a machine is found at run time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Level {
    /// No vector instructions asked for; everywhere.
    Scalar,
    /// x86-64 with SSE4.1 and POPCNT, four lanes.
    Sse41,
    /// x86-64 with AVX2 and POPCNT, eight lanes.
    Avx2,
    /// x86-64 with AVX-512 F, BW, DQ and VL, sixteen lanes.
    Avx512,
    /// AArch64 (little-endian), four lanes.
    Neon,
    /// WebAssembly with simd128, four lanes; fixed when compiled.
    Simd128,
}

/// A level name that is not known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownLevel(String);

impl fmt::Display for UnknownLevel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "unknown simd level '{}'; known:", self.0)?;
        Level::ALL.iter().try_for_each(|level| write!(f, " {level}"))
    }
}

impl std::error::Error for UnknownLevel {}

impl Level {
    /// Every level, on whatever machine.
    pub const ALL: [Level; 6] =
        [Level::Scalar, Level::Sse41, Level::Avx2, Level::Avx512, Level::Neon, Level::Simd128];

    /// The level's name, as configuration spells it.
    pub fn name(self) -> &'static str {
        match self {
            Level::Scalar => "scalar",
            Level::Sse41 => "sse4.1",
            Level::Avx2 => "avx2",
            Level::Avx512 => "avx512",
            Level::Neon => "neon",
            Level::Simd128 => "simd128",
        }
    }

    /// Whether this machine has the level.
    pub fn is_available(self) -> bool {
        match self {
            Level::Scalar => true,
            #[cfg(target_arch = "x86_64")]
            Level::Sse41 => crate::x86::Sse41::detect().is_some(),
            #[cfg(target_arch = "x86_64")]
            Level::Avx2 => crate::x86::Avx2::detect().is_some(),
            #[cfg(target_arch = "x86_64")]
            Level::Avx512 => crate::x86::Avx512::detect().is_some(),
            #[cfg(all(target_arch = "aarch64", target_feature = "neon", target_endian = "little"))]
            Level::Neon => true,
            #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
            Level::Simd128 => true,
            _ => false,
        }
    }

    /// The levels of this machine, narrowest first.
    pub fn available() -> impl Iterator<Item = Level> {
        Level::ALL.into_iter().filter(|level| level.is_available())
    }

    /// The widest level of this machine.
    pub fn best() -> Level {
        Level::available().last().unwrap_or(Level::Scalar)
    }

    /// Runs `kernel` at this level, or at the scalar level where the machine
    /// lacks it.
    #[inline]
    pub fn dispatch<K: Kernel>(self, kernel: K) -> K::Output {
        match self {
            #[cfg(target_arch = "x86_64")]
            Level::Sse41 => match crate::x86::Sse41::detect() {
                Some(token) => token.vectorize(kernel),
                None => Scalar.vectorize(kernel),
            },
            #[cfg(target_arch = "x86_64")]
            Level::Avx2 => match crate::x86::Avx2::detect() {
                Some(token) => token.vectorize(kernel),
                None => Scalar.vectorize(kernel),
            },
            #[cfg(target_arch = "x86_64")]
            Level::Avx512 => match crate::x86::Avx512::detect() {
                Some(token) => token.vectorize(kernel),
                None => Scalar.vectorize(kernel),
            },
            #[cfg(all(target_arch = "aarch64", target_feature = "neon", target_endian = "little"))]
            Level::Neon => crate::neon::Neon::new().vectorize(kernel),
            #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
            Level::Simd128 => crate::wasm::Simd128::new().vectorize(kernel),
            _ => Scalar.vectorize(kernel),
        }
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Level {
    type Err = UnknownLevel;

    fn from_str(text: &str) -> Result<Level, UnknownLevel> {
        let wanted = text.trim().to_ascii_lowercase();
        Level::ALL
            .into_iter()
            .find(|level| level.name() == wanted)
            .ok_or_else(|| UnknownLevel(text.into()))
    }
}
