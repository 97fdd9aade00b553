//! `tunnel`: the virtual wind tunnel writes a campaign folder, and its README says what is in it.

use clap::Args;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::Instant;

use calibrate::{AirspeedCalibration, Calibration, Settings};
use coupling::{ElasticWing, Mount};
use tunnel::{AirspeedComparison, FlightState, Found, HalfWingFlight, Story, Truth, TunnelError, TunnelFile};

use crate::args::Common;
use crate::commands::result_parts::as_json;
use crate::commands::tunnel_result::{
    CalibrationResult, ChannelLines, FlightResult, HalfWing, TruthAndModel, TunnelResult,
};
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::{paths, show};

/// Options of `tunnel`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot tunnel
  wingroot tunnel --runs data/tuflex/tunnel.ron --seed 2 --out out/another_tunnel

What it writes is generated, and its README.md says so: a campaign to try commands on, no measurement.")]
pub struct TunnelArgs {
    /// What the tunnel measures and hides [default: tunnel.ron of the current folder]
    #[arg(long, value_name = "FILE")]
    pub(crate) runs: Option<PathBuf>,
}

/// Mass that the half wing carries in the check of the corrections in flight, kg (the assumed 20 kg aircraft).
const HALF_MASS_KG: f64 = 10.0;
/// Trim, pull-up and push-down: airspeed (m/s) and load factor.
const FLIGHT: [(f64, f64); 3] = [(25.7, 1.0), (37.0, 4.0), (42.0, -2.0)];

/// Runs the command.
pub(crate) fn run(args: &TunnelArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let path = paths::tunnel(args.runs.as_deref())?;
    let file = TunnelFile::read(&path)?;
    let seed = common.seed.unwrap_or(file.seed);
    let truth = Truth::build(&file).map_err(failure)?;
    let campaign = tunnel::campaign(&file, &truth, seed).map_err(failure)?;
    let folder = ResultFolder::begin(&common.out("tunnel"))?;
    for (name, text) in &campaign.files {
        folder.write_text(name, text)?;
    }
    let model = ElasticWing::from_bulk(&truth.baseline_file, &truth.baseline_file.bulk(Mount::Tunnel)?)?;
    let statics = &file.statics;
    let comparison =
        tunnel::compare(&truth, &model, &statics.airspeeds_m_s, &statics.angles_deg).map_err(failure)?;
    let measured = calibrate::Campaign::read(folder.path())?;
    let settings = Settings::of_wing(&truth.baseline_file.correction);
    let calibration = calibrate::calibrate(&model, &measured, &settings)?;
    let found: Vec<Found> = calibration.airspeeds.iter().map(|airspeed| found(&model, airspeed)).collect();
    let flight = flight(&truth, &calibration)?;
    let file_name = shown(&path);
    let is_bent = truth.is_bent();
    let story =
        Story { tunnel: &file, file_name, seed, is_bent, comparison: &comparison, found: &found, flight };
    folder.write_text("README.md", &tunnel::readme(&story))?;
    folder.input("what it measures and hides", &path)?;
    let result = as_json(&result(&story, campaign.rows.len()))?;
    folder.write_json("result.json", &result)?;
    let out = folder.commit()?;
    show::summary(common, &summary(&story, &out, start.elapsed().as_secs_f64()));
    show::json(common, &result)
}

/// The path as one types it in the current folder.
fn shown(path: &Path) -> String {
    let here = std::env::current_dir().unwrap_or_default();
    let absolute = std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf());
    absolute.strip_prefix(&here).unwrap_or(path).to_string_lossy().replace('\\', "/")
}

fn failure(error: TunnelError) -> Failure {
    match error {
        TunnelError::Input(error) => error.into(),
        TunnelError::Wing(error) => error.into(),
        error @ (TunnelError::Unsettled { .. } | TunnelError::Rig(_)) => Failure::computation(error),
    }
}

/// What calibration found, with the corrections at the wing's corners.
fn found(model: &ElasticWing, airspeed: &AirspeedCalibration) -> Found {
    let boxes = &model.correctable;
    let (last, rows) = (boxes.len() - 1, boxes.chord_rows[0]);
    let corners = |values: &[f64]| [0, rows - 1, last + 1 - rows, last].map(|entry| values[entry]);
    let (fit, corrections) = (&airspeed.fit, &airspeed.corrections);
    let tests = airspeed.line.nonlinearity.iter().flatten();
    Found {
        v_m_s: airspeed.data.v_m_s,
        objective: fit.objective,
        line_floor: airspeed.line_floor,
        cone_programs: fit.cone_programs,
        ending: format!("{:?}", fit.ending),
        left_out: airspeed
            .left_out
            .as_ref()
            .map(|left| [left.objective_before, left.objective_after, left.line_error]),
        least_p: tests.map(|test| test.p_value).fold(1.0, f64::min),
        force: corners(&corrections.force),
        moment: corners(&corrections.moment),
        offset: corners(&corrections.pressure_offset),
    }
}

/// The half wing in flight without corrections and with those of the highest airspeed.
fn flight(truth: &Truth, calibration: &Calibration) -> Result<[[FlightState; 2]; 3], Failure> {
    let mut wing = HalfWingFlight::new(&truth.baseline_file, HALF_MASS_KG, truth.rho_kg_m3)?;
    let fastest =
        calibration.airspeeds.last().ok_or_else(|| Failure::computation("no airspeed was measured"))?;
    let neutral = aero::Corrections::neutral(fastest.corrections.len());
    let mut fly = |(v_m_s, load_factor): (f64, f64)| {
        let before = wing.trimmed(v_m_s, load_factor, &neutral)?;
        Ok::<_, Failure>([before, wing.trimmed(v_m_s, load_factor, &fastest.corrections)?])
    };
    Ok([fly(FLIGHT[0])?, fly(FLIGHT[1])?, fly(FLIGHT[2])?])
}

fn result(story: &Story<'_>, rows: usize) -> TunnelResult {
    let lines = |channel: &tunnel::ChannelComparison| ChannelLines {
        offset: channel.offset,
        slope_per_deg: channel.slope_per_deg,
        relative_error: channel.relative_error,
    };
    let compared = |row: &AirspeedComparison| {
        let [fz, mx, my] = row.channels.each_ref().map(lines);
        TruthAndModel { v_m_s: row.v_m_s, fz, mx, my }
    };
    let calibrated = |f: &Found| CalibrationResult {
        v_m_s: f.v_m_s,
        objective_before: f.objective[0],
        objective_after: f.objective[1],
        line_floor: f.line_floor,
        iterations: f.cone_programs,
        ending: f.ending.clone(),
    };
    let [trim, pull_up, push_down] = story.flight.map(|states| {
        states.map(|state| FlightResult { alpha_deg: state.alpha_deg, tip_deflection_m: state.tip_z_m })
    });
    TunnelResult {
        command: "tunnel",
        measurements: false,
        campaign: story.tunnel.name.clone(),
        seed: story.seed,
        static_rows: rows,
        truth_and_model: story.comparison.iter().map(compared).collect(),
        calibration: story.found.iter().map(calibrated).collect(),
        half_wing_uncorrected_and_corrected: HalfWing { trim, pull_up, push_down },
    }
}

fn summary(story: &Story<'_>, out: &Path, seconds: f64) -> String {
    let mut text = format!("{} (seed {}; not measurements)\n", story.tunnel.name, story.seed);
    if story.is_bent {
        text.push_str(
            "  the static cases are of the bent wing; the model beside them here has small deflections\n",
        );
    }
    text.push_str(
        "  V m/s   error of the uncorrected model: Fz    Mx    My      Eq. 8 before    after    line\n",
    );
    for (row, found) in story.comparison.iter().zip(story.found) {
        let [fz, mx, my] = row.channels.map(|channel| 100.0 * channel.relative_error);
        let _ = writeln!(
            text,
            "  {:5.1}   {:32.0} % {:3.0} % {:3.0} %      {:12.2} {:8.3} {:7.3}",
            row.v_m_s, fz, mx, my, found.objective[0], found.objective[1], found.line_floor
        );
    }
    let [trim, up, down] = story.flight;
    let _ = writeln!(
        text,
        "  half wing with the corrections of the highest airspeed: trim {:+.2} deg, tip at 4 g {:.2}, at -2 g {:.2} times",
        trim[1].alpha_deg - trim[0].alpha_deg,
        up[1].tip_z_m / up[0].tip_z_m,
        down[1].tip_z_m / down[0].tip_z_m
    );
    let _ = write!(text, "written to {} in {seconds:.1} s", out.display());
    text
}
