//! A campaign searched for an effect that the wing's model lacks: the thresholds from null campaigns, the verdict in one sentence.
//!
//! `search_a_campaign WING.ron CAMPAIGN_FOLDER CORRECTIONS.ron`: the corrections as `calibrate` found them from this campaign, say
//! `data/tuflex/wing.ron data/tuflex/measured out/calibrate/corrections.ron`. It takes a minute.

use calibrate::{Campaign, Schedule};
use coupling::ElasticWing;
use discover::analysis::{Prepared, Rigs};
use discover::finding::Finding;
use discover::model_form::LatticeVariant;
use discover::rules::Rules;
use std::error::Error;
use std::io::Write;

fn main() -> Result<(), Box<dyn Error>> {
    let mut out = std::io::stdout().lock();
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [wing, campaign, corrections] = arguments.as_slice() else {
        return Err("expected WING.ron CAMPAIGN_FOLDER CORRECTIONS.ron".into());
    };
    let (file, wing) = ElasticWing::read(wing.as_ref())?;
    let campaign = Campaign::read(campaign.as_ref())?;
    let schedule = Schedule::read(corrections.as_ref())?;
    // every number that a decision depends on; another value of one of them is another `Rules`
    let rules = Rules::default();
    let lattice = LatticeVariant::of(&file, &wing, &rules.variants);
    let rigs = Rigs::new(&file, &wing, lattice.as_ref(), rules)?;
    let prepared = Prepared::new(&rigs, &schedule, &campaign, true)?;
    if let Some(defect) = prepared.defects().first() {
        return Err(format!("the data are at fault: {defect:?}").into());
    }
    let nulls = prepared.null_distribution(1);
    let finding = Finding::search(&prepared, &nulls, 1);
    writeln!(out, "{}", finding.judgement().sentence())?;
    Ok(())
}
