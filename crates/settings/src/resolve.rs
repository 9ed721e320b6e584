//! Layers to settings.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use fillrate_engine::DeviceConfig;
use fillrate_engine::target::TileSize;
use fillrate_glide::card::{CARDS, Card};
use fillrate_glide::{GlideConfig, Improvements, MAX_SCALE, ScanOut};
use fillrate_redline::{Chip, RedlineConfig};
use fillrate_simd::Level;

use crate::layer::{CardTable, Layer, Verite};

/// The file's name.
const FILE: &str = "fillrate.toml";

/// Everything that is set.
#[derive(Clone, Debug)]
pub struct Settings {
    /// How the library works.
    pub glide: GlideConfig,
    /// RRedline's board, and how it draws.
    pub redline: RedlineConfig,
    /// RRedline's command buffers are dropped instead of issued, which measures
    /// the program alone.
    pub speed_of_light: bool,
    /// Record every call here.
    pub trace: Option<PathBuf>,
    /// Write frames and their log here.
    pub capture: Option<PathBuf>,
    /// Write every Nth frame; 0 writes the log alone.
    pub every: u64,
    /// End the program after so many swaps.
    pub exit_after: Option<u64>,
    /// How pictures of frames look; hashes are of what the buffer holds.
    pub scan_out: ScanOut,
    /// The file that was read.
    pub file: Option<PathBuf>,
    /// What could not be used, in words.
    pub problems: Vec<String>,
}

/// Where the file is looked for, in order: `FILLRATE_CONFIG` alone where it is
/// set; else the working directory, then the user's configuration folder.
fn candidates() -> Vec<PathBuf> {
    let variable = |name: &str| std::env::var_os(name).filter(|value| !value.is_empty());
    if let Some(file) = variable("FILLRATE_CONFIG") {
        return vec![PathBuf::from(file)];
    }
    let home = || variable("HOME").map(|home| Path::new(&home).join(".config"));
    let folder = variable("XDG_CONFIG_HOME").map(PathBuf::from).or_else(home);
    let own = folder.map(|folder| folder.join("fillrate").join(FILE));
    [Some(PathBuf::from(FILE)), own].into_iter().flatten().collect()
}

impl Settings {
    /// Reads the file and the environment.
    pub fn load() -> Settings {
        Settings::load_checking(false)
    }

    /// The same; `check` says whether checking mode is on where neither says
    /// anything.
    pub fn load_checking(check: bool) -> Settings {
        let text = |path: PathBuf| {
            let text = std::fs::read_to_string(&path);
            match text {
                Ok(text) => Some((path, Ok(text))),
                // A file that is asked for must be there.
                Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
                    let asked = std::env::var_os("FILLRATE_CONFIG").is_some();
                    asked.then(|| (path, Err(error.to_string())))
                }
                Err(error) => Some((path, Err(error.to_string()))),
            }
        };
        let file = candidates().into_iter().find_map(text);
        // Variables that are not text are not ours.
        let variables = std::env::vars_os().filter_map(|(name, value)| {
            Some((name.into_string().ok()?, value.into_string().ok()?))
        });
        Settings::from_parts(file, variables, check)
    }

    /// The settings of a file (its path and its text, or why it cannot be
    /// read) and of variables; see [`Settings::load_checking`].
    pub fn from_parts(
        file: Option<(PathBuf, Result<String, String>)>,
        variables: impl Iterator<Item = (String, String)>,
        check: bool,
    ) -> Settings {
        let mut problems = Vec::new();
        let layer = match &file {
            None => Layer::default(),
            Some((path, text)) => {
                let layer = text.clone().and_then(|text| Layer::from_toml(&text));
                layer.unwrap_or_else(|problem| {
                    problems.push(format!("{} is not used: {problem}", path.display()));
                    Layer::default()
                })
            }
        };
        let mut layer = layer.overridden_by(Layer::from_variables(variables, &mut problems));
        layer.board.check = Some(layer.board.check.unwrap_or(check));
        let glide = glide(&layer, &mut problems);
        let redline = redline(&layer.verite, glide.device.clone(), &mut problems);
        let output = layer.output;
        Settings {
            glide,
            redline,
            speed_of_light: layer.verite.speed_of_light.unwrap_or(false),
            trace: output.trace,
            capture: output.capture,
            every: output.every.unwrap_or(1),
            exit_after: output.exit_after.filter(|&n| n > 0),
            scan_out: ScanOut {
                gamma: output.gamma.unwrap_or(false),
                filter: output.filter.unwrap_or(false),
            },
            file: file.map(|(path, _)| path),
            problems,
        }
    }
}

/// A value in its range, or a problem.
fn within<T>(
    name: &str,
    value: Option<u64>,
    convert: impl Fn(u64) -> Option<T>,
    allowed: &str,
    problems: &mut Vec<String>,
) -> Option<T> {
    let value = value?;
    let converted = convert(value);
    if converted.is_none() {
        problems.push(format!("{name} = {value} is not used: {allowed}"));
    }
    converted
}

fn glide(layer: &Layer, problems: &mut Vec<String>) -> GlideConfig {
    let default = GlideConfig::default();
    let boards = |n: u64| (1..=4).contains(&n).then_some(n as usize);
    let board = &layer.board;
    GlideConfig {
        device: device(layer, problems),
        card: card(board.card.as_deref(), &layer.cards, problems),
        boards: within("boards", board.boards, boards, "there are 1 to 4", problems)
            .unwrap_or(default.boards),
        check: board.check.unwrap_or(default.check),
        splash: board.splash.unwrap_or(default.splash),
        improve: improvements(layer, problems),
        variables: layer.variables.clone(),
    }
}

fn redline(verite: &Verite, device: DeviceConfig, problems: &mut Vec<String>) -> RedlineConfig {
    let default = RedlineConfig::default();
    let chip = verite.chip.as_deref().and_then(|name| {
        let chip = Chip::by_name(name);
        if chip.is_none() {
            problems.push(format!("chip = {name} is not used: it is v1000 or v2000"));
        }
        chip
    });
    let desktop = verite.desktop.as_deref().and_then(|text| {
        let sides =
            text.split_once('x').and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
        let sides = sides.filter(|(w, h)| (1..=2048).contains(w) && (1..=2048).contains(h));
        if sides.is_none() {
            problems.push(format!("desktop = {text} is not used: it is 1x1 to 2048x2048"));
        }
        sides
    });
    let memory = |n: u64| matches!(n, 4 | 8).then_some(n as u32);
    RedlineConfig {
        chip: chip.unwrap_or(default.chip),
        memory: within("memory", verite.memory, memory, "boards have 4 or 8 MB", problems)
            .unwrap_or(default.memory),
        desktop: desktop.unwrap_or(default.desktop),
        blit_source_first: verite.blit_source_first.unwrap_or(default.blit_source_first),
        device,
        ..default
    }
}

fn improvements(layer: &Layer, problems: &mut Vec<String>) -> Improvements {
    let improve = &layer.improve;
    let scale = |n: u64| u32::try_from(n).ok().filter(|n| (1..=MAX_SCALE).contains(n));
    Improvements {
        scale: within("scale", improve.scale, scale, "it is 1 to 4", problems).unwrap_or(1),
        color32: improve.color32.unwrap_or(false),
        supersample: improve.supersample.unwrap_or(false),
    }
}

fn device(layer: &Layer, problems: &mut Vec<String>) -> DeviceConfig {
    let default = DeviceConfig::default();
    let draw = &layer.draw;
    let threads = |n: u64| (1..=256).contains(&n).then_some(n as usize);
    let tile = |n: u64| match n {
        32 => Some(TileSize::Small),
        64 => Some(TileSize::Medium),
        128 => Some(TileSize::Large),
        _ => None,
    };
    let threads = within("threads", draw.threads, threads, "there are 1 to 256", problems);
    let tile = within("tile", draw.tile, tile, "tiles are 32, 64 or 128 pixels", problems);
    let level = draw.simd.as_deref().and_then(|name| match name.parse::<Level>() {
        Ok(level) if level.is_available() => Some(level),
        Ok(level) => {
            problems.push(format!("simd = {level} is not used: this machine lacks it"));
            None
        }
        Err(error) => {
            problems.push(format!("simd = {name} is not used: {error}"));
            None
        }
    });
    DeviceConfig {
        threads: threads.unwrap_or(default.threads),
        level: level.unwrap_or(default.level),
        tile: tile.unwrap_or(default.tile),
    }
}

/// The board of that name: one of the file's, or a built-in one.
fn card(
    name: Option<&str>,
    tables: &BTreeMap<String, CardTable>,
    problems: &mut Vec<String>,
) -> Card {
    let Some(name) = name else { return Card::default() };
    let own = tables.get(name).map(|table| Card {
        name: name.to_string().into(),
        frame_buffer: table.frame_buffer,
        units: table.units,
        texture: table.texture,
        interleaved: table.interleaved,
    });
    match own.or_else(|| Card::by_name(name)) {
        Some(card) if card.is_valid() => card,
        Some(_) => {
            problems.push(format!(
                "board {name} is not used: boards have 1 to 3 units of 1, 2 or 4 MB and 1, 2 or 4 \
                 MB of frame buffer"
            ));
            Card::default()
        }
        None => {
            let names: Vec<&str> =
                tables.keys().map(String::as_str).chain(CARDS.iter().map(|c| &*c.name)).collect();
            problems.push(format!("card = {name} is not used: boards are {}", names.join(", ")));
            Card::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn settings(text: &str, variables: &[(&str, &str)]) -> Settings {
        let variables = variables.iter().map(|(name, value)| (name.to_string(), value.to_string()));
        Settings::from_parts(Some((FILE.into(), Ok(text.into()))), variables, false)
    }

    const EVERYTHING: &str = "
        [draw]
        threads = 3
        simd = \"scalar\"
        tile = 32
        [board]
        card = \"mine\"
        boards = 2
        check = true
        splash = true
        [cards.mine]
        frame_buffer = 4
        units = 3
        texture = 4
        interleaved = true
        [output]
        trace = \"a.trace\"
        capture = \"frames\"
        every = 5
        exit_after = 7
        gamma = true
        filter = true
        [improve]
        scale = 3
        color32 = true
        supersample = true
        [verite]
        chip = \"v1000\"
        memory = 8
        desktop = \"800x600\"
        blit_source_first = true
        speed_of_light = true
        [variables]
        SST_GAMMA = \"1.3\"
    ";

    #[test]
    fn everything_can_be_set_in_the_file() {
        let s = settings(EVERYTHING, &[]);
        assert_eq!(s.problems, Vec::<String>::new());
        assert_eq!((s.glide.device.threads, s.glide.device.level), (3, Level::Scalar));
        assert_eq!(s.glide.device.tile, TileSize::Small);
        let card = &s.glide.card;
        assert_eq!((&*card.name, card.units, card.interleaved), ("mine", 3, true));
        assert_eq!((s.glide.boards, s.glide.check, s.glide.splash), (2, true, true));
        assert_eq!((s.every, s.exit_after), (5, Some(7)));
        assert_eq!(s.scan_out, ScanOut { gamma: true, filter: true });
        assert_eq!(s.glide.variables["SST_GAMMA"], "1.3");
        assert_eq!(s.capture, Some("frames".into()));
        let improve = Improvements { scale: 3, color32: true, supersample: true };
        assert_eq!(s.glide.improve, improve);
        let redline = &s.redline;
        assert_eq!((redline.chip, redline.memory), (Chip::V1000, 8));
        assert_eq!((redline.desktop, redline.device.threads), ((800, 600), 3));
        assert!(redline.blit_source_first && s.speed_of_light);
    }

    #[test]
    fn variables_win_over_the_file() {
        let s = settings(
            EVERYTHING,
            &[
                ("FILLRATE_THREADS", "1"),
                ("FILLRATE_CARD", "voodoo-4mb"),
                ("FILLRATE_CHECK", "0"),
                ("FILLRATE_GAMMA", "off"),
                ("SST_GAMMA", "2"),
                ("HOME", "/nowhere"),
            ],
        );
        assert_eq!(s.problems, Vec::<String>::new());
        assert_eq!((s.glide.device.threads, s.glide.check), (1, false));
        assert_eq!((&*s.glide.card.name, s.glide.boards), ("voodoo-4mb", 2));
        assert_eq!(s.scan_out, ScanOut { gamma: false, filter: true });
        assert_eq!(s.glide.variables["SST_GAMMA"], "2");
    }

    #[test]
    fn what_cannot_be_used_is_told_of() {
        for (text, variables, told) in [
            ("[draw]\nthreads = 0", &[][..], "threads = 0"),
            ("[draw]\nthread = 1", &[], "unknown field"),
            ("[draw", &[], "fillrate.toml"),
            ("[board]\ncard = \"x\"", &[], "boards are"),
            ("[cards.x]\nframe_buffer=3\nunits=1\ntexture=2\n[board]\ncard=\"x\"", &[], "board x"),
            ("", &[("FILLRATE_TILE", "48")], "tile = 48"),
            ("", &[("FILLRATE_VERITE_CHIP", "v9000")], "chip = v9000"),
            ("", &[("FILLRATE_VERITE_MEMORY", "5")], "memory = 5"),
            ("", &[("FILLRATE_VERITE_DESKTOP", "800")], "desktop = 800"),
            ("", &[("FILLRATE_SCALE", "5")], "scale = 5"),
            ("", &[("FILLRATE_SIMD", "mmx")], "simd = mmx"),
            ("", &[("FILLRATE_EVERY", "-1")], "FILLRATE_EVERY=-1"),
            ("", &[("FILLRATE_CHECK", "maybe")], "neither"),
        ] {
            let s = settings(text, variables);
            assert_eq!(s.problems.len(), 1, "{text} {:?}", s.problems);
            assert!(s.problems[0].contains(told), "{:?}", s.problems);
            assert_eq!(s.glide.card, Card::default());
        }
    }

    #[test]
    fn without_a_file_everything_has_its_built_in_value() {
        let s = Settings::from_parts(None, std::iter::empty(), false);
        assert_eq!((s.every, s.exit_after, s.file), (1, None, None));
        assert_eq!(s.scan_out, ScanOut::default());
        assert!(!s.glide.check && !s.glide.splash && s.problems.is_empty());
    }
}
