//! Tables of `loads`: station loads, envelope, selected instants; and station loads read again.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use fullaircraft::Component;
use fullaircraft::cases::envelope::Extreme;
use fullaircraft::cases::list::MODELS;
use fullaircraft::design_loads::in_time::axis_of;
use fullaircraft::design_loads::instants::{FlownCase, FlownInstant};
use fullaircraft::package::round_trip::LOADS;
use loads::matrix::{Action, Case};
use loads::select::Instant;
use loads::select::file::Model;
use loads::{Design, Matrix, Selection};
use nastran::{InputError, read_text};

use crate::commands::loads_flights::Flown;
use crate::failure::Failure;
use crate::output::ResultFolder;

/// Heads of `station_loads.csv`.
const HEAD: &str = "model,case,instant,t_s,station,component,Fx_N,Fy_N,Fz_N,Mx_Nm,My_Nm,Mz_Nm";

/// Writes loads at all stations in all instants by component, case by case: gigabytes of a plan with thousands of gusts. Components
/// without a load are left out, the net is always there.
///
/// # Errors
/// If it cannot be written, or a load is not finite.
pub(crate) fn write_station_loads(
    folder: &ResultFolder,
    names: &[String],
    cases: &[FlownCase],
) -> Result<(), Failure> {
    let head = std::iter::once(Ok(format!("{HEAD}\n")));
    folder
        .write_lines("station_loads.csv", head.chain(cases.iter().map(|case| Ok(station_loads(names, case)))))
}

fn station_loads(names: &[String], case: &FlownCase) -> String {
    let mut text = String::new();
    for (instant, flown) in (1..).zip(&case.instants) {
        for (name, components) in names.iter().zip(&flown.loads) {
            for (component, loads) in Component::ALL.iter().zip(components) {
                if *component != Component::Net && loads.iter().all(|load| *load == 0.0) {
                    continue;
                }
                let (model, number) = (MODELS[case.model], case.number);
                // Writing to a String cannot fail.
                let _ = write!(text, "{model},{number},{instant},{},{name},{}", flown.t_s, component.name());
                for load in loads {
                    let _ = write!(text, ",{load:.12e}");
                }
                text.push('\n');
            }
        }
    }
    text
}

/// A row of `station_loads.csv`.
pub(crate) struct StationRow<'r> {
    /// Which of the two models.
    pub(crate) model: usize,
    /// Number of the case.
    pub(crate) case: usize,
    /// Number of the instant, from one.
    pub(crate) instant: usize,
    /// Station.
    pub(crate) station: &'r str,
    /// Component's name.
    pub(crate) component: &'r str,
    /// Six loads.
    pub(crate) loads: [f64; 6],
}

/// Reads `station_loads.csv` row by row: it may be long.
///
/// # Errors
/// If it is not as it is written here.
pub(crate) fn station_rows(path: &Path, mut each: impl FnMut(StationRow<'_>)) -> Result<(), InputError> {
    let text = read_text(path)?;
    let wrong = |line: usize, message: &str| {
        InputError::in_file(path, format!("line {line}: {message}"))
            .with_help("expected the file as `wingroot loads` writes it")
    };
    let mut lines = text.lines().enumerate();
    if lines.next().map(|(_, head)| head) != Some(HEAD) {
        return Err(wrong(1, "these are not the heads of station loads"));
    }
    for (at, line) in lines {
        let cells: Vec<&str> = line.split(',').collect();
        let &[model, case, instant, _, station, component, ref values @ ..] = cells.as_slice() else {
            return Err(wrong(at + 1, "a cell is missing"));
        };
        let number = |text: &str| text.parse::<usize>().map_err(|_| wrong(at + 1, "this is no number"));
        let real = |text: &&str| text.parse::<f64>().ok().filter(|value| value.is_finite());
        let values: Option<Vec<f64>> = values.iter().map(real).collect();
        let loads = values.and_then(|values| <[f64; 6]>::try_from(values).ok());
        let loads = loads.ok_or_else(|| wrong(at + 1, "expected six finite loads"))?;
        let model = MODELS.iter().position(|known| *known == model);
        let model = model.ok_or_else(|| wrong(at + 1, "expected the model initial or updated"))?;
        let (case, instant) = (number(case)?, number(instant)?);
        each(StationRow { model, case, instant, station, component, loads });
    }
    Ok(())
}

/// The place of a name in a list, which it joins if it is new.
pub(crate) fn place_of(names: &mut Vec<String>, name: &str) -> usize {
    names.iter().position(|known| known == name).unwrap_or_else(|| {
        names.push(name.to_owned());
        names.len() - 1
    })
}

/// Loads of an instant at the stations that were found so far.
type Found = Vec<Option<[f64; 6]>>;

/// Net loads of `station_loads.csv`: names of the stations, and all instants.
pub(crate) fn read_station_loads(path: &Path) -> Result<(Vec<String>, Vec<Instant>), Failure> {
    let mut names: Vec<String> = Vec::new();
    let mut instants: BTreeMap<(usize, usize, usize), Found> = BTreeMap::new();
    station_rows(path, |row| {
        if row.component != Component::Net.name() {
            return;
        }
        let place = place_of(&mut names, row.station);
        let loads = instants.entry((row.model, row.case, row.instant)).or_default();
        loads.resize(loads.len().max(place + 1), None);
        loads[place] = Some(row.loads);
    })?;
    let all = instants.into_iter().map(|((model, case, instant), loads)| {
        let loads = (0..names.len()).map(|place| loads.get(place).copied().flatten()).collect::<Option<_>>();
        let model = if model == 0 { Model::Initial } else { Model::Updated };
        let missing = || InputError::in_file(path, format!("case {case} lacks loads of a station"));
        Ok(Instant { model, case, instant, loads: loads.ok_or_else(missing)? })
    });
    let all = all.collect::<Result<Vec<_>, InputError>>()?;
    Ok((names, all))
}

/// Both ends of the six net loads by model and station; of cases that give the same the first counts.
pub(crate) fn envelope(names: &[String], instants: &[Instant], matrix: &Matrix) -> Vec<Extreme> {
    let mut all = Vec::new();
    for model in [Model::Initial, Model::Updated] {
        for (place, station) in names.iter().enumerate() {
            for (at, load) in LOADS.into_iter().enumerate() {
                let of_model = || instants.iter().filter(|instant| instant.model == model);
                let value = |instant: &&Instant| instant.loads[place][at];
                let smallest = of_model().reduce(|a, b| if value(&b) < value(&a) { b } else { a });
                let largest = of_model().reduce(|a, b| if value(&b) > value(&a) { b } else { a });
                for (end, found) in [("smallest", smallest), ("largest", largest)] {
                    let Some(found) = found else { continue };
                    all.push(Extreme {
                        model: model.name().to_owned(),
                        station: station.clone(),
                        load,
                        end,
                        value: value(&found),
                        case: found.case,
                        flown: case_of(matrix, found.case).map(words).unwrap_or_default(),
                        interval_90: None,
                    });
                }
            }
        }
    }
    all
}

/// A case of the matrix.
pub(crate) fn case_of(matrix: &Matrix, number: usize) -> Option<&Case> {
    matrix.cases.iter().find(|case| case.number == number)
}

/// The gradient of the gust that an instant of a case is of, m.
pub(crate) fn gradient_m(case: &Case, instant: &FlownInstant) -> Option<f64> {
    let Action::Discrete { gradient_m, .. } = case.action else { return None };
    Some(instant.gradient_m.unwrap_or(gradient_m))
}

/// A case in a few words.
pub(crate) fn words(case: &Case) -> String {
    format!("{}, {:.2} m/s, {} m, n {:.3}", case.condition, case.v_m_s, case.h_m, case.n_z)
}

/// What goes to stress, a row a load set.
pub(crate) fn selected(
    names: &[String],
    selection: &Selection,
    flown: &Flown,
    matrix: &Matrix,
    design: &Design,
) -> String {
    let mut text = String::from("sid,model,case,instant,t_s,H_m,kind,mass,h_m,V_m_s,n_z,driven,limit,why\n");
    for one in &selection.selected {
        let model = usize::from(one.model == Model::Updated);
        let Some(case) = case_of(matrix, one.case) else { continue };
        let instant = flown.case(model, one.case).and_then(|case| case.instants.get(one.instant - 1));
        let gradient = instant.and_then(|instant| gradient_m(case, instant));
        let gradient = gradient.map_or_else(String::new, |gradient_m| format!("{gradient_m:.4}"));
        let limit = instant.and_then(|instant| Some(instant.limit?.words(axis_of(case), names)));
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "{},{},{},{},{},{gradient},{},{},{},{:.6},{:.6},{},{},\"{}\"",
            one.sid,
            one.model.name(),
            one.case,
            one.instant,
            instant.map_or(0.0, |instant| instant.t_s),
            case.kind,
            design.masses[case.mass].name,
            case.h_m,
            case.v_m_s,
            case.n_z,
            one.driven,
            limit.unwrap_or_default(),
            one.why.join("; ")
        );
    }
    text
}
