//! Elements alone at any state: force from energy, tangent from force, what is promised, masses that turn.

use super::*;
use nalgebra::Rotation3;

/// Beam, rod, two shells, a solid, bushes between two grids, to the ground and without a say about rotations, a spring, a body beside
/// its grid.
fn elements() -> Vec<Corotated> {
    let deck = "MAT1,1,7.+5,,.3,2.7\nPBAR,1,1,.01,2.-3,3.-3,4.-3\nPROD,2,1,.01,1.-3\nPSHELL,3,1,.05,1,,1\nPSOLID,5,1\n\
        PBUSH,6,K,4.+3,3.+3,2.+3,1.+3,2.+3,3.+3\nGRID,1,,0.,0.,0.\nGRID,2,,1.,.1,.1\nGRID,3,,1.1,1.2,0.\n\
        GRID,4,,0.,1.,.2\n\
        GRID,5,,.3,.4,1.\nCBAR,1,1,1,3,0.,0.,1.\n,,,.1,0.,.2,0.,.1,0.\nCROD,2,2,1,2\nCQUAD4,3,3,1,2,3,4\n\
        CTRIA3,4,3,1,2,5\n\
        CTETRA,5,5,1,2,3,5\nCBUSH,6,6,4,1,,,,0\nCBUSH,7,6,5,,,,,0\nCELAS2,8,50.,2,5,3,6\nCONM2,9,2,,3.,.2,.1,.3\n\
        ,.5,.1,.6,0.,.2,.7\nGRID,6,,.3,.4,1.\nPBUSH,10,K,4.+3,3.+3,2.+3\nCBUSH,10,10,6,5,,,,0\n";
    let bulk = nastran::parse_deck("test.bdf", deck).expect("a deck");
    let model = Model::from_bulk(&bulk).expect("a model");
    let of = |element| Corotated::of(&model, element).expect("it turns").expect("it has matrices");
    model.elements.iter().map(of).collect()
}

fn of(id: u32) -> Corotated {
    elements().into_iter().find(|element| element.id == id).expect("it is there")
}

fn noise(at: usize) -> Vector3<f64> {
    let at = at as f64;
    Vector3::new((1.3 * at + 0.4).sin(), (2.1 * at).cos(), (0.7 * at - 1.0).sin())
}

/// Six nodes turned by a rotation and strained; the last two are at one place before.
fn state(turn: &Rotation3<f64>, strain: f64) -> State {
    let points = [
        [0.0, 0.0, 0.0],
        [1.0, 0.1, 0.1],
        [1.1, 1.2, 0.0],
        [0.0, 1.0, 0.2],
        [0.3, 0.4, 1.0],
        [0.3, 0.4, 1.0],
    ];
    let place = |(at, point): (usize, &[f64; 3])| turn * Vector3::from(*point) + noise(at) * strain;
    let places = points.iter().enumerate().map(place).collect();
    let rotations =
        (0..6).map(|at| Rotation3::from_scaled_axis(noise(at + 7) * 2.0 * strain) * turn).collect();
    State { places, rotations }
}

/// Unit motions of an element's nodes, and the states a step to both sides.
fn steps(element: &Corotated, state: &State, step: f64) -> Vec<[State; 2]> {
    let moved = |dof: usize, step: f64| {
        let mut motion = vec![0.0; 36];
        motion[dof] = step;
        state.moved_by(&motion)
    };
    element.dofs().into_iter().map(|dof| [moved(dof, step), moved(dof, -step)]).collect()
}

fn force_at(element: &Corotated, state: &State) -> DVector<f64> {
    let placed = element.placed(state);
    element.force(&placed, &element.local_force(&placed).expect("elastic"))
}

fn turns() -> [Rotation3<f64>; 2] {
    [Rotation3::identity(), Rotation3::from_scaled_axis(Vector3::new(1.1, -0.8, 1.3))]
}

#[test]
fn forces_are_the_slopes_of_the_energy() {
    for turn in turns() {
        let state = state(&turn, 0.1);
        for element in elements().iter().filter(|element| element.is_elastic()) {
            let energy = |state: &State| {
                let placed = element.placed(state);
                0.5 * element.local_force(&placed).expect("elastic").dot(&placed.motion)
            };
            let (force, step) = (force_at(element, &state), 1e-5);
            for (at, [up, down]) in steps(element, &state, step).iter().enumerate() {
                let slope = (energy(up) - energy(down)) / (2.0 * step);
                assert!((force[at] - slope).abs() < 1e-7 * force.amax(), "element {}, {at}", element.id);
            }
        }
    }
}

/// Also where a bush turns with a grid by springs that meet no rotation: their forces, once apart, turn the grid.
#[test]
fn forces_between_grids_have_no_resultant() {
    for turn in turns() {
        let state = state(&turn, 0.1);
        // A bush to the ground and a spring in fixed axes lean on something.
        for element in elements().iter().filter(|own| own.is_elastic() && ![7, 8].contains(&own.id)) {
            let given = force_at(element, &state);
            let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
            for (node, own) in element.nodes.iter().zip(given.as_slice().chunks_exact(element.per_node)) {
                let own_force = Vector3::from_column_slice(&own[..3]);
                force += own_force;
                moment += state.places[*node].cross(&own_force);
                if own.len() == 6 {
                    moment += Vector3::from_column_slice(&own[3..]);
                }
            }
            let most = force.amax().max(moment.amax());
            assert!(most < 1e-11 * given.amax(), "element {}: {most:e}", element.id);
        }
    }
}

#[test]
fn tangents_are_the_slopes_of_the_forces_whole_and_unsymmetric() {
    for turn in turns() {
        let state = state(&turn, 0.1);
        for element in elements().iter().filter(|element| element.is_elastic()) {
            let placed = element.placed(&state);
            let local = element.local_force(&placed).expect("elastic");
            let k = element.tangent(&placed, &local).expect("elastic");
            let step = 1e-5;
            for (at, [up, down]) in steps(element, &state, step).iter().enumerate() {
                let slope = (force_at(element, up) - force_at(element, down)) / (2.0 * step);
                let error = (k.column(at) - slope).amax() / k.amax();
                assert!(error < 1e-7, "element {}, column {at}: {error:e}", element.id);
            }
        }
    }
}

#[test]
fn what_a_motion_promises_is_the_change_of_the_local_force() {
    for turn in turns() {
        let state = state(&turn, 0.1);
        for element in elements().iter().filter(|element| element.is_elastic()) {
            let (placed, step) = (element.placed(&state), 1e-5);
            let local = |state: &State| element.local_force(&element.placed(state)).expect("elastic");
            for (at, [up, down]) in steps(element, &state, step).iter().enumerate() {
                let slope = (local(up) - local(down)) / (2.0 * step);
                let mut unit = DVector::zeros(element.dofs().len());
                unit[at] = 1.0;
                let promised = element.promised(&placed, &unit).expect("elastic");
                let size = element.k.as_ref().expect("elastic").amax();
                let error = (promised - slope).amax() / size;
                assert!(error < 1e-8, "element {}, motion {at}: {error:e}", element.id);
            }
        }
    }
}

#[test]
fn masses_turn_with_their_element() {
    let turn = Rotation3::from_scaled_axis(Vector3::new(1.1, -0.8, 1.3));
    for element in elements().iter().filter(|element| element.mass.is_some()) {
        let mass = element.mass.as_ref().expect("massive");
        let turned = element.turned(mass, &state(&turn, 0.0));
        for (i, j) in (0..mass.nrows() / 3).flat_map(|i| (0..mass.nrows() / 3).map(move |j| (3 * i, 3 * j))) {
            let block = turn.matrix() * mass.fixed_view::<3, 3>(i, j) * turn.matrix().transpose();
            let error = (turned.fixed_view::<3, 3>(i, j) - block).amax();
            assert!(error < 1e-13 * mass.amax(), "element {}: {error:e}", element.id);
        }
    }
}

#[test]
fn elements_join_three_motions_a_node_or_six() {
    let six =
        |nodes: &[usize]| nodes.iter().flat_map(|node| (0..6).map(move |c| 6 * node + c)).collect::<Vec<_>>();
    assert_eq!(of(1).dofs(), six(&[0, 2]));
    assert_eq!(of(8).dofs(), six(&[1, 2]), "a spring between rotations");
    let solid: Vec<usize> = [0, 1, 2, 4].iter().flat_map(|node| (0..3).map(move |c| 6 * node + c)).collect();
    assert_eq!(of(5).dofs(), solid);
    assert_eq!(of(10).dofs(), six(&[4, 5]), "it turns with a grid");
    assert!(of(1).is_elastic() && !of(9).is_elastic());
    // Alone it is the same on a state of its own nodes.
    let (beam, turned) = (of(1), state(&turns()[1], 0.1));
    let own = State {
        places: vec![turned.places[0], turned.places[2]],
        rotations: vec![turned.rotations[0], turned.rotations[2]],
    };
    let alone = beam.alone();
    assert_eq!(alone.nodes, [0, 1]);
    assert!((force_at(&alone, &own) - force_at(&beam, &turned)).amax() < 1e-12);
}

#[test]
fn elements_in_fixed_axes_say_when_they_have_turned_too_far_and_others_never() {
    let turned = |node: usize, degrees: f64| {
        let mut state = state(&Rotation3::identity(), 0.0);
        let angle: f64 = degrees.to_radians();
        state.rotations[node] = Rotation3::from_scaled_axis(Vector3::new(0.6, 0.0, -0.8) * angle);
        state
    };
    let (ground, spring, beam) = (of(7), of(8), of(1));
    assert_eq!(ground.beyond_limit(&turned(4, 169.0)), None);
    let (own, limit) = ground.beyond_limit(&turned(4, 171.0)).expect("beyond");
    assert!((own.to_degrees() - 171.0).abs() < 1e-9 && (limit.to_degrees() - 170.0).abs() < 1e-9);
    assert_eq!(spring.beyond_limit(&turned(2, 4.9)), None);
    let (own, limit) = spring.beyond_limit(&turned(2, 5.1)).expect("beyond");
    assert!((own.to_degrees() - 5.1).abs() < 1e-9 && (limit.to_degrees() - 5.0).abs() < 1e-9);
    assert_eq!(beam.beyond_limit(&turned(2, 179.0)), None);
    // A bush turns with its first grid: what is left is the other's.
    assert!((of(6).largest_turn(&turned(0, 30.0)).to_degrees() - 30.0).abs() < 1e-9);
    // One without rotational stiffness is a ball joint: it may turn as far as it likes.
    assert_eq!(of(10).largest_turn(&turned(4, 60.0)), 0.0);
}
