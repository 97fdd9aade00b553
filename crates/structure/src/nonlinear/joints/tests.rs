//! Motions of arms and what they hold.

use super::*;
use crate::nonlinear::LargeDeflection;

#[test]
fn combinations_are_summed_motion_by_motion() {
    let (one, other) = (vec![(2, 1.0), (5, -2.0)], vec![(5, 3.0), (1, 4.0)]);
    assert_eq!(sum([(2.0, &one), (-1.0, &other)].into_iter()), [(1, -4.0), (2, 2.0), (5, -7.0)]);
    assert_eq!((motions(3, 3), motions(0, 6)), (vec![18, 19, 20], vec![0, 1, 2, 3, 4, 5]));
}

/// Small, an arm along x does not ask for the turn about z; turned, it does, and that follows the end of the arm.
#[test]
fn ties_that_follow_each_other_once_they_turn_are_refused() {
    let deck = |grid: u8| {
        format!(
            "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,2.,0.,0.\nCBAR,1,1,2,3,0.,0.,1.\nPBAR,1,1,1.,1.,1.,1.\n\
             MAT1,1,1.,.4\nRBE2,7,1,123,2\nMPC,1,1,6,1.,{grid},1,-.5\n"
        )
    };
    let structure = |grid: u8| {
        let bulk = nastran::parse_deck("test.bdf", &deck(grid)).expect("a deck");
        LargeDeflection::new(&Model::from_bulk(&bulk).expect("no circle of small motions"))
    };
    assert!(structure(3).is_ok());
    let error = structure(2).expect_err("a circle").to_string();
    assert!(error.contains("follow each other in a circle"), "{error}");
}
