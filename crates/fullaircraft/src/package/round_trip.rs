//! The round trip: cards and structure are read back by our own reader as a user's are, summed at the stations, and put on
//! the structure held at the wing's root.
//!
//! Stations must hold within 1e-9 of the case's largest force or moment, the whole within 1e-9 of the sum of sizes, tips within 1e-9
//! of the sum of what each load does to them.

use crate::aircraft::assembly::Aircraft;
use crate::error::AircraftError;
use crate::package::cards::CardCase;
use crate::stations::places::Station;
use faer::Mat;
use nalgebra::Point3;
use nastran::{BulkData, InputError, parse_deck};
use std::fmt::Write as _;
use structure::{Flexibility, Model, System};

/// What agrees this closely, as a share of the largest, is the same.
pub const TOLERANCE: f64 = 1e-9;
/// The six loads with their units.
pub const LOADS: [&str; 6] = ["Fx_N", "Fy_N", "Fz_N", "Mx_Nm", "My_Nm", "Mz_Nm"];

/// A number of the solver beside the same of the cards.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The case's load set.
    pub sid: u32,
    /// Station, `right tip`, `left tip` or `balance`.
    pub place: String,
    /// One of [`LOADS`] or `deflection_m`.
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
    /// Height of the right and left tip over the plane of the wing's root under the net loads, m.
    pub tips_m: [f64; 2],
}

/// A structure that was read from its file, and how its tips answer loads.
#[derive(Debug)]
pub struct RoundTrip<'a> {
    stations: &'a [Station],
    /// From our nodes to those that were read.
    nodes: Vec<usize>,
    read: System,
    /// Height of both tips by loads on the g-set that was read.
    tips: Mat<f64>,
}

/// How high both tips rise by loads on the g-set of a structure held at a node, g-set by 2, m/N and m/N m: by reciprocity the
/// displacements under a unit load at each tip.
///
/// # Errors
/// If the structure is free to move when held there.
pub fn tips_by_loads(free: &System, centre: usize, tips: [usize; 2]) -> Result<Mat<f64>, AircraftError> {
    let held = free.clamped_at(centre);
    let flexibility = Flexibility::new(&held).map_err(coupling::CouplingError::from)?;
    let mut units = Mat::zeros(6 * free.node_count(), 2);
    tips.iter().enumerate().for_each(|(side, tip)| units[(6 * tip + 2, side)] = 1.0);
    let solve = |loads: &Mat<f64>| {
        held.expand(flexibility.displacements(held.reduce(loads.as_ref()).as_ref()).as_ref())
    };
    // thin shells are badly conditioned: one step of refinement takes off what the factors leave of rounding
    let first = solve(&units);
    let left = units - held.elastic_loads(first.as_ref());
    Ok(first + solve(&left))
}

impl<'a> RoundTrip<'a> {
    /// Reads the structure.
    ///
    /// # Errors
    /// If it cannot be read, or a grid of the aircraft is not there or elsewhere.
    pub fn new(aircraft: &Aircraft, stations: &'a [Station], structure: &str) -> Result<Self, AircraftError> {
        let bulk = parse_deck("aircraft.bdf", structure)?;
        let read = System::assemble(&Model::from_bulk(&bulk)?)?;
        let nodes = aircraft.free.node_ids().iter().zip(aircraft.free.points()).map(|(id, point)| {
            let node = read.node_index(*id).filter(|node| (read.points()[*node] - point).norm() < TOLERANCE);
            node.ok_or_else(|| InputError::general(format!("grid {id} is not where it was in aircraft.bdf")))
        });
        let nodes: Vec<usize> = nodes.collect::<Result<_, _>>()?;
        let tips = [aircraft.right.tip, aircraft.left.tip].map(|tip| nodes[tip]);
        let tips = tips_by_loads(&read, nodes[aircraft.centre], tips)?;
        Ok(Self { stations, nodes, read, tips })
    }

    /// Reads the cards of a case (`text`, its file) and compares.
    ///
    /// # Errors
    /// If they cannot be read, or are of another load set.
    pub fn compare(
        &self,
        case: &CardCase,
        text: &str,
        expected: &Expected,
    ) -> Result<Vec<Row>, AircraftError> {
        let loads = self.loads(case.sid, &parse_deck(&case.file(), text)?)?;
        let points = self.read.points();
        let own = |station: &Station| Station {
            nodes: station.nodes.iter().map(|node| self.nodes[*node]).collect(),
            ..station.clone()
        };
        let sums: Vec<[f64; 6]> =
            self.stations.iter().map(|station| own(station).sums(points, &loads)).collect();
        let row = |place: &str, what, solver: f64, cards: f64, largest: f64| {
            let off = (solver - cards).abs();
            let of_largest = if off == 0.0 { 0.0 } else { off / largest };
            Row { sid: case.sid, place: place.to_owned(), what, solver, cards, of_largest }
        };
        let mut rows = Vec::new();
        for (load, what) in LOADS.into_iter().enumerate() {
            let kind = 3 * (load / 3)..3 * (load / 3) + 3;
            let of_kind = expected.stations.iter().flat_map(|six| &six[kind.clone()]);
            let largest = of_kind.fold(0.0_f64, |most, value| most.max(value.abs()));
            for ((station, cards), solver) in self.stations.iter().zip(&sums).zip(&expected.stations) {
                rows.push(row(&station.name, what, solver[load], cards[load], largest));
            }
        }
        let about = points[self.nodes[0]];
        let whole = Station {
            name: "balance".to_owned(),
            channel: "balance".to_owned(),
            point: about,
            nodes: (0..points.len()).collect(),
        };
        let sizes = sizes(points, &about, &loads);
        for (load, what) in LOADS.into_iter().enumerate() {
            rows.push(row("balance", what, 0.0, whole.sums(points, &loads)[load], sizes[load / 3]));
        }
        for (side, place) in ["right tip", "left tip"].into_iter().enumerate() {
            let does = loads.iter().enumerate().map(|(dof, load)| self.tips[(dof, side)] * load);
            let largest = does.clone().map(f64::abs).sum();
            rows.push(row(place, "deflection_m", expected.tips_m[side], does.sum(), largest));
        }
        Ok(rows)
    }

    /// Loads on the g-set that was read.
    fn loads(&self, sid: u32, deck: &BulkData) -> Result<Vec<f64>, InputError> {
        let mut loads = vec![0.0; 6 * self.read.node_count()];
        for card in &deck.point_loads {
            let node = self.read.node_index(card.grid).filter(|_| card.set == sid && card.cid == 0);
            let node = node.ok_or_else(|| {
                let message =
                    format!("this load of set {} at grid {} is not of case {sid}", card.set, card.grid);
                InputError::at(&card.span, message)
            })?;
            let first = 6 * node + if card.is_moment { 3 } else { 0 };
            (0..3).for_each(|axis| loads[first + axis] += card.vector[axis]);
        }
        Ok(loads)
    }
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
