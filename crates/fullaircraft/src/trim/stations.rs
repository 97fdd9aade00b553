//! Where loads are monitored: the wing's roots and any points along the span, right and left.
//!
//! A station's loads are what everything outboard of it (air, weight and inertia) puts on the rest, about its point, in aircraft
//! axes on both sides: Fz up, Mx = +y Fz (negative on the left under lift), My nose up.

use crate::aircraft::assembly::{Aircraft, WingPlaces};
use coupling::wing_file::StationAt;
use coupling::{Balance, root_rows};
use faer::{Mat, MatRef};
use nalgebra::{Point3, Vector3};
use nastran::InputError;

/// A station on one side.
#[derive(Debug, Clone, PartialEq)]
pub struct Station {
    /// `right root`, `left NAME`...
    pub name: String,
    /// Point the moments are about.
    pub point: Point3<f64>,
    boxes: Vec<usize>,
    nodes: Vec<usize>,
}

/// Stations and how loads come together at them: three rows (Fz, Mx, My) a station.
#[derive(Debug, Clone)]
pub struct Stations {
    /// Right and left root, then right and left of each point.
    pub all: Vec<Station>,
    /// By box loads, two columns a box.
    pub(crate) air: Mat<f64>,
    /// By acceleration along and about the axes, about the centre of gravity: to be taken off.
    pub(crate) inertia: Mat<f64>,
}

impl Stations {
    /// The roots, the stations of the wing's file, and `points` of the right wing with their images.
    ///
    /// # Errors
    /// If two have the same name, or one has no boxes or grids outboard of it.
    pub fn new(aircraft: &Aircraft, points: &[StationAt]) -> Result<Self, InputError> {
        let root = aircraft.root_point();
        let whole = |side: &str, wing: &WingPlaces| Station {
            name: format!("{side} root"),
            point: root,
            boxes: wing.boxes.clone(),
            nodes: wing.nodes.clone(),
        };
        let mut all = vec![whole("right", &aircraft.right), whole("left", &aircraft.left)];
        let points: Vec<&StationAt> = aircraft.wing.stations.iter().chain(points).collect();
        for (at, point) in points.iter().enumerate() {
            if point.name == "root" || points[..at].iter().any(|other| other.name == point.name) {
                return Err(InputError::general(format!("two stations are called {}", point.name))
                    .with_help("give every station its own name; the wing's file may have some, too"));
            }
            all.push(outboard(aircraft, point, "right", &aircraft.right, 1.0)?);
            all.push(outboard(aircraft, point, "left", &aircraft.left, -1.0)?);
        }
        let about = Point3::new(aircraft.file.total.x_cg_m, 0.0, 0.0);
        let field = aircraft.free.inertia_loads(aircraft.free.rigid_body(&about).as_ref());
        let lattice = &aircraft.flow.lattice;
        let mut air = Mat::zeros(3 * all.len(), 2 * lattice.len());
        let mut inertia = Mat::zeros(3 * all.len(), 6);
        for (at, station) in all.iter().enumerate() {
            let mut metric = vec![false; lattice.len()];
            station.boxes.iter().for_each(|&place| metric[place] = true);
            let rows = root_rows(lattice, &Balance { point: station.point, metric });
            air.as_mut().submatrix_mut(3 * at, 0, 3, 2 * lattice.len()).copy_from(&rows);
            let rows = nodal_loads(aircraft, &station.nodes, &station.point, field.as_ref());
            inertia.as_mut().submatrix_mut(3 * at, 0, 3, 6).copy_from(&rows);
        }
        Ok(Self { all, air, inertia })
    }
}

fn outboard(
    aircraft: &Aircraft,
    point: &StationAt,
    side: &str,
    wing: &WingPlaces,
    sign: f64,
) -> Result<Station, InputError> {
    let beyond = |y_m: f64| sign * y_m > point.y_m;
    let mid_y = |at: &usize| aircraft.flow.lattice.boxes[*at].mid_point().y;
    let boxes: Vec<usize> = wing.boxes.iter().copied().filter(|at| beyond(mid_y(at))).collect();
    let nodes: Vec<usize> =
        wing.nodes.iter().copied().filter(|at| beyond(aircraft.free.points()[*at].y)).collect();
    if boxes.is_empty() || nodes.is_empty() {
        let message =
            format!("station {} has nothing of the wing outboard of y = {} m", point.name, point.y_m);
        return Err(
            InputError::general(message).with_help("expected a y between the wing's root and its tip")
        );
    }
    let root = aircraft.root_point();
    let place = Point3::new(point.x_m.unwrap_or(root.x), sign * point.y_m, point.z_m.unwrap_or(root.z));
    Ok(Station { name: format!("{side} {}", point.name), point: place, boxes, nodes })
}

/// Fz, Mx and My about a point (rows) of nodal loads at some nodes, g-set columns.
pub(crate) fn nodal_loads(
    aircraft: &Aircraft,
    nodes: &[usize],
    about: &Point3<f64>,
    f_g: MatRef<'_, f64>,
) -> Mat<f64> {
    let mut sums = Mat::zeros(3, f_g.ncols());
    for column in 0..f_g.ncols() {
        for &node in nodes {
            let part = |from: usize| Vector3::from_fn(|axis, _| f_g[(6 * node + from + axis, column)]);
            let (force, moment) = (part(0), part(3));
            let moment = moment + (aircraft.free.points()[node] - about).cross(&force);
            sums[(0, column)] += force.z;
            sums[(1, column)] += moment.x;
            sums[(2, column)] += moment.y;
        }
    }
    sums
}
