//! Ties at finite rotations: followers do the work of their loads, stand where a rigid arm or a mean puts them, and
//! hand
//! reactions and readings on; with displacement systems of their own.

use crate::large::{force, large, moment, path, spin};
use crate::large_laws::{shaken, tangent_error, to_the_last_digit};
use nalgebra::{Rotation3, Vector3};
use structure::nonlinear::{LargeDeflection, Loads, NodeLoad, State};

/// Three beams; rigid arms from grid 3 and on from there, from grid 4 without rotations; means with and without them,
/// of grids that
/// follow others among them, and an arm from a mean; an equation. Some grids have systems of their own.
const TIED: &str = "CORD2R,5,,0.,0.,0.,1.,2.,2.,\n,1.,0.,0.\nCORD2R,6,,0.,0.,0.,0.,1.,1.,\n,1.,1.,0.\n\
    GRID,1,,0.,0.,0.,5\nGRID,2,,1.,0.,.1,6\nGRID,3,,2.,.2,0.\nGRID,4,,2.,1.,.3,5\n\
    GRID,10,,2.2,.5,.4,5\nGRID,11,,1.7,.3,-.5\nGRID,12,,2.4,1.2,.6,6\nGRID,13,,2.5,.1,.9,6\nGRID,14,,1.5,.8,.4,5\n\
    GRID,15,,1.2,-.4,.8,6\nGRID,16,,1.9,1.5,.1,5\nGRID,17,,4.,0.,0.,5\n\
    PBAR,1,1,.01,2.-3,3.-3,4.-3\nMAT1,1,7.+5,,.3,2.7\nCBAR,1,1,1,2,0.,0.,1.\nCBAR,2,1,2,3,0.,0.,1.\n\
        CBAR,3,1,3,4,0.,0.,1.\n\
    RBE2,20,3,123456,10,11\nRBE2,21,4,123,12\nRBAR,22,10,13,123456\nRBE3,23,,14,123456,1.,123,2,3\n,.7,123456,4,13\n\
    RBE3,24,,15,123,1.,123,2,3\n,2.,123,4\nRBE2,25,14,123456,16\nMPC,1,17,1,1.,4,1,-1.\nSPC1,1,123456,1\n";

/// Position of a grid.
fn at(wing: &LargeDeflection, grid: u32) -> usize {
    wing.nodes().iter().position(|node| node.id == grid).expect("it is there")
}

fn size(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most: f64, value| most.max(value.abs()))
}

#[test]
fn followers_do_the_work_of_their_loads() {
    let wing = large(TIED);
    let (n, step) = (wing.free_count(), 1e-5);
    let turn = Rotation3::from_scaled_axis(Vector3::new(0.7, -1.1, 0.9));
    for start in [shaken(&wing, 0.3), shaken(&wing, 0.2).turned(&turn)] {
        let state = wing.moved(&start, &vec![0.0; n]);
        let without = wing.residual(&state, &Loads::default());
        for (grid, turns) in [
            (10, true),
            (11, true),
            (12, false),
            (13, true),
            (14, true),
            (15, false),
            (16, true),
            (17, false),
            (4, true),
        ] {
            let node = at(&wing, grid);
            let pull = Vector3::new(30.0, -20.0, 50.0);
            let twist = if turns { Vector3::new(7.0, 9.0, -8.0) } else { Vector3::zeros() };
            let load = NodeLoad { node, force: pull, moment: twist };
            let with = wing.residual(&state, &Loads { dead: vec![load], ..Loads::default() });
            let work = |free: usize| {
                let moved = |by: f64| {
                    let mut motion = vec![0.0; n];
                    motion[free] = by;
                    wing.moved(&state, &motion)
                };
                let (up, down) = (moved(step), moved(-step));
                let apart = (up.places[node] - down.places[node]) / (2.0 * step);
                let turned = spin(&(up.rotations[node] * down.rotations[node].inverse())) / (2.0 * step);
                pull.dot(&apart) + twist.dot(&turned)
            };
            let by_motion: Vec<f64> = (0..n).map(work).collect();
            assert!(size(&by_motion) > 1.0, "GRID {grid} moves");
            for free in 0..n {
                let own = without[free] - with[free];
                assert!(
                    (own - by_motion[free]).abs() < 1e-7 * size(&by_motion),
                    "GRID {grid}, motion {free}: {own}"
                );
            }
        }
    }
}

#[test]
fn followers_stand_where_a_rigid_motion_of_what_they_follow_takes_them() {
    let wing = large(TIED);
    let undeformed = wing.undeformed();
    let (turn, shift) =
        (Rotation3::from_scaled_axis(Vector3::new(1.9, -1.2, 1.4)), Vector3::new(3.0, -1.0, 2.0));
    let mut state = undeformed.turned(&turn);
    state.places.iter_mut().for_each(|place| *place += shift);
    for (grid, turns) in
        [(10, true), (11, true), (12, false), (13, true), (14, true), (15, false), (16, true)]
    {
        let node = at(&wing, grid);
        state.places[node] += Vector3::new(0.5, 0.2, -0.7);
        if turns {
            state.rotations[node] = Rotation3::from_scaled_axis(Vector3::new(0.1, 0.4, 0.2));
        }
    }
    let back = wing.moved(&state, &vec![0.0; wing.free_count()]);
    for (node, place) in back.places.iter().enumerate() {
        let grid = wing.nodes()[node].id;
        let expected = turn * undeformed.places[node] + shift;
        assert!((place - expected).norm() < 1e-12, "GRID {grid} is at {place} for {expected}");
        let off = (back.rotations[node].matrix() - turn.matrix()).amax();
        assert!(off < 1e-12, "GRID {grid} is turned otherwise: {off}");
    }
}

/// Arms from the first grid, whose rotations feel nothing but springs at the arm's end, and on from there.
#[test]
fn arms_that_turn_under_a_load_are_in_the_tangent() {
    let deck = "CORD2R,5,,0.,0.,0.,1.,2.,2.,\n,1.,0.,0.\nGRID,1,,.2,.1,0.,5\nGRID,2,,1.2,.3,.4,5\nGRID,3,,.9,-.5,1.1\n\
        GRID,4,,1.,1.,1.\nRBE2,7,1,123456,2\nRBE2,8,2,123,3\nRBAR,9,1,4,123456\nCELAS2,1,50.,2,1\nCELAS2,2,40.,2,2\n\
        CELAS2,3,30.,3,3\nCELAS2,4,20.,3,1\nCELAS2,5,60.,4,2\nCELAS2,6,70.,4,3\nCELAS2,7,10.,1,1\n";
    let wing = large(deck);
    assert_eq!(wing.free_count(), 6);
    let mut loads =
        Loads { dead: vec![force(1, [5.0, -3.0, 8.0]), force(2, [4.0, 6.0, -7.0])], ..Loads::default() };
    loads.dead.push(moment(3, [1.0, 2.0, 3.0]));
    for strain in [0.0, 0.3] {
        let error = tangent_error(&wing, &shaken(&wing, strain), &loads);
        assert!(error < 1e-8, "strain {strain}: {error:e}");
    }
    let beams = large(
        &TIED
            .replace("RBE3,23,,14,123456,1.,123,2,3\n,.7,123456,4,13\n", "")
            .replace("RBE2,25,14", "RBE2,25,13"),
    );
    let loads =
        Loads { dead: vec![force(4, [50.0, -20.0, 90.0]), force(7, [10.0, 70.0, 30.0])], ..Loads::default() };
    let error = tangent_error(&beams, &shaken(&beams, 0.2), &loads);
    assert!(error < 1e-8, "{error:e}");
}

/// All that pulls at followers, at a bent state.
fn pulled() -> (LargeDeflection, Loads) {
    let wing = large(TIED);
    let dead =
        [(10, [12.0, 8.0, 18.0]), (12, [-4.0, 6.0, 16.0]), (14, [2.0, -10.0, 14.0]), (15, [0.0, 4.0, 12.0])];
    let dead = dead.map(|(grid, newton)| force(at(&wing, grid), newton));
    let dead = [&dead[..], &[moment(at(&wing, 16), [6.0, -4.0, 8.0])]].concat();
    (wing, Loads { dead, ..Loads::default() })
}

#[test]
fn the_clamp_gives_the_resultant_of_what_followers_carry_along_its_own_axes() {
    let (wing, loads) = pulled();
    let state = path(&wing, &loads).end().state.clone();
    let moved = state.places[at(&wing, 13)] - wing.nodes()[at(&wing, 13)].point.coords;
    assert!(moved.norm() > 0.1, "it bends: {moved}");
    let given = wing.reactions(&state, &loads);
    let root = state.places[0];
    let (mut force, mut turning) = (Vector3::zeros(), Vector3::zeros());
    for load in &loads.dead {
        force += load.force;
        turning += load.moment + (state.places[load.node] - root).cross(&load.force);
    }
    let axes = wing.nodes()[0].axes;
    let own = [&given[..3], &given[3..6]].map(|three| axes * Vector3::from_column_slice(three));
    assert!((own[0] + force).norm() < 1e-7 * force.norm(), "{} for {force}", own[0]);
    assert!((own[1] + turning).norm() < 1e-7 * turning.norm(), "{} for {turning}", own[1]);
}

#[test]
fn small_readings_of_followers_follow_from_the_adjoint() {
    let (wing, mut loads) = pulled();
    loads.gravity_m_s2 = Vector3::new(0.0, 3.0, -20.0);
    let end = to_the_last_digit(&wing, &path(&wing, &loads).end().state, &loads);
    let (read_at, other) = (at(&wing, 13), at(&wing, 15));
    let read = |state: &State| state.places[read_at].z - 0.4 * state.places[other].x;
    let mut by_motion = vec![0.0; 6 * wing.nodes().len()];
    (by_motion[6 * read_at + 2], by_motion[6 * other]) = (1.0, -0.4);
    let dead = wing.change_of_dead(&end, &loads);
    let change = |motion: &[f64]| dead.transposed_in_equilibrium(motion);
    let outer = wing.load_forces(&end, &loads);
    let lambda = &wing.adjoint(&end, &outer, &change, &[by_motion]).expect("an equilibrium")[0];
    for (grid, axis, is_moment) in [(14, 0, false), (11, 2, false), (16, 1, true), (3, 1, false)] {
        let (node, step) = (at(&wing, grid), 0.01);
        let pushed = |step: f64| {
            let (mut more, unit) = (loads.clone(), Vector3::ith(axis, step));
            more.dead.push(if is_moment { moment(node, unit.into()) } else { force(node, unit.into()) });
            read(&to_the_last_digit(&wing, &end, &more))
        };
        let difference = (pushed(step) - pushed(-step)) / (2.0 * step);
        let own = lambda[6 * node + 3 * usize::from(is_moment) + axis];
        assert!((own / difference - 1.0).abs() < 1e-5, "GRID {grid}, {axis}: {own} for {difference}");
    }
}

/// Weight of bodies with arms, of masses that differ along their axes (with inertia and without) and of beams: the slope of the work
/// of all loads in a virtual motion.
#[test]
fn the_change_of_weight_is_that_of_differences() {
    let wing = large(&format!(
        "{TIED}CONM2,50,3,,2.,.1,.2,-.1\nCONM2,51,4,,3.\nCONM1,52,2,,4.,.1,5.,.2,.3\n,6.,,,,.2,,,\n,,.3,,,,,,.4\n\
         CONM1,53,10,5,2.,,7.,.5\n,9.\n"
    ));
    let (mut loads, step) = (Loads { dead: vec![force(1, [1.0, 2.0, 3.0])], ..Loads::default() }, 1e-6);
    loads.gravity_m_s2 = Vector3::new(2.0, -3.0, 9.0);
    let state = shaken(&wing, 0.3);
    let wave = |phase: f64| -> Vec<f64> {
        (0..6 * wing.nodes().len()).map(|at| (1.3 * at as f64 + phase).sin()).collect()
    };
    let (virtual_motion, motion) = (wave(0.2), wave(1.7));
    let change = wing.change_of_dead(&state, &loads);
    let own: f64 = change.transposed(&virtual_motion).iter().zip(&motion).map(|(a, b)| a * b).sum();
    let work = |by: f64| -> f64 {
        let moved: Vec<f64> = motion.iter().map(|m| m * by).collect();
        let forces = wing.load_forces(&state.moved_by(&moved), &loads);
        forces.iter().zip(&virtual_motion).map(|(f, v)| f * v).sum()
    };
    let difference = (work(step) - work(-step)) / (2.0 * step);
    assert!((own / difference - 1.0).abs() < 1e-7, "{own} for {difference}");
    // In the symmetric form half of m x v is taken off.
    let symmetric = change.transposed_in_equilibrium(&virtual_motion);
    let forces = wing.load_forces(&state, &loads);
    for ((six, own), (force, v)) in symmetric
        .chunks_exact(6)
        .zip(change.transposed(&virtual_motion).chunks_exact(6))
        .zip(forces.chunks_exact(6).zip(virtual_motion.chunks_exact(6)))
    {
        let across = Vector3::from_column_slice(&force[3..]).cross(&Vector3::from_column_slice(&v[3..]));
        for axis in 0..3 {
            assert_eq!(six[axis], own[axis]);
            assert!((six[3 + axis] - (own[3 + axis] - 0.5 * across[axis])).abs() < 1e-12);
        }
    }
    let weightless = Loads { gravity_m_s2: Vector3::zeros(), ..loads };
    assert!(size(&wing.change_of_dead(&state, &weightless).transposed(&virtual_motion)) == 0.0);
}
