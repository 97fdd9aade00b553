//! What is looked at in flight, as rows: generalised forces of the air, and loads of parts of the aircraft as sums of air loads
//! and inertia.
//!
//! ```text
//! load of a part = T rows P - inertia (a, omega', eta'', omega omega)
//! ```
//! T turns the air's loads about the centre of gravity as the equations of flight do, so that the whole aircraft's sum is zero.
//! The last six columns are the centripetal accelerations `omega x (omega x r)`, linear in the products of the rates. Gravity is
//! an acceleration upwards. Fz up, Mx, My about the part's point in aircraft axes (x aft, y right, z up) on both sides.

use crate::aircraft::assembly::{Aircraft, WingPlaces};
use crate::flight::modes::FreeModes;
use faer::{Mat, MatRef};
use maneuver::Station;
use nalgebra::{Matrix3, Point3, Vector3};

/// Products of rates: xx, yy, zz, xy, xz, yz.
pub(crate) const PRODUCTS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// See the module.
#[derive(Debug, Clone)]
pub(crate) struct LoadParts {
    /// Names of the parts, three loads each: `right`, `left`, then stations, and the whole aircraft last.
    pub(crate) names: Vec<String>,
    /// From each part's point to the centre of gravity, m.
    pub(crate) to_centre: Vec<Vector3<f64>>,
    /// Forces and moments about the centre of gravity, six rows a part, by box loads, two columns a box.
    pub(crate) air: Mat<f64>,
    /// Fz, Mx, My about the part's point by six rigid accelerations about the centre of gravity, modal accelerations and
    /// products of rates.
    pub(crate) inertia: Mat<f64>,
}

impl LoadParts {
    /// Both wings at their roots, then every monitoring station on both sides, then the whole.
    pub(crate) fn new(aircraft: &Aircraft, modes: &FreeModes) -> Self {
        let root = aircraft.root_point();
        let mut parts = vec![
            ("right".to_owned(), root, aircraft.right.clone()),
            ("left".to_owned(), root, aircraft.left.clone()),
        ];
        for station in Station::of_wing(&aircraft.wing) {
            for (wing, side, sign) in [(&aircraft.right, "right", 1.0), (&aircraft.left, "left", -1.0)] {
                let point = Point3::new(station.point.x, sign * station.point.y, station.point.z);
                parts.push((format!("{}_{side}", station.name), point, outboard(aircraft, wing, &point)));
            }
        }
        let whole = WingPlaces {
            boxes: (0..aircraft.flow.lattice.len()).collect(),
            nodes: (0..aircraft.free.node_count()).collect(),
            ..aircraft.right.clone()
        };
        parts.push(("whole".to_owned(), aircraft.mass.centre, whole));
        let momentum = momentum(aircraft, modes);
        let mut air = Mat::zeros(6 * parts.len(), 2 * aircraft.flow.lattice.len());
        let mut inertia = Mat::zeros(3 * parts.len(), momentum.ncols());
        for (at, (_, point, part)) in parts.iter().enumerate() {
            put_air(aircraft, part, &mut air, 6 * at);
            let nodal = nodal_loads(aircraft, part, point, momentum.as_ref());
            inertia.as_mut().subrows_mut(3 * at, 3).copy_from(&nodal);
        }
        Self {
            to_centre: parts.iter().map(|(_, point, _)| aircraft.mass.centre - point).collect(),
            names: parts.into_iter().map(|(name, ..)| name).collect(),
            air,
            inertia,
        }
    }
}

/// Forces and moments about the centre of gravity of box loads on a part, into six rows from `first` on.
fn put_air(aircraft: &Aircraft, part: &WingPlaces, air: &mut Mat<f64>, first: usize) {
    for &j in &part.boxes {
        let panel = &aircraft.flow.lattice.boxes[j];
        let (n, axis) = (panel.normal(), panel.pitch_axis());
        let moment = (panel.mid_point() - aircraft.mass.centre).cross(&n);
        for i in 0..3 {
            air[(first + i, 2 * j)] = n[i];
            air[(first + 3 + i, 2 * j)] = moment[i];
            air[(first + 3 + i, 2 * j + 1)] = axis[i];
        }
    }
}

/// Boxes and nodes of a wing beyond a point's |y|.
fn outboard(aircraft: &Aircraft, wing: &WingPlaces, point: &Point3<f64>) -> WingPlaces {
    let beyond = |y: f64| y * point.y.signum() > point.y.abs();
    let lattice = &aircraft.flow.lattice;
    WingPlaces {
        boxes: wing.boxes.iter().copied().filter(|&j| beyond(lattice.boxes[j].mid_point().y)).collect(),
        nodes: wing.nodes.iter().copied().filter(|&i| beyond(aircraft.free.points()[i].y)).collect(),
        ..wing.clone()
    }
}

/// Forces on the g-set that accelerate the masses: six rigid accelerations about the centre of gravity, the elastic modes,
/// products of rates.
fn momentum(aircraft: &Aircraft, modes: &FreeModes) -> Mat<f64> {
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

/// Fz, Mx, My about a point of nodal loads (g-set) on a part.
fn nodal_loads(
    aircraft: &Aircraft,
    part: &WingPlaces,
    about: &Point3<f64>,
    f_g: MatRef<'_, f64>,
) -> Mat<f64> {
    let mut sums = Mat::zeros(3, f_g.ncols());
    for column in 0..f_g.ncols() {
        for &node in &part.nodes {
            let of = |from: usize| Vector3::from_fn(|axis, _| f_g[(6 * node + from + axis, column)]);
            let (force, moment) = (of(0), of(3));
            let moment = moment + (aircraft.free.points()[node] - about).cross(&force);
            sums[(0, column)] += force.z;
            sums[(1, column)] += moment.x;
            sums[(2, column)] += moment.y;
        }
    }
    sums
}
