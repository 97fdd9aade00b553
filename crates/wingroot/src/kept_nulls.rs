//! Null campaigns with a bar, each kept when it is finished, so that a stopped run goes on with the others.

use discover::analysis::Prepared;
use discover::null_campaigns::{NullCampaign, NullStore};
use discover::null_distribution::NullDistribution;
use indicatif::ProgressBar;

use crate::common::Common;
use crate::progress;
use crate::store::Store;

struct Kept {
    store: Store,
    bar: ProgressBar,
}

impl NullStore for Kept {
    fn get(&self, k: u64) -> Option<NullCampaign> {
        let found = self.store.get(&k.to_string());
        self.bar.inc(u64::from(found.is_some()));
        found
    }

    fn put(&self, k: u64, campaign: &NullCampaign) {
        if let Err(error) = self.store.put(&k.to_string(), campaign) {
            // Who cannot keep it has it all the same; only a stop would cost it.
            tracing::warn!("a null campaign is not kept: {error}");
        }
        self.bar.inc(1);
    }
}

/// What is found in campaigns without effect; the store is emptied when all are there.
pub(crate) fn null_distribution(
    prepared: &Prepared,
    seed: u64,
    store: Store,
    common: &Common,
) -> NullDistribution {
    let campaigns = usize::try_from(prepared.data.rules.nulls.campaigns).unwrap_or(0);
    let kept = Kept { store, bar: progress::bar(common, campaigns, "null campaigns") };
    let nulls = prepared.null_distribution_kept(seed, &kept);
    progress::end(&kept.bar);
    // A store that resists is found again, or is of other inputs and ignored.
    let _ = kept.store.close();
    nulls
}
