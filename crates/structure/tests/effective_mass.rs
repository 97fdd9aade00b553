//! Effective modal masses add up to the mass that can move.

use nalgebra::Point3;
use structure::{Model, System, effective_masses, normal_modes};

/// Three masses in a row on weightless beams; the first is clamped.
const DECK: &str = "GRID,1,,0.,0.,0.\nGRID,2,,0.,1.,0.\nGRID,3,,0.3,2.,0.\n\
    CBAR,1,1,1,2,0.,0.,1.\nCBAR,2,1,2,3,0.,0.,1.\nPBAR,1,1,1.-3,1.-6,2.-6,1.-6\nMAT1,1,7.+10,,.3,\n\
    CONM2,1,1,,5.\nCONM2,2,2,,2.,,,,,+\n+,.01,,.02,,,.03\nCONM2,3,3,,1.,.1,,,,+\n+,.01,,.02,,,.03\nSPC1,1,123456,1\n";

#[test]
fn over_all_modes_they_add_up_to_the_mass_that_is_not_clamped() {
    let model = Model::from_bulk(&nastran::parse_deck("three masses", DECK).unwrap()).unwrap();
    let system = System::assemble(&model).unwrap();
    let modes = normal_modes(&system, 12).unwrap();
    let about = Point3::new(0.1, 0.2, 0.3);
    let rows = effective_masses(&system, &modes, &about);
    for axis in 0..6 {
        let sum: f64 = rows.iter().map(|row| row[axis]).sum();
        // By hand: point masses of 2 and 1 kg at (0, 1, 0) and (0.4, 2, 0), with their own inertias.
        let bodies = [(2.0, [0.0, 1.0, 0.0]), (1.0, [0.4, 2.0, 0.0])];
        let own = [0.01, 0.02, 0.03];
        let want: f64 = bodies
            .iter()
            .map(|(mass, at)| {
                let arm = [at[0] - about.x, at[1] - about.y, at[2] - about.z];
                let square: f64 = arm.iter().map(|a| a * a).sum();
                if axis < 3 { *mass } else { mass * (square - arm[axis - 3].powi(2)) + own[axis - 3] }
            })
            .sum();
        assert!((sum - want).abs() < 1e-8 * want, "axis {axis}: {sum} instead of {want}");
    }
}
