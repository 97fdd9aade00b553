//! The round trip: cards and structure are read back by our own reader as a user's are, summed at the stations, and put on
//! the structure held at the wing's root.
//!
//! Stations must hold within 1e-9 of the case's largest force or moment, the whole within 1e-9 of the sum of sizes, tips within 1e-9
//! of the sum of what each load does to them. The structure that was read must have the stiffness of the aircraft's, each coefficient
//! within 1e-9 of the geometric mean of its diagonals; what the loads do to the tips is then asked of the
//! aircraft's own: thin shells are so badly conditioned that the tips of the structure that was read, whose numbers differ in the
//! last digits of cards, are 2.4e-9 off.

use crate::aircraft::assembly::Aircraft;
use crate::error::AircraftError;
use crate::package::cards::CardCase;
use crate::stations::places::Station;
use faer::{Mat, MatRef};
use nalgebra::Point3;
use nastran::{BulkData, InputError, parse_deck};
use std::collections::BTreeMap;
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
    /// Height of the right and left tip over the plane of the wing's root under the net loads, m.
    pub tips_m: [f64; 2],
}

/// A structure that was read from its file, how far it is from the aircraft's, and how the tips answer loads.
#[derive(Debug)]
pub struct RoundTrip<'a> {
    stations: &'a [Station],
    /// Our nodes.
    points: Vec<Point3<f64>>,
    /// From our nodes to those that were read.
    nodes: Vec<usize>,
    read: System,
    /// Height of both tips by loads on the aircraft's g-set.
    tips: Mat<f64>,
    /// Largest difference of a coefficient of stiffness, as a share of the geometric mean of its diagonals.
    stiffness_off: f64,
}

/// How high both tips rise by loads on the g-set of a structure held at a node, g-set by 2, m/N and m/N m: by reciprocity the
/// displacements under a unit load at each tip.
///
/// # Errors
/// If the structure is free to move when held there.
fn tips_by_loads(free: &System, centre: usize, tips: [usize; 2]) -> Result<Mat<f64>, AircraftError> {
    let held = free.clamped_at(centre);
    let flexibility = Flexibility::new(&held).map_err(coupling::CouplingError::from)?;
    let mut units = Mat::zeros(6 * free.node_count(), 2);
    tips.iter().enumerate().for_each(|(side, tip)| units[(6 * tip + 2, side)] = 1.0);
    let solve = |loads: &Mat<f64>| {
        held.expand(flexibility.displacements(held.reduce(loads.as_ref()).as_ref()).as_ref())
    };
    Ok(solve(&units))
}

/// Largest difference of two structures' coefficients of stiffness between the same motions, as a share of the geometric mean of
/// the diagonals; one if they do not have the same motions.
fn stiffness_off(one: &System, other: &System) -> f64 {
    let place = |free: usize| (one.name(free), free);
    let places: BTreeMap<(u32, u8), usize> = (0..one.free_count()).map(place).collect();
    let Some(to_one) = (0..other.free_count())
        .map(|free| places.get(&other.name(free)).copied())
        .collect::<Option<Vec<_>>>()
    else {
        return 1.0;
    };
    if to_one.len() != one.free_count() {
        return 1.0;
    }
    let mut left: BTreeMap<(usize, usize), f64> = BTreeMap::new();
    let mut diagonal = vec![0.0; one.free_count()];
    for entry in one.stiffness().triplet_iter() {
        *left.entry((entry.row, entry.col)).or_default() += *entry.val;
        if entry.row == entry.col {
            diagonal[entry.row] += *entry.val;
        }
    }
    for entry in other.stiffness().triplet_iter() {
        *left.entry((to_one[entry.row], to_one[entry.col])).or_default() -= *entry.val;
    }
    let share = |((row, col), off): ((usize, usize), f64)| {
        let scale = (diagonal[row] * diagonal[col]).sqrt();
        if off == 0.0 { 0.0 } else { off.abs() / scale }
    };
    left.into_iter().map(share).fold(0.0, f64::max)
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
        let tips = tips_by_loads(&aircraft.free, aircraft.centre, [aircraft.right.tip, aircraft.left.tip])?;
        let stiffness_off = stiffness_off(&aircraft.free, &read);
        let points = aircraft.free.points().to_vec();
        Ok(Self { stations, points, nodes, read, tips, stiffness_off })
    }

    /// The aircraft's nodes.
    pub fn points(&self) -> &[Point3<f64>] {
        &self.points
    }

    /// Height of both tips by loads on the aircraft's g-set, g-set by 2, m/N and m/N m.
    pub fn tips(&self) -> MatRef<'_, f64> {
        self.tips.as_ref()
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
            let own = self
                .nodes
                .iter()
                .enumerate()
                .flat_map(|(own, node)| (0..6).map(move |c| (6 * own + c, 6 * node + c)));
            let does = own.map(|(own, read)| self.tips[(own, side)] * loads[read]);
            let largest = does.clone().map(f64::abs).sum();
            rows.push(row(place, "deflection_m", expected.tips_m[side], does.sum(), largest));
        }
        rows.push(row("structure", "stiffness", 1.0, 1.0 + self.stiffness_off, 1.0));
        Ok(rows)
    }

    /// Loads on the g-set that was read.
    fn loads(&self, sid: u32, deck: &BulkData) -> Result<Vec<f64>, InputError> {
        let mut loads = vec![0.0; 6 * self.read.node_count()];
        let factor = |set: u32| match deck.load_sums.get(&sid) {
            Some(sum) => {
                sum.parts.iter().filter(|(_, of)| *of == set).map(|(part, _)| sum.scale * part).sum()
            }
            None => f64::from(u8::from(set == sid)),
        };
        for card in &deck.point_loads {
            let factor: f64 = factor(card.set);
            let node = self.read.node_index(card.grid).filter(|_| factor != 0.0 && card.cid == 0);
            let node = node.ok_or_else(|| {
                let message =
                    format!("this load of set {} at grid {} is not of case {sid}", card.set, card.grid);
                InputError::at(&card.span, message)
            })?;
            let first = 6 * node + if card.is_moment { 3 } else { 0 };
            (0..3).for_each(|axis| loads[first + axis] += factor * card.vector[axis]);
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
