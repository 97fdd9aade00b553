//! Structures of several parts: two beams on a body that is free, or held.

use crate::common::{at, beam, close, displaced, section, system};
use faer::Mat;
use nastran::parse_deck;
use structure::{Flexibility, MassProperties, Model, count_below, normal_modes, normal_modes_below};

/// Two beams away from the body at grid 900, tied to it, with a turned grid among them.
fn body() -> String {
    beam(1, 8, 2.0, 0.0)
        + &beam(101, 8, 1.7, 0.4)
        + &section()
        + "CORD2R,5,,0.,0.,0.,1.,2.,2.,\n,1.,0.,0.\nGRID,900,,0.2,-0.3,0.1,5\nRBE2,900,900,123456,1,101\n\
           CONM2,900,900,,2.5,0.1,0.,0.2\n,0.1,,0.2,,,0.25\n"
}

#[test]
fn a_node_clamped_afterwards_is_one_clamped_by_a_card() {
    let cut = system(&body());
    let cut = cut.clamped_at(cut.node_index(900).unwrap());
    let card = system(&(body() + "SPC1,1,123456,900\n"));
    assert_eq!(cut.free_dofs(), card.free_dofs());
    let [a, b] = [&cut, &card].map(|system| displaced(system, &[(9, 3, 10.0), (105, 5, 2.0), (103, 1, 5.0)]));
    for dof in 0..a.nrows() {
        assert!((a[(dof, 0)] - b[(dof, 0)]).abs() <= 1e-12 * b.norm_max(), "{dof}");
    }
    let [a, b] = [&cut, &card].map(|system| normal_modes(system, 6).unwrap().omega_rad_s);
    for (a, b) in a.iter().zip(&b) {
        close(*a, *b, 1e-10, "frequency");
    }
}

#[test]
fn parts_that_do_not_hang_together_bend_each_for_itself() {
    let both = system(&(body() + "SPC1,1,123456,900\n"));
    let one = system(&(beam(1, 8, 2.0, 0.0) + &section() + "SPC1,1,123456,1\n"));
    let (a, b) = (displaced(&both, &[(9, 3, 10.0)]), displaced(&one, &[(9, 3, 10.0)]));
    for component in 1..=6 {
        let (a, b) = (at(&both, &a, 9, component), at(&one, &b, 9, component));
        assert!((a - b).abs() <= 1e-10 * b.abs().max(1e-3), "{component}: {a} {b}");
    }
    for grid in 101..=109 {
        assert_eq!(at(&both, &a, grid, 3), 0.0);
    }
    // one part that is loose is named, the other holds
    let loose = system(&(beam(1, 8, 2.0, 0.0) + &beam(101, 8, 1.7, 0.4) + &section() + "SPC1,1,123456,1\n"));
    let error = Flexibility::new(&loose).unwrap_err();
    assert_eq!(error.loose.len(), 6, "{error}");
    assert!(error.loose.iter().all(|(grid, _)| *grid > 100), "{error}");
}

#[test]
fn modes_below_a_frequency_are_as_many_as_are_counted_and_the_same() {
    let free = system(&body());
    let some = normal_modes(&free, 12).unwrap().omega_rad_s;
    let between = 0.5 * (some[9] + some[10]);
    assert_eq!(count_below(&free, between).unwrap(), 10);
    let below = normal_modes_below(&free, between, 6).unwrap();
    assert_eq!(below.omega_rad_s.len(), 10);
    assert_eq!(below.omega_rad_s[..6], [0.0; 6]);
    for (a, b) in below.omega_rad_s[6..].iter().zip(&some[6..]) {
        close(*a, *b, 1e-9, "frequency");
    }
    assert_eq!(normal_modes_below(&free, 0.5 * some[6], 8).unwrap().omega_rad_s.len(), 8);
    // the rest of the equation K x = omega² M x, and no common momentum with the rigid motions
    let shapes = free.expand(below.shapes.as_ref());
    let (elastic, inertia) = (free.elastic_loads(shapes.as_ref()), free.inertia_loads(shapes.as_ref()));
    let rest = Mat::from_fn(elastic.nrows(), 10, |i, j| {
        elastic[(i, j)] - below.omega_rad_s[j].powi(2) * inertia[(i, j)]
    });
    let rest = free.reduce(rest.as_ref());
    let size = free.reduce(elastic.as_ref());
    assert!(rest.norm_max() <= 1e-7 * size.norm_max(), "{} {}", rest.norm_max(), size.norm_max());
    let momentum = inertia.transpose() * &shapes;
    for rigid in 0..6 {
        for mode in 6..10 {
            assert!(momentum[(rigid, mode)].abs() < 1e-10, "{}", momentum[(rigid, mode)]);
        }
    }
}

#[test]
fn a_model_has_the_mass_properties_of_its_system() {
    let bulk = parse_deck("test.bdf", &body()).unwrap();
    let model = Model::from_bulk(&bulk).unwrap();
    let (a, b) = (MassProperties::of_model(&model), system(&body()).mass_properties());
    close(a.mass_kg, b.mass_kg, 1e-12, "mass");
    assert!((a.centre - b.centre).norm() < 1e-12);
    assert!((a.inertia_kg_m2 - b.inertia_kg_m2).norm() <= 1e-12 * b.inertia_kg_m2.norm());
}
