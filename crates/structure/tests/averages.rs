//! Weighted means (RBE3): where a load on the reference goes, and what a group must hold to have a mean.

use crate::common::{at, close, displaced, system};
use nastran::parse_deck;
use structure::Model;

/// Grids of a group with springs of 1 N/m along z, held otherwise; the mean at grid 9 follows them.
fn group(places: &[[f64; 2]], weights: &[f64], reference: [f64; 2]) -> structure::System {
    let mut deck = format!("GRID,9,,{:?},{:?},0.\nRBE3,1,,9,123456", reference[0], reference[1]);
    for (k, weight) in weights.iter().enumerate() {
        let start = if k == 0 { "," } else { "\n," };
        deck = format!("{deck}{start}{weight:?},123,{}", k + 1);
    }
    for (k, [x, y]) in places.iter().enumerate() {
        let id = k + 1;
        deck = format!("{deck}\nGRID,{id},,{x:?},{y:?},0.\nCELAS2,{id},1.,{id},3\nSPC1,1,12456,{id}");
    }
    deck.push('\n');
    system(&deck)
}

/// The mean is what moves a rigid body with the least weighted squares of its misses; the share of a load that a grid gets is, for
/// a load at the weighted centroid, its weight over all, and about that point a moment's share is weight times arm over the
/// sum of weight times arm squared, as in a group of bolts.
#[test]
fn a_load_is_shared_by_weight_and_a_moment_by_weight_and_arm() {
    // principal axes along x and y, weighted centroid at the origin: sums of w x, w y and w x y are zero
    let places = [[3.0, 0.0], [-1.0, 0.0], [0.0, 2.0], [0.0, -0.5]];
    let weights = [0.5, 1.5, 0.25, 1.0];
    let total: f64 = weights.iter().sum();
    let second = |axis: usize| -> f64 {
        places.iter().zip(&weights).map(|(place, weight)| weight * place[axis] * place[axis]).sum()
    };
    let reference = [0.7, -0.4];
    let system = group(&places, &weights, reference);
    let (fz, mx, my) = (10.0, 4.0, -3.0);
    let u = displaced(&system, &[(9, 3, fz), (9, 4, mx), (9, 5, my)]);
    let (about_x, about_y) = (mx + reference[1] * fz, my - reference[0] * fz);
    let mut means = [0.0; 3];
    for (k, (place, weight)) in places.iter().zip(weights).enumerate() {
        let share = weight * (fz / total + about_x * place[1] / second(1) - about_y * place[0] / second(0));
        close(at(&system, &u, u32::try_from(k + 1).unwrap(), 3), share, 1e-10, "force on a grid with 1 N/m");
        means[0] += weight * share / total;
        means[1] += weight * place[1] * share / second(1);
        means[2] -= weight * place[0] * share / second(0);
    }
    close(at(&system, &u, 9, 4), means[1], 1e-10, "rotation about x");
    close(at(&system, &u, 9, 5), means[2], 1e-10, "rotation about y");
    let height = means[0] + means[1] * reference[1] - means[2] * reference[0];
    close(at(&system, &u, 9, 3), height, 1e-10, "height of the reference");
}

#[test]
fn a_group_in_one_line_has_no_mean_rotation_about_it() {
    let read = |components: &str| {
        let deck = format!(
            "GRID,1,,0.,0.,0.\nGRID,2,,2.,1.,0.\nGRID,3,,4.,2.,0.\nGRID,9,,1.,1.,1.\n\
             RBE3,5,,9,{components},1.,123,1,2\n,3\n"
        );
        Model::from_bulk(&parse_deck("test.bdf", &deck).unwrap()).map(|_| ()).map_err(|e| e.to_string())
    };
    // the line runs along (2, 1, 0): rotation about it has parts about x and y, and moves a grid beside the line
    for components in ["4", "5", "123456", "1", "3"] {
        let refused = read(components).unwrap_err();
        assert!(
            refused.contains("RBE3 5: its group does not determine component"),
            "{components}: {refused}"
        );
    }
    // about z it is determined
    assert_eq!(read("6"), Ok(()));
    // rotations of the grids themselves hold it
    let deck = "GRID,1,,0.,0.,0.\nGRID,2,,2.,1.,0.\nGRID,9,,1.,1.,1.\nRBE3,5,,9,123456,1.,123456,1,2\n";
    assert!(Model::from_bulk(&parse_deck("test.bdf", deck).unwrap()).is_ok());
}

/// Of grids at +a and -a along x that give displacements and rotations alike, the least squares of the misses, rotations times
/// the radius a, are at rotation (v1 - v2)/(4a) + (t1 + t2)/4 about z.
#[test]
fn rotations_of_a_group_weigh_with_the_square_of_its_radius() {
    let deck = "GRID,1,,.25,0.,0.\nGRID,2,,-.25,0.,0.\nGRID,9,,0.,0.,0.\nRBE3,5,,9,123456,2.,123456,1,2\n";
    let model = Model::from_bulk(&parse_deck("test.bdf", deck).unwrap()).unwrap();
    // grids 1, 2, 9: six motions each
    let rotation = model.dependents.iter().find(|dependent| dependent.dof == 17).unwrap();
    let share = |dof: usize| rotation.row.iter().find(|(other, _)| *other == dof).map_or(0.0, |(_, f)| *f);
    for (dof, expected) in [(1, 1.0), (7, -1.0), (5, 0.25), (11, 0.25)] {
        assert!((share(dof) - expected).abs() < 1e-12, "motion {dof}: {} beside {expected}", share(dof));
    }
}
