//! `calibrate`: measured root loads in, corrections of the panel model by airspeed out.

use clap::Args;
use std::fmt::Write as _;
use std::path::Path;
use std::time::Instant;

use aero::{Corrections, MirrorPlane};
use calibrate::ensemble::ensemble;
use calibrate::posterior::AirspeedPosterior;
use calibrate::posterior::next::Suggestion;
use calibrate::{AirspeedCalibration, Calibration, Campaign, Settings, Weight};
use coupling::{ElasticWing, Geometry, LargeWing, SteadyCase, SteadyModel, WingFile};
use nastran::InputError;

use crate::args::{Common, Measured};
use crate::commands::calibrate_common as common_set;
use crate::commands::calibrate_figures as figures;
use crate::commands::calibrate_model::{self, Fitted};
use crate::commands::calibrate_numbers::{channels, identifiability, speed_name};
use crate::commands::calibrate_predictions;
use crate::commands::calibrate_predictions_result;
use crate::commands::calibrate_result::{
    AirspeedResult, BlockResult, CalibrateResult, LeftOutAirspeedResult, LeftOutResult, NonlinearityResult,
    RootPlaneResult, TareResult,
};
use crate::commands::calibrate_shapes;
use crate::commands::calibrate_strips::{self, Strips};
use crate::commands::result_parts::{Channels, as_json};
use crate::corrections::{ENSEMBLE, schedule};
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;

/// Options of `calibrate`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot calibrate
  wingroot calibrate --wing my_wing/wing.ron --campaign my_wing/campaign --out out/my_wing
  wingroot calibrate --wing data/pazy/wing.ron --campaign data/pazy/tip_5deg --out out/pazy

Written: corrections.ron, DMI cards wkk_V.bdf and fa2j_V.bdf for each airspeed, figures, result.json. An airspeed needs
three angles of attack (docs/guide.md explains the columns and how to read the result).")]
pub struct CalibrateArgs {
    /// Wing and measurements.
    #[command(flatten)]
    pub(crate) measured: Measured,
    /// Rank what to measure next by how much it narrows this prediction: `tip`, `bending:0.5` (place along the span) or
    /// `control:NAME`.
    #[arg(long, value_name = "WHAT")]
    pub(crate) next: Option<String>,
}

/// Runs the command.
pub(crate) fn run(args: &CalibrateArgs, common: &Common) -> Result<(), Failure> {
    let path = args.measured.wing_path()?;
    if WingFile::read(&path)?.geometry == Geometry::Nonlinear {
        let (file, wing) = LargeWing::read(&path)?;
        return fit(args, common, &file, &Fitted::large(&wing));
    }
    let (file, wing) = ElasticWing::read(&path)?;
    fit(args, common, &file, &Fitted::Small(&wing))
}

/// What a fit came to.
struct Fit {
    calibration: Calibration,
    /// With small deflections, where the fit has large ones.
    small: Option<Calibration>,
    predictions: Vec<AirspeedPosterior>,
    /// What to measure next.
    next: Vec<Suggestion>,
    seconds: f64,
}

/// Fits a wing and writes what came of it.
fn fit(args: &CalibrateArgs, common: &Common, file: &WingFile, fitted: &Fitted<'_>) -> Result<(), Failure> {
    let wing = fitted.elastic();
    let campaign = Campaign::read(&args.measured.campaign_path()?)?;
    let Fit { calibration, small, predictions, next, seconds } = found(args, &campaign, file, fitted)?;
    let strips = calibrate_strips::compare(&campaign.folder, fitted, &calibration)?;
    let of_small = |small: &Calibration| -> Vec<_> {
        let lifts = calibrate_model::lift_factors(small).into_iter();
        lifts.map(|lift| common_set::lift_factor(lift, small)).collect()
    };
    let result = CalibrateResult {
        lift_factors_with_small_deflections: small.as_ref().map(of_small).unwrap_or_default(),
        predictions: calibrate_predictions_result::result(wing, &predictions),
        next: calibrate_predictions_result::suggestions(&next),
        ..result(wing, &campaign, &calibration, strips.as_ref(), seconds)?
    };
    let result = as_json(&result)?;
    let folder = ResultFolder::begin(&common.out("calibrate"))?;
    folder.input("wing", &file.path)?;
    folder.input("campaign", &campaign.folder)?;
    let schedule = schedule(file, &calibration);
    folder.write_text("corrections.ron", &schedule.to_ron())?;
    if let Some(ensemble) = ensemble(wing, &file.correction.prior, &schedule, &predictions) {
        folder.write_text(ENSEMBLE, &ensemble.to_ron()?)?;
    }
    write(&folder, fitted, &calibration, strips.as_ref())?;
    calibrate_predictions::write(&folder, wing, &predictions)?;
    folder.write_json("result.json", &result)?;
    let faults = calibration.faults();
    let out = folder.commit_if(faults.is_empty())?;
    let both = small.as_ref().map(|small| calibrate_model::told(&calibration, small)).unwrap_or_default();
    let told = both
        + &calibrate_predictions::summary(wing, &predictions, calibration.found.is_some())
        + &calibrate_predictions::next_table(&next);
    show::summary(common, &summary(&calibration, fitted.bends_far(), &told, &out, seconds));
    show::json(common, &result)?;
    if faults.is_empty() { Ok(()) } else { Err(Failure::Computation(faults.join("; "))) }
}

/// The corrections, and with small deflections the intervals of what they predict.
fn found(
    args: &CalibrateArgs,
    campaign: &Campaign,
    file: &WingFile,
    fitted: &Fitted<'_>,
) -> Result<Fit, Failure> {
    let (start, wing, prior) = (Instant::now(), fitted.elastic(), &file.correction.prior);
    let settings = Settings::of_wing(&file.correction);
    if matches!(fitted, Fitted::Large(..)) {
        if args.next.is_some() {
            let message =
                "--next ranks by intervals of predictions, which are known with small deflections only";
            let help = "take `geometry: Nonlinear` out of the wing's file for it";
            return Err(InputError::general(message).with_help(help).into());
        }
        let calibration = calibrate::calibrate(fitted, campaign, &settings)?;
        let unused = calibration.data.further.len();
        if unused > 0 {
            tracing::warn!(
                "{unused} rows with sensors or deflected controls are not fitted: they are with small deflections only"
            );
        }
        let seconds = start.elapsed().as_secs_f64();
        let small = Some(calibrate::calibrate(wing, campaign, &settings)?);
        return Ok(Fit { calibration, small, predictions: Vec::new(), next: Vec::new(), seconds });
    }
    let calibration = calibrate::calibrate(wing, campaign, &settings)?;
    let predictions = calibrate::posterior::posterior(wing, &calibration, prior)?;
    let calibration = calibration.with_means(wing, &predictions)?;
    let seconds = start.elapsed().as_secs_f64();
    let next = match &args.next {
        None => Vec::new(),
        Some(words) => {
            let wanted = calibrate_predictions::wanted(words, wing)?;
            calibrate::posterior::next::rank(wing, &calibration, prior, &wanted)?
        }
    };
    Ok(Fit { calibration, small: None, predictions, next, seconds })
}

/// Writes DMI cards and figures.
fn write(
    folder: &ResultFolder,
    fitted: &Fitted<'_>,
    calibration: &Calibration,
    strips: Option<&Strips>,
) -> Result<(), Failure> {
    let wing = fitted.elastic();
    let common = calibration.common.iter().map(|set| &set.corrections);
    let reaches =
        figures::reaches(calibration.airspeeds.iter().map(|airspeed| &airspeed.corrections).chain(common));
    for airspeed in &calibration.airspeeds {
        let name = speed_name(airspeed.data.v_m_s);
        write_set(folder, wing, &name, &format!("{name} m/s"), &airspeed.corrections, reaches)?;
    }
    match &calibration.common {
        None => {
            folder.write_text("static_loads.csv", &figures::static_loads_csv(fitted, calibration)?)?;
            figures::write(folder, fitted, calibration)?;
        }
        Some(set) => {
            write_set(folder, wing, "common", "all airspeeds", &set.corrections, reaches)?;
            let caption = "Readings with their zeros taken out, and what both models give.";
            folder.write_figure("readings", caption, common_set::figure(fitted, set, calibration)?)?;
        }
    }
    calibrate_shapes::write(folder, fitted, calibration)?;
    if let Some(strips) = strips {
        folder.write_figure("strips", "Measured beside computed; never fitted.", strips.figure())?;
    }
    Ok(())
}

/// One set of corrections as DMI cards and as a picture.
fn write_set(
    folder: &ResultFolder,
    wing: &ElasticWing,
    name: &str,
    at: &str,
    corrections: &Corrections,
    reaches: [f64; 3],
) -> Result<(), Failure> {
    let padded = wing.padded(corrections)?;
    folder.write_text(&format!("wkk_{name}.bdf"), &padded.wkk().rounded_to_fields().write())?;
    folder.write_text(&format!("fa2j_{name}.bdf"), &padded.fa2j().rounded_to_fields().write())?;
    folder.write_planforms(
        &format!("corrections_{name}"),
        &format!("Corrections at {at}"),
        "Figure 7 of the paper.",
        &figures::planforms(wing, corrections, reaches),
    )
}

fn result(
    wing: &ElasticWing,
    campaign: &Campaign,
    calibration: &Calibration,
    strips: Option<&Strips>,
    seconds: f64,
) -> Result<CalibrateResult, Failure> {
    let data = &calibration.data;
    let of = |values: [f64; 4]| channels(values, data.channels);
    Ok(CalibrateResult {
        command: "calibrate",
        campaign: campaign.name.clone(),
        airspeeds: calibration.airspeeds.iter().map(|at| airspeed_result(at, calibration)).collect(),
        common: calibration.common.as_ref().map(|set| common_set::result(set, calibration)),
        cone_programs: calibration.cone_programs(),
        blocks: data
            .blocks
            .iter()
            .map(|b| BlockResult { block: b.block.clone(), offset: of(b.offset) })
            .collect(),
        block_sigma: of(data.block_sigma),
        point_sigma: data.point_sigma.map(of),
        noise_from: match (data.noise_dof, data.point_sigma) {
            (Some(dof), _) => format!("replicates, {dof} degrees of freedom"),
            (None, Some(sigma)) => match campaign.noise {
                Some(noise) if noise.static_point.to_array() != sigma => {
                    "the scatter of rows, beyond the campaign's declaration".into()
                }
                _ => "the campaign's declaration".into(),
            },
            (None, None) => "unknown: no replicates and none declared".into(),
        },
        nonlinearity_level: calibration.nonlinearity_level,
        suspicions: calibration.said(&[Weight::Suspicion, Weight::Defect]),
        defects: calibration.said(&[Weight::Defect]),
        left_open: calibration.said(&[Weight::Open]),
        lines_set_aside: calibration.set_aside.clone(),
        rows_with_deflected_controls: data
            .further
            .iter()
            .filter(|point| !point.controls_rad.is_empty())
            .count(),
        weight_tare: calibration.weight_tare.map(|tare| TareResult {
            points: tare.points,
            rms: tare.rms,
            rms_over_noise: tare.rms_over_noise,
        }),
        root_plane: root_plane(wing, campaign, calibration)?,
        lift_factors_with_small_deflections: Vec::new(),
        predictions: Vec::new(),
        next: Vec::new(),
        strips: strips.map(Strips::rows),
        strips_rms: strips.map(Strips::rms),
        seconds,
    })
}

fn airspeed_result(airspeed: &AirspeedCalibration, calibration: &Calibration) -> AirspeedResult {
    let fit = &airspeed.fit;
    let measured = calibration.data.channels;
    let of = |values: [f64; 4]| Channels::of(values, measured);
    let told = airspeed.identifiability.as_ref();
    let nonlinearity = (0..4)
        .filter_map(|c| airspeed.line.nonlinearity[c].map(|test| (c, test)))
        .map(|(c, test)| NonlinearityResult {
            channel: calibrate::campaign::CHANNELS[c],
            curvature_per_deg2: test.curvature_per_rad2 * 1.0_f64.to_radians().powi(2),
            f: test.f,
            p_value: test.p_value,
            significant: test.p_value < calibration.nonlinearity_level,
        })
        .collect();
    AirspeedResult {
        v_m_s: airspeed.data.v_m_s,
        objective_before: fit.objective[0],
        objective_after: fit.objective[1],
        line_floor: airspeed.line_floor,
        noise_floor: airspeed.noise_floor,
        iterations: fit.cone_programs,
        ending: format!("{:?}", fit.ending),
        rmse_before: of(fit.rmse[0]),
        rmse_after: of(fit.rmse[1]),
        line_rmse: of(airspeed.line.rmse),
        determined_directions: told.map(|told| told.determined_directions),
        neighbour_bound_active: fit.neighbour_bound_active,
        nonlinearity,
        identifiability: told.map(|told| identifiability(told, measured)),
        left_out: airspeed.left_out.as_ref().map(|left_out| LeftOutResult {
            alpha_deg: left_out.alphas_rad.iter().map(|a| a.to_degrees()).collect(),
            objective_before: left_out.objective_before,
            objective_after: left_out.objective_after,
            line_error: left_out.line_error,
        }),
        left_out_airspeed: airspeed.left_out_airspeed.as_ref().map(|left_out| LeftOutAirspeedResult {
            objective_before: left_out.objective_before,
            objective_after: left_out.objective_after,
        }),
        lift_factor: airspeed.lift.as_ref().map(|lift| common_set::lift_factor(lift, calibration)),
        weights: airspeed.lift.as_ref().map(|_| of(airspeed.weights)),
    }
}

/// What the choice of the plane at the root does to the rigid lift slope.
fn root_plane(
    wing: &ElasticWing,
    campaign: &Campaign,
    calibration: &Calibration,
) -> Result<RootPlaneResult, Failure> {
    let area_m2: f64 = wing.correctable.places.iter().map(|&place| wing.lattice.boxes[place].area_m2()).sum();
    let slope = |cp: &dyn Fn(usize) -> f64| {
        let lift = |&place: &usize| {
            cp(place) * wing.lattice.boxes[place].area_m2() * wing.lattice.boxes[place].normal().z
        };
        wing.correctable.places.iter().map(lift).sum::<f64>() / area_m2
    };
    let chosen = slope(&|place| wing.pressures_by_alpha()[place]);
    let name = match wing.plane {
        MirrorPlane::None => "None".to_owned(),
        MirrorPlane::Symmetric { y_m } => format!("Symmetric({y_m})"),
        MirrorPlane::Antisymmetric { y_m } => format!("Antisymmetric({y_m})"),
    };
    let free = if wing.plane == MirrorPlane::None {
        chosen
    } else {
        let alone =
            aero::SteadyAero::new(&wing.lattice, MirrorPlane::None, 0.0).map_err(Failure::computation)?;
        let upward = faer::Mat::from_fn(wing.lattice.len(), 1, |j, _| wing.lattice.boxes[j].normal().z);
        let cp = alone.pressures(upward.as_ref());
        slope(&|place| cp[(place, 0)])
    };
    let fastest = calibration.data.airspeeds.last().map_or(0.0, |a| a.v_m_s);
    let flow = aero::Flow { v_m_s: fastest, rho_kg_m3: campaign.rho_kg_m3 };
    let neutral = aero::Corrections::neutral(wing.correctable.len());
    let states = wing.at(flow, &neutral)?.solve(&[SteadyCase::new(flow, 0.0), SteadyCase::new(flow, 0.01)]);
    let elastic = (states[1].root.fz_n - states[0].root.fz_n) / 0.01 / (flow.dynamic_pressure_pa() * area_m2);
    Ok(RootPlaneResult {
        choice: name,
        lift_slope_per_rad: chosen,
        lift_slope_per_rad_without_plane: free,
        elastic_lift_slope_per_rad_at_highest_airspeed: elastic,
    })
}

fn summary(
    calibration: &Calibration,
    bends_far: bool,
    predictions: &str,
    out: &Path,
    seconds: f64,
) -> String {
    let number = |value: f64| format!("{value:.4}");
    let optional = |value: Option<f64>| value.map_or_else(|| "-".into(), number);
    let columns: [report::Column<'_, &AirspeedCalibration>; 9] = [
        ("V (m/s)", &|a| speed_name(a.data.v_m_s)),
        ("F before", &|a| number(a.fit.objective[0])),
        ("F after", &|a| number(a.fit.objective[1])),
        ("line floor", &|a| number(a.line_floor)),
        ("noise floor", &|a| optional(a.noise_floor)),
        ("programs", &|a| a.fit.cone_programs.to_string()),
        ("left out: before", &|a| optional(a.left_out.as_ref().map(|l| l.objective_before))),
        ("after", &|a| optional(a.left_out.as_ref().map(|l| l.objective_after))),
        ("ending", &|a| format!("{:?}", a.fit.ending)),
    ];
    let table = report::Table::of(&calibration.airspeeds, &columns);
    let mut text = match &calibration.common {
        None => format!("{table}\n"),
        Some(set) => common_set::table(set, calibration),
    };
    for a in &calibration.airspeeds {
        let bent: Vec<&str> = (0..4)
            .filter(|&c| {
                a.line.nonlinearity[c].is_some_and(|test| test.p_value < calibration.nonlinearity_level)
            })
            .map(|c| calibrate::campaign::CHANNELS[c])
            .collect();
        if !bent.is_empty() {
            let v = speed_name(a.data.v_m_s);
            let of = if bends_far { ", as far as the bent wing misses them," } else { "" };
            let _ = writeln!(
                text,
                "{v} m/s: {}{of} cannot be followed by a straight line; reported, not fitted",
                bent.join(", ")
            );
        }
    }
    text.push_str(predictions);
    for said in calibration.said(&[Weight::Open]) {
        let _ = writeln!(text, "note: {said}");
    }
    text + &format!("{seconds:.2} s; results in {}\n", out.display())
}
