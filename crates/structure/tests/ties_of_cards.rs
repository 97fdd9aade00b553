//! Which ties hold at finite rotations, and rigid bars whose independent motions are spread over both ends.

use nalgebra::Point3;
use nastran::parse_deck;
use structure::{Joint, Model};

const GRIDS: &str = "CORD2R,5,,0.,0.,0.,1.,2.,2.,\n,1.,0.,0.\nGRID,1,,.5,.2,-.3\nGRID,2,,2.,.4,.3\nGRID,3,,1.,1.5,.2\n\
    GRID,4,,1.,1.,2.,5\nGRID,9,,1.,.7,.4\n";

fn read(cards: &str) -> Result<Model, String> {
    let bulk = parse_deck("test.bdf", &format!("{GRIDS}{cards}")).map_err(|error| error.to_string())?;
    Model::from_bulk(&bulk).map_err(|error| error.to_string())
}

fn joint(cards: &str) -> Joint {
    let model = read(cards).expect(cards);
    assert_eq!(model.ties.len(), 1, "{cards}");
    assert_eq!(model.ties[0].rows, 0..model.dependents.len(), "{cards}");
    model.ties[0].joint.clone()
}

#[test]
fn rigid_elements_with_all_displacements_turn_and_others_are_linear() {
    let rigid = |from: usize, to: &[usize], turns: bool| Joint::Rigid { from, to: to.into(), turns };
    for (cards, expected) in [
        ("RBE2,7,2,123456,1,3\n", rigid(1, &[0, 2], true)),
        ("RBE2,7,2,123,1\n", rigid(1, &[0], false)),
        ("RBE2,7,2,1234,1\n", Joint::Linear),
        ("RBE2,7,2,12456,1\n", Joint::Linear),
        ("RBE2,7,2,456,1\n", Joint::Linear),
        // The other end follows in all that is not named, or in what is.
        ("RBAR,7,1,3,123456\n", rigid(0, &[2], true)),
        ("RBAR,7,1,3,,123456\n", rigid(2, &[0], true)),
        ("RBAR,7,1,3,123456,,,123\n", rigid(0, &[2], false)),
        ("RBAR,7,1,3,,123456,123456\n", rigid(2, &[0], true)),
        ("RBAR,7,1,3,123456,,,12\n", Joint::Linear),
        ("RBAR,7,1,3,,123456,1234\n", Joint::Linear),
        ("RBAR,7,1,3,1234,23\n", Joint::Linear),
        ("RBAR1,7,1,3\n", rigid(0, &[2], true)),
        ("RBAR1,7,1,3,123\n", rigid(0, &[2], false)),
        ("RBAR1,7,1,3,1235\n", Joint::Linear),
        ("RTRPLT1,7,2,1,3\n", rigid(1, &[0, 2], true)),
        ("RTRPLT1,7,2,1,3,123,123456\n", Joint::Linear),
        ("RBE1,7,2,123456\n,UM,1,123,3,123\n", rigid(1, &[0, 2], false)),
        ("RBE1,7,2,123,1,23,3,3\n,UM,2,456\n", Joint::Linear),
        ("RROD,7,1,3,1\n", Joint::Linear),
    ] {
        assert_eq!(joint(cards), expected, "{cards}");
    }
}

#[test]
fn equations_are_exact_as_differences_of_one_displacement_alone() {
    for (cards, is_difference) in [
        ("MPC,1,9,2,1.,1,2,-1.\n", true),
        ("MPC,1,9,2,2.,1,2,-.5,,\n,,3,2,-1.5\n", true),
        ("MPC,1,9,2,1.,1,2,-.9\n", false),
        ("MPC,1,9,2,1.,1,2,1.\n", false),
        ("MPC,1,9,2,1.,1,3,-1.\n", false),
        ("MPC,1,9,5,1.,1,5,-1.\n", false),
        // Other axes.
        ("MPC,1,9,2,1.,4,2,-1.\n", false),
    ] {
        let expected = if is_difference { Joint::Difference } else { Joint::Linear };
        assert_eq!(joint(cards), expected, "{cards}");
    }
}

/// Weights of rotations count with the square of the group's mean distance from the reference.
#[test]
fn means_turn_with_groups_of_whole_displacements() {
    let model = read("").expect("grids");
    let about = model.nodes[4].point;
    let far = |node: usize| (model.nodes[node].point - about).norm();
    let square =
        |nodes: &[usize]| (nodes.iter().map(|node| far(*node)).sum::<f64>() / nodes.len() as f64).powi(2);
    let Joint::Mean { reference, turns, members } = joint("RBE3,7,,9,123456,2.,123,1,2\n,3.,123456,3\n")
    else {
        panic!("a mean")
    };
    assert_eq!((reference, turns), (4, true));
    for (own, (node, place, rotation)) in
        members.iter().zip([(0, 2.0, 0.0), (1, 2.0, 0.0), (2, 3.0, 3.0 * square(&[0, 1, 2]))])
    {
        assert_eq!((own.0, own.1), (node, place));
        assert!((own.2 - rotation).abs() < 1e-14, "{own:?}");
    }
    assert!(matches!(joint("RBE3,7,,9,123,1.,123,1,2\n,3\n"), Joint::Mean { turns: false, .. }));
    for cards in [
        "RBE3,7,,9,1234,1.,123,1,2\n,3\n",
        "RBE3,7,,9,123456,1.,1234,1,2\n,3\n",
        "RBE3,7,,9,123,1.,123,1,2\n,3,UM,1,123\n",
    ] {
        assert_eq!(joint(cards), Joint::Linear, "{cards}");
    }
    let cards = format!("{GRIDS}RBE3,7,,9,123456,1.,123,1,2\n,3\n");
    for weight in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        let mut bulk = parse_deck("test.bdf", &cards).expect("a deck");
        bulk.averages.get_mut(&7).expect("a mean").groups[0].weight = weight;
        let error = Model::from_bulk(&bulk).expect_err("refused").to_string();
        assert!(error.contains("RBE3 7 has a group of weight"), "{error}");
    }
}

/// Motions of a node in its own axes under the six rigid motions about the origin.
fn rigid(model: &Model, dof: usize) -> [f64; 6] {
    let (node, component) = (&model.nodes[dof / 6], dof % 6);
    let axis: nalgebra::Vector3<f64> = node.axes.column(component % 3).into();
    let arm = (node.point - Point3::origin()).cross(&axis);
    if component < 3 {
        [axis.x, axis.y, axis.z, arm.x, arm.y, arm.z]
    } else {
        [0.0, 0.0, 0.0, axis.x, axis.y, axis.z]
    }
}

/// Every row of a rigid bar, and of other ties, is true of all rigid motions; and the rows are those of the motions
/// named.
#[test]
fn rows_of_ties_hold_under_every_rigid_motion() {
    let all = |node: usize| (6 * node..6 * node + 6).collect::<Vec<usize>>();
    let of = |node: usize, components: &[usize]| {
        components.iter().map(|c| 6 * node + c - 1).collect::<Vec<usize>>()
    };
    for (cards, dependent, sources) in [
        ("RBAR,7,1,4,123456\n", all(3), all(0)),
        ("RBAR,7,4,1,,123456\n", all(3), all(0)),
        (
            "RBAR,7,1,4,1234,23\n",
            [of(0, &[5, 6]), of(3, &[1, 4, 5, 6])].concat(),
            [of(0, &[1, 2, 3, 4]), of(3, &[2, 3])].concat(),
        ),
        (
            "RBAR,7,1,4,1234,23,5,16\n",
            [of(0, &[5]), of(3, &[1, 6])].concat(),
            [of(0, &[1, 2, 3, 4]), of(3, &[2, 3])].concat(),
        ),
        // A component that is not named follows nothing.
        ("RBAR1,7,4,1,1246\n", of(0, &[1, 2, 4, 6]), all(3)),
        (
            "RTRPLT,7,1,2,4,1235,3,3\n",
            [of(0, &[4, 6]), of(1, &[1, 2, 4, 5, 6]), of(3, &[1, 2, 4, 5, 6])].concat(),
            [of(0, &[1, 2, 3, 5]), of(1, &[3]), of(3, &[3])].concat(),
        ),
        (
            "RTRPLT,7,1,2,4,1235,3,3\n,,1,16\n",
            [of(1, &[1]), of(3, &[1, 6])].concat(),
            [of(0, &[1, 2, 3, 5]), of(1, &[3]), of(3, &[3])].concat(),
        ),
        ("RTRPLT1,7,4,1,2,,35\n", [all(0), of(1, &[3, 5])].concat(), all(3)),
        // Six independent motions of four grids, two lines of them, and the rest of some.
        (
            "RBE1,7,1,123,2,3,3,3\n,,4,1\n,UM,1,456,2,12,9,123456\n,,4,26,6.5-6\n",
            [of(0, &[4, 5, 6]), of(1, &[1, 2]), of(3, &[2, 6]), all(4)].concat(),
            [of(0, &[1, 2, 3]), of(1, &[3]), of(2, &[3]), of(3, &[1])].concat(),
        ),
        ("RROD,7,4,9,2\n", of(3, &[2]), [of(3, &[1, 3]), of(4, &[1, 2, 3])].concat()),
        ("RBE2,7,4,135,2,1\n", [of(0, &[1, 3, 5]), of(1, &[1, 3, 5])].concat(), all(3)),
        ("RBE3,7,,9,26,1.,123,1,2\n,2.,13,4,3\n", of(4, &[2, 6]), [all(0), all(1), all(2), all(3)].concat()),
        (
            "RBE3,7,,4,123456,1.,123456,1,2\n,3,UM,1,123,2,456\n",
            [of(0, &[1, 2, 3]), of(1, &[4, 5, 6])].concat(),
            [all(0), all(1), all(2), all(3)].concat(),
        ),
    ] {
        let model = read(cards).expect(cards);
        let mut own: Vec<usize> = model.dependents.iter().map(|row| row.dof).collect();
        own.sort_unstable();
        assert_eq!(own, dependent, "{cards}");
        for row in &model.dependents {
            assert!(row.row.iter().all(|(dof, _)| sources.contains(dof)), "{cards}: {:?}", row.row);
            let mut follows = [0.0; 6];
            for (dof, factor) in &row.row {
                follows.iter_mut().zip(rigid(&model, *dof)).for_each(|(sum, part)| *sum += factor * part);
            }
            for (motion, (follows, own)) in follows.iter().zip(rigid(&model, row.dof)).enumerate() {
                assert!((follows - own).abs() < 1e-10, "{cards}: {} in motion {motion}", row.dof);
            }
        }
    }
}

#[test]
fn motions_that_do_not_hold_a_bar_are_refused() {
    let flat = "GRID,11,,0.,0.,0.\nGRID,12,,2.,0.,0.\n";
    // Nothing holds the turn about the bar; or x is held twice.
    for cards in ["RBAR,7,11,12,123,123\n", "RBAR,7,11,12,1235,16\n"] {
        let error = read(&format!("{flat}{cards}")).expect_err("refused");
        assert!(
            error.contains("RBAR 7: its independent motions do not determine the motion of the body"),
            "{error}"
        );
    }
    assert!(read(&format!("{flat}RBAR,7,11,12,1234,23\n")).is_ok());
}

#[test]
fn a_rigid_rod_keeps_the_distance_of_its_ends_and_nothing_else() {
    let model = read("RROD,7,4,9,,3\n").expect("a rod");
    let row = &model.dependents[0];
    assert_eq!((row.dof, model.dependents.len()), (6 * 4 + 2, 1));
    // Any motions of the two ends, the dependent one by its row.
    let mut motion = [0.0; 30];
    for (dof, value) in motion.iter_mut().enumerate() {
        *value = (1.7 * dof as f64).sin();
    }
    motion[row.dof] = row.row.iter().map(|(dof, factor)| factor * motion[*dof]).sum();
    let moved = |node: usize| {
        model.nodes[node].axes * nalgebra::Vector3::from_column_slice(&motion[6 * node..6 * node + 3])
    };
    let along = model.nodes[4].point - model.nodes[3].point;
    assert!((moved(4) - moved(3)).dot(&along).abs() < 1e-14 && (moved(4) - moved(3)).norm() > 0.5);
    let across = "GRID,11,,0.,0.,0.\nGRID,12,,2.,0.,0.\nRROD,7,11,12,2\n";
    let error = read(across).expect_err("refused");
    assert!(error.contains("RROD 7: component 2 of GRID 11 is across the rod"), "{error}");
}

/// A straight line of grids with axes of their own: across it a cubic, along it a line, between motions of the grids that are free.
/// MYSTRAN 18's rows of such a line (.6, .4; .648, .288, .352, -.192; .72, -.12, -.32 at two fifths of it) are these.
#[test]
fn grids_on_a_straight_spline_follow_a_cubic() {
    let line = "GRID,31,,0.,0.,0.\nGRID,32,,.8,0.,0.,5\nGRID,33,,2.,0.,0.\nGRID,34,,2.,1.,0.\nGRID,35,,2.,1.5,0.\nGRID,36,,2.,2.,0.\n";
    let model = read(&format!("{line}RSPLINE,7,,31,32,123456,33\n")).expect("a spline");
    let at = |id: u32| model.nodes.iter().position(|node| node.id == id).expect("a node");
    let mut motion = vec![0.0; 6 * model.nodes.len()];
    let ends = [[0.3, -0.2, 0.5, 0.1, -0.4, 0.2], [-0.1, 0.4, 0.25, -0.3, 0.15, 0.35]];
    for (id, end) in [31, 33].into_iter().zip(&ends) {
        motion[6 * at(id)..6 * at(id) + 6].copy_from_slice(end);
    }
    for row in &model.dependents {
        motion[row.dof] = row.row.iter().map(|(dof, factor)| factor * motion[*dof]).sum();
    }
    let node = at(32);
    let own = |first: usize| {
        model.nodes[node].axes
            * nalgebra::Vector3::from_column_slice(&motion[6 * node + first..6 * node + first + 3])
    };
    let [a, b] = ends;
    let mix = |axis: usize| 0.6 * a[axis] + 0.4 * b[axis];
    // Slopes are rotations about z in the plane x-y, minus those about y in x-z; two metres long.
    let across = |w: [f64; 2], slope: [f64; 2]| {
        (
            0.648 * w[0] + 0.288 * slope[0] + 0.352 * w[1] - 0.192 * slope[1],
            -0.72 * w[0] - 0.12 * slope[0] + 0.72 * w[1] - 0.32 * slope[1],
        )
    };
    let (y, turn_z) = across([a[1], b[1]], [a[5], b[5]]);
    let (z, minus_turn_y) = across([a[2], b[2]], [-a[4], -b[4]]);
    let (moved, turned) = (own(0), own(3));
    for (own, expected) in [
        (moved.x, mix(0)),
        (moved.y, y),
        (moved.z, z),
        (turned.x, mix(3)),
        (turned.y, -minus_turn_y),
        (turned.z, turn_z),
    ] {
        assert!((own - expected).abs() < 1e-12, "{own} for {expected}");
    }
    // Round a corner that is free, with components that are free in between: true of every rigid motion.
    let cards = format!("{line}RSPLINE,7,.3,31,32,123,33,,34\n,123456,35,1256,36\n");
    let model = read(&cards).expect("a spline");
    assert_eq!(model.dependents.len(), 3 + 6 + 4);
    for row in &model.dependents {
        let mut follows = [0.0; 6];
        for (dof, factor) in &row.row {
            follows.iter_mut().zip(rigid(&model, *dof)).for_each(|(sum, part)| *sum += factor * part);
        }
        for (follows, own) in follows.iter().zip(rigid(&model, row.dof)) {
            assert!((follows - own).abs() < 1e-9, "{}: {follows} for {own}", row.dof);
        }
    }
    let error = read(&format!("{line}RSPLINE,7,,31,33,123,36\n")).expect_err("refused");
    assert!(error.contains("RSPLINE 7: its line bends at GRID 33, which follows"), "{error}");
    let long = (100..500).map(|grid| format!("GRID,{grid},,{grid}.,0.,0.\n")).collect::<Vec<_>>().concat();
    let digits = |grid: u32| if grid < 499 { "123" } else { "" };
    let list = (101..500).map(|grid| format!("{grid},{},", digits(grid))).collect::<Vec<_>>().concat();
    let error = read(&format!("{long}RSPLINE,7,,100,{list}\n")).expect_err("refused");
    assert!(error.contains("RSPLINE 7 has 400 grids, more than 300"), "{error}");
    for cards in ["RSPLINE,7,,31,32,123\n", "RSPLINE,7,,31,33\n", "RSPLINE,7,,31,32,,33\n"] {
        let error = read(&format!("{line}{cards}")).expect_err("refused");
        assert!(error.contains("RSPLINE 7 does not end with a grid that nothing constrains"), "{error}");
    }
}

/// Equations solved for their first motion: x = -(sum of the others) / its own factor.
#[test]
fn an_equation_gives_its_first_motion() {
    let model = read("MPC,1,9,2,4.,1,1,-2.,,\n,,3,6,6.\n").expect("an equation");
    let row = &model.dependents[0];
    assert_eq!((row.dof, model.dependents.len()), (6 * 4 + 1, 1));
    let mut own = row.row.clone();
    own.sort_by_key(|(dof, _)| *dof);
    assert_eq!(own, [(0, 0.5), (6 * 2 + 5, -1.5)]);
    let mut bulk = parse_deck("test.bdf", &format!("{GRIDS}MPC,1,9,2,4.,1,1,-2.\n")).expect("a deck");
    bulk.equations[0].terms[0].1 = 0.0;
    let error = Model::from_bulk(&bulk).expect_err("refused").to_string();
    assert!(error.contains("the dependent motions it names are not determined by the others"), "{error}");
}
