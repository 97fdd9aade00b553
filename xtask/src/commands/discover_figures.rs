//! Pictures of `discover`: held-out runs before and after, and the candidates' evidence as CSV.

use std::fmt::Write as _;

use maneuver::effects::Flown;
use report::{Figure, Panel, Series, Style};

use crate::commands::discover::{Discovered, is_held_out};
use crate::failure::Failure;
use crate::output::ResultFolder;

const CHANNELS: [(&str, &str); 3] = [("Fz_N", "Fz (N)"), ("Mx_Nm", "Mx (N m)"), ("My_Nm", "My (N m)")];

/// Writes a picture and a CSV for every held-out run.
pub(crate) fn write(found: &Discovered<'_>, results: &ResultFolder) -> Result<(), Failure> {
    let (data, simulator) = (&found.prepared.data, &found.prepared.simulator);
    let level = &found.report.level;
    let first = data.statics.len();
    let held_out: Vec<usize> = (0..data.runs.len()).filter(|i| is_held_out(data.runs[*i].usage)).collect();
    let places: Vec<usize> = held_out.iter().map(|i| first + i).collect();
    let before = simulator.fly(&simulator.models(&[], None), &[], &places);
    let after = simulator.fly(&level.models, &level.effects, &places);
    for ((&i, before), after) in held_out.iter().zip(&before).zip(&after) {
        let run = &data.runs[i];
        let dt = run.stimulus.time_step_s;
        let t_s: Vec<f64> = (0..run.measured[0].len()).map(|k| k as f64 * dt).collect();
        results.write_text(&format!("runs/{}.csv", run.name), &csv(&t_s, &run.measured, before, after))?;
        let figure = figure(&run.name, &t_s, &run.measured, before, after);
        let name = format!("runs/{}", run.name);
        results.write_figure_of(&name, "", figure, &format!("{name}.csv"))?;
    }
    Ok(())
}

fn csv(t_s: &[f64], measured: &[Vec<f64>; 3], before: &Flown, after: &Flown) -> String {
    let mut text = String::from("t_s");
    for (name, _) in CHANNELS {
        let _ = write!(text, ",{name}_measured,{name}_before,{name}_after");
    }
    text.push('\n');
    for (i, t) in t_s.iter().enumerate() {
        let _ = write!(text, "{t:.4}");
        for (c, measured) in measured.iter().enumerate() {
            let _ = write!(text, ",{:.4},{:.4},{:.4}", measured[i], before.loads[c][i], after.loads[c][i]);
        }
        text.push('\n');
    }
    text
}

fn figure(name: &str, t_s: &[f64], measured: &[Vec<f64>; 3], before: &Flown, after: &Flown) -> Figure {
    let line = |label: &str, values: &[f64], style| Series::new(label, t_s.to_vec(), values.to_vec(), style);
    let panel = |c: usize| Panel {
        title: String::new(),
        x_label: "time (s)".into(),
        y_label: CHANNELS[c].1.into(),
        series: vec![
            line("measured", &measured[c], Style::Line),
            line("before", &before.loads[c], Style::DashedLine),
            line("after", &after.loads[c], Style::Line),
        ],
    };
    Figure {
        title: format!("{name}: held out, before and after"),
        columns: 1,
        panels: (0..3).map(panel).collect(),
    }
}
