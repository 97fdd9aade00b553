//! Discrete gusts over their gradients: the worst of each net load, and whether it lies inside the range.

use std::fmt::Write as _;

use fullaircraft::cases::list::MODELS;
use fullaircraft::design_loads::instants::FlownCase;
use fullaircraft::package::round_trip::LOADS;
use loads::Matrix;
use loads::matrix::{Action, Case};
use schemars::JsonSchema;
use serde::Serialize;

use crate::commands::loads_tables::{case_of, gradient_m};

/// An end of a net load over all gradients of a family of gusts: those of a mass, altitude, airspeed and direction.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub(crate) struct WorstGust {
    /// Which model.
    model: &'static str,
    /// Number of the case; of a gradient that was searched for, of the nearest case.
    case: usize,
    /// Station.
    station: String,
    /// Load with its unit.
    load: &'static str,
    /// `smallest` or `largest`.
    end: &'static str,
    /// Gradient of the worst gust, m.
    #[serde(rename = "H_m")]
    h_m: f64,
    /// The load, N or N m.
    value: f64,
    /// When, from the gust's beginning, s.
    t_s: f64,
    /// Whether the gradient is none of the two at the ends of the range.
    tuned: bool,
    /// Fx, Fy, Fz (N), Mx, My, Mz (N m) there and then.
    companions: [f64; 6],
}

/// Cases of a family.
struct Family<'a> {
    key: (usize, usize, u64, u64, &'static str),
    cases: Vec<(&'a FlownCase, &'a Case)>,
}

/// Both ends of every net load in every family.
pub(crate) fn worst(names: &[String], cases: &[FlownCase], matrix: &Matrix) -> Vec<WorstGust> {
    let mut families: Vec<Family<'_>> = Vec::new();
    for flown in cases {
        let Some(case) = case_of(matrix, flown.number) else { continue };
        let Action::Discrete { direction, .. } = case.action else { continue };
        let key = (flown.model, case.mass, case.h_m.to_bits(), case.v_m_s.to_bits(), direction.word());
        match families.iter_mut().find(|family| family.key == key) {
            Some(family) => family.cases.push((flown, case)),
            None => families.push(Family { key, cases: vec![(flown, case)] }),
        }
    }
    families.iter().flat_map(|family| family.ends(names)).collect()
}

impl Family<'_> {
    fn ends(&self, names: &[String]) -> Vec<WorstGust> {
        let all = || {
            self.cases.iter().flat_map(|(flown, case)| {
                flown
                    .instants
                    .iter()
                    .filter_map(move |instant| Some((*flown, instant, gradient_m(case, instant)?)))
            })
        };
        let shortest_m = all().map(|one| one.2).fold(f64::INFINITY, f64::min);
        let longest_m = all().map(|one| one.2).fold(f64::NEG_INFINITY, f64::max);
        let mut ends = Vec::new();
        for (place, station) in names.iter().enumerate() {
            for (at, load) in LOADS.into_iter().enumerate() {
                for (end, sign) in [("smallest", -1.0), ("largest", 1.0)] {
                    let value = |one: &(_, &fullaircraft::design_loads::instants::FlownInstant, _)| {
                        sign * one.1.net()[place][at]
                    };
                    let worst = all().max_by(|a, b| value(a).total_cmp(&value(b)));
                    let Some((flown, instant, h_m)) = worst else { continue };
                    let companions = instant.net()[place];
                    ends.push(WorstGust {
                        model: MODELS[flown.model],
                        case: flown.number,
                        station: station.clone(),
                        load,
                        end,
                        h_m,
                        value: companions[at],
                        t_s: instant.t_s,
                        tuned: h_m > shortest_m && h_m < longest_m,
                        companions,
                    });
                }
            }
        }
        ends
    }
}

/// All as `gusts.csv`.
pub(crate) fn csv(all: &[WorstGust]) -> String {
    let mut text =
        String::from("model,case,station,load,end,H_m,value,t_s,tuned,Fx_N,Fy_N,Fz_N,Mx_Nm,My_Nm,Mz_Nm\n");
    for one in all {
        let WorstGust { model, case, station, load, end, h_m, value, t_s, .. } = one;
        let tuned = if one.tuned { "yes" } else { "no: at the end of the range" };
        // Writing to a String cannot fail.
        let _ = write!(text, "{model},{case},{station},{load},{end},{h_m:.4},{value:.9e},{t_s},{tuned}");
        for load in one.companions {
            let _ = write!(text, ",{load:.9e}");
        }
        text.push('\n');
    }
    text
}

/// The worst of all families for Fz, Mx and My of some stations.
pub(crate) fn of_stations(all: Vec<WorstGust>, is_shown: &dyn Fn(&str) -> bool) -> Vec<WorstGust> {
    let mut roots: Vec<WorstGust> = Vec::new();
    for one in all.into_iter().filter(|one| is_shown(&one.station) && LOADS[2..5].contains(&one.load)) {
        let same = |other: &&mut WorstGust| {
            (other.model, &other.station, other.load, other.end)
                == (one.model, &one.station, one.load, one.end)
        };
        match roots.iter_mut().find(same) {
            Some(known) => {
                let sign = if one.end == "largest" { 1.0 } else { -1.0 };
                if sign * one.value > sign * known.value {
                    *known = one;
                }
            }
            None => roots.push(one),
        }
    }
    roots
}

/// The moments of the right root, or of the first station, with the updated model, in a line.
pub(crate) fn line(roots: &[WorstGust]) -> Option<String> {
    let station = shown_station(roots.iter().map(|one| one.station.as_str()))?;
    let of = |load: &str| {
        let own =
            roots.iter().filter(|one| one.model == MODELS[1] && one.station == station && one.load == load);
        own.max_by(|a, b| a.value.abs().total_cmp(&b.value.abs()))
    };
    let words = |one: &WorstGust| {
        let tuned = if one.tuned { "" } else { ", at the range's end: not tuned" };
        format!("{} {:.4} at H {:.1} m{tuned}", one.load, one.value, one.h_m)
    };
    let all: Vec<String> = ["Mx_Nm", "My_Nm"].into_iter().filter_map(|load| Some(words(of(load)?))).collect();
    (!all.is_empty()).then(|| format!("gusts        {station} {} (updated)\n", all.join("; ")))
}

/// The right root where there is one, else the first station.
pub(crate) fn shown_station<'s>(mut names: impl Iterator<Item = &'s str>) -> Option<&'s str> {
    let first = names.next()?;
    Some(std::iter::once(first).chain(names).find(|name| *name == "right root").unwrap_or(first))
}
