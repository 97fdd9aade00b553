//! Tables and figures of `gust`.

use std::fmt::Write as _;

use faer::c64;
use fullaircraft::{DynamicAnswer, GustDeck, RandomAnswer, RandomSet, TimeAnswer};
use report::{Figure, Panel, Series, Style};

use crate::failure::Failure;
use crate::output::ResultFolder;

/// Motions of a grid.
const MOTIONS: [&str; 6] = ["T1", "T2", "T3", "R1", "R2", "R3"];
/// Loads of a station.
pub(super) const LOADS: [&str; 6] = ["F1", "F2", "F3", "M1", "M2", "M3"];
/// Grids and stations drawn; the tables have all.
const DRAWN: usize = 8;
/// What stands below figures of grids.
const OF_GRIDS: &str = "Displacement and acceleration of grids along their third axis, in the deck's units; the tables have all motions \
    and all grids that were asked for.";
/// What stands below figures of stations.
const OF_STATIONS: &str = "Total load of a monitoring station: of boxes the air's, of grids air less mass times acceleration; in the \
    deck's units. The tables have the parts.";
/// What stands below the figure of densities.
const OF_DENSITIES: &str =
    "Power spectral densities of what moves in random gusts, in the deck's units squared per Hz.";

/// A quantity over time or frequency.
pub(super) struct Quantity {
    pub(super) of: String,
    pub(super) component: String,
    /// Whether a station has it, and not a grid.
    pub(super) is_load: bool,
    pub(super) x: Vec<f64>,
    pub(super) y: Vec<f64>,
}

/// The tables as text, empty those that nothing fills.
#[derive(Default)]
pub(super) struct Tables {
    grids: String,
    stations: String,
    grids_over_frequency: String,
    stations_over_frequency: String,
    densities: String,
    /// Name, frequencies and densities, for the figure.
    drawn: Vec<(String, Vec<f64>, Vec<f64>)>,
}

impl Tables {
    /// Motions of grids and loads of stations in time.
    pub(super) fn over_time(&mut self, id: u32, deck: &GustDeck, time: &TimeAnswer, grids: &[u32]) {
        for grid in grids {
            let Some(shapes) = deck.shapes_at(*grid) else { continue };
            for (t, [moved, accelerated]) in time.times_s.iter().zip(time.of_grid(&shapes)) {
                let values: Vec<String> = moved.iter().chain(&accelerated).map(f64::to_string).collect();
                // Writing to a String cannot fail.
                let _ = writeln!(self.grids, "{id},{t},{grid},{}", values.join(","));
            }
        }
        for (station, (name, _, is_structural, axes)) in time.stations.iter().zip(deck.stations()) {
            for component in axes.iter().map(|axis| usize::from(*axis) - 1) {
                for (t, loads) in time.times_s.iter().zip(&station.loads) {
                    let _ = writeln!(
                        self.stations,
                        "{id},{t},{name},{},{},{},{},{},{}",
                        kind(is_structural),
                        LOADS[component],
                        loads.inertial[component],
                        loads.flexible[component],
                        loads.gust[component],
                        loads.total(component)
                    );
                }
            }
        }
    }

    /// The same over frequency, real and imaginary parts.
    pub(super) fn over_frequency(&mut self, id: u32, deck: &GustDeck, answer: &DynamicAnswer, grids: &[u32]) {
        for grid in grids {
            let Some(shapes) = deck.shapes_at(*grid) else { continue };
            for (hz, x) in answer.hz.iter().zip(&answer.modal) {
                let _ = write!(self.grids_over_frequency, "{id},{hz},{grid}");
                for row in 0..6 {
                    let y: c64 = x.iter().enumerate().map(|(j, x)| *x * shapes[(row, j)]).sum();
                    let _ = write!(self.grids_over_frequency, ",{},{}", y.re, y.im);
                }
                self.grids_over_frequency.push('\n');
            }
        }
        for (at, (name, _, is_structural, axes)) in deck.stations().enumerate() {
            for component in axes.iter().map(|axis| usize::from(*axis) - 1) {
                for (hz, stations) in answer.hz.iter().zip(&answer.stations) {
                    let total = stations[at].total(component);
                    let _ = writeln!(
                        self.stations_over_frequency,
                        "{id},{hz},{name},{},{},{},{}",
                        kind(is_structural),
                        LOADS[component],
                        total.re,
                        total.im
                    );
                }
            }
        }
    }

    /// A density.
    pub(super) fn density(&mut self, set: u32, hz: &[f64], of: &str, component: &str, answer: &RandomAnswer) {
        for (hz, density) in hz.iter().zip(&answer.density) {
            let _ = writeln!(self.densities, "{set},{hz},{of},{component},{density}");
        }
        self.drawn.push((format!("{of} {component}"), hz.to_vec(), answer.density.clone()));
    }

    /// Writes those that are not empty.
    pub(super) fn write(&self, folder: &ResultFolder) -> Result<(), Failure> {
        let columns = |names: &[&str], ends: &[&str]| {
            let all = names.iter().flat_map(|name| ends.iter().map(move |end| format!("{name}{end}")));
            all.collect::<Vec<_>>().join(",")
        };
        let accelerations: Vec<String> = MOTIONS.iter().map(|name| format!("acceleration_{name}")).collect();
        let parts = "inertial,flexible,gust,total";
        let all = [
            (
                "grids.csv",
                format!("subcase,time_s,grid,{},{}", MOTIONS.join(","), accelerations.join(",")),
                &self.grids,
            ),
            ("stations.csv", format!("subcase,time_s,station,kind,component,{parts}"), &self.stations),
            (
                "grids_over_frequency.csv",
                format!("subcase,frequency_hz,grid,{}", columns(&MOTIONS, &["_real", "_imaginary"])),
                &self.grids_over_frequency,
            ),
            (
                "stations_over_frequency.csv",
                "subcase,frequency_hz,station,kind,component,real,imaginary".to_owned(),
                &self.stations_over_frequency,
            ),
            ("densities.csv", "set,frequency_hz,of,component,density".to_owned(), &self.densities),
        ];
        for (name, head, text) in all.iter().filter(|table| !table.2.is_empty()) {
            folder.write_text(name, &format!("{head}\n{text}"))?;
        }
        Ok(())
    }
}

fn kind(is_structural: bool) -> &'static str {
    if is_structural { "structure" } else { "air" }
}

/// Names of a grid's displacements and accelerations.
fn of_grid(grid: u32) -> (String, [String; 12]) {
    let name = |at: usize| {
        let motion = MOTIONS[at % 6];
        if at < 6 { motion.to_owned() } else { format!("acceleration {motion}") }
    };
    (format!("grid {grid}"), std::array::from_fn(name))
}

/// What is asked for, in time.
pub(super) fn in_time(deck: &GustDeck, time: &TimeAnswer, grids: &[u32]) -> Vec<Quantity> {
    let mut all = Vec::new();
    for grid in grids {
        let Some(shapes) = deck.shapes_at(*grid) else { continue };
        let (of, names) = of_grid(*grid);
        let motions = time.of_grid(&shapes);
        for (at, component) in names.into_iter().enumerate() {
            let y = motions.iter().map(|both| both[at / 6][at % 6]).collect();
            all.push(Quantity { of: of.clone(), component, is_load: false, x: time.times_s.clone(), y });
        }
    }
    for (station, (name, _, _, axes)) in time.stations.iter().zip(deck.stations()) {
        for component in axes.iter().map(|axis| usize::from(*axis) - 1) {
            let y = station.loads.iter().map(|loads| loads.total(component)).collect();
            let (of, x) = (name.to_owned(), time.times_s.clone());
            all.push(Quantity { of, component: LOADS[component].to_owned(), is_load: true, x, y });
        }
    }
    all
}

/// The same as amplitudes over frequency.
pub(super) fn amplitudes(deck: &GustDeck, answer: &DynamicAnswer, grids: &[u32]) -> Vec<Quantity> {
    let mut all = Vec::new();
    for grid in grids {
        let Some(shapes) = deck.shapes_at(*grid) else { continue };
        let (of, names) = of_grid(*grid);
        for (at, component) in names.into_iter().enumerate() {
            let value = |(hz, x): (&f64, &Vec<c64>)| {
                let y: c64 = x.iter().enumerate().map(|(j, x)| *x * shapes[(at % 6, j)]).sum();
                y.norm() * if at < 6 { 1.0 } else { (std::f64::consts::TAU * hz).powi(2) }
            };
            let y = answer.hz.iter().zip(&answer.modal).map(value).collect();
            all.push(Quantity { of: of.clone(), component, is_load: false, x: answer.hz.clone(), y });
        }
    }
    for (at, (name, _, _, axes)) in deck.stations().enumerate() {
        for component in axes.iter().map(|axis| usize::from(*axis) - 1) {
            let y = answer.stations.iter().map(|all| all[at].total(component).norm()).collect();
            let (of, x) = (name.to_owned(), answer.hz.clone());
            all.push(Quantity { of, component: LOADS[component].to_owned(), is_load: true, x, y });
        }
    }
    all
}

/// The same in random gusts.
pub(super) fn random(
    random: &RandomSet<'_>,
    deck: &GustDeck,
    grids: &[u32],
) -> Vec<(String, String, RandomAnswer)> {
    let mut all = Vec::new();
    for grid in grids {
        let (of, names) = of_grid(*grid);
        for (at, component) in names.into_iter().enumerate() {
            if let Some(answer) = random.of_grid(*grid, at % 6, at >= 6) {
                all.push((of.clone(), component, answer));
            }
        }
    }
    for (at, (name, _, _, axes)) in deck.stations().enumerate() {
        for component in axes.iter().map(|axis| usize::from(*axis) - 1) {
            all.push((name.to_owned(), LOADS[component].to_owned(), random.of_station(at, component)));
        }
    }
    all
}

/// Figures of a subcase: name, caption, figure.
pub(super) fn figures(
    id: u32,
    quantities: &[Quantity],
    axis: &str,
    time: Option<&TimeAnswer>,
) -> Vec<(String, &'static str, Figure)> {
    let panel = |title: &str, of: Vec<&Quantity>, name: &dyn Fn(&Quantity) -> String| {
        let series = of.iter().map(|q| Series::new(name(q), q.x.clone(), q.y.clone(), Style::Line));
        Panel::new(title, axis, title, series.collect())
    };
    let mut all = Vec::new();
    let third = |component: &str| -> Vec<&Quantity> {
        quantities.iter().filter(|q| !q.is_load && q.component == component).take(DRAWN).collect()
    };
    let mut panels = Vec::new();
    if let Some(time) = time {
        let series =
            Series::new("excitation", time.times_s.clone(), time.excitation.clone(), Style::DashedLine);
        panels.push(Panel::new("function that excites", axis, "function that excites", vec![series]));
    }
    for component in ["T3", "acceleration T3"] {
        let of = third(component);
        if !of.is_empty() {
            panels.push(panel(component, of, &|q| q.of.clone()));
        }
    }
    if !panels.is_empty() {
        all.push((format!("subcase_{id}_grids"), OF_GRIDS, Figure::new(format!("subcase {id}"), panels, 2)));
    }
    let mut names: Vec<&str> = quantities.iter().filter(|q| q.is_load).map(|q| q.of.as_str()).collect();
    names.dedup();
    for name in names.into_iter().take(DRAWN) {
        let of = quantities.iter().filter(|q| q.is_load && q.of == name);
        let panels = of.map(|q| panel(&q.component, vec![q], &|_| "total".to_owned())).collect();
        let figure = Figure::new(format!("subcase {id}, station {name}"), panels, 3);
        let plain: String = name
            .chars()
            .map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' })
            .collect();
        all.push((format!("subcase_{id}_station_{plain}"), OF_STATIONS, figure));
    }
    all
}

/// The figure of densities.
pub(super) fn draw_densities(folder: &ResultFolder, tables: &Tables) -> Result<(), Failure> {
    let panels = tables.drawn.iter().take(DRAWN).map(|(name, hz, density)| {
        let series = Series::new("density", hz.clone(), density.clone(), Style::Line);
        Panel::new(name.as_str(), "frequency (Hz)", "density", vec![series])
    });
    folder.write_figure("densities", OF_DENSITIES, Figure::new("random gusts", panels.collect(), 2))?;
    Ok(())
}
