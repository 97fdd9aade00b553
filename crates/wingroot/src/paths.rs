//! Where a command finds what was not named: in the folder where it is started, and beside the wing that it works on.
//!
//! Nothing else is taken by itself, and what is taken is said first and stands in the report ([`taken`]). Only
//! `wingroot NAME` goes on to the repository's own example ([`start_from`]).

use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock, PoisonError};

use nastran::InputError;
use nastran::ron_or_json::in_folder;

use crate::show;

/// The files by which a folder is known, `NAME.ron` or `NAME.json`.
const WING: &str = "wing";
const AIRCRAFT: &str = "aircraft";
const CAMPAIGN: &str = "campaign";
const TUNNEL: &str = "tunnel";
const RIG: &str = "rig";
/// The study of a folder of response surfaces.
pub(crate) const STUDY: &str = "response";
/// Folders of measurements that are looked for beside a wing.
const CAMPAIGNS: [&str; 2] = ["campaign", "measured"];

/// The folder with the shipped examples, where one is started from a checkout.
static SHIPPED: OnceLock<PathBuf> = OnceLock::new();
/// What was taken without being named, in words.
static TAKEN: Mutex<Vec<String>> = Mutex::new(Vec::new());

/// Lets commands fall back on the examples in a folder (`data` of the repository) where the current folder has nothing.
pub fn start_from(examples: PathBuf) {
    // Set once, at the start of the process.
    let _ = SHIPPED.set(examples);
}

/// What was taken without being named, a phrase each.
pub fn taken() -> Vec<String> {
    TAKEN.lock().unwrap_or_else(PoisonError::into_inner).clone()
}

/// Starts anew, for the next command of one process.
pub(crate) fn forget() {
    TAKEN.lock().unwrap_or_else(PoisonError::into_inner).clear();
}

/// Says that something was taken that nobody named.
pub fn take(what: &str, path: &Path, why: &str) {
    let sentence = format!("{what}: {} ({why})", path.display());
    let mut all = TAKEN.lock().unwrap_or_else(PoisonError::into_inner);
    if !all.contains(&sentence) {
        show::note(&sentence);
        all.push(sentence);
    }
}

/// The wing's file: the one named, else `wing.ron` of the current folder.
///
/// # Errors
/// If none is named and none is here.
pub fn wing(given: Option<&Path>) -> Result<PathBuf, InputError> {
    found("wing", given, WING, "tuflex", "--wing FILE")
}

/// The aircraft's file: the one named, else `aircraft.ron` beside the wing if one is named, else of the current folder.
///
/// # Errors
/// If none is named and none is there.
pub fn aircraft(given: Option<&Path>, wing: Option<&Path>) -> Result<PathBuf, InputError> {
    let Some(wing) = wing.filter(|_| given.is_none()) else {
        return found("aircraft", given, AIRCRAFT, "tuflex", "--aircraft FILE");
    };
    let (beside, here) = (in_folder(folder_of(wing), AIRCRAFT)?, in_folder(Path::new(""), AIRCRAFT)?);
    let places = [beside.map(|path| (path, "beside the wing")), here.map(|path| (path, "of this folder"))];
    let Some((path, why)) = places.into_iter().flatten().next() else {
        let message = format!("no aircraft is named, and there is no {AIRCRAFT}.ron beside this wing");
        return Err(
            InputError::in_file(wing, message).with_help("name the aircraft around it with --aircraft FILE")
        );
    };
    take("aircraft", &path, why);
    Ok(path)
}

/// What the virtual wind tunnel measures: the file named, else `tunnel.ron` of the current folder.
///
/// # Errors
/// If none is named and none is here.
pub fn tunnel(given: Option<&Path>) -> Result<PathBuf, InputError> {
    found("runs", given, TUNNEL, "tuflex", "--runs FILE")
}

/// The file of a rig that nobody drives: the one named, else `rig.ron` of the current folder.
///
/// # Errors
/// If none is named and none is here.
pub fn rig(given: Option<&Path>) -> Result<PathBuf, InputError> {
    found("rig", given, RIG, "bristol", "--rig FILE")
}

/// The data of response surfaces: the path named, else the current folder if it holds `response.ron`.
///
/// # Errors
/// If nothing is named and nothing is here.
pub fn study(given: Option<&Path>) -> Result<PathBuf, InputError> {
    let file = found("data", given, STUDY, "mav", "--data PATH")?;
    Ok(if given.is_none() { folder_of(&file).to_path_buf() } else { file })
}

fn found(
    what: &str,
    given: Option<&Path>,
    name: &str,
    example: &str,
    option: &str,
) -> Result<PathBuf, InputError> {
    if let Some(given) = given {
        return Ok(given.to_path_buf());
    }
    if let Some(here) = in_folder(Path::new(""), name)? {
        take(what, &here, "of this folder");
        return Ok(here);
    }
    if let Some(shipped) =
        SHIPPED.get().map(|folder| folder.join(example).join(format!("{name}.ron"))).filter(|p| p.is_file())
    {
        take(what, &shipped, "the shipped example");
        return Ok(shipped);
    }
    Err(InputError::general(format!("no {what} given, and this folder has no {name}.ron")).with_help(format!(
        "name one with {option}, or start in a folder that has one (`wingroot new DIR --example {example}` makes such a folder)"
    )))
}

/// The campaign's folder: the one named, else the one beside the wing (`campaign`, `measured`, or the wing's own folder).
///
/// # Errors
/// If none is named and there is none beside the wing, or more than one.
pub fn campaign(given: Option<&Path>, wing: &Path) -> Result<PathBuf, InputError> {
    if let Some(given) = given {
        return Ok(given.to_path_buf());
    }
    let folder = folder_of(wing);
    let named: Vec<PathBuf> =
        CAMPAIGNS.iter().map(|name| folder.join(name)).filter(|path| is_campaign(path)).collect();
    let own = is_campaign(folder).then(|| folder.to_path_buf());
    let candidates: Vec<PathBuf> = named.into_iter().chain(own).collect();
    if let [one] = candidates.as_slice() {
        take("campaign", one, "beside the wing");
        return Ok(one.clone());
    }
    let mut there: Vec<PathBuf> = candidates;
    if there.is_empty() {
        let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
        there = entries.map(|entry| entry.path()).filter(|path| is_campaign(path)).collect();
        there.sort();
    }
    let names: Vec<String> = there.iter().map(|path| path.display().to_string()).collect();
    let message = if names.is_empty() {
        "no campaign is named, and there is none beside this wing".to_owned()
    } else {
        "no campaign is named, and which one belongs to this wing is not clear".to_owned()
    };
    let help = if names.is_empty() {
        format!(
            "name the folder of measurements with --campaign DIR, or put it beside the wing as {}",
            CAMPAIGNS[0]
        )
    } else {
        format!("name one with --campaign DIR; there is {}", names.join(", "))
    };
    Err(InputError::in_file(wing, message).with_help(help))
}

/// Whether a folder is a campaign's. One with both files is, too: who reads it says what is wrong.
pub(crate) fn is_campaign(folder: &Path) -> bool {
    !matches!(in_folder(folder, CAMPAIGN), Ok(None))
}

/// The folder of a file, as one types it.
pub fn folder_of(file: &Path) -> &Path {
    file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or_else(|| Path::new("."))
}
