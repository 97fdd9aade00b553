//! Places of boxes along the span, and which of them are corrected.

use super::*;

/// A wing of 2 by 3 boxes from y = 2 m, a body of 1 by 2 inboard of it.
fn lattice() -> Lattice {
    let wing = Lattice::trapezoid(200, [0.0, 2.0, 0.0], 1.0, [0.5, 5.0, 0.0], 0.4, [2, 3]).expect("boxes");
    let body = Lattice::trapezoid(100, [0.0, 1.0, 0.0], 1.0, [0.0, 2.0, 0.0], 1.0, [1, 2]).expect("boxes");
    body.joined(&wing).expect("both")
}

#[test]
fn the_inner_edge_is_where_the_innermost_box_begins() {
    assert_eq!(inner_edge(&lattice()), 1.0);
    let left = Lattice::trapezoid(1, [0.0, -3.0, 0.0], 1.0, [0.0, -1.0, 0.0], 1.0, [1, 1]).expect("a box");
    assert_eq!(inner_edge(&left), -3.0);
}

#[test]
fn boxes_of_the_wing_are_counted_from_its_own_root() {
    let found = correctable_boxes(&lattice(), &[100]);
    assert_eq!(found.places, [2, 3, 4, 5, 6, 7]);
    assert_eq!(found.chord_row, [0, 1, 0, 1, 0, 1]);
    assert_eq!(found.chord_rows, [2; 6]);
    assert_eq!(found.strip, [0, 0, 1, 1, 2, 2]);
    assert_eq!(found.ends_m, [2.0, 5.0]);
    for (b, y) in found.y_norm.iter().enumerate() {
        assert!((y - ((b / 2) as f64 + 0.5) / 3.0).abs() < 1e-12, "box {b} at {y}");
    }
    // Chords 1, 0.8, 0.6, 0.4 m: strips of 0.9, 0.7 and 0.5 m2.
    assert!((found.area_m2 - 2.1).abs() < 1e-12);
    for (b, share) in found.area_share.iter().enumerate() {
        let own = [0.9, 0.7, 0.5][b / 2] / 2.0 / 2.1;
        assert!((share - own).abs() < 1e-12, "box {b} has {share}");
    }
    assert!((found.span_m() - 3.0).abs() < 1e-12 && (found.mean_chord_m() - 0.7).abs() < 1e-12);
    // With the body: strips go on from panel to panel.
    let all = correctable_boxes(&lattice(), &[]);
    assert_eq!(all.places, (0..8).collect::<Vec<_>>());
    assert_eq!(all.strip, [0, 1, 2, 2, 3, 3, 4, 4]);
    assert_eq!(all.chord_rows, [1, 1, 2, 2, 2, 2, 2, 2]);
    assert!((all.y_norm[0] - 0.0625).abs() < 1e-12 && (all.area_m2 - 3.1).abs() < 1e-12);
    assert_eq!(all.ends_m, [1.0, 5.0]);
}

/// A wing's file without checks.
fn file(rest: &str) -> WingFile {
    let text = format!(
        "Wing(name: \"parts\", balance: (x_m: 0.1, y_m: 0.2, z_m: 0.3), \
         correction: (chord_strips: 1, span_order: 1), {rest})"
    );
    nastran::ron_file::parse("wing.ron", &text).expect("a wing's file")
}

#[test]
fn the_plane_is_at_the_innermost_box_unless_the_file_says_otherwise_and_fairings_hang_on_the_wall() {
    let drawn = "source: Parametric((semispan_m: 2.0, root_chord_m: 0.6, tip_chord_m: 0.4, \
        quarter_chord_sweep_deg: 0.0, boxes: (chordwise: 2, spanwise: 3), fairing: (strips: 2, width_m: 0.5)))";
    for (rest, plane, on_wall) in [
        ("", MirrorPlane::Symmetric { y_m: -0.5 }, true),
        (", root_plane: Symmetric(-0.75)", MirrorPlane::Symmetric { y_m: -0.75 }, true),
        (", root_plane: None, fairing_metric: true", MirrorPlane::None, false),
    ] {
        let wing = file(&format!("{drawn}{rest}"));
        let bulk = wing.bulk(crate::Mount::Tunnel).expect("cards");
        let parts = wing_parts(&wing, &bulk).expect("a wing");
        assert_eq!(parts.plane, plane);
        assert_eq!(parts.balance.point, Point3::new(0.1, 0.2, 0.3));
        let metric: Vec<bool> = (0..10).map(|j| j < 6 || !on_wall).collect();
        assert_eq!(parts.balance.metric, metric);
        assert!(parts.fairing_surfaces == [200_001] && parts.supported.is_none() && parts.camber.len() == 10);
    }
}

/// Grids at 0, 2 and 1 m in the order of their numbers, and one that hangs on nothing.
const BEAM: &str = "GRID,1,,.2,0.,0.\nGRID,2,,.2,2.,0.\nGRID,3,,.2,1.,0.\nGRID,4,,.2,3.,0.\nMAT1,1,7.+10,,.3,2700.\n\
    PBAR,1,1,1.-3,1.-6,1.-6,1.-6\nCBAR,1,1,1,3,0.,0.,1.\nCBAR,2,1,3,2,0.,0.,1.\nSPC1,1,123456,1,4\nPAERO1,1\n\
    CAERO1,100,1,,2,1,,,1\n,0.,0.,0.,.5,0.,2.,0.,.5\nSET1,7,1,3,2\nSET1,8,1,4\nSET1,9,1,5\n";

#[test]
fn boxes_follow_the_grids_of_the_file_and_the_tip_is_the_outermost_of_them() {
    let bulk = nastran::parse_deck("wing.bdf", BEAM).expect("cards");
    let with = |rest: &str| {
        let wing = file(&format!("source: Deck((file: \"wing.bdf\", spline_set: 7)){rest}"));
        wing_parts(&wing, &bulk)
    };
    let tip = |rest: &str| {
        let held = with(rest).expect("a wing").supported.expect("a structure");
        held.s_dofs[held.tip_z]
    };
    assert_eq!((tip(""), tip(", tip_grid: 3"), tip(", spline: NearestNode")), (8, 14, 8));
    let refused = with(", tip_grid: 6").expect_err("no such grid").to_string();
    assert!(refused.contains("tip_grid is 6"), "{refused}");
    let parts = with(", spline: NearestNode").expect("a wing");
    let (_, spline) = parts.structure.expect("a structure");
    // The middles of both strips are as near to one grid as to another: the first of the set is taken.
    for (box_at, node) in [(0, 0), (1, 2)] {
        assert!(spline.rows()[2 * box_at].iter().all(|(dof, _)| dof / 6 == node), "{:?}", spline.rows());
    }
    let (_, beam) = with("").expect("a wing").structure.expect("a structure");
    assert!(
        beam.rows()[0].iter().any(|(dof, _)| dof / 6 == 2)
            && beam.rows()[0].iter().any(|(dof, _)| dof / 6 == 0)
    );
    for (set, word) in [(8, "grid 4, which no element holds"), (9, "grid 5, which the deck does not have")] {
        let wing = file(&format!("source: Deck((file: \"wing.bdf\", spline_set: {set}))"));
        let refused = wing_parts(&wing, &bulk).expect_err("a grid").to_string();
        assert!(refused.contains(word), "{refused}");
    }
}
