//! Means of groups at any size, motions that nothing touches, shells that fall back on plainer ones, and lists of
//! load sets.

use crate::common::{close, system};
use faer::Mat;
use nalgebra::DMatrix;
use nastran::parse_deck;
use structure::{Flexibility, MassProperties, Model, load_sets};

fn read(deck: &str) -> Result<Model, String> {
    let bulk = parse_deck("test.bdf", deck).map_err(|error| error.to_string())?;
    Model::from_bulk(&bulk).map_err(|error| error.to_string())
}

/// What a group determines hangs on its form alone, not on the unit of its lengths.
#[test]
fn a_group_determines_the_same_motions_at_any_size() {
    let said = |places: &[[f64; 3]], size: f64, components: &str, of: &str| {
        let grid = |(id, [x, y, z]): (u32, &[f64; 3])| {
            format!("GRID*,{id},,{:.9E},{:.9E}\n*,{:.9E}\n", size * x, size * y, size * z)
        };
        let grids: String = (1..).zip(places).map(grid).collect();
        let far = grid((9, &[1.0; 3]));
        read(&format!("{grids}{far}RBE3,5,,9,{components},1.,{of},1,2\n,3\n")).map(|_| ())
    };
    let line = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [4.0, 2.0, 0.0]];
    let triangle = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [1.0, 3.0, 0.5]];
    for size in [1e-4, 1.0, 1e5] {
        for components in ["4", "5", "1", "3", "123456"] {
            let error = said(&line, size, components, "123").expect_err("a line");
            assert!(error.contains("does not determine component"), "size {size}, {components}: {error}");
        }
        assert_eq!(said(&line, size, "6", "123"), Ok(()), "size {size}");
        assert_eq!(said(&line, size, "123456", "123456"), Ok(()), "size {size}");
        assert_eq!(said(&triangle, size, "123456", "123"), Ok(()), "size {size}");
        // Heights alone say nothing of the other motions.
        for components in ["1", "2", "6"] {
            assert!(said(&triangle, size, components, "3").is_err(), "size {size}, {components}");
        }
        assert_eq!(said(&triangle, size, "345", "3"), Ok(()), "size {size}");
    }
}

#[test]
fn motions_that_nothing_touches_are_held_along_the_axes_of_their_grid() {
    // A rod along x: of a grid with basic axes x alone, of one with oblique axes all three of its own.
    let deck = "CORD2R,5,,0.,0.,0.,1.,2.,2.,\n,0.,1.,0.\nGRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.,5\nGRID,3,,2.,0.,0.\n\
        GRID,4,,9.,9.,9.\n\
        CROD,1,1,1,2\nCROD,2,1,2,3\nPROD,1,1,.1\nMAT1,1,7.+10,,.3\n";
    assert_eq!(system(deck).free_dofs(), [0, 6, 7, 8, 12]);
    // What is followed by something that is touched counts as touched: all of grid 4 by its arm.
    let own = system(&format!("{deck}RBE2,7,4,123,3\n"));
    assert_eq!(own.free_dofs(), [0, 6, 7, 8, 18, 22, 23]);
    assert!(own.is_attached(3) && !system(deck).is_attached(3));
    let clamped = system(&format!("{deck}SPC1,1,1,2,3\n"));
    assert_eq!(clamped.free_dofs(), [0, 7, 8]);
    // About the rod and about z (turned by 45 degrees, and by a right angle, whose cosine rounds): what has no part of x is held.
    for (axes, own) in [
        ("0.,1.,1.,\n,1.,0.,0.", &[6][..]),
        ("0.,0.,1.,\n,1.,1.,0.", &[6, 7]),
        ("0.,0.,1.,\n,1.-17,1.,0.", &[7]),
    ] {
        let turned = system(&deck.replace("1.,2.,2.,\n,0.,1.,0.", axes));
        assert_eq!(turned.free_dofs(), [&[0][..], own, &[12]].concat(), "{axes}");
    }
}

/// A load on one of three parts bends that part alone, whatever the other columns.
#[test]
fn columns_of_loads_are_answered_one_by_one() {
    let spring = |id: u32, k: f64| format!("GRID,{id},,{id}.,0.,0.\nCELAS2,{id},{k:?},{id},3\n");
    let system = system(
        &(spring(1, 4.0) + &spring(2, 5.0) + &spring(3, 8.0) + "CELAS2,9,2.,1,3,2,3\nSPC1,1,12456,1,2,3\n"),
    );
    let flexibility = Flexibility::new(&system).expect("held");
    let loads = Mat::from_fn(3, 4, |i, j| if j == 3 { 0.0 } else { f64::from(u8::from(i == j)) });
    let moved = flexibility.displacements(loads.as_ref());
    // Of [6 -2; -2 7] the inverse is [7 2; 2 6] / 38.
    let expected =
        [[7.0 / 38.0, 2.0 / 38.0, 0.0], [2.0 / 38.0, 6.0 / 38.0, 0.0], [0.0, 0.0, 0.125], [0.0; 3]];
    for (j, column) in expected.iter().enumerate() {
        for (i, value) in column.iter().enumerate() {
            assert!((moved[(i, j)] - value).abs() < 1e-15, "{i} {j}: {}", moved[(i, j)]);
        }
    }
}

fn stiffness(deck: &str) -> DMatrix<f64> {
    read(deck).expect("a model").elements[0].stiffness().expect("stiff").into_owned()
}

/// A quadrilateral whose section couples membrane and bending bends in its plane as without drilling rotations; with
/// none it differs.
#[test]
fn a_coupled_section_has_no_membrane_with_drilling() {
    let deck = |name: &str, plies: &str| {
        format!(
            "GRID,1,,0.,0.,0.\nGRID,2,,1.2,0.,.1\nGRID,3,,1.1,.8,0.\nGRID,4,,-.1,.7,.1\n{name},1,1,1,2,3,4\n\
            PCOMP,1\n{plies}\
             MAT1,2,7.+10,,.3\nMAT1,3,1.+10,,.3\n"
        )
    };
    let coupled = ",2,.01,0.,,3,.02,0.\n";
    let alike = ",2,.03,0.\n";
    let difference = |plies: &str| {
        let (plain, drilled) = (stiffness(&deck("CQUAD4", plies)), stiffness(&deck("CQUADR", plies)));
        (&drilled - &plain).amax() / plain.amax()
    };
    assert_eq!(difference(coupled), 0.0);
    assert!(difference(alike) > 1e-3, "{}", difference(alike));
    // a symmetric laminate of three plies, whose coupling is a sum that rounds
    let symmetric = ",2,.01,0.,,3,.007,0.\n,2,.01,0.\n";
    assert!(difference(symmetric) > 1e-3, "{}", difference(symmetric));
}

#[test]
fn sets_of_loads_of_every_kind_are_listed_once_in_ascending_order() {
    let deck = "GRID,1\nGRID,2,,1.\nGRID,3,,1.,1.\nCBAR,1,1,1,2,0.,1.,0.\nPBAR,1,1,1.,1.,1.,1.\nMAT1,1,7.+10,,.3,1.\n\
        CTRIA3,2,2,1,2,3\nPSHELL,2,1,.1,1\nSPC1,1,123456,1\nFORCE,18,2,,1.,1.,0.,0.\nMOMENT,17,2,,1.,1.,0.,0.\n\
        FORCE1,16,2,1.,1,2\n\
        FORCE2,15,2,1.,1,2,1,3\nPLOAD1,14,1,FY,FR,0.,1.,1.,1.\nPLOAD2,13,1.,2\nPLOAD4,12,2,1.\nGRAV,11,,1.,0.,0.,1.\n\
        RFORCE,10,,,1.,0.,0.,1.\nLOAD,9,1.,1.,18\nSPCD,8,1,1,.1\nFORCE,18,3,,1.,1.,0.,0.\n";
    let bulk = parse_deck("test.bdf", deck).expect("a deck");
    assert_eq!(load_sets(&bulk), (8..=18).collect::<Vec<u32>>());
}

/// A body seen from another origin and along other axes: mass, centre and inertia go with it.
#[test]
fn mass_properties_turn_and_move_with_a_structure() {
    let turn = nalgebra::Rotation3::from_scaled_axis(nalgebra::Vector3::new(0.4, -1.1, 0.7));
    let shift = nalgebra::Vector3::new(100.0, -50.0, 30.0);
    let places = [[0.0, 0.0, 0.0], [1.0, 0.2, -0.3], [-0.4, 0.9, 0.5]].map(nalgebra::Vector3::from);
    let masses = [2.0, 3.0, 1.5];
    let body = |at: usize| {
        let (id, p, mass) = (at + 1, turn * places[at] + shift, masses[at]);
        format!("GRID*,{id},,{:.12},{:.12}\n*,{:.12}\nCONM2,{id},{id},,{mass:?}\n", p.x, p.y, p.z)
    };
    let deck: String = (0..3).map(body).collect();
    let total: f64 = masses.iter().sum();
    let centre = places.iter().zip(masses).map(|(p, m)| p * m).sum::<nalgebra::Vector3<f64>>() / total;
    let inertia: nalgebra::Matrix3<f64> = places
        .iter()
        .zip(masses)
        .map(|(p, m)| {
            let r = p - centre;
            (nalgebra::Matrix3::identity() * r.norm_squared() - r * r.transpose()) * m
        })
        .sum();
    let model = read(&deck).expect("a model");
    for own in [MassProperties::of_model(&model), system(&deck).mass_properties()] {
        close(own.mass_kg, total, 1e-13, "mass");
        assert!((own.centre.coords - (turn * centre + shift)).norm() < 1e-10, "{}", own.centre);
        let expected = turn.matrix() * inertia * turn.matrix().transpose();
        assert!((own.inertia_kg_m2 - expected).amax() < 1e-9, "{} {expected}", own.inertia_kg_m2);
    }
}
