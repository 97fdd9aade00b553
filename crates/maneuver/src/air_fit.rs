//! How well the rig's rational air fits the doublet lattice, by load and by motion.

use crate::air::{worst_by_column, worst_by_row};
use crate::rig::Rig;

/// Largest errors at the table's own frequencies, each entry's over its largest modulus there, shares of one.
#[derive(Debug, Clone, PartialEq)]
pub struct AirFit {
    /// The table's frequencies, omega c/(2 V) with the mean chord c.
    pub reduced_frequencies: Vec<f64>,
    /// The poles, in the same measure.
    pub poles: Vec<f64>,
    /// By generalised force of each mode, then root load.
    pub by_row: Vec<(String, f64)>,
    /// By mode, root pitch and control.
    pub by_motion: Vec<(String, f64)>,
}

impl Rig<'_> {
    /// The fit of this rig's air; none for quasi-steady air.
    pub fn air_fit(&self) -> Option<AirFit> {
        let air = self.air();
        let accuracy = air.accuracy()?;
        let half_chord_m = 0.5 * air.chord_m;
        let reduced = |values: &[f64]| values.iter().map(|value| value * half_chord_m).collect();
        let modes = || (1..=self.omega_rad_s().len()).map(|mode| format!("mode {mode}"));
        let loads = ["Fz", "Mx", "My"].map(String::from);
        let controls = self.wing.control_names();
        let motions = modes().chain(std::iter::once("root pitch".to_owned())).chain(controls);
        Some(AirFit {
            reduced_frequencies: reduced(&air.table.as_ref()?.omega_over_v_per_m),
            poles: reduced(&air.rational.poles_per_m),
            by_row: modes().chain(loads).zip(worst_by_row(&accuracy)).collect(),
            by_motion: motions.zip(worst_by_column(&accuracy)).collect(),
        })
    }
}
