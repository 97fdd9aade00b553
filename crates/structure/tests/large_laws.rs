//! What every structure that bends far must fulfil: exact tangents, no force from rigid rotations, results that turn with it.

#![expect(clippy::format_push_string, reason = "decks written card by card")]

use crate::large::{beam_along_x, force, large, path};
use nalgebra::{DMatrix, DVector, Rotation3, Vector3};
use structure::nonlinear::{Controls, Following, LargeDeflection, Loads, NodeLoad, State};

/// One of everything: beams with offsets and pins, rods, quadrilaterals (one warped), a triangle, a laminate, solids of three kinds,
/// bushes between coincident and distant grids, springs, masses with arms, rigid links in a chain, a mean.
fn zoo() -> String {
    let mut deck = String::from(
        "MAT1,1,7.+7,,.3,2.7\nPBAR,1,1,.01,2.-5,3.-5,4.-5\nPROD,2,1,.01,1.-5\nPSHELL,3,1,.05,1,,1\n\
         MAT8,8,7.+7,2.+7,.25,1.+7,8.+6,6.+6,2.\nPCOMP,4,\n,8,.02,0.,YES,8,.02,45.,YES\n\
         ,8,.02,90.,YES\nPSOLID,5,1\nPBUSH,6,K,4.+5,3.+5,2.+5,1.+4,2.+4,3.+4\n",
    );
    let grids = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.1],
        [2.0, 0.1, 0.0],
        [2.0, 1.0, 0.1],
        [1.0, 1.1, 0.0],
        [0.0, 1.0, 0.0],
        [3.0, 0.5, 0.0],
        [2.0, 0.1, 0.0],
        [2.5, -0.6, 0.3],
        // Solids.
        [0.0, 0.0, 1.0],
        [1.0, 0.1, 1.0],
        [1.1, 1.0, 1.1],
        [0.0, 1.0, 1.2],
        [1.0, 0.5, 2.0],
        [2.0, 0.4, 1.2],
        // On rigid arms.
        [3.2, 0.9, 0.2],
        [3.4, 1.0, 0.5],
        [1.2, 0.6, 0.7],
    ];
    for (at, [x, y, z]) in grids.iter().enumerate() {
        deck += &format!("GRID,{},,{x:?},{y:?},{z:?}\n", at + 1);
    }
    deck + "CQUAD4,1,3,1,2,5,6\nCQUAD4,2,4,2,3,4,5\nCTRIA3,3,3,3,7,4\nCBAR,4,1,3,7,0.,0.,1.\n\
        CBAR,5,1,8,9,0.,0.,1.\n,,,.1,0.,.2,0.,.1,0.\nCBAR,13,1,7,9,0.,0.,1.\n,5,46\nCROD,6,2,4,7\nCROD,7,2,14,15\n\
        CHEXA,8,5,1,2,5,6,10,11,\n,12,13\nCTETRA,9,5,10,11,12,14\nCPENTA,10,5,2,15,11,5,4,12\n\
        CBUSH,11,6,3,8,,,,0\nCBUSH,12,6,9,3,,,,0\nCONM2,20,7,,3.,.2,.1,.3\n,.01,.001,.02,0.,.002,.03\n\
        RBE2,30,7,123456,16\nRBAR,31,16,17,123456\nRBE3,32,,18,123456,1.,123,2,5\n,11,12\n\
        CELAS2,40,1.+4,16,1,17,1\nSPC1,1,123,6\n"
}

/// A state far off the undeformed one, and strained.
pub(crate) fn shaken(wing: &LargeDeflection, strain: f64) -> State {
    let mut seed = 1_u64;
    let mut noise = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((seed >> 33) as f64 / f64::from(1_u32 << 31) - 0.5) * strain
    };
    let motion: Vec<f64> = (0..wing.free_count()).map(|_| noise()).collect();
    wing.moved(&wing.undeformed(), &motion)
}

/// Largest difference between the tangent and central differences of the residual, over the tangent's largest entry.
pub(crate) fn tangent_error(wing: &LargeDeflection, state: &State, loads: &Loads) -> f64 {
    let (n, step) = (wing.free_count(), 1e-6);
    let k = wing.stiffness(state, loads);
    let mut dense = vec![vec![0.0; n]; n];
    for (j, column) in dense.iter_mut().enumerate() {
        for (i, value) in k.as_ref().row_idx_of_col(j).zip(k.as_ref().val_of_col(j)) {
            column[i] = *value;
        }
    }
    let column = |j: usize| {
        let at = |sign: f64| {
            let mut motion = vec![0.0; n];
            motion[j] = sign * step;
            wing.residual(&wing.moved(state, &motion), loads)
        };
        let (up, down) = (at(1.0), at(-1.0));
        up.iter().zip(&down).map(|(u, d)| (u - d) / (2.0 * step)).collect::<Vec<f64>>()
    };
    let differences: Vec<Vec<f64>> = (0..n).map(column).collect();
    let (mut error, mut size): (f64, f64) = (0.0, 0.0);
    for i in 0..n {
        for j in 0..n {
            let symmetric = 0.5 * (differences[j][i] + differences[i][j]);
            assert!(
                symmetric.is_finite() && dense[i][j].is_finite(),
                "{i} {j}: {symmetric}, {}",
                dense[i][j]
            );
            error = error.max((dense[i][j] - symmetric).abs());
            size = size.max(dense[i][j].abs());
        }
    }
    error / size
}

#[test]
fn the_tangent_is_that_of_differences_at_strains_of_ten_percent() {
    // Means carry no load here: their own turning is left out of the tangent.
    let wing = large(&zoo());
    let loads =
        Loads { dead: vec![force(16, [50.0, -20.0, 90.0]), force(4, [1.0, 2.0, 3.0])], ..Loads::default() };
    for strain in [0.0, 0.02, 0.2] {
        let error = tangent_error(&wing, &shaken(&wing, strain), &loads);
        println!("strain {strain}: tangent against differences {error:e}");
        assert!(error < 1e-8, "strain {strain}: {error:e}");
    }
}

#[test]
fn turned_by_three_radians_and_moved_it_carries_no_force() {
    let wing = large(&zoo().replace("CELAS2,40,1.+4,16,1,17,1\n", ""));
    let undeformed = wing.undeformed();
    let strained = wing.inner_forces(&shaken(&wing, 0.02)).iter().fold(0.0, |m: f64, f| m.max(f.abs()));
    for axis in [[0.6, 0.0, 0.8], [0.0, 1.0, 0.0], [-0.48, 0.64, 0.6]] {
        let mut state = undeformed.turned(&Rotation3::from_scaled_axis(Vector3::from(axis) * 3.0));
        state.places.iter_mut().for_each(|place| *place += Vector3::new(5.0, -3.0, 2.0));
        let largest = wing.inner_forces(&state).iter().fold(0.0, |m: f64, f| m.max(f.abs()));
        println!("rigid: {largest:e} of {strained:e}");
        assert!(largest < 1e-10 * strained, "{largest:e} of {strained:e}");
    }
}

/// Forces on rigid arms and on the mean's reference, pressures, following forces, weight; all turned.
fn all_loads(turned: &Rotation3<f64>) -> Loads {
    let dead = [force(16, [200.0, -80.0, 300.0]), force(17, [100.0, 150.0, -250.0])];
    let dead = dead.map(|load| NodeLoad {
        force: turned * load.force,
        moment: turned * Vector3::new(5.0, 9.0, -7.0),
        ..load
    });
    let following = vec![
        // Given at the undeformed place.
        Following::Node(force(6, [0.0, 30.0, 400.0])),
        Following::Pressure { face: vec![1, 2, 3, 4], pascal: vec![300.0, 200.0, 100.0, 250.0] },
        Following::Pressure { face: vec![2, 6, 3], pascal: vec![300.0, 200.0, 100.0] },
        Following::Along { node: 13, line: [9, 13], size: 100.0, is_moment: false },
        Following::Across { node: 8, lines: [[2, 8], [2, 6]], size: 40.0, is_moment: true },
    ];
    Loads { dead: dead.to_vec(), following, gravity_m_s2: turned * Vector3::new(0.0, 0.0, -90.0) }
}

fn held() -> LargeDeflection {
    let deck = zoo().replace("CELAS2,40,1.+4,16,1,17,1\n", "").replace("SPC1,1,123,6", "SPC1,1,123456,1,6");
    // Rods without torsion: the grids of the solids do not turn.
    let deck = deck.replace("PROD,2,1,.01,1.-5", "PROD,2,1,.01");
    large(&(deck + "CONM2,21,18,,2.,.1,.2,-.1\n"))
}

#[test]
fn turned_with_its_loads_it_gives_the_same_local_result() {
    let wing = held();
    let straight = path(&wing, &all_loads(&Rotation3::identity()));
    let moved = straight.end().state.places[16] - wing.undeformed().places[16];
    println!("the end of the arm moves by {moved:?}, {:?}", straight.end().largest_local_rotation);
    assert!(moved.norm() > 0.2, "it bends: {moved}");
    for vector in [Vector3::new(0.0, std::f64::consts::FRAC_PI_2, 0.0), Vector3::new(-1.44, 1.92, 1.8)] {
        let turn = Rotation3::from_scaled_axis(vector);
        let start = wing.undeformed().turned(&turn);
        let turned = wing.path(&start, &Loads::default(), &all_loads(&turn), &Controls::default()).unwrap();
        let expected = straight.end().state.turned(&turn);
        let places = turned.end().state.places.iter().zip(&expected.places);
        let off = places.map(|(own, expected)| (own - expected).norm()).fold(0.0, f64::max);
        println!("turned by {:.2} rad: {off:e} m", vector.norm());
        assert!(off < 1e-9 * moved.norm(), "turned by {vector}: {off:e}");
    }
}

#[test]
fn clamps_give_what_all_loads_ask_for_at_the_places_of_now() {
    let (wing, loads) = (held(), all_loads(&Rotation3::identity()));
    let walked = path(&wing, &loads);
    let state = &walked.end().state;
    let (reactions, outer) = (wing.reactions(state, &loads), wing.load_forces(state, &loads));
    let sum = |forces: &[f64]| {
        let mut sum = (Vector3::zeros(), Vector3::zeros());
        for (own, place) in forces.chunks_exact(6).zip(&state.places) {
            let force = Vector3::from_column_slice(&own[..3]);
            sum.0 += force;
            sum.1 += place.cross(&force) + Vector3::from_column_slice(&own[3..]);
        }
        sum
    };
    let ((force, moment), (given, turning)) = (sum(&outer), sum(&reactions));
    println!("loads {force:?} {moment:?}");
    assert!((force + given).norm() < 1e-7 * force.norm(), "forces: {force} {given}");
    assert!((moment + turning).norm() < 1e-7 * moment.norm(), "moments: {moment} {turning}");
}

/// The equilibrium next to a state: many steps with one tangent, where Newton's method stops at a ten-millionth of a radian.
pub(crate) fn to_the_last_digit(wing: &LargeDeflection, start: &State, loads: &Loads) -> State {
    let (n, k) = (wing.free_count(), wing.stiffness(start, loads));
    let mut dense = DMatrix::zeros(n, n);
    for j in 0..n {
        for (i, value) in k.as_ref().row_idx_of_col(j).zip(k.as_ref().val_of_col(j)) {
            dense[(i, j)] = *value;
        }
    }
    let factor = dense.lu();
    let mut state = start.clone();
    for _ in 0..60 {
        let short = DVector::from_vec(wing.residual(&state, loads));
        let step = -factor.solve(&short).expect("a stiff structure");
        state = wing.moved(&state, step.as_slice());
    }
    state
}

#[test]
fn readings_change_with_loads_as_their_adjoint_says() {
    // Loads on the mean's reference and on masses with arms: ties and weight turn.
    let (wing, mut loads) = (held(), all_loads(&Rotation3::identity()));
    loads.following.clear();
    let mean = NodeLoad { moment: Vector3::new(8.0, -6.0, 4.0), ..force(17, [300.0, 200.0, -400.0]) };
    loads.dead.push(mean);
    let end = to_the_last_digit(&wing, &path(&wing, &loads).end().state, &loads);
    let turned = end.rotations.iter().map(Rotation3::angle).fold(0.0, f64::max);
    assert!(turned > 0.2, "it turns: {turned}");
    let read = |state: &State| state.places[16].z + 0.3 * state.places[13].x;
    let mut by_motion = vec![0.0; 6 * wing.nodes().len()];
    (by_motion[6 * 16 + 2], by_motion[6 * 13]) = (1.0, 0.3);
    let dead = wing.change_of_dead(&end, &loads);
    let change = |motion: &[f64]| dead.transposed_in_equilibrium(motion);
    let outer = wing.load_forces(&end, &loads);
    let lambda = &wing.adjoint(&end, &outer, &change, &[by_motion]).unwrap()[0];
    let mut off: f64 = 0.0;
    for (node, axis, is_moment) in
        [(17, 0, false), (17, 1, true), (16, 2, false), (12, 1, false), (4, 2, true)]
    {
        let step = 0.05;
        let at = |step: f64| {
            let (mut more, unit) = (loads.clone(), Vector3::ith(axis, step));
            let none = force(node, [0.0; 3]);
            let load =
                if is_moment { NodeLoad { moment: unit, ..none } } else { NodeLoad { force: unit, ..none } };
            more.dead.push(load);
            read(&to_the_last_digit(&wing, &end, &more))
        };
        let difference = (at(step) - at(-step)) / (2.0 * step);
        let own = lambda[6 * node + 3 * usize::from(is_moment) + axis];
        println!("node {node}, axis {axis}: {own:.9e}, by differences {difference:.9e}");
        off = off.max((own / difference - 1.0).abs());
    }
    assert!(off < 1e-6, "the adjoint is off by {off:e}");
}

/// A cantilever bent both ways, its twist held at the tip, whose reaction makes the tangent unsymmetric; also with a weighted mean that carries a load.
#[test]
fn so_they_do_where_a_support_holds_one_of_three_rotations() {
    let mean = "GRID,20,,.9,.1,.05\nRBE3,20,,20,123456,1.,123456,8,9\n";
    for (ties, carried) in [("", 7), (mean, 9)] {
        let deck = beam_along_x(8, 1.0, 1.0e6, [0.02, 0.03]) + "SPC1,1,123456,1\nSPC1,1,4,9\n" + ties;
        let wing = large(&deck);
        let dead = vec![force(8, [0.0, 0.05, 0.03]), force(carried, [0.0, 0.0, 0.01])];
        let loads = Loads { dead, ..Loads::default() };
        let end = to_the_last_digit(&wing, &path(&wing, &loads).end().state, &loads);
        let twisting = wing.reactions(&end, &loads)[6 * 8 + 3];
        let mut by_motion = vec![0.0; 6 * wing.nodes().len()];
        (by_motion[6 * 8 + 2], by_motion[6 * 5 + 1]) = (1.0, 0.3);
        let outer = wing.load_forces(&end, &loads);
        let still = |motion: &[f64]| vec![0.0; motion.len()];
        let lambda = &wing.adjoint(&end, &outer, &still, &[by_motion]).unwrap()[0];
        let read = |state: &State| state.places[8].z + 0.3 * state.places[5].y;
        let mut off: f64 = 0.0;
        for (node, axis) in [(8, 1), (8, 2), (4, 0), (carried, 2)] {
            let at = |step: f64| {
                let mut more = loads.clone();
                more.dead.push(NodeLoad { force: Vector3::ith(axis, step), ..force(node, [0.0; 3]) });
                read(&to_the_last_digit(&wing, &end, &more))
            };
            let difference = (at(1e-5) - at(-1e-5)) / 2e-5;
            let own = lambda[6 * node + axis];
            println!(
                "{twisting:.3e} Nm; node {node}, axis {axis}: {own:.9e}, by differences {difference:.9e}"
            );
            off = off.max((own / difference - 1.0).abs());
        }
        assert!(off < 1e-6, "the adjoint is off by {off:e}, {carried}");
    }
}
