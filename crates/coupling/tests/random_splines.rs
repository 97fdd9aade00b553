//! Laws of any spline, on axes, boxes and motions drawn at random: what moves rigidly is carried rigidly, work is the same on both
//! sides, and neither the frame nor the unit of length means anything.

use aero::{AeroBox, Lattice};
use coupling::Spline;
use faer::Mat;
use nalgebra::{Point3, Rotation3, Vector3};
use proptest::prelude::*;

/// An axis of nodes outwards, boxes anywhere about it.
#[derive(Debug, Clone)]
struct Case {
    axis: Vec<Point3<f64>>,
    lattice: Lattice,
}

/// A box with sides along x, as doublets and horseshoes need it: place, chord, width, sweep, slope.
fn panel(id: u32, [x, y, z, chord, width, sweep, slope]: [f64; 7]) -> AeroBox {
    let inner = Point3::new(x, y, z);
    let outer = Point3::new(x + sweep * width, y + width, z + slope * width);
    let aft = Vector3::new(chord, 0.0, 0.0);
    AeroBox { id, corners: [inner, inner + aft, outer + aft, outer] }
}

fn cases() -> impl Strategy<Value = Case> {
    let step = (-0.3..0.5, 0.1..0.6_f64, -0.3..0.3);
    let place = (-1.0..2.0, -0.5..4.0, -0.5..0.5, 0.05..0.5);
    let shape = (0.05..0.5_f64, -0.8..0.8_f64, -0.8..0.8_f64);
    let boxes = prop::collection::vec((place, shape), 1..6);
    (prop::collection::vec(step, 2..7), boxes).prop_map(|(steps, boxes)| {
        let mut axis = vec![Point3::origin()];
        for (x, y, z) in steps {
            axis.push(axis[axis.len() - 1] + Vector3::new(x, y, z));
        }
        let boxes = (1..).zip(boxes).map(|(id, ((x, y, z, chord), (width, sweep, slope)))| {
            panel(id, [x, y, z, chord, width, sweep, slope])
        });
        Case { axis, lattice: Lattice { boxes: boxes.collect(), surfaces: Vec::new() } }
    })
}

impl Case {
    fn splines(&self) -> [Spline; 2] {
        let nodes: Vec<usize> = (0..self.axis.len()).collect();
        [
            Spline::beam(&self.lattice, &self.axis, &nodes),
            Spline::nearest_node(&self.lattice, &self.axis, &nodes),
        ]
    }

    fn moved(&self, by: impl Fn(&Point3<f64>) -> Point3<f64>) -> Self {
        let mut other = self.clone();
        let corners = other.lattice.boxes.iter_mut().flat_map(|panel| panel.corners.iter_mut());
        for point in other.axis.iter_mut().chain(corners) {
            *point = by(point);
        }
        other
    }

    /// Six motions a node, waves along the axis, turned.
    fn waves(&self, turn: &Rotation3<f64>, phase: f64, length: f64) -> Mat<f64> {
        let mut motions = Mat::zeros(6 * self.axis.len(), 1);
        for node in 0..self.axis.len() {
            let wave = |k: usize| (phase + 1.3 * (6 * node + k) as f64).sin();
            let vectors =
                [Vector3::new(wave(0), wave(1), wave(2)) * length, Vector3::new(wave(3), wave(4), wave(5))];
            for (part, vector) in vectors.iter().enumerate() {
                let turned = turn * vector;
                for k in 0..3 {
                    motions[(6 * node + 3 * part + k, 0)] = turned[k];
                }
            }
        }
        motions
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_moves_rigidly_is_carried_rigidly(
        case in cases(),
        shift in (-1.0..1.0, -1.0..1.0, -1.0..1.0),
        turn in (-1.0..1.0, -1.0..1.0, -1.0..1.0),
    ) {
        let (shift, turn) = (Vector3::new(shift.0, shift.1, shift.2), Vector3::new(turn.0, turn.1, turn.2));
        let at = |point: &Point3<f64>| shift + turn.cross(&point.coords);
        let motions = Mat::from_fn(6 * case.axis.len(), 1, |row, _| {
            if row % 6 < 3 { at(&case.axis[row / 6])[row % 6] } else { turn[row % 6 - 3] }
        });
        for spline in case.splines() {
            let carried = spline.displace(motions.as_ref());
            for (index, panel) in case.lattice.boxes.iter().enumerate() {
                let heave = panel.normal().dot(&at(&panel.mid_point()));
                let pitch = panel.pitch_axis().dot(&turn);
                prop_assert!((carried[(2 * index, 0)] - heave).abs() < 1e-10);
                prop_assert!((carried[(2 * index + 1, 0)] - pitch).abs() < 1e-10);
            }
        }
    }

    #[test]
    fn work_is_the_same_on_both_sides_and_resultants_are_those_of_the_boxes(case in cases(), phase in 0.0..6.0_f64) {
        let motions = case.waves(&Rotation3::identity(), phase, 1.0);
        let on_boxes = Mat::from_fn(2 * case.lattice.len(), 1, |row, _| (phase + 0.7 * row as f64).cos());
        for spline in case.splines() {
            let loads = spline.loads(on_boxes.as_ref());
            let work = |a: &Mat<f64>, b: &Mat<f64>| (a.transpose() * b)[(0, 0)];
            let (boxes, grids) = (work(&on_boxes, &spline.displace(motions.as_ref())), work(&loads, &motions));
            prop_assert!((boxes - grids).abs() < 1e-10 * (1.0 + boxes.abs()));
            let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
            for (index, panel) in case.lattice.boxes.iter().enumerate() {
                let lift = panel.normal() * on_boxes[(2 * index, 0)];
                force += lift;
                moment += panel.mid_point().coords.cross(&lift) + panel.pitch_axis() * on_boxes[(2 * index + 1, 0)];
            }
            for (node, point) in case.axis.iter().enumerate() {
                let part = |first: usize| Vector3::from_fn(|k, _| loads[(6 * node + first + k, 0)]);
                force -= part(0);
                moment -= part(3) + point.coords.cross(&part(0));
            }
            prop_assert!(force.norm() < 1e-10 && moment.norm() < 1e-9, "left over: {force}, {moment}");
        }
    }

    #[test]
    fn frame_and_unit_mean_nothing(case in cases(), roll in -3.0..3.0_f64, unit in 0.01..40.0_f64, phase in 0.0..6.0_f64) {
        let turn = Rotation3::from_axis_angle(&Vector3::x_axis(), roll);
        let there = case.moved(|p| (turn * p + Vector3::new(1.0, -2.0, 0.5)) * unit);
        let own = case.waves(&Rotation3::identity(), phase, 1.0);
        let other = there.waves(&turn, phase, unit);
        for (here, there) in case.splines().iter().zip(there.splines()) {
            let (a, b) = (here.displace(own.as_ref()), there.displace(other.as_ref()));
            for row in 0..a.nrows() {
                let scale = if row % 2 == 0 { unit } else { 1.0 };
                prop_assert!((a[(row, 0)] * scale - b[(row, 0)]).abs() < 1e-9 * scale.max(1.0) * 10.0);
            }
        }
    }
}
