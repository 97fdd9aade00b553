//! A weighted mean at a state: displacement and spin of its reference by the motions of its group.

use crate::nonlinear::frame::{Group, spin_of_rotation};
use nalgebra::{Matrix3, Rotation3, Vector3};

/// What one member gives the reference: displacement and spin by its displacement, and by its spin if that counts.
pub(super) struct Blocks {
    pub(super) by_place: [Matrix3<f64>; 2],
    pub(super) by_spin: Option<[Matrix3<f64>; 2]>,
}

/// Of all members, with their places and rotations and the place of the reference.
pub(super) fn blocks(
    group: &Group,
    places: &[Vector3<f64>],
    rotations: &[Rotation3<f64>],
    reference: &Vector3<f64>,
) -> Vec<Blocks> {
    let middle = group.middle(places);
    let arms: Vec<_> = places.iter().map(|place| place - middle).collect();
    let fit = group.fit(&arms, rotations);
    let total: f64 = group.places.iter().sum();
    let lever = (reference - middle).cross_matrix();
    let spins = |block: Matrix3<f64>| fit.q * fit.inverse * block * fit.q.transpose();
    let one = |(at, rotation): (usize, &Rotation3<f64>)| {
        let by_place = spins(group.arms[at].cross_matrix() * group.weight(at));
        let moved = Matrix3::identity() * (group.places[at] / total) - lever * by_place;
        let weight = group.rotations[at];
        let by_spin = (weight > 0.0).then(|| {
            let turn = spins(spin_of_rotation(&(fit.q.transpose() * rotation.matrix())) * weight);
            [-lever * turn, turn]
        });
        Blocks { by_place: [moved, by_place], by_spin }
    };
    rotations.iter().enumerate().map(one).collect()
}

impl Blocks {
    /// Force and moment that the member gets of those on the reference.
    pub(super) fn handed(&self, [force, moment]: &[Vector3<f64>; 2]) -> [Vector3<f64>; 2] {
        let back = |[moved, spun]: &[Matrix3<f64>; 2]| moved.tr_mul(force) + spun.tr_mul(moment);
        [back(&self.by_place), self.by_spin.as_ref().map_or_else(Vector3::zeros, back)]
    }
}
