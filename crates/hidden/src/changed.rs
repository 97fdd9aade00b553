//! Stiffness and mass of a case: the true structure's with what jitter and effects change.

use crate::modal::Masses;
use crate::physics::Physics;
use crate::system::Parts;
use faer::Mat;

impl Parts {
    /// Phiᵀ K Phi of this case.
    pub(crate) fn stiffness(&self, physics: &Physics) -> Mat<f64> {
        let [bending, torsion] = &self.structure.stiffness_by;
        let modes = self.structure.omega_rad_s.len();
        Mat::from_fn(modes, modes, |i, j| {
            let base = if i == j { self.structure.omega_rad_s[i].powi(2) } else { 0.0 };
            base + physics.bending.root * bending[0][(i, j)]
                + physics.bending.tip * bending[1][(i, j)]
                + physics.torsion.root * torsion[0][(i, j)]
                + physics.torsion.tip * torsion[1][(i, j)]
        })
    }

    /// The masses of this case.
    pub(crate) fn masses(&self, physics: &Physics) -> Masses {
        let structure = &self.structure;
        let modes = structure.omega_rad_s.len();
        let mut masses = structure.masses.clone();
        masses.add(physics.mass.root, &structure.masses_by[0]);
        masses.add(physics.mass.tip, &structure.masses_by[1]);
        masses.add(physics.mass_aft_over_c, &structure.masses_by_aft);
        for point in &physics.point_masses {
            let distance = |strip: &usize| (self.strips.eta[*strip] - point.eta).abs();
            let Some(strip) = (0..self.strips.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)))
            else {
                continue;
            };
            let (y_m, x_m) = (
                self.strips.y_m[strip],
                self.strips.x_quarter_m[strip] + (point.x_over_c - 0.25) * self.strips.chord_m[strip],
            );
            let aft_m = x_m - self.strips.x_quarter_m[strip];
            let z =
                |mode: usize| self.strips.height[(strip, mode)] - aft_m * self.strips.twist[(strip, mode)];
            let by_field = [0.0, 1.0, -(x_m - structure.pitch_axis_x_m)];
            let by_load =
                [1.0, y_m - structure.balance.y, -(x_m - structure.balance.x)].map(|arm| arm * point.mass_kg);
            for i in 0..modes {
                for j in 0..modes {
                    masses.modal[(i, j)] += point.mass_kg * z(i) * z(j);
                }
                for (field, by) in by_field.iter().enumerate() {
                    masses.fields[(i, field)] += point.mass_kg * z(i) * by;
                }
                for (row, load) in by_load.iter().enumerate() {
                    masses.loads_by_modes[(row, i)] += load * z(i);
                }
            }
            for (row, load) in by_load.iter().enumerate() {
                for (field, by) in by_field.iter().enumerate() {
                    masses.loads_by_fields[(row, field)] += load * by;
                }
            }
        }
        masses
    }
}
