//! How loads on boxes answer motions of the boxes, all of it: pressures by incidences and by the lattice's own change, directions
//! of forces. Seen from the side of the loads, for adjoints.

use super::air::{Loaded, Solved, chord, directions};
use aero::{AeroBox, AeroError, Lattice, influence_by_motion};
use faer::Mat;
use nalgebra::{Rotation3, Vector3};

/// Forces and moments about midpoints of boxes, or what they are weighed by: displacements and spins.
pub(super) type OnBoxes = Vec<[Vector3<f64>; 2]>;

/// The answer about a solved state.
pub(super) struct Answer<'a> {
    solved: &'a Solved<'a>,
    loaded: &'a Loaded,
    /// Boxes in the axes of the lattice, x along the wake.
    boxes: Lattice,
    to_wake: Rotation3<f64>,
    /// Direction of the stream in those axes.
    stream: Vector3<f64>,
    /// Incidences that the pressures need, by motions of the boxes.
    by_motion: Mat<f64>,
    /// Lift and moment of a unit pressure coefficient, corrections included.
    unit: Mat<f64>,
}

impl<'a> Answer<'a> {
    /// About a state that was solved and its loads.
    ///
    /// # Errors
    /// Those of the lattice.
    pub(super) fn new(solved: &'a Solved<'a>, loaded: &'a Loaded) -> Result<Self, AeroError> {
        let (air, elastic) = (&solved.air, solved.air.elastic);
        let boxes = solved.turned_boxes(solved.state());
        let of_lattice = |(j, cp): (usize, &f64)| cp * air.own_chord_m(j) / solved.chord_m[j];
        let cp: Vec<f64> = loaded.cp.iter().enumerate().map(of_lattice).collect();
        let by_motion = influence_by_motion(&boxes, &air.boxes.seams, elastic.plane, elastic.mach, &cp)?;
        let ones = Mat::from_fn(cp.len(), 1, |_, _| 1.0);
        let unit = elastic.integration.corrected(&air.corrections).of_pressures(air.q_pa, ones.as_ref());
        Ok(Self { solved, loaded, boxes, to_wake: air.to_wake(), stream: air.stream(), by_motion, unit })
    }

    /// Derivatives by displacements (1/m) and spins (1/rad) of the boxes of a weighted sum of the loads on them; all in the
    /// structure's axes.
    pub(super) fn transposed(&self, weights: &OnBoxes) -> OnBoxes {
        let (solved, count) = (self.solved, weights.len());
        let mut by_spin = vec![Vector3::zeros(); count];
        let mut by_pressure = vec![0.0; count];
        for (j, panel) in self.boxes.boxes.iter().enumerate() {
            let weights = weights[j].map(|weight| self.to_wake * weight);
            let [force, moment] = directions(panel, &self.stream);
            let weight = self.unit[(2 * j, 0)] * weights[0].dot(&force)
                + self.unit[(2 * j + 1, 0)] * weights[1].dot(&moment);
            // The pressure of the lattice counts by the chord along the wake of now.
            let per_chord = weight / solved.air.own_chord_m(j);
            by_pressure[j] = per_chord * solved.chord_m[j];
            let of_lattice = self.loaded.cp[j] * solved.air.own_chord_m(j) / solved.chord_m[j];
            by_spin[j] = chord_vector(panel).cross(&Vector3::x()) * (per_chord * of_lattice)
                + self.of_directions(j, panel, &weights);
        }
        let by_incidence = solved.aero.weights_of_incidences(&by_pressure);
        let own = self.boxes.boxes.iter().zip(&solved.air.incidence).zip(&by_incidence);
        for (by_spin, ((panel, incidence), weight)) in by_spin.iter_mut().zip(own) {
            let along = panel.normal() + chord(panel) * *incidence;
            *by_spin += along.cross(&self.stream) * *weight;
        }
        let needed = Mat::from_fn(count, 1, |i, _| by_incidence[i]);
        let needed = &self.by_motion * &needed;
        let back = self.to_wake.inverse();
        let one = |(j, by_spin): (usize, &Vector3<f64>)| {
            let of = |first: usize| Vector3::from_fn(|i, _| needed[(6 * j + first + i, 0)]);
            [back * -of(0), back * (by_spin - of(3))]
        };
        by_spin.iter().enumerate().map(one).collect()
    }

    /// By the spin of a box: its lift and moment turn with its bound vortex and its chord.
    fn of_directions(&self, at: usize, panel: &AeroBox, weights: &[Vector3<f64>; 2]) -> Vector3<f64> {
        let [lift, moment] = [0, 1].map(|part| self.loaded.box_loads.values[2 * at + part]);
        let [from, to] = panel.bound_vortex();
        let (bound, chord) = (to - from, chord(panel));
        let across = self.stream.cross(&bound);
        let direction = across.normalize();
        let by_direction = weights[0] * lift + chord.cross(&weights[1]) * moment;
        let normal = by_direction - direction * direction.dot(&by_direction);
        bound.cross(&normal.cross(&self.stream)) / across.norm()
            + chord.cross(&weights[1].cross(&direction)) * moment
    }
}

/// Mean chord of a box, aft, m.
fn chord_vector(panel: &AeroBox) -> Vector3<f64> {
    let [c1, c2, c3, c4] = &panel.corners;
    ((c2 - c1) + (c3 - c4)) / 2.0
}
