//! `fullaircraft --cases`: a grid of airspeeds, load factors and maneuvers with both models, and the load envelope.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::Instant;

use fullaircraft::cases::envelope::{Extreme, LOADS, cases_csv, envelope_csv, load_envelope};
use fullaircraft::cases::grid::{MODELS, groups};
use fullaircraft::{Aircraft, Case, CaseFlight, CaseResult, CasesFile, FlightAir, TrimTools};
use indicatif::ProgressBar;
use nastran::InputError;
use rayon::prelude::*;
use schemars::JsonSchema;
use serde::Serialize;

use crate::args::Common;
use crate::commands::fullaircraft_cases_figures as figures;
use crate::commands::fullaircraft_prepared::{FullaircraftArgs, Prepared, prepared};
use crate::corrections::CorrectedWing;
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::store::Store;
use crate::{progress, show};

/// What `result.json` holds: nothing that depends on how often the run was stopped.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Summary {
    /// Name of the command.
    command: &'static str,
    /// Name of the grid of cases.
    name: String,
    /// How many cases were flown.
    cases: usize,
    /// Cases that could not be flown.
    refused: Vec<Refused>,
    /// Number of aerodynamic boxes.
    boxes: usize,
    /// Airspeed of the corrections.
    correction_airspeed_m_s: f64,
    /// Smallest and largest loads.
    envelope: Vec<Extreme>,
    /// What the user should know.
    warnings: Vec<String>,
}

/// A case that could not be flown.
#[derive(Debug, Serialize, JsonSchema)]
struct Refused {
    /// Its number.
    case: usize,
    /// Which model.
    model: String,
    /// What was to be flown.
    flown: String,
    /// Why it was not.
    why: String,
}

/// Runs the command.
pub(crate) fn run(path: &Path, args: &FullaircraftArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let target = common.out(args.results());
    let file = CasesFile::read(path)?;
    let Prepared { mut aircraft, corrections, wing: CorrectedWing { origin, .. }, mut inputs, .. } =
        prepared(args, common)?;
    inputs.push(("cases", file.path.clone()));
    if !aircraft.wing.deflection.is_empty() && !common.quiet {
        show::note(
            "cases fly surfaces to where they are commanded: the wing's deflection correction is left out",
        );
    }
    // maneuvers in time know the wing's stations only
    aircraft.wing.stations.extend(file.stations.iter().cloned());
    let tools = tools(&aircraft, &file)?;
    let models = [aircraft.uncorrected(), aircraft.with_corrections(&corrections)?];
    let limits = aircraft.file.lift_limits()?;
    let store = Store::beside(&target, &aircraft.inputs_of_cases(&corrections, &file))?;
    let cases = file.cases();
    let finished: Vec<Option<CaseResult>> = cases.iter().map(|case| kept(&store, case)).collect();
    let before = finished.iter().flatten().count();
    let unfinished = cases.iter().zip(&finished).filter(|(_, found)| found.is_none());
    let missing: Vec<Case> = unfinished.map(|(case, _)| case.clone()).collect();
    // What needs no unsteady air is flown and kept before that is prepared, which takes longest.
    let (dynamic, steady): (Vec<Case>, Vec<Case>) = missing.into_iter().partition(Case::is_dynamic);
    let bar = progress::bar(common, dynamic.len() + steady.len(), "cases");
    let mut results: Vec<CaseResult> = finished.into_iter().flatten().collect();
    for cases in [steady, dynamic] {
        let air = if cases.iter().any(Case::is_dynamic) { Some(FlightAir::new(&aircraft)?) } else { None };
        let flight = CaseFlight {
            tools: &tools,
            models: [&models[0], &models[1]],
            air: air.as_ref(),
            limits: limits.as_deref(),
        };
        results.extend(fly(&flight, &cases, &store, &bar).map_err(|failure| in_file(failure, &file))?);
    }
    progress::end(&bar);
    results.sort_by_key(|result| result.number);
    let summary = summary(&file, &results, &tools);
    let out = write(&target, &inputs, &summary, &results, &tools)?;
    store.close()?;
    remark(common, &summary);
    let text = format!(
        "{}\n{} cases, {} of them not to be flown, {before} finished before; {} factorisations, {:.2} s\n\
         corrections at {} m/s: {origin}\nresults in {}\n",
        table(&summary.envelope),
        summary.cases,
        summary.refused.len(),
        tools.factorisations(),
        start.elapsed().as_secs_f64(),
        summary.correction_airspeed_m_s,
        out.display()
    );
    show::summary(common, &text);
    show::json(common, &summary)?;
    if summary.refused.len() == summary.cases {
        return Err(Failure::Computation("none of the cases can be flown".into()));
    }
    Ok(())
}

/// What a case is called in the store: its number is its place in a list, which may be another next time.
fn part(case: &Case) -> String {
    format!("{} {:?} {:?}", case.model, case.v_m_s, case.action)
}

fn kept(store: &Store, case: &Case) -> Option<CaseResult> {
    let result = store.get(&part(case))?;
    Some(CaseResult { number: case.number, ..result })
}

/// What trims are made with, once the aircraft knows every name in the file.
fn tools<'a>(aircraft: &'a Aircraft, file: &CasesFile) -> Result<TrimTools<'a>, Failure> {
    let tools = TrimTools::new(aircraft, &[]).map_err(|error| in_file(error.into(), file))?;
    file.check_names(&tools)?;
    Ok(tools)
}

/// Flies what is missing on all threads; each result is kept as soon as it is there.
fn fly(
    flight: &CaseFlight<'_>,
    missing: &[Case],
    store: &Store,
    bar: &ProgressBar,
) -> Result<Vec<CaseResult>, Failure> {
    let results = Mutex::new(Vec::new());
    let flown = groups(missing).par_iter().try_for_each(|group| {
        flight.fly(group, &mut |case: &Case, result: CaseResult| {
            let kept = store.put(&part(case), &result)?;
            results.lock().map_err(Failure::computation)?.push(kept);
            bar.inc(1);
            Ok::<(), Failure>(())
        })
    });
    flown?;
    results.into_inner().map_err(Failure::computation)
}

/// Input that no file was named for is the file's of the cases.
fn in_file(failure: Failure, file: &CasesFile) -> Failure {
    match failure {
        Failure::Input(error) if error.span.is_none() => {
            let here = InputError::in_file(&file.path, error.message);
            Failure::Input(InputError { help: error.help, ..here })
        }
        other => other,
    }
}

fn summary(file: &CasesFile, results: &[CaseResult], tools: &TrimTools<'_>) -> Summary {
    let refused = results.iter().filter_map(|result| {
        let why = result.refused.clone()?;
        Some(Refused { case: result.number, model: result.model.clone(), flown: result.label(), why })
    });
    let warned = |result: &CaseResult| {
        let (model, v_m_s) = (result.model.clone(), result.v_m_s);
        result
            .warnings
            .iter()
            .map(move |warning| format!("{model}, {v_m_s} m/s, {warning}"))
            .collect::<Vec<_>>()
    };
    Summary {
        command: "fullaircraft --cases",
        name: file.name.clone(),
        cases: results.len(),
        refused: refused.collect(),
        boxes: tools.aircraft.flow.lattice.len(),
        correction_airspeed_m_s: tools.aircraft.file.correction_airspeed_m_s,
        envelope: load_envelope(results),
        warnings: results.iter().flat_map(warned).collect::<BTreeSet<_>>().into_iter().collect(),
    }
}

fn write(
    target: &Path,
    inputs: &[(&'static str, PathBuf)],
    summary: &Summary,
    results: &[CaseResult],
    tools: &TrimTools<'_>,
) -> Result<PathBuf, Failure> {
    let folder = ResultFolder::begin(target)?;
    inputs.iter().try_for_each(|(what, path)| folder.input(what, path))?;
    folder.write_text("cases.csv", &cases_csv(results))?;
    folder.write_text("envelope.csv", &envelope_csv(&summary.envelope))?;
    if !summary.envelope.is_empty() {
        let drawn = figures::envelope(&tools.stations, &summary.envelope);
        folder.write_figure_of(
            "envelope",
            "The smallest and the largest load of all cases at each station.",
            drawn,
            "envelope.csv",
        )?;
        folder.write_figure_of(
            "cases",
            "Both ends of what each case moves through.",
            figures::cloud(results),
            "cases.csv",
        )?;
    }
    folder.write_json("result.json", summary)?;
    folder.commit_if(summary.refused.len() < summary.cases)
}

/// How many cases were refused or warned about; the whole list is in the results.
fn remark(common: &Common, summary: &Summary) {
    if common.quiet {
        return;
    }
    for refused in summary.refused.iter().take(5) {
        show::note(&format!("{}, {}: {}", refused.model, refused.flown, refused.why));
    }
    if summary.refused.len() > 5 {
        show::note(&format!("and {} more that cannot be flown, see result.json", summary.refused.len() - 5));
    }
    if !summary.warnings.is_empty() {
        show::note(&format!(
            "{} warnings (deflections, polars, stability) in result.json, the first: {}",
            summary.warnings.len(),
            summary.warnings[0]
        ));
    }
}

fn table(envelope: &[Extreme]) -> report::Table {
    let mut table =
        report::Table::new(&["", "initial", "updated: smallest", "initial", "updated: largest", "given by"]);
    let mut stations: Vec<&str> = Vec::new();
    for extreme in envelope {
        if !stations.contains(&extreme.station.as_str()) {
            stations.push(&extreme.station);
        }
    }
    for station in stations {
        for load in LOADS {
            let find = |model: &str, end: &str| {
                envelope
                    .iter()
                    .find(|e| e.model == model && e.station == station && e.load == load && e.end == end)
            };
            let number =
                |model: &str, end: &str| find(model, end).map_or("-".into(), |e| format!("{:.2}", e.value));
            table.row([
                format!("{station}: {}", load.replace('_', " ")),
                number(MODELS[0], "smallest"),
                number(MODELS[1], "smallest"),
                number(MODELS[0], "largest"),
                number(MODELS[1], "largest"),
                find(MODELS[1], "largest").map_or_else(String::new, |e| e.flown.clone()),
            ]);
        }
    }
    table
}
