//! The one store of finished cases: what a stopped run, or another part of a sweep, has finished is not computed again.
//!
//! A folder of segments (`segment`), one for each process that writes: no locks, no renames, nothing that a network's file system
//! does badly. A process appends each case as it is finished and reads the segments of all others when it begins. A case
//! that is there twice counts once. Segments say what their results depend on ([`Inputs`]); only those of the same inputs are read.

use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use nastran::InputError;
use serde::Serialize;
use serde::de::DeserializeOwned;

mod index;
mod inputs;
mod segment;
mod shared;

pub use index::{Foreign, Standing};
pub use inputs::Inputs;
pub use segment::{Told, unique};
pub use shared::Shared;

use crate::failure::Failure;
use crate::fingerprint::Fingerprint;
use index::Index;
use segment::Writer;

/// The finished cases of one computation.
#[derive(Debug)]
pub struct Store {
    folder: PathBuf,
    inputs: Inputs,
    label: String,
    state: Mutex<State>,
}

/// What a process knows of its store.
#[derive(Debug, Default)]
struct State {
    /// What was there when the store was first asked, and what was put since.
    index: Option<Index>,
    /// This process' own segment.
    writer: Option<Writer>,
}

impl Store {
    /// The store in a folder, which is made with the first case. `inputs` is all that results depend on beside the case.
    pub fn new(folder: PathBuf, inputs: impl Into<Inputs>) -> Self {
        Self { folder, inputs: inputs.into(), label: "whole".to_owned(), state: Mutex::default() }
    }

    /// The store of the results that will stand at `target`.
    ///
    /// # Errors
    /// If the target has no place.
    pub fn beside(target: &Path, inputs: impl Into<Inputs>) -> Result<Self, Failure> {
        Ok(Self::new(Self::folder_beside(target)?, inputs))
    }

    /// The folder of that store: `.NAME.finished` beside the target.
    ///
    /// # Errors
    /// If the target has no place.
    pub fn folder_beside(target: &Path) -> Result<PathBuf, Failure> {
        let target = std::path::absolute(target).map_err(|error| refused(target, &error))?;
        let name = target.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        Ok(target.with_file_name(format!(".{name}.finished")))
    }

    /// With the name that this process' segment begins with, such as that of its part.
    #[must_use]
    pub fn labelled(self, label: impl Into<String>) -> Self {
        Self { label: label.into(), ..self }
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// What the names of all segments begin with.
    pub fn labels(&self) -> Vec<String> {
        let names = segment::paths(&self.folder)
            .into_iter()
            .filter_map(|path| path.file_stem().map(ToOwned::to_owned));
        names.map(|name| name.to_string_lossy().split('-').next().unwrap_or_default().to_owned()).collect()
    }

    /// The hash of a case in this and every other store.
    pub fn hash(part: &str) -> Fingerprint {
        Fingerprint::default().with(part.as_bytes())
    }

    /// Whether a case was finished with the same inputs.
    pub fn has(&self, part: &str) -> bool {
        self.with_index(|index| index.has(Self::hash(part)))
    }

    /// The result of a case, if it was finished with the same inputs.
    pub fn get<T: DeserializeOwned>(&self, part: &str) -> Option<T> {
        let (told, text) = self.with_index(|index| index.read(Self::hash(part)))?;
        // two cases with one hash: neither is believed for the other
        (told.part == part).then(|| serde_json::from_str(&text).ok())?
    }

    /// What was said of a finished case.
    pub fn told_of(&self, hash: Fingerprint) -> Option<Told> {
        self.with_index(|index| index.read(hash)).map(|(told, _)| told)
    }

    /// What was said of each finished case beside its result; `each` gets them in the order of their hashes.
    pub fn told(&self, mut each: impl FnMut(Told)) {
        for hash in self.with_index(|index| index.hashes()) {
            if let Some((told, _)) = self.with_index(|index| index.read(hash)) {
                each(told);
            }
        }
    }

    /// What the store holds beside results.
    pub fn standing(&self) -> Standing {
        self.with_index(|index| index.standing())
    }

    /// Keeps a result, and gives it back as it will be read.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn put<T: Serialize + DeserializeOwned>(&self, part: &str, result: &T) -> Result<T, Failure> {
        let text = serde_json::to_string(result).map_err(Failure::computation)?;
        self.put_text(&Told { part: part.to_owned(), ..Told::default() }, &text)?;
        serde_json::from_str(&text).map_err(Failure::computation)
    }

    /// Keeps a result with what is told of it.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn put_told<T: Serialize>(&self, told: &Told, result: &T) -> Result<(), Failure> {
        self.put_text(told, &serde_json::to_string(result).map_err(Failure::computation)?)
    }

    fn put_text(&self, told: &Told, text: &str) -> Result<(), Failure> {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let state = &mut *state;
        let index = state.index.get_or_insert_with(|| Index::read_all(&self.folder, &self.inputs));
        // A store that another process removed with its results in place is begun anew.
        if state.writer.as_mut().is_none_or(Writer::is_gone) {
            let writer = Writer::begin(&self.folder, &self.label, &self.inputs);
            let writer = writer.map_err(|error| refused(&self.folder, &error))?;
            index.add_segment(writer.path());
            state.writer = Some(writer);
        }
        let Some(writer) = &mut state.writer else { return Ok(()) };
        match writer.append(Self::hash(&told.part), told, text) {
            Ok(place) => {
                index.add(Self::hash(&told.part), place);
                Ok(())
            }
            Err(error) => {
                let path = writer.path().to_path_buf();
                state.writer = None;
                Err(refused(&path, &error))
            }
        }
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

    fn with_index<T>(&self, what: impl FnOnce(&mut Index) -> T) -> T {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        what(state.index.get_or_insert_with(|| Index::read_all(&self.folder, &self.inputs)))
    }
}

fn refused(path: &Path, error: &std::io::Error) -> Failure {
    let error = InputError::in_file(path, format!("what is finished cannot be kept: {error}"));
    error.with_help("choose another folder with --out DIR").into()
}

#[cfg(test)]
mod tests;
