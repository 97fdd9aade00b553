//! Pictures of `discover`: held-out runs before and after, with what is uncertain about the model after.

use std::fmt::Write as _;

use calibrate::Use;
use discover::bands::Banded;
use discover::finding::Finding;
use report::{Figure, Panel, Series, Style};

use crate::failure::Failure;
use crate::output::ResultFolder;

const CHANNELS: [(&str, &str); 3] = [("Fz_N", "Fz (N)"), ("Mx_Nm", "Mx (N m)"), ("My_Nm", "My (N m)")];
/// Name of the band.
const BAND_NAME: &str = "after: 2 standard deviations to either side";
/// A held-out run.
struct Shown<'a> {
    name: &'a str,
    t_s: Vec<f64>,
    /// Places of the loads that the runs have.
    channels: Vec<usize>,
    measured: &'a [Vec<f64>; 3],
    flown: Banded,
}

/// Writes a picture and a CSV for every held-out run.
pub(crate) fn write(finding: &Finding<'_>, results: &ResultFolder) -> Result<(), Failure> {
    let data = &finding.prepared.data;
    let held_out: Vec<usize> = (0..data.runs.len()).filter(|i| data.runs[*i].usage == Use::Holdout).collect();
    if held_out.is_empty() {
        return Ok(());
    }
    let effects = &finding.report.current.effects;
    for flown in finding.prepared.bands(finding.simulator_after(), effects, &held_out) {
        let run = &data.runs[flown.run];
        let dt = run.stimulus.time_step_s;
        let shown = Shown {
            name: &run.name,
            t_s: (0..run.measured[0].len()).map(|k| k as f64 * dt).collect(),
            channels: (0..3).filter(|&c| data.run_loads[c]).collect(),
            measured: &run.measured,
            flown,
        };
        let name = format!("runs/{}", run.name);
        results.write_text(&format!("{name}.csv"), &csv(&shown))?;
        results.write_figure_of(&name, "", figure(&shown), &format!("{name}.csv"))?;
    }
    Ok(())
}

fn csv(shown: &Shown<'_>) -> String {
    let flown = &shown.flown;
    let mut text = String::from("t_s");
    for &c in &shown.channels {
        let name = CHANNELS[c].0;
        let _ = write!(text, ",{name}_measured,{name}_before,{name}_after,{name}_low,{name}_high");
    }
    text.push('\n');
    for (i, t) in shown.t_s.iter().enumerate() {
        let _ = write!(text, "{t:.4}");
        for &c in &shown.channels {
            let (before, after, half) = (flown.before.loads[c][i], flown.after.loads[c][i], flown.half[c][i]);
            let (low, high) = (after - half, after + half);
            let _ = write!(text, ",{:.4},{before:.4},{after:.4},{low:.4},{high:.4}", shown.measured[c][i]);
        }
        text.push('\n');
    }
    text
}

fn figure(shown: &Shown<'_>) -> Figure {
    let flown = &shown.flown;
    let line = |label: &str, values: Vec<f64>, style| Series::new(label, shown.t_s.clone(), values, style);
    let panel = |&c: &usize| {
        let edge = |sign: f64| {
            flown.after.loads[c].iter().zip(&flown.half[c]).map(|(after, half)| after + sign * half).collect()
        };
        Panel::new(
            "",
            "time (s)",
            CHANNELS[c].1,
            vec![
                line(BAND_NAME, edge(-1.0), Style::Edge),
                line(BAND_NAME, edge(1.0), Style::Edge),
                line("measured", shown.measured[c].clone(), Style::Line),
                line("before", flown.before.loads[c].clone(), Style::DashedLine),
                line("after", flown.after.loads[c].clone(), Style::Line),
            ],
        )
    };
    Figure::new(
        format!("{}: held out, before and after", shown.name),
        shown.channels.iter().map(panel).collect(),
        1,
    )
}
