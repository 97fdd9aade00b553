//! Figures 8 to 18 of the paper on flexible wings, gathered from the steps of the pipeline under their numbers: pictures drawn
//! from the steps' curves, and these as CSV.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use nastran::table::Table;
use report::{Figure, Panel, Series, Style};

use crate::commands::pipeline_result::{HeldOutRun, PaperFigure};
use crate::failure::Failure;
use crate::output::ResultFolder;

/// A figure's number, what it shows, and its curves in the folders of the steps.
const FIGURES: [(u32, &str, &str); 11] = [
    (8, "root loads over the angle of attack", "calibrate/static_loads.csv"),
    (9, "pitch at 0.5 Hz", "simulate/aoa_0p5hz_30_models.csv"),
    (10, "pitch at 2 Hz", "simulate/aoa_2hz_30_models.csv"),
    (11, "pitch at 4 Hz", "simulate/aoa_4hz_30_models.csv"),
    (12, "doublet of 5 degrees", "simulate/doublet_inner_5_30_models.csv"),
    (13, "doublet of 15 degrees", "simulate/doublet_inner_15_30_models.csv"),
    (14, "doublet of 25 degrees", "simulate/doublet_inner_25_30_models.csv"),
    (EQUIVALENT, "equivalent deflections", "deflection/deflection.csv"),
    (16, "deflection corrections", "deflection/deflection.csv"),
    (17, "chirp of 5 degrees", "simulate/chirp_inner_5_30_models.csv"),
    (DETAIL, "chirp near the first bending", "simulate/chirp_inner_5_30_models.csv"),
];
/// The figure of equivalent deflections.
const EQUIVALENT: u32 = 15;
/// The figure of a part of a run.
const DETAIL: u32 = 18;
/// That part, s: the chirp passes 4 to 6 Hz.
const DETAIL_S: (f64, f64) = (12.5, 18.5);

/// A sentence that says which figures of the paper show a run or result of a step; empty if none does.
pub(crate) fn paper_figures(step: &str, name: &str) -> String {
    let numbers: Vec<String> = FIGURES
        .iter()
        .filter(|(.., curves)| *curves == format!("{step}/{name}_models.csv"))
        .map(|(number, ..)| number.to_string())
        .collect();
    match &numbers[..] {
        [] => String::new(),
        [one] => format!("Figure {one} of the paper."),
        more => format!("Figures {} of the paper.", more.join(" and ")),
    }
}

/// Writes pictures and curves as `figure_NN.svg`, `.png` and `.csv`; the list of them.
pub(crate) fn gather(base: &Path, folder: &ResultFolder) -> Result<Vec<PaperFigure>, Failure> {
    let mut list = Vec::new();
    for (number, shows, curves) in FIGURES {
        let name = format!("figure_{number:02}");
        let [svg, csv] = ["svg", "csv"].map(|ending| format!("{name}.{ending}"));
        folder.write_text(&csv, &nastran::read_text(&base.join(curves))?)?;
        let title = format!("Figure {number}: {shows}");
        let table = Table::read(&base.join(curves))?;
        let figure = if table.has("t_s") {
            history(&table, &title, (number == DETAIL).then_some(DETAIL_S))?
        } else if table.has("alpha_deg") {
            loads(&table, &title)?
        } else {
            factors(&table, &title, if number == EQUIVALENT { "equivalent_deg" } else { "factor" })?
        };
        folder.write_figure_of(&name, "", figure, &csv)?;
        list.push(PaperFigure { figure: number, shows: shows.to_owned(), picture: svg, curves: csv });
    }
    Ok(list)
}

/// What is left of each run that `discover` held out, before and after: root mean squares by load.
pub(crate) fn held_out(base: &Path) -> Result<Vec<HeldOutRun>, Failure> {
    let folder = base.join("discover/runs");
    let mut files: Vec<PathBuf> =
        std::fs::read_dir(&folder).into_iter().flatten().flatten().map(|entry| entry.path()).collect();
    files.retain(|file| file.extension().is_some_and(|ending| ending == "csv"));
    files.sort();
    let left = |table: &Table, state: &str| -> Result<BTreeMap<String, f64>, Failure> {
        let mut rms = BTreeMap::new();
        for (load, _) in LOADS.into_iter().filter(|(load, _)| table.has(&format!("{load}_measured"))) {
            let of = |what: &str| table.numbers(&format!("{load}_{what}"));
            let squares = of("measured")?.iter().zip(of(state)?).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
            rms.insert(load.to_owned(), (squares / table.len().max(1) as f64).sqrt());
        }
        Ok(rms)
    };
    let run = |file: PathBuf| -> Result<HeldOutRun, Failure> {
        let table = Table::read(&file)?;
        let run = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        Ok(HeldOutRun { run, before: left(&table, "before")?, after: left(&table, "after")? })
    };
    files.into_iter().map(run).collect()
}

/// Channels with their labels.
const LOADS: [(&str, &str); 3] = [("Fz_N", "Fz (N)"), ("Mx_Nm", "Mx (N m)"), ("My_Nm", "My (N m)")];

/// Loads of a run as measured and by each model, and what moved the wing; all of it or the part between two times.
fn history(table: &Table, title: &str, part_s: Option<(f64, f64)>) -> Result<Figure, Failure> {
    let t_s = table.numbers("t_s")?;
    let inside: Vec<usize> = (0..table.len())
        .filter(|&row| part_s.is_none_or(|(from, to)| (from..=to).contains(&t_s[row])))
        .collect();
    let within = |values: &[f64]| inside.iter().map(|&row| values[row]).collect::<Vec<f64>>();
    let series = |name: &str, column: &str, style| -> Result<Series, Failure> {
        Ok(Series::new(name, within(&t_s), within(&table.numbers(column)?), style))
    };
    let models = [
        ("measured", "measured", Style::Line),
        ("initial", "initial", Style::DashedLine),
        ("updated, deflections as commanded", "as_commanded", Style::DashedLine),
        ("updated", "updated", Style::Line),
    ];
    let mut panels = Vec::new();
    for (channel, label) in LOADS {
        let there = |model: &str| table.has(&format!("{model}_{channel}"));
        let curves = models.into_iter().filter(|(_, model, _)| there(model));
        let curves = curves
            .map(|(name, model, style)| series(name, &format!("{model}_{channel}"), style))
            .collect::<Result<_, _>>()?;
        panels.push(Panel::new("", "time (s)", label, curves));
    }
    let mut inputs = vec![series("angle of attack", "alpha_deg", Style::Line)?];
    for surface in ["inner", "middle", "outer"] {
        let column = format!("delta_{surface}_deg");
        if table.has(&column) {
            let commanded = series(&format!("{surface} aileron, commanded"), &column, Style::Line)?;
            inputs.extend(Some(commanded).filter(|series| series.y.iter().any(|delta| *delta != 0.0)));
        }
    }
    panels.push(Panel::new("", "time (s)", "angle (deg)", inputs));
    Ok(Figure::new(title, panels, 2))
}

/// Rows in which some columns have the same values, in the order of their first appearance.
fn grouped<T: PartialEq + Clone>(count: usize, key: impl Fn(usize) -> T) -> Vec<(T, Vec<usize>)> {
    let mut groups: Vec<(T, Vec<usize>)> = Vec::new();
    for row in 0..count {
        let of = key(row);
        match groups.iter_mut().find(|(known, _)| *known == of) {
            Some((_, rows)) => rows.push(row),
            None => groups.push((of, vec![row])),
        }
    }
    groups
}

/// Root loads over the angle of attack at each airspeed.
fn loads(table: &Table, title: &str) -> Result<Figure, Failure> {
    let (v_m_s, alpha) = (table.numbers("V_m_s")?, table.numbers("alpha_deg")?);
    let mut panels = Vec::new();
    for (v, rows) in grouped(table.len(), |row| v_m_s[row]) {
        let of = |values: &[f64]| rows.iter().map(|&row| values[row]).collect::<Vec<f64>>();
        for (channel, label) in LOADS {
            let series = |name: &str, style| -> Result<Series, Failure> {
                Ok(Series::new(name, of(&alpha), of(&table.numbers(&format!("{name}_{channel}"))?), style))
            };
            let curves = vec![
                series("initial", Style::DashedLine)?,
                series("updated", Style::Line)?,
                series("measured", Style::Points)?,
            ];
            panels.push(Panel::new(format!("{v} m/s"), "angle of attack (deg)", label, curves));
        }
    }
    Ok(Figure::new(title, panels, 3))
}

/// Equivalent deflections or factors over commanded ones, a panel for each surface and a line for each airspeed.
fn factors(table: &Table, title: &str, column: &str) -> Result<Figure, Failure> {
    let (v_m_s, commanded, y) =
        (table.numbers("V_m_s")?, table.numbers("commanded_deg")?, table.numbers(column)?);
    let y_label = if column == "factor" { "K (-)" } else { "equivalent deflection (deg)" };
    let surfaces: Vec<String> = (0..table.len())
        .map(|row| table.text(row, "control").map(str::to_owned))
        .collect::<Result<_, _>>()?;
    let mut panels = Vec::new();
    for (surface, rows) in grouped(table.len(), |row| surfaces[row].clone()) {
        let mut series = Vec::new();
        for (v, places) in grouped(rows.len(), |place| v_m_s[rows[place]]) {
            let of = |values: &[f64]| places.iter().map(|&place| values[rows[place]]).collect::<Vec<f64>>();
            for style in [Style::Line, Style::Points] {
                series.push(Series::new(format!("{v} m/s"), of(&commanded), of(&y), style));
            }
        }
        if column != "factor" {
            let most = rows.iter().map(|&row| commanded[row]).fold(0.0, f64::max);
            series.push(Series::new("linear", vec![0.0, most], vec![0.0, most], Style::DashedLine));
        }
        panels.push(Panel::new(format!("{surface} aileron"), "commanded deflection (deg)", y_label, series));
    }
    let columns = panels.len();
    Ok(Figure::new(title, panels, columns))
}
