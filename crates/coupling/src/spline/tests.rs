//! Boxes on an axis of two nodes and on single ones, by rows and as what large deflections carry.

use super::*;

fn boxes() -> Lattice {
    Lattice::trapezoid(1, [0.1, 0.2, 0.05], 0.8, [0.5, 1.8, 0.3], 0.4, [2, 2]).expect("boxes")
}

fn points() -> Vec<Point3<f64>> {
    vec![Point3::new(0.3, 0.0, 0.0), Point3::new(9.0, 9.0, 9.0), Point3::new(0.7, 2.0, 0.2)]
}

/// What rows of a carried point give its box, beside the rows of the spline, in motions of all nodes.
fn carried_as_splined(feet: &[CarriedPoint], spline: &Spline) {
    let motion = Mat::from_fn(18, 1, |dof, _| (1.3 * dof as f64 + 0.4).sin());
    let moved = spline.displace(motion.as_ref());
    for (j, (panel, foot)) in boxes().boxes.iter().zip(feet).enumerate() {
        assert_eq!((foot.rows.nrows(), foot.rows.ncols()), (6, 6 * foot.nodes.len()));
        let of = |row: usize| -> f64 {
            let each =
                foot.nodes.iter().enumerate().flat_map(|(at, node)| (0..6).map(move |c| (at, *node, c)));
            each.map(|(at, node, c)| foot.rows[(row, 6 * at + c)] * motion[(6 * node + c, 0)]).sum()
        };
        let (shift, spin) = (Vector3::new(of(0), of(1), of(2)), Vector3::new(of(3), of(4), of(5)));
        let heave = panel.normal().dot(&(shift + spin.cross(&(panel.mid_point() - foot.origin))));
        assert!((moved[(2 * j, 0)] - heave).abs() < 1e-12, "box {j}: {heave}");
        assert!((moved[(2 * j + 1, 0)] - panel.pitch_axis().dot(&spin)).abs() < 1e-12, "box {j}");
    }
}

#[test]
fn an_axis_of_two_nodes_is_a_beam() {
    let (lattice, points) = (boxes(), points());
    let spline = Spline::beam(&lattice, &points, &[0, 2]);
    let feet = feet_on_axis(&lattice, &points, &[0, 2]);
    let along = points[2] - points[0];
    for (panel, foot) in lattice.boxes.iter().zip(&feet) {
        assert_eq!(foot.nodes, [0, 2]);
        // The foot of the perpendicular, on the axis.
        let arm = panel.mid_point() - foot.origin;
        assert!(arm.dot(&along).abs() < 1e-12 && (foot.origin - points[0]).cross(&along).norm() < 1e-12);
    }
    carried_as_splined(&feet, &spline);
    // Half way between the nodes each has half of a displacement, and a rotation bends it by an eighth of the length.
    let middle = Point3::new(0.5, 1.0, 0.1);
    let (_, _, motion) = motion_on_axis(&points, &[0, 2], &middle);
    let share = |row: usize, dof: usize| -> f64 {
        motion[row].iter().filter(|(own, _)| *own == dof).map(|(_, value)| value).sum()
    };
    for axis in 0..3 {
        assert!((share(axis, axis) - 0.5).abs() < 1e-12 && (share(axis, 12 + axis) - 0.5).abs() < 1e-12);
    }
    // A rotation r of the inner node moves the middle by r x along / 8; the outer one's by the opposite.
    for axis in 0..3 {
        let moved = Vector3::ith(axis, 1.0).cross(&along) / 8.0;
        for row in 0..3 {
            assert!((share(row, 3 + axis) - moved[row]).abs() < 1e-12, "{axis} {row}");
            assert!((share(row, 15 + axis) + moved[row]).abs() < 1e-12, "{axis} {row}");
        }
    }
    // A displacement across turns the middle by 1.5 over the length.
    let across = Vector3::z() - along * (along.z / along.norm_squared());
    let turned = along.cross(&across) * (1.5 / along.norm_squared());
    for row in 0..3 {
        assert!(
            (share(3 + row, 14) - turned[row]).abs() < 1e-12
                && (share(3 + row, 2) + turned[row]).abs() < 1e-12
        );
    }
}

#[test]
fn boxes_on_single_nodes_move_with_the_nearest() {
    let (lattice, points) = (boxes(), points());
    for nodes in [&[0, 2][..], &[2, 0], &[2], &[0]] {
        let feet = nearest_nodes(&lattice, &points, nodes);
        for (panel, foot) in lattice.boxes.iter().zip(&feet) {
            let far = |node: &usize| (points[*node] - panel.mid_point()).norm();
            assert!(nodes.iter().all(|node| far(&foot.nodes[0]) <= far(node)) && foot.nodes.len() == 1);
            assert_eq!(foot.origin, points[foot.nodes[0]]);
        }
        carried_as_splined(&feet, &Spline::nearest_node(&lattice, &points, nodes));
        if nodes.len() == 1 {
            let alone = feet_on_axis(&lattice, &points, nodes);
            assert!(alone.iter().all(|foot| foot.nodes == nodes));
        }
    }
    // Of equally near ones the first.
    let pair = [Point3::new(0.0, 1.0, 0.0), Point3::new(0.0, -1.0, 0.0)];
    assert_eq!(nearest_of(&pair, &[1, 0], &Point3::origin()), Some(1));
    assert_eq!(nearest_of(&pair, &[0, 1], &Point3::origin()), Some(0));
    assert_eq!(nearest_of(&pair, &[], &Point3::origin()), None);
    let rows = Spline::nearest_node(&lattice, &points, &[]);
    assert!(rows.rows().iter().all(Vec::is_empty) && rows.g_size() == 18);
}
