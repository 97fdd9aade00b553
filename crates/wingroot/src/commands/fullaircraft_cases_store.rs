//! Finished cases, kept beside the result folder until all are done: what a stopped run has flown is not flown again.
//!
//! A file a case, named by the hash of everything its result depends on, written under another name and renamed, so it is whole
//! or not there.

use std::path::{Path, PathBuf};

use coupling::wing_file::fingerprint;
use fullaircraft::{Case, CaseResult};
use nastran::InputError;

use crate::failure::Failure;

/// The finished cases of one result folder.
#[derive(Debug)]
pub(crate) struct Store {
    folder: PathBuf,
    inputs: String,
}

impl Store {
    /// The store of the results that will stand at `target`: `.NAME.finished` beside it. `inputs` is all that results depend on
    /// beside the case.
    pub(crate) fn open(target: &Path, inputs: &str) -> Result<Self, Failure> {
        let target = std::path::absolute(target).map_err(|error| refused(target, &error))?;
        let name = target.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let folder = target.with_file_name(format!(".{name}.finished"));
        std::fs::create_dir_all(&folder).map_err(|error| refused(&folder, &error))?;
        Ok(Self { folder, inputs: fingerprint(inputs) })
    }

    /// The result of a case, if it was finished before with the same inputs.
    pub(crate) fn get(&self, case: &Case) -> Option<CaseResult> {
        let text = std::fs::read_to_string(self.path(case)).ok()?;
        let result: CaseResult = serde_json::from_str(&text).ok()?;
        Some(CaseResult { number: case.number, ..result })
    }

    /// Keeps a result, and gives it back as it will be read.
    pub(crate) fn put(&self, case: &Case, result: &CaseResult) -> Result<CaseResult, Failure> {
        let text = serde_json::to_string(result).map_err(Failure::computation)?;
        let path = self.path(case);
        let partial = path.with_extension(format!("partial-{}", std::process::id()));
        std::fs::write(&partial, &text).map_err(|error| refused(&partial, &error))?;
        std::fs::rename(&partial, &path).map_err(|error| refused(&path, &error))?;
        serde_json::from_str(&text).map_err(Failure::computation)
    }

    /// Removes the store: its results are in the result folder.
    pub(crate) fn close(self) -> Result<(), Failure> {
        std::fs::remove_dir_all(&self.folder).map_err(|error| refused(&self.folder, &error))
    }

    fn path(&self, case: &Case) -> PathBuf {
        // its number is its place in a list, which may be another next time
        let what = format!("{} {} {:?} {:?}", self.inputs, case.model, case.v_m_s, case.action);
        self.folder.join(format!("{}.json", fingerprint(&what)))
    }
}

fn refused(path: &Path, error: &std::io::Error) -> Failure {
    let error = InputError::in_file(path, format!("a finished case cannot be kept: {error}"));
    error.with_help("choose another folder with --out DIR").into()
}
