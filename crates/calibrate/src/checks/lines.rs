//! Straight lines through measured and modelled root loads: slope and load at zero angle by airspeed and channel.

use crate::objective::polynomial_residuals;
use crate::statics::{AirspeedData, StaticData};
use aero::{Corrections, Flow};
use coupling::{CouplingError, SteadyCase, SteadyModel};

/// Root loads of an airspeed as lines in the angle of attack.
#[derive(Debug, Clone)]
pub(super) struct Lines {
    /// Airspeed, m/s.
    pub(super) v_m_s: f64,
    /// Measured slope by the angle of attack, per rad, and load at zero angle, by channel.
    pub(super) measured: [[f64; 2]; 3],
    /// The same of theory.
    pub(super) theory: [[f64; 2]; 3],
    /// Covariance of measured slope and load at zero angle, by channel: variance, variance, covariance.
    pub(super) noise: [[f64; 3]; 3],
    /// Mean chord, m.
    pub(super) chord_m: f64,
    /// Which channels are measured.
    pub(super) channels: [bool; 3],
}

/// Lines of all airspeeds with three angles or more.
///
/// # Errors
/// If the wing cannot be solved.
pub(super) fn lines<M: SteadyModel>(
    model: &M,
    rho_kg_m3: f64,
    data: &StaticData,
) -> Result<Vec<Lines>, CouplingError> {
    let neutral = Corrections::neutral(model.correctable().len());
    let with_a_line = data.airspeeds.iter().filter(|airspeed| airspeed.angles.len() >= 3);
    let line = |airspeed: &AirspeedData| {
        let flow = Flow { v_m_s: airspeed.v_m_s, rho_kg_m3 };
        let step_rad = 0.01;
        let cases = [0.0, step_rad].map(|alpha_rad| SteadyCase::new(flow, alpha_rad));
        let loads: Vec<[f64; 3]> =
            model.root_loads(&cases, &neutral)?.iter().map(|load| load.to_array()).collect();
        let fitted: [_; 3] = std::array::from_fn(|channel| measured_line(data, airspeed, channel));
        Ok(Lines {
            v_m_s: airspeed.v_m_s,
            measured: fitted.map(|(line, _)| line),
            noise: fitted.map(|(_, noise)| noise),
            theory: std::array::from_fn(|c| [(loads[1][c] - loads[0][c]) / step_rad, loads[0][c]]),
            chord_m: model.correctable().mean_chord_m(),
            channels: [data.channels[0], data.channels[1], data.channels[2]],
        })
    };
    with_a_line.map(line).collect()
}

/// Least-squares line of a channel and the covariance of its coefficients, from the noise or from the scatter about it.
fn measured_line(data: &StaticData, airspeed: &AirspeedData, channel: usize) -> ([f64; 2], [f64; 3]) {
    let alphas: Vec<f64> = airspeed.angles.iter().map(|angle| angle.alpha_rad).collect();
    let loads: Vec<f64> = airspeed.angles.iter().map(|angle| angle.readings()[channel]).collect();
    let (residuals, coefficients) = polynomial_residuals(&alphas, &loads, 1);
    let n = alphas.len() as f64;
    let scatter = residuals.iter().map(|r| r * r).sum::<f64>() / (n - 2.0);
    let declared = data.point_sigma.map_or(0.0, |sigma| {
        let replicates = airspeed.angles.iter().map(|angle| angle.replicates as f64).sum::<f64>() / n;
        sigma[channel].powi(2) / replicates
    });
    let variance = scatter.max(declared);
    let mean = alphas.iter().sum::<f64>() / n;
    let spread = alphas.iter().map(|alpha| (alpha - mean).powi(2)).sum::<f64>();
    let line = [coefficients.get(1).copied().unwrap_or(0.0), coefficients.first().copied().unwrap_or(0.0)];
    (line, [variance / spread, variance * (1.0 / n + mean * mean / spread), -variance * mean / spread])
}
