//! The elastic wing against Loads Kernel 2026.5 (independent tool): 25 steady cases, uncorrected and corrected.
//!
//! Goal: Fz, Mx, My to 1e-6 of N and N m, tip to 1e-6 m. Loads Kernel's own stiffness, mass, nearest-node spline and
//! ten modes are used; what its algebra does otherwise (data/loads_kernel/README.md) is repeated here on the outside:
//! sin(alpha) and sin(camber) as incidence; the elastic incidence times cos(alpha), which is a structure softer by
//! cos(alpha) whose displacement is cos(alpha) times Loads Kernel's; weight not tared at alpha = 0.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use aero::{Corrections, Flow, Lattice, MirrorPlane};
use coupling::{Balance, ElasticWing, Spline, SteadyCase, SupportedStructure, WingParts};
use faer::{Mat, Side};
use nalgebra::Point3;
use nastran::table::Table;
use std::path::{Path, PathBuf};

const GRAVITY_M_S2: f64 = 9.8066;
const RHO_KG_M3: f64 = 101_325.0 / 287.0531 / 288.15;
const MODES: usize = 10;

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../data/loads_kernel").join(name)
}

/// A symmetric matrix of 174 rows from its upper triangle.
fn matrix(name: &str) -> Mat<f64> {
    let table = Table::read(&data(name)).unwrap();
    let mut matrix = Mat::zeros(174, 174);
    for row in 0..table.len() {
        let index = |column: &str| {
            let number = table.number(row, column).unwrap();
            (0..174).find(|&i| i as f64 == number).unwrap()
        };
        let value = table.number(row, "value").unwrap();
        matrix[(index("row"), index("column"))] = value;
        matrix[(index("column"), index("row"))] = value;
    }
    matrix
}

struct LoadsKernelWing {
    points: Vec<Point3<f64>>,
    /// Ten modes of the structure clamped at its first node, 174 rows.
    shapes: Mat<f64>,
    omega2: Vec<f64>,
    mass: Mat<f64>,
}

impl LoadsKernelWing {
    fn read() -> Self {
        let grid = Table::read(&data("grid.csv")).unwrap();
        let number = |row: usize, column: &str| grid.number(row, column).unwrap();
        let points = (0..grid.len())
            .map(|i| Point3::new(number(i, "x_m"), number(i, "y_m"), number(i, "z_m")))
            .collect();
        let (stiffness, mass) = (matrix("kgg.csv"), matrix("mgg.csv"));
        let free = 168;
        // M is diagonal there: scale to a standard symmetric eigenproblem.
        let root = |i: usize| mass[(i + 6, i + 6)].sqrt();
        let scaled = Mat::from_fn(free, free, |i, j| stiffness[(i + 6, j + 6)] / (root(i) * root(j)));
        let eigen = scaled.self_adjoint_eigen(Side::Lower).unwrap();
        let shapes =
            Mat::from_fn(174, MODES, |i, m| if i < 6 { 0.0 } else { eigen.U()[(i - 6, m)] / root(i - 6) });
        Self { points, shapes, omega2: (0..MODES).map(|m| eigen.S()[m]).collect(), mass }
    }

    /// The wing as Loads Kernel has it at one angle of attack.
    fn at(&self, lattice: &Lattice, spline: &Spline, alpha_rad: f64) -> ElasticWing {
        let cos = alpha_rad.cos();
        let s_dofs: Vec<usize> = (0..174).collect();
        let modal = |left: &Mat<f64>| {
            // cos(alpha) Phi omega^-2 Phi' left
            let forces = self.shapes.transpose() * left;
            let amplitudes = Mat::from_fn(MODES, left.ncols(), |m, c| cos * forces[(m, c)] / self.omega2[m]);
            &self.shapes * &amplitudes
        };
        let unit_fields = Mat::from_fn(174, 3, |dof, axis| f64::from(u8::from(dof % 6 == axis)));
        let field_loads = &self.mass * &unit_fields;
        let balance = Point3::new(0.1, 0.0, 0.0);
        let weight = Mat::from_fn(3, 3, |row, axis| {
            (0..29)
                .map(|node| {
                    let f: Vec<f64> = (0..6).map(|c| field_loads[(6 * node + c, axis)]).collect();
                    let arm = self.points[node] - balance;
                    match row {
                        0 => f[2],
                        1 => f[3] + arm.y * f[2] - arm.z * f[1],
                        _ => f[4] + arm.z * f[0] - arm.x * f[2],
                    }
                })
                .sum()
        });
        let supported = SupportedStructure::from_parts(
            s_dofs,
            modal(&Mat::identity(174, 174)),
            modal(&field_loads),
            weight,
            spline,
            28,
        )
        .unwrap();
        let camber = (0..lattice.len())
            .map(|j| {
                let exact = -0.02 + 0.11 * (j % 12) as f64 / 11.0;
                ((exact * 1e5).round() / 1e5).sin() + alpha_rad.sin() - alpha_rad
            })
            .collect();
        let mut wing = ElasticWing::new(WingParts {
            lattice: lattice.clone(),
            controls: Vec::new(),
            balance: Balance { point: balance, metric: vec![true; lattice.len()] },
            plane: MirrorPlane::None,
            mach: 0.0,
            fairing_surfaces: Vec::new(),
            camber,
            supported: Some(supported),
            structure: None,
        })
        .unwrap();
        wing.gravity_m_s2 = GRAVITY_M_S2;
        wing
    }
}

fn check(reference: &str, corrections: &Corrections) {
    let lattice = Lattice::from_bulk(&nastran::read_deck(&data("wing.bdf")).unwrap()).unwrap();
    let model = LoadsKernelWing::read();
    let nodes: Vec<usize> = (0..29).collect();
    let spline = Spline::nearest_node(&lattice, &model.points, &nodes);
    let table = Table::read(&data(reference)).unwrap();
    assert_eq!(table.len(), 25);
    for alpha_deg in [-4.0, -2.0, 0.0, 2.0, 4.0_f64] {
        let alpha_rad = alpha_deg.to_radians();
        let wing = model.at(&lattice, &spline, alpha_rad);
        let weight = &wing.supported.as_ref().unwrap().weight;
        for row in (0..25).filter(|&row| table.number(row, "alpha_deg").unwrap() == alpha_deg) {
            let flow = Flow { v_m_s: table.number(row, "V_m_s").unwrap(), rho_kg_m3: RHO_KG_M3 };
            let case = SteadyCase::new(flow, alpha_rad);
            let state = &wing.at(flow, corrections).unwrap().solve(&[case])[0];
            let loads = state.root.to_array();
            for (channel, name) in ["Fz_N", "Mx_Nm", "My_Nm"].into_iter().enumerate() {
                let untared = loads[channel] - weight[(channel, 2)] * GRAVITY_M_S2;
                let expected = table.number(row, name).unwrap();
                assert!(
                    (untared - expected).abs() < 1e-6,
                    "{reference} row {row} {name}: {untared} against {expected}"
                );
            }
            // Loads Kernel gives the tip in earth axes: aft motion of the nose-up wing is down.
            let tip = |component: usize| state.displacement[6 * 28 + component] / alpha_rad.cos();
            let tip_up_m = tip(2) * alpha_rad.cos() - tip(0) * alpha_rad.sin();
            let expected_down_m = table.number(row, "tip_down_m").unwrap();
            assert!((tip_up_m + expected_down_m).abs() < 1e-6, "tip {tip_up_m} against {expected_down_m}");
        }
    }
}

#[test]
fn uncorrected_wing_agrees_with_loads_kernel_in_25_cases() {
    check("static_base.csv", &Corrections::neutral(672));
}

#[test]
fn corrected_wing_agrees_with_loads_kernel_in_25_cases() {
    let table = Table::read(&data("corrections.csv")).unwrap();
    let corrections = Corrections {
        force: table.numbers("force").unwrap(),
        moment: table.numbers("moment").unwrap(),
        pressure_offset: table.numbers("pressure_offset").unwrap(),
    };
    check("static_corr.csv", &corrections);
}
