//! `bench`: time of the main steps, beside the paper's way of doing the same in the same run.

use clap::Args;
use std::path::PathBuf;
use std::time::Duration;

use aero::{Lattice, MirrorPlane, SteadyAero};
use calibrate::ensemble::ensemble;
use calibrate::posterior::posterior;
use calibrate::{Calibration, Campaign, Settings, calibrate};
use coupling::{ElasticWing, WingFile};
use serde_json::{Value, json};

use super::bench_clock::{REPEATS, median, peak_mb, row};
use crate::commands::{
    bench_aircraft, bench_chirp, bench_discover, bench_dlm, bench_general, bench_structure, bench_trim,
};
use crate::repository;
use wingroot::args::Common;
use wingroot::corrections::schedule;
use wingroot::failure::Failure;
use wingroot::output::ResultFolder;
use wingroot::show;

/// Options of `bench`.
#[derive(Debug, Clone, Args)]
#[command(after_help = "Examples:
  cargo xtask bench
  cargo xtask bench --peer-python venv/bin/python")]
pub(crate) struct BenchArgs {
    /// A Python with PanelAero, timed on the same boxes in the same run [default: python3, if it has it]
    #[arg(long, value_name = "PYTHON", default_value = "python3")]
    pub(crate) peer_python: PathBuf,
}

/// The general optimiser gets this long for one airspeed.
const GENERAL: Duration = Duration::from_secs(30);

/// Runs the command.
pub(crate) fn run(args: &BenchArgs, common: &Common) -> Result<(), Failure> {
    // First, while the process is small and in the order of their size: these rows tell their peak of memory.
    let mut rows = vec![doublets(&bench_dlm::aircraft()?, args)?];
    rows.extend(bench_aircraft::rows()?);
    rows.extend(bench_structure::rows(&WingFile::read(&repository::path("data/tuflex/wing.ron"))?)?);
    rows.push(bench_structure::reading()?);
    let (file, wing) = ElasticWing::read(&repository::path("data/tuflex/wing.ron"))?;
    let campaign = Campaign::read(&repository::path("data/tuflex/measured"))?;
    let settings = Settings::of_wing(&file.correction);
    rows.push(row(
        &format!("vlm_{}_boxes_with_image", wing.lattice.len()),
        median(|| SteadyAero::new(&wing.lattice, wing.plane, 0.0).map(drop).map_err(Failure::computation))?,
    ));
    rows.push(row(
        &format!("vlm_{}_boxes_free", wing.lattice.len()),
        median(|| {
            SteadyAero::new(&wing.lattice, MirrorPlane::None, 0.0).map(drop).map_err(Failure::computation)
        })?,
    ));
    rows.extend(bench_chirp::rows(&file, &wing)?);
    rows.extend(bench_trim::rows()?);
    rows.extend(bench_discover::rows()?);
    let calibration = calibrate(&wing, &campaign, &settings)?;
    let whole = median(|| {
        let (file, wing) = ElasticWing::read(&repository::path("data/tuflex/wing.ron"))?;
        calibrate(&wing, &campaign, &Settings::of_wing(&file.correction))?;
        Ok(())
    })?;
    let airspeeds = calibration.airspeeds.len();
    let name = format!("calibrate_{airspeeds}_airspeeds_with_wing_and_aic");
    rows.push(row(&name, whole));
    let with_intervals = median(|| {
        let (file, wing) = ElasticWing::read(&repository::path("data/tuflex/wing.ron"))?;
        let calibration = calibrate(&wing, &campaign, &Settings::of_wing(&file.correction))?;
        let prior = &file.correction.prior;
        let known = posterior(&wing, &calibration, prior)?;
        let calibration = calibration.with_means(&wing, &known)?;
        ensemble(&wing, prior, &schedule(&file, &calibration), &known);
        Ok(())
    })?;
    rows.push(json!({
        "name": format!("{name}_and_intervals"), "seconds": with_intervals,
        "peer": "the same without intervals", "peer_seconds": whole,
        "ratio": whole / with_intervals,
    }));
    rows.push(general(&wing, &campaign, &settings, &calibration, whole / airspeeds as f64)?);
    let result = json!({ "command": "bench", "rows": rows, "peak_MB": peak_mb() });
    let folder = ResultFolder::begin(&common.out("bench"))?.with_head(crate::pages::bench::page);
    folder.input("wing", &repository::path("data/tuflex/wing.ron"))?;
    folder.input("campaign", &repository::path("data/tuflex/measured"))?;
    folder.write_json("result.json", &result)?;
    folder.commit()?;
    show::summary(common, &summary(&rows));
    show::json(common, &result)
}

/// The doublet lattice of a whole aircraft, beside PanelAero's on the same boxes where it is there.
fn doublets(aircraft: &Lattice, args: &BenchArgs) -> Result<Value, Failure> {
    let ours = median(|| bench_dlm::eight_frequencies(aircraft))?;
    let mut row = row(&format!("dlm_{}_boxes_8_frequencies", aircraft.len()), ours);
    row["peak_MB"] = json!(peak_mb());
    if let Some(peer) = bench_dlm::panelaero(aircraft, &args.peer_python)? {
        let seconds = peer["seconds"].as_f64().unwrap_or_default();
        row["peer"] = json!("PanelAero");
        row["peer_seconds"] = json!(seconds);
        row["peer_peak_MB"] = peer["peak_MB"].clone();
        row["ratio"] = json!(seconds / ours);
    }
    Ok(row)
}

/// One airspeed by a general optimiser with finite differences (the paper's way), beside ours.
fn general(
    wing: &ElasticWing,
    campaign: &Campaign,
    settings: &Settings,
    calibration: &Calibration,
    ours: f64,
) -> Result<Value, Failure> {
    let Some(fastest) = calibration.airspeeds.last() else {
        return Err(Failure::Computation("the campaign has no airspeed".into()));
    };
    let peer = bench_general::fit(wing, &fastest.data, campaign.rho_kg_m3, settings, GENERAL)
        .map_err(Failure::computation)?;
    Ok(json!({
        "name": format!("calibrate_one_airspeed_{}_m_s", fastest.data.v_m_s),
        "seconds": ours,
        "objective": fastest.fit.objective[1],
        "line_floor": fastest.line_floor,
        "cone_programs": fastest.fit.cone_programs,
        "peer": "L-BFGS with forward differences of the same model (argmin), ended after the first ten iterations beyond 30 s",
        "peer_seconds": peer.seconds,
        "peer_simulations": peer.simulations,
        "peer_objective": peer.objective,
        "ratio": peer.seconds / ours,
    }))
}

fn summary(rows: &[Value]) -> String {
    let with = |row: &Value, key: &str, places: usize| {
        row[key].as_f64().map_or_else(|| "-".into(), |value| format!("{value:.places$}"))
    };
    let columns: [report::Column<'_, &Value>; 8] = [
        ("step", &|row| row["name"].as_str().unwrap_or_default().to_owned()),
        ("seconds", &|row| with(row, "seconds", 4)),
        ("peak MB", &|row| with(row, "peak_MB", 0)),
        ("peer's seconds", &|row| with(row, "peer_seconds", 4)),
        ("peer's MB", &|row| with(row, "peer_peak_MB", 0)),
        ("ratio", &|row| with(row, "ratio", 4)),
        ("F", &|row| with(row, "objective", 4)),
        ("peer's F", &|row| with(row, "peer_objective", 4)),
    ];
    let table = report::Table::of(rows, &columns);
    let alone = if rows.iter().any(|row| row["peer"] == "PanelAero") {
        ""
    } else {
        "PanelAero is not there, so the doublet lattice stands alone; --peer-python names a Python that has it.\n"
    };
    format!(
        "{table}\n{alone}Median of {REPEATS} runs after one to warm up; meshes, the aircraft and the peer run once.\n"
    )
}
