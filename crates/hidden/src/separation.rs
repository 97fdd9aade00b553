//! Flow that separates: Kirchhoff's point of separation, zone by zone, with a time constant.
//!
//! Beyond some angle the point of separation f moves from the trailing edge (1) forward, and the lift of an angle falls to
//! `((1 + sqrt f)/2)²` of it (Leishman and Beddoes 1989, Eqs. 10 and 11). The loss is an incidence that the
//! zone lacks.

/// See the module.
#[derive(Debug, Clone, PartialEq)]
pub struct Separation {
    /// Angle at which 30 % of the chord are separated, rad, by zone.
    pub angle_rad: Vec<f64>,
    /// Widths of the exponentials before and beyond it, rad.
    pub width_rad: (f64, f64),
    /// Time constant in chords travelled.
    pub chords: f64,
    /// Factor of what is lost.
    pub strength: f64,
}

impl Separation {
    /// The steady point of separation of a zone.
    pub fn point(&self, zone: usize, angle_rad: f64) -> f64 {
        let beyond = angle_rad.abs() - self.angle_rad[zone];
        if beyond <= 0.0 {
            1.0 - 0.3 * (beyond / self.width_rad.0).exp()
        } else {
            0.04 + 0.66 * (-beyond / self.width_rad.1).exp()
        }
    }

    /// Incidence that a zone lacks, rad.
    pub fn lost(&self, point: f64, angle_rad: f64) -> f64 {
        self.strength * angle_rad * ((0.5 * (1.0 + point.max(0.0).sqrt())).powi(2) - 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn attached_flow_loses_little_and_separated_flow_three_quarters() {
        let flow = Separation { angle_rad: vec![0.15], width_rad: (0.02, 0.02), chords: 3.0, strength: 1.0 };
        assert!((flow.point(0, 0.15) - 0.7).abs() < 1e-12);
        assert!(flow.lost(flow.point(0, 0.02), 0.02).abs() < 1e-4);
        // f = .04: ((1 + .2)/2)² = .36
        assert!((flow.lost(flow.point(0, 1.0), 1.0) + 0.64).abs() < 1e-6);
        assert!((flow.lost(flow.point(0, -1.0), -1.0) - 0.64).abs() < 1e-6);
    }
}
