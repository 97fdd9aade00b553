//! The house rules that no compiler checks; `cargo xtask tidy` and a test in `xtask/tests` run them.
//!
//! - [`imports`]: a crate imports only what the table of the architecture allows.
//! - [`features`]: what is built alone is compiled as with all tests.
//! - [`sources`]: every source file says what it is, stays short, prints nothing and skips no test.
//! - [`parameters`]: no parameter is a tuple of references.
//! - [`effect_names`]: an effect is asked for by name in its own file only.
//! - [`decisions`]: what decides in `discover` is in its rules.
//! - [`circles`]: files of a crate do not take names from each other in circles.
//! - [`suites`]: every file of tests is run.
//! - [`documents`]: ARCHITECTURE.md speaks of what exists; every folder of data says where it comes from.

use std::path::Path;

use wingroot::failure::Failure;

mod cargo;
pub mod circles;
mod complaint;
pub mod decisions;
pub mod documents;
pub mod effect_names;
pub mod features;
pub mod imports;
pub mod lines;
pub mod modules;
pub mod parameters;
pub mod parsed;
pub mod sources;
pub mod suites;

pub use complaint::Complaint;

/// All complaints about the repository at `root`, sorted by place.
///
/// # Errors
/// If cargo does not run or a file cannot be read.
pub fn check(root: &Path) -> Result<Vec<Complaint>, Failure> {
    let packages = imports::packages(root)?;
    let mut complaints = imports::check(&packages);
    complaints.extend(features::check(root)?);
    complaints.extend(sources::check(root)?);
    complaints.extend(suites::check(root)?);
    let sources = parsed::sources(root)?;
    complaints.extend(parameters::check(&sources));
    complaints.extend(effect_names::check(&sources, &effect_names::names()));
    complaints.extend(decisions::check(&sources));
    complaints.extend(circles::check(&sources));
    complaints.extend(documents::check(root, &packages)?);
    complaints.sort();
    Ok(complaints)
}
