//! Air of a thin section in unsteady motion: Theodorsen's forces (NACA report 496) with R. T. Jones's two exponentials for the
//! lag of the circulation (NACA report 681), as a function of the Laplace variable and as two states.

use nalgebra::{Complex, Matrix2};
use std::f64::consts::PI;

/// Jones's lift after a step: `1 - sum of a exp(-b s)`, s in half chords travelled.
pub const JONES: [(f64, f64); 2] = [(0.165, 0.0455), (0.335, 0.3)];

/// Lag of the circulation, Theodorsen's C continued to growing and decaying motion; `s = p b / V`.
///
/// `lag` is the part of the lag that is there: 1 for plane flow, less for a wing of finite span.
pub fn circulation(s: Complex<f64>, lag: f64) -> Complex<f64> {
    JONES.iter().fold(Complex::new(1.0, 0.0), |sum, (a, b)| sum - s * *a * lag / (s + *b))
}

/// A section in a stream.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strip {
    /// Half of the chord, m.
    pub semichord_m: f64,
    /// The axis behind mid-chord, in half chords.
    pub axis: f64,
    /// Span times the factor on the theoretical lift, m.
    pub lifting_span_m: f64,
    /// Part of the lag of plane flow.
    pub lag: f64,
}

/// Air forces that act on `[heave, pitch]` and their rates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AirMatrices {
    /// Added mass, on the left of the equations.
    pub mass: Matrix2<f64>,
    /// Damping without circulation, on the left.
    pub damping: Matrix2<f64>,
    /// Circulatory force and moment per downwash, on the left, N s/m and N s.
    pub circulatory: [f64; 2],
    /// Downwash at three quarters of the chord per heave rate and pitch rate, and per pitch, m/s.
    pub downwash_rate: [f64; 2],
    /// Downwash per pitch angle, m/s: the airspeed.
    pub downwash_pitch: f64,
}

impl Strip {
    /// The matrices at a density (kg/m3) and an airspeed (m/s). Heave is positive down, pitch nose up.
    pub fn matrices(&self, rho_kg_m3: f64, v_m_s: f64) -> AirMatrices {
        let Self { semichord_m: b, axis: a, lifting_span_m, .. } = *self;
        let apparent = PI * rho_kg_m3 * b * b * lifting_span_m;
        let lift = 2.0 * PI * rho_kg_m3 * v_m_s * b * lifting_span_m;
        AirMatrices {
            mass: Matrix2::new(1.0, -b * a, -b * a, b * b * (0.125 + a * a)) * apparent,
            damping: Matrix2::new(0.0, v_m_s, 0.0, v_m_s * b * (0.5 - a)) * apparent,
            circulatory: [lift, -lift * b * (a + 0.5)],
            downwash_rate: [1.0, b * (0.5 - a)],
            downwash_pitch: v_m_s,
        }
    }

    /// Air forces on the left of the equations at the Laplace variable `p` (1/s), per heave and pitch.
    pub fn stiffness(&self, rho_kg_m3: f64, v_m_s: f64, p: Complex<f64>) -> Matrix2<Complex<f64>> {
        let air = self.matrices(rho_kg_m3, v_m_s);
        let c = circulation(p * self.semichord_m / v_m_s.max(1e-6), self.lag);
        let downwash = [p * air.downwash_rate[0], p * air.downwash_rate[1] + air.downwash_pitch];
        Matrix2::from_fn(|i, j| {
            p * p * air.mass[(i, j)] + p * air.damping[(i, j)] + c * downwash[j] * air.circulatory[i]
        })
    }
}
