//! What is looked at in flight, as rows: generalised forces of the air, and loads of parts of the aircraft as sums of air loads
//! and inertia.
//!
//! ```text
//! load of a part = T rows P - inertia (a, omega', eta'', omega omega)
//! ```
//! T turns the air's loads about the centre of gravity as the equations of flight do, so that the whole aircraft's sum is zero.
//! The last six columns are the centripetal accelerations `omega x (omega x r)`, linear in the products of the rates. Gravity is
//! an acceleration upwards. Fz up, Mx, My about the part's point in aircraft axes (x aft, y right, z up) on both sides.

use crate::aircraft::assembly::Aircraft;
use crate::error::AircraftError;
use crate::flight::modes::FreeModes;
use faer::Mat;
use nalgebra::{Matrix3, Vector3};

/// Products of rates: xx, yy, zz, xy, xz, yz.
pub(crate) const PRODUCTS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// See the module.
#[derive(Debug, Clone)]
pub(crate) struct LoadParts {
    /// Names of the parts, three loads each: `right`, `left`, then stations, and the whole aircraft last.
    pub(crate) names: Vec<String>,
    /// From each part's point to the centre of gravity, m.
    pub(crate) to_centre: Vec<Vector3<f64>>,
    /// Forces and moments about the centre of gravity of what box loads put on the nodes, six rows a part, two columns a box.
    pub(crate) air: Mat<f64>,
    /// Fz, Mx, My about the part's point by six rigid accelerations about the centre of gravity, modal accelerations and
    /// products of rates.
    pub(crate) inertia: Mat<f64>,
}

impl LoadParts {
    /// Both wings at their roots, then every station of the wing's file on both sides, then the whole; with the aircraft's [`momentum`].
    ///
    /// # Errors
    /// If a station has nothing outboard of it.
    pub(crate) fn new(aircraft: &Aircraft, momentum: &Mat<f64>) -> Result<Self, AircraftError> {
        let mut stations = aircraft.wing_stations(&[])?;
        stations.extend(aircraft.body_stations().pop());
        let (system, centre) = (&aircraft.free, &aircraft.mass.centre);
        let mut air = Mat::zeros(6 * stations.len(), 2 * aircraft.flow.lattice.len());
        let mut inertia = Mat::zeros(3 * stations.len(), momentum.ncols());
        for (at, station) in stations.iter().enumerate() {
            let boxes = aircraft.spline.displace(station.motions(system, centre).as_ref());
            air.as_mut().subrows_mut(6 * at, 6).copy_from(boxes.transpose());
            let sums = station.motions(system, &station.point).transpose() * momentum;
            inertia.as_mut().subrows_mut(3 * at, 3).copy_from(sums.as_ref().subrows(2, 3));
        }
        Ok(Self {
            to_centre: stations.iter().map(|station| centre - station.point).collect(),
            names: stations.into_iter().map(|station| station.channel).collect(),
            air,
            inertia,
        })
    }
}

/// Forces on the g-set that accelerate the masses: six rigid accelerations about the centre of gravity, the elastic modes,
/// products of rates.
pub(crate) fn momentum(aircraft: &Aircraft, modes: &FreeModes) -> Mat<f64> {
    let (system, elastic) = (&aircraft.free, modes.elastic());
    let rigid = system.rigid_body(&aircraft.mass.centre);
    let points = system.points();
    let fields = Mat::from_fn(rigid.nrows(), 6 + elastic + PRODUCTS.len(), |dof, column| match column {
        rigid_motion if rigid_motion < 6 => rigid[(dof, rigid_motion)],
        mode if mode < 6 + elastic => modes.elastic_shape(dof, mode - 6),
        _ if dof % 6 > 2 => 0.0,
        product => {
            centripetal(PRODUCTS[product - 6 - elastic], &(points[dof / 6] - aircraft.mass.centre))[dof % 6]
        }
    });
    let mut loads = system.inertia_loads(fields.as_ref());
    add_offsets(aircraft, &mut loads, 6 + elastic);
    loads
}

/// What a product of rates makes of the acceleration `omega (omega . r) - omega² r`.
fn centripetal((i, j): (usize, usize), arm: &Vector3<f64>) -> Vector3<f64> {
    Vector3::from_fn(|axis, _| match (i == j, axis == i, axis == j) {
        (true, false, _) => -arm[axis],
        (false, true, _) => arm[j],
        (false, _, true) => arm[i],
        _ => 0.0,
    })
}

/// Masses beside their nodes: what `omega x (omega x r)` is at a mass is no displacement and rotation of its node. First moments
/// s and inertias I of each node are read off its answer to unit rotations, `e x s` and `I e`; then
/// `omega x (omega x s)` is the force left out and `omega x I omega` the moment.
fn add_offsets(aircraft: &Aircraft, loads: &mut Mat<f64>, first: usize) {
    let count = aircraft.free.node_count();
    let turn = Mat::from_fn(6 * count, 3, |dof, axis| f64::from(u8::from(dof % 6 == 3 + axis)));
    let answer = aircraft.free.inertia_loads(turn.as_ref());
    for node in 0..count {
        let force = |axis: usize, by: usize| answer[(6 * node + axis, by)];
        let s = Vector3::new(
            0.5 * (force(1, 2) - force(2, 1)),
            0.5 * (force(2, 0) - force(0, 2)),
            0.5 * (force(0, 1) - force(1, 0)),
        );
        let inertia = Matrix3::from_fn(|axis, by| answer[(6 * node + 3 + axis, by)]);
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        for (product, &(i, j)) in PRODUCTS.iter().enumerate() {
            let mut moment = axes[i].cross(&(inertia * axes[j]));
            if i != j {
                moment += axes[j].cross(&(inertia * axes[i]));
            }
            let force = centripetal((i, j), &s);
            for axis in 0..3 {
                loads[(6 * node + axis, first + product)] += force[axis];
                loads[(6 * node + 3 + axis, first + product)] += moment[axis];
            }
        }
    }
}
