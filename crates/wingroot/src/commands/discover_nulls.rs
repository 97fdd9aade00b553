//! The null distribution of `discover`: the given or shipped one, or one from null campaigns, which are a sweep: all in one process, or
//! a share, preparation, merge and status of many.

use std::path::{Path, PathBuf};
use std::time::Instant;

use coupling::WingFile;
use discover::analysis::Prepared;
use discover::null_distribution::NullDistribution;
use discover::null_key::NullKey;
use nastran::InputError;
use nastran::ron_or_json::expected_in;

use crate::args::Common;
use crate::corrections::CorrectedWing;
use crate::failure::Failure;
use crate::fingerprint::Fingerprint;
use crate::paths::folder_of;
use crate::store::{Inputs, Store, Told};
use crate::sweep::estimate::{Estimate, Slot};
use crate::sweep::share::Share;
use crate::sweep::split::{Weighed, share_of};
use crate::sweep::{Task, merging, status};
use crate::{kept_nulls, show};

/// All campaigns as a share.
const ALL: Share = Share { number: 1, of: 1 };

/// What a null distribution is asked for with.
pub(crate) struct Asked<'a> {
    /// The one that the user names.
    pub(crate) named: Option<&'a PathBuf>,
    pub(crate) corrected: &'a CorrectedWing,
    pub(crate) prepared: &'a Prepared,
    pub(crate) common: &'a Common,
    pub(crate) seed: u64,
    pub(crate) start: Instant,
    /// Where an estimate is left.
    pub(crate) estimate: &'a Slot,
}

impl Asked<'_> {
    /// The null distribution and where it is from, in words; none if the task was another and is done.
    ///
    /// # Errors
    /// If a given one is of other inputs, or campaigns are missing from a merge.
    pub(crate) fn null_distribution(
        &self,
        task: Task,
    ) -> Result<Option<(NullDistribution, String)>, Failure> {
        let wanted = self.prepared.null_key(&self.corrected.file.hash, &self.corrected.schedule);
        let serves = |nulls: &NullDistribution| nulls.serves(&wanted, &self.prepared.library);
        if let Some(found) = self.given(&serves, &wanted)? {
            if matches!(task, Task::All | Task::Merge) {
                return Ok(Some(found));
            }
            let text = format!("{} serves: there are no null campaigns to compute\n", found.1);
            show::summary(self.common, &text);
            return Ok(None);
        }
        let inputs =
            Inputs::default().with("seed", &self.seed.to_string()).with("design", &format!("{wanted:?}"));
        let store = Store::beside(&self.common.out("discover"), inputs)?.labelled(task.label());
        if !self.campaigns(task, &store)? {
            return Ok(None);
        }
        let mut nulls = kept_nulls::null_distribution(self.prepared, self.seed, &store, self.common);
        nulls.key = wanted;
        if task == Task::All {
            // A store that resists is found again, or is of other inputs and ignored.
            let _ = store.close();
        }
        Ok(Some((nulls, "made now".to_owned())))
    }

    /// The given or shipped one, or the last, if it serves; a given one must.
    fn given(
        &self,
        serves: &dyn Fn(&NullDistribution) -> bool,
        wanted: &NullKey,
    ) -> Result<Option<(NullDistribution, String)>, Failure> {
        if let Some(path) = self.named {
            let nulls: NullDistribution = nastran::ron_file::read(path)?;
            if serves(&nulls) {
                return Ok(Some((nulls, path.display().to_string())));
            }
            let differs = nulls.key.differs_in(wanted);
            let of = if differs.is_empty() {
                "lacks effects of the library".to_owned()
            } else {
                format!("does not fit; what differs: {}", differs.join(", "))
            };
            return Err(InputError::in_file(path, format!("this null distribution {of}"))
                .with_help("leave --null-distribution out to have it made for this one")
                .into());
        }
        beside_or_last(&self.corrected.file, serves)
    }

    /// Does a task; whether the distribution is to be made of campaigns then.
    fn campaigns(&self, task: Task, store: &Store) -> Result<bool, Failure> {
        let row = self.row();
        match task {
            Task::All => {
                if !self.common.quiet {
                    show::note(
                        "no null distribution for this wing, campaign and library of effects: made now (a minute or so)",
                    );
                }
                return Ok(true);
            }
            Task::Merge => {
                merging::one_state(store)?;
                let missing = row.iter().filter(|case| !store.has(&kept_nulls::part(k(case))));
                let mut missing: Vec<Fingerprint> = missing.map(|case| case.hash).collect();
                missing.sort_unstable();
                merging::complete(store, &missing, || self.row())?;
                merging::remarks(store);
                return Ok(true);
            }
            Task::Part(share) => {
                let own = share_of(row, share);
                self.fly(&own, store);
                let seconds = self.start.elapsed().as_secs_f64();
                let (own, folder) = (own.len(), store.folder().display());
                let text = format!("part {share}: {own} null campaigns, {seconds:.1} s; kept in {folder}\n");
                show::summary(self.common, &text);
            }
            Task::Case(hash) => {
                let Some(case) = row.iter().find(|case| case.hash == hash) else {
                    return Err(merging::no_such_case(hash));
                };
                self.fly(&[*case], store);
                show::summary(self.common, &format!("{} is kept\n", kept_nulls::part(k(case))));
            }
            Task::Prepare => {
                merging::one_state(store)?;
                let text = format!(
                    "{} null campaigns; nothing in {} is of another state\n",
                    row.len(),
                    store.folder().display()
                );
                show::summary(self.common, &text);
            }
            Task::Status => {
                status::show(self.common, store, &status::status("discover", store, row))?;
            }
            Task::Estimate => {
                let row = share_of(row, ALL);
                let three: Vec<Weighed> = row.iter().take(3).copied().collect();
                self.fly(&three, store);
                let told: Vec<(Weighed, Told)> =
                    three.iter().filter_map(|case| Some((*case, store.told_of(case.hash)?))).collect();
                self.estimate.put(Estimate::of_some(&row, &told, self.start));
            }
        }
        Ok(false)
    }

    /// All campaigns; they cost the same.
    fn row(&self) -> Vec<Weighed> {
        let weighed = |k: u64| {
            let hash = Store::hash(&kept_nulls::part(k));
            let number = usize::try_from(k).unwrap_or(usize::MAX);
            let frame = Fingerprint::default();
            Weighed { frame, is_late: false, group: frame, unit: hash, hash, cost: 1, number }
        };
        (0..self.prepared.data.rules.nulls.campaigns).map(weighed).collect()
    }

    fn fly(&self, row: &[Weighed], store: &Store) {
        let mut wanted: Vec<u64> = row.iter().map(k).collect();
        wanted.sort_unstable();
        kept_nulls::some(self.prepared, self.seed, &wanted, store, self.common);
    }
}

/// The number of a campaign.
fn k(case: &Weighed) -> u64 {
    case.number as u64
}

/// The one beside the wing's file, or that of the last `discover`, if it serves; and where it is.
///
/// # Errors
/// If it stands beside the wing in both forms of a file.
pub(crate) fn beside_or_last(
    file: &WingFile,
    serves: &dyn Fn(&NullDistribution) -> bool,
) -> Result<Option<(NullDistribution, String)>, Failure> {
    let beside = expected_in(folder_of(&file.path), "null_distribution")?;
    let last = crate::common::results("discover").join("null_distribution.ron");
    for path in [beside, last] {
        let nulls: Option<NullDistribution> = nastran::ron_file::read(&path).ok();
        if let Some(nulls) = nulls.filter(serves) {
            return Ok(Some((nulls, path.display().to_string())));
        }
    }
    Ok(None)
}

/// A null distribution from campaigns without effect, made now in one process; those of a run that was stopped stand beside the results.
///
/// # Errors
/// If nothing can be kept there.
pub(crate) fn made_now(
    key: NullKey,
    prepared: &Prepared,
    seed: u64,
    out: &Path,
    common: &Common,
) -> Result<NullDistribution, Failure> {
    let inputs = Inputs::default().with("seed", &seed.to_string()).with("design", &format!("{key:?}"));
    let store = Store::beside(out, inputs)?;
    let nulls = kept_nulls::null_distribution(prepared, seed, &store, common);
    // A store that resists is found again, or is of other inputs and ignored.
    let _ = store.close();
    Ok(NullDistribution { key, ..nulls })
}
