//! The original library's environment variables.
//!
//! A switch is on where it is set to anything but 0. What each of them does
//! here is in `docs/settings.md`.
//!
//! Source: G246, the library's and the initialisation code's use of the
//! environment.

use std::collections::BTreeMap;

use crate::card::RESOLUTIONS;
use crate::scanout::{FILTER_THRESHOLDS, GammaTable, gamma_table};

/// The gamma of a board that nobody set.
pub(crate) const DEFAULT_GAMMA: f32 = 1.7;

/// The variables as values.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Variables {
    pub swap_interval: Option<u32>,
    pub no_splash: bool,
    pub shameless_plug: bool,
    pub no_dither_subtraction: bool,
    pub ignore_reopen: bool,
    pub bounds_check: bool,
    /// Red, green, blue.
    pub gamma: [f32; 3],
    pub resolution: Option<i32>,
    pub filter_thresholds: [u8; 3],
}

impl Variables {
    /// Reads them; values that cannot be used count as not set.
    pub fn new(all: &BTreeMap<String, String>) -> Variables {
        let text = |name: &str| all.get(name).map(|value| value.trim());
        let switch = |name: &str| text(name).is_some_and(|value| value != "0");
        let positive = |name: &str| {
            text(name).and_then(|v| v.parse().ok()).filter(|&g: &f32| g > 0.0 && g.is_finite())
        };
        let gamma = positive("SST_GAMMA").unwrap_or(DEFAULT_GAMMA);
        let thresholds = match switch("SST_VIDEO_FILTER_DISABLE") {
            true => [0; 3],
            false => text("SST_VIDEO_FILTER_THRESHOLD")
                .and_then(|v| u32::from_str_radix(v.trim_start_matches("0x"), 16).ok())
                .map_or(FILTER_THRESHOLDS, |v| [v >> 16, v >> 8, v].map(|v| v as u8)),
        };
        Variables {
            swap_interval: text("FX_GLIDE_SWAPINTERVAL").and_then(|v| v.parse().ok()),
            no_splash: switch("FX_GLIDE_NO_SPLASH"),
            shameless_plug: switch("FX_GLIDE_SHAMELESS_PLUG"),
            no_dither_subtraction: switch("FX_GLIDE_NO_DITHER_SUB"),
            ignore_reopen: switch("FX_GLIDE_IGNORE_REOPEN"),
            bounds_check: switch("FX_GLIDE_BOUNDS_CHECK"),
            gamma: ["SST_RGAMMA", "SST_GGAMMA", "SST_BGAMMA"]
                .map(|name| positive(name).unwrap_or(gamma)),
            resolution: text("SST_SCREENREZ").and_then(resolution),
            filter_thresholds: thresholds,
        }
    }

    /// The gamma tables of a board that was just opened.
    pub fn gamma_tables(&self) -> [GammaTable; 3] {
        self.gamma.map(gamma_table)
    }
}

/// A resolution by its width, or by width and height: `640` or `640x480`.
fn resolution(text: &str) -> Option<i32> {
    let names = |&(w, h): &(u32, u32)| text == format!("{w}x{h}");
    // Of several with one width, the highest.
    let by_width = |&(w, _): &(u32, u32)| text == w.to_string();
    let exact = RESOLUTIONS.iter().position(names);
    exact.or_else(|| RESOLUTIONS.iter().rposition(by_width)).map(|index| index as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn variables(pairs: &[(&str, &str)]) -> Variables {
        let all = pairs.iter().map(|(name, value)| (name.to_string(), value.to_string()));
        Variables::new(&all.collect())
    }

    #[test]
    fn values_are_read() {
        let v = variables(&[
            ("FX_GLIDE_SWAPINTERVAL", "0"),
            ("FX_GLIDE_NO_SPLASH", "1"),
            ("FX_GLIDE_SHAMELESS_PLUG", "0"),
            ("SST_GAMMA", "1.3"),
            ("SST_GGAMMA", "2"),
            ("SST_SCREENREZ", "640"),
            ("SST_VIDEO_FILTER_THRESHOLD", "0x102030"),
        ]);
        assert_eq!((v.swap_interval, v.no_splash, v.shameless_plug), (Some(0), true, false));
        assert_eq!((v.gamma, v.resolution), ([1.3, 2.0, 1.3], Some(7)));
        assert_eq!(v.filter_thresholds, [0x10, 0x20, 0x30]);
        assert_eq!(variables(&[("SST_SCREENREZ", "320x200")]).resolution, Some(0));
    }

    #[test]
    fn unusable_values_count_as_not_set() {
        let v = variables(&[
            ("FX_GLIDE_SWAPINTERVAL", "-1"),
            ("SST_GAMMA", "nan"),
            ("SST_RGAMMA", "-2"),
            ("SST_SCREENREZ", "12"),
            ("SST_VIDEO_FILTER_THRESHOLD", "x"),
        ]);
        assert_eq!(v, variables(&[]));
        assert_eq!(v.gamma, [DEFAULT_GAMMA; 3]);
    }
}
