//! `hidden`: the blind benchmark of `discover` on campaigns in which a known effect is hidden, of a wing with another discretisation
//! or of another program (`--truth vortex`).
//!
//! A case and its verdict go to one folder, its sealed answer to another that only the scoring reads. Cases that have a verdict
//! are not done again.

use std::path::Path;
use std::time::Instant;

use clap::Args;
use discover::result::DiscoverResult;
use hidden::score::{BenchmarkResult, gates};
use hidden::{Answer, Bench, CasePlan, Class, Families, Mix, cases, score};

use crate::args::{Common, whole};
use crate::commands::hidden_judge::{Judge, Setting, wing, with_judge};
use crate::commands::hidden_truth::Truth;
use crate::failure::Failure;
use crate::fingerprint::Fingerprint;
use crate::output::ResultFolder;
use crate::store::Store;
use crate::sweep::estimate::{Estimate, peak_memory_bytes};
use crate::sweep::split::{Weighed, share_of};
use crate::sweep::{SweepArgs, Task, merging, status};
use crate::{progress, show};

/// Options of `hidden`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot hidden --cases 20
  wingroot hidden --cases 600 --seed 2000000
  wingroot hidden --truth vortex --cases 40
  wingroot hidden --class paper_pair --cases 40

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
    /// Cases of one class alone, such as null, single, paper_pair or out_of_library; the first N of all classes otherwise
    #[arg(long, value_name = "CLASS")]
    pub(crate) class: Option<Class>,
    /// Judge no case, score those that were judged before
    #[arg(long)]
    pub(crate) finished: bool,
    /// Which of the cases
    #[command(flatten)]
    pub(crate) sweep: SweepArgs,
}

/// First seed of the development range.
const FIRST_SEED: u64 = 1;

impl From<tunnel::TunnelError> for Failure {
    fn from(error: tunnel::TunnelError) -> Self {
        Self::computation(error)
    }
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
        HiddenArgs::default().setting("bench".to_owned()),
        &Common { quiet: true, ..Common::default() },
        |judge, bench| {
            let plan = cases(FIRST_SEED, 3, &Mix::only(Class::Paper)).remove(2);
            let case = judge.written(&bench.case(&plan), "case")?;
            let start = Instant::now();
            let prepared = judge.read(&case, &plan)?;
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

/// What is asked for, while the judge is there.
struct Session<'a> {
    judge: &'a Judge<'a>,
    bench: &'a Bench,
    args: &'a HiddenArgs,
    seed: u64,
    common: &'a Common,
}

/// Runs the command.
pub(crate) fn run(args: &HiddenArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let task = args.sweep.task()?;
    let out = common.out(args.truth.folder());
    let seed = common.seed.unwrap_or(FIRST_SEED);
    let folders = [out.with_extension("cases"), out.with_extension("sealed")];
    let folders = [folders[0].as_path(), folders[1].as_path()];
    let judged = with_judge(folders, args.setting(task.label()), common, |judge, bench| {
        Session { judge, bench, args, seed, common }.run(task, start)
    })?;
    let Some(judged) = judged else { return Ok(()) };
    let families = Families::frozen()?;
    let metrics = score(&judged, &families);
    let seconds = start.elapsed().as_secs_f64();
    let result = BenchmarkResult {
        command: "hidden".to_owned(),
        seed,
        class: args.class,
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

impl HiddenArgs {
    fn setting(&self, label: String) -> Setting {
        Setting { truth: self.truth, own_static_points: self.own_static_points, label }
    }
}

impl Session<'_> {
    /// Does a task; what is to be scored, if it is that.
    fn run(&self, task: Task, start: Instant) -> Result<Option<Vec<(Answer, DiscoverResult)>>, Failure> {
        let verdicts = self.judge.verdicts();
        match task {
            Task::All if self.args.finished => {}
            Task::All => drop(self.judge_all(&self.row())?),
            Task::Part(share) => {
                let row = share_of(self.row(), share);
                let before = self.judge_all(&row)?;
                let text = format!(
                    "part {share}: {} of {} cases, {before} judged before, {:.0} s; kept in {}\n",
                    row.len(),
                    self.args.cases,
                    start.elapsed().as_secs_f64(),
                    verdicts.folder().display()
                );
                show::summary(self.common, &text);
                return Ok(None);
            }
            Task::Case(hash) => return self.again(hash).map(|()| None),
            Task::Prepare => {
                let text = format!(
                    "{} cases; thresholds are kept, {:.0} s\n",
                    self.args.cases, self.judge.nulls_seconds
                );
                show::summary(self.common, &text);
                return Ok(None);
            }
            Task::Status => {
                let status = status::status("hidden", verdicts, self.row());
                return status::show(self.common, verdicts, &status).map(|()| None);
            }
            Task::Estimate => {
                self.args.sweep.estimate.put(self.estimate(start)?);
                return Ok(None);
            }
            Task::Merge => merging::one_state(verdicts)?,
        }
        self.finished(task).map(Some)
    }

    /// Answers and verdicts of all cases, or with `--finished` of those that were judged.
    fn finished(&self, task: Task) -> Result<Vec<(Answer, DiscoverResult)>, Failure> {
        if task == Task::Merge && !self.args.finished {
            let is_missing = |case: &Weighed| !self.judge.is_finished(&self.name(case.number));
            let mut missing: Vec<Fingerprint> =
                self.row().into_iter().filter(is_missing).map(|case| case.hash).collect();
            missing.sort_unstable();
            merging::complete(self.judge.verdicts(), &missing, || self.row())?;
        }
        merging::remarks(self.judge.verdicts());
        self.judge.clear();
        Ok(self.plans().iter().filter_map(|plan| self.judge.earlier(&self.name(plan.index))).collect())
    }

    fn plans(&self) -> Vec<CasePlan> {
        cases(self.seed, self.args.cases, &self.args.class.map_or_else(Mix::default, Mix::only))
    }

    /// What a case is called in the stores.
    fn name(&self, index: usize) -> String {
        let class = self.args.class.map_or_else(String::new, |class| format!("_{class:?}"));
        format!("{}{class}_{index:05}", self.seed)
    }

    /// All cases; what one costs is not known before it is judged.
    fn row(&self) -> Vec<Weighed> {
        let weighed = |plan: CasePlan| {
            let hash = Store::hash(&self.name(plan.index));
            let frame = Fingerprint::default();
            Weighed { frame, is_late: false, group: hash, unit: hash, hash, cost: 1, number: plan.index }
        };
        self.plans().into_iter().map(weighed).collect()
    }

    /// Judges what is not judged: one after the other, each with all processors, as a user's campaign has them: its seconds
    /// are a user's. How many were judged before.
    fn judge_all(&self, row: &[Weighed]) -> Result<usize, Failure> {
        let is_missing = |case: &&Weighed| !self.judge.is_finished(&self.name(case.number));
        let mut missing: Vec<usize> = row.iter().filter(is_missing).map(|case| case.number).collect();
        missing.sort_unstable();
        let plans = self.plans();
        let bar = progress::bar(self.common, missing.len(), "cases");
        for plan in plans.iter().filter(|plan| missing.binary_search(&plan.index).is_ok()) {
            self.judge.case(self.bench, plan, &self.name(plan.index))?;
            bar.inc(1);
        }
        progress::end(&bar);
        Ok(row.len() - missing.len())
    }

    /// Three cases judged, each with all processors, and what all of them will take.
    fn estimate(&self, start: Instant) -> Result<Estimate, Failure> {
        let setup_s = start.elapsed().as_secs_f64();
        let three: Vec<Weighed> = self.row().into_iter().take(3).collect();
        self.judge_all(&three)?;
        let told = three.iter().filter_map(|case| self.judge.verdicts().told_of(case.hash));
        let threads = rayon::current_num_threads() as f64;
        let flown = told.map(|told| (told.part, threads * told.seconds.unwrap_or(0.0)));
        let flown: Vec<(String, f64)> = flown.collect();
        let mean_s = flown.iter().map(|(_, seconds)| seconds).sum::<f64>() / flown.len().max(1) as f64;
        let seconds = mean_s * self.args.cases as f64;
        let memory_bytes = peak_memory_bytes();
        Ok(Estimate { cases: self.args.cases, flown, setup_s, seconds, memory_bytes })
    }

    /// One case, whether it was judged or not.
    fn again(&self, hash: Fingerprint) -> Result<(), Failure> {
        let plans = self.plans();
        let found = plans.iter().find(|plan| Store::hash(&self.name(plan.index)) == hash);
        let Some(plan) = found else { return Err(merging::no_such_case(hash)) };
        let name = self.name(plan.index);
        let verdict = self.judge.case(self.bench, plan, &name)?;
        show::summary(self.common, &format!("{name}: judged in {:.1} s\n", verdict.seconds.unwrap_or(0.0)));
        show::json(self.common, &verdict)
    }
}

fn summary(result: &BenchmarkResult, out: &Path) -> String {
    let BenchmarkResult { scored, seconds, .. } = result;
    let mut table = report::Table::new(&["gate", "limit", "value", "95 %", "n", "reached"]);
    // of one class alone most have no cases
    for gate in result.gates.iter().filter(|gate| gate.value.is_some()) {
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
