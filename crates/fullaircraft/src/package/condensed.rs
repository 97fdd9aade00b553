//! Loads condensed to the stations' points, for stress models that have a grid at each of them (a loads reference axis).
//!
//! ```text
//! F_i = sum f_g,   M_i = sum (r_g - r_i) x f_g + m_g      over the grids of station i that are in no station inside it
//! ```
//! Each point carries the difference of its cut to the next outboard ones, so that the points inside a cut, moved to it, add up to the
//! cut's loads exactly.

use crate::package::cards::{CardCase, comments};
use crate::package::rows::{Balanced, Expected, Row, balance_rows, station_rows};
use crate::stations::nodal::NodalLoads;
use crate::stations::places::Station;
use nalgebra::{Matrix3, Point3};
use nastran::{InputError, parse_deck};
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// Stations whose points carry loads.
#[derive(Debug, Clone)]
pub struct Condensed<'a> {
    stations: &'a [Station],
    /// Where the structure's nodes are.
    points: Vec<Point3<f64>>,
    /// By station: the nodes that count for its point, in the aircraft's axes.
    own: Vec<Station>,
    /// By station: places of all stations inside it, itself with them.
    inside: Vec<Vec<usize>>,
    /// Number of each station's grid.
    grids: Vec<u32>,
}

impl<'a> Condensed<'a> {
    /// Stations of a structure with nodes at `points`; their grids get numbers above `last`.
    ///
    /// # Errors
    /// If two stations share nodes and neither is inside the other, or a node is in no station.
    pub fn new(stations: &'a [Station], points: &[Point3<f64>], last: u32) -> Result<Self, InputError> {
        let sets: Vec<BTreeSet<usize>> =
            stations.iter().map(|station| station.nodes.iter().copied().collect()).collect();
        // of two with the same nodes the later is inside the earlier
        let is_inside = |inner: usize, outer: usize| {
            sets[inner].is_subset(&sets[outer]) && (sets[inner].len() < sets[outer].len() || inner >= outer)
        };
        for (a, one) in stations.iter().enumerate() {
            for (b, other) in stations.iter().enumerate().skip(a + 1) {
                let nested = sets[a].is_subset(&sets[b]) || sets[b].is_subset(&sets[a]);
                if !nested && !sets[a].is_disjoint(&sets[b]) {
                    let message = format!(
                        "stations {} and {} share grids and neither is inside the other: loads cannot be condensed to their points",
                        one.name, other.name
                    );
                    return Err(InputError::general(message)
                        .with_help("write export: (at: Grids), or leave one of them out"));
                }
            }
        }
        let covered: BTreeSet<usize> = sets.iter().flatten().copied().collect();
        if covered.len() != points.len() {
            let message = format!(
                "{} grids are in no station: their loads would be lost",
                points.len() - covered.len()
            );
            return Err(InputError::general(message).with_help("write export: (at: Grids)"));
        }
        let all = 0..stations.len();
        let inside: Vec<Vec<usize>> =
            all.clone().map(|outer| all.clone().filter(|inner| is_inside(*inner, outer)).collect()).collect();
        let own = all.map(|at| {
            let inner = inside[at].iter().filter(|inner| **inner != at);
            let theirs: BTreeSet<usize> = inner.flat_map(|inner| &sets[*inner]).copied().collect();
            let nodes = sets[at].difference(&theirs).copied().collect();
            Station { nodes, axes: Matrix3::identity(), ..stations[at].clone() }
        });
        let own: Vec<Station> = own.collect();
        let grids = (last + 1..).take(stations.len()).collect();
        Ok(Self { stations, points: points.to_vec(), own, inside, grids })
    }

    /// Numbers of the points' grids.
    pub fn grids(&self) -> &[u32] {
        &self.grids
    }

    /// Where they are.
    pub fn places(&self) -> Vec<Point3<f64>> {
        self.stations.iter().map(|station| station.point).collect()
    }

    /// Loads at the points, six each in the aircraft's axes, of loads on the g-set.
    pub fn loads(&self, f_g: &[f64]) -> Vec<f64> {
        self.own.iter().flat_map(|own| own.sums(&self.points, f_g)).collect()
    }

    /// All components of nodal loads at the points.
    pub fn nodal(&self, loads: &NodalLoads) -> NodalLoads {
        let NodalLoads { air, inertia, thrust, damping } = loads;
        NodalLoads {
            air: self.loads(air),
            inertia: self.loads(inertia),
            thrust: self.loads(thrust),
            damping: self.loads(damping),
        }
    }

    /// GRID cards of the points, to be included in a bulk data section.
    pub fn cards(&self, origin: &[String]) -> String {
        let mut text = comments(origin);
        for (grid, station) in self.grids.iter().zip(self.stations) {
            text += &comments(&[format!("grid {grid}: station {}", station.name)]);
            // Writing to a String cannot fail.
            let Point3 { coords } = station.point;
            let _ = writeln!(
                text,
                "GRID*   {grid:>16}{:>16}{:>16}{:>16}\n*       {:>16}",
                0,
                nastran::real::format(coords.x, 16),
                nastran::real::format(coords.y, 16),
                nastran::real::format(coords.z, 16)
            );
        }
        text
    }

    /// Reads the cards of a case (`text`, its file) and those of the points (`stations`) and compares cuts and balance: which of
    /// the six loads of the whole are to be nothing.
    ///
    /// # Errors
    /// If they cannot be read, or a load is at no point.
    pub fn compare(
        &self,
        case: &CardCase,
        text: &str,
        stations: &str,
        expected: &Expected,
        balanced: &[Balanced],
    ) -> Result<Vec<Row>, InputError> {
        let read = parse_deck("stations.bdf", stations)?;
        let places = self.grids.iter().map(|grid| {
            let missing = || InputError::general(format!("grid {grid} of stations.bdf is not there"));
            read.grids.get(grid).map(|grid| grid.xyz).ok_or_else(missing)
        });
        let places: Vec<Point3<f64>> = places.collect::<Result<_, _>>()?;
        let loads = case.read_back(&parse_deck(&case.file(), text)?, self.grids.len(), |grid| {
            self.grids.iter().position(|known| *known == grid)
        })?;
        let cut = |at: usize| {
            let nodes = self.inside[at].clone();
            Station { point: places[at], nodes, ..self.stations[at].clone() }.sums(&places, &loads)
        };
        let sums: Vec<[f64; 6]> = (0..self.stations.len()).map(cut).collect();
        let mut rows = station_rows(case.sid, self.stations, &expected.stations, &sums);
        rows.extend(balance_rows(case.sid, &places, &loads, balanced));
        Ok(rows)
    }
}
