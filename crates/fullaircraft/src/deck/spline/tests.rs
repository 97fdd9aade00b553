//! Attachments that give way (DZ): as they do so ever more easily, the spline becomes the rigid motion that fits the grids best.

use super::splines;
use aero::{Lattice, StreamAxes};
use nalgebra::{DMatrix, DVector, Point3};
use nastran::parse_deck;
use std::fmt::Write as _;

/// Places of five grids, and their heights.
const GRIDS: [[f64; 3]; 5] =
    [[0.1, 0.2, 0.3], [0.9, 0.4, -0.2], [0.4, 1.1, 0.5], [0.8, 1.9, 0.1], [0.2, 1.6, -0.4]];

/// Heave and pitch of four boxes of 0.5 m by 1 m, by the spline's card, with the grids at `places`.
fn motion(card: &str, places: &[[f64; 3]]) -> (Lattice, Vec<f64>) {
    let mut deck =
        format!("CAERO1,101,1,,2,2,,,1\n,0.,0.,0.,1.,0.,2.,0.,1.\nPAERO1,1\nSET1,9,1,THRU,5\n{card}\n");
    for (i, [x, y, _]) in places.iter().enumerate() {
        let _ = writeln!(deck, "GRID,{},,{x:?},{y:?},0.", i + 1);
    }
    let bulk = parse_deck("t.bdf", &deck).expect("a deck");
    let lattice = Lattice::from_bulk(&bulk).expect("boxes");
    let points: Vec<Point3<f64>> = places.iter().map(|[x, y, _]| Point3::new(*x, *y, 0.0)).collect();
    let splined =
        splines(&bulk, &lattice, &[1, 2, 3, 4, 5], &points, &StreamAxes::basic()).expect("a spline");
    let height = |dof: usize| if dof % 6 == 2 { places[dof / 6][2] } else { 0.0 };
    let value = |row: &Vec<(usize, f64)>| row.iter().map(|(dof, weight)| weight * height(*dof)).sum();
    (lattice, splined.spline.rows().iter().map(value).collect())
}

/// The plane a + b x + c y nearest to points, in the sense of least squares; b is left out on request.
fn nearest(places: &[[f64; 3]], along_x: bool) -> [f64; 3] {
    let columns = if along_x { 3 } else { 2 };
    let a = DMatrix::from_fn(places.len(), columns, |i, j| match (j, along_x) {
        (0, _) => 1.0,
        (1, true) => places[i][0],
        _ => places[i][1],
    });
    let z = DVector::from_fn(places.len(), |i, _| places[i][2]);
    let fit = (a.transpose() * &a).try_inverse().expect("apart") * a.transpose() * z;
    if along_x { [fit[0], fit[1], fit[2]] } else { [fit[0], 0.0, fit[1]] }
}

#[test]
fn a_plate_that_is_hardly_attached_is_the_plane_nearest_to_the_grids() {
    let (lattice, found) = motion("SPLINE1,20,101,101,104,9,1.+9", &GRIDS);
    let [a, b, c] = nearest(&GRIDS, true);
    for (j, panel) in lattice.boxes.iter().enumerate() {
        let mid = panel.mid_point();
        assert!((found[2 * j] - (a + b * mid.x + c * mid.y)).abs() < 1e-6, "{found:?}");
        assert!((found[2 * j + 1] + b).abs() < 1e-6, "{found:?}");
    }
    let rigid = motion("SPLINE1,20,101,101,104,9", &GRIDS).1;
    assert!((rigid[0] - found[0]).abs() > 0.01, "without DZ the plate goes through the grids");
}

#[test]
fn a_beam_that_is_hardly_attached_is_the_line_nearest_to_the_grids() {
    let on_axis = GRIDS.map(|[_, y, z]| [0.5, y, z]);
    let card = "CORD2R,7,,.5,0.,0.,.5,0.,1.\n,1.5,0.,0.\nSPLINE2,20,101,101,104,9,1.+9,1.,7\n,-1.,0.";
    let (lattice, found) = motion(card, &on_axis);
    let [a, _, c] = nearest(&on_axis, false);
    for (j, panel) in lattice.boxes.iter().enumerate() {
        assert!((found[2 * j] - (a + c * panel.mid_point().y)).abs() < 1e-6, "{found:?}");
        assert!(found[2 * j + 1].abs() < 1e-9, "no grid turns: {found:?}");
    }
}
