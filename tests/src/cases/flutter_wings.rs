//! Flutter of wings on the doublet lattice, with known modes (data/published/flutter*__*.json).

use super::flutter_decks::NASTRAN;
use super::flutter_strips::{Goland, first_flutter, goland_strips, natural_rad_s, speeds};
use crate::half_wing::WALL;
use crate::registry::Case;
use crate::row::{Row, worst};
use crate::{list, number, numbers};
use aero::{DlmSettings, DoubletLattice, Flow, Lattice, MirrorPlane};
use faer::Mat;
use maneuver::flutter::{Aeroelastic, FlutterCurves, GafTable, gaf_table};
use serde_json::Value;
use std::f64::consts::TAU;

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case { file: "flutter__goland_wing", run: goland },
    Case { file: "flutter_measured__papa_0012_a", run: papa },
    Case { file: "flutter__flutter_0012_pknl", run: rigid_plate },
];

/// A table of a half wing beside the wall for box motions `(mode, x, y) -> (h up, nose-up angle)` at box midpoints, at
/// reduced frequencies omega c/(2V).
///
/// # Panics
/// If the lattice cannot be solved.
pub fn table(
    lattice: &Lattice,
    mach: f64,
    modes: usize,
    motion: impl Fn(usize, f64, f64) -> (f64, f64),
    chord: f64,
    k: &[f64],
) -> GafTable {
    let rows = Mat::from_fn(2 * lattice.len(), modes, |row, mode| {
        let mid = lattice.boxes[row / 2].mid_point();
        let (h, theta) = motion(mode, mid.x, mid.y);
        if row % 2 == 0 { h } else { theta }
    });
    let doublets = DoubletLattice::new(lattice, WALL, mach, &DlmSettings::default()).expect("a half wing");
    let kappa: Vec<f64> = k.iter().map(|k| 2.0 * k / chord).collect();
    gaf_table(lattice, &doublets, rows.as_ref(), None, &kappa).expect("rising frequencies")
}

/// Reduced frequencies of a table up to about 1.
pub const UP_TO_ONE: [f64; 14] =
    [0.0, 0.005, 0.02, 0.05, 0.08, 0.12, 0.17, 0.23, 0.3, 0.4, 0.5, 0.65, 0.8, 1.0];

/// Strip theory, and the doublet lattice on the case's meshes with its four functions of either kind.
fn goland(case: &Value) -> Vec<Row> {
    let mut rows = goland_strips(case);
    for mesh in [[12, 6], [20, 8]] {
        for about_cg in [false, true] {
            let wing = Goland::new(&case["inputs"], about_cg, 4);
            let c = wing.chord;
            let lattice = Lattice::trapezoid(1, [0.0; 3], c, [0.0, wing.length, 0.0], c, [mesh[1], mesh[0]])
                .expect("a rectangle");
            let motion = |mode: usize, x: f64, y: f64| {
                let value = wing.function(mode, y);
                if mode < wing.count { (-value, 0.0) } else { (-value * (x - wing.axis * c), value) }
            };
            let forces = table(&lattice, 0.0, 8, motion, c, &UP_TO_ONE);
            let convention = if about_cg { "I about CG" } else { "I about EA" };
            let same = |entry: &&Value| {
                crate::numbers(&entry["mesh"]) == mesh.map(f64::from) && entry["I"] == convention
            };
            for entry in list(&case["expected"]["own_dlm_3d"]).iter().filter(same) {
                let rho = number(&entry["rho"]);
                let [mass, stiffness] = wing.matrices();
                let flutter = first_flutter(mass, stiffness, &forces, &speeds(20.0, 220.0, 41, rho));
                let row = |what: &str, ours: f64, key: &str| {
                    let name =
                        format!("{} by {} boxes, {convention}, density {rho}: {what}", mesh[0], mesh[1]);
                    Row::relative(name, ours, number(&entry[key]), 0.01)
                };
                rows.push(row("flutter speed (m/s)", flutter.flow.v_m_s, "VF"));
                rows.push(row("flutter frequency (rad/s)", flutter.omega_rad_s, "omF"));
            }
        }
    }
    let uvlm = &case["expected"]["uvlm_sharpy_rho_1p02"];
    let fine = rows
        .iter()
        .find(|row| row.quantity.starts_with("20 by 8 boxes, I about EA, density 1.02: flutter speed"));
    let ours = fine.map_or(f64::NAN, |row| row.ours);
    let want = number(&uvlm["V"]);
    let range = crate::numbers(&uvlm["range"]);
    rows.push(Row::band(
        "beside a vortex lattice in time (m/s)",
        ours,
        want,
        range[0] - want,
        range[1] - want,
    ));
    rows
}

/// The rigid wing on its plunging and pitching springs: the density at which it flutters at each Mach number's airspeed
/// (slug, ft, s; half the wing is modelled beside the splitter plate).
fn papa(case: &Value) -> Vec<Row> {
    let input = |name: &str| number(&case["inputs"][name]);
    let (chord, span) = (input("chord_in") / 12.0, input("semi_span_in") / 12.0);
    let lattice =
        Lattice::trapezoid(1, [0.0; 3], chord, [0.0, span, 0.0], chord, [12, 20]).expect("a rectangle");
    let motion =
        |mode: usize, x: f64, _y: f64| if mode == 0 { (-1.0, 0.0) } else { (-(x - chord / 2.0), 1.0) };
    let diagonal = |a: f64, b: f64| Mat::from_fn(2, 2, |i, j| if i == j { [a, b][i] } else { 0.0 });
    let mut rows = Vec::new();
    for entry in list(&case["expected"]) {
        let (mach, v) = (number(&entry["M"]), number(&entry["V_ft_s"]));
        let forces = table(&lattice, mach, 2, motion, chord, &UP_TO_ONE[..9]);
        let system = Aeroelastic::new(
            diagonal(input("m_slug"), input("I_slug_ft2")),
            Mat::zeros(2, 2),
            diagonal(input("Kh_lb_ft"), input("Kalpha_ft_lb")),
            &forces,
        )
        .expect("two coordinates");
        let rho = number(&entry["rho_slug_ft3"]);
        let flows: Vec<Flow> =
            (1..=40).map(|i| Flow { v_m_s: v, rho_kg_m3: rho * 0.05 * f64::from(i) }).collect();
        let curves = system.pk(&flows).unwrap_or_else(|error| panic!("Mach {mach}: {error}"));
        let flutter = *curves.flutter().unwrap_or_else(|| panic!("Mach {mach}: no flutter"));
        let q = flutter.flow.dynamic_pressure_pa();
        let f = flutter.omega_rad_s / TAU;
        let measured = number(&entry["q_psf"]);
        let name = format!("Mach {mach} flutter pressure (psf)");
        // The case asks for 10 % below Mach 0.7 and nothing above.
        rows.push(if mach < 0.7 {
            Row::relative(name, q, measured, 0.1)
        } else {
            Row::record(name, q, measured)
        });
        rows.push(Row::relative(format!("Mach {mach} frequency (Hz)"), f, number(&entry["f_hz"]), 0.04));
        let other = &entry["own_dlm_at_test_V"][1];
        rows.push(Row::record(
            format!("Mach {mach} beside another lattice: pressure (psf)"),
            q,
            number(&other["q"]),
        ));
        rows.push(Row::record(
            format!("Mach {mach} beside another lattice: frequency (Hz)"),
            f,
            number(&other["f"]),
        ));
    }
    rows
}

/// A rigid plate 10 m by 1 m on springs at its leading edge, airspeed and density matched along an atmosphere. Facts of
/// pyNastran's model `models/aero/2_mode_flutter` (github.com/SteveDoyle2/pyNastran, BSD-3): 10 mm of 2800 kg/m3 in elements
/// of lumped mass over grids at x = 0, .333, .667 and 1 m; 1e5 N/m and 1e5 N m/rad; 20 by 5 boxes, no symmetry.
fn rigid_plate(case: &Value) -> Vec<Row> {
    let expected = &case["expected"];
    // a quarter of each element's mass goes to each of its corners
    let (mass, x) = (280.0, [0.0, 0.333, 0.667, 1.0]);
    let lumps: Vec<f64> = (0..4)
        .map(|i| {
            let left = if i > 0 { x[i] - x[i - 1] } else { 0.0 };
            let right = if i < 3 { x[i + 1] - x[i] } else { 0.0 };
            0.5 * mass * (left + right)
        })
        .collect();
    let moment = |power: i32| -> f64 { lumps.iter().zip(x).map(|(m, x)| m * x.powi(power)).sum() };
    // displacement up and nose-up angle about the leading edge: z = h - x theta
    let entries = [mass, -moment(1), -moment(1), moment(2)];
    let inertia = Mat::from_fn(2, 2, |i, j| entries[2 * i + j]);
    let stiffness = Mat::from_fn(2, 2, |i, j| if i == j { 1e5 } else { 0.0 });
    let (f, g) = (number(&case["tolerance"]["f"]), 0.01);
    let mut rows = Vec::new();
    for (i, omega) in natural_rad_s(&inertia, &stiffness).into_iter().enumerate() {
        let want = number(&expected["modes_hz"][i]);
        rows.push(Row::relative(format!("mode {} (Hz)", i + 1), omega / TAU, want, f));
    }
    // k, 1/k, density, Mach number, airspeed, g, Hz
    let printed = ["1", "2"].map(|mode| -> Vec<Vec<f64>> {
        list(&expected["flutter"][mode]["rows"]).iter().map(numbers).collect()
    });
    let flows: Vec<Flow> = printed[0].iter().map(|row| Flow { v_m_s: row[4], rho_kg_m3: row[2] }).collect();
    // The print is that of the Mach number before the last of the source's list: see the note in tests/README.md.
    let curves = plate_curves(&inertia, &stiffness, 0.4, &flows);
    for (mode, table) in printed.iter().enumerate() {
        let [mut damping, mut frequency, mut collapsing] = [Vec::new(), Vec::new(), Vec::new()];
        for (root, row) in curves.branches[mode].iter().zip(table) {
            let at = format!("at {} m/s, {} kg/m3", row[4], row[2]);
            let hz = Row::relative(at.clone(), root.frequency_hz(), row[6], f);
            if row[6] == 0.0 {
                frequency.push(Row::absolute(at, root.frequency_hz(), 0.0, 0.0));
            } else if row[5] < -3.0 {
                collapsing.push(hz);
            } else {
                damping.push(Row::absolute(at, root.damping_g().unwrap_or(f64::NAN), row[5], g));
                frequency.push(hz);
            }
        }
        rows.push(worst(&format!("mode {} damping g", mode + 1), damping));
        rows.push(worst(&format!("mode {} frequency (Hz)", mode + 1), frequency));
        if !collapsing.is_empty() {
            let reason = "the root is about to stop oscillating, where its frequency falls without bound";
            let row = worst(&format!("mode {} frequency (Hz), damping g below -3", mode + 1), collapsing);
            rows.push(row.known(0.02, 0.035, reason));
        }
    }
    let flutter = |mach: f64| {
        plate_curves(&inertia, &stiffness, mach, &flows).flutter().map_or(f64::NAN, |c| c.flow.rho_kg_m3)
    };
    rows.push(Row::record("flutter density at Mach 0.5, beside 0.4 (kg/m3)", flutter(0.5), flutter(0.4)));
    rows
}

/// Roots of the rigid plate with forces of a Mach number.
fn plate_curves(inertia: &Mat<f64>, stiffness: &Mat<f64>, mach: f64, flows: &[Flow]) -> FlutterCurves {
    let lattice = Lattice::trapezoid(1, [0.0; 3], 1.0, [0.0, 10.0, 0.0], 1.0, [5, 20]).expect("a rectangle");
    let motion = Mat::from_fn(2 * lattice.len(), 2, |row, mode| match (row % 2, mode) {
        (0, 0) | (1, 1) => 1.0,
        (0, _) => -lattice.boxes[row / 2].mid_point().x,
        _ => 0.0,
    });
    let doublets = DoubletLattice::new(&lattice, MirrorPlane::None, mach, &NASTRAN).expect("one wing");
    let kappa = UP_TO_ONE.map(|k| 2.0 * k);
    let forces = gaf_table(&lattice, &doublets, motion.as_ref(), None, &kappa).expect("rising frequencies");
    let none = Mat::zeros(2, 2);
    let system =
        Aeroelastic::new(inertia.clone(), none, stiffness.clone(), &forces).expect("two coordinates");
    system.pk(flows).unwrap_or_else(|error| panic!("{error}"))
}
