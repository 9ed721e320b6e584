//! A configuration as words, for traces: what a replay has to know.

use crate::context::RaveConfig;
use crate::memory::EngineKind;

/// The kinds of engines and their names.
const KINDS: [(EngineKind, &str); 3] = [
    (EngineKind::Separate, "separate"),
    (EngineKind::VideoOnly, "video"),
    (EngineKind::VideoOnlyUntilFrameEnd, "frame"),
];

impl EngineKind {
    /// The name in settings and traces.
    pub fn name(self) -> &'static str {
        KINDS.iter().find(|(kind, _)| *kind == self).map_or("", |(_, name)| name)
    }

    /// The kind of a name.
    pub fn by_name(name: &str) -> Option<EngineKind> {
        KINDS.iter().find(|(_, known)| *known == name).map(|(kind, _)| *kind)
    }
}

impl RaveConfig {
    /// Everything that changes what a program sees, as keys and values.
    pub fn description(&self) -> [(&'static str, String); 4] {
        [
            ("textures", self.memory.kind.name().to_string()),
            ("texture_memory", self.memory.video_bytes.to_string()),
            ("texture_copies", self.memory.host_bytes.to_string()),
            ("apple", u32::from(self.as_apple_software).to_string()),
        ]
    }

    /// Takes a description over. Keys that are missing keep their values.
    ///
    /// # Errors
    /// What is wrong with a value, in words.
    pub fn describe<'a>(&mut self, find: impl Fn(&str) -> Option<&'a str>) -> Result<(), String> {
        let number = |key: &str| match find(key).map(|text| (text, text.parse::<u64>())) {
            Some((text, Err(_))) => Err(format!("{key} = {text} is not a number")),
            Some((_, Ok(number))) => Ok(Some(number)),
            None => Ok(None),
        };
        if let Some(name) = find("textures") {
            let kind = EngineKind::by_name(name);
            self.memory.kind = kind.ok_or_else(|| format!("'{name}' is no kind of engine"))?;
        }
        self.memory.video_bytes = number("texture_memory")?.unwrap_or(self.memory.video_bytes);
        self.memory.host_bytes = number("texture_copies")?.unwrap_or(self.memory.host_bytes);
        if let Some(apple) = number("apple")? {
            self.as_apple_software = apple != 0;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn descriptions_come_back() {
        let mut config = RaveConfig { as_apple_software: true, ..RaveConfig::default() };
        config.memory.kind = EngineKind::VideoOnlyUntilFrameEnd;
        config.memory.video_bytes = 12345;
        let pairs = config.description();
        let find = |key: &str| pairs.iter().find(|(k, _)| *k == key).map(|(_, v)| v.as_str());
        let mut other = RaveConfig::default();
        other.describe(find).expect("a description");
        assert_eq!(other.description(), pairs);
        assert!(other.describe(|_| Some("nonsense")).is_err());
    }
}
