//! `fullaircraft`: trim, pull-up, push-down, chirp and doublet of the full aircraft, initial beside updated model.

use std::path::PathBuf;
use std::time::Instant;

use fullaircraft::{Aircraft, AircraftError, Comparison, Summary};

use crate::args::Common;
use crate::commands::fullaircraft_derivatives as derivatives;
use crate::commands::fullaircraft_figures as figures;
use crate::commands::fullaircraft_prepared::{FullaircraftArgs, Prepared, prepared};
use crate::commands::{fullaircraft_cases, fullaircraft_deck};
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;

impl From<AircraftError> for Failure {
    fn from(error: AircraftError) -> Self {
        match error {
            AircraftError::Input(input) => Self::Input(input),
            AircraftError::Coupling(coupling) => coupling.into(),
            other => Self::computation(other),
        }
    }
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
    let Prepared { aircraft, corrections, effects, origin, inputs } = prepared(args, common)?;
    for remark in effects.remarks(&aircraft.file).iter().filter(|_| !common.quiet) {
        show::note(remark);
    }
    let comparison = effects.compare(&aircraft, &corrections)?;
    let summary = comparison.summary(&aircraft, start.elapsed().as_secs_f64());
    let folder = ResultFolder::begin(&common.out(args.results()))?;
    inputs.iter().try_for_each(|(what, path)| folder.input(what, path))?;
    let out = write(folder, &aircraft, &comparison, &summary)?;
    for warning in &summary.warnings {
        if !common.quiet {
            show::note(warning);
        }
    }
    let text = format!(
        "{}\n{}\ncorrections at {} m/s: {origin}\n{} boxes, {:.2} s; results in {}\n",
        table(&summary),
        derivatives::table(&summary.derivatives),
        summary.correction_airspeed_m_s,
        summary.boxes,
        summary.seconds,
        out.display()
    );
    show::summary(common, &text);
    show::json(common, &summary)
}

fn write(
    folder: ResultFolder,
    aircraft: &Aircraft,
    comparison: &Comparison,
    summary: &Summary,
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

fn table(summary: &Summary) -> report::Table {
    let mut table = report::Table::new(&["", "initial", "updated"]);
    let mut row = |what: String, before: f64, after: f64, places: usize| {
        table.row([what, format!("{before:.places$}"), format!("{after:.places$}")]);
    };
    let (initial, updated) = (&summary.models.initial, &summary.models.updated);
    for (name, before, after) in [
        ("trim", &initial.trim, &updated.trim),
        ("pull-up", &initial.pull_up, &updated.pull_up),
        ("push-down", &initial.push_down, &updated.push_down),
    ] {
        let what = format!("{name}, {} m/s, n = {}: alpha (deg)", before.v_m_s, before.load_factor);
        row(what, before.alpha_deg, after.alpha_deg, 2);
        row("    elevator (deg)".into(), before.elevator_deg, after.elevator_deg, 2);
        row("    tip deflection (m)".into(), before.tip_deflection_m, after.tip_deflection_m, 3);
    }
    for (name, before, after) in
        [("doublet", &initial.doublet, &updated.doublet), ("chirp", &initial.chirp, &updated.chirp)]
    {
        let accelerations = [before, after].map(|flown| flown.peak_tip_acceleration_m_s2);
        row(format!("{name}: peak tip acceleration (m/s2)"), accelerations[0], accelerations[1], 1);
        row("    peak tip rate (deg/s)".into(), before.peak_tip_rate_deg_s, after.peak_tip_rate_deg_s, 1);
    }
    if let (Some(before), Some(after)) = (&initial.gust, &updated.gust) {
        row("gust: largest load factor".into(), before.peak_load_factor, after.peak_load_factor, 2);
        let moments = [before, after].map(|flown| flown.peak_right_root_mx_nm);
        row("    largest right root Mx (N m)".into(), moments[0], moments[1], 1);
    }
    table
}
