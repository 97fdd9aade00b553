//! Null campaigns with a bar, each kept when it is finished, so that a stopped run goes on with the others.

use discover::analysis::Prepared;
use discover::null_campaigns::{NullCampaign, NullStore};
use discover::null_distribution::NullDistribution;
use indicatif::ProgressBar;

use crate::common::Common;
use crate::progress;
use crate::store::{Store, Told};

struct Kept<'a> {
    store: &'a Store,
    bar: ProgressBar,
}

/// What a null campaign is called in a store.
pub(crate) fn part(k: u64) -> String {
    format!("null campaign {k}")
}

impl NullStore for Kept<'_> {
    fn get(&self, k: u64) -> Option<NullCampaign> {
        let found = self.store.get(&part(k));
        self.bar.inc(u64::from(found.is_some()));
        found
    }

    fn put(&self, k: u64, campaign: &NullCampaign, seconds: f64) {
        let told = Told { part: part(k), seconds: Some(seconds), failed: None };
        if let Err(error) = self.store.put_told(&told, campaign) {
            // Who cannot keep it has it all the same; only a stop would cost it.
            tracing::warn!("a null campaign is not kept: {error}");
        }
        self.bar.inc(1);
    }
}

/// What is found in campaigns without effect, with those that the store has.
pub(crate) fn null_distribution(
    prepared: &Prepared,
    seed: u64,
    store: &Store,
    common: &Common,
) -> NullDistribution {
    let campaigns = usize::try_from(prepared.data.rules.nulls.campaigns).unwrap_or(0);
    let kept = Kept { store, bar: progress::bar(common, campaigns, "null campaigns") };
    let nulls = prepared.null_distribution_kept(seed, &kept);
    progress::end(&kept.bar);
    nulls
}

/// Makes and keeps some of the campaigns.
pub(crate) fn some(prepared: &Prepared, seed: u64, wanted: &[u64], store: &Store, common: &Common) {
    let kept = Kept { store, bar: progress::bar(common, wanted.len(), "null campaigns") };
    prepared.null_campaigns(seed, wanted, &kept);
    progress::end(&kept.bar);
}
