#![doc = include_str!("../README.md")]

use std::collections::BTreeMap;
use std::io::Read;
use std::path::{Path, PathBuf};

use flate2::read::GzDecoder;

/// A folder that ships with the program.
#[derive(Debug, Clone, Copy)]
pub struct Example {
    /// Its name on the command line, and the name of its folder in the repository's `data`.
    pub name: &'static str,
    /// What it is, in a line.
    pub about: &'static str,
    archive: &'static [u8],
}

/// Declares the examples.
macro_rules! examples {
    ($($name:ident: $about:literal),* $(,)?) => {
        /// All of them.
        pub static EXAMPLES: &[Example] = &[$(Example {
            name: stringify!($name),
            about: $about,
            archive: include_bytes!(concat!(env!("OUT_DIR"), "/", stringify!($name), ".tar.gz")),
        }),*];
    };
}

// A line here and one in build.rs; a test compares the two.
examples! {
    own_wing: "a small wing with every field explained, to put your own in its place (measurements generated)",
    tuflex: "the flexible wing of paper 1, of shells and solids, and its aircraft (measurements generated)",
    weber_brebner: "a rigid swept wing of 1958 with measured lift along the span (measurements)",
    pazy: "a very flexible wing of which the tip's deflection was measured (measurements)",
    bristol: "a wing on a heave and a pitch spring that flutters: 178 runs that nobody drives (measurements)",
    mav: "wind-tunnel runs of a micro air vehicle for response surfaces (measurements generated)",
}

/// The documents of the repository's folder `docs`, by file name.
///
/// # Errors
/// If the archive in the program is damaged.
pub fn documents() -> std::io::Result<BTreeMap<PathBuf, Vec<u8>>> {
    unpacked(include_bytes!(concat!(env!("OUT_DIR"), "/docs.tar.gz")))
}

fn unpacked(archive: &[u8]) -> std::io::Result<BTreeMap<PathBuf, Vec<u8>>> {
    let mut archive = tar::Archive::new(GzDecoder::new(archive));
    let mut files = BTreeMap::new();
    for entry in archive.entries()? {
        let mut entry = entry?;
        let path = entry.path()?.into_owned();
        let mut bytes = Vec::new();
        entry.read_to_end(&mut bytes)?;
        files.insert(path, bytes);
    }
    Ok(files)
}

/// The example of this name.
pub fn example(name: &str) -> Option<&'static Example> {
    EXAMPLES.iter().find(|example| example.name == name)
}

impl Example {
    /// Its files by their paths inside its folder.
    ///
    /// # Errors
    /// If the archive in the program is damaged.
    pub fn files(&self) -> std::io::Result<BTreeMap<PathBuf, Vec<u8>>> {
        unpacked(self.archive)
    }

    /// Writes its files below a folder, which is made if it is not there.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn write(&self, folder: &Path) -> std::io::Result<()> {
        for (name, bytes) in self.files()? {
            let path = folder.join(name);
            if let Some(parent) = path.parent() {
                std::fs::create_dir_all(parent)?;
            }
            std::fs::write(path, bytes)?;
        }
        Ok(())
    }
}
