//! `trust`: whether the intervals of calibrated wings hold wings that another program made.

use clap::Args;
use std::collections::BTreeMap;
use std::time::Instant;

use rayon::prelude::*;
use serde_json::{Value, json};

use super::trust_campaign::{Flown, Sensors, Stand};
use crate::repository;
use calibrate::posterior::predictions::Quantity;
use calibrate::{Calibration, Reading, Settings, Weight};
use coupling::ElasticWing;
use truth::lift::Kind;
use wingroot::args::Common;
use wingroot::failure::Failure;
use wingroot::output::ResultFolder;
use wingroot::{progress, show};

/// Options of `trust`.
#[derive(Debug, Clone, Args)]
#[command(after_help = "Examples:
  cargo xtask trust --truths 40
  cargo xtask trust --truths 500 --seed 7

Wings off their drawing are flown at rest by the vortex lattice and the beam of crates/truth, measured with noise, and calibrated
with the model's own lattice and structure. A quarter separates within the angles and stands for itself.")]
pub(crate) struct TrustArgs {
    /// Number of true wings
    #[arg(long, default_value_t = 100)]
    pub(crate) truths: u64,
    /// Number of the first of them
    #[arg(long, default_value_t = 1000)]
    pub(crate) seed: u64,
}

/// A prediction beside the truth, over the truth's size.
struct Judged {
    quantity: &'static str,
    held: bool,
    error: f64,
    theory_error: f64,
    half_width: f64,
    /// Interval score (Gneiting and Raftery 2007, Eq. 43).
    score: f64,
}

/// One truth with one set of sensors.
struct Outcome {
    kind: Kind,
    sensors: Sensors,
    judged: Vec<Judged>,
    /// Whether something was said about the data.
    flagged: bool,
}

/// Runs the command.
pub(crate) fn run(args: &TrustArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let data = repository::path("data/tuflex");
    let stand = Stand::new(&data).map_err(Failure::computation)?;
    let (file, wing) = ElasticWing::read(&data.join("wing_beam.ron"))?;
    let settings = Settings::of_wing(&file.correction);
    let bar = progress::bar(common, usize::try_from(args.truths).unwrap_or(usize::MAX), "true wings");
    let one = |number: u64| {
        let kind = Kind::ALL[(number % 4) as usize];
        let flown = stand.fly(kind, number);
        let judge = |sensors: Sensors| {
            let calibration = calibrate::calibrate(&wing, &stand.campaign(&flown, sensors), &settings)?;
            let known = calibrate::posterior::posterior(&wing, &calibration, &file.correction.prior)?;
            let calibration = calibration.with_means(&wing, &known)?;
            let judged = known.iter().flat_map(|at| judged(&flown, at.alpha_rad, &at.predictions)).collect();
            Ok(Outcome { kind, sensors, judged, flagged: flagged(&calibration) })
        };
        let outcomes = Sensors::ALL.into_iter().map(judge).collect::<Result<Vec<_>, Failure>>();
        bar.inc(1);
        outcomes
    };
    let outcomes: Vec<Outcome> = (args.seed..args.seed + args.truths)
        .into_par_iter()
        .map(one)
        .collect::<Result<Vec<_>, _>>()?
        .into_iter()
        .flatten()
        .collect();
    progress::end(&bar);
    let rows = rows(&outcomes);
    let result = json!({
        "command": "trust", "truths": args.truths, "seed": args.seed, "rows": rows, "flagged": flags(&outcomes),
        "seconds": start.elapsed().as_secs_f64(),
    });
    let folder = ResultFolder::begin(&common.out("trust"))?;
    folder.input("wing", &file.path)?;
    folder.input("polars", &repository::path(Stand::POLARS))?;
    folder.write_json("result.json", &result)?;
    folder.commit()?;
    show::summary(common, &summary(&rows, &outcomes));
    show::json(common, &result)
}

/// Whether a reader of the report is told that the data are not those of a straight wing without faults.
fn flagged(calibration: &Calibration) -> bool {
    let bent = calibration.airspeeds.iter().any(|at| {
        at.line.nonlinearity.iter().flatten().any(|test| test.p_value < calibration.nonlinearity_level)
    });
    bent || !calibration.said(&[Weight::Suspicion, Weight::Defect]).is_empty()
}

fn judged(
    flown: &Flown<'_>,
    alpha_rad: f64,
    predictions: &[calibrate::posterior::Prediction],
) -> Vec<Judged> {
    let truth = flown.at(alpha_rad);
    let lifts: Vec<f64> = predictions
        .iter()
        .filter_map(|p| match p.quantity {
            Quantity::Reading(Reading::StripLift { y_over_span }) => Some(truth.strip_lift(y_over_span)),
            _ => None,
        })
        .collect();
    let typical = (lifts.iter().map(|lift| lift * lift).sum::<f64>() / lifts.len() as f64).sqrt();
    let one = |p: &calibrate::posterior::Prediction| {
        let (quantity, value, scale) = match &p.quantity {
            Quantity::Reading(Reading::StripLift { y_over_span }) => {
                ("strip lift", truth.strip_lift(*y_over_span), typical)
            }
            Quantity::Reading(Reading::Bending { y_over_span }) if *y_over_span > 0.0 => {
                let value = truth.bending(*y_over_span);
                let name = if *y_over_span == 0.5 { "bending at mid-span" } else { "bending elsewhere" };
                (name, value, value.abs())
            }
            Quantity::TipHeight => ("tip", truth.tip_m(), truth.tip_m().abs()),
            Quantity::ControlMx { control } => {
                let value = flown.power(alpha_rad, control);
                ("aileron power", value, value.abs())
            }
            Quantity::Reading(_) => return None,
        };
        let [low, high] = p.interval();
        let outside = (low - value).max(value - high).max(0.0);
        Some(Judged {
            quantity,
            held: outside == 0.0,
            error: (p.value - value) / scale,
            theory_error: (p.theory - value) / scale,
            half_width: 0.5 * (high - low) / scale,
            score: (high - low + 20.0 * outside) / scale,
        })
    };
    predictions.iter().filter_map(one).collect()
}

/// Rows of the table: by quantity and sensors, attached flow and separated, and pooled over sensors.
fn rows(outcomes: &[Outcome]) -> Vec<Value> {
    let mut cells: BTreeMap<(&str, &str, &str), Vec<&Judged>> = BTreeMap::new();
    for outcome in outcomes {
        let flow = if outcome.kind == Kind::Separated { "separated" } else { "attached" };
        for judged in &outcome.judged {
            for sensors in [outcome.sensors.name(), "pooled"] {
                cells.entry((flow, judged.quantity, sensors)).or_default().push(judged);
            }
        }
    }
    let row = |((flow, quantity, sensors), all): ((&str, &str, &str), Vec<&Judged>)| {
        let count = all.len() as f64;
        let mean = |of: &dyn Fn(&Judged) -> f64| all.iter().map(|judged| of(judged)).sum::<f64>() / count;
        json!({
            "flow": flow, "quantity": quantity, "sensors": sensors, "count": all.len(),
            "held": mean(&|judged| f64::from(u8::from(judged.held))),
            "rms_error": mean(&|judged| judged.error.powi(2)).sqrt(),
            "rms_error_of_theory": mean(&|judged| judged.theory_error.powi(2)).sqrt(),
            "half_width": mean(&|judged| judged.half_width),
            "interval_score": mean(&|judged| judged.score),
        })
    };
    cells.into_iter().map(row).collect()
}

/// Share of the campaigns of a kind, by what is measured, in which something is said about the data.
fn flags(outcomes: &[Outcome]) -> Value {
    let mut shares: BTreeMap<String, (f64, f64)> = BTreeMap::new();
    for outcome in outcomes {
        let share = shares.entry(format!("{}, {}", outcome.kind.name(), outcome.sensors.name())).or_default();
        share.0 += f64::from(u8::from(outcome.flagged));
        share.1 += 1.0;
    }
    shares.into_iter().map(|(kind, (flagged, all))| (kind, flagged / all)).collect()
}

fn summary(rows: &[Value], outcomes: &[Outcome]) -> String {
    let percent = |row: &Value, key: &str| format!("{:.1}", 100.0 * row[key].as_f64().unwrap_or(f64::NAN));
    let word = |row: &Value, key: &str| row[key].as_str().unwrap_or_default().to_owned();
    let columns: [report::Column<'_, &Value>; 8] = [
        ("flow", &|row| word(row, "flow")),
        ("quantity", &|row| word(row, "quantity")),
        ("measured", &|row| word(row, "sensors")),
        ("held by 90 % (%)", &|row| percent(row, "held")),
        ("rms error (%)", &|row| percent(row, "rms_error")),
        ("theory's (%)", &|row| percent(row, "rms_error_of_theory")),
        ("half width (%)", &|row| percent(row, "half_width")),
        ("interval score (%)", &|row| percent(row, "interval_score")),
    ];
    format!("{}\nsomething is said about the data: {}\n", report::Table::of(rows, &columns), flags(outcomes))
}
