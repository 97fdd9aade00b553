//! `new`: a folder to start from: a commented wing of one's own that runs at once, or one of the shipped examples.

use clap::Args;
use clap::builder::PossibleValuesParser;
use shipped::{EXAMPLES, Example};
use std::path::{Path, PathBuf};

use nastran::InputError;
use serde_json::json;

use crate::args::Common;
use crate::failure::Failure;
use crate::show;

/// Options of `new`.
#[derive(Debug, Clone, Args)]
#[command(after_help = "Examples:
  wingroot new my_wing
  wingroot new paper_wing --example tuflex

Then, in the new folder: wingroot calibrate, wingroot discover, wingroot fullaircraft; results go to its folder out. Without
--example it is a small wing with every field explained, its section and beam, a campaign of static points and runs, an aircraft
around it and a README.md; its measurements are generated, so that everything runs before yours are in place.")]
pub struct NewArgs {
    /// The folder to make; it must not exist, or be empty
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// Which example
    #[arg(long, value_name = "NAME", default_value = "own_wing", value_parser = names())]
    example: String,
}

fn names() -> PossibleValuesParser {
    PossibleValuesParser::new(
        EXAMPLES.iter().map(|example| clap::builder::PossibleValue::new(example.name).help(example.about)),
    )
}

/// Runs the command.
pub(crate) fn run(args: &NewArgs, common: &Common) -> Result<(), Failure> {
    let folder = &args.folder;
    let example = shipped::example(&args.example)
        .ok_or_else(|| InputError::general(format!("there is no example {}", args.example)))?;
    check_empty(folder)?;
    let partial = partial(folder)?;
    let written = write(example, &partial).and_then(|()| put_in_place(&partial, folder));
    if written.is_err() {
        // What could not be written whole is not left in part; if that fails, too, the first error says enough.
        let _ = std::fs::remove_dir_all(&partial);
    }
    written?;
    let shown = folder.display();
    let first = match example.name {
        "mav" => "response",
        "bristol" => "free",
        _ => "calibrate",
    };
    show::summary(
        common,
        &format!(
            "In {shown}: {}. README.md there says more. Now:\n  cd {shown} && wingroot {first}",
            example.about
        ),
    );
    let files = example.files().map_err(Failure::computation)?;
    let names: Vec<String> = files.keys().map(|name| name.display().to_string()).collect();
    show::json(
        common,
        &json!({ "command": "new", "folder": shown.to_string(), "example": example.name, "files": names }),
    )
}

/// Refuses a folder with something in it, and a file.
fn check_empty(folder: &Path) -> Result<(), InputError> {
    let empty = match std::fs::read_dir(folder) {
        Ok(mut entries) => entries.next().is_none(),
        Err(error) => error.kind() == std::io::ErrorKind::NotFound,
    };
    if empty {
        return Ok(());
    }
    Err(InputError::in_file(
        folder,
        "this exists already and is no empty folder, so nothing is written to it",
    )
    .with_help("name a folder that does not exist yet"))
}

/// A hidden folder beside the target, on the same disk.
fn partial(folder: &Path) -> Result<PathBuf, InputError> {
    let absolute = std::path::absolute(folder).map_err(|error| refused(folder, &error))?;
    let name = absolute.file_name().map(|name| name.to_string_lossy().into_owned());
    let name = name.ok_or_else(|| InputError::in_file(folder, "this is no name for a new folder"))?;
    Ok(absolute.with_file_name(format!(".{name}.partial-{}", std::process::id())))
}

fn write(example: &Example, partial: &Path) -> Result<(), InputError> {
    example.write(partial).map_err(|error| refused(partial, &error))
}

fn put_in_place(partial: &Path, folder: &Path) -> Result<(), InputError> {
    if folder.is_dir() {
        std::fs::remove_dir(folder).map_err(|error| refused(folder, &error))?;
    }
    std::fs::rename(partial, folder).map_err(|error| refused(folder, &error))
}

fn refused(path: &Path, error: &std::io::Error) -> InputError {
    InputError::in_file(path, format!("the folder cannot be written: {error}"))
        .with_help("choose another place, or make room there")
}
