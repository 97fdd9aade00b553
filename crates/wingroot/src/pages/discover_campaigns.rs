//! The page of `discover --campaigns`: a row a campaign.

use report::Page;
use report::page::{Block, PageTable, Plate, Section};
use serde::Deserialize;
use serde_json::Value;

use super::values::short;
use crate::commands::discover_campaigns_result::{CampaignVerdict, CampaignsResult};

/// The page of a result; an empty one if it is none of `discover --campaigns`.
pub(super) fn page(result: &Value, _: &mut Vec<Plate>) -> Page {
    CampaignsResult::deserialize(result).map_or_else(|_| Page::default(), |result| page_of(&result))
}

fn page_of(result: &CampaignsResult) -> Page {
    let named = result.campaigns.iter().filter(|one| !one.effects.is_empty()).count();
    let said = result.campaigns.iter().map(|one| Block::Text(format!("{}: {}", one.name, one.sentence)));
    Page {
        title: "What the model lacks, campaign by campaign".into(),
        lead: vec![format!("{} campaigns on one wing; {named} name an effect.", result.campaigns.len())],
        sections: vec![
            Section::new("Verdicts", vec![Block::Table(table(&result.campaigns))]),
            Section::new("In words", said.collect()),
        ],
        ..Page::default()
    }
}

fn table(campaigns: &[CampaignVerdict]) -> PageTable {
    let caption =
        "Gaps in standard deviations of the noise, before -> after; each campaign has a page of its own.";
    let mut table =
        PageTable::new(caption, &["campaign", "verdict", "effects", "gap on training data", "gap held out"]);
    for one in campaigns {
        let gap = |of: Option<(f64, f64)>| {
            let there = of.filter(|(before, _)| before.is_finite());
            there.map_or_else(|| "-".to_owned(), |(a, b)| format!("{} -> {}", short(Some(a)), short(Some(b))))
        };
        table.row([
            one.name.clone(),
            one.verdict.word().to_owned(),
            one.effects_in_words(),
            gap(one.gap.map(|gap| (gap.training.before, gap.training.after))),
            gap(one.gap.map(|gap| (gap.holdout.before, gap.holdout.after))),
        ]);
    }
    table
}
