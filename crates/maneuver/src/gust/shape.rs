//! The discrete gust of the airworthiness rules: one wave of one minus cosine.

/// One wave: `w = w_0/2 (1 - cos(2 pi s/L))` for 0 < s < L, s the distance the reference point has travelled into it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OneMinusCosineGust {
    /// Largest incidence `w_0/V`, rad.
    pub incidence_rad: f64,
    /// Length L, m (twice the gradient distance).
    pub length_m: f64,
    /// When the reference point enters it, s.
    pub start_s: f64,
}

impl OneMinusCosineGust {
    /// Incidence at the reference point, rad.
    pub fn at(&self, t_s: f64, v_m_s: f64) -> f64 {
        let s = v_m_s * (t_s - self.start_s) / self.length_m;
        if s > 0.0 && s < 1.0 {
            0.5 * self.incidence_rad * (1.0 - (std::f64::consts::TAU * s).cos())
        } else {
            0.0
        }
    }
}
