//! Continuous turbulence: limit loads, correlations, and a figure of limit loads along the wing.

use std::fmt::Write as _;

use fullaircraft::cases::list::MODELS;
use fullaircraft::design_loads::instants::{FlownCase, TurbulenceFacts, TurbulentLoad};
use fullaircraft::package::round_trip::LOADS;
use loads::design::Attitude;
use loads::matrix::{Action, Case};
use loads::{Design, Matrix};
use report::{Figure, Panel, Series, Style};
use schemars::JsonSchema;
use serde::Serialize;

use crate::commands::loads_flights::Flown;
use crate::commands::loads_gusts::shown_station;
use crate::commands::loads_tables::case_of;
use crate::failure::Failure;
use crate::output::ResultFolder;

/// A net load in turbulence.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct TurbulenceRow {
    /// Which model.
    model: &'static str,
    /// Number of the case.
    case: usize,
    /// Station.
    station: String,
    /// Load with its unit.
    load: &'static str,
    /// In level flight, N or N m.
    one_g: f64,
    /// Root mean square by that of the turbulence, N or N m per m/s.
    a_bar: f64,
    /// Limit intensity of the turbulence, m/s TAS.
    u_sigma_m_s: f64,
    /// Smallest and largest, N or N m.
    limits: [f64; 2],
    /// Crossings of the mean upwards below the cut-off, Hz: no number to compare without it.
    n0_hz: f64,
    /// By how much A may grow beyond the cut-off, %; left out if a mode is there, whose part is unknown.
    #[serde(skip_serializing_if = "Option::is_none")]
    tail_bound_percent: Option<f64>,
    /// What keeps airspeed and attitude: `stable` (the aircraft) or `held` (a pilot or control laws, by the plan).
    attitude: &'static str,
}

/// Cases that were flown in turbulence.
fn rough(cases: &[FlownCase]) -> impl Iterator<Item = (&FlownCase, &TurbulenceFacts)> {
    cases.iter().filter_map(|case| Some((case, case.turbulence.as_ref()?)))
}

fn limits(facts: &TurbulenceFacts, load: &TurbulentLoad) -> [f64; 2] {
    [-1.0, 1.0].map(|sign| load.one_g + sign * facts.u_sigma_m_s * load.a_bar)
}

/// All loads that turbulence moves.
pub(crate) fn rows(names: &[String], cases: &[FlownCase]) -> Vec<TurbulenceRow> {
    let of = |(case, facts): (&FlownCase, &TurbulenceFacts)| {
        let (model, number) = (MODELS[case.model], case.number);
        let row = |load: &TurbulentLoad| TurbulenceRow {
            model,
            case: number,
            station: names[load.station].clone(),
            load: LOADS[load.load],
            one_g: load.one_g,
            a_bar: load.a_bar,
            u_sigma_m_s: facts.u_sigma_m_s,
            limits: limits(facts, load),
            n0_hz: load.n0_hz,
            tail_bound_percent: load.tail_bound.map(|share| 100.0 * share),
            attitude: facts.attitude.word(),
        };
        facts.loads.iter().map(row).collect::<Vec<_>>()
    };
    rough(cases).flat_map(of).collect()
}

/// All loads that turbulence moves, and the load factor of the whole, as `turbulence.csv`.
pub(crate) fn csv(names: &[String], cases: &[FlownCase]) -> String {
    let mut text = String::from(
        "model,case,station,load,one_g,A_per_m_s,U_sigma_m_s,smallest,largest,N0_hz,tail_bound_percent,attitude\n",
    );
    for (case, facts) in rough(cases) {
        let (model, number, u) = (MODELS[case.model], case.number, facts.u_sigma_m_s);
        let attitude = facts.attitude.word();
        for load in &facts.loads {
            let [smallest, largest] = limits(facts, load);
            let tail = load.tail_bound.map_or_else(String::new, |share| format!("{:.4}", 100.0 * share));
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "{model},{number},{},{},{:.9e},{:.9e},{u:.6},{smallest:.9e},{largest:.9e},{:.6},{tail},{attitude}",
                names[load.station], LOADS[load.load], load.one_g, load.a_bar, load.n0_hz
            );
        }
        if let Some([a, n0]) = facts.load_factor {
            let (smallest, largest) = (1.0 - u * a, 1.0 + u * a);
            let _ = writeln!(
                text,
                "{model},{number},whole,n_z,1,{a:.9e},{u:.6},{smallest:.9e},{largest:.9e},{n0:.6},,{attitude}"
            );
        }
    }
    text
}

/// Correlations of the loads that are looked at, as `correlation.csv`.
pub(crate) fn correlation(names: &[String], cases: &[FlownCase]) -> String {
    let mut text = String::from("model,case,station_i,load_i,station_j,load_j,rho\n");
    for (case, facts) in rough(cases) {
        for (i, j, rho) in &facts.correlations {
            let name = |at: &usize| {
                let load = &facts.loads[*at];
                format!("{},{}", names[load.station], LOADS[load.load])
            };
            // Writing to a String cannot fail.
            let _ = writeln!(text, "{},{},{},{},{rho:.9}", MODELS[case.model], case.number, name(i), name(j));
        }
    }
    text
}

/// Limit loads along the right wing, a figure a case; `along` has places of stations and their y, m.
pub(crate) fn figures(
    folder: &ResultFolder,
    along: &[(usize, f64)],
    flown: &Flown,
    matrix: &Matrix,
    design: &Design,
) -> Result<(), Failure> {
    let mut numbers: Vec<usize> = rough(&flown.cases).map(|(case, _)| case.number).collect();
    numbers.sort_unstable();
    numbers.dedup();
    for number in numbers {
        let Some(case) = case_of(matrix, number) else { continue };
        let panels = [2, 3, 4].map(|load| {
            let mut series = Vec::new();
            for (model, name) in MODELS.into_iter().enumerate() {
                let Some(facts) = flown.case(model, number).and_then(|case| case.turbulence.as_ref()) else {
                    continue;
                };
                let mut points: Vec<(f64, [f64; 2])> = facts
                    .loads
                    .iter()
                    .filter(|one| one.load == load)
                    .filter_map(|one| Some((place_y_m(along, one.station)?, limits(facts, one))))
                    .collect();
                points.sort_by(|a, b| a.0.total_cmp(&b.0));
                for (end, words) in ["smallest", "largest"].into_iter().enumerate() {
                    let (y, values) = points.iter().map(|point| (point.0, point.1[end])).unzip();
                    series.push(Series::new(format!("{name}, {words}"), y, values, Style::Line));
                }
            }
            Panel::new("", "y (m)", LOADS[load].replacen('_', " (", 1) + ")", series)
        });
        let mass = &design.masses[case.mass].name;
        let title = format!("{}, mass {mass}, {} m, {:.1} m/s", case.condition, case.h_m, case.v_m_s);
        folder.write_figure(
            &format!("turbulence_{number}"),
            caption(case),
            Figure::new(title, panels.into(), 3),
        )?;
    }
    Ok(())
}

/// y of a station that is looked at, m.
fn place_y_m(along: &[(usize, f64)], station: usize) -> Option<f64> {
    along.iter().find(|(place, _)| *place == station).map(|(_, y_m)| *y_m)
}

fn caption(case: &Case) -> &'static str {
    match case.action {
        Action::Turbulence { attitude: Attitude::Held, .. } => {
            "Limit loads in continuous turbulence about level flight, each at its own limit, with airspeed and attitude held as the plan says \
             (attitude: Held): an aircraft that diverges in these alone is not refused."
        }
        _ => {
            "Limit loads in continuous turbulence about level flight, each at its own limit. A model that is not stable by itself is refused, \
             and not drawn; one that is meets waves longer than its modes with airspeed and attitude held."
        }
    }
}

/// The bending moment of the right root, or of the first station, with the updated model, in a line.
pub(crate) fn line(rows: &[TurbulenceRow]) -> Option<String> {
    let station = shown_station(rows.iter().map(|row| row.station.as_str()))?;
    let own =
        rows.iter().filter(|row| row.model == MODELS[1] && row.station == station && row.load == "Mx_Nm");
    let size = |row: &TurbulenceRow| row.limits[0].abs().max(row.limits[1].abs());
    let worst = own.max_by(|a, b| size(a).total_cmp(&size(b)))?;
    let tail = match worst.tail_bound_percent {
        Some(percent) => format!("beyond the cut-off at most {percent:.2} %"),
        None => "modes lie beyond the cut-off: what they add is unknown".to_owned(),
    };
    let held = if worst.attitude == Attitude::Held.word() { ", airspeed and attitude held" } else { "" };
    Some(format!(
        "turbulence   {station} Mx {:.1} to {:.1} N m (case {}, updated{held}): U_sigma {:.2} m/s, A {:.3} N m per m/s, N0 {:.2} Hz, {tail}\n",
        worst.limits[0], worst.limits[1], worst.case, worst.u_sigma_m_s, worst.a_bar, worst.n0_hz
    ))
}
