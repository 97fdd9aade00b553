//! Straight lines through measured and modelled root loads: slope and load at zero angle by airspeed and channel.

use crate::objective::polynomial_residuals;
use crate::statics::{AirspeedData, StaticData};
use aero::{Corrections, Flow};
use coupling::{ByLoad, CouplingError, Load, SteadyCase, SteadyModel};

/// A root load as a line in the angle of attack.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Line {
    /// Per rad.
    pub(super) slope: f64,
    /// At zero angle.
    pub(super) at_zero: f64,
}

impl Line {
    /// The line of the load at zero angle alone.
    pub(super) fn level(at_zero: f64) -> Self {
        Self { slope: 0.0, at_zero }
    }

    /// Both parts by a factor.
    pub(super) fn times(self, slope: f64, at_zero: f64) -> Self {
        Self { slope: slope * self.slope, at_zero: at_zero * self.at_zero }
    }

    /// Slope, load at zero angle.
    pub(super) fn parts(self) -> [f64; 2] {
        [self.slope, self.at_zero]
    }
}

/// Covariance of the two parts of a measured line.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct LineNoise {
    /// Variance of the slope.
    pub(super) slope: f64,
    /// Variance of the load at zero angle.
    pub(super) at_zero: f64,
    /// Covariance of both.
    pub(super) both: f64,
}

impl LineNoise {
    /// As a matrix in the order of [`Line::parts`].
    pub(super) fn matrix(self) -> [[f64; 2]; 2] {
        [[self.slope, self.both], [self.both, self.at_zero]]
    }
}

/// Root loads of an airspeed as lines in the angle of attack.
#[derive(Debug, Clone)]
pub(super) struct Lines {
    /// Airspeed, m/s.
    pub(super) v_m_s: f64,
    /// As measured.
    pub(super) measured: ByLoad<Line>,
    /// By theory.
    pub(super) theory: ByLoad<Line>,
    /// Covariance of measured slope and load at zero angle, by channel.
    pub(super) noise: ByLoad<LineNoise>,
    /// Mean chord, m.
    pub(super) chord_m: f64,
    /// Which channels are measured.
    pub(super) channels: ByLoad<bool>,
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
        let loads: Vec<ByLoad<f64>> =
            model.root_loads(&cases, &neutral)?.into_iter().map(ByLoad::from).collect();
        let fitted = ByLoad::from_fn(|load| measured_line(data, airspeed, load));
        Ok(Lines {
            v_m_s: airspeed.v_m_s,
            measured: fitted.map(|(line, _)| line),
            noise: fitted.map(|(_, noise)| noise),
            theory: ByLoad::from_fn(|load| Line {
                slope: (loads[1][load] - loads[0][load]) / step_rad,
                at_zero: loads[0][load],
            }),
            chord_m: model.correctable().mean_chord_m(),
            channels: ByLoad::from_fn(|load| data.channels[load as usize]),
        })
    };
    with_a_line.map(line).collect()
}

/// Least-squares line of a load and the covariance of its coefficients, from the noise or from the scatter about it.
fn measured_line(data: &StaticData, airspeed: &AirspeedData, load: Load) -> (Line, LineNoise) {
    let alphas: Vec<f64> = airspeed.angles.iter().map(|angle| angle.alpha_rad).collect();
    let loads: Vec<f64> = airspeed.angles.iter().map(|angle| angle.loads[load]).collect();
    let (residuals, coefficients) = polynomial_residuals(&alphas, &loads, 1);
    let n = alphas.len() as f64;
    let scatter = residuals.iter().map(|r| r * r).sum::<f64>() / (n - 2.0);
    let declared = data.point_sigma.map_or(0.0, |sigma| {
        let replicates = airspeed.angles.iter().map(|angle| angle.replicates as f64).sum::<f64>() / n;
        sigma[load as usize].powi(2) / replicates
    });
    let variance = scatter.max(declared);
    let mean = alphas.iter().sum::<f64>() / n;
    let spread = alphas.iter().map(|alpha| (alpha - mean).powi(2)).sum::<f64>();
    let coefficient = |power: usize| coefficients.get(power).copied().unwrap_or(0.0);
    let noise = LineNoise {
        slope: variance / spread,
        at_zero: variance * (1.0 / n + mean * mean / spread),
        both: -variance * mean / spread,
    };
    (Line { slope: coefficient(1), at_zero: coefficient(0) }, noise)
}

#[cfg(test)]
mod tests;
