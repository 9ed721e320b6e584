//! What a trace says about itself.

use fillrate_call::{DecodeError, Decoder, Encoder};

/// Key: the front end that understands the calls, such as `glide2x`.
pub const API: &str = "api";
/// Key: the program that was recorded.
pub const PROGRAM: &str = "program";
/// Key: name and version of what wrote the trace.
pub const CREATOR: &str = "creator";
/// Start of the keys that hold settings which the pictures depend on, such as `config.memory`.
pub const CONFIG_PREFIX: &str = "config.";

/// Keys and values in the order in which they were given.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Meta {
    pairs: Vec<(String, String)>,
}

impl Meta {
    /// No pairs.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a pair.
    #[must_use]
    pub fn with(mut self, key: impl Into<String>, value: impl Into<String>) -> Self {
        self.pairs.push((key.into(), value.into()));
        self
    }

    /// The value last given for this key.
    pub fn get(&self, key: &str) -> Option<&str> {
        self.iter().filter(|pair| pair.0 == key).map(|pair| pair.1).last()
    }

    /// All pairs in order.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &str)> {
        self.pairs.iter().map(|(key, value)| (key.as_str(), value.as_str()))
    }

    /// The payload of a chunk with these pairs.
    pub(crate) fn encode(&self) -> Vec<u8> {
        let mut encoder = Encoder::new();
        for (key, value) in self.iter() {
            encoder.str(key);
            encoder.str(value);
        }
        encoder.into_bytes()
    }

    /// The pairs in the payload of a chunk.
    pub(crate) fn decode(payload: &[u8]) -> Result<Self, DecodeError> {
        let mut decoder = Decoder::new(payload);
        let mut meta = Self::new();
        while !decoder.remaining().is_empty() {
            let key = decoder.str()?.to_owned();
            meta.pairs.push((key, decoder.str()?.to_owned()));
        }
        Ok(meta)
    }
}
