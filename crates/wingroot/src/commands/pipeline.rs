//! `pipeline`: calibrate a wing, correct its deflections, simulate its runs, find the effects it lacks, fly the
//! mirrored aircraft with them.

use clap::Args;
use std::path::{Path, PathBuf};
use std::time::Instant;

use serde_json::{Map, Value, json};

use crate::args::{Common, Given, Measured};
use crate::commands::calibrate::CalibrateArgs;
use crate::commands::deflection::DeflectionArgs;
use crate::commands::discover::DiscoverArgs;
use crate::commands::fullaircraft_prepared::FullaircraftArgs;
use crate::commands::simulate::SimulateArgs;
use crate::commands::{calibrate, deflection, discover, fullaircraft, pipeline_figures, simulate};
use crate::failure::Failure;
use crate::output::ResultFolder;
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

/// Runs the command: every step writes its own folder below `out` (or below `--out DIR`).
pub(crate) fn run(args: &PipelineArgs, common: &Common) -> Result<(), Failure> {
    let base = common.out.clone().unwrap_or_else(|| crate::common::results(""));
    let wing = args.measured.wing_path()?;
    let measured = Measured { campaign: Some(args.measured.campaign_path()?), wing: Some(wing.clone()) };
    let aircraft = Some(paths::aircraft(args.aircraft.as_deref(), Some(&wing))?);
    // With a wing that an earlier step wrote.
    let with_wing = |wing: PathBuf| Measured { wing: Some(wing), ..measured.clone() };
    let start = Instant::now();
    // With --json the steps say nothing on standard output: their results are gathered at the end.
    let quiet = common.quiet || common.json;
    let step = |name: &str| Common { out: Some(base.join(name)), json: false, quiet, ..common.clone() };
    let heading = |name: &str| {
        if !quiet {
            show::summary(common, &format!("== {name}\n"));
        }
    };
    let mut seconds = Map::new();
    let mut timed = |name: &str, run: &dyn Fn(&Common) -> Result<(), Failure>| -> Result<(), Failure> {
        heading(name);
        let from = Instant::now();
        run(&step(name))?;
        seconds.insert(name.to_owned(), json!(from.elapsed().as_secs_f64()));
        Ok(())
    };
    timed("calibrate", &|common| calibrate::run(&CalibrateArgs { measured: measured.clone() }, common))?;
    let corrections = Some(base.join("calibrate/corrections.ron"));
    timed("deflection", &|common| {
        deflection::run(
            &DeflectionArgs {
                given: Given { measured: measured.clone(), corrections: corrections.clone(), ..Given::default() },
            },
            common,
        )
    })?;
    timed("simulate", &|common| {
        let of_deflection = |name: &str| base.join("deflection").join(name);
        let measured = with_wing(of_deflection("wing.ron"));
        let corrections = Some(of_deflection("corrections.ron"));
        simulate::run(
            &SimulateArgs { given: Given { measured, corrections, ..Given::default() }, ..Default::default() },
            common,
        )
    })?;
    timed("discover", &|common| {
        let corrections = corrections.clone();
        discover::run(
            &DiscoverArgs {
                given: Given { measured: measured.clone(), corrections, ..Given::default() },
                own_corrections: true,
                ..Default::default()
            },
            common,
        )
    })?;
    timed("fullaircraft", &|common| {
        // with the effects that stay with the wing, and the corrections found beside them
        let of_discover = |name: &str| base.join("discover").join(name);
        let given = Given {
            measured: with_wing(of_discover("wing.ron")),
            corrections: Some(of_discover("corrections.ron")),
            ..Given::default()
        };
        fullaircraft::run(&FullaircraftArgs { given, aircraft: aircraft.clone(), ..Default::default() }, common)
    })?;
    let total = start.elapsed().as_secs_f64();
    let mut result = json!({ "command": "pipeline", "seconds": total, "steps": seconds });
    for name in ["calibrate", "deflection", "simulate", "discover", "fullaircraft"] {
        result[name] = read_result(&base.join(name))?;
    }
    let folder = ResultFolder::begin(&base.join("pipeline"))?;
    result["figures"] = pipeline_figures::gather(&base, &folder)?;
    folder.write_json("result.json", &result)?;
    folder.commit()?;
    show::summary(common, &format!("pipeline done in {total:.1} s; results in {}\n", base.display()));
    show::json(common, &result)
}

fn read_result(folder: &Path) -> Result<Value, Failure> {
    let text = nastran::read_text(&folder.join("result.json"))?;
    serde_json::from_str(&text).map_err(Failure::computation)
}
