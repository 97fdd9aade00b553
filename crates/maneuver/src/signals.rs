//! Input signals with closed-form derivatives: what is commanded, as a function of time.

use std::f64::consts::{PI, TAU};

/// A sample that rounding puts this little before an edge (of its unit, or s) belongs behind it.
const EDGE: f64 = 1e-9;

/// A signal of time; angles in rad, time in s.
pub trait Signal: Send + Sync {
    /// Value.
    fn at(&self, t_s: f64) -> f64;

    /// First derivative; at a jump, zero.
    fn rate(&self, t_s: f64) -> f64 {
        let _ = t_s;
        0.0
    }

    /// Second derivative; at a jump or corner, zero.
    fn second(&self, t_s: f64) -> f64 {
        let _ = t_s;
        0.0
    }
}

/// A constant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constant(pub f64);

impl Signal for Constant {
    fn at(&self, _t_s: f64) -> f64 {
        self.0
    }
}

/// One-minus-cosine: `base + height/2 (1 - cos(2 pi f (t - start)))` for one period, `base` elsewhere (S35).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OneMinusCosine {
    /// Value before and after.
    pub base: f64,
    /// Largest departure from it.
    pub height: f64,
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Beginning, s.
    pub start_s: f64,
}

impl OneMinusCosine {
    /// Phase in rad inside the period, none outside.
    fn phase(&self, t_s: f64) -> Option<f64> {
        let phase = TAU * self.frequency_hz * (t_s - self.start_s);
        (0.0..TAU).contains(&phase).then_some(phase)
    }
}

impl Signal for OneMinusCosine {
    fn at(&self, t_s: f64) -> f64 {
        self.base + self.phase(t_s).map_or(0.0, |phase| 0.5 * self.height * (1.0 - phase.cos()))
    }

    fn rate(&self, t_s: f64) -> f64 {
        let omega = TAU * self.frequency_hz;
        self.phase(t_s).map_or(0.0, |phase| 0.5 * self.height * omega * phase.sin())
    }

    fn second(&self, t_s: f64) -> f64 {
        let omega = TAU * self.frequency_hz;
        self.phase(t_s).map_or(0.0, |phase| 0.5 * self.height * omega * omega * phase.cos())
    }
}

/// Doublet: `+height` for half a period, `-height` for the other half.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Doublet {
    /// Height of each half.
    pub height: f64,
    /// One over the length of both halves, Hz.
    pub frequency_hz: f64,
    /// Beginning, s.
    pub start_s: f64,
}

impl Signal for Doublet {
    fn at(&self, t_s: f64) -> f64 {
        match (t_s - self.start_s) * self.frequency_hz + EDGE {
            share if (0.0..0.5).contains(&share) => self.height,
            share if (0.5..1.0).contains(&share) => -self.height,
            _ => 0.0,
        }
    }
}

/// Step to `height` at `start_s`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Height.
    pub height: f64,
    /// Beginning, s.
    pub start_s: f64,
}

impl Signal for Step {
    fn at(&self, t_s: f64) -> f64 {
        if t_s + EDGE >= self.start_s { self.height } else { 0.0 }
    }
}

/// 3-2-1-1: three units up, two down, one up, one down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThreeTwoOneOne {
    /// Height.
    pub height: f64,
    /// Length of one unit, s.
    pub unit_s: f64,
    /// Beginning, s.
    pub start_s: f64,
}

impl Signal for ThreeTwoOneOne {
    fn at(&self, t_s: f64) -> f64 {
        match (t_s - self.start_s) / self.unit_s + EDGE {
            unit if (0.0..3.0).contains(&unit) || (5.0..6.0).contains(&unit) => self.height,
            unit if (3.0..5.0).contains(&unit) || (6.0..7.0).contains(&unit) => -self.height,
            _ => 0.0,
        }
    }
}

/// Linear chirp: `height sin(2 pi (f0 t + (f1 - f0) t²/(2 T)))`, so its frequency runs linearly from f0 to f1 in T
/// (S45: 0 to 10 Hz in 30 s is f = t/3 Hz).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chirp {
    /// Amplitude.
    pub height: f64,
    /// Frequency at the beginning, Hz.
    pub from_hz: f64,
    /// Frequency at the end, Hz.
    pub to_hz: f64,
    /// Length T, s.
    pub duration_s: f64,
    /// Beginning, s.
    pub start_s: f64,
}

impl Chirp {
    /// Frequency at a time inside the chirp, Hz.
    pub fn frequency_hz(&self, t_s: f64) -> f64 {
        self.from_hz + (self.to_hz - self.from_hz) * (t_s - self.start_s) / self.duration_s
    }

    /// Phase and its rate inside, none outside.
    fn phase(&self, t_s: f64) -> Option<(f64, f64)> {
        let t = t_s - self.start_s;
        let sweep = (self.to_hz - self.from_hz) / self.duration_s;
        (0.0..=self.duration_s)
            .contains(&t)
            .then_some((TAU * (self.from_hz * t + 0.5 * sweep * t * t), TAU * (self.from_hz + sweep * t)))
    }
}

impl Signal for Chirp {
    fn at(&self, t_s: f64) -> f64 {
        self.phase(t_s).map_or(0.0, |(phase, _)| self.height * phase.sin())
    }

    fn rate(&self, t_s: f64) -> f64 {
        self.phase(t_s).map_or(0.0, |(phase, omega)| self.height * omega * phase.cos())
    }

    fn second(&self, t_s: f64) -> f64 {
        let sweep = 2.0 * PI * (self.to_hz - self.from_hz) / self.duration_s;
        self.phase(t_s)
            .map_or(0.0, |(phase, omega)| self.height * (sweep * phase.cos() - omega * omega * phase.sin()))
    }
}

/// Samples of a signal at a uniform time step, `count` of them from t = 0.
pub fn sampled(signal: &dyn Signal, time_step_s: f64, count: usize) -> Vec<f64> {
    (0..count).map(|i| signal.at(i as f64 * time_step_s)).collect()
}
