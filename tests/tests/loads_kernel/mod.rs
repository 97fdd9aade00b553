//! The clamped wing of `data/loads_kernel` in our types: lattice, nodes, ten modes, camber, weight.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use aero::{ControlSurface, Lattice, MirrorPlane};
use coupling::{Balance, ElasticWing, Spline, SupportedStructure, WingParts};
use faer::{Mat, Side};
use nalgebra::Point3;
use nastran::table::Table;
use std::path::{Path, PathBuf};
use structure::System;

pub(crate) const GRAVITY_M_S2: f64 = 9.8066;
/// Standard atmosphere at height zero.
pub(crate) const RHO_KG_M3: f64 = 101_325.0 / 287.0531 / 288.15;
pub(crate) const MODES: usize = 10;
/// Degrees of freedom of its 29 nodes.
const SIZE: usize = 174;

pub(crate) fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../data/loads_kernel").join(name)
}

/// A symmetric matrix of 174 rows from its upper triangle.
fn matrix(name: &str) -> Mat<f64> {
    let table = Table::read(&data(name)).unwrap();
    let mut matrix = Mat::zeros(SIZE, SIZE);
    for row in 0..table.len() {
        let index = |column: &str| {
            let number = table.number(row, column).unwrap();
            (0..SIZE).find(|&i| i as f64 == number).unwrap()
        };
        let value = table.number(row, "value").unwrap();
        matrix[(index("row"), index("column"))] = value;
        matrix[(index("column"), index("row"))] = value;
    }
    matrix
}

pub(crate) struct LoadsKernelWing {
    points: Vec<Point3<f64>>,
    stiffness: Mat<f64>,
    mass: Mat<f64>,
    /// Ten modes of the structure clamped at its first node, 174 rows.
    shapes: Mat<f64>,
    omega2: Vec<f64>,
}

impl LoadsKernelWing {
    pub(crate) fn read() -> Self {
        let grid = Table::read(&data("grid.csv")).unwrap();
        let number = |row: usize, column: &str| grid.number(row, column).unwrap();
        let points = (0..grid.len())
            .map(|i| Point3::new(number(i, "x_m"), number(i, "y_m"), number(i, "z_m")))
            .collect();
        let (stiffness, mass) = (matrix("kgg.csv"), matrix("mgg.csv"));
        let free = SIZE - 6;
        // M is diagonal there: scale to a standard symmetric eigenproblem.
        let root = |i: usize| mass[(i + 6, i + 6)].sqrt();
        let scaled = Mat::from_fn(free, free, |i, j| stiffness[(i + 6, j + 6)] / (root(i) * root(j)));
        let eigen = scaled.self_adjoint_eigen(Side::Lower).unwrap();
        let shapes =
            Mat::from_fn(SIZE, MODES, |i, m| if i < 6 { 0.0 } else { eigen.U()[(i - 6, m)] / root(i - 6) });
        Self { points, stiffness, mass, shapes, omega2: (0..MODES).map(|m| eigen.S()[m]).collect() }
    }

    /// Every box on the node nearest to its middle.
    pub(crate) fn spline(&self, lattice: &Lattice) -> Spline {
        let nodes: Vec<usize> = (0..self.points.len()).collect();
        Spline::nearest_node(lattice, &self.points, &nodes)
    }

    /// The structure clamped at its first node, all modes.
    pub(crate) fn system(&self) -> System {
        let ids = (1..=29).collect();
        let clamped: Vec<usize> = (0..6).collect();
        System::from_matrices(ids, self.points.clone(), self.stiffness.as_ref(), self.mass.as_ref(), &clamped)
    }

    /// Ten modes without static residual, everything they do times `factor`.
    fn supported(&self, spline: &Spline, factor: f64) -> SupportedStructure {
        let modal = |left: &Mat<f64>| {
            // factor Phi omega^-2 Phi' left
            let forces = self.shapes.transpose() * left;
            let amplitudes =
                Mat::from_fn(MODES, left.ncols(), |m, c| factor * forces[(m, c)] / self.omega2[m]);
            &self.shapes * &amplitudes
        };
        let unit_fields = Mat::from_fn(SIZE, 3, |dof, axis| f64::from(u8::from(dof % 6 == axis)));
        let field_loads = &self.mass * &unit_fields;
        let weight = Mat::from_fn(3, 3, |row, axis| {
            (0..29)
                .map(|node| {
                    let f: Vec<f64> = (0..6).map(|c| field_loads[(6 * node + c, axis)]).collect();
                    let arm = self.points[node] - balance_point();
                    match row {
                        0 => f[2],
                        1 => f[3] + arm.y * f[2] - arm.z * f[1],
                        _ => f[4] + arm.z * f[0] - arm.x * f[2],
                    }
                })
                .sum()
        });
        let (flexibility, sag) = (modal(&Mat::identity(SIZE, SIZE)), modal(&field_loads));
        SupportedStructure::from_parts((0..SIZE).collect(), flexibility, sag, weight, spline, 28).unwrap()
    }

    /// The wing at one angle of attack: its ten modes softer by `softer`, incidence sin(alpha) and sin(camber).
    pub(crate) fn at(
        &self,
        lattice: &Lattice,
        mach: f64,
        controls: Vec<ControlSurface>,
        alpha_rad: f64,
        softer: f64,
    ) -> ElasticWing {
        let camber = (0..lattice.len())
            .map(|j| {
                let exact = -0.02 + 0.11 * (j % 12) as f64 / 11.0;
                ((exact * 1e5).round() / 1e5).sin() + alpha_rad.sin() - alpha_rad
            })
            .collect();
        let spline = self.spline(lattice);
        let mut wing = ElasticWing::new(WingParts {
            lattice: lattice.clone(),
            controls,
            balance: Balance { point: balance_point(), metric: vec![true; lattice.len()] },
            plane: MirrorPlane::None,
            mach,
            fairing_surfaces: Vec::new(),
            camber,
            supported: Some(self.supported(&spline, softer)),
            structure: Some((self.system(), spline)),
        })
        .unwrap();
        wing.gravity_m_s2 = GRAVITY_M_S2;
        wing
    }
}

fn balance_point() -> Point3<f64> {
    Point3::new(0.1, 0.0, 0.0)
}
