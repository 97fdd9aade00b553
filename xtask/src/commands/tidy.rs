//! `tidy`: checks the house rules of the repository (see [`crate::tidy`]).

use clap::Args;
use serde_json::json;

use crate::{repository, tidy};
use wingroot::args::Common;
use wingroot::failure::Failure;
use wingroot::show;

/// Options of `tidy`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  cargo xtask tidy
  cargo xtask tidy --lines")]
pub(crate) struct TidyArgs {
    /// Count lines of code by crate (no blank lines, no comments) instead
    #[arg(long)]
    pub(crate) lines: bool,
}

/// Prints every complaint; fails if there is one.
pub(crate) fn run(args: &TidyArgs, common: &Common) -> Result<(), Failure> {
    if args.lines {
        return lines(common);
    }
    let complaints: Vec<String> = tidy::check(&repository::root())?.iter().map(ToString::to_string).collect();
    show::json(common, &json!({ "command": "tidy", "complaints": complaints }))?;
    if complaints.is_empty() {
        show::summary(common, "tidy: nothing to complain about");
        return Ok(());
    }
    Err(Failure::Computation(format!("{} complaints\n{}", complaints.len(), complaints.join("\n"))))
}

/// Lines of code by crate, and their sum.
fn lines(common: &Common) -> Result<(), Failure> {
    let counts = tidy::lines::count(&repository::root())?;
    let sum: usize = counts.values().sum();
    show::json(common, &json!({ "command": "tidy", "lines": counts, "sum": sum }))?;
    for (package, count) in
        counts.iter().map(|(package, count)| (package.as_str(), count)).chain([("sum", &sum)])
    {
        show::summary(common, &format!("{package:<14}{count:>7}"));
    }
    Ok(())
}
