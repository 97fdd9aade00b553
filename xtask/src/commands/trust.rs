//! `trust`: whether the intervals of calibrated wings hold wings that another program made.

use clap::Args;
use std::time::Instant;

use rayon::prelude::*;
use serde_json::json;

use super::trust_campaign::{Sensors, Stand, V_M_S};
use super::trust_flight::{Flights, points};
use super::trust_generator::{Generator, measurements, values};
use super::trust_judged::{Outcome, flags, judge, predicted, rows, summary, truths};
use crate::repository;
use calibrate::ensemble::ensemble;
use calibrate::posterior::predictions::Quantity;
use calibrate::posterior::{AirspeedPosterior, posterior};
use calibrate::{Calibration, Schedule, Settings, Weight};
use coupling::{ElasticWing, WingFile};
use fullaircraft::AircraftFile;
use truth::lift::Kind;
use wingroot::args::Common;
use wingroot::corrections::schedule;
use wingroot::failure::Failure;
use wingroot::output::ResultFolder;
use wingroot::{progress, show};

/// Options of `trust`.
#[derive(Debug, Clone, Args)]
#[command(after_help = "Examples:
  cargo xtask trust --truths 40
  cargo xtask trust --truths 500 --seed 7

Wings off their drawing are flown at rest by the vortex lattice and the beam of crates/truth, measured with noise, and calibrated
with the model's own lattice and structure. A quarter separates within the angles and stands for itself. Interval scores are over
those of the best linear prediction from other wings of the same generator.")]
pub(crate) struct TrustArgs {
    /// Number of true wings
    #[arg(long, default_value_t = 100)]
    pub(crate) truths: u64,
    /// Number of the first of them
    #[arg(long, default_value_t = 1000)]
    pub(crate) seed: u64,
    /// Number of further wings that the generator's own prediction is learned from
    #[arg(long, default_value_t = 400)]
    pub(crate) learned: u64,
}

/// How far the wings that the generator's own prediction is learned from are from those that are judged.
const APART: u64 = 1 << 32;

/// What judges wings.
struct Judge<'a> {
    stand: &'a Stand,
    file: &'a WingFile,
    wing: &'a ElasticWing,
    settings: Settings,
    flights: Flights,
}

/// A wing as calibrated.
struct Calibrated {
    calibration: Calibration,
    known: AirspeedPosterior,
    schedule: Schedule,
}

/// Runs the command.
pub(crate) fn run(args: &TrustArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let data = repository::path("data/tuflex");
    let points = points(&AircraftFile::read(&data.join("aircraft.ron"))?, V_M_S);
    let stand = Stand::new(&data, points).map_err(Failure::computation)?;
    let (file, wing) = ElasticWing::read(&data.join("wing_beam.ron"))?;
    let settings = Settings::of_wing(&file.correction);
    let flights = Flights::new(&file, &points)?;
    let judge = Judge { stand: &stand, file: &file, wing: &wing, settings, flights };
    let whole = usize::try_from(args.truths + args.learned).unwrap_or(usize::MAX);
    let bar = progress::bar(common, whole, "true wings");
    let generators = judge.generators(args.seed + APART, args.learned, &|| bar.inc(1))?;
    let outcomes = (args.seed..args.seed + args.truths).into_par_iter().map(|number| {
        let outcomes = judge.outcomes(number, &generators);
        bar.inc(1);
        outcomes
    });
    let outcomes: Vec<Outcome> = outcomes.collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect();
    progress::end(&bar);
    let rows = rows(&outcomes);
    let result = json!({
        "command": "trust", "truths": args.truths, "seed": args.seed, "learned": args.learned, "rows": rows,
        "flagged": flags(&outcomes), "seconds": start.elapsed().as_secs_f64(),
    });
    let folder = ResultFolder::begin(&common.out("trust"))?;
    folder.input("wing", &file.path)?;
    folder.input("polars", &repository::path(Stand::POLARS))?;
    folder.write_json("result.json", &result)?;
    folder.commit()?;
    show::summary(common, &summary(&rows, &outcomes));
    show::json(common, &result)
}

impl Judge<'_> {
    fn calibrated(
        &self,
        flown: &super::trust_campaign::Flown<'_>,
        sensors: Sensors,
    ) -> Result<Calibrated, Failure> {
        let campaign = self.stand.campaign(flown, sensors);
        let calibration = calibrate::calibrate(self.wing, &campaign, &self.settings)?;
        let mut known = posterior(self.wing, &calibration, &self.file.correction.prior)?;
        let calibration = calibration.with_means(self.wing, &known)?;
        let schedule = schedule(self.file, &calibration);
        Ok(Calibrated { schedule, calibration, known: known.swap_remove(0) })
    }

    /// What somebody would say who knows the generator, by set of sensors, learned from attached wings.
    fn generators(
        &self,
        first: u64,
        count: u64,
        done: &(dyn Fn() + Sync),
    ) -> Result<Vec<Generator>, Failure> {
        let kinds = Kind::ALL.into_iter().filter(|kind| *kind != Kind::Separated).collect::<Vec<_>>();
        let drawn = self.stand.fly(Kind::Polars, first);
        let (asked, alpha_rad) = asked(&self.calibrated(&drawn, Sensors::Nothing)?.known);
        let judged: Vec<bool> = truths(&drawn, &asked, alpha_rad).iter().map(Option::is_some).collect();
        let one = |(number, kind): (u64, &Kind)| {
            let flown = self.stand.fly(*kind, first + number);
            done();
            let values = values(&truths(&flown, &asked, alpha_rad), &judged)?;
            let measured = Sensors::ALL.map(|sensors| measurements(&self.stand.campaign(&flown, sensors)));
            Some((values, measured))
        };
        let wings: Vec<(u64, &Kind)> = (0..count).zip(kinds.iter().cycle()).collect();
        let learned: Vec<(Vec<f64>, [Vec<f64>; 5])> =
            wings.into_par_iter().map(one).collect::<Vec<_>>().into_iter().flatten().collect();
        let truths: Vec<Vec<f64>> = learned.iter().map(|(values, _)| values.clone()).collect();
        let of = |sensors: usize| {
            let measured: Vec<Vec<f64>> = learned.iter().map(|(_, of)| of[sensors].clone()).collect();
            Generator::new(&measured, &truths).ok_or_else(|| {
                Failure::Computation(format!(
                    "{count} wings are too few to learn from: --learned 100 or more"
                ))
            })
        };
        (0..Sensors::ALL.len()).map(of).collect()
    }

    /// A wing with each set of sensors.
    fn outcomes(&self, number: u64, generators: &[Generator]) -> Result<Vec<Outcome>, Failure> {
        let kind = Kind::ALL[(number % 4) as usize];
        let flown = self.stand.fly(kind, number);
        let one = |(sensors, generator): (Sensors, &Generator)| {
            let Calibrated { calibration, known, schedule } = self.calibrated(&flown, sensors)?;
            let (asked, alpha_rad) = asked(&known);
            let truths = truths(&flown, &asked, alpha_rad);
            let prior = &self.file.correction.prior;
            let missing = || Failure::Computation("a calibration without an ensemble".into());
            let members =
                ensemble(self.wing, prior, &schedule, std::slice::from_ref(&known)).ok_or_else(missing)?;
            let in_flight = self.flights.predict(&schedule, &members)?;
            let by_generator = generator.intervals(&measurements(&self.stand.campaign(&flown, sensors)));
            let judged = judge(&truths, &predicted(&known.predictions, &in_flight), &by_generator);
            Ok(Outcome { kind, sensors, judged, flagged: flagged(&calibration) })
        };
        Sensors::ALL.into_iter().zip(generators).map(one).collect()
    }
}

/// Whether a reader of the report is told that the data are not those of a straight wing without faults.
fn flagged(calibration: &Calibration) -> bool {
    let bent = calibration.airspeeds.iter().any(|at| {
        at.line.nonlinearity.iter().flatten().any(|test| test.p_value < calibration.nonlinearity_level)
    });
    bent || !calibration.said(&[Weight::Suspicion, Weight::Defect]).is_empty()
}

/// What is asked of a wing, and at which angle.
fn asked(known: &AirspeedPosterior) -> (Vec<Quantity>, f64) {
    (known.predictions.iter().map(|prediction| prediction.quantity.clone()).collect(), known.alpha_rad)
}
