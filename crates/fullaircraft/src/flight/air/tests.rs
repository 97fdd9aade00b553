//! Unsteady air of a small aircraft beside its lattice, and the numbers it is made with.

use super::{AirColumns, LAGS, REDUCED_FREQUENCIES, RIGID, between, lattice, poles_per_m, significant};
use crate::aircraft::small::{air, aircraft};
use crate::flight::gust::GustAxis;
use faer::Mat;
use maneuver::air::accuracy;

#[test]
fn columns_stand_one_after_the_other_and_those_of_modes_and_controls_are_no_incidences() {
    let columns = AirColumns { modes: 3, controls: 2, gusts: 4 };
    assert_eq!([columns.mode(0), columns.mode(2), columns.control(0), columns.control(1)], [5, 7, 8, 9]);
    assert_eq!([columns.gust(0), columns.gust(3)], [10, 13]);
    assert_eq!([0, 3].map(|at| columns.gust_along(GustAxis::Lateral, at)), [14, 17]);
    assert_eq!(columns.count(), 18);
    let incidences: Vec<usize> = (0..18).filter(|column| columns.is_incidence(*column)).collect();
    assert_eq!(incidences, [0, 1, 2, 3, 4, 10, 11, 12, 13, 14, 15, 16, 17]);
}

#[test]
fn a_place_between_two_stations_is_shared_between_them_linearly() {
    let stations = [1.0, 2.0, 4.0, 5.0];
    for (x_m, law) in [(1.0, (0, 0.0)), (1.25, (0, 0.25)), (2.0, (1, 0.0)), (3.5, (1, 0.75)), (4.0, (2, 0.0))]
    {
        assert_eq!(between(&stations, x_m), law, "{x_m} m");
    }
    assert_eq!(between(&stations, 5.0), (2, 1.0), "the last is the end of the last interval");
    assert_eq!(between(&stations, 4.9).0, 2);
}

/// What of two rows of two entries counts.
fn counts(rows: [[f64; 2]; 2]) -> [[bool; 2]; 2] {
    let largest = Mat::from_fn(2, 2, |i, j| rows[i][j]);
    let found = significant(&largest);
    [0, 1].map(|i| {
        [0, 1].map(|j| {
            assert!(found[(i, j)] == 0.0 || found[(i, j)] == largest[(i, j)], "it keeps its size");
            found[(i, j)] != 0.0
        })
    })
}

#[test]
fn entries_are_significant_beside_the_largest_of_their_row_and_column_whatever_their_units() {
    assert_eq!(counts([[1.0, 1.0], [1.0, 1.0]]), [[true; 2]; 2]);
    // a hundredth and less of both its row and its column is nothing, in any unit of a row
    for unit in [1.0, 1e6, 1e-6] {
        assert_eq!(counts([[unit, 0.011 * unit], [1.0, 1.0]]), [[true; 2]; 2]);
        assert_eq!(counts([[unit, 0.009 * unit], [1.0, 1.0]]), [[true, false], [true, true]]);
        assert_eq!(counts([[1.0, 1.0], [0.009 * unit, unit]]), [[true, true], [false, true]]);
    }
    // small in its row alone: the largest of its column
    assert_eq!(counts([[100.0, 0.5], [50.0, 0.2]]), [[true; 2]; 2]);
    assert_eq!(counts([[100.0, 0.5], [100.0, 0.0045]]), [[true, true], [true, false]]);
    assert_eq!(counts([[0.0, 0.0], [1.0, 0.0]]), [[false, false], [true, false]]);
}

#[test]
fn poles_are_a_geometric_row_between_their_reduced_frequencies() {
    let poles = poles_per_m(0.5);
    assert_eq!(poles.len(), LAGS);
    assert!((poles[0] - 0.05 * 4.0).abs() < 1e-14 && (poles[LAGS - 1] - 4.0).abs() < 1e-14, "k = 0.05 to 1");
    let ratio = 20.0_f64.powf(1.0 / 9.0);
    assert!(poles.windows(2).all(|pair| (pair[1] / pair[0] - ratio).abs() < 1e-12));
}

#[test]
fn gusts_are_known_from_the_foremost_to_the_rearmost_box_in_equal_steps_of_a_decimetre_at_most() {
    let (x_m, lattice) = (&air().gust_x_m, &aircraft().flow.lattice);
    let places = || lattice.boxes.iter().map(|panel| panel.three_quarter_point().x);
    let (first, last) = (places().fold(f64::INFINITY, f64::min), places().fold(f64::NEG_INFINITY, f64::max));
    assert_eq!(x_m[0], first);
    assert!((x_m[x_m.len() - 1] - last).abs() < 1e-12);
    let step = (last - first) / (x_m.len() - 1) as f64;
    assert!(step <= 0.1 && (last - first) / (x_m.len() - 2) as f64 > 0.1, "no more than are needed");
    assert!(x_m.windows(2).all(|pair| (pair[1] - pair[0] - step).abs() < 1e-12));
}

#[test]
fn the_mean_chord_and_the_table_s_highest_frequency_are_the_wing_s() {
    // a taper from 0.30 to 0.15 m over 1.8 m
    assert!((air().chord_m - 0.225).abs() < 1e-6, "{}", air().chord_m);
    let kappa: Vec<f64> = REDUCED_FREQUENCIES.iter().map(|k| k / (0.5 * air().chord_m)).collect();
    assert_eq!(air().table.omega_over_v_per_m, kappa);
    // k = pi f c/V
    let hz = air().highest_hz(27.0);
    assert!((std::f64::consts::PI * hz * air().chord_m / 27.0 - 2.0).abs() < 1e-12, "{hz}");
    let fastest = air().modes.frequencies_hz().last().copied().expect("modes");
    let v_m_s = fastest * std::f64::consts::PI * air().chord_m / 2.0;
    assert!(air().warning(1.01 * v_m_s).is_none());
    assert!(air().warning(0.99 * v_m_s).expect("too slow").contains("below the fastest mode"));
}

#[test]
fn a_gust_everywhere_is_an_incidence_and_modes_and_controls_meet_the_air_as_they_move() {
    let (air, lattice) = (air(), &aircraft().flow.lattice);
    let [still, moving] = [&air.incidence.still, &air.incidence.moving];
    for (j, panel) in lattice.boxes.iter().enumerate() {
        for (axis, rigid) in [(GustAxis::Vertical, 0), (GustAxis::Lateral, 1)] {
            let of = |at: usize| still[(j, air.columns.gust_along(axis, at))];
            let sum: f64 = (0..air.columns.gusts).map(of).sum();
            let place: f64 = (0..air.columns.gusts).map(|at| of(at) * air.gust_x_m[at]).sum();
            assert!((sum - still[(j, rigid)]).abs() < 1e-14, "box {j}: {sum}");
            let law = sum * panel.three_quarter_point().x;
            assert!((place - law).abs() < 1e-12, "box {j} meets it where it is: {place} {law}");
        }
        // a mode's incidence: its slope, and at rates what its three-quarter point moves down
        for mode in 0..air.columns.modes {
            let (h, theta) = (air.modes.boxes[(2 * j, 6 + mode)], air.modes.boxes[(2 * j + 1, 6 + mode)]);
            let behind = (panel.three_quarter_point() - panel.mid_point()).norm();
            assert_eq!(still[(j, air.columns.mode(mode))], theta);
            assert!((moving[(j, air.columns.mode(mode))] - (theta * behind - h)).abs() < 1e-9);
        }
        for (c, control) in aircraft().flow.controls.iter().enumerate() {
            assert_eq!(still[(j, air.columns.control(c))], control.column(lattice.len())[j]);
            assert_eq!(moving[(j, air.columns.control(c))], control.rate_column_m(lattice.len())[j]);
        }
        assert!((0..RIGID).all(|rigid| moving[(j, rigid)] == 0.0));
    }
    assert!(air.columns.modes > 0 && aircraft().flow.controls.len() == 7);
}

#[test]
fn errors_of_the_rational_function_at_a_frequency_of_the_table_are_those_beside_the_table() {
    let air = air();
    let rows = air.modes.generalised_rows(aircraft());
    let rows = aircraft().flow.integration.rows_by_pressure(rows.as_ref());
    let largest = significant(&accuracy::largest(rows.as_ref(), air.table.cp.iter()));
    for at in [0, 3, 6] {
        let found = air.error_at(aircraft(), REDUCED_FREQUENCIES[at]).expect("it can be solved");
        let kappa = air.table.omega_over_v_per_m[at];
        let sample = [(kappa, air.table.cp[at].clone())];
        let law = accuracy::Accuracy::at(&air.rational, &sample, rows.as_ref(), largest.as_ref()).error;
        for i in 0..law.nrows() {
            for j in 0..law.ncols() {
                assert!((found[(i, j)] - law[(i, j)]).abs() < 1e-9, "k {kappa}, {i} {j}: {}", found[(i, j)]);
            }
        }
        let solved = lattice(aircraft()).expect("boxes").at(kappa).expect("it can be solved");
        let cp = solved.pressures(air.incidence.incidence(kappa).as_ref());
        assert!((&cp - &air.table.cp[at]).norm_l2() < 1e-12 * cp.norm_l2());
    }
    let steady = aircraft().flow.pressures(air.incidence.still.as_ref());
    assert!(
        (air.steady() - &steady).norm_l2() < 1e-12 * steady.norm_l2(),
        "at rest it is the vortex lattice's"
    );
}

#[test]
fn a_rigid_aircraft_s_air_is_the_same_without_modes_and_quasi_steady_without_lags() {
    let (elastic, rigid) = (air(), air().rigid());
    assert_eq!((rigid.columns.modes, rigid.columns.controls), (0, elastic.columns.controls));
    assert_eq!((rigid.modes.elastic(), rigid.steady().ncols()), (0, rigid.columns.count()));
    let pairs = (0..RIGID)
        .map(|at| (at, at))
        .chain((0..rigid.columns.controls).map(|at| (rigid.columns.control(at), elastic.columns.control(at))))
        .chain((0..rigid.columns.gusts).map(|at| (rigid.columns.gust(at), elastic.columns.gust(at))));
    for (own, from) in pairs {
        for j in 0..rigid.steady().nrows() {
            assert_eq!(rigid.steady()[(j, own)], elastic.steady()[(j, from)]);
            assert_eq!(rigid.rational.rate[(j, own)], elastic.rational.rate[(j, from)]);
            assert_eq!(rigid.incidence.moving[(j, own)], elastic.incidence.moving[(j, from)]);
            assert_eq!(rigid.rational.lags[4][(j, own)], elastic.rational.lags[4][(j, from)]);
        }
    }
    let quasi = elastic.rigid_and_quasi_steady(aircraft());
    assert!(quasi.rational.poles_per_m.is_empty() && quasi.rational.lags.is_empty());
    let rate = aircraft().flow.pressures(rigid.incidence.moving.as_ref());
    assert!((&quasi.rational.rate - &rate).norm_l2() < 1e-12 * rate.norm_l2());
}
