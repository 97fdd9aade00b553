//! The load envelope of many cases: smallest and largest Fz, Mx and My at each station, with the case that gave each.

use crate::cases::grid::{CaseResult, StationLoads};
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt::Write as _;

/// Names of the three loads with their units.
pub const LOADS: [&str; 3] = ["Fz_N", "Mx_Nm", "My_Nm"];

/// One end of a load's range.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Extreme {
    /// `initial` or `updated`.
    pub model: String,
    /// Station.
    pub station: String,
    /// One of [`LOADS`].
    pub load: &'static str,
    /// `smallest` or `largest`.
    pub end: &'static str,
    /// The load, N or N m.
    pub value: f64,
    /// Number of the case that gave it.
    pub case: usize,
    /// That case in words.
    pub flown: String,
}

/// Both ends of all loads, by model, station and load; of cases that give the same the first counts.
pub fn load_envelope(results: &[CaseResult]) -> Vec<Extreme> {
    let mut all: Vec<Extreme> = Vec::new();
    for result in results {
        for place in &result.loads {
            for (load, range) in LOADS.into_iter().zip(ranges(place)) {
                for (end, value) in ["smallest", "largest"].into_iter().zip(range) {
                    let known = all.iter_mut().find(|e| {
                        e.model == result.model
                            && e.station == place.station
                            && e.load == load
                            && e.end == end
                    });
                    let further = |known: &Extreme| match end {
                        "smallest" => value < known.value,
                        _ => value > known.value,
                    };
                    let one = || Extreme {
                        model: result.model.clone(),
                        station: place.station.clone(),
                        load,
                        end,
                        value,
                        case: result.number,
                        flown: result.label(),
                    };
                    match known {
                        Some(known) if further(known) => *known = one(),
                        Some(_) => {}
                        None => all.push(one()),
                    }
                }
            }
        }
    }
    all
}

/// The three ranges of a station in the order of [`LOADS`].
pub fn ranges(place: &StationLoads) -> [[f64; 2]; 3] {
    [place.fz_n, place.mx_nm, place.my_nm]
}

/// The envelope as CSV.
pub fn envelope_csv(envelope: &[Extreme]) -> String {
    let mut text = String::from("model,station,load,end,value,case,flown\n");
    for e in envelope {
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "{},{},{},{},{},{},\"{}\"",
            e.model, e.station, e.load, e.end, e.value, e.case, e.flown
        );
    }
    text
}

/// All cases as CSV, a row each: what was flown, trim, tips and loads; empty where a case has no such number.
pub fn cases_csv(results: &[CaseResult]) -> String {
    let values = longest(results, |result| result.values.keys().cloned().collect());
    let stations = longest(results, |result| result.loads.iter().map(|s| s.station.clone()).collect());
    let mut text = String::from("case,model,maneuver,V_m_s,load_factor,refused");
    for name in &values {
        let _ = write!(text, ",{name}");
    }
    text += ",right_tip_min_m,right_tip_max_m,left_tip_min_m,left_tip_max_m";
    for station in &stations {
        let place = station.replace(' ', "_");
        for load in LOADS {
            let _ = write!(text, ",{place}_{load}_min,{place}_{load}_max");
        }
    }
    text.push('\n');
    for result in results {
        text += &row(result, &values, &stations);
    }
    text
}

fn longest(results: &[CaseResult], names: impl Fn(&CaseResult) -> Vec<String>) -> Vec<String> {
    let lists = results.iter().map(names);
    lists.fold(Vec::new(), |longest, list| if list.len() > longest.len() { list } else { longest })
}

fn row(result: &CaseResult, values: &[String], stations: &[String]) -> String {
    let refused = result.refused.as_deref().unwrap_or_default().replace('"', "'");
    let mut text = format!(
        "{},{},\"{}\",{},{},\"{refused}\"",
        result.number, result.model, result.maneuver, result.v_m_s, result.load_factor
    );
    let mut cell = |value: Option<f64>| {
        text.push(',');
        if let Some(value) = value {
            let _ = write!(text, "{value}");
        }
    };
    for name in values {
        cell(result.values.get(name).copied());
    }
    for side in 0..2 {
        for end in 0..2 {
            cell(result.tip_deflection_m.get(side).map(|range| range[end]));
        }
    }
    for station in stations {
        let place = result.loads.iter().find(|place| place.station == *station);
        for load in 0..3 {
            for end in 0..2 {
                cell(place.map(|place| ranges(place)[load][end]));
            }
        }
    }
    text.push('\n');
    text
}
