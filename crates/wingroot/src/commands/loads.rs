//! `loads`: the cases of a plan of design loads flown with both models, their envelope, a selection, and the cards for stress.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use fullaircraft::cases::file::Action;
use fullaircraft::design_loads::aircraft::{check_loading, maneuvers};
use fullaircraft::{CasesFile, Station};
use loads::{Design, Matrix, SelectFile, Selection, matrix};
use nastran::InputError;
use nastran::ron_or_json::in_folder;

use crate::args::{Common, Given};
use crate::commands::fullaircraft_prepared::{FullaircraftArgs, Prepared, prepared_for_parts};
use crate::commands::loads_deck::{self, Asked};
use crate::commands::loads_draws as draws;
use crate::commands::loads_figures as figures;
use crate::commands::loads_flights::{Flights, Flown, FromPlan};
use crate::commands::loads_gusts as gusts;
use crate::commands::loads_kept as kept;
use crate::commands::loads_package::package;
use crate::commands::loads_package_files::Packed;
use crate::commands::loads_plan::{design, selection_file, write_matrix};
use crate::commands::loads_result::{Failed, LoadsResult};
use crate::commands::loads_sweep as sweep;
use crate::commands::loads_tables as tables;
use crate::commands::loads_turbulence as turbulence;
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;
use crate::store::{Shared, Store};
use crate::sweep::{SweepArgs, Task};

/// Options of `loads`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot loads
  wingroot loads --plan data/tuflex/loads.ron --matrix-only
  wingroot loads --from out/loads --select my/select.ron
  wingroot loads --deck my/aircraft.bdf --plan my/loads.ron

Flies every case of the plan with both models; writes cases.csv, vn.csv, station_loads.csv, envelope.csv, selected.csv,
figures and package/ (FORCE and MOMENT cards of the selected cases, the structure they belong to, and their round trip)
into out/loads. Finished cases are kept beside that folder until all are done. --from selects anew among finished cases and
flies none; with --cards those that are selected, for their cards: out/loads_selection.")]
pub struct LoadsArgs {
    /// The aircraft [default: aircraft.ron beside the wing, or of the current folder]
    #[arg(long, value_name = "FILE")]
    pub(crate) aircraft: Option<PathBuf>,
    /// Wing [default: the one that the aircraft names], measurements, corrections.
    #[command(flatten)]
    pub(crate) given: Given,
    /// The plan of design loads [default: loads.ron beside the aircraft]
    #[arg(long, value_name = "FILE.ron")]
    pub(crate) plan: Option<PathBuf>,
    /// A whole-aircraft Nastran deck (SOL 144), or a study (.ron) of decks that lack something for it, in place of the aircraft: its
    /// trims, with the plan's `deck` for its units
    #[arg(long, value_name = "FILE.bdf", requires = "plan",
        conflicts_with_all = ["aircraft", "wing", "campaign", "corrections", "from", "part", "case"])]
    pub(crate) deck: Option<PathBuf>,
    /// Only the matrix of cases and the V-n diagrams: nothing is flown
    #[arg(long, conflicts_with_all = ["part", "case"])]
    pub(crate) matrix_only: bool,
    /// The results of an earlier run to select from
    #[arg(long, value_name = "DIR", conflicts_with_all = ["matrix_only", "part", "case"], requires = "select")]
    pub(crate) from: Option<PathBuf>,
    /// With --from: cards of the new selection, for which its cases alone are flown again
    #[arg(long, requires = "from")]
    pub(crate) cards: bool,
    /// Which cases go to stress [default: the one that the plan names; without one, all ends and hulls]
    #[arg(long, value_name = "FILE.ron")]
    pub(crate) select: Option<PathBuf>,
    /// Which of the cases
    #[command(flatten)]
    pub(crate) sweep: SweepArgs,
}

impl LoadsArgs {
    /// The folder of results, which differs with what is asked for.
    pub(super) fn results(&self) -> &'static str {
        match (&self.from, &self.deck) {
            (Some(_), _) => "loads_selection",
            (None, Some(_)) => "loads_deck",
            (None, None) => "loads",
        }
    }
}

/// Runs the command.
pub(crate) fn run(args: &LoadsArgs, common: &Common) -> Result<(), Failure> {
    let target = common.out(args.results());
    if let (Some(from), Some(select)) = (&args.from, &args.select) {
        return select_again(args, from, select, common);
    }
    if let (Some(deck), Some(plan)) = (&args.deck, &args.plan) {
        return on_deck(args, deck, plan, &target, common);
    }
    let start = Instant::now();
    let own = FullaircraftArgs {
        aircraft: args.aircraft.clone(),
        given: args.given.clone(),
        ..FullaircraftArgs::default()
    };
    let task = if args.matrix_only { Task::All } else { args.sweep.task()? };
    // one process flies selected cases again for their cards
    let keeps = matches!(task, Task::All | Task::Prepare | Task::Part(_)) && !args.matrix_only;
    let shared = Shared::new(&Store::folder_beside(&target)?, keeps);
    let mut prepared = prepared_for_parts(&own, common, &shared)?;
    let plan = plan(args, &prepared)?;
    let design = design(&plan)?;
    prepared.inputs.push(("plan", plan.path.clone()));
    let (maneuvers, matrix) = planned(&prepared, &plan, &design)?;
    if args.matrix_only {
        let folder = ResultFolder::begin(&target)?;
        prepared.inputs.iter().try_for_each(|(what, path)| folder.input(what, path))?;
        write_matrix(&folder, &design, &matrix)?;
        return LoadsResult::of(&plan, &matrix).end_with_matrix(folder, common);
    }
    let select = selection_file(args.select.as_deref(), &plan)?;
    prepared.inputs.extend((!select.path.as_os_str().is_empty()).then(|| ("selection", select.path.clone())));
    let mut flights = {
        let planned = FromPlan { plan: &plan, design: &design, maneuvers, matrix: &matrix };
        Flights::new(&prepared, planned, &target, &shared)?
    };
    flights.store = flights.store.labelled(task.label());
    let Some(flown) = sweep::flown(&flights, task, &args.sweep, common, start)? else { return Ok(()) };
    let (result, packed) = write(&target, &prepared, &flights, &flown, &select)?;
    if task == Task::All {
        flights.store.close()?;
    }
    result.end(&packed, start, &target, common)
}

/// A plan on a deck.
fn on_deck(
    args: &LoadsArgs,
    deck: &Path,
    plan: &Path,
    target: &Path,
    common: &Common,
) -> Result<(), Failure> {
    if !args.matrix_only && args.sweep.task()? != Task::All {
        return Err(InputError::general("a plan on a deck is flown in one process")
            .with_help("leave out --part, prepare, merge and status")
            .into());
    }
    let asked = Asked { deck, plan, select: args.select.as_deref(), matrix_only: args.matrix_only };
    loads_deck::run(&asked, target, common)
}

/// The plan's file: the one named, else `loads.ron` beside the aircraft.
fn plan(args: &LoadsArgs, prepared: &Prepared) -> Result<CasesFile, Failure> {
    if let Some(path) = &args.plan {
        return Ok(CasesFile::read(path)?);
    }
    let aircraft = &prepared.aircraft.file.path;
    let folder = aircraft.parent().unwrap_or(Path::new(""));
    let path = in_folder(folder, "loads")?.ok_or_else(|| {
        InputError::in_file(aircraft, "no plan is named, and there is no loads.ron beside this aircraft")
            .with_help("name the plan of design loads with --plan FILE.ron")
    })?;
    crate::paths::take("plan", &path, "beside the aircraft");
    Ok(CasesFile::read(&path)?)
}

/// The plan's own maneuvers and all its cases.
fn planned(prepared: &Prepared, plan: &CasesFile, design: &Design) -> Result<(Vec<Action>, Matrix), Failure> {
    let aircraft = &prepared.aircraft;
    aircraft.loads_stations(plan)?;
    for mass in &design.masses {
        let in_plan = |error: InputError| InputError {
            span: InputError::in_field(&plan.path, "masses", "").span,
            ..error
        };
        check_loading(mass).map_err(in_plan)?;
    }
    let airframe = aircraft.airframe(&aircraft.uncorrected(), design.speeds.vc)?;
    let (actions, conditions) = maneuvers(plan, design)?.into_iter().unzip::<_, _, Vec<_>, Vec<_>>();
    Ok((actions, matrix(design, &airframe, &conditions)?))
}

/// Everything that comes of flown cases; nothing is written if the cards do not give back what was flown.
fn write(
    target: &Path,
    prepared: &Prepared,
    flights: &Flights<'_>,
    flown: &Flown,
    select: &SelectFile,
) -> Result<(LoadsResult, String), Failure> {
    let (plan, design) = (flights.plan, flights.design);
    let mut matrix = flights.matrix.clone();
    flown.mark(&mut matrix);
    let names: Vec<String> = flights.stations.iter().map(|station| station.name.clone()).collect();
    let instants = flown.instants();
    let selection = loads::select(select, &names, &instants)?;
    let start = Instant::now();
    let packed = package(prepared, flights, flown, select, &selection)?;
    let line = packed.line(start);
    let folder = ResultFolder::begin(target)?;
    prepared.inputs.iter().try_for_each(|(what, path)| folder.input(what, path))?;
    write_matrix(&folder, design, &matrix)?;
    let mut envelope = tables::envelope(&names, &instants, &matrix);
    draws::intervals(flights, &names, &mut envelope)?;
    tables::write_station_loads(&folder, &names, &flown.cases)?;
    folder.write_text("instants.csv", &kept::csv(&flown.cases))?;
    folder.write_text("envelope.csv", &fullaircraft::cases::envelope::envelope_csv(&envelope))?;
    let gusts = gusts::worst(&names, &flown.cases, &matrix);
    folder.write_text("gusts.csv", &gusts::csv(&gusts))?;
    folder.write_text("turbulence.csv", &turbulence::csv(&names, &flown.cases))?;
    folder.write_text("correlation.csv", &turbulence::correlation(&names, &flown.cases))?;
    turbulence::figures(&folder, &along(&flights.stations), flown, &matrix, design)?;
    folder.write_text("selection.csv", &selection.csv())?;
    folder.write_text("selected.csv", &tables::selected(&names, &selection, flown, &matrix, design))?;
    figures::potatoes(&folder, &names, &instants, &selection)?;
    for (name, bytes) in &packed.files {
        folder.write_bytes(&format!("package/{name}"), bytes)?;
    }
    let mut result = LoadsResult::of(plan, &matrix);
    result.failed = flown.failed().map(|(case, model, why)| Failed { case, model, why }).collect();
    result.envelope = envelope;
    result.intervals_from = flights.states.draws.from();
    result.gusts = gusts::of_stations(gusts, &|station| station.ends_with(" root"));
    result.turbulence = turbulence::rows(&names, &flown.cases);
    result.selected = selection.selected.iter().map(Into::into).collect();
    result.round_trip = Some(packed.round_trip);
    result.package = Some("package".to_owned());
    folder.write_json("result.json", &result)?;
    folder.commit_if(result.flown > 0)?;
    Ok((result, line))
}

/// Stations along the right wing: their places and y, m.
fn along(stations: &[Station]) -> Vec<(usize, f64)> {
    let is_wing = |name: &str| name.starts_with("right ") && !name.ends_with(" tail");
    let own = stations.iter().enumerate().filter(|(_, station)| is_wing(&station.name));
    own.map(|(place, station)| (place, station.point.y)).collect()
}

/// A new selection among the station loads of an earlier result; its cards, if they are asked for.
fn select_again(args: &LoadsArgs, from: &Path, select: &Path, common: &Common) -> Result<(), Failure> {
    let target = common.out(args.results());
    let file = SelectFile::read(select)?;
    if let (Some(plan), false) = (&args.plan, args.cards) {
        return Err(InputError::in_file(plan, "a selection among finished cases needs no plan")
            .with_help("leave out --plan, or ask for --cards of the selection")
            .into());
    }
    let (names, instants) = tables::read_station_loads(&from.join("station_loads.csv"))?;
    let selection = loads::select(&file, &names, &instants)?;
    let start = Instant::now();
    let packed = if args.cards { Some(cards_again(args, from, &file, &selection, common)?) } else { None };
    let line = packed.as_ref().map_or_else(String::new, |packed| packed.line(start));
    let folder = ResultFolder::begin(&target)?;
    folder.input("selection", select)?;
    folder.input("station loads", &from.join("station_loads.csv"))?;
    folder.write_text("selection.csv", &selection.csv())?;
    figures::potatoes(&folder, &names, &instants, &selection)?;
    let mut result = LoadsResult::selected_from(&from.display().to_string(), &selection);
    if let Some(packed) = &packed {
        for (name, bytes) in &packed.files {
            folder.write_bytes(&format!("package/{name}"), bytes)?;
        }
        (result.round_trip, result.package) = (Some(packed.round_trip), Some("package".to_owned()));
    }
    folder.write_json("result.json", &result)?;
    let out = folder.commit()?;
    show::summary(common, &format!("{}{line}results in {}\n", result.text(), out.display()));
    show::json(common, &result)
}

/// Cards of a selection among finished cases: loads at grids are not kept, so that the selected cases alone are flown again, and must
/// have the loads at stations that they had.
fn cards_again(
    args: &LoadsArgs,
    from: &Path,
    select: &SelectFile,
    selection: &Selection,
    common: &Common,
) -> Result<Packed, Failure> {
    let own = FullaircraftArgs {
        aircraft: args.aircraft.clone(),
        given: args.given.clone(),
        ..FullaircraftArgs::default()
    };
    let shared = Shared::default();
    let mut prepared = prepared_for_parts(&own, common, &shared)?;
    let plan = plan(args, &prepared)?;
    let design = design(&plan)?;
    prepared.inputs.push(("plan", plan.path.clone()));
    prepared.inputs.push(("selection", select.path.clone()));
    let (maneuvers, matrix) = planned(&prepared, &plan, &design)?;
    kept::check_same(&matrix, from)?;
    let (names, flown) = kept::read(from)?;
    let planned = FromPlan { plan: &plan, design: &design, maneuvers, matrix: &matrix };
    let flights = Flights::new(&prepared, planned, &common.out(args.results()), &shared)?;
    if !names.iter().eq(flights.stations.iter().map(|station| &station.name)) {
        return Err(InputError::in_file(
            from,
            "the stations of these results are not those of the plan and the wing",
        )
        .with_help("name the plan and the wing they were flown with")
        .into());
    }
    let cases: BTreeSet<usize> = selection.selected.iter().map(|one| one.case).collect();
    show::note(&format!("cases flown again for their loads at grids: {}", cases.len()));
    package(&prepared, &flights, &flown, select, selection)
}
