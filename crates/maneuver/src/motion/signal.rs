//! A signal of time with its derivatives.

/// A sample that rounding puts this little before an edge (of its unit, or s) belongs behind it.
pub(super) const EDGE: f64 = 1e-9;

/// A signal of time; angles in rad, time in s.
pub trait Signal: Send + Sync {
    /// Value.
    fn at(&self, t_s: f64) -> f64;

    /// First derivative; at a jump, zero.
    fn rate(&self, _t_s: f64) -> f64 {
        0.0
    }

    /// Second derivative; at a jump or corner, zero.
    fn second(&self, _t_s: f64) -> f64 {
        0.0
    }
}

/// A signal about a value other than zero, such as the angle of attack at the beginning.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct About<S>(pub f64, pub S);

impl<S: Signal> Signal for About<S> {
    fn at(&self, t_s: f64) -> f64 {
        self.0 + self.1.at(t_s)
    }

    fn rate(&self, t_s: f64) -> f64 {
        self.1.rate(t_s)
    }

    fn second(&self, t_s: f64) -> f64 {
        self.1.second(t_s)
    }
}

/// Samples of a signal at a uniform time step, `count` of them from t = 0.
pub fn sampled<S: Signal + ?Sized>(signal: &S, time_step_s: f64, count: usize) -> Vec<f64> {
    (0..count).map(|i| signal.at(i as f64 * time_step_s)).collect()
}
