//! What a corrected wing would show at places without sensors, and how that hangs on corrections and flexibility.

use crate::case::SteadyCase;
use crate::steady::SteadyOperator;
use faer::Mat;
use faer::linalg::solvers::Solve;

/// Readings of one case and their derivatives; the last reading is the height of the tip.
#[derive(Debug, Clone)]
pub struct Readings {
    /// The readings.
    pub values: Vec<f64>,
    /// Readings by boxes: by the force factor of each correctable box.
    pub by_force: Mat<f64>,
    /// By the moment factor.
    pub by_moment: Mat<f64>,
    /// By the pressure offset f_e/q.
    pub by_offset: Mat<f64>,
    /// By the logarithm of the flexibility, all of it.
    pub by_flexibility: Vec<f64>,
}

impl SteadyOperator<'_> {
    /// Reads a case: rows on the box loads (two columns a box), and the tip's height above its wind-off place in m.
    ///
    /// With `A = I - q F H` and `A u = F (...)` (design equations of [`crate::steady`]), the whole right side grows with the
    /// flexibility, so `du/d ln F = A⁻¹ u`.
    pub fn readings(&self, case: &SteadyCase, rows: &Mat<f64>) -> Readings {
        let (wing, q_pa) = (self.wing, self.flow.dynamic_pressure_pa());
        let lambda = self.adjoint_of(rows.as_ref());
        let state = self.solve(std::slice::from_ref(case)).swap_remove(0);
        let by = self.loads().derivatives(q_pa, lambda.as_ref(), &state.cp, &wing.correctable.places);
        let mut values: Vec<f64> = (0..rows.nrows())
            .map(|r| state.box_loads.values.iter().enumerate().map(|(k, load)| rows[(r, k)] * load).sum())
            .collect();
        values.push(state.tip_z_m);
        Readings {
            values,
            by_force: by.by_force,
            by_moment: by.by_moment,
            by_offset: by.by_offset,
            by_flexibility: self.by_flexibility(&state.displacement, state.tip_z_m, rows),
        }
    }

    fn by_flexibility(&self, displacement: &[f64], tip_z_m: f64, rows: &Mat<f64>) -> Vec<f64> {
        let (Some(structure), Some(factor)) = (&self.wing.supported, &self.factor) else {
            return vec![0.0; rows.nrows() + 1];
        };
        let u = Mat::from_fn(displacement.len(), 1, |i, _| displacement[i]);
        let moved = factor.solve(&u);
        let cp = &self.wing.cp_displacement * &moved;
        let loads = self.loads().of_pressures(self.flow.dynamic_pressure_pa(), cp.as_ref());
        let read = rows * &loads;
        // the wind-off sag, which the tip's height is counted from, grows with the flexibility as well
        let wind_off_m = displacement[structure.tip_z] - tip_z_m;
        (0..rows.nrows()).map(|r| read[(r, 0)]).chain([moved[(structure.tip_z, 0)] - wind_off_m]).collect()
    }
}
