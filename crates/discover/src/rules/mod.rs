//! Everything that `discover` decides by: each number with its unit, its meaning and where it comes from.
//!
//! `Rules::default()` is what the command decides by; a caller may try others. [`Rules::page`] writes them all on one page,
//! `docs/discover_rules.md`.

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

impl Rules {
    /// All of them on one page, in Markdown.
    pub fn page(&self) -> String {
        let mut text = String::from(
            "# The rules of `discover`\n\nWritten by `Rules::page`; a test keeps it. Every number that a decision of `discover` depends on, \
             with its default, unit, meaning and origin.\n",
        );
        for (theme, title, rules) in self.themes() {
            let head = "| rule | default | unit | meaning | origin |\n| --- | --- | --- | --- | --- |";
            let _ = writeln!(text, "\n## {title} (`{theme}`)\n\n{head}");
            for Rule { name, value, unit, meaning, origin } in rules {
                let _ = writeln!(text, "| `{name}` | {value} | {unit} | {meaning} | {origin} |");
            }
        }
        text + "\n## By an effect's name (`effects`)\n\n" + &self.effects.table()
    }
}
