//! `fullaircraft`: trim, pull-up, push-down, chirp and doublet of the full aircraft, initial beside updated model.

use std::path::PathBuf;
use std::time::Instant;

use coupling::Geometry;
use fullaircraft::{
    Aircraft, AircraftError, BentNumbers, Comparison, Derivatives, LargeFlight, ModelNumbers, Summary,
};
use maneuver::AirModel;
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::Value;

use crate::args::Common;
use crate::commands::fullaircraft_derivatives as derivatives;
use crate::commands::fullaircraft_figures as figures;
use crate::commands::fullaircraft_prepared::{Assembled, FullaircraftArgs, Prepared, assembled, prepared};
use crate::commands::result_parts::as_json;
use crate::commands::{fullaircraft_cases, fullaircraft_deck};
use crate::ensemble::{Intervals, intervals};
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;
use crate::store::Shared;

impl From<AircraftError> for Failure {
    fn from(error: AircraftError) -> Self {
        match error {
            AircraftError::Input(input) => Self::Input(input),
            AircraftError::Coupling(coupling) => coupling.into(),
            other => Self::computation(other),
        }
    }
}

/// `result.json` of `fullaircraft`.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct FullaircraftResult {
    /// Both models.
    #[serde(flatten)]
    pub(crate) summary: Summary,
    /// What is not certain of the updated model; null without an ensemble of wings beside the corrections.
    pub(crate) intervals_90: Option<Intervals>,
    /// Steady flight with large deflections beside small ones, of the wing without an interval; absent if deflections are small.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) large_deflections: Option<LargeFlight>,
}

/// What intervals are of.
#[derive(Serialize)]
struct Updated<'a> {
    model: ModelNumbers,
    derivatives: &'a Derivatives,
}

/// Samples of a history to a row of its file: 500 rows a second.
const CSV_EVERY: usize = 2;

/// Runs the command.
pub(crate) fn run(args: &FullaircraftArgs, common: &Common) -> Result<(), Failure> {
    if let Some(cases) = &args.cases {
        return fullaircraft_cases::run(cases, args, common);
    }
    if let Some(deck) = &args.deck {
        return fullaircraft_deck::run(deck, common);
    }
    let start = Instant::now();
    let Prepared { aircraft, found, corrections, effects, wing, inputs } = prepared(args, common)?;
    for remark in effects.remarks(&aircraft.file).iter().filter(|_| !common.quiet) {
        show::note(remark);
    }
    let air = wing.shared_air(&aircraft.flow, AirModel::default())?;
    let aircraft = aircraft.in_air(air.clone());
    let found = found.map(|found| found.in_air(air.clone()));
    let comparison = effects.compare(&aircraft, found.as_ref(), &corrections)?;
    let is_large = args.nonlinear || wing.file.geometry == Geometry::Nonlinear;
    let large = || aircraft.large_flight(found.as_ref(), &corrections, &comparison);
    let large = is_large.then(large).transpose()?;
    let members = wing.with_each_in_flight(|member| {
        let Assembled { aircraft, corrections, effects } =
            assembled(aircraft.file.clone(), member, &Shared::default())?;
        let flown = effects.fly(&aircraft.in_air(air.clone()), &corrections)?;
        as_json(&Updated { model: flown.numbers(), derivatives: &flown.derivatives })
    })?;
    let updated = &comparison.updated;
    let updated = as_json(&Updated { model: updated.numbers(), derivatives: &updated.derivatives })?;
    let summary = FullaircraftResult {
        intervals_90: wing
            .intervals_from()
            .map(|from| Intervals { from, of_updated: intervals(&updated, &members) }),
        large_deflections: large,
        summary: comparison.summary(&aircraft, start.elapsed().as_secs_f64()),
    };
    let folder = ResultFolder::begin(&common.out(args.results()))?;
    inputs.iter().try_for_each(|(what, path)| folder.input(what, path))?;
    let out = write(folder, &aircraft, &comparison, &summary)?;
    let Summary { warnings, derivatives, correction_airspeed_m_s, boxes, seconds, .. } = &summary.summary;
    for warning in warnings {
        if !common.quiet {
            show::note(warning);
        }
    }
    let text = format!(
        "{}\n{}{}\ncorrections at {correction_airspeed_m_s} m/s: {}\n{boxes} boxes, {seconds:.2} s; results in {}\n",
        table(&summary)?,
        summary.large_deflections.as_ref().map_or_else(String::new, large_table),
        derivatives::table(derivatives),
        wing.origin,
        out.display()
    );
    show::summary(common, &text);
    show::json(common, &summary)
}

fn write(
    folder: ResultFolder,
    aircraft: &Aircraft,
    comparison: &Comparison,
    summary: &FullaircraftResult,
) -> Result<PathBuf, Failure> {
    for (model, flown) in [("initial", &comparison.initial), ("updated", &comparison.updated)] {
        let histories =
            [("doublet", Some(&flown.doublet)), ("chirp", Some(&flown.chirp)), ("gust", flown.gust.as_ref())];
        for (name, history) in histories.into_iter().filter_map(|(name, history)| Some((name, history?))) {
            folder.write_text(&format!("{name}_{model}.csv"), &history.csv_every(CSV_EVERY))?;
        }
        for (name, trimmed) in
            [("trim", &flown.trim), ("pull_up", &flown.pull_up), ("push_down", &flown.push_down)]
        {
            folder.write_text(&format!("{name}_{model}.vtu"), &figures::vtu(aircraft, trimmed))?;
        }
    }
    figures::write(&folder, aircraft, comparison)?;
    if let Some(limits) = aircraft.file.lift_limits()? {
        let envelope = aircraft.envelope(&limits);
        folder.write_text("envelope.csv", &envelope.csv())?;
        let drawn = figures::envelope(aircraft, &envelope);
        folder.write_figure_of("envelope", "Figure 20 of the paper.", drawn, "envelope.csv")?;
    }
    folder.write_json("result.json", summary)?;
    folder.commit()
}

/// Rows of the table: words, where the number stands in a model's numbers, digits behind the point.
const ROWS: [(&str, &str, usize); 15] = [
    ("alpha (deg)", "/trim/alpha_deg", 2),
    ("elevator (deg)", "/trim/elevator_deg", 2),
    ("tip deflection (m)", "/trim/tip_deflection_m", 3),
    ("alpha (deg)", "/pull_up/alpha_deg", 2),
    ("elevator (deg)", "/pull_up/elevator_deg", 2),
    ("tip deflection (m)", "/pull_up/tip_deflection_m", 3),
    ("alpha (deg)", "/push_down/alpha_deg", 2),
    ("elevator (deg)", "/push_down/elevator_deg", 2),
    ("tip deflection (m)", "/push_down/tip_deflection_m", 3),
    ("peak tip acceleration (m/s2)", "/doublet/peak_tip_acceleration_m_s2", 1),
    ("peak tip rate (deg/s)", "/doublet/peak_tip_rate_deg_s", 1),
    ("peak tip acceleration (m/s2)", "/chirp/peak_tip_acceleration_m_s2", 1),
    ("peak tip rate (deg/s)", "/chirp/peak_tip_rate_deg_s", 1),
    ("largest load factor", "/gust/peak_load_factor", 2),
    ("largest right root Mx (N m)", "/gust/peak_right_root_Mx_Nm", 1),
];

/// Both models, and the interval of the updated one where there are wings to tell it.
fn table(result: &FullaircraftResult) -> Result<report::Table, Failure> {
    let models = as_json(&result.summary.models)?;
    let spread = result.intervals_90.as_ref().map(|intervals| &intervals.of_updated);
    let mut head = vec!["", "initial", "updated"];
    head.extend(spread.map(|_| "90 % interval"));
    let mut table = report::Table::new(&head);
    let mut before = "";
    for (words, place, digits) in ROWS {
        let number = |model: &str| models.pointer(&format!("/{model}{place}")).and_then(Value::as_f64);
        let (Some(initial), Some(updated)) = (number("initial"), number("updated")) else { continue };
        let maneuver = place.split('/').nth(1).unwrap_or_default();
        let same = std::mem::replace(&mut before, maneuver) == maneuver;
        let name = if same { "    ".to_owned() } else { maneuver_name(maneuver, &models) };
        let mut cells =
            vec![format!("{name}{words}"), format!("{initial:.digits$}"), format!("{updated:.digits$}")];
        if let Some(spread) = spread {
            let ends = spread.pointer(&format!("/model{place}"));
            let end = |i: usize| ends.and_then(|ends| ends.get(i)).and_then(Value::as_f64);
            cells.push(match (end(0), end(1)) {
                (Some(low), Some(high)) => format!("{low:.digits$} to {high:.digits$}"),
                _ => String::new(),
            });
        }
        table.row(cells);
    }
    Ok(table)
}

/// Steady flight in both geometries, for the console.
fn large_table(flight: &LargeFlight) -> String {
    let mut table = report::Table::new(&[
        "large deflections (linear)",
        "alpha (deg)",
        "elevator (deg)",
        "tip (m)",
        "spread (m)",
        "right root Mx (N m)",
    ]);
    for (model, points) in [("initial", &flight.initial), ("updated", &flight.updated)] {
        for point in points {
            let cell = |of: &dyn Fn(&BentNumbers) -> f64, digits: usize| {
                format!("{:.digits$} ({:.digits$})", of(&point.large), of(&point.linear))
            };
            table.row(vec![
                format!("{model}, {}, n = {}", point.name.replace('_', "-"), point.load_factor),
                cell(&|numbers| numbers.alpha_deg, 2),
                cell(&|numbers| numbers.elevator_deg, 2),
                cell(&|numbers| numbers.tip_deflection_m, 3),
                cell(&|numbers| numbers.spread_m, 3),
                cell(&|numbers| numbers.right_root_mx_nm, 2),
            ]);
        }
    }
    format!("{table}\n")
}

/// A maneuver's name for the table; steady points with airspeed and load factor.
fn maneuver_name(maneuver: &str, models: &Value) -> String {
    let number = |what: &str| models.pointer(&format!("/initial/{maneuver}/{what}")).and_then(Value::as_f64);
    let name = maneuver.replace('_', "-");
    match (number("V_m_s"), number("load_factor")) {
        (Some(v_m_s), Some(load_factor)) => format!("{name}, {v_m_s} m/s, n = {load_factor}: "),
        _ => format!("{name}: "),
    }
}
