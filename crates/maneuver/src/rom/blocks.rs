//! The air's forces of a [`ReducedOrderModel`] with changes, sorted by what multiplies functions of s.

use super::{Change, ReducedOrderModel};
use faer::{Mat, c64};

/// The air's forces with changes, in blocks that multiply functions of s.
pub(super) struct Blocks {
    /// (rows times motions) by functions: 1, s, s², then p/(p + g) of both families.
    pub(super) by: Mat<f64>,
    pub(super) rows: usize,
}

impl ReducedOrderModel {
    /// Modes and balance by the layout's columns with the factors of the zones.
    pub(super) fn zone_sum(&self, change: &Change) -> Mat<f64> {
        let mut total = self.air.clone();
        if change.by_zone() {
            for zone in 0..self.zones.len() {
                let (force, aft) = (change.zone_force[zone], change.zone_aft_over_c[zone]);
                if force != 0.0 {
                    total += faer::Scale(force) * &self.zone_air[zone];
                }
                if aft != 0.0 {
                    total -= faer::Scale(aft) * &self.zone_moment[zone];
                }
            }
        }
        total
    }

    pub(super) fn changed(&self, change: &Change) -> Blocks {
        let mut changed = self.blocks(&self.zone_sum(change), change);
        if change.unsteady != 0.0 {
            changed.by += faer::Scale(change.unsteady) * &self.unsteady().by;
        }
        changed
    }

    /// All that the unchanged air does beyond the steady answer to the momentary incidence.
    fn unsteady(&self) -> Blocks {
        let Blocks { mut by, rows } = self.blocks(&self.air, &Change::none(self.zones.len()));
        for motion in 0..self.layout.motions() {
            for row in 0..rows {
                by[(motion * rows + row, 0)] = 0.0;
                by[(motion * rows + row, 1)] -= self.quasi_steady_rate[(row, motion)];
            }
        }
        Blocks { by, rows }
    }

    pub(super) fn changed_lift(&self, change: &Change) -> Blocks {
        let factor = |zone: usize| 1.0 + change.zone_force[zone];
        let lift = Mat::from_fn(self.lift.nrows(), self.lift.ncols(), |zone, column| {
            factor(zone) * self.lift[(zone, column)]
        });
        self.blocks(&lift, change)
    }

    /// Columns of the layout sorted by motion and function of s.
    pub(super) fn blocks(&self, total: &Mat<f64>, change: &Change) -> Blocks {
        let (layout, rows) = (self.layout, total.nrows());
        let functions = 3 + layout.poles[0] + layout.poles[1];
        let mut by = Mat::zeros(rows * layout.motions(), functions);
        let first_control = layout.modes + 1;
        let factor = |motion: usize| {
            let slope = if motion < first_control { 1.0 + change.lift_slope } else { 1.0 };
            slope * (1.0 + change.pressure)
        };
        let mut put = |motion: usize, function: usize, column: usize| {
            for row in 0..rows {
                by[(motion * rows + row, function)] = factor(motion) * total[(row, column)];
            }
        };
        for motion in 0..layout.motions() {
            for derivative in 0..3 {
                put(motion, derivative, layout.motion(derivative).start + motion);
            }
        }
        for (lag, (family, pole, motion)) in layout.every_lag().enumerate() {
            put(motion, 3 + family * layout.poles[0] + pole, layout.first_lag() + lag);
        }
        Blocks { by, rows }
    }

    /// The functions of s at all frequencies: real parts, then imaginary parts.
    pub(super) fn weights(&self, omegas_rad_s: &[f64]) -> Mat<f64> {
        let n = omegas_rad_s.len();
        let poles: Vec<f64> = self.poles_per_m.iter().flatten().map(|pole| pole * self.flow.v_m_s).collect();
        Mat::from_fn(3 + poles.len(), 2 * n, |function, column| {
            let (omega, imaginary) = (omegas_rad_s[column % n], column >= n);
            match (function, imaginary) {
                (0, false) => 1.0,
                (0 | 2, true) | (1, false) => 0.0,
                (1, true) => omega,
                (2, false) => -omega * omega,
                (lag, _) => {
                    let g = poles[lag - 3];
                    let scale = omega * omega + g * g;
                    if scale == 0.0 {
                        0.0
                    } else if imaginary {
                        omega * g / scale
                    } else {
                        omega * omega / scale
                    }
                }
            }
        })
    }

    /// Rows by motions at one of the frequencies.
    pub(super) fn at(&self, blocks: &Blocks, values: &Mat<f64>, k: usize) -> Mat<c64> {
        let n = values.ncols() / 2;
        Mat::from_fn(blocks.rows, self.layout.motions(), |row, motion| {
            let place = motion * blocks.rows + row;
            c64::new(values[(place, k)], values[(place, n + k)])
        })
    }
}
