//! A campaign from beginning to end: noise, search, gap before and after.

use crate::bank::Thresholds;
use crate::data::Dataset;
use crate::gap::Gap;
use crate::level::{Level, Setting};
use crate::noise::{Noise, NoiseUnknown};
use crate::problem::Problem;
use crate::search::{Outcome, search};
use crate::simulator::{Simulator, SimulatorError, SplitRig};
use calibrate::{Campaign, Schedule, Use};
use coupling::{ElasticWing, WingFile};
use maneuver::AirModel;
use maneuver::effects::{Active, Effect, Flown, library};
use std::sync::Arc;

/// Lags of the other numerics' rational function.
const OTHER_LAGS: usize = 4;

/// How open corrections are that were found with other static points: about what a day's readings leave of them.
const CALIBRATED: f64 = 0.05;

/// Why a campaign cannot be searched.
#[derive(Debug, thiserror::Error)]
pub enum DiscoverError {
    /// The wing cannot be flown through it.
    #[error(transparent)]
    Simulator(#[from] SimulatorError),
    /// A file is wrong.
    #[error(transparent)]
    Input(#[from] nastran::InputError),
    /// Nothing says how large the noise is.
    #[error(transparent)]
    Noise(#[from] NoiseUnknown),
}

/// A wing's rigs, with the model's numerics and with others: set up once for any number of campaigns.
#[derive(Debug)]
pub struct Rigs<'a> {
    /// As `simulate` has it.
    pub own: SplitRig<'a>,
    /// With another rational function of the air.
    pub other: SplitRig<'a>,
}

impl<'a> Rigs<'a> {
    /// Sets both up.
    ///
    /// # Errors
    /// As [`SplitRig::new`].
    pub fn new(file: &'a WingFile, wing: &'a ElasticWing) -> Result<Self, DiscoverError> {
        let air = match AirModel::default() {
            AirModel::Unsteady { doublets, .. } => AirModel::Unsteady { lags: OTHER_LAGS, doublets },
            AirModel::QuasiSteady => AirModel::QuasiSteady,
        };
        let own = SplitRig::new(file, wing, AirModel::default())?;
        Ok(Self { own, other: SplitRig::new(file, wing, air)? })
    }
}

/// A wing and a campaign ready to be searched.
#[derive(Debug)]
pub struct Prepared {
    /// The data.
    pub data: Dataset,
    /// The wing in them.
    pub simulator: Simulator,
    /// With other numerics.
    pub others: Vec<Simulator>,
    /// The library.
    pub library: Vec<Arc<dyn Effect>>,
    /// The noise.
    pub noise: Noise,
    /// How open the corrections are (see [`Setting::open_corrections`]).
    pub open_corrections: f64,
}

/// What a search found and how far the gap closed.
#[derive(Debug)]
pub struct Report {
    /// The model at the end.
    pub level: Level,
    /// The effects and what else the search says.
    pub outcome: Outcome,
    /// Gaps of training runs before and after, then of held-out runs.
    pub gaps: [[Gap; 2]; 2],
    /// How often all was flown.
    pub model_runs: usize,
}

impl Prepared {
    /// Reads a campaign and sets up the wing for it.
    ///
    /// # Errors
    /// Bad data, a wing that diverges, unknown noise.
    pub fn new(
        rigs: &Rigs<'_>,
        schedule: &Schedule,
        campaign: &Campaign,
        own_corrections: bool,
    ) -> Result<Self, DiscoverError> {
        let data = Dataset::read(campaign, rigs.own.wing())?;
        let simulator = Simulator::new(&rigs.own, schedule, &data)?;
        let others = vec![Simulator::new(&rigs.other, schedule, &data)?];
        let names = rigs.own.controls();
        let places: Vec<usize> = (0..data.runs.len()).map(|i| data.statics.len() + i).collect();
        let flown = simulator.fly(&simulator.models(&[], None), &[], &places);
        let noise = Noise::new(&data, &flown)?;
        let open_corrections = if own_corrections { 1.0 } else { CALIBRATED };
        Ok(Self { data, simulator, others, library: library(&names), noise, open_corrections })
    }

    /// What the search is given.
    pub fn setting(&self) -> Setting<'_> {
        Setting {
            data: &self.data,
            simulator: &self.simulator,
            others: &self.others,
            library: &self.library,
            open_corrections: self.open_corrections,
        }
    }

    /// Training and held-out problems.
    pub fn problems(&self) -> [Problem<'_>; 2] {
        [Use::Train, Use::Holdout].map(|usage| Problem::new(&self.data, &self.noise, usage))
    }

    /// Thresholds from campaigns without effect.
    pub fn thresholds(&self, seed: u64) -> Thresholds {
        let [train, holdout] = self.problems();
        Thresholds::from_nulls(&self.setting(), &train, &holdout, seed)
    }

    /// Searches.
    pub fn search(&self, limits: &Thresholds, seed: u64) -> Report {
        let before = self.simulator.count();
        let setting = self.setting();
        let [mut train, holdout] = self.problems();
        let (outcome, level) = search(&setting, &mut train, limits, seed);
        let gaps = [&train, &holdout].map(|problem| {
            let plain: &[Active] = &[];
            [plain, &level.effects].map(|effects| problem.gap(&self.flown(problem, &level, effects)))
        });
        Report { level, outcome, gaps, model_runs: self.simulator.count() - before }
    }

    fn flown(&self, problem: &Problem<'_>, level: &Level, effects: &[Active]) -> Vec<Flown> {
        let models = self.simulator.models(effects, Some(&level.models));
        self.simulator.fly(&models, effects, &problem.places())
    }
}
