//! Motions that SPC enforces, and what follows them.

use crate::common::close;
use faer::Mat;
use nastran::parse_deck;
use structure::{Flexibility, Model, System, enforced_motions};

/// Three rods of the stiffness 1000 in a row from grid 2 (held) over 1 to 4, which follows 3; 3 is enforced. As a spring between two walls,
/// one of which moves.
#[test]
fn what_follows_an_enforced_motion_moves_with_it() {
    let deck = "GRID,2,,0.,0.,0.,,23456\nGRID,1,,10.,0.,0.,,23456\nGRID,4,,20.,0.,0.,7,23456\nGRID,3,,30.,0.,0.,,23456\n\
                CORD2R,7,,0.,0.,0.,0.,0.,1.\n,-1.,0.,0.\nCROD,21,20,2,1\nCROD,14,20,1,4\nPROD,20,10,.01\nMAT1,10,1.+6,,.3\n\
                RBE2,34,3,1,4\nSPC1,1,1,2\nSPC,1,3,1,.2\n";
    let bulk = parse_deck("test.bdf", deck).expect("a deck");
    let model = Model::from_bulk(&bulk).expect("a model");
    let system = System::assemble(&model).expect("a system");
    let enforced = enforced_motions(&bulk, &model, None).expect("no circle").expect("one motion");
    let enforced = Mat::from_fn(enforced.len(), 1, |i, _| enforced[i]);
    let mut load = Mat::zeros(enforced.nrows(), 1);
    load[(6 * system.node_index(1).expect("is there"), 0)] = 200.0;
    let pushing = load - system.elastic_loads(enforced.as_ref());
    let free =
        Flexibility::new(&system).expect("stiff").displacements(system.reduce(pushing.as_ref()).as_ref());
    let moved = system.expand(free.as_ref()) + &enforced;
    let x = |grid: u32| moved[(6 * system.node_index(grid).expect("is there"), 0)];
    close(x(3), 0.2, 1e-12, "where it is held");
    // In the basic system, though x of grid 4's own points the other way.
    close(x(4), 0.2, 1e-12, "what follows it");
    close(x(1), (200.0 + 1000.0 * 0.2) / 2000.0, 1e-9, "between");
}
