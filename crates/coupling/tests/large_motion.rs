//! Small motions about the bent wing: its modes beside SOL 400 and UM/NAST (Riso and Cesnik, J. Aircraft, 2023), and the air's answer
//! at rest beside differences of the steady loads.

use crate::large::{SEMISPAN_M, without_skin, without_skin_with};
use aero::{Corrections, DlmSettings, DoubletLattice, Flow, MirrorPlane};
use coupling::{LargeWing, SteadyCase};
use faer::{Mat, c64};
use serde_json::Value;
use std::f64::consts::TAU;
use structure::update::modal_assurance;

fn case(v_m_s: f64, alpha_deg: f64) -> SteadyCase {
    SteadyCase::new(Flow { v_m_s, rho_kg_m3: 1.225 }, alpha_deg.to_radians())
}

fn neutral(wing: &LargeWing) -> Corrections {
    Corrections::neutral(wing.elastic.correctable.len())
}

/// Frequencies of first, second, third bending, torsion and in-plane bending over the rise of the tip.
#[test]
fn torsion_falls_as_the_wing_bends() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../data/published/nl_pazy__modes_deformed_skin0_to26pct.json"
    );
    let published: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let table: Vec<Vec<f64>> = serde_json::from_value(published["expected"]["UMNAST_VLM"].clone()).unwrap();
    // 10 g some 10 mm behind the trailing edge of the tip, as the reference carries it.
    let wing = without_skin_with([6, 16], MirrorPlane::Symmetric { y_m: 0.0 }, Some((0.01, 0.01)));
    let cases: Vec<SteadyCase> = (1..=22).map(|i| case(2.0 * f64::from(i), 7.0)).collect();
    let mut before: Option<(Mat<f64>, Vec<usize>)> = None;
    let mut curve: Vec<Vec<f64>> = Vec::new();
    for state in wing.solve(&cases, &neutral(&wing)).unwrap() {
        let (modes, shapes) = wing.tangent_modes(&state, 7).unwrap();
        let column = |of: &Mat<f64>, i: usize| of.col(i).iter().copied().collect::<Vec<f64>>();
        // Each followed by its shape from one airspeed to the next.
        let order: Vec<usize> = match &before {
            None => (0..5).collect(),
            Some((old, order)) => order
                .iter()
                .map(|mode| {
                    let alike = |i: usize| modal_assurance(&column(old, *mode), &column(&shapes, i));
                    (0..7).max_by(|a, b| alike(*a).total_cmp(&alike(*b))).unwrap()
                })
                .collect(),
        };
        let mut row = vec![100.0 * state.tip_m.z / SEMISPAN_M];
        row.extend(order.iter().map(|mode| modes.omega_rad_s[*mode] / TAU));
        println!("{row:.3?}");
        assert!(row.iter().all(|value| value.is_finite()), "tip and frequencies {row:?}");
        before = Some((shapes, order));
        curve.push(row);
    }
    let at = |z: f64, column: usize| {
        let pair = curve.windows(2).find(|pair| pair[0][0] <= z && z <= pair[1][0])?;
        let share = (z - pair[0][0]) / (pair[1][0] - pair[0][0]);
        Some(pair[0][column] + share * (pair[1][column] - pair[0][column]))
    };
    let tolerances = [0.02, 0.02, 0.04, 0.02, 0.05];
    let mut worst = [0.0_f64; 5];
    for row in table.iter().filter(|row| row[0] > 0.5) {
        for mode in 1..=5 {
            let Some(own) = at(row[0], mode) else { continue };
            worst[mode - 1] = worst[mode - 1].max((own / row[mode] - 1.0).abs());
            if mode == 3 {
                println!("tip {:.2} %: torsion {own:.2} Hz for {:.2}", row[0], row[mode]);
            }
        }
    }
    println!("largest differences of OOP1, OOP2, T1, OOP3, IP1: {worst:.4?}");
    for (mode, (worst, tolerance)) in worst.iter().zip(tolerances).enumerate() {
        assert!(*worst < tolerance, "mode {}: off by {worst}", mode + 1);
    }
}

#[test]
fn at_rest_doublets_and_turning_loads_are_the_change_of_the_steady_loads() {
    let wing = without_skin([6, 16], MirrorPlane::Symmetric { y_m: 0.0 });
    let (case, neutral) = (case(50.0, 5.0), neutral(&wing));
    let state = wing.solve(std::slice::from_ref(&case), &neutral).unwrap().remove(0);
    let motion = wing.small_motion(&case, &neutral, &state, 4).unwrap();
    let doublets = DoubletLattice::new(&motion.lattice, wing.elastic.plane, 0.0, &DlmSettings::default())
        .unwrap()
        .at(0.0)
        .unwrap();
    let w = Mat::from_fn(motion.lattice.len(), 4, |j, mode| c64::from(motion.incidence[(j, mode)]));
    let cp = doublets.pressures(w.as_ref());
    let q_pa = case.flow.dynamic_pressure_pa();
    let by_doublets = Mat::from_fn(4, 4, |i, mode| {
        let air: f64 = (0..cp.nrows()).map(|j| cp[(j, mode)].re * motion.work[(i, j)]).sum();
        q_pa * air + motion.load_stiffness[(i, mode)]
    });
    let by_steady = wing.following_work(&case, &neutral, &state, &motion).unwrap();
    let size =
        (0..4).flat_map(|i| (0..4).map(move |j| (i, j))).map(|at| by_steady[at].abs()).fold(0.0, f64::max);
    for i in 0..4 {
        for j in 0..4 {
            let (one, other) = (by_doublets[(i, j)], by_steady[(i, j)]);
            println!(
                "{i} {j}: {one:.3} by doublets, {other:.3} by differences, {:.3} of it turning loads",
                motion.load_stiffness[(i, j)]
            );
            assert!((one - other).abs() < 0.03 * size, "work of mode {i} by {j}: {one}, not {other}");
        }
    }
}
