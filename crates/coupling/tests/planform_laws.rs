//! Lines, panels and control surfaces of a trapezoidal wing worked out by hand, and what is refused beyond each bound.

use coupling::planform::{Boxes, Control, FIRST_AXIS_GRID, Fairing, Mesh, Mount, Planform, WING_PANEL};
use nalgebra::{Point3, Vector3};
use nastran::{BulkData, CoordDefinition, Divisions};
use std::path::Path;

/// Semispan 4 m, chord 2 to 1 m, quarter-chord line swept by a slope of 0.5, dihedral by 0.25.
pub(crate) fn trapezoid() -> Planform {
    Planform {
        semispan_m: 4.0,
        root_chord_m: 2.0,
        tip_chord_m: 1.0,
        quarter_chord_sweep_deg: 0.5_f64.atan().to_degrees(),
        dihedral_deg: 0.25_f64.atan().to_degrees(),
        twist_deg: (0.0, 0.0),
        root_leading_edge_x_m: 3.0,
        airfoil: None,
        boxes: Boxes { chordwise: 4, spanwise: 8, strip_edges: None },
        fairing: None,
        controls: Vec::new(),
        structure: None,
    }
}

fn control(name: &str, strips: (usize, usize), chord_boxes: usize) -> Control {
    Control { name: name.to_owned(), strips, chord_boxes, limit_deg: None }
}

fn bulk(planform: &Planform, mount: Mount) -> Result<BulkData, nastran::InputError> {
    planform.bulk(Path::new("."), mount)
}

fn near(found: Point3<f64>, x: f64, y: f64, z: f64) {
    assert!((found - Point3::new(x, y, z)).norm() < 1e-12, "{found} beside {x} {y} {z}");
}

#[test]
fn points_of_a_trapezoid_are_those_of_its_drawing() {
    let wing = trapezoid();
    assert!((wing.chord_m(0.0) - 2.0).abs() < 1e-15 && (wing.chord_m(-1.0) - 2.0).abs() < 1e-15);
    assert!((wing.chord_m(1.0) - 1.75).abs() < 1e-15 && (wing.chord_m(4.0) - 1.0).abs() < 1e-15);
    // the quarter-chord line is at 3 + 2/4 = 3.5 m and goes aft by a half of y
    near(wing.point(0.0, 0.25), 3.5, 0.0, 0.0);
    near(wing.point(2.0, 0.25), 4.5, 2.0, 0.5);
    near(wing.point(2.0, 0.0), 4.5 - 0.375, 2.0, 0.5);
    near(wing.point(4.0, 1.0), 5.5 + 0.75, 4.0, 1.0);
    // inboard of the root it goes on as at the root
    near(wing.point(-1.0, 1.0), 3.5 + 1.5, -1.0, 0.0);
    assert!((wing.area_m2() - 6.0).abs() < 1e-12 && (wing.mean_chord_m() - 1.5).abs() < 1e-12);
    assert!((wing.half_wing_aspect_ratio() - 16.0 / 6.0).abs() < 1e-12);
    assert!((wing.full_wing_aspect_ratio() - 32.0 / 6.0).abs() < 1e-12);
    let edges = wing.strip_edges_m();
    assert_eq!(edges.len(), 9);
    assert!(edges.iter().enumerate().all(|(i, y)| (y - 0.5 * i as f64).abs() < 1e-15));
    assert!(wing.sensor_grids().is_empty());
}

#[test]
fn a_section_turns_about_its_quarter_chord_and_rises_along_its_own_normal() {
    let mut wing = trapezoid();
    wing.twist_deg = (0.0, 30.0);
    near(wing.section_point(0.0, 1.0, 0.1), 5.0, 0.0, 0.2);
    // half way the twist is 15 degrees, the chord 1.5 m and the quarter point at (4.5, 2, 0.5)
    let (sin, cos) = 15.0_f64.to_radians().sin_cos();
    let (aft, up) = (0.5 * 1.5, 0.2 * 1.5);
    near(wing.section_point(2.0, 0.75, 0.2), 4.5 + aft * cos + up * sin, 2.0, 0.5 + up * cos - aft * sin);
    // beyond the tip the twist stays that of the tip
    let (sin, cos) = 30.0_f64.to_radians().sin_cos();
    let tip = wing.point(4.4, 0.25);
    let aft = 0.75 * wing.chord_m(4.4);
    near(wing.section_point(4.4, 1.0, 0.0), tip.x + aft * cos, 4.4, tip.z - aft * sin);
}

#[test]
fn panels_have_the_corners_of_the_drawing_and_the_twist_of_their_middles() {
    let mut wing = trapezoid();
    wing.twist_deg = (1.0, 3.0);
    wing.fairing = Some(Fairing { strips: 2, width_m: 0.3, camber: true });
    let tunnel = bulk(&wing, Mount::Tunnel).expect("a wing");
    let panel = &tunnel.panels[&WING_PANEL];
    near(panel.point_1, 3.0, 0.0, 0.0);
    near(panel.point_4, 5.25, 4.0, 1.0);
    assert!((panel.chord_1 - 2.0).abs() < 1e-15 && (panel.chord_4 - 1.0).abs() < 1e-15);
    assert!(matches!(panel.span_divisions, Divisions::Equal(8)));
    assert!(matches!(panel.chord_divisions, Divisions::Equal(4)));
    let stub = &tunnel.panels[&200_001];
    near(stub.point_1, 3.0, -0.3, 0.0);
    near(stub.point_4, 3.0, 0.0, 0.0);
    let twist = &tunnel.matrices["W2GJ"].columns[0];
    assert_eq!(twist.len(), 4 * 10);
    for (at, value) in twist.iter().enumerate() {
        let degrees = if at < 32 { 1.0 + 2.0 * ((at / 4) as f64 + 0.5) / 8.0 } else { 1.0 };
        assert!((value.to_degrees() - degrees).abs() < 1e-12, "box {at}: {value}");
    }
    wing.fairing = Some(Fairing { strips: 2, width_m: 0.3, camber: false });
    let plain = bulk(&wing, Mount::Tunnel).expect("a wing").matrices["W2GJ"].columns[0].clone();
    assert!(plain[..32] == twist[..32] && plain[32..].iter().all(|value| *value == 0.0));
    let flying = bulk(&wing, Mount::Aircraft).expect("a wing");
    assert!(flying.panels.len() == 1 && flying.matrices["W2GJ"].columns[0] == twist[..32]);
    wing.boxes = Boxes { chordwise: 4, spanwise: 2, strip_edges: Some(vec![0.0, 0.25, 1.0]) };
    let uneven = bulk(&wing, Mount::Aircraft).expect("a wing");
    assert_eq!(uneven.factors[&1].values, [0.0, 0.25, 1.0]);
    let twist: Vec<f64> = uneven.matrices["W2GJ"].columns[0].iter().map(|v| v.to_degrees()).collect();
    assert!((twist[0] - 1.25).abs() < 1e-12 && (twist[4] - 2.25).abs() < 1e-12 && twist.len() == 8);
}

#[test]
fn a_hinge_lies_on_box_edges_and_its_boxes_are_behind_it() {
    let mut wing = trapezoid();
    wing.controls = vec![control("in", (1, 2), 1), control("out", (5, 8), 3)];
    let cards = bulk(&wing, Mount::Tunnel).expect("a wing");
    // strips of four boxes: the last of strips 1 and 2
    assert_eq!(cards.box_lists[&501].boxes, [WING_PANEL + 3, WING_PANEL + 7]);
    let outer: Vec<u32> =
        (4..8).flat_map(|strip| (1..4).map(move |row| WING_PANEL + strip * 4 + row)).collect();
    assert_eq!(cards.box_lists[&502].boxes, outer);
    assert!(cards.surfaces[&502].label == "out" && cards.surfaces[&502].parts == [(502, 502)]);
    for (id, inner_y, outer_y, share) in [(501, 0.0, 1.0, 0.75), (502, 2.0, 4.0, 0.25)] {
        let CoordDefinition::Points { rid, a, b, c } = &cards.coords[&id].definition else {
            panic!("points")
        };
        let (from, to) = (wing.point(inner_y, share), wing.point(outer_y, share));
        assert!(*rid == 0 && (a - from).norm() < 1e-12, "{a}");
        let (z, x) = (b - a, c - a);
        let y = z.cross(&x);
        assert!((y - (to - from).normalize()).norm() < 1e-12, "the hinge runs outwards");
        assert!((z.norm() - 1.0).abs() < 1e-12 && (x.norm() - 1.0).abs() < 1e-12 && z.dot(&y).abs() < 1e-12);
        // z lies in the vertical plane of the hinge
        assert!(z.z > 0.0 && z.dot(&Vector3::z().cross(&y)).abs() < 1e-12);
    }
}

/// A field, how it is set, values that may be and values that may not.
type Change = (&'static str, fn(&mut Planform, f64), &'static [f64], &'static [f64]);
/// A count, how it is set, the least and the most.
type Count = (&'static str, fn(&mut Planform, usize), [usize; 2]);

#[test]
fn numbers_at_their_bounds_are_taken_and_beyond_them_refused() {
    let changes: [Change; 9] = [
        ("semispan_m", |w, v| w.semispan_m = v, &[1e-3, 1e4], &[0.0, -1.0, 1.1e4, f64::NAN]),
        ("root_chord_m", |w, v| w.root_chord_m = v, &[1e-3, 1e4], &[0.0, -1.0, 1.1e4, f64::INFINITY]),
        ("tip_chord_m", |w, v| w.tip_chord_m = v, &[1e-3, 1e4], &[0.0, -1.0, 1.1e4]),
        ("quarter_chord_sweep_deg", |w, v| w.quarter_chord_sweep_deg = v, &[-75.0, 75.0], &[-75.1, 75.1]),
        ("dihedral_deg", |w, v| w.dihedral_deg = v, &[-75.0, 75.0], &[-75.1, 75.1]),
        ("twist_deg", |w, v| w.twist_deg.0 = v, &[-45.0, 45.0], &[-45.1, 45.1]),
        ("twist_deg", |w, v| w.twist_deg.1 = v, &[-45.0, 45.0], &[-45.1, 45.1]),
        ("root_leading_edge_x_m", |w, v| w.root_leading_edge_x_m = v, &[-1e4, 1e4], &[-1.1e4, 1.1e4]),
        (
            "width_m",
            |w, v| w.fairing = Some(Fairing { strips: 1, width_m: v, camber: true }),
            &[1e-3, 1e4],
            &[0.0, 1.1e4],
        ),
    ];
    for (field, set, good, bad) in changes {
        let with = |value: f64| {
            let mut wing = trapezoid();
            set(&mut wing, value);
            bulk(&wing, Mount::Tunnel)
        };
        for value in good {
            assert!(with(*value).is_ok(), "{field} {value}");
        }
        for value in bad {
            let error = with(*value).expect_err(field).to_string();
            assert!(error.contains(&format!("{field} is {value:?}")), "{field} {value}: {error}");
        }
    }
    let counts: [Count; 3] = [
        ("chordwise", |w, n| w.boxes.chordwise = n, [1, 100]),
        ("spanwise", |w, n| w.boxes.spanwise = n, [1, 900]),
        (
            "the fairing has",
            |w, n| w.fairing = Some(Fairing { strips: n, width_m: 1.0, camber: true }),
            [1, 100],
        ),
    ];
    for (field, set, [low, high]) in counts {
        for (value, good) in [(low, true), (high, true), (low - 1, false), (high + 1, false)] {
            let mut wing = trapezoid();
            set(&mut wing, value);
            let outcome = bulk(&wing, Mount::Tunnel);
            assert_eq!(outcome.is_ok(), good, "{field} {value}");
            assert!(outcome.err().is_none_or(|error| error.to_string().contains(field)));
        }
    }
}

#[test]
fn strip_edges_are_one_more_than_strips_and_ascend_from_root_to_tip() {
    let with = |edges: &[f64]| {
        let mut wing = trapezoid();
        wing.boxes = Boxes { chordwise: 1, spanwise: 3, strip_edges: Some(edges.to_vec()) };
        bulk(&wing, Mount::Tunnel).err().map(|error| error.to_string()).unwrap_or_default()
    };
    assert_eq!(with(&[0.0, 0.2, 0.6, 1.0]), "");
    assert!(with(&[0.0, 0.2, 1.0]).contains("strip_edges has 3 numbers, expected spanwise + 1 = 4"));
    assert!(with(&[0.0, 0.2, 0.4, 0.6, 1.0]).contains("5 numbers"));
    assert!(with(&[0.1, 0.2, 0.6, 1.0]).contains("must start with 0.0"));
    assert!(with(&[0.0, 0.2, 0.6, 0.9]).contains("end with 1.0"));
    assert!(with(&[0.0, 0.6, 0.6, 1.0]).contains("0.6 is followed by 0.6"));
    assert!(with(&[0.0, 0.7, 0.6, 1.0]).contains("0.7 is followed by 0.6"));
}

#[test]
fn control_surfaces_that_cannot_be_are_refused_and_the_widest_taken() {
    let with = |controls: &[Control]| {
        let mut wing = trapezoid();
        wing.controls = controls.to_vec();
        bulk(&wing, Mount::Tunnel).err().map(|error| error.to_string()).unwrap_or_default()
    };
    let limited = |limit| Control { limit_deg: Some(limit), ..control("a", (1, 1), 1) };
    for good in [
        vec![control("a", (1, 8), 3)],
        vec![control("a2345678", (1, 1), 1), control("b_1", (2, 8), 1)],
        vec![control("b", (4, 8), 1), control("a", (1, 3), 1)],
        vec![limited(90.0)],
        vec![limited(0.1)],
    ] {
        assert_eq!(with(&good), "");
    }
    for (bad, said) in [
        (vec![control("a23456789", (1, 1), 1)], "no AESURF label"),
        (vec![control("2a", (1, 1), 1)], "no AESURF label"),
        (vec![control("_a", (1, 1), 1)], "no AESURF label"),
        (vec![control("a-b", (1, 1), 1)], "no AESURF label"),
        (vec![control("", (1, 1), 1)], "no AESURF label"),
        (vec![control("a", (0, 1), 1)], "has strips (0, 1)"),
        (vec![control("a", (3, 2), 1)], "has strips (3, 2)"),
        (vec![control("a", (1, 9), 1)], "has strips (1, 9)"),
        (vec![control("a", (1, 1), 0)], "has 0 boxes"),
        (vec![control("a", (1, 1), 4)], "has 4 boxes"),
        (vec![limited(0.0)], "limit_deg 0.0"),
        (vec![limited(90.5)], "limit_deg 90.5"),
        (vec![limited(f64::NAN)], "limit_deg NaN"),
        (vec![control("a", (1, 1), 1), control("A", (3, 4), 1)], "two control surfaces are called A"),
        (vec![control("a", (1, 3), 1), control("b", (3, 4), 1)], "b and a share strips"),
        (vec![control("a", (3, 5), 1), control("b", (1, 3), 1)], "b and a share strips"),
        (vec![control("a", (3, 5), 1), control("b", (4, 4), 1)], "b and a share strips"),
    ] {
        let error = with(&bad);
        assert!(error.contains(said), "{said}: {error}");
    }
}

#[test]
fn boxes_too_coarse_for_the_doublet_lattice_are_named_from_the_limit_on() {
    let mut wing = trapezoid();
    wing.dihedral_deg = 0.0;
    // chord 2 m in four boxes; strips half a metre wide, the last of 1.125 and 1 m chord
    assert!((wing.longest_box_m() - 0.5).abs() < 1e-15);
    assert!((wing.largest_box_aspect_ratio() - 0.5 * 4.0 / 1.0).abs() < 1e-12);
    wing.dihedral_deg = 60.0;
    assert!((wing.largest_box_aspect_ratio() - 4.0).abs() < 1e-12);
    assert!(wing.warnings(100.0, 1.0)[0].contains("4.00 times as wide"));
    wing.dihedral_deg = 0.0;
    // 0.08 V/f: 8 m is plenty, 0.5 m is not less than 0.5 m, 0.512 m is more
    assert!(wing.warnings(100.0, 1.0).is_empty());
    assert!(wing.warnings(64.0, 10.0).is_empty());
    let said = wing.warnings(50.0, 8.0);
    assert!(said.len() == 1 && said[0].contains("0.5000 m, but 8 Hz at 50 m/s"), "{said:?}");
    (wing.root_chord_m, wing.tip_chord_m) = (1.0, 2.0);
    assert!((wing.longest_box_m() - 0.5).abs() < 1e-15);
    assert!((wing.largest_box_aspect_ratio() - 2.0).abs() < 1e-12);
    wing.boxes.chordwise = 6;
    assert!(wing.warnings(1e4, 1.0)[0].contains("3.00 times as wide"));
}

#[test]
fn another_lattice_keeps_control_surfaces_where_they_are() {
    let mut wing = trapezoid();
    wing.fairing = Some(Fairing { strips: 3, width_m: 0.3, camber: true });
    wing.controls = vec![control("a", (3, 4), 1), control("b", (7, 8), 2)];
    // marks at strips 0, 2, 4, 6, 8
    assert_eq!(wing.mesh(1.0, 1.0), Mesh { chordwise: 4, strips: vec![2; 4], fairing_strips: 3 });
    assert_eq!(wing.mesh(2.0, 2.0), Mesh { chordwise: 8, strips: vec![4; 4], fairing_strips: 6 });
    // 6 boxes along the chord put the hinge of a at 1.5 boxes: 8 is the next with both on edges
    assert_eq!(wing.mesh(1.5, 0.1), Mesh { chordwise: 8, strips: vec![1; 4], fairing_strips: 1 });
    let mut finer = wing.clone();
    finer.remesh(&Mesh { chordwise: 8, strips: vec![1, 3, 2, 4], fairing_strips: 5 }).expect("it fits");
    assert_eq!((finer.boxes.chordwise, finer.boxes.spanwise), (8, 10));
    assert!(finer.controls[0].strips == (2, 4) && finer.controls[0].chord_boxes == 2);
    assert!(finer.controls[1].strips == (7, 10) && finer.controls[1].chord_boxes == 4);
    assert_eq!(finer.fairing.as_ref().map(|fairing| fairing.strips), Some(5));
    let third = 1.0 / 3.0;
    let edges = [0.0, 1.0, 1.0 + third, 1.0 + 2.0 * third, 2.0, 2.5, 3.0, 3.25, 3.5, 3.75, 4.0];
    assert!(finer.strip_edges_m().iter().zip(edges).all(|(found, y)| (found - y).abs() < 1e-12));
    assert!(bulk(&finer, Mount::Tunnel).is_ok());
    let fails = |mesh: Mesh| wing.clone().remesh(&mesh).expect_err("it does not fit");
    let strips = |strips: &[usize]| Mesh { chordwise: 4, strips: strips.to_vec(), fairing_strips: 1 };
    assert!(fails(strips(&[1, 1, 1])).contains("strips has 3 numbers, expected 4 above zero"));
    assert!(fails(strips(&[1, 1, 1, 0])).contains("expected 4 above zero"));
    assert!(fails(Mesh { chordwise: 6, ..strips(&[1; 4]) }).contains("the hinge of a is on no edge"));
    assert_eq!(FIRST_AXIS_GRID, 1001);
}
