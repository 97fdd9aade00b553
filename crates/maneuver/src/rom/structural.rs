//! Structure and masses of a [`ReducedOrderModel`] with changes.

use super::{BALANCE, Change, PointMass, ReducedOrderModel};
use faer::{Mat, c64};

/// Structure and masses with changes.
pub(super) struct Structural {
    mass: Mat<f64>,
    damping: Mat<f64>,
    stiffness: Mat<f64>,
    /// Added to the unchanged wing's rows of the balance by modal accelerations, and by fields; of modes by fields.
    balance_by_modes: Mat<f64>,
    balance_by_fields: Mat<f64>,
    modal_by_fields: Mat<f64>,
    mass_factor: f64,
}

impl Structural {
    pub(super) fn new(rig: &ReducedOrderModel, change: &Change) -> Self {
        let m = rig.modes();
        let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
        let zeta = rig.damping_ratio * (1.0 + change.damping);
        let mut stiffness = Mat::from_fn(m, m, |i, j| unit(i, j) * rig.omega_rad_s[i].powi(2));
        if let Some(parts) = &rig.stiffness {
            stiffness += faer::Scale(change.bending) * &parts.bending;
            stiffness += faer::Scale(change.torsion) * &parts.torsion;
        } else {
            // nobody split it: all of it
            stiffness = faer::Scale(1.0 + change.bending) * stiffness;
        }
        let mut all = Self {
            mass: Mat::from_fn(m, m, |i, j| unit(i, j) * (1.0 + change.mass)),
            damping: Mat::from_fn(m, m, |i, j| unit(i, j) * 2.0 * zeta * rig.omega_rad_s[i]),
            stiffness,
            balance_by_modes: Mat::zeros(BALANCE, m),
            balance_by_fields: Mat::zeros(BALANCE, 3),
            modal_by_fields: Mat::zeros(m, 3),
            mass_factor: 1.0 + change.mass,
        };
        for point in &change.points {
            all.add(rig, point);
        }
        all
    }

    fn add(&mut self, rig: &ReducedOrderModel, point: &PointMass) {
        let zones = &rig.zones;
        if zones.is_empty() {
            return;
        }
        let about = zones.about(point.y_norm);
        let between =
            |of: &dyn Fn(usize) -> f64| about.iter().map(|&(zone, share)| share * of(zone)).sum::<f64>();
        let x = between(&|zone| zones.x_m[zone] + point.aft_over_c * zones.chord_m[zone]);
        let y = between(&|zone| zones.y_m[zone]);
        let shape: Vec<f64> =
            (0..rig.modes()).map(|mode| between(&|zone| rig.heights[(zone, mode)])).collect();
        let field = [0.0, 1.0, -(x - rig.pitch_axis_x_m)];
        let row = [1.0, y - rig.balance_m[1], -(x - rig.balance_m[0])];
        for i in 0..shape.len() {
            for j in 0..shape.len() {
                self.mass[(i, j)] += point.mass_kg * shape[i] * shape[j];
            }
            for (f, share) in field.iter().enumerate() {
                self.modal_by_fields[(i, f)] += point.mass_kg * shape[i] * share;
            }
        }
        for (r, arm) in row.iter().enumerate() {
            for (mode, height) in shape.iter().enumerate() {
                self.balance_by_modes[(r, mode)] -= point.mass_kg * arm * height;
            }
            for (f, share) in field.iter().enumerate() {
                self.balance_by_fields[(r, f)] += point.mass_kg * arm * share;
            }
        }
    }

    /// `s² M + s C + K - Z`.
    pub(super) fn dynamic(&self, s: c64, z: &Mat<c64>, m: usize) -> Mat<c64> {
        Mat::from_fn(m, m, |i, j| {
            s * s * self.mass[(i, j)] + s * self.damping[(i, j)] + self.stiffness[(i, j)] - z[(i, j)]
        })
    }

    /// Share of a field of acceleration in a row of modes and balance.
    pub(super) fn field(&self, rig: &ReducedOrderModel, row: usize, field: usize) -> f64 {
        let m = rig.modes();
        // what the truncated modes do under the field, in the air
        let air = rig.air[(row, rig.layout.field(field))];
        air + if row < m {
            rig.modal_fields[(row, field)] * self.mass_factor + self.modal_by_fields[(row, field)]
        } else {
            rig.inertia[(row - m, rig.layout.field(field))] * self.mass_factor
                + self.balance_by_fields[(row - m, field)]
        }
    }

    /// Balance by modes: air and momentum.
    pub(super) fn balance(&self, s: c64, rig: &ReducedOrderModel, z: &Mat<c64>) -> Mat<c64> {
        let (m, first) = (rig.modes(), rig.layout.modal_accelerations().start);
        Mat::from_fn(BALANCE, m, |row, mode| {
            let momentum =
                rig.inertia[(row, first + mode)] * self.mass_factor + self.balance_by_modes[(row, mode)];
            z[(m + row, mode)] + s * s * momentum
        })
    }

    /// What the tare takes off for the points.
    pub(super) fn points_tare(&self, row: usize, gravity_m_s2: f64) -> f64 {
        self.balance_by_fields[(row, 1)] * gravity_m_s2
    }
}
