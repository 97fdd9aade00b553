//! What the decision knows of single effects; all else of an effect is in its own file of `maneuver::effects`.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// How far model-form variants are off in one kind of maneuver, in the unit of an effect's first parameter.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum OffByVariants {
    /// By what calibration leaves of that parameter; not at all, if it does not determine it.
    AsCalibrated,
    /// By so much.
    Size(f64),
    /// Not at all.
    Nothing,
}

/// The rules of one effect.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct EffectRule {
    /// Share by which its size may differ between parts of the data, as no form is exact.
    pub form: f64,
    /// What is added to that share.
    pub off_by_variants: OffByVariants,
}

impl Default for EffectRule {
    /// Of effects that have none of their own.
    fn default() -> Self {
        Self { form: 0.15, off_by_variants: OffByVariants::AsCalibrated }
    }
}

/// Rules by effect, and those of effects that have none of their own.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct EffectRules {
    /// Where an effect has no rule of its own.
    pub usual: EffectRule,
    /// By the effect's name.
    pub own: BTreeMap<String, EffectRule>,
}

impl EffectRules {
    /// The rule of an effect.
    pub fn of(&self, name: &str) -> &EffectRule {
        self.own.get(name).unwrap_or(&self.usual)
    }

    /// As a table in Markdown.
    pub(super) fn table(&self) -> String {
        let mut text = String::from(
            "| effect | `form`: share by which its size may differ between parts of the data | `off_by_variants`: size added to \
             that share |\n| --- | --- | --- |\n",
        );
        let own = self.own.iter().map(|(name, rule)| (format!("`{name}`"), rule));
        for (name, rule) in own.chain([("all others".to_owned(), &self.usual)]) {
            let _ = writeln!(text, "| {name} | {} | {:?} |", rule.form, rule.off_by_variants);
        }
        text
    }
}

impl Default for EffectRules {
    fn default() -> Self {
        let usual = EffectRule::default;
        // flow that separates: where, how suddenly and with what delay it does so no one formula says; the slope by Reynolds
        // number, whose parts of the data are the airspeeds; what the wake remembers; and lags of servos and filters, which may be of any order
        let rough = || EffectRule { form: 0.4, ..usual() };
        // what scales all loads
        let level = || EffectRule { off_by_variants: OffByVariants::Size(0.01), ..usual() };
        let own = [
            // a mass on the outer wing is not at one point, and what it does near a resonance grows with the airspeed as damping does
            ("tip_mass", EffectRule { form: 0.2, ..usual() }),
            // a wing that is heavier everywhere alike has no other form
            ("wing_mass_error", EffectRule { form: 0.08, off_by_variants: OffByVariants::Nothing }),
            ("act_lag", rough()),
            ("aero_lag", rough()),
            ("daq_filter", rough()),
            ("stall", rough()),
            ("dynamic_stall", rough()),
            ("re_dependence", rough()),
            ("lift_slope", level()),
            ("q_error", level()),
            ("gain", level()),
        ];
        Self { usual: usual(), own: own.map(|(name, rule)| (name.to_owned(), rule)).into() }
    }
}
