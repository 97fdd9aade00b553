//! `tidy`: checks the house rules of the repository (see [`crate::tidy`]).

use serde_json::json;

use crate::args::{Common, TidyArgs};
use crate::failure::Failure;
use crate::{paths, show, tidy};

/// Prints every complaint; fails if there is one.
pub(crate) fn run(_args: &TidyArgs, common: &Common) -> Result<(), Failure> {
    let complaints: Vec<String> =
        tidy::check(&paths::repository())?.iter().map(ToString::to_string).collect();
    show::json(common, &json!({ "command": "tidy", "complaints": complaints }))?;
    if complaints.is_empty() {
        show::summary(common, "tidy: nothing to complain about");
        return Ok(());
    }
    Err(Failure::Computation(format!("{} complaints\n{}", complaints.len(), complaints.join("\n"))))
}
