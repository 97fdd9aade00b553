//! Everything that `discover` decides by: each number with its unit, its meaning and where it comes from.
//!
//! `Rules::default()` is what the command decides by; a caller may try others. [`Rules::page`] writes those of the decision on one page,
//! `docs/discover_rules.md`, [`Rules::settings_page`] all others, `docs/discover_settings.md`.

mod checks;
mod data;
mod effects;
mod model;
mod rule;
mod search;

pub use checks::{AirspeedRules, LabelRules, RecordRules, RepeatRules, SampleRules, ScaleRules, TimingRules};
pub use data::{DataRules, NoiseRules, SpectralLineRules};
pub use effects::{EffectRule, EffectRules, OffByVariants};
pub use model::{SharedRules, ToleranceRules, VariantRules};
pub use rule::{Origin, Rule};
pub use search::{
    ConsistencyRules, ExperimentRules, FitRules, LocateRules, NamingRules, NullRules, RankRules, RivalRules,
    VerdictRules,
};

use serde::{Deserialize, Serialize};
use std::fmt::Write as _;

macro_rules! themes {
    ($($(#[doc = $meaning:literal])+ $theme:ident: $type:ty, $title:literal;)+) => {
        /// See the module.
        #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
        #[serde(default, deny_unknown_fields)]
        pub struct Rules {
            $($(#[doc = $meaning])+ pub $theme: $type,)+
            /// What is decided by an effect's name.
            pub effects: EffectRules,
        }

        impl Rules {
            /// All rules by theme: its field, its title, its rules.
            pub fn themes(&self) -> Vec<(&'static str, &'static str, Vec<Rule>)> {
                vec![$((stringify!($theme), $title, self.$theme.list()),)+]
            }
        }
    };
}

themes! {
    /// Reading a campaign.
    data: DataRules, "Reading a campaign";
    /// Pure error.
    noise: NoiseRules, "Pure error";
    /// Spectral lines that do not repeat.
    spectral_lines: SpectralLineRules, "Spectral lines that do not repeat";
    /// Data checks: a run beside its simulation.
    record: RecordRules, "Data checks: a run beside its simulation";
    /// Data checks: airspeeds that are not what a label says.
    airspeed: AirspeedRules, "Data checks: wrong airspeeds";
    /// Data checks: exchanged labels and flipped signs.
    labels: LabelRules, "Data checks: exchanged labels and flipped signs";
    /// Data checks: scaled channels.
    scales: ScaleRules, "Data checks: channels of another scale";
    /// Data checks: samples that were not measured.
    samples: SampleRules, "Data checks: stuck and clipped channels, spikes";
    /// Data checks: late and early runs.
    timing: TimingRules, "Data checks: late and early runs";
    /// Data checks: repeats that do not repeat.
    repeats: RepeatRules, "Data checks: repeats that do not repeat";
    /// What a single run may be off by.
    tolerance: ToleranceRules, "What a single run may be off by";
    /// What all runs share.
    shared: SharedRules, "What all runs share";
    /// Model-form variants.
    variants: VariantRules, "Model-form variants";
    /// Screening and fit of candidates.
    fit: FitRules, "Screening and fit of candidates";
    /// Which candidates are fitted.
    rank: RankRules, "Which candidates are fitted";
    /// Which candidates the data do not tell apart.
    rivals: RivalRules, "Which candidates the data do not tell apart";
    /// When an effect is named.
    naming: NamingRules, "When an effect is named";
    /// One size in all parts of the data.
    consistency: ConsistencyRules, "One size in all parts of the data";
    /// What is found where nothing is missing.
    nulls: NullRules, "What is found where nothing is missing";
    /// What is said in the end.
    verdict: VerdictRules, "What is said in the end";
    /// Experiments of the menu.
    experiments: ExperimentRules, "Experiments of the menu";
    /// Where the residual sits.
    locate: LocateRules, "Where the residual sits";
}

/// Themes that decide on names. With the others a campaign is read, checked, fitted and shown.
const DECISION: [&str; 4] = ["nulls", "naming", "rivals", "consistency"];

const HEAD: &str = "| rule | default | unit | meaning | origin |\n| --- | --- | --- | --- | --- |";

impl Rules {
    /// The rules of the decision on one page, in Markdown.
    pub fn page(&self) -> String {
        let mut text = format!(
            "# By which rules `discover` names an effect\n\nWritten by `Rules::page`; a test keeps it. How a campaign is read, checked and fitted: \
             `discover_settings.md`.\n\n1. *Is it needed?* Its log Bayes factor exceeds one threshold (`nulls`, `naming`).\n\
             2. *Is it told apart?* It wins a bootstrap over runs; of what comes close the simplest is named, and the others are said as its rivals (`rivals`).\n\
             3. *Does it predict?* Parts of the data that each know its size ask for one size (`consistency`).\n\n{HEAD}\n"
        );
        for (theme, _, rules) in self.themes_of(true) {
            push(&mut text, Some(theme), &rules);
        }
        text + "\nShare by which the size of an effect may differ between parts of the data:\n\n"
            + &self.effects.table()
    }

    /// All other numbers, in Markdown.
    pub fn settings_page(&self) -> String {
        let mut text = String::from(
            "# How `discover` reads, checks and fits\n\nWritten by `Rules::settings_page`; a test keeps it. Every number beside those of \
             the decision (`discover_rules.md`), with its default, unit, meaning and origin.\n",
        );
        for (theme, title, rules) in self.themes_of(false) {
            let _ = writeln!(text, "\n## {title} (`{theme}`)\n\n{HEAD}");
            push(&mut text, None, &rules);
        }
        text
    }

    fn themes_of(&self, decision: bool) -> impl Iterator<Item = (&'static str, &'static str, Vec<Rule>)> {
        self.themes().into_iter().filter(move |(theme, ..)| DECISION.contains(theme) == decision)
    }
}

/// Rows of rules, with the name of their theme before their own.
fn push(text: &mut String, theme: Option<&str>, rules: &[Rule]) {
    let theme = theme.map(|theme| format!("{theme}.")).unwrap_or_default();
    for Rule { name, value, unit, meaning, origin } in rules {
        let _ = writeln!(text, "| `{theme}{name}` | {value} | {unit} | {meaning} | {origin} |");
    }
}
