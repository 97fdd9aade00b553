//! Rows of a round trip: a number of the solver beside the same of the cards.

use crate::stations::places::Station;
use nalgebra::{Matrix3, Point3};
use std::fmt::Write as _;

/// What agrees this closely, as a share of the largest, is the same.
pub const TOLERANCE: f64 = 1e-9;
/// The six loads with their units.
pub const LOADS: [&str; 6] = ["Fx_N", "Fy_N", "Fz_N", "Mx_Nm", "My_Nm", "Mz_Nm"];

/// A number of the solver beside the same of the cards.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The case's load set.
    pub sid: u32,
    /// Station, `right tip`, `left tip`, `balance` or `structure`.
    pub place: String,
    /// One of [`LOADS`], `deflection_m` or `stiffness`.
    pub what: &'static str,
    /// By the solver.
    pub solver: f64,
    /// By the cards.
    pub cards: f64,
    /// Their difference over the largest of its kind.
    pub of_largest: f64,
}

impl Row {
    /// Whether both are the same.
    pub fn holds(&self) -> bool {
        self.of_largest <= TOLERANCE
    }
}

/// What the solver says of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Expected {
    /// Net loads at each station.
    pub stations: Vec<[f64; 6]>,
    /// Height of each tip over where the structure is held, under the net loads, m.
    pub tips_m: Vec<f64>,
}

impl Row {
    /// The solver's number and the cards', and the largest of their kind.
    pub(crate) fn new(
        sid: u32,
        place: &str,
        what: &'static str,
        [solver, cards]: [f64; 2],
        largest: f64,
    ) -> Self {
        let off = (solver - cards).abs();
        let of_largest = if off == 0.0 { 0.0 } else { off / largest };
        Self { sid, place: place.to_owned(), what, solver, cards, of_largest }
    }
}

/// A sum of the loads of the whole that is to be nothing: their work in a rigid motion that no constraint hinders.
#[derive(Debug, Clone, PartialEq)]
pub struct Balanced {
    /// Which of [`LOADS`] it is called.
    pub load: usize,
    /// Point of the moments.
    pub about: Point3<f64>,
    /// Shares of the six loads about that point in it: how far the motion takes it, and turns it.
    pub shares: [f64; 6],
}

impl Balanced {
    /// All six loads about a point.
    pub fn all(about: Point3<f64>) -> Vec<Self> {
        let unit = |load| std::array::from_fn(|at| f64::from(u8::from(at == load)));
        (0..6).map(|load| Self { load, about, shares: unit(load) }).collect()
    }
}

/// Loads at stations beside those summed from cards, as shares of the largest force or moment.
pub(crate) fn station_rows(
    sid: u32,
    stations: &[Station],
    expected: &[[f64; 6]],
    sums: &[[f64; 6]],
) -> Vec<Row> {
    let mut rows = Vec::new();
    for (load, what) in LOADS.into_iter().enumerate() {
        let kind = 3 * (load / 3)..3 * (load / 3) + 3;
        let of_kind = expected.iter().flat_map(|six| &six[kind.clone()]);
        let largest = of_kind.fold(0.0_f64, |most, value| most.max(value.abs()));
        for ((station, cards), solver) in stations.iter().zip(sums).zip(expected) {
            rows.push(Row::new(sid, &station.name, what, [solver[load], cards[load]], largest));
        }
    }
    rows
}

/// Sums of the loads of the whole that are to be nothing, as shares of the sum of sizes.
pub(crate) fn balance_rows(
    sid: u32,
    points: &[Point3<f64>],
    loads: &[f64],
    balanced: &[Balanced],
) -> Vec<Row> {
    let row = |one: &Balanced| {
        let whole = Station {
            name: "balance".to_owned(),
            channel: "balance".to_owned(),
            point: one.about,
            nodes: (0..points.len()).collect(),
            axes: Matrix3::identity(),
        };
        let left: f64 =
            whole.sums(points, loads).iter().zip(one.shares).map(|(sum, share)| sum * share).sum();
        Row::new(sid, "balance", LOADS[one.load], [0.0, left], sizes(points, &one.about, loads)[one.load / 3])
    };
    balanced.iter().map(row).collect()
}

/// Sums of sizes of forces, and of their moments about a point with the moments.
fn sizes(points: &[Point3<f64>], about: &Point3<f64>, loads: &[f64]) -> [f64; 2] {
    let norm = |three: &[f64]| three.iter().map(|value| value * value).sum::<f64>().sqrt();
    let mut sizes = [0.0, 0.0];
    for (point, six) in points.iter().zip(loads.chunks_exact(6)) {
        sizes[0] += norm(&six[..3]);
        sizes[1] += norm(&six[3..]) + (point - about).norm() * norm(&six[..3]);
    }
    sizes
}

/// All rows as CSV.
pub fn round_trip_csv(rows: &[Row]) -> String {
    let mut text = String::from("sid,station,load,solver,cards,difference,of_largest,verdict\n");
    for row in rows {
        let verdict = if row.holds() { "reproduced" } else { "not reproduced" };
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "{},{},{},{:e},{:e},{:e},{:e},{verdict}",
            row.sid,
            row.place,
            row.what,
            row.solver,
            row.cards,
            row.cards - row.solver,
            row.of_largest
        );
    }
    text
}

#[cfg(test)]
mod tests;
