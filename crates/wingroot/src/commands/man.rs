//! `man`: manual pages of the program and of each command.

use std::path::PathBuf;

use clap::{Args, CommandFactory};
use nastran::InputError;

use crate::args::Common;
use crate::cli::Cli;
use crate::failure::Failure;
use crate::show;

/// Options of `man`.
#[derive(Debug, Clone, Args)]
#[command(after_help = "Examples:
  wingroot man ~/.local/share/man/man1")]
pub struct ManArgs {
    /// The folder for the pages: wingroot.1, wingroot-calibrate.1, ...
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

/// Writes the pages.
pub(crate) fn run(args: &ManArgs, common: &Common) -> Result<(), Failure> {
    let written = std::fs::create_dir_all(&args.folder)
        .and_then(|()| clap_mangen::generate_to(Cli::command(), &args.folder));
    written.map_err(|error| {
        InputError::in_file(&args.folder, format!("the pages cannot be written: {error}"))
            .with_help("name a folder in which you may write")
    })?;
    show::summary(common, &format!("manual pages in {}", args.folder.display()));
    Ok(())
}
