//! What a null distribution depends on, as fingerprints: the wing, its corrections, the effects with everything that they
//! declare, the rules, the stated noise, and the campaign's design. Measured loads have no part in it: null campaigns replace
//! them. Angles, airspeeds and commands have, as they drive the wing. The seed has none: another seed draws from the same
//! distribution. Formulas of effects have no part, as nothing can be read from them: whoever changes one makes the shipped
//! distribution again.

use crate::data::Dataset;
use aero::Corrections;
use calibrate::{CorrectionSet, Schedule};
use coupling::wing_file::fingerprint;
use maneuver::effects::{Effect, Needs, Stimulus};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::fmt::Write as _;
use std::sync::Arc;

/// Inputs are compared to this share of a radian and of a second: rounding of another processor makes no other campaign.
const FINE: f64 = 1e-6;

/// See the module; each part is a fingerprint.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NullKey {
    /// The wing's file and what it names.
    pub wing: String,
    /// Corrections at every airspeed, to four digits, and how open their directions are.
    pub corrections: String,
    /// The library: names, forms, parameters with bounds, prior and calibration, starts, stages.
    pub effects: String,
    /// All rules.
    pub rules: String,
    /// Noise as the campaign states it.
    pub noise: String,
    /// Airspeeds, angles, commands, times, what is held out, and which loads there are.
    pub design: String,
}

impl NullKey {
    /// The key of a wing (its file's hash) with corrections in a campaign; `open_corrections` as in
    /// [`crate::setting::Setting`].
    pub fn new(
        wing_hash: &str,
        schedule: &Schedule,
        open_corrections: f64,
        library: &[Arc<dyn Effect>],
        data: &Dataset,
    ) -> Self {
        Self {
            wing: wing_hash.to_owned(),
            corrections: fingerprint(&corrections(schedule, open_corrections)),
            effects: fingerprint(&library.iter().map(declared).collect::<String>()),
            rules: fingerprint(&format!("{:?}", data.rules)),
            noise: fingerprint(&format!("{:?}", data.stated)),
            design: fingerprint(&design(data)),
        }
    }

    /// In what another key differs, in words.
    pub fn differs_in(&self, other: &Self) -> Vec<&'static str> {
        let parts = |key: &Self| {
            [&key.wing, &key.corrections, &key.effects, &key.rules, &key.noise, &key.design]
                .map(String::clone)
        };
        let words =
            ["wing", "corrections", "library of effects", "rules", "stated noise", "campaign's design"];
        let pairs = parts(self).into_iter().zip(parts(other)).zip(words);
        pairs.filter(|((own, other), _)| own != other).map(|(_, word)| word).collect()
    }
}

fn corrections(schedule: &Schedule, open_corrections: f64) -> String {
    let mut text = format!("{open_corrections:?}");
    for CorrectionSet { v_m_s, corrections } in &schedule.sets {
        let _ = write!(text, "|{v_m_s:.3e}");
        let Corrections { force, moment, pressure_offset } = corrections;
        for value in force.iter().chain(moment).chain(pressure_offset) {
            // the sign of what rounds to nothing is no difference
            let _ = write!(text, " {:.3e}", if value.abs() < FINE { 0.0 } else { *value });
        }
    }
    text
}

/// Everything that an effect's file declares as data.
fn declared(effect: &Arc<dyn Effect>) -> String {
    format!(
        "{:?} {:?} {:?} {:?} {:?} {} {} {} {} {:?}\n",
        effect.spec(),
        effect.form(),
        effect.parameters(),
        effect.starts(),
        effect.stage(),
        effect.needs() != Needs::NONE,
        effect.splits_stiffness(),
        effect.holds_at_rest_only(),
        effect.excludes_deflection_correction(),
        effect.flight()
    )
}

fn design(data: &Dataset) -> String {
    let mut text = format!("{:.4} {:?} {:?}", data.rho_kg_m3, data.run_loads, data.static_loads());
    let mut add = |airspeed: usize, usage: calibrate::Use, stimulus: &Stimulus, more: String| {
        let _ = write!(text, "\n{:.3} {usage:?} {more}{}", data.airspeeds_m_s[airspeed], driven(stimulus));
    };
    for run in &data.runs {
        add(run.airspeed, run.usage, &run.stimulus, format!("{:?} {}", run.repeat_of, run.decimation));
    }
    for group in &data.statics {
        let there: Vec<[bool; 3]> =
            group.measured.iter().map(|loads| loads.map(|load| load.is_some())).collect();
        add(group.airspeed, group.usage, &group.stimulus, format!("{:?} {there:?}", group.blocks));
    }
    text
}

/// Angle, commands and times.
fn driven(stimulus: &Stimulus) -> String {
    let inputs = &stimulus.inputs;
    let times = [stimulus.time_step_s, stimulus.clock_h];
    let values = inputs.alpha.value.iter().chain(inputs.controls_rad.iter().flatten()).chain(&times);
    values.fold(format!(" {}", stimulus.steady), |mut text, value| {
        // in whole steps; adding zero makes minus zero zero
        let _ = write!(text, " {:.0}", (value / FINE).round() + 0.0);
        text
    })
}
