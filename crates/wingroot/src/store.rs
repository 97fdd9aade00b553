//! Finished parts of a long computation, kept until all are done: what a stopped run has finished is not computed again.
//!
//! A file a part, named by the fingerprint of everything its result depends on, the program's commit included; written under
//! another name and renamed, so it is whole or not there.

use std::path::{Path, PathBuf};

use nastran::InputError;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::failure::Failure;
use crate::fingerprint::Fingerprint;

/// The finished parts of one computation.
#[derive(Debug)]
pub struct Store {
    folder: PathBuf,
    inputs: Fingerprint,
}

impl Store {
    /// The store in a folder, which is made with the first part. `inputs` is all that results depend on beside the part.
    pub fn new(folder: PathBuf, inputs: &str) -> Self {
        let inputs = Fingerprint::default().with(crate::version::VERSION.as_bytes()).with(inputs.as_bytes());
        Self { folder, inputs }
    }

    /// The store of the results that will stand at `target`: `.NAME.finished` beside it.
    ///
    /// # Errors
    /// If the target has no place.
    pub fn beside(target: &Path, inputs: &str) -> Result<Self, Failure> {
        let target = std::path::absolute(target).map_err(|error| refused(target, &error))?;
        let name = target.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        Ok(Self::new(target.with_file_name(format!(".{name}.finished")), inputs))
    }

    /// The result of a part, if it was finished before with the same inputs.
    pub fn get<T: DeserializeOwned>(&self, part: &str) -> Option<T> {
        serde_json::from_str(&std::fs::read_to_string(self.path(part)).ok()?).ok()
    }

    /// Keeps a result, and gives it back as it will be read.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn put<T: Serialize + DeserializeOwned>(&self, part: &str, result: &T) -> Result<T, Failure> {
        let text = serde_json::to_string(result).map_err(Failure::computation)?;
        std::fs::create_dir_all(&self.folder).map_err(|error| refused(&self.folder, &error))?;
        let path = self.path(part);
        let partial = path.with_extension(format!("partial-{}", std::process::id()));
        std::fs::write(&partial, &text).map_err(|error| refused(&partial, &error))?;
        std::fs::rename(&partial, &path).map_err(|error| refused(&path, &error))?;
        serde_json::from_str(&text).map_err(Failure::computation)
    }

    /// Removes the store: its results are in the result folder.
    ///
    /// # Errors
    /// If it resists.
    pub fn close(self) -> Result<(), Failure> {
        if !self.folder.exists() {
            return Ok(());
        }
        std::fs::remove_dir_all(&self.folder).map_err(|error| refused(&self.folder, &error))
    }

    fn path(&self, part: &str) -> PathBuf {
        self.folder.join(format!("{}.json", self.inputs.with(part.as_bytes())))
    }
}

fn refused(path: &Path, error: &std::io::Error) -> Failure {
    let error = InputError::in_file(path, format!("what is finished cannot be kept: {error}"));
    error.with_help("choose another folder with --out DIR").into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_is_found_again_with_the_same_inputs_only() {
        let folder = std::env::temp_dir().join(format!("wingroot-store-{}", std::process::id()));
        let store = |inputs: &str| Store::new(folder.clone(), inputs);
        assert_eq!(store("a").put("one", &1.5).unwrap(), 1.5);
        assert_eq!(store("a").get::<f64>("one"), Some(1.5));
        assert_eq!(store("a").get::<f64>("two"), None);
        assert_eq!(store("b").get::<f64>("one"), None);
        store("a").close().unwrap();
        assert!(!folder.exists());
    }
}
