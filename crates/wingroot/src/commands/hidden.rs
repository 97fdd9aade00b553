//! `hidden`: the blind benchmark of `discover` on campaigns in which a known effect is hidden, of a wing with another discretisation
//! or of another program (`--truth vortex`).
//!
//! A case and its verdict go to one folder, its sealed answer to another that only the scoring reads. Cases that have a verdict
//! are not done again.

use clap::{Args, ValueEnum};
use nastran::InputError;
use std::path::{Path, PathBuf};
use std::time::Instant;

use coupling::ElasticWing;
use discover::analysis::{Prepared, Rigs};
use discover::finding::{Finding, Sources};
use discover::model_form::LatticeVariant;
use discover::null_distribution::NullDistribution;
use discover::result::DiscoverResult;
use discover::rules::Rules;
use hidden::score::{BenchmarkResult, gates};
use hidden::{Answer, Bench, Case, CasePlan, Class, Families, Fineness, Mix, cases, score};

use crate::args::{Common, whole};
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::store::Store;
use crate::{blind, kept_nulls, progress, show};

/// Options of `hidden`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot hidden --cases 20
  wingroot hidden --cases 600 --seed 2000000
  wingroot hidden --truth vortex --cases 40

Seeds below 1000000 are for development, below 2000000 for thresholds, from there for tests. Verdicts are
kept in out/hidden.cases and answers in out/hidden.sealed (of vortices in out/hidden_vortex.*), so that a run that was
stopped goes on; remove both to begin anew, as after a change of `discover`.")]
pub struct HiddenArgs {
    /// Number of cases
    #[arg(long, value_name = "N", default_value_t = 40, value_parser = whole::<100_000>)]
    pub(crate) cases: usize,
    /// Calibrate each case on its own static points, as a user does (track B), instead of effect-free ones
    #[arg(long)]
    pub(crate) own_static_points: bool,
    /// Which program makes the campaigns
    #[arg(long, value_enum, default_value_t = Truth::DoubletLattice)]
    pub(crate) truth: Truth,
    /// Judge no case, score those that were judged before
    #[arg(long)]
    pub(crate) finished: bool,
}

/// The programs that make campaigns.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Truth {
    /// The model's own library with another mesh: fast
    #[default]
    #[value(name = "doublet")]
    DoubletLattice,
    /// A vortex lattice and a beam of their own, which share nothing with the model
    Vortex,
}

impl Truth {
    /// Name in results.
    fn name(self) -> &'static str {
        match self {
            Self::DoubletLattice => "doublet",
            Self::Vortex => "vortex",
        }
    }

    /// Folder of results if none is named.
    fn folder(self) -> &'static str {
        match self {
            Self::DoubletLattice => "hidden",
            Self::Vortex => "hidden_vortex",
        }
    }
}

/// The example and its file of the wing in whose model effects are missing; it is unpacked beside the cases.
const WING: (&str, &str) = ("tuflex", "wing_beam.ron");
/// First seed of the calibration range: the null distribution's campaign.
const NULLS_SEED: u64 = 1_000_000;
/// First seed of the development range.
const FIRST_SEED: u64 = 1;

impl From<tunnel::TunnelError> for Failure {
    fn from(error: tunnel::TunnelError) -> Self {
        Self::computation(error)
    }
}

/// What serves all cases.
struct Judge<'a> {
    rigs: Rigs<'a>,
    nulls: NullDistribution,
    folder: PathBuf,
    sealed: PathBuf,
    own_static_points: bool,
    truth: Truth,
    common: Common,
    /// What the null distribution took, s.
    nulls_seconds: f64,
}

/// A case with its time and model runs, for `bench`.
pub struct Timed {
    /// Reading, calibration and search of one case, s.
    pub seconds: f64,
    /// How often the campaign was flown.
    pub model_runs: usize,
    /// Effects and forms of the library.
    pub effects: usize,
    /// The null distribution for the case's design, s.
    pub nulls_seconds: f64,
}

/// The joiner and the ailerons hidden together, judged in a folder that is removed again.
///
/// # Errors
/// If the folder cannot be written, or the case cannot be judged.
pub fn timed_case(folder: &Path) -> Result<Timed, Failure> {
    let timed = with_judge(
        [folder, folder],
        &HiddenArgs::default(),
        &Common { quiet: true, ..Common::default() },
        |judge, bench| {
            let plan = cases(FIRST_SEED, 3, &Mix::only(Class::Paper)).remove(2);
            judge.written(&bench.case(&plan), "case")?;
            let start = Instant::now();
            let prepared = judge.read(&folder.join("case"), &plan)?;
            let report = prepared.search(&judge.nulls, plan.seed);
            let seconds = start.elapsed().as_secs_f64();
            Ok(Timed {
                seconds,
                model_runs: report.model_runs,
                effects: prepared.library.len(),
                nulls_seconds: judge.nulls_seconds,
            })
        },
    );
    std::fs::remove_dir_all(folder).map_err(Failure::computation)?;
    timed
}

/// The wing's file, unpacked into a folder of cases.
fn wing(folder: &Path) -> Result<PathBuf, Failure> {
    let (example, file) = WING;
    let unpacked = folder.join(example);
    let example =
        shipped::example(example).ok_or_else(|| Failure::computation("the program lacks its example"))?;
    example.write(&unpacked).map_err(|error| {
        InputError::in_file(&unpacked, format!("the wing cannot be unpacked here: {error}"))
            .with_help("choose another folder with --out DIR")
    })?;
    Ok(unpacked.join(file))
}

/// Sets up the shipped wing and the benchmark's null distribution in a folder of cases (the second is for answers), and works
/// with them.
fn with_judge<T>(
    [folder, sealed]: [&Path; 2],
    args: &HiddenArgs,
    common: &Common,
    work: impl FnOnce(&Judge<'_>, &Bench) -> Result<T, Failure>,
) -> Result<T, Failure> {
    let path = wing(folder)?;
    let mut bench = Bench::new(&path, Fineness::BENCHMARK)?;
    if args.truth == Truth::Vortex {
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
        own_static_points: args.own_static_points,
        truth: args.truth,
        common: common.clone(),
        nulls_seconds: 0.0,
    };
    let start = Instant::now();
    judge.nulls = judge.null_distribution(&bench)?;
    judge.nulls_seconds = start.elapsed().as_secs_f64();
    work(&judge, &bench)
}

/// Runs the command.
pub(crate) fn run(args: &HiddenArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let out = common.out(args.truth.folder());
    let seed = common.seed.unwrap_or(FIRST_SEED);
    let folders = [out.with_extension("cases"), out.with_extension("sealed")];
    let folders = [folders[0].as_path(), folders[1].as_path()];
    let judged = with_judge(folders, args, common, |judge, bench| {
        let mut plans = cases(seed, args.cases, &Mix::default());
        if args.finished {
            plans.retain(|plan| judge.earlier(&name(plan, seed)).is_some());
        }
        let bar = progress::bar(common, plans.len(), "cases");
        // one after the other, each with all processors, as a user's campaign has them: its seconds are a user's
        let judged = plans
            .iter()
            .map(|plan| {
                let one = judge.case(bench, plan, seed);
                bar.inc(1);
                one
            })
            .collect::<Result<Vec<(Answer, DiscoverResult)>, Failure>>();
        progress::end(&bar);
        judged
    })?;
    let families = Families::frozen()?;
    let metrics = score(&judged, &families);
    let seconds = start.elapsed().as_secs_f64();
    let result = BenchmarkResult {
        command: "hidden".to_owned(),
        seed,
        track: if args.own_static_points { "B" } else { "A" }.to_owned(),
        truth: args.truth.name().to_owned(),
        gates: gates(&metrics),
        scored: metrics,
        seconds,
    };
    let results = ResultFolder::begin(&out)?;
    results.input("wing", &wing(folders[0])?)?;
    results.write_json("result.json", &result)?;
    results.commit()?;
    show::summary(common, &summary(&result, &out));
    show::json(common, &result)
}

impl Judge<'_> {
    /// Thresholds from null campaigns of the model in the design of the benchmark, kept for the next run.
    fn null_distribution(&self, bench: &Bench) -> Result<NullDistribution, Failure> {
        let path = self.folder.join("null_distribution.ron");
        let plan = cases(NULLS_SEED, 1, &Mix::only(Class::Null));
        let folder = self.written(&bench.case(&plan[0]), "bank")?;
        let left_out = plan[0].leave_out.as_deref();
        let case = blind::read(&self.rigs, &folder, self.own_static_points, left_out)?;
        let key = case.prepared.null_key(&self.rigs.own.file().hash, &case.schedule);
        let kept: Option<NullDistribution> = nastran::ron_file::read(&path).ok();
        if let Some(nulls) = kept.filter(|kept| kept.serves(&key, &case.prepared.library)) {
            return Ok(nulls);
        }
        let store = Store::new(self.folder.join("null_campaigns"), &format!("{key:?}"));
        let mut nulls = kept_nulls::null_distribution(&case.prepared, NULLS_SEED, store, &self.common);
        nulls.key = key;
        write(&path, &nastran::ron_file::to_text(&nulls)?)?;
        Ok(nulls)
    }

    /// Where answers and verdicts are kept; those of other rules, another library or another program are not found there.
    fn stores(&self) -> [Store; 2] {
        let track = if self.own_static_points { "B" } else { "A" };
        let inputs = format!("{track} {} {:?}", self.truth.name(), self.nulls.key);
        [&self.sealed, &self.folder.join("verdicts")].map(|folder| Store::new(folder.clone(), &inputs))
    }

    /// Answer and verdict of a case that was judged before.
    fn earlier(&self, name: &str) -> Option<(Answer, DiscoverResult)> {
        let [sealed, verdicts] = self.stores();
        Some((sealed.get(name)?, verdicts.get(name)?))
    }

    /// Makes a case, or takes one that is there, and lets `discover` judge it.
    fn case(&self, bench: &Bench, plan: &CasePlan, seed: u64) -> Result<(Answer, DiscoverResult), Failure> {
        let name = name(plan, seed);
        if let Some(earlier) = self.earlier(&name) {
            return Ok(earlier);
        }
        let case = bench.case(plan);
        let folder = self.written(&case, &name)?;
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
        let answer = sealed.put(&name, &case.answer)?;
        let verdict = verdicts.put(&name, &verdict)?;
        // measurements are made again from the seed if they are wanted
        let _ = std::fs::remove_dir_all(folder);
        Ok((answer, verdict))
    }

    /// Writes a case's files into a folder of its own.
    fn written(&self, case: &Case, name: &str) -> Result<PathBuf, Failure> {
        let folder = self.folder.join(name);
        case.files.write(&folder).map_err(Failure::computation)?;
        Ok(folder)
    }

    /// Reads and calibrates a case that was written.
    fn read(&self, folder: &Path, plan: &CasePlan) -> Result<Prepared, Failure> {
        let left_out = plan.leave_out.as_deref();
        Ok(blind::read(&self.rigs, folder, self.own_static_points, left_out)?.prepared)
    }

    fn judged(&self, prepared: &Prepared, plan: &CasePlan, start: Instant) -> DiscoverResult {
        let seconds = || start.elapsed().as_secs_f64();
        let faults = prepared.defects();
        if !faults.is_empty() {
            return DiscoverResult::at_fault(faults, None, seconds());
        }
        let finding = Finding::search(prepared, &self.nulls, plan.seed);
        let corrections = if self.own_static_points {
            "the case's own static points"
        } else {
            "static points without the effect"
        };
        let sources = Sources { corrections: corrections.to_owned(), ..Sources::default() };
        let result = finding.result(&sources, false, 0.0);
        DiscoverResult { seconds: Some(seconds()), ..result }
    }
}

/// What a case is called in the stores.
fn name(plan: &CasePlan, seed: u64) -> String {
    format!("{seed}_{:05}", plan.index)
}

fn write(path: &Path, text: &str) -> Result<(), Failure> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(Failure::computation)?;
    }
    let partial = path.with_extension("partial");
    std::fs::write(&partial, text).map_err(Failure::computation)?;
    std::fs::rename(&partial, path).map_err(Failure::computation)
}

fn summary(result: &BenchmarkResult, out: &Path) -> String {
    let BenchmarkResult { scored, seconds, .. } = result;
    let mut table = report::Table::new(&["gate", "limit", "value", "95 %", "n", "reached"]);
    for gate in &result.gates {
        let metric = scored.metrics.get(&gate.metric);
        let number = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |value| format!("{value:.3}"));
        table.row([
            gate.metric.clone(),
            format!("{:.2}", gate.limit),
            number(gate.value),
            metric.map_or_else(String::new, |m| format!("{} .. {}", number(m.low), number(m.high))),
            metric.map_or_else(String::new, |m| m.n.to_string()),
            if gate.reached { "yes" } else { "no" }.to_owned(),
        ]);
    }
    format!("{table}\n{} cases, {seconds:.0} s; results in {}\n", scored.cases, out.display())
}
