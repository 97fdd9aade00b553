//! `new`: a commented folder for an own wing, with generated measurements, that runs at once.

use clap::Args;
use std::path::{Path, PathBuf};

use nastran::InputError;
use serde_json::json;

use crate::args::Common;
use crate::failure::Failure;
use crate::show;

/// Options of `new`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  cargo xtask new my_wing
  cargo xtask calibrate --wing my_wing/wing.ron --campaign my_wing/campaign --out out/my_wing

The folder holds wing.ron with every field explained, its section and beam, a campaign of static points and runs, and a
README.md. The example measurements are generated, so that everything runs before yours are in place; docs/guide.md goes on
from there.")]
pub(crate) struct NewArgs {
    /// The folder to make; it must not exist, or be empty
    #[arg(value_name = "DIR")]
    pub(crate) folder: PathBuf,
}

/// Where the example stands in the repository, as its README names it.
const SHIPPED: &str = "data/own_wing";

/// A file of the example: its name and its text.
macro_rules! file {
    ($name:literal) => {
        ($name, include_str!(concat!("../../../data/own_wing/", $name)))
    };
}

/// The example, part of the program, so that it cannot be changed by mistake.
const FILES: [(&str, &str); 12] = [
    file!("README.md"),
    file!("wing.ron"),
    file!("beam.csv"),
    file!("section.dat"),
    file!("campaign/README.md"),
    file!("campaign/campaign.ron"),
    file!("campaign/static.csv"),
    file!("campaign/pitch_1hz_20.csv"),
    file!("campaign/pitch_2hz_20.csv"),
    file!("campaign/aileron_5_20.csv"),
    file!("campaign/aileron_10_20.csv"),
    file!("campaign/aileron_8_20.csv"),
];

/// Runs the command.
pub(crate) fn run(args: &NewArgs, common: &Common) -> Result<(), Failure> {
    let folder = &args.folder;
    check_empty(folder)?;
    let partial = partial(folder)?;
    let written = write(&partial, folder).and_then(|()| put_in_place(&partial, folder));
    if written.is_err() {
        // What could not be written whole is not left in part; if that fails, too, the first error says enough.
        let _ = std::fs::remove_dir_all(&partial);
    }
    written?;
    let shown = folder.display();
    show::summary(
        common,
        &format!(
            "A wing of your own in {shown}; its measurements are generated: put in yours file by file. {shown}/README.md says \
             how. Now:\n  cargo xtask calibrate --wing {shown}/wing.ron --campaign {shown}/campaign"
        ),
    );
    let names: Vec<&str> = FILES.iter().map(|(name, _)| *name).collect();
    show::json(
        common,
        &json!({ "command": "new", "folder": shown.to_string(), "files": names, "measurements": false }),
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

fn write(partial: &Path, folder: &Path) -> Result<(), InputError> {
    for (name, text) in FILES {
        let path = partial.join(name);
        if let Some(parent) = path.parent() {
            std::fs::create_dir_all(parent).map_err(|error| refused(parent, &error))?;
        }
        // Its commands name the folder they are for; what is said of the repository's own files stays.
        let text = if name == "README.md" {
            let shown = folder.display().to_string();
            let commands = |line: &str| {
                if line.starts_with("cargo xtask") { line.replace(SHIPPED, &shown) } else { line.to_owned() }
            };
            text.lines().map(|line| commands(line) + "\n").collect()
        } else {
            text.to_owned()
        };
        std::fs::write(&path, text).map_err(|error| refused(&path, &error))?;
    }
    Ok(())
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
