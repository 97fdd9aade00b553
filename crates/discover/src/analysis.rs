//! A campaign from beginning to end: noise, search, gap before and after.

use crate::current_model::CurrentModel;
use crate::data::{Dataset, RunData};
use crate::data_checks::{Defect, defects};
use crate::detection_limit::{DetectionLimit, detection_limits};
use crate::found::Outcome;
use crate::gap::Gap;
use crate::load_model::LoadModel;
use crate::model_form::{LatticeVariant, kernel_variant, lag_variant};
use crate::noise::{Noise, NoiseUnknown};
use crate::null_campaigns::{NullCampaign, NullStore, from_null_campaigns, null_campaigns};
use crate::null_distribution::NullDistribution;
use crate::null_key::NullKey;
use crate::problem::Problem;
use crate::rules::Rules;
use crate::search::search;
use crate::setting::Setting;
use crate::simulator::{Simulator, SimulatorError, SplitRig};
use crate::spectral_lines::{SpectralLine, sentence, spectral_lines};
use crate::stated_noise::{self, NoiseBand, beyond_stated};
use crate::uncertain::uncertain;
use calibrate::{Campaign, Schedule, Use};
use coupling::{ByLoad, CouplingError, ElasticWing, WingFile};
use maneuver::effects::{Active, Effect, library_with};
use maneuver::{AirModel, SharedAir};
use std::sync::Arc;

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

/// A wing's rigs, in the model's own form and in variants of it: set up once for any number of campaigns.
#[derive(Debug)]
pub struct Rigs<'a> {
    /// What decides.
    pub rules: Arc<Rules>,
    /// As `simulate` has it.
    pub own: SplitRig<'a>,
    /// With another rational function of the air, other doublets, another lattice.
    pub variants: Vec<SplitRig<'a>>,
}

impl<'a> Rigs<'a> {
    /// Sets all up for the rules that campaigns are decided by; `lattice` is the wing on another one, if it can be put there.
    ///
    /// # Errors
    /// As [`SplitRig::new`].
    pub fn new(
        file: &'a WingFile,
        wing: &'a ElasticWing,
        lattice: Option<&'a LatticeVariant>,
        rules: Rules,
    ) -> Result<Self, DiscoverError> {
        let how = &rules.variants;
        let settings = AirModel::default().doublets();
        let shared = settings.map(|settings| SharedAir::of(wing, settings)).transpose();
        let shared = shared.map_err(CouplingError::from).map_err(SimulatorError::from)?;
        let own = || {
            let own = SplitRig::in_air(file, wing, AirModel::default(), how, shared.as_ref())?;
            let lags = own.in_other_air(lag_variant(how), shared.as_ref())?;
            Ok::<_, SimulatorError>([own, lags])
        };
        let on_lattice =
            || lattice.map(|lattice| SplitRig::on_lattice(lattice, kernel_variant(), how)).transpose();
        let (own, on_lattice) = rayon::join(own, on_lattice);
        let [own, lags] = own?;
        let kernel = match on_lattice? {
            Some(on_lattice) => on_lattice,
            None => own.in_other_air(kernel_variant(), None)?,
        };
        Ok(Self { rules: Arc::new(rules), own, variants: vec![lags, kernel] })
    }
}

impl Rigs<'_> {
    /// The wing and its model-form variants, brought to its static loads, in a data set.
    ///
    /// # Errors
    /// If the wing diverges at an airspeed, or corrections do not reach there.
    pub fn simulators(
        &self,
        schedule: &Schedule,
        data: &Dataset,
    ) -> Result<(Simulator, Vec<Simulator>), DiscoverError> {
        let own = Simulator::new(&self.own, schedule, data)?;
        let variant = |rig| Ok(Simulator::new(rig, schedule, data)?.matching(&own, &self.rules));
        let variants = self.variants.iter().map(variant).collect::<Result<_, DiscoverError>>()?;
        Ok((own, variants))
    }
}

/// A wing and a campaign ready to be searched.
#[derive(Debug)]
pub struct Prepared {
    /// The data.
    pub data: Dataset,
    /// The wing in them.
    pub simulator: Simulator,
    /// Model-form variants of it.
    pub variants: Vec<Simulator>,
    /// The library.
    pub library: Vec<Arc<dyn Effect>>,
    /// Names of the wing's controls.
    pub controls: Vec<String>,
    /// Calibrated parameters that stay uncertain, each at one standard deviation.
    pub uncertain: Vec<Active>,
    /// The noise.
    pub noise: Noise,
    /// Where it is not what the campaign states.
    pub noise_beyond_stated: Vec<NoiseBand>,
    /// Spectral lines that do not repeat.
    pub spectral_lines: Vec<SpectralLine>,
    /// How open the corrections are (see [`Setting::open_corrections`]).
    pub open_corrections: f64,
}

/// What a search found and how far the gap closed.
#[derive(Debug)]
pub struct Report<'a> {
    /// The model at the end.
    pub current: CurrentModel<'a>,
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
        let data = Dataset::read(campaign, rigs.own.wing(), &rigs.rules)?;
        Self::of_data(rigs, schedule, data, own_corrections)
    }

    /// The same with a campaign's data, read for the rigs' wing and rules.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn of_data(
        rigs: &Rigs<'_>,
        schedule: &Schedule,
        data: Dataset,
        own_corrections: bool,
    ) -> Result<Self, DiscoverError> {
        let (simulator, variants) = rigs.simulators(schedule, &data)?;
        let controls = rigs.own.controls();
        let places: Vec<usize> = (0..data.runs.len()).map(|i| data.place_of_run(i)).collect();
        let flown = simulator.flown(&[], None, &places);
        let noise = Noise::new(&data, &flown)?;
        let noise_beyond_stated = beyond_stated(&data, &flown);
        let spectral_lines = spectral_lines(&data, &flown);
        let open_corrections = if own_corrections { 1.0 } else { rigs.rules.shared.calibrated };
        let library = library_with(&controls, &rigs.own.file().into());
        let uncertain = uncertain(&library, &controls, &rigs.rules.shared);
        Ok(Self {
            data,
            simulator,
            variants,
            library,
            controls,
            uncertain,
            noise,
            noise_beyond_stated,
            spectral_lines,
            open_corrections,
        })
    }

    /// What the search is given.
    pub fn setting(&self) -> Setting<'_> {
        Setting {
            data: &self.data,
            model: &self.simulator,
            variants: self.variants.iter().map(|variant| variant as &dyn LoadModel).collect(),
            library: &self.library,
            uncertain: &self.uncertain,
            open_corrections: self.open_corrections,
        }
    }

    /// What is searched.
    pub fn training(&self) -> Problem<'_> {
        Problem::of_conditions(&self.data, &self.noise, Use::Train)
    }

    /// The training and the held-out data whose gaps are stated, every run for itself.
    pub fn judged(&self) -> [Problem<'_>; 2] {
        [Use::Train, Use::Holdout].map(|usage| Problem::of_runs(&self.data, &self.noise, usage))
    }

    /// What is found in campaigns without effect.
    pub fn null_distribution(&self, seed: u64) -> NullDistribution {
        self.null_distribution_kept(seed, &())
    }

    /// The same, with campaigns that a stopped run has finished, and each kept when it is.
    pub fn null_distribution_kept(&self, seed: u64, kept: &dyn NullStore) -> NullDistribution {
        from_null_campaigns(&self.setting(), self.training(), &self.judged(), seed, kept)
    }

    /// Some of these campaigns, by their numbers; those that are not kept are made.
    pub fn null_campaigns(&self, seed: u64, wanted: &[u64], kept: &dyn NullStore) -> Vec<NullCampaign> {
        null_campaigns(&self.setting(), self.training(), &self.judged(), seed, wanted, kept)
    }

    /// What a null distribution of this campaign depends on, for the wing of a file (its hash) with these corrections.
    pub fn null_key(&self, wing_hash: &str, schedule: &Schedule) -> NullKey {
        NullKey::new(wing_hash, schedule, self.open_corrections, &self.library, &self.data)
    }

    /// Searches.
    pub fn search(&self, nulls: &NullDistribution, seed: u64) -> Report<'_> {
        let before = self.simulator.count();
        let setting = self.setting();
        let (mut outcome, current) = search(&setting, self.training(), nulls, seed);
        if let Some(sentence) = sentence(&self.data.rules.spectral_lines, &self.spectral_lines) {
            // no effect of the library makes a spectral line
            outcome.unexplained = true;
            outcome.trace.push(sentence);
        }
        outcome.trace.extend(stated_noise::sentence(&self.noise_beyond_stated));
        let gaps = self.judged().each_ref().map(|problem| {
            let places = problem.places();
            let of = |effects| problem.gap(&self.simulator.flown(effects, Some(&current.models), &places));
            [of(&[]), of(&current.effects)]
        });
        Report { current, outcome, gaps, model_runs: self.simulator.count() - before }
    }

    /// What of every effect would have been named, where a search found nothing missing; empty otherwise.
    pub fn detection_limits(&self, report: &Report<'_>, nulls: &NullDistribution) -> Vec<DetectionLimit> {
        if !report.outcome.found.is_empty() || report.outcome.unexplained {
            return Vec::new();
        }
        detection_limits(&self.setting(), &report.current, nulls)
    }

    /// Gaps of training and held-out runs as another simulator flies them with effects: corrections that were calibrated
    /// again with the effects in the model.
    pub fn gaps_of(&self, simulator: &Simulator, effects: &[Active]) -> [Gap; 2] {
        let models = simulator.models(effects, None);
        self.judged()
            .each_ref()
            .map(|problem| problem.gap(&simulator.fly(&models, effects, &problem.places())))
    }

    /// Places of all static groups and runs among the stimuli, every run for itself.
    pub fn records(&self) -> Vec<usize> {
        (0..self.data.statics.len() + self.data.runs.len()).collect()
    }

    /// Defects of the data, judged before anything is searched; none is what one hopes for.
    pub fn defects(&self) -> Vec<Defect> {
        let flown = self.simulator.flown(&[], None, &self.records());
        let of_run =
            |run: &RunData| ByLoad::from_fn(|load| self.noise.sigma(run.airspeed, load as usize, 1.0));
        let statics = self.data.statics.iter().map(|_| self.noise.point);
        let sigma: Vec<ByLoad<f64>> = statics.chain(self.data.runs.iter().map(of_run)).collect();
        defects(&self.data, &flown, &sigma)
    }
}
