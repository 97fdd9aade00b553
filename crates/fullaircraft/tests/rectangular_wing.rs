//! A rigid rectangular wing free in plunge, in discrete gusts and in continuous turbulence, by our doublet lattice and
//! `loads::turbulence`, beside numbers made with PanelAero (`data/rectangular_wing_*.json`).

use aero::{DlmSettings, DoubletLattice, Integration, KernelIntegral, Lattice, MirrorPlane, SpanFit};
use faer::{Mat, c64};
use loads::design::Spectrum;
use loads::turbulence::{Grid, Response, Turbulence};
use maneuver::gust::{FrequencyTable, OneMinusCosineGust, gust_incidence, periodic_response};
use serde_json::Value;
use std::f64::consts::TAU;

const ASPECT_RATIO: f64 = 6.0;
/// Lift, and bending moment of a half wing, over q S and q S c.
const LOADS: usize = 2;

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

/// Tables of lift and bending by a gust whose phase is taken at the leading edge, and by plunge, per incidence, over omega c/V.
fn tables() -> [FrequencyTable; 2] {
    let semispan = 0.5 * ASPECT_RATIO;
    let lattice =
        Lattice::trapezoid(1, [0.0; 3], 1.0, [0.0, semispan, 0.0], 1.0, [8, 16]).expect("a rectangle");
    let settings = DlmSettings { integral: KernelIntegral::Laschka, fit: SpanFit::Parabolic };
    let wall = MirrorPlane::Symmetric { y_m: 0.0 };
    let doublets = DoubletLattice::new(&lattice, wall, 0.0, &settings).expect("a half wing");
    let integration = Integration::new(&lattice);
    let kappa: Vec<f64> = (0..=24).map(|i| 4.0 * (f64::from(i) / 24.0).powi(2)).collect();
    let table = |middle: f64, incidence: &dyn Fn(f64) -> Mat<c64>| {
        let answer = |kappa: &f64| {
            let cp = doublets.at(*kappa).expect("a frequency").pressures(incidence(*kappa).as_ref());
            Mat::from_fn(LOADS, 1, |row, _| {
                let each = lattice.boxes.iter().enumerate().map(|(j, panel)| {
                    // both halves lift, one bends
                    cp[(j, 0)] * (integration.area(j) / ASPECT_RATIO * [2.0, panel.quarter_point().y][row])
                });
                each.sum::<c64>()
            })
        };
        FrequencyTable::new(kappa.clone(), kappa.iter().map(answer).collect(), middle).expect("rising")
    };
    let upwards = |_: f64| Mat::from_fn(lattice.len(), 1, |j, _| c64::from(lattice.boxes[j].normal().z));
    [table(0.5, &|kappa| gust_incidence(&lattice, 0.5, kappa)), table(0.0, &upwards)]
}

#[test]
fn a_rectangular_wing_in_turbulence_has_the_loads_and_correlations_of_another_doublet_lattice() {
    let text = include_str!("data/rectangular_wing_turbulence.json");
    let reference: Value = serde_json::from_str(text).expect("JSON");
    let [gust, plunge] = tables();
    let of = |table: &FrequencyTable, omega: f64| {
        let answers = table.at(omega, 0.0).expect("within the table");
        [answers[(0, 0)], answers[(1, 0)]]
    };
    for row in reference["turbulence"].as_array().expect("a list") {
        let (mu, scale) = (number(&row["mass_over_rho_S_c"]), number(&row["L_over_c"]));
        // chord and airspeed are one: omega c/V = 2 k
        let cut_off_hz = 2.0 * number(&row["k_max"]) / TAU;
        let grid = Grid::new(1.0, scale, cut_off_hz, &[], 6.0);
        let mut loads = vec![Vec::new(); 4];
        for omega in &grid.omega_rad_s {
            let ([lift, bends], [damps, damps_bending]) = (of(&gust, *omega), of(&plunge, *omega));
            let s = c64::new(0.0, *omega);
            // m z'' = q S (C_g w - C_p z') over rho S V^2: 2 mu s z' = C_g w - C_p z'
            let rate = lift / (s * (2.0 * mu) + damps);
            let lifts = lift - damps * rate;
            let air = bends - damps_bending * rate;
            let acceleration = s * rate;
            // half of the mass is spread over the span: a quarter on each half, at half of its semispan
            let inertia = acceleration * (2.0 * mu * 0.25 * 0.25 * ASPECT_RATIO);
            let all = [acceleration, lifts, air, air - inertia];
            loads.iter_mut().zip(all).for_each(|(list, value)| list.push(value));
        }
        let turbulence = Turbulence { v_m_s: 1.0, scale_m: scale, spectrum: Spectrum::Karman };
        let response = Response::new(&grid, turbulence, &loads);
        let near = |what: &str, ours: f64, expected: &Value, share: f64| {
            let off = (ours / number(expected) - 1.0).abs();
            println!("mu {mu}, cut-off {cut_off_hz:.3}, {what}: {ours:.6} {expected}, {off:.1e}");
            assert!(off < share, "mu {mu}, cut-off {cut_off_hz:.3}, {what}: {ours} beside {expected}");
        };
        for (at, name) in ["acc_c_over_V2", "CL", "air_bending", "net_bending"].into_iter().enumerate() {
            near(name, response.a_bar(at), &row["A_bar_per_w_over_V"][name], 0.01);
        }
        near("N0 of the acceleration", response.n0_hz(0), &row["N0_acc_c_over_V"], 0.03);
        for (at, name) in [(2, "corr_acc_air_bending"), (3, "corr_acc_net_bending")] {
            let off = response.rho(0, at) - number(&row[name]);
            assert!(off.abs() < 0.002, "mu {mu}, {name}: {off} beside {}", row[name]);
        }
    }
}

#[test]
fn a_rectangular_wing_free_in_plunge_peaks_in_discrete_gusts_as_by_another_doublet_lattice() {
    let reference: Value =
        serde_json::from_str(include_str!("data/rectangular_wing_gust.json")).expect("JSON");
    let [gust, plunge] = tables();
    let slope = plunge.at(0.0, 0.0).expect("within the table")[(0, 0)].re;
    // the reference's period of 4000 chords and its cut-off at omega c/V = 4
    let (samples, cut_off) = (32_768, 4.0);
    let step = 4000.0 / f64::from(samples);
    for row in reference["cases"].as_array().expect("a list") {
        let (mu_g, gradient) = (number(&row["mu_g"]), number(&row["H_over_c"]));
        // mu_g = 2 m/(rho S c a); the sharp edge gives a/(2 m/(rho S c)) = 1/mu_g
        let shape = OneMinusCosineGust { incidence_rad: 1.0, length_m: 2.0 * gradient, start_s: 0.0 };
        let signal: Vec<f64> = (0..samples).map(|k| shape.at(step * f64::from(k), 1.0)).collect();
        let answer = |omega: f64| {
            let [lift, damps] = [gust.at(omega, 0.0)?, plunge.at(omega, 0.0)?].map(|answers| answers[(0, 0)]);
            let s = c64::new(0.0, omega);
            Ok::<_, maneuver::flutter::FlutterError>(vec![s * lift / (s * (mu_g * slope) + damps) * mu_g])
        };
        let found = periodic_response(&signal, step, cut_off, answer).expect("within the table");
        let peak = found.answers[0].iter().copied().fold(0.0, f64::max);
        let expected = number(&row["peak_over_sharp_edge"]);
        println!("mu_g {mu_g}, H {gradient} c: {peak:.6} beside {expected:.6}");
        assert!(
            (peak / expected - 1.0).abs() < 0.01,
            "mu_g {mu_g}, H {gradient} c: {peak} beside {expected}"
        );
    }
}
