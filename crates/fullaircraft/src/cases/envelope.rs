//! The load envelope of many cases: smallest and largest Fz, Mx and My at each station, with the case that gave each.

use crate::cases::grid::{CaseResult, StationLoads};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::HashMap;
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
    /// 90 % interval of the load at this end, N or N m, as the wing is known; left out where no others as likely were flown.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub interval_90: Option<[f64; 2]>,
}

impl Extreme {
    /// Whether another is the same end of the same load at the same station, whichever model it is of.
    pub fn is_end_of(&self, other: &Self) -> bool {
        (self.load, self.end, &self.station) == (other.load, other.end, &other.station)
    }
}

/// The envelope of cases that come one by one; of cases that give the same the first counts.
#[derive(Debug, Default)]
pub struct LoadEnvelope {
    all: Vec<Extreme>,
    /// First of the six extremes of a model's station.
    first: HashMap<String, HashMap<String, usize>>,
}

impl LoadEnvelope {
    /// Takes in a case.
    pub fn add(&mut self, result: &CaseResult) {
        for place in &result.loads {
            let known = self.first.get(&result.model).and_then(|stations| stations.get(&place.station));
            if let Some(&first) = known {
                let ends = ranges(place).into_iter().flatten();
                for (known, value) in self.all[first..].iter_mut().zip(ends) {
                    let further =
                        if known.end == "smallest" { value < known.value } else { value > known.value };
                    if further {
                        (known.value, known.case, known.flown) = (value, result.number, result.label());
                    }
                }
            } else {
                let stations = self.first.entry(result.model.clone()).or_default();
                stations.insert(place.station.clone(), self.all.len());
                for (load, range) in LOADS.into_iter().zip(ranges(place)) {
                    self.all.extend(["smallest", "largest"].into_iter().zip(range).map(|(end, value)| {
                        Extreme {
                            model: result.model.clone(),
                            station: place.station.clone(),
                            load,
                            end,
                            value,
                            case: result.number,
                            flown: result.label(),
                            interval_90: None,
                        }
                    }));
                }
            }
        }
    }

    /// Both ends of all loads, by model, station and load.
    pub fn extremes(self) -> Vec<Extreme> {
        self.all
    }
}

/// Both ends of all loads, by model, station and load.
pub fn load_envelope(results: &[CaseResult]) -> Vec<Extreme> {
    let mut envelope = LoadEnvelope::default();
    for result in results {
        envelope.add(result);
    }
    envelope.extremes()
}

/// The three ranges of a station in the order of [`LOADS`].
pub fn ranges(place: &StationLoads) -> [[f64; 2]; 3] {
    [place.fz_n, place.mx_nm, place.my_nm]
}

/// The envelope as CSV; with both ends of intervals where there are any.
pub fn envelope_csv(envelope: &[Extreme]) -> String {
    let is_interval = envelope.iter().any(|extreme| extreme.interval_90.is_some());
    let more = if is_interval { ",low_90,high_90" } else { "" };
    let mut text = format!("model,station,load,end,value,case,flown{more}\n");
    for e in envelope {
        // Writing to a String cannot fail.
        let _ = write!(
            text,
            "{},{},{},{},{},{},\"{}\"",
            e.model, e.station, e.load, e.end, e.value, e.case, e.flown
        );
        let _ = match e.interval_90 {
            Some([low, high]) => writeln!(text, ",{low},{high}"),
            None => writeln!(text, "{}", if is_interval { ",," } else { "" }),
        };
    }
    text
}

/// The columns of a table of cases: names of values and stations of the case that has most of them.
#[derive(Debug, Clone, Default)]
pub struct CaseColumns {
    /// Names of values.
    pub values: Vec<String>,
    /// Stations.
    pub stations: Vec<String>,
}

impl CaseColumns {
    /// Takes in a case.
    pub fn add(&mut self, result: &CaseResult) {
        if result.values.len() > self.values.len() {
            self.values = result.values.keys().cloned().collect();
        }
        if result.loads.len() > self.stations.len() {
            self.stations = result.loads.iter().map(|place| place.station.clone()).collect();
        }
    }

    /// The names of all numbers of a row, in the order of [`numbers`](Self::numbers), with their units.
    pub fn names(&self) -> Vec<String> {
        let tips = ["right", "left"]
            .into_iter()
            .flat_map(|side| ["min", "max"].map(|end| format!("{side}_tip_{end}_m")));
        let loads = self.stations.iter().flat_map(|station| {
            let place = station.replace(' ', "_");
            LOADS.into_iter().flat_map(move |load| ["min", "max"].map(|end| format!("{place}_{load}_{end}")))
        });
        self.values.iter().cloned().chain(tips).chain(loads).collect()
    }

    /// The numbers of a row: values, heights of the tips, loads.
    pub fn numbers(&self, result: &CaseResult) -> Vec<Option<f64>> {
        let mut all: Vec<Option<f64>> =
            self.values.iter().map(|name| result.values.get(name).copied()).collect();
        for side in 0..2 {
            all.extend([0, 1].map(|end| result.tip_deflection_m.get(side).map(|range| range[end])));
        }
        for station in &self.stations {
            let place = result.loads.iter().find(|place| place.station == *station);
            all.extend((0..6).map(|at| place.map(|place| ranges(place)[at / 2][at % 2])));
        }
        all
    }

    /// The first line of the table as CSV.
    pub fn csv_head(&self) -> String {
        format!("case,model,maneuver,V_m_s,load_factor,refused,{}\n", self.names().join(","))
    }

    /// A line of the table as CSV: what was flown, trim, tips and loads; empty where a case has no such number.
    pub fn csv_row(&self, result: &CaseResult) -> String {
        let refused = result.refused.as_deref().unwrap_or_default().replace('"', "'");
        let mut text = format!(
            "{},{},\"{}\",{},{},\"{refused}\"",
            result.number, result.model, result.maneuver, result.v_m_s, result.load_factor
        );
        for value in self.numbers(result) {
            text.push(',');
            // Writing to a String cannot fail.
            let _ = value.map_or(Ok(()), |value| write!(text, "{value}"));
        }
        text.push('\n');
        text
    }
}

#[cfg(test)]
mod tests;
