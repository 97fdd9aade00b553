//! Where simulation and measurements of `discover` disagree: what residuals go with, and the map of their power as CSV.

use std::fmt::Write as _;

use calibrate::Use;
use discover::locate::{BANDS_HZ, Cell, Located, PureError, Residuals, map, regressors};
use maneuver::effects::Active;
use serde_json::{Value, json};

use crate::commands::discover::Discovered;

/// So many regressors are listed.
const LISTED: usize = 12;
/// Less than this of a channel's residual is no finding.
const LEAST_SHARE: f64 = 0.01;
/// Nor is what chance does more often.
const CHANCE: f64 = 0.05;

/// Residuals of training data, with effects or without.
fn residuals(found: &Discovered<'_>, effects: &[Active]) -> Residuals {
    let prepared = found.prepared;
    let all: Vec<usize> = (0..prepared.data.statics.len() + prepared.data.runs.len()).collect();
    let models = prepared.simulator.models(effects, Some(&found.report.level.models));
    let flown = prepared.simulator.fly(&models, effects, &all);
    let coefficient = |airspeed: usize, channel: usize, hz: f64| prepared.noise.sigma(airspeed, channel, hz);
    let error =
        PureError { coefficient: &coefficient, point: prepared.noise.point, degrees_of_freedom: None };
    let controls: Vec<String> = found.corrected.wing.controls.iter().map(|c| c.name.clone()).collect();
    Residuals::new(&prepared.data, &flown, &error, &controls, Some(Use::Train))
}

/// `located` of result.json: what the residual goes with before any effect. Families of deflections are judged on all training
/// data, the others where the controls rest, if there is such: a large residual of theirs would hide the rest.
pub(crate) fn json(found: &Discovered<'_>) -> Vec<Value> {
    let all = residuals(found, &[]);
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

/// The map before and after.
pub(crate) fn map_csv(found: &Discovered<'_>) -> String {
    let mut text = String::from("model,channel,maneuver,from_hz,to_hz,power,limit,rows,units\n");
    let none: &[Active] = &[];
    for (model, effects) in [("before", none), ("after", &found.report.level.effects)] {
        for cell in map(&residuals(found, effects)) {
            let Cell { channel, maneuver, band, power, limit, rows, units } = cell;
            let (from, to) = BANDS_HZ[band];
            let _ = writeln!(
                text,
                "{model},{channel},\"{maneuver}\",{from},{to},{power:.3},{limit:.3},{rows},{units}"
            );
        }
    }
    text
}
