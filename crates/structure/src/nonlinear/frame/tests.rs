//! Best-fit frames: least squares, spins by differences, thresholds of lines.

use super::*;

#[test]
fn a_rigid_rotation_is_found_to_round_off_for_lines_planes_bodies_and_points() {
    let turned = Rotation3::from_scaled_axis(Vector3::new(1.9, -1.2, 2.0));
    let all = [[0.0, 0.0, 0.0], [2.0, 0.1, 0.0], [2.2, 1.0, 0.0], [0.1, 1.1, 0.0], [0.3, 0.4, 1.0]];
    let all: Vec<Vector3<f64>> = all.iter().map(|p| Vector3::from(*p)).collect();
    for count in 1..=5 {
        let group = Group::of(&all[..count], true);
        let arms: Vec<_> = group.arms.iter().map(|arm| turned * arm).collect();
        let fit = group.fit(&arms, &vec![turned; count]);
        assert!((fit.q - turned.matrix()).amax() < 1e-14, "{count} nodes: {}", fit.q - turned.matrix());
    }
}

/// Nodes of a body that do not lie in a plane, with unlike weights of places and rotations.
fn body() -> Group {
    let points = [[0.0, 0.0, 0.0], [2.0, 0.1, 0.0], [2.2, 1.0, 0.0], [0.1, 1.1, 0.4]].map(Vector3::from);
    Group::weighted(&points, vec![1.0, 2.0, 0.5, 1.5], vec![0.0, 0.7, 0.3, 0.0])
}

/// Arms that are turned and strained, and rotations that are not those of the arms.
fn strained(group: &Group) -> (Vec<Vector3<f64>>, Vec<Rotation3<f64>>) {
    let turn = Rotation3::from_scaled_axis(Vector3::new(0.9, -1.2, 0.5));
    let off = |at: usize| {
        let at = at as f64;
        Vector3::new((1.3 * at + 0.4).sin(), (2.1 * at).cos(), (0.7 * at - 1.0).sin()) * 0.15
    };
    let arms = group.arms.iter().enumerate().map(|(at, arm)| turn * arm + off(at)).collect();
    let rotations = (0..group.arms.len()).map(|at| turn * Rotation3::from_scaled_axis(off(at + 5))).collect();
    (arms, rotations)
}

/// M of the module.
fn numerator(group: &Group, arms: &[Vector3<f64>], rotations: &[Rotation3<f64>]) -> Matrix3<f64> {
    let of_place = |at: usize| arms[at] * group.arms[at].transpose() * group.weight(at);
    let of_rotation = |at: usize| rotations[at].matrix() * group.rotations[at];
    (0..arms.len()).map(|at| of_place(at) + of_rotation(at)).sum()
}

#[test]
fn no_other_rotation_fits_better() {
    let group = body();
    let (arms, rotations) = strained(&group);
    let (q, m) = (group.fit(&arms, &rotations).q, numerator(&group, &arms, &rotations));
    assert!((q.transpose() * q - Matrix3::identity()).amax() < 1e-14 && q.determinant() > 0.0);
    assert!(axial(&(q.transpose() * m)).norm() < 1e-13 * m.norm(), "stationary");
    for axis in 0..3 {
        for angle in [-2.0, -0.1, 0.1, 2.0, 3.1] {
            let other = q * Rotation3::from_scaled_axis(Vector3::ith(axis, angle)).matrix();
            assert!((other.transpose() * m).trace() < (q.transpose() * m).trace() - 1e-6, "{axis} {angle}");
        }
    }
}

/// The fit's spin as the module has it, against the fit to arms and rotations that moved a little.
#[track_caller]
fn spins_as_differences_say(group: &Group, arms: &[Vector3<f64>], rotations: &[Rotation3<f64>], what: &str) {
    let (fit, step) = (group.fit(arms, rotations), 1e-5);
    let spun = |moved: &dyn Fn(f64) -> Fit| {
        let [up, down] = [moved(step).q, moved(-step).q];
        fit.q.transpose() * axial(&(up * down.transpose())) / (4.0 * step)
    };
    for node in 0..arms.len() {
        for unit in [0, 1, 2].map(|axis| Vector3::ith(axis, 1.0)) {
            let by_place = spun(&|step| {
                let mut arms = arms.to_vec();
                arms[node] += unit * step;
                group.fit(&arms, rotations)
            });
            let numerator = group.arms[node].cross(&(fit.q.transpose() * unit)) * group.weight(node);
            let own = fit.inverse * numerator;
            assert!((own - by_place).norm() < 1e-7, "{what}, place {node}: {own} for {by_place}");
            let by_spin = spun(&|step| {
                let mut rotations = rotations.to_vec();
                rotations[node] = Rotation3::from_scaled_axis(unit * step) * rotations[node];
                group.fit(arms, &rotations)
            });
            let local = fit.q.transpose() * rotations[node].matrix();
            let own =
                fit.inverse * (spin_of_rotation(&local) * (fit.q.transpose() * unit) * group.rotations[node]);
            assert!((own - by_spin).norm() < 1e-7, "{what}, rotation {node}: {own} for {by_spin}");
        }
    }
}

#[test]
fn the_spin_of_a_fit_is_that_of_differences() {
    let group = body();
    let (arms, rotations) = strained(&group);
    spins_as_differences_say(&group, &arms, &rotations, "a body");
    let points: Vec<Vector3<f64>> = [0.0, 0.4, 1.5].map(|x| Vector3::new(x, 2.0 * x, -x)).into();
    let line = Group::of(&points, true);
    let (arms, rotations) = strained(&line);
    spins_as_differences_say(&line, &arms, &rotations, "a line with roll");
    // Without roll; stretched, but straight.
    let line = Group::of(&points[..2], false);
    let turn = Rotation3::from_scaled_axis(Vector3::new(-0.3, 0.8, 1.1));
    let arms: Vec<Vector3<f64>> = line.arms.iter().map(|arm| turn * arm * 1.3).collect();
    let same = vec![Rotation3::identity(); 2];
    let (fit, step) = (line.fit(&arms, &same), 1e-5);
    for unit in [0, 1, 2].map(|axis| Vector3::ith(axis, 1.0)) {
        let moved = |step: f64| line.fit(&[arms[0] - unit * step, arms[1] + unit * step], &same).q;
        let by_place = fit.q.transpose() * axial(&(moved(step) * moved(-step).transpose())) / (4.0 * step);
        let local = fit.q.transpose() * unit;
        let own = fit.inverse * (line.arms[1].cross(&local) - line.arms[0].cross(&local));
        // About the line itself nothing is said.
        let along = line.arms[1].normalize();
        let off = own - by_place;
        let off = off - along * along.dot(&off);
        assert!(off.norm() < 1e-7, "a line without roll: {own} for {by_place}");
        assert!(own.dot(&along).abs() < 1e-12, "no spin along the line");
    }
}

/// Two places at +-a turned by alpha, rotations that stay: least squares of 2 a^2 and b = 2 a^2 / 1000 a node are at
/// tan q = 2 a^2 sin alpha / (2 a^2 cos alpha + 4 b), where a rotation by q about one axis has the trace 1 + 2 cos q.
#[test]
fn a_line_points_from_end_to_end_but_for_a_thousandth() {
    let (a, alpha) = (3.0, 0.8_f64);
    let line = Group::of(&[Vector3::new(-a, 0.0, 0.0), Vector3::new(a, 0.0, 0.0)], true);
    let arms: Vec<Vector3<f64>> =
        line.arms.iter().map(|arm| Rotation3::from_scaled_axis(Vector3::z() * alpha) * arm).collect();
    let q = line.fit(&arms, &[Rotation3::identity(); 2]).q;
    let expected = (alpha.sin() / (alpha.cos() + 4e-3)).atan();
    assert!((q[(1, 0)].atan2(q[(0, 0)]) - expected).abs() < 1e-12, "{q} for {expected}");
    // About the line itself it is the mean of the nodes' rotations.
    let rolled = [0.3, 0.7].map(|angle| Rotation3::from_scaled_axis(Vector3::x() * angle));
    let q = line.fit(&line.arms, &rolled).q;
    assert!((q[(2, 1)].atan2(q[(1, 1)]) - 0.5).abs() < 1e-12, "{q}");
    // A point has nothing but its rotation.
    let point = Group::of(&[Vector3::new(1.0, 2.0, 3.0)], true);
    assert_eq!(point.rotations, [1.0]);
}

#[test]
fn three_nodes_are_a_line_up_to_a_thousandth_of_breadth_over_length() {
    // Inertias about the middle: 2 along, 2/3 b^2 across.
    let of = |b: f64, size: f64| {
        let points = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, b, 0.0]].map(|p| Vector3::from(p) * size);
        Group::of(&points, true)
    };
    for size in [1e-3, 1.0, 1e4] {
        assert!(of(1.6e-3, size).is_line() && !of(1.9e-3, size).is_line(), "size {size}");
        assert!(of(1.9e-3, size).rotations.iter().all(|weight| *weight == 0.0), "a surface has its own roll");
    }
    assert!(
        Group::of(&[Vector3::zeros(), Vector3::x()], false).rotations.iter().all(|weight| *weight == 0.0)
    );
}

#[test]
fn the_middle_is_weighted_and_arms_go_from_there() {
    let points = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 8.0, 0.0]].map(Vector3::from);
    let group = Group::weighted(&points, vec![1.0, 2.0, 1.0], vec![0.0; 3]);
    let middle = Vector3::new(2.0, 2.0, 0.0);
    assert!((group.middle(&points) - middle).norm() < 1e-15);
    assert!(group.arms.iter().zip(&points).all(|(arm, point)| (arm - (point - middle)).norm() < 1e-15));
    assert_eq!((group.weight(1), Group::with_node(&points, 2).weight(1)), (2.0, 0.0));
}

#[test]
fn a_group_that_turns_with_a_node_has_that_nodes_rotation_whatever_the_places() {
    let points = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 8.0, 0.0]].map(Vector3::from);
    let group = Group::with_node(&points, 1);
    let (arms, rotations) = strained(&group);
    assert!((group.fit(&arms, &rotations).q - rotations[1].matrix()).amax() < 1e-14);
    spins_as_differences_say(&group, &arms, &rotations, "with a node");
}

#[test]
fn a_line_may_turn_by_half_a_turn() {
    for along in [Vector3::x(), Vector3::new(1.0, -2.0, 0.5), Vector3::new(0.0, 0.3, 3.0)] {
        let line = Group::of(&[Vector3::zeros(), along * 0.2, along], false);
        let arms: Vec<Vector3<f64>> = line.arms.iter().map(|arm| -arm).collect();
        let q = line.fit(&arms, &[Rotation3::identity(); 3]).q;
        assert!((q.determinant() - 1.0).abs() < 1e-12);
        assert!(line.arms.iter().zip(&arms).all(|(arm, now)| (q * arm - now).norm() < 1e-12), "{q}");
    }
    // A point without rotations does not turn.
    let point = Group::of(&[Vector3::x()], false).fit(&[Vector3::zeros()], &[Rotation3::identity()]);
    assert_eq!((point.q, point.inverse), (Matrix3::identity(), Matrix3::zeros()));
}
