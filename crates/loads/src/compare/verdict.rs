//! Verdicts, and why.

use super::facts::{Facts, Pair};
use super::given::{Thresholds, Zero};
use super::statistics::Interval;
use schemars::JsonSchema;
use serde::Serialize;

/// Fewest points of a verdict.
const FEWEST: usize = 5;
/// A large load this many standard deviations below the measured one is no conservative load.
const BELOW_SIGMA: f64 = 2.0;

/// What is said of calculated loads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
pub enum Verdict {
    /// Large loads are calculated too small, by more than chance.
    #[serde(rename = "unconservative")]
    Unconservative,
    /// There are too few points that did not fit the corrections, or they scatter too much.
    #[serde(rename = "undetermined")]
    Undetermined,
    /// Slope and bias are within what is asked for.
    #[serde(rename = "reliable")]
    Reliable,
    /// Loads are calculated too large, never too small.
    #[serde(rename = "conservative")]
    Conservative,
    /// None of these.
    #[serde(rename = "not shown")]
    NotShown,
}

impl Verdict {
    /// In words.
    pub fn word(self) -> &'static str {
        match self {
            Self::Unconservative => "unconservative",
            Self::Undetermined => "undetermined",
            Self::Reliable => "reliable",
            Self::Conservative => "conservative",
            Self::NotShown => "not shown",
        }
    }
}

/// The first verdict that holds; `found` says which tests are beyond chance: large loads in their order, then the slope.
pub(super) fn verdict(
    facts: &Facts,
    thresholds: &Thresholds,
    found: &[bool],
    unit: &str,
) -> (Verdict, Vec<String>) {
    let short = shortfalls(facts, thresholds, found);
    if !short.is_empty() {
        return (Verdict::Unconservative, short);
    }
    let n = facts.pairs.len();
    let slope = match facts.slope() {
        Some(slope) if n >= FEWEST => slope,
        _ => {
            let points = if n == 1 { "1 point" } else { &format!("{n} points") };
            let why = format!("{points} that fitted no corrections; {FEWEST} different ones are the fewest");
            return (Verdict::Undetermined, vec![why]);
        }
    };
    let r = thresholds.reliable_within;
    let ends = format!("slope {:.4} ({:.4} to {:.4})", slope.value, slope.low, slope.high);
    if slope.high - slope.low > 2.0 * r {
        return (Verdict::Undetermined, vec![format!("{ends}: wider than {:.3}", 2.0 * r)]);
    }
    let (bias_holds, bias) = bias(facts, thresholds, unit);
    let slope_holds = slope.low >= 1.0 - r && slope.high <= 1.0 + r;
    let slope_words = format!(
        "{ends} {} {:.3} to {:.3}",
        if slope_holds { "within" } else { "not within" },
        1.0 - r,
        1.0 + r
    );
    let mut reasons = vec![slope_words, bias];
    if slope_holds && bias_holds {
        return (Verdict::Reliable, reasons);
    }
    let below = facts.large().filter(|pair| pair.below(1.0) > BELOW_SIGMA).count();
    reasons.push(format!(
        "{below} of {} large loads calculated more than {BELOW_SIGMA} sigma below the measured",
        facts.large.len()
    ));
    let verdict = if slope.high <= 1.0 + r && below == 0 { Verdict::Conservative } else { Verdict::NotShown };
    (verdict, reasons)
}

/// What is calculated too small by more than chance.
fn shortfalls(facts: &Facts, thresholds: &Thresholds, found: &[bool]) -> Vec<String> {
    let mut reasons = Vec::new();
    let r = thresholds.reliable_within;
    let points: Vec<&Pair> =
        facts.large().zip(found).filter(|(_, found)| **found).map(|(pair, _)| pair).collect();
    if let Some(worst) = points.iter().map(|pair| pair.ratio()).reduce(f64::min) {
        reasons.push(format!(
            "{} of {} large loads calculated below {:.3} of the measured by more than chance, the worst {worst:.4}",
            points.len(),
            facts.large.len(),
            1.0 - r
        ));
    }
    if let (Some(line), Some(true)) = (&facts.line, found.get(facts.large.len())) {
        reasons.push(format!(
            "slope {:.4} ({:.4} to {:.4}) above {:.3} by more than chance",
            line.slope.value,
            line.slope.low,
            line.slope.high,
            1.0 + r
        ));
    }
    reasons
}

/// Whether the bias is within what is asked for, and in words. An unknown zero has none.
fn bias(facts: &Facts, thresholds: &Thresholds, unit: &str) -> (bool, String) {
    if facts.zero == Zero::Free {
        return (true, "bias not judged: the gauge's zero is free".into());
    }
    let (Some(Interval { value, low, high }), Some(sigma)) = (facts.bias, facts.sigma) else {
        return (false, "no bias".into());
    };
    let most = thresholds.bias_within_sigma * sigma;
    let holds = low >= -most && high <= most;
    let within = if holds { "within" } else { "not within" };
    (holds, format!("bias {value:.3} ({low:.3} to {high:.3}) {unit} {within} {most:.3}"))
}
