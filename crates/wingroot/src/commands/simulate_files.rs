//! What `simulate` writes: a run's CSV, the curves of its figure as CSV, and the figure.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use maneuver::{Run, Simulated, TimeHistory};
use report::{Figure, Panel, Series, Style};
use serde_json::Value;

use crate::commands::pipeline_figures::paper_figures;
use crate::commands::simulate_flown::Flown;
use crate::corrections::CorrectedWing;
use crate::failure::Failure;
use crate::output::ResultFolder;

/// Channels and labels of the loads.
pub(super) const LOADS: [(&str, &str); 3] =
    [("Fz_N", "Fz (N)"), ("Mx_Nm", "Mx (N m)"), ("My_Nm", "My (N m)")];
/// The updated model with every deflection acting as commanded.
const AS_COMMANDED: &str = "updated, deflections as commanded";

/// What the shaded band is.
const BAND: &str = "updated, 90 % interval";

/// Writes everything and puts it in place.
pub(crate) fn write(
    out: &Path,
    flown: &[Flown],
    corrected: &CorrectedWing,
    result: &Value,
) -> Result<PathBuf, Failure> {
    let folder = ResultFolder::begin(out)?;
    corrected.note_inputs(&folder)?;
    let folders: BTreeSet<&Path> = flown.iter().filter_map(|flight| flight.file.parent()).collect();
    for of_runs in folders {
        folder.input("runs", of_runs)?;
    }
    for flight in flown {
        let name = &flight.run.name;
        let (run, stations) = split(&flight.updated.history);
        folder.write_text(&format!("{name}.csv"), &run.to_csv())?;
        if !stations.channels.is_empty() {
            folder.write_text(&format!("{name}_stations.csv"), &stations.to_csv())?;
        }
        folder.write_text(&format!("{name}_models.csv"), &models(flight).to_csv())?;
        folder.write_figure_of(
            name,
            &paper_figures("simulate", name),
            figure(flight),
            &format!("{name}_models.csv"),
        )?;
    }
    folder.write_json("result.json", result)?;
    folder.commit()
}

/// The columns that a run's file has, and all others: loads at stations and of strips.
fn split(history: &TimeHistory) -> (TimeHistory, TimeHistory) {
    let part = |of_run: bool| TimeHistory {
        t_s: history.t_s.clone(),
        channels: history.channels.iter().filter(|c| Run::has_column(&c.name) == of_run).cloned().collect(),
    };
    (part(true), part(false))
}

/// The curves of a run's figure: inputs, and each load as measured and by each model.
fn models(flown: &Flown) -> TimeHistory {
    let mut curves = TimeHistory { t_s: flown.run.t_s.clone(), channels: Vec::new() };
    let degrees = |values: &[f64]| values.iter().map(|value| value.to_degrees()).collect::<Vec<f64>>();
    curves.push("alpha_deg", degrees(&flown.run.alpha_rad));
    for (name, values) in &flown.run.controls_rad {
        curves.push(format!("delta_{name}_deg"), degrees(values));
    }
    for (c, (channel, _)) in LOADS.into_iter().enumerate() {
        if let Some(loads) = &flown.run.loads {
            curves.push(format!("measured_{channel}"), loads[c].clone());
        }
        let models = [("initial", Some(&flown.initial)), ("updated", Some(&flown.updated))];
        for (model, simulated) in models.into_iter().chain([("as_commanded", flown.as_commanded.as_ref())]) {
            if let Some(values) = simulated.and_then(|simulated| simulated.history.get(channel)) {
                curves.push(format!("{model}_{channel}"), values.to_vec());
            }
        }
        if let Some(spread) = &flown.spread {
            for (end, name) in ["low", "high"].into_iter().enumerate() {
                let values = spread[c].iter().map(|interval| interval[end]).collect();
                curves.push(format!("updated_{name}_{channel}"), values);
            }
        }
    }
    curves
}

/// Loads measured, initial and updated, and what moved the wing.
fn figure(flown: &Flown) -> Figure {
    let t_s = &flown.run.t_s;
    let mut panels = Vec::new();
    for (c, (name, label)) in LOADS.into_iter().enumerate() {
        let of = |simulated: &Simulated| simulated.history.get(name).unwrap_or(&[]).to_vec();
        // the measurement first, so that its noise covers neither model
        let measured = flown.run.loads.as_ref().map(|loads| loads[c].clone());
        let mut series = Vec::new();
        if let Some(spread) = &flown.spread {
            series.extend([0, 1].map(|end| {
                let edge = spread[c].iter().map(|interval| interval[end]).collect();
                Series::new(BAND, t_s.clone(), edge, Style::Edge)
            }));
        }
        series.extend(measured.map(|values| Series::new("measured", t_s.clone(), values, Style::Line)));
        series.push(Series::new("initial", t_s.clone(), of(&flown.initial), Style::DashedLine));
        if let Some(as_commanded) = &flown.as_commanded {
            series.push(Series::new(AS_COMMANDED, t_s.clone(), of(as_commanded), Style::DashedLine));
        }
        series.push(Series::new("updated", t_s.clone(), of(&flown.updated), Style::Line));
        panels.push(Panel::new("", "time (s)", label, series));
    }
    let alpha: Vec<f64> = flown.run.alpha_rad.iter().map(|alpha| alpha.to_degrees()).collect();
    let mut inputs = vec![Series::new("angle of attack", t_s.clone(), alpha, Style::Line)];
    for (name, values) in &flown.run.controls_rad {
        let degrees: Vec<f64> = values.iter().map(|delta| delta.to_degrees()).collect();
        if degrees.iter().any(|delta| *delta != 0.0) {
            inputs.push(Series::new(format!("{name} aileron, commanded"), t_s.clone(), degrees, Style::Line));
        }
    }
    panels.push(Panel::new("", "time (s)", "angle (deg)", inputs));
    Figure::new(format!("{} at {:.1} m/s", flown.run.name, flown.run.v_m_s), panels, 2)
}
