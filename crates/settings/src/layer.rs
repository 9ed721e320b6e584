//! One place where settings come from: a file, or the environment.

use std::collections::BTreeMap;
use std::path::PathBuf;

use serde::Deserialize;

/// Settings of one place; what it does not say is `None`.
#[derive(Clone, Debug, Default, Deserialize, PartialEq)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct Layer {
    pub draw: Draw,
    pub board: Board,
    pub output: Output,
    pub improve: Improve,
    pub verite: Verite,
    /// Boards by name.
    pub cards: BTreeMap<String, CardTable>,
    /// The original library's variables.
    pub variables: BTreeMap<String, String>,
}

#[derive(Clone, Debug, Default, Deserialize, PartialEq)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct Draw {
    pub threads: Option<u64>,
    pub simd: Option<String>,
    pub tile: Option<u64>,
}

#[derive(Clone, Debug, Default, Deserialize, PartialEq)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct Board {
    pub card: Option<String>,
    pub boards: Option<u64>,
    pub check: Option<bool>,
    pub splash: Option<bool>,
}

#[derive(Clone, Debug, Default, Deserialize, PartialEq)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct Output {
    pub trace: Option<PathBuf>,
    pub capture: Option<PathBuf>,
    pub every: Option<u64>,
    pub exit_after: Option<u64>,
    pub gamma: Option<bool>,
    pub filter: Option<bool>,
}

#[derive(Clone, Debug, Default, Deserialize, PartialEq)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct Improve {
    pub scale: Option<u64>,
    pub color32: Option<bool>,
    pub supersample: Option<bool>,
}

/// RRedline's board.
#[derive(Clone, Debug, Default, Deserialize, PartialEq)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct Verite {
    pub chip: Option<String>,
    pub memory: Option<u64>,
    pub desktop: Option<String>,
    pub blit_source_first: Option<bool>,
    pub speed_of_light: Option<bool>,
}

/// A board.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub(crate) struct CardTable {
    pub frame_buffer: u32,
    pub units: usize,
    pub texture: u32,
    #[serde(default)]
    pub interleaved: bool,
}

/// `later` where it says something, else `self`.
macro_rules! override_fields {
    ($to:expr, $later:expr; $($field:ident),*) => {
        $($to.$field = $later.$field.or($to.$field.take());)*
    };
}

impl Layer {
    /// A file's text.
    pub fn from_toml(text: &str) -> Result<Layer, String> {
        toml::from_str(text).map_err(|error| error.to_string())
    }

    /// The environment, and what of it cannot be used.
    pub fn from_variables(
        variables: impl Iterator<Item = (String, String)>,
        problems: &mut Vec<String>,
    ) -> Layer {
        let mut layer = Layer::default();
        for (name, text) in variables {
            let original = name.starts_with("FX_GLIDE_") || name.starts_with("SST_");
            if original {
                layer.variables.insert(name, text);
            } else if let Some(ours) = name.strip_prefix("FILLRATE_")
                && let Err(problem) = layer.set(ours, &text)
            {
                problems.push(format!("{name}={text} is not used: {problem}"));
            }
        }
        layer
    }

    /// Sets one of our variables, without its prefix. Names of other programs'
    /// variables are passed over.
    fn set(&mut self, name: &str, text: &str) -> Result<(), String> {
        let number = || text.parse::<u64>().map_err(|_| "it is not a number".to_string());
        let switch = || match text {
            "0" | "" | "false" | "off" => Ok(false),
            "1" | "true" | "on" => Ok(true),
            _ => Err("it is neither 0 nor 1".to_string()),
        };
        let path = || (!text.is_empty()).then(|| PathBuf::from(text));
        match name {
            "THREADS" => self.draw.threads = Some(number()?),
            "SIMD" => self.draw.simd = Some(text.to_string()),
            "TILE" => self.draw.tile = Some(number()?),
            "CARD" => self.board.card = Some(text.to_string()),
            "BOARDS" => self.board.boards = Some(number()?),
            "CHECK" => self.board.check = Some(switch()?),
            "SPLASH" => self.board.splash = Some(switch()?),
            "TRACE" => self.output.trace = path(),
            "CAPTURE" => self.output.capture = path(),
            "EVERY" => self.output.every = Some(number()?),
            "EXIT_AFTER" => self.output.exit_after = Some(number()?),
            "SCALE" => self.improve.scale = Some(number()?),
            "COLOR32" => self.improve.color32 = Some(switch()?),
            "SUPERSAMPLE" => self.improve.supersample = Some(switch()?),
            "GAMMA" => self.output.gamma = Some(switch()?),
            "VERITE_CHIP" => self.verite.chip = Some(text.to_string()),
            "VERITE_MEMORY" => self.verite.memory = Some(number()?),
            "VERITE_DESKTOP" => self.verite.desktop = Some(text.to_string()),
            "VERITE_BLIT_SOURCE_FIRST" => self.verite.blit_source_first = Some(switch()?),
            "SPEED_OF_LIGHT" => self.verite.speed_of_light = Some(switch()?),
            "FILTER" => self.output.filter = Some(switch()?),
            _ => {}
        }
        Ok(())
    }

    /// This layer with a later one over it.
    pub fn overridden_by(mut self, mut later: Layer) -> Layer {
        override_fields!(self.draw, later.draw; threads, simd, tile);
        override_fields!(self.board, later.board; card, boards, check, splash);
        override_fields!(
            self.output, later.output; trace, capture, every, exit_after, gamma, filter
        );
        override_fields!(self.improve, later.improve; scale, color32, supersample);
        override_fields!(
            self.verite, later.verite;
            chip, memory, desktop, blit_source_first, speed_of_light
        );
        self.cards.append(&mut later.cards);
        self.variables.append(&mut later.variables);
        self
    }
}
