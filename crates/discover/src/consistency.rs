//! How large an effect is, judged from parts of the data one by one: an effect that is the one named has one size at
//! every airspeed and in every kind of maneuver. What only resembles it grows with another power of the airspeed, or is
//! right in pitch and wrong with the surfaces.
//!
//! The contribution c of the effect is cut into groups of segments, `r = sum_g delta_g c_g + noise`: `delta_g` is by what
//! share the group wants more of it. Nothing is allowed to the effect's form, as that would hide the answer; it is allowed
//! between groups instead, and to the form of the effects beside it. Uncertainties are those of the model with the effects:
//! a mass moves the resonance at which they act.

use crate::current_model::CurrentModel;
use crate::problem::Problem;
use crate::rules::{OffByVariants, Rules};
use crate::setting::Setting;
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use maneuver::effects::Active;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What moved in a group's segments.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Moved {
    /// Nothing: static points.
    #[serde(rename = "static")]
    Nothing,
    /// The whole wing in pitch.
    Pitch,
    /// Control surfaces.
    Surfaces,
}

impl Moved {
    /// As results and sentences say it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Nothing => "static",
            Self::Pitch => "pitch",
            Self::Surfaces => "surfaces",
        }
    }
}

/// One group's judgement.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Share {
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// What moved.
    pub moved: Moved,
    /// The size that this group alone would have over the one that was found.
    pub share: f64,
    /// Its standard deviation.
    pub sigma: f64,
}

impl std::fmt::Display for Share {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let moved = self.moved.word();
        write!(f, "{moved} at {:.0} m/s {:.2}", self.v_m_s, self.share)
    }
}

/// Shares of one of the current model's effects by group; those that know it badly are left out. `current` is
/// [`CurrentModel::strict`] for it.
pub fn shares(setting: &Setting<'_>, current: &CurrentModel<'_>, which: usize) -> Vec<Share> {
    let CurrentModel { problem, residual, .. } = current;
    let contribution = current.contribution(which);
    let groups = groups(setting, problem);
    let cut = |segments: &[usize]| {
        let mut column = vec![0.0; contribution.len()];
        for segment in segments {
            let rows = problem.segments[*segment].rows.clone();
            column[rows.clone()].copy_from_slice(&contribution[rows]);
        }
        column
    };
    let columns: Vec<Vec<f64>> = groups.values().map(|segments| cut(segments)).collect();
    let k = columns.len();
    let stacked = Mat::from_fn(residual.len(), k + 1, |i, j| if j < k { columns[j][i] } else { residual[i] });
    let gram = current.shared.gram(stacked.as_ref());
    // a share of one more or less is as much as may be expected of any group
    let normal = Mat::from_fn(k, k, |i, j| gram[(i, j)] + f64::from(u8::from(i == j)));
    let Ok(factor) = normal.llt(Side::Lower) else { return Vec::new() };
    let inverse = factor.solve(Mat::<f64>::identity(k, k));
    let phi = (gram[(k, k)] / residual.len() as f64).max(1.0);
    let of = |(j, (v, moved)): (usize, &(usize, Moved))| Share {
        v_m_s: setting.data.airspeeds_m_s[*v],
        moved: *moved,
        share: 1.0 + (0..k).map(|i| inverse[(j, i)] * gram[(i, k)]).sum::<f64>(),
        sigma: (phi * inverse[(j, j)]).sqrt(),
    };
    let all: Vec<Share> = groups.keys().enumerate().map(of).collect();
    let rules = &setting.rules().consistency;
    let best = all.iter().map(|share| share.sigma).fold(rules.known_share, f64::min);
    all.into_iter().filter(|share| share.sigma < rules.known_share.min(rules.times_worse * best)).collect()
}

/// How far shares of an effect are from one size, or that one from the size that was found: the larger chi square over its
/// degrees of freedom; none with fewer than two shares.
pub fn scatter(rules: &Rules, effect: &Active, shares: &[Share]) -> Option<f64> {
    let judges = |share: &&Share| !effect.effect.holds_at_rest_only() || share.moved == Moved::Nothing;
    let shares: Vec<&Share> = shares.iter().filter(judges).collect();
    let rule = rules.effects.of(effect.effect.spec().name);
    let off = match rule.off_by_variants {
        OffByVariants::AsCalibrated => effect.parameters()[0].calibrated.map_or(0.0, |known| known.sigma),
        OffByVariants::Size(size) => size,
        OffByVariants::Nothing => 0.0,
    };
    // what model-form variants are off by in one kind of maneuver is a larger share of a smaller effect
    let largest = effect.values.iter().map(|value| value.abs()).fold(f64::MIN_POSITIVE, f64::max);
    let off = (rules.shared.prior_widths * off / largest).min(rules.consistency.form_most);
    spread(&shares, rule.form.hypot(off))
}

/// Chi square over its degrees of freedom of shares that may differ by `form`, and of their mean, which is to be one.
fn spread(shares: &[&Share], form: f64) -> Option<f64> {
    if shares.len() < 2 {
        return None;
    }
    let weight = |s: &&Share| 1.0 / (s.sigma * s.sigma + form * form);
    let whole: f64 = shares.iter().map(weight).sum();
    let mean = shares.iter().map(|s| weight(s) * s.share).sum::<f64>() / whole;
    let square: f64 = shares.iter().map(|s| weight(s) * (s.share - mean).powi(2)).sum();
    let among = square / (shares.len() - 1) as f64;
    // what the form is off by, parts may have in common
    let known: f64 = shares.iter().map(|s| 1.0 / (s.sigma * s.sigma)).sum();
    let from_found = (mean - 1.0).powi(2) / (1.0 / known + form * form);
    Some(among.max(from_found))
}

/// Segments by airspeed and what moved.
fn groups(setting: &Setting<'_>, problem: &Problem<'_>) -> BTreeMap<(usize, Moved), Vec<usize>> {
    let stimuli: Vec<_> = setting.data.stimuli().collect();
    let mut groups: BTreeMap<(usize, Moved), Vec<usize>> = BTreeMap::new();
    for (index, segment) in problem.segments.iter().enumerate() {
        let (airspeed, stimulus) = &stimuli[segment.place];
        let alpha = &stimulus.inputs.alpha.value;
        let low = alpha.iter().copied().fold(f64::INFINITY, f64::min);
        let high = alpha.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let moved = if stimulus.steady {
            Moved::Nothing
        } else if high - low > setting.rules().consistency.pitching_span_rad {
            Moved::Pitch
        } else {
            Moved::Surfaces
        };
        groups.entry((*airspeed, moved)).or_default().push(index);
    }
    groups
}

#[cfg(test)]
mod tests;
