//! A good deck of many kinds of elements, broken in every line and field: an error or a structure, never a panic.

use nastran::parse_deck;
use structure::{Flexibility, Model, System, normal_modes};

/// One element of most kinds, on a clamped cube with what hangs on it.
const GOOD: &str = "\
GRID,1,,0.,0.,0.
GRID,2,,1.,0.,0.
GRID,3,,1.,1.,0.
GRID,4,,0.,1.,0.
GRID,5,,0.,0.,1.
GRID,6,,1.,0.,1.
GRID,7,,1.,1.,1.
GRID,8,,0.,1.,1.
GRID,9,,2.,0.,0.,20
GRID,10,,2.,1.,0.
GRID,11,,3.,.5,0.
GRID,12,,.5,.5,2.
GRID,13,,.5,.5,2.
GRID,14,,2.5,.5,1.
CORD2R,20,,0.,0.,0.,0.,1.,1.
,1.,0.,0.
CHEXA,1,1,1,2,3,4,5,6
,7,8
PSOLID,1,1
CQUAD4,2,2,2,9,10,3,15.
CTRIA3,3,3,9,11,10
PCOMP,2,,1.,,,,,SYM
,2,1.-3,0.,,2,1.-3,45.
PSHELL,3,1,2.-3,1,,1
MAT1,1,7.+10,,.3,2700.
MAT8,2,1.3+11,9.+9,.3,5.+9,5.+9,3.+9,1600.
RBE3,4,,12,123456,1.,123,5,6
,7,8
CBUSH,5,5,12,13,,,,0
PBUSH,5,K,1.+6,1.+6,1.+6,1.+5,1.+5,1.+5
CONM2,6,13,,2.,.1,0.,0.
CBAR,7,7,11,14,0.,1.,0.
PBAR,7,1,1.-4,1.-8,1.-8,2.-8
CELAS2,8,1.+4,14,3
CROD,9,9,14,10
PROD,9,1,1.-5,1.-9
CMASS2,10,.3,14,1
RBE2,11,13,123456,15
GRID,15,,.5,.5,2.5
MPC,1,16,1,1.,15,1,-1.
,,15,5,.5
GRID,16,,.5,.5,3.
CONM2,12,16,,.1
SPC1,1,123456,1,4,5,8
SPC1,1,23,16
";

/// True if the deck is solved.
fn solved(deck: &str) -> bool {
    let Ok(bulk) = parse_deck("wing.bdf", deck) else { return false };
    let Ok(model) = Model::from_bulk(&bulk) else { return false };
    let Ok(system) = System::assemble(&model) else { return false };
    Flexibility::new(&system).is_ok() && normal_modes(&system, 3).is_ok()
}

#[test]
fn the_good_deck_is_solved() {
    let bulk = parse_deck("wing.bdf", GOOD).unwrap_or_else(|error| panic!("{error}"));
    assert!(bulk.unknown.is_empty(), "{:?}", bulk.unknown);
    let model = Model::from_bulk(&bulk).unwrap_or_else(|error| panic!("{error}"));
    let system = System::assemble(&model).unwrap_or_else(|error| panic!("{error}"));
    Flexibility::new(&system).unwrap_or_else(|error| panic!("{error}"));
    assert!(solved(GOOD));
}

#[test]
fn without_any_one_line_there_is_an_error_or_a_structure() {
    let lines: Vec<&str> = GOOD.lines().collect();
    let mut refused = 0;
    for left_out in 0..lines.len() {
        let kept = lines.iter().enumerate().filter(|(at, _)| *at != left_out).map(|(_, line)| *line);
        refused += usize::from(!solved(&kept.collect::<Vec<_>>().join("\n")));
    }
    // Every grid, property and material is referred to.
    assert!(refused > 20, "{refused} of {} were refused", lines.len());
}

#[test]
fn with_any_one_field_changed_there_is_an_error_or_a_structure() {
    let lines: Vec<&str> = GOOD.lines().collect();
    for (at, line) in lines.iter().enumerate() {
        let fields: Vec<&str> = line.split(',').collect();
        for field in 1..fields.len() {
            for other in ["", "0", "-1", "99", "0.", "-1.", "1.+300", "x"] {
                let mut changed = fields.clone();
                changed[field] = other;
                let broken = changed.join(",");
                let mut deck = lines.clone();
                deck[at] = &broken;
                solved(&deck.join("\n"));
            }
        }
    }
}
