//! Readings of a wing that is off its theory, and their derivatives.

use super::off::WingOff;
use crate::sensors::Together;
use coupling::{Load, Readings, SteadyCase, SteadyOperator};

/// What is read in one case.
pub(super) struct CaseRead {
    /// By corrections and flexibility; the values are those without a change of flexibility.
    pub(super) readings: Readings,
    /// By control and row: derivative by the factor on what the control does.
    pub(super) by_control: Vec<Vec<f64>>,
    /// Channel of the balance, by row.
    pub(super) channels: Vec<Option<usize>>,
    /// What is read.
    pub(super) values: Vec<f64>,
}

/// Reads a case; `operator` has the corrections of `off`.
pub(super) fn read_case(
    operator: &SteadyOperator<'_>,
    off: &WingOff,
    case: &SteadyCase,
    together: &Together,
) -> CaseRead {
    let rows = &together.rows;
    let mut flown = case.clone();
    for (delta_rad, factor) in flown.controls_rad.iter_mut().zip(&off.controls) {
        *delta_rad *= factor;
    }
    let readings = operator.readings(&flown, rows);
    // readings are linear in the deflections
    let by_control = |c: usize| {
        let mut without = flown.clone();
        let Some(delta_rad) = without.controls_rad.get_mut(c).filter(|delta_rad| **delta_rad != 0.0) else {
            return vec![0.0; readings.values.len()];
        };
        *delta_rad = 0.0;
        let values = operator.values(&without, rows);
        readings.values.iter().zip(values).map(|(with, without)| (with - without) / off.controls[c]).collect()
    };
    let by_control: Vec<Vec<f64>> = (0..off.controls.len()).map(by_control).collect();
    let [bending, torsion] = off.log_flexibility;
    let [by_bending, by_torsion] = &readings.by_flexibility;
    let softened = by_bending.iter().zip(by_torsion).map(|(a, b)| a * bending + b * torsion);
    let mut values: Vec<f64> =
        readings.values.iter().zip(softened).map(|(value, more)| value + more).collect();
    for (by_control, share) in by_control.iter().zip(&off.in_channels) {
        for (row, channel) in together.channels.iter().enumerate() {
            values[row] += channel.map_or(0.0, |channel| share[Load::ALL[channel]] * by_control[row]);
        }
    }
    CaseRead { readings, by_control, channels: together.channels.clone(), values }
}
