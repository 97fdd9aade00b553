//! `loads --deck`: a plan of design loads on a user's whole-aircraft Nastran deck: its trims with both models, their envelope, a
//! selection, and cards for the deck's own structure.

use std::fmt::Write as _;
use std::path::Path;
use std::time::Instant;

use fullaircraft::Station;
use fullaircraft::cases::list::MODELS;
use fullaircraft::design_loads::deck::DeckFlown;
use fullaircraft::package::round_trip::LOADS;
use loads::SelectFile;

use crate::args::Common;
use crate::commands::loads_deck_package::package;
use crate::commands::loads_figures as figures;
use crate::commands::loads_flights::Flown;
use crate::commands::loads_gusts as gusts;
use crate::commands::loads_on_deck::OnDeck;
use crate::commands::loads_plan::{selection_file, write_matrix};
use crate::commands::loads_result::{Failed, LoadsResult};
use crate::commands::loads_tables as tables;
use crate::commands::loads_turbulence as turbulence;
use crate::failure::Failure;
use crate::output::ResultFolder;

/// What is asked for.
pub(super) struct Asked<'a> {
    /// The deck, or a study.
    pub(super) deck: &'a Path,
    /// The plan.
    pub(super) plan: &'a Path,
    /// The selection, if it is not the plan's.
    pub(super) select: Option<&'a Path>,
    /// Whether nothing is flown.
    pub(super) matrix_only: bool,
}

/// Runs the command with a deck and a plan.
pub(super) fn run(asked: &Asked<'_>, target: &Path, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let mut on = OnDeck::read(asked.deck, asked.plan, common)?;
    if asked.matrix_only {
        return LoadsResult::of(&on.file, &on.matrix).end_with_matrix(begun(&on, target)?, common);
    }
    let select = selection_file(asked.select, &on.file)?;
    on.inputs.extend((!select.path.as_os_str().is_empty()).then(|| ("selection", select.path.clone())));
    let all = on.fly(common);
    let flown = Flown { cases: all.iter().map(|one| one.case.clone()).collect() };
    flown.mark(&mut on.matrix);
    let (result, packed) = write(&on, target, &select, &all, &flown)?;
    result.end(&packed, start, target, common)
}

/// The folder of results with the matrix in it.
fn begun(on: &OnDeck, target: &Path) -> Result<ResultFolder, Failure> {
    let folder = ResultFolder::begin(target)?;
    on.given.leave_study(&folder)?;
    on.inputs.iter().try_for_each(|(what, path)| folder.input(what, path))?;
    write_matrix(&folder, &on.design, &on.matrix)?;
    Ok(folder)
}

/// Everything that comes of flown cases, and the package in a line; nothing is written if the cards do not give back what was flown.
fn write(
    on: &OnDeck,
    target: &Path,
    select: &SelectFile,
    all: &[DeckFlown],
    flown: &Flown,
) -> Result<(LoadsResult, String), Failure> {
    let names: Vec<String> = on.stations.iter().map(|station| station.name.clone()).collect();
    let instants = flown.instants();
    let selection = loads::select(select, &names, &instants)?;
    let since = Instant::now();
    let packed = package(on, all, select, &selection)?;
    let line = packed.line(since);
    let folder = begun(on, target)?;
    let envelope = tables::envelope(&names, &instants, &on.matrix);
    let selected = tables::selected(&names, &selection, flown, &on.matrix, &on.design);
    let worst = gusts::worst(&names, &flown.cases, &on.matrix);
    tables::write_station_loads(&folder, &names, &flown.cases)?;
    for (name, text) in [
        ("envelope.csv", fullaircraft::cases::envelope::envelope_csv(&envelope)),
        ("gusts.csv", gusts::csv(&worst)),
        ("turbulence.csv", turbulence::csv(&names, &flown.cases)),
        ("correlation.csv", turbulence::correlation(&names, &flown.cases)),
        ("trims.csv", trims(all)),
        ("monitors.csv", monitors(all)),
        ("selection.csv", selection.csv()),
        ("selected.csv", selected),
    ] {
        folder.write_text(name, &text)?;
    }
    turbulence::figures(&folder, &along(on), flown, &on.matrix, &on.design)?;
    figures::potatoes(&folder, &names, &instants, &selection)?;
    for (name, bytes) in &packed.files {
        folder.write_bytes(&format!("package/{name}"), bytes)?;
    }
    let mut result = LoadsResult::of(&on.file, &on.matrix);
    result.failed = flown.failed().map(|(case, model, why)| Failed { case, model, why }).collect();
    result.envelope = envelope;
    result.gusts = gusts::of_stations(worst, &|station| station != "whole");
    result.turbulence = turbulence::rows(&names, &flown.cases);
    result.selected = selection.selected.iter().map(Into::into).collect();
    result.round_trip = Some(packed.round_trip);
    result.package = Some("package".to_owned());
    folder.write_json("result.json", &result)?;
    folder.commit_if(result.flown > 0)?;
    Ok((result, line))
}

/// Stations along the right wing: their places and y, m.
fn along(on: &OnDeck) -> Vec<(usize, f64)> {
    let is_basic = |station: &Station| station.name != "whole" && station.axes.is_identity(1e-9);
    let places = on.stations.iter().enumerate().filter(|(_, station)| is_basic(station));
    let y_m = places.map(|(place, station)| (place, station.point.y * on.plan.units.length_m));
    y_m.filter(|(_, y_m)| *y_m > 0.0).collect()
}

/// Trim variables of all cases in the deck's own units.
fn trims(all: &[DeckFlown]) -> String {
    let mut text = String::from("model,case,variable,value\n");
    for one in all {
        for (name, value) in &one.values {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "{},{},{name},{value:.12e}", MODELS[one.case.model], one.case.number);
        }
    }
    text
}

/// The air's loads of the deck's MONPNT1.
fn monitors(all: &[DeckFlown]) -> String {
    let mut text = format!("model,case,monitor,{}\n", LOADS.join(","));
    for one in all {
        for (name, loads) in &one.air {
            // Writing to a String cannot fail.
            let _ = write!(text, "{},{},{name}", MODELS[one.case.model], one.case.number);
            for load in loads {
                let _ = write!(text, ",{load:.12e}");
            }
            text.push('\n');
        }
    }
    text
}
