//! Natural frequencies against closed forms, and the proof that none is missing.

use crate::common::{AREA, E, I, RHO, beam, close, section, system};
use nalgebra::Point3;
use structure::{ModesError, count_below, normal_modes};

/// beta L of the clamped-free and of the free-free beam (roots of cos cosh = -1 and = 1; Blevins).
const CLAMPED_FREE: [f64; 3] = [1.875_104_069, 4.694_091_133, 7.854_757_438];
const FREE_FREE: [f64; 3] = [4.730_040_745, 7.853_204_624, 10.995_607_838];

fn omega(beta_l: f64, length: f64, i: f64) -> f64 {
    (beta_l / length).powi(2) * (E * i / (RHO * AREA)).sqrt()
}

fn sorted(mut values: Vec<f64>) -> Vec<f64> {
    values.sort_by(f64::total_cmp);
    values
}

#[test]
fn a_clamped_beam_has_the_frequencies_of_the_closed_form() {
    let system = system(&(beam(1, 40, 2.0, 0.0) + &section() + "SPC1,1,123456,1\n"));
    let modes = normal_modes(&system, 5).unwrap();
    let expected =
        sorted(CLAMPED_FREE.iter().flat_map(|b| [omega(*b, 2.0, I[0]), omega(*b, 2.0, I[1])]).collect());
    for (mode, expected) in expected.iter().take(5).enumerate() {
        close(modes.omega_rad_s[mode], *expected, 1e-5, &format!("mode {mode}"));
    }
}

#[test]
fn modes_are_orthonormal_and_their_sign_is_settled() {
    let system = system(&(beam(1, 12, 2.0, 0.0) + &section() + "SPC1,1,123456,1\n"));
    let modes = normal_modes(&system, 8).unwrap();
    let full = system.expand(modes.shapes.as_ref());
    let product = full.transpose() * system.inertia_loads(full.as_ref());
    let stiffness = full.transpose() * system.elastic_loads(full.as_ref());
    let largest = modes.omega_rad_s[7].powi(2);
    for i in 0..8 {
        for j in 0..8 {
            let unit = f64::from(u8::from(i == j));
            assert!((product[(i, j)] - unit).abs() < 1e-10, "{i} {j}: {}", product[(i, j)]);
            let square = unit * modes.omega_rad_s[i].powi(2);
            assert!((stiffness[(i, j)] - square).abs() < 1e-7 * largest, "{i} {j}");
        }
        let largest = |component: usize| {
            let column = (0..system.node_count()).map(|node| full[(6 * node + component, i)]);
            column.fold(0.0f64, |a, b| if b.abs() > a.abs() { b } else { a })
        };
        let decisive = if largest(2).abs() > 1e-3 { largest(2) } else { largest(0) + largest(1) };
        assert!(decisive > 0.0, "mode {i}: {decisive}");
    }
}

#[test]
fn a_free_beam_has_six_zero_modes_and_then_those_of_the_closed_form() {
    let system = system(&(beam(1, 40, 2.0, 0.0) + &section()));
    let modes = normal_modes(&system, 10).unwrap();
    assert_eq!(modes.omega_rad_s[..6], [0.0; 6]);
    let expected =
        sorted(FREE_FREE.iter().flat_map(|b| [omega(*b, 2.0, I[0]), omega(*b, 2.0, I[1])]).collect());
    for (mode, expected) in expected.iter().take(4).enumerate() {
        close(modes.omega_rad_s[6 + mode], *expected, 1e-5, &format!("mode {mode}"));
    }
    assert_eq!(count_below(&system, 0.99 * expected[0]).unwrap(), 6);
}

#[test]
fn only_the_rigid_modes_can_be_asked_for() {
    let system = system(&(beam(1, 10, 2.0, 0.0) + &section()));
    assert_eq!(normal_modes(&system, 4).unwrap().omega_rad_s, vec![0.0; 4]);
}

#[test]
fn two_equal_wings_have_every_frequency_twice() {
    let deck = beam(1, 20, 2.0, 0.0) + &beam(101, 20, 2.0, 1.0) + &section() + "SPC1,1,123456,1,101\n";
    let double = system(&deck);
    let single = system(&(beam(1, 20, 2.0, 0.0) + &section() + "SPC1,1,123456,1\n"));
    let one = normal_modes(&single, 6).unwrap();
    let two = normal_modes(&double, 12).unwrap();
    for mode in 0..12 {
        close(two.omega_rad_s[mode], one.omega_rad_s[mode / 2], 1e-8, &format!("mode {mode}"));
    }
    for mode in 0..6 {
        let above = one.omega_rad_s[mode] * 1.001;
        assert_eq!(count_below(&double, above).unwrap(), 2 * (mode + 1), "below {above}");
    }
    // An odd number cuts the last pair; it is found nevertheless.
    let odd = normal_modes(&double, 5).unwrap();
    close(odd.omega_rad_s[4], one.omega_rad_s[2], 1e-8, "half a pair");
}

#[test]
fn the_count_of_frequencies_is_exact_between_any_two() {
    let system = system(&(beam(1, 15, 2.0, 0.0) + &section() + "SPC1,1,123456,1\n"));
    let modes = normal_modes(&system, 20).unwrap();
    for (below, pair) in modes.omega_rad_s.windows(2).enumerate() {
        let between = 0.5 * (pair[0] + pair[1]);
        assert_eq!(count_below(&system, between).unwrap(), below + 1, "below {between}");
    }
    assert_eq!(count_below(&system, 0.0).unwrap(), 0);
}

#[test]
fn motions_without_mass_have_no_frequency() {
    // A massless beam with a point mass at its tip: exactly three displacements have mass.
    let section = section().replace(&format!(",{RHO:?}"), ",0.");
    let system = system(&(beam(1, 4, 2.0, 0.0) + &section + "SPC1,1,123456,1\nCONM2,1,5,,3.0\n"));
    let modes = normal_modes(&system, 3).unwrap();
    let spring = |i: f64| (3.0 * E * i / 8.0 / 3.0).sqrt();
    close(modes.omega_rad_s[0], spring(I[1]), 1e-9, "plane 2");
    close(modes.omega_rad_s[1], spring(I[0]), 1e-9, "plane 1");
    close(modes.omega_rad_s[2], (E * AREA / 2.0 / 3.0).sqrt(), 1e-9, "extension");
    assert_eq!(normal_modes(&system, 4).unwrap_err(), ModesError::TooMany { asked: 4, available: 3 });
    assert_eq!(count_below(&system, 1e9).unwrap(), 3);
}

#[test]
fn an_overhanging_mass_on_a_shaft_swings_with_its_full_moment_of_inertia() {
    // Only twist about y is free: the mass at arm r, with own inertia, on the torsion spring GJ/L.
    let deck = "GRID,1,,0.,0.,0.\nGRID,2,,0.,2.,0.\nCBAR,1,1,1,2,0.,0.,1.\nSPC1,1,123456,1\nSPC1,1,12346,2\n\
                CONM2,1,2,,0.5,0.3,0.,0.4\n,0.01,,0.02,,,0.03\n";
    let system = system(&(deck.to_owned() + &section().replace(&format!(",{RHO:?}"), ",0.")));
    let modes = normal_modes(&system, 1).unwrap();
    let inertia = 0.5 * (0.3f64.powi(2) + 0.4f64.powi(2)) + 0.02;
    close(modes.omega_rad_s[0], (crate::common::G * I[2] / 2.0 / inertia).sqrt(), 1e-10, "swing");
}

#[test]
fn point_masses_have_their_own_mass_properties() {
    let deck = "GRID,1,,0.,0.,0.\nGRID,2,,2.,0.,0.\nGRID,3,,0.,3.,0.\n\
                CONM2,1,1,,1.0,0.,0.,1.0\nCONM2,2,2,,2.0\nCONM2,3,3,-1,3.0,0.,3.,2.\n,0.1,0.02,0.2,,,0.3\n";
    let properties = system(deck).mass_properties();
    let bodies = [
        (1.0, Point3::new(0.0, 0.0, 1.0)),
        (2.0, Point3::new(2.0, 0.0, 0.0)),
        (3.0, Point3::new(0.0, 3.0, 2.0)),
    ];
    let centre = bodies.iter().fold(nalgebra::Vector3::zeros(), |sum, (m, p)| sum + p.coords * *m) / 6.0;
    let mut inertia = nalgebra::Matrix3::new(0.1, -0.02, 0.0, -0.02, 0.2, 0.0, 0.0, 0.0, 0.3);
    for (m, p) in bodies {
        let r = p.coords - centre;
        inertia += (nalgebra::Matrix3::identity() * r.norm_squared() - r * r.transpose()) * m;
    }
    close(properties.mass_kg, 6.0, 1e-14, "mass");
    assert!((properties.centre.coords - centre).norm() < 1e-13, "{}", properties.centre);
    assert!((properties.inertia_kg_m2 - inertia).norm() < 1e-12, "{}", properties.inertia_kg_m2);
}

#[test]
fn a_structure_given_by_matrices_has_the_same_modes() {
    let system = system(&(beam(1, 6, 2.0, 0.0) + &section() + "SPC1,1,123456,1\n"));
    let n = 6 * system.node_count();
    let unit = faer::Mat::<f64>::identity(n, n);
    let (k, m) = (system.elastic_loads(unit.as_ref()), system.inertia_loads(unit.as_ref()));
    let clamped: Vec<usize> = (0..6).collect();
    let ids = system.node_ids().to_vec();
    let same =
        structure::System::from_matrices(ids, system.points().to_vec(), k.as_ref(), m.as_ref(), &clamped);
    let (same, own) = (normal_modes(&same, 4).unwrap(), normal_modes(&system, 4).unwrap());
    for (same, own) in same.omega_rad_s.iter().zip(&own.omega_rad_s) {
        close(*same, *own, 1e-11, "frequency");
    }
}

#[test]
fn a_body_in_a_system_of_its_own_has_arm_and_inertia_along_that_systems_axes() {
    // System 7: its x along basic y, its y along basic z, its z along basic x. The other way round is another system.
    let deck = "CORD2R,7,,0.,0.,0.,1.,0.,0.\n,0.,1.,0.\nGRID,1,,2.,3.,4.\n\
                CONM2,1,1,7,2.0,0.1,0.2,0.3\n,0.5,0.01,0.6,0.02,0.03,0.7\n";
    let properties = system(deck).mass_properties();
    let expected = Point3::new(2.3, 3.1, 4.2);
    assert!((properties.centre - expected).norm() < 1e-13, "{}", properties.centre);
    // about basic x that of local z, about y of x, about z of y; products are positive integrals on the card
    let inertia = nalgebra::Matrix3::new(0.7, -0.02, -0.03, -0.02, 0.5, -0.01, -0.03, -0.01, 0.6);
    assert!((properties.inertia_kg_m2 - inertia).norm() < 1e-12, "{}", properties.inertia_kg_m2);
}

#[test]
fn a_beam_carries_its_non_structural_mass_beside_its_axis_and_its_non_structural_inertia_about_it() {
    // along x: mass per length 3 to 1 kg/m at (y, z) from (0.1, -0.2) to (0.3, 0.2), NSI from 0.04 to 0.01 kg m
    let property = "PBEAM,1,1,1.-4,4.-9,1.-9,,2.-9,3.\n,,,,,,,,\n,YES,1.,1.-4,4.-9,1.-9,,2.-9,1.\n,,,,,,,,\n\
                    ,0.,0.,,,.04,.01\n,.1,-.2,.3,.2\nMAT1,1,7.+10,2.7+10,,0.\n";
    let deck = "GRID,1,,0.,0.,0.\nGRID,2,,2.,0.,0.\nCBEAM,1,1,1,2,0.,1.,0.\n";
    let properties = system(&(deck.to_owned() + property)).mass_properties();
    let l = 2.0;
    // integrals over t = x/L of m, m y, m z, m (y² + z²) with m = 3 - 2t, y = 0.1 + 0.2t, z = -0.2 + 0.4t
    let mass = l * 2.0;
    let first = [l * (0.3 + 0.4 / 2.0 - 0.4 / 3.0), l * (-0.6 + 1.6 / 2.0 - 0.8 / 3.0)];
    // y² + z² = 0.05 - 0.12t + 0.2t²; times m: 0.15 - 0.46t + 0.84t² - 0.4t³
    let second = l * (0.15 - 0.46 / 2.0 + 0.84 / 3.0 - 0.4 / 4.0);
    close(properties.mass_kg, mass, 1e-12, "mass");
    close(properties.centre.x, l * (3.0 / 2.0 - 2.0 / 3.0) / 2.0, 1e-12, "centre along the beam");
    close(properties.centre.y, first[0] / mass, 1e-12, "centre along y");
    close(properties.centre.z, first[1] / mass, 1e-12, "centre along z");
    let about_centre = second - (first[0] * first[0] + first[1] * first[1]) / mass;
    let expected = about_centre + l * 0.5 * (0.04 + 0.01);
    close(properties.inertia_kg_m2[(0, 0)], expected, 1e-12, "inertia about the beam");
}

#[test]
fn a_motion_with_neither_stiffness_nor_mass_is_refused_and_not_counted_by_chance() {
    // Oblique, so that rounding leaves something of every stiffness; beyond the hinge there is no mass.
    let mut deck = section().replace(&format!(",{RHO:?}"), ",0.") + "SPC1,1,123456,1\nCONM2,1,2,,3.0\n";
    for node in 0..5 {
        let t = 0.37 * f64::from(node);
        deck = format!("{deck}GRID,{},,{:.9},{:.9},{:.9}\n", node + 1, t, 0.7 * t, 0.31 * t);
    }
    for grid in 1..5 {
        let pins = if grid == 3 { ",,456\n" } else { "" };
        deck = format!("{deck}CBAR,{grid},1,{grid},{},0.,0.1,1.\n{pins}", grid + 1);
    }
    let held = system(&deck.replace(",,456\n", ""));
    assert_eq!(count_below(&held, 1e9).unwrap(), 3);
    let swinging = system(&deck);
    for omega_rad_s in [10.0, 1e3, 1e5] {
        let refused = count_below(&swinging, omega_rad_s);
        assert!(matches!(refused, Err(ModesError::Uncountable { .. })), "{omega_rad_s}: {refused:?}");
    }
    assert!(matches!(normal_modes(&swinging, 2), Err(ModesError::Massless(_))));
}
