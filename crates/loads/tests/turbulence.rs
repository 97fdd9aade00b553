//! Turbulence and discrete gusts on aircraft in plunge, written as transfer functions and equations of motion, beside
//! `plunge_gust.json` and `flexible_plunge.json`.

use crate::close::close;
use crate::common::{number, reference};
use crate::plunge::{Flexible, Rigid};
use loads::design::Spectrum;
use loads::rules::discrete::design_gust;
use loads::tuning::{Tuned, worst};
use loads::turbulence::{Complex64, Grid, Mode, Response, Turbulence};
use serde_json::Value;

/// Far above all that responds: closed forms have no cut-off.
const NO_CUT_OFF_HZ: f64 = 1e12;

/// Root mean square of z'' in V^2/c for turbulence of V.
fn rigid_rms(rigid: Rigid, scale_over_chord: f64, spectrum: Spectrum) -> f64 {
    let grid = Grid::new(1.0, scale_over_chord, NO_CUT_OFF_HZ, &[], 6.0);
    let loads = [grid.omega_rad_s.iter().map(|omega| rigid.acceleration(*omega)).collect::<Vec<_>>()];
    let turbulence = Turbulence { v_m_s: 1.0, scale_m: scale_over_chord, spectrum };
    Response::new(&grid, turbulence, &loads).a_bar(0)
}

#[test]
fn a_rigid_aircraft_in_drydens_turbulence_has_the_closed_forms_root_mean_square() {
    for mu_g in [3.0, 5.0, 10.0, 20.0, 50.0, 100.0] {
        for scale in [100.0, 250.0] {
            let r: f64 = scale / mu_g;
            let exact = (1.0 + 1.5 * r).sqrt() / (1.0 + r) / mu_g;
            let ours = rigid_rms(Rigid { mu_g, lagged: false }, scale, Spectrum::Dryden);
            assert!((ours / exact - 1.0).abs() < 1e-9, "mu {mu_g}, L/c {scale}: {ours} beside {exact}");
        }
    }
}

#[test]
fn root_mean_squares_in_both_spectra_with_and_without_lags_are_those_of_the_reference() {
    for row in reference("plunge_gust.json")["turbulence"].as_array().unwrap() {
        let (mu_g, scale) = (number(&row["mu_g"]), number(&row["L_over_c"]));
        for (spectrum, name) in [(Spectrum::Dryden, "dryden"), (Spectrum::Karman, "karman")] {
            for (lagged, words) in [(false, "quasi_steady"), (true, "lagged")] {
                let key = format!("{name}_{words}");
                close(rigid_rms(Rigid { mu_g, lagged }, scale, spectrum), &row[&key], 1e-6, &key);
            }
        }
    }
}

/// CS 25.341(a)(2): `U/2 (1 - cos(pi s/H))` for 0 <= s <= 2 H.
fn one_minus_cosine(size: f64, gradient: f64, s: f64) -> f64 {
    let inside = (0.0..=2.0 * gradient).contains(&s);
    if inside { size / 2.0 * (1.0 - (std::f64::consts::PI * s / gradient).cos()) } else { 0.0 }
}

#[test]
fn a_rigid_aircraft_through_one_minus_a_cosine_peaks_as_in_the_reference() {
    for row in reference("plunge_gust.json")["one_minus_cosine"].as_array().unwrap() {
        for chords in ["5", "12.5", "25"] {
            let expected = &row[&format!("H_over_c_{chords}")];
            let gradient: f64 = chords.parse().unwrap();
            let peak = |lagged| {
                let rigid = Rigid { mu_g: number(&row["mu_g"]), lagged };
                rigid.peak(&|tau| one_minus_cosine(1.0, gradient, tau), 2.0 * gradient)
            };
            close(peak(false), &expected["quasi_steady_peak_over_sharp_edge"], 1e-6, "quasi-steady peak");
            close(peak(true), &expected["lagged_peak_over_sharp_edge"], 1e-6, "peak with lags");
        }
    }
}

#[test]
fn the_worst_gradient_by_ten_and_a_step_is_that_of_two_hundred() {
    let size = |gradient: f64| {
        let rigid = Rigid { mu_g: 60.0, lagged: true };
        // Chords of 1.5 m.
        let peak = rigid.peak(&|tau| one_minus_cosine(1.0, gradient / 1.5, tau), 2.0 * gradient / 1.5);
        design_gust(17.07, 0.9, gradient) * peak
    };
    let between = |n: i32| -> Vec<f64> {
        (0..n).map(|at| 9.0 * (107.0f64 / 9.0).powf(f64::from(at) / f64::from(n - 1))).collect()
    };
    let (ten, all) = (between(10), between(200));
    let sizes: Vec<f64> = ten.iter().map(|h| size(*h)).collect();
    let found = worst(&ten, &sizes).unwrap();
    assert_eq!(found.tuned, Tuned::Inside);
    let refined = sizes[found.place].max(size(found.next_m.unwrap()));
    let best = all.iter().map(|h| size(*h)).fold(0.0, f64::max);
    assert!((refined / best - 1.0).abs() < 0.005, "{refined} beside {best}");
    assert!(refined >= sizes[found.place]);
}

#[test]
fn a_worst_gradient_at_the_end_of_the_range_is_not_tuned_and_says_so() {
    // Falls with H from the first on, as for chords of 0.2 m.
    let found = worst(&[9.0, 20.0, 40.0], &[3.0, 2.0, 1.0]).unwrap();
    assert_eq!((found.tuned, found.next_m), (Tuned::AtShortest, None));
    assert!(found.tuned.warning("root My", 9.0).unwrap().contains("9.0 m, the range's end"));
    assert_eq!(worst(&[9.0, 20.0, 40.0], &[1.0, 2.0, 3.0]).unwrap().tuned, Tuned::AtLongest);
    // The parabola through three points of one is its top: 1 - (ln H - ln 20)^2.
    let f = |h: f64| 1.0 - (h.ln() - 20.0f64.ln()).powi(2);
    let found = worst(&[9.0, 18.0, 40.0], &[f(9.0), f(18.0), f(40.0)]).unwrap();
    assert!((found.next_m.unwrap() - 20.0).abs() < 1e-9, "{found:?}");
    assert_eq!(worst(&[], &[]), None);
}

/// Four loads of a flexible aircraft at the frequencies of a grid.
fn flexible_loads(aircraft: &Flexible, grid: &Grid) -> Vec<Vec<Complex64>> {
    let all: Vec<[Complex64; 4]> = grid.omega_rad_s.iter().map(|omega| aircraft.loads(*omega)).collect();
    (0..4).map(|load| all.iter().map(|loads| loads[load]).collect()).collect()
}

fn modes(row: &Value) -> Vec<Mode> {
    let poles = row["aeroelastic_poles"].as_array().expect("poles").iter();
    poles.map(|pole| Mode { decay_rad_s: -number(&pole[0]), omega_rad_s: number(&pole[1]) }).collect()
}

#[test]
fn loads_of_a_flexible_aircraft_their_correlations_and_crossings_are_those_of_the_reference() {
    for (name, row) in reference("flexible_plunge.json")["aircraft"].as_object().unwrap() {
        let aircraft = Flexible::of(&row["inputs"]);
        let scale_m = number(&row["L_m"]);
        let grid = Grid::new(aircraft.v_m_s, scale_m, 1e6, &modes(row), 6.0);
        let loads = flexible_loads(&aircraft, &grid);
        for (spectrum, key) in [(Spectrum::Dryden, "dryden_lyapunov"), (Spectrum::Karman, "karman")] {
            let turbulence = Turbulence { v_m_s: aircraft.v_m_s, scale_m, spectrum };
            let response = Response::new(&grid, turbulence, &loads);
            for i in 0..4 {
                close(response.a_bar(i), &row[key]["A_bar_per_m_s"][i], 1e-5, &format!("{name} {key} A {i}"));
                for j in 0..4 {
                    let expected = number(&row[key]["correlation"][i][j]);
                    assert!((response.rho(i, j) - expected).abs() < 1e-5, "{name} {key} rho {i} {j}");
                }
                if let Some(n0) = row[key].get("N0_hz") {
                    close(response.n0_hz(i), &n0[i], 1e-3, &format!("{name} N0 {i}"));
                }
            }
        }
    }
}

#[test]
fn a_grid_half_as_fine_gives_the_same_and_the_tail_bound_holds_what_a_doubled_cut_off_adds() {
    let all = reference("flexible_plunge.json");
    let row = &all["aircraft"]["uav_20kg"];
    let (aircraft, scale_m) = (Flexible::of(&row["inputs"]), number(&row["L_m"]));
    let a_bar = |cut_off_hz: f64, panels: f64| -> Vec<(f64, Option<f64>)> {
        let grid = Grid::new(aircraft.v_m_s, scale_m, cut_off_hz, &modes(row), panels);
        let loads = flexible_loads(&aircraft, &grid);
        let turbulence = Turbulence { v_m_s: aircraft.v_m_s, scale_m, spectrum: Spectrum::Karman };
        let response = Response::new(&grid, turbulence, &loads);
        (0..4).map(|load| (response.a_bar(load), response.tail_bound(load))).collect()
    };
    for (fine, coarse) in a_bar(30.0, 6.0).iter().zip(a_bar(30.0, 3.0)) {
        assert!((fine.0 / coarse.0 - 1.0).abs() < 1e-4, "{fine:?} beside {coarse:?}");
    }
    for cut_off in [30.0, 60.0, 120.0] {
        for (load, (at, doubled)) in a_bar(cut_off, 6.0).iter().zip(a_bar(2.0 * cut_off, 6.0)).enumerate() {
            let grown = doubled.0 / at.0 - 1.0;
            let bound = at.1.unwrap();
            assert!((0.0..=bound).contains(&grown), "{cut_off} Hz, load {load}: {grown} beside {bound}");
        }
    }
    // The second mode, at 17 Hz, is beyond 10 Hz: there is no bound.
    assert!(a_bar(10.0, 6.0).iter().all(|(_, bound)| bound.is_none()));
}

#[test]
fn companions_of_parts_sum_up_to_the_limit_load_and_points_lie_on_the_ellipse() {
    let all = reference("flexible_plunge.json");
    let row = &all["aircraft"]["uav_20kg"];
    let (aircraft, scale_m) = (Flexible::of(&row["inputs"]), number(&row["L_m"]));
    let grid = Grid::new(aircraft.v_m_s, scale_m, 30.0, &modes(row), 6.0);
    let loads = flexible_loads(&aircraft, &grid);
    let turbulence = Turbulence { v_m_s: aircraft.v_m_s, scale_m, spectrum: Spectrum::Karman };
    let response = Response::new(&grid, turbulence, &loads);
    // Two parts that are no multiples of each other sum up to a load: so do their companions.
    let part = |share: &dyn Fn(f64) -> f64| -> Vec<Complex64> {
        loads[1].iter().zip(&grid.omega_rad_s).map(|(h, omega)| h * share(*omega)).collect()
    };
    let parts = [part(&|omega| (0.1 * omega).sin()), part(&|omega| 1.0 - (0.1 * omega).sin())];
    for at_limit in 0..4 {
        let sum: f64 = parts.iter().map(|part| response.companion(part, at_limit)).sum();
        let expected = response.rho(at_limit, 1) * response.a_bar(1);
        assert!((sum - expected).abs() < 1e-12 * response.a_bar(1), "{sum} beside {expected}");
    }
    assert!((response.companion(&loads[1], 1) - response.a_bar(1)).abs() < 1e-12);
    let (one_g, u_sigma) = ([100.0, -20.0], 25.0);
    let [high, low] = response.limits(1, one_g[0], u_sigma);
    assert!((high + low - 200.0).abs() < 1e-9 && (high - low - 50.0 * response.a_bar(1)).abs() < 1e-9);
    let rho = response.rho(1, 2);
    for point in response.design_points([1, 2], one_g, u_sigma) {
        let [x, y] = [0, 1].map(|at| (point[at] - one_g[at]) / (u_sigma * response.a_bar(at + 1)));
        // Equal probability: x^2 - 2 rho x y + y^2 = 1 - rho^2.
        assert!((x * x - 2.0 * rho * x * y + y * y - (1.0 - rho * rho)).abs() < 1e-9, "{x} {y}");
    }
}
