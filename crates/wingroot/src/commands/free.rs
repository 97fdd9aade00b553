//! `free`: what a measured rig that nobody drives lacks, and the cycles it has where it was not fitted.

use clap::Args;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Instant;

use free::campaign::{Run, read, runs_file};
use free::cycles::fold_m_s;
use free::points::points;
use free::predict::{Prediction, measured_onset_m_s, predictions, score};
use free::rig::Rig;
use free::search::{Found, search_scales};
use free::verdict::Answer;
use nastran::InputError;

use super::free_figures;
use super::free_result::{Beside, FreeResult, ScoreResult, candidates, effects};
use crate::args::Common;
use crate::commands::result_parts::as_json;
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::{paths, show};

/// Options of `free`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot free
  wingroot free --rig my_rig/rig.ron

`wingroot new rig --example bristol` makes the folder of a measured rig.")]
pub struct FreeArgs {
    /// The rig [default: rig.ron of the current folder]; its folder has runs.csv and the folder free
    #[arg(long, value_name = "FILE")]
    pub(crate) rig: Option<PathBuf>,
}

/// Oscillations up to this amplitude are small, rad.
const SMALL_RAD: f64 = 0.012;
/// A fold is looked for so far below and above the lowest cycle measured, in such steps, m/s.
const FOLD_BELOW_M_S: f64 = 4.0;
const FOLD_ABOVE_M_S: f64 = 2.0;
const FOLD_STEP_M_S: f64 = 0.1;

/// A search with what it was made of.
struct Searched {
    rig: Rig,
    runs: Vec<Run>,
    held_out: Vec<bool>,
    found: Found,
    points: usize,
    predictions: Vec<Prediction>,
}

/// Runs the command.
pub(crate) fn run(args: &FreeArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let path = paths::rig(args.rig.as_deref())?;
    let campaign = paths::folder_of(&path).to_path_buf();
    let (rig, runs) = (Rig::read(&path)?, read(&campaign)?);
    let searched = Searched::new(&rig, runs).map_err(|error| error.or_in(&runs_file(&campaign)))?;
    let result = searched.result(start.elapsed().as_secs_f64());
    let text = told(&result);
    let result = as_json(&result)?;
    let folder = ResultFolder::begin(&common.out("free"))?;
    folder.input("rig", &path)?;
    folder.input("runs", &runs_file(&campaign))?;
    folder.write_text("cycles.csv", &free_figures::csv(&searched.predictions))?;
    if !searched.predictions.is_empty() {
        let figure = free_figures::cycles(&searched.predictions);
        folder.write_figure("cycles", free_figures::CAPTION, figure)?;
    }
    if let Some(figure) = free_figures::portraits(&searched.predictions) {
        folder.write_figure("portraits", free_figures::PORTRAIT_CAPTION, figure)?;
    }
    folder.write_json("result.json", &result)?;
    let out = folder.commit()?;
    show::summary(common, &format!("{text}written to {}", out.display()));
    show::json(common, &result)
}

impl Searched {
    fn new(rig: &Rig, runs: Vec<Run>) -> Result<Self, InputError> {
        let held_out = rig.held_out.of(&runs);
        let fitted: Vec<Run> =
            runs.iter().zip(&held_out).filter(|(_, held)| !**held).map(|(run, _)| run.clone()).collect();
        let points = points(&fitted, &rig.scatter);
        if points.is_empty() {
            return Err(InputError::general(
                "no run that is not held out shows an oscillation above turbulence",
            )
            .with_help("hold less out, or measure cycles or stronger blows"));
        }
        let (found, place) = search_scales(rig, &points);
        let rig = rig.scaled().swap_remove(place);
        let predictions = predictions(&rig, &found.fitted, &runs, &held_out);
        Ok(Self { rig, runs, held_out, found, points: points.len(), predictions })
    }

    fn result(&self, seconds: f64) -> FreeResult {
        let Self { rig, found, .. } = self;
        let answer = found.answer();
        let fitted_day =
            |day: u32| self.runs.iter().zip(&self.held_out).any(|(run, held)| run.day == day && !held);
        let of = |chosen: &dyn Fn(&Prediction) -> bool| {
            ScoreResult::from(score(self.predictions.iter().filter(|p| chosen(p))))
        };
        FreeResult {
            command: "free",
            name: rig.name.clone(),
            verdict: answer.kind(),
            sentence: answer.sentence(),
            effects: effects(found),
            rivals: if matches!(answer, Answer::Ambiguous(..)) { found.rivals.clone() } else { Vec::new() },
            rig: self.found.fitted.model(rig, 0).rig.into(),
            candidates: candidates(found),
            points: self.points,
            left: found.fitted.chi2 / found.residuals.max(1) as f64,
            fitted: of(&|p| !p.held_out),
            held_out_airspeeds: of(&|p| p.held_out && fitted_day(p.run.day)),
            held_out_days: of(&|p| !fitted_day(p.run.day)),
            onset: self.onset(),
            fold: self.fold(),
            seconds,
        }
    }

    /// Of the linear rig as small oscillations calibrate it, over the airspeeds of the runs.
    fn onset(&self) -> Beside {
        let airspeeds = || self.runs.iter().map(|run| run.airspeed_m_s);
        let range = [0.5 * airspeeds().fold(f64::INFINITY, f64::min), 1.3 * airspeeds().fold(0.0, f64::max)];
        let first = &self.runs[0];
        let section = self.found.linear.model(&self.rig, first.day).section();
        Beside {
            predicted_m_s: section.onset_m_s(first.rho_kg_m3, range),
            measured_m_s: measured_onset_m_s(&points(&self.runs, &self.rig.scatter), SMALL_RAD),
        }
    }

    /// On the day of the lowest cycle that was measured.
    fn fold(&self) -> Beside {
        let lowest = self.predictions.iter().min_by(|a, b| a.run.airspeed_m_s.total_cmp(&b.run.airspeed_m_s));
        let Some(lowest) = lowest else { return Beside { predicted_m_s: None, measured_m_s: None } };
        let v_m_s = lowest.run.airspeed_m_s;
        let model = self.found.fitted.model(&self.rig, lowest.run.day);
        let range = [(v_m_s - FOLD_BELOW_M_S).max(FOLD_STEP_M_S), v_m_s + FOLD_ABOVE_M_S];
        let predicted_m_s = fold_m_s(&model, lowest.run.rho_kg_m3, range, FOLD_STEP_M_S);
        Beside { predicted_m_s, measured_m_s: Some(v_m_s) }
    }
}

/// What is said at the terminal.
fn told(result: &FreeResult) -> String {
    let mut text = format!("{}\n", result.sentence);
    for effect in &result.effects {
        for p in &effect.parameters {
            let _ = writeln!(text, "  {}: {} {:.4} +- {:.4}", effect.name, p.name, p.value, p.sd);
        }
    }
    let scores = [
        ("fitted", result.fitted),
        ("airspeeds held out", result.held_out_airspeeds),
        ("days held out", result.held_out_days),
    ];
    for (name, score) in scores.into_iter().filter(|(_, score)| score.cycles > 0) {
        let _ = writeln!(
            text,
            "  {name}: {} cycles, of which the linear rig has 0 and this one {}; pitch amplitude within {:.1} % rms, frequency {:.2} %",
            score.cycles,
            score.cycles - score.missing,
            score.amplitude_error_percent,
            score.frequency_error_percent
        );
    }
    for (name, beside) in [("onset", result.onset), ("fold", result.fold)] {
        let of = |v: Option<f64>| v.map_or_else(|| "none".to_owned(), |v| format!("{v:.1} m/s"));
        let _ =
            writeln!(text, "  {name}: {}, measured {}", of(beside.predicted_m_s), of(beside.measured_m_s));
    }
    let _ = write!(text, "{:.1} s; ", result.seconds);
    text
}
