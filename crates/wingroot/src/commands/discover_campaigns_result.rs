//! `result.json` of `discover --campaigns`.

use discover::result::{DiscoverResult, StatedGaps};
use discover::verdict::VerdictKind;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What was found in the campaigns of a folder.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub(crate) struct CampaignsResult {
    /// Name of the command.
    pub(crate) command: String,
    /// By name of the campaign's folder.
    pub(crate) campaigns: Vec<CampaignVerdict>,
    /// What all of them took, s.
    pub(crate) seconds: f64,
}

/// What was found in one campaign; everything else is in the `result.json` of its own.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub(crate) struct CampaignVerdict {
    /// The campaign's folder, and that of its results.
    pub(crate) name: String,
    /// What is said.
    pub(crate) verdict: VerdictKind,
    /// Effects that are named, the first found first, each with what it may be instead.
    pub(crate) effects: Vec<CampaignEffect>,
    /// The verdict in words.
    pub(crate) sentence: String,
    /// Gaps before and after; left out where nothing was searched.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) gap: Option<StatedGaps>,
    /// Where the thresholds come from, in words.
    pub(crate) null_distribution: String,
    /// What it took, s: what all campaigns share is not in it.
    pub(crate) seconds: f64,
}

/// An effect that is named in a campaign.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub(crate) struct CampaignEffect {
    /// Name.
    pub(crate) name: String,
    /// Stated probability that it is right.
    pub(crate) confidence: f64,
    /// What it may be instead.
    pub(crate) confused_with: Vec<String>,
}

impl CampaignVerdict {
    /// Of the result of one campaign.
    pub(crate) fn new(name: String, result: &DiscoverResult) -> Self {
        let search = result.search.as_ref();
        let faults: Vec<&str> = result.defects.iter().map(|defect| &*defect.sentence).collect();
        let refused = result.refused.clone().unwrap_or_else(|| faults.join("; "));
        let effect = |effect: &discover::result::NamedEffect| CampaignEffect {
            name: effect.name.clone(),
            confidence: effect.confidence.unwrap_or(0.0),
            confused_with: effect.confused_with.clone(),
        };
        Self {
            name,
            verdict: result.verdict,
            effects: result.effects.iter().map(effect).collect(),
            sentence: search.map_or(refused, |search| search.sentence.clone()),
            gap: search.and_then(|search| search.gap),
            null_distribution: search.map_or_else(String::new, |search| search.null_distribution.clone()),
            seconds: result.seconds.unwrap_or(0.0),
        }
    }

    /// Effects in a cell: what one may be instead stands in brackets behind it.
    pub(crate) fn effects_in_words(&self) -> String {
        let said = self.effects.iter().map(|effect| {
            if effect.confused_with.is_empty() {
                effect.name.clone()
            } else {
                format!("{} (or {})", effect.name, effect.confused_with.join(", "))
            }
        });
        said.collect::<Vec<_>>().join(" + ")
    }
}
