//! The jet transport wing of Bisplinghoff, Ashley and Halfman in a random gust (data/published/gust__bah_*.json).
//!
//! Structure: the case `fem__bah_structure`. Boxes, splines and gust are facts of NASA's demonstration problem D11-03-1A
//! (github.com/nasa/NASTRAN-95, inp/d11031a.inp, NASA Open Source Agreement), in, lb, s; x forward and z down in the
//! structure, x aft and z up in the air.

use super::flutter_decks::NASTRAN;
use super::vibrations::bah_system;
use crate::half_wing::{Planform, WALL};
use crate::registry::Case;
use crate::row::{Row, worst};
use crate::{list, number, numbers, published};
use aero::{Corrections, DoubletLattice, Flow, Integration, Lattice};
use faer::linalg::solvers::Solve;
use faer::{Mat, c64};
use maneuver::flutter::{Aeroelastic, gaf_table};
use maneuver::gust::{FrequencyTable, elastic_response, gust_incidence};
use serde_json::Value;
use std::f64::consts::TAU;
use structure::normal_modes;

/// The cases of this file.
pub const CASES: &[Case] = &[Case { file: "gust__bah_gust_frequency_response", run: bah_gust }];

/// Airspeed (in/s), density (lb s²/in⁴), reference chord (in), Mach number, where the gust's phase is taken (in, x aft).
const V: f64 = 8360.0;
const RHO: f64 = 1.1468e-7;
const CHORD: f64 = 131.232;
const MACH: f64 = 0.62;
const GUST_X: f64 = 0.0;
/// Gust velocity over airspeed, and structural damping g of all modes.
const WG: f64 = 1.1962e-4;
const DAMPING_G: f64 = 0.06;
/// Reduced frequencies. The source has .02, .1 and .5 only and interpolates.
const K: [f64; 15] = [0.0, 0.01, 0.02, 0.04, 0.07, 0.1, 0.14, 0.18, 0.22, 0.26, 0.3, 0.35, 0.4, 0.45, 0.5];

/// Spectrum of the gust's velocity at every quarter of a hertz from zero, in²/s² per Hz.
const SPECTRUM: [f64; 40] = [
    2.8708, 1.2641, 4.7188e-1, 2.3080e-1, 1.3456e-1, 8.7595e-2, 6.1402e-2, 4.5369e-2, 3.4865e-2, 2.7618e-2,
    2.2412e-2, 1.8547e-2, 1.5601e-2, 1.3304e-2, 1.1478e-2, 1.0004e-2, 8.7964e-3, 7.7947e-3, 6.9547e-3,
    6.2434e-3, 5.6359e-3, 5.1128e-3, 4.6593e-3, 4.2636e-3, 3.9162e-3, 3.6095e-3, 3.3375e-3, 3.0951e-3,
    2.8782e-3, 2.6833e-3, 2.5076e-3, 2.3485e-3, 2.2042e-3, 2.0727e-3, 1.9526e-3, 1.8427e-3, 1.7418e-3,
    1.6490e-3, 1.5634e-3, 1.4843e-3,
];

/// Three panels of one planform, the middle one's last two chordwise rows being the aileron. Its apex is at x = 0.
fn lattice() -> Lattice {
    let planform = Planform { semispan: 500.0, root: 225.0, tip: 100.0, tip_x: 78.75 - 35.0 };
    let coarse = [0.0, 0.375, 0.75, 1.0];
    let fine = [0.0, 0.1875, 0.375, 0.625, 0.75, 0.875, 1.0];
    let inner = planform.lattice(&[0.0, 0.09, 0.21, 0.33, 0.45, 0.56, 0.66, 0.74], &coarse);
    let numbered = |mut lattice: Lattice, first: u32| {
        (first..).zip(&mut lattice.boxes).for_each(|(id, panel)| panel.id = id);
        lattice.surfaces.iter_mut().for_each(|surface| surface.id = first);
        lattice
    };
    let middle = numbered(planform.lattice(&[0.74, 0.82, 0.9, 0.974], &fine), 101);
    let outer = numbered(planform.lattice(&[0.974, 1.0], &coarse), 201);
    inner.joined(&middle).and_then(|both| both.joined(&outer)).expect("numbers of their own")
}

/// Stations of the grid pairs: y, x forward of the front and of the rear grid.
const STATIONS: [[f64; 3]; 5] = [
    [90.0, 20.25, -81.0],
    [186.0, 17.85, -71.4],
    [268.0, 15.8, -63.2],
    [368.0, 13.3, -53.2],
    [458.0, 11.05, -44.2],
];

/// Displacement and slope along x forward at a place of the beam spline, which the pairs determine: a natural cubic
/// through the displacements of the axis (grid 11 the innermost), straight lines through the slopes.
fn on_axis(t3: &[f64], y: f64) -> (f64, f64) {
    let slope = |s: usize| (t3[2 * s] - t3[2 * s + 1]) / (STATIONS[s][1] - STATIONS[s][2]);
    let mut knots = vec![(0.0, t3[10])];
    knots.extend((0..5).map(|s| (STATIONS[s][0], t3[2 * s] - slope(s) * STATIONS[s][1])));
    let at = STATIONS.iter().position(|station| y < station[0]).unwrap_or(5);
    let twist = match at {
        0 => slope(0),
        5 => slope(4),
        s => {
            let share = (y - STATIONS[s - 1][0]) / (STATIONS[s][0] - STATIONS[s - 1][0]);
            slope(s - 1) + share * (slope(s) - slope(s - 1))
        }
    };
    (natural_cubic(&knots, y), twist)
}

/// w(y) = a + b y + sum c_i |y - y_i|³ with sum c_i = sum c_i y_i = 0: straight outside of the knots.
fn natural_cubic(knots: &[(f64, f64)], y: f64) -> f64 {
    let n = knots.len();
    let system = Mat::from_fn(n + 2, n + 2, |i, j| match (i < n, j < n) {
        (true, true) => (knots[i].0 - knots[j].0).abs().powi(3),
        (true, false) => knots[i].0.powi(i32::from(j > n)),
        (false, true) => knots[j].0.powi(i32::from(i > n)),
        (false, false) => 0.0,
    });
    let right = Mat::from_fn(n + 2, 1, |i, _| knots.get(i).map_or(0.0, |knot| knot.1));
    let c = system.partial_piv_lu().solve(&right);
    let cubes: f64 = (0..n).map(|i| c[(i, 0)] * (y - knots[i].0).abs().powi(3)).sum();
    cubes + c[(n, 0)] + c[(n + 1, 0)] * y
}

/// Displacement and slope along x forward on the plane through grids 8, 10 and 12.
fn on_aileron(t3: &[f64], x: f64, y: f64) -> (f64, f64) {
    let rows = [[1.0, -53.2, 368.0], [1.0, -44.2, 458.0], [1.0, -86.45, 368.0]];
    let system = Mat::from_fn(3, 3, |i, j| rows[i][j]);
    let right = Mat::from_fn(3, 1, |i, _| t3[[7, 9, 11][i]]);
    let c = system.partial_piv_lu().solve(&right);
    (c[(0, 0)] + c[(1, 0)] * x + c[(2, 0)] * y, c[(1, 0)])
}

/// Motion of the boxes, two rows each, for T3 of the twelve grids in columns.
fn box_motion(lattice: &Lattice, t3: &Mat<f64>) -> Mat<f64> {
    let middle = &lattice.surfaces[1];
    let mut motion = Mat::zeros(2 * lattice.len(), t3.ncols());
    for (j, panel) in lattice.boxes.iter().enumerate() {
        let mid = panel.mid_point();
        let x_forward = 78.75 - mid.x;
        let in_middle = (middle.first_box..middle.first_box + 18).contains(&j);
        let aileron = in_middle && (j - middle.first_box) % 6 >= 4;
        for mode in 0..t3.ncols() {
            let column = t3.col_as_slice(mode);
            let (w, slope) = if aileron {
                on_aileron(column, x_forward, mid.y)
            } else {
                let (axis, slope) = on_axis(column, mid.y);
                (axis + slope * x_forward, slope)
            };
            // z down: up is the negative, and nose up is a slope that falls forward
            motion[(2 * j, mode)] = -w;
            motion[(2 * j + 1, mode)] = -slope;
        }
    }
    motion
}

/// Amplitudes per unit gust at each frequency of the print: T3 of grids 1, 9, 10 and 11, R2 of 12, and both bending moments.
struct Answers {
    hz: Vec<f64>,
    values: Vec<[c64; 7]>,
}

fn answers(structure: &Value) -> Answers {
    let system = bah_system(structure);
    let modes = normal_modes(&system, 12).expect("twelve motions with mass");
    let shapes = system.expand(modes.shapes.as_ref());
    let row = |grid: u32, component: usize| 6 * system.node_index(grid).expect("a grid") + component;
    let grids: Vec<usize> = (1..=12).map(|grid| row(grid, 2)).collect();
    let t3 = Mat::from_fn(12, 12, |i, mode| shapes[(grids[i], mode)]);
    let r2 = Mat::from_fn(1, 12, |_, mode| shapes[(row(12, 4), mode)]);
    let genel = &structure["genel"];
    let table = |value: &Value| {
        let rows: Vec<Vec<f64>> = list(value).iter().map(numbers).collect();
        Mat::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j])
    };
    let bent = Mat::from_fn(10, 12, |i, mode| t3[(i, mode)] - t3[(10, mode)]);
    let forces = table(&genel["Z_flexibility"]).partial_piv_lu().solve(&bent);
    let arms = table(&genel["S"]);
    let moment = |column: usize, mode: usize| -> f64 {
        -(0..10).map(|i| arms[(i, column)] * forces[(i, mode)]).sum::<f64>()
    };
    let outputs = Mat::from_fn(7, 12, |i, mode| match i {
        0..4 => t3[([0, 8, 9, 10][i], mode)],
        4 => r2[(0, mode)],
        5 => moment(1, mode),
        _ => moment(3, mode),
    });
    let lattice = lattice();
    let doublets = DoubletLattice::new(&lattice, WALL, MACH, &NASTRAN).expect("a half wing");
    let motion = box_motion(&lattice, &t3);
    let kappa: Vec<f64> = K.iter().map(|k| 2.0 * k / CHORD).collect();
    let air = gaf_table(&lattice, &doublets, motion.as_ref(), None, &kappa).expect("rising");
    let (integration, neutral) = (Integration::new(&lattice), Corrections::neutral(lattice.len()));
    let loads = integration.corrected(&neutral);
    // the boxes' x is aft of the apex, which is 78.75 in forward of the axis; the phase is smoothest amid the wing
    let middle = 150.0;
    let gust = kappa.iter().map(|&kappa| {
        let w = gust_incidence(&lattice, middle, kappa);
        let cp = doublets.at(kappa).expect("a frequency").pressures(w.as_ref());
        loads.weighed(motion.transpose(), cp.as_ref())
    });
    let gust = FrequencyTable::new(kappa.clone(), gust.collect(), middle).expect("rising");
    let diagonal = |value: &dyn Fn(f64) -> f64| {
        Mat::from_fn(12, 12, |i, j| if i == j { value(modes.omega_rad_s[i]) } else { 0.0 })
    };
    let (mass, damping) = (diagonal(&|_| 1.0), diagonal(&|omega| DAMPING_G * omega));
    let undamped = diagonal(&|_| 0.0);
    let wing = Aeroelastic::new(mass, damping, diagonal(&|omega| omega * omega), &air).expect("twelve modes");
    let flow = Flow { v_m_s: V, rho_kg_m3: RHO };
    let hz: Vec<f64> = (1..40).map(|i| 0.25 * f64::from(i)).collect();
    let values = hz.iter().map(|hz| {
        let omega = TAU * hz;
        let load = gust.at(omega / V, 78.75 + GUST_X).expect("within the table");
        let load = load * faer::Scale(c64::from(WG * flow.dynamic_pressure_pa()));
        let x =
            elastic_response(&wing, flow, omega, undamped.as_ref(), load.as_ref()).expect("within the table");
        std::array::from_fn(|i| (0..12).map(|mode| x[(mode, 0)] * outputs[(i, mode)]).sum())
    });
    Answers { values: values.collect(), hz }
}

fn bah_gust(case: &Value) -> Vec<Row> {
    let rel = number(&case["tolerance"]["rel"]);
    let expected = &case["expected"];
    let got = answers(&published("fem__bah_structure")["inputs"]);
    let names = [
        ("T3 of grid 1 (in)", &expected["disp_T3"]["1"]),
        ("T3 of grid 9 (in)", &expected["disp_T3"]["9"]),
        ("T3 of grid 10 (in)", &expected["disp_T3"]["10"]),
        ("T3 of grid 11 (in)", &expected["disp_T3"]["11"]),
        ("aileron angle (rad)", &expected["disp_R2_12"]),
        ("bending at the centreline (in lb)", &expected["root_bending_11R1_centreline"]),
        ("bending at station 45 (in lb)", &expected["root_bending_11R3_station45"]),
    ];
    let mut rows = Vec::new();
    for (output, (name, table)) in names.into_iter().enumerate() {
        let table: Vec<Vec<f64>> = list(table).iter().map(numbers).collect();
        let size = table.iter().map(|row| row[1].hypot(row[2])).fold(0.0, f64::max);
        let each = got.hz.iter().zip(&got.values).flat_map(|(hz, values)| {
            let want = table.iter().find(|row| row[0] == *hz).expect("a frequency of the print");
            [("real", values[output].re, want[1]), ("imaginary", values[output].im, want[2])]
                .map(|(part, ours, want)| Row::absolute(format!("{part} at {hz} Hz"), ours, want, rel * size))
        });
        rows.push(worst(name, each.collect()));
    }
    for (name, output, key) in [
        ("rms of plunge (in)", 3, "plunge_11T3"),
        ("rms of the tip (in)", 1, "tip_9T3"),
        ("rms of bending at station 45 (in lb)", 6, "root_bending_11R3"),
    ] {
        // trapezoids over the print's frequencies, zero at rest as there
        let density =
            |i: usize| if i == 0 { 0.0 } else { got.values[i - 1][output].norm_sqr() * SPECTRUM[i] };
        let area: f64 = (1..40).map(|i| 0.125 * (density(i - 1) + density(i))).sum();
        rows.push(Row::relative(name, area.sqrt(), number(&expected["psd_rms"][key]["rms"]), rel));
    }
    rows
}
