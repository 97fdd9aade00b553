//! One of our numbers beside a reference number, and the verdict.

use serde::Serialize;

/// How close is close enough, of `ours - reference`.
#[derive(Debug, Clone, PartialEq)]
pub enum Tolerance {
    /// Within `abs + rel |reference|`: the case's own tolerance.
    Within {
        /// Share of the reference.
        rel: f64,
        /// In the quantity's unit; comes on top.
        abs: f64,
    },
    /// From `low` to `high` in the quantity's unit: a case whose band is not symmetric.
    Band {
        /// Least difference.
        low: f64,
        /// Largest difference.
        high: f64,
    },
    /// The case's own tolerance is missed for a known reason, and the difference is held from `low` to `high` so that
    /// a change is noticed. Such bounds come from our own results and say nothing about being right.
    Known {
        /// Least difference, in the quantity's unit.
        low: f64,
        /// Largest difference, in the quantity's unit.
        high: f64,
        /// What the case asks for.
        asked: Box<Self>,
        /// Why it is missed.
        reason: String,
    },
    /// The case says that the quantity is only to be recorded, or gives no tolerance.
    Record,
}

/// What came out of a comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Within the case's tolerance.
    Met,
    /// Outside of the case's tolerance by as much as is known and explained.
    KnownDeviation,
    /// Nothing was asked for.
    Recorded,
    /// Outside of the tolerance, or not where the known deviation was, or not a number.
    NotMet,
}

impl std::fmt::Display for Verdict {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(match self {
            Self::Met => "met",
            Self::KnownDeviation => "known deviation",
            Self::Recorded => "recorded",
            Self::NotMet => "NOT MET",
        })
    }
}

/// One number beside its reference.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// What is compared, with mesh, place and unit where they matter: `strip at 0.3 of the span (per rad)`.
    pub quantity: String,
    /// Our result.
    pub ours: f64,
    /// The reference.
    pub reference: f64,
    /// How close they must be.
    pub tolerance: Tolerance,
}

impl Row {
    /// Within `rel` of the reference.
    pub fn relative(quantity: impl Into<String>, ours: f64, reference: f64, rel: f64) -> Self {
        Self { quantity: quantity.into(), ours, reference, tolerance: Tolerance::Within { rel, abs: 0.0 } }
    }

    /// Within `abs` of the reference.
    pub fn absolute(quantity: impl Into<String>, ours: f64, reference: f64, abs: f64) -> Self {
        Self { quantity: quantity.into(), ours, reference, tolerance: Tolerance::Within { rel: 0.0, abs } }
    }

    /// Within `abs + rel |reference|`.
    pub fn within(quantity: impl Into<String>, ours: f64, reference: f64, rel: f64, abs: f64) -> Self {
        Self { quantity: quantity.into(), ours, reference, tolerance: Tolerance::Within { rel, abs } }
    }

    /// With `ours - reference` from `low` to `high`.
    pub fn band(quantity: impl Into<String>, ours: f64, reference: f64, low: f64, high: f64) -> Self {
        Self { quantity: quantity.into(), ours, reference, tolerance: Tolerance::Band { low, high } }
    }

    /// Only recorded.
    pub fn record(quantity: impl Into<String>, ours: f64, reference: f64) -> Self {
        Self { quantity: quantity.into(), ours, reference, tolerance: Tolerance::Record }
    }

    /// The same row as a known deviation from `low` to `high` (of `ours - reference`), with the reason.
    #[must_use]
    pub fn known(mut self, low: f64, high: f64, reason: impl Into<String>) -> Self {
        let asked = Box::new(self.tolerance);
        self.tolerance = Tolerance::Known { low, high, asked, reason: reason.into() };
        self
    }

    /// `ours - reference`.
    pub fn difference(&self) -> f64 {
        self.ours - self.reference
    }

    /// Difference over the reference; not a number for a reference of zero.
    pub fn relative_difference(&self) -> f64 {
        self.difference() / self.reference.abs()
    }

    /// The verdict; a result that is not a number is never close.
    pub fn verdict(&self) -> Verdict {
        let off = self.difference();
        let (good, verdict) = match &self.tolerance {
            Tolerance::Within { rel, abs } => (off.abs() <= abs + rel * self.reference.abs(), Verdict::Met),
            Tolerance::Band { low, high } => ((*low..=*high).contains(&off), Verdict::Met),
            Tolerance::Known { low, high, .. } => ((*low..=*high).contains(&off), Verdict::KnownDeviation),
            Tolerance::Record => (off.is_finite(), Verdict::Recorded),
        };
        if good { verdict } else { Verdict::NotMet }
    }

    /// How much of the tolerance is used: 1 at its edge. Infinite for what is not a number, zero where nothing is
    /// asked for.
    pub fn used(&self) -> f64 {
        let off = self.difference();
        let used = match &self.tolerance {
            Tolerance::Within { rel, abs } => off.abs() / (abs + rel * self.reference.abs()),
            Tolerance::Band { low, high } | Tolerance::Known { low, high, .. } => {
                (2.0 * off - low - high).abs() / (high - low)
            }
            Tolerance::Record => 0.0,
        };
        if off == 0.0 {
            0.0
        } else if used.is_nan() {
            f64::INFINITY
        } else {
            used
        }
    }

    /// The tolerance in words.
    pub fn tolerance_text(&self) -> String {
        self.tolerance.to_string()
    }
}

impl std::fmt::Display for Tolerance {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Within { rel, abs } if *abs == 0.0 => f.write_str(&percent(*rel)),
            Self::Within { rel, abs } if *rel == 0.0 => write!(f, "{abs}"),
            Self::Within { rel, abs } => write!(f, "{} + {abs:e}", percent(*rel)),
            Self::Band { low, high } => write!(f, "{low:.4} to {high:.4}"),
            Self::Known { asked, .. } => asked.fmt(f),
            Self::Record => f.write_str("none"),
        }
    }
}

impl Tolerance {
    /// What the case asks for: the tolerance itself, unless it is a known deviation's.
    pub fn asked(&self) -> &Self {
        if let Self::Known { asked, .. } = self { asked.asked() } else { self }
    }
}

fn percent(rel: f64) -> String {
    if rel < 1e-4 { format!("{rel:e}") } else { format!("{} %", (rel * 1e6).round() / 1e4) }
}

/// The row that uses most of its tolerance, named "worst of N: ...": for tables of many alike.
///
/// # Panics
/// If there is no row: a comparison of nothing would always pass.
pub fn worst(what: &str, rows: Vec<Row>) -> Row {
    let count = rows.len();
    let worst = rows.into_iter().max_by(|a, b| a.used().total_cmp(&b.used()));
    let mut row = worst.unwrap_or_else(|| panic!("{what}: there is nothing to compare"));
    row.quantity = format!("{what}, worst of {count}: {}", row.quantity);
    row
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_at_the_edge_is_met_and_beyond_it_not() {
        assert_eq!(Row::relative("a", 1.01, 1.0, 0.011).verdict(), Verdict::Met);
        assert_eq!(Row::relative("a", 1.02, 1.0, 0.011).verdict(), Verdict::NotMet);
        assert_eq!(Row::absolute("a", -3.0, -3.5, 0.5).verdict(), Verdict::Met);
        assert_eq!(Row::band("a", 1.2, 1.0, 0.0, 0.1).verdict(), Verdict::NotMet);
    }

    #[test]
    fn what_is_no_number_is_never_met() {
        for row in [
            Row::relative("a", f64::NAN, 1.0, 0.1),
            Row::record("a", f64::INFINITY, 1.0),
            Row::relative("a", 1.0, 1.0, 0.1).known(-1.0, f64::NAN, "no reason"),
        ] {
            assert_eq!(row.verdict(), Verdict::NotMet);
        }
        assert!(Row::relative("a", f64::NAN, 1.0, 0.1).used().is_infinite());
    }

    #[test]
    fn a_known_deviation_that_moves_is_not_met() {
        let row = |ours: f64| Row::relative("a", ours, 1.0, 0.02).known(0.04, 0.05, "a thick wing");
        assert_eq!(row(1.045).verdict(), Verdict::KnownDeviation);
        // better than known is noticed as well
        assert_eq!(row(1.0).verdict(), Verdict::NotMet);
        assert_eq!(row(1.045).tolerance_text(), "2 %");
    }

    #[test]
    fn the_worst_row_is_the_one_that_uses_most_of_its_tolerance() {
        let rows = vec![Row::relative("small", 1.009, 1.0, 0.01), Row::relative("large", 1.1, 1.0, 0.5)];
        assert_eq!(worst("lift", rows).quantity, "lift, worst of 2: small");
    }
}
