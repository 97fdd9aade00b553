//! `pipeline`: calibrate a wing, correct its deflections, simulate its runs, find the effects it lacks, fly the
//! mirrored aircraft with them.

use clap::Args;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Instant;

use nastran::ron_or_json::expected_in;
use serde_json::Value;

use crate::args::{Common, Given, Measured};
use crate::commands::calibrate::CalibrateArgs;
use crate::commands::deflection::DeflectionArgs;
use crate::commands::discover::DiscoverArgs;
use crate::commands::fullaircraft_prepared::FullaircraftArgs;
use crate::commands::pipeline_result::PipelineResult;
use crate::commands::result_parts::as_json;
use crate::commands::simulate::SimulateArgs;
use crate::commands::{calibrate, deflection, discover, fullaircraft, pipeline_figures, simulate};
use crate::failure::Failure;
use crate::output::{ResultFolder, check_replaceable, needs_pages};
use crate::{paths, show};

/// Options of `pipeline`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot pipeline
  wingroot pipeline --wing my_wing/wing.ron --out out/my_wing --quiet

Every step writes a folder of its own below out (or --out DIR): calibrate, deflection, simulate, discover, fullaircraft, and
pipeline with the main results of all.")]
pub struct PipelineArgs {
    /// Wing and measurements.
    #[command(flatten)]
    measured: Measured,
    /// The aircraft [default: aircraft.ron beside the wing]
    #[arg(long, value_name = "FILE")]
    aircraft: Option<PathBuf>,
}

/// The steps, and the folders that they write.
const STEPS: [&str; 5] = ["calibrate", "deflection", "simulate", "discover", "fullaircraft"];

/// Runs the command: every step writes its own folder below `out` (or below `--out DIR`).
pub(crate) fn run(args: &PipelineArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let base = common.out.clone().unwrap_or_else(|| crate::common::results(""));
    // Before the work, not after it.
    needs_pages(common, "pipeline")?;
    STEPS.iter().chain(&["pipeline"]).try_for_each(|step| check_replaceable(&base.join(step)))?;
    let seconds = steps(args, common, &base)?;
    let total = start.elapsed().as_secs_f64();
    let folder = ResultFolder::begin(&base.join("pipeline"))?;
    let of = |step: &str| read_result(&base.join(step));
    let result = as_json(&PipelineResult {
        command: "pipeline",
        seconds: total,
        steps: seconds,
        figures: pipeline_figures::gather(&base, &folder)?,
        held_out_runs: pipeline_figures::held_out(&base)?,
        calibrate: of("calibrate")?,
        deflection: of("deflection")?,
        simulate: of("simulate")?,
        discover: of("discover")?,
        fullaircraft: of("fullaircraft")?,
    })?;
    folder.write_json("result.json", &result)?;
    folder.commit()?;
    show::summary(common, &format!("pipeline done in {total:.1} s; results in {}\n", base.display()));
    show::json(common, &result)
}

/// Runs the steps, each with what the earlier ones wrote; the seconds of each.
fn steps(args: &PipelineArgs, common: &Common, base: &Path) -> Result<BTreeMap<String, f64>, Failure> {
    let wing = args.measured.wing_path()?;
    let measured = Measured { campaign: Some(args.measured.campaign_path()?), wing: Some(wing.clone()) };
    let aircraft = Some(paths::aircraft(args.aircraft.as_deref(), Some(&wing))?);
    // The wing with its corrections, and those that a step wrote.
    let with = |measured: Measured, step: &str| {
        let corrections = Some(base.join(step).join("corrections.ron"));
        Given { measured, corrections, ..Given::default() }
    };
    let written_by = |step: &str| {
        let wing = Some(expected_in(&base.join(step), "wing")?);
        // intervals take nine times the time of what flies: `simulate` and `fullaircraft` themselves give them
        let given = with(Measured { wing, ..measured.clone() }, step);
        Ok::<_, Failure>(Given { no_intervals: true, ..given })
    };
    let calibrated = with(measured.clone(), "calibrate");
    // With --json the steps say nothing on standard output: their results are gathered at the end.
    let quiet = common.quiet || common.json;
    let mut seconds = BTreeMap::new();
    for name in STEPS {
        if !quiet {
            show::summary(common, &format!("== {name}\n"));
        }
        let from = Instant::now();
        let common = &Common { out: Some(base.join(name)), json: false, quiet, ..common.clone() };
        match name {
            "calibrate" => calibrate::run(&CalibrateArgs { measured: measured.clone(), next: None }, common),
            "deflection" => deflection::run(&DeflectionArgs { given: calibrated.clone() }, common),
            "simulate" => {
                let given = written_by("deflection")?;
                simulate::run(&SimulateArgs { given, ..Default::default() }, common)
            }
            "discover" => {
                let given = calibrated.clone();
                discover::run(&DiscoverArgs { given, own_corrections: true, ..Default::default() }, common)
            }
            // with the effects that stay with the wing, and the corrections found beside them
            _ => {
                let (given, aircraft) = (written_by("discover")?, aircraft.clone());
                fullaircraft::run(&FullaircraftArgs { aircraft, given, ..Default::default() }, common)
            }
        }?;
        seconds.insert(name.to_owned(), from.elapsed().as_secs_f64());
    }
    Ok(seconds)
}

fn read_result(folder: &Path) -> Result<Value, Failure> {
    let text = nastran::read_text(&folder.join("result.json"))?;
    serde_json::from_str(&text).map_err(Failure::computation)
}
