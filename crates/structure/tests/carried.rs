//! Points carried by nodes that turn far: where they are, and that their loads do the same work on the nodes.

use crate::large::spin;
use nalgebra::{DMatrix, Matrix3, Point3, Rotation3, Vector3};
use structure::nonlinear::{Carried, CarriedPoint, State};

fn nodes() -> Vec<Vector3<f64>> {
    [[0.0, 0.0, 0.0], [1.0, 0.1, 0.1], [1.1, 1.2, 0.0], [0.0, 1.0, 0.2], [2.1, 0.2, 0.2]]
        .map(Vector3::from)
        .into()
}

/// Rows of a point that moves with the weighted mean of its nodes' rigid motions.
fn point(origin: [f64; 3], shares: &[(usize, f64)]) -> CarriedPoint {
    let origin = Point3::from(origin);
    let mut rows = DMatrix::zeros(6, 6 * shares.len());
    for (at, (node, share)) in shares.iter().enumerate() {
        let arm = origin.coords - nodes()[*node];
        let unit = Matrix3::identity() * *share;
        rows.fixed_view_mut::<3, 3>(0, 6 * at).copy_from(&unit);
        rows.fixed_view_mut::<3, 3>(0, 6 * at + 3).copy_from(&(-arm.cross_matrix() * *share));
        rows.fixed_view_mut::<3, 3>(3, 6 * at + 3).copy_from(&unit);
    }
    CarriedPoint { origin, nodes: shares.iter().map(|(node, _)| *node).collect(), rows }
}

/// Two on one quadrilateral, one on a line, one on a node, and again one on the quadrilateral.
fn points() -> Vec<CarriedPoint> {
    let four = [(0, 0.4), (1, 0.3), (2, 0.2), (3, 0.1)];
    vec![
        point([0.5, 0.4, 0.6], &four),
        point([1.6, 0.0, -0.3], &[(1, 0.3), (4, 0.7)]),
        point([0.2, 0.9, 0.1], &[(0, -0.2), (1, 0.1), (2, 0.5), (3, 0.6)]),
        point([1.4, 1.5, 0.3], &[(2, 1.0)]),
        point([-0.3, 0.8, -0.2], &four),
    ]
}

fn wave(count: usize, phase: f64) -> Vec<f64> {
    (0..count).map(|at| (1.3 * at as f64 + phase).sin()).collect()
}

fn turned(turn: &Rotation3<f64>, shift: &Vector3<f64>) -> State {
    let places = nodes().iter().map(|place| turn * place + shift).collect();
    State { places, rotations: vec![*turn; 5] }
}

/// Turned far, and bent.
fn bent() -> State {
    let motion: Vec<f64> = wave(30, 0.4).iter().map(|value| 0.15 * value).collect();
    turned(&Rotation3::from_scaled_axis(Vector3::new(1.1, -0.8, 1.3)), &Vector3::new(3.0, 1.0, -2.0))
        .moved_by(&motion)
}

#[test]
fn points_follow_a_rigid_motion_of_their_nodes() {
    let (turn, shift) =
        (Rotation3::from_scaled_axis(Vector3::new(1.9, -1.2, 1.4)), Vector3::new(3.0, -1.0, 2.0));
    let carried = Carried::new(&nodes(), &points());
    let placed = carried.placed(&turned(&turn, &shift));
    for (at, point) in points().iter().enumerate() {
        let (place, rotation) = carried.place(&placed, at);
        assert!((place - (turn * point.origin.coords + shift)).norm() < 1e-12, "point {at}: {place}");
        assert!((rotation.matrix() - turn.matrix()).amax() < 1e-12, "point {at}");
    }
}

#[test]
fn small_motions_move_points_by_their_rows_whatever_the_attitude() {
    let carried = Carried::new(&nodes(), &points());
    let (turn, step) = (Rotation3::from_scaled_axis(Vector3::new(0.9, 0.3, -1.4)), 1e-6);
    let shift = Vector3::new(-1.0, 0.5, 0.2);
    let motion = wave(30, 0.7);
    // The same motion seen along the turned axes.
    let along: Vec<f64> = motion
        .chunks_exact(3)
        .flat_map(|three| <[f64; 3]>::from((turn * Vector3::from_column_slice(three)) * step))
        .collect();
    let placed = carried.placed(&turned(&turn, &shift).moved_by(&along));
    for (at, point) in points().iter().enumerate() {
        let own = point.nodes.iter().flat_map(|node| &motion[6 * node..6 * node + 6]).copied();
        let expected = &point.rows * nalgebra::DVector::from_iterator(6 * point.nodes.len(), own);
        let (place, rotation) = carried.place(&placed, at);
        let moved = turn.inverse() * (place - shift) - point.origin.coords;
        let spun = spin(&(turn.inverse() * rotation));
        for axis in 0..3 {
            assert!((moved[axis] / step - expected[axis]).abs() < 1e-4, "point {at}: {moved}");
            assert!((spun[axis] / step - expected[3 + axis]).abs() < 1e-4, "point {at}: {spun}");
        }
    }
}

#[test]
fn loads_on_points_do_the_same_work_on_their_nodes() {
    let (carried, state, step) = (Carried::new(&nodes(), &points()), bent(), 1e-5);
    let loads: Vec<[Vector3<f64>; 2]> = wave(30, 2.1)
        .chunks_exact(6)
        .map(|six| {
            [Vector3::from_column_slice(&six[..3]) * 30.0, Vector3::from_column_slice(&six[3..]) * 20.0]
        })
        .collect();
    // One by one, and all together.
    let alone = |at: usize| {
        let mut only = vec![[Vector3::zeros(); 2]; 5];
        only[at] = loads[at];
        only
    };
    for loads in (0..5).map(alone).chain([loads.clone()]) {
        let forces = carried.forces(&carried.placed(&state), &loads, 5);
        assert_eq!(forces.len(), 30);
        for dof in 0..30 {
            let moved = |by: f64| {
                let mut motion = vec![0.0; 30];
                motion[dof] = by;
                carried.placed(&state.moved_by(&motion))
            };
            let (up, down) = (moved(step), moved(-step));
            let of_point = |(at, [force, moment]): (usize, &[Vector3<f64>; 2])| {
                let (up, down) = (carried.place(&up, at), carried.place(&down, at));
                force.dot(&(up.0 - down.0)) + moment.dot(&spin(&(up.1 * down.1.inverse())))
            };
            let work: f64 = loads.iter().enumerate().map(of_point).sum::<f64>() / (2.0 * step);
            assert!((forces[dof] - work).abs() < 1e-6, "motion {dof}: {} for {work}", forces[dof]);
        }
    }
}

#[test]
fn loads_keep_their_resultant() {
    let (carried, state) = (Carried::new(&nodes(), &points()), bent());
    let placed = carried.placed(&state);
    let (pull, twist) = (Vector3::new(5.0, -3.0, 8.0), Vector3::new(1.0, 4.0, -2.0));
    for at in 0..5 {
        let mut loads = vec![[Vector3::zeros(); 2]; 5];
        loads[at] = [pull, twist];
        let forces = carried.forces(&placed, &loads, 5);
        let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
        for (six, place) in forces.chunks_exact(6).zip(&state.places) {
            let own = Vector3::from_column_slice(&six[..3]);
            force += own;
            moment += place.cross(&own) + Vector3::from_column_slice(&six[3..]);
        }
        let expected = carried.place(&placed, at).0.cross(&pull) + twist;
        assert!(
            (force - pull).norm() < 1e-11 && (moment - expected).norm() < 1e-11,
            "point {at}: {force} {moment}"
        );
    }
}
