//! A one-minus-cosine gust, frozen in the air: `w = w_0/2 (1 - cos(2 pi s/L))` for 0 < s < L, s the distance a point of the
//! aircraft has travelled into it.

use std::f64::consts::TAU;

/// A vertical gust that the foremost point of the aircraft enters first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gust {
    /// Largest velocity, upwards, m/s.
    pub velocity_m_s: f64,
    /// Length L, m: twice the gradient distance.
    pub length_m: f64,
    /// When the foremost point enters at the airspeed of the trim, s.
    pub start_s: f64,
}

impl Gust {
    /// Velocity, m/s, and its change with the distance, 1/s, at s.
    pub(crate) fn at(&self, s_m: f64) -> [f64; 2] {
        let turn = s_m / self.length_m;
        if !(turn > 0.0 && turn < 1.0) {
            return [0.0; 2];
        }
        let (sine, cosine) = (TAU * turn).sin_cos();
        [0.5 * self.velocity_m_s * (1.0 - cosine), 0.5 * self.velocity_m_s * TAU / self.length_m * sine]
    }
}
