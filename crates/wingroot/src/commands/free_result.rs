//! `result.json` of `free`.

use free::effect::Family;
use free::predict::Score;
use free::search::{Candidate, Found};
use free::verdict::Answer;
use response::verdict::VerdictKind;
use schemars::JsonSchema;
use serde::Serialize;

/// What a rig on two springs lacks, and the cycles it has where it was not fitted.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct FreeResult {
    /// Name of the command.
    pub(crate) command: &'static str,
    /// The rig.
    pub(crate) name: String,
    /// The kind of answer.
    pub(crate) verdict: VerdictKind,
    /// The answer in a sentence.
    pub(crate) sentence: String,
    /// What was named, in the order of finding.
    pub(crate) effects: Vec<EffectResult>,
    /// Families that the data do not tell from the first.
    pub(crate) rivals: Vec<Family>,
    /// The linear rig with them.
    pub(crate) rig: RigResult,
    /// Everything that was tried.
    pub(crate) candidates: Vec<CandidateResult>,
    /// Oscillations fitted.
    pub(crate) points: usize,
    /// Mean square of what is left of them, in variances of the scatter that the rig's file says; 1 is a perfect model.
    pub(crate) left: f64,
    /// Cycles that were fitted.
    pub(crate) fitted: ScoreResult,
    /// Cycles at airspeeds that were not, on days with fitted runs.
    pub(crate) held_out_airspeeds: ScoreResult,
    /// Cycles of days without a fitted run.
    pub(crate) held_out_days: ScoreResult,
    /// Airspeed from which small oscillations grow.
    pub(crate) onset: Beside,
    /// Lowest airspeed with a cycle.
    pub(crate) fold: Beside,
    /// Wall clock.
    pub(crate) seconds: f64,
}

/// An airspeed beside its measurement.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub(crate) struct Beside {
    /// Of the model; null if it has none.
    pub(crate) predicted_m_s: Option<f64>,
    /// Measured; null if the runs do not show it. Of a fold it is the lowest airspeed at which a cycle was measured: the fold lies below.
    pub(crate) measured_m_s: Option<f64>,
}

/// Cycles predicted. A linear rig has none.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub(crate) struct ScoreResult {
    /// Measured.
    pub(crate) cycles: usize,
    /// Of them, those that the model does not have.
    pub(crate) missing: usize,
    /// Root mean square error of the others' pitch amplitude.
    pub(crate) amplitude_error_percent: f64,
    /// Of their frequency.
    pub(crate) frequency_error_percent: f64,
}

impl From<Score> for ScoreResult {
    fn from(score: Score) -> Self {
        Self {
            cycles: score.cycles,
            missing: score.missing,
            amplitude_error_percent: 100.0 * score.amplitude,
            frequency_error_percent: 100.0 * score.frequency,
        }
    }
}

/// An effect that was named.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct EffectResult {
    /// Its form.
    pub(crate) name: &'static str,
    /// Its family.
    pub(crate) family: Family,
    /// Its parameters.
    pub(crate) parameters: Vec<ParameterResult>,
}

/// A parameter.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct ParameterResult {
    /// Its name with its unit.
    pub(crate) name: &'static str,
    /// The most probable value.
    pub(crate) value: f64,
    /// Its standard deviation.
    pub(crate) sd: f64,
}

/// The effects that a search names.
pub(crate) fn effects(found: &Found) -> Vec<EffectResult> {
    if matches!(found.answer(), Answer::Missing | Answer::Nothing) {
        return Vec::new();
    }
    let of = |(effect, values): (free::effect::Effect, Vec<[f64; 2]>)| {
        let named = effect.parameters().into_iter().zip(values);
        let parameters = named.map(|(p, [value, sd])| ParameterResult { name: p.name, value, sd }).collect();
        EffectResult { name: effect.name(), family: effect.family(), parameters }
    };
    found.fitted.values().into_iter().map(of).collect()
}

/// The linear rig.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct RigResult {
    /// Everything that heaves.
    pub(crate) mass_kg: f64,
    /// Mass times distance of the centre of gravity behind the axis.
    pub(crate) unbalance_kgm: f64,
    /// Moment of inertia about the axis, kg m2.
    pub(crate) inertia_kg_m2: f64,
    /// Heave spring.
    pub(crate) heave_stiffness_n_per_m: f64,
    /// Heave damper.
    pub(crate) heave_damping_n_s_per_m: f64,
    /// Pitch spring for small angles, a radian.
    pub(crate) pitch_stiffness_nm: f64,
    /// Pitch damper.
    pub(crate) pitch_damping_nm_s: f64,
    /// The axis behind mid-chord, in half chords.
    pub(crate) axis: f64,
    /// Span times the factor on the lift.
    pub(crate) lifting_span_m: f64,
    /// Part of plane flow's lag.
    pub(crate) lag: f64,
    /// What the heave sensor shows per heave.
    pub(crate) heave_gain: f64,
    /// How much later than the pitch.
    pub(crate) heave_delay_s: f64,
}

impl From<free::rig::LinearRig> for RigResult {
    fn from(rig: free::rig::LinearRig) -> Self {
        let section = rig.section;
        Self {
            mass_kg: section.mass_kg,
            unbalance_kgm: section.unbalance_kgm,
            inertia_kg_m2: section.inertia_kg_m2,
            heave_stiffness_n_per_m: section.heave_stiffness_n_per_m,
            heave_damping_n_s_per_m: section.heave_damping_n_s_per_m,
            pitch_stiffness_nm: section.pitch_stiffness_nm,
            pitch_damping_nm_s: section.pitch_damping_nm_s,
            axis: section.strip.axis,
            lifting_span_m: section.strip.lifting_span_m,
            lag: section.strip.lag,
            heave_gain: rig.heave_gain,
            heave_delay_s: rig.heave_delay_s,
        }
    }
}

/// An effect that was tried.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct CandidateResult {
    /// Beside how many effects found before.
    pub(crate) level: usize,
    /// Its form.
    pub(crate) name: &'static str,
    /// Its family.
    pub(crate) family: Family,
    /// Log evidence beyond the model without it; null if a fit came to no minimum.
    pub(crate) log_bayes_factor: Option<f64>,
    /// Share of campaigns, days drawn again, in which it gains.
    pub(crate) wins: f64,
    /// Mean square of what is left, in variances of the scatter.
    pub(crate) left: f64,
}

/// The candidates of a search.
pub(crate) fn candidates(found: &Found) -> Vec<CandidateResult> {
    let residuals = found.residuals.max(1) as f64;
    let of = |level: usize, candidate: &Candidate| CandidateResult {
        level,
        name: candidate.effect.name(),
        family: candidate.effect.family(),
        log_bayes_factor: Some(candidate.gained).filter(|gained| gained.is_finite()),
        wins: candidate.wins,
        left: candidate.fitted.chi2 / residuals,
    };
    let levels = found.levels.iter().enumerate();
    levels.flat_map(|(level, all)| all.iter().map(move |candidate| of(level, candidate))).collect()
}
