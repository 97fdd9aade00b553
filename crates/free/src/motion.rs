//! The section in time: its linear part as states, its effects as loads, by Runge and Kutta's fourth order.

use crate::effect::{Active, Instant};
use crate::section::{Section, State, Stream};

/// Integrates from a state.
#[derive(Debug, Clone)]
pub struct Motion<'a> {
    section: &'a Section,
    effects: &'a [Active],
    stream: Stream,
    matrix: nalgebra::SMatrix<f64, 6, 6>,
    inverse: nalgebra::Matrix2<f64>,
    omega_rad_s: f64,
}

impl<'a> Motion<'a> {
    /// A section with effects in a stream; `omega_rad_s` is the frequency at which hysteretic damping is viscous.
    pub fn new(section: &'a Section, effects: &'a [Active], stream: Stream, omega_rad_s: f64) -> Self {
        let (matrix, inverse) = section.state_matrix(stream);
        Self { section, effects, stream, matrix, inverse, omega_rad_s }
    }

    fn rate(&self, x: &State) -> State {
        let mut rate = self.matrix * x;
        let at = Instant {
            heave_rate_m_s: x[2],
            pitch_rad: x[1],
            pitch_rate_rad_s: x[3],
            v_m_s: self.stream.v_m_s,
            pressed_n: self.stream.q_pa() * self.section.strip.lifting_span_m * self.chord_m(),
            chord_m: self.chord_m(),
            omega_rad_s: self.omega_rad_s,
        };
        let mut loads = nalgebra::Vector2::zeros();
        for active in self.effects {
            let [force, moment] = active.effect.loads(&active.values, &at, self.section.pitch_stiffness_nm);
            loads -= nalgebra::Vector2::new(force, moment);
        }
        let accelerated = self.inverse * loads;
        rate[2] += accelerated[0];
        rate[3] += accelerated[1];
        rate
    }

    fn chord_m(&self) -> f64 {
        2.0 * self.section.strip.semichord_m
    }

    /// A step of `dt_s`, s.
    pub fn step(&self, x: &State, dt_s: f64) -> State {
        let k1 = self.rate(x);
        let k2 = self.rate(&(x + k1 * (0.5 * dt_s)));
        let k3 = self.rate(&(x + k2 * (0.5 * dt_s)));
        let k4 = self.rate(&(x + k3 * dt_s));
        x + (k1 + k2 * 2.0 + k3 * 2.0 + k4) * (dt_s / 6.0)
    }
}
