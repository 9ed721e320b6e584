//! The files of a game: archives (`.pk3`, which are zip files), folders, and
//! files made in memory. Later ones replace earlier ones, as in the game.

use std::collections::HashMap;
use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

use anyhow::{Context, Result};
use zip::ZipArchive;

/// The most bytes a single file may unpack to.
const MAX_FILE: u64 = 256 << 20;

/// Where a file lies.
#[derive(Clone, Copy, Debug)]
enum Place {
    Archive { archive: usize, index: usize },
    Memory(usize),
}

/// All files by name. Names are compared without case.
#[derive(Debug, Default)]
pub struct Assets {
    archives: Vec<ZipArchive<BufReader<File>>>,
    memory: Vec<Vec<u8>>,
    places: HashMap<String, Place>,
}

impl Assets {
    /// Every archive of a folder, in the order of their names.
    ///
    /// # Errors
    /// Where the folder or an archive cannot be read.
    pub fn open(folder: &Path) -> Result<Assets> {
        let mut files = Vec::new();
        let entries = std::fs::read_dir(folder)
            .with_context(|| format!("cannot read the folder {}", folder.display()))?;
        for entry in entries {
            let path = entry?.path();
            if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("pk3")) {
                files.push(path);
            }
        }
        files.sort();
        let mut assets = Assets::default();
        for file in files {
            assets.add_archive(&file)?;
        }
        Ok(assets)
    }

    fn add_archive(&mut self, path: &Path) -> Result<()> {
        let open = || -> Result<_> { Ok(ZipArchive::new(BufReader::new(File::open(path)?))?) };
        let archive = open().with_context(|| format!("cannot open {}", path.display()))?;
        let number = self.archives.len();
        for index in 0..archive.len() {
            if let Some(Ok(name)) = archive.name_for_index(index) {
                let place = Place::Archive { archive: number, index };
                self.places.insert(name.to_ascii_lowercase(), place);
            }
        }
        self.archives.push(archive);
        Ok(())
    }

    /// Adds a file.
    pub fn insert(&mut self, name: &str, bytes: Vec<u8>) {
        self.places.insert(name.to_ascii_lowercase(), Place::Memory(self.memory.len()));
        self.memory.push(bytes);
    }

    /// A file's bytes; `None` where there is none, or it cannot be unpacked.
    pub fn read(&mut self, name: &str) -> Option<Vec<u8>> {
        match *self.places.get(&name.to_ascii_lowercase())? {
            Place::Memory(index) => Some(self.memory[index].clone()),
            Place::Archive { archive, index } => {
                let file = self.archives[archive].by_index(index).ok()?;
                let mut bytes = Vec::new();
                file.take(MAX_FILE).read_to_end(&mut bytes).ok()?;
                Some(bytes)
            }
        }
    }

    /// Names that start and end so, sorted.
    pub fn names(&self, prefix: &str, suffix: &str) -> Vec<String> {
        let fits = |name: &&String| name.starts_with(prefix) && name.ends_with(suffix);
        let mut names: Vec<String> = self.places.keys().filter(fits).cloned().collect();
        names.sort();
        names
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_ignore_case_and_later_files_replace_earlier_ones() {
        let mut assets = Assets::default();
        assets.insert("Scripts/A.shader", vec![1]);
        assets.insert("scripts/a.shader", vec![2]);
        assert_eq!(assets.read("SCRIPTS/a.Shader"), Some(vec![2]));
        assert_eq!(assets.read("scripts/b.shader"), None);
        assert_eq!(assets.names("scripts/", ".shader"), ["scripts/a.shader"]);
    }
}
