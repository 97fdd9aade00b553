//! A measured run, flown again: its inputs through the rig, its loads beside the simulated ones.

use crate::history::TimeHistory;
use crate::rig_model::{Motion, RigModel};
use crate::run::Run;
use crate::smoothing::{smooth_from_rest, zero_phase};
use coupling::{ByLoad, Load};
use nastran::InputError;
use std::path::Path;

/// A run as simulated, and how far it is from the measurement.
#[derive(Debug, Clone, PartialEq)]
pub struct Simulated {
    /// Simulated channels at the run's samples.
    pub history: TimeHistory,
    /// Root mean square of measured minus simulated Fz, Mx, My (N, N m), both behind the same zero-phase filter;
    /// none if the run has no loads.
    pub residual_rms: Option<ByLoad<f64>>,
    /// The same over the root mean square variation of the measured load, in per cent.
    pub residual_percent: Option<ByLoad<f64>>,
}

/// The inputs of a run: the measured angle smoothed, the commanded deflections as they are.
///
/// # Errors
/// If the run moves a control that the wing does not have.
pub fn motion_of(run: &Run, model: &RigModel, file: &Path) -> Result<Motion, InputError> {
    let mut controls_rad = vec![vec![0.0; run.len()]; model.controls.len()];
    for (name, values) in &run.controls_rad {
        let Some(place) = model.controls.iter().position(|control| control == name) else {
            let known = if model.controls.is_empty() { "none".into() } else { model.controls.join(", ") };
            let text = nastran::read_text(file).unwrap_or_default();
            return Err(InputError::at(
                &nastran::place_of(&[&format!("delta_{name}_deg")], &text, file),
                format!("the run moves a control {name}, which the wing does not have"),
            )
            .with_help(
                match nastran::suggest::nearest(name, model.controls.iter().map(String::as_str)) {
                    Some(meant) => format!("did you mean `delta_{meant}_deg`? The wing's controls: {known}"),
                    None => format!("the wing's controls: {known}"),
                },
            ));
        };
        controls_rad[place].clone_from(values);
    }
    Ok(Motion {
        time_step_s: run.time_step_s,
        alpha: smooth_from_rest(&run.alpha_rad, run.time_step_s, model.cutoff_hz),
        controls_rad,
    })
}

/// Flies a run.
///
/// # Errors
/// If the run moves a control that the wing does not have.
pub fn simulate(run: &Run, model: &RigModel, file: &Path) -> Result<Simulated, InputError> {
    let mut history = model.fly(&motion_of(run, model, file)?);
    history.t_s.clone_from(&run.t_s);
    Ok(Simulated::of(run, history, model))
}

impl Simulated {
    /// A history flown by a model beside what the run measured.
    pub fn of(run: &Run, history: TimeHistory, model: &RigModel) -> Self {
        let (mut residual_rms, mut residual_percent) = (None, None);
        if let Some(measured) = &run.loads {
            let filtered = |values: &[f64]| zero_phase(values, run.time_step_s, model.cutoff_hz);
            let rms = ByLoad::from_fn(|load| {
                let simulated = filtered(history.get(load.column()).unwrap_or(&[]));
                let difference: Vec<f64> =
                    filtered(&measured[load as usize]).iter().zip(simulated).map(|(m, s)| m - s).collect();
                root_mean_square(&difference)
            });
            let variation = |values: &[f64]| {
                let mean = values.iter().sum::<f64>() / values.len() as f64;
                root_mean_square(&values.iter().map(|value| value - mean).collect::<Vec<f64>>())
            };
            let percent = |load: Load| {
                100.0 * rms[load] / variation(&filtered(&measured[load as usize])).max(f64::MIN_POSITIVE)
            };
            residual_rms = Some(rms);
            residual_percent = Some(ByLoad::from_fn(percent));
        }
        Self { history, residual_rms, residual_percent }
    }
}

fn root_mean_square(values: &[f64]) -> f64 {
    (values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64).sqrt()
}

#[cfg(test)]
mod tests;
