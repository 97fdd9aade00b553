//! Net loads in turbulence made by hand.

use super::{AtLimit, NetLoads};
use crate::flight::gust::GustAxis;
use faer::c64;
use loads::design::Spectrum;
use loads::turbulence::{Grid, Turbulence};

const TURBULENCE: Turbulence = Turbulence { v_m_s: 40.0, scale_m: 700.0, spectrum: Spectrum::Karman };

/// Loads of stations that are the same at all frequencies but for their size.
fn net(stations: usize, sizes: &[f64]) -> NetLoads {
    let grid = Grid::new(40.0, 700.0, 20.0, &[], 3.0);
    let count = grid.omega_rad_s.len();
    let loads = sizes.iter().map(|size| vec![c64::new(0.6 * size, 0.8 * size); count]).collect();
    NetLoads::new(grid, TURBULENCE, stations, loads)
}

#[test]
fn a_load_is_something_beside_the_largest_force_moment_or_load_factor_of_all_stations() {
    let tiny = [0.9e-9, 1.1e-9];
    let sizes = [
        [2.0, 2.0 * tiny[0], 2.0 * tiny[1], 5000.0 * tiny[0], 5000.0 * tiny[1], 0.0],
        [0.0, 1.0, 1.0, 5000.0, 1.0, 1.0],
    ];
    let mut all = sizes.concat();
    all.push(1e-12);
    let net = net(2, &all);
    assert_eq!(net.stations(), 2);
    let found = net.is_something(&net.response());
    let law = [true, false, true, false, true, false, false, true, true, true, true, true, true];
    assert_eq!(found, law, "the load factor is of a kind of its own");
    let still = super::tests::net(1, &[0.0; 6]);
    assert_eq!(still.is_something(&still.response()), vec![false; 6], "nothing is no more than nothing");
}

#[test]
fn at_a_limit_each_load_counts_over_its_own_root_mean_square() {
    let sizes = [1.0, 1.0, 3.0, 40.0, 0.5, 1.0, 1.0, 1.0, 7.0, 1e-12, 9.0, 1.0];
    let net = net(2, &sizes);
    let response = net.response();
    let along = GustAxis::Vertical.along();
    let limit =
        |station: usize, direction: usize| AtLimit { station, along: along[direction], is_largest: true };
    // Mx against My of the first station; of the second Mx is nothing
    let found = net.at_limits(&[limit(0, 0), limit(0, 3), limit(0, 4), limit(1, 4)]);
    let one = c64::new(0.6, 0.8) / response.a_bar(0);
    for (k, factor) in [1.0, 2.0, 0.0, -1.0].into_iter().enumerate() {
        for value in &found[k] {
            assert!((value - one * factor).norm() < 1e-12 * one.norm(), "limit {k}: {value}");
        }
    }
    assert_eq!(found[0].len(), net.grid.omega_rad_s.len());
}
