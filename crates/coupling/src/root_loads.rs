//! Root loads: what the wing puts on the balance.

use aero::Lattice;
use faer::Mat;
use nalgebra::{Point3, Vector3};

/// What the wing puts on the balance, in axes that pitch with it, about the balance point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RootLoads {
    /// Force, up positive, N.
    pub fz_n: f64,
    /// Bending moment, tip up positive (+y Fz), N m.
    pub mx_nm: f64,
    /// Torsion moment, nose up positive (-x Fz), N m.
    pub my_nm: f64,
}

impl RootLoads {
    /// From the order Fz, Mx, My.
    pub fn from_array(values: [f64; 3]) -> Self {
        Self { fz_n: values[0], mx_nm: values[1], my_nm: values[2] }
    }

    /// In the order Fz, Mx, My.
    pub fn to_array(self) -> [f64; 3] {
        [self.fz_n, self.mx_nm, self.my_nm]
    }
}

impl std::ops::Add for RootLoads {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            fz_n: self.fz_n + other.fz_n,
            mx_nm: self.mx_nm + other.mx_nm,
            my_nm: self.my_nm + other.my_nm,
        }
    }
}

impl std::ops::Sub for RootLoads {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self {
            fz_n: self.fz_n - other.fz_n,
            mx_nm: self.mx_nm - other.mx_nm,
            my_nm: self.my_nm - other.my_nm,
        }
    }
}

/// The balance: the point its moments are about, and which boxes hang on it.
#[derive(Debug, Clone, PartialEq)]
pub struct Balance {
    /// Point the moments are about, basic axes, m.
    pub point: Point3<f64>,
    /// Per box of the lattice: does its load reach the balance? (A fairing may stand on the wall.)
    pub metric: Vec<bool>,
}

/// R: 3 rows (Fz, Mx, My) by two columns a box. A load along the box normal at the midpoint and a moment about
/// the box pitch axis, taken to the balance point; zero columns for boxes that are not metric.
pub fn root_rows(lattice: &Lattice, balance: &Balance) -> Mat<f64> {
    let mut rows = Mat::zeros(3, 2 * lattice.len());
    for (j, panel) in lattice.boxes.iter().enumerate().filter(|(j, _)| balance.metric[*j]) {
        let (n, e) = (panel.normal(), panel.pitch_axis());
        let moment: Vector3<f64> = (panel.mid_point() - balance.point).cross(&n);
        rows[(0, 2 * j)] = n.z;
        rows[(1, 2 * j)] = moment.x;
        rows[(2, 2 * j)] = moment.y;
        rows[(1, 2 * j + 1)] = e.x;
        rows[(2, 2 * j + 1)] = e.y;
    }
    rows
}
