//! What a plan of design loads says before anything is flown: its design, its selection, its matrix.

use std::path::Path;

use fullaircraft::CasesFile;
use loads::{Design, Matrix, SelectFile};
use nastran::InputError;

use crate::commands::loads_figures as figures;
use crate::failure::Failure;
use crate::output::ResultFolder;

/// The design of a file that is a plan.
pub(super) fn design(plan: &CasesFile) -> Result<Design, InputError> {
    plan.design()?.ok_or_else(|| {
        InputError::in_file(&plan.path, "this is a grid of cases and no plan of design loads")
            .with_help("a plan has `rules`; a grid is flown by `fullaircraft --cases`")
    })
}

/// The selection: the file named, else the plan's, else ends and hulls of everything.
pub(super) fn selection_file(named: Option<&Path>, plan: &CasesFile) -> Result<SelectFile, InputError> {
    let beside = |name: &String| plan.path.parent().unwrap_or(Path::new("")).join(name);
    match named.map(Path::to_path_buf).or_else(|| plan.select.as_ref().map(beside)) {
        Some(path) => SelectFile::read(&path),
        None => Ok(SelectFile::default()),
    }
}

/// Cases and V-n diagrams.
pub(super) fn write_matrix(folder: &ResultFolder, design: &Design, matrix: &Matrix) -> Result<(), Failure> {
    folder.write_text("cases.csv", &matrix.csv(design))?;
    folder.write_text("vn.csv", &matrix.vn_csv(design))?;
    figures::vn(folder, design, matrix)
}
