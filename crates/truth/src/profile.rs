//! A number along the span.

/// Number of points, evenly from root to tip.
const POINTS: u32 = 61;

/// Values at even places of the half span, linear between.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile(Vec<f64>);

impl Profile {
    /// A function of the share of the half span.
    pub fn of(value: impl Fn(f64) -> f64) -> Self {
        Self((0..POINTS).map(|place| value(f64::from(place) / f64::from(POINTS - 1))).collect())
    }

    /// The same everywhere.
    pub fn even(value: f64) -> Self {
        Self::of(|_| value)
    }

    /// The value at a share of the half span; those of root and tip beyond.
    pub fn at(&self, eta: f64) -> f64 {
        let place = eta.clamp(0.0, 1.0) * f64::from(POINTS - 1);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 60")]
        let before = (place as usize).min(self.0.len() - 2);
        let share = place - before as f64;
        self.0[before] * (1.0 - share) + self.0[before + 1] * share
    }

    /// Adds a function of the share of the half span.
    pub fn add(&mut self, value: impl Fn(f64) -> f64) {
        for (own, more) in self.0.iter_mut().zip(Self::of(value).0) {
            *own += more;
        }
    }

    /// Multiplies by a function of the share of the half span.
    pub fn scale(&mut self, value: impl Fn(f64) -> f64) {
        for (own, factor) in self.0.iter_mut().zip(Self::of(value).0) {
            *own *= factor;
        }
    }
}
