//! Figures 8 to 18 of the paper on flexible wings, gathered from the steps of the pipeline under their numbers: a picture each,
//! and its curves as CSV.

use std::path::Path;

use nastran::table::Table;
use report::{Figure, Panel, Series, Style};
use serde_json::{Value, json};

use crate::failure::Failure;
use crate::output::ResultFolder;

/// A figure's number, what it shows, its picture and its curves in the folders of the steps.
const FIGURES: [(u32, &str, &str, &str); 11] = [
    (8, "root loads over the angle of attack", "calibrate/static_loads.svg", "calibrate/static_loads.csv"),
    (9, "pitch at 0.5 Hz", "simulate/aoa_0p5hz_30.svg", "simulate/aoa_0p5hz_30_models.csv"),
    (10, "pitch at 2 Hz", "simulate/aoa_2hz_30.svg", "simulate/aoa_2hz_30_models.csv"),
    (11, "pitch at 4 Hz", "simulate/aoa_4hz_30.svg", "simulate/aoa_4hz_30_models.csv"),
    (12, "doublet of 5 degrees", "simulate/doublet_inner_5_30.svg", "simulate/doublet_inner_5_30_models.csv"),
    (
        13,
        "doublet of 15 degrees",
        "simulate/doublet_inner_15_30.svg",
        "simulate/doublet_inner_15_30_models.csv",
    ),
    (
        14,
        "doublet of 25 degrees",
        "simulate/doublet_inner_25_30.svg",
        "simulate/doublet_inner_25_30_models.csv",
    ),
    (15, "equivalent deflections", "deflection/equivalent.svg", "deflection/deflection.csv"),
    (16, "deflection corrections", "deflection/factors.svg", "deflection/deflection.csv"),
    (17, "chirp of 5 degrees", "simulate/chirp_inner_5_30.svg", "simulate/chirp_inner_5_30_models.csv"),
    (18, "chirp near the first bending", DETAIL, "simulate/chirp_inner_5_30_models.csv"),
];
/// In place of a picture: a part of the curves is drawn.
const DETAIL: &str = "";
/// That part, s: the chirp passes 4 to 6 Hz.
const DETAIL_S: (f64, f64) = (12.5, 18.5);

/// Copies pictures and curves to `figure_NN.svg` and `.csv`; the list of them.
pub(crate) fn gather(base: &Path, folder: &ResultFolder) -> Result<Value, Failure> {
    let mut list = Vec::new();
    for (number, shows, picture, curves) in FIGURES {
        let [svg, csv] = ["svg", "csv"].map(|ending| format!("figure_{number:02}.{ending}"));
        let text = nastran::read_text(&base.join(curves))?;
        folder.write_text(&csv, &text)?;
        let picture = match picture {
            DETAIL => detail(&base.join(curves), shows)?,
            picture => nastran::read_text(&base.join(picture))?,
        };
        folder.write_text(&svg, &picture)?;
        list.push(json!({ "figure": number, "shows": shows, "picture": svg, "curves": csv }));
    }
    Ok(Value::Array(list))
}

/// Loads of a run within [`DETAIL_S`], as measured and by each model.
fn detail(curves: &Path, title: &str) -> Result<String, Failure> {
    let table = Table::read(curves)?;
    let t_s = table.numbers("t_s")?;
    let inside: Vec<usize> =
        (0..table.len()).filter(|&row| (DETAIL_S.0..=DETAIL_S.1).contains(&t_s[row])).collect();
    let within = |values: &[f64]| inside.iter().map(|&row| values[row]).collect::<Vec<f64>>();
    let mut panels = Vec::new();
    for (channel, label) in [("Fz_N", "Fz (N)"), ("Mx_Nm", "Mx (N m)"), ("My_Nm", "My (N m)")] {
        let mut series = Vec::new();
        for (model, style) in
            [("measured", Style::Line), ("initial", Style::DashedLine), ("updated", Style::Line)]
        {
            let values = table.numbers(&format!("{model}_{channel}"))?;
            series.push(Series::new(model, within(&t_s), within(&values), style));
        }
        panels.push(Panel {
            title: String::new(),
            x_label: "time (s)".into(),
            y_label: label.into(),
            series,
        });
    }
    Figure { title: title.into(), panels, columns: 2 }.svg().map_err(Failure::computation)
}
