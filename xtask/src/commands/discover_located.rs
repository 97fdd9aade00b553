//! Where simulation and measurements of `discover` disagree: what residuals go with, and the map of their power as CSV.

use std::fmt::Write as _;

use calibrate::Use;
use discover::load_model::LoadModel;
use discover::locate::{Cell, Located, PureError, Residuals, map, regressors};
use discover::simulator::Simulator;
use maneuver::effects::Active;
use serde_json::{Value, json};

use crate::commands::discover::Discovered;

/// So many regressors are listed.
const LISTED: usize = 12;
/// Less than this of a channel's residual is no finding.
const LEAST_SHARE: f64 = 0.01;
/// Nor is what chance does more often.
const CHANCE: f64 = 0.05;

/// Residuals of training data as a simulator flies it with effects.
fn residuals(found: &Discovered<'_>, (simulator, effects): (&Simulator, &[Active])) -> Residuals {
    let prepared = found.prepared;
    let all: Vec<usize> = (0..prepared.data.statics.len() + prepared.data.runs.len()).collect();
    let flown = simulator.fly(&simulator.models(effects, None), effects, &all);
    let coefficient = |airspeed: usize, channel: usize, hz: f64| prepared.noise.sigma(airspeed, channel, hz);
    let error =
        PureError { coefficient: &coefficient, point: prepared.noise.point, degrees_of_freedom: None };
    let controls: Vec<String> = found.corrected.wing.controls.iter().map(|c| c.name.clone()).collect();
    Residuals::new(&prepared.data, &flown, &error, &controls, Some(Use::Train))
}

/// `located` of result.json: what the residual goes with before any effect. Families of deflections are judged on all training
/// data, the others where the controls rest, if there is such: a large residual of theirs would hide the rest.
pub(crate) fn json(found: &Discovered<'_>) -> Vec<Value> {
    let all = residuals(found, found.before());
    let mut resting = all.clone();
    resting.units.retain(|unit| {
        unit.stimulus
            .inputs
            .controls_rad
            .iter()
            .all(|control| control.iter().all(|delta| *delta == control[0]))
    });
    let of_controls = |l: &Located| l.regressor.contains("delta");
    let mut listed = regressors(&all);
    if !resting.units.is_empty() {
        listed.retain(of_controls);
        listed.extend(regressors(&resting).into_iter().filter(|l| !of_controls(l)));
        listed.sort_by(|a, b| b.share_of_residual.total_cmp(&a.share_of_residual));
    }
    let told = |l: &&Located| l.share_of_residual >= LEAST_SHARE && l.p_value <= CHANCE;
    let entry = |l: &Located| {
        json!({ "channel": l.channel, "regressor": l.regressor, "share_of_residual": l.share_of_residual,
            "p_value": l.p_value, "where": l.place })
    };
    listed.iter().filter(told).take(LISTED).map(entry).collect()
}

/// A cell of the map before, and its power after.
pub(crate) struct BeforeAfter {
    before: Cell,
    after: f64,
}

/// The map before and after, the largest power before first.
pub(crate) fn maps(found: &Discovered<'_>) -> Vec<BeforeAfter> {
    let after = map(&residuals(found, found.after()));
    let of = |cell: &Cell| {
        let same = |other: &&Cell| {
            (other.channel, &other.maneuver, other.band) == (cell.channel, &cell.maneuver, cell.band)
        };
        after.iter().find(same).map_or(f64::NAN, |other| other.power)
    };
    map(&residuals(found, found.before()))
        .into_iter()
        .map(|before| BeforeAfter { after: of(&before), before })
        .collect()
}

/// The map as CSV.
pub(crate) fn map_csv(bands_hz: &[(f64, f64)], cells: &[BeforeAfter]) -> String {
    let mut text = String::from("model,channel,maneuver,from_hz,to_hz,power,limit,rows,units\n");
    for model in ["before", "after"] {
        for BeforeAfter { before, after } in cells {
            let Cell { channel, maneuver, band, power, limit, rows, units } = before;
            let (from, to) = bands_hz[*band];
            let power = if model == "before" { power } else { after };
            let _ = writeln!(
                text,
                "{model},{channel},\"{maneuver}\",{from},{to},{power:.3},{limit:.3},{rows},{units}"
            );
        }
    }
    text
}

/// The map as `result.json` has it.
pub(crate) fn map_json(bands_hz: &[(f64, f64)], cells: &[BeforeAfter]) -> Vec<Value> {
    let entry = |cell: &BeforeAfter| {
        let Cell { channel, maneuver, band, power, limit, .. } = &cell.before;
        let (from, to) = bands_hz[*band];
        json!({ "channel": channel, "maneuver": maneuver, "from_hz": from, "to_hz": to,
            "before": power, "after": cell.after, "limit": limit })
    };
    cells.iter().map(entry).collect()
}
