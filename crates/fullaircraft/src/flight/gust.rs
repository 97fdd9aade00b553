//! A one-minus-cosine gust, frozen in the air: `w = w_0/2 (1 - cos(2 pi s/L))` for 0 < s < L, s the distance a point of the
//! aircraft has travelled into it.

use std::f64::consts::TAU;

/// Which way the air of a gust moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GustAxis {
    /// Upwards.
    Vertical,
    /// From the right, towards -y.
    Lateral,
}

/// A gust that the foremost point of the aircraft enters first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gust {
    /// Largest velocity along the gust's axis (upwards, or from the right), m/s.
    pub velocity_m_s: f64,
    /// Length L, m: twice the gradient distance.
    pub length_m: f64,
    /// When the foremost point enters at the airspeed of the trim, s.
    pub start_s: f64,
}

impl Gust {
    /// Velocity, m/s, and its rate, m/s², at a point of an aircraft with this airspeed that has come s into it.
    pub(crate) fn met(&self, s_m: f64, v_m_s: f64) -> [f64; 2] {
        let [velocity, slope] = self.at(s_m);
        [velocity, slope * v_m_s]
    }

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

#[cfg(test)]
mod tests {
    use super::*;

    const GUST: Gust = Gust { velocity_m_s: 3.0, length_m: 8.0, start_s: 0.2 };

    #[test]
    fn a_gust_is_the_discrete_gust_of_the_certification_specifications() {
        // CS-25.341(a)(2): U = U_ds/2 (1 - cos(pi s/H)) for 0 <= s <= 2 H, zero elsewhere: U_ds at the gradient distance H
        let h_m = 0.5 * GUST.length_m;
        for (share, of_peak) in
            [(0.0, 0.0), (0.5, 0.5), (2.0 / 3.0, 0.75), (1.0, 1.0), (1.5, 0.5), (2.0, 0.0)]
        {
            let velocity = GUST.at(share * h_m)[0];
            assert!((velocity - 3.0 * of_peak).abs() < 1e-14, "{share} H: {velocity} m/s");
        }
        assert_eq!([GUST.at(-0.1), GUST.at(2.1 * h_m)], [[0.0; 2]; 2]);
    }

    #[test]
    fn the_rate_of_a_gust_is_the_change_of_its_velocity_with_time() {
        let (v_m_s, h_s) = (25.0, 1e-5);
        for t_s in [0.02, 0.08, 0.15, 0.2, 0.31] {
            let [before, after] = [t_s - h_s, t_s + h_s].map(|t| GUST.met(v_m_s * t, v_m_s)[0]);
            let (rate, change) = (GUST.met(v_m_s * t_s, v_m_s)[1], (after - before) / (2.0 * h_s));
            assert!((rate - change).abs() < 1e-5, "{t_s} s: {rate} and {change} m/s2");
        }
    }
}
