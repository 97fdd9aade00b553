//! Figures of `loads`: V-n diagrams with the cases in them, and loads against loads at stations with what is selected.

use loads::matrix::Status;
use loads::select::Instant;
use loads::select::file::{Load, Model};
use loads::{Design, Matrix, Selection};
use report::{Figure, Panel, Series, Style};

use crate::failure::Failure;
use crate::output::ResultFolder;

/// Pairs of loads that are drawn.
const PAIRS: [(Load, Load); 2] = [(Load::Fz, Load::Mx), (Load::Mx, Load::My)];

/// A V-n diagram each state of loading and altitude.
pub(crate) fn vn(folder: &ResultFolder, design: &Design, matrix: &Matrix) -> Result<(), Failure> {
    for (mass, diagram) in &matrix.diagrams {
        let name = &design.masses[*mass].name;
        let mut lines: Vec<(&str, Vec<f64>, Vec<f64>)> = Vec::new();
        for (line, v_m_s, n) in diagram.lines() {
            match lines.last_mut().filter(|last| last.0 == line) {
                Some(last) => {
                    last.1.push(v_m_s);
                    last.2.push(n);
                }
                None => lines.push((line, vec![v_m_s], vec![n])),
            }
        }
        let mut series: Vec<Series> =
            lines.into_iter().map(|(line, v, n)| Series::new(line, v, n, Style::Line)).collect();
        let of = |flown: bool| {
            let here = matrix.cases.iter().filter(|case| case.mass == *mass && case.h_m == diagram.h_m);
            here.filter(|case| (case.status == Status::LeftOut) != flown)
                .map(|case| (case.v_eas_m_s, case.n_z))
                .unzip::<f64, f64, Vec<f64>, Vec<f64>>()
        };
        for (label, flown) in [("cases", true), ("left out", false)] {
            let (v, n) = of(flown);
            if !v.is_empty() {
                series.push(Series::new(label, v, n, Style::Points));
            }
        }
        let panel = Panel::new("", "equivalent airspeed (m/s)", "load factor", series);
        let title = format!("V-n diagram, mass {name}, {} m", diagram.h_m);
        let caption = "Stall, maneuver and gust lines, with the cases of the matrix.";
        let file = format!("vn_{}_{}m", plain(name), diagram.h_m);
        folder.write_figure(&file, caption, Figure::new(title, vec![panel], 1))?;
    }
    Ok(())
}

/// Net loads of all instants at each station of the right wing, and those that go to stress; of a deck at all its stations.
pub(crate) fn potatoes(
    folder: &ResultFolder,
    names: &[String],
    instants: &[Instant],
    selection: &Selection,
) -> Result<(), Failure> {
    if instants.is_empty() {
        return Ok(());
    }
    let of_right = |name: &&String| name.starts_with("right ");
    let is_drawn = |name: &&String| of_right(name) || !names.iter().any(|other| of_right(&other));
    for (place, name) in names.iter().enumerate().filter(|(_, name)| is_drawn(name)) {
        let panel = |(across, up): (Load, Load)| {
            let points = |label: &str, keep: &dyn Fn(&Instant) -> bool| {
                let loads =
                    instants.iter().filter(|instant| keep(instant)).map(|instant| &instant.loads[place]);
                let (x, y) = loads.map(|six| (six[across.place()], six[up.place()])).unzip();
                Series::new(label, x, y, Style::Points)
            };
            let taken = |instant: &Instant| {
                selection.selected.iter().any(|one| {
                    (one.model, one.case, one.instant) == (instant.model, instant.case, instant.instant)
                })
            };
            let series = vec![
                points("initial", &|instant| instant.model == Model::Initial),
                points("updated", &|instant| instant.model == Model::Updated),
                points("selected", &taken),
            ];
            let label = |load: Load| format!("{} ({})", load.name(), load.unit());
            Panel::new("", label(across), label(up), series)
        };
        let figure = Figure::new(format!("Loads at {name}"), PAIRS.into_iter().map(panel).collect(), 2);
        let caption = "Net loads of all cases and instants, and those that go to stress.";
        folder.write_figure(&format!("potato_{}", plain(name)), caption, figure)?;
    }
    Ok(())
}

/// A name as part of a file's.
fn plain(name: &str) -> String {
    name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect()
}
