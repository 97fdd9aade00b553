//! Rows by which box loads are read: at the balance, at stations along the span, by strips. Two columns a box: the load along its
//! normal, and the moment about its pitch axis.

use crate::case::CorrectableBoxes;
use aero::Lattice;
use faer::Mat;
use nalgebra::{Point3, Vector3};

/// The balance: the point its moments are about, and which boxes hang on it.
#[derive(Debug, Clone, PartialEq)]
pub struct Balance {
    /// Point the moments are about, basic axes, m.
    pub point: Point3<f64>,
    /// Per box of the lattice: does its load reach the balance? (A fairing may stand on the wall.)
    pub metric: Vec<bool>,
}

/// R: root loads of box loads, of the boxes that are metric, about the balance point.
pub fn root_rows(lattice: &Lattice, balance: &Balance) -> Mat<f64> {
    rows_about(lattice, &balance.point, |j| balance.metric[j])
}

/// 3 rows (Fz, Mx, My about a point) by two columns a box: a load along the box normal at the midpoint and a moment about the box
/// pitch axis (which has no part along x, so none of it is Mx); zero columns for boxes that do not count.
fn rows_about(lattice: &Lattice, point: &Point3<f64>, counts: impl Fn(usize) -> bool) -> Mat<f64> {
    let mut rows = Mat::zeros(3, 2 * lattice.len());
    for (j, panel) in lattice.boxes.iter().enumerate().filter(|(j, _)| counts(*j)) {
        let (n, e) = (panel.normal(), panel.pitch_axis());
        let moment: Vector3<f64> = (panel.mid_point() - point).cross(&n);
        rows[(0, 2 * j)] = n.z;
        rows[(1, 2 * j)] = moment.x;
        rows[(2, 2 * j)] = moment.y;
        rows[(2, 2 * j + 1)] = e.y;
    }
    rows
}

/// The same of the metric boxes whose middle is outboard of a point: shear, bending and torsion at a station.
pub fn station_rows(lattice: &Lattice, balance: &Balance, point: &Point3<f64>) -> Mat<f64> {
    rows_about(lattice, point, |j| balance.metric[j] && lattice.boxes[j].mid_point().y > point.y)
}

/// Lift per metre of span of every strip of the correctable boxes, N/m, by two columns a box.
pub fn strip_rows(lattice: &Lattice, boxes: &CorrectableBoxes) -> Mat<f64> {
    let count = boxes.strip.iter().max().map_or(0, |last| last + 1);
    let mut rows = Mat::zeros(count, 2 * lattice.len());
    for (&place, &strip) in boxes.places.iter().zip(&boxes.strip) {
        let panel = &lattice.boxes[place];
        rows[(strip, 2 * place)] = panel.normal().z / panel.width_m();
    }
    rows
}
