//! A wing's file with its own text, beside the files that it names.

use coupling::WingFile;
use std::path::{Path, PathBuf};

/// A file of the shipped wing.
pub fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex").join(name)
}

/// A wing's file in a folder of its own.
pub struct Copy(PathBuf);

impl Copy {
    /// With `text` as its wing.
    pub fn new(test: &str, text: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("wingroot-effects-{}-{test}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        for file in ["e214.dat", "beam_distribution.csv"] {
            std::fs::copy(data(file), folder.join(file)).unwrap();
        }
        std::fs::write(folder.join("wing.ron"), text).unwrap();
        Self(folder)
    }

    /// Reads it.
    pub fn read(&self) -> Result<WingFile, nastran::InputError> {
        WingFile::read(&self.0.join("wing.ron"))
    }
}

impl Drop for Copy {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}
