//! Case control: what each SUBCASE selects of the sets in the bulk data.
//!
//! What stands before the first SUBCASE holds for all of them. Output requests are skipped. Selections that change the
//! structure and are not read are kept by name, so that whoever needs the structure can refuse them.

use crate::deck::include;
use crate::source::{InputError, Span};
use crate::text_file::read_deck_text;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What a subcase selects.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Subcase {
    /// Its number; one for a case control without SUBCASE, zero for a deck without case control.
    pub id: u32,
    /// LABEL, else SUBTITLE.
    pub label: String,
    /// TRIM.
    pub trim: Option<u32>,
    /// DIVERG.
    pub divergence: Option<u32>,
    /// SPC.
    pub spc: Option<u32>,
    /// MPC.
    pub mpc: Option<u32>,
    /// SUPORT1.
    pub support: Option<u32>,
    /// METHOD: EIGRL or EIGR.
    pub method: Option<u32>,
    /// LOAD: static loads.
    pub load: Option<u32>,
    /// TEMPERATURE, or TEMPERATURE(LOAD): temperatures that load the structure.
    pub temperature: Option<u32>,
    /// TEMPERATURE(INITIAL): temperatures at which nothing has expanded, in the place of the materials' own.
    pub initial_temperature: Option<u32>,
    /// TEMPERATURE(MATERIAL): temperatures that the materials' constants are those of.
    pub material_temperature: Option<u32>,
    /// FMETHOD: FLUTTER.
    pub flutter: Option<u32>,
    /// SDAMPING: TABDMP1.
    pub damping: Option<u32>,
    /// AUTOSPC, in the place of PARAM AUTOSPC.
    pub auto_spc: Option<bool>,
    /// AESYMXZ: 1 symmetric, -1 antisymmetric, 0 asymmetric.
    pub symmetry: Option<i32>,
    /// GUST.
    pub gust: Option<u32>,
    /// DLOAD: TLOAD, RLOAD or DLOAD.
    pub dynamic_load: Option<u32>,
    /// FREQUENCY: FREQ, FREQ1 and FREQ2.
    pub frequencies: Option<u32>,
    /// TSTEP.
    pub time_steps: Option<u32>,
    /// RANDOM: RANDPS.
    pub random: Option<u32>,
    /// K2GG and M2GG: matrices (DMIG) that the structure has beside its elements.
    pub matrices: Vec<AddedMatrix>,
    /// K2PP, M2PP, B2PP, B2GG, K42GG: matrices (DMIG) beside the structure's; TFL: transfer functions.
    pub direct: Vec<String>,
    /// Grids of DISPLACEMENT, VELOCITY and ACCELERATION.
    pub responses: Asked,
    /// A command for what no program of wingroot computes, such as `ADAPT = 101`.
    pub foreign: Option<(String, Span)>,
    /// Selections that change stiffness, mass, loads or the choice of modes and are not read, such as `NSM = 5`.
    pub unread: Vec<(String, Span)>,
    /// Combinations of earlier subcases after this one, such as `SUBCOM 3`, which are not computed.
    pub combinations: Vec<String>,
}

/// A matrix that a subcase adds to the structure's.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AddedMatrix {
    /// To which.
    pub to: Added,
    /// Name of its DMIG cards.
    pub name: String,
    /// Where it is selected.
    pub span: Span,
}

/// What a matrix is added to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Added {
    /// K2GG: to the stiffness.
    Stiffness,
    /// M2GG: to the mass, which PARAM WTMASS does not change.
    Mass,
}

/// Points that answers are asked for at.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub enum Asked {
    /// None.
    #[default]
    Nothing,
    /// ALL.
    All,
    /// Those of sets, in rising numbers.
    Of(BTreeSet<u32>),
}

/// Commands that change stiffness, mass, loads or the choice of modes and are not read.
const CHANGING: [&str; 7] = ["NSM", "STATSUB", "DEFORM", "P2G", "A2GG", "MFLUID", "MODESELECT"];

/// Commands that ask for what wingroot is not for, and what that is.
const FOREIGN: [(&str, &str); 4] = [
    ("ADAPT", "adaptive p-elements"),
    ("BCONTACT BCSET BGSET", "contact or glue"),
    ("AXISYM AXISYMMETRIC HARMONICS", "fluids and bodies of revolution by harmonics"),
    ("FLUX", "heat"),
];

/// What a command of [`FOREIGN`] asks for.
pub(crate) fn foreign_purpose(text: &str) -> &'static str {
    let name = words(text).map(|(name, _)| name).unwrap_or_default();
    FOREIGN
        .iter()
        .find(|(names, _)| names.split(' ').any(|one| one == name))
        .map_or("something else", |(_, what)| what)
}

/// Commands that begin something made of earlier subcases, which have no boundary conditions of their own.
const COMBINED: [&str; 3] = ["SUBCOM", "SYMCOM", "REPCASE"];

/// Longest range of a set.
const LONGEST_RANGE: u32 = 1_000_000;

/// One command, with the lines that a comma joins to it, and where it stands.
struct Command {
    text: String,
    span: Span,
}

/// Reads the lines before BEGIN BULK: those after CEND, or all if there is no CEND. Without CEND and without a selection
/// there is no case control and no subcase; with one there is at least one.
///
/// # Errors
/// If a selection is no number, AESYMXZ no symmetry, or an included file cannot be read.
pub(super) fn read(path: &Path, lines: &[&str]) -> Result<Vec<Subcase>, InputError> {
    let is_end =
        |line: &&str| line.trim_start().get(..4).is_some_and(|word| word.eq_ignore_ascii_case("CEND"));
    let end = lines.iter().position(is_end);
    let mut commands = Vec::new();
    collect(path, lines, end.map_or(0, |at| at + 1), &mut commands)?;
    let mut common = Subcase::default();
    let mut subcases: Vec<Subcase> = Vec::new();
    let mut combined: Option<Subcase> = None;
    let sets = sets(&commands);
    for command in &commands {
        let Some((name, value)) = words(&command.text) else { continue };
        if name.starts_with("SUBC") && name != "SUBCOM" || name == "SYM" {
            let id = number(command, value)?;
            if subcases.iter().any(|case| case.id == id) {
                let message = format!("subcase {id} is given twice");
                return Err(
                    InputError::at(&command.span, message).with_help("give every subcase its own number")
                );
            }
            subcases.push(Subcase { id, ..common.clone() });
            combined = None;
        } else if COMBINED.contains(&name.as_str()) {
            combined = Some(Subcase::default());
            if let Some(before) = subcases.last_mut().filter(|_| name != "REPCASE") {
                before.combinations.push(command.text.clone());
            }
        } else {
            let case = combined.as_mut().or(subcases.last_mut()).unwrap_or(&mut common);
            select(case, command, &name, value, &sets)?;
        }
    }
    if subcases.is_empty() && (end.is_some() || common != Subcase::default()) {
        subcases.push(Subcase { id: 1, ..common });
    }
    refuse_unlike_matrices(&subcases)?;
    Ok(subcases)
}

/// One structure serves all subcases.
fn refuse_unlike_matrices(subcases: &[Subcase]) -> Result<(), InputError> {
    let Some(most) = subcases.iter().map(|case| &case.matrices).max_by_key(|matrices| matrices.len()) else {
        return Ok(());
    };
    if subcases.iter().all(|case| case.matrices == *most) {
        return Ok(());
    }
    let message = format!("the matrix {} is not selected for all subcases alike", most[most.len() - 1].name);
    Err(InputError::at(&most[most.len() - 1].span, message)
        .with_help("K2GG and M2GG belong above the first SUBCASE"))
}

/// The lines from one on, with those of included files in their place.
fn collect(path: &Path, lines: &[&str], from: usize, commands: &mut Vec<Command>) -> Result<(), InputError> {
    let file: Arc<PathBuf> = Arc::new(path.to_path_buf());
    let mut at = from;
    while at < lines.len() {
        let line = lines[at];
        if include::is_include(line) {
            let found = include::target(&file, lines, at)?;
            at = found.next_line;
            let inner = path.parent().unwrap_or(Path::new("")).join(&found.path);
            // A file that includes itself would never end.
            if include::identity(&inner) == include::identity(path) {
                return Err(InputError::at(&found.span, format!("{} includes itself", path.display())));
            }
            let text = read_deck_text(&inner)
                .map_err(|error| InputError { span: Some(found.span.clone()), ..error })?;
            let without_includes: Vec<&str> =
                text.lines().filter(|line| !include::is_include(line)).collect();
            collect(&inner, &without_includes, 0, commands)?;
            continue;
        }
        let text = line.split('$').next().unwrap_or("").trim();
        if !text.is_empty() {
            let span = Span::new(&file, at + 1, 1, line.chars().count().max(1) + 1);
            match commands.last_mut().filter(|before| before.text.ends_with(',')) {
                Some(before) => before.text += text,
                None => commands.push(Command { text: text.to_owned(), span }),
            }
        }
        at += 1;
    }
    Ok(())
}

/// Name in capitals and value of a command, what stands in brackets left out; nothing for those of fluids.
fn words(text: &str) -> Option<(String, Option<&str>)> {
    let end = text.find(|c: char| c.is_whitespace() || c == '=' || c == '(').unwrap_or(text.len());
    let (name, mut rest) = text.split_at(end);
    if let Some(open) = rest.trim_start().strip_prefix('(') {
        let (inside, after) = open.split_once(')')?;
        if inside.to_ascii_uppercase().starts_with("FLUI") {
            return None;
        }
        rest = after;
    }
    let value = rest.split(|c: char| c.is_whitespace() || c == '=').find(|word| !word.is_empty());
    Some((name.to_ascii_uppercase(), value))
}

fn wrong(command: &Command, what: &str) -> InputError {
    InputError::at(&command.span, format!("`{}` selects nothing", command.text))
        .with_help(format!("expected {what}"))
}

fn number(command: &Command, value: Option<&str>) -> Result<u32, InputError> {
    value.and_then(|value| value.parse().ok()).ok_or_else(|| wrong(command, "a number"))
}

/// Commands that may be cut down to four letters or more.
const ABBREVIATED: [&str; 13] = [
    "AUTOSPC",
    "SUPORT1",
    "METHOD",
    "TEMPERATURE",
    "FMETHOD",
    "SDAMPING",
    "DLOAD",
    "FREQUENCY",
    "TSTEP",
    "RANDOM",
    "SUBTITLE",
    "AESYMXZ",
    "LABEL",
];

/// The whole name of a command.
fn unabbreviated(name: &str) -> &str {
    let whole = ABBREVIATED.iter().find(|whole| name.len() >= 4 && whole.starts_with(name));
    whole.copied().unwrap_or(name)
}

/// What stands in brackets, in capitals: TEMP(INITIAL).
fn said_of(text: &str) -> String {
    text.split_once('(').map_or("", |(_, rest)| rest).trim_start().to_ascii_uppercase()
}

/// The sets of points, by number; of a set given again the last.
fn sets(commands: &[Command]) -> BTreeMap<u32, BTreeSet<u32>> {
    let mut sets = BTreeMap::new();
    for command in commands {
        let Some((head, list)) = command.text.split_once('=') else { continue };
        let mut words = head.split_whitespace();
        let is_set = words.next().is_some_and(|word| word.eq_ignore_ascii_case("SET"));
        let Some(id) = words.next().and_then(|id| id.parse().ok()).filter(|_| is_set) else { continue };
        let mut ids: BTreeSet<u32> = BTreeSet::new();
        let (mut last, mut is_range) = (None, false);
        for word in list.split(|c: char| c.is_whitespace() || c == ',').filter(|word| !word.is_empty()) {
            match word.parse::<u32>() {
                Ok(end) => {
                    let first = last.filter(|first| is_range && end > *first && end - first < LONGEST_RANGE);
                    ids.extend(first.unwrap_or(end)..=end);
                    (last, is_range) = (Some(end), false);
                }
                Err(_) => is_range = word.eq_ignore_ascii_case("THRU"),
            }
        }
        sets.insert(id, ids);
    }
    sets
}

/// Adds the points of a request; one that names no set asks for nothing.
fn ask(case: &mut Subcase, value: Option<&str>, sets: &BTreeMap<u32, BTreeSet<u32>>) {
    let word = value.unwrap_or_default();
    if word.eq_ignore_ascii_case("ALL") {
        case.responses = Asked::All;
    } else if let Some(set) = word.parse().ok().and_then(|id: u32| sets.get(&id)) {
        match &mut case.responses {
            Asked::All => {}
            Asked::Of(ids) => ids.extend(set),
            Asked::Nothing => case.responses = Asked::Of(set.clone()),
        }
    }
}

/// Adds a matrix of K2GG or M2GG; several in one command, or with factors, are not read.
fn add(case: &mut Subcase, command: &Command, name: &str, value: Option<&str>) {
    let span = command.span.clone();
    match value.filter(|_| !command.text.contains([',', '*', '('])) {
        Some(value) => case.matrices.push(AddedMatrix {
            to: if name == "K2GG" { Added::Stiffness } else { Added::Mass },
            name: value.to_ascii_uppercase(),
            span,
        }),
        None => case.unread.push((command.text.clone(), span)),
    }
}

/// The number of AESYMXZ's word.
fn symmetry(command: &Command, value: Option<&str>) -> Result<i32, InputError> {
    match value.unwrap_or_default().to_ascii_uppercase().get(..4) {
        Some("SYMM") => Ok(1),
        Some("ANTI") => Ok(-1),
        Some("ASYM") => Ok(0),
        _ => Err(wrong(command, "SYMMETRIC, ANTISYMMETRIC or ASYMMETRIC")),
    }
}

/// Keeps what a command says of a subcase.
fn select(
    case: &mut Subcase,
    command: &Command,
    name: &str,
    value: Option<&str>,
    sets: &BTreeMap<u32, BTreeSet<u32>>,
) -> Result<(), InputError> {
    let one = || number(command, value).map(Some);
    match unabbreviated(name) {
        "TRIM" => case.trim = one()?,
        "DIVERG" => case.divergence = one()?,
        "SPC" => case.spc = one()?,
        "MPC" => case.mpc = one()?,
        "AUTOSPC" => {
            let word = value.unwrap_or_default().to_ascii_uppercase();
            case.auto_spc = Some(match word.as_str() {
                "YES" => true,
                "NO" => false,
                _ => return Err(wrong(command, "YES or NO")),
            });
        }
        "SUPORT1" => case.support = one()?,
        "METHOD" => case.method = one()?,
        "LOAD" => case.load = one()?,
        "TEMPERATURE" => match said_of(&command.text).get(..3) {
            Some("INI") => case.initial_temperature = one()?,
            Some("MAT") => case.material_temperature = one()?,
            _ => case.temperature = one()?,
        },
        "FMETHOD" => case.flutter = one()?,
        "SDAMPING" => case.damping = one()?,
        "GUST" => case.gust = one()?,
        "DLOAD" => case.dynamic_load = one()?,
        "FREQUENCY" => case.frequencies = one()?,
        "TSTEP" => case.time_steps = one()?,
        "RANDOM" => case.random = one()?,
        "K2GG" | "M2GG" => add(case, command, name, value),
        "K2PP" | "M2PP" | "B2PP" | "B2GG" | "K42GG" | "TFL" => {
            case.direct.push(format!("{name} {}", value.unwrap_or_default().to_ascii_uppercase()));
        }
        _ if ["DISP", "VELO", "ACCE"].iter().any(|word| name.starts_with(word)) => ask(case, value, sets),
        "LABEL" | "SUBTITLE" => {
            let label = command.text.split_once('=').map_or("", |(_, label)| label);
            label.trim().clone_into(&mut case.label);
        }
        "AESYMXZ" => case.symmetry = Some(symmetry(command, value)?),
        _ if FOREIGN.iter().any(|(names, _)| names.split(' ').any(|one| one == name)) => {
            case.foreign = Some((command.text.clone(), command.span.clone()));
        }
        _ if CHANGING.contains(&name) => {
            case.unread.push((command.text.clone(), command.span.clone()));
        }
        _ => {}
    }
    Ok(())
}
