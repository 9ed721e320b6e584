//! What a library is made with.

use fillrate_engine::DeviceConfig;

use crate::board::Chip;

/// A board and how it is drawn for.
#[derive(Clone, Debug)]
pub struct RedlineConfig {
    /// The chip.
    pub chip: Chip,
    /// Mebibytes of video memory: 4 or 8; other values count as the nearer one.
    pub memory: u32,
    /// Columns and rows of the desktop in windowed mode, 16 bits a pixel.
    pub desktop: (u32, u32),
    /// The order of `V_FIFO_BITBLT`'s corners: destination first as the headers
    /// have it, or source first as some programs do.
    pub blit_source_first: bool,
    /// Whether issued commands are carried out by a thread of the device, so
    /// that issuing does not wait; changes no pixel.
    pub background: bool,
    /// How the engine works; changes no pixel.
    pub device: DeviceConfig,
}

impl Default for RedlineConfig {
    /// A V2000 board with 4 MiB on a desktop of 1024x768.
    fn default() -> RedlineConfig {
        RedlineConfig {
            chip: Chip::default(),
            memory: 4,
            desktop: (1024, 768),
            blit_source_first: false,
            background: true,
            device: DeviceConfig::default(),
        }
    }
}

impl RedlineConfig {
    /// Bytes of video memory.
    pub fn memory_bytes(&self) -> u32 {
        if self.memory > 4 { 8 << 20 } else { 4 << 20 }
    }

    /// The desktop as far as a board can show it: its pitch is one of the
    /// chip's, and it leaves a mebibyte of memory.
    pub fn desktop_size(&self) -> (u32, u32) {
        let width = self.desktop.0.clamp(1, self.chip.max_pitch() / 2);
        let pitch = self.chip.stride(width * 2).map_or(1, |code| self.chip.linebytes(code));
        let rows = (self.memory_bytes() - (1 << 20)) / pitch;
        (width, self.desktop.1.clamp(1, rows))
    }

    /// What pictures depend on, as names and values for a recording.
    pub fn describe(&self) -> Vec<(String, String)> {
        let (width, height) = self.desktop;
        let pairs = [
            ("chip", self.chip.name().to_string()),
            ("memory", self.memory.to_string()),
            ("desktop", format!("{width}x{height}")),
            ("blit_source_first", self.blit_source_first.to_string()),
        ];
        pairs.into_iter().map(|(key, value)| (key.to_string(), value)).collect()
    }

    /// The configuration that [`describe`](Self::describe) described; unknown
    /// names and values are left out.
    pub fn from_description(pairs: impl IntoIterator<Item = (String, String)>) -> RedlineConfig {
        let mut config = RedlineConfig::default();
        for (key, value) in pairs {
            config.set(&key, &value);
        }
        config
    }

    fn set(&mut self, key: &str, value: &str) {
        let size = || {
            let (width, height) = value.split_once('x')?;
            Some((width.parse().ok()?, height.parse().ok()?))
        };
        match key {
            "chip" => self.chip = Chip::by_name(value).unwrap_or(self.chip),
            "memory" => self.memory = value.parse().unwrap_or(self.memory),
            "desktop" => self.desktop = size().unwrap_or(self.desktop),
            "blit_source_first" => {
                self.blit_source_first = value.parse().unwrap_or(self.blit_source_first);
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn descriptions_come_back() {
        let config = RedlineConfig {
            chip: Chip::V1000,
            memory: 8,
            desktop: (800, 600),
            blit_source_first: true,
            ..RedlineConfig::default()
        };
        let back = RedlineConfig::from_description(config.describe());
        assert_eq!(back.describe(), config.describe());
        let huge = RedlineConfig { desktop: (u32::MAX, u32::MAX), ..config };
        assert_eq!(huge.desktop_size(), (2560, 1433));
    }
}
