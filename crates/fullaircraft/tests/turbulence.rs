//! Continuous turbulence on the free elastic aircraft: its transfer functions beside flights in time, limit loads and companions as
//! identities of cards, symmetry, and grids of frequencies.

use crate::common::{air, whole};
use coupling::wing_file::StationAt;
use faer::c64;
use fullaircraft::flight::loads::LoadedTrim;
use fullaircraft::flight::turbulence::{AtLimit, PANELS_A_DECADE, TurbulentLoads};
use fullaircraft::package::cards::{CardCase, structure};
use fullaircraft::package::round_trip::{Expected, RoundTrip, Row, round_trip_csv};
use fullaircraft::{
    Aircraft, Component, FlightLoads, FlightPoint, Gust, GustAxis, Station, Steady, TrimTools,
};
use loads::design::Spectrum;
use loads::turbulence::{Grid, Turbulence};
use std::f64::consts::{PI, TAU};

const V_M_S: f64 = 30.0;
const SCALE_M: f64 = 762.0;
const CUT_OFF_HZ: f64 = 30.0;

fn stations(aircraft: &Aircraft) -> Vec<Station> {
    let half = StationAt { name: "half".to_owned(), x_m: Some(0.42), y_m: 0.9, z_m: None };
    let mut all = aircraft.wing_stations(&[half]).expect("it is on the wing");
    all.extend(aircraft.body_stations());
    all
}

/// Flies the shipped aircraft with beams from level flight.
fn flying(axis: GustAxis, then: impl FnOnce(&FlightLoads<'_>)) {
    let aircraft = whole();
    let tools = TrimTools::new(aircraft, &[]).expect("the shipped aircraft flies");
    let model = aircraft.uncorrected();
    let at = tools.at(&model, V_M_S).expect("the shipped aircraft flies");
    let found = at.solve(&Steady::Level.case(&aircraft.file, V_M_S)).expect("the shipped aircraft flies");
    let point = FlightPoint { v_m_s: V_M_S, load_factor: 1.0, pitch_rate_deg_s: 0.0 };
    let trimmed = at.trimmed(&found, &point);
    let steady = at.nodal_loads(&found);
    let trim = LoadedTrim { model: &model, air: air(), trimmed: &trimmed, steady, drives: Vec::new(), axis };
    then(&FlightLoads::new(trim, stations(aircraft), 0.001).expect("the shipped aircraft flies"));
}

fn in_turbulence<'a>(flight: &'a FlightLoads<'_>, cut_off_hz: f64, panels: f64) -> TurbulentLoads<'a> {
    let held = flight.held();
    let modes = held.modes().expect("nothing grows");
    let turbulence = Turbulence { v_m_s: V_M_S, scale_m: SCALE_M, spectrum: Spectrum::Karman };
    flight.in_turbulence(&held, turbulence, Grid::new(V_M_S, SCALE_M, cut_off_hz, &modes, panels))
}

/// What a change is at a time by the transfer function: 1/pi Re int H W exp(i w t) dw.
fn in_time(transfer: &[c64], gust: &[c64], grid: &Grid, t_s: f64) -> f64 {
    let terms = transfer.iter().zip(gust).zip(grid.omega_rad_s.iter().zip(&grid.weight_rad_s));
    terms.map(|((h, w), (omega, weight))| (h * w * c64::cis(omega * t_s)).re * weight / PI).sum()
}

/// Fourier's integral of one minus a cosine that lasts L/V.
fn transformed(gust: &Gust, omega_rad_s: f64) -> c64 {
    let (steps, lasts_s) = (400, gust.length_m / V_M_S);
    let step_s = lasts_s / f64::from(steps);
    let one = |k: i32| {
        let t_s = step_s * f64::from(k);
        let w = 0.5 * gust.velocity_m_s * (1.0 - (TAU * t_s / lasts_s).cos());
        c64::cis(-omega_rad_s * t_s) * (w * step_s)
    };
    (1..steps).map(one).sum()
}

#[test]
fn a_flown_gust_is_the_fourier_integral_of_the_transfer_functions_to_it() {
    // airspeed and attitude, held in turbulence, hardly change in half a second
    let gust = Gust { velocity_m_s: 3.0, length_m: 6.0, start_s: 0.0 };
    for (axis, loads) in [(GustAxis::Vertical, [2, 3, 4]), (GustAxis::Lateral, [1, 3, 5])] {
        flying(axis, |flight| {
            let held = flight.held();
            let turbulence = Turbulence { v_m_s: V_M_S, scale_m: 7.62, spectrum: Spectrum::Karman };
            let grid = Grid::new(V_M_S, turbulence.scale_m, 60.0, &held.modes().unwrap(), 60.0);
            let wave: Vec<c64> = grid.omega_rad_s.iter().map(|omega| transformed(&gust, *omega)).collect();
            let turbulent = flight.in_turbulence(&held, turbulence, grid);
            let flown = flight.fly(Some(gust), &[], 401);
            for (station, load) in (0..4).flat_map(|station| loads.map(|load| (station, load))) {
                let change = |sample: usize| {
                    flown.at_station(station, Component::Net, sample)[load]
                        - flown.at_station(station, Component::Net, 0)[load]
                };
                let largest = (0..401).map(|sample| change(sample).abs()).fold(0.0, f64::max);
                let mut off = 0.0_f64;
                for sample in (0..401).step_by(10) {
                    let by_frequency = in_time(
                        turbulent.transfer(station, load),
                        &wave,
                        turbulent.grid(),
                        flown.t_s[sample],
                    );
                    off = off.max((by_frequency - change(sample)).abs() / largest);
                }
                println!("{axis:?} station {station} load {load}: {off:.4} of {largest:.3}");
                assert!(off < 0.03, "{axis:?}, station {station}, load {load}: off by {off} of {largest}");
            }
        });
    }
}

#[test]
fn cards_of_a_load_at_its_limit_sum_up_to_the_limit_and_to_the_companions_of_all_others() {
    let aircraft = whole();
    let stations = stations(aircraft);
    let back = RoundTrip::new(aircraft, &stations, &structure(aircraft, &[])).unwrap();
    let (tips, u_sigma_m_s) = (back.tips(), 8.0);
    for axis in [GustAxis::Vertical, GustAxis::Lateral] {
        flying(axis, |flight| {
            let turbulent = in_turbulence(flight, CUT_OFF_HZ, PANELS_A_DECADE);
            let response = turbulent.response();
            for (sid, station, direction, is_largest) in [(1, 0, 1, true), (2, 2, 0, false), (3, 3, 2, true)]
            {
                let along = axis.along()[direction];
                let load = along.shares.iter().position(|share| *share != 0.0).unwrap();
                let i = 6 * station + load;
                let sign = if is_largest { u_sigma_m_s } else { -u_sigma_m_s };
                let goes = |other: usize| {
                    std::array::from_fn(|row| {
                        let j = 6 * other + row;
                        let rho = if i == j { 1.0 } else { response.rho(i, j) };
                        flight.at_trim(other, Component::Net)[row] + sign * rho * response.a_bar(j)
                    })
                };
                let flown = turbulent.at_limits(&[AtLimit { station, along, is_largest }], u_sigma_m_s);
                let net = flown.nodal_loads(0).of(Component::Net);
                let tip = |side| net.iter().enumerate().map(|(dof, load)| tips[(dof, side)] * load).sum();
                let expected = Expected {
                    stations: (0..stations.len()).map(goes).collect(),
                    tips_m: vec![tip(0), tip(1)],
                };
                let case = CardCase { sid, words: "turbulence".to_owned(), net, parts: Vec::new() };
                let rows = back.compare(&case, &case.text(aircraft.free.node_ids(), &[]), &expected).unwrap();
                assert!(rows.iter().all(Row::holds), "{axis:?}, {}\n{}", along.words, round_trip_csv(&rows));
            }
        });
    }
}

#[test]
fn a_corner_of_two_moments_lies_on_the_ellipse_of_equal_probability() {
    flying(GustAxis::Vertical, |flight| {
        let turbulent = in_turbulence(flight, CUT_OFF_HZ, PANELS_A_DECADE);
        let response = turbulent.response();
        let (u_sigma_m_s, trim) = (5.0, flight.at_trim(0, Component::Net));
        let corners = response.design_points([3, 4], [trim[3], trim[4]], u_sigma_m_s);
        for (direction, places) in [(3, [4, 5]), (4, [6, 7])] {
            for (is_largest, place) in [(true, places[0]), (false, places[1])] {
                let along = GustAxis::Vertical.along()[direction];
                let flown = turbulent.at_limits(&[AtLimit { station: 0, along, is_largest }], u_sigma_m_s);
                let net = flown.at_station(0, Component::Net, 0);
                for (row, expected) in [3, 4].into_iter().zip(corners[place]) {
                    let size = u_sigma_m_s * response.a_bar(row);
                    assert!(
                        (net[row] - expected).abs() < 1e-9 * size,
                        "{}: {} for {expected}",
                        along.words,
                        net[row]
                    );
                }
            }
        }
    });
}

#[test]
fn vertical_turbulence_loads_both_wings_alike_and_lateral_turbulence_opposite() {
    // right and left root are stations 0 and 1; of an image Fy, Mx and Mz change sign
    let image = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0];
    for (axis, sign) in [(GustAxis::Vertical, 1.0), (GustAxis::Lateral, -1.0)] {
        flying(axis, |flight| {
            let turbulent = in_turbulence(flight, CUT_OFF_HZ, PANELS_A_DECADE);
            let response = turbulent.response();
            for (load, image) in image.into_iter().enumerate() {
                let rho = response.rho(load, 6 + load);
                let a = [response.a_bar(load), response.a_bar(6 + load)];
                assert!((rho - sign * image).abs() < 1e-6, "{axis:?}, load {load}: rho {rho}");
                assert!((a[0] / a[1] - 1.0).abs() < 1e-5, "{axis:?}, load {load}: {a:?}");
            }
        });
    }
}

#[test]
fn half_as_fine_a_grid_gives_the_same_and_turbulence_below_the_first_mode_has_no_tail_bound() {
    flying(GustAxis::Vertical, |flight| {
        let [fine, coarse] =
            [PANELS_A_DECADE, 0.5 * PANELS_A_DECADE].map(|panels| in_turbulence(flight, CUT_OFF_HZ, panels));
        let (of_fine, of_coarse) = (fine.response(), coarse.response());
        for at in [2, 3, 4, 12 + 2, 12 + 3, 12 + 4] {
            let (a, b) = (of_fine.a_bar(at), of_coarse.a_bar(at));
            println!("{at}: {a} {b}, N0 {} Hz, tail {:?}", of_fine.n0_hz(at), of_fine.tail_bound(at));
            assert!((a / b - 1.0).abs() < 1e-4, "load {at}: {a} beside {b} per m/s");
        }
        assert!(in_turbulence(flight, 2.0, PANELS_A_DECADE).response().tail_bound(3).is_none());
    });
}

#[test]
fn the_same_lateral_gust_everywhere_is_a_sideslip() {
    let (air, still) = (air(), &air().incidence.still);
    for j in 0..still.nrows() {
        let stations = 0..air.columns.gusts;
        let gusts: f64 = stations.map(|at| still[(j, air.columns.gust_along(GustAxis::Lateral, at))]).sum();
        assert!((gusts - still[(j, 1)]).abs() < 1e-14, "box {j}: {gusts} for {}", still[(j, 1)]);
    }
}
