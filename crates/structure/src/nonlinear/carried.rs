//! Points carried by nodes of the structure, in three dimensions: places and rotations of now, and loads back to the nodes.
//!
//! A point has a spline's rows N over the motions of its nodes. These are seen from the frame Q that turns with the nodes,
//! where they are small (d, as an element's): place c + Q (X - C + N_u d), rotation Q exp(N_r d). Loads
//! go back by the same virtual work, so that nothing is lost however far the nodes have turned.

use super::corotated::{Corotated, Placed};
use super::rotation::by_spin;
use super::state::State;
use nalgebra::{DMatrix, DVector, Matrix3, Point3, Rotation3, SMatrix, Vector3};
use std::collections::BTreeMap;

/// A point and what it hangs on.
#[derive(Debug, Clone)]
pub struct CarriedPoint {
    /// Its undeformed place, m.
    pub origin: Point3<f64>,
    /// The nodes that carry it, by position.
    pub nodes: Vec<usize>,
    /// Displacement (m) and rotation (rad) of the point by those of the nodes: 6 by 6 a node, basic axes; exact for rigid
    /// motions.
    pub rows: DMatrix<f64>,
}

/// Points of one structure.
#[derive(Debug, Clone)]
pub struct Carried {
    carriers: Vec<Corotated>,
    /// Carrier of each point, its arm from the carrier's middle, and its rows.
    points: Vec<(usize, Vector3<f64>, DMatrix<f64>)>,
}

/// The carriers at a state.
pub struct PlacedCarriers {
    all: Vec<(Placed, Vector3<f64>)>,
}

impl Carried {
    /// Of points on nodes at undeformed places (all nodes of the structure, m).
    pub fn new(nodes: &[Vector3<f64>], points: &[CarriedPoint]) -> Self {
        let mut known: BTreeMap<Vec<usize>, usize> = BTreeMap::new();
        let mut carriers = Vec::new();
        let mut tie = |point: &CarriedPoint| {
            let at = *known.entry(point.nodes.clone()).or_insert_with(|| {
                carriers.push(Corotated::carrier(&point.nodes, nodes));
                carriers.len() - 1
            });
            (at, point.origin.coords - middle(&point.nodes, nodes), point.rows.clone())
        };
        let points = points.iter().map(&mut tie).collect();
        Self { carriers, points }
    }

    /// The carriers at a state.
    pub fn placed(&self, state: &State) -> PlacedCarriers {
        let one = |carrier: &Corotated| (carrier.placed(state), middle(&carrier.nodes, &state.places));
        PlacedCarriers { all: self.carriers.iter().map(one).collect() }
    }

    /// Place (m) and rotation from the undeformed attitude of a point.
    pub fn place(&self, placed: &PlacedCarriers, point: usize) -> (Vector3<f64>, Rotation3<f64>) {
        let (carrier, arm, rows) = &self.points[point];
        let (placed, middle) = &placed.all[*carrier];
        let [moved, turned] = small(rows, &placed.motion);
        let frame = Rotation3::from_matrix_unchecked(placed.q);
        (middle + frame * (arm + moved), frame * Rotation3::from_scaled_axis(turned))
    }

    /// Forces and moments on the nodes (N, Nm; g-set of `nodes` nodes, basic axes, moments over spins) of a force (N) and a
    /// moment (Nm) at each point.
    pub fn forces(&self, placed: &PlacedCarriers, loads: &[[Vector3<f64>; 2]], nodes: usize) -> Vec<f64> {
        // By carrier: force and moment about its middle, and what the small motions of its nodes feel.
        let mut sums: Vec<(DVector<f64>, DVector<f64>)> = self
            .carriers
            .iter()
            .map(|carrier| (DVector::zeros(6), DVector::zeros(6 * carrier.nodes.len())))
            .collect();
        for ((carrier, arm, rows), [force, moment]) in self.points.iter().zip(loads) {
            let placed = &placed.all[*carrier].0;
            let [moved, turned] = small(rows, &placed.motion);
            let (f, m) = (placed.q.transpose() * force, placed.q.transpose() * moment);
            let about = m + (arm + moved).cross(&f);
            let back = by_spin(&turned).try_inverse().unwrap_or_else(Matrix3::identity).transpose();
            let own = SMatrix::<f64, 6, 1>::from_iterator(f.iter().chain(&(back * m)).copied());
            let (rigid, local) = &mut sums[*carrier];
            (0..3).for_each(|i| {
                rigid[i] += f[i];
                rigid[3 + i] += about[i];
            });
            *local += rows.transpose() * own;
        }
        let mut all = vec![0.0; 6 * nodes];
        for ((carrier, (placed, _)), (rigid, local)) in self.carriers.iter().zip(&placed.all).zip(&sums) {
            let mut own = carrier.balanced(placed, local);
            if let Some((_, spread)) = carrier.projector(placed) {
                own += spread * rigid;
            }
            for (node, part) in carrier.nodes.iter().zip(own.as_slice().chunks_exact(6)) {
                for first in [0, 3] {
                    let turned = placed.q * Vector3::new(part[first], part[first + 1], part[first + 2]);
                    (0..3).for_each(|i| all[6 * node + first + i] += turned[i]);
                }
            }
        }
        all
    }
}

fn middle(nodes: &[usize], places: &[Vector3<f64>]) -> Vector3<f64> {
    nodes.iter().map(|node| places[*node]).sum::<Vector3<f64>>() / nodes.len() as f64
}

/// Displacement and rotation vector of a point in its carrier's frame.
fn small(rows: &DMatrix<f64>, motion: &DVector<f64>) -> [Vector3<f64>; 2] {
    let all = rows * motion;
    [Vector3::new(all[0], all[1], all[2]), Vector3::new(all[3], all[4], all[5])]
}
