//! Dampers of decks as forces on modes: what they take out of a motion is damping times the square of the velocity they feel.

use crate::common::close;
use faer::Mat;
use nalgebra::{Matrix3, Vector3};
use nastran::parse_deck;
use structure::{Model, dampers, modal_damping, modal_structural_damping};

/// Three grids, one with displacement axes of its own.
const GRIDS: &str = "CORD2R,5,,0.,0.,0.,1.,2.,2.,\n,1.,0.,0.\nGRID,1,,.5,.2,-.3\nGRID,2,,2.,.4,.3,5\nGRID,3,,1.,1.5,.2\nSPOINT,4\n";

/// Velocities of all grids, any; those of the scalar point are in the first of its six places.
fn velocity(dof: usize) -> f64 {
    (1.3 * dof as f64 + 0.4).sin()
}

fn vector(first: usize) -> Vector3<f64> {
    Vector3::from_fn(|axis, _| velocity(first + axis))
}

/// What the dampers of some cards take out, W.
fn taken_out(cards: &str) -> f64 {
    let bulk = parse_deck("t.bdf", &format!("{GRIDS}{cards}")).unwrap_or_else(|error| panic!("{error}"));
    let shape = Mat::from_fn(24, 1, |dof, _| velocity(dof));
    modal_damping(&dampers(&bulk).unwrap_or_else(|error| panic!("{error}")), shape.as_ref())[(0, 0)]
}

/// The axes of system 5: z towards (1, 2, 2), x as near to the basic one as can be.
fn turned() -> Matrix3<f64> {
    let z = Vector3::new(1.0, 2.0, 2.0) / 3.0;
    let y = z.cross(&Vector3::x()).normalize();
    Matrix3::from_columns(&[y.cross(&z), y, z])
}

#[test]
fn scalar_dampers_feel_the_difference_of_two_motions() {
    let own = |axis: usize| turned().column(axis).dot(&vector(6));
    let spin = |axis: usize| turned().column(axis).dot(&vector(9));
    for (cards, felt) in [
        ("CDAMP2,1,3.,1,2\n", velocity(1)),
        ("CDAMP2,1,3.,1,2,3,1\n", velocity(1) - velocity(12)),
        ("CDAMP1,1,9,2,3,1,5\nPDAMP,8,1.,9,3.\n", own(2) - velocity(4)),
        ("CDAMP2,1,3.,2,4,,\n", spin(0)),
        ("CDAMP4,1,3.,4\n", velocity(18)),
        ("CDAMP3,1,9,4\nPDAMP,9,3.\n", velocity(18)),
    ] {
        close(taken_out(cards), 3.0 * felt * felt, 1e-12, cards);
    }
}

#[test]
fn dampers_along_a_line_feel_its_stretching_and_twisting() {
    let [a, b] = [Vector3::new(0.5, 0.2, -0.3), Vector3::new(1.0, 1.5, 0.2)];
    let along = (b - a).normalize();
    let (stretch, twist) = ((vector(12) - vector(0)).dot(&along), (vector(15) - vector(3)).dot(&along));
    let expected = 3.0 * stretch * stretch + 0.5 * twist * twist;
    close(taken_out("CVISC,1,9,1,3\nPVISC,8,1.,,,9,3.,.5\n"), expected, 1e-12, "CVISC");
    close(taken_out("CBUSH1D,1,9,1,3\nPBUSH1D,9,,3.\n"), 3.0 * stretch * stretch, 1e-12, "CBUSH1D");
    let across = turned().column(0).dot(&(vector(12) - vector(0)));
    close(taken_out("CBUSH1D,1,9,1,3,5\nPBUSH1D,9,7.,3.\n"), 3.0 * across * across, 1e-12, "in a system");
    let grounded = turned().column(0).dot(&vector(0));
    close(
        taken_out("CBUSH1D,1,9,1,,5\nPBUSH1D,9,7.,3.\n"),
        3.0 * grounded * grounded,
        1e-12,
        "to the ground",
    );
}

#[test]
fn bushes_damp_at_their_place_in_their_axes() {
    let place = Vector3::new(0.75, 0.85, -0.05);
    let end = |first: usize, at: Vector3<f64>| {
        (vector(first) + vector(first + 3).cross(&(place - at)), vector(first + 3))
    };
    let (a, b) = (end(0, Vector3::new(0.5, 0.2, -0.3)), end(12, Vector3::new(1.0, 1.5, 0.2)));
    let apart = turned().transpose() * (b.0 - a.0);
    let twist = turned().transpose() * (b.1 - a.1);
    let expected = apart.x.powi(2)
        + 2.0 * apart.y.powi(2)
        + 3.0 * apart.z.powi(2)
        + 4.0 * twist.x.powi(2)
        + 6.0 * twist.z.powi(2);
    let cards = "CBUSH,1,9,1,3,,,,5\nPBUSH,9,K,8.,8.,8.,8.,8.,8.\n,,B,1.,2.,3.,4.,,6.\n";
    close(taken_out(cards), expected, 1e-12, "CBUSH");
    assert_eq!(taken_out("CBUSH,1,9,1,3,,,,5\nPBUSH,9,K,8.\n"), 0.0);
}

#[test]
fn wings_are_not_computed_with_dampers_and_statics_do_without() {
    let bulk = parse_deck("t.bdf", &format!("{GRIDS}CELAS2,2,4.,1,2\nCDAMP2,1,3.,1,2\n")).expect("a deck");
    let error = Model::from_bulk(&bulk).expect_err("refused").to_string();
    assert!(error.starts_with("t.bdf:8:1: CDAMP 1 is a damper, which wings are computed without"), "{error}");
    assert_eq!(Model::from_deck(&bulk, None).expect("a deck").elements.len(), 1);
    let missing = parse_deck("t.bdf", &format!("{GRIDS}CELAS2,2,4.,1,2\nCDAMP2,1,3.,9,2\n")).expect("a deck");
    let error = Model::from_deck(&missing, None).expect_err("refused").to_string();
    assert!(error.starts_with("t.bdf:8:1: CDAMP 1 refers to GRID 9, which is not in the deck"), "{error}");
}

#[test]
fn springs_along_one_axis_and_bushes_have_the_mass_of_their_property() {
    let masses = |cards: &str| {
        let bulk = parse_deck("t.bdf", &format!("{GRIDS}{cards}")).expect("a deck");
        let model = Model::from_deck(&bulk, None).expect("a model");
        let element = &model.elements[0];
        let mass = element.mass().expect("mass").into_owned();
        let of = |node: usize| {
            let rows = (0..mass.nrows()).filter(|row| element.dofs()[*row] / 6 == node);
            rows.map(|row| mass[(row, row)]).sum::<f64>() / 3.0
        };
        [of(0), of(2)]
    };
    assert_eq!(masses("CBUSH1D,1,9,1,3\nPBUSH1D,9,7.,,3.\n"), [1.5, 1.5]);
    // Two fifths of the way from A to B (QRG, PBUSH, remark 13).
    let [a, b] = masses("CBUSH,1,9,1,3,,,,5\n,.4\nPBUSH,9,K,7.\n,,M,3.\n");
    assert!((a - 1.8).abs() < 1e-12 && (b - 1.2).abs() < 1e-12, "{a} {b}");
    // At the place of B in a system of its own.
    let [a, b] = masses("CBUSH,1,9,1,3,,,,5\n,,0,1.,1.5,.2\nPBUSH,9,K,7.\n,,M,3.\n");
    assert!(a.abs() < 1e-12 && (b - 3.0).abs() < 1e-12, "{a} {b}");
}

/// An element of each kind, each with its own loss factor; the deck says it in as many ways.
const LOSSY: &str = "\
GRID,11,,0.,0.,0.\nGRID,12,,1.,0.,0.\nGRID,13,,1.,1.,0.\nGRID,14,,0.,1.,0.\n\
GRID,15,,0.,0.,1.\nGRID,16,,1.,0.,1.\nGRID,17,,1.,1.,1.\nGRID,18,,0.,1.,1.\n\
MAT1,1,7.+3,,.3,2.,,,.01\nMAT1,2,7.+3,,.3,2.,,,.02\nMAT8,3,7.+3,7.+3,.3,3.+3,3.+3,3.+3,2.\n,,,,,,,,\n,.9\n\
CBAR,1,1,11,12,0.,1.,0.\nPBAR,1,1,.1,.01,.01,.01\nCROD,2,2,11,13\nPROD,2,2,.1,.01\n\
CONROD,3,11,14,1,.1\nCTUBE,4,4,11,15\nPTUBE,4,2,.2,.01\nCSHEAR,5,5,11,12,13,14\nPSHEAR,5,1,.1\n\
CQUAD4,6,6,11,12,13,14\nPSHELL,6,2,.1,1,,1\nCQUAD4,7,7,15,16,17,18\nPCOMP,7,,,,,,.03\n,3,.1\n\
CHEXA,8,8,11,12,13,14,15,16\n,17,18\nPSOLID,8,1\n\
CELAS1,9,9,11,1,12,1\nPELAS,8,1.,.5,,9,40.,.04\nCELAS2,10,40.,11,1,13,1,.05\nCELAS4,11,40.,19,20\n\
CBUSH,12,12,11,17,,,,0\nPBUSH,12,K,1.,2.,3.,4.,5.,6.\n,,GE,.06\n";

#[test]
fn elements_lose_the_share_of_their_energy_that_their_material_or_property_says() {
    let factors = [0.01, 0.02, 0.01, 0.02, 0.01, 0.02, 0.03, 0.01, 0.04, 0.05, 0.0, 0.06];
    let bulk = parse_deck("t.bdf", LOSSY).unwrap_or_else(|error| panic!("{error}"));
    let model = Model::from_deck(&bulk, None).unwrap_or_else(|error| panic!("{error}"));
    let shape = Mat::from_fn(6 * model.nodes.len(), 1, |dof, _| velocity(dof));
    let energy = |element: &dyn structure::Element| {
        let (dofs, k) = (element.dofs(), element.stiffness().expect("stiffness"));
        let own = nalgebra::DVector::from_iterator(dofs.len(), dofs.iter().map(|dof| velocity(*dof)));
        own.dot(&(&*k * &own))
    };
    assert_eq!(model.elements.len(), factors.len());
    let expected: f64 =
        model.elements().map(|element| factors[element.id() as usize - 1] * energy(element)).sum();
    let own =
        modal_structural_damping(&bulk, shape.as_ref()).unwrap_or_else(|error| panic!("{error}"))[(0, 0)];
    close(own, expected, 1e-12, "all kinds");
}

/// One loss factor of a PBUSH is that of all directions, several are each its own (QRG, PBUSH, remark 9).
#[test]
fn bushes_lose_energy_by_direction() {
    let lost = |row: &str| {
        let cards = format!("{GRIDS}CBUSH,1,9,1,,,,,0\nPBUSH,9,K,1.,2.,3.,4.,5.,6.\n,,GE,{row}\n");
        let bulk = parse_deck("t.bdf", &cards).unwrap_or_else(|error| panic!("{error}"));
        let shape = Mat::from_fn(24, 1, |dof, _| velocity(dof));
        modal_structural_damping(&bulk, shape.as_ref()).unwrap_or_else(|error| panic!("{error}"))[(0, 0)]
    };
    let energy = |axis: usize| (axis as f64 + 1.0) * velocity(axis).powi(2);
    close(lost(".05"), 0.05 * (0..6).map(energy).sum::<f64>(), 1e-12, "one");
    close(lost(".05,0."), 0.05 * energy(0), 1e-12, "one and a zero");
    close(lost(",,.02,,,.1"), 0.02 * energy(2) + 0.1 * energy(5), 1e-12, "two");
}
