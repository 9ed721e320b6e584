//! Digests of the workloads' pictures, kept in `tests/golden/bench.json`.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context as _, Result};

/// What is built in.
const KEPT: &str = include_str!("../../../../tests/golden/bench.json");

/// Digests by size and workload.
pub struct Digests(BTreeMap<String, BTreeMap<String, String>>);

impl Digests {
    /// Those of a file, or those built in.
    pub fn load(file: Option<&Path>) -> Result<Digests> {
        let (text, name) = match file {
            Some(file) => {
                let name = file.display().to_string();
                let text = std::fs::read_to_string(file);
                (text.with_context(|| format!("cannot read {name}"))?, name)
            }
            None => (KEPT.to_string(), "the built-in digests".to_string()),
        };
        let digests = serde_json::from_str(&text);
        Ok(Digests(digests.with_context(|| format!("{name}: not a file of digests"))?))
    }

    /// The digest of a workload's picture; `None` where none is kept.
    pub fn get(&self, size: &str, workload: &str) -> Option<&str> {
        self.0.get(size)?.get(workload).map(String::as_str)
    }
}

/// A digest as text.
pub fn text(digest: u64) -> String {
    format!("{digest:016x}")
}
