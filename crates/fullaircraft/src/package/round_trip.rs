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
pub use crate::package::rows::{Balanced, Expected, LOADS, Row, TOLERANCE, round_trip_csv};
use crate::package::rows::{balance_rows, station_rows};
use crate::stations::places::Station;
use faer::{Mat, MatRef};
use nalgebra::Point3;
use nastran::{BulkData, InputError, parse_deck};
use std::collections::BTreeMap;
use structure::{Flexibility, Model, System};

/// The structure that loads were found on.
#[derive(Debug)]
pub struct Own<'o> {
    /// Free, as its cards are.
    pub free: &'o System,
    /// Held where no reaction may be left.
    pub held: &'o System,
    /// Names and nodes of the tips.
    pub tips: Vec<(&'static str, usize)>,
    /// What is in balance: the loads that no constraint carries.
    pub balanced: Vec<Balanced>,
    /// How a deck of this kind is read.
    pub assemble: fn(&BulkData) -> Result<System, InputError>,
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
    /// Height of the tips by loads on our g-set.
    tips: Mat<f64>,
    names: Vec<&'static str>,
    /// What is in balance.
    balanced: Vec<Balanced>,
    /// Largest difference of a coefficient of stiffness, as a share of the geometric mean of its diagonals.
    stiffness_off: f64,
}

/// How high tips rise by loads on the g-set of a structure, g-set by tips, m/N and m/N m: by reciprocity the
/// displacements under a unit load at each tip of the structure as it is held.
fn tips_by_loads(own: &Own<'_>) -> Result<Mat<f64>, AircraftError> {
    let flexibility = Flexibility::new(own.held).map_err(coupling::CouplingError::from)?;
    let mut units = Mat::zeros(6 * own.free.node_count(), own.tips.len());
    own.tips.iter().enumerate().for_each(|(side, (_, tip))| units[(6 * tip + 2, side)] = 1.0);
    Ok(own.held.expand(flexibility.displacements(own.held.reduce(units.as_ref()).as_ref()).as_ref()))
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
    let mut left: Vec<(usize, usize, f64)> = Vec::new();
    let mut diagonal = vec![0.0; one.free_count()];
    for entry in one.stiffness().triplet_iter() {
        left.push((entry.col, entry.row, *entry.val));
        if entry.row == entry.col {
            diagonal[entry.row] += *entry.val;
        }
    }
    let others = other.stiffness().triplet_iter();
    left.extend(others.map(|entry| (to_one[entry.col], to_one[entry.row], -*entry.val)));
    left.sort_unstable_by_key(|(col, row, _)| (*col, *row));
    let share = |same: &[(usize, usize, f64)]| {
        let off: f64 = same.iter().map(|(_, _, value)| value).sum();
        let (col, row, _) = same[0];
        if off == 0.0 { 0.0 } else { off.abs() / (diagonal[row] * diagonal[col]).sqrt() }
    };
    left.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).map(share).fold(0.0, f64::max)
}

impl<'a> RoundTrip<'a> {
    /// Reads the structure of an aircraft, which is held at the wing's root.
    ///
    /// # Errors
    /// If it cannot be read, or a grid of the aircraft is not there or elsewhere.
    pub fn new(aircraft: &Aircraft, stations: &'a [Station], structure: &str) -> Result<Self, AircraftError> {
        let held = aircraft.free.clamped_at(aircraft.centre);
        let own = Own {
            free: &aircraft.free,
            held: &held,
            tips: vec![("right tip", aircraft.right.tip), ("left tip", aircraft.left.tip)],
            balanced: Balanced::all(aircraft.free.points()[0]),
            assemble: |bulk| System::assemble(&Model::from_bulk(bulk)?),
        };
        Self::of(own, stations, structure)
    }

    /// Reads a structure.
    ///
    /// # Errors
    /// If it cannot be read, is free to move as it is held, or a grid of our own is not there or elsewhere.
    pub fn of(own: Own<'_>, stations: &'a [Station], structure: &str) -> Result<Self, AircraftError> {
        let read = (own.assemble)(&parse_deck("aircraft.bdf", structure)?)?;
        let nodes = own.free.node_ids().iter().zip(own.free.points()).map(|(id, point)| {
            let near = TOLERANCE * (1.0 + point.coords.norm());
            let node = read.node_index(*id).filter(|node| (read.points()[*node] - point).norm() < near);
            node.ok_or_else(|| InputError::general(format!("grid {id} is not where it was in aircraft.bdf")))
        });
        let nodes: Vec<usize> = nodes.collect::<Result<_, _>>()?;
        let tips = tips_by_loads(&own)?;
        let stiffness_off = stiffness_off(own.free, &read);
        let points = own.free.points().to_vec();
        let names = own.tips.iter().map(|(name, _)| *name).collect();
        let balanced = own.balanced;
        Ok(Self { stations, points, nodes, read, tips, names, balanced, stiffness_off })
    }

    /// The aircraft's nodes.
    pub fn points(&self) -> &[Point3<f64>] {
        &self.points
    }

    /// Which sums of the loads of the whole are in balance.
    pub fn balanced(&self) -> &[Balanced] {
        &self.balanced
    }

    /// Height of the tips by loads on the g-set, g-set by tips, m/N and m/N m.
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
        let deck = parse_deck(&case.file(), text)?;
        let loads = case.read_back(&deck, self.read.node_count(), |grid| self.read.node_index(grid))?;
        let points = self.read.points();
        let own = |station: &Station| Station {
            nodes: station.nodes.iter().map(|node| self.nodes[*node]).collect(),
            ..station.clone()
        };
        let sums: Vec<[f64; 6]> =
            self.stations.iter().map(|station| own(station).sums(points, &loads)).collect();
        let mut rows = station_rows(case.sid, self.stations, &expected.stations, &sums);
        rows.extend(balance_rows(case.sid, points, &loads, &self.balanced));
        let row = |place: &str, what, solver, cards, largest| {
            Row::new(case.sid, place, what, [solver, cards], largest)
        };
        for (side, place) in self.names.iter().enumerate() {
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
}
