//! The count that proves modes complete, where the iteration does not see half of them.

use super::*;
use crate::model::Model;
use std::fmt::Write as _;

/// Two equal cantilevers that do not hang together: every frequency is there twice.
fn two_wings() -> System {
    let mut deck = String::from("MAT1,1,7.+10,2.7+10,,2700.\nPBAR,1,1,1.-4,4.-9,1.-9,2.-9\n");
    for wing in 0..2 {
        for node in 0..=8 {
            let _ = writeln!(deck, "GRID,{},,{wing}.,{:?},0.", 100 * wing + node + 1, 0.25 * f64::from(node));
        }
        for grid in (100 * wing + 1)..(100 * wing + 9) {
            let _ = writeln!(deck, "CBAR,{grid},1,{grid},{},0.,0.,1.", grid + 1);
        }
        let _ = writeln!(deck, "SPC1,1,123456,{}", 100 * wing + 1);
    }
    let bulk = nastran::parse_deck("test.bdf", &deck).expect("a deck");
    System::assemble(&Model::from_bulk(&bulk).expect("a model")).expect("a structure")
}

/// A search that starts without any motion of the second wing, which no iteration then gives it.
fn half_blind(system: &System, count: usize, known: Option<Count>) -> Search<'_> {
    let mut search = Search::new(system, count, known, 0, 0.0, held(system));
    let of_second = |i: usize| system.name(i).0 > 100;
    for j in 0..search.block.ncols() {
        for i in (0..search.block.nrows()).filter(|i| of_second(*i)) {
            search.block[(i, j)] = 0.0;
        }
    }
    search
}

#[test]
fn modes_that_the_iteration_does_not_see_are_missed_by_the_count() {
    let system = two_wings();
    let pairs = |modes: Modes| {
        for pair in modes.omega_rad_s.chunks(2) {
            assert!((pair[1] / pair[0] - 1.0).abs() < 1e-8, "not twice: {:?}", modes.omega_rad_s);
        }
    };
    let mut blind = half_blind(&system, 6, None);
    blind.converge().expect("it converges, on half of the modes");
    let difference = blind.check().expect("it can be counted").expect("and the count contradicts");
    let ModesError::Incomplete { found, counted, .. } = difference else { panic!("{difference}") };
    assert_eq!((found, counted), (6, 12));
    pairs(half_blind(&system, 6, None).run().expect("the block grows until all are found"));
    // as many as lie below a frequency: none beyond it may stand in for those that are missed
    let all = normal_modes(&system, 8).expect("modes").omega_rad_s;
    let square = (0.5 * (all[5] + all[6])).powi(2);
    let known = Some(Count { square, below: 6 });
    let found = half_blind(&system, 6, known).run().expect("modes");
    assert!(found.omega_rad_s.iter().all(|omega| omega * omega < square), "{:?}", found.omega_rad_s);
    pairs(found);
}
