//! What splines of plates and beams must do with motions whose answers are closed forms.

use super::splines;
use aero::{Lattice, StreamAxes};
use nalgebra::{Matrix3, Point3, Rotation3, Vector3};
use nastran::parse_deck;
use std::f64::consts::PI;
use std::fmt::Write as _;

/// Four boxes on a swept, tapered panel of a size.
fn panel(size: f64) -> String {
    format!(
        "CAERO1,101,1,,2,2,,,1\n,0.,0.,0.,{:?},{:?},{:?},0.,{:?}\nPAERO1,1\nSET1,9,1,THRU,4\n",
        size,
        0.7 * size,
        2.0 * size,
        0.6 * size
    )
}

/// Heave and pitch of each box, by the displacement (and rotation) of each of four grids.
fn motion(cards: &str, grids: &[Point3<f64>; 4], moved: &[[f64; 6]; 4]) -> (Lattice, Vec<f64>) {
    let mut deck = cards.to_owned();
    for (i, at) in grids.iter().enumerate() {
        let _ = writeln!(deck, "GRID,{},,{:.12},{:.12},{:.12}", i + 1, at.x, at.y, at.z);
    }
    let bulk = parse_deck("t.bdf", &deck).expect("a deck");
    let lattice = Lattice::from_bulk(&bulk).expect("boxes");
    let splined = splines(&bulk, &lattice, &[1, 2, 3, 4], grids, &StreamAxes::basic()).expect("a spline");
    assert!(splined.loose.is_empty());
    let value = |row: &Vec<(usize, f64)>| row.iter().map(|(dof, by)| by * moved[dof / 6][dof % 6]).sum();
    let found = splined.spline.rows().iter().map(value).collect();
    (lattice, found)
}

/// Four grids around the panel.
const AROUND: [[f64; 2]; 4] = [[0.2, 0.1], [1.3, 0.4], [0.5, 1.7], [1.6, 2.2]];

fn around(size: f64) -> [Point3<f64>; 4] {
    AROUND.map(|[x, y]| Point3::new(size * x, size * y, 0.0))
}

/// A beam's system whose y axis is swept aft, with bending and torsion attached as said.
fn swept(attached: &str) -> String {
    format!("CORD2R,7,,.3,.1,0.,.3,.1,1.\n,1.1,-.3,0.\nSPLINE2,20,101,101,104,9,0.,.8,7\n,{attached}\n")
}

#[test]
fn rigid_motions_of_the_grids_are_rigid_motions_of_the_boxes() {
    let (shift, turn) = (Vector3::new(0.4, -0.2, 0.3), Vector3::new(0.05, -0.07, 0.11));
    let grids = around(1.0);
    let moved = grids.map(|at| {
        let u = shift + turn.cross(&at.coords);
        [u.x, u.y, u.z, turn.x, turn.y, turn.z]
    });
    for spline in ["SPLINE1,20,101,101,104,9\n".to_owned(), swept("-1.,-1."), swept("0.,0."), swept("0.,.3")]
    {
        let (lattice, found) = motion(&(panel(1.0) + &spline), &grids, &moved);
        for (j, of) in lattice.boxes.iter().enumerate() {
            let heave = (shift + turn.cross(&of.mid_point().coords)).z;
            let pitch = turn.dot(&of.pitch_axis());
            assert!((found[2 * j] - heave).abs() < 1e-9, "{spline} heave of box {j}: {found:?} {heave}");
            assert!((found[2 * j + 1] - pitch).abs() < 1e-9, "{spline} pitch of box {j}: {found:?} {pitch}");
        }
    }
}

/// Where the beam runs, and the axes of its system as columns.
fn beam() -> (Point3<f64>, Matrix3<f64>) {
    let x = Vector3::new(0.8, -0.4, 0.0).normalize();
    (Point3::new(0.3, 0.1, 0.0), Matrix3::from_columns(&[x, Vector3::z().cross(&x), Vector3::z()]))
}

#[test]
fn between_grids_with_their_slopes_a_beam_bends_as_hermites_cubic_and_twists_as_a_rod() {
    let (origin, axes) = beam();
    let places = [-0.2, 2.4];
    let at = |y: f64, x: f64| origin + axes.column(1) * y + axes.column(0) * x;
    // the inner two bound the boxes, two more lie beyond
    let grids = [at(places[0], 0.0), at(places[1], 0.0), at(places[0] - 1.0, 0.0), at(places[1] + 1.0, 0.0)];
    let cubic = |y: f64| 0.3 - 0.2 * y + 0.15 * y * y - 0.04 * y * y * y;
    let slope = |y: f64| -0.2 + 0.3 * y - 0.12 * y * y;
    let twist = |y: f64| 0.1 + 0.05 * y;
    let moved = [places[0], places[1], places[0] - 1.0, places[1] + 1.0].map(|y| {
        let turn = axes.column(0) * slope(y) + axes.column(1) * twist(y);
        [0.0, 0.0, cubic(y), turn.x, turn.y, turn.z]
    });
    let (lattice, found) = motion(&(panel(1.0) + &swept("0.,0.")), &grids, &moved);
    for (j, of) in lattice.boxes.iter().enumerate() {
        let local = axes.transpose() * (of.mid_point() - origin);
        let axis = axes.transpose() * of.pitch_axis();
        assert!(local.y > places[0] && local.y < places[1], "between the inner grids");
        let heave = cubic(local.y) - local.x * twist(local.y);
        let pitch = slope(local.y) * axis.x + twist(local.y) * axis.y;
        assert!((found[2 * j] - heave).abs() < 1e-8, "heave of box {j}: {found:?} {heave}");
        assert!((found[2 * j + 1] - pitch).abs() < 1e-8, "pitch of box {j}: {found:?} {pitch}");
    }
}

#[test]
fn grids_ahead_and_behind_a_beam_twist_it_linearly_from_one_end_to_the_other() {
    let (origin, axes) = beam();
    let at = |y: f64, x: f64| origin + axes.column(1) * y + axes.column(0) * x;
    let grids = [at(-0.1, -0.3), at(-0.1, 0.5), at(2.3, -0.4), at(2.3, 0.2)];
    let (heave, twist) = (|y: f64| 0.2 + 0.3 * y, |y: f64| -0.1 + 0.2 * y);
    let moved = [(-0.1, -0.3), (-0.1, 0.5), (2.3, -0.4), (2.3, 0.2)]
        .map(|(y, x)| [0.0, 0.0, heave(y) - x * twist(y), 0.0, 0.0, 0.0]);
    let (lattice, found) = motion(&(panel(1.0) + &swept("-1.,-1.")), &grids, &moved);
    for (j, of) in lattice.boxes.iter().enumerate() {
        let local = axes.transpose() * (of.mid_point() - origin);
        let axis = axes.transpose() * of.pitch_axis();
        let law = [heave(local.y) - local.x * twist(local.y), 0.3 * axis.x + twist(local.y) * axis.y];
        assert!((found[2 * j] - law[0]).abs() < 1e-9, "box {j}: {found:?} {law:?}");
        assert!((found[2 * j + 1] - law[1]).abs() < 1e-9, "box {j}: {found:?} {law:?}");
    }
}

#[test]
fn a_plate_over_a_square_twisted_at_its_corners_has_forces_that_alternate() {
    // by symmetry F, -F, F, -F; r² = 4 a² to two corners and 8 a² to one: w = F a² (8 ln 8 - 2 4 ln 4) = 8 F a² ln 2,
    // and 16 pi DZ F more
    let (a, centre) = (0.8_f64, [0.9, 1.1]);
    let corners = [[-a, -a], [a, -a], [a, a], [-a, a]];
    let grids = corners.map(|[x, y]| Point3::new(centre[0] + x, centre[1] + y, 0.0));
    let sign = [1.0, -1.0, 1.0, -1.0];
    let moved = sign.map(|up| [0.0, 0.0, up, 0.0, 0.0, 0.0]);
    for flexibility in [0.0, 0.05] {
        let card = format!("SPLINE1,20,101,101,104,9,{flexibility:?}\n");
        let (lattice, found) = motion(&(panel(1.0) + &card), &grids, &moved);
        let force = 1.0 / (8.0 * a * a * 2.0_f64.ln() + 16.0 * PI * flexibility);
        let heave = |x: f64, y: f64| -> f64 {
            let of = |(at, sign): (&Point3<f64>, f64)| {
                let r2 = (x - at.x).powi(2) + (y - at.y).powi(2);
                sign * force * r2 * r2.ln()
            };
            grids.iter().zip(sign).map(of).sum()
        };
        for (j, of) in lattice.boxes.iter().enumerate() {
            let (at, h) = (of.mid_point(), 1e-5);
            let slope = (heave(at.x + h, at.y) - heave(at.x - h, at.y)) / (2.0 * h);
            assert!((found[2 * j] - heave(at.x, at.y)).abs() < 1e-9, "DZ {flexibility}, box {j}: {found:?}");
            assert!((found[2 * j + 1] + slope).abs() < 1e-8, "nose up is down along the stream: {found:?}");
        }
    }
}

#[test]
fn a_plate_of_any_size_and_place_moves_alike() {
    let moved = [0.3, -0.5, 0.2, 0.9].map(|up| [0.0, 0.0, up, 0.0, 0.0, 0.0]);
    let one = motion(&(panel(1.0) + "SPLINE1,20,101,101,104,9,.02\n"), &around(1.0), &moved).1;
    let large = motion(&(panel(50.0) + "SPLINE1,20,101,101,104,9,50.\n"), &around(50.0), &moved).1;
    for j in 0..4 {
        assert!((one[2 * j] - large[2 * j]).abs() < 1e-9, "{one:?} {large:?}");
        assert!((one[2 * j + 1] - 50.0 * large[2 * j + 1]).abs() < 1e-9, "{one:?} {large:?}");
    }
    assert!(one.iter().all(|value| value.abs() > 1e-3), "all of them move: {one:?}");
}

#[test]
fn a_plate_s_boxes_are_the_rectangle_with_two_at_its_corners_and_grids_on_a_line_are_refused() {
    let deck = |card: &str, lined: bool| {
        let y = |i: usize, y: f64| if lined { i as f64 } else { y };
        let mut deck =
            format!("CAERO1,101,1,,3,3,,,1\n,0.,0.,0.,1.,0.,2.,0.,1.\nPAERO1,1\nSET1,9,1,THRU,4\n{card}\n");
        for (i, [x, across]) in AROUND.iter().enumerate() {
            let x = if lined { 2.0 * i as f64 } else { *x };
            let _ = writeln!(deck, "GRID,{},,{x:?},{:?},0.", i + 1, y(i, *across));
        }
        let bulk = parse_deck("t.bdf", &deck).expect("a deck");
        let lattice = Lattice::from_bulk(&bulk).expect("boxes");
        let points: Vec<Point3<f64>> = bulk.grids.values().map(|grid| grid.xyz).collect();
        splines(&bulk, &lattice, &[1, 2, 3, 4], &points, &StreamAxes::basic()).map(|found| found.loose)
    };
    // 101 102 103 along the first strip's chord, then 104 to 106, 107 to 109
    assert_eq!(deck("SPLINE1,20,101,102,106,9", false).expect("boxes"), vec![101, 104, 107, 108, 109]);
    assert_eq!(deck("SPLINE1,20,101,103,105,9", false).expect("boxes"), vec![101, 104, 107, 108, 109]);
    assert_eq!(deck("SPLINE1,20,101,101,109,9", false).expect("boxes"), Vec::<u32>::new());
    for (card, why) in
        [("SPLINE1,20,101,101,110,9", "no box 110"), ("SPLINE1,20,101,100,101,9", "no box 100")]
    {
        let refused = deck(card, false).expect_err("no such box").to_string();
        assert!(refused.contains(why), "{refused}");
    }
    let lined = deck("SPLINE1,20,101,101,109,9", true).expect_err("a line").to_string();
    assert!(lined.contains("do not determine a plate"), "{lined}");
}

#[test]
fn a_deck_turned_with_its_stream_has_the_same_splines() {
    let turn = Rotation3::new(Vector3::new(0.4, -0.8, 1.1));
    let stream = StreamAxes { axes: turn.into_inner(), origin: Point3::new(1.0, -2.0, 0.5) };
    assert_eq!(super::in_basic_axes(vec![(2, 1.5)], &StreamAxes::basic()), vec![(2, 1.5)]);
    // what is seen along z and about y of node 1 is the part of a motion along these axes
    let row = super::in_basic_axes(vec![(8, 2.0), (10, -3.0)], &stream);
    let (u, about) = (Vector3::new(0.3, 0.7, -0.2), Vector3::new(-0.1, 0.5, 0.9));
    let all = [u.x, u.y, u.z, about.x, about.y, about.z];
    let found: f64 = row.iter().map(|(dof, by)| by * all[dof - 6]).sum();
    let law = 2.0 * (turn.inverse() * u).z - 3.0 * (turn.inverse() * about).y;
    assert!((found - law).abs() < 1e-14, "{found} {law}");
}
