//! Cases of `hidden` made and judged, each answer and verdict kept as soon as it is there.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::time::{Duration, Instant};

use coupling::ElasticWing;
use discover::analysis::{Prepared, Rigs};
use discover::finding::{Finding, Sources};
use discover::model_form::LatticeVariant;
use discover::null_distribution::NullDistribution;
use discover::result::DiscoverResult;
use discover::rules::Rules;
use hidden::{Answer, Bench, Case, CasePlan, Class, Fineness, Mix, cases};
use nastran::InputError;

use crate::args::Common;
use crate::commands::hidden_truth::Truth;
use crate::failure::Failure;
use crate::store::{Inputs, Store, Told, unique};
use crate::{blind, kept_nulls};

/// The example and its file of the wing in whose model effects are missing; it is unpacked beside the cases.
const WING: (&str, &str) = ("tuflex", "wing_beam.ron");
/// First seed of the calibration range: the null distribution's campaign.
const NULLS_SEED: u64 = 1_000_000;
/// How long campaigns that a killed process left stay at least.
const LEFT_FOR: Duration = Duration::from_secs(3600);

/// What cases are judged as, beside the seed.
#[derive(Debug, Clone)]
pub(crate) struct Setting {
    /// Which program makes the campaigns.
    pub(crate) truth: Truth,
    /// Track B.
    pub(crate) own_static_points: bool,
    /// What this process' segments of the stores begin with.
    pub(crate) label: String,
}

/// What serves all cases.
pub(crate) struct Judge<'a> {
    rigs: Rigs<'a>,
    /// Thresholds.
    pub(crate) nulls: NullDistribution,
    folder: PathBuf,
    sealed: PathBuf,
    setting: Setting,
    common: Common,
    /// Answers and verdicts.
    stores: OnceLock<[Store; 2]>,
    /// What the null distribution took, s.
    pub(crate) nulls_seconds: f64,
}

/// The wing's file, unpacked into a folder of cases, where other processes may be reading it.
pub(crate) fn wing(folder: &Path) -> Result<PathBuf, Failure> {
    let (example, file) = WING;
    let unpacked = folder.join(example);
    let example =
        shipped::example(example).ok_or_else(|| Failure::computation("the program lacks its example"))?;
    let refused = |error: &dyn std::fmt::Display| {
        InputError::in_file(&unpacked, format!("the wing cannot be unpacked here: {error}"))
            .with_help("choose another folder with --out DIR")
    };
    for (name, bytes) in example.files().map_err(|error| refused(&error))? {
        let path = unpacked.join(name);
        if std::fs::read(&path).is_ok_and(|known| known == bytes) {
            continue;
        }
        write(&path, &bytes).map_err(|error| refused(&error))?;
    }
    Ok(unpacked.join(file))
}

/// Sets up the shipped wing and the benchmark's null distribution in a folder of cases (the second is for answers), and works
/// with them.
pub(crate) fn with_judge<T>(
    [folder, sealed]: [&Path; 2],
    setting: Setting,
    common: &Common,
    work: impl FnOnce(&Judge<'_>, &Bench) -> Result<T, Failure>,
) -> Result<T, Failure> {
    let path = wing(folder)?;
    let mut bench = Bench::new(&path, Fineness::BENCHMARK)?;
    if setting.truth == Truth::Vortex {
        bench = bench.with_vortices(&path)?;
    }
    let (file, wing) = ElasticWing::read(&path)?;
    let rules = Rules::default();
    let lattice = LatticeVariant::of(&file, &wing, &rules.variants);
    let mut judge = Judge {
        rigs: Rigs::new(&file, &wing, lattice.as_ref(), rules)?,
        nulls: NullDistribution::default(),
        folder: folder.to_path_buf(),
        sealed: sealed.to_path_buf(),
        setting,
        common: common.clone(),
        stores: OnceLock::new(),
        nulls_seconds: 0.0,
    };
    let start = Instant::now();
    judge.nulls = judge.null_distribution(&bench)?;
    judge.nulls_seconds = start.elapsed().as_secs_f64();
    work(&judge, &bench)
}

impl Judge<'_> {
    /// Thresholds from null campaigns of the model in the design of the benchmark, kept for the next run.
    fn null_distribution(&self, bench: &Bench) -> Result<NullDistribution, Failure> {
        let path = self.folder.join("null_distribution.ron");
        let plan = cases(NULLS_SEED, 1, &Mix::only(Class::Null));
        let folder = self.written(&bench.case(&plan[0]), "bank")?;
        let left_out = plan[0].leave_out.as_deref();
        let case = blind::read(&self.rigs, &folder, self.setting.own_static_points, left_out)?;
        let _ = std::fs::remove_dir_all(&folder);
        let key = case.prepared.null_key(&self.rigs.own.file().hash, &case.schedule);
        let kept: Option<NullDistribution> = nastran::ron_file::read(&path).ok();
        if let Some(nulls) = kept.filter(|kept| kept.serves(&key, &case.prepared.library)) {
            return Ok(nulls);
        }
        let store = Store::new(self.folder.join("null_campaigns"), &format!("{key:?}"));
        let mut nulls = kept_nulls::null_distribution(&case.prepared, NULLS_SEED, &store, &self.common);
        // A store that resists is found again, or is of other inputs and ignored.
        let _ = store.close();
        nulls.key = key;
        write(&path, nastran::ron_file::to_text(&nulls)?.as_bytes()).map_err(Failure::computation)?;
        Ok(nulls)
    }

    /// Where answers and verdicts are kept; those of other rules, another library or another program are not found there.
    fn stores(&self) -> &[Store; 2] {
        self.stores.get_or_init(|| {
            let inputs = Inputs::default()
                .with("track", if self.setting.own_static_points { "B" } else { "A" })
                .with("truth", self.setting.truth.name())
                .with("null distribution", &format!("{:?}", self.nulls.key));
            [&self.sealed, &self.folder.join("verdicts")]
                .map(|folder| Store::new(folder.clone(), inputs.clone()).labelled(self.setting.label.clone()))
        })
    }

    /// The verdicts.
    pub(crate) fn verdicts(&self) -> &Store {
        &self.stores()[1]
    }

    /// Whether a case was judged before.
    pub(crate) fn is_finished(&self, name: &str) -> bool {
        self.stores().iter().all(|store| store.has(name))
    }

    /// Answer and verdict of a case that was judged before.
    pub(crate) fn earlier(&self, name: &str) -> Option<(Answer, DiscoverResult)> {
        let [sealed, verdicts] = self.stores();
        Some((sealed.get(name)?, verdicts.get(name)?))
    }

    /// Makes a case and lets `discover` judge it; the verdict is kept unless one is there.
    pub(crate) fn case(&self, bench: &Bench, plan: &CasePlan, name: &str) -> Result<DiscoverResult, Failure> {
        let case = bench.case(plan);
        let folder = self.written(&case, name)?;
        let start = Instant::now();
        let verdict = match self.read(&folder, plan) {
            Ok(prepared) => self.judged(&prepared, plan, start),
            // a campaign that cannot be read is refused as a user's would be
            Err(Failure::Input(refused)) => {
                let seconds = start.elapsed().as_secs_f64();
                DiscoverResult::at_fault(Vec::new(), Some(refused.message), seconds)
            }
            Err(other) => return Err(other),
        };
        let [sealed, verdicts] = self.stores();
        let told = Told { part: name.to_owned(), seconds: Some(start.elapsed().as_secs_f64()), failed: None };
        if !self.is_finished(name) {
            sealed.put_told(&told, &case.answer)?;
            verdicts.put_told(&told, &verdict)?;
        }
        // measurements are made again from the seed if they are wanted
        let _ = std::fs::remove_dir_all(folder);
        Ok(verdict)
    }

    /// Writes a case's files into a folder of this process' own.
    pub(crate) fn written(&self, case: &Case, name: &str) -> Result<PathBuf, Failure> {
        let folder = self.campaigns().join(format!("{name}-{}", unique()));
        case.files.write(&folder).map_err(Failure::computation)?;
        Ok(folder)
    }

    /// Where campaigns are while they are judged.
    fn campaigns(&self) -> PathBuf {
        self.folder.join("campaigns")
    }

    /// Removes campaigns that killed processes left.
    pub(crate) fn clear(&self) {
        let entries = std::fs::read_dir(self.campaigns()).into_iter().flatten().flatten();
        for path in entries.map(|entry| entry.path()) {
            let changed = path.metadata().and_then(|data| data.modified()).ok();
            if changed.and_then(|at| at.elapsed().ok()).is_some_and(|age| age > LEFT_FOR) {
                let _ = std::fs::remove_dir_all(path);
            }
        }
    }

    /// Reads and calibrates a case that was written.
    pub(crate) fn read(&self, folder: &Path, plan: &CasePlan) -> Result<Prepared, Failure> {
        let left_out = plan.leave_out.as_deref();
        Ok(blind::read(&self.rigs, folder, self.setting.own_static_points, left_out)?.prepared)
    }

    fn judged(&self, prepared: &Prepared, plan: &CasePlan, start: Instant) -> DiscoverResult {
        let seconds = || start.elapsed().as_secs_f64();
        let faults = prepared.defects();
        if !faults.is_empty() {
            return DiscoverResult::at_fault(faults, None, seconds());
        }
        let finding = Finding::search(prepared, &self.nulls, plan.seed);
        let corrections = if self.setting.own_static_points {
            "the case's own static points"
        } else {
            "static points without the effect"
        };
        let sources = Sources { corrections: corrections.to_owned(), ..Sources::default() };
        let result = finding.result(&sources, false, 0.0);
        DiscoverResult { seconds: Some(seconds()), ..result }
    }
}

/// Writes a file whole or not at all, whoever else writes it.
fn write(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder)?;
    }
    let partial = path.with_extension(format!("partial-{}", unique()));
    std::fs::write(&partial, bytes)?;
    std::fs::rename(&partial, path)
}
